use super::*;
use rug::Integer;

fn extent(peak: u32, reach: u32) -> Extent {
    Extent { peak, reach }
}

#[test]
fn extents_add_up() {
    let (a, b) = (extent(10, 7), extent(3, 50));
    assert_eq!((a.plus(4), a.times(b), a.or(b)), (extent(14, 11), extent(13, 57), extent(10, 50)));
    assert_eq!([a, b].map(Extent::bits), [7, 3]);
    // Bits of the weight, of the number of terms, and two to spare.
    for (weight, first, second, bits) in
        [(1, 1, 1, 3), (-1, 0, 5, 3), (8, 9, 4, 4 + 2 + 2), (i64::MIN, 3, 7, 64 + 1 + 2)]
    {
        assert_eq!(extent_of(weight, (first, a), (second, b)), extent(13 + bits, 57 + bits));
    }
}

/// By three bits for every two terms, down to 40 bits above the last.
#[test]
fn coefficients_fall_as_expected_down_to_the_noise() {
    let shop = Workshop::new(100, 0, (3, 2));
    assert_eq!([0, 1, 2, 5, 39, 40, 41, 1000].map(|j| shop.fall(j)), [0, 1, 3, 7, 58, 60, 60, 60]);
    let falling = [1u64 << 20, 1 << 19, 1 << 9].map(Integer::from);
    let falling = Fixed::from_integers(&falling, shop.width());
    assert_eq!(shop.extent(&falling), extent(21, 21));
    assert_eq!(shop.transform(&falling, 4, 1).times(&shop, 5).extent, extent(24, 24));
    assert_eq!(shop.transform(&falling, 4, 1).times(&shop, u32::MAX).extent, extent(53, 53));
}

/// A sum knows its extent, and has primes for it or says that it has not.
#[test]
fn sums_have_primes_for_their_extent_or_overflow() {
    let shop = Workshop::new(300, 0, (0, 1));
    let row = |bits: u32, count: usize| {
        shop.transform(&Fixed::from_integers(&[Integer::from(1) << (bits - 1)], shop.width()), 4, count)
    };
    let small = row(100, 2);
    for (terms, bits) in [(1, 203 + 2), (2, 203 + 3), (5, 203 + 4)] {
        let mut sum = shop.sum(&vec![(1, &small, &small); terms]);
        assert_eq!((sum.extent, sum.count), (extent(bits, bits), 1));
        assert!(shop.add(&mut sum, &vec![(1, &small, &small); terms]).is_some());
        assert_eq!(sum.extent, extent(bits + 1, bits + 1));
    }
    // A larger product decides, with its own number of terms.
    let larger = row(110, 2);
    for (terms, bits) in [(1, 223 + 1), (3, 223 + 2), (4, 223 + 3)] {
        let mut sum = shop.sum(&[(1, &small, &small)]);
        shop.add(&mut sum, &vec![(1, &larger, &larger); terms]).unwrap();
        assert_eq!(sum.extent, extent(bits + 1, bits + 1));
    }
    assert!(!shop.overflowed());
    // 396 bits fit into eight primes.
    let mut sum = shop.sum(&[(1, &small, &small)]);
    shop.set_extent(&mut sum, extent(capacity(1), 1000));
    assert!(!shop.overflowed());
    let large = row(192, 1);
    assert!(shop.add(&mut sum, &[(1, &large, &large)]).is_none());
    shop.set_extent(&mut sum, extent(capacity(1) + 1, 1000));
    assert!(shop.overflowed());
    // Too few primes of a factor: one group, where two are needed.
    let shop = Workshop::new(300, 0, (0, 1));
    shop.sum(&[(1, &row(196, 2), &row(196, 2))]);
    assert!(!shop.overflowed());
    shop.sum(&[(1, &row(196, 2), &row(196, 1))]);
    assert!(shop.overflowed());
}

#[test]
fn work_is_split_and_memory_is_kept_up_to_limits() {
    assert_eq!(
        [(100, 100), (101, 100), (100, 101), (1, 10_001)].map(|(n, each)| is_costly(n, each)),
        [false, true, true, true]
    );
    let shop = Workshop::new(300, 0, (0, 1));
    assert_eq!(shop.effort(), 15);
    for _ in 0..MOST_KEPT + 3 {
        shop.give_back(vec![Lanes::ONE; 5]);
    }
    assert_eq!(shop.used.lock().unwrap().len(), MOST_KEPT);
    assert_eq!(shop.memory(7).len(), 7);
    assert_eq!(shop.used.lock().unwrap().len(), MOST_KEPT - 1);
}
