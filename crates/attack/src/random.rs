//! Random values: the same ones for the same seed, part and number of a case.

use rand::rngs::SmallRng;
use rand::{Rng, RngExt, SeedableRng};

/// The source of a case's random values.
pub type Source = SmallRng;

/// Returns the source of case `number` of `part`.
pub fn source(seed: u64, part: &str, number: u64) -> Source {
    let mut state = seed ^ 0x9e37_79b9_7f4a_7c15;
    for word in part.bytes().map(u64::from).chain([number]) {
        state = (state ^ word).wrapping_mul(0xff51_afd7_ed55_8ccd).rotate_left(29);
    }
    SmallRng::seed_from_u64(state)
}

/// Returns one of the items.
///
/// # Panics
///
/// If there are none.
pub fn choose<'a, T>(random: &mut Source, items: &'a [T]) -> &'a T {
    &items[random.random_range(0..items.len())]
}

/// Returns any of the 2^64 bit patterns as a number.
pub fn bits(random: &mut Source) -> f64 {
    f64::from_bits(random.next_u64())
}

/// Returns a number between `low` and `high`, spread evenly in the logarithm.
pub fn by_ratio(random: &mut Source, low: f64, high: f64) -> f64 {
    low * (high / low).powf(random.random::<f64>())
}

/// Returns `x` moved by up to `steps` neighbouring numbers up or down.
pub fn near(random: &mut Source, x: f64, steps: i32) -> f64 {
    let count = random.random_range(-steps..=steps);
    (0..count.abs()).fold(x, |x, _| if count > 0 { x.next_up() } else { x.next_down() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_case_repeats_itself_and_no_other() {
        let draw = |seed, part, number| source(seed, part, number).next_u64();
        assert_eq!(draw(1, "f64", 2), draw(1, "f64", 2));
        let others = [draw(2, "f64", 2), draw(1, "data", 2), draw(1, "f64", 3)];
        assert!(others.iter().all(|other| *other != draw(1, "f64", 2)));
    }
}
