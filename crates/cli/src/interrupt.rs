//! Ctrl-C: ends the command at once, with exit code 130 and no half-written file.

use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The temporary file that is being written, if any.
static PENDING: Mutex<Option<PathBuf>> = Mutex::new(None);

/// Makes Ctrl-C remove the file under way, say so and end the process with code 130.
///
/// The file that `-o` names is untouched until its new content is complete, so it is either the old
/// one or the new one.
pub fn install() {
    // Where no handler can be set the system's own way to end a process remains.
    let _ = ctrlc::set_handler(|| {
        if let Some(path) = pending().take() {
            let _ = if path.is_dir() { std::fs::remove_dir_all(path) } else { std::fs::remove_file(path) };
        }
        let _ = std::io::Write::write_all(&mut std::io::stderr(), b"\nrestitution: interrupted\n");
        std::process::exit(130);
    });
}

/// Remembers a temporary file for as long as the guard lives.
pub(crate) struct Pending;

impl Pending {
    pub(crate) fn file(path: &Path) -> Self {
        *pending() = Some(path.to_owned());
        Self
    }
}

impl Drop for Pending {
    fn drop(&mut self) {
        *pending() = None;
    }
}

fn pending() -> MutexGuard<'static, Option<PathBuf>> {
    PENDING.lock().unwrap_or_else(PoisonError::into_inner)
}
