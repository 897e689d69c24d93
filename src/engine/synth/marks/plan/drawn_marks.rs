//! The lookup of a layer with drawn marks that stay where they were drawn.
//!
//! ```text
//!  lookup, marks ─▶ drawn spots ─▶ those that can stand ─▶ drawn spots among these ─▶ lookup with pinned marks
//! ```

use crate::marks::{Ellipse, Mark};
use crate::synth::error::PlanError;
use crate::synth::marks::plan::answers::Ask;
use crate::synth::marks::plan::drawn_spots::{Around, DrawnSpot, drawn_spots};
use crate::synth::marks::plan::layer_lookup::{Lookup, Start};
use crate::synth::marks::plan::offset::Offset;
use crate::synth::marks::plan::pinned_marks::pin_spots;
use crate::synth::training::Training;

impl Lookup {
    /// This lookup with marks that stay where they were drawn, px.
    ///
    /// # Errors
    /// The training set cannot be read, or does not take such attributes.
    pub fn with_pinned(self, training: &Training, marks: &[Mark]) -> Result<Self, PlanError> {
        let lines = marks.iter().filter_map(Mark::path).collect();
        let ellipses = marks.iter().enumerate().filter_map(|(index, mark)| Some((index, mark.ellipse()?)));
        let spots = self.drawn_spots(training, &ellipses.collect::<Vec<_>>(), &|_| Offset::default())?;
        Ok(Self { start: Start::Free { spots, lines }, ..self })
    }

    /// Looks up drawn spots one by one; `offset` is subtracted from the questions. Spots that are too near to others to grow take
    /// no room from them.
    pub(super) fn drawn_spots(
        &self,
        training: &Training,
        ellipses: &[(usize, Ellipse)],
        offset: &dyn Fn([f64; 2]) -> Offset,
    ) -> Result<Vec<DrawnSpot>, PlanError> {
        let around = Around {
            bounds: self.map.layout().bounds(),
            cell: self.px_a_cell(),
            wanted: &|point| self.spots_at(point),
            offset,
        };
        let answers = self.answers_of(training);
        let ask: Ask = &|wanted, cell| answers.ask(self.system, wanted, cell);
        let all = drawn_spots(ellipses, ellipses, &around, ask)?;
        let (pinned, left_out) = pin_spots(self, &[], &all);
        if left_out.is_empty() {
            return Ok(all);
        }
        let standing: Vec<(usize, Ellipse)> =
            pinned.iter().map(|pinned| (pinned.mark, pinned.drawn)).collect();
        drawn_spots(ellipses, &standing, &around, ask)
    }
}
