//! A block of arguments, form by form.

use super::Work;
use super::machine::{BLOCK, Block, Machine};
use crate::evaluator::curve::Curve;
use crate::evaluator::fifth_root::{Root, fifth_power, is_ordinary};
use crate::evaluator::pieces::WORDS;
use crate::evaluator::zero_compression::ZeroCompression;
use crate::evaluator::zero_force::ZeroForce;
use crate::{End, Restitution};
use core::marker::PhantomData;

/// What is asked for.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Quantity {
    /// `epsilon`.
    Kept,
    /// `1 - epsilon`.
    Lost,
    /// `u` of a velocity.
    U,
}

/// A batch: arguments `u`, or velocities if there is a law that turns them into `u`.
pub(super) struct Batch<'a> {
    pub(super) u: &'a [f64],
    pub(super) out: &'a mut [f64],
    pub(super) end: End,
    pub(super) quantity: Quantity,
    pub(super) factor: Option<Restitution>,
}

impl Work for Batch<'_> {
    #[inline(always)]
    fn run(self, machine: impl Machine) {
        match self.end {
            End::ZeroCompression => self.run_table(Blocks::<_, ZeroCompression>::on(machine)),
            End::ZeroForce => self.run_table(Blocks::<_, ZeroForce>::on(machine)),
        }
    }
}

/// Evaluates `epsilon` of one block.
#[inline(always)]
pub(super) fn evaluate(machine: impl Machine, end: End, u: &[f64; BLOCK], out: &mut [f64; BLOCK]) {
    match end {
        End::ZeroCompression => Blocks::<_, ZeroCompression>::on(machine).kept(u, out),
        End::ZeroForce => Blocks::<_, ZeroForce>::on(machine).kept(u, out),
    }
}

impl Batch<'_> {
    /// Evaluates block by block; the last block ends with the last argument, whatever it repeats.
    // Loops and named functions that are always inlined, not closures: only what ends up inside the function that a
    // machine has compiled for itself uses its instructions.
    #[inline(always)]
    fn run_table<M: Machine, T: Curve>(self, blocks: Blocks<M, T>) {
        let Batch { u, out, quantity, factor, .. } = self;
        if u.len() < BLOCK {
            for (u, out) in u.iter().zip(out) {
                *out = single::<T>(*u, quantity, factor);
            }
            return;
        }
        let last = u.len() - BLOCK;
        let mut next = 0;
        while next < u.len() {
            let start = next.min(last);
            let arguments: &[f64; BLOCK] = u[start..].first_chunk().expect("a block");
            let values = out[start..].first_chunk_mut().expect("a block");
            match (factor, quantity) {
                (Some(law), _) => blocks.at_velocities(law, quantity, arguments, values),
                (None, Quantity::Kept) => blocks.kept(arguments, values),
                (None, _) => blocks.lost(arguments, values),
            }
            next += BLOCK;
        }
    }
}

/// One argument or velocity.
fn single<T: Curve>(u: f64, quantity: Quantity, factor: Option<Restitution>) -> f64 {
    match (factor, quantity) {
        (None, Quantity::Kept) => T::epsilon(u),
        (None, _) => T::one_minus_epsilon(u),
        (Some(law), Quantity::Kept) => law.epsilon(u),
        (Some(law), Quantity::Lost) => law.one_minus_epsilon(u),
        (Some(law), Quantity::U) => law.u(u),
    }
}

/// The rows of arguments that are placed in `u`, and the distances from their centres.
#[inline(always)]
fn places<T: Curve>(u: &[f64; BLOCK]) -> (Block<u64>, Block<f64>) {
    let (mut start, mut t) = (Block::zeros(), Block::zeros());
    for i in 0..BLOCK {
        let (row, centre) = T::place(u[i]);
        (start[i], t[i]) = (row.wrapping_mul(WORDS), u[i] - centre);
    }
    (start, t)
}

/// The rows of arguments each of which is placed in its own variable.
#[inline(always)]
fn mixed_places<T: Curve>(u: &[f64; BLOCK]) -> Places {
    let mut places = Places::new();
    for (i, u) in u.iter().enumerate() {
        let (row, centre) = T::place(*u);
        let (other, t, power) = T::place_other(*u, 0.0);
        let is_other = T::is_other(*u);
        places.start[i] = if is_other { other } else { row }.wrapping_mul(WORDS);
        places.t[i] = if is_other { t } else { *u - centre };
        if T::HAS_POWER {
            places.power[i] = if is_other { power } else { 1.0 };
        }
    }
    places
}

/// Blocks are evaluated by a machine in a table.
struct Blocks<M, T> {
    machine: M,
    table: PhantomData<T>,
}

/// The words of the table at which the rows of a block start, the distances from their centres, and what values are multiplied by.
struct Places {
    start: Block<u64>,
    t: Block<f64>,
    power: Block<f64>,
}

impl Places {
    #[inline(always)]
    fn new() -> Self {
        Self { start: Block::zeros(), t: Block::zeros(), power: Block::zeros() }
    }
}

impl<M: Machine, T> Blocks<M, T> {
    #[inline(always)]
    fn on(machine: M) -> Self {
        Self { machine, table: PhantomData }
    }

    /// `epsilon` of a block.
    #[inline(always)]
    fn kept(&self, u: &[f64; BLOCK], out: &mut [f64; BLOCK])
    where
        T: Curve,
    {
        let (mut common, mut odd) = (true, false);
        for u in u {
            common &= (T::NOTHING_LOST <= *u) & (*u < T::END) & !T::is_other(*u);
            odd |= !((0.0 <= *u) & (*u < T::END));
        }
        if common {
            let (start, t) = places::<T>(u);
            self.machine.values(T::TABLE, &start, &t, out);
            return;
        }
        let places = mixed_places::<T>(u);
        self.machine.values(T::TABLE, &places.start, &places.t, out);
        for i in 0..BLOCK {
            let value = if T::HAS_POWER { out[i] * places.power[i] } else { out[i] };
            out[i] = if u[i] < T::NOTHING_LOST { 1.0 } else { value };
        }
        if odd {
            for i in 0..BLOCK {
                if !(0.0..T::END).contains(&u[i]) {
                    out[i] = T::epsilon(u[i]);
                }
            }
        }
    }

    /// `1 - epsilon` of a block.
    #[inline(always)]
    fn lost(&self, u: &[f64; BLOCK], out: &mut [f64; BLOCK])
    where
        T: Curve,
    {
        let (mut near, mut common, mut odd) = (0_u64, true, false);
        for u in u {
            let is_near = *u < T::NEAR_END;
            near += u64::from(is_near);
            common &= is_near | !T::is_other(*u);
            odd |= !((0.0 <= *u) & (*u < T::END));
        }
        if common && near < BLOCK as u64 {
            let (start, t) = places::<T>(u);
            self.machine.losses(T::TABLE, &start, &t, out);
        }
        if !common {
            let places = mixed_places::<T>(u);
            let mut kept = Block::zeros();
            self.machine.values_and_losses(T::TABLE, &places.start, &places.t, &mut kept, out);
            for i in 0..BLOCK {
                let beyond = 1.0 - kept[i] * places.power[i];
                out[i] = if T::is_other(u[i]) { beyond } else { out[i] };
            }
        }
        if near > FEW {
            for i in 0..BLOCK {
                let value = T::near(u[i]);
                out[i] = if u[i] < T::NEAR_END { value } else { out[i] };
            }
        }
        if odd | (near > 0 && near <= FEW) {
            for i in 0..BLOCK {
                if u[i] < T::NEAR_END || !(0.0..T::END).contains(&u[i]) {
                    out[i] = T::one_minus_epsilon(u[i]);
                }
            }
        }
    }

    /// Evaluates at velocities: the fifth roots of the block, then as single calls do.
    #[inline(always)]
    fn at_velocities(
        &self,
        law: Restitution,
        quantity: Quantity,
        velocities: &[f64; BLOCK],
        out: &mut [f64; BLOCK],
    ) where
        T: Curve,
    {
        let (ordinary, roots) = self.roots(law.factor(), velocities);
        if quantity == Quantity::Kept && ordinary {
            self.of_roots(law, velocities, &roots, out);
            return;
        }
        if quantity == Quantity::Kept {
            for i in 0..BLOCK {
                out[i] = law.epsilon(velocities[i]);
            }
            return;
        }
        let mut u = Block::<f64>::zeros();
        for i in 0..BLOCK {
            u[i] = roots.at(i).distance(0.0);
        }
        if !ordinary {
            for i in 0..BLOCK {
                u[i] = law.u(velocities[i]);
            }
        }
        if quantity == Quantity::U { *out = *u } else { self.lost(&u, out) }
    }

    /// Takes the fifth roots, and says whether all products are ordinary numbers.
    #[inline(always)]
    fn roots(&self, factor: f64, velocities: &[f64; BLOCK]) -> (bool, Roots) {
        let mut ordinary = true;
        let (mut index, mut y, mut scale) = (Block::zeros(), Block::zeros(), Block::zeros());
        for i in 0..BLOCK {
            let x = factor * velocities[i];
            ordinary &= is_ordinary(x);
            (index[i], y[i], scale[i]) = Root::place(x);
        }
        let (mut root, mut reciprocal) = (Block::zeros(), Block::zeros());
        self.machine.roots(&index, &mut root, &mut reciprocal);
        let mut power = Block::zeros();
        for i in 0..BLOCK {
            power[i] = fifth_power(root[i]);
        }
        (ordinary, Roots { root, reciprocal, power, y, scale })
    }

    /// `epsilon` from roots that are known better than one f64.
    #[inline(always)]
    fn of_roots(&self, law: Restitution, velocities: &[f64; BLOCK], roots: &Roots, out: &mut [f64; BLOCK])
    where
        T: Curve,
    {
        let (mut places, mut common, mut odd) = (Places::new(), true, false);
        for i in 0..BLOCK {
            let root = roots.at(i);
            let estimate = root.estimate();
            let (row, centre) = T::place(estimate);
            common &= (T::NOTHING_LOST <= estimate) & !T::is_other(estimate);
            odd |= estimate >= T::END;
            (places.start[i], places.t[i]) = (row.wrapping_mul(WORDS), root.distance(centre));
        }
        let mut u = Block::<f64>::zeros();
        if !common {
            for i in 0..BLOCK {
                let root = roots.at(i);
                u[i] = root.distance(0.0);
                let (other, t, power) = T::place_other(u[i], root.distance(u[i]));
                let is_other = T::is_other(root.estimate());
                places.start[i] = if is_other { other.wrapping_mul(WORDS) } else { places.start[i] };
                places.t[i] = if is_other { t } else { places.t[i] };
                places.power[i] = if is_other { power } else { 1.0 };
            }
        }
        self.machine.values(T::TABLE, &places.start, &places.t, out);
        if !common {
            for (i, out) in out.iter_mut().enumerate() {
                let one = roots.at(i).estimate() < T::NOTHING_LOST;
                let value = if T::HAS_POWER { *out * places.power[i] } else { *out };
                *out = if one { 1.0 } else { value };
            }
        }
        if odd {
            for i in 0..BLOCK {
                if roots.at(i).estimate() >= T::END {
                    out[i] = law.epsilon(velocities[i]);
                }
            }
        }
    }
}

/// Up to so many arguments near 0 are evaluated one by one rather than the form for all.
const FEW: u64 = 4;

/// What the fifth roots of a block are made of.
struct Roots {
    root: Block<f64>,
    reciprocal: Block<f64>,
    power: Block<f64>,
    y: Block<f64>,
    scale: Block<f64>,
}

impl Roots {
    #[inline(always)]
    fn at(&self, i: usize) -> Root {
        Root::from_piece([self.root[i], self.reciprocal[i]], self.power[i], self.y[i], self.scale[i])
    }
}
