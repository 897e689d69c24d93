//! Plans of layers of patches.

use crate::attributes::free::FreeMap;
use crate::attributes::regions::RegionGrid;
use crate::attributes::{AttributeMap, Attributes, Spots};
use crate::document::layer_rules::{Beneath, Combination};
use crate::document::{Document, DocumentError, Kind, RaggedChoice, Stroke};
use crate::grid::distance::{length, nearest};
use crate::grid::{Bounds, Domain, Grid};
use crate::marks::{Ellipse, Mark};
use crate::measure::raggedness;
use crate::points::discs::POINTS_A_SQUARE;
use crate::points::patches::{Outline, Patches, Wanted};
use crate::synth::plan::sketch_targets::{marks_on, region_map};

/// The share of the plane that patches cover where only one was drawn: that of a Holstein.
const USUAL_COVERAGE: f64 = 0.35;
/// Patches that cover more have no room, however fine their points (`facts.md` U: sixty sketches up to 0.7).
const MOST_COVERAGE: f64 = 0.72;
/// Cells in a distance of points. With 2.5, sixty sketches met what was asked (`facts.md` U).
const CELLS: f64 = 3.0;
/// The same for the points of kept outlines, which are finer than their outlines need.
const KEPT_CELLS: f64 = 1.5;
/// Corners of a kept ellipse.
const CORNERS: usize = 64;
/// Places along a side at which the map is asked for the finest points.
const SAMPLES: usize = 16;
/// Distance from a drawn mark, in mean spacings, at which others say as much about raggedness as it does.
const SMOOTHING: f64 = 0.5;

/// Patches that are ready to grow.
#[derive(Clone, Debug)]
pub struct PatchPlan {
    /// What is wanted where, but for raggedness; every spacing is filled.
    pub map: AttributeMap,
    /// The grid over the canvas, px.
    pub grid: Grid,
    /// Points a patch.
    pub detail: f64,
    /// The drawn marks that are reproduced, each with its index.
    pub kept: Vec<(usize, Outline)>,
    /// What the user should know.
    pub notes: Vec<String>,
    /// Cells that the marks of the layers beneath have taken; empty = none.
    pub obstacles: Vec<bool>,
    ragged: Ragged,
}

/// How ragged patches are.
#[derive(Clone, Debug)]
enum Ragged {
    /// σ, everywhere.
    Given(f64),
    /// The raggedness of the drawn marks at the nodes of a grid.
    Drawn(RegionGrid, Vec<f64>),
}

impl PatchPlan {
    /// Reads layer `index` of a document named `source`, on a canvas of `size` px.
    ///
    /// # Errors
    /// Its marks are lines, or a rule of layers is broken: file, place, what is allowed.
    pub fn read(
        document: &Document,
        index: usize,
        source: &str,
        size: [f64; 2],
    ) -> Result<Self, DocumentError> {
        let layer = &document.layers[index];
        let mut map = region_map(document, index, source)?.resized(size);
        let marks = marks_on(document, index, source, size)?;
        let below = if index == 0 { Beneath::Nothing } else { Beneath::Unknown };
        let kind = marks.first().map(Kind::from);
        if let Some(problem) = Combination::new(layer, kind, below).problem(&format!("layers[{index}]")) {
            return Err(problem.in_file(source));
        }
        let canvas = Bounds { size, edges: document.edges };
        let shapes = shapes(&layer.strokes, &marks);
        let ragged = match layer.options.ragged {
            RaggedChoice::Given(sigma) => Ragged::Given(sigma),
            RaggedChoice::Drawn => Ragged::drawn(&map, &shapes),
        };
        map.fill_free_spacing(|spots| Wanted::spacing_of_coverage(spots.area, USUAL_COVERAGE));
        let mut notes = map.free().map(FreeMap::remarks).unwrap_or_default();
        let too_dense = |spots: &Spots| coverage(spots) > MOST_COVERAGE;
        if map.limit_density(MOST_COVERAGE * 0.75f64.sqrt())
            || map.samples().iter().filter_map(spots).any(|of| too_dense(&of))
        {
            notes.push(format!(
                "patches that cover more than {:.0} % find no room: they are farther apart than drawn",
                100.0 * MOST_COVERAGE
            ));
        }
        let keeps = document.keeps_marks(index);
        let kept = shapes.into_iter().enumerate().filter(|_| keeps);
        let kept = kept.filter_map(|(mark, shape)| Some((mark, Outline::new(shape.corners)?))).collect();
        let grid = Grid { size: [1, 1], cell: size, edges: document.edges };
        let detail = layer.options.detail;
        let mut plan = Self { map, grid, detail, kept, notes, obstacles: Vec::new(), ragged };
        let cell = plan.finest_cell();
        let cells = canvas.size.map(|side| (side / cell).ceil().max(1.0) as usize);
        plan.grid = Grid { size: cells, cell: [0, 1].map(|axis| size[axis] / cells[axis] as f64), ..grid };
        Ok(plan)
    }

    /// The canvas, px.
    #[must_use]
    pub fn canvas(&self) -> Bounds {
        self.map.layout().bounds()
    }

    /// px a cell.
    #[must_use]
    pub fn px_a_cell(&self) -> f64 {
        self.grid.px_a_cell()
    }

    /// What is wanted at a place, px; beyond a closed border as at the nearest place on it.
    #[must_use]
    pub fn wanted(&self, at: [f64; 2]) -> Wanted {
        let at = self.canvas().inside(at);
        let Some(spots) = spots(&self.map.at(at)) else {
            // Marks are ellipses, so that none are wanted otherwise.
            return Wanted { area: 1.0, spacing: 2.0, aspect: 1.0, angle: 0.0, raggedness: 1.0 };
        };
        let Spots { area, aspect, angle, spacing } = spots;
        let least = Wanted::spacing_of_coverage(area, MOST_COVERAGE);
        let spacing = spacing.map_or(least, |spacing| spacing.max(least));
        let wanted = Wanted { area, spacing, aspect, angle, raggedness: 1.0 };
        let raggedness = match &self.ragged {
            Ragged::Given(sigma) => wanted.raggedness_of(*sigma, self.detail),
            Ragged::Drawn(layout, values) => {
                layout.corners(at).iter().map(|(node, weight)| weight * values[*node]).sum()
            }
        };
        Wanted { raggedness, ..wanted }
    }

    /// Have marks of the layers beneath taken this place, px?
    #[must_use]
    pub fn is_taken(&self, at: [f64; 2]) -> bool {
        self.obstacles.get(self.grid.cell_at(self.grid.to_cells(at))).copied().unwrap_or(false)
    }

    /// The cells that no patch may claim: those that are taken, and those nearer to them than one distance of points.
    #[must_use]
    pub fn blocked(&self) -> Vec<bool> {
        let Some(ways) = nearest(&self.obstacles, &self.grid) else { return Vec::new() };
        let is_near = |(cell, way): (usize, &[i32; 2])| {
            length(*way, &self.grid) < self.distance_of_points(&self.wanted(self.grid.center_px(cell)))
        };
        ways.iter().enumerate().map(is_near).collect()
    }

    /// Radius of the discs from which patches are made, px.
    fn distance_of_points(&self, wanted: &Wanted) -> f64 {
        (POINTS_A_SQUARE * wanted.area / wanted.points(self.detail)).sqrt()
    }

    /// The cell that the finest points need, px.
    fn finest_cell(&self) -> f64 {
        let size = self.canvas().size;
        let place = |k: usize, axis: usize| (k as f64 + 0.5) / SAMPLES as f64 * size[axis];
        let samples =
            (0..SAMPLES * SAMPLES).map(|k| self.wanted([place(k % SAMPLES, 0), place(k / SAMPLES, 1)]));
        let patches = samples.map(|wanted| self.distance_of_points(&wanted) / CELLS);
        let of_kept = |(_, outline): &(usize, Outline)| {
            (POINTS_A_SQUARE * outline.area() / Patches::KEPT_DETAIL).sqrt() / KEPT_CELLS
        };
        patches.chain(self.kept.iter().map(of_kept)).fold(f64::INFINITY, f64::min)
    }
}

/// The corners of a drawn mark on the canvas that is grown, and how ragged it is.
struct Shape {
    center: [f64; 2],
    corners: Vec<[f64; 2]>,
    raggedness: f64,
}

/// The shape of each of the `strokes`, whose `marks` lie on the canvas that is grown.
fn shapes(strokes: &[Stroke], marks: &[Mark]) -> Vec<Shape> {
    let shape = |(stroke, mark): (&Stroke, &Mark)| {
        let center = mark.center();
        match (stroke, stroke.mark()) {
            (Stroke::Outline(outline), Some(drawn)) => {
                let by = [0, 1].map(|axis| center[axis] - drawn.center()[axis]);
                let corners: Vec<_> = outline.points.iter().map(|[x, y]| [x + by[0], y + by[1]]).collect();
                let raggedness = raggedness(&corners).unwrap_or(1.0);
                Shape { center, corners, raggedness }
            }
            _ => Shape { center, corners: mark.ellipse().map(corners).unwrap_or_default(), raggedness: 1.0 },
        }
    };
    strokes.iter().zip(marks).map(shape).collect()
}

/// Corners of an ellipse.
fn corners(ellipse: Ellipse) -> Vec<[f64; 2]> {
    let (s, c) = libm::sincos(ellipse.angle.to_radians());
    let corner = |k: usize| {
        let (v, u) = libm::sincos(std::f64::consts::TAU * k as f64 / CORNERS as f64);
        let [x, y] = [ellipse.radii[0] * u, ellipse.radii[1] * v];
        [ellipse.center[0] + c * x - s * y, ellipse.center[1] + s * x + c * y]
    };
    (0..CORNERS).map(corner).collect()
}

impl Ragged {
    /// As the drawn shapes: by regions their means, else at each place the mean of those around it.
    fn drawn(map: &AttributeMap, shapes: &[Shape]) -> Self {
        let (canvas, spacing) = (map.layout().bounds(), mean_spacing(map));
        let layout = if map.is_free() { map.nodes() } else { *map.layout() };
        let value = |node: usize| {
            let place = layout.place(node);
            let at = layout.center(place);
            let owner = (!map.is_free()).then(|| {
                let holds = |index: usize| map.region(layout.place(index)).marks > 0;
                layout.nearest(place, holds)
            });
            let (mut sum, mut total) = (0.0, 0.0);
            for shape in shapes {
                let weight = match owner {
                    Some(owner) => {
                        f64::from(u8::from(Some(layout.index(layout.region_of(shape.center))) == owner))
                    }
                    None => {
                        let [x, y] = canvas.shortest([0, 1].map(|axis| shape.center[axis] - at[axis]));
                        let reach = SMOOTHING * spacing;
                        (x * x + y * y + reach * reach).powi(-2)
                    }
                };
                (sum, total) = (sum + weight * shape.raggedness, total + weight);
            }
            if total > 0.0 { sum / total } else { 1.0 }
        };
        Self::Drawn(layout, (0..layout.len()).map(value).collect())
    }
}

/// The mean spacing of what is wanted, px; where it is free, that of [`USUAL_COVERAGE`].
fn mean_spacing(map: &AttributeMap) -> f64 {
    let of = |spots: Spots| spots.spacing.unwrap_or(Wanted::spacing_of_coverage(spots.area, USUAL_COVERAGE));
    let all: Vec<f64> = map.of_regions().iter().filter_map(spots).map(of).collect();
    all.iter().sum::<f64>() / all.len().max(1) as f64
}

fn spots(attributes: &Attributes) -> Option<Spots> {
    if let Attributes::Spots(spots) = attributes { Some(*spots) } else { None }
}

/// The share of the plane that patches with these attributes cover.
fn coverage(spots: &Spots) -> f64 {
    spots.spacing.map_or(0.0, |spacing| spots.area * 2.0 / (3f64.sqrt() * spacing * spacing))
}
