//! The turning point and the largest compression as series in the damping, in fixed point.

use super::one_variable::{one, reciprocal};
use super::power_rows::{Base, PowerRows};
use super::units::{Scale, fixed};
use crate::kernels::{Fixed, Transformed, Workshop, size_for};
use restitution_law::Lattice;
use restitution_real::Ball;
use rug::Integer;

/// The trajectory around the undamped turning point as a polynomial:
///
/// ```text
/// x(T + rho v theta)/x_0(T) = sum_(k <= N) v^k P_k(theta),   deg P_k <= k
/// ```
pub(crate) struct Neighbourhood {
    /// `P_0 .. P_N`, `P_k` with `k + 1` coefficients.
    pub rows: Vec<Fixed>,
}

/// The constants of the equation of motion in units of `x_0(T)`: `e' = e x_0^(a-1)`, `d' = d x_0^gamma`.
#[derive(Clone, Debug)]
pub(crate) struct TurningScale {
    pub elastic: Ball,
    pub damping: Ball,
    /// `rho`, a short fraction.
    pub step: (i64, i64),
}

/// A power of the trajectory under way, with its transforms of the size at hand.
struct Power {
    steps: i64,
    unit: i64,
    found: Vec<Fixed>,
    rows: PowerRows,
}

impl Power {
    fn new(steps: i64, unit: i64, constant: &Integer, width: usize) -> Self {
        let zeroth = Fixed::from_integers(std::slice::from_ref(constant), width);
        Self { steps, unit, found: vec![zeroth], rows: PowerRows::new(steps, unit, 1, 1) }
    }

    fn transform_again(&mut self, shop: &Workshop, size: usize, rows: usize) {
        self.rows = PowerRows::new(self.steps, self.unit, size, rows);
        for row in &self.found {
            self.rows.push(shop, row);
        }
    }

    /// Row `n` from the rows of the trajectory up to `n`; `X_0 = 1`, so that nothing is divided.
    ///
    /// Every coefficient has an error of less than 2 units against the rows below.
    fn push(&mut self, shop: &Workshop, x: &Base) -> Option<()> {
        let n = self.found.len();
        let mut sum = self.rows.lower(shop, x);
        shop.add(&mut sum, &[(self.steps * n as i64, x.plain.row(n), self.rows.rows.row(0))])?;
        let row = shop.settle(sum, n + 1, shop.bits()).scaled(|_| (1, self.unit * n as i64));
        self.rows.push(shop, &row);
        self.found.push(row);
        Some(())
    }
}

impl Neighbourhood {
    /// Continues `x_n(T)/x_0(T)` and `x_n'(T)/x_0(T)` by the equation of motion:
    ///
    /// ```text
    /// l (l-1) P_(k,l) = - rho^2 (e' x^a)_(k-2,l-2) - rho (l-1)/(gamma+1) (d' x^(gamma+1))_(k-2,l-1)
    /// ```
    ///
    /// `None` if a row has more bits than the limit.
    pub fn new(
        shop: &Workshop,
        scale: &Scale,
        turning: &TurningScale,
        position: &[Integer],
        velocity: &[Integer],
        limit: u32,
    ) -> Option<Self> {
        let [elastic, damping] = scale.powers();
        let unit = scale.lattice.unit;
        let constant = |x: &Ball| fixed(x, shop.bits());
        let mut force = Power::new(elastic, unit, &constant(&turning.elastic), shop.width());
        let mut friction =
            (!scale.shared).then(|| Power::new(damping, unit, &constant(&turning.damping), shop.width()));
        let mut rows: Vec<Fixed> = vec![one(shop)];
        let orders = position.len();
        let mut x = Base::new(1, orders);
        let mut size = 0;
        for k in 0..orders {
            if k > 0 {
                let drag = friction.as_ref().unwrap_or(&force);
                let forces = (k >= 2).then(|| (&force.found[k - 2], &drag.found[k - 2]));
                let row = row(scale, turning, forces, k, &position[k], &velocity[k - 1]);
                if row.iter().any(|c| c.significant_bits() > limit) || drag.found.last()?.bits() > limit {
                    return None;
                }
                rows.push(Fixed::from_integers(&row, shop.width()));
            }
            if k + 1 > size {
                // Row n of a power has degree n.
                size = size_for((k + k / 2 + 4).min(orders));
                x = Base::new(size, orders);
                rows.iter().for_each(|row| x.push(shop, row));
                force.transform_again(shop, size, orders);
                friction.iter_mut().for_each(|power| power.transform_again(shop, size, orders));
            } else {
                x.push(shop, &rows[k]);
            }
            if k > 0 && k + 2 < orders {
                force.push(shop, &x)?;
                if let Some(friction) = &mut friction {
                    friction.push(shop, &x)?;
                }
            }
        }
        Some(Self { rows })
    }

    /// The coefficient of `theta^l` as a series in `v` without its factor `v^l`, below `v^len`.
    fn column(&self, l: usize, len: usize, width: usize) -> Fixed {
        let mut words = Vec::with_capacity(len * width);
        for row in self.rows.iter().skip(l).take(len) {
            words.extend_from_slice(row.words(l));
        }
        Fixed::from_words(words, width)
    }

    /// The derivative `d/d(v theta)`, so often, at `v theta = shift`, below `v^len`.
    pub fn derivative_at(&self, shop: &Workshop, shift: &Fixed, derivative: usize, len: usize) -> Fixed {
        let last = (len + derivative).min(self.rows.len());
        let step = len.isqrt().max(1);
        let size = size_for(2 * len);
        let transform = |series: &Fixed| shop.transform(series, size, shop.all_primes());
        let mut powers = vec![one(shop)];
        for i in 1..=step {
            powers.push(shop.product(&powers[i - 1], shift, len));
        }
        let giant = powers.pop().unwrap_or_else(|| one(shop));
        let powers: Vec<Transformed> = powers.iter().map(transform).collect();
        let mut sum = Fixed::zero(len, shop.width());
        for block in (0..(last - derivative).div_ceil(step)).rev() {
            let from = block * step;
            let needed = len - from;
            let columns: Vec<(i64, Transformed)> = (from..(from + step).min(last - derivative))
                .map(|i| {
                    let l = i + derivative;
                    let falling = (0..derivative).map(|k| (l - k) as i64).product();
                    (falling, transform(&self.column(l, needed, shop.width())))
                })
                .collect();
            let terms: Vec<_> = columns.iter().zip(&powers).map(|((w, c), p)| (*w, c, p)).collect();
            let mut next = shop.product(&sum, &giant, needed);
            next.add(&shop.settle(shop.sum(&terms), needed, shop.bits()));
            sum = next;
        }
        sum
    }

    /// The shift of the turning point, `v theta`, below `v^len`, by Newton's iteration on `x' = 0`.
    pub fn shift(&self, shop: &Workshop, len: usize) -> Fixed {
        let mut shift = Fixed::zero(1, shop.width());
        while shift.len() < len {
            let known = shift.len();
            let next = (2 * known).min(len);
            let mut padded = shift.clone();
            padded.extend(&Fixed::zero(next - known, shop.width()));
            let velocity = self.derivative_at(shop, &padded, 1, next).beyond(known);
            let acceleration = self.derivative_at(shop, &padded, 2, next - known);
            let correction = shop.product(&velocity, &reciprocal(shop, &acceleration), next - known);
            shift.extend(&correction.negated());
        }
        shift
    }
}

/// The coefficients of `P_k`, each rounded by less than one unit.
fn row(
    scale: &Scale,
    turning: &TurningScale,
    forces: Option<(&Fixed, &Fixed)>,
    k: usize,
    position: &Integer,
    velocity: &Integer,
) -> Vec<Integer> {
    let Lattice { damping, unit, .. } = scale.lattice;
    let (rn, rd) = turning.step;
    let mut row = vec![position.clone(), Integer::from(velocity * rn) / rd];
    let Some((pull, drag)) = forces else { return row };
    let (numerator, denominator) = if scale.shared { scale.ratio } else { (1, 1) };
    for l in 2..=k {
        // Over the common denominator rd^2 damping denominator.
        let mut sum = pull.integer(l - 2) * (rn * rn) * (damping * denominator);
        if l < k {
            sum += drag.integer(l - 1) * (rn * rd) * (unit * numerator) * (l - 1) as i64;
        }
        let steps = (l * (l - 1)) as i64;
        row.push(-(sum / (rd * rd)) / (damping * denominator) / steps);
    }
    row
}

#[cfg(test)]
mod tests {
    use super::*;

    /// At `theta = t` the coefficient of `v^m` of the `d`-th derivative is that of `P_(m+d)` at `t`.
    #[test]
    fn derivatives_are_those_of_the_polynomials() {
        let bits = 128;
        let shop = Workshop::new(bits, 40, (2, 1));
        let p = |k: usize, l: usize| (7 * k * k + 5 * l + 3 * k * l) as i64 % 11 - 5;
        for orders in [3, 8, 12, 17] {
            let row = |k| -> Vec<Integer> { (0..=k).map(|l| Integer::from(p(k, l)) << bits).collect() };
            let rows = (0..orders).map(|k| Fixed::from_integers(&row(k), shop.width())).collect();
            let neighbourhood = Neighbourhood { rows };
            for (derivative, t) in [(0, 1), (1, 1), (2, 1), (0, -2), (1, -2), (2, -2)] {
                for len in [1, 2, orders - 2, orders] {
                    let shift = [Integer::new(), Integer::from(t) << bits];
                    let shift = Fixed::from_integers(&shift[..len.min(2)], shop.width());
                    let found = neighbourhood.derivative_at(&shop, &shift, derivative, len);
                    assert_eq!(found.len(), len);
                    for m in 0..len {
                        let k = m + derivative;
                        let falling = |l: usize| (0..derivative).map(|i| (l - i) as i64).product::<i64>();
                        let term = |l: usize| falling(l) * p(k, l) * i64::pow(t, (l - derivative) as u32);
                        let value = if k < orders { (derivative..=k).map(term).sum() } else { 0 };
                        let off = (found.integer(m) - (Integer::from(value) << bits)).abs();
                        assert!(off < 1 << 30, "{orders} {derivative} {t} {len} {m}");
                    }
                }
            }
        }
    }
}
