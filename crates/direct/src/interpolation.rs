use crate::collision::Collision;
use crate::damping::Damping;
use crate::error::DirectError;
use num_rational::BigRational;
use rayon::prelude::*;
use restitution_real::Ball;
use rug::Float;

/// Proved digits of the coefficients that are compared: more than a table of velocities can need.
const DIGITS: usize = 25;
/// Bits that hold them.
const BITS: u32 = 128;

impl Collision {
    /// Bounds by how much linear interpolation in the velocity, between two velocities of a table, differs from `epsilon`.
    ///
    /// Where `epsilon` bends one way between them, its distance `h` from the chord vanishes at both ends and bends the other way, so that it lies
    /// below its own chords prolonged: those from either end to a point where it is known. With `h <= M` at the three points that
    /// quarter the interval,
    ///
    /// ```text
    /// h(t) <= (4/3) (1 - t) M <= (4/3) M              for t <= 1/4
    /// h(t) <= min(4 t, 2 (1 - t)) M <= (4/3) M        for 1/4 <= t <= 1/2, and likewise beyond
    /// ```
    ///
    /// That `epsilon(g)` bends one way is not proved but was seen wherever it was looked for (tests/it/lookup.rs): it is convex for
    /// `0 < p < 1`, spheres among them. The three distances are certified. Cost: five coefficients of 25 digits.
    ///
    /// # Errors
    ///
    /// As [`Collision::epsilon`], and those of `damping`.
    ///
    /// # Examples
    ///
    /// ```
    /// use num_rational::BigRational;
    /// use restitution_direct::{Collision, Damping, DirectError, End};
    /// use restitution_law::ForceLaw;
    ///
    /// let law = ForceLaw::viscoelastic_spheres();
    /// let spheres = Collision::new(&law, End::ZeroCompression)?;
    /// let whole = |n: i64| BigRational::from_integer(n.into());
    /// let damping = |g: &BigRational| Damping::of_velocity(g, &whole(1), &law);
    /// let coarse = spheres.interpolation_error(&whole(1), &whole(2), damping)?;
    /// assert!(coarse > 0.003 && coarse < 0.007);
    ///
    /// assert_eq!(spheres.interpolation_error(&whole(-1), &whole(2), damping), Err(DirectError::NegativeVelocity));
    /// # Ok::<(), DirectError>(())
    /// ```
    pub fn interpolation_error(
        &self,
        from: &BigRational,
        to: &BigRational,
        damping: impl Fn(&BigRational) -> Result<Damping, DirectError>,
    ) -> Result<f64, DirectError> {
        let epsilon = |g: &BigRational| self.epsilon_at(&damping(g)?, DIGITS);
        let (first, last) = (epsilon(from)?, epsilon(to)?);
        let off = |quarter: i64| {
            let share = BigRational::new(quarter.into(), 4.into());
            let between = from + (to - from) * &share;
            let chord = &first + (&last - &first) * Ball::from_rational(&share, BITS);
            Ok::<_, DirectError>((epsilon(&between)? - chord).abs().upper())
        };
        let bound = Ball::exact(largest([off(1)?, off(2)?, off(3)?]))
            * Ball::from_rational(&BigRational::new(4.into(), 3.into()), BITS);
        Ok(bound.upper().to_f64_round(rug::float::Round::Up))
    }

    /// Bounds by how much linear interpolation in a whole table of velocities differs from `epsilon`, its `digits` rounded digits included.
    ///
    /// The largest [`interpolation_error`](Self::interpolation_error) between neighbours, with one unit of the last digit that is printed and the rounding of
    /// a velocity to f64 added. The velocities need no order; `None` if there are fewer than two. `after_each` is called for every interval
    /// that is done with. Cost: five coefficients of 25 digits for each interval, on all processors.
    ///
    /// # Errors
    ///
    /// As [`Collision::interpolation_error`].
    ///
    /// # Examples
    ///
    /// ```
    /// use num_rational::BigRational;
    /// use restitution_direct::{Collision, Damping, DirectError, End};
    /// use restitution_law::ForceLaw;
    ///
    /// let law = ForceLaw::viscoelastic_spheres();
    /// let spheres = Collision::new(&law, End::ZeroCompression)?;
    /// let velocities = [3, 1, 2].map(|n: i64| BigRational::from_integer(n.into()));
    /// let damping = |g: &BigRational| Damping::of_velocity(g, &velocities[1], &law);
    /// let error = spheres.table_error(&velocities, 6, damping, || ())?;
    /// assert!(error.is_some_and(|error| error > 0.003 && error < 0.007));
    /// assert_eq!(spheres.table_error(&velocities[..1], 6, damping, || ())?, None);
    ///
    /// let nothing = |_: &BigRational| Err(DirectError::NegativeVelocity);
    /// assert!(spheres.table_error(&velocities, 6, nothing, || ()).is_err());
    /// # Ok::<(), DirectError>(())
    /// ```
    pub fn table_error(
        &self,
        velocities: &[BigRational],
        digits: usize,
        damping: impl Fn(&BigRational) -> Result<Damping, DirectError> + Sync,
        after_each: impl Fn() + Sync,
    ) -> Result<Option<f64>, DirectError> {
        let mut velocities = velocities.to_vec();
        velocities.sort();
        velocities.dedup();
        let between = |pair: &[BigRational]| {
            let error = self.interpolation_error(&pair[0], &pair[1], &damping);
            after_each();
            error
        };
        let errors = velocities.par_windows(2).map(between).collect::<Result<Vec<_>, _>>()?;
        let printed = 0.1_f64.powi(i32::try_from(digits).unwrap_or(i32::MAX)) + f64::EPSILON;
        Ok(errors.into_iter().reduce(f64::max).map(|largest| largest + printed))
    }
}

/// The largest of three numbers, all its bits: `Float::max` rounds what it takes from the other.
fn largest(numbers: [Float; 3]) -> Float {
    let [first, second, third] = numbers;
    let larger = |x: Float, y: Float| if y > x { y } else { x };
    larger(larger(first, second), third)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::End;

    #[test]
    fn the_largest_number_is_not_rounded() {
        let long = Float::with_val(200, 1) + Float::with_val(200, Float::i_exp(1, -150));
        let short = |x: u32| Float::with_val(BITS, x);
        assert_eq!(largest([short(1), short(0), long.clone()]), long);
        assert_eq!(largest([short(1), long.clone(), short(0)]), long);
        assert_eq!(largest([short(2), long, short(0)]), short(2));
    }

    fn ratio(n: i64, d: i64) -> BigRational {
        BigRational::new(n.into(), d.into())
    }

    /// The distances from the chord, from coefficients of other velocities, and 4/3 of the largest.
    #[test]
    fn the_distance_from_the_chord_is_bounded_by_four_thirds_of_three() {
        let spheres = Collision::new(&"3/2,1/2".parse().unwrap(), End::ZeroCompression).unwrap();
        let damping = |g: &BigRational| Ok(Damping::exact(g));
        let found = spheres.interpolation_error(&ratio(1, 1), &ratio(3, 1), damping).unwrap();
        let at = |quarter: i64| spheres.epsilon(&(ratio(1, 1) + ratio(quarter, 2)), 20).unwrap().to_f64();
        let chord = |quarter: i64| at(0) + (at(4) - at(0)) * quarter as f64 / 4.0;
        let largest = (1..4).map(|quarter| (chord(quarter) - at(quarter)).abs()).fold(0.0, f64::max);
        assert!((found / (largest * 4.0 / 3.0) - 1.0).abs() < 1e-12, "{found} {largest}");
        // A table: the larger of two, a unit of the last digit and the rounding of a velocity.
        let other = spheres.interpolation_error(&ratio(3, 1), &ratio(4, 1), damping).unwrap();
        assert!(other < found);
        let velocities = [ratio(3, 1), ratio(4, 1), ratio(1, 1), ratio(3, 1)];
        let table = spheres.table_error(&velocities, 3, damping, || ()).unwrap().unwrap();
        assert!((table - found - 0.001 - f64::EPSILON).abs() < 1e-16, "{table} {found}");
    }
}
