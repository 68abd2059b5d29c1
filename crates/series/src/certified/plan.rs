//! Which precision and which units to try: nothing here is part of a proof.

use super::attempt::{Expansion, Failure, Plan, Request, attempt, norms_of_powers, size_for_bits};
use super::units::log_singular_ratio;
use crate::kernels::{LANES, block_for, groups_for, size_for};
use num_rational::BigRational;
use num_traits::ToPrimitive;
use restitution_law::ForceLaw;
use restitution_real::Ball;

/// Orders and bits of the first, cheap attempt that shows how many bits are lost.
const SCOUT_ORDER: usize = 12;
const SCOUT_BITS: u32 = 192;
/// Bits of a scout, for laws whose errors grow much, and how many are added beyond those that were missing.
const MOST_SCOUT_BITS: u32 = 1024;
const SPARE_BITS: u32 = 32;
/// Bits that may seem lost beyond all there are.
const UNKNOWN: u32 = 64;
/// Least damping order at which the proof of the turning point has all that it needs.
const LEAST_ORDER: usize = 3;
/// Units of the damping that are tried, each smaller by a factor: first in small steps, then in large ones.
const UNITS: usize = 20;
const SMALLER: [(usize, f64); 2] = [(8, 0.7), (UNITS, 0.35)];
/// Loss in bits from which on a smaller unit is tried too, and what it must save.
const MUCH: f64 = 90.0;
const WORTH_IT: f64 = 8.0;
/// A factor that makes a unit so small that orders in it can be derived, and the share of damped orders in a good one.
const TINY: f64 = 1e-3;
const TINIEST: i32 = 8;
const SUITABLE: f64 = 0.2;
/// Terms beyond the bits over their fall, at first; where they fall by fewer bits, terms that are worth so many.
const MARGIN: usize = 8;
const SLOW: f64 = 0.5;
const MARGIN_BITS: f64 = 20.0;
/// Bits that are lost more for twice as many terms.
const ROUNDING: f64 = 3.4;
/// Attempts with more terms at one precision.
const CUTS: usize = 8;

/// What an expansion is wanted for.
pub(crate) struct Goal<'g> {
    pub law: &'g ForceLaw,
    /// The largest order of the expansion and of the trajectories.
    pub last: usize,
    pub damping: usize,
    /// Relative bits of every value.
    pub wanted: usize,
    /// Most bits of working precision.
    pub limit: usize,
    /// By how many bits an expansion falls short of the goal; 0 if it is reached.
    pub missing: &'g dyn Fn(&Expansion) -> usize,
}

/// Why no expansion was proved.
pub(crate) enum Unproved {
    /// The precision is exhausted.
    Exhausted,
    /// The law's norms are too large for the proof.
    Norms,
}

/// A choice of units that works for a law, and the bits it loses.
struct Scouted {
    lambda: f64,
    step: f64,
    margin: usize,
    lost: f64,
}

/// Finds an expansion that reaches the goal: a cheap attempt first where it pays, then as a rule one more.
pub(crate) fn expand(goal: &Goal, watch: &mut dyn FnMut(usize)) -> Result<Expansion, Unproved> {
    let damping = goal.damping.max(LEAST_ORDER);
    let request = Request { law: goal.law, damping, last: goal.last.max(damping) };
    let scouted = scout(&request).ok_or(Unproved::Norms)?;
    let Scouted { lambda, step, mut margin, lost } = scouted;
    let mut plan = Plan { bits: 0, lambda, step, margin };
    // Rounding adds up over the terms.
    let terms = |bits: usize| size_for_bits(goal.law, bits as u32, margin) as f64;
    let growth = (terms(goal.wanted + 64) / terms(SCOUT_BITS as usize)).log2().max(0.0);
    let mut spare = (lost + ROUNDING * growth).max(32.0) as usize + damping / 40 + 4;
    let (mut cuts, mut units) = (0, 0);
    loop {
        let bits = goal.wanted + spare;
        plan.bits =
            u32::try_from(bits).ok().filter(|_| bits <= goal.limit).ok_or(Unproved::Exhausted)?.max(128);
        match attempt(&request, plan, watch) {
            Ok(expansion) => {
                let missing = (goal.missing)(&expansion);
                if missing == 0 {
                    return Ok(expansion);
                }
                spare += missing + spare / 16 + 4;
            }
            Err(Failure::Terms(terms)) if cuts < CUTS => {
                cuts += 1;
                margin = more(margin, terms, plan.bits, goal.law);
                plan.margin = margin;
            }
            Err(Failure::Bits(missing)) => spare += missing as usize + SPARE_BITS as usize,
            Err(_) if units < UNITS => {
                plan.lambda *= step_of_unit(units);
                units += 1;
                plan.step = 0.0;
                spare += damping / 2;
            }
            Err(_) => return Err(Unproved::Norms),
        }
    }
}

/// Bytes at the peak for coefficients up to an order: rows of two series as residues, two or three times as many and
/// their multiples where they are multiplied in blocks, and the tables of the transforms.
///
/// Measured on spheres: see the test. The estimate is never below and at most twice that.
pub(crate) fn memory_estimate(law: &ForceLaw, order: usize, digits: usize) -> f64 {
    let bits = 3.33 * digits as f64 + 0.9 * order as f64 + 60.0;
    let slope = log_singular_ratio(law).max(0.25);
    let terms = (bits / slope) as usize + MARGIN;
    let points = size_for(terms.max(order.saturating_add(2)).min(1 << 60)) as f64;
    let primes = (LANES * groups_for((2.0 * bits + 192.0).min(1e9) as u32)) as f64;
    let rows = if block_for(order) <= order { 10.0 } else { 3.0 };
    let families = if law.is_viscoelastic() { 1.0 } else { 4.0 / 3.0 };
    8e6 + families * (40.0 + rows * order as f64) * points * primes * 8.0
}

/// Terms beyond the bits over their fall to begin with.
fn least_margin(law: &ForceLaw) -> usize {
    let slope = log_singular_ratio(law);
    if slope < SLOW { (MARGIN_BITS / slope) as usize } else { MARGIN }
}

/// A margin with which at least so many more terms are taken: sizes grow by steps.
fn more(margin: usize, terms: usize, bits: u32, law: &ForceLaw) -> usize {
    let size = |margin: usize| size_for_bits(law, bits, margin);
    (margin + terms..).find(|&next| size(next) > size(margin)).unwrap_or(margin)
}

/// Tries units of the damping at low order and precision from the natural one down.
///
/// A unit that is proved but loses much is compared with the next one; so it is not where damped orders had to be made
/// small before anything was proved.
fn scout(goal: &Request) -> Option<Scouted> {
    let law = goal.law;
    let slope = log_singular_ratio(law);
    // Some hundred thousand terms are out of reach.
    if slope < 1e-2 {
        return None;
    }
    let order = goal.damping.min(SCOUT_ORDER);
    let request = Request { law, damping: order, last: goal.last.min(order + 1) };
    let mut margin = least_margin(law);
    let mut lambda = 1.15 / first_coefficient(law);
    let mut best: Option<Scouted> = None;
    let (mut bits, mut compared) = (SCOUT_BITS, true);
    for unit in 0..UNITS {
        let found = scout_unit(&request, goal.damping, lambda, &mut bits, &mut margin);
        let better = |found: &Scouted| best.as_ref().is_none_or(|best| found.lost + WORTH_IT < best.lost);
        match found.filter(better) {
            Some(found) if found.lost > MUCH && compared => best = Some(found),
            Some(found) => return Some(found),
            None if best.is_some() => break,
            None if unit == 0 => {
                let suitable = suitable_unit(&request, lambda, bits)?;
                compared = suitable > lambda * step_of_unit(unit);
                lambda = lambda.min(suitable / step_of_unit(unit));
            }
            None => {}
        }
        lambda *= step_of_unit(unit);
    }
    best
}

/// An attempt with one unit of the damping, with as many terms as it needs.
fn scout_unit(
    request: &Request,
    damping: usize,
    lambda: f64,
    bits: &mut u32,
    margin: &mut usize,
) -> Option<Scouted> {
    for cut in 0..CUTS {
        let plan = Plan { bits: *bits, lambda, step: 0.0, margin: *margin };
        match attempt(request, plan, &mut |_| ()) {
            Ok(expansion) => {
                // Where nothing at all is known, what was lost can't be told.
                let unknown = lost(&expansion, request.last, *bits) > f64::from(*bits + UNKNOWN);
                if unknown && 2 * *bits <= MOST_SCOUT_BITS {
                    *bits *= 2;
                    continue;
                }
                let lost = lost(&expansion, damping, *bits).min(f64::from(2 * *bits));
                return Some(Scouted { lambda, step: expansion.step, margin: plan.margin, lost });
            }
            // Where rounding of large powers is folded over, the estimate is too low.
            Err(Failure::Terms(terms)) => {
                let terms = terms + cut * size_for_bits(request.law, *bits, *margin) / 2;
                *margin = more(*margin, terms, *bits, request.law);
            }
            Err(Failure::Bits(missing)) if *bits + missing <= MOST_SCOUT_BITS => {
                *bits += missing + SPARE_BITS;
                *margin = least_margin(request.law);
            }
            Err(_) => break,
        }
    }
    None
}

/// A unit of the damping in which all damped orders of a power together are about as large as that without damping.
///
/// Rows of order `n` change by the `n`-th power of the unit.
fn suitable_unit(request: &Request, lambda: f64, bits: u32) -> Option<f64> {
    (1..=TINIEST).find_map(|step| {
        let plan = Plan { bits, lambda: lambda * TINY.powi(step), step: 0.0, margin: MARGIN };
        let norms = norms_of_powers(request, plan)?;
        let damped = |factor: f64| {
            let powers = std::iter::successors(Some(factor), |power| Some(power * factor));
            norms[1..].iter().zip(powers).map(|(norm, power)| norm * power).sum::<f64>()
        };
        let (mut low, mut high) = (0.0f64, 40.0f64);
        for _ in 0..40 {
            let middle = (low + high) / 2.0;
            if damped(middle.exp2()) <= SUITABLE * norms[0] { low = middle } else { high = middle }
        }
        Some(plan.lambda * low.exp2())
    })
}

fn step_of_unit(unit: usize) -> f64 {
    SMALLER.iter().find(|(below, _)| unit < *below).map_or(1.0, |(_, step)| *step)
}

/// About how many relative bits are lost at an order, from what was lost at lower ones.
fn lost(expansion: &Expansion, order: usize, precision: u32) -> f64 {
    let lost = |series: &[Ball]| -> f64 {
        let bits: Vec<f64> = series.iter().map(|c| lost_bits(c, precision)).collect();
        let last = bits.len() - 1;
        let worst = bits.iter().skip(1).copied().fold(0.0, f64::max);
        let early = bits.iter().take(last / 2 + 1).skip(1).copied().fold(0.0, f64::max);
        let slope = if last >= 6 { (worst - early) / (last - last / 2) as f64 } else { 0.0 };
        worst + slope.max(0.0) * (order.saturating_sub(last)) as f64
    };
    lost(&expansion.restitution).max(lost(&expansion.compression))
}

/// Bits between the precision and what is proved.
fn lost_bits(c: &Ball, precision: u32) -> f64 {
    c.relative_bits().map_or(0.0, |bits| f64::from(precision) - bits as f64)
}

/// `|C_1| = 2 ((a+1)/2)^((gamma+1)/(a+1)) B((gamma+1)/(a+1), 3/2)/(a+1)` (MATH section 6).
fn first_coefficient(law: &ForceLaw) -> f64 {
    let ratio = law.damping_step() / law.elastic_step();
    let three_halves = BigRational::new(3.into(), 2.into());
    let reach =
        Ball::from_rational(&(law.elastic_step() / BigRational::new(2.into(), 1.into())), 64).pow(&ratio);
    let beta = Ball::beta(&ratio, &three_halves, 64);
    let step = law.elastic_step().to_f64().unwrap_or(1.0);
    (2.0 * reach.to_f64() * beta.to_f64() / step).clamp(1e-9, 1e12)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What was measured is estimated, and no more than twice as much.
    #[test]
    fn memory_is_what_was_measured() {
        let spheres = ForceLaw::viscoelastic_spheres();
        let measured = [
            (4, 1000, 61.0),
            (8, 300, 14.3),
            (1, 3000, 379.0),
            (40, 300, 31.7),
            (100, 30, 21.0),
            (200, 30, 86.7),
            (300, 100, 263.0),
            (1000, 30, 3282.0),
        ];
        for (order, digits, megabytes) in measured {
            let estimate = memory_estimate(&spheres, order, digits) / 1e6;
            assert!((megabytes..2.0 * megabytes).contains(&estimate), "{order} {digits}: {estimate}");
        }
    }
}
