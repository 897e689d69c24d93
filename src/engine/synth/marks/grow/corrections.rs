//! Corrections of a plan during its growth; the plan itself does not change.

use crate::rd::Hindrance;
use crate::synth::marks::plan::Plan;
use crate::synth::marks::plan::lattice::NodeOffset;
use crate::synth::marks::plan::pinned_marks::{LeftOut, PinnedMark};

/// The largest corrections: of ln rate, of each component of the shape, of ln ratio.
const MOST: NodeOffset = [1.2, 0.6, 0.6, 0.7];

/// The drawn spots that a growth holds at their places, the corrections of their parameters, and the spots that it has left out.
#[derive(Clone, Debug, Default)]
pub struct Corrections {
    pinned: Vec<PinnedMark>,
    /// The correction that is added to the offset of each spot.
    added: Vec<NodeOffset>,
    left_out: Vec<LeftOut>,
}

impl Corrections {
    /// No corrections: the drawn spots of `plan` as they were planned.
    #[must_use]
    pub fn none(plan: &Plan) -> Self {
        let pinned = plan.pinned_spots().to_vec();
        Self { added: vec![NodeOffset::default(); pinned.len()], pinned, left_out: plan.left_out().to_vec() }
    }

    /// The spots that stay where they were drawn.
    #[must_use]
    pub fn pinned_spots(&self) -> &[PinnedMark] {
        &self.pinned
    }

    /// The drawn spots that find no room.
    #[must_use]
    pub fn left_out(&self) -> &[LeftOut] {
        &self.left_out
    }

    /// Difference between the parameters of each pinned spot and those looked up for its place.
    pub fn offsets(&self) -> impl Iterator<Item = NodeOffset> {
        let sum = |(mark, added): (&PinnedMark, &NodeOffset)| {
            [0, 1, 2, 3].map(|part: usize| mark.offset[part] + added[part])
        };
        self.pinned.iter().zip(&self.added).map(sum)
    }

    /// Least area of a spot, px²; smaller ones are specks. It is a quarter of the visible area of the smallest drawn spot. A spot
    /// that has shrunk to a third of its area is to be corrected, not taken for missing.
    #[must_use]
    pub fn least_area(&self) -> f64 {
        let areas = self.pinned.iter().map(|mark| mark.visible.area);
        0.25 * areas.fold(f64::INFINITY, f64::min)
    }

    /// Adds to the corrections of all pinned spots.
    pub fn add(&mut self, added: &[NodeOffset]) {
        for (correction, added) in self.added.iter_mut().zip(added) {
            for (part, added) in added.iter().enumerate() {
                correction[part] = (correction[part] + added).clamp(-MOST[part], MOST[part]);
            }
        }
    }

    /// Undoes the corrections of these pinned spots, by their indices.
    pub fn undo(&mut self, pinned: &[usize]) {
        pinned.iter().for_each(|index| self.added[*index] = NodeOffset::default());
    }

    /// Leaves the pinned spots `crowded` out, by their indices.
    pub fn leave_out(&mut self, crowded: &[usize]) {
        let out = crowded.iter().map(|index| &self.pinned[*index]);
        self.left_out.extend(out.map(|mark| LeftOut {
            mark: mark.mark,
            drawn: mark.drawn,
            reason: Hindrance::Neighbour,
        }));
        let stays = |index: usize| !crowded.contains(&index);
        let mut index = 0..;
        self.pinned.retain(|_| index.next().is_some_and(stays));
        let mut index = 0..;
        self.added.retain(|_| index.next().is_some_and(stays));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::marks::Ellipse;
    use crate::synth::marks::plan::visible_part::VisiblePart;

    fn three() -> Corrections {
        let drawn = |x: f64| Ellipse { center: [x, 50.0], radii: [8.0, 6.0], angle: 0.0 };
        let layout = crate::attributes::regions::RegionGrid {
            size: [200.0, 100.0],
            grid: [1, 1],
            edges: crate::grid::Edges::Closed,
        };
        let mark = |mark: usize| {
            let drawn = drawn(40.0 * (mark + 1) as f64);
            PinnedMark {
                mark,
                drawn,
                visible: VisiblePart::new(&drawn, &layout),
                offset: [0.1, 0.0, 0.0, 0.0],
            }
        };
        Corrections { pinned: (0..3).map(mark).collect(), added: vec![[0.0; 4]; 3], left_out: vec![] }
    }

    #[test]
    fn corrections_are_added_to_what_was_planned_up_to_a_bound_and_undone() {
        let mut corrections = three();
        corrections.add(&[[0.5, 0.0, 0.0, 0.0], [0.0, 9.0, 0.0, 0.0], [0.0; 4]]);
        let offsets: Vec<NodeOffset> = corrections.offsets().collect();
        assert_eq!(offsets, [[0.6, 0.0, 0.0, 0.0], [0.1, MOST[1], 0.0, 0.0], [0.1, 0.0, 0.0, 0.0]]);
        corrections.undo(&[0]);
        assert_eq!(corrections.offsets().next(), Some([0.1, 0.0, 0.0, 0.0]));
    }

    #[test]
    fn a_spot_that_is_left_out_takes_its_correction_with_it() {
        let mut corrections = three();
        corrections.add(&[[0.0; 4], [0.2, 0.0, 0.0, 0.0], [0.3, 0.0, 0.0, 0.0]]);
        corrections.leave_out(&[1]);
        assert_eq!(corrections.pinned_spots().iter().map(|mark| mark.mark).collect::<Vec<_>>(), [0, 2]);
        assert_eq!(corrections.offsets().map(|offset| offset[0]).collect::<Vec<_>>(), [0.1, 0.4]);
        assert_eq!(corrections.left_out()[0].mark, 1);
    }
}
