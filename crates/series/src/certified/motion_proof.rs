//! How far the trajectories found are from the true ones (`docs/error-bounds.md`, theorem 4).

use super::damped::Motion;
use super::response::{Cause, response};
use super::sketch::{Detail, Grading, Powers, Sketch, Unbounded, in_detail, within};
use super::units::Scale;
use crate::kernels::{Fixed, Workshop, power_of_two};
use restitution_real::Magnitude;
use rug::Integer;

/// The error of one settled coefficient: half a unit and the rounding of the fraction.
pub(crate) const SETTLED: f64 = 0.51;
/// How much larger than all else the error of the cut may be before more terms are asked for.
const CUT: f64 = 64.0;
/// How many times as many terms may be asked for.
const MOST_FOLDS: usize = 4;
/// Bins for exponents, at most.
const MOST_BINS: usize = 6000;
/// Bins for the smaller step of the exponents, and at most so many for the larger one.
const BINS_PER_STEP: f64 = 4.0;
const MOST_BINS_PER_STEP: f64 = 128.0;
/// How often their width is doubled at most.
const WIDER: u32 = 3;

/// Bounds of the errors of all orders together, in units of the fixed point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MotionErrors {
    /// `sum_n |x_n(T) - x~_n(T)|`.
    pub position: Magnitude,
    /// `sum_n |x_n'(T) - x~_n'(T)|`.
    pub velocity: Magnitude,
}

/// What a proof comes to.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Outcome {
    Bounded(MotionErrors),
    /// The sums were cut off so many terms too early to lose no bits by that.
    Cut(usize),
}

/// One power in the equation of motion: `constant F^power`, found as `rows` with `defects`.
struct Force<'m> {
    steps: i64,
    rows: &'m [Fixed],
    defects: &'m [Fixed],
}

fn exact(x: f64) -> Magnitude {
    Magnitude::exact(x * (1.0 + 1e-12))
}

/// Proves bounds of the errors, if the norms are not too large for the theorem.
pub(crate) fn bound(
    shop: &Workshop,
    scale: &Scale,
    motion: &Motion,
    slope: f64,
) -> Result<Outcome, Unbounded> {
    let pull = Force { steps: scale.powers()[0], rows: &motion.force, defects: &motion.force_defects };
    let friction =
        Force { steps: scale.powers()[1], rows: &motion.friction, defects: &motion.friction_defects };
    let pull = defects(shop, scale, motion, &pull, slope);
    let friction = (!scale.shared).then(|| defects(shop, scale, motion, &friction, slope));
    // A few bits lost by the cut cost less than more terms.
    let cut = friction.iter().fold(pull.cut(), |cut, friction| cut.max(friction.cut()));
    if cut > CUT {
        let terms = terms_for(cut, slope);
        // Rounding that grows so far is not a matter of terms.
        let folds = terms < MOST_FOLDS * motion.f[0].len();
        return if folds { Ok(Outcome::Cut(terms)) } else { Err(Unbounded::Bits(shop.bits() / 2)) };
    }
    in_detail(|detail| bound_in(detail, shop, scale, motion, slope, &pull, friction.as_ref()))
}

/// About how many terms more make what is cut off so many times smaller.
fn terms_for(cut: f64, slope: f64) -> usize {
    (cut.log2() / (0.9 * slope)).ceil() as usize
}

fn bound_in(
    detail: Detail,
    shop: &Workshop,
    scale: &Scale,
    motion: &Motion,
    slope: f64,
    pull: &Defects,
    friction: Option<&Defects>,
) -> Result<Outcome, Unbounded> {
    let unit = scale.lattice.unit as f64;
    let (elastic, damping) = (scale.lattice.elastic as f64 / unit, scale.lattice.damping as f64 / unit);
    let grading = Grading { row: damping, column: elastic };
    let powers = Powers::new(Sketch::new(&motion.f, &motion.force, shop.bits(), grading, detail)?, grading)?;
    let [lower, gamma] = scale.lower_powers();
    let stiffness = powers.power(lower)?;
    let (pull_error, mut folded) = pull.force_error(&powers, stiffness.norm())?;
    let (drag, drag_error) = match friction {
        None => {
            let ratio = exact(scale.ratio.0 as f64 / scale.ratio.1 as f64);
            (stiffness.clone(), pull_error * ratio)
        }
        Some(friction) => {
            let drag = powers.power(gamma)?;
            let (error, of_friction) = friction.force_error(&powers, drag.norm())?;
            folded = folded + of_friction;
            (drag, error)
        }
    };

    let (residual, last) = residual(scale, motion);
    let rest = residual.to_f64() + pull_error.to_f64() + drag_error.to_f64();
    let cut = (last + folded).to_f64() / (rest - (last + folded).to_f64()).max(1.0);
    if cut > CUT {
        return Ok(Outcome::Cut(terms_for(cut, slope)));
    }
    let residual = residual + pull_error * exact(1.0 / elastic) + drag_error * exact(1.0 / damping);
    let (e, d) = (Magnitude::of(&scale.elastic), Magnitude::of(&scale.damping));
    let power = elastic - 1.0;
    let growth = growth(grading, (&stiffness, e * exact(power)), (&drag, d)).ok_or(Unbounded::Large)?;

    // What is of second order in the error must stay below the residual.
    let velocity = growth * residual * Magnitude::exact(2.0);
    let small = power_of_two(-i64::from(shop.bits()));
    let relative = velocity * small * powers.reciprocal();
    let curvature = |constant: Magnitude, powers_product: f64, norm: Magnitude| {
        constant * exact(powers_product.abs()) * norm * powers.base()
    };
    let second = curvature(e, power * lower / elastic, stiffness.norm()) + curvature(d, gamma, drag.norm());
    let second = second * relative * powers.reciprocal() * velocity;
    let first = relative * exact(power.max(damping).max(1.0));
    let position = velocity * exact(1.0 / (1.0 + elastic.min(damping)));
    // Compared as they are: a quotient could be rounded to 1.
    if within(first, 0.5) && second <= residual {
        return Ok(Outcome::Bounded(MotionErrors { position, velocity }));
    }
    let excess = (2.0 * first.to_f64()).max(second.to_f64() / residual.to_f64());
    Err(if excess.is_finite() {
        Unbounded::Bits(excess.log2().ceil().max(1.0) as u32)
    } else {
        Unbounded::Large
    })
}

/// The response of the linearised problem, with bins that are wider where there would be too many.
fn growth(
    grading: Grading,
    (stiffness, e): (&Sketch, Magnitude),
    (drag, d): (&Sketch, Magnitude),
) -> Option<Magnitude> {
    let Grading { row: damping, column: elastic } = grading;
    let width = (elastic.min(damping) / BINS_PER_STEP).max(elastic.max(damping) / MOST_BINS_PER_STEP);
    (0..=WIDER).find_map(|doubled| {
        let width = width * f64::from(1 << doubled);
        let bin = |exponent: f64| (exponent / width - 1e-9).max(0.0) as usize;
        let binned = |sketch: &Sketch, factor: Magnitude| -> Vec<Magnitude> {
            let norms = sketch.norms_by(|n, j| bin(damping * n as f64 + elastic * j as f64));
            norms.into_iter().map(|norm| norm * factor).collect()
        };
        let low = |b: usize| b as f64 * width;
        let causes = [
            Cause {
                step: bin(elastic),
                sizes: &binned(stiffness, e),
                weight: &|b, place| 1.0 / ((low(b) + 1.0) * low(place)),
            },
            Cause { step: bin(damping), sizes: &binned(drag, d), weight: &|b, _| 1.0 / (low(b) + 1.0) },
        ];
        response(bin(elastic.min(damping)), &causes, MOST_BINS)
    })
}

/// How far the rows found for a power are from being one.
struct Defects {
    power: f64,
    /// `||r_0|| + sum_(n >= 1) ||r_n||/n` as found, in units of the lattice, and what was folded over.
    found: Magnitude,
    folded: Magnitude,
    /// About what rounding alone leaves.
    rounding: f64,
}

/// The defects `r` of a force, where products were cyclic: what was folded over counts twice.
fn defects(shop: &Workshop, scale: &Scale, motion: &Motion, force: &Force, slope: f64) -> Defects {
    let unit = scale.lattice.unit;
    let power = force.steps as f64 / unit as f64;
    let size = motion.f[0].len();
    let rounding = exact(SETTLED * size as f64);
    let truncated = exact(size as f64);
    let rows = force.defects.iter().map(|defect| defect.norm(0, 1.0) + rounding + truncated);
    let of_rows = rows.sum::<Magnitude>();

    let transform = |series: &Fixed| shop.transform(series, size, shop.all_primes());
    let (f, h) = (&motion.f[0], &force.rows[0]);
    let slope_f = f.scaled(|j| (force.steps * j as i64, 1));
    let slope_h = h.scaled(|j| (unit * j as i64, 1));
    let products =
        shop.sum(&[(1, &transform(&slope_f), &transform(h)), (-1, &transform(f), &transform(&slope_h))]);
    let of_first = shop.settle(products, size, shop.bits()).norm(0, 1.0) + rounding;

    let bits = i64::from(shop.bits());
    let folded = |slope: f64| {
        let norm = |series: &Fixed| series.rising_norm(bits, slope);
        let all = |rows: &[Fixed]| rows.iter().map(norm).sum::<Magnitude>();
        let sum = exact(power.max(1.0) * unit as f64) * all(&motion.f) * all(force.rows)
            + norm(&slope_f) * norm(h)
            + norm(f) * norm(&slope_h);
        sum * power_of_two(bits + 1 - (slope * size as f64).floor() as i64)
    };
    let folded = [0.99, 0.97, 0.94, 0.9, 0.8].map(|share| folded(share * slope));
    let folded = folded.into_iter().fold(Magnitude::exact(f64::INFINITY), |x, y| if x < y { x } else { y });
    let forces: f64 = force.rows.iter().map(|row| row.norm(bits, 1.0).to_f64()).sum();
    let rounding = (power.max(1.0) * unit as f64) * forces * (size * motion.f.len()) as f64;
    let per_unit = exact(1.0 / unit as f64);
    Defects {
        power,
        found: (of_rows + of_first) * per_unit,
        folded: folded * per_unit,
        rounding: rounding / unit as f64,
    }
}

impl Defects {
    /// How much larger what was folded over is than all else, or than rounding where too much is.
    fn cut(&self) -> f64 {
        let cut = |rest: f64| self.folded.to_f64() / rest.max(1.0);
        if cut(self.found.to_f64()) > CUT { cut(self.rounding).max(cut(self.found.to_f64())) } else { 0.0 }
    }

    /// `||H - c F^p||` for the rows `H` found and the polynomial `F` found: `||F^p||` times
    ///
    /// ```text
    /// |h - c| + ||F^(-p-1)|| (||r_0|| + sum_(n >= 1) ||r_n||/n)
    /// ```
    ///
    /// The second bound is what was folded over in it.
    fn force_error(
        &self,
        powers: &Powers,
        lower_power: Magnitude,
    ) -> Result<(Magnitude, Magnitude), Unbounded> {
        let inverse = powers.power(-self.power - 1.0)?.norm();
        let error = Magnitude::ONE + inverse * (self.found + self.folded);
        let force = lower_power * powers.base();
        Ok((force * error, force * inverse * self.folded))
    }
}

/// `||D^(-1) r||` for the residual `r` of the equation of motion, exactly but for the last conversion:
///
/// ```text
/// r_(n,j)/e = (e+1) F_(n,j) + H_(n,j-1)/e + G_(n-1,j)/(gamma+1)
/// ```
///
/// The second bound is that of the terms where the rows end.
fn residual(scale: &Scale, motion: &Motion) -> (Magnitude, Magnitude) {
    let (unit, damping) = (scale.lattice.unit, scale.lattice.damping);
    let (numerator, denominator) = if scale.shared { scale.ratio } else { (1, 1) };
    let friction = if scale.shared { &motion.force } else { &motion.friction };
    let (mut total, mut last) = (Magnitude::ZERO, Magnitude::ZERO);
    for (n, f) in motion.f.iter().enumerate() {
        for j in 0..=f.len() {
            let m = scale.index(n, j);
            if m == 0 {
                continue;
            }
            let mut sum = Integer::new();
            if j < f.len() {
                sum += f.integer(j) * m * (m + unit) * (damping * denominator);
                if n > 0 {
                    sum += friction[n - 1].integer(j) * m * (unit * unit) * numerator;
                }
            }
            if j > 0 {
                sum += motion.force[n].integer(j - 1) * (unit * unit) * (damping * denominator);
            }
            if !sum.is_zero() {
                let size = Magnitude::exact(sum.to_f64().abs().next_up());
                let size = size * exact(1.0 / (unit as f64 * m as f64 * damping as f64 * denominator as f64));
                total = total + size;
                if j == f.len() {
                    last = last + size;
                }
            }
        }
    }
    (total, last)
}

#[cfg(test)]
mod tests;
