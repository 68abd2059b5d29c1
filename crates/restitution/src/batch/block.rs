//! A block of arguments, form by form.

use super::machine::{BLOCK, Block, Machine};
use crate::fifth_root::{Root, is_ordinary};
use crate::pieces::{Grid, Piece};
use crate::{End, Restitution, zero_compression, zero_force};

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

impl Batch<'_> {
    /// Evaluates block by block; the last block ends with the last argument, whatever it repeats.
    #[inline(always)]
    pub(super) fn run(self, machine: impl Machine) {
        let quantity = self.quantity;
        match self.end {
            End::ZeroCompression => self.run_form(machine, &zero_compression_form(quantity)),
            End::ZeroForce => self.run_form(machine, &zero_force_form(quantity)),
        }
    }

    // Loops and named functions that are always inlined, not closures: only what ends up inside the function that a
    // machine has compiled for itself uses its instructions.
    #[inline(always)]
    fn run_form<const N: usize>(
        self,
        machine: impl Machine,
        form: &Form<'_, N, impl Fn(f64) -> f64, impl Fn(f64) -> f64>,
    ) {
        let Batch { u, out, quantity, factor, .. } = self;
        if u.len() < BLOCK {
            for (u, out) in u.iter().zip(out) {
                *out = match (factor, quantity) {
                    (None, _) => (form.single)(*u),
                    (Some(law), Quantity::Kept) => law.epsilon(*u),
                    (Some(law), Quantity::Lost) => law.one_minus_epsilon(*u),
                    (Some(law), Quantity::U) => law.u(*u),
                };
            }
            return;
        }
        let forms = Forms { machine, quantity };
        let last = u.len() - BLOCK;
        let mut next = 0;
        while next < u.len() {
            let start = next.min(last);
            let arguments: &[f64; BLOCK] = u[start..].first_chunk().expect("a block");
            let values = out[start..].first_chunk_mut().expect("a block");
            match factor {
                None => forms.at(arguments, values, form),
                Some(law) => forms.at_velocities(law, arguments, values, form),
            }
            next += BLOCK;
        }
    }
}

/// The forms of one end of contact and one quantity, and where they hold.
struct Form<'a, const N: usize, Near, Beyond> {
    table: &'a [Piece; N],
    grid: &'a Grid,
    /// Below, `near` holds.
    near_end: f64,
    near: Near,
    /// From here on `beyond` holds, up to `beyond_end`.
    table_end: f64,
    beyond: Beyond,
    beyond_end: f64,
    /// For every argument.
    single: fn(f64) -> f64,
}

#[inline(always)]
fn zero_compression_form(
    quantity: Quantity,
) -> Form<'static, { zero_compression::ROWS }, impl Fn(f64) -> f64, impl Fn(f64) -> f64> {
    use zero_compression as form;
    let kept = quantity == Quantity::Kept;
    let beyond = |u| form::inverse_fifth_power(u, 0.0);
    Form {
        table: form::TABLE,
        grid: &form::GRID,
        near_end: if kept { form::NOTHING_LOST } else { form::NEAR_END },
        near: move |u| if kept { 1.0 } else { form::near(u) },
        table_end: form::TABLE_END,
        beyond: move |u| if kept { beyond(u) } else { 1.0 - beyond(u) },
        beyond_end: form::LARGE,
        single: if kept { form::epsilon } else { form::one_minus_epsilon },
    }
}

#[inline(always)]
fn zero_force_form(
    quantity: Quantity,
) -> Form<'static, { zero_force::ROWS }, impl Fn(f64) -> f64, impl Fn(f64) -> f64> {
    use zero_force as form;
    let kept = quantity == Quantity::Kept;
    Form {
        table: form::TABLE,
        grid: &form::GRID,
        near_end: form::NEAR_END,
        near: move |u| if kept { 1.0 - form::near(u) } else { form::near(u) },
        table_end: form::TABLE_END,
        beyond: |u| u,
        beyond_end: form::TABLE_END, // one by one from there on
        single: if kept { form::epsilon } else { form::one_minus_epsilon },
    }
}

#[derive(Clone, Copy)]
struct Forms<M> {
    machine: M,
    quantity: Quantity,
}

impl<M: Machine> Forms<M> {
    /// Evaluates at arguments `u`.
    #[inline(always)]
    fn at<const N: usize>(
        self,
        u: &[f64; BLOCK],
        out: &mut [f64; BLOCK],
        form: &Form<'_, N, impl Fn(f64) -> f64, impl Fn(f64) -> f64>,
    ) {
        let mut inside = true;
        for u in u {
            inside &= (form.near_end <= *u) & (*u < form.table_end);
        }
        let (near, beyond, odd) = if inside { (0, 0, false) } else { form.census(u) };
        if near == BLOCK as u64 && !odd {
            for i in 0..BLOCK {
                out[i] = (form.near)(u[i]);
            }
            return;
        }
        let (mut index, mut t) = (Block::zeros(), Block::zeros());
        for i in 0..BLOCK {
            let (piece, centre) = form.grid.locate(u[i]);
            (index[i], t[i]) = (piece as u64, u[i] - centre);
        }
        match self.quantity {
            Quantity::Kept => self.machine.values(form.table, &index, &t, out),
            Quantity::Lost | Quantity::U => self.machine.losses(form.table, &index, &t, out),
        }
        if inside {
            return;
        }
        if odd {
            for i in 0..BLOCK {
                if !(form.near_end..form.table_end).contains(&u[i]) {
                    out[i] = (form.single)(u[i]);
                }
            }
            return;
        }
        if near > FEW {
            for i in 0..BLOCK {
                let value = (form.near)(u[i]);
                out[i] = if u[i] < form.near_end { value } else { out[i] };
            }
        } else if near > 0 {
            for i in 0..BLOCK {
                if u[i] < form.near_end {
                    out[i] = (form.single)(u[i]);
                }
            }
        }
        if beyond > 0 {
            for i in 0..BLOCK {
                let value = (form.beyond)(u[i]);
                out[i] = if u[i] >= form.table_end { value } else { out[i] };
            }
        }
    }

    /// Evaluates at velocities: the fifth roots of the block, then as single calls do.
    #[inline(always)]
    fn at_velocities<const N: usize>(
        self,
        law: Restitution,
        velocities: &[f64; BLOCK],
        out: &mut [f64; BLOCK],
        form: &Form<'_, N, impl Fn(f64) -> f64, impl Fn(f64) -> f64>,
    ) {
        let (ordinary, roots) = self.roots(law.factor(), velocities);
        match self.quantity {
            Quantity::Kept if ordinary => self.of_roots(law, velocities, &roots, out, form),
            Quantity::Kept => {
                for i in 0..BLOCK {
                    out[i] = law.epsilon(velocities[i]);
                }
            }
            Quantity::Lost | Quantity::U => {
                let mut u = Block::<f64>::zeros();
                for i in 0..BLOCK {
                    u[i] = roots.at(i).distance(0.0);
                }
                if !ordinary {
                    for i in 0..BLOCK {
                        u[i] = law.u(velocities[i]);
                    }
                }
                if self.quantity == Quantity::U { *out = *u } else { self.at(&u, out, form) }
            }
        }
    }

    /// Takes the fifth roots, and says whether all products are ordinary numbers.
    #[inline(always)]
    fn roots(self, factor: f64, velocities: &[f64; BLOCK]) -> (bool, Roots) {
        let mut ordinary = true;
        let (mut index, mut y, mut scale) = (Block::zeros(), Block::zeros(), Block::zeros());
        for i in 0..BLOCK {
            let x = factor * velocities[i];
            ordinary &= is_ordinary(x);
            (index[i], y[i], scale[i]) = Root::place(x);
        }
        let (mut root, mut reciprocal) = (Block::zeros(), Block::zeros());
        self.machine.roots(&index, &mut root, &mut reciprocal);
        (ordinary, Roots { root, reciprocal, y, scale })
    }

    /// `epsilon` from roots that are known better than one f64.
    #[inline(always)]
    fn of_roots<const N: usize>(
        self,
        law: Restitution,
        velocities: &[f64; BLOCK],
        roots: &Roots,
        out: &mut [f64; BLOCK],
        form: &Form<'_, N, impl Fn(f64) -> f64, impl Fn(f64) -> f64>,
    ) {
        let near_end = if law.end() == End::ZeroForce { form.near_end } else { 0.0 };
        let (mut index, mut t, mut outside) = (Block::zeros(), Block::zeros(), false);
        for i in 0..BLOCK {
            let root = roots.at(i);
            let estimate = root.estimate();
            let (piece, centre) = form.grid.locate(estimate);
            outside |= !(near_end <= estimate && estimate < form.table_end);
            (index[i], t[i]) = (piece as u64, root.distance(centre));
        }
        self.machine.values(form.table, &index, &t, out);
        if outside {
            for i in 0..BLOCK {
                if !(near_end..form.table_end).contains(&roots.at(i).estimate()) {
                    out[i] = law.epsilon(velocities[i]);
                }
            }
        }
    }
}

/// Up to so many arguments near 0 are evaluated one by one rather than the form for all.
const FEW: u64 = 4;

impl<const N: usize, Near, Beyond> Form<'_, N, Near, Beyond> {
    /// Counts the arguments below and beyond the table, and says whether one has no form of its own.
    #[inline(always)]
    fn census(&self, u: &[f64; BLOCK]) -> (u64, u64, bool) {
        let (mut near, mut beyond, mut odd) = (0, 0, false);
        for u in *u {
            near += u64::from(u < self.near_end);
            beyond += u64::from(self.table_end <= u && u < self.beyond_end);
            odd |= !(u >= 0.0 && u < self.beyond_end);
        }
        (near, beyond, odd)
    }
}

/// What the fifth roots of a block are made of.
struct Roots {
    root: Block<f64>,
    reciprocal: Block<f64>,
    y: Block<f64>,
    scale: Block<f64>,
}

impl Roots {
    #[inline(always)]
    fn at(&self, i: usize) -> Root {
        Root::from_piece([self.root[i], self.reciprocal[i]], self.y[i], self.scale[i])
    }
}
