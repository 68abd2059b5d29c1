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
mod tests {
    use super::*;

    #[test]
    fn the_head_of_spheres_is_that_of_the_paper() {
        let head = Head::new(&ForceLaw::viscoelastic_spheres(), 3, 4);
        let find = |n, j| {
            let term = head.terms.iter().find(|t| (t.damping_order, t.elastic_index) == (n, j)).unwrap();
            let scale = head.damping_scale.powi(as_i64(n)) * head.elastic_scale.powi(as_i64(j));
            Ball::exact(term.trajectory.to_float()) / scale
        };
        // (A14): coefficients of t^(7/2) in x_0, t^(15/2) in x_1, t^(11/2) in x_3.
        for (n, j, numerator, denominator) in [(0, 1, 4, 35), (1, 2, 713, 238_875), (3, 0, 38, 2475)] {
            let error = find(n, j) - Ball::from_ratio(numerator, denominator, 64);
            assert!(error.abs_up() < 1e-9, "{n} {j} {error:?}");
        }
    }

    /// The four series by (2) of `docs/error-bounds.md`, as it is written there, in double precision.
    fn plain(law: &ForceLaw, head: &Head, orders: usize, width: usize) -> [Vec<Vec<f64>>; 4] {
        let number = |x: &BigRational| Ball::from_rational(x, 64).to_f64();
        let (a, gamma) = (number(law.a()), number(law.gamma()));
        let (s, w) = (head.elastic_scale.to_f64(), head.damping_scale.to_f64());
        let zeros = || vec![vec![0.0; width]; orders + 1];
        let (mut l, mut powers) = (zeros(), [zeros(), zeros(), zeros()]);
        let product = |x: &[Vec<f64>], y: &[Vec<f64>], n: usize, j: usize| {
            let pairs = (0..=n).flat_map(|m| (0..=j).map(move |i| (m, i)));
            pairs.map(|(m, i)| x[m][i] * y[n - m][j - i]).sum::<f64>()
        };
        for n in 0..=orders {
            for j in 0..width {
                if (n, j) == (0, 0) {
                    powers.iter_mut().for_each(|power| power[0][0] = 1.0);
                    continue;
                }
                let e = (a + 1.0) * j as f64 + (gamma + 1.0) * n as f64;
                let elastic = if j > 0 { s * powers[0][n][j - 1] } else { 0.0 };
                let damping =
                    if n > 0 { w * (powers[1][n - 1][j] + product(&powers[1], &l, n - 1, j)) } else { 0.0 };
                l[n][j] = -(product(&l, &l, n, j) + elastic + damping) / (e + 1.0);
                for (power, exponent) in powers.iter_mut().zip([a - 1.0, gamma, 1.0]) {
                    power[n][j] = exponent * product(&l, power, n, j) / e;
                }
            }
        }
        let [elastic, damping, trajectory] = powers;
        [l, elastic, damping, trajectory]
    }

    #[test]
    fn heads_of_all_four_series_solve_the_system() {
        // Of 3/2,1/2 and of 3,1 some of the powers coincide.
        for (law, orders) in [("3/2,1/2", 5), ("5/3,1/4", 4), ("3,1", 3), ("1/2,-1/4", 6), ("2,0", 2)] {
            let law: ForceLaw = law.parse().unwrap();
            let head = Head::new(&law, orders, 8);
            let [l, a, b, f] = plain(&law, &head, orders, 9);
            for t in &head.terms {
                let truth = [&l, &a, &b, &f].map(|x| x[t.damping_order][t.elastic_index].abs());
                let bounds = [t.logarithmic, t.elastic, t.damping, t.trajectory].map(Magnitude::to_f64);
                for (bound, truth) in bounds.iter().zip(truth) {
                    assert!((bound - truth).abs() <= 1e-9 * truth.max(1e-3), "{law} {t:?} {truth}");
                }
            }
            // Every pair of indices below the limit, once.
            let mut found: Vec<(usize, usize)> =
                head.terms.iter().map(|t| (t.damping_order, t.elastic_index)).collect();
            found.sort_unstable();
            let grade =
                |n: usize, j: usize| head.lattice.damping * as_i64(n) + head.lattice.elastic * as_i64(j);
            let expected: Vec<(usize, usize)> = (0..=orders)
                .flat_map(|n| (0..=8).map(move |j| (n, j)))
                .filter(|&(n, j)| grade(n, j) <= head.limit)
                .collect();
            assert_eq!(found, expected);
        }
    }

    /// Operands at the ends of their balls: the products stay inside, and the radius is no more than the document says.
    #[test]
    fn sums_of_products_hold_every_operand() {
        const BITS: u32 = 20;
        let unit = |k: i64| Ball::from_ratio(k, 1 << BITS, 64);
        let row = |mid: [i64; 3], radius: i64| mid.map(|m| unit(m).widened(unit(radius).mid())).to_vec();
        let (x, y) = ([1 << 20, -3 << 18, 5 << 15], [7 << 17, 1 << 19, -9 << 16]);
        let (x_radius, y_radius) = (1 << 6, 3 << 5);
        let (p, q) = (Factor::new(&row(x, x_radius), BITS), Factor::new(&row(y, y_radius), BITS));
        let sums = sum_of_products([(2, &p, &q), (1, &q, &p)].into_iter(), 3, BITS);
        for (j, sum) in sums.iter().enumerate() {
            for signs in 0..64u32 {
                let sign = |k: usize| if signs >> k & 1 == 1 { 1 } else { -1 };
                let product =
                    |i: usize| (x[i] + sign(i) * x_radius) * (y[j - i] + sign(3 + j - i) * y_radius);
                let exact = 3 * (0..=j).map(product).sum::<i64>();
                assert!(
                    sum.contains(&(Ball::from_integer(exact, 64).shifted(-2 * BITS as i32))),
                    "{j} {signs}"
                );
            }
            // ||x|| rho_y + rho_x (||y|| + 3 rho_y), a unit more for the rounding of each operand, three times.
            let norm = |mid: [i64; 3], radius: i64| mid.iter().map(|m| m.abs() + radius).sum::<i64>() as f64;
            let (rho_x, rho_y) = (x_radius as f64 + 1.0, y_radius as f64 + 1.0);
            let (norm_x, norm_y) = (norm(x, x_radius), norm(y, y_radius));
            let once = |nx: f64, rx: f64, ny: f64, ry: f64| nx * ry + rx * (ny + 3.0 * ry);
            let stated = 2.0 * once(norm_x, rho_x, norm_y, rho_y) + once(norm_y, rho_y, norm_x, rho_x);
            let radius = sum.rad().to_f64() * 2f64.powi(2 * BITS as i32);
            assert!((radius / stated - 1.0).abs() < 1e-6, "{radius} {stated}");
        }
    }
}
