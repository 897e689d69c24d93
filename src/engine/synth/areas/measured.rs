//! Measurement of grown areas.

use crate::attributes::Attributes;
use crate::grid::Field;
use crate::measure::{Regions, Spot, Target, spot_errors, spot_raggedness_at, spots_of_at_least};
use crate::synth::areas::grown::GrownAreas;
use crate::synth::areas::plan::AreaPlan;

/// An area smaller than this share of the wanted area at its place is a speck: one patch in two hundred found room for no more.
const SPECK: f64 = 0.1;
/// The threshold of the edge.
pub(super) const EDGE: f32 = 0.5;

/// The areas that have grown as `field`, with their measurements.
pub(super) fn measured(plan: AreaPlan, field: Field) -> GrownAreas {
    let layout = *plan.map.layout();
    let least = plan.map.samples().iter().map(area).fold(f64::INFINITY, f64::min);
    let spots: Vec<Spot> = spots_of_at_least(&field, EDGE, SPECK * least);
    let errors = spot_errors(
        &spots,
        &Target {
            bounds: plan.canvas(),
            regions: Regions::Grid(&layout),
            covered: &|point| plan.is_taken(point),
            wanted: &|point| plan.asked(point),
            surface: None,
        },
    );
    let mut sums = vec![[0.0; 3]; layout.len()];
    for (center, got) in spot_raggedness_at(&field, EDGE) {
        let [count, asked, found] = &mut sums[layout.index(layout.region_of(center))];
        *count += 1.0;
        *asked += plan.wanted(center).raggedness;
        *found += got;
    }
    let mean = |[count, asked, found]: [f64; 3]| (count > 0.0).then(|| [asked / count, found / count]);
    let raggedness = sums.into_iter().map(mean).collect();
    GrownAreas {
        plan,
        field,
        rosettes: None,
        cramped: 0,
        steps: 0,
        gap: None,
        own_polygons: None,
        spots,
        errors,
        raggedness,
    }
}

fn area(wanted: &Attributes) -> f64 {
    if let Attributes::Spots(spots) = wanted { spots.area } else { f64::INFINITY }
}
