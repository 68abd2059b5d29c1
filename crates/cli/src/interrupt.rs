//! Ctrl-C and other requests to end: the command ends at once, with exit code 130 and no half-written file.

use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The temporary file that is being written, if any.
static PENDING: Mutex<Option<PathBuf>> = Mutex::new(None);

/// Makes Ctrl-C, a request to terminate or the end of the terminal remove the file under way, say so and end the
/// process with code 130, and a limit on the size of files an error that can be reported.
///
/// The file that `-o` names is untouched until its new content is complete, so it is either the old
/// one or the new one.
pub fn install() {
    // Where no handler can be set the system's own way to end a process remains.
    let _ = ctrlc::set_handler(|| {
        let mut pending = pending(); // until the end: no new file is begun
        if let Some(path) = pending.take() {
            let _ = if path.is_dir() { std::fs::remove_dir_all(path) } else { std::fs::remove_file(path) };
        }
        let _ = std::io::Write::write_all(&mut std::io::stderr(), b"\nrestitution: interrupted\n");
        std::process::exit(130);
    });
    #[cfg(unix)]
    // With a handler, writing beyond the limit fails instead of ending the process.
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, std::sync::Arc::default());
}

/// Remembers a temporary file for as long as it lives.
pub(crate) struct Pending(());

impl Pending {
    /// Nothing to remove yet.
    pub(crate) fn nothing() -> Self {
        Self(())
    }

    /// Remembers `path`. To be called before the file is made, so that there is no moment at which it is unknown.
    pub(crate) fn file(&self, path: &Path) {
        *pending() = Some(path.to_owned());
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
