use super::*;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use rug::Integer;
use std::collections::BTreeMap;

const BITS: u32 = 90;
const GRADING: Grading = Grading { row: 1.5, column: 2.5 };
const FULL: Detail = Detail { left_out: 0.0, wider: 1.0 };

/// Coefficients by place, in fractions.
type Exact = BTreeMap<(usize, usize), BigRational>;

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

fn of_f64(x: f64) -> BigRational {
    BigRational::from_float(x).unwrap()
}

fn of_magnitude(x: Magnitude) -> BigRational {
    of_f64(x.to_f64())
}

/// Rows with `columns` coefficients that fall, of either sign, with many digits and some zeros.
fn rows(count: usize, columns: usize) -> Vec<Fixed> {
    let coefficient = |n: usize, j: usize| -> Integer {
        if (n, j) == (0, 0) {
            return Integer::from(1) << BITS;
        }
        if (n + 2 * j) % 5 == 4 {
            return Integer::new();
        }
        let sign = if (n * 3 + j) % 4 < 2 { 1 } else { -1 };
        (Integer::from(sign) << BITS) / (7 * 3i64.pow((n + j).min(30) as u32) + (n + 5 * j) as i64)
    };
    let row = |n: usize| (0..columns).map(|j| coefficient(n, j)).collect::<Vec<_>>();
    (0..count).map(|n| Fixed::from_integers(&row(n), 2)).collect()
}

fn exact(rows: &[Fixed]) -> Exact {
    let unit = BigRational::from_integer(num_bigint::BigInt::from(1) << BITS);
    let number = |x: Integer| BigRational::from_integer(x.to_string().parse().unwrap()) / &unit;
    let of_row = |(n, row): (usize, &Fixed)| -> Vec<_> {
        (0..row.len()).map(|j| ((n, j), number(row.integer(j)))).collect()
    };
    rows.iter().enumerate().flat_map(of_row).collect()
}

fn known(sketch: &Sketch) -> Exact {
    let place = |i: usize| (i / sketch.columns, i % sketch.columns);
    sketch.values.iter().enumerate().map(|(i, &value)| (place(i), of_f64(value))).collect()
}

fn minus(x: &Exact, y: &Exact) -> Exact {
    let mut out = x.clone();
    for (place, value) in y {
        *out.entry(*place).or_insert_with(BigRational::zero) -= value;
    }
    out
}

fn times(x: &Exact, y: &Exact, cut: usize) -> Exact {
    let mut out = Exact::new();
    for ((n, i), x) in x {
        for ((m, j), y) in y.iter().filter(|((m, _), _)| n + m < cut) {
            *out.entry((n + m, i + j)).or_insert_with(BigRational::zero) += x * y;
        }
    }
    out
}

fn one_norm(x: &Exact) -> BigRational {
    x.values().map(Signed::abs).sum()
}

fn sloped(x: &Exact) -> Exact {
    let e = |n: usize, j: usize| ratio(3, 2) * ratio(n as i64, 1) + ratio(5, 2) * ratio(j as i64, 1);
    x.iter().map(|(&(n, j), value)| ((n, j), value * e(n, j))).collect()
}

/// At least the number, and above it by no more than a share.
fn closely_above(bound: &BigRational, number: &BigRational, share: f64, what: &str) {
    assert!(bound >= number, "{what}: {:e} for {:e}", bound.to_f64().unwrap(), number.to_f64().unwrap());
    let most = number * (BigRational::one() + of_f64(share));
    assert!(*bound <= most, "{what}: {:e} for {:e}", bound.to_f64().unwrap(), number.to_f64().unwrap());
}

#[test]
fn what_a_sketch_leaves_out_is_counted() {
    let rows = rows(6, 9);
    let all = exact(&rows);
    for left_out in [0.0, 1e-4, 1e-2, 0.1] {
        for wider in [1.0, 1.5] {
            let sketch = Sketch::new(&rows, &[], BITS, GRADING, Detail { left_out, wider }).unwrap();
            let missing = minus(&all, &known(&sketch));
            let inside = |&(n, j): &(usize, usize)| n < sketch.rows() && j < sketch.columns;
            let (kept, dropped): (Exact, Exact) =
                missing.clone().into_iter().partition(|(place, _)| inside(place));
            // Of what is kept, eight roundings of a double and one unit each; all of what is not.
            let unit = BigRational::new(1.into(), num_bigint::BigInt::from(1) << BITS);
            let rounding = |place: &(usize, usize)| match all.get(place).filter(|x| !x.is_zero()) {
                None => BigRational::zero(),
                Some(x) => x.abs() * of_f64(8.0 * f64::EPSILON) + &unit,
            };
            let stated: Exact = kept.keys().map(|place| (*place, rounding(place))).chain(dropped).collect();
            assert!(kept.iter().all(|(place, value)| value.abs() <= rounding(place)));
            closely_above(&of_magnitude(sketch.error), &one_norm(&stated), 1e-12, "error");
            closely_above(
                &of_magnitude(sketch.slope_error),
                &one_norm(&sloped(&stated)),
                1e-12,
                "slope error",
            );
            let norm = one_norm(&known(&sketch)) + of_magnitude(sketch.error);
            closely_above(&of_magnitude(sketch.norm()), &norm, 1e-8, "norm");
            assert!(of_magnitude(sketch.norm()) >= one_norm(&all));
        }
    }
}

/// As many rows and columns as the norms of rows and columns ask for, times what is asked for.
#[test]
fn as_much_is_kept_as_counts() {
    let shape = |left_out: f64, wider: f64, power: &[Fixed]| {
        let sketch = Sketch::new(&rows(6, 9), power, BITS, GRADING, Detail { left_out, wider }).unwrap();
        (sketch.rows(), sketch.columns)
    };
    let wanted = |left_out: f64, all: &Exact| {
        let rest = |of: &dyn Fn(&(usize, usize)) -> bool| -> f64 {
            all.iter().filter(|(place, _)| of(place)).map(|(_, x)| x.abs().to_f64().unwrap()).sum()
        };
        let row = (1..).find(|&rows| rest(&|place| place.0 >= rows) < left_out).unwrap();
        (row, (1..).find(|&columns| rest(&|place| place.1 >= columns) < left_out).unwrap())
    };
    let all = exact(&rows(6, 9));
    for left_out in [1e-4, 1e-2, 0.1, 10.0] {
        let (n, j) = wanted(left_out, &all);
        assert_eq!(shape(left_out, 1.0, &[]), (n, j), "{left_out}");
        let wide = |count: usize| (count as f64 * 1.5).ceil() as usize;
        assert_eq!(shape(left_out, 1.5, &[]), (wide(n).min(6), wide(j)), "{left_out}");
    }
    // A power that falls more slowly keeps more, by what is left out beside its norm.
    let ten = |x: &Fixed| x.scaled(|j| (if j == 0 { 1 } else { 30 }, 1));
    let power: Vec<Fixed> = rows(6, 9).iter().map(ten).collect();
    let of_power = exact(&power);
    for left_out in [1e-4, 1e-2, 0.1] {
        let (n, j) = wanted(left_out, &all);
        let (m, i) = wanted(left_out * one_norm(&of_power).to_f64().unwrap(), &of_power);
        assert_eq!(shape(left_out, 1.0, &power), (n.max(m).min(6), j.max(i)), "{left_out}");
    }
    // A small power counts as if its norm were 1.
    let small: Vec<Fixed> = rows(6, 9).iter().map(|row| row.scaled(|_| (1, 100))).collect();
    let (n, j) = wanted(1e-2, &all);
    let (m, i) = wanted(1e-2, &exact(&small));
    assert_eq!(shape(1e-2, 1.0, &small), (n.max(m), j.max(i)));
    assert!(matches!(
        Sketch::new(&rows(20, 601), &[], BITS, GRADING, FULL).map(|_| ()),
        Err(Unbounded::Large)
    ));
    assert!(Sketch::new(&rows(20, 600), &[], BITS, GRADING, FULL).is_ok());
}

#[test]
fn norms_by_place_are_all_there() {
    let sketch = Sketch::new(&rows(4, 5), &[], BITS, GRADING, Detail { left_out: 1e-2, wider: 1.0 }).unwrap();
    let norms = sketch.norms_by(|n, j| n + 2 * j);
    let known = known(&sketch);
    for (place, norm) in norms.iter().enumerate() {
        let at: Exact =
            known.iter().filter(|((n, j), _)| n + 2 * j == place).map(|(k, x)| (*k, x.clone())).collect();
        let missing = if place == 0 { of_magnitude(sketch.error) } else { BigRational::zero() };
        closely_above(&of_magnitude(*norm), &(one_norm(&at) + missing), 1e-12, "norm at a place");
    }
    assert_eq!(norms.len(), sketch.rows() - 1 + 2 * (sketch.columns - 1) + 1);
}

/// Sums of products against fractions, with the rounding that is stated; rows beyond the cut are left out.
#[test]
fn products_of_sketches_round_by_what_is_stated() {
    let sketch = Sketch::new(&rows(4, 5), &[], BITS, GRADING, FULL).unwrap();
    let other: Vec<f64> = sketch.values.iter().enumerate().map(|(i, x)| x * (1.0 + i as f64 / 7.0)).collect();
    let both = [(1.25, sketch.values.as_slice(), other.as_slice()), (-3.0, &other, &other)];
    let exact_of = |values: &[f64]| -> Exact {
        let place = |i: usize| (i / sketch.columns, i % sketch.columns);
        values.iter().enumerate().map(|(i, &x)| (place(i), of_f64(x))).collect()
    };
    for terms in [&both[..1], &both[..]] {
        let (product, rounding) = sketch.sum(terms);
        let wide = 2 * sketch.columns - 1;
        let found: Exact =
            product.iter().enumerate().map(|(i, &x)| ((i / wide, i % wide), of_f64(x))).collect();
        let mut sum = Exact::new();
        let mut sizes = BigRational::zero();
        for (c, f, g) in terms {
            let product = times(&exact_of(f), &exact_of(g), sketch.cut);
            let c = of_f64(*c);
            product.iter().for_each(|(k, x)| *sum.entry(*k).or_insert_with(BigRational::zero) += x * &c);
            sizes += c.abs() * one_norm(&exact_of(f)) * one_norm(&exact_of(g));
        }
        assert!(one_norm(&minus(&found, &sum)) <= of_magnitude(rounding));
        let stated = sizes * of_f64((terms.len() * 20 + 4) as f64 * f64::EPSILON);
        closely_above(&of_magnitude(rounding), &stated, 1e-8, "rounding");
        for less_one in [false, true] {
            let mut sum = found.clone();
            if less_one {
                *sum.get_mut(&(0, 0)).unwrap() -= BigRational::one();
            }
            let stated = one_norm(&sum) + of_magnitude(rounding) + of_f64(f64::EPSILON);
            closely_above(&of_magnitude(sketch.norm_of_sum(terms, less_one)), &stated, 1e-8, "norm of a sum");
        }
    }
}

#[test]
fn squares_hold_the_square() {
    for left_out in [0.0, 1e-2, 0.1] {
        let rows = rows(4, 5);
        let sketch = Sketch::new(&rows, &[], BITS, GRADING, Detail { left_out, wider: 1.0 }).unwrap();
        let square = sketch.squared();
        assert_eq!((square.rows(), square.columns), (sketch.rows(), sketch.columns));
        let truth = times(&exact(&rows), &exact(&rows), sketch.cut);
        assert!(one_norm(&minus(&truth, &known(&square))) <= of_magnitude(square.error));
        // What is missing of the factors, and what does not fit.
        let (_, rounding) = sketch.sum(&[(1.0, &sketch.values, &sketch.values)]);
        let product = times(&known(&sketch), &known(&sketch), sketch.cut);
        let inside = |&(n, j): &(usize, usize)| n < sketch.rows() && j < sketch.columns;
        let outside: Exact = product.into_iter().filter(|(place, _)| !inside(place)).collect();
        let error = of_magnitude(sketch.error);
        let stated = one_norm(&outside)
            + of_magnitude(rounding)
            + (ratio(2, 1) * one_norm(&known(&sketch)) + &error) * &error;
        closely_above(&of_magnitude(square.error), &stated, 1e-7, "square");
    }
}

/// `f^p` as far as so many rows and columns, by Miller's formula in fractions.
fn exact_power(f: &Exact, power: &BigRational, rows: usize, columns: usize) -> Exact {
    let e = |(n, j): (usize, usize)| ratio(3, 2) * ratio(n as i64, 1) + ratio(5, 2) * ratio(j as i64, 1);
    let mut out: Exact = [((0, 0), BigRational::one())].into();
    for n in 0..rows {
        for j in (0..columns).filter(|&j| n + j > 0) {
            let term = |(&(m, i), x): (&(usize, usize), &BigRational)| {
                let weight = (power + BigRational::one()) * e((m, i)) - e((n, j));
                weight * x * &out[&(n - m, j - i)]
            };
            let below = f.iter().filter(|&(&(m, i), x)| m <= n && i <= j && m + i > 0 && !x.is_zero());
            let sum: BigRational = below.map(term).sum();
            // Shortened: a tail of 300 bits is nothing beside a bound.
            let value = sum / e((n, j));
            out.insert((n, j), shortened(value));
        }
    }
    out
}

fn shortened(x: BigRational) -> BigRational {
    let scale: num_bigint::BigInt = num_bigint::BigInt::from(1) << 300;
    BigRational::new((x * BigRational::from_integer(scale.clone())).to_integer(), scale)
}

/// The powers that the proofs take, of a polynomial whose powers are known in fractions: every error holds.
#[test]
fn errors_of_powers_hold() {
    let rows = rows(3, 4);
    let all = exact(&rows);
    for (left_out, wider) in [(1e-2, 1.0), (1e-3, 1.5), (0.0, 1.0)] {
        let sketch = Sketch::new(&rows, &[], BITS, GRADING, Detail { left_out, wider }).unwrap();
        let powers = Powers::new(sketch.clone(), GRADING).unwrap();
        assert!(of_magnitude(powers.base()) >= one_norm(&all));
        let cut = |power: Exact| -> Exact { power.into_iter().filter(|((n, _), _)| *n < 3).collect() };
        let reciprocal = cut(exact_power(&all, &ratio(-1, 1), 3, 16));
        assert!(of_magnitude(powers.reciprocal()) >= one_norm(&reciprocal));
        assert!(of_magnitude(powers.reciprocal()) <= one_norm(&reciprocal) * ratio(2, 1));
        for (numerator, denominator) in
            [(1, 2), (-1, 2), (3, 2), (-5, 2), (1, 1), (0, 1), (5, 1), (7, 1), (-13, 2)]
        {
            let power = numerator as f64 / denominator as f64;
            let Ok(found) = powers.power(power) else {
                assert!(left_out > 0.0 && power.abs() > 2.0, "{power} with {left_out}");
                continue;
            };
            let truth = cut(exact_power(&all, &ratio(numerator, denominator), 3, 16));
            let off = one_norm(&minus(&truth, &known(&found)));
            assert!(off <= of_magnitude(found.error), "{power}: {:e}", off.to_f64().unwrap());
        }
    }
}

/// Section 9 of `docs/error-bounds.md`, as it is written there, in double precision.
#[test]
fn errors_of_powers_are_those_of_the_document() {
    for left_out in [1e-3, 0.0] {
        let f = Sketch::new(&rows(3, 6), &[], BITS, GRADING, Detail { left_out, wider: 1.0 }).unwrap();
        let powers = Powers::new(f.clone(), GRADING).unwrap();
        let number = |x: BigRational| x.to_f64().unwrap();
        let gap_of = |x: &Sketch, y: &Sketch| {
            let one: Exact = [((0, 0), BigRational::one())].into();
            number(one_norm(&minus(&times(&known(x), &known(y), f.cut), &one)))
        };
        let norm = |x: &Sketch| number(one_norm(&known(x)));
        let (error, slope_error) = (f.error.to_f64(), f.slope_error.to_f64());
        let inverse = f.raw_power(-1.0, GRADING);
        let reciprocal = norm(&inverse) / (1.0 - gap_of(&f, &inverse) - error * norm(&inverse));
        let share = (powers.reciprocal().to_f64() / reciprocal - 1.0).abs();
        assert!(share < 1e-6, "1/f: {share}");
        for power in [0.5, -1.5, 2.0, -2.5] {
            let (q, opposite) = (f.raw_power(power, GRADING), f.raw_power(-power, GRADING));
            let inverse = norm(&opposite) / (1.0 - gap_of(&q, &opposite));
            let (df, dq) = (sloped(&known(&f)), sloped(&known(&q)));
            let p = of_f64(power);
            let second: Exact = times(&known(&q), &df, f.cut).into_iter().map(|(k, x)| (k, x * &p)).collect();
            let (df, dq) = (number(one_norm(&df)), number(one_norm(&dq)));
            let first = times(&known(&f), &sloped(&known(&q)), f.cut);
            let defect = number(one_norm(&minus(&first, &second)));
            // What is missing of f, and sixteen roundings of a double.
            let missing = error * dq + power.abs() * norm(&q) * slope_error;
            let inexact = dq * (norm(&f) + error) + power.abs() * norm(&q) * (df + slope_error);
            let defect = defect + missing + 16.0 * f64::EPSILON * inexact;
            let x = defect * reciprocal * inverse / 1.5;
            let xi = x / (1.0 - x);
            let expected = norm(&q) * xi / (1.0 - xi);
            let found = powers.power(power).unwrap();
            // Sums of doubles are rounded by up to 1e-13 of their norms.
            let off = found.error.to_f64() - expected;
            let rounding =
                1e-6 * expected + 4e-13 * expected / defect * (norm(&f) * dq + power.abs() * norm(&q) * df);
            assert!((0.0..rounding).contains(&off), "{power}: {:e} for {expected:e}", found.error.to_f64());
            assert_eq!(found.values, q.values);
        }
    }
}

#[test]
fn large_powers_are_squares_where_doubles_see_no_small_product() {
    let f = Sketch::new(&rows(3, 6), &[], BITS, GRADING, FULL).unwrap();
    let powers = Powers::new(f.clone(), GRADING).unwrap();
    // At once where that is precise: up to 6 always, beyond it if little is missing.
    assert_eq!(powers.power(6.0).unwrap().values, f.raw_power(6.0, GRADING).values);
    let at_once = powers.power_within(6.5);
    let found = powers.power(6.5).unwrap();
    let root = powers.power(3.25).unwrap().squared();
    match at_once.filter(Sketch::is_precise) {
        Some(at_once) => assert_eq!(found.values, at_once.values),
        None => assert_eq!(found.values, root.values),
    }
    let precise = |error: f64| Sketch { error: Magnitude::exact(error), ..f.clone() }.is_precise();
    let norm = f.norm().to_f64();
    assert!(precise(0.1 * norm) && !precise(0.2 * norm));
}

#[test]
fn more_detail_is_tried_only_where_it_may_help() {
    let tried = |answers: [Result<u32, Unbounded>; 3]| {
        let count = std::cell::Cell::new(0);
        let found = in_detail(|_| {
            count.set(count.get() + 1);
            answers[count.get() - 1]
        });
        (count.get(), found.ok())
    };
    let (coarse, large) = (Err(Unbounded::Coarse), Err(Unbounded::Large));
    assert_eq!(tried([Ok(1), Ok(2), Ok(3)]), (1, Some(1)));
    assert_eq!(tried([coarse, Ok(2), Ok(3)]), (2, Some(2)));
    assert_eq!(tried([coarse, coarse, Ok(3)]), (3, Some(3)));
    assert_eq!(tried([large, Ok(2), Ok(3)]), (1, None));
    assert_eq!(tried([coarse, coarse, coarse]), (3, None));
}

#[test]
fn limits_belong_to_what_is_within() {
    assert!(within(Magnitude::exact(0.25), 0.25) && within(Magnitude::ZERO, 0.25));
    assert!(!within(Magnitude::exact(0.25f64.next_up()), 0.25));
    assert!(!within(Magnitude::exact(f64::INFINITY), 0.25) && !within(Magnitude::exact(f64::NAN), 0.25));
}

#[test]
fn one_over_one_minus_is_above() {
    for x in [0.0, 1e-300, 1e-17, 0.1, 0.25, 0.5, 0.9, 0.998, 0.99899] {
        let found = of_magnitude(over_one_minus(Magnitude::exact(x)).unwrap());
        let exact = BigRational::one() / (BigRational::one() - of_f64(x));
        // Of the rest, two roundings; of the quotient, two more.
        closely_above(&found, &exact, 3e-13, "1/(1-x)");
        assert!(found > exact);
    }
    for x in [0.9991, 1.0, 1.5, f64::INFINITY] {
        assert!(over_one_minus(Magnitude::exact(x)).is_none(), "{x}");
    }
}

#[test]
fn what_counts_is_counted_from_the_end() {
    let norms = [8.0, 4.0, 2.0, 1.0, 0.0];
    for (limit, count) in [(0.5, 4), (1.0, 4), (1.5, 3), (3.0, 3), (3.5, 2), (7.0, 2), (7.5, 1), (20.0, 1)] {
        assert_eq!(counting(&norms, limit), count, "{limit}");
    }
    assert_eq!(counting(&[1.0, f64::NAN, 0.0], 1.0), 2);
    assert_eq!(counting(&[], 1.0), 1);
}
