//! Requests at the edges of what can be computed, with what they cost.

use crate::digits_lost::digits_lost;
use crate::effort::Effort;
use crate::page::{Data, Figure};
use crate::speed::figures;
use num_rational::BigRational;
use restitution_direct::{Collision, End};
use restitution_law::ForceLaw;
use restitution_law::exact::{Exact, NumberError};
use restitution_real::Ball;
use restitution_series::{Quantity, coefficients};
use restitution_table::{Cell, Table};
use std::time::Instant;

/// A request and how it is answered.
struct Case {
    what: String,
    why: &'static str,
    digits: usize,
    ask: Box<dyn Fn(usize) -> Result<Ball, String>>,
}

/// Returns the table of hard cases.
pub fn figure(effort: &Effort) -> Figure {
    let mut table = Table::new(&["request", "why_hard", "answer", "working_bits", "digits_lost", "seconds"]);
    for case in cases(effort) {
        let start = Instant::now();
        let answer = (case.ask)(case.digits);
        let seconds = Cell::digits(figures(start.elapsed().as_secs_f64(), 2));
        let (answer, bits, lost) = match answer {
            Ok(ball) => {
                let text = ball.to_digits(case.digits).map_or("not proved".into(), Cell::digits);
                (text, (ball.prec() as usize).into(), Cell::digits(figures(digits_lost(&ball), 2)))
            }
            Err(reason) => (Cell::text(format!("refused: {reason}")), Cell::Empty, Cell::Empty),
        };
        table.push(vec![Cell::text(case.what), case.why.into(), answer, bits, lost, seconds]);
    }
    let caption = "Hard cases, computed for this page. A law is a,γ of x″ + u x^γ x′ + x^a = 0. Every digit shown is proved; digits lost are those between the working precision and the radius of the answer, and include what a narrow answer such as 1 − ε cancels. Where an expansion does not exist the request is refused.";
    Figure::table(caption, Data::new("hard-cases.csv", table))
}

fn cases(effort: &Effort) -> Vec<Case> {
    let laws = [
        ("3/2,1/2", effort.order, "high order"),
        ("2,1", effort.order, "high order"),
        ("3/2,-9/10", 4, "γ close to −1"),
        ("3/2,-99/100", 4, "γ close to −1"),
        ("3/2,-1", 4, "no expansion"),
    ];
    let expansions = laws.into_iter().map(|(law, k, why)| coefficient(law, k, why));
    let motions = DIRECT.into_iter().map(|(law, u, why)| direct(law, u, why));
    let lost = [-12, -20, -60].map(small_loss);
    expansions.chain(motions).chain(lost).collect()
}

/// Law, damping and why it is hard; as in docs/stability.md.
const DIRECT: [(&str, &str, &str); 9] = [
    ("3/2,1/2", "1.388361925615829", "next to R"),
    ("3/2,1/2", "8", "ε is small"),
    ("3/2,1/2", "20", "the slow manifold alone decides"),
    ("3/2,1/2", "1000", "boundary layer at the turning point"),
    ("3/2,501/1000", "1", "z = 0 is a branch point"),
    ("3/2,1499/1000", "1", "a close to γ"),
    ("1001/1000,1/1000", "1", "a close to γ + 1 and to 1"),
    ("3/2,-9/10", "0.01", "γ close to −1"),
    ("1,0", "2", "overdamped, never separates"),
];

/// `C_k` of a law.
fn coefficient(law: &'static str, k: usize, why: &'static str) -> Case {
    let ask = move |digits| {
        let law: ForceLaw = law.parse().map_err(|error: restitution_law::LawError| error.to_string())?;
        let values =
            coefficients(Quantity::Restitution, &law, k, digits).map_err(|error| error.to_string())?;
        values.last().cloned().ok_or_else(|| "no coefficient".to_owned())
    };
    Case { what: format!("C_{k}, law {law}"), why, digits: 20, ask: Box::new(ask) }
}

/// A value of the certified integrator.
fn direct(law: &'static str, u: &'static str, why: &'static str) -> Case {
    let ask = move |digits| {
        let law: ForceLaw = law.parse().map_err(|error: restitution_law::LawError| error.to_string())?;
        let collision = Collision::new(&law, End::ZeroCompression).map_err(|error| error.to_string())?;
        let u: Exact = u.parse().map_err(|error: NumberError| error.to_string())?;
        collision.epsilon(u.value(), digits).map_err(|error| error.to_string())
    };
    Case { what: format!("ε at u = {u}, law {law}"), why, digits: 20, ask: Box::new(ask) }
}

/// `1 - epsilon` of spheres at a power of ten.
fn small_loss(exponent: i32) -> Case {
    let ask = move |digits| {
        let spheres = Collision::new(&ForceLaw::viscoelastic_spheres(), End::ZeroCompression)
            .map_err(|error| error.to_string())?;
        let u = BigRational::from_integer(10.into()).pow(exponent);
        spheres.one_minus_epsilon(&u, digits).map_err(|error| error.to_string())
    };
    Case {
        what: format!("1 − ε at u = 1e{exponent}, law 3/2,1/2"),
        why: "1 − ε cancels",
        digits: 20,
        ask: Box::new(ask),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_has_no_answer_is_refused() {
        assert!((coefficient("3/2,-1", 4, "").ask)(20).is_err());
        assert!((direct("1,0", "2", "").ask)(20).is_err());
        let loss = (small_loss(-12).ask)(12).unwrap();
        assert_eq!(loss.to_digits(12).as_deref(), Some("1.15344885809e-12"));
    }
}
