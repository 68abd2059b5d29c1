//! Every bound that the evaluator states, once: tests assert these, documents are compared with them.

use core::fmt;

/// What a bound rests on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Evidence {
    /// A proof that holds for every argument of the domain.
    Proved,
    /// The largest error over the arguments that the named test looks at.
    Measured,
}

/// What a bound is counted in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Units in the last place of the exact result.
    Ulp,
    /// Relative to the exact result.
    Relative,
}

/// A bound of an error, with what it rests on.
///
/// # Examples
///
/// ```
/// use restitution::bounds;
///
/// assert_eq!(bounds::EPSILON.to_string(), "at most 2 ulp (proved)");
/// assert!(bounds::ALL.iter().all(|bound| bound.observed <= bound.size));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// What is bounded.
    pub quantity: &'static str,
    /// The arguments for which it is.
    pub domain: &'static str,
    /// The bound.
    pub size: f64,
    /// What it is counted in.
    pub unit: Unit,
    /// What it rests on.
    pub evidence: Evidence,
    /// The largest error that was seen.
    pub observed: f64,
    /// Why the bound is not smaller.
    pub reason: &'static str,
    /// The test that keeps it.
    pub test: &'static str,
}

impl fmt::Display for Bound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let evidence = match self.evidence {
            Evidence::Proved => "proved",
            Evidence::Measured => "measured",
        };
        match self.unit {
            Unit::Ulp => write!(f, "at most {} ulp ({evidence})", self.size),
            Unit::Relative => write!(f, "at most {:e} relative ({evidence})", self.size),
        }
    }
}

const FAST_VS_DIRECT: &str = "tests/it/fast_vs_direct.rs";
const PROVED: &str = "tests/it/proved.rs";
const VELOCITY: &str = "tests/it/velocity.rs";

/// Of [`epsilon`](crate::epsilon), but for [`EPSILON_BEYOND`].
pub const EPSILON: Bound = Bound {
    quantity: "`epsilon(u)`",
    domain: "every u at zero compression, u to 1023.99 at zero force; results that are normal",
    size: 2.0,
    unit: Unit::Ulp,
    evidence: Evidence::Proved,
    observed: 1.47,
    reason: "rounded c_0 half a unit, or one where the result lies below a power of two and c_0 above; last addition half a unit",
    test: PROVED,
};

/// Of [`epsilon`](crate::epsilon) at zero force from `u = 1023.99` on.
pub const EPSILON_BEYOND: Bound = Bound {
    quantity: "`epsilon(u)` at zero force, from a velocity, too",
    domain: "u from 1023.99 on; results that are normal",
    size: 2.0,
    unit: Unit::Ulp,
    evidence: Evidence::Measured,
    observed: 1.12,
    reason: "last addition half a unit, the power and its correction the rest",
    test: FAST_VS_DIRECT,
};

/// Of [`one_minus_epsilon`](crate::one_minus_epsilon).
pub const ONE_MINUS_EPSILON: Bound = Bound {
    quantity: "`one_minus_epsilon(u)`",
    domain: "u as for `epsilon`; results that are normal",
    size: 3.0,
    unit: Unit::Ulp,
    evidence: Evidence::Proved,
    observed: 1.81,
    reason: "near u = 0 a product of two rounded factors; near u = 0.07 the polynomial's part is as large as the loss at the centre",
    test: PROVED,
};

/// Of [`Restitution::epsilon`](crate::Restitution::epsilon), for the factor that it carries.
pub const EPSILON_OF_VELOCITY: Bound = Bound {
    quantity: "`Restitution::epsilon(g)`",
    domain: "u as for `epsilon`, f g an f64; results that are normal",
    size: 3.0,
    unit: Unit::Ulp,
    evidence: Evidence::Proved,
    observed: 1.19,
    reason: "that of epsilon, and the rounding of f g, which is one unit of epsilon at most, a third of it at zero force; the last rounding may count one where the result lies below a power of two",
    test: PROVED,
};

/// Of [`fifth_root`](crate::fifth_root).
pub const FIFTH_ROOT: Bound = Bound {
    quantity: "`fifth_root(x)`",
    domain: "every f64",
    size: 0.6,
    unit: Unit::Ulp,
    evidence: Evidence::Proved,
    observed: 0.51,
    reason: "half of the last addition, some roundings of what is added, a 400th of the root",
    test: VELOCITY,
};

/// Of [`u_of_epsilon`](crate::u_of_epsilon), as a change of the coefficient asked for.
pub const INVERSE: Bound = Bound {
    quantity: "exact coefficient at `u_of_epsilon(e)`, against `e`",
    domain: "e at least 1e-290; against 1 - e where e > 1/2",
    size: 1e-15,
    unit: Unit::Relative,
    evidence: Evidence::Measured,
    observed: 7.0e-16,
    reason: "the rounding of u counts up to five times, 5.6e-16, and that of c_0 once: epsilon falls like u^-5",
    test: FAST_VS_DIRECT,
};

/// Of the step that [`epsilon`](crate::epsilon) may take upwards between neighbouring arguments.
pub const STEP_UP: Bound = Bound {
    quantity: "`epsilon` of an argument above that of a smaller one",
    domain: "every pair of arguments",
    size: 1.0,
    unit: Unit::Ulp,
    evidence: Evidence::Measured,
    observed: 1.0,
    reason: "rounding: epsilon falls by less than one ulp between neighbours",
    test: FAST_VS_DIRECT,
};

/// All of them.
pub const ALL: [Bound; 7] =
    [EPSILON, ONE_MINUS_EPSILON, EPSILON_OF_VELOCITY, EPSILON_BEYOND, FIFTH_ROOT, INVERSE, STEP_UP];

#[cfg(all(test, feature = "std"))]
mod tests {
    use super::*;

    #[test]
    fn a_bound_says_what_it_rests_on() {
        assert_eq!(EPSILON.to_string(), "at most 2 ulp (proved)");
        let measured = Bound { size: 1e-15, unit: Unit::Relative, evidence: Evidence::Measured, ..EPSILON };
        assert_eq!(measured.to_string(), "at most 1e-15 relative (measured)");
    }
}
