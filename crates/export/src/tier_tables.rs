//! The cheaper tiers of the crate `restitution`.

use crate::design::cheapest;
use crate::evaluator_tables::HEAD;
use crate::grid::Grid;
use crate::pieces::{Pieces, Shape};
use crate::{ExportError, InterpolatedCurve};
use restitution::End;
use rug::Float;
use std::fmt::Write as _;

/// Beyond, the tiers hand over to the full evaluator.
const FAR: f64 = 8.0;
const TIERS: [(&str, f64); 3] = [("1E3", 1e-3), ("1E6", 1e-6), ("1E9", 1e-9)];
/// Constants that a tier may have: 4 KiB.
const SIZE: u64 = 512;
/// By how much a tier ends above `epsilon`, relative to it: the full evaluator, which goes on, is within 2 ulp.
const ABOVE: f64 = 4.0 * f64::EPSILON;

/// Returns `tables/tiers.rs`.
///
/// # Errors
///
/// [`ExportError::Tolerance`] if no table keeps a tier's tolerance.
pub fn tier_tables(references: [&InterpolatedCurve; 2]) -> Result<String, ExportError> {
    let mut text =
        format!("//! Cheaper tiers.\n{HEAD}\nuse crate::End;\nuse crate::evaluator::tier::Tier;\n");
    for reference in references {
        for (name, tolerance) in TIERS {
            text.push_str(&tier(reference.end(), name, tolerance, &fit(reference, tolerance)?));
        }
    }
    Ok(text)
}

fn fit(reference: &InterpolatedCurve, tolerance: f64) -> Result<Pieces, ExportError> {
    let last = reference.epsilon(&Float::with_val(64, FAR)).to_f64();
    let shape = Shape {
        grid: Grid { shift: 1.0, bits: 0 },
        degree: 1,
        range: (0.0, FAR),
        law: None,
        last_value: Some(last * (1.0 + ABOVE)),
        tolerance: 0.98 * tolerance,
    };
    cheapest(reference, &shape, &[SIZE], tolerance)
}

fn tier(end: End, name: &str, tolerance: f64, pieces: &Pieces) -> String {
    let (title, variant) = match end {
        End::ZeroCompression => ("ZERO_COMPRESSION", "ZeroCompression"),
        End::ZeroForce => ("ZERO_FORCE", "ZeroForce"),
    };
    let (rows, width, Grid { shift, bits }) = (pieces.rows.len(), pieces.rows[0].len(), pieces.grid);
    let mut text = format!(
        "\n/// To {tolerance:e}; contact ends at {}.\n#[rustfmt::skip]\npub static {title}_{name}: Tier<{rows}, {width}> = Tier::new(End::{variant}, {tolerance:e}, {FAR:?}, {shift:?}, {bits}, [\n",
        title.to_lowercase().replace('_', " "),
    );
    for row in &pieces.rows {
        let _ = writeln!(text, "    {row:?},");
    }
    text + "]);\n"
}
