use super::*;
use crate::coordinate::Coordinate;
use rug::Rational;

const BITS: u32 = 12;

fn jets(rows: &[[i32; 2]]) -> Jets {
    let coefficients = rows.concat().into_iter().map(Integer::from).collect();
    Jets { width: 2, bits: BITS, coefficients }
}

/// A flow of few degrees, at a pace that is not 1, so that much is cut off.
fn flow(law: &str, order: usize) -> Flow {
    let coordinate = Coordinate::of(&law.parse().unwrap());
    let u = [2100, 90].map(Integer::from).to_vec();
    let flow = Flow::new(&coordinate, u, BITS, order, 2).unwrap();
    flow.at_pace([4096, -310].map(Integer::from).to_vec())
}

fn norm(x: &Jets) -> f64 {
    x.size().to_f64()
}

#[test]
fn a_product_of_near_functions_is_as_near_as_is_said() {
    let flow = flow("3/2,1/2", 2);
    let near = |rows: &[[i32; 2]], error: f64| Near { jets: jets(rows), error: Ball::from_f64(error, 64) };
    let x = near(&[[4000, -700], [1500, 300], [-900, 41]], 0.03);
    let y = near(&[[-3000, 500], [2500, -123], [800, 77]], 0.05);
    let product = x.times(&y, &flow);
    let mut lost = zero();
    x.jets.product(&y.jets).rounded(3, 2, BITS, &mut lost);
    let wanted = norm(&x.jets) * 0.05 + norm(&y.jets) * 0.03 + 0.03 * 0.05 + lost.to_f64();
    assert!((product.error.to_f64() / wanted - 1.0).abs() < 1e-12, "{:?} {wanted}", product.error);
    assert_eq!((product.jets.rows(), product.jets.width, product.jets.bits), (3, 2, BITS));
}

/// `z^m (z^(A-1-m) c^2 + c u z^(B-1-m) v)` and the defect with it, in exact numbers.
struct Exact {
    step: Step,
    q: Rational,
    u: Jets,
    pace: Jets,
    coordinate: Jets,
    elastic: u32,
    damping: u32,
}

fn of(x: &Jets) -> Exactly {
    let number = |c: &Integer| Rational::from(c) >> x.bits;
    (0..x.rows()).map(|k| x.row(k).iter().map(number).collect()).collect()
}

impl Exact {
    /// `h = q 2^shift/rate`.
    fn length(&self) -> Rational {
        self.q.clone() * (Rational::from(1) << self.step.shift) / self.step.rate
    }

    /// Coefficients of exact polynomials in two variables, `[theta][delta]`.
    fn defect(&self) -> Vec<Vec<Rational>> {
        let length = self.length();
        let v = scaled(&derivative(&of(&self.coordinate)), &(self.q.clone() / &length));
        let power = |n: u32| {
            let one = vec![vec![Rational::from(1)]];
            (0..n).fold(one, |p, _| product(&p, &of(&self.coordinate)))
        };
        let c = of(&self.pace);
        let pull = product(&product(&of(&self.u), &c), &product(&power(self.damping), &v));
        let force = sum(&product(&power(self.elastic), &product(&c, &c)), &pull);
        sum(&derivative(&v), &scaled(&force, &length))
    }
}

type Exactly = Vec<Vec<Rational>>;

fn product(a: &Exactly, b: &Exactly) -> Exactly {
    let (wa, wb) = (a[0].len(), b[0].len());
    let mut out = vec![vec![Rational::new(); wa + wb - 1]; a.len() + b.len() - 1];
    for (i, a) in a.iter().enumerate() {
        for (j, b) in b.iter().enumerate() {
            for (p, a) in a.iter().enumerate() {
                for (q, b) in b.iter().enumerate() {
                    out[i + j][p + q] += Rational::from(a * b);
                }
            }
        }
    }
    out
}

fn sum(a: &Exactly, b: &Exactly) -> Exactly {
    let (rows, width) = (a.len().max(b.len()), a[0].len().max(b[0].len()));
    let get = |x: &Exactly, k: usize, j: usize| x.get(k).and_then(|r| r.get(j)).cloned().unwrap_or_default();
    (0..rows).map(|k| (0..width).map(|j| get(a, k, j) + get(b, k, j)).collect()).collect()
}

fn scaled(a: &Exactly, factor: &Rational) -> Exactly {
    a.iter().map(|row| row.iter().map(|c| Rational::from(c * factor)).collect()).collect()
}

fn derivative(a: &Exactly) -> Exactly {
    (1..a.len()).map(|k| scaled(&vec![a[k].clone()], &Rational::from(k)).remove(0)).collect()
}

/// A course of few bits and degrees leaves the defect of its exact polynomials, but for what its powers were rounded by.
#[test]
fn the_defect_is_that_of_the_exact_polynomials() {
    let laws = [
        ("3/2,1/2", 4, 2, (2, 1)),
        ("2,1", 2, 1, (1, 1)),
        ("1/2,3/2", 2, 4, (2, 1)),
        ("1,0", 1, 0, (1, 1)),
        ("3,2", 3, 2, (1, 1)),
    ];
    for (law, elastic, damping, q) in laws {
        for order in [3, 9] {
            let flow = flow(law, order);
            let coordinate = jets(&[[2600, -150], [900, 210], [-410, 60], [77, -9]]);
            let step = Step { rate: 70, shift: 5 };
            let course = Course::measure(&flow, coordinate.clone(), step);
            let exact = Exact {
                step,
                q: Rational::from(q),
                u: Jets::constant(&flow.u, BITS),
                pace: Jets::constant(&flow.pace, BITS),
                coordinate,
                elastic,
                damping,
            };
            let defect = exact.defect();
            let row = |row: &Vec<Rational>| row.iter().map(|c| c.to_f64().abs()).sum::<f64>();
            let largest: f64 = defect.iter().map(row).sum();
            let integral: f64 = defect.iter().enumerate().map(|(k, r)| row(r) / (k + 1) as f64).sum();
            let (found, all) = (course.defect.to_f64(), course.largest_defect.to_f64());
            let slack = if order == 3 { 4.0 } else { 1.25 };
            assert!(integral <= found && found < slack * integral, "{law} {order}: {found} {integral}");
            assert!(largest <= all && all < slack * largest, "{law} {order}: {all} {largest}");
            // Written out: the defect of what was computed, and h times the distance of the force.
            let common = Powers::new(&flow, &exact.coordinate).get(flow.common, &flow);
            let computed = sum(
                &derivative(&of(&course.velocity)),
                &scaled(&product(&of(&common.jets), &of(&course.balance)), &exact.length()),
            );
            let [a, b] = [&common.error, &course.balance_error].map(Ball::to_f64);
            let force_error = norm(&common.jets) * b + norm(&course.balance) * a + a * b;
            let wanted: f64 = computed.iter().map(row).sum::<f64>() + exact.length().to_f64() * force_error;
            assert!((all / wanted - 1.0).abs() < 1e-12, "{law} {order}: {all} {wanted}");
            let length = q.0 as f64 * 32.0 / 70.0 / q.1 as f64;
            assert!((course.length.to_f64() / length - 1.0).abs() < 1e-15);
            // What a shorter step makes smaller: the rows from the order's last on.
            let cut: f64 = defect.iter().skip(order - 1).map(|r| row(&r[..r.len().min(2)].to_vec())).sum();
            let seen = course.cut_off.to_f64();
            assert!(order == 9 || (seen > 0.2 * cut && seen < 5.0 * cut), "{law}: {seen} {cut}");
        }
    }
}

#[test]
fn powers_are_products_of_smaller_ones() {
    let flow = flow("3/2,1/2", 9);
    let z = jets(&[[2600, -150], [900, 210]]);
    let powers = Powers::new(&flow, &z);
    let mut exact = Jets::constant(&[Integer::from(1) << BITS], BITS);
    for n in 0..=2 {
        let found = powers.get(n, &flow);
        let off = found.jets.plus(&exact.clone().negative()).size();
        assert!((off - &found.error).lower() <= 0, "{n}");
        assert!(found.error.to_f64() < 0.02, "{n}: {:?}", found.error);
        assert_eq!(n < 2, found.error.to_f64() == 0.0);
        exact = exact.product(&z);
    }
}
