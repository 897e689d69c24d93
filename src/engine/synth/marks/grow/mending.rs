//! Continues the growth of a settled pattern after half-grown spots have been restarted: most of the spots that stay too low or too
//! small have begun too late.
//!
//! Lines that fade beside others are left as they are. Removing them, or raising them to their full height, makes the widths and
//! distances near drawn strokes worse (`facts.md` M).

use crate::grid::Domain;
use crate::synth::marks::grow::engine::Engine;
use crate::synth::marks::grow::half_grown::HalfGrown;
use crate::synth::marks::plan::laid_out::Plan;

impl Engine {
    /// Continues the growth with new starts of the `half`-grown spots. Returns their number: none for irregular spots, which are of
    /// different heights on purpose.
    pub fn grow_on_mended(&mut self, plan: &Plan, half: &HalfGrown) -> usize {
        if plan.lookup.irregular > 0.0 {
            return 0;
        }
        let again = self.nearest_places(&plan.lookup.all_to_cells(&half.spots));
        if !again.is_empty() {
            self.grow_on(&again, &again);
        }
        again.len()
    }

    /// The initial places of the spots nearest to `half`, cells.
    fn nearest_places(&self, half: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let places = self.varied.as_ref().map_or(&[][..], |spots| &spots.places);
        let nearest = |at: &[f64; 2]| {
            let away = |place: &[f64; 2]| {
                let way = self.maps.domain.displacement(*at, *place);
                way[0] * way[0] + way[1] * way[1]
            };
            places.iter().copied().min_by(|a, b| away(a).total_cmp(&away(b)))
        };
        let mut again: Vec<[f64; 2]> = half.iter().filter_map(nearest).collect();
        again.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
        again.dedup();
        again
    }
}
