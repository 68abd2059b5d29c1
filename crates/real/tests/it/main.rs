//! Containment: every operation on balls against results of more than twice the precision.

mod arithmetic;
mod balls;
mod digits;
mod exponents;
mod fields;
mod functions;
mod magnitudes;
mod operands;
