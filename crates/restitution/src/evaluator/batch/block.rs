//! A block of arguments, form by form.

use super::Work;
use super::machine::{BLOCK, Block, Distance, Kept, Lost, Machine};
use crate::evaluator::curve::Curve;
use crate::evaluator::fifth_root::{Root, fifth_power, is_ordinary};
use crate::evaluator::inverse::{Given, inverse, is_in_table, is_near, near_zero, place};
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
    /// `u` of what is given of a coefficient.
    Inverse(Given),
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
        for next in (0..u.len()).step_by(BLOCK) {
            let start = next.min(last);
            let arguments: &[f64; BLOCK] = u[start..].first_chunk().expect("a block");
            let values = out[start..].first_chunk_mut().expect("a block");
            match (factor, quantity) {
                (_, Quantity::Inverse(given)) => blocks.inverse(given, arguments, values),
                (Some(law), _) => blocks.at_velocities(law, quantity, arguments, values),
                (None, Quantity::Kept) => blocks.kept(arguments, values),
                (None, _) => blocks.lost(arguments, values),
            }
        }
    }
}

/// One argument or velocity.
fn single<T: Curve>(u: f64, quantity: Quantity, factor: Option<Restitution>) -> f64 {
    match (factor, quantity) {
        (_, Quantity::Inverse(given)) => inverse_alone::<T>(u, given),
        (None, Quantity::Kept) => kept_alone::<T>(u),
        (None, _) => lost_alone::<T>(u),
        (Some(law), Quantity::Kept) => law.epsilon(u),
        (Some(law), Quantity::Lost) => law.one_minus_epsilon(u),
        (Some(law), Quantity::U) => law.u(u),
    }
}

/// The rows of arguments, and the distances from their centres.
#[inline(always)]
fn places<T: Curve>(u: &[f64; BLOCK]) -> (Block<u64>, Block<f64>) {
    let (mut start, mut t) = (Block::zeros(), Block::zeros());
    for i in 0..BLOCK {
        let (row, centre) = T::GRID.locate(u[i]);
        (start[i], t[i]) = ((row as u64).wrapping_mul(WORDS), u[i] - centre);
    }
    (start, t)
}

/// `epsilon` of one argument of a block; as a call, so that the loops of blocks stay small.
#[inline(never)]
fn kept_alone<T: Curve>(u: f64) -> f64 {
    T::epsilon(u)
}

/// `1 - epsilon` of one argument of a block.
#[inline(never)]
fn lost_alone<T: Curve>(u: f64) -> f64 {
    T::one_minus_epsilon(u)
}

/// `u` of one coefficient of a block.
#[inline(never)]
fn inverse_alone<T: Curve>(value: f64, given: Given) -> f64 {
    inverse::<T>(value, given)
}

/// Whether all arguments have a piece for `epsilon`.
#[inline(always)]
fn all_have_pieces<T: Curve>(u: &[f64; BLOCK]) -> bool {
    let mut all = true;
    for u in u {
        all &= (T::NOTHING_LOST <= *u) & (*u < T::END);
    }
    all
}

/// Blocks are evaluated by a machine in a table.
struct Blocks<M, T> {
    machine: M,
    table: PhantomData<T>,
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
        let (start, t) = places::<T>(u);
        self.machine.read::<Kept, _>(T::TABLE, &start, &t, out);
        if !all_have_pieces::<T>(u) {
            for (u, out) in u.iter().zip(out) {
                if !(T::NOTHING_LOST..T::END).contains(u) {
                    *out = kept_alone::<T>(*u);
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
        let (mut near, mut table) = (0_u64, 0_u64);
        for u in u {
            near += u64::from((0.0 <= *u) & (*u < T::NEAR_END));
            table += u64::from((T::NEAR_END <= *u) & (*u < T::END));
        }
        let ways = Ways::of(near, table);
        if ways.table {
            let (start, t) = places::<T>(u);
            self.machine.read::<Lost, _>(T::TABLE, &start, &t, out);
        }
        if ways.near {
            for i in 0..BLOCK {
                let value = T::near(u[i]);
                out[i] = if u[i] < T::NEAR_END { value } else { out[i] };
            }
        }
        if ways.alone {
            for (u, out) in u.iter().zip(out) {
                if !(T::NEAR_END..T::END).contains(u) {
                    *out = lost_alone::<T>(*u);
                }
            }
        }
    }

    /// `u` of a block of coefficients.
    #[inline(always)]
    fn inverse(&self, given: Given, values: &[f64; BLOCK], out: &mut [f64; BLOCK])
    where
        T: Curve,
    {
        let (mut near, mut table) = (0_u64, 0_u64);
        for value in values {
            let [kept, lost] = given.both(*value);
            near += u64::from(is_near::<T>(lost));
            table += u64::from(is_in_table::<T>(kept, lost));
        }
        let ways = Ways::of(near, table);
        if ways.table {
            let (mut start, mut change, mut centre) = (Block::zeros(), Block::zeros(), Block::<f64>::zeros());
            for i in 0..BLOCK {
                let [kept, lost] = given.both(values[i]);
                let (index, missing) = place::<T>(kept, lost);
                (start[i], change[i], centre[i]) = (index as u64 * WORDS, missing, T::GRID.centre(index));
            }
            self.machine.read::<Distance, _>(T::TABLE, &start, &change, out);
            for i in 0..BLOCK {
                out[i] += centre[i];
            }
        }
        if ways.near {
            for i in 0..BLOCK {
                let [_, lost] = given.both(values[i]);
                let u = near_zero::<T>(lost);
                out[i] = if is_near::<T>(lost) { u } else { out[i] };
            }
        }
        if ways.alone {
            for (value, out) in values.iter().zip(out) {
                let [kept, lost] = given.both(*value);
                if !is_in_table::<T>(kept, lost) {
                    *out = inverse_alone::<T>(*value, given);
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
        let (mut start, mut t, mut estimates) = (Block::zeros(), Block::zeros(), Block::<f64>::zeros());
        for i in 0..BLOCK {
            let root = roots.at(i);
            estimates[i] = root.estimate();
            let (row, centre) = T::GRID.locate(estimates[i]);
            (start[i], t[i]) = ((row as u64).wrapping_mul(WORDS), root.distance(centre));
        }
        self.machine.read::<Kept, _>(T::TABLE, &start, &t, out);
        if !all_have_pieces::<T>(&estimates) {
            for i in 0..BLOCK {
                if !(T::NOTHING_LOST..T::END).contains(&estimates[i]) {
                    out[i] = law.epsilon(velocities[i]);
                }
            }
        }
    }
}

/// Up to so many arguments near 0 are evaluated one by one rather than the form for all.
const FEW: u64 = 4;

/// Which ways a block goes.
#[derive(Debug, PartialEq)]
struct Ways {
    /// All of it through the table.
    table: bool,
    /// All of it through the form near 0.
    near: bool,
    /// What has no piece one by one.
    alone: bool,
}

impl Ways {
    /// The ways of a block of which so many arguments lie near 0 and so many in the table.
    #[inline(always)]
    fn of(near: u64, table: u64) -> Self {
        let few = (1..=FEW).contains(&near);
        Self { table: table > 0, near: near > FEW, alone: few || near + table < BLOCK as u64 }
    }
}

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_goes_no_way_for_nothing() {
        for near in 0..=BLOCK as u64 {
            for table in 0..=BLOCK as u64 - near {
                let Ways { table: by_table, near: by_form, alone } = Ways::of(near, table);
                let others = BLOCK as u64 - near - table;
                assert_eq!(by_table, table != 0, "{near} {table}");
                assert_eq!(by_form, near >= 5, "{near} {table}");
                assert_eq!(alone, others != 0 || (!by_form && near != 0), "{near} {table}");
            }
        }
    }

    #[test]
    fn pieces_begin_where_something_is_lost_and_end_with_the_table() {
        fn check<T: Curve>() {
            let within = |at: usize, u: f64| {
                let mut block = [1.0; BLOCK];
                block[at] = u;
                all_have_pieces::<T>(&block)
            };
            for at in [0, 1, BLOCK - 1] {
                assert!(within(at, T::NOTHING_LOST) && within(at, T::END.next_down()));
                assert!(!within(at, T::NOTHING_LOST.next_down()) && !within(at, T::END));
                assert!(
                    !within(at, f64::NAN)
                        && !within(at, -1.0)
                        && !within(at, 0.0)
                        && !within(at, f64::INFINITY)
                );
            }
        }
        check::<ZeroCompression>();
        check::<ZeroForce>();
    }
}
