use crate::{End, zero_compression, zero_force};

/// Arguments that are looked at together.
const BLOCK: usize = 32;

/// Writes `epsilon(u)` of each element to `out`, as far as the shorter of the two slices reaches.
///
/// Every value is the one [`crate::epsilon`] gives, to the bit. Blocks run without branches where they can, which the
/// compiler vectorises, with gathers where the target has them.
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
    for (u, out) in u.chunks(BLOCK).zip(out.chunks_mut(BLOCK)) {
        match end {
            End::ZeroCompression => compression_block(u, out),
            End::ZeroForce => force_block(u, out),
        }
    }
}

fn compression_block(u: &[f64], out: &mut [f64]) {
    let (_, last) = span(u);
    if last < zero_compression::TABLE_END.to_bits() {
        each(u, out, zero_compression::epsilon_within);
    } else if last < zero_compression::LARGE.to_bits() {
        each(u, out, zero_compression::epsilon_to_large);
    } else {
        each(u, out, zero_compression::epsilon);
    }
}

fn force_block(u: &[f64], out: &mut [f64]) {
    let (first, last) = span(u);
    let near_end = zero_force::NEAR_END.to_bits();
    if last >= zero_force::TABLE_END.to_bits() {
        each(u, out, zero_force::epsilon);
    } else if first >= near_end {
        each(u, out, zero_force::epsilon_within);
    } else if last < near_end {
        each(u, out, |u| 1.0 - zero_force::near(u));
    } else {
        each(u, out, zero_force::epsilon_to_far);
    }
}

/// The least and the largest of the bit patterns, which are ordered as the numbers from 0 on; infinity, NaN and what
/// has a sign come after every number.
fn span(u: &[f64]) -> (u64, u64) {
    u.iter().fold((u64::MAX, 0), |(first, last), u| (first.min(u.to_bits()), last.max(u.to_bits())))
}

#[inline(always)]
fn each(u: &[f64], out: &mut [f64], f: impl Fn(f64) -> f64) {
    for (u, out) in u.iter().zip(out) {
        *out = f(*u);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::epsilon;

    #[test]
    fn a_batch_gives_what_single_calls_give() {
        let spread: [f64; 3000] = core::array::from_fn(|i| 1e-8 * 1.009_f64.powi(i as i32));
        let few: [f64; 700] = core::array::from_fn(|i| (i as f64) * 0.009);
        let odd = [f64::NAN, -1.0, -0.0, f64::INFINITY, 5e-324];
        let mut out = [0.0; 3000];
        for end in [End::ZeroCompression, End::ZeroForce] {
            for u in [&spread[..], &few[..], &few[7..], &odd[..], &few[..5]] {
                epsilon_batch(u, &mut out, end);
                for (u, out) in u.iter().zip(&out) {
                    assert_eq!(out.to_bits(), epsilon(*u, end).to_bits(), "{u:e}");
                }
            }
        }
    }
}
