//! Certified direct integration against reference digits, closed forms and its own laws.

use num_rational::BigRational;
use restitution_direct::{Collision, DirectError, End, saturation_radius, saturation_speed};
use restitution_law::ForceLaw;
use restitution_real::Ball;

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

fn collision(law: &str, end: End) -> Collision {
    Collision::new(&law.parse().unwrap(), end).unwrap()
}

fn spheres() -> Collision {
    Collision::new(&ForceLaw::viscoelastic_spheres(), End::ZeroCompression).unwrap()
}

#[test]
fn reference_values_of_spheres() {
    // reference.json, 30 digits, from two methods that share no code with this one.
    for (n, d, digits) in [
        (1, 10, "0.892147587290229345269672993933"),
        (1, 2, "0.573824628664948983553510312776"),
        (1, 1, "0.331164810466640935279720797775"),
        (2, 1, "0.0953303653541515433824652515832"),
        (5, 1, "0.00165068207177331763895882089836"),
        (8, 1, "0.000157421316658559729504822417616"),
    ] {
        let epsilon = spheres().epsilon(&ratio(n, d), 30).unwrap();
        assert_eq!(epsilon.to_digits(30).as_deref(), Some(digits), "u = {n}/{d}");
    }
}

#[test]
fn delayed_recovery_of_spheres() {
    let delayed = collision("3/2,1/2", End::ZeroForce);
    for (n, d, digits) in [(1, 2, "0.5952515011"), (1, 1, "0.3939306032"), (2, 1, "0.2116460546")] {
        let epsilon = delayed.epsilon(&ratio(n, d), 10).unwrap();
        assert_eq!(epsilon.to_digits(10).as_deref(), Some(digits), "u = {n}/{d}");
    }
}

#[test]
fn constant_restitution_has_a_closed_form() {
    // gamma = (a-1)/2: linear dashpot, Tsuji, a = 2 and a = 5/2.
    for (a, gamma) in [
        (ratio(1, 1), ratio(0, 1)),
        (ratio(3, 2), ratio(1, 4)),
        (ratio(2, 1), ratio(1, 2)),
        (ratio(5, 2), ratio(3, 4)),
    ] {
        let law = ForceLaw::new(a.clone(), gamma).unwrap();
        let collision = Collision::new(&law, End::ZeroCompression).unwrap();
        for u in [ratio(1, 10), ratio(1, 1), ratio(19, 10)] {
            let epsilon = collision.epsilon(&u, 40).unwrap();
            assert_eq!(epsilon.to_digits(40), closed_form(&a, &u).to_digits(40), "{law} u = {u}");
        }
    }
}

/// `exp(-pi zeta/sqrt(1 - zeta^2))`, `zeta = (u/2) sqrt(2/(a+1))`.
fn closed_form(a: &BigRational, u: &BigRational) -> Ball {
    let zeta_squared = u * u / (ratio(2, 1) * (a + ratio(1, 1)));
    let tangent = Ball::from_rational(&(&zeta_squared / (ratio(1, 1) - &zeta_squared)), 250).sqrt();
    (-(Ball::pi(250) * tangent)).exp()
}

#[test]
fn a_linear_dashpot_ends_at_zero_force_as_known() {
    // [SP2007]: epsilon = exp(-(pi - angle) zeta/sqrt(1 - zeta^2)); at zeta = 1/sqrt(2) the angle is pi/2.
    let u = |prec| Ball::from_integer(2, prec).sqrt();
    let epsilon = collision("1,0", End::ZeroForce).epsilon_of(u, 40).unwrap();
    let expected = (-(Ball::pi(250).shifted(-1))).exp();
    assert_eq!(epsilon.to_digits(40), expected.to_digits(40));
}

#[test]
fn saturation_of_the_exit_speed() {
    let law = ForceLaw::viscoelastic_spheres();
    let radius = saturation_radius(&law, 27).unwrap();
    assert_eq!(radius.to_digits(27).as_deref(), Some("1.38836192561582941006822465"));
    let speed = saturation_speed(&law, 60).unwrap();
    assert_eq!(
        saturation_speed(&law, 27).unwrap().to_digits(27).as_deref(),
        Some("5.15838170426768521641430592")
    );
    // Beyond u = 60 nothing but the limit is left of 60 digits.
    let u = ratio(60, 1);
    let far = spheres().epsilon(&u, 60).unwrap() * Ball::from_rational(&u, 300).powi(5);
    assert!(far.overlaps(&speed) && far.relative_bits().unwrap() > 190);
}

#[test]
fn every_velocity_is_reached() {
    let tiny = spheres().epsilon(&ratio(1, 1_000_000_000_000), 30).unwrap();
    assert_eq!(tiny.to_digits(30).as_deref(), Some("0.999999999998846551141905509467"));
    for u in [20, 1000] {
        for end in [End::ZeroCompression, End::ZeroForce] {
            assert!(collision("3/2,1/2", end).epsilon(&ratio(u, 1), 30).unwrap().to_digits(30).is_some());
        }
    }
}

#[test]
fn restitution_falls_with_velocity() {
    for end in [End::ZeroCompression, End::ZeroForce] {
        let spheres = collision("3/2,1/2", end);
        let values: Vec<Ball> =
            (0..=60).map(|k| spheres.enclose(&Ball::from_ratio(k * k, 200, 110), 110).unwrap()).collect();
        for pair in values.windows(2) {
            assert!((&pair[0] - &pair[1]).is_positive());
        }
    }
}

#[test]
fn higher_precision_lies_inside() {
    for law in ["3/2,1/2", "2,1", "3/2,1/4", "7/5,1/3", "1,2"] {
        for u in [ratio(1, 7), ratio(4, 3)] {
            let collision = collision(law, End::ZeroCompression);
            let enclose = |prec| collision.enclose(&Ball::from_rational(&u, prec), prec).unwrap();
            let (coarse, fine) = (enclose(100), enclose(200));
            assert!(coarse.contains(&fine), "{law} u = {u}: {coarse:?} {fine:?}");
        }
    }
}

#[test]
fn a_wide_damping_gives_a_wide_enclosure() {
    let spheres = spheres();
    let wide = Ball::between(&rug::Float::with_val(128, 0.999), &rug::Float::with_val(128, 1.001), 128);
    let enclosure = spheres.enclose(&wide, 128).unwrap();
    for u in [ratio(999, 1000), ratio(1, 1), ratio(1001, 1000)] {
        let inside = spheres.epsilon(&u, 30).unwrap();
        assert!(enclosure.contains(&inside), "{u}: {enclosure:?} {inside:?}");
    }
}

#[test]
fn equivalent_laws_agree() {
    // Only (gamma+1)/(a+1) and u sqrt(((a+1)/2)^((a-2 gamma-1)/(a+1)))-like scales matter:
    // x^((a+1)/2) turns the law into one with a = 1.
    let u = ratio(3, 4);
    let spheres = spheres().epsilon(&u, 35).unwrap();
    let scale = |prec| {
        // a = 1, gamma' = p = 1/5: b = u ((a+1)/2)^(2 gamma'' ...) from dX/dt = sqrt((a+1)/2) x^((a-1)/2) v.
        let half_step = Ball::from_ratio(5, 4, prec);
        Ball::from_rational(&u, prec) * half_step.pow(&ratio(-2, 5))
    };
    let linear = collision("1,1/5", End::ZeroCompression).epsilon_of(scale, 35).unwrap();
    assert_eq!(spheres.to_digits(35), linear.to_digits(35));
}

#[test]
fn what_cannot_be_integrated_is_said() {
    let dashpot = collision("1,0", End::ZeroCompression);
    assert!(matches!(dashpot.epsilon(&ratio(2, 1), 10), Err(DirectError::Overdamped { .. })));
    let creeping = collision("3/2,-9/10", End::ZeroCompression);
    assert!(matches!(creeping.epsilon(&ratio(1, 10), 10), Err(DirectError::Overdamped { .. })));
    assert!(matches!(spheres().epsilon(&ratio(-1, 10), 10), Err(DirectError::Damping { .. })));
    let slow: ForceLaw = "1.001,0.001".parse().unwrap();
    assert!(matches!(saturation_radius(&slow, 10), Err(DirectError::SlowSaturation { .. })));
}

#[test]
fn the_series_and_the_integration_agree_at_small_damping() {
    use restitution_series::{Quantity, coefficients};
    // At u = 1/10 the terms fall by 1.39 * 10 each: 35 of them leave less than 10^-39.
    for (law, digits) in [("3/2,1/2", 36), ("2,1", 30)] {
        let c = coefficients(Quantity::Restitution, &law.parse().unwrap(), 35, 45).unwrap();
        let u = Ball::from_ratio(1, 10, 160);
        let sum = c.iter().rev().fold(Ball::from_integer(0, 160), |sum, c| sum * &u + c);
        let epsilon = collision(law, End::ZeroCompression).epsilon(&ratio(1, 10), 45).unwrap();
        assert_eq!(epsilon.to_digits(digits), sum.to_digits(digits), "{law}");
    }
}

#[test]
fn a_collision_run_backwards_undoes_itself() {
    // epsilon(u) epsilon(-u epsilon(u)^(1/5)) = 1, the second factor from the series (|argument| < 0.05).
    use restitution_series::{Quantity, coefficients};
    let c = coefficients(Quantity::Restitution, &ForceLaw::viscoelastic_spheres(), 24, 45).unwrap();
    let u = ratio(1, 20);
    let epsilon = spheres().epsilon(&u, 45).unwrap();
    let back = -(Ball::from_rational(&u, 160) * epsilon.fifth_root());
    let gained = c.iter().rev().fold(Ball::from_integer(0, 160), |sum, c| sum * &back + c);
    assert_eq!((epsilon * gained).to_digits(34), Ball::from_integer(1, 160).to_digits(34));
}

#[test]
fn the_zero_of_the_force_may_lie_close_to_zero_compression() {
    for (law, u, digits) in [
        ("3/4,3/5", "927/100000", "0.9930369983776973952171206808006"),
        ("3/4,7/10", "5511/20000", "0.8382645459062922465254040777216"),
        ("3/4,3/5", "667/20000", "0.975356332809872665330012928558"),
    ] {
        // Digits of a Taylor integrator in another program.
        let u: BigRational = u.parse().unwrap();
        let collision = collision(law, End::ZeroForce);
        for count in [20, 25, 30, 40, 60] {
            let epsilon = collision.epsilon(&u, count).unwrap().to_digits(count).unwrap();
            let same = digits.len().min(epsilon.len()) - 2;
            assert_eq!(epsilon[..same], digits[..same], "{law} u = {u} {count}");
        }
    }
}

#[test]
fn a_dashpot_of_any_damping_ends_at_zero_force_as_known() {
    // With X = x^((a+1)/2) every law with gamma = (a-1)/2 is X'' + 2 b X' + X = 0, and the force vanishes
    // where X = -2 b X'. Beyond critical damping, w = sqrt(b^2 - 1):
    // epsilon = exp(-(b/w) ln((b+w)/(b-w))), e^-2 at b = 1.
    for (law, critical) in [("1,0", ratio(2, 1)), ("7,3", ratio(4, 1)), ("7/18,-11/36", ratio(5, 3))] {
        let collision = collision(law, End::ZeroForce);
        for b in [ratio(1_000_001, 1_000_000), ratio(8, 5), ratio(50, 1)] {
            let epsilon = collision.epsilon(&(&b * &critical), 30).unwrap();
            let w = Ball::from_rational(&(&b * &b - ratio(1, 1)), 200).sqrt();
            let b = Ball::from_rational(&b, 200);
            let expected = (-(&b / &w * ((&b + &w) / (&b - &w)).ln())).exp();
            assert_eq!(epsilon.to_digits(30), expected.to_digits(30), "{law} b = {b:?}");
        }
        let at_critical = collision.epsilon(&critical, 30).unwrap();
        assert_eq!(at_critical.to_digits(30), Ball::from_integer(-2, 200).exp().to_digits(30), "{law}");
    }
}

#[test]
fn beyond_critical_damping_no_motion_need_be_followed() {
    // p < 0: steps would have to shrink without end. Where the motion is followed (u = 3) the answer is the same.
    let hard = collision("26/5,-1/2", End::ZeroCompression);
    for u in [ratio(3, 1), ratio(100, 1), ratio(18_448, 1), ratio(i64::MAX, 1)] {
        assert!(matches!(hard.epsilon(&u, 47), Err(DirectError::Overdamped { .. })), "{u}");
    }
    // p = 0: the barrier stands from the critical damping on, not before; a and gamma only scale it.
    for (law, critical) in [("1,0", ratio(2, 1)), ("7,3", ratio(4, 1)), ("7/18,-11/36", ratio(5, 3))] {
        let collision = collision(law, End::ZeroCompression);
        let at = |scale: BigRational| collision.enclose(&Ball::from_rational(&(&critical * scale), 200), 100);
        assert!(matches!(at(ratio(1_000_001, 1_000_000)), Err(DirectError::Overdamped { .. })), "{law}");
        let below = at(ratio(19, 20));
        assert!(below.as_ref().is_ok_and(Ball::is_positive), "{law}: {below:?}");
    }
}

#[test]
fn critical_damping_is_decided_exactly() {
    let tiny = BigRational::new(1.into(), num_bigint::BigInt::from(10).pow(30));
    for (law, critical) in [("1,0", ratio(2, 1)), ("7/18,-11/36", ratio(5, 3))] {
        let collision = collision(law, End::ZeroCompression);
        for u in [critical.clone(), &critical + &tiny, ratio(100, 1)] {
            assert!(matches!(collision.epsilon(&u, 20), Err(DirectError::Overdamped { .. })), "{law} {u}");
        }
        // zeta = 1 - delta: epsilon = exp(-pi zeta/sqrt(1 - zeta^2)), about exp(-pi/sqrt(2 delta)).
        let below = &critical - &tiny;
        assert!(matches!(collision.epsilon(&below, 20), Err(DirectError::Vanishing { .. })), "{law}");
        let near = &critical * ratio(999_999_999, 1_000_000_000);
        assert_eq!(collision.epsilon(&near, 9).unwrap().to_digits(9).unwrap(), "4.14268627e-30509", "{law}");
        let lost = collision.one_minus_epsilon(&(critical - &tiny), 20).unwrap();
        assert_eq!(lost.to_digits(20).as_deref(), Some("1.0000000000000000000"));
    }
}

#[test]
fn the_integration_meets_the_closed_form_up_to_critical_damping() {
    // `epsilon` takes the closed form where zeta^2 > 15/16; `enclose` always integrates.
    let dashpot = collision("1,0", End::ZeroCompression);
    for u in [ratio(31, 16), ratio(63, 32), ratio(199, 100)] {
        let integrated = dashpot.enclose(&Ball::from_rational(&u, 300), 300).unwrap();
        assert!(integrated.overlaps(&dashpot.epsilon(&u, 60).unwrap()), "{u}");
        assert!(integrated.relative_bits().unwrap() > 200, "{u}: {integrated:?}");
    }
}
