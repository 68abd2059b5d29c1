//! The numbers and statements of the papers, each compared with what is computed.
//!
//! A [`Claim`] carries what is printed as data; [`Claim::judge`] computes the true side by the project's
//! certified and exact engines and compares. No verdict is written down anywhere: change a printed digit
//! and it changes.

mod appendix_coefficients;
mod appendix_trajectory;
mod appendix_turning_point;
mod claim;
mod error;
mod figure_1;
mod formula;
mod free_series;
mod mueller_poeschel;
mod page;
mod power_forces;
mod printed_number;
mod samples;
mod section_3_series;
mod section_3_theory;
mod sections_1_and_2;
mod true_values;

pub use claim::{Claim, Finding, Verdict};
pub use error::AuditError;
pub use page::{count, markdown, remarks};
pub use power_forces::PowerForces;
pub use true_values::TrueValues;

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
        section(
            "Sections I and II: the expansion quoted, and dimensional analysis",
            sections_1_and_2::claims(),
        ),
        section("Section III: the approximate theory", section_3_theory::claims()),
        section("Section III: the series, the Padé formula (35) and Table I", section_3_series::claims()),
        section("Fig. 1: ice", figure_1::claims()),
        section("Appendix: the trajectory", appendix_trajectory::claims()),
        section("Appendix: the turning point", appendix_turning_point::claims()),
        section("Appendix: the coefficients", appendix_coefficients::claims()),
        section(
            "Müller and Pöschel 2011: Padé approximants in the square root of u",
            mueller_poeschel::claims(),
        ),
    ]
}

/// Judges every claim whose name is one of `wanted` or begins with one; all if there are none.
///
/// # Errors
///
/// [`AuditError::UnknownClaim`]; [`AuditError::Undecided`] with what the computations say.
pub fn audit(
    truth: &TrueValues,
    wanted: &[String],
    watch: &mut dyn FnMut(),
) -> Result<Vec<(&'static str, Vec<Judged>)>, AuditError> {
    let mut out = Vec::new();
    for Section { title, claims } in sections() {
        let claims = claims.into_iter().filter(|claim| is_wanted(claim.id, wanted));
        let mut judged = Vec::new();
        for claim in claims {
            judged.push(Judged { finding: claim.judge(truth)?, claim });
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
/// [`AuditError::UnknownClaim`] with the name.
pub fn check_names(wanted: &[String]) -> Result<(), AuditError> {
    let sections = sections();
    let known = |name: &&String| {
        sections.iter().flat_map(|section| &section.claims).any(|claim| begins(claim.id, name))
    };
    match wanted.iter().find(|name| !known(name)) {
        Some(name) => Err(AuditError::UnknownClaim { name: name.clone() }),
        None => Ok(()),
    }
}

fn is_wanted(id: &str, wanted: &[String]) -> bool {
    wanted.is_empty() || wanted.iter().any(|name| begins(id, name))
}

/// Whether `name`, in capitals or not, is the claim's, or its beginning up to a point or behind one.
fn begins(id: &str, name: &str) -> bool {
    let name = name.trim_matches(['(', ')']);
    let begins = id.get(..name.len()).is_some_and(|start| start.eq_ignore_ascii_case(name));
    begins
        .then(|| &id[name.len()..])
        .is_some_and(|rest| rest.is_empty() || rest.starts_with('.') || name.contains('.'))
}

/// The README's code runs as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeDoctests;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_whole_equations() {
        assert!(begins("A26", "A26") && begins("A26.formula", "(A26)") && begins("TableI.d1", "TableI.d"));
        assert!(!begins("A26", "A2") && !begins("11", "1") && !begins("A26", "A") && !begins("A26", ""));
        assert!(check_names(&["A14".to_owned(), "a26".to_owned(), "(A27)".to_owned()]).is_ok());
        assert!(matches!(check_names(&["A99".to_owned()]), Err(AuditError::UnknownClaim { .. })));
    }
}
