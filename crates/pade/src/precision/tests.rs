use super::*;

#[test]
fn precisions_double_up_to_the_limit() {
    let asked = |start: u32, limit: u32, enough: u32| {
        let mut all = Vec::new();
        let answer = with_precision(start, limit, |bits| -> Result<_, PadeError> {
            all.push(bits);
            Ok(if bits < enough { Err(PadeError::Undecided { what: "it" }) } else { Ok(bits) })
        });
        (all, answer)
    };
    let exhausted = |reached_bits| Err(PadeError::PrecisionExhausted { what: "it", reached_bits });
    assert_eq!(asked(64, 1024, 1), (vec![64], Ok(64)));
    assert_eq!(asked(64, 256, 200), (vec![64, 128, 256], Ok(256)));
    assert_eq!(asked(64, 256, 257), (vec![64, 128, 256], exhausted(256)));
    assert_eq!(asked(64, 255, 257), (vec![64, 128], exhausted(128)));
    assert_eq!(asked(0, 5, 100), (vec![1, 2, 4], exhausted(4)));
    assert_eq!(asked(64, 0, 65), (vec![64], exhausted(64)));
    // Whatever else fails comes back as it is.
    let fails = with_precision(8, 64, |_| Ok::<_, PadeError>(Err::<u32, _>(PadeError::PoleAtZero)));
    assert_eq!(fails, Err(PadeError::PoleAtZero));
    assert_eq!(with_precision::<u32, _>(8, 64, |_| Err(PadeError::PoleAtZero)), Err(PadeError::PoleAtZero));
}
