//! The expansion in `u`: other digits, time reversal, and its sum against direct integration.

use super::integration::{confirmed, integrated};
use super::laws::{self, Request, law};
use super::refused;
use crate::Tally;
use crate::random::{Source, by_ratio, choose};
use num_bigint::BigInt;
use num_rational::BigRational;
use rand::RngExt;
use restitution_direct::End;
use restitution_law::ForceLaw;
use restitution_real::Ball;
use restitution_series::{DelayedRecovery, Quantity, coefficients};
use rug::Float;

/// The most powers of an expansion to one of `u` that are summed.
const FINEST: usize = 4;

fn derived(
    quantity: Quantity,
    law: &ForceLaw,
    order: usize,
    digits: usize,
    tally: &mut Tally,
) -> Option<Vec<Ball>> {
    match coefficients(quantity, law, order, digits) {
        Ok(found) => Some(found),
        Err(error) => {
            let request =
                format!("table --law {law} --quantity {quantity:?} --order {order} --digits {digits}");
            refused(&request, &error.to_string(), tally);
            None
        }
    }
}

/// A table at more digits and a higher order.
pub fn other_digits(random: &mut Source, tally: &mut Tally) {
    let law = law(random);
    let quantities = [
        Quantity::Restitution,
        Quantity::ScaledRestitution,
        Quantity::Compression,
        Quantity::DelayedRecovery,
    ];
    let quantity = *choose(random, &quantities);
    let (order, digits) = (random.random_range(1..12), laws::digits(random));
    let first = derived(quantity, &law, order, digits, tally);
    let second = derived(
        quantity,
        &law,
        order + random.random_range(0..4),
        digits + random.random_range(1..40),
        tally,
    );
    match (first, second) {
        (Some(first), Some(second)) => {
            for (k, (one, other)) in first.iter().zip(&second).enumerate() {
                let text = || {
                    format!(
                        "table --law {law} --quantity {quantity:?} --order {order} --digits {digits}, k = {k}"
                    )
                };
                confirmed(&text, one, other, digits, tally);
            }
        }
        (None, None) => {}
        _ => tally.fault(
            "the same request at other digits is answered or refused alike",
            format!("table --law {law} --quantity {quantity:?} --order {order} --digits {digits}"),
        ),
    }
}

/// `epsilon(u) epsilon(-u epsilon(u)^p) = 1` as power series, in balls: no tolerance, but balls that are narrow.
pub fn identity(random: &mut Source, tally: &mut Tally) {
    let law = law(random);
    let (order, digits) = (random.random_range(2..14), 20 + laws::digits(random));
    let Some(c) = derived(Quantity::Restitution, &law, order, digits, tally) else { return };
    tally.count("series reversed in time", 1);
    for (k, product) in reversed(&c, &law.velocity_exponent()).iter().enumerate() {
        let one = Ball::from_integer(i64::from(k == 0), 64);
        tally.expect(product.overlaps(&one), "epsilon(u) epsilon(-u epsilon^p) = 1", || {
            format!("law {law}, order {k} of {order}, {digits} digits: {product:?}")
        });
        // Each of some k^2 terms is known to 10^-digits of products of coefficients of that order.
        let size: f64 = (0..=k).map(|i| (c[i].to_f64() * c[k - i].to_f64()).abs()).sum::<f64>().max(1.0);
        let narrow = size * 4f64.powi(k as i32 + 2) * 10f64.powi(-(digits as i32));
        tally.expect(product.rad().to_f64() <= narrow, "a series reversed in time has its digits", || {
            format!("law {law}, order {k} of {order}, {digits} digits: {product:?}")
        });
    }
}

/// `epsilon(u) epsilon(w)`, `w = -u epsilon(u)^p`.
fn reversed(c: &[Ball], p: &BigRational) -> Vec<Ball> {
    let mut w: Vec<Ball> = power(c, p).iter().map(|w| -w).collect();
    w.insert(0, Ball::from_integer(0, 64));
    w.truncate(c.len());
    let mut composed = vec![Ball::from_integer(0, 64); c.len()];
    for c in c.iter().rev() {
        composed = product(&composed, &w);
        composed[0] += c;
    }
    product(c, &composed)
}

fn product(one: &[Ball], other: &[Ball]) -> Vec<Ball> {
    let term = |k: usize| (0..=k).fold(Ball::from_integer(0, 64), |sum, i| sum + &one[i] * &other[k - i]);
    (0..one.len()).map(term).collect()
}

/// `f^p` of a series that starts with 1 (J. C. P. Miller).
fn power(f: &[Ball], p: &BigRational) -> Vec<Ball> {
    let prec = f.iter().map(Ball::prec).max().unwrap_or(64);
    let whole = |n: usize| BigRational::from_integer(n.into());
    let mut g = vec![Ball::from_integer(1, prec)];
    for k in 1..f.len() {
        let weight = |i: usize| Ball::from_rational(&((p * whole(i) - whole(k - i)) / whole(k)), prec);
        let sum = (1..=k).fold(Ball::from_integer(0, prec), |sum, i| sum + weight(i) * &f[i] * &g[k - i]);
        g.push(sum);
    }
    g
}

/// The sum of the expansion where it converges fast, against direct integration.
pub fn against_integration(random: &mut Source, tally: &mut Tally) {
    let law = law(random);
    let zero_force = law.a() > law.gamma() && random.random_bool(0.5);
    let quantity = if zero_force { Quantity::DelayedRecovery } else { Quantity::Restitution };
    let Some(steps) = steps_per_power(&law, zero_force) else { return };
    let order = steps * random.random_range(12..24);
    let Some(c) = derived(quantity, &law, order, 40, tally) else { return };
    for _ in 0..3 {
        let u = by_ratio(random, 1e-6, 0.3);
        let u = BigRational::new(BigInt::from((u * 1e9) as i64 + 1), 1_000_000_000.into());
        compare(&law, &c, steps, &u, zero_force, random, tally);
    }
}

/// How many powers of the expansion there are to one of `u`: two for spheres at zero force. Finer ones are not summed.
fn steps_per_power(law: &ForceLaw, zero_force: bool) -> Option<usize> {
    if !zero_force {
        return Some(1);
    }
    let denominator = *DelayedRecovery::new(law).ok()?.damping_exponent().denom();
    usize::try_from(denominator).ok().filter(|&steps| steps <= FINEST)
}

fn compare(
    law: &ForceLaw,
    c: &[Ball],
    steps: usize,
    u: &BigRational,
    zero_force: bool,
    random: &mut Source,
    tally: &mut Tally,
) {
    let prec = 256;
    let x = Ball::from_rational(u, prec).pow(&BigRational::new(1.into(), steps.into()));
    let sum = c.iter().rev().fold(Ball::from_integer(0, prec), |sum, c| sum * &x + c);
    // What is left out: the terms fall five times from six powers of u to the next six, so that a hundred of the largest of the
    // last six for each step is more than all that follow, however unevenly they fall.
    let size = |k: usize| (c[k].to_f64() * x.to_f64().powi(k as i32)).abs();
    let (end, six) = (c.len(), 6 * steps);
    let late = (end - six..end).map(size).fold(0.0, f64::max);
    let early = (end - 2 * six..end - six).map(size).fold(0.0, f64::max);
    if late.is_nan() || late >= 0.2 * early {
        return; // too near to the radius of convergence to judge by
    }
    let left_out = 100.0 * steps as f64 * late;
    let digits = ((-left_out.log10()) as usize).min(36).saturating_sub(1);
    if digits < 4 {
        return;
    }
    let end = if zero_force { End::ZeroForce } else { End::ZeroCompression };
    let request = Request { law: law.clone(), u: u.clone(), end, digits: random.random_range(4..=digits) };
    let Some(found) = integrated(&request, request.digits, tally) else {
        return tally.example("sums of the expansion whose integral is refused", &request);
    };
    tally.count("numbers confirmed by the expansion", 1);
    let sum = sum.widened(&Float::with_val(64, left_out));
    confirmed(&|| format!("{request}, by the expansion"), &found, &sum, request.digits.min(digits), tally);
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::SeedableRng;

    #[test]
    fn a_series_with_a_wrong_coefficient_does_not_reverse() {
        let law: ForceLaw = "2,1/3".parse().unwrap();
        let mut c = coefficients(Quantity::Restitution, &law, 6, 20).unwrap();
        let sound = |c: &[Ball]| {
            let one = |k: usize| Ball::from_integer(i64::from(k == 0), 64);
            let products = reversed(c, &law.velocity_exponent());
            products.iter().enumerate().all(|(k, product)| product.overlaps(&one(k)))
        };
        assert!(sound(&c));
        // Off by four radii; odd coefficients are free.
        for k in [2, 4, 6] {
            let right = c[k].clone();
            let off = Float::with_val(64, right.rad() * 4u32);
            c[k] = Ball::new(Float::with_val(right.prec(), right.mid() + off), right.rad());
            assert!(!sound(&c), "C_{k}");
            c[k] = right;
        }
    }

    #[test]
    fn sums_at_zero_force_are_compared_for_steps_of_every_size() {
        let mut random = Source::seed_from_u64(1);
        for (text, steps) in [("1,0", 1), ("2,0", 2), ("3/2,1/2", 2), ("3,0", 3), ("3/4,-1/4", 4)] {
            let law: ForceLaw = text.parse().unwrap();
            assert_eq!(steps_per_power(&law, true), Some(steps), "{text}");
            let mut tally = Tally::default();
            let c = derived(Quantity::DelayedRecovery, &law, 12 * steps, 40, &mut tally).unwrap();
            compare(&law, &c, steps, &laws::ratio(1, 50), true, &mut random, &mut tally);
            assert_eq!(
                (tally.faults_found(), tally.counts["numbers confirmed by the expansion"]),
                (0, 1),
                "{text}"
            );
        }
        assert_eq!(steps_per_power(&"2,1/3".parse().unwrap(), true), None); // fifths
    }
}
