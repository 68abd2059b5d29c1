//! `A Q - P = O(x^(L+M+1))` for whole tables, against a second algorithm that shares no code.

use crate::pade_series::{approximate_theory, cosine, exponential, ints, lacunary, quotient, ratio};
use num_rational::BigRational;
use num_traits::{One, Zero};
use restitution_law::ForceLaw;
use restitution_pade::{Approximant, Contact, PadeError, PadeType, approximant};
use restitution_real::Rationals;
use restitution_series::DelayedRecovery;

type Poly = Vec<BigRational>;

/// The side of the tables: degrees 0 to 12.
const SIDE: usize = 13;
/// One coefficient more than `[12/12]` takes, so that the order of contact can exceed what is asked.
const KNOWN: usize = 2 * SIDE;
/// The entries with up to this many conditions are compared with Euclid's algorithm, which is slow.
const CROSS_CHECKED: usize = 17;

fn product(a: &[BigRational], b: &[BigRational]) -> Poly {
    let mut out = vec![BigRational::zero(); (a.len() + b.len()).saturating_sub(1)];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            out[i + j] += x * y;
        }
    }
    out
}

fn subtract(a: &[BigRational], b: &[BigRational]) -> Poly {
    let at = |p: &[BigRational], k: usize| p.get(k).cloned().unwrap_or_else(BigRational::zero);
    let mut out: Poly = (0..a.len().max(b.len())).map(|k| at(a, k) - at(b, k)).collect();
    while out.last().is_some_and(Zero::is_zero) {
        out.pop();
    }
    out
}

fn remainder(a: &[BigRational], b: &[BigRational]) -> (Poly, Poly) {
    let (mut rest, mut quotient) = (subtract(a, &[]), vec![BigRational::zero(); a.len()]);
    while rest.len() >= b.len() && !rest.is_empty() {
        let shift = rest.len() - b.len();
        let mut step = vec![BigRational::zero(); shift + 1];
        step[shift] = &rest[rest.len() - 1] / &b[b.len() - 1];
        rest = subtract(&rest, &product(&step, b));
        quotient[shift] = step[shift].clone();
    }
    (quotient, rest)
}

/// The entry by Euclid's algorithm on `x^(L+M+1)` and `A` (McEliece and Shearer 1978): the first
/// remainder of degree `L` or less, over its cofactor.
fn by_euclid(series: &[BigRational], asked: PadeType) -> (Poly, Poly) {
    let n = asked.conditions();
    let mut power = vec![BigRational::zero(); n];
    power.push(BigRational::one());
    let (mut before, mut cofactor_before) = (power, Vec::new());
    let (mut last, mut cofactor) = (subtract(&series[..n], &[]), vec![BigRational::one()]);
    while last.len() > asked.numerator + 1 {
        let (quotient, rest) = remainder(&before, &last);
        let next = subtract(&cofactor_before, &product(&quotient, &cofactor));
        (before, last) = (last, rest);
        (cofactor_before, cofactor) = (cofactor, next);
    }
    (last, cofactor)
}

/// The coefficient of `x^n` in `A Q - P`.
fn residual(series: &[BigRational], entry: &Approximant<Rationals>, n: usize) -> BigRational {
    let product: BigRational = entry.den().iter().zip(series[..=n].iter().rev()).map(|(q, a)| q * a).sum();
    entry.num().get(n).map_or(product.clone(), |p| product - p)
}

fn check_entry(name: &str, series: &[BigRational], asked: PadeType) {
    let entry = approximant(&Rationals, series, asked).unwrap();
    let (exact, order) = (entry.exact_type(), entry.contact().order());
    let context = format!("{name} {asked} {exact} {}", entry.contact());
    assert!((0..order).all(|n| residual(series, &entry, n).is_zero()), "{context}");
    if let Contact::Exactly(n) = entry.contact() {
        assert!(!residual(series, &entry, n).is_zero(), "{context}");
    }
    // x^lambda (P, Q) meets the linear conditions within the degrees asked for.
    let lambda = entry.deficiency();
    assert!(order + lambda >= asked.conditions(), "{context}");
    assert!(exact.numerator + lambda <= asked.numerator || entry.function().is_zero(), "{context}");
    assert!(exact.denominator + lambda <= asked.denominator, "{context}");
    if asked.conditions() <= CROSS_CHECKED {
        let (num, den) = by_euclid(series, asked);
        let crossed = subtract(&product(entry.num(), &den), &product(&num, entry.den()));
        assert_eq!(crossed, [], "{context}");
    }
    assert!(entry.den()[0].is_one(), "{context}");
}

fn check_table(name: &str, series: &[BigRational]) {
    let side = SIDE.min(series.len() / 2);
    for numerator in 0..side {
        for denominator in 0..side {
            check_entry(name, series, PadeType::new(numerator, denominator));
        }
    }
}

#[test]
fn exponential_is_normal() {
    check_table("exp", &exponential(KNOWN));
    let entry = approximant(&Rationals, &exponential(KNOWN), PadeType::new(3, 4)).unwrap();
    assert_eq!(entry.exact_type(), PadeType::new(3, 4));
    assert_eq!(entry.contact(), Contact::Exactly(8));
    assert_eq!(entry.den()[1], ratio(-4, 7)); // -M/(L + M)
}

#[test]
fn even_functions_have_blocks_of_side_two() {
    let series = cosine(KNOWN);
    check_table("cos", &series);
    for (numerator, denominator) in [(4, 2), (4, 3), (5, 2), (5, 3)] {
        let entry = approximant(&Rationals, &series, PadeType::new(numerator, denominator)).unwrap();
        assert_eq!(entry.exact_type(), PadeType::new(4, 2));
        assert_eq!(entry.contact(), Contact::Exactly(8));
        assert_eq!(entry.deficiency(), usize::from(numerator + denominator == 8));
    }
}

#[test]
fn rational_functions_fill_an_infinite_block() {
    for (num, den) in [
        (&[1, 0, 2][..], &[1, 0, 0, -1][..]),
        (&[0, 0, 0, 1], &[1, 1]),
        (&[5], &[1]),
        (&[3, 1], &[2, 0, 0, 0, 7]),
    ] {
        let series = quotient(num, den, KNOWN);
        check_table(&format!("{num:?}/{den:?}"), &series);
        let exact = PadeType::new(num.len() - 1, den.len() - 1);
        for (numerator, denominator) in [(0, 0), (0, 5), (5, 0), (5, 5)] {
            let asked = PadeType::new(exact.numerator + numerator, exact.denominator + denominator);
            let entry = approximant(&Rationals, &series, asked).unwrap();
            assert_eq!(entry.exact_type(), exact, "{asked}");
            assert_eq!(entry.contact(), Contact::AtLeast(KNOWN));
        }
    }
}

#[test]
fn lacunary_series_have_blocks_of_every_side() {
    check_table("lacunary", &lacunary(KNOWN));
    let entry = approximant(&Rationals, &lacunary(KNOWN), PadeType::new(11, 3)).unwrap();
    assert_eq!((entry.exact_type(), entry.deficiency()), (PadeType::new(8, 0), 0));
    let entry = approximant(&Rationals, &lacunary(KNOWN), PadeType::new(12, 4)).unwrap();
    assert_eq!((entry.exact_type(), entry.deficiency()), (PadeType::new(8, 0), 1));
}

#[test]
fn the_approximate_theory() {
    let series = approximate_theory(KNOWN);
    assert_eq!(series[2..5], [ratio(3, 5), ratio(-6, 25), ratio(7, 125)]);
    check_table("eps + s eps^(3/5) = 1", &series);
}

/// `Psi` to `len` coefficients, whose numerators and denominators grow fast.
fn check_delayed_recovery(len: usize) {
    let end = DelayedRecovery::new(&ForceLaw::viscoelastic_spheres()).unwrap();
    check_table("Psi", &end.psi(len - 1));
}

#[test]
fn the_gain_of_delayed_recovery() {
    check_delayed_recovery(16);
}

#[test]
#[ignore = "slow: Psi to [12/12] in fractions of thousands of digits, 80 s"]
fn the_whole_table_of_delayed_recovery() {
    check_delayed_recovery(KNOWN);
}

#[test]
fn polynomials_and_inverse_polynomials() {
    let series = exponential(4);
    let taylor = approximant(&Rationals, &series, PadeType::new(3, 0)).unwrap();
    assert_eq!(taylor.num(), series);
    let inverse = approximant(&Rationals, &series, PadeType::new(0, 3)).unwrap();
    assert_eq!(inverse.den(), [ratio(1, 1), ratio(-1, 1), ratio(1, 2), ratio(-1, 6)]);
    assert_eq!(approximant(&Rationals, &ints(&[5]), PadeType::new(0, 0)).unwrap().num(), ints(&[5]));
}

#[test]
fn the_zero_series_is_zero_over_one() {
    let entry = approximant(&Rationals, &ints(&[0; KNOWN]), PadeType::new(3, 4)).unwrap();
    assert!(entry.function().is_zero());
    assert_eq!((entry.num(), entry.den()), (&[][..], &ints(&[1])[..]));
    assert_eq!(entry.contact(), Contact::AtLeast(KNOWN));
    check_table("0", &ints(&[0; KNOWN]));
    let late = ints(&[0, 0, 0, 1, 1]);
    let entry = approximant(&Rationals, &late, PadeType::new(2, 2)).unwrap();
    assert!(entry.function().is_zero());
    assert_eq!(entry.contact(), Contact::Exactly(3));
}

#[test]
fn too_few_coefficients_are_an_error() {
    let short = exponential(7);
    assert!(approximant(&Rationals, &short, PadeType::new(3, 3)).is_ok());
    for asked in [PadeType::new(3, 4), PadeType::new(usize::MAX, 1), PadeType::new(usize::MAX, usize::MAX)] {
        let error = approximant(&Rationals, &short, asked).unwrap_err();
        assert!(matches!(error, PadeError::NotEnoughCoefficients { known: 7, .. }), "{asked}");
    }
    let none: &[BigRational] = &[];
    assert!(approximant(&Rationals, none, PadeType::new(0, 0)).is_err());
}
