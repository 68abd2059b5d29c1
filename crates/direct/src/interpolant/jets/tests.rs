use super::*;
use rug::Rational;

const BITS: u32 = 8;

/// A polynomial with these rows, in units of `2^-8`.
fn jets(rows: &[&[i32]]) -> Jets {
    let coefficients = rows.concat().into_iter().map(Integer::from).collect();
    Jets { width: rows[0].len(), bits: BITS, coefficients }
}

fn ratio(n: i32, d: i32) -> Rational {
    Rational::from((n, d))
}

/// The value at a place, exactly.
fn value(x: &Jets, theta: &Rational, delta: &Rational) -> Rational {
    let mut sum = Rational::new();
    for k in (0..x.rows()).rev() {
        let row = x.row(k).iter().rev().fold(Rational::new(), |sum, c| sum * delta + c);
        sum = sum * theta + row;
    }
    sum >> x.bits
}

fn places() -> impl Iterator<Item = (Rational, Rational)> {
    let thetas = [ratio(0, 1), ratio(1, 3), ratio(1, 1)];
    thetas.into_iter().flat_map(|t| [-1, 0, 1].map(|d| (t.clone(), ratio(d, 1))))
}

fn number(x: &Rational) -> f64 {
    x.to_f64()
}

#[test]
fn sums_products_and_derivatives_are_exact() {
    let (x, y) = (jets(&[&[3, -5], &[7, 11], &[-2, 1]]), jets(&[&[1, 2, -4], &[-6, 9, 13]]));
    for (theta, delta) in places() {
        let at = |x: &Jets| value(x, &theta, &delta);
        assert_eq!(at(&x.product(&y)), at(&x) * at(&y));
        assert_eq!(at(&x.plus(&y)), at(&x) + at(&y));
        let fine = Jets { bits: BITS + 3, ..y.clone() };
        assert_eq!(at(&x.plus(&fine)), at(&x) + at(&fine));
        assert_eq!(at(&fine.plus(&x)), at(&x) + at(&fine));
        assert_eq!(at(&x.clone().negative()), -at(&x));
        // (7 + 11 d) + 2 t (-2 + d)
        let slope =
            (ratio(7, 256) + ratio(11, 256) * &delta) + (ratio(-4, 256) + ratio(2, 256) * &delta) * &theta;
        assert_eq!(at(&x.derivative()), slope);
    }
    assert_eq!(x.end(), [8, 7].map(Integer::from));
    assert_eq!(x.size().to_f64(), 29.0 / 256.0);
    let integral = (8.0 + 18.0 / 2.0 + 3.0 / 3.0) / 256.0;
    assert!((x.integral().to_f64() / integral - 1.0).abs() < 1e-15);
    assert_eq!(schoolbook(x.row(0), y.row(1)), [-18, 57, -6, -65].map(Integer::from));
}

#[test]
fn what_is_cut_off_and_rounded_is_counted() {
    let x = jets(&[&[0x17, -0x29, 0x30], &[0x11, 0x4f, -0x20], &[-0x35, 0x11, 0x7]]);
    // Two rows and columns of four bits: four truncations, and the rest.
    let mut lost = Ball::from_ratio(1, 2, BOUND_BITS);
    let kept = x.rounded(2, 2, 4, &mut lost);
    assert_eq!(kept.coefficients, [1, -3, 1, 4].map(Integer::from));
    let dropped = f64::from(0x30 + 0x20 + 0x35 + 0x11 + 0x7) / 256.0;
    assert!((lost.to_f64() - (0.5 + dropped + 4.0 / 16.0)).abs() < 1e-15, "{lost:?}");
    for (theta, delta) in places() {
        let off = (value(&x, &theta, &delta) - value(&kept, &theta, &delta)).abs();
        assert!(number(&off) <= lost.to_f64() - 0.5);
    }
    // Nothing is lost where nothing is cut off.
    let mut nothing = zero();
    assert_eq!(x.rounded(9, 9, BITS, &mut nothing).coefficients, x.coefficients);
    assert_eq!(nothing.to_f64(), 0.0);
    let mut units = zero();
    x.rounded(9, 9, BITS - 1, &mut units);
    assert_eq!(units.to_f64(), 9.0 / 128.0);
}

#[test]
fn ranges_hold_the_values() {
    let (low, high) = (-1.0 / 256.0, 13.0 / 256.0);
    // 3 + 5 t, less or more 2 of the bend and 2 of the deviations.
    for rows in [[[3, -1], [5, 1], [2, 0]], [[8, -1], [-5, 1], [1, -1]], [[3, 1], [5, 1], [0, -2]]] {
        let rows: Vec<&[i32]> = rows.iter().map(|row| &row[..]).collect();
        let x = jets(&rows);
        let range = x.range();
        assert_eq!((range.low.to_f64(), range.high.to_f64()), (low + 0.0, high - 1.0 / 256.0));
        for (theta, delta) in places() {
            let at = number(&value(&x, &theta, &delta));
            assert!(range.low.to_f64() <= at && at <= range.high.to_f64());
        }
    }
    let one = jets(&[&[3, -1]]).range();
    assert_eq!((one.low.to_f64(), one.high.to_f64()), (2.0 / 256.0, 4.0 / 256.0));
    let range = |low: f64, high: f64| Range { low: Ball::from_f64(low, 64), high: Ball::from_f64(high, 64) };
    for (low, high, largest, least) in [
        (1.0, 3.0, 3.0, Some(1.0)),
        (-3.0, -1.0, 3.0, Some(1.0)),
        (-3.0, 1.0, 3.0, None),
        (-1.0, 3.0, 3.0, None),
        (0.0, 3.0, 3.0, None),
        (-3.0, 0.0, 3.0, None),
    ] {
        let range = range(low, high);
        assert_eq!(range.largest().to_f64(), largest);
        assert_eq!(range.least().map(|x| x.to_f64()), least);
    }
}

/// Horner's rule with truncations and columns cut off, against the exact value at `theta(delta)`.
#[test]
fn a_value_at_a_jet_is_off_by_what_is_said() {
    let x = jets(&[&[0x41, -0x2f], &[-0x53, 0x1d], &[0x77, -0x35], &[-0x61, 0x3b]]);
    for theta in [jets(&[&[0x35, 0x25]]), jets(&[&[0x85, -0x55]]), jets(&[&[0xb1, 0x4f]])] {
        let (found, error) = x.at(&theta);
        assert_eq!((found.rows(), found.width, found.bits), (1, 2, BITS));
        let mut worst = 0.0_f64;
        for d in -4..=4 {
            let delta = ratio(d, 4);
            let place = value(&theta, &Rational::new(), &delta);
            let off = value(&x, &place, &delta) - value(&found, &Rational::new(), &delta);
            worst = worst.max(number(&off.abs()));
        }
        let error = error.to_f64();
        assert!(worst <= error && error < 4.0 * worst, "{worst} {error}");
        // Each step drops a column and truncates two numbers; what was lost before is carried by the size of theta.
        let reach = theta.size().to_f64();
        let (mut sum, mut wanted) = (x.row(3).to_vec(), 0.0);
        for k in (0..3).rev() {
            let product = schoolbook(&sum, theta.row(0));
            let dropped = product[2].to_f64().abs() * f64::exp2(-16.0);
            wanted = wanted * reach + dropped + 2.0 / 256.0;
            sum = (0..2).map(|j| Integer::from(&product[j] >> BITS) + &x.row(k)[j]).collect();
        }
        assert!((error / wanted - 1.0).abs() < 1e-12, "{error} {wanted}");
        assert_eq!(found.row(0), sum);
    }
}

#[test]
fn a_quotient_is_one_but_for_rounding() {
    let numbers = |c: &[i32]| -> Vec<Integer> { c.iter().map(|c| Integer::from(*c) << 40_u32).collect() };
    let (a, b) = (numbers(&[3, -5, 7, 2]), numbers(&[4, 1, -2]));
    let found = quotient(&a, &b, 40).unwrap();
    let product = schoolbook(&found, &b);
    for (k, a) in a.iter().enumerate() {
        let off = (Integer::from(&product[k] >> 40_u32) - a).abs();
        assert!(off < 16, "{k}: {off}");
    }
    assert!(quotient(&a, &numbers(&[0, 1]), 40).is_none());
    assert!(quotient(&a, &[], 40).is_none());
}
