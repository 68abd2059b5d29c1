//! The languages that evaluators are written in.
//!
//! # A new language
//!
//! One file `language/NAME.rs` with a `pub(super) static LANGUAGE: Language`, and its line in [`LANGUAGES`]:
//! a template in which [`fields`](template) stand in braces, how a row of numbers is written, and what the language
//! is called. `tests/it/export.rs` then wants a driver for it, in its list of drivers. `docs/export.md` has the recipe.

mod c;
mod fortran;
mod javascript;
mod julia;
mod matlab;
mod python;
mod rust;
mod template;

use crate::{ExportError, Listing};

/// A language that evaluators are written in.
#[derive(Debug)]
pub struct Language {
    /// What it is called on the command line.
    pub name: &'static str,
    /// What else it is called there, in lower case.
    pub aliases: &'static [&'static str],
    /// What the sources are.
    pub title: &'static str,
    /// The file that a source goes into, with the field NAME.
    pub file: &'static str,
    /// What a line of the head starts with.
    pub comment: &'static str,
    /// How rows of numbers are written.
    rows: Rows,
    /// Names that the source itself needs, beside those that start with NAME.
    reserved: &'static [&'static str],
    /// The source, with fields.
    template: &'static str,
}

/// How rows of numbers are written; `{what}` is the name of the array, `{i}` the number of the row.
#[derive(Debug)]
struct Rows {
    before: &'static str,
    between: &'static str,
    after: &'static str,
    /// What follows each number.
    suffix: &'static str,
}

/// Every language, in the order of the documents.
pub static LANGUAGES: &[&Language] = &[
    &rust::LANGUAGE,
    &c::LANGUAGE,
    &fortran::LANGUAGE,
    &python::LANGUAGE,
    &julia::LANGUAGE,
    &javascript::LANGUAGE,
    &matlab::LANGUAGE,
];

/// The longest name: Fortran allows 63 letters, of which `_epsilon_of_velocity` takes 20.
const LONGEST_NAME: usize = 40;

impl Language {
    /// Finds a language by name, alias or extension, in any case.
    ///
    /// # Errors
    ///
    /// [`ExportError::Language`] if there is none.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution_export::Language;
    ///
    /// assert_eq!(Language::of("CPP")?.name, "c");
    /// assert_eq!(Language::of(".f90")?.name, "fortran");
    /// let error = Language::of("basic").unwrap_err().to_string();
    /// assert_eq!(
    ///     error,
    ///     "there is no language \"basic\": choose one of rust, c, fortran, python, julia, javascript, matlab"
    /// );
    /// # Ok::<(), restitution_export::ExportError>(())
    /// ```
    pub fn of(name: &str) -> Result<&'static Self, ExportError> {
        let wanted = name.trim().trim_start_matches('.').to_lowercase();
        let found = LANGUAGES
            .iter()
            .find(|language| language.name == wanted || language.aliases.contains(&wanted.as_str()));
        found.copied().ok_or_else(|| ExportError::Language {
            name: name.trim().to_owned(),
            known: LANGUAGES.iter().map(|language| language.name).collect::<Vec<_>>().join(", "),
        })
    }

    /// Returns the evaluator as source code, in which every public name starts with `name`.
    ///
    /// # Errors
    ///
    /// [`ExportError::Name`] if that is no name in this language.
    pub fn write(&self, listing: &Listing, name: &str) -> Result<String, ExportError> {
        self.check(name)?;
        Ok(template::fill(self, listing, name))
    }

    /// Checks that names can start with `name`.
    ///
    /// # Errors
    ///
    /// [`ExportError::Name`] if they cannot.
    pub fn check(&self, name: &str) -> Result<(), ExportError> {
        let refuse = |reason| Err(ExportError::Name { name: name.to_owned(), language: self.name, reason });
        if !name.starts_with(|c: char| c.is_ascii_alphabetic()) {
            return refuse("start with a letter from a to z");
        }
        if !name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') {
            return refuse("use letters from a to z, digits and underscores only");
        }
        if name.len() > LONGEST_NAME {
            return refuse("use 40 characters at most");
        }
        if self.reserved.contains(&name.to_lowercase().as_str()) {
            return refuse("the language or the source itself uses it, choose another");
        }
        Ok(())
    }
}
