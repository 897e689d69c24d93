//! Plans of layers of areas: patches and cells.

pub mod patches;
pub mod polygons;

use crate::attributes::free::FreeMap;
use crate::attributes::{AttributeMap, Attributes, Spots, Spread};
use crate::document::layer_rules::{Beneath, Combination};
use crate::document::{AreaKind, Document, DocumentError, Kind, Stroke, SystemChoice};
use crate::grid::{Bounds, Domain, Grid};
use crate::learn::{PairSet, TrainingError};
use crate::marks::{Ellipse, Mark, Path};
use crate::measure::raggedness;
use crate::points::patches::{Outline, Wanted, slope};
use crate::rd::pairs::polygons::POLYGONS;
use crate::synth::drawn::maps::modulated_by;
use crate::synth::drawn::sketch_targets::{self, marks_on, region_map};
use crate::synth::training::Training;
use patches::PatchForm;
use polygons::{PolygonForm, drawn_gap};

/// Corners of a kept ellipse or freehand outline.
const CORNERS: usize = 64;
/// Number of places along a side at which the map is read to find the finest cell.
const SAMPLES: usize = 16;

/// Patches or cells that are ready to grow.
#[derive(Clone, Debug)]
pub struct AreaPlan {
    /// The wanted attributes by place, without the form of the areas; every spacing is filled in.
    pub map: AttributeMap,
    /// The grid over the canvas, px.
    pub grid: Grid,
    /// The drawn marks that are reproduced, each with its index.
    pub kept: Vec<(usize, Outline)>,
    /// Notes for the user.
    pub notes: Vec<String>,
    /// Cells of the grid that the marks of the layers beneath have taken; empty = none.
    pub obstacles: Vec<bool>,
    /// The kind of areas, with what is particular to it.
    pub form: AreaForm,
}

/// The form of areas.
#[derive(Clone, Debug)]
pub enum AreaForm {
    /// Patches of scattered points.
    Patches(PatchForm),
    /// Cells side by side.
    Polygons(PolygonForm),
}

/// The training rows of cells, if layer `index` of `document` grows cells.
///
/// # Errors
/// They cannot be read.
pub fn rows_of_cells<'a>(
    document: &Document,
    index: usize,
    training: &'a Training,
) -> Result<Option<&'a PairSet>, TrainingError> {
    match document.areas(index) {
        Some(AreaKind::Polygons) => training.pairs(&POLYGONS),
        Some(AreaKind::Patches) | None => Ok(None),
    }
}

impl AreaPlan {
    /// Reads layer `index` of a document named `source`, on a canvas of `size` px. For cells, `rows` hold the errors of their laws.
    ///
    /// # Errors
    /// Its marks are lines, or a rule of layers is broken: file, place, what is allowed.
    pub fn read(
        document: &Document,
        index: usize,
        source: &str,
        size: [f64; 2],
        rows: Option<&PairSet>,
    ) -> Result<Self, DocumentError> {
        let layer = &document.layers[index];
        let map = region_map(document, index, source)?.resized(size);
        let mut map = modulated_by(document, index, size, map);
        let marks = marks_on(document, index, source, size)?;
        let below = if index == 0 { Beneath::Nothing } else { Beneath::Unknown };
        let marked = Kind::of_layer(marks.iter().map(Kind::from));
        let kind = document.areas(index);
        let system = kind.map_or(layer.system, |kind| SystemChoice::Of(kind.description()));
        let combination = Combination { system, ..Combination::new(layer, marked, below) };
        if let Some(problem) = combination.problem(&format!("layers[{index}]")) {
            return Err(problem.in_file(source));
        }
        let canvas = Bounds { size, edges: document.edges };
        let shapes = shapes(&layer.strokes, &marks);
        let mut notes = map.free().map(FreeMap::remarks).unwrap_or_default();
        notes.extend(kind.filter(|_| layer.areas().is_none()).map(chosen));
        let form = match kind {
            Some(AreaKind::Polygons) => {
                // On a canvas of another size, the distances of marks may differ.
                let own = Bounds { size: document.size.map(f64::from), edges: document.edges };
                let drawn = drawn_gap(&sketch_targets::marks(document, index, source)?, &own);
                AreaForm::Polygons(PolygonForm::new(layer.options.gap, drawn, &mut map, rows, &mut notes))
            }
            Some(AreaKind::Patches) | None => {
                AreaForm::Patches(PatchForm::new(&layer.options, &mut map, &shapes, &mut notes))
            }
        };
        let keeps = document.keeps_marks(index);
        let kept = shapes.into_iter().enumerate().filter(|_| keeps);
        let kept = kept.filter_map(|(mark, shape)| Some((mark, Outline::new(shape.corners)?))).collect();
        let grid = Grid { size: [1, 1], cell: size, edges: document.edges };
        let mut plan = Self { map, grid, kept, notes, obstacles: Vec::new(), form };
        let cell = plan.finest_cell();
        let cells = canvas.size.map(|side| (side / cell).ceil().max(1.0) as usize);
        plan.grid = Grid { size: cells, cell: [0, 1].map(|axis| size[axis] / cells[axis] as f64), ..grid };
        Ok(plan)
    }

    /// The kind of areas.
    #[must_use]
    pub fn kind(&self) -> AreaKind {
        match self.form {
            AreaForm::Patches(_) => AreaKind::Patches,
            AreaForm::Polygons(_) => AreaKind::Polygons,
        }
    }

    /// The canvas, px.
    #[must_use]
    pub fn canvas(&self) -> Bounds {
        self.map.layout().bounds()
    }

    /// px a cell of the grid.
    #[must_use]
    pub fn px_a_cell(&self) -> f64 {
        self.grid.px_a_cell()
    }

    /// The wanted attributes at a place, px; beyond a closed border those of the nearest place on it.
    #[must_use]
    pub fn wanted(&self, at: [f64; 2]) -> Wanted {
        let at = self.canvas().inside(at);
        let Some(spots) = spots(&self.map.at(at)) else {
            // Marks of areas are ellipses, so that the map holds no other attributes.
            return Wanted {
                area: 1.0,
                spacing: 2.0,
                aspect: 1.0,
                angle: 0.0,
                raggedness: 1.0,
                spread: Spread::ZERO,
            };
        };
        match &self.form {
            AreaForm::Patches(patches) => patches.wanted(spots, self.map.spread_at(at), at),
            AreaForm::Polygons(cells) => cells.wanted(&spots),
        }
    }

    /// The attributes that are asked for at a place, px; for cells with the distance that follows from their area and the lines
    /// between them.
    #[must_use]
    pub fn asked(&self, at: [f64; 2]) -> Attributes {
        self.with_spacing(self.map.at(at))
    }

    /// The attributes that are asked for at the centre of a region.
    #[must_use]
    pub fn asked_of_region(&self, place: [usize; 2]) -> Attributes {
        self.with_spacing(self.map.of_region(place))
    }

    fn with_spacing(&self, asked: Attributes) -> Attributes {
        match (&self.form, asked) {
            (AreaForm::Polygons(cells), Attributes::Spots(spots)) => {
                Attributes::Spots(Spots { spacing: Some(cells.wanted(&spots).spacing), ..spots })
            }
            (_, asked) => asked,
        }
    }

    /// Whether marks of the layers beneath have taken this place, px.
    #[must_use]
    pub fn is_taken(&self, at: [f64; 2]) -> bool {
        self.obstacles.get(self.grid.cell_at(self.grid.to_cells(at))).copied().unwrap_or(false)
    }

    /// The wanted attributes at places spread evenly over the canvas.
    fn samples(&self) -> impl Iterator<Item = Wanted> {
        let size = self.canvas().size;
        let place = move |k: usize, axis: usize| (k as f64 + 0.5) / SAMPLES as f64 * size[axis];
        (0..SAMPLES * SAMPLES).map(move |k| self.wanted([place(k % SAMPLES, 0), place(k / SAMPLES, 1)]))
    }

    /// Number of distances to sides of kept outlines that are computed, over all cells and points.
    pub fn asked_sides(&self) -> f64 {
        let px = self.px_a_cell() * self.px_a_cell();
        let of_outline = |outline: &Outline| {
            let [low, high] = outline.corners();
            let around = 2.0 * slope(outline);
            let sides = [0, 1].map(|axis| (high[axis] - low[axis] + around).min(self.canvas().size[axis]));
            outline.points().len() as f64 * sides[0] * sides[1] / px
        };
        self.kept.iter().map(|(_, outline)| of_outline(outline)).sum()
    }

    /// The cell that the finest marks need, px.
    fn finest_cell(&self) -> f64 {
        let cell = |wanted: Wanted| match &self.form {
            AreaForm::Patches(patches) => patches.cell(&wanted),
            AreaForm::Polygons(cells) => cells.cell(&wanted),
        };
        let finest = self.samples().map(cell).fold(f64::INFINITY, f64::min);
        match self.form {
            AreaForm::Patches(_) => {
                self.kept.iter().map(|(_, outline)| patches::cell_of_kept(outline)).fold(finest, f64::min)
            }
            AreaForm::Polygons(_) => finest,
        }
    }
}

/// The note why areas grow although the system is chosen automatically and no outlines are drawn.
fn chosen(kind: AreaKind) -> String {
    let name = kind.description().name;
    format!(
        "the drawn marks are denser than spots grow, so \"auto\" grows {name}; set \"system\" to choose another"
    )
}

/// The corners of a drawn mark on the canvas that is grown, and its raggedness.
pub(in crate::synth) struct Shape {
    pub center: [f64; 2],
    pub corners: Vec<[f64; 2]>,
    pub raggedness: f64,
}

/// The shape of each of the `strokes`, whose `marks` lie on the canvas that is grown; lines have no corners.
pub(in crate::synth) fn shapes(strokes: &[Stroke], marks: &[Mark]) -> Vec<Shape> {
    let shape = |(stroke, mark): (&Stroke, &Mark)| {
        let center = mark.center();
        match (stroke, stroke.mark()) {
            (Stroke::Outline(outline) | Stroke::Fitted { outline, .. }, Some(drawn)) => {
                let by = [0, 1].map(|axis| center[axis] - drawn.center()[axis]);
                let corners: Vec<_> = outline.points.iter().map(|[x, y]| [x + by[0], y + by[1]]).collect();
                let raggedness = raggedness(&corners).unwrap_or(1.0);
                Shape { center, corners, raggedness }
            }
            (Stroke::Freehand { points, .. }, Some(drawn)) if mark.ellipse().is_some() => {
                let by = [0, 1].map(|axis| center[axis] - drawn.center()[axis]);
                let closed = points.iter().chain(points.first()).map(|[x, y]| [x + by[0], y + by[1]]);
                let path = Path { points: closed.collect(), width: 1.0 };
                let corners: Vec<_> = path.samples(CORNERS).iter().map(|sample| sample.point).collect();
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

fn spots(attributes: &Attributes) -> Option<Spots> {
    if let Attributes::Spots(spots) = attributes { Some(*spots) } else { None }
}
