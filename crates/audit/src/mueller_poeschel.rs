//! The Padé constants of \[MP2011\], in the square root of `u`, the contact ending at zero force.

use crate::AuditError;
use crate::claim::{Claim, Finding, enclosed};
use crate::true_values::{FIELD, TrueValues};
use restitution_pade::{PadeType, approximant};

/// Which polynomial a constant belongs to.
#[derive(Clone, Copy)]
enum Part {
    Num,
    Den,
}

/// The claims.
pub fn claims() -> Vec<Claim> {
    const ONE_FOUR: &str = "restitution pade 1 4 --end zero-force --digits 20";
    const THREE_SIX: &str = "restitution pade 3 6 --end zero-force --digits 20";
    let small = |id, statement, printed, check| Claim::new(id, statement, printed, ONE_FOUR, check);
    let large = |id, statement, printed, check| Claim::new(id, statement, printed, THREE_SIX, check);
    vec![
        small("MP2011.14.c1", "[1/4], c_1", "0.501086", |p, f| constant(p, f, (1, 4), Part::Num, 1)),
        small("MP2011.14.b1", "[1/4], b_1", "0.501086", |p, f| constant(p, f, (1, 4), Part::Den, 1)),
        small("MP2011.14.b2", "[1/4], b_2", "1.15345", |p, f| constant(p, f, (1, 4), Part::Den, 2)),
        small("MP2011.14.b3", "[1/4], b_3", "0.577977", |p, f| constant(p, f, (1, 4), Part::Den, 3)),
        small("MP2011.14.b4", "[1/4], b_4", "0.532178", |p, f| constant(p, f, (1, 4), Part::Den, 4)),
        large("MP2011.36.c1", "[3/6], c_1", "1.07232", |p, f| constant(p, f, (3, 6), Part::Num, 1)),
        large("MP2011.36.c2", "[3/6], c_2", "0.574198", |p, f| constant(p, f, (3, 6), Part::Num, 2)),
        large("MP2011.36.c3", "[3/6], c_3", "0.141552", |p, f| constant(p, f, (3, 6), Part::Num, 3)),
        large("MP2011.36.b1", "[3/6], b_1", "1.07232", |p, f| constant(p, f, (3, 6), Part::Den, 1)),
        large("MP2011.36.b2", "[3/6], b_2", "1.72765", |p, f| constant(p, f, (3, 6), Part::Den, 2)),
        large("MP2011.36.b3", "[3/6], b_3", "1.37842", |p, f| constant(p, f, (3, 6), Part::Den, 3)),
        large("MP2011.36.b4", "[3/6], b_4", "1.19449", |p, f| constant(p, f, (3, 6), Part::Den, 4)),
        large("MP2011.36.b5", "[3/6], b_5", "0.467273", |p, f| constant(p, f, (3, 6), Part::Den, 5)),
        large("MP2011.36.b6", "[3/6], b_6", "0.235585", |p, f| constant(p, f, (3, 6), Part::Den, 6)),
    ]
}

fn constant(
    printed: &str,
    truth: &TrueValues,
    (l, m): (usize, usize),
    part: Part,
    k: usize,
) -> Result<Finding, AuditError> {
    let found = approximant(&FIELD, &truth.h, PadeType::new(l, m)).map_err(AuditError::failure)?;
    let polynomial = match part {
        Part::Num => found.num(),
        Part::Den => found.den(),
    };
    enclosed(printed, &polynomial[k])
}
