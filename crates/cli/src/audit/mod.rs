//! The numbers and statements of the papers, each compared with what is computed.
//!
//! A [`Claim`] carries what is printed as data; [`Claim::judge`] computes the true side by the project's
//! certified and exact engines and compares. No verdict is written down anywhere: change a printed digit
//! and it changes.

mod approximation;
mod claim;
mod compact;
mod dimensions;
mod facts;
mod figure;
mod formal;
mod formula;
mod inverse;
mod number;
mod page;
mod quotient;
mod samples;
mod trajectory;
mod turning;

pub use claim::{Claim, Finding, Verdict};
pub use facts::Facts;
pub use page::{count, markdown, remarks};

use crate::CliError;

/// Claims that belong together.
pub struct Section {
    /// What they are about.
    pub title: &'static str,
    /// The claims, in the order of the paper.
    pub claims: Vec<Claim>,
}

/// A claim with its verdict.
pub struct Judged {
    /// The claim.
    pub claim: Claim,
    /// What was found.
    pub finding: Finding,
}

/// All claims, by section of the papers.
pub fn sections() -> Vec<Section> {
    let section = |title, claims| Section { title, claims };
    vec![
        section("Sections I and II: the expansion quoted, and dimensional analysis", dimensions::claims()),
        section("Section III: the approximate theory", approximation::claims()),
        section("Section III: the series, the Padé formula (35) and Table I", quotient::claims()),
        section("Fig. 1: ice", figure::claims()),
        section("Appendix: the trajectory", trajectory::claims()),
        section("Appendix: the turning point", turning::claims()),
        section("Appendix: the coefficients", inverse::claims()),
        section("Müller and Pöschel 2011: Padé approximants in the square root of u", compact::claims()),
    ]
}

/// Judges every claim whose name is one of `wanted` or begins with one; all if there are none.
///
/// # Errors
///
/// Usage if a name is not known; what the computations say.
pub fn audit(
    facts: &Facts,
    wanted: &[String],
    watch: &mut dyn FnMut(),
) -> Result<Vec<(&'static str, Vec<Judged>)>, CliError> {
    let mut out = Vec::new();
    for Section { title, claims } in sections() {
        let claims = claims.into_iter().filter(|claim| is_wanted(claim.id, wanted));
        let mut judged = Vec::new();
        for claim in claims {
            judged.push(Judged { finding: claim.judge(facts)?, claim });
            watch();
        }
        if !judged.is_empty() {
            out.push((title, judged));
        }
    }
    Ok(out)
}

/// Refuses names that no claim begins with.
///
/// # Errors
///
/// Usage, with the name.
pub fn check_names(wanted: &[String]) -> Result<(), CliError> {
    let sections = sections();
    let known = |name: &&String| {
        sections.iter().flat_map(|section| &section.claims).any(|claim| begins(claim.id, name))
    };
    match wanted.iter().find(|name| !known(name)) {
        Some(name) => Err(CliError::usage(format!(
            "no claim is called {name}: run 'restitution audit' for a list, or give an equation such as A26"
        ))),
        None => Ok(()),
    }
}

fn is_wanted(id: &str, wanted: &[String]) -> bool {
    wanted.is_empty() || wanted.iter().any(|name| begins(id, name))
}

/// Whether `name` is the claim's, or its beginning up to a point or behind one.
fn begins(id: &str, name: &str) -> bool {
    let rest = id.strip_prefix(name.trim_matches(['(', ')']));
    rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.') || name.contains('.'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_whole_equations() {
        assert!(begins("A26", "A26") && begins("A26.formula", "(A26)") && begins("TableI.d1", "TableI.d"));
        assert!(!begins("A26", "A2") && !begins("11", "1") && !begins("A26", "A") && !begins("A26", ""));
        assert!(check_names(&["A14".to_owned()]).is_ok());
        assert!(matches!(check_names(&["A99".to_owned()]), Err(CliError::Usage(_))));
    }
}
