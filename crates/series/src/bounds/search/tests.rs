use super::*;
use crate::{TailBound, TurningPointSum};

/// Rates are chosen from many that are proved: the choice is no part of a proof, but decides how good it is.
#[test]
fn rates_are_as_good_as_they_were() {
    let expected = [
        ("3/2,1/2", 0, "41 terms, 9 rates, 5.187358, 2^-243.679"),
        ("3/2,1/2", 4, "41 terms, 54 rates, 5.187358, 2^-228.792"),
        ("7/3,5/6", 2, "41 terms, 48 rates, 5.101870, 2^-217.248"),
        ("1,0", 3, "41 terms, 54 rates, 3.732132, 2^-304.776"),
        ("10,9", 1, "81 terms, 42 rates, 1.492229, 2^-45.620"),
        ("5/4,-1/4", 2, "41 terms, 54 rates, 4.399989, 2^-210.078"),
    ];
    for (text, order, expected) in expected {
        let law: ForceLaw = text.parse().unwrap();
        let (head, rates) = rates(&CLOSE, &law, order).unwrap();
        let bound = TailBound::find(&law, order).unwrap();
        let tail = bound.tail_at_turning_point(TurningPointSum::Velocity, order, 100).to_f64();
        let ratio = bound.ratio();
        let (terms, count) = (head.terms.iter().filter(|t| t.damping_order == 0).count(), rates.len());
        let found = format!("{terms} terms, {count} rates, {ratio:.6}, 2^{:.3}", tail.log2());
        assert_eq!(found, expected, "{text} {order}");
    }
}

/// A rough bound is as good but for some bits, from fewer rates.
#[test]
fn rough_bounds_are_close() {
    for (text, order, expected) in
        [("3/2,1/2", 4, "17 terms, 15 rates, 4.756828"), ("10,9", 1, "41 terms, 12 rates, 1.438905")]
    {
        let law: ForceLaw = text.parse().unwrap();
        let bound = TailBound::find_rough(&law, order).unwrap();
        let (head, rates) = rates(&ROUGH, &law, order).unwrap();
        let terms = head.terms.iter().filter(|t| t.damping_order == 0).count();
        let found = format!("{terms} terms, {} rates, {:.6}", rates.len(), bound.ratio());
        assert_eq!(found, expected, "{text} {order}");
    }
}

#[test]
fn the_largest_damping_is_found() {
    for (text, order) in [("3/2,1/2", 4), ("1,0", 2), ("7/3,5/6", 2)] {
        let law: ForceLaw = text.parse().unwrap();
        let head = Head::new(&law, order, 40);
        let majorant = Majorant::new(&law, &head);
        let ratio = (0.6 * log_singular_ratio(&law)).exp();
        let found = largest_damping(&majorant, ratio).unwrap();
        assert!(majorant.decay(ratio, found).is_some(), "{text}");
        assert!(majorant.decay(ratio, 1.04 * found).is_none(), "{text}: {found}");
        // None where not even order 0 is bounded.
        assert!(largest_damping(&majorant, 1.5 * log_singular_ratio(&law).exp()).is_none());
    }
}

/// A rate beyond the singularity is never proved; a head is taken for the rates that cover every order.
#[test]
fn rates_cover_every_order() {
    for (text, order) in [("3/2,1/2", 3), ("3/2,1/2", 0), ("9,8", 2)] {
        let law: ForceLaw = text.parse().unwrap();
        let log_ratio = log_singular_ratio(&law);
        let head = Head::new(&law, order, 40);
        let (rates, depth) = CLOSE.rates_of_head(&law, &head, order, log_ratio);
        let ratios = rates.iter().filter(|rate| rate.covers(order)).map(Decay::ratio);
        let largest = ratios.fold(0.0, f64::max);
        assert!(largest > 1.0 && (largest.ln() / log_ratio - depth).abs() < 1e-9, "{text} {largest} {depth}");
        let (without, with): (Vec<_>, Vec<_>) = rates.iter().partition(|rate| !rate.covers(1));
        assert_eq!(with.is_empty(), order == 0, "{text}");
        assert!(!without.is_empty(), "{text}");
        // Where the ratio asked for is at most 1, nothing is.
        assert_eq!(CLOSE.rates_of_head(&law, &head, order, -1.0).1.to_bits(), 0f64.to_bits());
        assert!(CLOSE.rates_of_head(&law, &head, order, -1.0).0.is_empty());
        let (none, depth) = CLOSE.rates_of_head(&law, &head, order, 20.0 * log_ratio);
        assert!(none.is_empty() && depth == 0.0, "{text}");
    }
}

/// Proposition 2 of `docs/error-bounds.md`: `min(2, 1/cos(pi/(a+1)))^(a+1)`.
#[test]
fn the_nearest_singularity_is_that_of_the_document() {
    for (text, ratio) in [
        ("3/2,1/2", 2f64.powf(2.5)),
        ("1/2,1/2", 2f64.powf(1.5)),
        ("1,0", 4.0),
        ("2,1", 8.0),
        ("3,2", 4.0),
        ("5,4", (4.0f64 / 3.0).powi(3)),
    ] {
        let found = log_singular_ratio(&text.parse().unwrap()).exp();
        assert!((found / ratio - 1.0).abs() < 1e-12, "{text}: {found}");
    }
}

#[test]
fn laws_whose_series_barely_reach_the_turning_point_are_refused() {
    let law: ForceLaw = "100000,1".parse().unwrap();
    for search in [CLOSE, ROUGH] {
        let refused = rates(&search, &law, 0).map(|_| ());
        let Err(BoundError::TurningPointNotReached { law: told, terms }) = refused else {
            panic!("a rate is proved");
        };
        assert_eq!((told.as_str(), terms), (law.to_string().as_str(), 320));
    }
}
