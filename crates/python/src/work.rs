//! Work that may take long: outside the interpreter's lock, ended by Ctrl-C, watched if asked.

use pyo3::prelude::*;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, mpsc};
use std::thread;
use std::time::{Duration, Instant};

/// How often signals are looked for.
const POLL: Duration = Duration::from_millis(50);

/// What the work tells of itself, and how it hears that nobody waits for it any more.
#[derive(Clone, Default)]
pub struct Watch {
    done: Arc<AtomicUsize>,
    abandoned: Arc<AtomicBool>,
}

/// Unwinds the thread of abandoned work.
struct Abandoned;

impl Watch {
    /// Notes that `done` steps are done; does not return where the work was interrupted.
    pub fn set(&self, done: usize) {
        self.done.store(done, Ordering::Relaxed);
        if self.abandoned.load(Ordering::Relaxed) {
            resume_unwind(Box::new(Abandoned));
        }
    }
}

/// Runs `work` on a thread of its own and gives its result.
///
/// Every 50 ms the interpreter may handle signals, and `progress`, if there is one, is called with the number
/// of steps done and `total`; with the seconds gone and None where steps cannot be counted. If either raises,
/// the exception is passed on at once, and the work ends at its next step.
pub fn run<T: Send + 'static>(
    py: Python<'_>,
    total: Option<usize>,
    progress: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&Watch) -> T + Send + 'static,
) -> PyResult<T> {
    let watch = Watch::default();
    let (send, receive) = mpsc::channel();
    let inside = watch.clone();
    let worker = thread::spawn(move || {
        // nobody listens any more if the work was abandoned
        let _ = send.send(work(&inside));
    });
    let (start, mut told) = (Instant::now(), 0);
    let receive = std::sync::Mutex::new(receive);
    loop {
        let waited = py.detach(|| match receive.lock() {
            Ok(receive) => receive.recv_timeout(POLL),
            Err(_) => Err(mpsc::RecvTimeoutError::Disconnected),
        });
        match waited {
            Ok(value) => {
                if let (Some(progress), Some(total)) = (progress, total) {
                    progress.call1((total, total))?;
                }
                return Ok(value);
            }
            Err(mpsc::RecvTimeoutError::Disconnected) => match worker.join() {
                Err(panic) => resume_unwind(panic),
                Ok(()) => unreachable!("the work ended without a result"),
            },
            Err(mpsc::RecvTimeoutError::Timeout) => {}
        }
        let done = match total {
            Some(_) => watch.done.load(Ordering::Relaxed),
            None => usize::try_from(start.elapsed().as_secs()).unwrap_or(usize::MAX),
        };
        let told_so = match progress.filter(|_| done != told) {
            Some(progress) => progress.call1((done, total)).map(|_| told = done),
            None => Ok(()),
        };
        if let Err(error) = py.check_signals().and(told_so) {
            watch.abandoned.store(true, Ordering::Relaxed);
            return Err(error);
        }
    }
}
