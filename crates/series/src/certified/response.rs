//! How much an error grows in a causal linear problem, as a recursion of scalars.

use super::sketch::over_one_minus;
use restitution_real::Magnitude;
use std::ops::Range;

/// One term of the problem: an error at place `b` causes others at `b + step + i`, larger by `sizes[i]` times
/// what the two places allow.
pub(crate) struct Cause<'c> {
    pub step: usize,
    pub sizes: &'c [Magnitude],
    /// Never rises with either place.
    pub weight: &'c dyn Fn(usize, usize) -> f64,
}

/// The whole error that a unit at place `first` or later causes, itself included:
///
/// ```text
/// R(b) = 1 + sum over causes and i of weight(b, b+step+i) sizes_i R(b+step+i)
/// ```
///
/// From a place on where all causes together have a factor `q <= 1/2` it is at most `1/(1-q)`. Since the weights
/// don't rise, neither does `R`. Causes within one place, of a factor `s < 1`, enlarge all else by `1/(1-s)`.
/// `None` if no such place is found among the first `most`.
pub(crate) fn response(first: usize, causes: &[Cause], most: usize) -> Option<Magnitude> {
    let sizes: Vec<Vec<(usize, Magnitude)>> = causes.iter().map(nonzero).collect();
    let total = |b: usize| {
        let term = |cause: &Cause, (i, size): (usize, Magnitude)| {
            Magnitude::exact((cause.weight)(b, b + cause.step + i) * (1.0 + 1e-12)) * size
        };
        let sum = |(cause, sizes): (&Cause, &Vec<(usize, Magnitude)>)| -> Magnitude {
            sizes.iter().map(|&size| term(cause, size)).sum()
        };
        causes.iter().zip(&sizes).map(sum).sum::<Magnitude>()
    };
    let small = |b: usize| total(b).to_f64() <= 0.5;
    let end = first_place(first..most, small)?;
    let beyond = Magnitude::exact((1.0 / (1.0 - total(end).to_f64()).next_down()).next_up());
    let mut response = vec![beyond; end + 1];
    for b in (first..end).rev() {
        let (mut sum, mut within) = (Magnitude::ONE, Magnitude::ZERO);
        for (cause, sizes) in causes.iter().zip(&sizes) {
            for &(i, size) in sizes {
                let place = b + cause.step + i;
                let weight = Magnitude::exact((cause.weight)(b, place) * (1.0 + 1e-12));
                if place == b {
                    within = within + weight * size;
                } else {
                    sum = sum + weight * size * response[place.min(end)];
                }
            }
        }
        response[b] = sum * over_one_minus(within)?;
    }
    Some(response[first])
}

/// The first place from which on a condition holds, by doubling, then bisection.
fn first_place(places: Range<usize>, holds: impl Fn(usize) -> bool) -> Option<usize> {
    let Range { start: mut low, end } = places;
    if low >= end || holds(low) {
        return (low < end).then_some(low);
    }
    let mut high = (2 * low + 1).min(end);
    while !holds(high) {
        if high == end {
            return None;
        }
        (low, high) = (high, (2 * high).min(end));
    }
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        if holds(middle) { high = middle } else { low = middle }
    }
    Some(high)
}

fn nonzero(cause: &Cause) -> Vec<(usize, Magnitude)> {
    cause.sizes.iter().copied().enumerate().filter(|(_, size)| size.to_f64() > 0.0).collect()
}

#[cfg(test)]
mod tests;
