//! Closed forms as text, LaTeX, and input of mpmath and sympy.

use crate::{ClosedForm, Constant, Family, Term};
use num_rational::{BigRational, Ratio};
use num_traits::{One, Signed};

/// A way to write an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// For reading: `7/25 + 575/1452 B(9/5, 3/2)/B(3/5, 3/2)^3`.
    Text,
    /// Mathematics of LaTeX, without packages.
    Latex,
    /// Python with mpmath.
    Python,
    /// Python with sympy.
    Sympy,
}

impl ClosedForm {
    /// The name of the coefficient: `C_3`.
    pub fn name(&self) -> String {
        format!("{}_{}", self.family.letter(), self.order)
    }

    /// Returns the right side as an expression.
    pub fn expression(&self, language: Language) -> String {
        if self.terms.is_empty() {
            return "0".to_owned();
        }
        let mut text = String::new();
        for (i, term) in self.terms.iter().enumerate() {
            let sign = match (term.coefficient.is_negative(), i) {
                (true, 0) => "-",
                (false, 0) => "",
                (true, _) => " - ",
                (false, _) => " + ",
            };
            if language == Language::Latex && i > 0 && i % 3 == 0 {
                text.push_str(" \\\\\n  && {}");
            }
            text.push_str(sign);
            text.push_str(&self.term(term, language));
        }
        text
    }

    /// A term without its sign.
    fn term(&self, term: &Term, language: Language) -> String {
        let coefficient = term.coefficient.abs();
        let (mut above, mut below) = (Vec::new(), Vec::new());
        if term.base_power != 0 {
            let exponent = self.base.exponent * term.base_power;
            above.push(language.root(self.base.number, exponent));
        }
        for (constant, power) in &term.factors {
            let side = if *power > 0 { &mut above } else { &mut below };
            side.push(language.power(&language.constant(constant), power.unsigned_abs()));
        }
        let times = if matches!(language, Language::Text | Language::Latex) { " " } else { "*" };
        if language == Language::Latex {
            let number = if coefficient.is_one() && !above.is_empty() {
                String::new()
            } else {
                language.number(&coefficient)
            };
            let fraction = match (above.is_empty(), below.is_empty()) {
                (_, true) => above.join(" \\, "),
                (true, false) => format!("\\frac{{1}}{{{}}}", below.join(" ")),
                (false, false) => format!("\\frac{{{}}}{{{}}}", above.join(" "), below.join(" ")),
            };
            return [number, fraction]
                .into_iter()
                .filter(|part| !part.is_empty())
                .collect::<Vec<_>>()
                .join(" \\, ");
        }
        if !coefficient.is_one() || above.is_empty() {
            above.insert(0, language.number(&coefficient));
        }
        let above = above.join(times);
        match below.len() {
            0 => above,
            1 => format!("{above}/{}", below[0]),
            _ => format!("{above}/({})", below.join(times)),
        }
    }
}

impl Family {
    /// The letter of the coefficients.
    pub fn letter(self) -> &'static str {
        match self {
            Self::Restitution => "C",
            Self::Scaled => "a",
            Self::DelayedRecovery => "h",
        }
    }
}

impl Constant {
    /// The name in text, such as `B(9/5, 3/2)` or `M(3/5, 9/5, 3/5)`.
    pub fn name(&self) -> String {
        Language::Text.constant(self)
    }
}

impl Language {
    fn number(self, value: &BigRational) -> String {
        match self {
            Self::Latex if !value.is_integer() => format!("\\frac{{{}}}{{{}}}", value.numer(), value.denom()),
            Self::Python if !value.is_integer() => format!("mpf({})/{}", value.numer(), value.denom()),
            Self::Sympy if !value.is_integer() => format!("Rational({}, {})", value.numer(), value.denom()),
            _ => value.to_string(),
        }
    }

    fn fraction(self, value: Ratio<i64>) -> String {
        match self {
            Self::Text | Self::Latex => value.to_string(),
            Self::Python => format!("mpf({})/{}", value.numer(), value.denom()),
            Self::Sympy => format!("Rational({}, {})", value.numer(), value.denom()),
        }
    }

    fn root(self, number: Ratio<i64>, exponent: Ratio<i64>) -> String {
        match self {
            Self::Latex => format!(
                "\\left({}\\right)^{{{exponent}}}",
                self.number(&BigRational::new((*number.numer()).into(), (*number.denom()).into()))
            ),
            Self::Text => format!("({number})^({exponent})"),
            Self::Python | Self::Sympy => {
                format!("({})**({})", self.fraction(number), self.fraction(exponent))
            }
        }
    }

    fn power(self, factor: &str, power: u32) -> String {
        match (self, power) {
            (_, 1) => factor.to_owned(),
            (Self::Latex, _) => format!("{factor}^{{{power}}}"),
            (Self::Text, _) => format!("{factor}^{power}"),
            _ => format!("{factor}**{power}"),
        }
    }

    fn constant(self, constant: &Constant) -> String {
        let list =
            |join: &str| constant.exponents.iter().map(|&p| self.fraction(p)).collect::<Vec<_>>().join(join);
        let single = constant.exponents.len() == 1;
        match self {
            Self::Text if single => format!("B({}, 3/2)", list("")),
            Self::Latex if single => format!("\\mathrm{{B}}({}, \\frac32)", list("")),
            Self::Latex => format!("M({})", list(", ")),
            Self::Python if single => format!("beta({}, mpf(3)/2)", list("")),
            Self::Sympy if single => format!("beta({}, Rational(3, 2))", list("")),
            Self::Sympy => constant.symbol(),
            _ => format!("M({})", list(", ")),
        }
    }
}

impl Constant {
    /// A name that is an identifier: `M_3_5__9_5__3_5`.
    pub fn symbol(&self) -> String {
        let parts = self.exponents.iter().map(|p| format!("{}_{}", p.numer(), p.denom()));
        format!("M_{}", parts.collect::<Vec<_>>().join("__"))
    }
}
