use super::*;

#[test]
fn the_head_of_spheres_is_that_of_the_paper() {
    let head = Head::new(&ForceLaw::viscoelastic_spheres(), 3, 4);
    let find = |n, j| {
        let term = head.terms.iter().find(|t| (t.damping_order, t.elastic_index) == (n, j)).unwrap();
        let scale = head.damping_scale.powi(as_i64(n)) * head.elastic_scale.powi(as_i64(j));
        Ball::exact(term.trajectory.to_float()) / scale
    };
    // (A14): coefficients of t^(7/2) in x_0, t^(15/2) in x_1, t^(11/2) in x_3.
    for (n, j, numerator, denominator) in [(0, 1, 4, 35), (1, 2, 713, 238_875), (3, 0, 38, 2475)] {
        let error = find(n, j) - Ball::from_ratio(numerator, denominator, 64);
        assert!(error.abs_up() < 1e-9, "{n} {j} {error:?}");
    }
}

/// The four series by (2) of `docs/error-bounds.md`, as it is written there, in double precision.
fn plain(law: &ForceLaw, head: &Head, orders: usize, width: usize) -> [Vec<Vec<f64>>; 4] {
    let number = |x: &BigRational| Ball::from_rational(x, 64).to_f64();
    let (a, gamma) = (number(law.a()), number(law.gamma()));
    let (s, w) = (head.elastic_scale.to_f64(), head.damping_scale.to_f64());
    let zeros = || vec![vec![0.0; width]; orders + 1];
    let (mut l, mut powers) = (zeros(), [zeros(), zeros(), zeros()]);
    let product = |x: &[Vec<f64>], y: &[Vec<f64>], n: usize, j: usize| {
        let pairs = (0..=n).flat_map(|m| (0..=j).map(move |i| (m, i)));
        pairs.map(|(m, i)| x[m][i] * y[n - m][j - i]).sum::<f64>()
    };
    for n in 0..=orders {
        for j in 0..width {
            if (n, j) == (0, 0) {
                powers.iter_mut().for_each(|power| power[0][0] = 1.0);
                continue;
            }
            let e = (a + 1.0) * j as f64 + (gamma + 1.0) * n as f64;
            let elastic = if j > 0 { s * powers[0][n][j - 1] } else { 0.0 };
            let damping =
                if n > 0 { w * (powers[1][n - 1][j] + product(&powers[1], &l, n - 1, j)) } else { 0.0 };
            l[n][j] = -(product(&l, &l, n, j) + elastic + damping) / (e + 1.0);
            for (power, exponent) in powers.iter_mut().zip([a - 1.0, gamma, 1.0]) {
                power[n][j] = exponent * product(&l, power, n, j) / e;
            }
        }
    }
    let [elastic, damping, trajectory] = powers;
    [l, elastic, damping, trajectory]
}

#[test]
fn heads_of_all_four_series_solve_the_system() {
    // Of 3/2,1/2 and of 3,1 some of the powers coincide.
    for (law, orders) in [("3/2,1/2", 5), ("5/3,1/4", 4), ("3,1", 3), ("1/2,-1/4", 6), ("2,0", 2)] {
        let law: ForceLaw = law.parse().unwrap();
        let head = Head::new(&law, orders, 8);
        let [l, a, b, f] = plain(&law, &head, orders, 9);
        for t in &head.terms {
            let truth = [&l, &a, &b, &f].map(|x| x[t.damping_order][t.elastic_index].abs());
            let bounds = [t.logarithmic, t.elastic, t.damping, t.trajectory].map(Magnitude::to_f64);
            for (bound, truth) in bounds.iter().zip(truth) {
                assert!((bound - truth).abs() <= 1e-9 * truth.max(1e-3), "{law} {t:?} {truth}");
            }
        }
        // Every pair of indices below the limit, once.
        let mut found: Vec<(usize, usize)> =
            head.terms.iter().map(|t| (t.damping_order, t.elastic_index)).collect();
        found.sort_unstable();
        let grade = |n: usize, j: usize| head.lattice.damping * as_i64(n) + head.lattice.elastic * as_i64(j);
        let expected: Vec<(usize, usize)> = (0..=orders)
            .flat_map(|n| (0..=8).map(move |j| (n, j)))
            .filter(|&(n, j)| grade(n, j) <= head.limit)
            .collect();
        assert_eq!(found, expected);
    }
}

/// Operands at the ends of their balls: the products stay inside, and the radius is no more than the document says.
#[test]
fn sums_of_products_hold_every_operand() {
    const BITS: u32 = 20;
    let unit = |k: i64| Ball::from_ratio(k, 1 << BITS, 64);
    let row = |mid: [i64; 3], radius: i64| mid.map(|m| unit(m).widened(unit(radius).mid())).to_vec();
    let (x, y) = ([1 << 20, -3 << 18, 5 << 15], [7 << 17, 1 << 19, -9 << 16]);
    let (x_radius, y_radius) = (1 << 6, 3 << 5);
    let (p, q) = (Factor::new(&row(x, x_radius), BITS), Factor::new(&row(y, y_radius), BITS));
    let sums = sum_of_products([(2, &p, &q), (1, &q, &p)].into_iter(), 3, BITS);
    for (j, sum) in sums.iter().enumerate() {
        for signs in 0..64u32 {
            let sign = |k: usize| if signs >> k & 1 == 1 { 1 } else { -1 };
            let product = |i: usize| (x[i] + sign(i) * x_radius) * (y[j - i] + sign(3 + j - i) * y_radius);
            let exact = 3 * (0..=j).map(product).sum::<i64>();
            assert!(sum.contains(&(Ball::from_integer(exact, 64).shifted(-2 * BITS as i32))), "{j} {signs}");
        }
        // ||x|| rho_y + rho_x (||y|| + 3 rho_y), a unit more for the rounding of each operand, three times.
        let norm = |mid: [i64; 3], radius: i64| mid.iter().map(|m| m.abs() + radius).sum::<i64>() as f64;
        let (rho_x, rho_y) = (x_radius as f64 + 1.0, y_radius as f64 + 1.0);
        let (norm_x, norm_y) = (norm(x, x_radius), norm(y, y_radius));
        let once = |nx: f64, rx: f64, ny: f64, ry: f64| nx * ry + rx * (ny + 3.0 * ry);
        let stated = 2.0 * once(norm_x, rho_x, norm_y, rho_y) + once(norm_y, rho_y, norm_x, rho_x);
        let radius = sum.rad().to_f64() * 2f64.powi(2 * BITS as i32);
        assert!((radius / stated - 1.0).abs() < 1e-6, "{radius} {stated}");
    }
}
