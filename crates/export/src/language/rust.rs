//! Rust.

use super::{Language, Rows};

pub(super) static LANGUAGE: Language = Language {
    name: "rust",
    aliases: &["rs"],
    title: "Rust, 2018 and later, a module",
    file: "NAME.rs",
    comment: "// ",
    rows: Rows { before: "        [", between: ", ", after: "],\n", suffix: "" },
    reserved: &[],
    template: TEMPLATE,
};

const TEMPLATE: &str = r#"{HEAD}
// Functions:
//     {NAME}_epsilon(u)               the coefficient of restitution
//     {NAME}_loss(u)                  1 - epsilon, with all its digits where u is small
//     {NAME}_slope(u)                 d epsilon/d u
//     {NAME}_epsilon_slice(u, out)    many at once
//     {NAME}_u_of_velocity(velocity, g_star)    u of the size of a velocity; both in the same unit
//     {NAME}_epsilon_of_velocity(velocity, g_star)
?VELOCITY //     {NAME}_u_at_m_per_s(velocity)   the same for the g* above
?VELOCITY //     {NAME}_epsilon_at_m_per_s(velocity)
//
// Self-check: rustc --test {FILE} -o check && ./check, or `cargo test` with this file as a module.
//
// Written by: restitution export --lang {LANGUAGE} {OPTIONS} --name {NAME}

/// The polynomial of the piece of `u`, in the distance to its end as a part of its width, constant first; that distance,
/// the exponent of the width, and how many periods of the law at infinity lie between. `None` outside the range.
#[inline]
#[allow(non_snake_case)]
fn {NAME}_locate(u: f64) -> Option<(usize, &'static [f64; {WIDTH}], f64, i32, i32)> {
    #[rustfmt::skip]
    #[allow(clippy::all)]
    static TABLE: [[f64; {WIDTH}]; {ROWS}] = [
{TABLE}
    ];
    if !(u >= {LOW} && u.to_bits() <= {HIGH_BITS} || u == 0.0 && {LOW_BITS}_u64 == 0) {
        return None;
    }
?LAW     let (bits, row, periods) = if u.to_bits() >= {LAW_BITS} && u > 0.0 {
?LAW         let periods = ((u.to_bits() - {LAW_BITS}) >> 52) / {OCTAVES};
?LAW         let bits = u.to_bits() - ((periods * {OCTAVES}) << 52);
?LAW         (bits, (bits >> {REST}) - {LAW_FIRST} + {LAW_ROW}, periods as i32)
?LAW     } else {
?LAW         let bits = (u + {SHIFT}).to_bits();
?LAW         (bits, (bits >> {REST}) - {FIRST}, 0)
?LAW     };
!LAW     let bits = (u + {SHIFT}).to_bits();
!LAW     let (row, periods) = ((bits >> {REST}) - {FIRST}, 0);
    let row = (row as usize).min({LAST_ROW});
    let exponent = (bits >> 52) as i32 - {BITS} - 1023;
    let distance = 2.0 - f64::from_bits(((bits << {BITS}) & 0x000f_ffff_ffff_ffff) | 0x3ff0_0000_0000_0000);
    Some((row, &TABLE[row], distance, exponent, periods))
}

/// What epsilon has above its value at the end of the piece.
#[inline]
#[allow(non_snake_case)]
fn {NAME}_rise(c: &[f64; {WIDTH}], distance: f64) -> f64 {
    c[1..].iter().rev().fold(0.0, |rise, c| (rise + c) * distance)
}

/// `x` times a power of two.
#[inline]
#[allow(dead_code, non_snake_case)]
fn {NAME}_scaled(mut x: f64, mut exponent: i32) -> f64 {
    while exponent < -1000 && x != 0.0 {
        x *= f64::from_bits(23 << 52);
        exponent += 1000;
    }
    if x == 0.0 { x } else { x * f64::from_bits(((exponent + 1023) as u64) << 52) }
}

/// Returns the coefficient of restitution at `u`; NaN outside the range.
#[inline]
#[allow(non_snake_case)]
pub fn {NAME}_epsilon(u: f64) -> f64 {
    match {NAME}_locate(u) {
?LAW         Some((_, c, distance, _, periods)) => {NAME}_scaled(c[0] + {NAME}_rise(c, distance), -5 * periods),
!LAW         Some((_, c, distance, ..)) => c[0] + {NAME}_rise(c, distance),
        None => f64::NAN,
    }
}

/// Returns `1 - epsilon` at `u`; NaN outside the range.
#[inline]
#[allow(dead_code, non_snake_case)]
pub fn {NAME}_loss(u: f64) -> f64 {
?NEAR     #[rustfmt::skip]
?NEAR     #[allow(clippy::all)]
?NEAR     static NEAR: [f64; {NEAR_COUNT}] = [{NEAR}];
    match {NAME}_locate(u) {
?NEAR !ROOT         Some((row, ..)) if row < {NEAR_ROW} => u * NEAR.iter().rev().fold(0.0, |sum, c| sum * u + c),
?NEAR ?ROOT         Some((row, ..)) if row < {NEAR_ROW} => u * NEAR.iter().rev().fold(0.0, |sum, c| sum * u.sqrt() + c),
?LAW         Some((.., periods)) if periods > 0 => 1.0 - {NAME}_epsilon(u),
        Some((_, c, distance, ..)) => (1.0 - c[0]) - {NAME}_rise(c, distance),
        None => f64::NAN,
    }
}

/// Returns `d epsilon/d u` at `u`; NaN outside the range.
#[inline]
#[allow(dead_code, non_snake_case)]
pub fn {NAME}_slope(u: f64) -> f64 {
    match {NAME}_locate(u) {
        Some((_, c, distance, exponent, periods)) => {
            let sum = (1..{WIDTH}).rev().fold(0.0, |sum, k| sum * distance + k as f64 * c[k]);
            -{NAME}_scaled(sum, -exponent - {FALL} * periods)
        }
        None => f64::NAN,
    }
}

/// Writes the coefficient of restitution at each `u` to `out`, as far as the shorter reaches.
#[allow(dead_code, non_snake_case)]
pub fn {NAME}_epsilon_slice(u: &[f64], out: &mut [f64]) {
    for (u, out) in u.iter().zip(out) {
        *out = {NAME}_epsilon(*u);
    }
}

/// Returns `u` of the size of a velocity; `g_star` is the characteristic velocity, in the same unit.
#[inline]
#[allow(dead_code, non_snake_case)]
pub fn {NAME}_u_of_velocity(velocity: f64, g_star: f64) -> f64 {
    {U_AT_G_STAR} * (velocity.abs() / g_star).powf(0.2)
}

/// Returns the coefficient of restitution of the size of a velocity.
#[inline]
#[allow(dead_code, non_snake_case)]
pub fn {NAME}_epsilon_of_velocity(velocity: f64, g_star: f64) -> f64 {
    {NAME}_epsilon({NAME}_u_of_velocity(velocity, g_star))
}
?VELOCITY 
?VELOCITY /// Returns `u` of the size of a velocity in m/s, for `g* = {G_STAR} m/s`.
?VELOCITY #[inline]
?VELOCITY #[allow(dead_code, non_snake_case)]
?VELOCITY pub fn {NAME}_u_at_m_per_s(velocity: f64) -> f64 {
?VELOCITY     {NAME}_u_of_velocity(velocity, {G_STAR})
?VELOCITY }
?VELOCITY 
?VELOCITY /// Returns the coefficient of restitution of the size of a velocity in m/s.
?VELOCITY #[inline]
?VELOCITY #[allow(dead_code, non_snake_case)]
?VELOCITY pub fn {NAME}_epsilon_at_m_per_s(velocity: f64) -> f64 {
?VELOCITY     {NAME}_epsilon_of_velocity(velocity, {G_STAR})
?VELOCITY }

#[cfg(test)]
#[allow(non_snake_case)]
mod {NAME}_tests {
    #[test]
    fn certified_values_are_met() {
        #[rustfmt::skip]
        let certified: [[f64; 3]; {CHECKS}] = [ // u, epsilon, 1 - epsilon
{POINTS}
        ];
        for [u, epsilon, loss] in certified.iter().copied() {
            let error = (super::{NAME}_epsilon(u) / epsilon - 1.0).abs();
            assert!(error <= {TOLERANCE}, "u = {:e}: relative error {:e}", u, error);
            let error = (super::{NAME}_loss(u) - loss).abs();
            assert!(error <= {LOSS_BOUND} * loss, "u = {:e}: error {:e} of the loss", u, error);
        }
    }
}
"#;
