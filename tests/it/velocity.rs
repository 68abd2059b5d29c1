//! From a velocity: the fifth root and the coefficient.

use crate::certified::{PREC, exact, reference, ulps};
use proptest::prelude::Rng;
use restitution::{Contact, End, Restitution, ViscoelasticContact, bounds, fifth_root};
use rug::Float;

const POINTS: i32 = 60_000;

#[test]
fn the_fifth_root_is_within_its_bound() {
    let mut worst = 0.0_f64;
    for i in 0..POINTS {
        let spread = if i % 2 == 0 { 600.0 } else { 1.6 };
        let x = 10.0_f64.powf((f64::from(i) / f64::from(POINTS) - 0.5) * spread);
        worst = worst.max(ulps(fifth_root(x), &Float::with_val(PREC, x).root(5)));
        assert_eq!(fifth_root(-x), -fifth_root(x));
    }
    println!("fifth root: {worst:.3} ulp");
    assert!(worst <= bounds::FIFTH_ROOT.size);
}

#[test]
fn unusual_arguments_of_the_fifth_root() {
    for x in [0.0, -0.0, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(fifth_root(x).to_bits(), x.to_bits());
    }
    for x in [5e-324, 1e-310, f64::MIN_POSITIVE, f64::MAX, 1.0, 32.0, 1.0_f64.next_down(), 32.0_f64.next_up()]
    {
        assert!(ulps(fifth_root(x), &Float::with_val(PREC, x).root(5)) <= bounds::FIFTH_ROOT.size, "{x:e}");
    }
}

#[test]
fn the_coefficient_at_a_velocity_is_within_its_bound() {
    for end in [End::ZeroCompression, End::ZeroForce] {
        let law = Restitution::from_u_at_unit_velocity(1.0, end); // exactly u^5 = g
        let mut worst = 0.0_f64;
        for i in 0..POINTS {
            let g = 10.0_f64.powf(f64::from(i) / f64::from(POINTS) * 52.0 - 40.0);
            let u = Float::with_val(PREC, g).root(5);
            worst = worst.max(ulps(law.epsilon(g), &reference(end).epsilon(&u)));
        }
        println!("{end:?} from a velocity: {worst:.3} ulp");
        assert!(worst <= bounds::EPSILON_OF_VELOCITY.size);
    }
}

#[test]
fn g_star_is_where_the_first_order_takes_all() {
    for end in [End::ZeroCompression, End::ZeroForce] {
        let law = Restitution::from_g_star(0.0032, end);
        let u = 1.0 / 1.153_448_858_095_288_8;
        assert!((law.u(0.0032) / u - 1.0).abs() <= 4.0 * f64::EPSILON);
        assert!((law.velocity(u) / 0.0032 - 1.0).abs() <= 16.0 * f64::EPSILON);
        let (lost, kept) = exact(reference(end), u);
        assert!((law.epsilon(0.0032) / kept.to_f64() - 1.0).abs() <= 8.0 * f64::EPSILON);
        assert!((law.one_minus_epsilon(0.0032) / lost.to_f64() - 1.0).abs() <= 8.0 * f64::EPSILON);
        assert_eq!((law.epsilon(0.0), law.epsilon(f64::INFINITY)), (1.0, 0.0));
        assert!(law.epsilon(-1e-9).is_nan() && law.epsilon(f64::NAN).is_nan());
    }
}

/// Two ways to the same law: with a contact in between, whose `A` is one f64, and without. What differs is the fifth
/// root, 2 units of 2^-53, and six roundings, five times each, and ten in the two powers: 50 of those units.
#[test]
fn a_characteristic_velocity_means_the_same_with_and_without_a_contact() {
    let mut random = crate::support::generator(12, 1);
    let mut worst = 0.0_f64;
    for _ in 0..crate::support::cases(20_000) {
        let mut by_ratio = |low: f64, high: f64| {
            let spread = f64::from(random.rng().next_u32()) / f64::from(u32::MAX);
            low * (high / low).powf(spread)
        };
        let (radius, mass, modulus) = (by_ratio(1e-6, 1.0), by_ratio(1e-12, 1e3), by_ratio(1e5, 1e12));
        let g_star = by_ratio(1e-9, 1e3);
        let contact = Contact::new(radius, mass, modulus).unwrap();
        let pair = ViscoelasticContact::from_characteristic_velocity(contact, g_star).unwrap();
        let (with, without) =
            (pair.restitution(End::ZeroForce), Restitution::from_g_star(g_star, End::ZeroForce));
        let scale = with.velocity(1.0) / without.velocity(1.0);
        worst = worst.max((scale - 1.0).abs() / f64::EPSILON);
    }
    println!("with and without a contact: velocities differ by {worst:.1} units of 2^-52");
    assert!(worst <= 25.0);
}
