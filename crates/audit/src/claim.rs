//! One statement of a paper and what is found about it.

use crate::AuditError;
use crate::formula::{Constants, Formula, Scope};
use crate::printed_number::{Agreement, Known, SHOWN_DIGITS, digits};
use crate::samples::Samples;
use crate::true_values::TrueValues;
use num_rational::BigRational;
use num_traits::Zero;
use restitution_real::{Ball, Balls, Rationals};
use std::fmt;

/// A checkable statement.
#[derive(Clone, Debug)]
pub struct Claim {
    /// The equation number and, where it says several things, a word after a point.
    pub id: &'static str,
    /// What the statement is about.
    pub statement: &'static str,
    /// The number or formula as printed.
    pub printed: String,
    /// A command whose output shows the computed side.
    pub command: &'static str,
    pub(crate) check: fn(&str, &TrueValues) -> Result<Finding, AuditError>,
}

impl Claim {
    pub(crate) fn new(
        id: &'static str,
        statement: &'static str,
        printed: &str,
        command: &'static str,
        check: fn(&str, &TrueValues) -> Result<Finding, AuditError>,
    ) -> Self {
        Self { id, statement, printed: printed.to_owned(), command, check }
    }

    /// Compares what is printed with what is known.
    ///
    /// # Errors
    ///
    /// What the computation says; a comparison that the precision does not decide.
    pub fn judge(&self, truth: &TrueValues) -> Result<Finding, AuditError> {
        (self.check)(&self.printed, truth)
            .map_err(|error| AuditError::failure(format!("claim {}: {error}", self.id)))
    }
}

/// What comparing a statement with the truth gives.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It is true as it stands.
    Holds,
    /// The number is right to its last printed digit.
    HoldsToItsDigits,
    /// The number is right, its digits are cut off instead of rounded.
    HoldsCutOff,
    /// It is true in a sense that it does not state.
    Imprecise,
    /// It is not true; the slip that gives exactly what is printed, if one is known.
    Wrong(Option<String>),
}

impl Verdict {
    /// The word under which it is counted.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Holds | Self::HoldsToItsDigits | Self::HoldsCutOff => "holds",
            Self::Imprecise => "imprecise",
            Self::Wrong(_) => "wrong",
        }
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::HoldsToItsDigits => f.write_str("holds to its printed digits"),
            Self::HoldsCutOff => f.write_str("holds to its printed digits, cut off"),
            verdict => f.write_str(verdict.word()),
        }
    }
}

/// The verdict on a claim with what it rests on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// The right number, or what was checked.
    pub computed: String,
    /// The verdict.
    pub verdict: Verdict,
    /// The workings, and what else there is to say.
    pub notes: Vec<String>,
}

impl Finding {
    pub(crate) fn new(computed: impl ToString, verdict: Verdict) -> Self {
        Self { computed: computed.to_string(), verdict, notes: Vec::new() }
    }

    pub(crate) fn noting(mut self, note: impl ToString) -> Self {
        self.notes.push(note.to_string());
        self
    }

    /// Lowers `Holds` to `Imprecise`: what is said is true, but not all that should be.
    pub(crate) fn imprecise(mut self) -> Self {
        if self.verdict == Verdict::Holds {
            self.verdict = Verdict::Imprecise;
        }
        self
    }
}

/// A mistake that might have led to a printed number, and the number it leads to.
pub struct Slip {
    /// What went wrong.
    pub mistake: &'static str,
    /// What comes out.
    pub gives: Known,
}

/// Judges a printed number; the slip counts if it gives the printed digits.
pub fn number(printed: &str, known: &Known, slip: Option<Slip>) -> Result<Finding, AuditError> {
    let verdict = match Agreement::of(printed, known)? {
        Agreement::Equal => Verdict::Holds,
        Agreement::Rounded => Verdict::HoldsToItsDigits,
        Agreement::CutOff => Verdict::HoldsCutOff,
        Agreement::None => {
            let reproduces =
                |slip: &Slip| Ok::<_, AuditError>(Agreement::of(printed, &slip.gives)? != Agreement::None);
            let slip = match slip {
                Some(slip) if reproduces(&slip)? => {
                    Some(format!("{} gives {}", slip.mistake, slip.gives.shown()?))
                }
                _ => None,
            };
            Verdict::Wrong(slip)
        }
    };
    Ok(Finding::new(known.shown()?, verdict))
}

/// Judges a printed number against a ball.
pub fn enclosed(printed: &str, ball: &Ball) -> Result<Finding, AuditError> {
    number(printed, &Known::Within(ball.clone()), None)
}

/// A field in which equations can be tested.
pub trait Testable: Constants {
    /// Whether a residual is zero as far as it can be told, given the size of what was subtracted.
    fn vanishes(&self, residual: &Self::Number, size: &Self::Number) -> bool;
}

impl Testable for Rationals {
    fn vanishes(&self, residual: &BigRational, _: &BigRational) -> bool {
        residual.is_zero()
    }
}

impl Testable for Balls {
    /// Zero lies in the ball, and nothing beyond a 10^-35th of the size does.
    fn vanishes(&self, residual: &Ball, size: &Ball) -> bool {
        let limit = size.abs_up() * rug::Float::with_val(32, 1e-35);
        residual.contains_zero() && residual.abs_up() <= limit
    }
}

/// Whether every equation is true in the scope.
fn hold<F: Testable>(equations: &[(Formula, Formula)], scope: &Scope<F>) -> Result<bool, AuditError> {
    let mut hold = true;
    for (left, right) in equations {
        let (left, right) = (left.value(scope)?, right.value(scope)?);
        hold &= scope.field().vanishes(&scope.field().sub(&left, &right), &left);
    }
    Ok(hold)
}

/// How often an identity is tested.
const POINTS: usize = 20;

/// Judges equations, separated by semicolons, that must be true wherever `point` puts them.
pub fn identity<F: Testable>(
    printed: &str,
    what: &str,
    point: impl Fn(&mut Samples) -> Result<Scope<F>, AuditError>,
) -> Result<Finding, AuditError> {
    let equations = printed.split(';').map(sides).collect::<Result<Vec<_>, _>>()?;
    let mut samples = Samples::new();
    let mut held = 0;
    for _ in 0..POINTS {
        held += usize::from(hold(&equations, &point(&mut samples)?)?);
    }
    let verdict = if held == POINTS { Verdict::Holds } else { Verdict::Wrong(None) };
    Ok(Finding::new(format!("true at {held} of {POINTS} {what}"), verdict))
}

/// Judges an equation between definite numbers: the left side is what is computed.
pub fn equality(printed: &str, scope: &Scope<Balls>) -> Result<Finding, AuditError> {
    let (left, right) = sides(printed)?;
    let (left, right) = (left.value(scope)?, right.value(scope)?);
    let holds = scope.field().vanishes(&(&left - right), &left);
    let verdict = if holds { Verdict::Holds } else { Verdict::Wrong(None) };
    Ok(Finding::new(digits(&left, SHOWN_DIGITS)?, verdict))
}

/// Reads both sides of an equation.
pub fn sides(equation: &str) -> Result<(Formula, Formula), AuditError> {
    let sides = equation.split_once('=');
    let (left, right) =
        sides.ok_or_else(|| AuditError::failure(format!("'{equation}' is not an equation")))?;
    Ok((Formula::read(left)?, Formula::read(right)?))
}

/// Reads what is behind the sign of equality.
pub fn right_side(equation: &str) -> Result<Formula, AuditError> {
    Ok(sides(equation)?.1)
}
