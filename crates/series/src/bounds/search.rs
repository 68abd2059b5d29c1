//! Which weights to try: nothing here is part of the proof, only of the quality of what is proved.

use super::decay::Decay;
use super::error::BoundError;
use super::head::Head;
use super::majorant::Majorant;
use num_traits::ToPrimitive;
use rayon::prelude::*;
use restitution_law::ForceLaw;

/// How many weights are tried.
pub(super) struct Search {
    /// Leading terms that are enclosed, tried in turn.
    heads: &'static [usize],
    /// Radii that are tried, as exponents of the ratio at which the nearest singularity lies.
    depths: &'static [f64],
    /// Damping weights that are kept, as fractions of the largest that can be proved.
    fractions: &'static [f64],
}

/// For tails that are to be short.
pub(super) const CLOSE: Search = Search {
    heads: &[40, 80, 160, 320],
    depths: &[0.2, 0.4, 0.6, 0.7, 0.78, 0.84, 0.88, 0.92, 0.95, 0.97],
    fractions: &[0.98, 0.85, 0.7, 0.5, 0.25],
};
/// For sizes of which a hundredth too much costs little: four times faster.
pub(super) const ROUGH: Search =
    Search { heads: &[16, 40, 80, 160, 320], depths: &[0.2, 0.4, 0.6, 0.8, 0.9], fractions: &[0.9, 0.5] };
/// A head is long enough when this depth is proved.
const GOOD_DEPTH: f64 = 0.8;

/// Finds rates of decay, from short heads to long ones until a rate is good.
pub(super) fn rates(
    search: &Search,
    law: &ForceLaw,
    damping_order: usize,
) -> Result<(Head, Vec<Decay>), BoundError> {
    let log_ratio = log_singular_ratio(law);
    let mut best = None;
    for &elastic_terms in search.heads {
        let head = Head::new(law, damping_order, elastic_terms);
        let (rates, depth) = search.rates_of_head(law, &head, damping_order, log_ratio);
        if depth > 0.0 {
            best = Some((head, rates));
        }
        if depth >= GOOD_DEPTH {
            break;
        }
    }
    best.ok_or_else(|| BoundError::TurningPointNotReached {
        law: law.to_string(),
        terms: search.heads.last().copied().unwrap_or(0),
    })
}

impl Search {
    /// All rates a head proves, and the largest depth among those that cover every order.
    fn rates_of_head(
        &self,
        law: &ForceLaw,
        head: &Head,
        damping_order: usize,
        log_ratio: f64,
    ) -> (Vec<Decay>, f64) {
        let majorant = Majorant::new(law, head);
        let of_depth = |&depth: &f64| {
            let ratio = (depth * log_ratio).exp();
            let mut rates: Vec<Decay> = majorant.decay(ratio, 0.0).into_iter().collect();
            if ratio <= 1.0 || rates.is_empty() {
                return (Vec::new(), 0.0);
            }
            if damping_order == 0 {
                return (rates, depth);
            }
            let Some(largest) = largest_damping(&majorant, ratio) else { return (rates, 0.0) };
            let alone = rates.len();
            rates.extend(
                self.fractions.iter().filter_map(|fraction| majorant.decay(ratio, fraction * largest)),
            );
            // A depth counts where every order is covered.
            let depth = if rates.len() > alone { depth } else { 0.0 };
            (rates, depth)
        };
        let found: Vec<(Vec<Decay>, f64)> = self.depths.par_iter().map(of_depth).collect();
        let deepest = found.iter().map(|(_, depth)| *depth).fold(0.0, f64::max);
        (found.into_iter().flat_map(|(rates, _)| rates).collect(), deepest)
    }
}

/// About the largest damping weight that is proved at a ratio, within 3 %.
fn largest_damping(majorant: &Majorant, ratio: f64) -> Option<f64> {
    let proves = |weight: f64| majorant.decay(ratio, weight).is_some();
    let mut low = (0..60).map(|k| 64.0 * 0.5f64.powi(k)).find(|&weight| proves(weight))?;
    let mut high = 2.0 * low;
    for _ in 0..5 {
        let middle = (low + high) / 2.0;
        if proves(middle) { low = middle } else { high = middle }
    }
    Some(low)
}

/// The logarithm of `(t/T)^(a+1)` at the singularity nearest to 0 (`docs/error-bounds.md`, proposition 2).
///
/// ```text
/// t/T = min(2, 1/cos(pi/(a+1)))      where the cosine counts for a > 1
/// ```
fn log_singular_ratio(law: &ForceLaw) -> f64 {
    let step = law.elastic_step().to_f64().unwrap_or(f64::MAX);
    let cosine = (std::f64::consts::PI / step).cos();
    let distance = if cosine > 0.5 { -cosine.ln() } else { 2f64.ln() };
    step * distance
}

#[cfg(test)]
mod tests;
