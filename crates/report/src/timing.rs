//! Medians of times with their spread, measured in turn.

use std::time::{Duration, Instant};

/// The median of repeated measurements with its quartiles, in seconds for one value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timing {
    pub median: f64,
    pub low: f64,
    pub high: f64,
}

impl Timing {
    /// Returns the median and the quartiles; NaN without samples.
    pub fn of(mut samples: Vec<f64>) -> Self {
        samples.sort_by(f64::total_cmp);
        let quantile = |quarters: usize| {
            let last = samples.len().checked_sub(1)?;
            samples.get((last * quarters + 2) / 4).copied()
        };
        let [low, median, high] = [1, 2, 3].map(|quarters| quantile(quarters).unwrap_or(f64::NAN));
        Self { median, low, high }
    }

    /// Returns the times in units of `unit` seconds.
    pub fn in_units_of(self, unit: f64) -> Self {
        Self { median: self.median / unit, low: self.low / unit, high: self.high / unit }
    }
}

/// Work that gives a number of values each time it is done.
pub struct Task<'a> {
    pub values: usize,
    pub work: Box<dyn FnMut() + 'a>,
}

/// Measures the tasks, `rounds` times one after the other, so that what slows the machine slows them all.
///
/// A sample repeats its task for about `sample` and counts the time of one value; the first round, which
/// finds the number of repetitions, does not count.
pub fn in_turn(tasks: &mut [Task], rounds: usize, sample: Duration, mut watch: impl FnMut()) -> Vec<Timing> {
    let repetitions = tasks
        .iter_mut()
        .map(|task| {
            (task.work)();
            let once = seconds(task, 1).max(1e-9);
            (sample.as_secs_f64() / once).clamp(1.0, 1e6) as usize
        })
        .collect::<Vec<_>>();
    let mut samples = vec![Vec::with_capacity(rounds); tasks.len()];
    for _ in 0..rounds {
        for (i, task) in tasks.iter_mut().enumerate() {
            let values = (repetitions[i] * task.values) as f64;
            samples[i].push(seconds(task, repetitions[i]) / values);
        }
        watch();
    }
    samples.into_iter().map(Timing::of).collect()
}

fn seconds(task: &mut Task, repetitions: usize) -> f64 {
    let start = Instant::now();
    (0..repetitions).for_each(|_| (task.work)());
    start.elapsed().as_secs_f64()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quartiles_of_five() {
        let timing = Timing::of(vec![5.0, 1.0, 4.0, 2.0, 3.0]);
        assert_eq!(timing, Timing { low: 2.0, median: 3.0, high: 4.0 });
        assert!(Timing::of(Vec::new()).median.is_nan());
    }

    #[test]
    fn tasks_take_turns() {
        let order = std::cell::RefCell::new(Vec::new());
        let note = &order;
        let task = |n: i32| Task { values: 1, work: Box::new(move || note.borrow_mut().push(n)) };
        let times = in_turn(&mut [task(1), task(2)], 3, Duration::ZERO, || ());
        assert_eq!(*order.borrow(), [1, 1, 2, 2, 1, 2, 1, 2, 1, 2]);
        assert!(times.iter().all(|t| t.low <= t.median && t.median <= t.high));
    }
}
