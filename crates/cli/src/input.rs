//! Files that are read whole, up to a limit.

use crate::CliError;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// Reads a file of at most `most` bytes; `-` is stdin. `remedy` says what to give instead of a longer one.
///
/// # Errors
///
/// [`CliError::Usage`] for a file that cannot be read, with the reason, or is longer.
///
/// # Examples
///
/// ```
/// use restitution_cli::input::read;
///
/// let missing = read("/no/such/file".as_ref(), 1_000_000, "give a table").unwrap_err();
/// assert!(missing.to_string().contains("cannot read '/no/such/file': no such file"));
/// ```
pub fn read(path: &Path, most: u64, remedy: &str) -> Result<Vec<u8>, CliError> {
    let name = path.display();
    let cannot = |error: std::io::Error| {
        let reason = error.to_string().to_lowercase();
        CliError::usage(format!(
            "cannot read '{name}': {}",
            reason.split(" (os error").next().unwrap_or_default()
        ))
    };
    let mut bytes = Vec::new();
    let source: Box<dyn Read> = if path == Path::new("-") {
        Box::new(std::io::stdin())
    } else {
        let file = File::open(path).map_err(cannot)?;
        bytes.reserve(file.metadata().map_or(0, |meta| meta.len().min(most) as usize));
        Box::new(file)
    };
    source.take(most + 1).read_to_end(&mut bytes).map_err(cannot)?;
    if bytes.len() as u64 > most {
        return Err(CliError::usage(format!("'{name}' has more than {} MB: {remedy}", most / 1_000_000)));
    }
    Ok(bytes)
}
