use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive};
use restitution_law::ForceLaw;
use rug::Float;

/// Largest exponent for which the phase plane is expanded in a coordinate analytic at `x = 0`.
const LARGEST_POWER: i64 = 12;

/// The largest degree that is expanded to its end.
const LARGEST_DEGREE: i64 = 32;

/// The coordinate `z` of the phase plane, `x = z^q`.
///
/// ```text
/// v dv/dz = -q (z^(A-1) + u z^(B-1) v),    A = q (a + 1),  B = q (gamma + 1)
/// ```
///
/// Only `B/A = (gamma + 1)/(a + 1)` belongs to the law; `q` is free. In lowest terms `B/A` makes the
/// right side a polynomial: `z = sqrt(x)`, `A = 5`, `B = 3` for spheres. Where these are large the
/// choice is `B = 1` and `z = 0` is a branch point, which is then approached in steps of `ln z` but not
/// crossed.
#[derive(Clone, Debug)]
pub(crate) struct Coordinate {
    pub(crate) q: BigRational,
    pub(crate) elastic: BigRational,
    pub(crate) damping: BigRational,
}

impl Coordinate {
    pub(crate) fn of(law: &ForceLaw) -> Self {
        let ratio = law.damping_step() / law.elastic_step();
        let small = |n: &BigInt| n.to_i64().is_some_and(|n| n <= LARGEST_POWER);
        let damping = if small(ratio.denom()) && small(ratio.numer()) {
            BigRational::from_integer(ratio.numer().clone())
        } else {
            BigRational::one()
        };
        Self { q: &damping / law.damping_step(), elastic: &damping / ratio, damping }
    }

    /// Whether `v(z)` is analytic at `z = 0`, and of low enough degree to be expanded there.
    pub(crate) fn crosses_zero(&self) -> bool {
        self.elastic.is_integer() && self.elastic <= BigRational::from_integer(LARGEST_DEGREE.into())
    }

    /// The coordinate a step of `length` further, in `z` itself or, beside a branch point, in `ln z`.
    pub(crate) fn advance(&self, z: &Float, length: f64) -> Float {
        if self.crosses_zero() {
            return Float::with_val(z.prec(), z + length);
        }
        z * Float::with_val(53, length).exp()
    }

    /// `A - B = q (a - gamma)`: the zero-force curve is `z^(A-B) = -u v`.
    pub(crate) fn force_power(&self) -> BigRational {
        &self.elastic - &self.damping
    }

    /// Whether the zero-force curve leaves from the origin, `a > gamma`.
    pub(crate) fn has_zero_force(&self) -> bool {
        self.force_power().is_positive()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spheres_use_the_square_root() {
        let c = Coordinate::of(&ForceLaw::viscoelastic_spheres());
        assert_eq!(
            (c.q.to_string(), c.elastic.to_string(), c.damping.to_string()),
            ("2".into(), "5".into(), "3".into())
        );
        assert!(c.crosses_zero());
    }

    #[test]
    fn awkward_exponents_keep_the_damping_regular() {
        let c = Coordinate::of(&"1.001,0".parse().unwrap());
        assert_eq!((c.elastic.to_string(), c.damping.to_string()), ("2001/1000".into(), "1".into()));
        assert!(!c.crosses_zero());
    }

    #[test]
    fn the_force_vanishes_on_the_way_out_where_elasticity_grows_faster_than_damping() {
        for (law, known) in
            [("3/2,1/2", true), ("1,0", true), ("1,1", false), ("1,3/2", false), ("3/2,-1/2", true)]
        {
            assert_eq!(Coordinate::of(&law.parse().unwrap()).has_zero_force(), known, "{law}");
        }
    }
}
