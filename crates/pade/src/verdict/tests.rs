use super::*;
use crate::{PadeType, RationalFunction, approximant};
use num_rational::BigRational;
use restitution_real::Rationals;

fn ints(p: &[i64]) -> Vec<BigRational> {
    p.iter().map(|&c| BigRational::from_integer(c.into())).collect()
}

fn of(num: &[i64], den: &[i64], interval: &Interval<BigRational>) -> Verdict {
    let f = RationalFunction::new(&Rationals, ints(num), ints(den)).unwrap();
    let asked = PadeType::new(num.len() - 1, den.len() - 1);
    let series = f.series(num.len() + den.len());
    verdict(&approximant(&Rationals, &series, asked).unwrap(), interval).unwrap()
}

/// Numerator, denominator, and the verdict.
type Graph<'g> = (&'g [i64], &'g [i64], usize, Option<usize>, Trend, Bounds);

#[test]
fn graphs_are_told_as_they_are() {
    let half = Interval::HalfLine;
    let all: [Graph; 13] = [
        (&[1], &[1, 1], 0, Some(0), Trend::Decreasing, Bounds::Within),
        (&[1, -1], &[1], 0, Some(1), Trend::Decreasing, Bounds::NotPositive),
        (&[1], &[1, -1], 1, Some(0), Trend::Broken, Bounds::Unbounded),
        (&[1], &[1], 0, Some(0), Trend::Constant, Bounds::Within),
        (&[2], &[1], 0, Some(0), Trend::Constant, Bounds::AboveOne),
        (&[-1], &[1, 1], 0, Some(0), Trend::Increasing, Bounds::NotPositive),
        (&[1, 1], &[1], 0, Some(0), Trend::Increasing, Bounds::AboveOne),
        (&[1, 1], &[1, 2], 0, Some(0), Trend::Decreasing, Bounds::Within),
        // 1 -+ x/(1 + x^2)
        (&[1, -1, 1], &[1, 0, 1], 0, Some(0), Trend::Turning(1), Bounds::Within),
        (&[1, 1, 1], &[1, 0, 1], 0, Some(0), Trend::Turning(1), Bounds::AboveOne),
        // 1 - x + x^2 falls below 1 and comes back above it.
        (&[1, -1, 1], &[1], 0, Some(0), Trend::Turning(1), Bounds::AboveOne),
        (&[2, -3, 1], &[1], 0, Some(2), Trend::Turning(1), Bounds::NotPositive),
        // A double zero is not positive.
        (&[1, -2, 1], &[1, 0, 1], 0, Some(1), Trend::Turning(1), Bounds::NotPositive),
    ];
    for (num, den, poles, zeros, trend, bounds) in all {
        let found = of(num, den, &half);
        assert_eq!(found, Verdict { poles, zeros, trend, bounds }, "{num:?}/{den:?}");
        let sound = poles == 0 && matches!(bounds, Bounds::Within | Bounds::AboveOne);
        assert_eq!(found.is_sound(), sound, "{num:?}/{den:?}");
    }
    let nothing = verdict(&approximant(&Rationals, &ints(&[0, 0, 0]), PadeType::new(1, 1)).unwrap(), &half);
    let nothing = nothing.unwrap();
    assert_eq!((nothing.zeros, nothing.trend, nothing.bounds), (None, Trend::Constant, Bounds::NotPositive));
    assert!(!nothing.is_sound());
}

#[test]
fn graphs_end_where_the_interval_ends() {
    let up_to = |n: i64, d: i64| Interval::UpTo(BigRational::new(n.into(), d.into()));
    let trend = |num: &[i64], end| of(num, &[1], &end).trend;
    assert_eq!(of(&[1, -1], &[1], &up_to(1, 2)).bounds, Bounds::Within);
    assert_eq!(of(&[1, -1], &[1], &up_to(1, 1)).bounds, Bounds::NotPositive);
    assert_eq!(of(&[1], &[1, -1], &up_to(1, 2)).bounds, Bounds::AboveOne);
    assert_eq!(of(&[1], &[1, -1], &up_to(1, 1)).poles, 1);
    assert_eq!(trend(&[1, -1, 1], up_to(1, 4)), Trend::Decreasing);
    assert_eq!(trend(&[1, -1, 1], up_to(3, 4)), Trend::Turning(1));
    assert_eq!(of(&[1, -1, 1], &[1], &up_to(1, 1)).bounds, Bounds::AboveOne);
    assert_eq!(of(&[1, -1, 1], &[1], &up_to(99, 100)).bounds, Bounds::Within);
}

#[test]
fn verdicts_are_told_in_words() {
    let trends = [Trend::Constant, Trend::Decreasing, Trend::Increasing, Trend::Turning(2), Trend::Broken];
    let words = trends.map(|trend| trend.to_string()).join(", ");
    assert_eq!(words, "constant, decreasing, increasing, not monotone, 2 turning points, broken by a pole");
    let bounds = [Bounds::Within, Bounds::AboveOne, Bounds::NotPositive, Bounds::Unbounded];
    let words = bounds.map(|bounds| bounds.to_string()).join(", ");
    assert_eq!(words, "within (0, 1], positive, exceeds 1, not positive everywhere, unbounded");
}
