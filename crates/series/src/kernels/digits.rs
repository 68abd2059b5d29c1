//! Sums of products of 32-bit digits with 25-bit halves of residues, in 64-bit integers.

use super::lanes::LANES;

/// Bits in the lower half of a residue.
pub(super) const HALF: u32 = 25;
pub(super) const HALF_MASK: u64 = (1 << HALF) - 1;
pub(super) const DIGIT_MASK: u64 = 0xffff_ffff;
/// Products below `2^57` that fit into 64 bits.
const LAZY: usize = 128;
/// Rows that are multiplied at once, and lines of the table that are taken together.
pub(super) const ROWS: usize = 4;

/// A table of numbers, line by line, each line a multiple of eight long.
pub(super) struct Digits {
    width: usize,
    numbers: Vec<u32>,
}

/// Four rows of sums `low + 2^32 high`, both far below `2^64`.
#[derive(Default)]
pub(super) struct Sums {
    width: usize,
    sums: Vec<u64>,
    low: Vec<u64>,
    high: Vec<u64>,
}

impl Sums {
    /// The low and the high parts of eight sums of a row.
    #[inline(always)]
    pub fn block(&self, row: usize, block: usize) -> (&[u64; LANES], &[u64; LANES]) {
        let place = row * self.width / LANES + block;
        (&self.low.as_chunks().0[place], &self.high.as_chunks().0[place])
    }
}

impl Digits {
    /// A table of zeros, with its lines a multiple of four and their length a multiple of eight.
    pub fn zero(lines: usize, width: usize) -> Self {
        let width = width.max(1).next_multiple_of(LANES);
        Self { width, numbers: vec![0; lines.next_multiple_of(ROWS) * width] }
    }

    pub fn width(&self) -> usize {
        self.width
    }

    pub fn lines(&self) -> usize {
        self.numbers.len() / self.width
    }

    pub fn line(&mut self, i: usize) -> &mut [u32] {
        &mut self.numbers[i * self.width..(i + 1) * self.width]
    }

    /// `sum_i factors_(i,r) table_(i,k)` for the first lines, whose number is a multiple of four.
    #[inline(always)]
    pub fn multiply(&self, factors: &[[u32; ROWS]], out: &mut Sums) {
        out.width = self.width;
        for part in [&mut out.sums, &mut out.low, &mut out.high] {
            part.clear();
            part.resize(ROWS * self.width, 0);
        }
        for (factors, lines) in factors.chunks(LAZY).zip(self.numbers.chunks(LAZY * self.width)) {
            for (factors, lines) in
                factors.as_chunks::<ROWS>().0.iter().zip(lines.chunks_exact(ROWS * self.width))
            {
                self.add(factors, lines, &mut out.sums);
            }
            for ((sum, low), high) in out.sums.iter_mut().zip(&mut out.low).zip(&mut out.high) {
                *low += *sum & DIGIT_MASK;
                *high += *sum >> 32;
                *sum = 0;
            }
        }
    }

    /// Adds the products of four lines with four factors each.
    #[inline(always)]
    fn add(&self, factors: &[[u32; ROWS]; ROWS], lines: &[u32], sums: &mut [u64]) {
        let width = self.width;
        let (a, rest) = lines.split_at(width);
        let (b, rest) = rest.split_at(width);
        let (c, d) = rest.split_at(width);
        let (w, rest) = sums.split_at_mut(width);
        let (x, rest) = rest.split_at_mut(width);
        let (y, z) = rest.split_at_mut(width);
        add_lines([w, x, y, z], a, b, &c[..width], &d[..width], factors);
    }
}

#[inline(always)]
fn add_lines(
    [w, x, y, z]: [&mut [u64]; ROWS],
    a: &[u32],
    b: &[u32],
    c: &[u32],
    d: &[u32],
    factors: &[[u32; ROWS]; ROWS],
) {
    let [e, f, g, h] = factors.map(|factors| factors.map(u64::from));
    let sums = w.iter_mut().zip(x).zip(y).zip(z);
    let lines = a.iter().zip(b).zip(c).zip(d);
    for ((((w, x), y), z), (((&a, &b), &c), &d)) in sums.zip(lines) {
        let (a, b, c, d) = (u64::from(a), u64::from(b), u64::from(c), u64::from(d));
        *w += a * e[0] + b * f[0] + c * g[0] + d * h[0];
        *x += a * e[1] + b * f[1] + c * g[1] + d * h[1];
        *y += a * e[2] + b * f[2] + c * g[2] + d * h[2];
        *z += a * e[3] + b * f[3] + c * g[3] + d * h[3];
    }
}
