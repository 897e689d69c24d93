//! The parameters of single spots.

use crate::rd::Parameters;
use crate::synth::marks::plan::laid_out::Plan;
use crate::synth::marks::plan::lattice::NodeOffset;
use crate::synth::marks::plan::one_spot::{deviating, room_of};
use crate::synth::marks::plan::spread::deviations::Scores;

/// The differences of the parameters of the spots at `places` (cells), and the parameters of their room.
pub fn own_of_all(
    plan: &Plan,
    places: &[[f64; 2]],
    pitch: &[f64],
    scores: &Scores,
) -> (Vec<NodeOffset>, Vec<Parameters>) {
    let lookup = &plan.lookup;
    let px = lookup.all_to_px(places);
    let pinned = plan.pinned_spots();
    let deviations = scores.deviations(plan, &px);
    let own = |(index, px): (usize, &[f64; 2])| match pinned.get(index) {
        Some(pinned) => {
            let room = room_of(lookup, pinned.drawn.center, pitch, pinned.offset);
            (pinned.offset, room)
        }
        None => {
            let offset = deviating(lookup, *px, &deviations[index]);
            (offset, room_of(lookup, *px, pitch, offset))
        }
    };
    px.iter().enumerate().map(own).unzip()
}
