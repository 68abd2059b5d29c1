//! The radii that the proofs give, to six digits: a bound that moves, wider or tighter, is seen and read again.
//!
//! Radii exceed true errors by many bits, so a test that only asks whether the truth is inside would pass with a bound
//! that forgot a term. Here every way of a collision is followed at a fixed precision; the true value, from a run at
//! more bits, must be inside, and the radius must be the one last reviewed. Lines are printed on failure in
//! the form in which they stand below.

use num_rational::BigRational;
use restitution_direct::{Collision, End, Interpolant, Variable, saturation_radius, saturation_speed};
use restitution_law::ForceLaw;
use restitution_real::Ball;
use rug::Float;

const C: End = End::ZeroCompression;
const F: End = End::ZeroForce;

fn ratio(text: &str) -> BigRational {
    text.parse().unwrap()
}

fn law(text: &str) -> ForceLaw {
    text.parse().unwrap()
}

fn six(x: &Float) -> String {
    x.to_string_radix(10, Some(6))
}

/// A law, an end, a damping, what its ball is wide as a power of two (0: exact), bits; the radius.
type Point = (&'static str, End, &'static str, i32, u32, &'static str);

const POINTS: &[Point] = &[
    ("3/2,1/2", C, "1/1000000", 0, 128, "2.31320e-35"),
    ("3/2,1/2", C, "1/10", 0, 128, "2.48708e-35"),
    ("3/2,1/2", C, "1", 0, 128, "2.45416e-35"),
    ("3/2,1/2", C, "1", -40, 128, "4.41873e-12"),
    ("3/2,1/2", C, "1", 0, 400, "1.00145e-116"),
    ("3/2,1/2", C, "7/2", 0, 128, "2.21354e-37"),
    ("3/2,1/2", C, "8", 0, 128, "2.70102e-39"),
    ("3/2,1/2", C, "40", 0, 96, "3.53311e-33"),
    ("3/2,1/2", C, "1000", 0, 96, "3.61790e-40"),
    ("3/2,1/2", F, "1/1000000", 0, 128, "2.31320e-35"),
    ("3/2,1/2", F, "1", 0, 128, "3.12634e-35"),
    ("3/2,1/2", F, "1", -40, 128, "5.45569e-12"),
    ("3/2,1/2", F, "1", 0, 400, "1.21439e-116"),
    ("3/2,1/2", F, "20", 0, 96, "2.99448e-25"),
    ("3/2,1/2", F, "1000", 0, 96, "5.55736e-24"),
    ("1,0", C, "1", 0, 128, "1.69271e-35"),
    ("1,0", C, "39/20", 0, 128, "7.98238e-39"),
    ("1,0", F, "1", 0, 128, "2.89457e-35"),
    ("1,0", F, "16/5", 0, 128, "7.13334e-35"),
    ("3,1/2", C, "1", 0, 128, "1.09970e-34"),
    ("3,1/2", F, "7771/2000", 0, 128, "3.20953e-34"),
    ("2,1", C, "1", 0, 128, "2.24765e-35"),
    ("2,1", F, "5", 0, 128, "2.20360e-35"),
    ("7/3,5/6", C, "7/10", 0, 128, "1.17400e-34"),
    ("7/3,5/6", F, "7/10", 0, 128, "1.18939e-34"),
    ("9/4,2", C, "7/10", 0, 96, "2.89690e-25"),
    ("9/4,2", F, "7/10", 0, 96, "2.54064e-25"),
    ("3/4,3/5", C, "927/100000", 0, 96, "2.26269e-25"),
    ("3/4,3/5", F, "927/100000", 0, 96, "2.41399e-25"),
    ("3/4,7/10", F, "5511/20000", 0, 96, "2.59914e-25"),
    ("3/2,-1/4", C, "1/2", 0, 96, "1.14399e-23"),
    ("3/2,-1/4", F, "1/2", 0, 96, "1.54963e-23"),
    ("1/2,3/2", C, "1", 0, 96, "8.44018e-26"),
    ("1001/1000,1/1000", C, "1", 0, 64, "6.25799e-16"),
    ("9,-13/100", C, "1/5", 0, 64, "7.65303e-16"),
    ("1/10,1/20", C, "1/2", 0, 64, "7.56041e-16"),
];

/// Those that are followed in long steps of time, one for each kind of law that is.
const LONG_STEPS: &[Point] = &[
    ("3/2,1/2", C, "1", 0, 1200, "2.59905e-356"),
    ("3/2,1/2", F, "1/2", 0, 620, "3.14570e-182"),
    ("3/2,1/2", C, "5", -400, 620, "5.04161e-121"),
    ("1,0", C, "1", 0, 620, "2.16811e-181"),
    ("2,0", C, "1/3", 0, 620, "1.29927e-182"),
    ("2,1", F, "1", 0, 620, "1.29030e-182"),
    ("3,2", C, "1", 0, 620, "2.80432e-182"),
];

fn enclosure(point: &Point, bits: u32) -> Ball {
    let (of, end, u, wide, ..) = *point;
    let mut damping = Ball::from_rational(&ratio(u), 2 * bits);
    if wide != 0 {
        damping.widen(&(Float::with_val(64, 1) >> wide.unsigned_abs()));
    }
    let collision = Collision::new(&law(of), end).unwrap();
    collision.enclose(&damping, bits).unwrap_or_else(|error| panic!("{of} {u}: {error}"))
}

/// Points whose radii are not those that stand there.
fn moved(points: &[Point]) -> String {
    let mut moved = String::new();
    for point in points {
        let (of, end, u, wide, bits, radius) = *point;
        let (end, now) = (if end == C { "C" } else { "F" }, six(enclosure(point, bits).rad()));
        if now != radius {
            moved += &format!("    ({of:?}, {end}, {u:?}, {wide}, {bits}, {now:?}),\n");
        }
    }
    moved
}

#[test]
fn figures_of_points() {
    let moved = moved(POINTS);
    assert!(moved.is_empty(), "these radii have moved:\n{moved}");
}

#[test]
fn figures_of_long_steps() {
    let moved = moved(LONG_STEPS);
    assert!(moved.is_empty(), "these radii have moved:\n{moved}");
}

#[test]
fn points_hold_the_truth() {
    for point in POINTS.iter().chain(LONG_STEPS) {
        let (of, end, u, _, bits, radius) = *point;
        let coarse = enclosure(point, bits);
        let fine = enclosure(&(of, end, u, 0, bits, radius), bits + 40);
        let inside = coarse.contains(&Ball::exact(fine.mid().clone()));
        assert!(inside, "{of} {end:?} {u}: {coarse:?} misses {fine:?}");
    }
}

/// A law, an end, an interval, its variable, degree, bits; the remainder and the sum of the coefficients.
type Piece = (&'static str, End, &'static str, &'static str, Variable, usize, u32, &'static str);

const U: Variable = Variable::Damping;
const R: Variable = Variable::Root;

const PIECES: &[Piece] = &[
    ("3/2,1/2", C, "0", "1/20", U, 8, 80, "1.31859e-14"),
    ("3/2,1/2", C, "49/50", "51/50", U, 8, 80, "4.87005e-16"),
    ("3/2,1/2", C, "6", "49/8", U, 6, 60, "5.96132e-13"),
    ("3/2,1/2", F, "49/50", "51/50", U, 8, 80, "6.94507e-17"),
    ("3/2,1/2", F, "9/10", "1", R, 6, 60, "2.99695e-11"),
    ("3/2,1/2", F, "1/1000000", "2/1000000", R, 4, 60, "1.32353e-17"),
    ("3/2,1/2", F, "100", "102", U, 6, 60, "2.51134e-13"),
    ("1,0", C, "1/2", "11/20", U, 6, 60, "1.50493e-10"),
    ("2,1", C, "1/3", "2/5", U, 6, 60, "2.29110e-11"),
    ("2,1", F, "1/3", "2/5", U, 6, 60, "2.56760e-8"),
    ("3/2,1/2", C, "1", "1", U, 0, 60, "1.68219e-21"),
];

fn interpolant(piece: &Piece) -> Interpolant {
    let (of, end, from, to, variable, degree, bits, _) = *piece;
    let collision = Collision::new(&law(of), end).unwrap();
    collision.interpolant(&ratio(from), &ratio(to), variable, degree, bits).unwrap()
}

#[test]
fn figures_of_pieces() {
    let mut moved = String::new();
    for piece in PIECES {
        let (of, end, from, to, variable, degree, bits, remainder) = *piece;
        let (end, name) = (if end == C { "C" } else { "F" }, if variable == U { "U" } else { "R" });
        let now = six(&interpolant(piece).remainder().upper());
        if now != remainder {
            moved += &format!("    ({of:?}, {end}, {from:?}, {to:?}, {name}, {degree}, {bits}, {now:?}),\n");
        }
    }
    assert!(moved.is_empty(), "these remainders have moved:\n{moved}");
}

#[test]
fn pieces_hold_the_truth() {
    for piece in PIECES {
        let (of, end, from, to, ..) = *piece;
        let middle = Ball::from_rational(&((ratio(from) + ratio(to)) / ratio("2")), 200);
        let fine = Collision::new(&law(of), end).unwrap().enclose(&middle, 160).unwrap();
        let coarse = interpolant(piece).enclose(&middle).unwrap();
        let inside = coarse.contains(&Ball::exact(fine.mid().clone()));
        assert!(inside, "{of} {end:?} {from}: {coarse:?} misses {fine:?}");
    }
}

#[test]
fn figures_of_saturation() {
    let mut moved = String::new();
    for (of, digits, radius, speed) in [
        ("3/2,1/2", 20, "1.62358e-30", "3.01473e-29"),
        ("2,1", 12, "4.20522e-23", "2.20343e-22"),
        ("7/3,5/6", 12, "5.83496e-15", "1.19985e-11"),
        ("3/2,1", 12, "5.04648e-23", "8.95033e-23"),
    ] {
        let law = law(of);
        let [now, faster] = [saturation_radius, saturation_speed].map(|ask| {
            let (coarse, fine) = (ask(&law, digits).unwrap(), ask(&law, digits + 10).unwrap());
            assert!(coarse.contains(&Ball::exact(fine.mid().clone())), "{of}: {coarse:?} misses {fine:?}");
            six(coarse.rad())
        });
        if now != radius || faster != speed {
            moved += &format!("({of:?}, {digits}, {now:?}, {faster:?}),\n");
        }
    }
    assert!(moved.is_empty(), "these radii have moved:\n{moved}");
}
