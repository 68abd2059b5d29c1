use super::super::inverse::logarithm;
use super::*;
use restitution_real::Ball;

const BITS: u32 = 128;
const MORE: u32 = 256;
const HEAD: u32 = 48;
/// An error far above all rounding.
const LARGE: f64 = (1u64 << 40) as f64;

/// Exponents of spheres, of a law with `p < 0`, and of one with `p > 1`.
const EXPONENTS: [Exponents; 3] = [
    Exponents { elastic: (4, 5), velocity: (1, 5) },
    Exponents { elastic: (4, 3), velocity: (-2, 3) },
    Exponents { elastic: (1, 2), velocity: (9, 4) },
];

/// `1 + sum y_k v^k` with falling coefficients of alternating sign, in units of `2^-bits`.
fn compression(len: usize, bits: u32) -> Vec<Integer> {
    let coefficient = |k: usize| {
        let unit = Integer::from(1) << BITS;
        let size = if k == 0 { unit } else { unit * 2 / (Integer::from(5) << k as u32) };
        (if k % 2 == 1 { -size } else { size }) << (bits - BITS)
    };
    (0..len).map(coefficient).collect()
}

/// `y` with an error at one place, `ln eps` for it, and what is proved.
fn proved(y: &[Integer], y_error: f64, l_error: Option<(usize, f64)>, exponents: Exponents) -> Restitution {
    let shop = Workshop::new(BITS, HEAD, (0, 1));
    let y = Fixed::from_integers(y, shop.width());
    let mut l = logarithm(&shop, &y, exponents, y.len());
    if let Some((k, error)) = l_error {
        l.set(k, &(l.integer(k) + Integer::from(error as u64)));
    }
    prove(&shop, &y, Magnitude::exact(y_error), &l, exponents).unwrap()
}

/// `eps_k` with many more bits, in units of `2^-BITS`.
fn truth(len: usize, exponents: Exponents) -> Vec<Ball> {
    let shop = Workshop::new(MORE, HEAD, (0, 1));
    let y = Fixed::from_integers(&compression(len, MORE), shop.width());
    let l = logarithm(&shop, &y, exponents, len);
    let series = power_of_exponential(&shop, &l, (1, 1));
    let ball = |k: usize| Ball::from_big_integer(&series.integer(k), 512).shifted(BITS as i32 - MORE as i32);
    (0..len).map(ball).collect()
}

/// The largest `|eps_k - eps~_k| weight^k` over what is stated of it.
fn used(found: &Restitution, truth: &[Ball]) -> f64 {
    let off = |k: usize| {
        let ours = Ball::from_big_integer(&found.series.integer(k), 512);
        (ours - truth[k].clone()).abs().to_f64() * found.weight.powi(k as i32)
    };
    (0..truth.len()).map(off).fold(0.0, f64::max) / found.error.to_f64()
}

#[test]
fn errors_of_the_compression_are_in_the_bound() {
    for exponents in EXPONENTS {
        for len in [2, 5, 8] {
            let truth = truth(len, exponents);
            let exact = compression(len, BITS);
            assert!(used(&proved(&exact, 0.0, None, exponents), &truth) <= 1.0);
            for k in 1..len {
                for sign in [-1, 1] {
                    let mut y = exact.clone();
                    y[k] += Integer::from(LARGE as u64) * sign;
                    let stated = used(&proved(&y, LARGE, None, exponents), &truth);
                    assert!(stated <= 1.0, "{exponents:?}: y_{k} of {len} uses {stated} of the bound");
                    // Without the error of what was given, the bound would be broken: this can be noticed.
                    let silent = used(&proved(&y, 0.0, None, exponents), &truth);
                    // Even orders cancel where they are the last, or where eps^q w^k = v^k.
                    let [q, p] = [exponents.elastic, exponents.velocity].map(|(n, d)| n as f64 / d as f64);
                    let cancels = k % 2 == 0 && (k + 1 == len || (q + p * k as f64).abs() < 1e-9);
                    assert!(silent > 1.0 || cancels, "{exponents:?}: y_{k} of {len}: {silent}");
                }
            }
        }
    }
}

#[test]
fn errors_of_the_logarithm_are_in_the_bound() {
    for exponents in EXPONENTS {
        for len in [2, 5, 8] {
            let truth = truth(len, exponents);
            let exact = compression(len, BITS);
            for k in 1..len {
                let found = proved(&exact, 0.0, Some((k, LARGE)), exponents);
                let stated = used(&found, &truth);
                assert!(stated <= 1.0, "{exponents:?}: L_{k} of {len} uses {stated} of the bound");
                // An even order of L, if the last, cancels: it leaves no trace in G.
                let cancels = k + 1 == len && k % 2 == 0;
                assert!(stated > 1e-5 || cancels, "{exponents:?}: L_{k} of {len} uses {stated} of the bound");
            }
        }
    }
}

/// Powers `exp(q L)` against many more bits.
#[test]
fn errors_of_exponentials_hold() {
    let shop = Workshop::new(BITS, HEAD, (0, 1));
    let more = Workshop::new(MORE, HEAD, (0, 1));
    for len in [2usize, 3, 9] {
        let logarithm = |bits: u32| -> Vec<Integer> {
            compression(len, bits)
                .into_iter()
                .enumerate()
                .map(|(k, c)| if k == 0 { Integer::new() } else { c })
                .collect()
        };
        let l = Fixed::from_integers(&logarithm(BITS), shop.width());
        let better = Fixed::from_integers(&logarithm(MORE), more.width());
        for weight in [1.0, 0.75] {
            let scales = Scales { shop: &shop, len, weight, small: power_of_two(-i64::from(BITS)) };
            for power in [(1, 1), (4, 5), (-2, 3), (9, 4), (-7, 2)] {
                let found = scales.exponential(&l, power).unwrap();
                let truth = power_of_exponential(&more, &better, power);
                let (mut norm, mut off, mut size) = (0.0, 0.0, 1.0);
                for k in 0..len {
                    let ours = Ball::from_big_integer(&found.series.integer(k), 512);
                    let exact =
                        Ball::from_big_integer(&truth.integer(k), 512).shifted(BITS as i32 - MORE as i32);
                    norm += exact.clone().shifted(-(BITS as i32)).abs().to_f64() * size;
                    off += (ours - exact).abs().to_f64() * size;
                    size *= weight;
                }
                assert!(off <= found.error.to_f64(), "{power:?}: {off} {:?}", found.error);
                assert!((norm..norm * (1.0 + 1e-9)).contains(&found.norm.to_f64()), "{power:?}: {norm}");
            }
        }
    }
}

/// What is proved of `1 + first v + ...` at so many bits: `error weight`, or nothing.
fn at(
    len: usize,
    first: f64,
    (elastic, velocity): ((i64, i64), (i64, i64)),
    bits: u32,
    l_error: f64,
) -> String {
    let exponents = Exponents { elastic, velocity };
    let shop = Workshop::new(bits, HEAD, (0, 1));
    let coefficient = |k: usize| Integer::from_f64(first.powi(k as i32) * f64::from(bits).exp2()).unwrap();
    let y: Vec<Integer> = (0..len).map(coefficient).collect();
    let y = Fixed::from_integers(&y, shop.width());
    let mut l = logarithm(&shop, &y, exponents, len);
    if len > 1 {
        l.set(1, &(l.integer(1) + Integer::from_f64(l_error).unwrap()));
    }
    let found = prove(&shop, &y, Magnitude::exact(3.0), &l, exponents);
    found.map_or("nothing".to_owned(), |found| format!("{:?} {:?}", found.error.to_f64(), found.weight))
}

/// What is proved, to the last bit, where every part of the bound counts: few bits, or a large second derivative.
#[test]
fn figures_of_the_proof() {
    let spheres = ((4, 5), (1, 5));
    let half = ((4, 3), (-2, 3));
    let steep = ((1, 2), (9, 4));
    for (len, first, exponents, bits, expected) in [
        (1, 1.0, spheres, 64, "97.86096100015388 1.0"),
        (2, -0.375, spheres, 64, "1293.965018657504 0.9989999990007963"),
        (5, -0.375, spheres, 64, "6891.85406477337 0.8406651808097002"),
        (10, -0.375, spheres, 64, "19947.335256242306 0.8394174407049384"),
        (5, -0.375, half, 64, "2826.435884842168 0.7219646487203059"),
        (5, -0.375, steep, 64, "30586.98073633892 0.2735131770725903"),
        (8, -0.375, ((1, 5), (1, 1000)), 64, "2235374.9921772033 0.9950869668936233"),
        (3, 2e-5, ((1, 1), (10_000_000, 1)), 64, "204354.7833316417 0.04874062407216945"),
        (3, 2e-5, ((3, 2), (10_000_000, 1)), 65, "57762.33989122391 0.059360329816384026"),
        (5, 2e-5, ((1, 1), (300_000, 1)), 64, "9039.888503992901 0.12161048124770593"),
        // The least weight.
        (3, 1.0, ((1, 1), (400_000, 1)), 192, "2.4650550131818425e22 0.001116850004811577"),
        (3, 1.0, ((1, 1), (600_000, 1)), 192, "nothing"),
    ] {
        assert_eq!(at(len, first, exponents, bits, 0.0), expected, "{len} {first} {exponents:?} {bits}");
    }
}

/// Nothing is proved where the error is not small beside 1, or the second derivative times it.
#[test]
fn errors_too_large_for_the_theorem_are_refused() {
    let large = ((1, 1), (1_000_000, 1));
    for (len, first, exponents, exponent, expected) in [
        (5, -0.375, ((4, 5), (1, 5)), 54, "1.2253489099970666e17 0.8406651825713914"),
        (5, -0.375, ((4, 5), (1, 5)), 55, "nothing"),
        // That the image stays inside the unit ball asks for more.
        (2, 1e-6, large, 43, "35132017023228.813 0.9989999990007963"),
        (2, 1e-6, large, 44, "nothing"),
    ] {
        let found = at(len, first, exponents, 80, 2f64.powi(exponent));
        assert_eq!(found, expected, "{len} {exponents:?} 2^{exponent}");
    }
}

#[test]
fn numbers_are_taken_as_bounds() {
    for x in [0.0, 1e-9, 0.3, 1.0, 12345.678] {
        let taken = super::exact(x).to_f64();
        assert!(taken >= x * (1.0 + 9e-13) && taken <= x * (1.0 + 2e-12), "{x}");
    }
}

/// The sums and errors that the proof adds up, from their formulas.
#[test]
fn parts_of_the_bound_are_those_of_their_formulas() {
    let exact = |x: f64| Magnitude::exact(x);
    let near = |found: Magnitude, expected: f64| {
        let found = found.to_f64();
        assert!(found >= expected && found <= expected * (1.0 + 1e-11), "{found} {expected}");
    };
    let sizes = [1.0, 0.75, 0.5, 3.0];
    let (q, p) = (0.25, 1.5);
    let sums = Sums::of(&sizes.map(exact), exact(q), exact(p));
    let sum = |of: &dyn Fn(f64) -> f64| (0..4).map(|k| sizes[k] * of(k as f64)).sum::<f64>();
    near(sums.total, 5.25);
    near(sums.slope, sum(&|k| k));
    near(sums.by_image, sum(&|k| k * (q + p * k)));
    near(sums.by_square, sum(&|k| (q + p * k).powi(2)));
    let second = sums.second_derivative(exact(0.125), exact(6.25), exact(3.0));
    near(second, (sum(&|k| (q + p * k).powi(2)) + 0.125 * 6.25 * 6.25) * 3.0 * 2.0);
    near(composing(9, exact(2.5)), (PRODUCT + 1.0) * 9.0 * (9.0 + 3.0 * 3.0 + 4.0) * 3.5);
    let error = derivative_error(7, exact(1.5), exact(20.0), exact(5.0));
    near(error, PRODUCT * 7.0 + 1.5 * (14.0 + 20.0) + 10.0);
}
