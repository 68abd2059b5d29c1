//! The known coefficients from which the bound on all others is derived.

use crate::turning_time;
use num_rational::BigRational;
use num_traits::{One, Zero};
use restitution_law::{ForceLaw, Lattice};
use restitution_real::{Ball, Magnitude, kronecker};
use rug::{Float, Integer};

/// Bits with which a head of so many leading terms is enclosed.
///
/// Only the size of the coefficients matters, but the last ones are the smallest: they fall by up to
/// 3 bits a term against the precision that a product of series keeps.
fn head_bits(elastic_terms: usize) -> u32 {
    64 + 3 * u32::try_from(elastic_terms).unwrap_or(u32::MAX / 4)
}

/// Upper bounds of `|L|, |A|, |B|, |F|` at one exponent `e = grade/unit`, scaled by `T^e`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Term {
    pub grade: i64,
    pub damping_order: usize,
    pub elastic_index: usize,
    pub logarithmic: Magnitude,
    pub elastic: Magnitude,
    pub damping: Magnitude,
    pub trajectory: Magnitude,
}

/// All coefficients with `e <= limit/unit` and at most the given damping order.
///
/// ```text
/// L = t d/dt log F,   A = F^(a-1),   B = F^gamma,   D = t d/dt
/// (D + 1) L = -L^2 - s A - w B (1 + L),   D A = (a-1) L A,   D B = gamma L B,   D F = L F
/// ```
///
/// (`docs/error-bounds.md`, section 2.) The system is quadratic and causal: `D` multiplies a
/// coefficient by its exponent `e`, and the right sides need nothing later.
#[derive(Clone, Debug)]
pub(super) struct Head {
    /// By ascending grade.
    pub terms: Vec<Term>,
    /// The largest grade in the head.
    pub limit: i64,
    pub lattice: Lattice,
    /// `T^(a+1)`, which carries `s` at the turning point.
    pub elastic_scale: Ball,
    /// `T^(gamma+1)`, which carries `w/u` at the turning point.
    pub damping_scale: Ball,
}

impl Head {
    /// Encloses the head that reaches to `s^elastic_terms` at damping order 0.
    ///
    /// Cost: for `N` orders and `J` terms about `2 N^2` products of series of `J` terms, `4 N J^2`
    /// operations on balls of 64 bits.
    pub fn new(law: &ForceLaw, damping_order: usize, elastic_terms: usize) -> Self {
        let lattice = law.lattice();
        // Half a step more, so that no product of two terms ends on the edge by accident.
        let limit = lattice.elastic * as_i64(elastic_terms) + lattice.elastic / 2;
        let mut system = System::new(law, head_bits(elastic_terms));
        let mut terms = Vec::new();
        for n in 0..=damping_order {
            let Ok(left) = u64::try_from(limit - lattice.damping * as_i64(n)) else { break };
            let width = usize::try_from(left / lattice.elastic.unsigned_abs()).unwrap_or(0) + 1;
            system.add_order(width);
            terms.extend((0..width).map(|j| system.term(n, j)));
        }
        terms.sort_by_key(|term| term.grade);
        Self {
            terms,
            limit,
            lattice,
            elastic_scale: system.elastic_scale,
            damping_scale: system.damping_scale,
        }
    }
}

/// One series of the head: its coefficients by order in the damping, ready for products.
#[derive(Default)]
struct Series {
    rows: Vec<Vec<Ball>>,
    factors: Vec<Factor>,
}

impl Series {
    fn push(&mut self, row: Vec<Ball>, bits: u32) {
        self.factors.push(Factor::new(&row, bits));
        self.rows.push(row);
    }

    /// Returns `sum_(0<k<n) x_k y_(n-k)`, the part of order `n` of a product that is known before it.
    fn cross(x: &Self, y: &Self, width: usize, bits: u32) -> Vec<Ball> {
        let n = x.factors.len();
        sum_of_products((1..n).map(|k| (1, &x.factors[k], &y.factors[n - k])), width, bits)
    }

    /// As [`Series::cross`] of a series with itself, each pair once.
    fn cross_square(&self, width: usize, bits: u32) -> Vec<Ball> {
        let n = self.factors.len();
        let weight = |k: usize| if 2 * k < n { 2 } else { 1 };
        let pairs = (1..=n / 2).map(|k| (weight(k), &self.factors[k], &self.factors[n - k]));
        sum_of_products(pairs, width, bits)
    }
}

/// A row in units of `2^-bits`, none of whose coefficients is off by more than `error` units.
struct Factor {
    integers: Vec<Integer>,
    error: Magnitude,
    norm: Magnitude,
}

impl Factor {
    fn new(row: &[Ball], bits: u32) -> Self {
        let integer = |x: &Ball| Float::with_val(x.prec(), x.mid() << bits).to_integer().unwrap_or_default();
        let radius = |x: &Ball| Magnitude::of(&Ball::exact(x.rad().clone()).shifted(bits as i32));
        // To the nearest integer: half a unit; not finite: no bound.
        let largest = row.iter().map(radius).fold(Magnitude::ZERO, |x, y| if x < y { y } else { x });
        let norm = row.iter().map(|x| Magnitude::of(&x.shifted(bits as i32))).sum();
        Self { integers: row.iter().map(integer).collect(), error: largest + Magnitude::ONE, norm }
    }
}

/// The first `len` coefficients of a sum of products: the integers' product is exact, and each coefficient is off by at
/// most `||x|| error_y + error_x (||y|| + len error_y)`.
fn sum_of_products<'f>(
    terms: impl Iterator<Item = (u32, &'f Factor, &'f Factor)>,
    len: usize,
    bits: u32,
) -> Vec<Ball> {
    let mut sum = vec![Integer::new(); len];
    let mut error = Magnitude::ZERO;
    for (weight, x, y) in terms {
        for (sum, c) in sum.iter_mut().zip(kronecker::product(&x.integers, &y.integers, len)) {
            *sum += c * weight;
        }
        let spread = y.norm + Magnitude::exact(len as f64) * y.error;
        error = error + Magnitude::exact(f64::from(weight)) * (x.norm * y.error + x.error * spread);
    }
    let error = error.to_float();
    let ball = |c: &Integer| {
        let unit = -i32::try_from(2 * bits).unwrap_or(i32::MAX);
        Ball::from_big_integer(c, bits).widened(&error).shifted(unit)
    };
    sum.iter().map(ball).collect()
}

/// `F` to one power, with its exponent.
struct Power {
    exponent: BigRational,
    series: Series,
}

/// The series of the head while they grow, scaled by `T^e`.
struct System {
    bits: u32,
    lattice: Lattice,
    elastic_scale: Ball,
    damping_scale: Ball,
    logarithmic: Series,
    /// The different ones among `A`, `B`, `F`, and the places of these three.
    powers: Vec<Power>,
    elastic: usize,
    damping: usize,
    trajectory: usize,
    /// The last order of `B (1 + L)`, which drives the next one.
    drive: Vec<Ball>,
}

impl System {
    fn new(law: &ForceLaw, bits: u32) -> Self {
        let time = turning_time(law, bits + 32);
        let mut powers: Vec<Power> = Vec::new();
        let mut place = |exponent: BigRational| {
            powers.iter().position(|power| power.exponent == exponent).unwrap_or_else(|| {
                powers.push(Power { exponent, series: Series::default() });
                powers.len() - 1
            })
        };
        let elastic = place(law.a() - BigRational::one());
        let damping = place(law.gamma().clone());
        let trajectory = place(BigRational::one());
        Self {
            bits,
            lattice: law.lattice(),
            elastic_scale: time.pow(&law.elastic_step()),
            damping_scale: time.pow(&law.damping_step()),
            logarithmic: Series::default(),
            powers,
            elastic,
            damping,
            trajectory,
            drive: Vec::new(),
        }
    }

    /// Appends the coefficients of the next damping order.
    fn add_order(&mut self, width: usize) {
        let n = self.logarithmic.rows.len();
        let squares = self.logarithmic.cross_square(width, self.bits);
        let known: Vec<Vec<Ball>> = self
            .powers
            .iter()
            .map(|p| Series::cross(&self.logarithmic, &p.series, width, self.bits))
            .collect();
        let mut row = Vec::with_capacity(width);
        let mut power_rows = vec![Vec::with_capacity(width); self.powers.len()];
        let mut drive = Vec::with_capacity(width);
        for j in 0..width {
            row.push(self.next_logarithmic(n, j, &squares[j], &row, &power_rows[self.elastic]));
            for (i, power_row) in power_rows.iter_mut().enumerate() {
                let product = &known[i][j] + self.with_first_order(n, j, &row, power_row, i);
                power_row.push(self.next_power(n, j, i, &product));
                if i == self.damping {
                    drive.push(&power_row[j] + product);
                }
            }
        }
        self.logarithmic.push(row, self.bits);
        for (power, power_row) in self.powers.iter_mut().zip(power_rows) {
            power.series.push(power_row, self.bits);
        }
        self.drive = drive;
    }

    /// `L_(n,j) = -(L^2 + s A + w B (1 + L))_(n,j)/(e + 1)`.
    fn next_logarithmic(&self, n: usize, j: usize, squares: &Ball, row: &[Ball], elastic: &[Ball]) -> Ball {
        if (n, j) == (0, 0) {
            return Ball::zero();
        }
        let mut right = match self.logarithmic.rows.first() {
            None => convolution(row, row, j),
            Some(first) => squares + convolution(first, row, j).shifted(1),
        };
        if j > 0 {
            right += &self.elastic_scale * &elastic[j - 1];
        }
        if n > 0 {
            right += &self.damping_scale * &self.drive[j];
        }
        -(right / (self.exponent(n, j) + Ball::one()))
    }

    /// The terms of `(L P)_(n,j)` with a factor of damping order 0.
    fn with_first_order(&self, n: usize, j: usize, row: &[Ball], power_row: &[Ball], power: usize) -> Ball {
        if n == 0 {
            return convolution(row, power_row, j);
        }
        convolution(&self.logarithmic.rows[0], power_row, j)
            + convolution(row, &self.powers[power].series.rows[0], j)
    }

    /// `P_(n,j) = power (L P)_(n,j)/e`.
    fn next_power(&self, n: usize, j: usize, power: usize, product: &Ball) -> Ball {
        if (n, j) == (0, 0) {
            return Ball::from_integer(1, self.bits);
        }
        Ball::from_rational(&self.powers[power].exponent, self.bits) * product / self.exponent(n, j)
    }

    fn exponent(&self, n: usize, j: usize) -> Ball {
        Ball::from_ratio(self.grade(n, j), self.lattice.unit, self.bits)
    }

    fn grade(&self, n: usize, j: usize) -> i64 {
        self.lattice.damping * as_i64(n) + self.lattice.elastic * as_i64(j)
    }

    fn term(&self, n: usize, j: usize) -> Term {
        let power = |place: usize| Magnitude::of(&self.powers[place].series.rows[n][j]);
        Term {
            grade: self.grade(n, j),
            damping_order: n,
            elastic_index: j,
            logarithmic: Magnitude::of(&self.logarithmic.rows[n][j]),
            elastic: power(self.elastic),
            damping: power(self.damping),
            trajectory: power(self.trajectory),
        }
    }
}

/// The coefficient `j` of the product of two rows, as far as their coefficients are known.
fn convolution(x: &[Ball], y: &[Ball], j: usize) -> Ball {
    let mut sum = Ball::zero();
    for (i, p) in x.iter().enumerate().take(j + 1) {
        if let Some(q) = y.get(j - i) {
            sum += p * q;
        }
    }
    sum
}

pub(super) fn as_i64(index: usize) -> i64 {
    i64::try_from(index).unwrap_or(i64::MAX)
}

#[cfg(test)]
mod tests;
