//! How a series is written: its terms and an honest `+ O(t^(p/2))`.

use crate::FractionalSeries;
use num_rational::{BigRational, Ratio};
use num_traits::{One, Signed, Zero};
use restitution_real::convert::fraction;
use std::fmt;

impl fmt::Display for FractionalSeries {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut first = true;
        for (k, c) in self.coefficients().iter().enumerate().filter(|(_, c)| !c.is_zero()) {
            let sign = match (first, c.is_negative()) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            };
            write!(f, "{sign}{}", term(&c.abs(), &self.exponent(k)))?;
            first = false;
        }
        let plus = if first { "" } else { " + " };
        write!(f, "{plus}O({})", monomial(&self.exponent(self.order())))
    }
}

fn term(c: &BigRational, exponent: &Ratio<i64>) -> String {
    match (c.is_one(), exponent.is_zero()) {
        (_, true) => fraction(c),
        (true, false) => monomial(exponent),
        (false, false) => format!("{} {}", fraction(c), monomial(exponent)),
    }
}

/// `1`, `t`, `t^6` or `t^(7/2)`.
fn monomial(exponent: &Ratio<i64>) -> String {
    match (exponent.is_zero(), exponent.is_one(), exponent.is_integer()) {
        (true, ..) => "1".to_owned(),
        (_, true, _) => "t".to_owned(),
        (_, _, true) => format!("t^{exponent}"),
        _ => format!("t^({exponent})"),
    }
}
