//! From a law to its expansion coefficients, at one precision, with what is proved of them.

use super::damped::Motion;
use super::inverse::{Exponents, logarithm};
use super::inverse_proof;
use super::motion_proof::{self, Outcome};
use super::sketch::Unbounded;
use super::turning::{Neighbourhood, TurningScale};
use super::turning_proof;
use super::units::{Scale, fixed, log_singular_ratio};
use crate::kernels::{Fixed, Workshop, keep_freed_memory, size_for};
use crate::turning_time;
use crate::vanishing::vanish;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive};
use restitution_law::ForceLaw;
use restitution_real::{Ball, Magnitude};
use rug::{Float, Integer};

/// Bits before the point: no coefficient of a provable expansion needs so many, but those of large powers.
const HEAD: u32 = 48;
/// Exponents beyond which powers need more bits: for each one more at most so many, and this multiple of what the
/// power of the undamped trajectory itself has.
const LARGE_POWER: f64 = 16.0;
const BITS_OF_LARGE_POWERS: f64 = 2.5;
const SPARE: f64 = 3.0;
/// Of these, bits that a row may have, but those of large powers; the rest is for sums and weights.
const ROW_HEAD: u32 = 12;

/// The largest order that is proved.
pub(crate) const LARGEST_ORDER: usize = turning_proof::MOST_PLACES - 1;

/// The choices that decide how close the approximation and its proof are.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plan {
    /// Bits after the point.
    pub bits: u32,
    /// The unit of the damping, about.
    pub lambda: f64,
    /// The unit of time around the turning point, or 0 to find one.
    pub step: f64,
    /// Terms of the trajectories beyond `bits` over the bits by which they fall.
    pub margin: usize,
}

/// An expansion with proved radii.
pub(crate) struct Expansion {
    /// `y_0 .. y_N`, the maximal compression (A23).
    pub compression: Vec<Ball>,
    /// `C_0 .. C_N`, the restitution (A30).
    pub restitution: Vec<Ball>,
    /// A unit of time for a longer expansion.
    pub step: f64,
}

/// Why an attempt proved nothing.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Failure {
    /// The norms are too large: a smaller unit of the damping may help.
    Norms,
    /// The sums were cut off so many terms too early.
    Terms(usize),
    /// So many bits more of working precision are needed.
    Bits(u32),
}

/// The law with its largest orders: `damping` of the trajectories, `last` of the expansion.
pub(crate) struct Request<'l> {
    pub law: &'l ForceLaw,
    pub damping: usize,
    pub last: usize,
}

/// Bits before the point that the powers of a law need beyond [`HEAD`].
fn bits_of_powers(law: &ForceLaw) -> u32 {
    let exponent = |x: &BigRational| x.to_f64().unwrap_or(f64::MAX);
    let excess = exponent(law.a()).max(exponent(&law.damping_step())) - LARGE_POWER;
    // F is least at T, where it is x_0(T)/T, and largest next to the singularity.
    let (time, step) = (turning_time(law, 64).to_f64(), exponent(&law.elastic_step()));
    let least = time.log2() - (step / 2.0).log2() / step;
    let largest = -2.0 / (step - 2.0).max(0.5) * (log_singular_ratio(law).exp2() - 1.0).min(1.0).log2();
    let bits = (SPARE * least.max(largest)).min(BITS_OF_LARGE_POWERS);
    (bits * excess).clamp(0.0, 4096.0) as u32
}

/// Bits before the point for the powers of a law.
fn head(law: &ForceLaw) -> u32 {
    HEAD + bits_of_powers(law)
}

/// Of these, bits that a row may have.
fn row_head(law: &ForceLaw) -> u32 {
    ROW_HEAD + bits_of_powers(law) / 2
}

/// Bits by which the coefficients of the trajectories may be expected to fall, as a fraction.
fn decay(law: &ForceLaw) -> (usize, usize) {
    ((log_singular_ratio(law) * 0.85 * 64.0) as usize, 64)
}

/// The terms of the trajectories at a precision.
pub(crate) fn size_for_bits(law: &ForceLaw, bits: u32, margin: usize) -> usize {
    size_for((f64::from(bits) / log_singular_ratio(law)).ceil() as usize + margin)
}

/// About the norms of the larger power in the equation of motion, by damping order.
pub(crate) fn norms_of_powers(request: &Request, plan: Plan) -> Option<Vec<f64>> {
    let (_, shop, motion) = motion(request, plan, &mut |_| ())?;
    let norm = |row: &Fixed| row.norm(i64::from(shop.bits()), 1.0).to_f64();
    let sum = |rows: &[Fixed]| rows.iter().map(norm).collect::<Vec<f64>>();
    let (pull, friction) = (sum(&motion.force), sum(&motion.friction));
    let large = |norms: &[f64]| norms[1..].iter().sum::<f64>() / norms[0];
    Some(if friction.is_empty() || large(&pull) >= large(&friction) { pull } else { friction })
}

/// Approximate trajectories, if their coefficients have the bits for it.
fn motion(request: &Request, plan: Plan, watch: &mut dyn FnMut(usize)) -> Option<(Scale, Workshop, Motion)> {
    let (law, bits) = (request.law, plan.bits);
    let (scale, shop) =
        rayon::join(|| Scale::new(law, plan.lambda, bits), || Workshop::new(bits, head(law), decay(law)));
    // As T >= 1, `d/e` is below `d`; `e` is at most about `2 (a+1)`.
    if scale.damping.abs_up() > Float::with_val(64, 1) << (row_head(law) - 2) {
        return None;
    }
    let size = size_for_bits(law, bits, plan.margin);
    if !scale.has_words(request.damping, size) {
        return None;
    }
    let motion = Motion::derive(&shop, &scale, request.damping, size, bits + row_head(law), watch)?;
    Some((scale, shop, motion))
}

/// Derives and proves the expansion of a law.
pub(crate) fn attempt(
    request: &Request,
    plan: Plan,
    watch: &mut dyn FnMut(usize),
) -> Result<Expansion, Failure> {
    keep_freed_memory();
    let law = request.law;
    let bits = plan.bits;
    debug_assert!(request.last.max(request.damping) <= LARGEST_ORDER);
    let (scale, shop, motion) = motion(request, plan, watch).ok_or(Failure::Norms)?;
    let slope = log_singular_ratio(law);
    let outcome = motion_proof::bound(&shop, &scale, &motion, slope);
    if shop.overflowed() {
        return Err(Failure::Norms);
    }
    let errors = match outcome {
        Ok(Outcome::Bounded(errors)) => errors,
        Ok(Outcome::Cut(terms)) => return Err(Failure::Terms(terms)),
        Err(Unbounded::Bits(bits)) => return Err(Failure::Bits(bits)),
        Err(_) => return Err(Failure::Norms),
    };

    let flat = Workshop::new(bits, head(law), (0, 1));
    let start = Start::new(law, &scale, &motion, errors, bits);
    let mut step = if plan.step > 0.0 { plan.step } else { start.first_step() };
    for _ in 0..5 {
        let turning = start.turning(step);
        let Some(near) =
            Neighbourhood::new(&flat, &scale, &turning, &start.position, &start.velocity, bits + ROW_HEAD)
        else {
            return Err(Failure::Norms);
        };
        let shift = near.shift(&flat, request.damping / 2 + 1);
        let size = shift.norm(i64::from(bits), 1.0).to_f64();
        if size.is_nan() || size >= 0.99 {
            step *= size.clamp(1.05, 4.0) * 1.06;
            continue;
        }
        let errors = (start.position_error, start.velocity_error);
        let y_error =
            turning_proof::bound(&flat, &scale, &turning, &near, errors, &shift).ok_or(Failure::Norms)?;
        let y = near.derivative_at(&flat, &shift, 0, request.damping + 1);
        let mut expansion = finish(request, &flat, &scale, &start, &y, y_error)?;
        if flat.overflowed() {
            return Err(Failure::Norms);
        }
        expansion.step = step * (size * 1.08).max(0.3);
        return Ok(expansion);
    }
    Err(Failure::Norms)
}

/// The initial values of the neighbourhood of the turning point, in units of `x_0(T)`.
struct Start {
    position: Vec<Integer>,
    velocity: Vec<Integer>,
    position_error: Magnitude,
    velocity_error: Magnitude,
    /// `x_0(T)` in units of `T`.
    top: Ball,
    elastic: Ball,
    damping: Ball,
    bits: u32,
}

impl Start {
    fn new(
        law: &ForceLaw,
        scale: &Scale,
        motion: &Motion,
        errors: motion_proof::MotionErrors,
        bits: u32,
    ) -> Self {
        let prec = bits + 64;
        let half = BigRational::new(1.into(), 2.into());
        let reach = Ball::from_rational(&(law.elastic_step() * half), prec).pow(&law.elastic_step().recip());
        let top = reach / &scale.time;
        let inverse = fixed(&(Ball::from_integer(1, prec) / &top), bits);
        let unit = scale.lattice.unit;
        let (mut position, mut velocity) = (Vec::new(), Vec::new());
        let mut sizes = Magnitude::ZERO;
        for (n, f) in motion.f.iter().enumerate() {
            let (mut x, mut v) = (Integer::new(), Integer::new());
            for j in 0..f.len() {
                let q = f.integer(j);
                v += Integer::from(&q * (scale.index(n, j) + unit));
                x += q;
            }
            v /= unit;
            for value in [&x, &v] {
                sizes = sizes + Magnitude::of(&Ball::from_big_integer(value, 64).shifted(-(bits as i32)));
            }
            position.push(Integer::from(&x * &inverse) >> bits);
            velocity.push(Integer::from(&v * &inverse) >> bits);
        }
        // Exactly: the undamped motion turns at T.
        position[0] = Integer::from(1) << bits;
        velocity[0] = Integer::new();
        // The inverse is right to one unit, each product is cut off, and so was the velocity.
        let rounding = sizes + Magnitude::exact(3.0 * (motion.f.len() as f64 + 1.0));
        let up = Magnitude::of(&(Ball::from_integer(1, 64) / &top));
        let elastic = &scale.elastic * top.pow(&(law.a() - BigRational::one()));
        let damping = &scale.damping * top.pow(law.gamma());
        Self {
            position,
            velocity,
            position_error: errors.position * up + rounding,
            velocity_error: errors.velocity * up + rounding,
            top,
            elastic,
            damping,
            bits,
        }
    }

    /// Somewhat more than the shift of the turning point at first order.
    fn first_step(&self) -> f64 {
        let velocity =
            self.velocity.get(1).map_or(0.0, |v| (Float::with_val(64, v) >> self.bits).to_f64().abs());
        let shift = velocity / self.elastic.to_f64();
        if shift.is_finite() && shift > 1e-6 { 1.9 * shift } else { 0.25 }
    }

    fn turning(&self, step: f64) -> TurningScale {
        let denominator = (64.0 / step).log2().round().clamp(1.0, 24.0).exp2();
        let numerator = (step * denominator).ceil().clamp(1.0, 65536.0);
        TurningScale {
            elastic: self.elastic.clone(),
            damping: self.damping.clone(),
            step: (numerator as i64, denominator as i64),
        }
    }
}

/// The inverse collision, and everything in the units of the paper.
fn finish(
    request: &Request,
    shop: &Workshop,
    scale: &Scale,
    start: &Start,
    y: &Fixed,
    y_error: Magnitude,
) -> Result<Expansion, Failure> {
    let law = request.law;
    let small = |x: &BigRational| (x.numer().to_i64().unwrap_or(0), x.denom().to_i64().unwrap_or(1));
    let exponents = Exponents {
        elastic: small(&(BigRational::from_integer(2.into()) / law.elastic_step())),
        velocity: small(&law.velocity_exponent()),
    };
    // What is not known of Y is y_N of even order N, which cancels from C_N: any value will do.
    let mut padded = y.clone();
    padded.extend(&Fixed::zero(request.last + 1 - y.len(), shop.width()));
    let l = logarithm(shop, &padded, exponents, request.last + 1);
    let proved = inverse_proof::prove(shop, &padded, y_error, &l, exponents).ok_or(Failure::Norms)?;
    let unit = -(start.bits as i32);
    let lambda = |k: usize| scale.lambda.powi(i64::try_from(k).unwrap_or(i64::MAX));
    let ball = |series: &Fixed, k: usize, error: Float| {
        Ball::from_big_integer(&series.integer(k), start.bits + HEAD).widened(&error).shifted(unit)
            / lambda(k)
    };
    let length = &start.top * &scale.time;
    let compression =
        (0..y.len()).map(|k| if k == 0 { length.clone() } else { ball(y, k, y_error.to_float()) * &length });
    let radius = |k: usize| {
        let weight = Ball::from_f64(proved.weight, 64).powi(i64::try_from(k).unwrap_or(i64::MAX));
        (Ball::exact(proved.error.to_float()) / weight).abs_up()
    };
    let restitution = (0..=request.last)
        .map(|k| if k == 0 { Ball::from_integer(1, start.bits) } else { ball(&proved.series, k, radius(k)) });
    let mut restitution: Vec<Ball> = restitution.map(|c| c.with_prec(start.bits)).collect();
    vanish(law, &mut restitution);
    Ok(Expansion { compression: compression.collect(), restitution, step: 0.0 })
}

#[cfg(test)]
mod figures;
#[cfg(test)]
mod tests;
