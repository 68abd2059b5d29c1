//! One step in time of all collisions of an interval: the coordinate as a polynomial, approximately.

use super::jets::Jets;
use crate::coordinate::Coordinate;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive};
use restitution_real::convert::rug_integer;
use rug::Integer;

/// The motion in a coordinate `x = z^q` and a time with `dt = z^(q-1) ds`, in which it is polynomial:
///
/// ```text
/// dz/ds = v/q,    dv/ds = -z^common (z^elastic + u z^damping v)
/// ```
///
/// with `common + elastic = A - 1`, `common + damping = B - 1`; analytic through `z = 0` and `v = 0`. A time
/// that runs `c` times as fast, `c` a jet, has the velocity `c v`, the stiffness `c^2` and the damping `c u`.
#[derive(Clone, Debug)]
pub(crate) struct Flow {
    /// `q` as a fraction.
    pub(crate) q: (Integer, Integer),
    pub(crate) common: u32,
    pub(crate) elastic: u32,
    pub(crate) damping: u32,
    /// The damping `u`, a jet in units of `2^-bits`, exactly.
    pub(crate) u: Vec<Integer>,
    /// The pace `c` of time, a jet in the same units with the constant term 1, exactly.
    pub(crate) pace: Vec<Integer>,
    /// `c u` and `c^2`, approximately.
    scaled_u: Vec<Integer>,
    stiffness: Vec<Integer>,
    pub(crate) bits: u32,
    /// Degree in `theta`.
    pub(crate) order: usize,
    /// Coefficients kept in `delta`.
    pub(crate) width: usize,
}

impl Flow {
    /// The flow of a law at this precision; `None` if it is not analytic at `z = 0`.
    pub(crate) fn new(
        c: &Coordinate,
        u: Vec<Integer>,
        bits: u32,
        order: usize,
        width: usize,
    ) -> Option<Self> {
        if !c.crosses_zero() {
            return None;
        }
        let power = |n: &BigRational| (n - BigRational::one()).to_integer().to_u32();
        let (a, b) = (power(&c.elastic)?, power(&c.damping)?);
        let common = a.min(b);
        let q = (rug_integer(c.q.numer()), rug_integer(c.q.denom()));
        let pace = unit_row(width, bits);
        let (elastic, damping) = (a - common, b - common);
        let (scaled_u, stiffness) = (padded(&u, width), pace.clone());
        Some(Self { q, common, elastic, damping, u, pace, scaled_u, stiffness, bits, order, width })
    }

    /// The same flow in a time with this pace.
    pub(crate) fn at_pace(&self, pace: Vec<Integer>) -> Self {
        let (scaled_u, stiffness) = (self.jet_product(&self.u, &pace), self.jet_product(&pace, &pace));
        Self { scaled_u, stiffness, pace, ..self.clone() }
    }

    /// The product of two jets, cut off at the width and rounded.
    pub(crate) fn jet_product(&self, x: &[Integer], y: &[Integer]) -> Vec<Integer> {
        convolution(&padded(x, self.width), &padded(y, self.width), 0, self.width, self.bits)
    }

    /// The powers of `z` that are needed, each as the product of two smaller ones.
    pub(crate) fn powers(&self) -> Vec<u32> {
        let mut needed = vec![self.common, self.elastic, self.damping];
        let mut i = 0;
        while i < needed.len() {
            if needed[i] > 1 {
                needed.extend([needed[i] / 2, needed[i].div_ceil(2)]);
            }
            i += 1;
        }
        needed.retain(|n| *n > 1);
        needed.sort_unstable();
        needed.dedup();
        needed
    }

    /// Returns the coordinate as a polynomial of degree `order`, from a start `z_0`, `v_0`.
    ///
    /// Fixed point, every product and division rounded, no error carried: what is returned is judged
    /// by its defect.
    pub(crate) fn solve(&self, z: &[Integer], v: &[Integer], step: Step) -> Jets {
        let mut table = Table::new(self, z);
        let mut speed = v.to_vec();
        let mut velocities: Vec<Integer> = Vec::with_capacity(self.order * self.width);
        for k in 0..self.order {
            velocities.extend(speed.iter().cloned());
            let force = table.force(self, &velocities, k);
            let divisor = Integer::from(step.rate) * (k as u64 + 1);
            let row: Vec<Integer> = speed.iter().map(|v| Integer::from(v << step.shift) / &divisor).collect();
            let divisor = divisor * &self.q.1;
            speed =
                force.iter().map(|f| -((Integer::from(f * &self.q.0) << step.shift) / &divisor)).collect();
            table.coordinate.extend(row);
        }
        Jets { width: self.width, bits: self.bits, coefficients: table.coordinate }
    }
}

/// A length `h = q 2^shift/rate` of a step, chosen so that `v = (q/h) dz/dtheta` is exact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step {
    pub(crate) rate: u64,
    pub(crate) shift: u32,
}

impl Step {
    /// A step of about this length; `None` if there is none.
    pub(crate) fn near(length: f64, q: f64) -> Option<Self> {
        let rate = q / length;
        if !(1e-6..1e15).contains(&rate) {
            return None;
        }
        let shift = (6.0 - rate.log2().floor()).max(0.0) as u32;
        Some(Self { rate: (rate * f64::from(shift).exp2()).round() as u64, shift })
    }
}

/// The rows of `z`, its powers and the products with them, as far as they are known.
struct Table {
    coordinate: Vec<Integer>,
    powers: Vec<(u32, Vec<Integer>)>,
    /// `u v` and `z^elastic + u z^damping v`.
    pull: Vec<Integer>,
    balance: Vec<Integer>,
}

impl Table {
    fn new(flow: &Flow, z: &[Integer]) -> Self {
        let powers = flow.powers().into_iter().map(|n| (n, Vec::new())).collect();
        Self { coordinate: z.to_vec(), powers, pull: Vec::new(), balance: Vec::new() }
    }

    /// Row `k` of `z^common (z^elastic + u z^damping v)`.
    fn force(&mut self, flow: &Flow, v: &[Integer], k: usize) -> Vec<Integer> {
        let w = flow.width;
        for i in 0..self.powers.len() {
            let n = self.powers[i].0;
            let row = convolution(self.power(n / 2), self.power(n.div_ceil(2)), k, w, flow.bits);
            self.powers[i].1.extend(row);
        }
        let pulled = convolution(&flow.scaled_u, &v[k * w..(k + 1) * w], 0, w, flow.bits);
        self.pull.extend(pulled);
        let damped = match flow.damping {
            0 => self.pull[k * w..].to_vec(),
            n => convolution(self.power(n), &self.pull, k, w, flow.bits),
        };
        let elastic = match flow.elastic {
            0 if k == 0 => flow.stiffness.clone(),
            0 => vec![Integer::new(); w],
            n => convolution(&flow.stiffness, &self.power(n)[k * w..(k + 1) * w], 0, w, flow.bits),
        };
        self.balance.extend(damped.into_iter().zip(elastic).map(|(x, y)| x + y));
        match flow.common {
            0 => self.balance[k * w..].to_vec(),
            n => convolution(self.power(n), &self.balance, k, w, flow.bits),
        }
    }

    fn power(&self, n: u32) -> &[Integer] {
        if n == 1 {
            return &self.coordinate;
        }
        self.powers.iter().find(|(m, _)| *m == n).map_or(&[], |(_, rows)| rows)
    }
}

fn padded(jet: &[Integer], width: usize) -> Vec<Integer> {
    let mut jet = jet.to_vec();
    jet.resize(width, Integer::new());
    jet
}

/// The jet 1.
pub(crate) fn unit_row(width: usize, bits: u32) -> Vec<Integer> {
    let mut row = vec![Integer::new(); width];
    row[0] = Integer::from(1) << bits;
    row
}

/// Row `k` of a product of two series of jets, cut off at the width and rounded.
fn convolution(a: &[Integer], b: &[Integer], k: usize, width: usize, bits: u32) -> Vec<Integer> {
    let row = |i: usize| i * width..(i + 1) * width;
    let mut sum = vec![Integer::new(); width];
    let add = |i: usize, sum: &mut Vec<Integer>| {
        for (p, c) in a[row(i)].iter().enumerate().filter(|(_, c)| !c.is_zero()) {
            for (s, d) in sum[p..].iter_mut().zip(&b[row(k - i)]) {
                *s += c * d;
            }
        }
    };
    if std::ptr::eq(a, b) {
        (0..k.div_ceil(2)).for_each(|i| add(i, &mut sum));
        sum.iter_mut().for_each(|s| *s <<= 1);
        if k.is_multiple_of(2) {
            add(k / 2, &mut sum);
        }
    } else {
        (0..=k).for_each(|i| add(i, &mut sum));
    }
    sum.iter_mut().for_each(|s| *s >>= bits);
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_power_that_is_needed_is_the_product_of_two_smaller_ones() {
        // a = 4, gamma = 1/2: A = 10, B = 3, so that z^2, z^7 and with it z^3, z^4 are needed.
        for (law, wanted) in [("4,1/2", vec![2, 3, 4, 7]), ("3/2,1/2", vec![2]), ("1,0", vec![])] {
            let coordinate = Coordinate::of(&law.parse().unwrap());
            let flow = Flow::new(&coordinate, vec![Integer::from(1) << 63], 64, 9, 1).unwrap();
            assert_eq!(flow.powers(), wanted, "{law}");
        }
        let branch = Coordinate::of(&"7/3,5/6".parse().unwrap());
        assert!(Flow::new(&branch, vec![Integer::from(1)], 64, 9, 1).is_none());
    }
}
