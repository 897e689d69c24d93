//! Separation of merged spots in parts of the canvas. If only a few of many spots have merged, only the cells around them grow on,
//! and only these are measured again. The rest of the pattern has settled, and would not change.
//!
//! ```text
//!   ┌─────────────┐  cutout
//!   │ rim: frozen │
//!   │  ┌───────┐  │  The rim holds the spots that the sides cut, and surrounds what grows as the pattern did.
//!   │  │ grows │  │
//!   │  └───────┘  │
//!   └─────────────┘
//! ```

use rayon::prelude::*;

use crate::grid::{Bounds, Cutout, Domain, Field};
use crate::marks::Ellipse;
use crate::measure::{Spot, spots_of_at_least};
use crate::rd::{Growth, InitialConditions, restart};
use crate::synth::marks::grow::convergence::{ConvergenceMonitor, Verdict};
use crate::synth::marks::grow::engine::Engine;
use crate::synth::marks::grow::grid_level::unit;
use crate::synth::marks::grow::measured::{Measured, measured_size, spots_measured};
use crate::synth::marks::grow::pattern::Pattern;
use crate::synth::marks::plan::laid_out::Plan;
use crate::synth::passes::MergedSpots;
use crate::synth::pattern::EDGE;
use crate::synth::profile::{Section, during};

/// Distance from a changed spot, in spacings, within which cells grow on: up to the second ring of neighbours. Not tuned.
const FREE: f64 = 2.0;
/// Width of the rim, in spacings: more than the length of a spot.
const RIM: f64 = 1.5;
/// Largest share of the cells in cutouts; above it the whole pattern grows on.
const MOST: f64 = 0.25;

/// A part of the canvas that grows on.
pub struct Part {
    cutout: Cutout,
    /// The width of its rim, cells.
    rim: f64,
}

/// A part while it grows on.
struct GrowingPart {
    growth: Growth,
    monitor: ConvergenceMonitor,
    settled: bool,
}

impl Engine {
    /// The parts to grow on so that `merged` spots are separated; `None` if that is the whole pattern, or no part.
    #[must_use]
    pub fn parts_about(&self, merged: &MergedSpots) -> Option<Vec<Part>> {
        // Pinned spots are moved and corrected on the whole canvas only.
        let spots = self.varied.as_ref().filter(|_| self.position_control.is_none())?;
        // The spacing in the direction in which it is longest.
        let with_spacing = |index: &usize| {
            let at = spots.places[*index];
            let p = self.maps.at(at);
            (at, self.system.spacing(&p) / f64::from(p.stretch).sqrt())
        };
        let changed: Vec<([f64; 2], f64)> =
            merged.surplus.iter().chain(&merged.kept).map(with_spacing).collect();
        let about: Vec<([f64; 2], f64)> =
            changed.iter().map(|(at, spacing)| (*at, (FREE + RIM) * spacing)).collect();
        let cutouts = Cutout::about(&self.maps.domain, &about)?;
        let cells: usize = cutouts.iter().map(|cutout| cutout.grid.cells()).sum();
        if merged.surplus.is_empty() || cells as f64 > MOST * self.maps.domain.cells() as f64 {
            return None;
        }
        let part = |cutout: Cutout| {
            let inside = changed.iter().filter(|(at, _)| cutout.place(*at).is_some());
            Part { cutout, rim: RIM * inside.map(|(_, spacing)| *spacing).fold(f64::INFINITY, f64::min) }
        };
        Some(cutouts.into_iter().map(part).collect())
    }

    /// Removes the surplus spots of `merged`; the `parts` grow on from the initial state of the spots that are kept.
    #[must_use]
    pub fn begin_separation(&mut self, parts: Vec<Part>, plan: &Plan, merged: &MergedSpots) -> Separation {
        let Some(spots) = &mut self.varied else { return Separation { parts, growing: Vec::new() } };
        let again: Vec<[f64; 2]> =
            merged.surplus.iter().chain(&merged.kept).map(|index| spots.places[*index]).collect();
        during(Section::Parameters, || {
            spots.correct(plan, &merged.surplus, std::iter::empty(), &mut self.maps.parameters);
        });
        self.start = self.start.clone().with_places(&self.maps, &spots.places);
        let places = spots.places.clone();
        let begin = |part: &Part| self.begin(part, &places, &again);
        let growing = during(Section::Start, || parts.par_iter().map(begin).collect());
        Separation { parts, growing }
    }

    /// Puts the grown parts of a separation back into the pattern. Returns these parts.
    pub fn end_separation(&mut self, separation: Separation) -> Vec<Part> {
        let Separation { parts, growing } = separation;
        for (part, grown) in parts.iter().zip(&growing) {
            self.grid_level.growth.take(&part.cutout, &grown.growth);
            self.updates += grown.growth.steps() * part.cutout.grid.cells() as u64;
        }
        parts
    }

    /// A part with spots at `places`, cells of the whole grid, of which those `again` are restarted.
    fn begin(&self, part: &Part, places: &[[f64; 2]], again: &[[f64; 2]]) -> GrowingPart {
        let Part { cutout, rim } = part;
        let maps = self.maps.cut(cutout);
        let within = |places: &[[f64; 2]]| -> Vec<[f64; 2]> {
            places.iter().filter_map(|at| cutout.place(*at)).collect()
        };
        let (places, again) = (within(places), within(again));
        let stay: Vec<[f64; 2]> = places.iter().filter(|at| !again.contains(at)).copied().collect();
        let mut concentrations = self.grid_level.growth.concentrations_in(cutout);
        let start = InitialConditions::at_places(self.system, &maps, 0, &places);
        let afresh =
            |cells: &[usize], near: &dyn Fn([f64; 2], f64) -> bool| start.in_cells(&maps, cells, near);
        restart(self.system, &maps, &mut concentrations, [&again, &stay], afresh);
        let mut growth =
            Growth::resumed(self.system, &maps, concentrations).expect("made for this system on this grid");
        growth.freeze(|cell| cutout.distance_from_cut(cutout.grid.center(cell)) < *rim);
        let unit = unit(&growth, 1.0);
        let monitor = ConvergenceMonitor::new(self.system, unit, false, growth.marks().values);
        GrowingPart { growth, monitor, settled: false }
    }
}

/// Parts that grow on.
pub struct Separation {
    parts: Vec<Part>,
    growing: Vec<GrowingPart>,
}

impl Separation {
    /// Grows all parts on until their next check of convergence. Returns the number of cell updates; `None` = all have settled.
    pub fn advance(&mut self) -> Option<u64> {
        if self.growing.iter().all(|part| part.settled) {
            return None;
        }
        Some(during(Section::Steps, || self.growing.par_iter_mut().map(GrowingPart::advance).sum()))
    }
}

impl GrowingPart {
    /// Grows on until the next check of convergence. Returns the number of cell updates.
    fn advance(&mut self) -> u64 {
        let Self { growth, monitor, settled } = self;
        if *settled {
            return 0;
        }
        let steps = monitor.next_check().saturating_sub(growth.steps()).max(1);
        growth.advance(steps);
        let all = vec![true; growth.cells()];
        let verdict = monitor.check(growth.steps(), |marks| growth.update_marks(marks, &all));
        // A part that does not settle is shown as it is.
        *settled = verdict != Verdict::Forming;
        steps * growth.cells() as u64
    }
}

/// Measures spots of at least `least_area`, px², again in `parts`, which have grown on from `marks` in `engine`, and writes their
/// concentrations over `marks`.
pub fn remeasured(
    plan: &Plan,
    least_area: f64,
    pattern: &Pattern,
    parts: &[Part],
    engine: &Engine,
    marks: &mut Field,
    measured: Measured,
) -> Measured {
    let Measured::Spots { marks: mut spots, .. } = measured else { return measured };
    let grid = plan.lookup.grid.size;
    let canvas = plan.lookup.map.layout().size.map(|side| side as usize);
    let finer = measured_size(plan, canvas)[0] as f64 / grid[0] as f64;
    for Part { cutout, .. } in parts {
        let now = engine.marks_in(cutout);
        let [before, after] = [cutout.of(&marks.values), now.clone()].map(|marks| {
            let pattern = pattern.in_cutout(cutout, marks, finer);
            on_canvas(cutout, spots_of_at_least(&pattern, EDGE, least_area))
        });
        replace(&mut spots, &before, &after, plan.lookup.map.layout().bounds());
        cutout.replace(&mut marks.values, &now);
    }
    spots_measured(plan, spots)
}

/// The spots measured in a cutout that its sides do not cut, at their places on the canvas.
fn on_canvas(cutout: &Cutout, spots: Vec<Spot>) -> Vec<Spot> {
    let is_uncut = |spot: &Spot| {
        let center = cutout.grid.to_cells(spot.ellipse.center);
        let long = spot.ellipse.radii[0] / cutout.grid.px_a_cell();
        spot.whole || cutout.distance_from_cut(center) > LONGER * long
    };
    let moved = |spot: Spot| {
        let ellipse = Ellipse { center: cutout.to_canvas(spot.ellipse.center), ..spot.ellipse };
        Spot { ellipse, ..spot }
    };
    spots.into_iter().filter(is_uncut).map(moved).collect()
}

/// Largest distance of the end of a region from the centre of its ellipse, in radii.
const LONGER: f64 = 1.5;
/// Largest distance of the centres of two measurements of one spot, as a share of its radius.
const SAME: f64 = 0.1;
/// Largest distance of the centres, as a share of the radius, and largest relative difference of the areas, of a spot that has not
/// changed.
const UNCHANGED: f64 = 1e-3;

/// Replaces the spots that have changed from `before` to `after`.
fn replace(spots: &mut Vec<Spot>, before: &[Spot], after: &[Spot], canvas: Bounds) {
    let lasts = |spot: &&Spot, among: &[Spot]| {
        let alike = |other: &Spot| {
            is_at(spot, other, UNCHANGED, canvas)
                && (other.ellipse.area() / spot.ellipse.area() - 1.0).abs() < UNCHANGED
        };
        among.iter().any(alike)
    };
    let gone: Vec<&Spot> = before.iter().filter(|spot| !lasts(spot, after)).collect();
    spots.retain(|spot| !gone.iter().any(|gone| is_at(spot, gone, SAME, canvas)));
    spots.extend(after.iter().filter(|spot| !lasts(spot, before)));
}

/// Whether the centres of two spots are within this share of their radius of each other.
fn is_at(spot: &Spot, other: &Spot, share: f64, canvas: Bounds) -> bool {
    let away = [0, 1].map(|axis| spot.ellipse.center[axis] - other.ellipse.center[axis]);
    let away = canvas.shortest(away);
    let radius2 = spot.ellipse.radii[0] * spot.ellipse.radii[1];
    away[0] * away[0] + away[1] * away[1] < share * share * radius2
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Document;
    use crate::synth::drawn::sketch_targets;
    use crate::synth::marks::plan::{Begun, look_up};
    use crate::synth::training::Training;
    use crate::synth::watch::Watch;

    /// A canvas of spots of different areas, none of which is pinned.
    fn planned(edges: &str) -> Begun {
        let spot = |k: usize| {
            let (x, y, r) = (60 + 32 * (k % 3), 60 + 32 * (k / 3), 7 + k % 4);
            format!(r#"{{"kind": "ellipse", "center": [{x}, {y}], "radii": [{r}, {r}], "angle": 0}}"#)
        };
        let marks: Vec<String> = (0..9).map(spot).collect();
        let text = format!(
            r#"{{"format": "dapple", "version": 1, "size": [560, 560], "edges": "{edges}", "layers": [{{"strokes": [{}]}}]}}"#,
            marks.join(", ")
        );
        let document = Document::parse(&text, "spots").expect("a document");
        let map = sketch_targets::region_map(&document, 0, "spots").expect("spots");
        look_up(&Training::default(), document.layers[0].system, &map)
            .expect("parameters")
            .rough(Vec::new())
            .begin(3)
    }

    /// The spots of `marks`, measured on the whole pattern.
    fn measured(plan: &Plan, marks: &Field) -> Measured {
        let size = measured_size(plan, plan.lookup.map.layout().size.map(|side| side as usize));
        let pattern = Pattern::new(&plan.lookup, marks);
        let pattern = pattern.levelled(&pattern.concentration(size), size);
        spots_measured(plan, spots_of_at_least(&pattern, EDGE, f64::INFINITY))
    }

    #[test]
    fn a_surplus_spot_is_taken_away_where_it_is_and_the_spots_are_those_that_all_of_the_pattern_shows() {
        for edges in ["closed", "wrap"] {
            let begun = planned(edges);
            let mut engine = Engine::new(&begun, 3);
            let plan = begun.plan;
            assert!(engine.settle(&Watch::NONE).expect("not cancelled"));
            let places = engine.varied.as_ref().expect("they differ").places.clone();
            let grid = engine.maps.domain;
            // The spot nearest to the lower right corner, and its nearest neighbour.
            let apart = |a: [f64; 2], b: [f64; 2]| {
                let [x, y] = grid.displacement(a, b);
                x * x + y * y
            };
            let nearest = |to: [f64; 2], but: usize| {
                let others = (0..places.len()).filter(|index| *index != but);
                others.min_by(|a, b| apart(places[*a], to).total_cmp(&apart(places[*b], to))).expect("many")
            };
            let surplus = nearest([grid.size[0] as f64 - 8.0, grid.size[1] as f64 - 8.0], usize::MAX);
            let merged = MergedSpots {
                surplus: vec![surplus],
                kept: vec![nearest(places[surplus], surplus)],
                crowded: vec![],
            };
            let before = plan.levelled(engine.marks());
            let pattern = Pattern::new(&plan.lookup, &before);
            let parts = engine.parts_about(&merged).expect("a small part");
            let mut separation = engine.begin_separation(parts, &plan, &merged);
            while separation.advance().is_some() {}
            let parts = engine.end_separation(separation);
            let mut marks = before.clone();
            let all = measured(&plan, &before);
            let count = all.spots().len();
            let found = remeasured(&plan, f64::INFINITY, &pattern, &parts, &engine, &mut marks, all);
            assert_eq!(found.spots().len(), count - 1, "{edges}");
            let mut outside = vec![true; grid.cells()];
            parts.iter().flat_map(|part| part.cutout.cells()).for_each(|cell| outside[cell] = false);
            let same = marks.values.iter().zip(&before.values).map(|(now, before)| now == before);
            assert!(same.zip(&outside).all(|(same, outside)| same || !outside));
            // The result agrees with a measurement of the whole pattern.
            assert!(marks == plan.levelled(engine.marks()) && marks != before);
            let expected = measured(&plan, &marks);
            assert_eq!(expected.spots().len(), count - 1);
            let bounds = plan.lookup.map.layout().bounds();
            for spot in expected.spots() {
                let same = found.spots().iter().find(|other| is_at(spot, other, 0.01, bounds));
                let ratio = same.expect("at the same place").ellipse.area() / spot.ellipse.area();
                assert!((ratio - 1.0).abs() < 2e-3 && same.is_some_and(|same| same.whole == spot.whole));
            }
        }
    }
}
