//! Series in two variables in double precision, with a bound of how far the exact ones may be.
//!
//! All norms are `||f|| = sum |f_(n,j)|`, a Banach algebra. A sketch decides nothing by itself: what is
//! proved rests on the norms of defects, in which the rounding of doubles is counted.

use crate::kernels::Fixed;
use restitution_real::Magnitude;

/// How much of a series is kept: powers may fall more slowly than the series itself.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Detail {
    /// Norm below which the rows and columns at the end are left out.
    left_out: f64,
    /// Rows and columns kept over those that count.
    wider: f64,
}

/// What is tried in turn.
const DETAILS: [Detail; 3] = [
    Detail { left_out: 1e-7, wider: 1.0 },
    Detail { left_out: 1e-10, wider: 1.5 },
    Detail { left_out: 1e-12, wider: 2.5 },
];

/// Why nothing was proved.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Unbounded {
    /// More detail may help.
    Coarse,
    /// The norms are too large.
    Large,
    /// The errors are too large for an estimate to first order, by so many bits.
    Bits(u32),
}

/// The first bound that a sketch in more and more detail proves.
pub(crate) fn in_detail<T>(bound: impl Fn(Detail) -> Result<T, Unbounded>) -> Result<T, Unbounded> {
    let mut bounds = DETAILS.into_iter().map(bound);
    let found = bounds.find(|bound| !matches!(bound, Err(Unbounded::Coarse)));
    found.unwrap_or(Err(Unbounded::Coarse))
}

/// Most coefficients of a sketch.
const LARGEST: usize = 12000;
/// Powers beyond may be squares.
const LARGEST_POWER: f64 = 6.0;
/// Share of a large power's norm that its error may be while more detail can be had.
const PRECISE: f64 = 0.1;
/// One rounding of a double.
const UNIT: f64 = f64::EPSILON;

/// `f = f~ + (something of norm at most error)`, `f~` with `rows` times `columns` coefficients.
#[derive(Clone, Debug)]
pub(crate) struct Sketch {
    columns: usize,
    /// Rows from here on are taken to be zero, also in products.
    cut: usize,
    values: Vec<f64>,
    /// Bounds the norm of what is missing.
    pub error: Magnitude,
    /// The same for `D f`, where each coefficient counts with its exponent.
    slope_error: Magnitude,
}

/// The exponents `row n + column j`, both steps positive.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Grading {
    pub row: f64,
    pub column: f64,
}

impl Grading {
    fn exponent(self, n: usize, j: usize) -> f64 {
        self.row * n as f64 + self.column * j as f64
    }

    fn least(self) -> f64 {
        self.row.min(self.column)
    }
}

/// Powers of a series with constant term 1, all bounded.
pub(crate) struct Powers {
    grading: Grading,
    base: Sketch,
    reciprocal: Magnitude,
}

impl Sketch {
    /// Takes the leading coefficients of exact rows in units of `2^-bits`: as many as count in these rows or, beside
    /// its norm, in a power of them.
    ///
    /// [`Unbounded::Large`] if too many of them count.
    pub fn new(
        exact: &[Fixed],
        power: &[Fixed],
        bits: u32,
        grading: Grading,
        detail: Detail,
    ) -> Result<Self, Unbounded> {
        let unit = i64::from(bits);
        let sizes = sizes(exact, unit);
        let kept =
            |norms: &[f64], left_out: f64| (counting(norms, left_out) as f64 * detail.wider).ceil() as usize;
        let [mut rows, mut columns] = norms(&sizes).map(|norms| kept(&norms, detail.left_out));
        if !power.is_empty() {
            let [of_rows, of_columns] = norms(&self::sizes(power, unit));
            let left_out = detail.left_out * of_rows.iter().sum::<f64>().max(1.0);
            (rows, columns) = (rows.max(kept(&of_rows, left_out)), columns.max(kept(&of_columns, left_out)));
        }
        let rows = rows.min(exact.len());
        if rows * columns > LARGEST {
            return Err(Unbounded::Large);
        }
        let mut values = vec![0.0; rows * columns];
        let (mut error, mut slope_error) = (Magnitude::ZERO, Magnitude::ZERO);
        for (n, row) in exact.iter().enumerate() {
            for j in 0..row.len() {
                let size = sizes[n][j];
                if size == 0.0 {
                    continue;
                }
                let missing = if n < rows && j < columns {
                    let negative = row.words(j).last().is_some_and(|top| top >> 63 == 1);
                    values[n * columns + j] = if negative { -size } else { size };
                    // The size is within 2^-50 of the number, or within one unit of the last place of both.
                    Magnitude::exact(size) * Magnitude::exact(8.0 * UNIT)
                        + crate::kernels::power_of_two(-unit)
                } else {
                    Magnitude::exact(size)
                };
                error = error + missing;
                slope_error =
                    slope_error + missing * Magnitude::exact(grading.exponent(n, j) * (1.0 + 8.0 * UNIT));
            }
        }
        Ok(Self { columns, cut: exact.len(), values, error, slope_error })
    }

    fn rows(&self) -> usize {
        self.values.len() / self.columns
    }

    /// An upper bound of the norm.
    pub fn norm(&self) -> Magnitude {
        norm(self.values.iter().copied()) + self.error
    }

    /// Whether little is missing beside what is known.
    fn is_precise(&self) -> bool {
        self.error.to_f64() < PRECISE * self.norm().to_f64()
    }

    /// Upper bounds of the norm by place, `place(n, j)`; what is missing counts at place 0.
    pub fn norms_by(&self, place: impl Fn(usize, usize) -> usize) -> Vec<Magnitude> {
        let mut norms = vec![self.error];
        for (i, value) in self.values.iter().enumerate() {
            let place = place(i / self.columns, i % self.columns);
            if norms.len() <= place {
                norms.resize(place + 1, Magnitude::ZERO);
            }
            norms[place] = norms[place] + Magnitude::exact(value.abs());
        }
        norms
    }

    /// `f~^p` by Miller's formula, as far as the sketch reaches; the errors are not set.
    ///
    /// ```text
    /// e g_e = (p + 1) sum e_1 f_(e_1) g_(e - e_1) - e sum f_(e_1) g_(e - e_1)
    /// ```
    fn raw_power(&self, power: f64, grading: Grading) -> Self {
        let (rows, columns) = (self.rows(), self.columns);
        let slope = self.slope(grading);
        let mut result = vec![0.0; rows * columns];
        let (mut weighted, mut plain) = (vec![0.0; columns], vec![0.0; columns]);
        for n in 0..rows {
            weighted.fill(0.0);
            plain.fill(0.0);
            for m in 1..=n {
                let row = m * columns..(m + 1) * columns;
                let below = &result[(n - m) * columns..(n - m + 1) * columns];
                for (i, (f, slope)) in self.values[row.clone()].iter().zip(&slope[row]).enumerate() {
                    add_multiple(&mut plain[i..], *f, below);
                    add_multiple(&mut weighted[i..], *slope, below);
                }
            }
            for j in 0..columns {
                let e = grading.exponent(n, j);
                let value = if e > 0.0 { ((power + 1.0) * weighted[j] - e * plain[j]) / e } else { 1.0 };
                result[n * columns + j] = value;
                add_multiple(&mut plain[j + 1..], value, &self.values[1..columns]);
                add_multiple(&mut weighted[j + 1..], value, &slope[1..columns]);
            }
        }
        Self { columns, cut: self.cut, values: result, error: Magnitude::ZERO, slope_error: Magnitude::ZERO }
    }

    /// `sum_t c_t f_t g_t` for sketches of one shape, with so many columns, and a bound of its rounding.
    fn sum(&self, terms: &[(f64, &[f64], &[f64])]) -> (Vec<f64>, Magnitude) {
        let columns = self.columns;
        let rows = terms[0].1.len() / columns;
        let wide = 2 * columns - 1;
        let mut product = vec![0.0; (2 * rows - 1) * wide];
        let mut sizes = Magnitude::ZERO;
        for (c, f, g) in terms {
            for (m, f) in f.chunks(columns).enumerate() {
                for (n, g) in g.chunks(columns).enumerate().take(self.cut.saturating_sub(m)) {
                    for (i, x) in f.iter().enumerate() {
                        add_multiple(&mut product[(m + n) * wide + i..], c * x, g);
                    }
                }
            }
            sizes = sizes + Magnitude::exact(c.abs()) * norm(f.iter().copied()) * norm(g.iter().copied());
        }
        // At most so many additions, each with a relative error of UNIT/2 of what was added so far.
        let additions = (terms.len() * rows * columns + 4) as f64;
        (product, sizes * Magnitude::exact(additions * UNIT))
    }

    /// The norm of `sum_t c_t f_t g_t`, or of that less 1, rounding counted.
    fn norm_of_sum(&self, terms: &[(f64, &[f64], &[f64])], less_one: bool) -> Magnitude {
        let (mut sum, rounding) = self.sum(terms);
        if less_one {
            sum[0] -= 1.0;
        }
        norm(sum.into_iter()) + rounding + Magnitude::exact(UNIT)
    }

    /// The square of the exact series, in as much detail. The errors of slopes are not set.
    fn squared(&self) -> Self {
        let (columns, wide) = (self.columns, 2 * self.columns - 1);
        let (sum, mut error) = self.sum(&[(1.0, &self.values, &self.values)]);
        let mut values = Vec::with_capacity(self.values.len());
        for (n, row) in sum.chunks(wide).enumerate() {
            let kept = if n < self.rows() { columns } else { 0 };
            values.extend_from_slice(&row[..kept]);
            error = error + norm(row[kept..].iter().copied());
        }
        let twice = Magnitude::exact(2.0) * norm(self.values.iter().copied()) + self.error;
        error = error + twice * self.error;
        Self { columns, cut: self.cut, values, error, slope_error: Magnitude::ZERO }
    }

    /// `D f~`, every coefficient times its exponent.
    fn slope(&self, grading: Grading) -> Vec<f64> {
        let scale = |(i, value): (usize, &f64)| value * grading.exponent(i / self.columns, i % self.columns);
        self.values.iter().enumerate().map(scale).collect()
    }
}

impl Powers {
    /// For a series with constant term 1.
    pub fn new(base: Sketch, grading: Grading) -> Result<Self, Unbounded> {
        let inverse = base.raw_power(-1.0, grading);
        let gap =
            base.norm_of_sum(&[(1.0, &base.values, &inverse.values)], true) + base.error * inverse.norm();
        let reciprocal = inverse.norm() * over_one_minus(gap).ok_or(Unbounded::Coarse)?;
        Ok(Self { grading, base, reciprocal })
    }

    /// A bound of the norm of the series.
    pub fn base(&self) -> Magnitude {
        self.base.norm()
    }

    /// A bound of the norm of its reciprocal.
    pub fn reciprocal(&self) -> Magnitude {
        self.reciprocal
    }

    /// The power of the exact series, as a sketch with its error.
    ///
    /// With `Q` the power of the sketch and `X = Q/f^p = 1 + xi`, `D X = (f D Q - p Q D f)/(f Q) X`, so that
    /// `||xi|| <= x/(1-x)`, `x = ||f D Q - p Q D f|| ||1/f|| ||1/Q|| / least exponent`.
    pub fn power(&self, power: f64) -> Result<Sketch, Unbounded> {
        let found = self.power_within(power);
        if power.abs() <= LARGEST_POWER {
            return found.ok_or(Unbounded::Coarse);
        }
        // Large powers and their reciprocals may have norms so large that doubles see no small product.
        match found {
            Some(found) if found.is_precise() => Ok(found),
            _ => self.power(power / 2.0).map(|root| root.squared()),
        }
    }

    fn power_within(&self, power: f64) -> Option<Sketch> {
        let (f, grading) = (&self.base, self.grading);
        let mut found = f.raw_power(power, grading);
        let opposite = f.raw_power(-power, grading);
        let gap = f.norm_of_sum(&[(1.0, &found.values, &opposite.values)], true);
        let inverse = opposite.norm() * over_one_minus(gap)?;
        let (slope, found_slope) = (f.slope(grading), found.slope(grading));
        let size = Magnitude::exact(power.abs() * (1.0 + 2.0 * UNIT));
        let defect = f.norm_of_sum(&[(1.0, &f.values, &found_slope), (-power, &found.values, &slope)], false);
        // Exponents and the power are doubles next to the exact ones.
        let inexact = norm(found_slope.iter().copied()) * f.norm()
            + size * found.norm() * (norm(slope.iter().copied()) + f.slope_error);
        let defect = defect
            + inexact * Magnitude::exact(16.0 * UNIT)
            + f.error * norm(found_slope.iter().copied())
            + size * found.norm() * f.slope_error;
        let least = Magnitude::exact((1.0 + 8.0 * UNIT) / grading.least());
        let x = defect * self.reciprocal * inverse * least;
        let xi = x * over_one_minus(x)?;
        found.error = found.norm() * xi * over_one_minus(xi)?;
        Some(found)
    }
}

/// Absolute values of the coefficients, nearly.
fn sizes(rows: &[Fixed], unit: i64) -> Vec<Vec<f64>> {
    rows.iter().map(|row| (0..row.len()).map(|j| row.size(j, unit).to_f64()).collect()).collect()
}

/// The norms of rows and of columns, nearly.
fn norms(sizes: &[Vec<f64>]) -> [Vec<f64>; 2] {
    let width = sizes.iter().map(Vec::len).max().unwrap_or(0);
    let column = |j: usize| sizes.iter().filter_map(|row| row.get(j)).sum::<f64>();
    [sizes.iter().map(|row| row.iter().sum()).collect(), (0..width).map(column).collect()]
}

/// `sum += factor series`, as far as the sum reaches.
fn add_multiple(sum: &mut [f64], factor: f64, series: &[f64]) {
    if factor != 0.0 {
        for (sum, x) in sum.iter_mut().zip(series) {
            *sum += factor * x;
        }
    }
}

/// How many leading norms leave less than the limit.
fn counting(norms: &[f64], limit: f64) -> usize {
    let mut rest = 0.0;
    let enough = norms.iter().rposition(|norm| {
        rest += norm;
        rest.is_nan() || rest >= limit
    });
    enough.map_or(1, |last| last + 1)
}

/// An upper bound of the sum of absolute values, of up to `2^20` numbers.
fn norm(values: impl Iterator<Item = f64>) -> Magnitude {
    Magnitude::exact(values.map(f64::abs).sum::<f64>() * (1.0 + 1e-9))
}

/// Whether a bound is at most a limit.
pub(crate) fn within(bound: Magnitude, limit: f64) -> bool {
    bound.to_f64() <= limit
}

/// `1/(1-x)` for a bound `x < 1`, rounded up.
pub(crate) fn over_one_minus(x: Magnitude) -> Option<Magnitude> {
    let rest = (1.0 - x.to_f64()).next_down();
    (rest > 1e-3).then(|| Magnitude::exact((1.0 / rest).next_up()))
}

#[cfg(test)]
mod tests;
