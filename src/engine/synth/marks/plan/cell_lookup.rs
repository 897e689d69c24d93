//! Parameters of the cells of any domain, looked up for each of them.
//!
//! The map of a flat canvas is looked up on a lattice instead, since its attributes are bilinear between regions.

use crate::attributes::Attributes;
use crate::grid::Domain;
use crate::rd::ParameterField;
use crate::synth::error::PlanError;
use crate::synth::marks::plan::lattice::Node;
use crate::synth::marks::plan::lookup::Ask;

/// Maps of `domain` whose cells have the parameters that `ask` gives for the attributes `wanted` at their centres. These
/// are in px, of which a cell has `cell` along a mean side; their angles are in the frames of the cells.
///
/// # Errors
/// Those of `ask`.
pub fn look_up_cells<D: Domain>(
    domain: D,
    cell: f64,
    wanted: impl Fn(D::Place) -> Attributes + Sync,
    ask: Ask,
) -> Result<ParameterField<D>, PlanError> {
    ParameterField::by_place(domain, |place| {
        Ok(Node::from_setting(&ask(&wanted(place), cell)?.setting()).parameters(1.0))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::attributes::regions::RegionMap;
    use crate::grid::relabelled::Relabelled;
    use crate::grid::{Edges, Grid};
    use crate::marks::{Ellipse, Mark};
    use crate::rd::System;
    use crate::synth::marks::plan::lookup;
    use crate::synth::training::Training;

    #[test]
    fn the_same_attributes_give_the_same_parameters_on_any_domain() {
        let spot = |x: f64, radii, angle| Mark::Ellipse(Ellipse { center: [x, 20.0], radii, angle });
        let marks = [spot(20.0, [5.0, 3.0], 10.0), spot(80.0, [7.0, 6.0], 60.0)];
        let mut map = RegionMap::from_marks(&marks, [100.0, 40.0], [2, 1], Edges::Wrap).expect("spots");
        map.fill_free_spacing(|spots| 3.0 * spots.area.sqrt());
        let system = System::MEINHARDT_SPOTS;
        let ask = |wanted: &Attributes, cell| lookup::ask(Training::built_in(), system, wanted, cell);
        let grid = Grid { size: [25, 10], cell: [4.0; 2], edges: Edges::Wrap };
        let flat = look_up_cells(grid, 4.0, |place| map.at(grid.to_px(place)), &ask).expect("in range");
        let shuffled = Relabelled::new(grid, &[], |_| 0.0);
        let other =
            look_up_cells(shuffled, 4.0, |place| map.at(grid.to_px(place.0)), &ask).expect("in range");
        assert!(other.domain.renumbered(&flat.parameters) == other.parameters);
        // Cells beside the middles of the regions have what is asked for at their centres.
        for (place, direction) in [([26.0, 22.0], 10.0), ([74.0, 22.0], 60.0)] {
            let wanted =
                Node::from_setting(&ask(&map.at(place), 4.0).expect("in range").setting()).parameters(1.0);
            let found = flat.at(grid.to_cells(place));
            assert!((found.rate / wanted.rate - 1.0).abs() < 1e-5, "{found:?} {wanted:?}");
            assert!((found.direction - wanted.direction).abs() < 1e-3, "{found:?} {wanted:?}");
            assert!((found.direction - direction).abs() < 8.0, "{found:?}");
        }
        assert!(flat.parameters.iter().any(|p| p != &flat.parameters[0]));
    }
}
