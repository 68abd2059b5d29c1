//! What is proved on some intervals, to six digits: a bound that moves fails here, and whoever changes it says why the new one is
//! sound. Further digits of an interpolant's remainder are those of the steps that were taken.

use super::*;
use restitution::tiers;

/// The interval that holds `u`.
fn at(end: End, u: f64) -> Group {
    groups(end).into_iter().find(|group| group.low() <= u && u < group.high()).unwrap()
}

fn is_near(found: f64, figure: f64) -> bool {
    (found - figure).abs() <= 1e-6 * figure
}

/// The bounds with the parts in which they are reached: of epsilon, of what is lost, of a velocity, of the forms alone.
fn is(found: Proof, figures: [(f64, f64); 4]) {
    let own = [found.epsilon, found.one_minus_epsilon, found.of_velocity, found.approximation];
    for (k, (own, (bound, at))) in own.into_iter().zip(figures).enumerate() {
        assert!(is_near(own.bound, bound) && is_near(own.at, at), "{k}: {own:?}, not {bound} at {at}");
    }
}

#[test]
fn of_pieces_at_zero_compression() {
    is(
        at(End::ZeroCompression, 1.2).prove().unwrap(),
        [
            (0.8633956801698894, 1.1562498828124979),
            (0.9906751550574384, 1.218749876562498),
            (2.252778342653021, 1.2451172343750008),
            (8.231093216642408e-19, 1.2021485427734393),
        ],
    );
    is(
        at(End::ZeroCompression, 0.3).prove().unwrap(),
        [
            (0.8328819214077472, 0.29687496953124815),
            (0.892028057036041, 0.28906247031249815),
            (1.56035186738616, 0.29687496953124815),
            (2.6629723124253186e-19, 0.30419924541015786),
        ],
    );
}

#[test]
fn of_pieces_at_zero_force() {
    is(
        at(End::ZeroForce, 1.2).prove().unwrap(),
        [
            (0.9749869608219519, 1.2167967517578104),
            (0.9917535716974626, 1.2324217501953105),
            (1.2186505662506155, 1.2167967517578104),
            (3.242486887378029e-19, 1.2314454203369158),
        ],
    );
    is(
        at(End::ZeroForce, 0.02).prove().unwrap(),
        [
            (0.9792499350390987, 0.02049255550537265),
            (1.6675631748530357, 0.023193359375),
            (1.305637825850014, 0.02026366982421697),
            (1.3375179387695398e-20, 0.02024841485901035),
        ],
    );
}

#[test]
fn of_the_forms_near_zero() {
    is(
        at(End::ZeroCompression, 1e-4).prove().unwrap(),
        [
            (0.9366853360477241, 6.103515625e-5),
            (2.371646561132183, 0.000102996826171875),
            (1.9388703933802744, 6.103515625e-5),
            (3.286315675293648e-21, 0.000118255615234375),
        ],
    );
    is(
        at(End::ZeroForce, 1e-5).prove().unwrap(),
        [
            (0.7317009176582808, 7.62939453125e-6),
            (2.3663162878431545, 1.2874603271484375e-5),
            (1.065040469659336, 7.62939453125e-6),
            (1.7851594950963028e-17, 1.4781951904296875e-5),
        ],
    );
}

#[test]
fn of_the_pieces_from_8_on() {
    is(
        saturated().unwrap(),
        [
            (1.388910354172937, 408.8750357875001),
            (0.5001020965392935, 7.999999193749996),
            (2.9932072836821355, 408.25001022500004),
            (3.239624966944867e-18, 518.9999476999999),
        ],
    );
}

#[test]
fn of_tiers() {
    let (compression, force) = (at(End::ZeroCompression, 1.2), at(End::ZeroForce, 0.02));
    // A tier has no row at the other end of contact.
    assert_eq!(compression.prove_tier(&tiers::ZERO_FORCE_1E6).unwrap(), 0.0);
    for (found, figure) in [
        (compression.prove_tier(&tiers::ZERO_COMPRESSION_1E3).unwrap(), 0.00048278029904339295),
        (compression.prove_tier(&tiers::ZERO_COMPRESSION_1E9).unwrap(), 4.568330160354181e-13),
        (force.prove_tier(&tiers::ZERO_FORCE_1E6).unwrap(), 4.90427680740471e-7),
        (tier_near_zero(&tiers::ZERO_COMPRESSION_1E3), 1.135937756392223e-15),
        (tier_near_zero(&tiers::ZERO_FORCE_1E9), 1.4248851659875412e-16),
    ] {
        assert!(is_near(found, figure), "{found}, not {figure}");
    }
}

/// Groups follow each other without a gap, down to where the first term is enough.
#[test]
fn intervals_cover_everything() {
    for (end, last) in [(End::ZeroCompression, 8.0), (End::ZeroForce, f64::INFINITY)] {
        let all = groups(end);
        assert_eq!(all[0].low(), 2f64.powi(-60));
        assert!(all.windows(2).all(|two| two[0].high() == two[1].low() && two[0].low() < two[0].high()));
        let table = forms::table(end).map(|form| form.high).fold(0.0, f64::max);
        assert_eq!(all.last().unwrap().high(), table.min(last), "{end:?}");
    }
}

#[test]
fn what_a_place_and_a_distance_are_off_by() {
    let form = forms::table(End::ZeroCompression).find(|form| form.high > 1.2).unwrap();
    assert_eq!(margin(&form), (form.high + 8.0) * f64::EPSILON + form.high * 1e-7);
    let half = 2f64.powi(-53);
    assert_eq!(error_of_root(-1.5, 300.0), 2.0 * half + half + 0.02 * 300.0 * half);
    assert_eq!(error_of_root(0.75, 0.0), half);
    assert_eq!([End::ZeroCompression, End::ZeroForce].map(error_of_product), [half, half / 3.0]);
    let parts: Vec<_> = parts(1.0, 3.0, 2.5, |t| t).collect();
    assert_eq!(parts.len(), 16);
    for (k, (at, t)) in parts.into_iter().enumerate() {
        let (from, to) = (1.0 + k as f64 / 8.0, 1.0 + (k + 1) as f64 / 8.0);
        let (low, high) = ((from.next_down() - 2.5).next_down(), (to.next_up() - 2.5).next_up());
        let error = low.next_up().abs().max(high.next_down().abs());
        assert_eq!(at, from);
        let expected = format!("{:?}", Rounded::new(low, high, error));
        assert_eq!(format!("{t:?}"), expected);
    }
    let (a, b) = (Worst { bound: 1.0, at: 2.0 }, Worst { bound: 3.0, at: 4.0 });
    assert_eq!((a.or(3.0, 4.0), b.or(1.0, 2.0), a.or(1.0, 7.0)), (b, b, a));
    let mixed = Proof { epsilon: a, one_minus_epsilon: b, of_velocity: a, approximation: b };
    let other = Proof { epsilon: b, one_minus_epsilon: a, of_velocity: b, approximation: a };
    assert_eq!(
        mixed.and(other),
        Proof { epsilon: b, one_minus_epsilon: b, of_velocity: b, approximation: b }
    );
}

#[test]
fn pieces_answer_for_arguments_that_may_be_taken_for_theirs() {
    let form = forms::table(End::ZeroForce).find(|form| form.high > 1.2).unwrap();
    let off = margin(&form);
    for (low, high, own) in [
        (form.high, 9.0, true),
        (form.high + off / 2.0, 9.0, true),
        (form.high + off, 9.0, false),
        (0.0, form.low, false),
        (0.0, form.low.next_up(), true),
    ] {
        assert_eq!(meets(&form, low, high), own, "{low} {high}");
    }
    for (end, near) in [(End::ZeroCompression, 0.03125), (End::ZeroForce, 0.0625)] {
        let form = forms::table(end).find(|form| form.high > near).unwrap();
        let to = |u: f64| Rounded::new(-1.0, u - form.centre, 0.0);
        let given = [near * 0.9, near * 0.999, near, near * 1.1].map(|u| gives_loss(&form, to(u), end));
        assert_eq!(given, [false, false, true, true], "{end:?}");
    }
}

#[test]
fn the_power_law_is_compared_from_before_its_first_piece() {
    for form in forms::table(End::ZeroCompression).filter(|form| form.low >= SATURATED) {
        assert!(saturated_from() < form.low - margin(&form), "{}", form.low);
    }
    assert!(saturated_from() > SATURATED * 0.999_999 && saturated_from() < SATURATED);
    assert_eq!(missed_beyond(3e-9, 1e-9, 2.0), 4e-9 / 32.0 * (1.0 + 1e-14));
}
