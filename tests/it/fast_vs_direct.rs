//! The f64 evaluator against certified values: the errors that its documentation states.

use crate::certified::{exact, reference, ulps};
use restitution::{End, bounds, epsilon, one_minus_epsilon, u_of_epsilon};
use rug::Float;

/// Points of the quick and of the whole comparison, by ratio over [`RANGE`].
const POINTS: [usize; 2] = [20_000, 1_000_000];
const RANGE: (f64, f64) = (1e-8, 1e3);
const ENDS: [End; 2] = [End::ZeroCompression, End::ZeroForce];

/// The largest errors seen, in ulp, with their places.
#[derive(Clone, Copy, Default)]
struct Worst {
    epsilon: (f64, f64),
    one_minus_epsilon: (f64, f64),
}

impl Worst {
    fn over(end: End, points: impl Iterator<Item = f64>) -> Self {
        let reference = reference(end);
        points.fold(Self::default(), |worst, u| {
            let (lost, kept) = exact(reference, u);
            worst.max(Self {
                epsilon: (ulps(epsilon(u, end), &kept), u),
                one_minus_epsilon: (ulps(one_minus_epsilon(u, end), &lost), u),
            })
        })
    }

    fn max(self, other: Self) -> Self {
        let larger = |a: (f64, f64), b: (f64, f64)| if b.0 <= a.0 { a } else { b }; // NaN wins
        Self {
            epsilon: larger(self.epsilon, other.epsilon),
            one_minus_epsilon: larger(self.one_minus_epsilon, other.one_minus_epsilon),
        }
    }

    fn check(self, what: &str) {
        let Self { epsilon: (e, at), one_minus_epsilon: (lost, lost_at) } = self;
        println!("{what}: epsilon {e:.3} ulp at {at:e}, one_minus_epsilon {lost:.3} ulp at {lost_at:e}");
        assert!(e <= bounds::EPSILON.size && lost <= bounds::ONE_MINUS_EPSILON.size, "{what}");
    }
}

/// `count` points by ratio, each at a place of its own within its step.
fn by_ratio(
    count: usize,
    (low, high): (f64, f64),
    part: std::ops::Range<usize>,
) -> impl Iterator<Item = f64> {
    part.map(move |i| {
        let jitter = (i as f64 * 0.618_033_988_749_894_9).fract();
        low * (high / low).powf((i as f64 + jitter) / count as f64)
    })
}

fn points_by_ratio(points: usize) {
    for end in ENDS {
        reference(end);
        let worst = std::thread::scope(|scope| {
            let halves = [0..points / 2, points / 2..points];
            let threads =
                halves.map(|half| scope.spawn(move || Worst::over(end, by_ratio(points, RANGE, half))));
            threads.map(|thread| thread.join().unwrap()).into_iter().fold(Worst::default(), Worst::max)
        });
        worst.check(&format!("{end:?}, {points} points"));
    }
}

#[test]
fn points_of_all_sizes() {
    points_by_ratio(crate::support::cases(POINTS[0]));
}

#[test]
#[ignore = "slow: a million points, half a minute"]
fn a_million_points_by_ratio() {
    points_by_ratio(POINTS[1]);
}

/// The exact coefficient at what the inverse returns, against the coefficient that was asked for.
#[test]
fn the_inverse_is_within_its_bound() {
    for end in ENDS {
        let reference = reference(end);
        let mut worst = (0.0_f64, 0.0);
        let count = crate::support::cases(20_000);
        let small = by_ratio(count, (1e-290, 1.0), 0..count).chain(by_ratio(count, (1e-5, 1.0), 0..count));
        let near_one = by_ratio(count, (1e-15, 0.5), 0..count).map(|lost| 1.0 - lost);
        for wanted in small.chain(near_one).filter(|wanted| *wanted < 1.0) {
            let (lost, kept) = exact(reference, u_of_epsilon(wanted, end));
            let (value, target) = if wanted > 0.5 { (lost, 1.0 - wanted) } else { (kept, wanted) };
            let error = (Float::with_val(112, value - target) / target).to_f64().abs();
            worst = if error <= worst.0 { worst } else { (error, wanted) };
        }
        println!("{end:?}, inverse: {:.3e} at {:e}", worst.0, worst.1);
        assert!(worst.0 <= bounds::INVERSE.size, "{end:?}: {worst:?}");
    }
}

#[test]
fn every_breakpoint_and_its_neighbours() {
    let pieces = |shift: f64, bits: i32, count: i32| {
        let parts = 1 << bits;
        let start = move |i: i32| (1.0 + f64::from(i % parts) / f64::from(parts)) * 2.0_f64.powi(i / parts);
        (0..=count).map(move |i| (start(i) - 1.0) * shift)
    };
    let (saturated, ends) = ((0..=128).map(|i| 1024.0 + f64::from(i) * 8.0), [1.0 / 32.0, 1.0 / 16.0]);
    let compression = pieces(1.0, 7, 10 * 128).chain(ends).chain(saturated);
    Worst::over(End::ZeroCompression, neighbours(compression)).check("ZeroCompression, breakpoints");
    let force = pieces(1.0 / 512.0, 6, 19 * 64).chain(ends);
    Worst::over(End::ZeroForce, neighbours(force)).check("ZeroForce, breakpoints");
    let beyond = (0..2 * 32).map(|i| (1.0 + f64::from(i % 32) / 32.0) * 2.0_f64.powi(i / 32 - 4) - 0.0625);
    let beyond = beyond.filter(|x| *x > 0.0 && *x < 0.0993).map(|x| x.powi(-3));
    Worst::over(End::ZeroForce, neighbours(beyond)).check("ZeroForce, breakpoints beyond");
}

fn neighbours(points: impl Iterator<Item = f64>) -> impl Iterator<Item = f64> {
    let around = |u: f64| {
        let (up, down) = (u.next_up(), u.next_down());
        [down.next_down(), down, u, up, up.next_up()]
    };
    points.flat_map(around).filter(|u| *u >= 0.0)
}

/// Where a piece is widest for its `u` and the result just below a power of two: the largest error at zero force.
#[test]
fn where_the_approximation_weighs_most() {
    Worst::over(End::ZeroForce, by_ratio(60_000, (255.5, 275.0), 0..60_000)).check("ZeroForce, 255.5 to 275");
}

/// From the last table entry to where the result is subnormal.
#[test]
fn large_u() {
    Worst::over(End::ZeroForce, by_ratio(20_000, (15.0, 1e9), 0..20_000)).check("ZeroForce to 1e9");
    for end in ENDS {
        let last = if end == End::ZeroCompression { 1e60 } else { 1e180 };
        Worst::over(end, by_ratio(4_000, (10.0, last), 0..4_000)).check(&format!("{end:?} to {last:e}"));
        let tiny = if end == End::ZeroCompression { (1e60, 1e66) } else { (1e180, 1e200) };
        for u in by_ratio(2_000, tiny, 0..2_000) {
            let (_, kept) = exact(reference(end), u);
            let error = Float::with_val(112, epsilon(u, end) - kept);
            assert!(
                error.to_f64().abs() <= 5e-324
                    || ulps(epsilon(u, end), &exact(reference(end), u).1) <= bounds::EPSILON.size
            );
        }
    }
}

#[test]
fn every_f64_has_a_defined_result() {
    for end in ENDS {
        for none in [0.0, -0.0, 5e-324, f64::MIN_POSITIVE, 1e-17] {
            assert_eq!(epsilon(none, end), 1.0);
        }
        assert_eq!((one_minus_epsilon(0.0, end), one_minus_epsilon(-0.0, end)), (0.0, 0.0));
        assert_eq!(one_minus_epsilon(5e-324, end), 5e-324);
        for fast in [f64::INFINITY, f64::MAX, 1e300] {
            assert_eq!((epsilon(fast, end), one_minus_epsilon(fast, end)), (0.0, 1.0));
        }
        for wrong in [f64::NAN, -5e-324, -1e-10, -1.0, -7.5, -8.5, -20.0, -1e300, f64::NEG_INFINITY] {
            assert!(epsilon(wrong, end).is_nan() && one_minus_epsilon(wrong, end).is_nan(), "{wrong:e}");
        }
        for u in by_ratio(100_000, (1e-320, 1e-7), 0..100_000).filter(|u| *u > 0.0) {
            let first = 1.153_448_858_095_288_8 * u;
            assert!((one_minus_epsilon(u, end) - first).abs() <= first * 1e-7 + 1e-323);
            assert!(epsilon(u, end) <= 1.0);
        }
    }
}
