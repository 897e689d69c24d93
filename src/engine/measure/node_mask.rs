//! Rows of nodes as bits, 64 in a word: whether each is above the level. Full and empty squares are skipped word by word.

use std::ops::Range;

use multiversion::multiversion;

/// Whether each node of a row is above `level`; bits beyond the row are 0.
#[multiversion(targets("x86_64+avx2"))]
pub(super) fn mask(values: &[f32], level: f32, words: &mut Vec<u64>) {
    // A byte for each, as eight and more values are compared at once.
    let word = |values: &[f32]| {
        let mut bytes = [0u8; 64];
        bytes.iter_mut().zip(values).for_each(|(byte, value)| *byte = u8::from(*value > level));
        let (eights, _) = bytes.as_chunks::<8>();
        eights.iter().rev().fold(0, |word, eight| word << 8 | packed(u64::from_le_bytes(*eight)))
    };
    words.clear();
    words.extend(values.chunks(64).map(word));
}

/// Converts eight bytes that are 0 or 1 to eight bits: the product moves bit 8 k to bit 56 + k, and no other bit into that byte.
fn packed(bytes: u64) -> u64 {
    bytes.wrapping_mul(0x0102_0408_1020_4080) >> 56
}

/// The runs of bits that are 1, from left to right.
pub(super) fn runs(mask: &[u64]) -> impl Iterator<Item = Range<usize>> {
    // Whether a run is open, and bits at which one begins or ends.
    let changes = move |word: usize| {
        let before = if word == 0 { 0 } else { mask[word - 1] >> 63 };
        mask.get(word).map_or(before, |bits| bits ^ (bits << 1 | before))
    };
    let (mut word, mut left) = (0, changes(0));
    let mut next = move || {
        while left == 0 {
            word += 1;
            if word > mask.len() {
                return None;
            }
            left = changes(word);
        }
        let bit = left.trailing_zeros() as usize;
        left &= left - 1;
        Some(64 * word + bit)
    };
    std::iter::from_fn(move || Some(next()?..next()?))
}

/// Squares between two rows of nodes, by the index of their left nodes.
pub(super) enum Squares {
    /// All four nodes of each are above the level.
    Full(Range<usize>),
    /// Some of the four nodes are above the level.
    Cut(usize),
}

/// A word of a mask shifted by one bit, with the first bit of the next word: bit k is node k + 1.
fn shifted(mask: &[u64], word: usize) -> u64 {
    mask[word] >> 1 | mask.get(word + 1).copied().unwrap_or(0) << 63
}

/// Calls `each` with the squares between rows of `nodes` nodes with the masks `above` and `below` that are not empty, from left
/// to right.
pub(super) fn squares(above: &[u64], below: &[u64], nodes: usize, mut each: impl FnMut(Squares)) {
    let within = |word: usize| {
        // No square begins with the last node of the row.
        let left = nodes - 1 - (64 * word).min(nodes - 1);
        if left >= 64 { u64::MAX } else { (1 << left) - 1 }
    };
    let mut full = None;
    for word in 0..below.len() {
        let four = [above[word], shifted(above, word), below[word], shifted(below, word)];
        let all = four.iter().fold(within(word), |all, bits| all & bits);
        let any = within(word) & four.iter().fold(0, |any, bits| any | bits);
        if all == u64::MAX {
            full.get_or_insert(64 * word);
            continue;
        }
        // Places where a run of full squares begins or ends, and squares that are neither full nor empty.
        let mut events = (all ^ (all << 1 | u64::from(full.is_some()))) | (any & !all);
        while events != 0 {
            let bit = events.trailing_zeros();
            events &= events - 1;
            let i = 64 * word + bit as usize;
            if all >> bit & 1 == 1 {
                full.get_or_insert(i);
                continue;
            }
            if let Some(from) = full.take() {
                each(Squares::Full(from..i));
            }
            if any >> bit & 1 == 1 {
                each(Squares::Cut(i));
            }
        }
    }
    if let Some(from) = full {
        each(Squares::Full(from..nodes - 1));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn squares_are_full_or_cut_as_their_nodes_are(
            rows in proptest::collection::vec((0.0..1.0_f32, 0.0..1.0_f32), 2..300), level in 0.05..0.95_f32,
        ) {
            let (above, below): (Vec<f32>, Vec<f32>) = rows.into_iter().unzip();
            let masks = [&above, &below].map(|row| {
                let mut words = Vec::new();
                mask(row, level, &mut words);
                words
            });
            let mut found = vec![0; above.len() - 1];
            let mut last = 0;
            squares(&masks[0], &masks[1], above.len(), |squares| {
                let (range, kind) = match squares {
                    Squares::Full(range) => (range, 2),
                    Squares::Cut(i) => (i..i + 1, 1),
                };
                assert!(last <= range.start && range.start < range.end);
                last = range.end;
                found[range].fill(kind);
            });
            for (i, found) in found.into_iter().enumerate() {
                let four = [above[i], above[i + 1], below[i], below[i + 1]];
                let inside = four.iter().filter(|value| **value > level).count();
                prop_assert_eq!(found, if inside == 4 { 2 } else { usize::from(inside > 0) });
            }
            let expected: Vec<usize> = (0..above.len()).filter(|i| above[*i] > level).collect();
            prop_assert_eq!(runs(&masks[0]).flatten().collect::<Vec<_>>(), expected);
            prop_assert!(runs(&masks[0]).zip(runs(&masks[0]).skip(1)).all(|(run, next)| run.end < next.start));
        }
    }
}
