//! A geometric bound of a polynomial's coefficients, which bounds the upper half of a product.

use crate::fixed::power_of_two;
use restitution_real::Ball;
use rug::Integer;

/// `|c_i| <= 2^(top - slope i)` for `1 <= i <= order`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Envelope {
    /// Binary logarithm of the bound at `i = 0`.
    pub(crate) top: f64,
    /// Bits lost from one coefficient to the next.
    pub(crate) slope: f64,
}

impl Envelope {
    /// Returns the envelope of the given slope; `coefficients[0]` is left out.
    pub(crate) fn with_slope(coefficients: &[Integer], bits: u32, slope: f64) -> Self {
        let heights = coefficients.iter().enumerate().skip(1).filter(|(_, c)| !c.is_zero());
        let top = heights
            .map(|(i, c)| f64::from(c.significant_bits()) - f64::from(bits) + slope * i as f64)
            .fold(-f64::from(bits) - 1.0, f64::max);
        Self { top, slope }
    }

    /// Bits lost per degree on the whole way from 1 to the first degree left out.
    pub(crate) fn decay_seen(&self, order: usize) -> f64 {
        self.slope - self.top / (order + 1) as f64
    }

    /// Returns the envelope among a few slopes that bounds the square's upper half best.
    pub(crate) fn tightest(coefficients: &[Integer], bits: u32) -> Self {
        let order = coefficients.len() - 1;
        let last = f64::from(bits) / order as f64;
        let value = |e: &Self| 2.0 * e.top - e.slope * (order + 1) as f64;
        (2..=12)
            .map(|eighth| Self::with_slope(coefficients, bits, last * f64::from(eighth) / 8.0))
            .min_by(|x, y| value(x).total_cmp(&value(y)))
            .unwrap_or(Self { top: f64::INFINITY, slope: last })
    }
}

/// A bound of `Sum_(k>order) Sum_(i+j=k, 1<=i,j<=order) |x_i y_j|`.
///
/// ```text
/// Sum_(k>N) (2N - k + 1) 2^(X + Y - s k) <= N 2^(X + Y - s (N+1))/(1 - 2^-s)
/// ```
///
/// Both envelopes must have the same slope `s > 0`.
pub(crate) fn upper_half(x: Envelope, y: Envelope, order: usize) -> Ball {
    beyond(x, y, order + 1, order)
}

/// A bound of `Sum_(k>=first) Sum_(i+j=k, i,j>=1) |x_i y_j|` where `i` runs over `terms` values at most.
pub(crate) fn beyond(x: Envelope, y: Envelope, first: usize, terms: usize) -> Ball {
    let s = x.slope.min(y.slope);
    // The doubles are off by far less than the whole bit added here.
    let log = x.top + y.top - s * first as f64 + (terms as f64).log2() - (1.0 - (-s).exp2()).log2() + 1.0;
    power_of_two(log.ceil().clamp(-1e9, 1e9) as i64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bound_covers_a_geometric_square() {
        let bits = 60;
        let c: Vec<Integer> =
            (0..20u32).map(|i| (Integer::from(1) << bits) / (Integer::from(3).pow(i))).collect();
        let mut upper = Integer::new();
        for i in 1..20usize {
            for j in 1..20usize {
                if i + j >= 20 {
                    upper += Integer::from(&c[i] * &c[j]);
                }
            }
        }
        let e = Envelope::tightest(&c, bits);
        let bound = upper_half(e, e, 19).to_f64();
        let truth = upper.to_f64() * (-2.0 * f64::from(bits)).exp2();
        assert!(truth <= bound && bound < 300.0 * truth, "{truth} {bound}");
    }

    /// `|c_i| <= 2^(top - slope i)` from the first one on, and for one of them no power of two lower.
    #[test]
    fn an_envelope_lies_on_its_coefficients() {
        for c in [[1_000_000_i32, 40, -700, 3, 0], [5, 0, 0, 0, -1], [0, 255, 256, -7, 2], [9, 0, 0, 0, 0]] {
            for slope in [0.0, 1.5, 4.0] {
                let e = Envelope::with_slope(&c.map(Integer::from), 10, slope);
                let above = |i: usize| e.top - slope * i as f64 + 10.0 - f64::from(c[i].abs()).log2();
                let least = (1..5).filter(|i| c[*i] != 0).map(above).fold(f64::INFINITY, f64::min);
                assert!(least.is_infinite() || (least > 0.0 && least <= 1.0), "{c:?} {slope}: {least}");
                assert!(least.is_finite() || e.top == -11.0);
            }
        }
    }

    /// The products of two geometric series from a degree on, summed.
    #[test]
    fn what_lies_beyond_a_degree_is_bounded() {
        for (slope, first, terms) in
            [(6.0, 4, 3), (3.0, 2, 3), (0.03, 2001, 2000), (0.25, 201, 200), (0.5, 300, 200)]
        {
            let e = |top: f64, slope: f64| Envelope { top, slope };
            let pairs = |k: usize| (k - 1).min(terms).saturating_sub(k.saturating_sub(terms + 1).min(terms));
            let truth: f64 =
                (first..=2 * terms).map(|k| pairs(k) as f64 * f64::exp2(2.5 - slope * k as f64)).sum();
            let bound = beyond(e(-1.5, slope), e(4.0, slope), first, terms).to_f64();
            let slack = bound / truth;
            assert!(
                slack >= 1.0 && slack < if first == terms + 1 { 6.0 } else { 12.0 },
                "{slope} {first}: {slack}"
            );
            // The flatter of the two is taken.
            assert_eq!(bound, beyond(e(-1.5, slope), e(4.0, slope + 1.0), first, terms).to_f64());
            assert_eq!(bound, beyond(e(-1.5, slope + 1.0), e(4.0, slope), first, terms).to_f64());
        }
        let e = Envelope { top: 0.5, slope: 2.0 };
        assert_eq!(upper_half(e, e, 7).to_f64(), beyond(e, e, 8, 7).to_f64());
    }

    use rug::ops::Pow;
}
