//! Formulas as they are printed: read from text, evaluated exactly or in balls.

use crate::AuditError;
use num_rational::BigRational;
use restitution_real::{Ball, Balls, Field, Rationals, ZeroTest};
use std::iter::Peekable;
use std::vec::IntoIter;

/// A formula: sums, products (written side by side), quotients and rational powers of numbers and names.
///
/// ```text
/// 15/4 (y1/y0)^2,    x2 - 1/2 x1'^2/x0'',    sqrt(pi) Gamma(3/5)/(5 Gamma(21/10))
/// ```
///
/// Products and quotients are taken from left to right, so that `1/2 a/b` is `((1/2) a)/b`.
#[derive(Clone, Debug, PartialEq)]
pub enum Formula {
    Number(BigRational),
    Name(String),
    Root(Box<Formula>),
    Negative(Box<Formula>),
    Sum(Box<Formula>, Box<Formula>),
    Product(Box<Formula>, Box<Formula>),
    Quotient(Box<Formula>, Box<Formula>),
    Power(Box<Formula>, Box<Formula>),
}

/// What the names of a formula stand for.
#[derive(Clone, Debug)]
pub struct Scope<F: Field> {
    field: F,
    values: Vec<(&'static str, F::Number)>,
    exponents: Vec<(&'static str, BigRational)>,
}

/// A field that knows constants by their names.
pub trait Constants: Field {
    /// Returns `pi` or `Gamma(p/q)`, if the field has them.
    fn constant(&self, name: &str) -> Option<Self::Number>;
}

impl Constants for Rationals {
    fn constant(&self, _: &str) -> Option<BigRational> {
        None
    }
}

impl Constants for Balls {
    fn constant(&self, name: &str) -> Option<Ball> {
        if name == "pi" {
            return Some(Ball::pi(self.prec()));
        }
        let argument = name.strip_prefix("Gamma(")?.strip_suffix(')')?;
        let argument = Formula::read(argument).ok()?.exponent(&[]).ok()?;
        Some(self.rational(&argument).gamma())
    }
}

impl<F: Field> Scope<F> {
    /// Returns a scope without names.
    pub fn new(field: F) -> Self {
        Self { field, values: Vec::new(), exponents: Vec::new() }
    }

    /// The field of the numbers.
    pub fn field(&self) -> &F {
        &self.field
    }

    /// Adds a name.
    #[must_use]
    pub fn with(mut self, name: &'static str, value: F::Number) -> Self {
        self.values.push((name, value));
        self
    }

    /// Adds names of numbers.
    #[must_use]
    pub fn with_all(mut self, names: &[&'static str], values: impl IntoIterator<Item = F::Number>) -> Self {
        self.values.extend(names.iter().copied().zip(values));
        self
    }

    /// Adds a rational number that may stand in exponents too.
    #[must_use]
    pub fn with_exponent(mut self, name: &'static str, value: &BigRational) -> Self {
        self.exponents.push((name, value.clone()));
        let value = self.field.rational(value);
        self.with(name, value)
    }
}

impl Formula {
    /// Reads a formula.
    pub fn read(text: &str) -> Result<Self, AuditError> {
        let mut reader = Reader { text, tokens: tokens(text)?.into_iter().peekable() };
        let formula = reader.sum()?;
        if reader.tokens.peek().is_some() { Err(unreadable(text)) } else { Ok(formula) }
    }

    /// Returns the value in a scope.
    pub fn value<F: Constants>(&self, scope: &Scope<F>) -> Result<F::Number, AuditError> {
        let field = &scope.field;
        Ok(match self {
            Self::Number(number) => field.rational(number),
            Self::Name(name) => {
                let known = scope.values.iter().find(|(known, _)| known == name).map(|(_, value)| value);
                let value = known.cloned().or_else(|| field.constant(name));
                value.ok_or_else(|| AuditError::failure(format!("the name {name} stands for nothing")))?
            }
            Self::Root(x) => power(field, &x.value(scope)?, &BigRational::new(1.into(), 2.into()))?,
            Self::Negative(x) => field.neg(&x.value(scope)?),
            Self::Sum(x, y) => field.add(&x.value(scope)?, &y.value(scope)?),
            Self::Product(x, y) => field.mul(&x.value(scope)?, &y.value(scope)?),
            Self::Quotient(x, y) => {
                let divisor = y.value(scope)?;
                if field.zero_test(&divisor) == ZeroTest::Zero {
                    return Err(AuditError::failure("a formula divides by zero"));
                }
                field.div(&x.value(scope)?, &divisor)
            }
            Self::Power(x, e) => power(field, &x.value(scope)?, &e.exponent(&scope.exponents)?)?,
        })
    }

    /// Returns the value as the exact number that an exponent must be.
    fn exponent(&self, names: &[(&'static str, BigRational)]) -> Result<BigRational, AuditError> {
        self.value(&Scope { field: Rationals, values: names.to_vec(), exponents: Vec::new() })
    }
}

fn power<F: Field>(field: &F, base: &F::Number, exponent: &BigRational) -> Result<F::Number, AuditError> {
    let none = || AuditError::failure(format!("{base:?} has no power {exponent} here"));
    field.power(base, exponent).ok_or_else(none)
}

fn unreadable(text: &str) -> AuditError {
    AuditError::failure(format!("'{text}' is not a formula"))
}

#[derive(Clone, Debug, PartialEq)]
enum Token {
    Number(BigRational),
    Name(String),
    Sign(char),
}

fn tokens(text: &str) -> Result<Vec<Token>, AuditError> {
    let mut rest = text.trim_start();
    let mut tokens = Vec::new();
    while let Some(first) = rest.chars().next() {
        let length = match first {
            '0'..='9' => rest.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(rest.len()),
            _ if rest.starts_with("Gamma(") => rest.find(')').ok_or_else(|| unreadable(text))? + 1,
            'a'..='z' | 'A'..='Z' => {
                rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '\'' && c != '_').unwrap_or(rest.len())
            }
            '+' | '-' | '*' | '/' | '^' | '(' | ')' => 1,
            _ => return Err(unreadable(text)),
        };
        let (token, behind) = rest.split_at(length);
        tokens.push(match first {
            '0'..='9' => Token::Number(crate::printed_number::exact(token).ok_or_else(|| unreadable(text))?),
            'a'..='z' | 'A'..='Z' => Token::Name(token.to_owned()),
            sign => Token::Sign(sign),
        });
        rest = behind.trim_start();
    }
    Ok(tokens)
}

struct Reader<'a> {
    text: &'a str,
    tokens: Peekable<IntoIter<Token>>,
}

impl Reader<'_> {
    fn took(&mut self, sign: char) -> bool {
        self.tokens.next_if_eq(&Token::Sign(sign)).is_some()
    }

    fn sum(&mut self) -> Result<Formula, AuditError> {
        let negative = self.took('-');
        let first = self.product()?;
        let mut sum = if negative { Formula::Negative(first.into()) } else { first };
        loop {
            if self.took('+') {
                sum = Formula::Sum(sum.into(), self.product()?.into());
            } else if self.took('-') {
                sum = Formula::Sum(sum.into(), Formula::Negative(self.product()?.into()).into());
            } else {
                return Ok(sum);
            }
        }
    }

    fn product(&mut self) -> Result<Formula, AuditError> {
        let mut product = self.power()?;
        loop {
            let beside =
                matches!(self.tokens.peek(), Some(Token::Number(_) | Token::Name(_) | Token::Sign('(')));
            if self.took('*') || beside {
                product = Formula::Product(product.into(), self.power()?.into());
            } else if self.took('/') {
                product = Formula::Quotient(product.into(), self.power()?.into());
            } else {
                return Ok(product);
            }
        }
    }

    fn power(&mut self) -> Result<Formula, AuditError> {
        let base = self.primary()?;
        Ok(if self.took('^') { Formula::Power(base.into(), self.primary()?.into()) } else { base })
    }

    fn primary(&mut self) -> Result<Formula, AuditError> {
        match self.tokens.next() {
            Some(Token::Number(number)) => Ok(Formula::Number(number)),
            Some(Token::Name(name)) if name == "sqrt" => Ok(Formula::Root(self.primary()?.into())),
            Some(Token::Name(name)) => Ok(Formula::Name(name)),
            Some(Token::Sign('(')) => {
                let inner = self.sum()?;
                if self.took(')') { Ok(inner) } else { Err(unreadable(self.text)) }
            }
            _ => Err(unreadable(self.text)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ratio(n: i64, d: i64) -> BigRational {
        BigRational::new(n.into(), d.into())
    }

    fn exact(text: &str) -> Result<BigRational, AuditError> {
        let scope = Scope::new(Rationals).with("x0''", ratio(4, 9)).with_exponent("p", &ratio(3, 2));
        Formula::read(text)?.value(&scope)
    }

    #[test]
    fn formulas_are_read_as_printed() {
        for (text, value) in [
            ("1/2 x0''/2", ratio(1, 9)),
            ("-3 - 2 (1 - x0'')^2", ratio(-293, 81)),
            ("x0''^p", ratio(8, 27)),
            ("x0''^(-1/2)", ratio(3, 2)),
            ("sqrt(x0'') p", ratio(1, 1)),
            ("0.25*4", ratio(1, 1)),
        ] {
            assert_eq!(exact(text).unwrap(), value, "{text}");
        }
    }

    #[test]
    fn nonsense_is_refused() {
        for text in
            ["", "1 +", "(1", "1)", "y", "2^(1/2)", "1/(p - p)", "1 % 2", "Gamma(1/2)", "1..2", "Gamma("]
        {
            assert!(exact(text).is_err(), "{text}");
        }
    }

    #[test]
    fn balls_have_constants() {
        let scope = Scope::new(Balls::new(100));
        let value = |text: &str| Formula::read(text).unwrap().value(&scope).unwrap();
        assert!(value("Gamma(1/2)^2").overlaps(&value("pi")));
        assert_eq!(value("sqrt(pi) Gamma(21/10)").to_digits(8).as_deref(), Some("1.8548479"));
    }
}
