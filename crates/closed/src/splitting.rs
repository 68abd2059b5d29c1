//! Sums of hypergeometric terms by binary splitting: integers at the bottom, balls at the top.

use rayon::prelude::*;
use restitution_real::Ball;
use rug::Integer;

/// Terms `t_n = w(n) prod_(i=1..n) p(i)/q(i)` of a series, all of them integers but the quotient.
pub(crate) trait Terms: Sync {
    /// `p(i)`, `i >= 1`.
    fn numerator(&self, i: i64) -> Integer;
    /// `q(i)`, `i >= 1`, not zero.
    fn denominator(&self, i: i64) -> Integer;
    /// `w(n)`, `n >= 0`.
    fn weight(&self, n: i64) -> Integer;
    /// Bits by which `|p(i)/q(i)|` is below 1, in thousandths, for every `i`, rounded down.
    fn millibits_per_term(&self) -> u64;
}

/// What is known of the terms `lo <= n < hi`: their sum is `sum/denominator` times the product of all earlier quotients.
struct Block {
    lo: i64,
    numerator: Integer,
    denominator: Integer,
    sum: Integer,
}

/// Terms summed one after the other at the bottom of the tree: below this, splitting costs more than it saves.
const LEAF: i64 = 16;
/// Bits beyond what a block has to be known to.
const GUARD: u64 = 64;

/// Returns `t_0 + ... + t_(count-1)` as a ball of `bits` bits.
///
/// The terms are cut into blocks whose integers are about as long as the precision asked for. Each is
/// split in halves (`P = P_1 P_2`, `Q = Q_1 Q_2`, `T = T_1 Q_2 + P_1 T_2`, exact), all of them at the same
/// time on the processors there are; then, from the last to the first,
///
/// ```text
/// R_b = (T_b + P_b R_(b+1))/Q_b,      sum = R_1
/// ```
///
/// in balls, a block that starts at term `n` with so many bits fewer as the product of the first `n`
/// quotients has zeros. (Brent; Haible and Papanikolaou 1998.) Cost: `O(M(bits) log^2 bits)`.
pub(crate) fn sum(terms: &impl Terms, count: u64, bits: u32) -> Ball {
    let count = i64::try_from(count).expect("fewer terms than bits of memory").max(1);
    let length = u64::from(terms.denominator(count).significant_bits());
    let width = i64::try_from(u64::from(bits) / length).unwrap_or(i64::MAX).max(LEAF);
    let starts: Vec<i64> = (0..count).step_by(usize::try_from(width).unwrap_or(usize::MAX)).collect();
    let blocks: Vec<Block> =
        starts.into_par_iter().map(|lo| split(terms, lo, count.min(lo.saturating_add(width)))).collect();
    let mut rest = Ball::from_integer(0, 64);
    for block in blocks.into_iter().rev() {
        let spared = u64::try_from(block.lo).unwrap_or(0).saturating_mul(terms.millibits_per_term()) / 1000;
        let prec = u32::try_from((u64::from(bits) + GUARD).saturating_sub(spared).max(GUARD)).unwrap_or(bits);
        let ball = |n: &Integer| Ball::from_big_integer(n, prec);
        rest = (ball(&block.sum) + ball(&block.numerator) * rest.with_prec(prec)) / ball(&block.denominator);
    }
    rest.with_prec(bits)
}

/// The terms `lo <= n < hi`, exactly.
fn split(terms: &impl Terms, lo: i64, hi: i64) -> Block {
    if hi - lo <= LEAF {
        return one_by_one(terms, lo, hi);
    }
    let middle = lo + (hi - lo) / 2;
    let (left, right) = (split(terms, lo, middle), split(terms, middle, hi));
    let sum = left.sum * &right.denominator + &left.numerator * right.sum;
    let numerator = left.numerator * right.numerator;
    Block { lo, numerator, denominator: left.denominator * right.denominator, sum }
}

fn one_by_one(terms: &impl Terms, lo: i64, hi: i64) -> Block {
    let mut block =
        Block { lo, numerator: Integer::from(1), denominator: Integer::from(1), sum: Integer::new() };
    for n in lo..hi {
        if n > 0 {
            let denominator = terms.denominator(n);
            block.numerator *= terms.numerator(n);
            block.sum *= &denominator;
            block.denominator *= denominator;
        }
        block.sum += &block.numerator * terms.weight(n);
    }
    block
}
