use crate::{ApproximateError, Expansion, first_bits};
use num_rational::BigRational;
use num_traits::ToPrimitive;
use rayon::prelude::*;
use restitution_direct::End;
use restitution_law::ForceLaw;
use restitution_pade::{
    Approximant, AtInfinity, Interval, PadeError, PadeType, WorstError, approximant, grid, largest_error,
    relative_error, two_point, verdict,
};
use restitution_real::{Ball, Balls, Field};
use rug::Float;

/// The error levels `10^-k` that are asked for.
const LEVELS: [u32; 4] = [3, 6, 9, 12];
/// The largest cost of a candidate with contact at 0 alone.
pub const ONE_POINT_COST: usize = 40;
/// The largest cost of a candidate with both ends.
pub const TWO_POINT_COST: usize = 57;
/// Coefficients of the series that are at hand.
pub const KNOWN: usize = ONE_POINT_COST + 1;
/// Denominators of candidates have at most so many degrees more than numerators, and never fewer.
pub const WIDEST: usize = 12;
/// Intervals of the grids.
const INTERVALS: u32 = 24;
/// Bits of the coefficients: every candidate loses fewer than this leaves.
const BITS: u32 = 640;

/// A range of `u` that starts at 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Span {
    /// Up to 2.
    Two,
    /// Up to 7.5.
    SevenAndAHalf,
    /// Every damping.
    All,
}

impl Span {
    fn end(self) -> BigRational {
        match self {
            Self::Two => BigRational::from_integer(2.into()),
            Self::SevenAndAHalf | Self::All => BigRational::new(15.into(), 2.into()),
        }
    }

    /// As it is written in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Two => "0 to 2",
            Self::SevenAndAHalf => "0 to 7.5",
            Self::All => "all",
        }
    }
}

/// Dampings beyond 7.5 at which candidates for all `u` are tried.
const BEYOND: [i64; 6] = [8, 10, 15, 40, 200, 5000];

/// One end of contact with what the search needs to know about it.
struct Search {
    expansion: Expansion,
    series: Vec<Ball>,
    saturation: Option<Ball>,
    goals: Vec<Goal>,
}

/// An error level to be reached on a range, and what reaches it.
#[derive(Debug)]
pub struct Goal {
    /// The range.
    pub span: Span,
    /// The error level.
    pub level: BigRational,
    points: Vec<BigRational>,
    /// What reaches it; `None` if nothing does.
    pub reached: Option<Reached>,
}

/// The approximant that reaches a goal.
#[derive(Debug)]
pub struct Reached {
    /// Its type and conditions.
    pub candidate: Candidate,
    /// Its largest error.
    pub worst: WorstError,
}

/// A type and the number of conditions met at infinity.
#[derive(Clone, Copy, Debug)]
pub struct Candidate {
    /// Its type.
    pub asked: PadeType,
    /// The conditions that it meets at infinity.
    pub at_infinity: usize,
}

/// Finds the cheapest sound approximants of viscoelastic spheres for error levels and ranges of `u`, by trying them all.
///
/// The cost of an approximant is `L + M`, the multiplications of its evaluation (there is one division besides unless `M = 0`). All
/// candidates of one cost are tried together, cheapest first; among those that reach an error level on a range without a pole and with
/// positive values there, the one with the smallest error is recommended. The error is the largest seen on a grid of certified values,
/// refined around its maximum, and for all `u` the limit at infinity besides: measured, not proved between its points.
/// `after_each_cost` is called for every cost that is done with. Cost: minutes on all processors.
///
/// # Errors
///
/// Those of [`Expansion`].
///
/// # Examples
///
/// ```no_run
/// use restitution_approximate::{ApproximateError, recommended};
/// use restitution_direct::End;
///
/// let goals = recommended(End::ZeroForce, || ())?; // minutes
/// assert!(goals[0].reached.is_some() && goals.iter().any(|goal| goal.reached.is_none()));
/// # Ok::<(), ApproximateError>(())
/// ```
pub fn recommended(end: End, mut after_each_cost: impl FnMut()) -> Result<Vec<Goal>, ApproximateError> {
    let mut search = Search::new(end)?;
    for cost in 0..=search.largest_cost() {
        search.try_cost(cost)?;
        after_each_cost();
    }
    Ok(search.goals)
}

impl Search {
    fn new(end: End) -> Result<Self, ApproximateError> {
        let expansion = Expansion::new(&ForceLaw::viscoelastic_spheres(), end, None)?;
        let two_ended = expansion.end() == End::ZeroCompression;
        let series = expansion.coefficients(KNOWN, BITS)?;
        let saturation = if two_ended { Some(expansion.saturation(BITS as usize * 3 / 10)?) } else { None };
        let spans = [Span::Two, Span::SevenAndAHalf, Span::All];
        let mut goals = Vec::new();
        for span in spans.into_iter().filter(|span| two_ended || *span != Span::All) {
            let mut points = grid(&0.into_rational(), &span.end(), INTERVALS)?;
            if span == Span::All {
                points.extend(BEYOND.map(IntoRational::into_rational));
            }
            for power in LEVELS {
                let level = BigRational::new(1.into(), 10_i64.pow(power).into());
                goals.push(Goal { span, level, points: points.clone(), reached: None });
            }
        }
        Ok(Self { expansion, series, saturation, goals })
    }

    fn largest_cost(&self) -> usize {
        if self.saturation.is_some() { TWO_POINT_COST } else { ONE_POINT_COST }
    }

    /// Tries all candidates of one cost.
    fn try_cost(&mut self, cost: usize) -> Result<(), ApproximateError> {
        let open: Vec<usize> = (0..self.goals.len()).filter(|&i| self.goals[i].reached.is_none()).collect();
        let tried: Vec<_> =
            self.candidates(cost).into_par_iter().map(|c| self.try_candidate(c, &open)).collect();
        for reached in tried {
            for (goal, reached) in reached? {
                let best = &mut self.goals[goal].reached;
                if best.as_ref().is_none_or(|b| reached.worst.error.upper() < b.worst.error.upper()) {
                    *best = Some(reached);
                }
            }
        }
        Ok(())
    }

    fn candidates(&self, cost: usize) -> Vec<Candidate> {
        let types = (0..=cost / 2).map(|numerator| PadeType::new(numerator, cost - numerator));
        let near = types.filter(|t| cost <= ONE_POINT_COST && t.denominator <= t.numerator + WIDEST);
        let mut all: Vec<_> = near.map(|asked| Candidate { asked, at_infinity: 0 }).collect();
        if self.saturation.is_some() && cost >= 5 && cost % 2 == 1 {
            let asked = PadeType::new((cost - 5) / 2, cost.div_ceil(2) + 2);
            let least = asked.conditions().saturating_sub(KNOWN).max(1);
            all.extend((least..=asked.denominator).map(|at_infinity| Candidate { asked, at_infinity }));
        }
        all
    }

    /// The open goals that a candidate reaches. One that the precision leaves open is passed over.
    fn try_candidate(
        &self,
        candidate: Candidate,
        open: &[usize],
    ) -> Result<Vec<(usize, Reached)>, ApproximateError> {
        let entry = match self.approximant(candidate) {
            Ok(entry) => entry,
            Err(PadeError::Undecided { .. }) => return Ok(Vec::new()),
            Err(error) => return Err(error.into()),
        };
        let mut reached = Vec::new();
        for &index in open {
            let goal = &self.goals[index];
            if let Some(worst) = self.reaches(&entry, goal)? {
                reached.push((index, Reached { candidate, worst }));
            }
        }
        Ok(reached)
    }

    fn approximant(&self, candidate: Candidate) -> Result<Approximant<Balls>, PadeError> {
        let Candidate { asked, at_infinity } = candidate;
        let bits = first_bits(asked, 40).min(BITS);
        let field = Balls::new(bits);
        let needed = asked.conditions() - at_infinity;
        let series: Vec<_> = self.series[..needed].iter().map(|c| c.with_prec(bits)).collect();
        match &self.saturation {
            Some(limit) if at_infinity > 0 => {
                let mut conditions = vec![field.zero(); at_infinity];
                conditions[0] = limit.with_prec(bits);
                two_point(&field, &series, asked, &AtInfinity::new(5, conditions))
            }
            _ => approximant(&field, &series, asked),
        }
    }

    /// The largest error on the range of a goal if it reaches the level there and is sound.
    fn reaches(
        &self,
        entry: &Approximant<Balls>,
        goal: &Goal,
    ) -> Result<Option<WorstError>, ApproximateError> {
        let function = entry.function();
        let allowed = Float::with_val(64, goal.level.to_f64().unwrap_or(0.0));
        for u in goal.points.iter().rev() {
            match relative_error(function, &self.expansion.sample(u)?) {
                Ok(error) if error.upper() <= allowed => {}
                _ => return Ok(None),
            }
        }
        let at_infinity = self.error_at_infinity(entry);
        if goal.span == Span::All && at_infinity.as_ref().is_none_or(|error| error.upper() > allowed) {
            return Ok(None);
        }
        let interval = match goal.span {
            Span::All => Interval::HalfLine,
            span => Interval::UpTo(Ball::from_rational(&span.end(), 64)),
        };
        if !verdict(entry, &interval).is_ok_and(|verdict| verdict.is_sound()) {
            return Ok(None);
        }
        let worst = largest_error(function, &goal.points, |u| self.expansion.sample(u))?;
        Ok((worst.error.upper() <= allowed).then_some(worst))
    }

    /// `|p_L/(q_M R^5) - 1|` if the degrees fall off as `eps` does.
    fn error_at_infinity(&self, entry: &Approximant<Balls>) -> Option<Ball> {
        let (num, den) = (entry.num(), entry.den());
        let limit = self.saturation.as_ref().filter(|_| num.len() + 5 == den.len())?;
        Some((num.last()? / den.last()? / limit - Ball::from_integer(1, 64)).abs())
    }
}

trait IntoRational {
    fn into_rational(self) -> BigRational;
}

impl IntoRational for i64 {
    fn into_rational(self) -> BigRational {
        BigRational::from_integer(self.into())
    }
}
