//! Refuses what the machine cannot hold, before it starts.

use crate::CliError;

/// Checks that about `bytes` bytes of memory are available.
///
/// `bytes` is the subcommand's own estimate of its peak; `remedy` says which argument to lower.
///
/// # Errors
///
/// [`CliError::Usage`] with the estimate and what is available.
///
/// # Examples
///
/// ```
/// use restitution_cli::memory::require;
///
/// assert!(require(1e3, "lower --order").is_ok());
/// let error = require(1e20, "lower --order").unwrap_err();
/// assert!(error.to_string().starts_with("this needs about 100 EB of memory"));
/// ```
pub fn require(bytes: f64, remedy: &str) -> Result<(), CliError> {
    let available = available();
    if bytes <= available {
        return Ok(());
    }
    Err(CliError::usage(format!(
        "this needs about {} of memory and {} are available: {remedy}",
        text(bytes),
        text(available)
    )))
}

/// Returns the bytes of memory that can be had: of the machine, or of the control group if less.
fn available() -> f64 {
    let mut system = sysinfo::System::new();
    system.refresh_memory();
    let free = system.available_memory() + system.free_swap();
    let limit = system.cgroup_limits().map_or(free, |limits| free.min(limits.free_memory));
    limit as f64
}

/// Returns a number of bytes with three figures.
fn text(bytes: f64) -> String {
    const UNITS: [&str; 9] = ["B", "kB", "MB", "GB", "TB", "PB", "EB", "ZB", "YB"];
    let power = (bytes.max(1.0).log10() / 3.0).floor().clamp(0.0, 8.0);
    let value = bytes / 1e3_f64.powf(power);
    format!("{value:.*} {}", if value < 9.95 { 1 } else { 0 }, UNITS[power as usize])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_are_readable() {
        assert_eq!(text(23_813e6), "24 GB");
        assert_eq!(text(1.25e12), "1.2 TB");
        assert_eq!(text(0.0), "0.0 B");
        assert_eq!(text(f64::INFINITY), "inf YB");
    }
}
