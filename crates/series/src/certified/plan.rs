//! Which precision and which units to try: nothing here is part of a proof.

use super::attempt::{Expansion, Failure, Plan, Request, attempt, size_for_bits};
use super::units::log_singular_ratio;
use crate::kernels::{LANES, block_for, groups_for, size_for};
use num_rational::BigRational;
use num_traits::ToPrimitive;
use restitution_law::ForceLaw;
use restitution_real::Ball;

/// Orders and bits of the first, cheap attempt that shows how many bits are lost.
const SCOUT_ORDER: usize = 12;
const SCOUT_BITS: u32 = 192;
/// Bits of a second scout, for laws whose errors grow too much for the first.
const MORE_SCOUT_BITS: u32 = 640;
/// Least damping order at which the proof of the turning point has all that it needs.
const LEAST_ORDER: usize = 3;
/// Units of the damping that are tried, each smaller by a factor: first in small steps, then in large ones.
const UNITS: usize = 36;
const SMALLER: [(usize, f64); 3] = [(8, 0.7), (20, 0.35), (UNITS, 0.1)];
/// Relative bits of every value that a scout must prove.
const LEAST_KNOWN: f64 = 8.0;
/// Loss in bits from which on a smaller unit is tried too, and what it must save.
const MUCH: f64 = 90.0;
const WORTH_IT: f64 = 8.0;
/// Terms beyond the bits over their fall, at first.
const MARGIN: usize = 8;
/// Bits that are lost more for twice as many terms.
const ROUNDING: f64 = 3.4;
/// Attempts with more terms at one precision.
const CUTS: usize = 6;

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
    let scouted = [SCOUT_BITS, MORE_SCOUT_BITS].into_iter().find_map(|bits| scout(goal.law, damping, bits));
    let scouted = scouted.ok_or(Unproved::Norms)?;
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

/// A margin with which at least so many more terms are taken: sizes grow by steps.
fn more(margin: usize, terms: usize, bits: u32, law: &ForceLaw) -> usize {
    let size = |margin: usize| size_for_bits(law, bits, margin);
    (margin + terms..).find(|&next| size(next) > size(margin)).unwrap_or(margin)
}

/// Tries units of the damping from the natural one down, at low order and precision.
///
/// A unit that is proved but loses much is compared with the next one.
fn scout(law: &ForceLaw, damping: usize, bits: u32) -> Option<Scouted> {
    // Some hundred thousand terms are out of reach.
    if log_singular_ratio(law) < 1e-2 {
        return None;
    }
    let order = damping.min(SCOUT_ORDER);
    let request = Request { law, damping: order, last: order };
    let mut lambda = 1.15 / first_coefficient(law);
    let mut best: Option<Scouted> = None;
    for unit in 0..UNITS {
        let found = scout_unit(&request, damping, lambda, bits);
        let better = |found: &Scouted| best.as_ref().is_none_or(|best| found.lost + WORTH_IT < best.lost);
        match found.filter(better) {
            Some(found) if found.lost > MUCH => best = Some(found),
            Some(found) => return Some(found),
            None if best.is_some() => break,
            None => {}
        }
        lambda *= step_of_unit(unit);
    }
    best
}

/// An attempt with one unit of the damping, with as many terms as it needs.
fn scout_unit(request: &Request, damping: usize, lambda: f64, bits: u32) -> Option<Scouted> {
    let mut plan = Plan { bits, lambda, step: 0.0, margin: MARGIN };
    for _ in 0..CUTS {
        match attempt(request, plan, &mut |_| ()) {
            Ok(expansion) => {
                let now = lost(&expansion, request.last, bits);
                let known = now + LEAST_KNOWN < f64::from(bits);
                let lost = lost(&expansion, damping, bits);
                return known.then_some(Scouted { lambda, step: expansion.step, margin: plan.margin, lost });
            }
            Err(Failure::Terms(terms)) => plan.margin = more(plan.margin, terms, bits, request.law),
            Err(Failure::Norms) => break,
        }
    }
    None
}

fn step_of_unit(unit: usize) -> f64 {
    SMALLER.iter().find(|(below, _)| unit < *below).map_or(0.1, |(_, step)| *step)
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
