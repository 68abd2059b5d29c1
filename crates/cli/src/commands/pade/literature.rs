//! Published constants beside the regenerated ones.

use crate::{Cell, CliError, Table};
use num_rational::BigRational;
use restitution_approximate::{Constant, Expansion, Request, Variable, constants, judge};
use restitution_direct::End;
use restitution_law::ForceLaw;
use restitution_pade::{PadeType, RationalFunction, table_one, with_precision};
use restitution_real::{Ball, Balls, Rationals};

/// Table I of \[RPBS1999\]: d_1, then d_2 to d_5.
const TABLE_ONE: [&[&str]; 2] = [&["1", "2.5839"], &["1", "3.5839", "2.9839", "1.1487", "0.3265"]];
/// a_3 and a_4 as printed in (A35) and (A36), in millionths.
const PRINTED_A3: i64 = 315_119;
const PRINTED_A4: i64 = 161_167;
/// \[MP2011\], in v* = sqrt(u).
const ONE_FOUR: [&[&str]; 2] = [&["1", "0.501086"], &["1", "0.501086", "1.15345", "0.577977", "0.532178"]];
const THREE_SIX: [&[&str]; 2] = [
    &["1", "1.07232", "0.574198", "0.141552"],
    &["1", "1.07232", "1.72765", "1.37842", "1.19449", "0.467273", "0.235585"],
];

/// Every published approximant, as printed and regenerated to `digits` digits.
pub fn table(digits: usize) -> Result<Table, CliError> {
    let mut table = Table::new(&["work", "approximant", "part", "k", "printed", "value"])
        .titled("Published Padé constants and what they should be");
    let spheres = ForceLaw::viscoelastic_spheres();
    let in_s = Expansion::new(&spheres, End::ZeroCompression, Some(Variable::S))?;
    let in_root = Expansion::new(&spheres, End::ZeroForce, Some(Variable::SqrtU))?;
    let nothing: [&[&str]; 2] = [&[], &[]];
    let paper = "[RPBS1999] Table I";
    push(&mut table, paper, "[1/4] in s, printed a_3, a_4, a_5 = 0", TABLE_ONE, as_printed(digits)?);
    push(&mut table, paper, "[1/4] in s, exact a_3, a_4, a_5 = 0", nothing, without_a5(&in_s, digits)?);
    push(&mut table, paper, "[1/4] in s", nothing, regenerated(&in_s, 1, 4, digits)?);
    let codes = "[MP2011]";
    push(&mut table, codes, "[1/4] in sqrt(u), zero force", ONE_FOUR, regenerated(&in_root, 1, 4, digits)?);
    push(&mut table, codes, "[3/6] in sqrt(u), zero force", THREE_SIX, regenerated(&in_root, 3, 6, digits)?);
    table.note("Table I is the [1/4] approximant with a_5 set to 0, fed with a_3 = 0.315119 and a_4 = 0.161167, which are wrong: right are a_3 = 0.340729..., a_4 = 0.197020...");
    table.note("the six printed digits of a_3 and a_4 leave the fourth decimal of d_1, d_2 and d_3 open: Table I as printed lies within what they allow");
    table.note("with every coefficient right, a_5 included, the [1/4] approximant in s has a zero near s = 3.31 and is negative beyond");
    Ok(table)
}

fn push(table: &mut Table, work: &str, what: &str, printed: [&[&str]; 2], rows: Vec<Constant>) {
    for (part, k, value) in rows {
        let printed = printed[usize::from(part == "den")].get(k).map_or(Cell::Empty, Cell::digits);
        table.push(vec![work.into(), what.into(), part.into(), k.into(), printed, Cell::Digits(value)]);
    }
}

/// Table I from the coefficients as printed: exact fractions, shown rounded.
fn as_printed(digits: usize) -> Result<Vec<Constant>, CliError> {
    let millionths = |n: i64| BigRational::new(n.into(), 1_000_000.into());
    let three_fifths = BigRational::new(3.into(), 5.into());
    let closed = table_one(&Rationals, &three_fifths, &millionths(PRINTED_A3), &millionths(PRINTED_A4))?;
    let bits = u32::try_from(digits.saturating_mul(4)).unwrap_or(u32::MAX / 8).saturating_add(64);
    let enclose = |p: &[BigRational]| p.iter().map(|c| Ball::from_rational(c, bits)).collect();
    let enclosed = RationalFunction::new(&Balls::new(bits), enclose(closed.num()), enclose(closed.den()))?;
    Ok(constants(&enclosed, digits)?)
}

/// Table I with the right a_3 and a_4, and a_5 = 0 as before.
fn without_a5(in_s: &Expansion, digits: usize) -> Result<Vec<Constant>, CliError> {
    let first = u32::try_from(digits.saturating_mul(4)).unwrap_or(u32::MAX / 64).saturating_add(64);
    with_precision(first, first.saturating_mul(8), |bits| {
        let series = in_s.coefficients(5, bits)?;
        let (a3, a4) = (-series[3].clone(), &series[4]);
        let three_fifths = Ball::from_ratio(3, 5, bits);
        Ok(table_one(&Balls::new(bits), &three_fifths, &a3, a4).and_then(|closed| constants(&closed, digits)))
    })
}

fn regenerated(expansion: &Expansion, l: usize, m: usize, digits: usize) -> Result<Vec<Constant>, CliError> {
    let number = |n: i64| BigRational::from_integer(n.into());
    let asked = PadeType::new(l, m);
    let range = (number(0), number(1));
    let request = Request { asked, at_infinity: 0, digits, range, level: number(1) };
    Ok(constants(judge(expansion, &request)?.approximant.function(), digits)?)
}
