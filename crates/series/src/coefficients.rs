use crate::expansion::{Expansion, damping_order_for, expand};
use crate::{SeriesError, TailBound};
use num_traits::One;
use restitution_law::ForceLaw;
use restitution_real::{Ball, RealError};

/// A family of expansion coefficients.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// `C_k` of `eps = 1 + C_1 u + C_2 u^2 + ...` (A30).
    Restitution,
    /// `a_k = C_k/C_1^k` of `eps = 1 - a_1 s + a_2 s^2 - ...`, `s = -C_1 u = (g/g*)^(1/5)` (A33)-(A36).
    ScaledRestitution,
    /// `y_k` of the maximal compression `x_max = y_0 + y_1 u + ...` (A23).
    Compression,
}

/// Bits that ball arithmetic loses for each order in the damping; see `docs/stability.md`.
const BITS_PER_ORDER: usize = 5;
/// Working precision above which no further attempt is made.
const MAX_BITS: u32 = 4_000_000;

/// Returns the coefficients of order `0 ..= order`, each enclosed so narrowly that `digits` decimals are proved.
///
/// The working precision is raised until [`Ball::to_digits`] shows the digits asked for.
///
/// # Errors
///
/// [`SeriesError::Real`] if that takes more than the largest working precision, and what the expansion
/// of the law says where there is none.
///
/// # Examples
///
/// ```
/// use restitution_law::ForceLaw;
/// use restitution_series::{Quantity, coefficients};
///
/// let spheres = ForceLaw::viscoelastic_spheres();
/// let c = coefficients(Quantity::Restitution, &spheres, 3, 12)?;
/// assert_eq!(c[3].to_digits(12).as_deref(), Some("-0.522882568088"));
/// # Ok::<(), restitution_series::SeriesError>(())
/// ```
pub fn coefficients(
    quantity: Quantity,
    law: &ForceLaw,
    order: usize,
    digits: usize,
) -> Result<Vec<Ball>, SeriesError> {
    coefficients_watched(quantity, law, order, digits, &mut |_| ())
}

/// As [`coefficients`], telling `watch` each order in the damping as it is done.
///
/// # Errors
///
/// As [`coefficients`].
pub fn coefficients_watched(
    quantity: Quantity,
    law: &ForceLaw,
    order: usize,
    digits: usize,
    watch: &mut dyn FnMut(usize),
) -> Result<Vec<Ball>, SeriesError> {
    let wanted = bits_of(digits) + 8;
    let mut spare = BITS_PER_ORDER * order + 40;
    let tail = TailBound::find(law, damping_order_for(quantity, order))?;
    loop {
        let bits = u32::try_from(wanted + spare).ok().filter(|&bits| bits <= MAX_BITS);
        let exhausted = RealError::PrecisionExhausted { digits, reached_bits: MAX_BITS };
        let bits = bits.ok_or(SeriesError::Real(exhausted))?;
        // The tail is not magnified on its way to the sums, so it may take up half of what is to spare.
        let tail_bits = bits - u32::try_from(spare / 2).unwrap_or(0);
        let expansion = expand(law, order, bits, (&tail, tail_bits), watch)?;
        let values = expansion.select(quantity);
        let missing = values.iter().filter(|v| v.to_digits(digits).is_none());
        let Some(missing) = missing.map(|v| shortfall(v, wanted)).max() else { return Ok(values) };
        eprintln!("bits {bits} missing {missing}");
        spare += missing + spare / 8 + 16;
    }
}

impl Expansion {
    fn select(self, quantity: Quantity) -> Vec<Ball> {
        match quantity {
            Quantity::Compression => self.compression,
            Quantity::Restitution => self.restitution,
            Quantity::ScaledRestitution => scaled(&self.restitution),
        }
    }
}

/// `a_k = C_k/C_1^k`.
fn scaled(restitution: &[Ball]) -> Vec<Ball> {
    let first = restitution.get(1).cloned().unwrap_or_else(Ball::one);
    let mut power = Ball::one();
    let divide = |(k, c): (usize, &Ball)| match k {
        0 => c.clone(),
        1 => Ball::one(),
        _ => {
            if k == 2 {
                power = first.clone();
            }
            power *= &first;
            c / &power
        }
    };
    restitution.iter().enumerate().map(divide).collect()
}

/// Bits that hold `digits` decimals: `log2(10) < 3.322`.
pub(crate) fn bits_of(digits: usize) -> usize {
    digits.saturating_mul(3322) / 1000 + 1
}

/// Bits by which the enclosure is too wide.
fn shortfall(value: &Ball, wanted: usize) -> usize {
    let wanted = i64::try_from(wanted).unwrap_or(i64::MAX);
    let known = value.relative_bits().unwrap_or(wanted).max(-wanted);
    usize::try_from(wanted - known).unwrap_or(0)
}
