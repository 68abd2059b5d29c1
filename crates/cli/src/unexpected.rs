//! What should not happen: a panic becomes one line and exit code 1.

use crate::CliError;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Runs the command; a panic is a failure with a line that asks for a report.
///
/// With `RUST_BACKTRACE` set the panic also says where it happened.
///
/// # Errors
///
/// Those of `run`, and [`CliError::Failure`] for a panic.
pub fn caught(run: impl FnOnce() -> Result<(), CliError>) -> Result<(), CliError> {
    if std::env::var_os("RUST_BACKTRACE").is_none() {
        std::panic::set_hook(Box::new(|_| {}));
    }
    catch_unwind(AssertUnwindSafe(run)).unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<String>().map(String::as_str);
        let text = text.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("no reason given");
        Err(CliError::failure(format!(
            "internal error: {text}: give it more memory if it was short of that, else please report it"
        )))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_a_failure_in_one_line() {
        let found = caught(|| panic!("the \n impossible")).unwrap_err();
        assert!(matches!(&found, CliError::Failure(text) if text.starts_with("internal error: the")));
        assert!(caught(|| Ok(())).is_ok());
    }
}
