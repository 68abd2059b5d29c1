//! Places for the labels of points, none over another.

/// Half the side of a mark with the space around it.
const MARK: f64 = 6.5;
/// The width of a character and the height of a line, in the units of the drawing.
const CHARACTER: f64 = 6.9;
const LINE: f64 = 12.0;

/// A rectangle, from left and top to right and bottom.
type Box = [f64; 4];

/// What is taken of the area of a chart.
#[derive(Debug)]
pub struct Labels {
    area: Box,
    taken: Vec<Box>,
}

impl Labels {
    /// Returns the empty area.
    pub fn within(left: f64, right: f64, top: f64, bottom: f64) -> Self {
        Self { area: [left, top, right, bottom], taken: Vec::new() }
    }

    /// Takes the place of a mark.
    pub fn occupy(&mut self, x: f64, y: f64) {
        self.taken.push([x - MARK, y - MARK, x + MARK, y + MARK]);
    }

    /// Returns where the text of a point begins, at the line it stands on, and takes the place; `None` if
    /// there is none beside the point.
    pub fn find(&mut self, x: f64, y: f64, text: &str) -> Option<(f64, f64)> {
        let width = CHARACTER * text.chars().count() as f64;
        let free = places(x, y, width).into_iter().find(|place| self.is_free(place))?;
        self.taken.push(free);
        Some((free[0], free[3] - 2.5))
    }

    fn is_free(&self, place: &Box) -> bool {
        let [left, top, right, bottom] = *place;
        let inside =
            left >= self.area[0] && top >= self.area[1] && right <= self.area[2] && bottom <= self.area[3];
        inside && self.taken.iter().all(|t| right <= t[0] || left >= t[2] || bottom <= t[1] || top >= t[3])
    }
}

/// The places around a point, the best first: eight next to it, then six a line further off.
fn places(x: f64, y: f64, width: f64) -> [Box; 14] {
    let (right, left, middle) = (x + MARK + 1.0, x - MARK - 1.0 - width, x - width / 2.0);
    let (above, beside, below) = (y - MARK - LINE, y - LINE / 2.0, y + MARK);
    let (high, low) = (above - LINE, below + LINE);
    let near = [(right, beside), (middle, above), (middle, below), (left, beside)];
    let corners = [(right, above), (right, below), (left, above), (left, below)];
    let far = [(right, high), (left, high), (right, low), (left, low), (middle, high), (middle, low)];
    let mut all = near.into_iter().chain(corners).chain(far);
    std::array::from_fn(|_| {
        let (left, top) = all.next().unwrap_or((x, y));
        [left, top, left + width, top + LINE]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_do_not_meet() {
        let mut labels = Labels::within(0.0, 100.0, 0.0, 100.0);
        (0..3).for_each(|i| labels.occupy(50.0, 40.0 + 10.0 * f64::from(i)));
        for i in 0..3 {
            assert!(labels.find(50.0, 40.0 + 10.0 * f64::from(i), "1e-12").is_some());
        }
        let (texts, marks) = (&labels.taken[3..], &labels.taken[..3]);
        for (i, a) in texts.iter().enumerate() {
            let others = marks.iter().chain(&texts[..i]);
            assert!(others.into_iter().all(|b| a[2] <= b[0] || a[0] >= b[2] || a[3] <= b[1] || a[1] >= b[3]));
        }
        assert!(labels.find(99.0, 99.0, "a text that has no room anywhere").is_none());
    }
}
