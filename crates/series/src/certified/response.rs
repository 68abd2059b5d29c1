//! How much an error grows in a causal linear problem, as a recursion of scalars.

use super::sketch::over_one_minus;
use restitution_real::Magnitude;

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
    let total = |b: usize| {
        let factor = |cause: &Cause| {
            let weight = (cause.weight)(b, b + cause.step) * (1.0 + 1e-12);
            Magnitude::exact(weight) * cause.sizes.iter().copied().sum::<Magnitude>()
        };
        causes.iter().map(factor).sum::<Magnitude>()
    };
    let small = |b: usize| total(b).to_f64() <= 0.5;
    let end = (first..most).step_by((most / 64).max(1)).find(|&b| small(b))?;
    let end = (first..=end).find(|&b| small(b))?;
    let beyond = Magnitude::exact((1.0 / (1.0 - total(end).to_f64()).next_down()).next_up());
    let mut response = vec![beyond; end + 1];
    let sizes: Vec<Vec<(usize, Magnitude)>> = causes.iter().map(nonzero).collect();
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

fn nonzero(cause: &Cause) -> Vec<(usize, Magnitude)> {
    cause.sizes.iter().copied().enumerate().filter(|(_, size)| size.to_f64() > 0.0).collect()
}
