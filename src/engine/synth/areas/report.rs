//! The report of patches and cells: what was asked for, and what grew.

use crate::attributes::{Attribute, Attributes, Polarity};
use crate::document::AreaKind;
use crate::grid::{Field, PointBuckets};
use crate::measure::Spot;
use crate::points::extent::Extent;
use crate::points::patches::{Outline, Wanted};
use crate::synth::areas::grown::GrownAreas;
use crate::synth::areas::grown::OwnPolygons;
use crate::synth::areas::plan::{AreaForm, AreaPlan};
use crate::synth::report::drawn::{self, DrawnMark, attributes_of};
use crate::synth::report::pinned;
use crate::synth::report::{RaggednessReport, RegionReport, WidthReport};

/// A drawn mark counts as grown if it overlaps with the grown area by at least this intersection ÷ union. Among other patches
/// ragged outlines reach 0.93–0.97, less if they overlap each other.
const THERE: f64 = 0.85;
/// A grown area is the drawn mark alone if the logarithms of the areas differ by less than this.
const OWN: f64 = 0.4;
/// Distance from a drawn mark, in √area of the mark, up to which the grown pattern counts as its own.
const BESIDE: f64 = 0.2;

/// The report of each region of grown areas, row by row; `drawn` tells how each drawn mark has grown.
#[must_use]
pub fn area_regions(layer: &GrownAreas, drawn: &[DrawnMark]) -> Vec<RegionReport> {
    let plan = &layer.plan;
    let layout = plan.map.layout();
    // Marks that have not grown count as lost, even if an area is near.
    let counted = drawn.iter().map(|mark| DrawnMark { off: mark.off.filter(|_| mark.there), ..mark.clone() });
    let stayed = pinned::stayed(&plan.map, &counted.collect::<Vec<_>>(), false);
    let by_region = drawn::by_region(drawn, layout);
    let region = |index: usize| {
        let place = layout.place(index);
        let (asked, errors) = (plan.wanted(layout.center(place)), &layer.errors[index]);
        let is_ragged = plan.kind() == AreaKind::Patches;
        let raggedness = is_ragged.then(|| RaggednessReport {
            asked: layer.raggedness[index].map_or(asked.raggedness, |[asked, _]| asked),
            got: layer.raggedness[index].map(|[_, got]| got),
        });
        let named = [
            (Attribute::Area, errors.area),
            (Attribute::Aspect, errors.aspect),
            (Attribute::Angle, errors.angle),
            (Attribute::Spacing, errors.spacing),
        ];
        let mut error: Vec<(Attribute, f64)> =
            named.into_iter().filter_map(|(attribute, value)| Some((attribute, value?))).collect();
        let ragged = raggedness.as_ref();
        error.extend(ragged.and_then(|of| Some((Attribute::Raggedness, of.got? / of.asked - 1.0))));
        let mut notes = if index == 0 { layer_notes(layer) } else { Vec::new() };
        notes.extend(drawn::note(&by_region[index], None));
        if errors.marks == 0 {
            notes.push("no whole one grew in this region: nothing was measured".to_owned());
        }
        RegionReport {
            place,
            marks: Some(errors.marks),
            merged: None,
            asked: plan.asked_of_region(place),
            polarity: Polarity::Positive,
            directed: true,
            parameters: parameters(plan, &asked),
            predicted: None,
            got: errors.got.map(Attributes::Spots),
            raggedness,
            error,
            spread: None,
            kept: stayed.get(index).cloned(),
            beyond: Vec::new(),
            notes,
        }
    };
    (0..layout.len()).map(region).collect()
}

/// The report on the lines between cells; `None` for patches.
#[must_use]
pub fn gap(layer: &GrownAreas) -> Option<WidthReport> {
    match &layer.plan.form {
        AreaForm::Polygons(cells) => Some(WidthReport { asked: cells.gap, got: layer.gap }),
        AreaForm::Patches(_) => None,
    }
}

/// The parameters that grow what is `asked`, by name.
fn parameters(plan: &AreaPlan, asked: &Wanted) -> Vec<(&'static str, f64)> {
    let mut parameters = match &plan.form {
        AreaForm::Patches(form) => {
            let shape = asked.shape(form.detail);
            vec![("sigma", shape.sigma), ("stretch", shape.aspect), ("points", asked.points(form.detail))]
        }
        AreaForm::Polygons(form) => vec![("size", form.size(asked))],
    };
    parameters.push(("cell", plan.px_a_cell()));
    parameters
}

/// Notes for the user on the whole layer.
fn layer_notes(layer: &GrownAreas) -> Vec<String> {
    let mut notes = layer.plan.notes.clone();
    if layer.cramped > 0 {
        let patches = if layer.cramped == 1 { "patch" } else { "patches" };
        let place = if layer.plan.obstacles.is_empty() { "" } else { " between the layers beneath" };
        notes.push(format!(
            "{} {patches} found no room for the whole area{place}: draw them farther apart or smaller",
            layer.cramped
        ));
    }
    if let Some(OwnPolygons { own, laid }) = layer.own_polygons.filter(|cells| cells.own < cells.laid) {
        notes
            .push(format!("{} of {laid} cells closed or merged with others: draw thinner lines", laid - own));
    }
    notes
}

/// For each drawn mark of grown areas, in the order of drawing, how it has grown.
#[must_use]
pub fn drawn_areas(layer: &GrownAreas) -> Vec<DrawnMark> {
    let plan = &layer.plan;
    let extent = Extent::from(plan.canvas());
    let centers = layer.spots.iter().map(|spot| spot.ellipse.center).collect();
    let centers = PointBuckets::new(plan.canvas(), centers);
    let mark = |(mark, outline): &(usize, Outline)| {
        let shared = shared(outline, &extent, layer);
        let covered = shared.is_some_and(|shared| shared >= THERE);
        let beside =
            |spot: &&Spot| outline.depth(spot.ellipse.center, &extent) > -BESIDE * outline.area().sqrt();
        let distance = |spot: &Spot| {
            let center = outline.center();
            let [x, y] = extent.shortest([0, 1].map(|axis| spot.ellipse.center[axis] - center[axis]));
            x * x + y * y
        };
        let near = centers.within(outline.center(), outline.radius() + BESIDE * outline.area().sqrt());
        let near = near.iter().map(|index| &layer.spots[*index as usize]).filter(beside);
        let own = near.min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let joined =
            own.is_some_and(|spot| spot.whole && libm::log(spot.ellipse.area() / outline.area()).abs() > OWN);
        let there = covered && !joined;
        let own = own.filter(|spot| there && spot.whole);
        DrawnMark {
            mark: *mark,
            there,
            off: shared.map(|shared| 1.0 - shared),
            asked: crate::marks::ellipse_of_outline(outline.points()).map(|ellipse| attributes_of(&ellipse)),
            got: own.map(|spot| attributes_of(&spot.ellipse)),
            reason: match shared {
                None => Some("on marks of a layer beneath, or outside of the canvas"),
                Some(_) if covered && joined => Some("joined with a mark that it touches, or nearly touches"),
                Some(_) if !there => Some("closer to other drawn marks than it can be, or too narrow"),
                Some(_) => None,
            },
            place: outline.center(),
        }
    };
    plan.kept.iter().map(mark).collect()
}

/// Intersection ÷ union of a drawn outline and the areas that grew on and beside it, without the parts on marks of the layers
/// beneath; `None` if nothing of the outline is visible.
fn shared(outline: &Outline, extent: &Extent, layer: &GrownAreas) -> Option<f64> {
    let Field { values, .. } = &layer.field;
    // Beyond the line around a cell lie other cells.
    let margin = match &layer.plan.form {
        AreaForm::Patches(_) => BESIDE * outline.area().sqrt(),
        AreaForm::Polygons(form) => 0.5 * form.gap,
    };
    let grid = layer.plan.grid;
    let reach = outline.points().iter().fold([0.0f64; 2], |reach, at| {
        [0, 1].map(|axis| reach[axis].max((at[axis] - outline.center()[axis]).abs()))
    });
    let [mut both, mut either, mut seen] = [0usize; 3];
    let span = |axis: usize| -> Vec<usize> {
        let (center, cell, count) = (outline.center()[axis], grid.cell[axis], grid.size[axis] as i64);
        let [low, high] =
            [-1.0, 1.0].map(|side| ((center + side * (reach[axis] + margin)) / cell).floor() as i64);
        if extent.wrap[axis] {
            (low..=high.min(low + count - 1)).map(|k| k.rem_euclid(count) as usize).collect()
        } else {
            (low.max(0)..=high.min(count - 1)).map(|k| k as usize).collect()
        }
    };
    let columns = span(0);
    for row in span(1) {
        for cell in columns.iter().map(|column| row * grid.size[0] + column) {
            if layer.plan.obstacles.get(cell).is_some_and(|taken| *taken) {
                continue;
            }
            let depth = outline.depth(grid.center_px(cell), extent);
            let (inside, grown) = (depth > 0.0, values[cell] > 0.5 && depth > -margin);
            both += usize::from(inside && grown);
            either += usize::from(inside || grown);
            seen += usize::from(inside);
        }
    }
    (seen > 0).then(|| both as f64 / either as f64)
}
