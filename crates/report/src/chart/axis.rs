//! One axis of a chart: a range, a scale and its ticks.

/// How values are spread along an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// By their logarithm.
    Log,
}

/// A labelled range of values.
#[derive(Clone, Debug)]
pub struct Axis {
    pub label: String,
    scale: Scale,
    low: f64,
    high: f64,
}

/// A line of the grid, with a number beside it or without.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Place along the axis, 0 to 1.
    pub place: f64,
    pub label: Option<String>,
}

/// Largest number of labels on an axis.
const MOST_LABELS: f64 = 9.0;

impl Axis {
    /// Returns an axis from `low` to `high`.
    pub fn linear(label: &str, low: f64, high: f64) -> Self {
        Self { label: label.to_owned(), scale: Scale::Linear, low, high }
    }

    /// Returns a logarithmic axis from `low` to `high`, both positive.
    pub fn log(label: &str, low: f64, high: f64) -> Self {
        Self { label: label.to_owned(), scale: Scale::Log, low: low.log10(), high: high.log10() }
    }

    /// Returns a logarithmic axis of whole decades around the positive values.
    pub fn decades(label: &str, values: impl IntoIterator<Item = f64>) -> Self {
        let logs = values.into_iter().filter(|v| *v > 0.0 && v.is_finite()).map(f64::log10);
        let (low, high) = logs.fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(v), h.max(v)));
        let (low, high) = if low > high { (0.0, 1.0) } else { (low, high) };
        let (low, high) = ((low - 0.05).floor(), (high + 0.05).ceil());
        Self { label: label.to_owned(), scale: Scale::Log, low, high }
    }

    /// Returns where a value lies, 0 at the low end and 1 at the high end; `None` if it has no place.
    pub fn place(&self, value: f64) -> Option<f64> {
        let value = if self.scale == Scale::Log { value.log10() } else { value };
        let place = (value - self.low) / (self.high - self.low);
        place.is_finite().then_some(place)
    }

    /// Returns the scale, its ends and where in a drawing they lie, as `pointer.js` reads it.
    pub fn written(&self, from: f64, to: f64) -> String {
        let scale = if self.scale == Scale::Log { "log" } else { "linear" };
        format!("{scale} {} {} {from} {to}", self.low, self.high)
    }

    /// Whether a value lies on the axis.
    pub fn holds(&self, value: f64) -> bool {
        self.place(value).is_some_and(|place| (-1e-9..=1.0 + 1e-9).contains(&place))
    }

    /// Returns the lines of the grid.
    pub fn ticks(&self) -> Vec<Tick> {
        match self.scale {
            Scale::Linear => self.linear_ticks(),
            Scale::Log => self.decade_ticks(),
        }
    }

    fn linear_ticks(&self) -> Vec<Tick> {
        let step = nice_step((self.high - self.low) / (MOST_LABELS - 1.0));
        let decimals = (-step.log10().floor()).max(0.0) as usize;
        let first = (self.low / step - 1e-9).ceil() as i64;
        let last = (self.high / step + 1e-9).floor() as i64;
        let value = |i: i64| i as f64 * step;
        (first..=last)
            .map(|i| Tick {
                place: (value(i) - self.low) / (self.high - self.low),
                label: Some(format!("{:.decimals$}", value(i)).replace('-', "−")),
            })
            .collect()
    }

    fn decade_ticks(&self) -> Vec<Tick> {
        let every = nice_step((self.high - self.low) / (MOST_LABELS - 1.0)).max(1.0) as i64;
        let (first, last) = ((self.low - 1e-9).ceil() as i64, (self.high + 1e-9).floor() as i64);
        let decades = (first..=last).map(|decade| Tick {
            place: (decade as f64 - self.low) / (self.high - self.low),
            label: (decade % every == 0).then(|| power_of_ten(decade)),
        });
        decades.chain(self.within_decades(first - 1, last)).collect()
    }

    /// The lines at 2 and 5 times a power of ten, labelled where there are few decades.
    fn within_decades(&self, first: i64, last: i64) -> Vec<Tick> {
        let span = self.high - self.low;
        if span > 4.0 {
            return Vec::new();
        }
        let lines = (first..=last).flat_map(|decade| [2.0_f64, 5.0].map(|factor| (factor, decade)));
        lines
            .map(|(factor, decade)| Tick {
                place: (factor.log10() + decade as f64 - self.low) / span,
                label: (span < 1.7).then(|| plain(factor * 10_f64.powi(decade as i32))),
            })
            .filter(|tick| (0.0..=1.0).contains(&tick.place))
            .collect()
    }
}

/// The smallest of 1, 2, 5 times a power of ten that is not below `least`.
fn nice_step(least: f64) -> f64 {
    let power = 10_f64.powf(least.log10().floor());
    [1.0, 2.0, 5.0, 10.0].into_iter().map(|n| n * power).find(|step| *step >= least * 0.999).unwrap_or(power)
}

/// A power of ten as it is read: plain near one, with a raised exponent elsewhere.
fn power_of_ten(decade: i64) -> String {
    if (-3..=3).contains(&decade) {
        plain(10_f64.powi(decade as i32))
    } else {
        format!("10{}", raised(decade))
    }
}

fn plain(value: f64) -> String {
    let decimals = (-value.log10().floor()).max(0.0) as usize;
    format!("{value:.decimals$}")
}

/// A whole number in raised digits.
fn raised(n: i64) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    n.to_string().chars().map(|c| c.to_digit(10).map_or('⁻', |d| DIGITS[d as usize])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(axis: &Axis) -> Vec<String> {
        axis.ticks().into_iter().filter_map(|tick| tick.label).collect()
    }

    #[test]
    fn ticks_are_round_numbers() {
        assert_eq!(labels(&Axis::linear("u", 0.0, 2.0)), ["0.0", "0.5", "1.0", "1.5", "2.0"]);
        assert_eq!(labels(&Axis::log("error", 1e-4, 10.0)), ["10⁻⁴", "0.001", "0.01", "0.1", "1", "10"]);
        assert_eq!(labels(&Axis::log("n", 1.0, 10.0)), ["1", "10", "2", "5"]);
    }

    #[test]
    fn decades_hold_their_values() {
        let axis = Axis::decades("error", [3e-17, 0.0, 0.2]);
        assert!(axis.holds(3e-17) && axis.holds(0.2) && !axis.holds(20.0) && axis.place(0.0).is_none());
        assert_eq!(axis.place(1e-17), Some(0.0));
    }
}
