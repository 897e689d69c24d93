//! Spots that begin again.

use super::found::{DrawnSpots, MergedSpots};

/// Which spots begin again, and what changes around them. Spots are numbered: the drawn ones first, then the others.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Restart {
    /// Whether the parameters of the drawn spots that differ, or are lost, are corrected by what was found.
    pub correct: bool,
    /// Drawn spots whose corrections are undone.
    pub undo: Vec<usize>,
    /// Spots that are taken away.
    pub away: Vec<usize>,
    /// Whether these are drawn ones, which are then left out.
    pub leave_out: bool,
    /// Spots that begin again at their places.
    pub again: Vec<usize>,
    /// Others that grow on in corrected parameters.
    pub changed: Vec<usize>,
}

impl Restart {
    /// How many spots it changes.
    #[must_use]
    pub fn count(&self) -> usize {
        self.away.len() + self.again.len() + self.changed.len()
    }

    /// Takes the surplus spots away that have grown together with another, which begins again.
    pub(super) fn separation(merged: &MergedSpots) -> Self {
        Self { away: merged.surplus.clone(), again: merged.kept.clone(), ..Self::default() }
    }

    /// Corrects the drawn spots that differ; the lost ones begin again.
    pub(super) fn correction(drawn: &DrawnSpots) -> Self {
        Self { correct: true, again: drawn.lost.clone(), changed: drawn.different.clone(), ..Self::default() }
    }

    /// Leaves out drawn spots that grow together with another one, whatever their parameters.
    pub(super) fn leaving_out(drawn: usize, merged: &MergedSpots) -> Self {
        let stays = |index: &&usize| **index < drawn && !merged.crowded.contains(index);
        let kept: Vec<usize> = merged.kept.iter().filter(stays).copied().collect();
        Self {
            undo: kept.clone(),
            away: merged.crowded.clone(),
            leave_out: true,
            again: kept,
            ..Self::default()
        }
    }
}
