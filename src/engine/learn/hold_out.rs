//! Hold-out split: rows to learn from, and rows to predict.

use crate::learn::Row;

/// Rows to learn from, and rows that are held out of them.
#[derive(Clone, Debug)]
pub struct Fold {
    /// To learn from.
    pub rows: Vec<Row>,
    /// Whether these are all rows except those held out.
    pub all: bool,
    /// The rows to predict, equal in all folds.
    pub questions: Vec<Row>,
}

/// `count` of `rows` at even steps, so that each part of a sweep is represented; all if there are fewer.
#[must_use]
pub fn evenly(rows: &[Row], count: usize) -> Vec<Row> {
    let count = count.min(rows.len());
    (0..count).map(|i| rows[i * rows.len() / count]).collect()
}

/// One split for each of `sizes` that is smaller than the number of rows to learn from, and one with all of these. A fifth of
/// `rows`, but at most `questions`, is held out. Rows are taken at even steps.
#[must_use]
pub fn folds(rows: &[Row], sizes: &[usize], questions: usize) -> Vec<Fold> {
    let count = questions.min(rows.len() / 5).max(1);
    let asked = |i: usize| (i * count + count / 2) / rows.len() != ((i + 1) * count + count / 2) / rows.len();
    let part = |of: bool| -> Vec<Row> {
        rows.iter().enumerate().filter(|(i, _)| asked(*i) == of).map(|(_, row)| *row).collect()
    };
    let (questions, others) = (part(true), part(false));
    let some = sizes.iter().filter(|size| **size < others.len()).map(|size| (evenly(&others, *size), false));
    let all = std::iter::once((others.clone(), true));
    some.chain(all).map(|(rows, all)| Fold { rows, all, questions: questions.clone() }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::learn::laws::{MEASURED, turing};

    #[test]
    fn no_row_is_both_learnt_from_and_held_out() {
        let rows = turing(503, MEASURED);
        let folds = folds(&rows, &[30, 100, 300, 1_000], 40);
        assert_eq!(folds.iter().map(|fold| fold.rows.len()).collect::<Vec<_>>(), [30, 100, 300, 463]);
        for fold in &folds {
            assert_eq!(fold.questions.len(), 40);
            assert_eq!(fold.questions, folds[0].questions);
            let seeds: Vec<u64> = fold.rows.iter().map(|row| row.seed).collect();
            assert!(fold.questions.iter().all(|row| !seeds.contains(&row.seed)));
            assert!(seeds.is_sorted_by(|a, b| a < b), "each once");
            assert_eq!(fold.all, fold.rows.len() == 463);
        }
    }

    #[test]
    fn rows_are_taken_evenly() {
        let rows = turing(100, MEASURED);
        let seeds: Vec<u64> = evenly(&rows, 4).iter().map(|row| row.seed).collect();
        assert_eq!(seeds, [0, 25, 50, 75]);
        assert_eq!(evenly(&rows, 1_000).len(), 100);
        let questions = &folds(&rows, &[], 10)[0].questions;
        assert!(questions.windows(2).all(|pair| (9..=11).contains(&(pair[1].seed - pair[0].seed))));
    }

    #[test]
    fn few_rows_keep_four_fifths_to_learn_from() {
        let folds = folds(&turing(50, MEASURED), &[30], 200);
        assert_eq!((folds[1].rows.len(), folds[1].questions.len()), (40, 10));
    }
}
