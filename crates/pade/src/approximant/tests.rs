use super::*;
use num_rational::BigRational;
use num_traits::Zero;
use restitution_real::{Ball, Balls, Rationals};

fn ints(p: &[i64]) -> Vec<BigRational> {
    p.iter().map(|&c| BigRational::from_integer(c.into())).collect()
}

/// All series of five coefficients that are -1, 0 or 1: every kind of degenerate block that fits.
fn all_series() -> impl Iterator<Item = Vec<BigRational>> {
    (0..243_i64)
        .map(|n| (0..5).map(|k| BigRational::from_integer((n / 3_i64.pow(k) % 3 - 1).into())).collect())
}

fn coefficient(p: &[BigRational], n: usize) -> BigRational {
    p.get(n).cloned().unwrap_or_else(BigRational::zero)
}

/// The coefficient of `x^n` in `A Q - P`.
fn residual(a: &[BigRational], p: &[BigRational], q: &[BigRational], n: usize) -> BigRational {
    (0..=n).fold(-coefficient(p, n), |sum, k| sum + coefficient(a, k) * coefficient(q, n - k))
}

/// The degree of the greatest common divisor, by Euclid; `None` of two zeros.
fn common_degree(p: &[BigRational], q: &[BigRational]) -> Option<usize> {
    let (mut p, mut q) = (p.to_vec(), q.to_vec());
    loop {
        while q.last().is_some_and(Zero::is_zero) {
            q.pop();
        }
        let Some(lead) = q.last().cloned() else { return p.len().checked_sub(1) };
        while p.len() >= q.len() {
            let factor = p[p.len() - 1].clone() / &lead;
            let shift = p.len() - q.len();
            for (k, c) in q.iter().enumerate() {
                p[shift + k] -= &factor * c;
            }
            p.pop();
        }
        std::mem::swap(&mut p, &mut q);
    }
}

/// The definition: `x^lambda (P, Q)` has the degrees and the order asked for, `P` and `Q` have no
/// common factor, `Q(0) = 1`; two such pairs are equal.
#[test]
fn every_entry_of_the_table_is_what_it_is_defined_to_be() {
    for series in all_series() {
        for asked in (0..5).flat_map(|l| (0..5 - l).map(move |m| PadeType::new(l, m))) {
            let found = approximant(&Rationals, &series, asked).unwrap();
            let (num, den, lambda) = (found.num(), found.den(), found.deficiency());
            let name = format!("{asked} of {series:?}: {num:?}/{den:?}");
            assert_eq!(found.asked(), asked, "{name}");
            assert_eq!(den[0], ints(&[1])[0], "{name}");
            assert!(num.len() + lambda <= asked.numerator + 1 || num.iter().all(Zero::is_zero), "{name}");
            assert!(den.len() + lambda <= asked.denominator + 1, "{name}");
            if num.iter().any(|c| !c.is_zero()) {
                assert_eq!(common_degree(num, den), Some(0), "{name}");
                let exact = PadeType::new(num.len() - 1, den.len() - 1);
                assert_eq!(found.exact_type(), exact, "{name}");
            }
            let first = (0..5).find(|&n| !residual(&series, num, den, n).is_zero());
            let contact = first.map_or(Contact::AtLeast(5), Contact::Exactly);
            assert_eq!(found.contact(), contact, "{name}");
            let order = asked.numerator + asked.denominator + 1;
            assert_eq!(lambda, order.saturating_sub(contact.order()), "{name}");
            assert_eq!(found.shared(), &series[..contact.order()], "{name}");
            assert_eq!(found.met_at_infinity(), 0, "{name}");
        }
    }
}

#[test]
fn approximants_of_the_exponential_are_its_closed_form() {
    let factorial = |n: usize| (1..=n).fold(ints(&[1])[0].clone(), |p, k| p * ints(&[k as i64])[0].clone());
    let series: Vec<_> = (0..9).map(|n| factorial(n).recip()).collect();
    // P = sum_k (L+M-k)! L!/((L+M)! k! (L-k)!) x^k, Q likewise of -x with L and M exchanged.
    let closed = |l: usize, m: usize, sign: i64| -> Vec<BigRational> {
        let term = |k: usize| {
            let (over, under) = (factorial(l + m - k) * factorial(l), factorial(l + m) * factorial(k));
            over / (under * factorial(l - k)) * ints(&[sign.pow(k as u32)])[0].clone()
        };
        (0..=l).map(term).collect()
    };
    for (l, m) in [(4, 4), (3, 5), (5, 3), (0, 6), (6, 0), (1, 2)] {
        let found = approximant(&Rationals, &series, PadeType::new(l, m)).unwrap();
        assert_eq!((found.num(), found.den()), (&closed(l, m, 1)[..], &closed(m, l, -1)[..]), "[{l}/{m}]");
        // With balls the same, each inside.
        let field = Balls::new(128);
        let balls: Vec<_> = series.iter().map(|c| field.rational(c)).collect();
        let near = approximant(&field, &balls, PadeType::new(l, m)).unwrap();
        for (ball, exact) in near.num().iter().zip(found.num()).chain(near.den().iter().zip(found.den())) {
            assert!(ball.contains_rational(exact) && *ball.rad() < 1e-25, "[{l}/{m}] {ball:?}");
        }
    }
}

/// `[L/M]` of `A` is the reciprocal of `[M/L]` of `1/A` (Hadamard).
#[test]
fn the_reciprocal_is_the_approximant_of_the_reciprocal_series() {
    for series in all_series() {
        for asked in (0..5).flat_map(|l| (0..5 - l).map(move |m| PadeType::new(l, m))) {
            let found = approximant(&Rationals, &series, asked).unwrap();
            if series[0].is_zero() {
                assert!(matches!(found.reciprocal(), Err(PadeError::PoleAtZero)), "{asked} of {series:?}");
                continue;
            }
            let mut inverse: Vec<BigRational> = vec![series[0].recip()];
            for n in 1..5 {
                let sum = (1..=n).fold(BigRational::zero(), |s, k| s + &series[k] * &inverse[n - k]);
                inverse.push(-sum / &series[0]);
            }
            let turned = PadeType::new(asked.denominator, asked.numerator);
            let expected = approximant(&Rationals, &inverse, turned).unwrap();
            assert_eq!(found.reciprocal().unwrap(), expected, "{asked} of {series:?}");
        }
    }
}

#[test]
fn parts_of_the_graph_are_the_polynomials_they_name() {
    for series in all_series() {
        for asked in [PadeType::new(2, 2), PadeType::new(1, 2), PadeType::new(3, 1), PadeType::new(0, 4)] {
            let found = approximant(&Rationals, &series, asked).unwrap();
            let (num, den, two) = (found.num(), found.den(), &ints(&[2])[0]);
            let minus = found.minus(two);
            let slope = found.slope();
            // The highest terms of P' Q and P Q' cancel where the degrees are the same.
            let highest =
                (num.len() + den.len() - 1).saturating_sub(if num.len() == den.len() { 2 } else { 1 });
            assert!(slope.len() <= highest, "{asked} of {series:?}");
            for n in 0..10 {
                let level = coefficient(num, n) - two * coefficient(den, n);
                assert_eq!(coefficient(&minus, n), level, "{asked} of {series:?}");
                let term = |k: usize| {
                    let weight = BigRational::from_integer((2 * k as i64 - n as i64 - 1).into());
                    weight * coefficient(num, k) * coefficient(den, n + 1 - k)
                };
                let rise = (0..=n + 1).fold(BigRational::zero(), |sum, k| sum + term(k));
                assert_eq!(coefficient(&slope, n), rise, "{asked} of {series:?}");
            }
        }
    }
}

#[test]
fn what_balls_leave_open_is_refused_and_exact_zeros_are_not() {
    let field = Balls::new(53);
    let third = Ball::from_ratio(1, 3, 53);
    let (blurred, zero) = (&third - &third, field.zero());
    // Whether [1/1] of 1/3 + d x + x^2/3 is degenerate hangs on d.
    let open = [third.clone(), blurred.clone(), third.clone()];
    assert!(matches!(approximant(&field, &open, PadeType::new(1, 1)), Err(PadeError::Undecided { .. })));
    let even = [third.clone(), zero.clone(), third.clone()];
    let found = approximant(&field, &even, PadeType::new(1, 1)).unwrap();
    assert_eq!((found.exact_type(), found.contact()), (PadeType::new(0, 0), Contact::Exactly(2)));
    // The order of contact ends where the next residual is not known to be zero or not.
    let constant = [third.clone(), zero.clone(), blurred, third.clone()];
    let found = approximant(&field, &constant, PadeType::new(1, 0)).unwrap();
    assert_eq!(found.contact(), Contact::AtLeast(2));
    assert_eq!(
        (found.contact().to_string(), Contact::Exactly(3).to_string()),
        ("at least O(x^2)".into(), "exactly O(x^3)".into())
    );
    // A row that is certainly not zero serves where another is open.
    let rows =
        [[zero, third.clone(), third.clone()].to_vec(), [third.clone(), &third - &third, third].to_vec()];
    let vector = null_vector(&field, rows.to_vec(), 3).unwrap();
    assert_eq!(vector.len(), 3);
    for row in &rows {
        let sum = row.iter().zip(&vector).fold(field.zero(), |sum, (a, v)| field.add(&sum, &field.mul(a, v)));
        assert!(sum.contains_zero() && *sum.rad() < 1e-12);
    }
}

#[test]
fn types_and_lengths_that_do_not_fit_are_refused() {
    let series = ints(&[1, 1, 2, 5]);
    for (l, m) in [(2, 2), (4, 0), (0, 4), (usize::MAX, usize::MAX)] {
        let asked = PadeType::new(l, m);
        let refused = approximant(&Rationals, &series, asked);
        let needed = l.saturating_add(m).saturating_add(1);
        assert_eq!(refused, Err(PadeError::NotEnoughCoefficients { asked, needed, known: 4 }));
    }
    assert!(approximant(&Rationals, &series, PadeType::new(1, 2)).is_ok());
    assert_eq!(PadeType::new(3, 8).to_string(), "[3/8]");
}
