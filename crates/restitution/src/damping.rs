use crate::{End, epsilon};

/// Returns the damping parameter `u` whose coefficient is `wanted`, between 0 and 1, by bisection to the last bit.
pub(crate) fn damping(wanted: f64, end: End) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    while epsilon(high, end) > wanted && high < f64::MAX {
        (low, high) = (high, 16.0 * high);
    }
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return high;
        }
        if epsilon(middle, end) > wanted { low = middle } else { high = middle }
    }
}
