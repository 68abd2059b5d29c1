//! What was probably meant by arguments that cannot be read.

use crate::units;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use std::ffi::OsString;

/// Returns what to say about an unexpected argument, if it is clear what was meant.
///
/// # Examples
///
/// ```
/// use restitution_cli::hint::of_unexpected;
///
/// let typed = ["epsilon", "--velocity", "-1cm/s"].map(Into::into);
/// let said = of_unexpected("-1", &typed);
/// assert_eq!(said.as_deref(), Some("'-1cm/s' for --velocity is negative: give its size"));
///
/// assert_eq!(of_unexpected("--foo", &["table", "--foo"].map(Into::into)), None);
/// ```
pub fn of_unexpected(unexpected: &str, arguments: &[OsString]) -> Option<String> {
    let words = arguments.iter().map(|word| word.to_string_lossy()).collect::<Vec<_>>();
    let number =
        |word: &str| word.strip_prefix('-').unwrap_or(word).starts_with(|c: char| c.is_ascii_digit());
    if unexpected.starts_with('-') && number(unexpected) {
        let at = words.iter().position(|word| word.starts_with(unexpected))?;
        let place = words[..at].iter().rposition(|word| word.starts_with('-') && !number(word))?;
        let option = &words[place];
        let belongs = place + 1 == at || ["--velocity", "--u"].contains(&option.as_ref());
        return belongs.then(|| format!("'{}' for {option} is negative: give its size", words[at]));
    }
    let mut before = words.windows(2).filter(|pair| pair[1] == unexpected).map(|pair| &pair[0]);
    if before.clone().any(|word| word == "--at-infinity") {
        return Some(format!(
            "--at-infinity stands alone or has an equals sign: write --at-infinity={unexpected}"
        ));
    }
    units::dimension_of(unexpected)?;
    let before = before.find(|word| number(word))?;
    Some(format!(
        "'{before} {unexpected}' are two arguments: write {before}{unexpected}, without a blank or in quotes"
    ))
}

/// As [`of_unexpected`], for what clap says.
pub(crate) fn of(error: &clap::Error, arguments: &[OsString]) -> Option<String> {
    let (context, may_be_number) = match error.kind() {
        ErrorKind::UnknownArgument => (ContextKind::InvalidArg, true),
        ErrorKind::ValueValidation => (ContextKind::InvalidValue, false), // a negative number was read, and its reader says why not
        _ => return None,
    };
    match error.get(context) {
        Some(ContextValue::String(unread)) if may_be_number || !unread.starts_with('-') => {
            of_unexpected(unread, arguments)
        }
        _ => None,
    }
}
