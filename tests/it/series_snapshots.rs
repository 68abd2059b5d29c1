//! Snapshots of the expansion of spheres. What each is right by stands in `reference`, `laws` and `identities`.

use crate::support::in_snapshots;
use restitution_law::ForceLaw;
use restitution_real::Ball;
use restitution_series::{DelayedRecovery, Quantity, Trajectories, coefficients};

/// One line for each coefficient from the first on: its order, its digits and its radius below them.
fn lines(quantity: Quantity, (first, last): (usize, usize), digits: usize) -> String {
    let spheres = ForceLaw::viscoelastic_spheres();
    let values = coefficients(quantity, &spheres, last, digits).expect("the expansion exists");
    let line = |(k, c): (usize, &Ball)| format!("{k:3}  {}\n", c.to_digits(digits).expect("proved digits"));
    values.iter().enumerate().skip(first).map(line).collect()
}

fn snapshot(name: &str, text: &str) {
    in_snapshots("series", || insta::assert_snapshot!(name, text));
}

#[test]
fn restitution_to_40_digits() {
    snapshot("C", &format!("C_k of spheres, 40 digits\n{}", lines(Quantity::Restitution, (1, 4), 40)));
}

#[test]
fn scaled_restitution() {
    snapshot("a", &format!("a_k of spheres, 30 digits\n{}", lines(Quantity::ScaledRestitution, (1, 8), 30)));
}

#[test]
fn compression() {
    snapshot("y", &format!("y_k of spheres, 30 digits\n{}", lines(Quantity::Compression, (0, 4), 30)));
}

#[test]
fn delayed_recovery() {
    let lines = lines(Quantity::DelayedRecovery, (0, 12), 30);
    snapshot("h", &format!("h_k of spheres, half powers of u, 30 digits\n{lines}"));
    let end = DelayedRecovery::new(&ForceLaw::viscoelastic_spheres()).expect("3/2 > 1/2");
    let line = |(k, psi)| format!("{k:3}  {psi}\n");
    let lines: String = end.psi(6).into_iter().enumerate().map(line).collect();
    snapshot("psi", &format!("coefficients of Psi(y) of spheres\n{lines}"));
}

#[test]
fn trajectories_to_the_eleventh_power() {
    let trajectories = Trajectories::exact(&ForceLaw::viscoelastic_spheres(), 3, 5);
    let mut text = String::from("x_0 .. x_3 of spheres to t^11: order, exponent of t, coefficient\n");
    for n in 0..=3 {
        for (j, q) in trajectories.coefficients(n).expect("derived").iter().enumerate() {
            let exponent = trajectories.exponent(n, j);
            if exponent <= 11.into() {
                text += &format!("{n}  {:>4}  {q}\n", exponent.to_string());
            }
        }
    }
    snapshot("trajectories", &text);
}
