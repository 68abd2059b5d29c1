//! A progress bar on stderr for what takes longer than a second.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::sync::mpsc::{self, Sender};
use std::thread::JoinHandle;
use std::time::Duration;

/// How long a run stays silent.
const PATIENCE: Duration = Duration::from_secs(1);

/// A bar that appears after a second, if stderr is a terminal, and leaves no trace when dropped.
///
/// # Examples
///
/// ```
/// use restitution_cli::progress::Progress;
///
/// let progress = Progress::steps("approximants", 3);
/// for _ in 0..3 {
///     progress.advance(1);
/// }
/// ```
pub struct Progress {
    bar: ProgressBar,
    done: Option<Sender<()>>,
    watch: Option<JoinHandle<()>>,
}

impl Progress {
    /// Starts the wait for `total` steps of known number.
    pub fn steps(label: &str, total: u64) -> Self {
        let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::hidden());
        Self::start(bar, label, "{msg} {wide_bar} {pos}/{len} {elapsed} (left: {eta})")
    }

    /// Starts the wait for something whose length is not known.
    pub fn unknown(label: &str) -> Self {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        Self::start(bar, label, "{spinner} {msg} {elapsed}")
    }

    /// Counts `steps` more steps as done; may be called from any thread.
    pub fn advance(&self, steps: u64) {
        self.bar.inc(steps);
    }

    /// Sets the number of steps done.
    pub fn set(&self, steps: u64) {
        self.bar.set_position(steps);
    }

    fn start(bar: ProgressBar, label: &str, template: &str) -> Self {
        let style = ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
        bar.set_style(style);
        bar.set_message(label.to_owned());
        let (done, waiting) = mpsc::channel();
        let shown = bar.clone();
        // Where no thread can be started there is no sign of life, and the work goes on.
        let watch = std::thread::Builder::new().spawn(move || {
            if waiting.recv_timeout(PATIENCE) == Err(mpsc::RecvTimeoutError::Timeout) {
                shown.set_draw_target(ProgressDrawTarget::stderr()); // hidden unless it is a terminal
                shown.enable_steady_tick(Duration::from_millis(200));
            }
        });
        Self { bar, done: Some(done), watch: watch.ok() }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.done.take();
        if let Some(watch) = self.watch.take() {
            let _ = watch.join();
        }
        self.bar.finish_and_clear();
    }
}

/// Runs `work` with a sign of life on stderr once it has taken a second.
pub fn during<T>(label: &str, work: impl FnOnce() -> T) -> T {
    let _progress = Progress::unknown(label);
    work()
}
