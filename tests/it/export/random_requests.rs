//! Tables for random tolerances and ranges: within their bounds, in [0, 1], falling, NaN never.

use crate::certified::{exact, reference};
use crate::support::{cases, generator};
use proptest::prelude::Rng;
use restitution::End;
use restitution_export::{Beyond, ExportError, Listing, Request};
use rug::Float;

/// A number of [0, 1), random.
struct Draw(proptest::test_runner::TestRunner);

impl Draw {
    fn next(&mut self) -> f64 {
        f64::from(self.0.rng().next_u32()) / 2.0_f64.powi(32)
    }

    fn request(&mut self) -> (Request, End) {
        let end = if self.next() < 0.5 { End::ZeroCompression } else { End::ZeroForce };
        let low = if self.next() < 0.5 { 0.0 } else { 10.0 * self.next().powi(4) };
        let width = 1e-3 * 1e4_f64.powf(self.next());
        let beyond = if self.next() < 0.3 { Beyond::Law } else { Beyond::NotANumber };
        let tolerance = 10.0_f64.powf(-1.0 - 13.0 * self.next());
        (Request { tolerance, range: (low, low + width), beyond }, end)
    }
}

fn check(listing: &Listing, draw: &mut Draw) {
    let reference = reference(listing.end);
    let (low, high) = (listing.request.range.0, listing.last().min(1e15));
    let mut points = vec![low, listing.request.range.1, high];
    points.extend((0..200).map(|_| low + (high - low) * draw.next().powi(6)));
    points.extend((0..200).map(|_| low + (listing.request.range.1 - low) * draw.next()));
    points.extend(
        (0..listing.pieces.law_row as u64).map(|i| listing.pieces.grid.start(listing.pieces.first + i)),
    );
    for u in points.into_iter().filter(|u| (low..=high).contains(u)) {
        let (lost, kept) = exact(reference, u);
        let relative =
            |value: f64, exact: &Float| (Float::with_val(112, value - exact) / exact).to_f64().abs();
        let error = relative(listing.pieces.epsilon(u), &kept);
        assert!(error <= listing.pieces.bound.total(), "{:?}: {u:e} {error:e}", listing.request);
        if u > 1e-300 {
            let error = relative(listing.loss.at(&listing.pieces, u), &lost);
            assert!(error <= listing.loss.bound, "{:?}: {u:e} {error:e} of the loss", listing.request);
        }
        let mut last = listing.pieces.epsilon(u);
        let mut x = u;
        for step in [0.0, 0.0, 0.0, 1e-16, 1e-16, 1e-15, 1e-14] {
            x = x.next_up().max(x * (1.0 + step)).max(x + step);
            if x > listing.last() {
                break;
            }
            let value = listing.pieces.epsilon(x);
            assert!((0.0..=last).contains(&value), "{:?}: {x:e} {value:e} after {last:e}", listing.request);
            last = value;
        }
    }
}

#[test]
fn random_requests_keep_what_they_promise() {
    let mut draw = Draw(generator(17, 1));
    for _ in 0..cases(4) {
        let (request, end) = draw.request();
        match Listing::new(reference(end), request) {
            Ok(listing) => check(&listing, &mut draw),
            Err(ExportError::Tolerance { .. } | ExportError::Law { .. }) => {
                assert!(request.tolerance < 1e-13 && request.beyond == Beyond::Law, "{request:?} is refused");
            }
            Err(error) => panic!("{request:?}: {error}"),
        }
    }
}
