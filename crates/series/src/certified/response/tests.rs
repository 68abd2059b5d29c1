use super::*;

/// Sizes and weights as plain numbers: `weight(b, b')` is `top/(b + b')^power`.
struct Plain {
    step: usize,
    sizes: Vec<f64>,
    top: f64,
    power: i32,
}

impl Plain {
    fn weight(&self, b: usize, place: usize) -> f64 {
        self.top / ((b + place) as f64).max(0.5).powi(self.power)
    }
}

fn found(first: usize, causes: &[Plain], most: usize) -> Option<f64> {
    let sizes: Vec<Vec<Magnitude>> =
        causes.iter().map(|cause| cause.sizes.iter().map(|&size| Magnitude::exact(size)).collect()).collect();
    let weights: Vec<_> =
        causes.iter().map(|cause| |b: usize, place: usize| cause.weight(b, place)).collect();
    let causes: Vec<Cause> = causes
        .iter()
        .zip(&sizes)
        .zip(&weights)
        .map(|((cause, sizes), weight)| Cause { step: cause.step, sizes, weight })
        .collect();
    response(first, &causes, most).map(Magnitude::to_f64)
}

/// The recursion of section 11 of `docs/error-bounds.md`, as it is written there.
fn written_out(first: usize, causes: &[Plain], most: usize) -> Option<f64> {
    let terms = |b: usize| -> Vec<(usize, f64)> {
        let of_cause = |cause: &Plain| -> Vec<(usize, f64)> {
            let place = |i: usize| b + cause.step + i;
            cause.sizes.iter().enumerate().map(|(i, s)| (place(i), cause.weight(b, place(i)) * s)).collect()
        };
        causes.iter().flat_map(of_cause).collect()
    };
    let all = |b: usize| terms(b).iter().map(|(_, term)| term).sum::<f64>();
    let end = (first..most).find(|&b| all(b) <= 0.5)?;
    let mut response = vec![1.0 / (1.0 - all(end)); end + 40];
    for b in (first..end).rev() {
        let within: f64 = terms(b).iter().filter(|(place, _)| *place == b).map(|(_, term)| term).sum();
        let later = terms(b).into_iter().filter(|(place, _)| *place > b);
        let sum = 1.0 + later.map(|(place, term)| term * response[place]).sum::<f64>();
        if within > 0.999 {
            return None;
        }
        response[b] = sum / (1.0 - within);
    }
    Some(response[first])
}

fn cases() -> Vec<(usize, Vec<Plain>, usize)> {
    let plain = |step, sizes: &[f64], top, power| Plain { step, sizes: sizes.to_vec(), top, power };
    vec![
        // Small at once.
        (0, vec![plain(1, &[0.1, 0.0, 0.2], 0.5, 1)], 10),
        // Small after some places; one cause, two causes, causes with gaps.
        (0, vec![plain(1, &[3.0], 2.0, 1)], 100),
        (2, vec![plain(2, &[5.0, 1.0, 0.25], 1.5, 2), plain(1, &[2.0, 0.5], 1.0, 1)], 100),
        (1, vec![plain(3, &[0.0, 40.0], 1.0, 2), plain(1, &[0.0, 0.0, 7.0], 0.5, 1)], 60),
        // Within one place.
        (3, vec![plain(0, &[2.0, 1.5], 1.0, 1), plain(1, &[1.0], 1.0, 1)], 60),
        (2, vec![plain(0, &[1.0, 0.0, 2.0], 1.0, 1), plain(0, &[0.5, 3.0], 1.0, 1)], 60),
        // Within one place too much.
        (0, vec![plain(0, &[2.0], 1.0, 1)], 60),
    ]
}

/// Rounded up, and by no more than the roundings.
#[test]
fn responses_are_those_of_the_recursion() {
    for (case, (first, causes, most)) in cases().into_iter().enumerate() {
        match (found(first, &causes, most), written_out(first, &causes, most)) {
            (Some(found), Some(plain)) => {
                let ratio = found / plain;
                assert!((1.0 - 1e-14..1.0 + 1e-10).contains(&ratio), "{case}: {found} for {plain}");
            }
            (None, None) => assert_eq!(case, 6),
            (found, plain) => panic!("{case}: {found:?} for {plain:?}"),
        }
    }
}

/// What a unit of error becomes when it is followed from place to place, however many times it is passed on.
#[test]
fn no_error_grows_beyond_the_response() {
    for (case, (first, causes, most)) in cases().into_iter().enumerate() {
        let Some(found) = found(first, &causes, most) else { continue };
        for start in first..first + 12 {
            let mut errors = vec![0.0; 400];
            errors[start] = 1.0;
            for b in start..300 {
                // Within one place: passed on until hardly anything is left.
                let within: f64 =
                    causes.iter().filter(|c| c.step == 0).map(|c| c.weight(b, b) * c.sizes[0]).sum();
                errors[b] *= (0..500).map(|k| within.powi(k)).sum::<f64>();
                for cause in &causes {
                    for (i, size) in cause.sizes.iter().enumerate().filter(|(i, _)| cause.step + i > 0) {
                        errors[b + cause.step + i] += cause.weight(b, b + cause.step + i) * size * errors[b];
                    }
                }
            }
            let whole: f64 = errors.iter().sum();
            assert!(whole <= found * (1.0 + 1e-12), "{case}: {whole} of one unit at {start}, bound {found}");
        }
    }
}

/// Nothing is said where the factors stay large among the places there are.
#[test]
fn places_are_searched_to_the_last() {
    let slow = || [Plain { step: 1, sizes: vec![20.0], top: 1.0, power: 1 }];
    // 20/(2b + 1) <= 1/2 from b = 20 on.
    assert!(found(0, &slow(), 21).is_some());
    assert!(found(0, &slow(), 19).is_none());
    assert!(found(20, &slow(), 20).is_none());
    for start in 0..12 {
        for end in 0..40 {
            for from in 0..45 {
                let place = first_place(start..end, |b| b >= from);
                let least = from.max(start);
                let expected = (start < end && least <= end).then_some(least);
                assert_eq!(place, expected, "from {from} in {start}..{end}");
            }
        }
    }
}
