//! Certified values on a grid, by which every method is judged.

use crate::ReportError;
use crate::Watch;
use num_rational::BigRational;
use num_traits::One;
use rayon::prelude::*;
use restitution_direct::{Collision, End};
use restitution_law::ForceLaw;
use restitution_real::Ball;

/// Digits of a certified value, five more than an f64 has.
const DIGITS: usize = 21;

/// The coefficient of restitution at dampings that are exact f64, certified.
pub struct CertifiedValues {
    pub u: Vec<f64>,
    values: [Vec<Ball>; 2],
}

impl CertifiedValues {
    /// Integrates the equation of motion at every `u`, for both ends of contact.
    ///
    /// # Errors
    ///
    /// What the integrator says.
    pub fn new(u: Vec<f64>, watch: &Watch) -> Result<Self, ReportError> {
        let values = |end| {
            let spheres =
                Collision::new(&ForceLaw::viscoelastic_spheres(), end).map_err(ReportError::failure)?;
            let at = |u: &f64| {
                let exact =
                    BigRational::from_float(*u).ok_or_else(|| ReportError::failure("u is not finite"))?;
                let value = spheres.epsilon(&exact, DIGITS).map_err(ReportError::failure)?;
                watch();
                Ok(value)
            };
            u.par_iter().map(at).collect::<Result<Vec<_>, ReportError>>()
        };
        Ok(Self { values: [values(End::ZeroCompression)?, values(End::ZeroForce)?], u })
    }

    /// The certified values for an end of contact.
    pub fn values(&self, end: End) -> &[Ball] {
        &self.values[usize::from(end == End::ZeroForce)]
    }

    /// Returns upper bounds of the relative errors of `values`; infinite where one is no number.
    pub fn errors(&self, values: &[f64], end: End) -> Vec<f64> {
        values.iter().zip(self.values(end)).map(|(value, exact)| relative_error(*value, exact)).collect()
    }
}

fn relative_error(value: f64, exact: &Ball) -> f64 {
    if !value.is_finite() {
        return f64::INFINITY;
    }
    (Ball::from_f64(value, exact.prec()) / exact - Ball::one()).abs_up().to_f64()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_relative_to_the_certified_value() {
        let reference = CertifiedValues::new(vec![1.0], &|| ()).unwrap();
        let [good, bad] =
            [0.331_164_810_466_640_9, 0.331_2].map(|v| reference.errors(&[v], End::ZeroCompression)[0]);
        assert!(good < 2e-16 && (bad - 1.0626e-4).abs() < 1e-8, "{good:e} {bad:e}");
        assert_eq!(reference.errors(&[f64::NAN], End::ZeroForce), [f64::INFINITY]);
        assert!(reference.errors(&[0.393_930_603_229_873_2], End::ZeroForce)[0] < 2e-16);
    }
}
