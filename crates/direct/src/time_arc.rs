//! One Taylor step in time, and the proof of it.

use crate::envelope::{Envelope, beyond};
use crate::equation::Equation;
use crate::fixed::{BOUND_BITS, from_fixed, lower_bound, size, unit, upper_bound, zero};
use crate::phase_arc::{PhasePoint, lower_is_within};
use crate::time_series::{FixedPoint, Pace, TimeChart, TimeSeries};
use crate::turning::{enter, return_to_phase};
use num_traits::One;
use restitution_real::Ball;
use rug::{Float, Integer};

/// What a step in time reaches.
pub(crate) struct TimeStep {
    pub(crate) end: FixedPoint,
    pub(crate) reached: PhasePoint,
}

/// Parts of a step on which its polynomials are bounded one by one.
const PARTS: i64 = 16;

/// A step's polynomials with what they leave over of the equation of motion.
pub(crate) struct TimeArc<'a> {
    equation: &'a Equation,
    chart: &'a TimeChart,
    series: TimeSeries,
    length: Ball,
    /// Ranges of `z` and `v` on the parts of the step.
    ranges: Vec<(Ball, Ball)>,
}

/// Bounds of `dz/ds = (v + delta)/q` and `dv/dtheta = -h z^m f + D` (docs/direct-integration.md, Prop. 9).
struct Defect {
    /// `Int |h delta|` and `Int |D|`.
    in_z: Ball,
    in_v: Ball,
    /// `max |delta|` and `max |D|`.
    most_in_z: Ball,
    most_in_v: Ball,
    /// `max |z^m f|`.
    pull: Ball,
}

impl<'a> TimeArc<'a> {
    /// Expands the motion from a point.
    pub(crate) fn expand(
        equation: &'a Equation,
        chart: &'a TimeChart,
        from: &FixedPoint,
        pace: &Pace,
        order: usize,
    ) -> Self {
        let series = TimeSeries::solve(chart, equation, from, pace, order);
        let ranges =
            ranges(&series.z, equation.prec).into_iter().zip(ranges(&series.v, equation.prec)).collect();
        Self { equation, chart, series, length: pace.length(), ranges }
    }

    /// The point at the end of the polynomials.
    pub(crate) fn end(&self) -> FixedPoint {
        self.series.end()
    }

    /// Bits the coefficients lose per degree towards the last ones.
    pub(crate) fn slope(&self) -> f64 {
        let height = |part: &[Integer]| part.iter().map(Integer::significant_bits).max().unwrap_or(0);
        let seen = |c: &[Integer]| {
            let n = c.iter().rposition(|c| c.significant_bits() > FAINT).unwrap_or(0) + 1;
            let w = n / 10 + 1;
            let (middle, last) = (height(&c[(n / 2).saturating_sub(w)..n / 2]), height(&c[n - w..n]));
            f64::from(middle.saturating_sub(last)) / (n - n / 2) as f64
        };
        seen(&self.series.force).min(seen(&self.series.v))
    }

    /// Proves the step from a point of the phase plane; `None` if it is too long.
    pub(crate) fn prove(&self, from: &PhasePoint) -> Option<TimeStep> {
        let defect = self.defect()?;
        let end = self.end();
        let bits = self.equation.prec;
        let (z, v) = (from_fixed(&end.z, bits, bits + 32), from_fixed(&end.v, bits, bits + 32));
        let reached = if self.series.v[0].is_positive() && end.v.is_negative() {
            self.turn(from, &defect, &z, &v)?
        } else {
            PhasePoint { z: z.mid().clone(), v: v.mid().clone(), energy: self.along(from, &defect)? }
        };
        Some(TimeStep { end, reached: rounded(reached, bits) })
    }

    /// The energy at the end of a step on which the velocity has no zero.
    fn along(&self, from: &PhasePoint, defect: &Defect) -> Option<Ball> {
        let slowest = self.ranges.iter().map(|(_, v)| v.abs_down()).reduce(|x, y| x.min(&y))?;
        let two = Ball::from_integer(2, BOUND_BITS);
        let grown = &defect.in_z * &defect.pull + self.fastest() * &defect.in_v;
        let energy = upper_bound(&(&from.energy + two * grown));
        let slowest = Ball::exact(slowest);
        let proved = (&slowest - &defect.most_in_z).is_positive()
            && (lower_bound(&(&slowest * &slowest)) - &energy).is_positive();
        proved.then_some(energy)
    }

    /// The point at the end of a step through the turning point.
    fn turn(&self, from: &PhasePoint, defect: &Defect, z: &Ball, v: &Ball) -> Option<PhasePoint> {
        let start = enter(self.equation, from)?;
        let (outer, inner) = (i64::from(self.chart.outer), i64::from(self.chart.inner));
        let u = self.equation.u.with_prec(BOUND_BITS);
        let (mut force, mut lowest) = (Ball::one().with_prec(BOUND_BITS), None::<Ball>);
        for (z, v) in &self.ranges {
            let pull = z.powi(outer) * (z.powi(inner) + &u * v);
            let falls = (&self.length * lower_bound(&pull) - &defect.most_in_v).is_positive();
            let wide = z.clone().widened(&upper_bound(&z.abs().shifted(ROOM)).upper());
            let here = lower_bound(&(Ball::one() + &u * v / wide.powi(inner)));
            if !falls || !z.is_positive() || !here.is_positive() {
                return None;
            }
            force = Ball::exact(Float::with_val(BOUND_BITS, force.lower().min(&here.lower())));
            let least = Ball::exact(z.abs_down());
            lowest = Some(lowest.map_or_else(
                || least.clone(),
                |l| if (&l - &least).is_positive() { least.clone() } else { l },
            ));
        }
        let y = lower_bound(&self.equation.potential(lowest?.mid()));
        let grown = &defect.in_z * (&defect.pull + &defect.most_in_v / lower_bound(&self.length))
            + (self.fastest() + &defect.most_in_z) * &defect.in_v;
        let energy = upper_bound(&(&start.energy + grown));
        let stays = (y.shifted(ROOM) * &force - &energy).is_positive();
        let off = upper_bound(&(energy / force));
        stays.then(|| return_to_phase(self.equation, z.mid().clone(), v.mid().clone(), off)).flatten()
    }

    fn fastest(&self) -> Ball {
        let most = self.ranges.iter().map(|(_, v)| v.abs_up()).reduce(|x, y| x.max(&y));
        most.map_or_else(|| Ball::whole_line(BOUND_BITS), |most| upper_bound(&Ball::exact(most)))
    }

    /// What the polynomials leave over; `None` if too much was cut off.
    fn defect(&self) -> Option<Defect> {
        let (bits, s) = (self.equation.prec, &self.series);
        let degrees = s.v.len();
        let last = degrees - 1;
        let norm = |c: &[Integer]| size(c, bits);
        let n = Ball::from_integer(i64::try_from(degrees).ok()?, BOUND_BITS);
        let rounding = unit(bits) * &n;
        // z^2 and f of the polynomials themselves, less the coefficients kept.
        let (in_square, square_cut) = if s.square.is_empty() {
            (zero(), zero())
        } else {
            let slope = Envelope::tightest(&s.z, bits);
            let cut = beyond(slope, slope, last, degrees) + (norm(&s.z[..1]) * norm(&s.z[last..])).shifted(1);
            (rounding.shifted(1) + &cut, cut)
        };
        let u = upper_bound(&(from_fixed(&s.u, bits, BOUND_BITS) + &s.u_error));
        let damping_cut = &u * norm(&s.v[last..]);
        let elastic = if self.chart.inner == 2 { in_square.clone() } else { norm(&s.z[last..]) };
        let in_force = elastic + &rounding + &damping_cut + &s.u_error * norm(&s.v);
        let force = norm(&s.force);
        let (outer, in_outer, product_cut) = match self.chart.outer {
            0 => (Ball::one(), zero(), zero()),
            1 => (norm(&s.z), zero(), product_cut(&s.z, &s.force, bits)),
            _ => (norm(&s.square), in_square, product_cut(&s.square, &s.force, bits)),
        };
        if !lower_is_within(&(square_cut + damping_cut + &product_cut), bits) {
            return None;
        }
        let left = product_cut
            + rounding.shifted(1)
            + &outer * &in_force
            + &force * &in_outer
            + &in_outer * &in_force;
        let left = upper_bound(&(left * &self.length));
        let many = &rounding * &n;
        Some(Defect {
            in_z: upper_bound(&(&rounding * self.equation.rational(&self.equation.coordinate.q))),
            in_v: upper_bound(&(&rounding + &left)),
            most_in_z: upper_bound(
                &(&many * self.equation.rational(&self.equation.coordinate.q) / &self.length),
            ),
            most_in_v: upper_bound(&(many + left)),
            pull: upper_bound(&((outer + in_outer) * (force + in_force))),
        })
    }
}

/// Bits of coefficients that are hardly more than rounding.
const FAINT: u32 = 16;
/// Binary logarithm of the neighbourhood of `z`, relative to it, in which the motion is proved to stay.
const ROOM: i32 = -6;

/// The degrees of `x f` beyond those of `f`.
fn product_cut(x: &[Integer], force: &[Integer], bits: u32) -> Ball {
    let order = force.len();
    let slope = Envelope::tightest(x, bits).slope.min(Envelope::tightest(force, bits).slope);
    let (in_x, in_force) = (Envelope::with_slope(x, bits, slope), Envelope::with_slope(force, bits, slope));
    let highest = x.get(order..).map_or_else(zero, |rest| size(rest, bits) * size(&force[..1], bits));
    beyond(in_x, in_force, order, x.len()) + highest
}

/// Rounds the velocity to the working precision; the energy takes it up.
fn rounded(point: PhasePoint, bits: u32) -> PhasePoint {
    let v = Float::with_val(bits, &point.v);
    let (old, new) = (Ball::exact(point.v), Ball::exact(v.clone()));
    let moved = (&old - &new).abs() * (old.abs() + new.abs());
    PhasePoint { z: point.z, v, energy: upper_bound(&(point.energy + upper_bound(&moved))) }
}

/// The number of coefficients up to the last one of at least `2^-48`; the first one always.
fn head(coefficients: &[Integer], bits: u32) -> usize {
    let least = bits.saturating_sub(48);
    coefficients.iter().rposition(|c| c.significant_bits() >= least).map_or(1, |last| last + 1)
}

/// Enclosures of a polynomial on the parts of `0 <= theta <= 1`.
fn ranges(coefficients: &[Integer], bits: u32) -> Vec<Ball> {
    let head = head(coefficients, bits);
    let tail = size(&coefficients[head..], bits).upper();
    let balls: Vec<Ball> = coefficients[..head].iter().map(|c| from_fixed(c, bits, BOUND_BITS)).collect();
    (0..PARTS)
        .map(|i| {
            let theta = Ball::from_ratio(2 * i + 1, 2 * PARTS, BOUND_BITS)
                .widened(Ball::from_ratio(1, 2 * PARTS, BOUND_BITS).mid());
            balls.iter().rev().fold(zero(), |sum, c| sum * &theta + c).widened(&tail)
        })
        .collect()
}

#[cfg(test)]
mod exactly;
#[cfg(test)]
mod tests;
