//! What makes a row of the table fall, from 1, in floating point too.
//!
//! A row is evaluated as `fl(c_0 + p)`, where `p` is `P(s) = c_1 s + … + c_d s^d` with rounding errors of at most
//!
//! ```text
//! E(s) = 2^-53 sum (2 k + 1) |c_k| s^k
//! ```
//!
//! (\[Higham2002\], sec. 5.1; 2 k + 1 roundings a term allow for any order of operations). The addition is
//! monotone, so it is enough that `p` is: for neighbouring `s`, which are `2^-rest` apart, by all coefficients being
//! positive (sums and products of positive numbers are monotone, whatever their order), or by
//! `2^-rest min P' >= 2 E(1)`. At the ends of a piece `c_0 <= p + c_0 <= left` is checked with exact numbers.

use crate::chebyshev::PREC;
use rug::Float;
use rug::float::Round;

const ROUNDING: f64 = f64::EPSILON / 2.0;
/// What covers the second order of `E`.
const SECOND_ORDER: f64 = 1.0 + 1e-12;

/// Why a polynomial cannot be used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Flaw {
    /// It would start above the one before, or fall to nothing.
    Room,
    /// It does not give 1 at 0.
    NotOne,
    /// It is not proved to fall.
    Rises,
}

/// `E(1)`, rounded up.
fn errors(row: &[f64]) -> f64 {
    let sum: f64 = row.iter().enumerate().skip(1).map(|(k, c)| (2 * k + 1) as f64 * c.abs()).sum();
    ROUNDING * sum * SECOND_ORDER
}

/// `P(s)` exactly but for 200 bits.
fn rise(row: &[f64], s: &Float) -> Float {
    let sum = row.iter().skip(1).rev().fold(Float::new(PREC), |sum, c| sum * s + *c);
    sum * s
}

/// Returns the `c_1` with which the row starts at `left`, but for its errors, and not above.
///
/// # Errors
///
/// [`Flaw::Room`] if that is not a positive number.
pub(crate) fn room_below(left: f64, row: &[f64]) -> Result<f64, Flaw> {
    let mut others = row.to_vec();
    others[1] = 0.0;
    let room = Float::with_val(PREC, left) - row[0] - rise(&others, &Float::with_val(PREC, 1));
    // c_1 + errors(c_1, …) <= room, with c_1 <= room to bound its own
    others[1] = room.to_f64().abs();
    let c_1 = rounded_down(&(room - errors(&others)));
    if c_1 > 0.0 && row[0] > 0.0 { Ok(c_1) } else { Err(Flaw::Room) }
}

/// Checks that the row gives 1 at its start: within 2^-54 below, which rounds to it.
///
/// # Errors
///
/// [`Flaw::NotOne`].
pub(crate) fn starts_at_one(row: &[f64]) -> Result<(), Flaw> {
    let below = 1 - rise(row, &Float::with_val(PREC, 1)) - row[0] + errors(row);
    if below <= ROUNDING / 2.0 { Ok(()) } else { Err(Flaw::NotOne) }
}

/// Returns what the row gives at the distance `s` or more, at least.
pub(crate) fn least(row: &[f64], s: &Float) -> f64 {
    if s.is_zero() { row[0] } else { rounded_down(&(rise(row, s) + row[0] - errors(row))).max(row[0]) }
}

/// Checks that the evaluated row does not rise between neighbouring arguments.
///
/// # Errors
///
/// [`Flaw::Rises`] if that is not proved.
pub(crate) fn falls(row: &[f64], rest: u32) -> Result<(), Flaw> {
    if row.iter().all(|c| *c >= 0.0) {
        return Ok(());
    }
    let turned = |(k, c): (usize, &f64)| k as f64 * c.min(0.0);
    let least_slope = (row[1] + row.iter().enumerate().skip(2).map(turned).sum::<f64>()) / SECOND_ORDER;
    let step = 2.0_f64.powi(-(rest as i32));
    if least_slope * step >= 2.0 * errors(row) { Ok(()) } else { Err(Flaw::Rises) }
}

/// The nearest f64 that is not larger.
fn rounded_down(x: &Float) -> f64 {
    x.to_f64_round(Round::Down)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rise evaluated by Horner's scheme, with fused multiply-add, and by powers.
    fn evaluations(row: &[f64], s: f64) -> [f64; 3] {
        let terms = || row.iter().skip(1).rev();
        let horner = terms().fold(0.0, |sum, c| sum * s + c) * s;
        let fused = terms().fold(0.0_f64, |sum, c| sum.mul_add(s, *c));
        let powers = row.iter().enumerate().skip(1).map(|(k, c)| c * s.powi(k as i32)).sum::<f64>();
        [horner + row[0], fused.mul_add(s, row[0]), powers + row[0]]
    }

    /// Whether any evaluation rises at neighbouring arguments, of which there are `2^rest`.
    fn is_seen_to_rise(row: &[f64], rest: u32) -> bool {
        let step = 2.0_f64.powi(-(rest as i32));
        let places = 1_u64 << rest;
        (0..40_u64).any(|i| {
            let start = i * (places / 41) + 1;
            (start..start + 200).any(|n| {
                let (far, near) =
                    (evaluations(row, n as f64 * step), evaluations(row, (n + 1) as f64 * step));
                far.iter().zip(&near).any(|(far, near)| far > near)
            })
        })
    }

    #[test]
    fn what_is_accepted_is_not_seen_to_rise() {
        let accepted = [vec![0.5, 0.1, 0.02, 1e-3], vec![0.5, 0.1, -0.02, 1e-3], vec![1e-3, 1e-4, -2e-5]];
        for row in accepted {
            assert_eq!(falls(&row, 46), Ok(()), "{row:?}");
            assert!(!is_seen_to_rise(&row, 46), "{row:?}");
        }
        for row in [vec![0.5, 0.1, -0.06], vec![0.5, -0.1, 0.2], vec![0.0, 0.1, -1e-6]] {
            assert_eq!(falls(&row, 52), Err(Flaw::Rises), "{row:?}");
        }
        assert!(is_seen_to_rise(&[0.0, 0.1, -0.049], 52), "the argument is fine enough to tell");
    }

    #[test]
    fn a_row_starts_below_the_one_before_and_at_one() {
        let row = [0.9, 0.0, 0.002];
        let c_1 = room_below(1.0, &row).unwrap();
        let row = [0.9, c_1, 0.002];
        let start = rise(&row, &Float::with_val(PREC, 1)) + row[0];
        assert!(start <= 1.0 - errors(&row) && start >= 1.0 - 2.0 * errors(&row) - 1e-17);
        assert_eq!(starts_at_one(&row), Err(Flaw::NotOne), "too steep: its rounding reaches below 1");
        let gentle = [0.99, room_below(1.0, &[0.99, 0.0, 1e-4]).unwrap(), 1e-4];
        assert_eq!(starts_at_one(&gentle), Ok(()));
        assert!(evaluations(&gentle, 1.0).iter().all(|value| *value == 1.0));
        assert_eq!(starts_at_one(&[0.99, gentle[1] - 1e-15, 1e-4]), Err(Flaw::NotOne));
        assert_eq!(room_below(0.9, &row), Err(Flaw::Room));
        let quarter = Float::with_val(PREC, 0.25);
        assert!(evaluations(&gentle, 0.25).iter().all(|value| *value >= least(&gentle, &quarter)));
    }
}
