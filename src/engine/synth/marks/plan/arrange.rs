//! Transition from the third to the last stage of a plan: the starting places of the marks of a layer among the marks beneath.

use crate::grid::Domain;
use crate::marks::Path;
use crate::measure::Spot;
use crate::rd::LinesAlongCurves;
use crate::synth::error::{LayOutError, PlanError};
use crate::synth::marks::plan::corrected::Corrected;
use crate::synth::marks::plan::drawn_spots::DrawnSpot;
use crate::synth::marks::plan::inside::places_inside;
use crate::synth::marks::plan::laid_out::{Arrangement, Plan};
use crate::synth::marks::plan::layer_lookup::{Lookup, Start};
use crate::synth::marks::plan::obstacle_mask::{ground_rim, has_room, with_rim};
use crate::synth::marks::plan::offset::Offset;
use crate::synth::marks::plan::offset_curves::{CurveKind, CurveRequest, Curves, line_widths};
use crate::synth::marks::plan::pinned_marks::pin_spots;
use crate::synth::training::Training;

/// The grown surroundings of a layer.
#[derive(Clone, Debug, Default)]
pub struct Surroundings<'a> {
    /// Cells of the layer's grid that marks beneath have taken; empty = none.
    pub obstacles: Vec<bool>,
    /// Spots of the next layer beneath: the places of a layer that stands inside it.
    pub spots: &'a [Spot],
}

impl Corrected {
    /// Determines where the marks begin; `seed` determines where open rings have their gaps.
    ///
    /// # Errors
    /// The marks beneath leave no room, or lines find no marks to run around.
    pub fn lay_out(self, surroundings: Surroundings, seed: u64) -> Result<Plan, LayOutError> {
        let Self { mut lookup, corrections } = self;
        let Surroundings { mut obstacles, spots } = surroundings;
        let arrangement = match &lookup.start {
            Start::Curves { kind, laws, broken } => {
                let curves = lay_curves(&lookup, &obstacles, (*kind, *laws), *broken, seed)?;
                for remarks in &mut lookup.remarks {
                    remarks.extend(curves.remarks.iter().cloned());
                }
                Arrangement::Curves(curves)
            }
            Start::Inside => Arrangement::Inside(places_inside(&lookup, spots)),
            Start::Free { spots, lines } => {
                if lookup.system.is_striped() && !obstacles.is_empty() {
                    if !has_room(&lookup, &obstacles) {
                        return Err(LayOutError::NoRoom);
                    }
                    obstacles = with_rim(&obstacles, &lookup.grid);
                }
                arrange_pinned(&lookup, &obstacles, spots, lines)
            }
        };
        let rim = ground_rim(&lookup, &obstacles);
        Ok(Plan { lookup, corrections, obstacles, rim, arrangement })
    }
}

impl Lookup {
    /// A rough plan for estimates and previews: nothing is corrected, and marks begin where the system puts them between the
    /// `obstacles`.
    #[must_use]
    pub fn rough(self, obstacles: Vec<bool>) -> Plan {
        let Corrected { lookup, corrections } = self.uncorrected();
        let rim = ground_rim(&lookup, &obstacles);
        Plan { lookup, corrections, obstacles, rim, arrangement: Arrangement::Natural }
    }
}

impl Plan {
    /// A plan with the error `found` in each region subtracted from its question.
    ///
    /// # Errors
    /// The training set cannot be read.
    pub fn less(&self, training: &Training, found: &[Offset]) -> Result<Self, PlanError> {
        let Self { lookup, corrections, obstacles, rim, arrangement } = self.clone();
        let Corrected { lookup, corrections } = Corrected { lookup, corrections }.less(training, found)?;
        let arrangement = match &lookup.start {
            Start::Free { spots, lines } => arrange_pinned(&lookup, &obstacles, spots, lines),
            Start::Inside | Start::Curves { .. } => arrangement,
        };
        Ok(Self { lookup, corrections, obstacles, rim, arrangement })
    }
}

/// Arranges a layer whose drawn marks stay where they were drawn, if they find room.
fn arrange_pinned(lookup: &Lookup, obstacles: &[bool], spots: &[DrawnSpot], lines: &[Path]) -> Arrangement {
    if !spots.is_empty() {
        let (spots, left_out) = pin_spots(lookup, obstacles, spots);
        return Arrangement::PinnedSpots { spots, left_out };
    }
    if lines.is_empty() { Arrangement::Natural } else { Arrangement::PinnedLines(lines.to_vec()) }
}

fn lay_curves(
    lookup: &Lookup,
    obstacles: &[bool],
    (kind, laws): (CurveKind, LinesAlongCurves),
    broken: f64,
    seed: u64,
) -> Result<Curves, LayOutError> {
    let grid = lookup.grid;
    let nothing = vec![false; grid.cells()];
    let obstacles = if obstacles.is_empty() { &nothing } else { obstacles };
    let width = line_widths(&lookup.map, &grid);
    let layout = *lookup.map.layout();
    let region_of = |point| layout.index(layout.region_of(point));
    let request = CurveRequest { kind, laws, obstacles, width: &width, broken, seed };
    Ok(Curves::lay(&request, &grid, layout.len(), &region_of)?)
}
