//! Plans of layers of streaks and cracks.

use crate::attributes::free::FreeMap;
use crate::attributes::periods::PeriodRules;
use crate::attributes::{AttributeMap, Attributes, Stripes};
use crate::document::layer_rules::{Beneath, Combination};
use crate::document::{Document, DocumentError, DutyChoice, Kind, LineKind, Problem};
use crate::grid::distance::{length, nearest};
use crate::grid::{Bounds, Domain, Grid};
use crate::points::discs::Laying;
use crate::points::lines::{Course, Lines, WantedLines, radius};
use crate::synth::drawn::maps::modulated_by;
use crate::synth::drawn::sketch_targets::marks;

/// Width ÷ period if no lines are drawn side by side. Streaks have the share that their chains have by themselves, and cracks cover
/// a fifth of the canvas.
const ALONE: [f64; 2] = [0.4, 0.1];
/// Shares of the canvas that streaks can cover: less breaks them into dots, more merges them.
const STREAKS: [f64; 2] = [0.2, 0.6];
/// Shares of the canvas that cracks can cover: for more there is no room between the meshes.
const CRACKS: [f64; 2] = [0.03, 0.45];
/// Cells of the grid per radius of the discs, as for patches.
const CELLS: f64 = 3.0;
/// The least factor of the discs' radii that the growth tries.
const LEAST_SCALE: f64 = 0.8;
/// Number of places along a side at which the map is read to find the finest lines.
const SAMPLES: usize = 16;

/// Streaks or cracks that are ready to grow.
#[derive(Clone, Debug)]
pub struct LinePlan {
    /// The kind of lines.
    pub kind: LineKind,
    /// Width, period and direction of what was drawn.
    pub map: AttributeMap,
    /// Points a streak.
    pub detail: f64,
    /// The grid over the canvas, px.
    pub grid: Grid,
    /// Notes for the user.
    pub notes: Vec<String>,
    /// Cells of the grid that the marks of the layers beneath have taken; empty = none.
    pub obstacles: Vec<bool>,
}

impl LinePlan {
    /// Reads layer `index` of a document named `source`, which `kind` grows, on a canvas of `size` px.
    ///
    /// # Errors
    /// Its marks are no lines, or a rule of layers is broken: file, place, what is allowed.
    pub fn read(
        document: &Document,
        index: usize,
        kind: LineKind,
        source: &str,
        size: [f64; 2],
    ) -> Result<Self, DocumentError> {
        let layer = &document.layers[index];
        let marks = marks(document, index, source)?;
        let below = if index == 0 { Beneath::Nothing } else { Beneath::Unknown };
        if let Some(problem) =
            Combination::new(layer, Some(Kind::Line), below).problem(&format!("layers[{index}]"))
        {
            return Err(problem.in_file(source));
        }
        let own = document.size.map(f64::from);
        let regions = document.regions.map(|regions| regions.map(|n| n as usize));
        let map =
            AttributeMap::of_threads(&marks, own, regions, document.edges, PeriodRules::threads(alone(kind)));
        let map = map.map_err(|error| {
            let place = format!("layers[{index}].strokes");
            Problem::new(place, error.to_string(), "at least one line").in_file(source)
        })?;
        let map = match layer.options.duty {
            DutyChoice::Given(duty) => map.with_duty(duty),
            DutyChoice::Drawn => map,
        };
        let grid = Grid { size: [1, 1], cell: size, edges: document.edges };
        let detail = layer.options.detail;
        let map = modulated_by(document, index, size, map.resized(size));
        let notes = map.free().map(FreeMap::remarks_on_periods).unwrap_or_default();
        let mut plan = Self { kind, map, detail, grid, notes, obstacles: Vec::new() };
        plan.note_shares();
        let cell = plan.finest_radius() * LEAST_SCALE / CELLS;
        let cells = size.map(|side| (side / cell).ceil().max(1.0) as usize);
        plan.grid = Grid { size: cells, cell: [0, 1].map(|axis| size[axis] / cells[axis] as f64), ..grid };
        Ok(plan)
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

    /// The kind of its lines.
    #[must_use]
    pub fn course(&self) -> Course {
        match self.kind {
            LineKind::Streaks => Course::Streaks(self.detail),
            LineKind::Cracks => Course::Cracks,
        }
    }

    /// The wanted lines at a place, px; beyond a closed border those of the nearest place on it.
    #[must_use]
    pub fn wanted(&self, at: [f64; 2]) -> WantedLines {
        self.of(&self.map.at(self.canvas().inside(at)))
    }

    /// The wanted lines at the centre of a region; for free marks their mean.
    #[must_use]
    pub fn wanted_of_region(&self, place: [usize; 2]) -> WantedLines {
        self.of(&self.map.of_region(place))
    }

    /// The share of the canvas that its lines are to cover, the mean over the places at which they are known.
    #[must_use]
    pub fn mean_share(&self) -> f64 {
        let samples = self.map.samples();
        samples.iter().map(|wanted| self.of(wanted).share).sum::<f64>() / samples.len() as f64
    }

    fn of(&self, wanted: &Attributes) -> WantedLines {
        let Attributes::Stripes(stripes) = wanted else { unreachable!("made of lines") };
        let [least, most] = shares(self.kind);
        WantedLines {
            width: stripes.width,
            share: share_of(self.kind, stripes.duty()).clamp(least, most),
            angle: stripes.angle,
        }
    }

    /// The attributes that are compared with the measurement; for cracks the width alone.
    #[must_use]
    pub fn asked(&self, at: [f64; 2]) -> Attributes {
        self.attributes(self.wanted(at))
    }

    /// The attributes of a region that are compared with the measurement; for cracks the width alone.
    #[must_use]
    pub fn asked_of_region(&self, place: [usize; 2]) -> Attributes {
        self.attributes(self.wanted_of_region(place))
    }

    fn attributes(&self, WantedLines { width, share, angle }: WantedLines) -> Attributes {
        let wavelength = (self.kind == LineKind::Streaks).then(|| width / share);
        Attributes::Stripes(Stripes { width, angle, wavelength })
    }

    /// Whether marks of the layers beneath have taken this place, px.
    #[must_use]
    pub fn is_taken(&self, at: [f64; 2]) -> bool {
        self.obstacles.get(self.grid.cell_at(self.grid.to_cells(at))).copied().unwrap_or(false)
    }

    /// The cells that no line may cover: those that are taken, and cells closer to these than one distance of points.
    #[must_use]
    pub fn blocked(&self) -> Vec<bool> {
        let Some(ways) = nearest(&self.obstacles, &self.grid) else { return Vec::new() };
        let is_near = |(cell, way): (usize, &[i32; 2])| {
            length(*way, &self.grid) < radius(self.course(), &self.wanted(self.grid.center_px(cell)))
        };
        ways.iter().enumerate().map(is_near).collect()
    }

    /// The work of one layout of points.
    #[must_use]
    pub fn laying(&self) -> Laying {
        let wanted = |at: [f64; 2]| self.wanted(at);
        let (grid, course) = (self.grid, self.course());
        Lines { grid, wanted: &wanted, blocked: None, course, scale: 1.0, seed: 0 }.laying()
    }

    fn note_shares(&mut self) {
        let [least, most] = shares(self.kind);
        let Some(asked) = self.map.samples().iter().find_map(|wanted| match wanted {
            Attributes::Stripes(stripes) => {
                let share = share_of(self.kind, stripes.duty());
                Some(share).filter(|share| *share < least - 1e-9 || *share > most + 1e-9)
            }
            Attributes::Spots(_) => None,
        }) else {
            return;
        };
        self.notes.push(format!(
            "{} cover {:.0} % to {:.0} % of the canvas, not {:.0} %",
            self.kind.description().name,
            100.0 * least,
            100.0 * most,
            100.0 * asked
        ));
    }

    /// The smallest radius of the discs anywhere on the canvas, px.
    fn finest_radius(&self) -> f64 {
        let size = self.canvas().size;
        let place = |k: usize, axis: usize| (k as f64 + 0.5) / SAMPLES as f64 * size[axis];
        let at =
            |k: usize| radius(self.course(), &self.wanted([place(k % SAMPLES, 0), place(k / SAMPLES, 1)]));
        (0..SAMPLES * SAMPLES).map(at).fold(f64::INFINITY, f64::min)
    }
}

/// Width ÷ period of lines for which nothing else gives it.
pub(in crate::synth) fn alone(kind: LineKind) -> f64 {
    match kind {
        LineKind::Streaks => ALONE[0],
        LineKind::Cracks => ALONE[1],
    }
}

/// The share that lines of this `duty` cover: for streaks the duty; for cracks, which run in both directions, that of two such sets
/// of lines.
pub(in crate::synth) fn share_of(kind: LineKind, duty: f64) -> f64 {
    match kind {
        LineKind::Streaks => duty,
        LineKind::Cracks => duty * (2.0 - duty),
    }
}

/// The least and the largest share that can grow.
pub(in crate::synth) fn shares(kind: LineKind) -> [f64; 2] {
    match kind {
        LineKind::Streaks => STREAKS,
        LineKind::Cracks => CRACKS,
    }
}
