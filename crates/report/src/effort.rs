//! How much is measured.

use std::time::Duration;

/// How much is measured: the whole report, or a quick look whose figures say little.
#[derive(Clone, Debug)]
pub struct Effort {
    /// Intervals of the evenly spaced part of the grid, for 0 to 2 and for 2 to 7.5.
    pub intervals: (usize, usize),
    /// Values in a slice.
    pub values: usize,
    /// Samples of a time.
    pub rounds: usize,
    /// How long one sample lasts.
    pub sample: Duration,
    /// How long one expansion may last for the next larger one to be tried.
    pub longest: Duration,
    /// Samples of the time of an expansion.
    pub expansions: usize,
    /// The largest order of coefficients that approximants get and whose lost digits are counted.
    pub order: usize,
}

impl Effort {
    /// The whole report, a few minutes.
    pub fn full() -> Self {
        Self {
            intervals: (400, 220),
            values: 1024,
            rounds: 31,
            sample: Duration::from_micros(300),
            longest: Duration::from_millis(1200),
            expansions: 5,
            order: 38,
        }
    }

    /// A look at every part, a few seconds.
    pub fn quick() -> Self {
        Self {
            intervals: (10, 6),
            values: 32,
            rounds: 1,
            sample: Duration::ZERO,
            longest: Duration::ZERO,
            expansions: 1,
            order: 12,
        }
    }

    /// The dampings at which errors are measured, ascending, each an exact f64 and the ends of ranges among them.
    pub fn grid(&self) -> Vec<f64> {
        let (near, far) = self.intervals;
        let geometric = (1..=12).rev().map(|i| 2.0 / near as f64 * 0.3_f64.powi(i));
        let even = (1..=near).map(|i| 2.0 * i as f64 / near as f64);
        let wide = (1..=far).map(|i| 2.0 + 5.5 * i as f64 / far as f64);
        geometric.chain(even).chain(wide).collect()
    }

    /// The steps of the progress bar.
    pub fn steps(&self) -> u64 {
        (2 * self.grid().len() + 6 * self.rounds + 2 * self.expansions) as u64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grids_rise_and_meet_the_ranges() {
        for effort in [Effort::full(), Effort::quick()] {
            let grid = effort.grid();
            assert!(grid.is_sorted() && grid[0] > 0.0);
            assert!([1.0, 2.0, 7.5].iter().all(|end| grid.contains(end)));
        }
    }
}
