//! Growing on from a settled pattern without the marks that have grown by half.
//!
//! Lines stay where they begin. Where one is too close to its neighbours it fades for long, more slowly than is worth waiting for:
//! from T = 15 to 40 half of such pieces vanish, and as many others have begun to fade. They are taken away at once, and the lines beside
//! them take their room. Raised to their full height they fade again. Spots begin again: most of those that stayed too low have only begun
//! too late.

use crate::grid::Domain;
use crate::measure::FadedAxis;
use crate::synth::marks::grow::engine::Engine;
use crate::synth::marks::grow::half_grown::HalfGrown;
use crate::synth::marks::plan::laid_out::Plan;

/// Up to this distance from the axis of a faded line, widths, nothing is left of it; at twice the distance all.
const GONE: f64 = 0.35;
/// Lines nearer to a drawn stroke than this, periods, stay: its own, and the gaps beside it.
const KEPT: f64 = 0.75;

impl Engine {
    /// Goes on growing without the lines that have faded, and with new beginnings of spots that have grown by `half`. Returns whether there
    /// is something to mend: irregular spots are of all heights, and lines of other systems come back where they were.
    pub fn grow_on_mended(&mut self, plan: &Plan, half: &HalfGrown) -> bool {
        if plan.lookup.irregular > 0.0 {
            return false;
        }
        let again = self.nearest_places(&plan.lookup.all_to_cells(&half.spots));
        if !again.is_empty() {
            self.grow_on(&again, &again);
            return true;
        }
        // Of these systems alone marks stay where they begin.
        if self.system.definition().along_curves.is_none() || plan.curves().is_some() {
            return false;
        }
        let faded: Vec<&FadedAxis> = half.lines.iter().filter(|line| !is_drawn(plan, line)).collect();
        if !faded.is_empty() {
            self.take_away(plan, &faded);
        }
        !faded.is_empty()
    }

    /// The places of the spots nearest to `half`, cells.
    fn nearest_places(&self, half: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let places = self.varied.as_ref().map_or(&[][..], |spots| &spots.places);
        let nearest = |at: &[f64; 2]| {
            let away = |place: &[f64; 2]| {
                let way = self.maps.domain.way(*at, *place);
                way[0] * way[0] + way[1] * way[1]
            };
            places.iter().copied().min_by(|a, b| away(a).total_cmp(&away(b)))
        };
        let mut again: Vec<[f64; 2]> = half.iter().filter_map(nearest).collect();
        again.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
        again.dedup();
        again
    }

    /// Goes on growing with ground in place of these lines.
    fn take_away(&mut self, plan: &Plan, faded: &[&FadedAxis]) {
        let (domain, grid) = (&self.maps.domain, &plan.lookup.grid);
        let mut gone = vec![0.0f32; domain.cells()];
        for line in faded {
            let width = plan.lines_at(line.at).map_or(0.0, |lines| lines.width) / grid.px_a_cell();
            for axis in &line.cells {
                let at = grid.to_cells(grid.center_px(*axis));
                for (cell, way) in domain.near(at, 2.0 * GONE * width, 0..domain.cells()) {
                    let distance = libm::hypot(way[0], way[1]) / (GONE * width);
                    gone[cell] = gone[cell].max((2.0 - distance).clamp(0.0, 1.0) as f32);
                }
            }
        }
        let mut concentrations = self.level.growth.concentrations();
        for (chemical, ground) in concentrations.iter_mut().zip(self.system.definition().obstacle) {
            chemical.iter_mut().zip(&gone).for_each(|(value, gone)| *value += gone * (ground - *value));
        }
        let changed: Vec<[f64; 2]> = faded.iter().map(|line| grid.to_cells(line.at)).collect();
        self.grow_on_from(concentrations, &changed);
    }
}

/// Whether a faded line is that of a drawn stroke, or the gap beside it.
fn is_drawn(plan: &Plan, line: &FadedAxis) -> bool {
    let Some(lines) = plan.lines_at(line.at) else { return false };
    let near = KEPT * lines.wavelength.unwrap_or(2.0 * lines.width);
    let (grid, bounds) = (&plan.lookup.grid, plan.lookup.map.layout().bounds());
    let is_near = |cell: &usize| {
        let at = grid.center_px(*cell);
        plan.pinned_lines().iter().any(|stroke| {
            // The image of the place that is nearest to the stroke.
            let middle = stroke.center();
            let way = bounds.shortest([0, 1].map(|axis| at[axis] - middle[axis]));
            stroke.distance_to([0, 1].map(|axis| middle[axis] + way[axis])) < near
        })
    };
    line.cells.iter().any(is_near)
}
