//! Many arguments of a tier.

use super::Work;
use super::block::evaluate;
use super::machine::{BLOCK, Block, Machine};
use crate::evaluator::pieces::{Rows, WORDS};
use crate::evaluator::tier::Tier;

/// Rows of a copy in the form that machines read, made once for each batch: of a small table and of a larger one.
const ROWS_OF_A_COPY: [usize; 2] = [64, 256];
/// Shorter batches are not worth the copy.
const SHORTEST: [usize; 2] = [128, 512];

/// A batch of a tier.
pub(super) struct TierBatch<'a, const ROWS: usize, const WIDTH: usize> {
    pub(super) tier: &'a Tier<ROWS, WIDTH>,
    pub(super) u: &'a [f64],
    pub(super) out: &'a mut [f64],
}

impl<const ROWS: usize, const WIDTH: usize> Work for TierBatch<'_, ROWS, WIDTH> {
    #[inline(always)]
    fn run(self, machine: impl Machine) {
        let Self { tier, u, out } = self;
        let worth = |size: usize| ROWS <= ROWS_OF_A_COPY[size] && u.len() >= SHORTEST[size];
        if worth(0) {
            in_copy::<{ ROWS_OF_A_COPY[0] }, ROWS, WIDTH>(machine, tier, u, out);
        } else if worth(1) {
            in_copy::<{ ROWS_OF_A_COPY[1] }, ROWS, WIDTH>(machine, tier, u, out);
        } else {
            u.iter().zip(out).for_each(|(u, out)| *out = tier.epsilon(*u));
        }
    }
}

/// Whether an argument lies inside of the table.
#[inline(always)]
fn is_inside<const ROWS: usize, const WIDTH: usize>(tier: &Tier<ROWS, WIDTH>, u: f64) -> bool {
    (0.0 <= u) & (u < tier.far())
}

#[inline(always)]
fn in_copy<const N: usize, const ROWS: usize, const WIDTH: usize>(
    machine: impl Machine,
    tier: &Tier<ROWS, WIDTH>,
    u: &[f64],
    out: &mut [f64],
) {
    let rows: Rows<N> = Rows::copied(tier.rows());
    let last = u.len() - BLOCK;
    for next in (0..u.len()).step_by(BLOCK) {
        let start = next.min(last);
        let arguments: &[f64; BLOCK] = u[start..].first_chunk().expect("a block");
        let values = out[start..].first_chunk_mut().expect("a block");
        block(machine, tier, &rows, arguments, values);
    }
}

#[inline(always)]
fn block<const N: usize, const ROWS: usize, const WIDTH: usize>(
    machine: impl Machine,
    tier: &Tier<ROWS, WIDTH>,
    rows: &Rows<N>,
    u: &[f64; BLOCK],
    out: &mut [f64; BLOCK],
) {
    let mut inside = true;
    let (mut start, mut distance) = (Block::zeros(), Block::zeros());
    for i in 0..BLOCK {
        inside &= is_inside(tier, u[i]);
        let (row, s) = tier.place(u[i]);
        (start[i], distance[i]) = (row.wrapping_mul(WORDS), s);
    }
    machine.tier::<N, WIDTH>(rows, &start, &distance, out);
    if !inside {
        let mut full = [0.0; BLOCK];
        evaluate(machine, tier.end(), u, &mut full);
        for i in 0..BLOCK {
            out[i] = if is_inside(tier, u[i]) { out[i] } else { full[i] };
        }
    }
}
