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
use restitution_series::{Quantity, coefficients};
use rug::Float;

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

/// `epsilon(u) epsilon(-u epsilon(u)^p) = 1` as power series, to the digits of the coefficients.
pub fn identity(random: &mut Source, tally: &mut Tally) {
    let law = law(random);
    let (order, digits) = (random.random_range(2..14), 20 + laws::digits(random));
    let Some(c) = derived(Quantity::Restitution, &law, order, digits, tally) else { return };
    let prec = 64 + 4 * digits as u32;
    let c: Vec<Float> = c.iter().map(|c| Float::with_val(prec, c.mid())).collect();
    let p = Float::with_val(prec, restitution_real::convert::rug_rational(&law.velocity_exponent()));
    // w = -u epsilon^p, then the product of epsilon(u) and sum c_k w^k.
    let mut w = power(&c, &p);
    w.insert(0, Float::new(prec));
    w.truncate(c.len());
    w.iter_mut().for_each(|w| *w = -w.clone());
    let mut composed = vec![Float::new(prec); c.len()];
    for c in c.iter().rev() {
        composed = product(&composed, &w);
        composed[0] += c;
    }
    let one = product(&c, &composed);
    tally.count("series reversed in time", 1);
    for (k, residual) in one.iter().enumerate() {
        let residual = if k == 0 { Float::with_val(prec, residual - 1u32) } else { residual.clone() };
        // Each of some k^2 terms is off by 10^-digits of products of coefficients of that order.
        let size: f64 = (0..=k).map(|i| (c[i].to_f64() * c[k - i].to_f64()).abs()).sum::<f64>().max(1.0);
        let allowed = size * 4f64.powi(k as i32 + 2) * 10f64.powi(-(digits as i32));
        tally.expect(residual.to_f64().abs() <= allowed, "epsilon(u) epsilon(-u epsilon^p) = 1", || {
            format!("law {law}, order {k} of {order}, {digits} digits: {residual:e}, allowed {allowed:e}")
        });
    }
}

fn product(one: &[Float], other: &[Float]) -> Vec<Float> {
    let prec = one[0].prec();
    let term = |k: usize| {
        (0..=k).fold(Float::new(prec), |sum, i| sum + Float::with_val(prec, &one[i] * &other[k - i]))
    };
    (0..one.len()).map(term).collect()
}

/// `f^p` of a series that starts with 1 (J. C. P. Miller).
fn power(f: &[Float], p: &Float) -> Vec<Float> {
    let prec = f[0].prec();
    let mut g = vec![Float::with_val(prec, 1)];
    for k in 1..f.len() {
        let term = |i: usize| (Float::with_val(prec, p * i as u32) - (k - i) as u32) * &f[i] * &g[k - i];
        let sum = (1..=k).fold(Float::new(prec), |sum, i| sum + term(i));
        g.push(sum / k as u32);
    }
    g
}

/// The sum of the expansion where it converges fast, against direct integration.
pub fn against_integration(random: &mut Source, tally: &mut Tally) {
    let law = law(random);
    let zero_force = law.a() > law.gamma() && random.random_bool(0.5);
    let quantity = if zero_force { Quantity::DelayedRecovery } else { Quantity::Restitution };
    let order = random.random_range(12..24);
    let Some(c) = derived(quantity, &law, order, 40, tally) else { return };
    let step = if zero_force {
        match half_power(&law) {
            Some(step) => step,
            None => return,
        }
    } else {
        BigRational::from_integer(1.into())
    };
    for _ in 0..3 {
        let u = by_ratio(random, 1e-6, 0.3);
        let u = BigRational::new(BigInt::from((u * 1e9) as i64 + 1), 1_000_000_000.into());
        compare(&law, &c, &step, &u, zero_force, random, tally);
    }
}

/// The step of the exponents of `u` at zero force; spheres expand in halves, and only they are summed.
fn half_power(law: &ForceLaw) -> Option<BigRational> {
    (*law == ForceLaw::viscoelastic_spheres()).then(|| BigRational::new(1.into(), 2.into()))
}

fn compare(
    law: &ForceLaw,
    c: &[Ball],
    step: &BigRational,
    u: &BigRational,
    zero_force: bool,
    random: &mut Source,
    tally: &mut Tally,
) {
    let prec = 256;
    let x = Ball::from_rational(u, prec).pow(step);
    let sum = c.iter().rev().fold(Ball::from_integer(0, prec), |sum, c| sum * &x + c);
    // What is left out: the terms fall five times from six to the next six, so that a hundred of the largest of the
    // last six is more than all that follow, however unevenly they fall.
    let size = |k: usize| (c[k].to_f64() * x.to_f64().powi(k as i32)).abs();
    let last = c.len() - 1;
    let late = (last - 5..=last).map(size).fold(0.0, f64::max);
    let early = (last - 11..=last - 6).map(size).fold(0.0, f64::max);
    if late.is_nan() || late >= 0.2 * early {
        return; // too near to the radius of convergence to judge by
    }
    let left_out = 100.0 * late;
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
