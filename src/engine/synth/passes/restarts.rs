//! Restarts of spots.

use super::found::{DrawnSpots, MergedSpots};

/// The spots that are restarted, and the changes around them. Spots are numbered: the drawn ones first, then the others.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Restart {
    /// Whether the parameters of drawn spots that are lost or have errors are corrected.
    pub correct: bool,
    /// Drawn spots whose corrections are undone.
    pub undo: Vec<usize>,
    /// Spots that are removed.
    pub away: Vec<usize>,
    /// Whether these are drawn spots, which are then left out.
    pub leave_out: bool,
    /// Spots that are restarted at their places.
    pub again: Vec<usize>,
    /// Other spots that continue with corrected parameters.
    pub changed: Vec<usize>,
}

impl Restart {
    /// Number of spots that it changes.
    #[must_use]
    pub fn count(&self) -> usize {
        self.away.len() + self.again.len() + self.changed.len()
    }

    /// Removes the surplus of merged spots, and restarts those that are kept.
    pub(super) fn separation(merged: &MergedSpots) -> Self {
        Self { away: merged.surplus.clone(), again: merged.kept.clone(), ..Self::default() }
    }

    /// Corrects the drawn spots with errors, and restarts the lost ones.
    pub(super) fn correction(drawn: &DrawnSpots) -> Self {
        Self { correct: true, again: drawn.lost.clone(), changed: drawn.different.clone(), ..Self::default() }
    }

    /// Leaves out drawn spots that merge with another one with any parameters.
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
