//! Which piece of a table a coefficient belongs to, without a search.

use super::pieces::{ROWS, Rows};

/// A bucket is 1/128 of a factor of two: narrower in `epsilon` than the distance of any two centres.
const BITS: u32 = 7;
/// The least `epsilon` that has a bucket is `2^-48`, that at the end of the longest table.
const FIRST_KEPT: u64 = (1023 - 48) << BITS;
/// The least loss that has a bucket is `2^-5`: below, no piece is asked for.
const FIRST_LOST: u64 = (1023 - 5) << BITS;
/// The bucket of `1/2`, where those of losses follow.
const HALF: usize = 47 << BITS;
const BUCKETS: usize = 1 << 13;

/// For each bucket, of `epsilon` to 1/2 and of `1 - epsilon` below, the last piece whose centre lies above all of it.
#[derive(Debug)]
pub(crate) struct Index([u16; BUCKETS]);

impl Index {
    /// Returns the index of a table of so many pieces, along which `epsilon` falls.
    pub(crate) const fn of(table: &Rows<ROWS>, count: usize) -> Self {
        let (mut buckets, mut piece, mut lost) = ([0; BUCKETS], 0, 0);
        while HALF + lost < BUCKETS && lost <= 4 << BITS {
            let most = 1.0 - f64::from_bits((FIRST_LOST + lost as u64) << (52 - BITS));
            piece = last_above(table, count, piece, most);
            buckets[HALF + 1 + lost] = piece as u16;
            lost += 1;
        }
        let mut kept = HALF + 1;
        while kept > 0 {
            kept -= 1;
            let end = f64::from_bits((FIRST_KEPT + kept as u64 + 1) << (52 - BITS));
            piece = last_above(table, count, piece, end.next_down());
            buckets[kept] = piece as u16;
        }
        Self(buckets)
    }

    /// Returns the last piece whose centre lies above all of the bucket: the one before or at the last above `kept` itself.
    #[inline(always)]
    pub(crate) fn before(&self, kept: f64, lost: f64) -> usize {
        let of_kept = (kept.to_bits() >> (52 - BITS)).wrapping_sub(FIRST_KEPT);
        let of_lost = (lost.to_bits() >> (52 - BITS)).wrapping_sub(FIRST_LOST - HALF as u64 - 1);
        let bucket = if kept > 0.5 { of_lost } else { of_kept };
        usize::from(self.0[bucket as usize % BUCKETS])
    }
}

/// From `piece` on, the last one whose centre lies above `kept`.
const fn last_above(table: &Rows<ROWS>, count: usize, mut piece: usize, kept: f64) -> usize {
    while piece + 1 < count && table.constant(piece + 1) > kept {
        piece += 1;
    }
    piece
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluator::curve::Curve;
    use crate::evaluator::zero_compression::ZeroCompression;
    use crate::evaluator::zero_force::ZeroForce;

    /// At every end of a bucket and every centre, with neighbours, against the search along the table.
    fn is_the_search<C: Curve>() {
        let constant = |piece: usize| C::TABLE.constant(piece);
        let bucket = |i: u64| f64::from_bits((FIRST_KEPT + i) << (52 - BITS));
        let kept = (0..48 << BITS).map(bucket);
        let lost = (0..5 << BITS).map(|i| 1.0 - f64::from_bits((FIRST_LOST + i) << (52 - BITS)));
        let mut seen = [0, 0];
        for kept in kept.chain(lost).chain((0..C::COUNT).map(constant)) {
            for kept in [kept.next_down(), kept, kept.next_up()] {
                if (constant(C::COUNT - 1)..=1.0 - C::NEAR_END).contains(&kept) {
                    let found = last_above(C::TABLE, C::COUNT, 0, kept);
                    let before = C::INDEX.before(kept, 1.0 - kept);
                    assert!(before == found || before + 1 == found, "{kept:e}: {before}, {found}");
                    seen[found - before] += 1;
                }
            }
        }
        assert!(seen[0] > 1000 && seen[1] > 1000, "{seen:?}");
    }

    #[test]
    fn no_bucket_has_two_centres() {
        is_the_search::<ZeroCompression>();
        is_the_search::<ZeroForce>();
    }
}
