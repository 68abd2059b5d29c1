use super::*;
use restitution_real::Magnitude;

/// A ball with a centre and a radius.
fn wide(mid: f64, rad: f64) -> Ball {
    Ball::new(Ball::from_f64(mid, 64).mid().clone(), &Magnitude::exact(rad).to_float())
}

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

fn ball(x: &BigRational) -> Ball {
    Ball::from_rational(x, 128)
}

/// `1 + x (1 - x)`, of which `x (1 - x)` is the error beside the constant 1.
fn hill() -> RationalFunction<Balls> {
    let numbers = [1, 1, -1].map(|n| Ball::from_integer(n, 128)).to_vec();
    RationalFunction::new(&Balls::new(128), numbers, vec![Ball::from_integer(1, 128)]).unwrap()
}

fn one(x: &BigRational) -> Result<Sample, PadeError> {
    Ok(Sample { x: ball(x), value: Ball::from_integer(1, 128) })
}

#[test]
fn grids_are_denser_at_the_ends() {
    let found = grid(&ratio(1, 1), &ratio(3, 1), 4).unwrap();
    assert_eq!(found, [ratio(1, 1), ratio(21, 16), ratio(2, 1), ratio(43, 16), ratio(3, 1)]);
    let found = grid(&ratio(0, 1), &ratio(27, 1), 3).unwrap();
    assert_eq!(found, [0, 7, 20, 27].map(|n| ratio(n, 1)));
    assert_eq!(grid(&ratio(0, 1), &ratio(5, 1), 0).unwrap(), [ratio(0, 1), ratio(5, 1)]);
    for (low, high) in [(-1, 3), (2, 2), (3, 2), (0, 0)] {
        let empty = grid(&ratio(low, 1), &ratio(high, 1), 4);
        assert!(matches!(empty, Err(PadeError::EmptyRange { .. })), "{low} {high}");
    }
}

#[test]
fn errors_are_relative() {
    // 1 + x (1 - x) at 1/2 is 5/4.
    for (value, error) in [((1, 1), (1, 4)), ((5, 2), (1, 2)), ((-5, 1), (5, 4)), ((5, 4), (0, 1))] {
        let sample = Sample { x: ball(&ratio(1, 2)), value: ball(&ratio(value.0, value.1)) };
        let found = relative_error(&hill(), &sample).unwrap();
        assert!(found.contains(&ball(&ratio(error.0, error.1))), "{value:?}: {found:?}");
        assert!(found.rad().to_f64() < 1e-30);
    }
    // What is not known of the value is in the error.
    let value = wide(1.0, 0.125);
    let found = relative_error(&hill(), &Sample { x: ball(&ratio(1, 2)), value }).unwrap();
    for value in [(7, 8), (1, 1), (9, 8)] {
        let exact = ratio(5, 4) / ratio(value.0, value.1) - ratio(1, 1);
        assert!(found.contains(&ball(&exact)), "{value:?}");
    }
}

#[test]
fn points_around_a_point_reach_to_its_neighbours() {
    let points = [0, 1, 3, 7].map(|n| ratio(n, 1));
    for (at, low, high) in [(3, 1, 7), (1, 0, 3), (0, 0, 1), (7, 3, 7)] {
        let expected: Vec<BigRational> = (0..=12).map(|i| ratio(low * 12 + (high - low) * i, 12)).collect();
        assert_eq!(around(&points, &ratio(at, 1)), expected, "{at}");
    }
}

/// The search written out for an error that is known everywhere.
#[test]
fn the_largest_error_is_looked_for_twice_more_closely() {
    let exact = |x: &BigRational| x * (ratio(1, 1) - x);
    for intervals in [1, 2, 3, 7, 10] {
        let first = grid(&ratio(0, 1), &ratio(1, 1), intervals).unwrap();
        let found = largest_error(&hill(), &first, one).unwrap();
        let (mut points, mut worst) = (first, None::<BigRational>);
        for _ in 0..3 {
            for x in &points {
                if worst.as_ref().is_none_or(|at| exact(x) > exact(at)) {
                    worst = Some(x.clone());
                }
            }
            points = around(&points, worst.as_ref().unwrap());
        }
        let at = worst.unwrap();
        assert!(found.error.contains(&ball(&exact(&at))), "{intervals}");
        assert!((exact(&found.at) - exact(&at)) == ratio(0, 1), "{intervals}: {} for {at}", found.at);
    }
    assert!(matches!(largest_error(&hill(), &[], one), Err(PadeError::EmptyRange { .. })));
    let fails = |_: &BigRational| Err(PadeError::PoleAtZero);
    assert!(matches!(largest_error(&hill(), &[ratio(1, 2)], fails), Err(PadeError::PoleAtZero)));
}

/// `x (1 - x)` reaches 3/16 at 1/4, and 1/4, nowhere exceeded, at 1/2.
#[test]
fn errors_stay_below_a_level_up_to_where_they_reach_it() {
    let points = grid(&ratio(0, 1), &ratio(1, 2), 7).unwrap();
    let reach = |level: BigRational| largest_reach(&hill(), &points, &level, one).unwrap();
    assert_eq!(reach(ratio(1, 4)), Reach::Everywhere);
    assert_eq!(reach(ratio(1, 3)), Reach::Everywhere);
    let Reach::UpTo(found) = reach(ratio(3, 16)) else { panic!("the level is passed") };
    assert!(found <= ratio(1, 4) && found > ratio(1, 4) - ratio(1, 4096), "{found}");
    // From the last point of the grid that is good, in twelve halvings.
    let bad = points.iter().position(|x| *x > ratio(1, 4)).unwrap();
    let step = (&points[bad] - &points[bad - 1]) / ratio(4096, 1);
    let steps = (&found - &points[bad - 1]) / &step;
    assert!(steps.is_integer() && &found + &step > ratio(1, 4), "{steps}");
    // A level that may be passed is as good as passed.
    let open = |x: &BigRational| {
        let value = wide(1.0, 1e-3);
        Ok::<_, PadeError>(Sample { x: ball(x), value })
    };
    assert!(matches!(largest_reach(&hill(), &points, &ratio(1, 4), open), Ok(Reach::UpTo(_))));
    let nothing = largest_reach(&hill(), &points, &ratio(1, 10_000), open).unwrap();
    assert_eq!(nothing, Reach::UpTo(ratio(0, 1)));
}
