//! Vectors of 256 and 512 bits: rows are loaded whole and transposed in registers.

use super::Work;
use super::machine::{BLOCK, Block, Compiled, Machine, Reading};
use crate::evaluator::fifth_root::{ROOTS, piece_at};
use crate::evaluator::pieces::{LENGTH, LIFT_SEVENTH, LIFT_SIXTH, Rows};
use crate::evaluator::rounding::{Divided, Number, Rooted};
use crate::evaluator::tier::value;
use core::arch::x86_64::__m128d;
use core::ops::Mul;
use pulp::x86::{V3, V4};
use pulp::{NullaryFnOnce, Simd, cast, f64x4};

/// Does work with the widest vectors of the processor at hand.
pub(super) fn run(work: impl Work) {
    if let Some(simd) = V4::try_new() {
        simd.vectorize(Job { work, machine: simd });
    } else if let Some(simd) = V3::try_new() {
        simd.vectorize(Job { work, machine: simd });
    } else {
        work.run(Compiled);
    }
}

/// Work that is compiled for a machine.
struct Job<W, M> {
    work: W,
    machine: M,
}

impl<W: Work, M: Machine> NullaryFnOnce for Job<W, M> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        self.work.run(self.machine);
    }
}

/// What is not the same for all widths.
trait Width: Simd {
    /// Returns column `k` of the rows in vector `k`.
    fn columns<const N: usize>(self, table: &Rows<N>, index: &[u64]) -> [Self::f64s; 8];

    /// Returns the roots and the reciprocals of pieces of the fifth root.
    fn roots(self, index: &[u64]) -> [Self::f64s; 2];

    /// Returns the bits of each number [`LIFT_SIXTH`] places higher.
    fn sixth(self, x: Self::f64s) -> Self::f64s;

    /// Returns the bits of each number [`LIFT_SEVENTH`] places higher.
    fn seventh(self, x: Self::f64s) -> Self::f64s;
}

/// A piece of the fifth root; the last one for an index beyond.
#[inline(always)]
fn root(index: u64) -> __m128d {
    cast(ROOTS[piece_at(index)])
}

impl Width for V4 {
    #[inline(always)]
    fn roots(self, index: &[u64]) -> [Self::f64s; 2] {
        let (low, high) = index.split_at(4);
        let simd: &V3 = &self;
        let ([a, b], [c, d]) = (Width::roots(*simd, low), Width::roots(*simd, high));
        [cast([a, c]), cast([b, d])]
    }

    #[inline(always)]
    fn columns<const N: usize>(self, table: &Rows<N>, index: &[u64]) -> [Self::f64s; 8] {
        let (low, high) = index.split_at(4);
        let simd: &V3 = &self;
        let [a0, a1, a2, a3, a4, a5, a6, a7] = simd.columns(table, low);
        let [b0, b1, b2, b3, b4, b5, b6, b7] = simd.columns(table, high);
        [
            cast([a0, b0]),
            cast([a1, b1]),
            cast([a2, b2]),
            cast([a3, b3]),
            cast([a4, b4]),
            cast([a5, b5]),
            cast([a6, b6]),
            cast([a7, b7]),
        ]
    }

    #[inline(always)]
    fn sixth(self, x: Self::f64s) -> Self::f64s {
        cast(self.avx512f._mm512_slli_epi64::<LIFT_SIXTH>(cast(x)))
    }

    #[inline(always)]
    fn seventh(self, x: Self::f64s) -> Self::f64s {
        cast(self.avx512f._mm512_slli_epi64::<LIFT_SEVENTH>(cast(x)))
    }
}

impl Width for V3 {
    #[inline(always)]
    fn roots(self, index: &[u64]) -> [Self::f64s; 2] {
        let &[i0, i1, i2, i3] = index.first_chunk().expect("a vector of indexes");
        self.interleaved([root(i0), root(i1), root(i2), root(i3)])
    }

    #[inline(always)]
    fn columns<const N: usize>(self, table: &Rows<N>, index: &[u64]) -> [Self::f64s; 8] {
        let &[i0, i1, i2, i3] = index.first_chunk().expect("a vector of indexes");
        let [a, b, c, d]: [[__m128d; 4]; 4] = [i0, i1, i2, i3].map(|start| cast(*table.words(start)));
        let [c0, c1] = self.interleaved([a[0], b[0], c[0], d[0]]);
        let [c2, c3] = self.interleaved([a[1], b[1], c[1], d[1]]);
        let [c4, c5] = self.interleaved([a[2], b[2], c[2], d[2]]);
        let [c6, c7] = self.interleaved([a[3], b[3], c[3], d[3]]);
        [c0, c1, c2, c3, c4, c5, c6, c7]
    }

    #[inline(always)]
    fn sixth(self, x: Self::f64s) -> Self::f64s {
        cast(self.avx2._mm256_slli_epi64::<{ LIFT_SIXTH as i32 }>(cast(x)))
    }

    #[inline(always)]
    fn seventh(self, x: Self::f64s) -> Self::f64s {
        cast(self.avx2._mm256_slli_epi64::<{ LIFT_SEVENTH as i32 }>(cast(x)))
    }
}

/// A step of the transposition of rows in quarters.
trait Quarters {
    /// The two columns of a quarter of four rows: halves are loaded to their places, then interleaved.
    fn interleaved(self, rows: [__m128d; 4]) -> [f64x4; 2];
}

impl Quarters for V3 {
    #[inline(always)]
    fn interleaved(self, [a, b, c, d]: [__m128d; 4]) -> [f64x4; 2] {
        let (even, odd) = (self.avx._mm256_set_m128d(c, a), self.avx._mm256_set_m128d(d, b));
        [cast(self.avx._mm256_unpacklo_pd(even, odd)), cast(self.avx._mm256_unpackhi_pd(even, odd))]
    }
}

/// Numbers side by side.
#[derive(Clone, Copy)]
struct Vector<S: Simd>(S, S::f64s);

impl<S: Width> Mul for Vector<S> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self(self.0, self.0.mul_f64s(self.1, other.1))
    }
}

impl<S: Width> Number for Vector<S> {
    /// As single calls round it: fused only where the crate is compiled for that.
    #[inline(always)]
    fn multiply_add(self, b: Self, c: Self) -> Self {
        let simd = self.0;
        let value = if cfg!(target_feature = "fma") {
            simd.mul_add_f64s(self.1, b.1, c.1)
        } else {
            simd.add_f64s(simd.mul_f64s(self.1, b.1), c.1)
        };
        Self(simd, value)
    }

    #[inline(always)]
    fn negated(self) -> Self {
        Self(self.0, self.0.neg_f64s(self.1))
    }

    #[inline(always)]
    fn of(&self, constant: f64) -> Self {
        Self(self.0, self.0.splat_f64s(constant))
    }
}

impl<S: Width> Divided for Vector<S> {
    #[inline(always)]
    fn over(self, divisor: Self) -> Self {
        Self(self.0, self.0.div_f64s(self.1, divisor.1))
    }
}

impl<S: Width> Rooted for Vector<S> {
    #[inline(always)]
    fn square_root(self) -> Self {
        Self(self.0, self.0.sqrt_f64s(self.1))
    }
}

impl<S: Width> Machine for S {
    #[inline(always)]
    fn read<R: Reading, const N: usize>(
        self,
        table: &Rows<N>,
        start: &Block<u64>,
        t: &Block<f64>,
        out: &mut [f64; BLOCK],
    ) {
        let (t, _) = S::as_simd_f64s(&t[..]);
        let (out, _) = S::as_mut_simd_f64s(&mut out[..]);
        for ((t, out), start) in t.iter().zip(out).zip(start.chunks_exact(S::F64_LANES)) {
            let (c, complement) = row(self, table, start);
            *out = R::of(&c, complement, Vector(self, *t)).1;
        }
    }

    #[inline(always)]
    fn tier<const N: usize, const WIDTH: usize>(
        self,
        table: &Rows<N>,
        start: &Block<u64>,
        distance: &Block<f64>,
        out: &mut [f64; BLOCK],
    ) {
        let (distance, _) = S::as_simd_f64s(&distance[..]);
        let (out, _) = S::as_mut_simd_f64s(&mut out[..]);
        for ((s, out), start) in distance.iter().zip(out).zip(start.chunks_exact(S::F64_LANES)) {
            let columns = self.columns(table, start);
            let c: [Vector<S>; WIDTH] = core::array::from_fn(|k| Vector(self, columns[k]));
            *out = value(&c, Vector(self, *s)).1;
        }
    }

    #[inline(always)]
    fn roots(self, index: &Block<u64>, root: &mut Block<f64>, reciprocal: &mut Block<f64>) {
        let (root, _) = S::as_mut_simd_f64s(&mut root[..]);
        let (reciprocal, _) = S::as_mut_simd_f64s(&mut reciprocal[..]);
        for ((root, reciprocal), index) in
            root.iter_mut().zip(reciprocal).zip(index.chunks_exact(S::F64_LANES))
        {
            [*root, *reciprocal] = Width::roots(self, index);
        }
    }
}

/// The coefficients of the rows that start at these words, and the complements.
#[inline(always)]
fn row<S: Width, const N: usize>(
    simd: S,
    table: &Rows<N>,
    start: &[u64],
) -> ([Vector<S>; LENGTH], Vector<S>) {
    let [c0, c1, c2, c3, c4, c5, complement, _] = simd.columns(table, start);
    let c = [c0, c1, c2, c3, c4, c5, simd.sixth(c5), simd.seventh(c4)];
    (c.map(|c| Vector(simd, c)), Vector(simd, complement))
}

#[cfg(test)]
mod tests {
    use super::super::block::{Batch, Quantity};
    use super::*;
    use crate::evaluator::inverse::Given;
    use crate::{End, Restitution};

    #[test]
    fn every_width_gives_the_same_bits() {
        let u: Vec<f64> = (0..9000).map(|i| 1e-18 * 1.008_f64.powi(i)).chain([f64::NAN, -1.0, 0.0]).collect();
        let law = Restitution::from_g_star(0.7, End::ZeroForce);
        for end in [End::ZeroCompression, End::ZeroForce] {
            for quantity in [
                Quantity::Kept,
                Quantity::Lost,
                Quantity::U,
                Quantity::Inverse(Given::Kept),
                Quantity::Inverse(Given::Lost),
            ] {
                for factor in [None, Some(law)] {
                    let bits = |run: &dyn Fn(Batch)| {
                        let mut out = vec![0.0; u.len()];
                        run(Batch { u: &u, out: &mut out, end, quantity, factor });
                        out.iter().map(|x| x.to_bits()).collect::<Vec<_>>()
                    };
                    let compiled = bits(&|batch| batch.run(Compiled));
                    if let Some(machine) = V3::try_new() {
                        let narrow = bits(&|batch| machine.vectorize(Job { work: batch, machine }));
                        assert_eq!(compiled, narrow, "256 bits");
                    }
                    if let Some(machine) = V4::try_new() {
                        let wide = bits(&|batch| machine.vectorize(Job { work: batch, machine }));
                        assert_eq!(compiled, wide, "512 bits");
                    }
                }
            }
        }
    }
}
