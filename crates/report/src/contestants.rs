//! The ways to get a coefficient of restitution that the report compares.
//!
//! To add one: a line in [`all`], or in one of the functions it calls.

use crate::ReportError;
use crate::chart::Shape;
use crate::formulas::{self, SLOPE, polynomial, quotient};
use crate::kernel::{Kernel, WithSlices};
use crate::ode::{self, Method};
use num_traits::Zero;
use restitution::tiers::Tier;
use restitution_direct::{End, saturation_speed};
use restitution_law::ForceLaw;
use restitution_pade::{Approximant, AtInfinity, PadeType, approximant, two_point};
use restitution_real::{Ball, Balls};
use restitution_series::{Quantity, coefficients};

/// Digits to which the coefficients behind approximants are proved before they are rounded to f64.
const DIGITS: usize = 80;
/// The field they are computed in, with bits to spare.
const FIELD: Balls = Balls::new(640);

/// What kind of method it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    Series,
    Formula35,
    Pade,
    TwoPoint,
    MuellerPoeschel,
    Approximate,
    Evaluator,
    Tier,
    Integration,
}

impl Family {
    pub const ALL: [Self; 9] = [
        Self::Series,
        Self::Formula35,
        Self::Pade,
        Self::TwoPoint,
        Self::MuellerPoeschel,
        Self::Approximate,
        Self::Evaluator,
        Self::Tier,
        Self::Integration,
    ];

    pub fn name(self) -> &'static str {
        match self {
            Self::Series => "series in u, to order …",
            Self::Formula35 => "formula (35) and counterparts",
            Self::Pade => "Padé in u, or √u (zero force)",
            Self::TwoPoint => "two-point Padé in u",
            Self::MuellerPoeschel => "Müller & Pöschel (zero force)",
            Self::Approximate => "approximate theory (27)",
            Self::Evaluator => "evaluator of this project",
            Self::Tier => "its tiers, to tolerance …",
            Self::Integration => "ODE library, to tolerance …",
        }
    }

    pub fn colour(self) -> usize {
        Self::ALL.iter().position(|family| *family == self).unwrap_or_default()
    }

    pub fn shape(self) -> Shape {
        match self {
            Self::Series | Self::Tier => Shape::Circle,
            Self::Formula35 | Self::Evaluator => Shape::Square,
            Self::Pade | Self::Approximate => Shape::Triangle,
            Self::TwoPoint | Self::Integration => Shape::Diamond,
            Self::MuellerPoeschel => Shape::Cross,
        }
    }
}

/// A way to get a coefficient of restitution.
pub struct Contestant {
    pub family: Family,
    /// In full, unique.
    pub name: String,
    /// In a few characters, to stand beside a point.
    pub mark: String,
    /// The end of contact it is for, by which it is judged.
    pub end: End,
    pub kernel: Box<dyn Kernel>,
}

impl Contestant {
    fn new(family: Family, name: &str, mark: &str, kernel: impl Fn(f64) -> f64 + Sync + 'static) -> Self {
        let (name, mark) = (name.to_owned(), mark.to_owned());
        Self { family, name, mark, end: End::ZeroCompression, kernel: Box::new(kernel) }
    }

    fn at_zero_force(mut self) -> Self {
        self.end = End::ZeroForce;
        self
    }
}

/// Returns all of them, save those that need coefficients beyond `order`.
///
/// The approximants are those that `restitution pade --recommended` finds, and smaller ones.
///
/// # Errors
///
/// What the coefficients and approximants say.
pub fn all(order: usize) -> Result<Vec<Contestant>, ReportError> {
    let exact = Exact::new(order)?;
    let series = [exact.series::<5>(), exact.series::<9>(), exact.series::<17>(), exact.series::<33>()];
    let mut list = series.into_iter().flatten().collect::<Vec<_>>();
    list.extend(formula_35(&exact)?);
    list.extend([exact.pade::<2, 7>()?, exact.pade::<4, 9>()?, exact.pade::<9, 14>()?].into_iter().flatten());
    list.extend([exact.pade::<13, 14>()?, exact.pade::<17, 23>()?].into_iter().flatten());
    list.extend([exact.pade_in_root::<4, 8>()?, exact.pade_in_root::<8, 12>()?].into_iter().flatten());
    list.extend([exact.pade_in_root::<11, 13>()?, exact.pade_in_root::<18, 22>()?].into_iter().flatten());
    list.extend([exact.two_point::<4, 9>(1)?, exact.two_point::<20, 25>(18)?].into_iter().flatten());
    list.extend(others());
    list.extend(tiers());
    list.extend(integrations());
    Ok(list)
}

/// Formula (35), and what it would be with the right coefficients.
fn formula_35(exact: &Exact) -> Result<[Contestant; 3], ReportError> {
    let mut four = exact.series[..5].to_vec();
    four.push(Ball::zero());
    let without = quotient_of::<2, 5>(&approximant(&FIELD, &four, PadeType::new(1, 4))?)?;
    let genuine = quotient_of::<2, 5>(&approximant(&FIELD, &exact.series, PadeType::new(1, 4))?)?;
    let family = Family::Formula35;
    Ok([
        Contestant::new(family, "formula (35) as printed", "printed", |u| formulas::printed_35(SLOPE * u)),
        Contestant::new(family, "formula (35), exact a_3 and a_4, a_5 = 0", "a₅ = 0", without),
        Contestant::new(family, "formula (35), every coefficient exact", "exact", genuine),
    ])
}

fn others() -> [Contestant; 8] {
    use Family::{Approximate, Evaluator, MuellerPoeschel};
    let by_slices = |end| {
        Box::new(WithSlices {
            one: move |u| restitution::epsilon(u, end),
            many: move |u: &[f64], out: &mut [f64]| restitution::epsilon_batch(u, out, end),
        })
    };
    let (inner, outer) = (End::ZeroCompression, End::ZeroForce);
    [
        Contestant::new(
            Approximate,
            "approximate theory, equation (27)",
            "(27)",
            formulas::approximate_theory,
        ),
        Contestant::new(
            MuellerPoeschel,
            "Müller & Pöschel [1/4] as printed",
            "[1/4]",
            formulas::printed_mp_1_4,
        )
        .at_zero_force(),
        Contestant::new(
            MuellerPoeschel,
            "Müller & Pöschel [3/6] as printed",
            "[3/6]",
            formulas::printed_mp_3_6,
        )
        .at_zero_force(),
        Contestant::new(
            MuellerPoeschel,
            "Müller & Pöschel [3/6], a power per term",
            "[3/6] powers",
            formulas::printed_mp_3_6_by_powers,
        )
        .at_zero_force(),
        Contestant {
            kernel: by_slices(inner),
            ..Contestant::new(Evaluator, "evaluator, zero compression", "full", |u| u)
        },
        Contestant {
            kernel: by_slices(outer),
            ..Contestant::new(Evaluator, "evaluator, zero force", "full (force)", |u| u)
        }
        .at_zero_force(),
        Contestant {
            kernel: from_velocities(inner),
            ..Contestant::new(Evaluator, "evaluator from g, zero compression", "g", |u| u)
        },
        Contestant {
            kernel: from_velocities(outer),
            ..Contestant::new(Evaluator, "evaluator from g, zero force", "g (force)", |u| u)
        }
        .at_zero_force(),
    ]
}

/// The evaluator from velocities `g = u^5`. They are made on the way, and their rounding is part of the error.
fn from_velocities(end: restitution::End) -> Box<dyn Kernel> {
    const CHUNK: usize = 256;
    let law = restitution::Restitution::from_u_at_unit_velocity(1.0, end);
    let velocity = |u: f64| u * u * (u * u) * u;
    Box::new(WithSlices {
        one: move |u| law.epsilon(velocity(u)),
        many: move |u: &[f64], out: &mut [f64]| {
            let mut velocities = [0.0; CHUNK];
            for (u, out) in u.chunks(CHUNK).zip(out.chunks_mut(CHUNK)) {
                velocities.iter_mut().zip(u).for_each(|(g, u)| *g = velocity(*u));
                law.epsilon_batch(&velocities[..u.len()], out);
            }
        },
    })
}

/// The cheaper tiers of the evaluator.
fn tiers() -> [Contestant; 6] {
    use restitution::tiers;
    [
        tier(&tiers::ZERO_COMPRESSION_1E3),
        tier(&tiers::ZERO_COMPRESSION_1E6),
        tier(&tiers::ZERO_COMPRESSION_1E9),
        tier(&tiers::ZERO_FORCE_1E3),
        tier(&tiers::ZERO_FORCE_1E6),
        tier(&tiers::ZERO_FORCE_1E9),
    ]
}

fn tier<const ROWS: usize, const WIDTH: usize>(tier: &'static Tier<ROWS, WIDTH>) -> Contestant {
    let forces = tier.end() == End::ZeroForce;
    let (end, place) =
        if forces { (End::ZeroForce, "zero force") } else { (End::ZeroCompression, "zero compression") };
    let kernel = WithSlices {
        one: move |u| tier.epsilon(u),
        many: move |u: &[f64], out: &mut [f64]| tier.epsilon_batch(u, out),
    };
    let tolerance = tier.tolerance();
    Contestant {
        family: Family::Tier,
        name: format!("tier {tolerance:e}, {place}"),
        mark: format!("{tolerance:e}{}", if forces { " (force)" } else { "" }),
        end,
        kernel: Box::new(kernel),
    }
}

fn integrations() -> impl Iterator<Item = Contestant> {
    let asked = [
        (Method::Dopri5, 3),
        (Method::Dopri5, 6),
        (Method::Dopri5, 9),
        (Method::Dop853, 6),
        (Method::Dop853, 9),
        (Method::Dop853, 12),
        (Method::Dop853, 14),
    ];
    asked.into_iter().map(|(method, digits)| {
        let tolerance = 10_f64.powi(-digits);
        let short = if method == Method::Dopri5 { "DP5" } else { "DP8" };
        let name = format!("{method:?} to {tolerance:e}");
        Contestant::new(Family::Integration, &name, &format!("{short} 1e-{digits}"), move |u| {
            ode::epsilon(u, method, tolerance)
        })
    })
}

/// The certified numbers that approximants are made of.
struct Exact {
    series: Vec<Ball>,
    /// The coefficients in powers of `u^(1/2)` for contacts that end at zero force.
    half_powers: Vec<Ball>,
    /// `R^5`, the limit of `eps u^5`.
    limit: Ball,
}

impl Exact {
    fn new(order: usize) -> Result<Self, ReportError> {
        let spheres = ForceLaw::viscoelastic_spheres();
        let series = coefficients(Quantity::Restitution, &spheres, order, DIGITS)?;
        let half_powers = coefficients(Quantity::DelayedRecovery, &spheres, order, DIGITS)?;
        let limit = saturation_speed(&spheres, DIGITS).map_err(ReportError::failure)?;
        Ok(Self { series, half_powers, limit })
    }

    /// The series with `N` coefficients.
    fn series<const N: usize>(&self) -> Option<Contestant> {
        let c: [f64; N] = rounded(self.series.get(..N)?)?;
        let order = N - 1;
        let name = format!("series to order {order}");
        Some(Contestant::new(Family::Series, &name, &order.to_string(), move |u| polynomial(&c, u)))
    }

    /// The approximant with `P` coefficients above and `Q` below.
    fn pade<const P: usize, const Q: usize>(&self) -> Result<Option<Contestant>, ReportError> {
        let asked = PadeType::new(P - 1, Q - 1);
        if self.series.len() < asked.conditions() {
            return Ok(None);
        }
        let kernel = quotient_of::<P, Q>(&approximant(&FIELD, &self.series, asked)?)?;
        Ok(Some(Contestant::new(Family::Pade, &format!("Padé {asked}"), &asked.to_string(), kernel)))
    }

    /// The same in `u^(1/2)` for contacts that end at zero force.
    fn pade_in_root<const P: usize, const Q: usize>(&self) -> Result<Option<Contestant>, ReportError> {
        let asked = PadeType::new(P - 1, Q - 1);
        if self.half_powers.len() < asked.conditions() {
            return Ok(None);
        }
        let kernel = quotient_of::<P, Q>(&approximant(&FIELD, &self.half_powers, asked)?)?;
        let (name, mark) = (format!("Padé {asked} in √u"), format!("{asked}√u"));
        Ok(Some(Contestant::new(Family::Pade, &name, &mark, move |u: f64| kernel(u.sqrt())).at_zero_force()))
    }

    /// The approximant in `u` with the last `conditions` exchanged for conditions at infinity.
    fn two_point<const P: usize, const Q: usize>(
        &self,
        conditions: usize,
    ) -> Result<Option<Contestant>, ReportError> {
        let asked = PadeType::new(P - 1, Q - 1);
        if self.series.len() + conditions < asked.conditions() {
            return Ok(None);
        }
        let mut law = vec![Ball::zero(); conditions];
        law[0] = self.limit.clone();
        let kernel = quotient_of::<P, Q>(&two_point(&FIELD, &self.series, asked, &AtInfinity::new(5, law))?)?;
        let name = format!("two-point Padé {asked}, {conditions} at ∞");
        Ok(Some(Contestant::new(Family::TwoPoint, &name, &format!("{asked}·{conditions}"), kernel)))
    }
}

/// Rounds an approximant to f64, as code that carries its constants does.
fn quotient_of<const P: usize, const Q: usize>(
    entry: &Approximant<Balls>,
) -> Result<impl Fn(f64) -> f64 + Sync + 'static, ReportError> {
    let (num, den) = (rounded::<P>(entry.num()), rounded::<Q>(entry.den()));
    let (Some(num), Some(den)) = (num, den) else {
        return Err(ReportError::failure(format!("the approximant {} is degenerate", entry.asked())));
    };
    Ok(move |u| quotient(&num, &den, u))
}

fn rounded<const N: usize>(values: &[Ball]) -> Option<[f64; N]> {
    values.iter().map(Ball::to_f64).collect::<Vec<_>>().try_into().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_contestant_knows_a_gentle_collision() {
        let list = all(12).unwrap();
        for (i, contestant) in list.iter().enumerate() {
            let mut value = [0.0];
            contestant.kernel.values(&[0.1], &mut value);
            let exact = if contestant.end == End::ZeroForce { 0.892_8 } else { 0.892_15 };
            assert!((value[0] - exact).abs() < 0.02, "{}: {}", contestant.name, value[0]);
            assert_eq!(value[0], contestant.kernel.chain(&[0.3, 0.1]), "{}", contestant.name);
            assert!(list[..i].iter().all(|other| other.name != contestant.name), "{}", contestant.name);
        }
    }
}
