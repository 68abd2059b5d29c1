//! Products of integer polynomials by Kronecker substitution: one product of two long integers.

use rug::Integer;
use rug::integer::Order;

/// Limbs a coefficient of a product needs: `bits` for each factor, the sum of `len` terms, the sign.
fn slot_limbs(bits_a: u32, bits_b: u32, len: usize) -> usize {
    let bits = bits_a as usize + bits_b as usize + (usize::BITS - len.leading_zeros()) as usize + 2;
    bits.div_ceil(64)
}

/// Returns `sum_i values[i] * 2^(64 slot i)`.
///
/// Every `|values[i]|` must lie below `2^(64 slot)`. Cost: linear.
fn pack<'a>(values: impl ExactSizeIterator<Item = &'a Integer>, slot: usize) -> Integer {
    let len = values.len();
    let mut positive = vec![0u64; slot * len];
    let mut negative = vec![0u64; slot * len];
    for (i, value) in values.enumerate() {
        let limbs = value.significant_digits::<u64>();
        let target = if value.is_negative() { &mut negative } else { &mut positive };
        value.write_digits(&mut target[slot * i..slot * i + limbs], Order::Lsf);
    }
    Integer::from_digits(&positive, Order::Lsf) - Integer::from_digits(&negative, Order::Lsf)
}

/// Returns the first `len` coefficients of a packed polynomial whose coefficients lie strictly
/// between `-2^(64 slot - 1)` and `2^(64 slot - 1)`.
///
/// A bias of half a slot is added to every coefficient, so that all of them are read as digits.
fn unpack(packed: &Integer, slot: usize, len: usize) -> Vec<Integer> {
    let total = len.max(packed.significant_digits::<u64>().div_ceil(slot) + 1);
    let mut bias = vec![0u64; slot * total];
    for i in 1..=total {
        bias[slot * i - 1] = 1 << 63;
    }
    let shifted = packed + Integer::from_digits(&bias, Order::Lsf);
    let mut digits = shifted.to_digits::<u64>(Order::Lsf);
    digits.resize(slot * total.max(len), 0);
    let half = Integer::from(1) << u32::try_from(64 * slot - 1).unwrap_or(u32::MAX);
    digits.chunks_exact(slot).take(len).map(|slot| Integer::from_digits(slot, Order::Lsf) - &half).collect()
}

/// Returns the first `len` coefficients of the product of two integer polynomials.
///
/// ```text
/// c_k = sum_(i+j=k) a_i b_j,   k < len
/// ```
///
/// (Kronecker 1882; Harvey 2009 for variants.) Exact. Cost: one integer product.
pub fn product(a: &[Integer], b: &[Integer], len: usize) -> Vec<Integer> {
    let (a, b) = (&a[..a.len().min(len)], &b[..b.len().min(len)]);
    if a.is_empty() || b.is_empty() {
        return vec![Integer::new(); len];
    }
    let bits = |v: &[Integer]| v.iter().map(Integer::significant_bits).max().unwrap_or(0);
    let slot = slot_limbs(bits(a), bits(b), a.len().min(b.len()));
    unpack(&(pack(a.iter(), slot) * pack(b.iter(), slot)), slot, len)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_and_carries_survive() {
        let ints = |v: &[i64]| v.iter().map(|&x| Integer::from(x)).collect::<Vec<_>>();
        let a = ints(&[-1, i64::MAX, 0, i64::MIN, 5]);
        let b = ints(&[i64::MIN, -1, i64::MIN, i64::MAX]);
        let mut expected = vec![Integer::new(); 6];
        for (i, x) in a.iter().enumerate() {
            for (j, y) in b.iter().enumerate() {
                if i + j < 6 {
                    expected[i + j] += Integer::from(x * y);
                }
            }
        }
        assert_eq!(product(&a, &b, 6), expected);
        assert_eq!(product(&a, &[], 3), ints(&[0, 0, 0]));
    }
}
