use crate::coordinate::Coordinate;
use crate::error::DirectError;
use num_rational::BigRational;
use restitution_law::ForceLaw;
use restitution_real::Ball;
use rug::Float;

/// The equation of motion of one collision, at one working precision.
#[derive(Clone, Debug)]
pub(crate) struct Equation {
    pub(crate) law: ForceLaw,
    pub(crate) coordinate: Coordinate,
    /// The damping `u >= 0`.
    pub(crate) u: Ball,
    /// Working precision in bits.
    pub(crate) prec: u32,
    /// Degree of every Taylor polynomial.
    pub(crate) order: usize,
}

impl Equation {
    pub(crate) fn new(law: &ForceLaw, u: &Ball, prec: u32) -> Self {
        let coordinate = Coordinate::of(law);
        let order = (prec / 9 * 4 + 10) as usize;
        Self { law: law.clone(), coordinate, u: u.with_prec(prec), prec, order }
    }

    /// The same equation at another working precision, with Taylor polynomials of the same degree.
    pub(crate) fn at(&self, prec: u32) -> Self {
        Self { prec, u: self.u.with_prec(prec), ..self.clone() }
    }

    /// An exact rational at working precision.
    pub(crate) fn rational(&self, value: &BigRational) -> Ball {
        Ball::from_rational(value, self.prec)
    }

    /// The error that the bodies do not separate.
    pub(crate) fn overdamped(&self) -> DirectError {
        DirectError::Overdamped { law: Box::new(self.law.clone()), u: shown(&self.u) }
    }

    /// The potential energy `y = z^A/(a + 1)`.
    pub(crate) fn potential(&self, z: &Float) -> Ball {
        let z = Ball::exact(z.clone()).with_prec(self.prec);
        z.pow(&self.coordinate.elastic) / self.rational(&self.law.elastic_step())
    }

    /// The zero-force balance `z^(A-B) - u w` at speed `w`: positive before the zero of the force.
    pub(crate) fn balance(&self, z: &Ball, speed: &Ball) -> Ball {
        z.pow(&self.coordinate.force_power()) - &self.u * speed
    }
}

/// A damping to a few digits, for messages.
pub(crate) fn shown(u: &Ball) -> String {
    u.mid().to_string_radix(10, Some(6))
}
