//! The part of a plan that only patches have: their raggedness and their points.

use super::{AreaPlan, Shape, spots};
use crate::attributes::regions::RegionGrid;
use crate::attributes::{AttributeMap, Spots, Spread};
use crate::document::{LayerOptions, RaggedChoice};
use crate::grid::distance::{length, nearest};
use crate::points::discs::{Laying, POINTS_A_SQUARE};
use crate::points::patches::{Outline, Patches, Wanted};
use crate::points::rosettes::Rosettes;

/// The share of the plane that patches cover if only one was drawn: that of a Holstein.
pub(in crate::synth) const USUAL_COVERAGE: f64 = 0.35;
/// The largest share that patches can cover: beyond it they find no room, however fine their points (`facts.md` U: sixty sketches
/// up to 0.7).
pub(in crate::synth) const MOST_COVERAGE: f64 = 0.72;
/// Cells of the grid per distance of points. With 2.5, sixty sketches got what they asked for (`facts.md` U).
const CELLS: f64 = 3.0;
/// Cells of the grid per distance of points in kept outlines, whose points are finer than the outlines need.
const KEPT_CELLS: f64 = 1.5;
/// Cells of the grid per depth of the blotches of a rosette.
const BLOTCH_CELLS: f64 = 6.0;
/// Distance from a drawn mark, in mean spacings, at which its weight in the raggedness of a place has fallen to a quarter.
const SMOOTHING: f64 = 0.5;

/// The part of a plan that only patches have.
#[derive(Clone, Debug)]
pub struct PatchForm {
    /// Points a patch.
    pub detail: f64,
    /// What the patches are as rosettes; `None` = they are solid.
    pub rosette: Option<Rosettes>,
    ragged: Ragged,
}

/// The raggedness of patches.
#[derive(Clone, Debug)]
enum Ragged {
    /// σ, everywhere.
    Given(f64),
    /// The raggedness of the drawn marks at the nodes of a grid.
    Drawn(RegionGrid, Vec<f64>),
}

impl PatchForm {
    /// The form of the patches, from the `options` and the drawn `shapes`. Fills in the spacings of `map`, and adds to `notes`
    /// where patches must be farther apart than drawn.
    pub(super) fn new(
        options: &LayerOptions,
        map: &mut AttributeMap,
        shapes: &[Shape],
        notes: &mut Vec<String>,
    ) -> Self {
        let ragged = match options.ragged {
            RaggedChoice::Given(sigma) => Ragged::Given(sigma),
            RaggedChoice::Drawn => Ragged::drawn(map, shapes),
        };
        map.fill_free_spacing(|spots| Wanted::spacing_of_coverage(spots.area, USUAL_COVERAGE));
        let too_dense = |spots: &Spots| coverage(spots) > MOST_COVERAGE;
        if map.limit_density(MOST_COVERAGE * 0.75f64.sqrt())
            || map.samples().iter().filter_map(spots).any(|of| too_dense(&of))
        {
            notes.push(format!(
                "patches that cover more than {:.0} % find no room: they are farther apart than drawn",
                100.0 * MOST_COVERAGE
            ));
        }
        Self { detail: options.detail, rosette: options.rosette, ragged }
    }

    /// The wanted attributes at a place, px, where the map gives `spots` and their spread.
    pub(super) fn wanted(
        &self,
        Spots { area, aspect, angle, spacing }: Spots,
        spread: Spread,
        at: [f64; 2],
    ) -> Wanted {
        let least = Wanted::spacing_of_coverage(area, MOST_COVERAGE);
        let spacing = spacing.map_or(least, |spacing| spacing.max(least));
        let wanted = Wanted { area, spacing, aspect, angle, raggedness: 1.0, spread };
        let raggedness = match &self.ragged {
            Ragged::Given(sigma) => wanted.raggedness_of(*sigma, self.detail),
            Ragged::Drawn(layout, values) => {
                layout.corners(at).iter().map(|(node, weight)| weight * values[*node]).sum()
            }
        };
        Wanted { raggedness, ..wanted }
    }

    /// The cells that no patch of `plan` may claim: those that are taken, and cells closer to these than one distance of points.
    #[must_use]
    pub fn blocked(&self, plan: &AreaPlan) -> Vec<bool> {
        let Some(ways) = nearest(&plan.obstacles, &plan.grid) else { return Vec::new() };
        let is_near = |(cell, way): (usize, &[i32; 2])| {
            length(*way, &plan.grid)
                < distance_of_points(&plan.wanted(plan.grid.center_px(cell)), self.detail)
        };
        ways.iter().enumerate().map(is_near).collect()
    }

    /// The work of laying the points of `plan`.
    #[must_use]
    pub fn laying(&self, plan: &AreaPlan) -> Laying {
        self.patches(plan, &|at| plan.wanted(at)).laying()
    }

    /// Upper bound of the comparisons of two centres in laying the centres of `plan`.
    #[must_use]
    pub fn compared(&self, plan: &AreaPlan) -> f64 {
        self.patches(plan, &|at| plan.wanted(at)).compared()
    }

    fn patches<'a>(&self, plan: &AreaPlan, wanted: &'a (dyn Fn([f64; 2]) -> Wanted + Sync)) -> Patches<'a> {
        Patches { grid: plan.grid, wanted, kept: &[], blocked: None, detail: self.detail, seed: 0 }
    }

    /// Cell of the grid that the points of such patches need, px.
    pub(super) fn cell(&self, wanted: &Wanted) -> f64 {
        let of_points = distance_of_points(wanted, self.detail) / CELLS;
        let of_blotches = self.rosette.map(|rosette| rosette.width_on(wanted.area) / BLOTCH_CELLS);
        of_blotches.map_or(of_points, |cell| cell.min(of_points))
    }
}

/// Radius of the discs from which patches of `detail` points are made, px.
pub(in crate::synth) fn distance_of_points(wanted: &Wanted, detail: f64) -> f64 {
    (POINTS_A_SQUARE * wanted.area / wanted.points(detail)).sqrt()
}

/// The cell of the grid that the points of a kept outline need, px.
pub(super) fn cell_of_kept(outline: &Outline) -> f64 {
    (POINTS_A_SQUARE * outline.area() / Patches::KEPT_DETAIL).sqrt() / KEPT_CELLS
}

impl Ragged {
    /// The raggedness of the drawn shapes: with regions their mean in each region, otherwise at each place the mean of the shapes
    /// around it.
    fn drawn(map: &AttributeMap, shapes: &[Shape]) -> Self {
        if !map.is_free() {
            return Self::of_regions(map, shapes);
        }
        let (canvas, layout, reach) = (map.layout().bounds(), map.nodes(), SMOOTHING * mean_spacing(map));
        let value = |node: usize| {
            let at = layout.center(layout.place(node));
            let (mut sum, mut total) = (0.0, 0.0);
            for shape in shapes {
                let [x, y] = canvas.shortest([0, 1].map(|axis| shape.center[axis] - at[axis]));
                let weight = (x * x + y * y + reach * reach).powi(-2);
                (sum, total) = (sum + weight * shape.raggedness, total + weight);
            }
            if total > 0.0 { sum / total } else { 1.0 }
        };
        Self::Drawn(layout, (0..layout.len()).map(value).collect())
    }

    /// The mean of the shapes in each region; an empty region has that of the nearest region with marks.
    fn of_regions(map: &AttributeMap, shapes: &[Shape]) -> Self {
        let layout = *map.layout();
        let mut sums = vec![[0.0; 2]; layout.len()];
        for shape in shapes {
            let [sum, count] = &mut sums[layout.index(layout.region_of(shape.center))];
            (*sum, *count) = (*sum + shape.raggedness, *count + 1.0);
        }
        let holds = |index: usize| map.region(layout.place(index)).marks > 0;
        let mean = |region: usize| match layout.nearest(layout.place(region), holds).map(|own| sums[own]) {
            Some([sum, count]) if count > 0.0 => sum / count,
            _ => 1.0,
        };
        Self::Drawn(layout, (0..layout.len()).map(mean).collect())
    }
}

/// The mean wanted spacing, px; where the spacing is free, that of [`USUAL_COVERAGE`].
fn mean_spacing(map: &AttributeMap) -> f64 {
    let of = |spots: Spots| spots.spacing.unwrap_or(Wanted::spacing_of_coverage(spots.area, USUAL_COVERAGE));
    let all: Vec<f64> = map.of_regions().iter().filter_map(spots).map(of).collect();
    all.iter().sum::<f64>() / all.len().max(1) as f64
}

/// The share of the plane that patches with these attributes cover.
fn coverage(spots: &Spots) -> f64 {
    spots.spacing.map_or(0.0, |spacing| spots.area * 2.0 / (3f64.sqrt() * spacing * spacing))
}
