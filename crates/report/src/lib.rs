//! The report: speed against error, errors, growth, the paper's figure and numerical stability, measured here.
//!
//! `contestants` lists what is compared; `certified_values` those that judge; a module for
//! each part of the page measures and draws it; `page` puts them together.

mod beside;
mod certified_values;
mod chart;
mod contestants;
mod digits_lost;
mod effort;
mod error;
mod errors;
mod f64_pade;
mod formulas;
mod growth;
mod hard_cases;
mod ice;
mod kernel;
mod machine;
mod ode;
mod page;
mod speed;
mod stability;
mod timing;

pub use beside::Beside;
pub use effort::Effort;
pub use error::ReportError;
pub use page::GENERATOR;

/// Called once for each step that is done, from any thread; [`Effort::steps`] says how many there are.
pub type Watch<'a> = dyn Fn() + Sync + 'a;

/// Measures everything and returns the files of the report, each with its name; with the times of another build beside if there is one.
///
/// # Errors
///
/// What the libraries say; nothing that is measured depends on input.
pub fn make(
    effort: &Effort,
    other: Option<&Beside>,
    watch: &Watch,
) -> Result<Vec<(String, String)>, ReportError> {
    let contestants = contestants::all(effort.order)?;
    let reference = certified_values::CertifiedValues::new(effort.grid(), &watch)?;
    let errors = speed::errors(&contestants, &reference);
    let results = speed::measure(&contestants, &reference, &errors, effort, &watch);
    let machine = machine::Machine::this();
    let speed = speed::section(&contestants, &results, reference.u.len());
    let builds = other.map(|other| beside::section(&contestants, &results, other));
    let others = [
        errors::section(&contestants, &reference, &errors)?,
        ice::section()?,
        growth::section(effort, &watch)?,
        stability::section(effort)?,
        page::Section::new(
            "Machine",
            "What the times above depend on.",
            vec![page::Figure::table("", page::Data::new(beside::MACHINE, machine.table()))],
        ),
    ];
    let sections = std::iter::once(speed).chain(builds).chain(others).collect::<Vec<_>>();
    Ok(page::files(&machine, &sections))
}

/// The README's code runs as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeDoctests;
