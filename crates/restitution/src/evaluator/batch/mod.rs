//! Many arguments at a time.
//!
//! A block of arguments goes through the same forms as a single one, in loops without branches: the places in the
//! table, then the rows, then what lies below and beyond. Rows are loaded whole, one cache line each, and
//! transposed in registers ([`machine`]): no gathers. Every value is the one that the single call gives, to the bit.

mod block;
mod machine;
mod tiers;
#[cfg(all(feature = "simd", target_arch = "x86_64"))]
mod x86;

use crate::evaluator::inverse::Given;
use crate::evaluator::tier::Tier;
use crate::{End, Restitution};
use block::{Batch, Quantity};
use tiers::TierBatch;

/// Writes `epsilon(u)` of each element to `out`, as far as the shorter of the two slices reaches.
///
/// Every value is the one [`crate::epsilon`] gives, to the bit. With the feature `simd` the width of the processor's
/// vectors is chosen at run time; with `rayon` large slices are shared out to threads.
///
/// # Examples
///
/// ```
/// use restitution::{End, epsilon, epsilon_batch};
///
/// let u = [0.0, 0.5, 1.0, 20.0, -1.0];
/// let mut values = [0.0; 5];
/// epsilon_batch(&u, &mut values, End::ZeroForce);
/// assert_eq!(values[1], epsilon(0.5, End::ZeroForce));
/// assert!(values[4].is_nan());
/// ```
pub fn epsilon_batch(u: &[f64], out: &mut [f64], end: End) {
    run(u, out, &|u, out| dispatch(Batch { u, out, end, quantity: Quantity::Kept, factor: None }));
}

/// Writes `1 - epsilon(u)` of each element to `out`, as far as the shorter of the two slices reaches.
///
/// Every value is the one [`crate::one_minus_epsilon`] gives, to the bit; otherwise as [`epsilon_batch`].
///
/// # Examples
///
/// ```
/// use restitution::{End, one_minus_epsilon, one_minus_epsilon_batch};
///
/// let u = [1e-20, 0.5, 1.0, -1.0];
/// let mut lost = [0.0; 4];
/// one_minus_epsilon_batch(&u, &mut lost, End::ZeroForce);
/// assert_eq!(lost[0], one_minus_epsilon(1e-20, End::ZeroForce));
/// assert!(lost[3].is_nan());
/// ```
pub fn one_minus_epsilon_batch(u: &[f64], out: &mut [f64], end: End) {
    run(u, out, &|u, out| dispatch(Batch { u, out, end, quantity: Quantity::Lost, factor: None }));
}

/// Writes `u_of_epsilon` of each element to `out`, as far as the shorter of the two slices reaches.
///
/// Every value is the one [`crate::u_of_epsilon`] gives, to the bit; otherwise as [`epsilon_batch`].
///
/// # Examples
///
/// ```
/// use restitution::{End, u_of_epsilon, u_of_epsilon_batch};
///
/// let mut u = [0.0; 3];
/// u_of_epsilon_batch(&[0.5, 1.0, 1.1], &mut u, End::ZeroCompression);
/// assert_eq!(u[..2], [u_of_epsilon(0.5, End::ZeroCompression), 0.0]);
/// assert!(u[2].is_nan());
/// ```
pub fn u_of_epsilon_batch(epsilon: &[f64], out: &mut [f64], end: End) {
    let quantity = Quantity::Inverse(Given::Kept);
    run(epsilon, out, &|u, out| dispatch(Batch { u, out, end, quantity, factor: None }));
}

/// Writes `u_of_one_minus_epsilon` of each element to `out`, as far as the shorter of the two slices reaches.
///
/// Every value is the one [`crate::u_of_one_minus_epsilon`] gives, to the bit; otherwise as [`epsilon_batch`].
///
/// # Examples
///
/// ```
/// use restitution::{End, u_of_one_minus_epsilon, u_of_one_minus_epsilon_batch};
///
/// let mut u = [0.0; 3];
/// u_of_one_minus_epsilon_batch(&[1e-12, 0.5, -0.1], &mut u, End::ZeroForce);
/// assert_eq!(u[0], u_of_one_minus_epsilon(1e-12, End::ZeroForce));
/// assert!(u[2].is_nan());
/// ```
pub fn u_of_one_minus_epsilon_batch(lost: &[f64], out: &mut [f64], end: End) {
    let quantity = Quantity::Inverse(Given::Lost);
    run(lost, out, &|u, out| dispatch(Batch { u, out, end, quantity, factor: None }));
}

impl<const ROWS: usize, const WIDTH: usize> Tier<ROWS, WIDTH> {
    /// Writes `epsilon(u)` of each element to `out`, as far as the shorter of the two reaches.
    ///
    /// Every value is the one [`epsilon`](Self::epsilon) gives, to the bit; otherwise as [`epsilon_batch`].
    pub fn epsilon_batch(&self, u: &[f64], out: &mut [f64]) {
        run(u, out, &|u, out| dispatch(TierBatch { tier: self, u, out }));
    }
}

impl Restitution {
    /// Writes the coefficients at `velocities` to `out`, as far as the shorter of the two reaches.
    ///
    /// Every value is the one [`epsilon`](Self::epsilon) gives, to the bit; otherwise as [`epsilon_batch`].
    pub fn epsilon_batch(&self, velocities: &[f64], out: &mut [f64]) {
        self.batch(velocities, out, Quantity::Kept);
    }

    /// Writes one less the coefficients at `velocities` to `out`, as far as the shorter of the two reaches.
    ///
    /// Every value is the one [`one_minus_epsilon`](Self::one_minus_epsilon) gives, to the bit.
    pub fn one_minus_epsilon_batch(&self, velocities: &[f64], out: &mut [f64]) {
        self.batch(velocities, out, Quantity::Lost);
    }

    /// Writes `u` of `velocities` to `out`, as far as the shorter of the two reaches.
    ///
    /// Every value is the one [`u`](Self::u) gives, to the bit.
    pub fn u_batch(&self, velocities: &[f64], out: &mut [f64]) {
        self.batch(velocities, out, Quantity::U);
    }

    fn batch(&self, velocities: &[f64], out: &mut [f64], quantity: Quantity) {
        let (end, factor) = (self.end(), Some(*self));
        run(velocities, out, &|u, out| dispatch(Batch { u, out, end, quantity, factor }));
    }
}

/// Runs `job` on the common part of the slices, shared out to threads if that pays and is asked for.
fn run(arguments: &[f64], out: &mut [f64], job: &(impl Fn(&[f64], &mut [f64]) + Sync)) {
    let length = arguments.len().min(out.len());
    let (arguments, out) = (&arguments[..length], &mut out[..length]);
    #[cfg(feature = "rayon")]
    {
        use rayon::prelude::*;
        if is_shared(length) {
            arguments.par_chunks(SHARE).zip(out.par_chunks_mut(SHARE)).for_each(|(u, out)| job(u, out));
            return;
        }
    }
    job(arguments, out);
}

/// Elements of a share: some 20 microseconds of work, half of a first-level cache.
#[cfg(feature = "rayon")]
const SHARE: usize = 16_384;

/// Whether a slice is worth sharing out: four shares are.
#[cfg(feature = "rayon")]
fn is_shared(length: usize) -> bool {
    length >= 4 * SHARE
}

/// Work that a machine does.
trait Work {
    fn run(self, machine: impl machine::Machine);
}

/// Does work with the widest vectors of the processor at hand.
fn dispatch(work: impl Work) {
    #[cfg(all(feature = "simd", target_arch = "x86_64"))]
    {
        x86::run(work);
    }
    #[cfg(not(all(feature = "simd", target_arch = "x86_64")))]
    {
        work.run(machine::Compiled);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{epsilon, one_minus_epsilon};

    const ENDS: [End; 2] = [End::ZeroCompression, End::ZeroForce];

    #[test]
    fn a_batch_gives_what_single_calls_give() {
        let spread: [f64; 3000] = core::array::from_fn(|i| 1e-8 * 1.009_f64.powi(i as i32));
        let few: [f64; 700] = core::array::from_fn(|i| (i as f64) * 0.009);
        let wide: [f64; 2047] =
            core::array::from_fn(|i| f64::from_bits((i as u64) << 52 | 0x5_a5a5_a5a5_a5a5));
        let odd = [f64::NAN, -1.0, -0.0, f64::INFINITY, 5e-324, 1e-310, 1e300, 7.0_f64.next_down()];
        let mut out = [0.0; 3000];
        for end in ENDS {
            let law = Restitution::from_g_star(0.3, end);
            for u in [&spread[..], &wide[..], &few[..], &few[7..], &odd[..], &few[..5], &few[..0]] {
                let mut compare = |batch: &dyn Fn(&[f64], &mut [f64]), single: &dyn Fn(f64) -> f64| {
                    batch(u, &mut out);
                    for (u, out) in u.iter().zip(&out) {
                        assert_eq!(out.to_bits(), single(*u).to_bits(), "{u:e}, {end:?}");
                    }
                };
                compare(&|u, out| epsilon_batch(u, out, end), &|u| epsilon(u, end));
                compare(&|u, out| one_minus_epsilon_batch(u, out, end), &|u| one_minus_epsilon(u, end));
                compare(&|u, out| u_of_epsilon_batch(u, out, end), &|u| crate::u_of_epsilon(u, end));
                compare(&|u, out| u_of_one_minus_epsilon_batch(u, out, end), &|u| {
                    crate::u_of_one_minus_epsilon(u, end)
                });
                compare(&|u, out| law.epsilon_batch(u, out), &|g| law.epsilon(g));
                compare(&|u, out| law.one_minus_epsilon_batch(u, out), &|g| law.one_minus_epsilon(g));
                compare(&|u, out| law.u_batch(u, out), &|g| law.u(g));
            }
        }
    }

    #[cfg(feature = "rayon")]
    #[test]
    fn slices_are_shared_out_from_65_536_elements_on() {
        assert!(!is_shared(0) && !is_shared(65_535) && is_shared(65_536) && is_shared(65_537));
    }

    #[cfg(feature = "std")]
    #[test]
    fn large_slices_are_shared_out_without_a_difference() {
        let u: Vec<f64> = (0..100_001).map(|i| f64::from(i) * 1e-4).collect();
        let mut out = vec![-1.0; u.len() + 3];
        epsilon_batch(&u, &mut out, End::ZeroForce);
        assert!(u.iter().zip(&out).all(|(u, out)| *out == epsilon(*u, End::ZeroForce)));
        assert_eq!(out[u.len()..], [-1.0; 3]);
    }
}
