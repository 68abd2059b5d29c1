//! The f64 functions of `restitution` over random bit patterns, breakpoints and their neighbours.

mod arguments;
mod batches;
mod certified;
mod curve;
mod inverse;
mod limits;
mod materials;
mod tiers;
mod velocity;

use crate::random::Source;
use crate::{Part, Size, Tally};
use rand::RngExt;
use restitution::End;

/// Both ends of contact.
pub(crate) const ENDS: [End; 2] = [End::ZeroCompression, End::ZeroForce];

/// Arguments of one case.
const ARGUMENTS: usize = 4096;

/// One case in so many is compared with certified values: they cost a hundred times all other checks together.
const CERTIFIED: u32 = 8;

/// `epsilon`, `one_minus_epsilon`, their batches and inverse, velocities, tiers, materials and codes.
#[derive(Debug)]
pub struct F64Functions;

impl Part for F64Functions {
    fn name(&self) -> &'static str {
        "f64"
    }

    fn about(&self) -> &'static str {
        "f64 functions at 4096 arguments: bit patterns, breakpoints, neighbours; batches, order, range, NaN, ulp"
    }

    fn cases(&self, size: Size) -> u64 {
        match size {
            Size::Slice => 24,
            Size::Minutes => 2_000,
            Size::Full => 100_000_000_u64.div_ceil(ARGUMENTS as u64),
        }
    }

    fn attack(&self, random: &mut Source, tally: &mut Tally) {
        let arguments = arguments::mixture(random, ARGUMENTS);
        tally.count("arguments", ARGUMENTS as u64);
        let against_certified = random.random_range(0..CERTIFIED) == 0;
        for end in ENDS {
            curve::attack(&arguments, end, tally);
            batches::attack(&arguments, end, random, tally);
            inverse::attack(random, end, ARGUMENTS / 8, tally);
            velocity::attack(&arguments, end, random, tally);
            if against_certified {
                certified::attack(random, end, tally);
            }
        }
        tiers::attack(&arguments, random, tally);
        materials::attack(random, tally);
    }
}
