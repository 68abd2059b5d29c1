//! One Taylor step around the turning point, the potential energy `y` as a function of `v`.

use crate::envelope::{Envelope, upper_half};
use crate::field::Field;
use crate::fixed::{
    BOUND_BITS, from_fixed, inner_products, lower_bound, power_of_two, size, to_fixed, unit, upper_bound,
};
use crate::phase_arc::{lower_is_within, zero};
use num_rational::BigRational;
use restitution_real::Ball;
use restitution_real::convert::rug_integer;
use rug::{Float, Integer};

/// A point near the turning point: `v` is exact, the true potential energy is near `y`.
///
/// `energy` bounds the difference of `F(y, v) = y + u v x^(gamma+1)/(gamma+1)` from its true value.
#[derive(Clone, Debug)]
pub(crate) struct TurningPoint {
    pub(crate) v: Float,
    pub(crate) y: Float,
    pub(crate) energy: Ball,
    /// The bound of the difference of `y` itself.
    pub(crate) spread: Ball,
}

/// What the step from one velocity to the next gives.
pub(crate) struct TurningStep {
    pub(crate) reached: TurningPoint,
    pub(crate) slope: f64,
    /// A lower bound of `1 + u v x^(gamma-a)` along the step.
    pub(crate) least_force: Ball,
}

/// The damping over the elastic force per unit velocity, `K = u x^(gamma-a)`, at potential `y`.
pub(crate) fn friction_ratio(field: &Field, y: &Ball) -> Ball {
    let power = -(field.law.a() - field.law.gamma()) / field.law.elastic_step();
    &field.u * (y * field.rational(&field.law.elastic_step())).pow(&power)
}

/// The integers of one step: `y`, `K`, the product series `K y'`.
struct Series {
    y: Vec<Integer>,
    ratio: Vec<Integer>,
    product: Vec<Integer>,
}

/// Follows `y' (1 + v K) = -h v`, `(y K)' = (1-c) K y'` from `from` to the velocity `end < from.v`.
///
/// `1 - c = (gamma + 1)/(a + 1)`. `None` if the step is too long to be proved (Prop. 3).
pub(crate) fn follow(field: &Field, from: &TurningPoint, end: &Float) -> Option<TurningStep> {
    let (bits, order) = (field.prec, field.order);
    let exact = |x: &Float| Ball::exact(x.clone());
    let h = exact(&Float::with_val(2 * bits + 64, end - &from.v));
    let velocity_scale = i64::from(from.v.get_exp().unwrap_or(i32::MIN).max(h.mid().get_exp()?));
    let scale = i64::from(from.y.get_exp()?);
    let shift = |n: i64| i32::try_from(n).ok();
    let unexpected = &mut zero();
    let v_fixed = to_fixed(&exact(&from.v).shifted(shift(-velocity_scale)?), bits, unexpected);
    let h_fixed = to_fixed(&h.shifted(shift(-velocity_scale)?), bits, unexpected);
    if !unexpected.is_exact() || !unexpected.mid().is_zero() {
        return None;
    }
    let mut right_error = zero();
    let right = [
        to_fixed(&(-(&h * exact(&from.v)).with_prec(bits)).shifted(shift(-scale)?), bits, &mut right_error),
        to_fixed(&(-(&h * &h).with_prec(bits)).shifted(shift(-scale)?), bits, &mut right_error),
    ];
    let start_ratio = friction_ratio(field, &exact(&from.y).with_prec(bits));
    let mut ratio_error = zero();
    let ratio = to_fixed(&start_ratio.shifted(shift(velocity_scale)?), bits, &mut ratio_error);
    let y = to_fixed(&exact(&from.y).shifted(shift(-scale)?), bits, unexpected);
    let one_minus_c = field.law.damping_step() / field.law.elastic_step();
    let series = taylor(&v_fixed, &h_fixed, &right, y, ratio, &one_minus_c, field)?;

    // Bounds, all in units of the two scales.
    let one = Ball::from_integer(1, BOUND_BITS);
    let n = |k: usize| Ball::from_integer(i64::try_from(k).unwrap_or(i64::MAX), BOUND_BITS);
    let change = size(&series.y[1..], bits);
    let y_start = from_fixed(&series.y[0], bits, BOUND_BITS);
    let lowest = lower_bound(&(&y_start - &change));
    if !lowest.is_positive() {
        return None;
    }
    let slope = Envelope::tightest(&series.y, bits).slope.min(Envelope::tightest(&series.ratio, bits).slope);
    let (env_y, env_ratio) =
        (Envelope::with_slope(&series.y, bits, slope), Envelope::with_slope(&series.ratio, bits, slope));
    let tail = upper_half(env_y, env_ratio, order);
    let last = size(&series.product[order - 1..], bits);
    if !lower_is_within(&(&tail + &last), bits) {
        return None;
    }
    // Prop. 3 (i): the defect of the equation of motion with the computed K.
    let start_force =
        &one + from_fixed(&v_fixed, bits, BOUND_BITS) * from_fixed(&series.ratio[0], bits, BOUND_BITS);
    let rounding =
        unit(bits) * (n(order) * (start_force.abs() + Ball::from_integer(3, BOUND_BITS)) + &change + &one);
    let motion = rounding + right_error + tail.shifted(1) + last + unit(bits);
    // (ii): the distance of the computed K from the true power of the polynomial y.
    let power = unit(bits) * n(order) * (&y_start + &one)
        + &tail * (&one + field.rational(&one_minus_c).with_prec(BOUND_BITS));
    let c = one_minus_c - BigRational::from_integer(1.into());
    let bend = upper_bound(&((&y_start + &change) / &lowest).pow(&abs(&c)));
    let ratio_off = upper_bound(&(&bend * (ratio_error + power / &lowest)));
    let defect = upper_bound(&(motion + ratio_off.shifted(1) * &change));
    // (iii): the force keeps its sign, so the error only shrinks but for the defect.
    let start_energy = upper_bound(&(from.energy.with_prec(BOUND_BITS) * power_of_two(-scale)));
    let energy = upper_bound(&(&start_energy + &defect));
    let widest = |y: &Ball| upper_bound(&(from_fixed(&series.ratio[0], bits, BOUND_BITS) * y));
    // K over all potentials within a quarter of the lowest one around the polynomial's range.
    let room = lowest.shifted(-2);
    let spread_ratio = (&y_start + &change + &room) / (&lowest - &room);
    let largest_ratio = widest(&upper_bound(&spread_ratio.pow(&abs(&c))));
    let fastest_out = -exact(end).shifted(shift(-velocity_scale)?).with_prec(BOUND_BITS);
    let least_force = if fastest_out.is_positive() {
        lower_bound(&(&one - upper_bound(&fastest_out) * &largest_ratio))
    } else {
        one.clone()
    };
    if !least_force.is_positive() {
        return None;
    }
    let spread = upper_bound(&(&energy / &least_force));
    if (&spread - &room).is_positive() || !spread.is_finite() {
        return None;
    }
    let sum: Integer = series.y.iter().sum();
    let y = from_fixed(&sum, bits, bits);
    let rounding = Ball::exact(y.rad().clone());
    let unscale = power_of_two(scale);
    let greatest_force = &one + upper_bound(&largest_ratio).shifted(1);
    let reached = TurningPoint {
        v: end.clone(),
        y: y.shifted(shift(scale)?).mid().clone(),
        energy: upper_bound(&((energy + &rounding * greatest_force) * &unscale)),
        spread: upper_bound(&((spread + rounding) * unscale)),
    };
    Some(TurningStep {
        reached,
        slope: env_y.decay_seen(order).min(env_ratio.decay_seen(order)),
        least_force,
    })
}

fn abs(q: &BigRational) -> BigRational {
    num_traits::Signed::abs(q)
}

/// Solves the two relations for the coefficients in turn; each division truncates.
fn taylor(
    v: &Integer,
    h: &Integer,
    right: &[Integer; 2],
    y: Integer,
    ratio: Integer,
    one_minus_c: &BigRational,
    field: &Field,
) -> Option<Series> {
    let (bits, order) = (field.prec, field.order);
    let (top, bottom) = (rug_integer(one_minus_c.numer()), rug_integer(one_minus_c.denom()));
    let force = (Integer::from(1) << bits) + (Integer::from(v * &ratio) >> bits);
    if force <= 0 {
        return None;
    }
    let weighted = Integer::from(&bottom * &y);
    let mut s = Series { y: vec![y], ratio: vec![ratio], product: Vec::with_capacity(order) };
    let mut derivative = vec![Integer::new()];
    for k in 1..=order {
        let known = inner_products(&derivative, &s.ratio, k);
        let mut side = right.get(k - 1).map_or_else(Integer::new, |r| Integer::from(r << bits));
        if k >= 2 {
            side -= h * &s.product[k - 2];
        }
        side -= v * Integer::from(&known >> bits);
        let coefficient = side / Integer::from(&force * k as u64);
        derivative.push(Integer::from(&coefficient * k as u64));
        s.y.push(coefficient);
        let product = known + &derivative[k] * &s.ratio[0];
        s.product.push(Integer::from(&product >> bits));
        let mut rest = inner_products(&s.y, &s.ratio, k) + &s.y[k] * &s.ratio[0];
        rest *= &bottom;
        rest *= k as u64;
        s.ratio.push((product * &top - rest) / Integer::from(&weighted * k as u64));
    }
    Some(s)
}
