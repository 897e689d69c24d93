//! Accuracy with which held-out rows are predicted from the others.

use super::pair_set::{PairRow, PairSet};
use crate::learn::TrainingError;

/// The errors of one answered quantity, over all questions.
#[derive(Clone, Debug, PartialEq)]
pub struct HeldOut {
    /// The quantity: a column.
    pub answered: &'static str,
    /// Relative |errors| in the order of the questions, for each method in the order of [`Self::WAYS`].
    pub errors: [Vec<f64>; 3],
}

impl HeldOut {
    /// The methods, in the order of the errors.
    pub const WAYS: [&'static str; 3] = ["law alone", "nearest neighbour", "LWR"];
}

/// Asks every `one_of`-th row of `set` of a set of the other rows.
///
/// # Errors
/// Too few others.
pub fn held_out(set: &PairSet, one_of: usize) -> Result<Vec<HeldOut>, TrainingError> {
    let is_asked = |index: usize| index % one_of == one_of / 2;
    let part = |of: bool| -> Vec<PairRow> {
        let rows = set.rows().iter().enumerate().filter(|(index, _)| is_asked(*index) == of);
        rows.map(|(_, row)| row.clone()).collect()
    };
    let Some(others) = PairSet::from_rows(set.system(), part(false))? else { return Ok(Vec::new()) };
    let mut all: Vec<HeldOut> = set
        .answered()
        .map(|answered| HeldOut { answered, errors: [Vec::new(), Vec::new(), Vec::new()] })
        .collect();
    for row in part(true) {
        let directions = set.value(&row, "directions") as usize;
        let question: Vec<f64> = set.asked().map(|name| set.value(&row, name)).collect();
        let learnt = others.ask(directions, &question).values;
        let nearest = others.nearest(directions, &question).unwrap_or_default();
        for (index, of) in all.iter_mut().enumerate() {
            let wanted = set.value(&row, of.answered);
            let error = |got: f64| (got / wanted - 1.0).abs();
            // The law has no factor; its threshold is the value at which the reaction is one half.
            of.errors[0].push(error(1.0));
            of.errors[1].extend(nearest.get(index).map(|got| error(*got)));
            of.errors[2].push(error(learnt[index]));
        }
    }
    Ok(all)
}
