use super::*;

/// Two rates of which one, the faster, bounds order 0 alone, and a head of three rows; exponents of spheres.
fn made_up() -> TailBound {
    let rate = |ratio, damping, g, h| Decay::new(ratio, damping, Magnitude::exact(g), Magnitude::exact(h));
    let row = |values: &[f64]| values.iter().map(|&x| Magnitude::exact(x)).collect::<Vec<_>>();
    TailBound {
        lattice: ForceLaw::viscoelastic_spheres().lattice(),
        damping_order: 5,
        checked_terms: 4,
        head: vec![row(&[1.0, 0.5, 0.25, 0.125]), row(&[0.75, 0.375]), row(&[0.0625])],
        rates: vec![
            rate(2.5, 0.5, 0.3, 0.1),
            rate(4.0, 0.0, 100.0, 2.0),
            rate(3.0, 0.25, 700.0, 5.0),
            rate(1.5, 4.0, 1.0, 0.5),
        ],
    }
}

/// `r`, `v`, `G`, `H` of the rates above.
const RATES: [[f64; 4]; 4] =
    [[2.5, 0.5, 0.3, 0.1], [4.0, 0.0, 100.0, 2.0], [3.0, 0.25, 700.0, 5.0], [1.5, 4.0, 1.0, 0.5]];

fn exponent(n: usize, j: usize) -> f64 {
    2.5 * j as f64 + 1.5 * n as f64
}

fn weight([r, v, ..]: [f64; 4], n: usize, j: usize) -> f64 {
    r.powi(-(j as i32)) * if n == 0 { 1.0 } else { v.powi(-(n as i32)) }
}

/// (5) of `docs/error-bounds.md`, least of the rates that bound the order.
fn least_coefficient(n: usize, j: usize) -> ([f64; 4], f64) {
    let e = exponent(n, j);
    let bound = |rate: &[f64; 4]| (rate[2] / (e * (e + 1.0)) + rate[3] / (e + 1.0)) * weight(*rate, n, j);
    let covering = RATES.into_iter().filter(|rate| n == 0 || rate[1] > 0.0);
    let least = covering.map(|rate| (rate, bound(&rate)));
    least.min_by(|x, y| x.1.total_cmp(&y.1)).unwrap()
}

fn closely_above(bound: &Float, formula: f64, what: &str) {
    let ratio = bound.to_f64() / formula;
    assert!(ratio > 1.0 - 1e-13 && ratio < 1.0 + 1e-8, "{what}: {ratio}");
}

#[test]
fn coefficients_are_those_of_the_head_and_of_the_best_rate() {
    let bound = made_up();
    assert_eq!((bound.damping_order(), bound.checked_terms()), (5, 4));
    assert_eq!(bound.ratio().to_bits(), 3f64.to_bits());
    assert_eq!(TailBound { damping_order: 0, ..made_up() }.ratio().to_bits(), 4f64.to_bits());
    for (n, j, size) in [(0, 0, 1.0), (0, 3, 0.125), (1, 1, 0.375), (2, 0, 0.0625)] {
        assert_eq!(bound.coefficient_up(n, j).to_f64().to_bits(), f64::to_bits(size));
    }
    let mut used = [false; 4];
    for n in 0..=5 {
        for j in [4, 7, 20, 60] {
            let (rate, least) = least_coefficient(n, j);
            closely_above(&bound.coefficient_up(n, j), least, &format!("{n} {j}"));
            used[RATES.iter().position(|x| *x == rate).unwrap()] = true;
        }
    }
    assert_eq!(used, [true; 4]);
    assert!(bound.coefficient_up(6, 9).is_infinite() && bound.coefficient_up(6, 0).is_infinite());
}

/// What is left of the head, term by term, and (7) of `docs/error-bounds.md` beyond it.
#[test]
fn tails_are_the_rest_of_the_head_and_a_geometric_series() {
    let bound = made_up();
    let heads: [&[f64]; 3] = [&[1.0, 0.5, 0.25, 0.125], &[0.75, 0.375], &[0.0625]];
    for n in 0..=5 {
        for terms in [0, 1, 2, 3, 4, 5, 30] {
            let known = heads.get(n).copied().unwrap_or_default();
            let first = terms.max(known.len());
            let (rate, _) = least_coefficient(n, first);
            let e = exponent(n, first);
            let rest = (rate[2] / e + rate[3]) * weight(rate, n, first) * rate[0] / (rate[0] - 1.0);
            let left = |velocity: bool| -> f64 {
                let of_head = |(j, q): (usize, &f64)| q * if velocity { exponent(n, j) + 1.0 } else { 1.0 };
                known.iter().enumerate().skip(terms).map(of_head).sum()
            };
            let tail = |sum| bound.tail_at_turning_point(sum, n, terms);
            let what = format!("{n} {terms}");
            closely_above(&tail(TurningPointSum::Velocity), left(true) + rest, &what);
            closely_above(&tail(TurningPointSum::Position), left(false) + rest / (e + 1.0), &what);
        }
    }
    assert!(bound.tail_at_turning_point(TurningPointSum::Position, 6, 3).is_infinite());
}

/// The least number that suffices for all orders, found one by one.
#[test]
fn terms_are_the_least_that_suffice() {
    let bound = made_up();
    for bits in [0, 1, 2, 5, 10, 33, 100] {
        let below = |n: usize, terms: usize| {
            let tail = bound.tail_at_turning_point(TurningPointSum::Velocity, n, terms).to_f64();
            tail < f64::from(bits).exp2().recip()
        };
        let of_order = |n: usize| (0..).find(|&terms| below(n, terms)).unwrap();
        let most = (0..=5).map(of_order).max().unwrap();
        assert_eq!(bound.terms_for(bits), most, "{bits}");
        for n in 0..=5 {
            for least in [0, 1, 9, 150] {
                assert_eq!(bound.terms_from(n, bits, least), of_order(n).max(least), "{n} {bits}");
                assert_eq!(bound.velocity_is_below(n, least, bits), below(n, least), "{n} {bits}");
            }
        }
    }
    // More bits than any sum has are as many as are allowed.
    assert!(!bound.velocity_is_below(0, 1000, u32::MAX));
    assert_eq!(
        bound.velocity_is_below(0, 600_000_000, u32::MAX),
        bound.velocity_is_below(0, 600_000_000, 1 << 30)
    );
    let lattice = ForceLaw::viscoelastic_spheres().lattice();
    for (n, j) in [(0, 0), (1, 0), (0, 1), (7, 13)] {
        let found = TailBound { lattice, ..made_up() }.exponent(n, j);
        assert!(found.is_exact() && (found.to_f64() - exponent(n, j)).abs() < 1e-12);
    }
}

/// The rows of the head are the enclosed coefficients, and everything is found again by the law alone.
#[test]
fn a_bound_has_the_head_of_its_law() {
    let law: ForceLaw = "7/3,5/6".parse().unwrap();
    let head = Head::new(&law, 3, 10);
    let bound = TailBound::new(3, &head, Vec::new());
    assert_eq!(bound.damping_order(), 3);
    let at_zero = head.terms.iter().filter(|term| term.damping_order == 0);
    assert_eq!(bound.checked_terms(), at_zero.count());
    for term in &head.terms {
        let found = bound.coefficient_up(term.damping_order, term.elastic_index);
        assert_eq!(found.to_f64().to_bits(), term.trajectory.to_f64().to_bits());
    }
    // Without a rate nothing is known beyond.
    assert!(bound.coefficient_up(0, bound.checked_terms()).is_infinite());
    assert!(bound.tail_at_turning_point(TurningPointSum::Velocity, 0, 0).is_infinite());
    assert_eq!(bound.ratio().to_bits(), 0f64.to_bits());
}
