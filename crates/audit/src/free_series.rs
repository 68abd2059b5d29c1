//! The paper's steps on formal series with freely chosen numbers, apart from the project's own engine.

use crate::AuditError;
use crate::samples::Samples;
use num_rational::BigRational;
use num_traits::{One, Zero};
use restitution_series::{FractionalSeries, SeriesError};

/// The coefficients `b_2 .. b_9` of `x(t) = sum b_k t^(k/2)` by collecting the orders of (A1).
///
/// ```text
/// x'' + alpha g^(-1/5) x' sqrt(x) + g^(-2/5) x^(3/2) = 0,    x(0) = 0, x'(0) = g^(4/5)
/// ```
///
/// `root` is `g^(1/5)`.
pub fn collected_orders(alpha: &BigRational, root: &BigRational) -> Result<Vec<BigRational>, AuditError> {
    let mut b = vec![BigRational::zero(), BigRational::zero(), root.pow(4)];
    for k in 3..10_i64 {
        b.push(BigRational::zero());
        let residual = residual(alpha, root, &b)?;
        let unknown = BigRational::new((k * (k - 2)).into(), 4.into());
        let index = b.len() - 1;
        // x'' has b_k t^(k/2 - 2): below t^0 there is nothing to collect.
        let rest = if k < 4 { BigRational::zero() } else { residual.coefficient(index - 4)?.clone() };
        b[index] = -rest / unknown;
    }
    Ok(b)
}

/// The left side of (A1) for given `b_k`.
pub fn residual(
    alpha: &BigRational,
    root: &BigRational,
    b: &[BigRational],
) -> Result<FractionalSeries, SeriesError> {
    let x = FractionalSeries::new(2, b.to_vec());
    let velocity = x.derivative()?;
    let half = BigRational::new(1.into(), 2.into());
    let drag = velocity.multiply(&x.power(&half)?)?;
    let force = x.power(&(&half + BigRational::one()))?;
    let times = |series: &FractionalSeries, factor: BigRational| {
        FractionalSeries::new(2, series.coefficients().iter().map(|c| c * &factor).collect())
    };
    let forces = times(&drag, alpha / root).add(&times(&force, root.pow(-2)))?;
    velocity.derivative()?.add(&forces)
}

/// The derivatives `x_n^(m)(T)`, `n = 0 .. 3`, `m = 0 .. 4`, of trajectories drawn at random, `x_0'(T) = 0`.
pub struct FreeMotion(pub Vec<Vec<BigRational>>);

impl FreeMotion {
    /// Draws one.
    pub fn draw(samples: &mut Samples) -> Self {
        let mut rows: Vec<_> = (0..4).map(|_| samples.fractions(5)).collect();
        rows[0][1] = BigRational::zero();
        Self(rows)
    }

    /// The coefficients of `u^0 .. u^3` in `x^(order)(T + dt)`, `dt = sum shift_k u^k`, by Taylor's formula.
    pub fn at(&self, shift: &[BigRational], order: usize) -> Vec<BigRational> {
        let mut sum = vec![BigRational::zero(); 4];
        let mut power = vec![BigRational::one()];
        power.resize(4, BigRational::zero());
        for m in order..5 {
            for (n, row) in self.0.iter().enumerate() {
                for k in n..4 {
                    sum[k] += &row[m] * &power[k - n];
                }
            }
            // dt^i/i! for the next i.
            let coefficient = |k: usize| -> BigRational { (0..=k).map(|i| &power[i] * &shift[k - i]).sum() };
            let divisor = BigRational::from_integer((m - order + 1).into());
            power = (0..4).map(|k| coefficient(k) / &divisor).collect();
        }
        sum
    }

    /// Solves `x'(T + dt) = 0` for the shift `0, tau_1, tau_2, tau_3`, order by order.
    pub fn turning_point(&self) -> Vec<BigRational> {
        let mut shift = vec![BigRational::zero(); 4];
        for k in 1..4 {
            let velocity = self.at(&shift, 1);
            shift[k] = -&velocity[k] / &self.0[0][2];
        }
        shift
    }
}

/// The coefficients of `u^1 .. u^4` in (A29), right side minus left side, without the common `g^(4/5)`.
///
/// ```text
/// sum_k y_k u^k - eps^(4/5) sum_k y_k (-u eps^(1/5))^k,    eps = 1 + C_1 u + C_2 u^2 + ...
/// ```
pub fn inverse_collision(y: &[BigRational], c: &[BigRational]) -> Result<Vec<BigRational>, SeriesError> {
    let mut eps = vec![BigRational::one()];
    eps.extend_from_slice(c);
    let eps = FractionalSeries::new(1, eps);
    let mut sum = vec![BigRational::zero(); 5];
    for (k, y) in y.iter().enumerate() {
        let exponent = BigRational::new((4 + k as i64).into(), 5.into());
        let sign = if k % 2 == 1 { -BigRational::one() } else { BigRational::one() };
        sum[k] += y;
        for (i, p) in eps.power(&exponent)?.coefficients().iter().take(5 - k).enumerate() {
            sum[k + i] -= y * &sign * p;
        }
    }
    Ok(sum.split_off(1))
}
