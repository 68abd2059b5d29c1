//! The cheaper tiers, proved like the table.

use super::cover::LEAST;
use super::rounded::{Rounded, half_unit};
use super::{Group, PARTS, Span};
use restitution::forms::Number;
use restitution::tiers::Tier;
use restitution_direct::DirectError;

/// Intervals of a row, each with its own polynomial: the sum that bounds its difference is close to the largest only on a narrow one.
const SPANS: u32 = 16;

impl Group {
    /// Proves a tier in this interval: the largest error relative to `epsilon`; 0 if the tier has no row here.
    ///
    /// # Errors
    ///
    /// A [`DirectError`] if there is no interpolant.
    pub fn prove_tier<const ROWS: usize, const WIDTH: usize>(
        &self,
        tier: &Tier<ROWS, WIDTH>,
    ) -> Result<f64, DirectError> {
        let own: Vec<_> = (0..ROWS)
            .map(|row| {
                let (low, high) = reach(tier.ends(row), tier.shift());
                (row, low.max(self.low()), high.min(self.high()).min(tier.far()))
            })
            .filter(|(_, low, high)| low < high)
            .flat_map(|(row, low, high)| {
                let at = move |part: u32| low + (high - low) * (f64::from(part) / f64::from(SPANS));
                (0..SPANS).map(move |part| (row, at(part), at(part + 1)))
            })
            .collect();
        if tier.end() != self.end() || own.is_empty() {
            return Ok(0.0);
        }
        let interpolant = self.interpolant()?;
        let errors = own.into_iter().map(|(row, low, high)| {
            let span = Span::new(interpolant, low.next_down(), high.next_up());
            largest(&span, tier, row, low, high)
        });
        Ok(errors.fold(0.0, worse))
    }
}

/// The largest error of a tier relative to `epsilon` below the intervals of all groups, where `1 - epsilon` is at most `1.16 u`.
pub fn tier_near_zero<const ROWS: usize, const WIDTH: usize>(tier: &Tier<ROWS, WIDTH>) -> f64 {
    let high = f64::from(-LEAST).exp2();
    largest(&Span::of_nothing_lost(high, 1.16 * high), tier, 0, 0.0, high)
}

/// From where to where arguments may be taken for those of a row: a place that is rounded may belong to the row beside.
fn reach((low, high): (f64, f64), shift: f64) -> (f64, f64) {
    let margin = half_unit(high + shift);
    (low - margin, high + margin)
}

/// Distances from the end of a row in its widths, from `least` to `most`, which are off by a part `place` of it.
fn distances(least: f64, most: f64, place: f64) -> Rounded {
    Rounded::new(least.next_down() - place, most.next_up() + place, place)
}

/// The largest error of a row relative to `epsilon`, approximation and roundings.
fn largest<const ROWS: usize, const WIDTH: usize>(
    span: &Span,
    tier: &Tier<ROWS, WIDTH>,
    row: usize,
    low: f64,
    high: f64,
) -> f64 {
    let (start, end) = tier.ends(row);
    let width = end - start;
    let of = |x: f64| span.u.of(x);
    let distance = of(end).plus(&span.u.clone().negated()) * of(1.0 / width);
    let (_, missed) = span.missed(&tier.form(row, distance));
    let place = half_unit(end + tier.shift()) / width;
    (0..PARTS).fold(0.0, |worst, part| {
        let at = |part: u32| low + (high - low) * (f64::from(part) / f64::from(PARTS));
        let (least, most) = ((end - at(part + 1)) / width, (end - at(part)) / width);
        let rounded = tier.form(row, distances(least, most, place));
        worse(worst, rounded.relative(missed))
    })
}

/// The larger of two errors; one that is no number proves nothing.
fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::INFINITY } else { a.max(b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_reach_as_far_as_rounded_places() {
        let half = 2f64.powi(-53);
        assert_eq!(reach((1.0, 1.5), 0.25), (1.0 - half, 1.5 + half));
        let found = format!("{:?}", distances(0.25, 0.5, 1e-9));
        let expected = Rounded::new(0.25f64.next_down() - 1e-9, 0.5f64.next_up() + 1e-9, 1e-9);
        assert_eq!(found, format!("{expected:?}"));
        assert_eq!(
            [(1.0, f64::NAN), (f64::NAN, 1.0), (2.0, 3.0)].map(|(a, b)| worse(a, b)),
            [f64::INFINITY, f64::INFINITY, 3.0]
        );
    }
}
