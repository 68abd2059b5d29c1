//! The collision once more, by another kind of integration: spectral collocation of its energy on the whole way at once.
//!
//! Scaled by the turning point, with `q = x^(gamma+1)`, `sigma = (a+1)/(gamma+1)` and the speed `y`, both ways are
//!
//! ```text
//! e = y^2 + q^sigma,   de/dq = -+ b sqrt(e - q^sigma),   e(1) = 1,      b = kappa sqrt(2 (a+1))/(gamma+1)
//! y(in) = y(0; in),    epsilon = y(out)/y(in),    u = kappa N^p,   N = sqrt(2/(a+1)) y(in),   p = (2 gamma - a + 1)/(a + 1)
//! ```
//!
//! in compression and on the way out; the contact ends at `q = 0`, or where the force vanishes, `b y = sigma q^(sigma-1)`.
//! The variable `q` is mapped to the whole line so that both ends become harmless (`1 - q = 1/(1 + exp(-pi sinh s))`),
//! the integral equation for `e` is collocated at equidistant `s` (Haber's formula of the indefinite integral in
//! sinc functions) and solved by Newton's iteration. No steps, no Taylor series, no power series in `u`.
//!
//! # Error
//!
//! Not proved: judged by a second run with other nodes.

use restitution_law::ForceLaw;
use rug::Float;
use rug::float::Constant;
use rug::ops::Pow;
use std::sync::OnceLock;

/// Bits of every number.
pub const BITS: u32 = 192;
/// The largest distance of two nodes.
const LARGEST_DISTANCE: usize = 640;
/// Iterations after which Newton has long converged or never will.
const ITERATIONS: usize = 30;
/// Where `1 - q^sigma` is below this, damping has not changed the energy by half of that, for `b < 1000`.
const TURNING: f64 = 1e-8;
/// Corrections below this are rounding.
const SETTLED: f64 = 1e-50;

/// A damping and the coefficient of restitution that belongs to it.
#[derive(Clone, Debug)]
pub struct Solution {
    /// The damping `u`.
    pub u: Float,
    /// The coefficient at zero compression, unless the bodies do not get there.
    pub zero_compression: Option<Float>,
    /// The coefficient at zero force, unless the force need not vanish.
    pub zero_force: Option<Float>,
}

/// A law in the variables of this method.
#[derive(Clone, Debug)]
struct Energy {
    sigma: Float,
    b: Float,
}

/// Nodes `-count..=count` in `s` at distance `step`.
#[derive(Clone, Copy, Debug)]
pub struct Nodes {
    /// How many on each side of 0.
    pub count: usize,
    /// Where the last one lies.
    pub reach: f64,
}

fn float(x: f64) -> Float {
    Float::with_val(BITS, x)
}

fn rational(value: &num_rational::BigRational) -> Float {
    Float::with_val(BITS, restitution_real::convert::rug_rational(value))
}

/// Solves both ways of the collision with scaled damping `kappa`; `None` where Newton's iteration fails.
pub fn solve(law: &ForceLaw, kappa: f64, nodes: Nodes) -> Option<Solution> {
    let (a1, g1) = (rational(&law.elastic_step()), rational(&law.damping_step()));
    let two = float(2.0);
    let b = Float::with_val(BITS, &two * &a1).sqrt() / &g1 * kappa;
    let energy = Energy { sigma: Float::with_val(BITS, &a1 / &g1), b };
    let way_in = energy.follow(Way::In, &float(0.0), nodes)?;
    let speed = Float::with_val(BITS, &two / &a1).sqrt() * &way_in;
    let u = speed.pow(rational(&law.velocity_exponent())) * kappa;
    let reaches = law.velocity_exponent() > num_rational::BigRational::default() || kappa < 1.0;
    let out = reaches.then(|| energy.follow(Way::Out, &float(0.0), nodes)).flatten();
    let has_zero_force = law.a() > law.gamma();
    let exit = has_zero_force.then(|| energy.zero_force(nodes)).flatten();
    let ratio = |out: Float| Float::with_val(BITS, &out / &way_in);
    Some(Solution { u, zero_compression: out.map(ratio), zero_force: exit.map(ratio) })
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    In,
    Out,
}

/// The nodes of one interval `[q_0, 1]`: what does not change between iterations.
struct Grid {
    step: Float,
    /// `(1 - q_0) dr/ds`, where `1 - q = (1 - q_0) r`.
    weight: Vec<Float>,
    /// `1 - q^sigma`.
    room: Vec<Float>,
    /// `r` in f64, for the first guess.
    place: Vec<f64>,
    /// `q`.
    q: Vec<Float>,
}

impl Energy {
    /// The speed at `q_0` on one way between `q = 1`, where it is 0, and `q_0`.
    fn follow(&self, way: Way, start: &Float, nodes: Nodes) -> Option<Float> {
        let grid = self.grid(start, nodes);
        let sign = if way == Way::In { 1.0 } else { -1.0 };
        let b = Float::with_val(BITS, &self.b * sign);
        let mut change = self.guess(&grid, start, sign)?;
        let mut last = f64::INFINITY;
        for _ in 0..ITERATIONS {
            let (correction, size) = newton(&grid, &b, &change)?;
            change.iter_mut().zip(correction).for_each(|(change, correction)| *change += correction);
            if size < SETTLED || (size < 1e-30 && size >= last) {
                return self.speed_at_end(&grid, &b, &change, start);
            }
            last = size;
        }
        None
    }

    fn grid(&self, start: &Float, nodes: Nodes) -> Grid {
        let step = float(nodes.reach) / nodes.count as u32;
        let pi = Float::with_val(BITS, Constant::Pi);
        let width = 1 - start.clone();
        let mut grid = Grid { step: step.clone(), weight: vec![], room: vec![], place: vec![], q: vec![] };
        for j in -(nodes.count as i32)..=nodes.count as i32 {
            let s = Float::with_val(BITS, &step * j);
            let (sinh, cosh) = s.sinh_cosh(Float::new(BITS));
            let e = Float::with_val(BITS, &pi * sinh).exp();
            let below = 1 / (1 + e.clone()); // 1 - r
            let r = Float::with_val(BITS, &e * &below);
            grid.weight.push(Float::with_val(BITS, &pi * cosh) * &r * &below * &width);
            // q = q_0 + (1 - q_0)(1 - r), and its logarithm with all digits near 1.
            let q = Float::with_val(BITS, &width * &below) + start;
            let logarithm =
                if r < 0.5 { (-(Float::with_val(BITS, &width * &r))).ln_1p() } else { q.clone().ln() };
            grid.room.push(-(logarithm * &self.sigma).exp_m1());
            grid.place.push(r.to_f64());
            grid.q.push(q);
        }
        grid
    }

    /// The change of the energy from the turning point on, to a few digits: implicit trapezoidal steps from node to node.
    fn guess(&self, grid: &Grid, start: &Float, sign: f64) -> Option<Vec<Float>> {
        let b = self.b.to_f64() * sign * (1.0 - start.to_f64());
        let (mut change, mut speed, mut place) = (0.0, 0.0, 0.0);
        let mut guess = Vec::with_capacity(grid.place.len());
        for (r, room) in grid.place.iter().zip(&grid.room) {
            let c = b * (r - place) / 2.0;
            let rest = change + c * speed + room.to_f64();
            // y^2 - c y - rest = 0, in the form without cancellation.
            let root = (c * c / 4.0 + rest).sqrt();
            let next = if c >= 0.0 { c / 2.0 + root } else { rest / (root - c / 2.0) };
            if next.is_nan() || next <= 0.0 {
                return None;
            }
            change += c * (speed + next);
            (speed, place) = (next, *r);
            guess.push(float(change));
        }
        Some(guess)
    }

    fn speed_at_end(&self, grid: &Grid, b: &Float, change: &[Float], start: &Float) -> Option<Float> {
        let speeds = speeds(grid, change)?;
        let products = speeds.iter().zip(&grid.weight).map(|(y, w)| Float::with_val(BITS, y * w));
        let whole = products.fold(Float::new(BITS), |sum, term| sum + term) * &grid.step * b;
        let room = 1 - start.clone().pow(&self.sigma);
        let square: Float = whole + room;
        (square > 0).then(|| square.sqrt())
    }

    /// The speed on the way out where the force vanishes, by Newton's iteration for the place.
    fn zero_force(&self, nodes: Nodes) -> Option<Float> {
        let mut q = self.zero_force_guess(nodes)?;
        for _ in 0..ITERATIONS {
            let y = self.follow(Way::Out, &q, nodes)?;
            let power = q.clone().pow(Float::with_val(BITS, &self.sigma - 1u32)) * &self.sigma; // sigma q^(sigma-1)
            let excess = Float::with_val(BITS, &y - Float::with_val(BITS, &power / &self.b));
            let slope = (self.b.clone() - Float::with_val(BITS, &power / &y)) / 2u32;
            let steep = power * Float::with_val(BITS, &self.sigma - 1u32) / &q / &self.b;
            let correction = excess / (slope - steep);
            let next = Float::with_val(BITS, &q - &correction);
            let relative = Float::with_val(BITS, &correction / &q).to_f64().abs();
            // Quadratic: what is left after a correction of 1e-25 is below rounding; the speed is flat there.
            if relative < 1e-25 {
                return Some(y);
            }
            q = if next > 0 && next < 1 { next } else { q / 2u32 };
        }
        None
    }

    /// Where the force vanishes, between two nodes of a coarse run through the whole way.
    fn zero_force_guess(&self, nodes: Nodes) -> Option<Float> {
        let nodes = Nodes { count: 400, reach: nodes.reach.max(4.5) };
        let grid = self.grid(&float(0.0), nodes);
        let (b, sigma) = (self.b.to_f64(), self.sigma.to_f64());
        let (mut change, mut speed, mut place) = (0.0, 0.0, 0.0);
        for (i, (r, room)) in grid.place.iter().zip(&grid.room).enumerate() {
            let c = -b * (r - place) / 2.0;
            let rest = change + c * speed + room.to_f64();
            let next = rest / ((c * c / 4.0 + rest).max(0.0).sqrt() - c / 2.0);
            let q = grid.q[i].to_f64();
            if next * b >= sigma * q.powf(sigma - 1.0) && i > 0 {
                return Some(grid.q[i].clone());
            }
            change += c * (speed + next);
            (speed, place) = (next, *r);
        }
        None
    }
}

/// `y = sqrt(change + 1 - q^sigma)`.
///
/// Next to the turning point the change is small against the room, but may be smaller than the error of an
/// integral over the whole line: there at least half of the room counts, with a weight that is smaller still.
fn speeds(grid: &Grid, change: &[Float]) -> Option<Vec<Float>> {
    let speed = |(change, room): (&Float, &Float)| {
        let square = Float::with_val(BITS, change + room);
        let least = if *room < TURNING { Float::with_val(BITS, room / 2u32) } else { Float::new(BITS) };
        let square = if square < least { least } else { square };
        (square > 0).then(|| square.sqrt())
    };
    change.iter().zip(&grid.room).map(speed).collect()
}

/// One step of Newton's iteration for `change = b int y dq`, and its size.
///
/// With `rho` what is missing, the correction solves `d = rho + int g d`, `g = b w/(2 y)`: a linear equation whose
/// solution is `d = rho + e^G int e^-G g rho`, `G = int g`.
fn newton(grid: &Grid, b: &Float, change: &[Float]) -> Option<(Vec<Float>, f64)> {
    let speeds = speeds(grid, change)?;
    let scaled = |f: &dyn Fn(usize) -> Float| -> Vec<Float> { (0..change.len()).map(f).collect() };
    let rate = scaled(&|j| Float::with_val(BITS, &speeds[j] * &grid.weight[j]) * b);
    let missing: Vec<Float> = indefinite(&grid.step, &rate)
        .into_iter()
        .zip(change)
        .map(|(reached, change)| reached - change)
        .collect();
    let g = scaled(&|j| Float::with_val(BITS, &grid.weight[j] / &speeds[j]) * b / 2u32);
    let growth: Vec<Float> = indefinite(&grid.step, &g).into_iter().map(Float::exp).collect();
    let source = scaled(&|j| Float::with_val(BITS, &g[j] * &missing[j]) / &growth[j]);
    let answer = indefinite(&grid.step, &source);
    let correction: Vec<Float> =
        answer.into_iter().enumerate().map(|(j, integral)| integral * &growth[j] + &missing[j]).collect();
    let size = correction.iter().map(|d| d.to_f64().abs()).fold(0.0, f64::max);
    size.is_finite().then_some((correction, size))
}

/// `int_(-inf)^(s_k) f ds = h sum_j f(s_j) (1/2 + Si(pi (k - j))/pi)` at every node (Haber 1993).
fn indefinite(step: &Float, f: &[Float]) -> Vec<Float> {
    let table = sine_integrals();
    let half = f.iter().fold(Float::new(BITS), |sum, f| sum + f) / 2u32;
    let at = |k: usize| {
        let sum = f.iter().enumerate().fold(half.clone(), |mut sum, (j, f)| {
            let s = &table[k.abs_diff(j)];
            if k >= j {
                sum += f * s
            } else {
                sum -= f * s
            }
            sum
        });
        sum * step
    };
    (0..f.len()).map(at).collect()
}

/// `Si(pi m)/pi` for `m = 0, 1, …`.
fn sine_integrals() -> &'static [Float] {
    static TABLE: OnceLock<Vec<Float>> = OnceLock::new();
    TABLE.get_or_init(|| (0..=LARGEST_DISTANCE as u32).map(sine_integral).collect())
}

fn sine_integral(m: u32) -> Float {
    let prec = BITS + 64 + 5 * m.min(80);
    let pi = Float::with_val(prec, Constant::Pi);
    let x = Float::with_val(prec, &pi * m);
    let square = x.clone().square();
    let value = if m > 60 {
        // pi/2 - (-1)^m (1/x) sum (-1)^n (2n)!/x^2n: the terms fall to e^-x.
        let (mut term, mut sum): (Float, Float) = (1 / x.clone(), Float::new(prec));
        for n in 1u32.. {
            sum += &term;
            let next = Float::with_val(prec, &term * -f64::from((2 * n - 1) * 2 * n)) / &square;
            if next.clone().abs() >= term.clone().abs()
                || next.get_exp() < sum.get_exp().map(|e| e - prec as i32)
            {
                break;
            }
            term = next;
        }
        let half = pi.clone() / 2u32;
        if m.is_multiple_of(2) { half - sum } else { half + sum }
    } else {
        // sum (-1)^n x^(2n+1)/((2n+1)(2n+1)!)
        let (mut power, mut sum) = (x.clone(), x.clone());
        for n in 1u32..(40 + 20 * m.max(2)) {
            power = -power * &square / (2 * n * (2 * n + 1));
            sum += Float::with_val(prec, &power / (2 * n + 1));
        }
        sum
    };
    Float::with_val(BITS, value / pi)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sine_integrals_are_right_on_both_sides_of_the_change_of_formula() {
        // Si(pi) = 1.851937051982466…, Si(2 pi) = 1.418151576132628…
        let pi = Float::with_val(BITS, Constant::Pi);
        for (m, si) in [(1, 1.851_937_051_982_466_2), (2, 1.418_151_576_132_628_5)] {
            assert!((Float::with_val(BITS, &sine_integrals()[m] * &pi).to_f64() - si).abs() < 1e-15);
        }
        // (-1)^m (S_m - 1/2) is smooth: differences of order 16 across 60 are small.
        let mut values: Vec<Float> = (52..=68)
            .map(|m| Float::with_val(BITS, &sine_integrals()[m] - 0.5f64) * (1 - 2 * (m as i32 % 2)))
            .collect();
        while values.len() > 1 {
            values = values.windows(2).map(|pair| Float::with_val(BITS, &pair[1] - &pair[0])).collect();
        }
        assert!(values[0].to_f64().abs() < 1e-16, "{}", values[0]);
    }

    #[test]
    fn linear_springs_have_their_closed_form() {
        // x'' + u x' + x = 0: epsilon = exp(-pi z/sqrt(1 - z^2)), z = u/2.
        let solution = solve(&"1,0".parse().unwrap(), 0.5, Nodes { count: 60, reach: 3.6 }).unwrap();
        let z = Float::with_val(BITS, 0.25);
        let square: Float = 1 - z.clone().square();
        let root = square.sqrt();
        let exact = (-(Float::with_val(BITS, Constant::Pi) * &z / root)).exp();
        let error = Float::with_val(BITS, solution.zero_compression.unwrap() - exact);
        assert!(solution.u == 0.5 && error.to_f64().abs() < 1e-18, "{error:e}");
    }

    #[test]
    fn spheres_agree_with_reference_digits_to_twenty() {
        // kappa such that u is about 1; compared through the certified table of both ends at that u elsewhere.
        let solve =
            |count| solve(&ForceLaw::viscoelastic_spheres(), 1.0, Nodes { count, reach: 3.8 }).unwrap();
        let (one, other) = (solve(60), solve(80));
        let off =
            |a: &Option<Float>, b: &Option<Float>| (a.clone().unwrap() - b.clone().unwrap()).to_f64().abs();
        println!(
            "{} {}",
            off(&one.zero_compression, &other.zero_compression),
            off(&one.zero_force, &other.zero_force)
        );
        assert!(off(&one.zero_compression, &other.zero_compression) < 1e-18);
        assert!(off(&one.zero_force, &other.zero_force) < 1e-18);
    }
}
