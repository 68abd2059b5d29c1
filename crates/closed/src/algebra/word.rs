//! Words of letters, and what shuffles make of two of them.

use std::collections::BTreeMap;

/// Letters `j_1 j_2 ... j_r` of an iterated integral, the outermost first; `j` stands for the exponent `j s`.
pub(crate) type Word = Vec<u32>;

/// Returns every word that keeps the order within `left` and within `right`, with its multiplicity.
pub(crate) fn shuffle(left: &[u32], right: &[u32]) -> BTreeMap<Word, u64> {
    let mut words = BTreeMap::new();
    let mut place = vec![Vec::with_capacity(left.len() + right.len())];
    let mut done = 0;
    // Each prefix remembers by its length and content how much of either word is used; grow letter by letter.
    let mut used = vec![(0, 0)];
    while done < left.len() + right.len() {
        let (mut longer, mut next_used) = (Vec::new(), Vec::new());
        for (prefix, (l, r)) in place.into_iter().zip(used) {
            let mut grow = |letter: u32, used: (usize, usize)| {
                let mut word: Word = prefix.clone();
                word.push(letter);
                longer.push(word);
                next_used.push(used);
            };
            if l < left.len() {
                grow(left[l], (l + 1, r));
            }
            if r < right.len() {
                grow(right[r], (l, r + 1));
            }
        }
        (place, used) = (longer, next_used);
        done += 1;
    }
    for word in place {
        *words.entry(word).or_insert(0) += 1;
    }
    words
}

/// Returns the different words with the same letters as the sorted `letters`, in lexicographic order.
pub(crate) fn arrangements(letters: &[u32]) -> Vec<Word> {
    if letters.is_empty() {
        return vec![Vec::new()];
    }
    let mut words = Vec::new();
    for (i, &letter) in letters.iter().enumerate() {
        if i > 0 && letters[i - 1] == letter {
            continue;
        }
        let mut rest = letters.to_vec();
        rest.remove(i);
        for mut tail in arrangements(&rest) {
            tail.insert(0, letter);
            words.push(tail);
        }
    }
    words
}

/// The word read from its end.
pub(crate) fn reversed(word: &[u32]) -> Word {
    word.iter().rev().copied().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shuffles_count_all_interleavings() {
        let words = shuffle(&[1, 1], &[3]);
        assert_eq!(words, BTreeMap::from([(vec![1, 1, 3], 1), (vec![1, 3, 1], 1), (vec![3, 1, 1], 1)]));
        assert_eq!(shuffle(&[1], &[1, 1]), BTreeMap::from([(vec![1, 1, 1], 3)]));
        assert_eq!(arrangements(&[1, 1, 3]), [vec![1, 1, 3], vec![1, 3, 1], vec![3, 1, 1]]);
    }
}
