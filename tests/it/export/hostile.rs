//! Exported sources under hostile arguments and hostile flags: nothing is read out of bounds, NaN stays NaN, `epsilon`
//! lies in [0, 1] and never rises.

use super::drivers::{DRIVERS, Driver};
use super::{listings, values};
use crate::support::{cases, generator};
use proptest::prelude::Rng;
use restitution_export::Listing;

/// Neighbours that are looked at on each side of a point.
const NEIGHBOURS: i32 = 3;

/// Arguments in rising order, the ones that are none first.
fn arguments(listing: &Listing) -> Vec<f64> {
    let mut random = generator(14, 1);
    let mut bits = || u64::from(random.rng().next_u32()) << 32 | u64::from(random.rng().next_u32());
    let (pieces, last) = (&listing.pieces, listing.last().min(f64::MAX));
    let nothing =
        [f64::NAN, -f64::NAN, f64::from_bits(0x7ff0_0000_0000_0001), -1.0, -5e-324, f64::NEG_INFINITY];
    let mut points =
        vec![0.0, 5e-324, 2.5e-308, 1e-300, 1e-17, 1e10, 1e200, f64::MAX, listing.request.range.0, last];
    points.extend((0..pieces.law_row as u64).map(|i| pieces.grid.start(pieces.first + i)));
    points.extend((0..12).map(|i| pieces.law.map_or(1.0, |law| law.from) * 2.0_f64.powi(i)));
    points.extend((0..cases(300)).map(|_| f64::from_bits(bits() >> 1)).filter(|u| u.is_finite()));
    points.extend((0..cases(300)).map(|_| (bits() >> 11) as f64 / (1_u64 << 53) as f64 * last.min(100.0)));
    let neighbours = |u: &f64| {
        let u = u.to_bits() as i64;
        (-NEIGHBOURS..=NEIGHBOURS).map(move |i| f64::from_bits((u + i64::from(i)).max(0) as u64))
    };
    let mut all: Vec<f64> = points.iter().flat_map(neighbours).filter(|u| !u.is_nan()).collect();
    all.push(f64::INFINITY);
    all.sort_by(f64::total_cmp);
    all.dedup();
    nothing.into_iter().chain([-0.0]).chain(all).collect()
}

fn withstands(driver: &Driver) {
    for listing in &listings()[..2] {
        let arguments = arguments(listing);
        for flags in driver.hostile {
            let Some(values) = values(driver, listing, flags, &arguments) else { return };
            check(driver, listing, &arguments, &values);
        }
    }
}

fn check(driver: &Driver, listing: &Listing, arguments: &[f64], values: &[super::Values]) {
    let (low, high) = (listing.request.range.0, listing.last());
    let mut last = 1.0;
    for (u, [epsilon, loss, slope]) in arguments.iter().zip(values) {
        let place = format!("{}: {u:e} ({:016x}) gives {epsilon:e}", driver.test, u.to_bits());
        if !(low..=high).contains(u) {
            assert!(epsilon.is_nan() && loss.is_nan() && slope.is_nan(), "{place} {loss:e} {slope:e}");
            continue;
        }
        assert!(*epsilon <= last && *epsilon >= 0.0, "{place} after {last:e}");
        assert!((epsilon + loss - 1.0).abs() <= 2.0 * listing.request.tolerance, "{place}, lost {loss:e}");
        assert!(*slope <= 0.0, "{place}, slope {slope:e}");
        let ours = listing.pieces.epsilon(*u);
        assert!(
            (epsilon - ours).abs() <= 4.0 * f64::EPSILON * ours + f64::MIN_POSITIVE,
            "{place}, not {ours:e}"
        );
        assert!(*u > 0.0 || *epsilon == 1.0, "{place}");
        last = *epsilon;
    }
}

macro_rules! in_every_language {
    ($($language:ident)*) => {
        $(#[test]
        fn $language() {
            withstands(DRIVERS.iter().find(|driver| driver.test == stringify!($language)).unwrap());
        })*
    };
}
in_every_language!(rust c cpp fortran python numpy matlab);
