//! What the claims are compared with, computed once.

use crate::AuditError;
use crate::formula::{Formula, Scope};
use num_rational::BigRational;
use num_traits::{One, Zero};
use restitution_direct::{Collision, End};
use restitution_law::ForceLaw;
use restitution_pade::{PadeType, RationalFunction, approximant, table_one};
use restitution_real::{Ball, Balls};
use restitution_series::{Quantity, TailBound, Trajectories, TurningPointSum, coefficients, turning_time};

/// Digits of the coefficients behind every claim.
const DIGITS: usize = 45;
/// Bits of the numbers computed from them.
const BITS: u32 = 200;
/// The field of the numbers here.
pub const FIELD: Balls = Balls::new(BITS);
/// The highest order of the expansion that a claim needs.
const ORDER: usize = 9;

/// Certified and exact numbers of the collision of spheres.
pub struct TrueValues {
    /// `C_0 .. C_9`.
    pub c: Vec<Ball>,
    /// `a_0 .. a_9`.
    pub a: Vec<Ball>,
    /// `y_0 .. y_4`.
    pub y: Vec<Ball>,
    /// `h_0 .. h_9` of the end of contact at zero force.
    pub h: Vec<Ball>,
    /// `x_0 .. x_3` exactly.
    pub trajectories: Trajectories,
    /// The motion at the undamped turning point.
    pub turning: AtTurningPoint,
    /// The numbers that follow when the corrections in (A26) and (A27) count half.
    pub halved: Halved,
    /// The collision, integrated directly.
    pub collision: Collision,
}

/// The trajectories and their derivatives at `T`, each with a proved bound of what the sums leave out.
pub struct AtTurningPoint {
    /// `T`.
    pub time: Ball,
    /// `x_n(T)`, `n = 0 .. 3`.
    pub position: Vec<Ball>,
    /// `x_n'(T)`; the first contains zero.
    pub velocity: Vec<Ball>,
}

/// The slip behind the printed `y_2` and `y_3`, carried through the appendix and Table I.
pub struct Halved {
    /// `y_2`.
    pub y2: Ball,
    /// `y_3`.
    pub y3: Ball,
    /// `C_0 .. C_4` by (A32).
    pub c: Vec<Ball>,
    /// `a_0 .. a_4` by (A33) to (A36).
    pub a: Vec<Ball>,
    /// Table I from these.
    pub table: RationalFunction<Balls>,
}

/// The printed formulas of `y_2` and `y_3` (A26), (A27), derivatives taken at `T`.
pub const Y2: &str = "x2 - 1/2 x1'^2/x0''";
/// See [`Y2`].
pub const Y3: &str = "x3 - x1' x2'/x0'' + 1/2 x1'^2 x1''/x0''^2 - 1/6 x1'^3 x0'''/x0''^3";
/// The printed formulas of `C_1 .. C_4` (A32).
pub const C: [&str; 4] = [
    "5/2 y1/y0",
    "15/4 (y1/y0)^2",
    "95/16 (y1/y0)^3 - 15/4 y2 y1/y0^2 + 5/2 y3/y0",
    "315/32 (y1/y0)^4 - 105/8 y2 y1^2/y0^3 + 35/4 y3 y1/y0^2",
];

impl TrueValues {
    /// Computes everything.
    ///
    /// # Errors
    ///
    /// What the engines say.
    pub fn new() -> Result<Self, AuditError> {
        let law = ForceLaw::viscoelastic_spheres();
        let table = |quantity, order| coefficients(quantity, &law, order, DIGITS);
        let (c, a) = (table(Quantity::Restitution, ORDER)?, table(Quantity::ScaledRestitution, ORDER)?);
        let bounds = TailBound::find(&law, 3).map_err(AuditError::failure)?;
        let terms = bounds.terms_for(BITS);
        let trajectories = Trajectories::exact(&law, 3, terms);
        let turning = AtTurningPoint::new(&trajectories, &bounds)?;
        Ok(Self {
            halved: Halved::new(&turning)?,
            y: table(Quantity::Compression, 4)?,
            h: table(Quantity::DelayedRecovery, ORDER)?,
            collision: Collision::new(&law, End::ZeroCompression).map_err(AuditError::failure)?,
            c,
            a,
            trajectories,
            turning,
        })
    }

    /// A scope for formulas between balls.
    pub fn scope(&self) -> Scope<Balls> {
        Scope::new(FIELD)
    }

    /// `eps = 1 - s + a_2 s^2 - ...`, the coefficients with their signs.
    pub fn in_s(&self) -> Vec<Ball> {
        let signed = |(k, a): (usize, &Ball)| if k % 2 == 1 { -a } else { a.clone() };
        let mut series: Vec<Ball> = self.a.iter().enumerate().map(signed).collect();
        series[0] = Ball::one();
        series
    }

    /// The genuine `[1/4]` approximant in `s`.
    ///
    /// # Errors
    ///
    /// What the Padé algorithm says.
    pub fn genuine(&self) -> Result<RationalFunction<Balls>, AuditError> {
        let found = approximant(&FIELD, &self.in_s(), PadeType::new(1, 4)).map_err(AuditError::failure)?;
        Ok(found.function().clone())
    }

    /// Table I from the right `a_3` and `a_4`.
    ///
    /// # Errors
    ///
    /// As [`table_one`].
    pub fn table_with_right_coefficients(&self) -> Result<RationalFunction<Balls>, AuditError> {
        table_one(&FIELD, &three_fifths(), &self.a[3], &self.a[4]).map_err(AuditError::failure)
    }
}

impl AtTurningPoint {
    fn new(trajectories: &Trajectories, bounds: &TailBound) -> Result<Self, AuditError> {
        let time = turning_time(trajectories.law(), BITS);
        let mut out = Self { time: time.clone(), position: Vec::new(), velocity: Vec::new() };
        for n in 0..=trajectories.damping_order() {
            let (mut position, mut velocity) = (ball(0), ball(0));
            for (j, q) in trajectories.coefficients(n)?.iter().enumerate() {
                let exponent = trajectories.exponent(n, j);
                let exponent = BigRational::new((*exponent.numer()).into(), (*exponent.denom()).into());
                let term = Ball::from_rational(q, BITS) * time.pow(&(&exponent - BigRational::one()));
                velocity += &term * Ball::from_rational(&exponent, BITS);
                position += term * &time;
            }
            let terms = trajectories.terms();
            let left_out = |sum| Ball::exact(bounds.tail_at_turning_point(sum, n, terms));
            // The tails are those of sums scaled by T^(3n/2), and by T once more for the position.
            let scale = time.pow(&BigRational::new((3 * n).into(), 2.into()));
            position.widen(&(left_out(TurningPointSum::Position) * &scale * &time).abs_up());
            velocity.widen(&(left_out(TurningPointSum::Velocity) * &scale).abs_up());
            out.position.push(position);
            out.velocity.push(velocity);
        }
        Ok(out)
    }

    /// The names that (A26) and (A27) use.
    ///
    /// Second derivatives are those of the equation of motion: with `x_0'(T) = 0`,
    ///
    /// ```text
    /// x_0'' = -x_0^(3/2),    x_1'' = -(3/2) sqrt(x_0) x_1,    x_0''' = 0
    /// ```
    pub fn scope(&self) -> Scope<Balls> {
        let (x, v) = (&self.position, &self.velocity);
        let root = x[0].sqrt();
        Scope::new(FIELD)
            .with_all(&["x0", "x1", "x2", "x3"], x.iter().cloned())
            .with_all(&["x1'", "x2'", "x3'"], v[1..].iter().cloned())
            .with("x0''", -(&root * &x[0]))
            .with("x1''", -(root * &x[1] * Ball::from_ratio(3, 2, BITS)))
            .with("x0'''", Ball::zero())
    }
}

impl Halved {
    fn new(turning: &AtTurningPoint) -> Result<Self, AuditError> {
        let half = |formula: &str, x: &Ball| {
            let right = Formula::read(formula)?.value(&turning.scope())?;
            Ok::<_, AuditError>(x + (right - x).shifted(-1))
        };
        let x = &turning.position;
        let (y2, y3) = (half(Y2, &x[2])?, half(Y3, &x[3])?);
        let y = [&x[0], &x[1], &y2, &y3].map(Ball::clone);
        let scope = Scope::new(FIELD).with_all(&["y0", "y1", "y2", "y3"], y);
        let mut c = vec![one()];
        for formula in C {
            c.push(Formula::read(formula)?.value(&scope)?);
        }
        let a: Vec<Ball> = (0..).zip(&c).map(|(k, value)| value / c[1].powi(k)).collect();
        let table = table_one(&FIELD, &three_fifths(), &a[3], &a[4]).map_err(AuditError::failure)?;
        Ok(Self { y2, y3, c, a, table })
    }
}

/// 1 at the working precision.
pub fn one() -> Ball {
    ball(1)
}

/// A whole number at the working precision.
pub fn ball(n: i64) -> Ball {
    Ball::from_integer(n, BITS)
}

/// A fraction at the working precision.
pub fn fraction(value: &BigRational) -> Ball {
    Ball::from_rational(value, BITS)
}

fn three_fifths() -> Ball {
    Ball::from_ratio(3, 5, BITS)
}
