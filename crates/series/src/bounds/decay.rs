//! One proved rate of decay of all coefficients beyond the head.

use num_traits::One;
use restitution_real::{Ball, Magnitude};
use rug::Float;

/// Which sum at the turning point is cut off.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TurningPointSum {
    /// The position `x_n(T)/T^(1+(gamma+1)n)`: terms `q T^e`.
    Position,
    /// The velocity `x_n'(T)/T^((gamma+1)n)`: terms `(e+1) q T^e`.
    Velocity,
}

/// The bound that one pair of weights `(r, v)` gives.
///
/// ```text
/// |q_(n,j)| T^e <= (G/(e (e+1)) + H/(e+1)) r^(-j) v^(-n)    for all e beyond the head
/// ```
///
/// (`docs/error-bounds.md`, theorem 1.)
#[derive(Clone, Debug)]
pub(super) struct Decay {
    ratio: Ball,
    /// `None` where only `n = 0` was bounded.
    damping: Option<Ball>,
    elastic_drive: Ball,
    damping_drive: Ball,
    rough: Rough,
}

/// The same numbers in double precision, to choose between rates; no part of the proof.
#[derive(Clone, Copy, Debug)]
struct Rough {
    log_ratio: f64,
    log_damping: f64,
    elastic_drive: f64,
    damping_drive: f64,
}

const BITS: u32 = 64;

impl Decay {
    /// Takes the weights `r` and `v` (0 where only `n = 0` was bounded) and the constants `G`, `H`.
    pub fn new(ratio: f64, damping: f64, elastic_drive: Magnitude, damping_drive: Magnitude) -> Self {
        let rough = Rough {
            log_ratio: ratio.log2(),
            log_damping: if damping > 0.0 { damping.log2() } else { 0.0 },
            elastic_drive: elastic_drive.to_f64(),
            damping_drive: damping_drive.to_f64(),
        };
        Self {
            ratio: Ball::from_f64(ratio, BITS),
            damping: (damping > 0.0).then(|| Ball::from_f64(damping, BITS)),
            elastic_drive: Ball::exact(elastic_drive.to_float()),
            damping_drive: Ball::exact(damping_drive.to_float()),
            rough,
        }
    }

    /// Whether the rate holds at damping order `n`.
    pub fn covers(&self, n: usize) -> bool {
        n == 0 || self.damping.is_some()
    }

    /// The ratio `r` by which `|q_(n,j)| T^e` falls with `j`.
    pub fn ratio(&self) -> f64 {
        self.ratio.to_f64()
    }

    /// About `log2` of the bound at index `(n, j)` with exponent `e`.
    pub fn rough_log(&self, n: usize, j: usize, exponent: f64) -> f64 {
        let Rough { log_ratio, log_damping, elastic_drive, damping_drive } = self.rough;
        ((elastic_drive / exponent + damping_drive) / (exponent + 1.0)).log2()
            - log_ratio * j as f64
            - log_damping * n as f64
    }

    /// An upper bound of `|q_(n,j)| T^e`.
    pub fn coefficient_up(&self, n: usize, j: usize, exponent: &Ball) -> Float {
        (self.velocity(n, j, exponent) / (exponent + Ball::one())).abs_up()
    }

    /// An upper bound of the sum from `j` on.
    ///
    /// Both `G/(e(e+1)) + H/(e+1)` and `G/e + H` fall with `e`, so the first index bounds them and
    /// the rest is a geometric series.
    pub fn tail_up(&self, sum: TurningPointSum, n: usize, j: usize, exponent: &Ball) -> Float {
        let first = match sum {
            TurningPointSum::Position => self.velocity(n, j, exponent) / (exponent + Ball::one()),
            TurningPointSum::Velocity => self.velocity(n, j, exponent),
        };
        (first * &self.ratio / (&self.ratio - Ball::one())).abs_up()
    }

    /// `(G/e + H) r^(-j) v^(-n)`, which bounds `(e + 1) |q_(n,j)| T^e`.
    fn velocity(&self, n: usize, j: usize, exponent: &Ball) -> Ball {
        let drive = &self.elastic_drive / exponent + &self.damping_drive;
        let power = |x: &Ball, k: usize| x.powi(i64::try_from(k).unwrap_or(i64::MAX));
        let radial = drive / power(&self.ratio, j);
        match &self.damping {
            Some(damping) if n > 0 => radial / power(damping, n),
            _ => radial,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// (5) and (7) of `docs/error-bounds.md` in double precision.
    #[test]
    fn bounds_are_those_of_the_theorem() {
        for (r, v, g, h) in [(4.0f64, 0.25f64, 3.0, 5.0), (1.5, 8.0, 0.1, 0.0), (7.0, 0.0, 2.0, 0.0)] {
            let decay = Decay::new(r, v, Magnitude::exact(g), Magnitude::exact(h));
            assert_eq!(decay.ratio().to_bits(), r.to_bits());
            assert!(decay.covers(0));
            assert_eq!(decay.covers(1), v > 0.0);
            for (n, j) in
                [(0i32, 3i32), (0, 41), (2, 7), (5, 40)].into_iter().filter(|&(n, _)| n == 0 || v > 0.0)
            {
                let e = 2.5 * f64::from(j) + 1.25 * f64::from(n);
                let weight = r.powi(-j) * if n == 0 { 1.0 } else { v.powi(-n) };
                let exponent = Ball::from_f64(e, BITS);
                let (n, j) = (usize::try_from(n).unwrap(), usize::try_from(j).unwrap());
                let coefficient = (g / (e * (e + 1.0)) + h / (e + 1.0)) * weight;
                closely_above(&decay.coefficient_up(n, j, &exponent), coefficient);
                let rest = r / (r - 1.0);
                let tail = |sum| decay.tail_up(sum, n, j, &exponent);
                closely_above(&tail(TurningPointSum::Position), coefficient * rest);
                closely_above(&tail(TurningPointSum::Velocity), (g / e + h) * weight * rest);
                assert!((decay.rough_log(n, j, e) - coefficient.log2()).abs() < 1e-9);
            }
        }
    }

    /// The formula in double precision is off by some ulp; the bound is rounded up to the 32 bits of a radius.
    fn closely_above(bound: &Float, formula: f64) {
        let ratio = bound.to_f64() / formula;
        assert!(ratio > 1.0 - 1e-13 && ratio < 1.0 + 1e-8, "{ratio}");
    }
}
