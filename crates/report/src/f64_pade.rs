//! Padé approximants in f64 as usually computed, to see what that loses.

/// Numerator and denominator, constant terms first.
pub type Quotient = (Vec<f64>, Vec<f64>);

/// Returns the `[l/m]` approximant of a series with `l + m + 1` coefficients or more.
pub fn approximant(series: &[f64], l: usize, m: usize) -> Quotient {
    let at = |k: usize, j: usize| k.checked_sub(j).map_or(0.0, |i| series[i]);
    let rows = (l + 1..=l + m).map(|k| (1..=m).map(|j| at(k, j)).chain([-at(k, 0)]).collect()).collect();
    let den = std::iter::once(1.0).chain(solved(rows)).collect::<Vec<_>>();
    let num = (0..=l).map(|k| den.iter().enumerate().map(|(j, q)| q * at(k, j)).sum()).collect();
    (num, den)
}

/// The value of a quotient.
pub fn value((num, den): &Quotient, x: f64) -> f64 {
    let horner = |c: &[f64]| c.iter().rev().fold(0.0, |sum, c| sum * x + c);
    horner(num) / horner(den)
}

/// Solves a linear system given with its right side as last column, by elimination with partial pivoting.
fn solved(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let n = rows.len();
    for column in 0..n {
        let pivot = (column..n).max_by(|a, b| rows[*a][column].abs().total_cmp(&rows[*b][column].abs()));
        rows.swap(column, pivot.unwrap_or(column));
        let top = rows[column].clone();
        for row in &mut rows[column + 1..] {
            let factor = row[column] / top[column];
            row.iter_mut().zip(&top).skip(column).for_each(|(entry, t)| *entry -= factor * t);
        }
    }
    let mut solution = vec![0.0; n];
    for i in (0..n).rev() {
        let known = (i + 1..n).map(|j| rows[i][j] * solution[j]).sum::<f64>();
        solution[i] = (rows[i][n] - known) / rows[i][i];
    }
    solution
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exp_has_its_known_approximant() {
        let (num, den) = approximant(&[1.0, 1.0, 0.5, 1.0 / 6.0, 1.0 / 24.0], 2, 2);
        let expected = [(num, [1.0, 0.5, 1.0 / 12.0]), (den, [1.0, -0.5, 1.0 / 12.0])];
        for (found, exact) in expected {
            assert!(found.iter().zip(exact).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?}");
        }
    }
}
