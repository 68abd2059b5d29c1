use crate::PadeError;
use restitution_real::{Field, OrderedField, ZeroTest};

/// Returns the null vector with the fewest leading coordinates, its last coordinate being 1.
///
/// `rows` holds fewer equations than unknowns, so there is one. Gauss's elimination goes through the
/// columns in order; the first column that depends on those before it ends the vector. Hence for a
/// polynomial `Q` given by its coefficients the answer is the one of least degree.
///
/// Exact for rationals. For balls a column is independent if some entry is certainly not zero, and
/// the one largest in magnitude is the pivot.
/// Cost: `n^3/3` multiplications for `n` rows.
///
/// # Errors
///
/// [`PadeError::Undecided`] if a column has no entry that is certainly nonzero but one that may be.
pub(crate) fn null_vector<F: OrderedField>(
    field: &F,
    mut rows: Vec<Vec<F::Number>>,
    columns: usize,
) -> Result<Vec<F::Number>, PadeError> {
    for column in 0..columns {
        let Some(pivot) = pivot(field, &rows, column)? else {
            return Ok(back_substitute(field, &rows, column));
        };
        rows.swap(column, pivot);
        let (done, below) = rows.split_at_mut(column + 1);
        for row in below {
            eliminate(field, row, &done[column], column);
        }
    }
    Ok(Vec::new())
}

/// The best row, among those not used yet, to eliminate `column` with; `None` if all are zero there.
fn pivot<F: OrderedField>(
    field: &F,
    rows: &[Vec<F::Number>],
    column: usize,
) -> Result<Option<usize>, PadeError> {
    let open = rows.iter().enumerate().skip(column);
    let nonzero = open.clone().filter(|(_, row)| field.zero_test(&row[column]) == ZeroTest::NonZero);
    if let Some((index, _)) = nonzero.max_by_key(|(_, row)| field.pivot_rank(&row[column])) {
        return Ok(Some(index));
    }
    if open.clone().any(|(_, row)| field.zero_test(&row[column]) == ZeroTest::Undecided) {
        return Err(PadeError::Undecided { what: "whether a pivot of the linear system is zero" });
    }
    Ok(None)
}

/// Subtracts the multiple of `by` that clears `column`; entries before it are zero already.
fn eliminate<F: Field>(field: &F, row: &mut [F::Number], by: &[F::Number], column: usize) {
    if field.zero_test(&row[column]) == ZeroTest::Zero {
        return;
    }
    let factor = field.div(&row[column], &by[column]);
    row[column] = field.zero();
    for (entry, above) in row[column + 1..].iter_mut().zip(&by[column + 1..]) {
        *entry = field.sub(entry, &field.mul(&factor, above));
    }
}

/// Solves the upper triangle above the dependent `column`.
fn back_substitute<F: Field>(field: &F, rows: &[Vec<F::Number>], column: usize) -> Vec<F::Number> {
    let mut vector = vec![field.one(); column + 1];
    for r in (0..column).rev() {
        let terms = rows[r][r + 1..=column].iter().zip(&vector[r + 1..]);
        let sum = terms.fold(field.zero(), |sum, (entry, v)| field.sub(&sum, &field.mul(entry, v)));
        vector[r] = field.div(&sum, &rows[r][r]);
    }
    vector
}
