//! The orders `x_1, x_2, ...` in the damping, one after the other, in fixed point.

use super::one_variable::exponential;
use super::power_rows::{Base, PowerRows};
use super::undamped::{Linearised, Undamped};
use super::units::{Scale, fixed};
use crate::kernels::{Fixed, Sum, Transformed, Workshop};

/// Approximations of the trajectories and of the powers in their equation of motion.
pub(crate) struct Motion {
    /// `F_0 .. F_N`.
    pub f: Vec<Fixed>,
    /// `e F^a`.
    pub force: Vec<Fixed>,
    /// `d F^(gamma+1)`; empty where it is a multiple of the force.
    pub friction: Vec<Fixed>,
    /// By how far the powers are not powers: `a H theta F - F theta H`, `theta = w d/dw`, at orders `n >= 1`,
    /// divided by `n`.
    pub force_defects: Vec<Fixed>,
    pub friction_defects: Vec<Fixed>,
}

/// A power of `F` under way.
struct Power {
    rows: PowerRows,
    /// `p` times the zeroth row over `F_0`.
    slope: Transformed,
    found: Vec<Fixed>,
    defects: Vec<Fixed>,
    lower: Option<(Sum, Fixed)>,
    denominator: i64,
}

impl Power {
    fn new(products: &Products, steps: i64, zeroth: Fixed, reciprocal: &Transformed) -> Self {
        let (shop, unit) = (products.shop, products.scale.lattice.unit);
        let mut rows = PowerRows::new(steps, unit, products.size, products.rows);
        rows.push(shop, &zeroth);
        let slope = products.settle(shop.sum(&[(1, rows.rows.row(0), reciprocal)])).scaled(|_| (steps, unit));
        let slope = products.transform(&slope);
        Self { rows, slope, found: vec![zeroth], defects: Vec::new(), lower: None, denominator: unit }
    }

    /// `K_n`, what the lower orders contribute to order `n`.
    fn prepare(&mut self, products: &Products, x: &Base, reciprocal: &Transformed) {
        let n = self.found.len() as i64;
        let sum = self.rows.lower(products.shop, x);
        let mean = products.settle(sum.clone()).scaled(|_| (1, self.denominator * n));
        let mean = products.transform(&mean);
        let lower = products.settle(products.shop.sum(&[(1, &mean, reciprocal)]));
        self.lower = Some((sum, lower));
    }

    fn lower(&self) -> Option<&Fixed> {
        self.lower.as_ref().map(|(_, lower)| lower)
    }

    /// Adds order `n`, `p F_0^(p-1) F_n + K_n`, and its defect.
    fn push(&mut self, products: &Products, x: &Base) -> Option<()> {
        let mut row = products.settle(products.shop.sum(&[(1, &self.slope, x.plain.row(self.found.len()))]));
        let (sum, lower) = self.lower.take()?;
        row.add(&lower);
        self.rows.push(products.shop, &row);
        let n = self.found.len() as i64;
        let defect = products.settle(self.rows.defect(products.shop, x, sum)?);
        self.defects.push(defect.scaled(|_| (1, n)));
        self.found.push(row);
        Some(())
    }
}

/// How series of one size are multiplied: the workshop and the size of its transforms.
struct Products<'s> {
    shop: &'s Workshop,
    scale: &'s Scale,
    size: usize,
    rows: usize,
}

impl Products<'_> {
    fn transform(&self, series: &Fixed) -> Transformed {
        self.shop.transform(series, self.size, self.shop.all_primes())
    }

    fn settle(&self, sum: Sum) -> Fixed {
        self.shop.settle(sum, self.size, self.shop.bits())
    }
}

impl Motion {
    /// Derives `F_0 .. F_N` with `size` terms each: order `n` solves the linearised equation with right side
    ///
    /// ```text
    /// -(e_n/(gamma+1)) (d F^(gamma+1))_(n-1) - s K_n,    K_n of e F^a
    /// ```
    ///
    /// Products are cyclic of length `size`: what is folded over is smaller than a unit. `None` if a row has
    /// more bits than the limit.
    pub fn derive(
        shop: &Workshop,
        scale: &Scale,
        orders: usize,
        size: usize,
        limit: u32,
        watch: &mut dyn FnMut(usize),
    ) -> Option<Self> {
        let Undamped { f, force, reciprocal } = Undamped::solve(shop, scale, size);
        let within = |row: &Fixed| row.bits() <= limit;
        if ![&f, &force, &reciprocal].into_iter().all(within) {
            return None;
        }
        watch(0);
        let products = Products { shop, scale, size, rows: orders + 1 };
        let lattice = scale.lattice;
        let reciprocal = products.transform(&reciprocal);
        let friction = (!scale.shared).then(|| friction_at_order_zero(&products, &f, &reciprocal));
        let linearised = Linearised::new(scale, &f);
        let linearised =
            [products.transform(&linearised.velocity), products.transform(&linearised.rescaling)];
        let [elastic, damping] = scale.powers();
        let mut force = Power::new(&products, elastic, force, &reciprocal);
        let mut friction = friction.map(|zeroth| Power::new(&products, damping, zeroth, &reciprocal));
        let mut x = Base::new(size, products.rows);
        x.push(shop, &f);
        let mut found = vec![f];
        for n in 1..=orders {
            force.prepare(&products, &x, &reciprocal);
            if let Some(friction) = &mut friction {
                friction.prepare(&products, &x, &reciprocal);
            }
            let (numerator, denominator) = if scale.shared { scale.ratio } else { (1, 1) };
            let source = friction.as_ref().unwrap_or(&force);
            let e = |j: usize| (scale.index(n, j) * numerator, lattice.damping * denominator);
            let mut right = source.found[n - 1].scaled(e);
            if let Some(lower) = force.lower() {
                right.add(&lower.stepped());
            }
            let f_n = solve(&products, &linearised, &right.negated(), n);
            if !within(&f_n) || !within(source.found.last()?) {
                return None;
            }
            x.push(shop, &f_n);
            force.push(&products, &x)?;
            if let Some(friction) = &mut friction {
                friction.push(&products, &x)?;
            }
            found.push(f_n);
            watch(n);
        }
        let (friction, friction_defects) = friction.map_or_else(Default::default, |f| (f.found, f.defects));
        Some(Self { f: found, force: force.found, friction, force_defects: force.defects, friction_defects })
    }
}

/// Solves the linearised equation at damping order `n >= 1`.
fn solve(products: &Products, [velocity, rescaling]: &[Transformed; 2], right: &Fixed, n: usize) -> Fixed {
    let lattice = products.scale.lattice;
    let e = |j: usize| products.scale.index(n, j);
    let right = products.transform(right);
    let work = products.settle(products.shop.sum(&[(1, velocity, &right)])).scaled(|j| (lattice.unit, e(j)));
    let moment = products.settle(products.shop.sum(&[(1, rescaling, &right)]));
    let moment = moment.scaled(|j| (lattice.unit, e(j) + lattice.unit));
    let (work, moment) = (products.transform(&work), products.transform(&moment));
    let sum = products.settle(products.shop.sum(&[(1, rescaling, &work), (-1, velocity, &moment)]));
    sum.scaled(|_| (2 * lattice.unit, lattice.elastic))
}

/// `d F_0^(gamma+1)`.
///
/// With `theta = s d/ds`, `H = F^p` solves `theta H = p (theta F)/F H`.
fn friction_at_order_zero(products: &Products, f: &Fixed, reciprocal: &Transformed) -> Fixed {
    let (shop, scale) = (products.shop, products.scale);
    let slope = products.transform(&f.scaled(|j| (j as i64, 1)));
    let rate = products.settle(shop.sum(&[(1, &slope, reciprocal)]));
    let rate = rate.scaled(|_| (scale.lattice.damping, scale.lattice.unit));
    let power = exponential(shop, &rate);
    // Its reciprocal is found along the way: the constant, which may be tiny, comes last.
    let damping = fixed(&scale.damping, shop.bits());
    let multiple = |j: usize| (power.integer(j) * &damping) >> shop.bits();
    Fixed::from_integers(&(0..power.len()).map(multiple).collect::<Vec<_>>(), shop.width())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Trajectories;
    use restitution_law::ForceLaw;
    use restitution_real::Ball;

    #[test]
    fn fixed_point_trajectories_are_the_exact_ones() {
        for (law, lambda) in [("3/2,1/2", 1.0), ("2,1/3", 0.8), ("5/4,-1/4", 0.5), ("1,0", 1.0)] {
            let law: ForceLaw = law.parse().unwrap();
            let bits = 192;
            let scale = Scale::new(&law, lambda, bits);
            let shop = Workshop::new(bits, 40, (2, 1));
            let terms = f64::from(bits) / super::super::units::log_singular_ratio(&law);
            let size = crate::kernels::size_for(terms as usize + 16);
            let motion = Motion::derive(&shop, &scale, 4, size, 230, &mut |_| ()).unwrap();
            let exact = Trajectories::exact(&law, 4, 20);
            for n in 0..=4 {
                for (j, q) in exact.coefficients(n).unwrap().iter().enumerate() {
                    // Lengths and times in T, dampings in lambda.
                    let unit = scale.elastic.powi(j as i64) * scale.damping.powi(n as i64);
                    let exact = Ball::from_rational(q, 400) * unit;
                    let ours = Ball::from_big_integer(&motion.f[n].integer(j), 400).shifted(-(bits as i32));
                    let off = ((ours - exact).shifted(bits as i32)).abs().to_f64();
                    assert!(off < 2f64.powi(16), "{law} {n} {j}: {off} units");
                }
            }
        }
    }

    /// Rows of the trajectory and of the power that is the source of the next are measured; the widest decides.
    #[test]
    fn no_row_has_more_bits_than_the_limit() {
        let mut widest_are_powers = [false; 2];
        for (law, lambda) in
            [("3/2,1/2", 1.0), ("3/2,1/2", 0.25), ("2,1/3", 0.8), ("2,1/3", 8.0), ("7/3,5/6", 6.0)]
        {
            let law: ForceLaw = law.parse().unwrap();
            let (scale, shop) = (Scale::new(&law, lambda, 192), Workshop::new(192, 40, (2, 1)));
            let of = |limit| Motion::derive(&shop, &scale, 4, 128, limit, &mut |_| ());
            let motion = of(u32::MAX).unwrap();
            let most = |rows: &[Fixed]| rows.iter().map(Fixed::bits).max().unwrap();
            let source = if motion.friction.is_empty() { &motion.force } else { &motion.friction };
            let (f, power) = (most(&motion.f), most(&source[..4]));
            let start = Undamped::solve(&shop, &scale, 128);
            let limit = f.max(power).max(most(&[start.force, start.reciprocal]));
            assert!(of(limit).is_some(), "{law} {lambda}");
            assert!(of(limit - 1).is_none(), "{law} {lambda}");
            widest_are_powers[usize::from(power > f)] = true;
        }
        assert_eq!(widest_are_powers, [true; 2]);
    }
}
