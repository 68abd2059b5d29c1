//! Sums of products of 32-bit digits with 25-bit halves of residues, in 64-bit integers.

use super::lanes::{LANES, turn};

/// Bits in the lower half of a residue.
pub(super) const HALF: u32 = 25;
pub(super) const HALF_MASK: u64 = (1 << HALF) - 1;
pub(super) const DIGIT_MASK: u64 = 0xffff_ffff;
/// Products below `2^57` that fit into 64 bits.
const LAZY: usize = 128;
/// Rows that are multiplied at once.
pub(super) const ROWS: usize = 4;

/// A table of numbers in blocks of eight columns, each block line by line.
pub(super) struct Digits {
    lines: usize,
    blocks: usize,
    numbers: Vec<[u32; LANES]>,
}

/// Eight columns of four rows of sums `low + 2^32 high`, both far below `2^64`.
#[derive(Clone, Copy)]
pub(super) struct Sums {
    pub low: [[u64; LANES]; ROWS],
    pub high: [[u64; LANES]; ROWS],
}

impl Digits {
    /// A table of zeros with at least so many columns.
    pub fn zero(lines: usize, columns: usize) -> Self {
        let blocks = columns.max(1).div_ceil(LANES);
        Self { lines, blocks, numbers: vec![[0; LANES]; lines * blocks] }
    }

    pub fn lines(&self) -> usize {
        self.lines
    }

    pub fn blocks(&self) -> usize {
        self.blocks
    }

    /// The numbers of a line in a block.
    pub fn block_mut(&mut self, line: usize, block: usize) -> &mut [u32; LANES] {
        &mut self.numbers[block * self.lines + line]
    }

    /// `sum_i factors_(i,r) table_(i,k)` over the first lines for the columns of a block.
    #[inline(always)]
    pub fn multiply(&self, factors: &[[u64; ROWS]], block: usize) -> Sums {
        let column = &self.numbers[block * self.lines..(block + 1) * self.lines];
        let mut out = Sums { low: [[0; LANES]; ROWS], high: [[0; LANES]; ROWS] };
        for (factors, column) in factors.chunks(LAZY).zip(column.chunks(LAZY)) {
            let mut sums = [[0u64; LANES]; ROWS];
            for (factors, numbers) in factors.iter().zip(column) {
                turn();
                for (l, &number) in numbers.iter().enumerate() {
                    let number = u64::from(number);
                    sums[0][l] += number * (factors[0] & DIGIT_MASK);
                    sums[1][l] += number * (factors[1] & DIGIT_MASK);
                    sums[2][l] += number * (factors[2] & DIGIT_MASK);
                    sums[3][l] += number * (factors[3] & DIGIT_MASK);
                }
            }
            for (r, sums) in sums.iter().enumerate() {
                for (l, sum) in sums.iter().enumerate() {
                    out.low[r][l] += sum & DIGIT_MASK;
                    out.high[r][l] += sum >> 32;
                }
            }
        }
        out
    }
}
