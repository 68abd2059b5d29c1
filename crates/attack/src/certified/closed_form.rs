//! Laws with `gamma = (a - 1)/2`, whose coefficient does not depend on velocity: closed forms at both ends, under-,
//! over- and critically damped, in plain high precision.

use super::integration::{confirmed, integrated};
use super::laws::{self, Request};
use super::refused;
use crate::Tally;
use crate::random::Source;
use num_rational::BigRational;
use num_traits::{One, Signed};
use rand::RngExt;
use restitution_direct::{Collision, DirectError, End};
use restitution_law::ForceLaw;
use restitution_real::Ball;
use rug::Float;
use rug::float::Constant;

/// Bits beyond those of the digits; `u` may be as small as 1e-30, or as near to critical damping.
const GUARD: u32 = 300;

/// The square of `zeta = (u/2) sqrt(2/(a+1))`.
fn zeta_squared(law: &ForceLaw, u: &BigRational) -> BigRational {
    u * u / (BigRational::from_integer(2.into()) * law.elastic_step())
}

/// `epsilon` to about `prec` bits, not proved; `None` where the bodies do not separate.
///
/// With `q = x^((a+1)/2)` the equation is that of a linear spring and dashpot, and zero force its zero force.
fn epsilon(law: &ForceLaw, u: &BigRational, end: End, prec: u32) -> Option<Ball> {
    let square = zeta_squared(law, u);
    let rest = BigRational::one() - &square;
    let float = |x: &BigRational| Float::with_val(prec, restitution_real::convert::rug_rational(x));
    let zeta = float(&square).sqrt();
    let root = float(&rest.abs()).sqrt();
    let exponent: Float = match end {
        End::ZeroCompression if !rest.is_positive() => return None,
        End::ZeroCompression => Float::with_val(prec, Constant::Pi) * &zeta / &root,
        End::ZeroForce if rest.is_positive() => {
            // 2 asin(zeta), the angle whose tangent is 2 zeta root/(1 - 2 zeta^2)
            let angle = Float::with_val(prec, &zeta).atan2(&root) * 2u32;
            (Float::with_val(prec, Constant::Pi) - angle) * &zeta / &root
        }
        End::ZeroForce if rest.is_negative() => {
            Float::with_val(prec, &zeta + &root).ln() * 2u32 * &zeta / &root
        }
        End::ZeroForce => Float::with_val(prec, 2),
    };
    // An error of the exponent relative to it is one of the value in proportion to the exponent.
    let error = exponent.clone() >> (prec - 8);
    let value = (-exponent).exp();
    let radius = Float::with_val(32, &value * error);
    Some(Ball::exact(value).widened(&radius))
}

pub fn attack(random: &mut Source, tally: &mut Tally) {
    let (n, d) = (random.random_range(1..40), random.random_range(1..9));
    let a = if random.random_bool(0.3) { laws::ratio(3, 2) } else { laws::ratio(n, d) };
    let gamma = (&a - BigRational::one()) / laws::ratio(2, 1);
    let Ok(law) = ForceLaw::new(a, gamma) else { return };
    let end = if random.random_bool(0.5) { End::ZeroForce } else { End::ZeroCompression };
    // Often on either side of critical damping, u^2 = 2 (a + 1).
    let u = if random.random_bool(0.2) { near_critical(&law, random) } else { laws::damping(random) };
    let request = Request { u, end, digits: laws::digits(random), law };
    let prec = GUARD + 4 * request.digits as u32;
    match epsilon(&request.law, &request.u, end, prec) {
        Some(exact) => {
            if let Some(found) = integrated(&request, request.digits, tally) {
                tally.count("numbers confirmed by a closed form", 1);
                confirmed(&|| request.to_string(), &found, &exact, request.digits, tally);
            } else if exact.to_f64() > 1e-300 && !tally.counts.keys().any(|what| what.starts_with("refused"))
            {
                tally.fault("bodies that separate are said to", format!("{request}: {exact:?}"));
            }
        }
        None => match Collision::new(&request.law, end).and_then(|c| c.epsilon(&request.u, request.digits)) {
            Err(DirectError::Overdamped { .. }) => tally.count("bodies that do not separate", 1),
            Err(error) => refused(&request.to_string(), &error.to_string(), tally),
            Ok(value) => {
                tally.fault("bodies that do not separate are said not to", format!("{request}: {value:?}"))
            }
        },
    }
}

fn near_critical(law: &ForceLaw, random: &mut Source) -> BigRational {
    let square = BigRational::from_integer(2.into()) * law.elastic_step();
    let float = Float::with_val(60, restitution_real::convert::rug_rational(&square)).sqrt().to_f64();
    let off = 10f64.powi(-random.random_range(1..8)) * (2.0 * random.random::<f64>() - 1.0);
    let digits = (float * (1.0 + off) * 1e9).round() as i64;
    laws::ratio(digits, 1_000_000_000)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_values() {
        let value = |law: &str, n, d, end| {
            epsilon(&law.parse().unwrap(), &laws::ratio(n, d), end, 200).map(|e| e.to_f64())
        };
        let close = |x: Option<f64>, y: f64| (x.unwrap() / y - 1.0).abs() < 1e-14;
        assert!(close(value("1,0", 1, 2, End::ZeroCompression), 0.444_344_225_088_488_8));
        assert!(close(value("1,0", 320_695, 100_000, End::ZeroForce), 0.068_168_296_331_364_63));
        assert!(close(value("1,0", 2, 1, End::ZeroForce), (-2.0_f64).exp()));
        assert!(value("1,0", 2, 1, End::ZeroCompression).is_none());
    }
}
