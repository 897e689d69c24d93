//! The fourth stage of a plan: the layer is laid out among the layers beneath.

use crate::attributes::{Attributes, Stripes};
use crate::grid::{Domain, Field};
use crate::marks::Path;
use crate::measure::{Regions, Target};
use crate::rd::ParameterField;
use crate::synth::marks::plan::layer_lookup::Lookup;
use crate::synth::marks::plan::offset::Correction;
use crate::synth::marks::plan::offset_curves::{Curves, line_widths};
use crate::synth::marks::plan::pinned_marks::{LeftOut, PinnedMark};

/// Heights above this belong to the ground around marks of the layers beneath, which ends 1.5 line widths from them.
const RIM: f32 = 0.2;

/// A layer that is laid out among those beneath.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The parameters of every place, corrected.
    pub lookup: Lookup,
    /// Corrections found by probes, by region.
    pub corrections: Vec<Correction>,
    /// Cells that the marks of the layers beneath have taken; empty = none.
    pub obstacles: Vec<bool>,
    /// Heights of the ground around the obstacles, see [`ground_rim`](crate::synth::marks::plan::obstacle_mask::ground_rim); empty
    /// = none.
    pub rim: Vec<f32>,
    /// Starting places of its marks.
    pub arrangement: Arrangement,
}

/// Starting places of the marks of a layer.
#[derive(Clone, Debug)]
pub enum Arrangement {
    /// At places chosen by the system.
    Natural,
    /// Some spots where they were drawn, and around them others at places chosen by the system.
    PinnedSpots {
        /// Drawn spots that find room.
        spots: Vec<PinnedMark>,
        /// Drawn spots that find no room.
        left_out: Vec<LeftOut>,
    },
    /// Stripes along drawn lines and paths, px, and between them others at places chosen by the system.
    PinnedLines(Vec<Path>),
    /// One spot at each of these places, px, and none elsewhere.
    Inside(Vec<[f64; 2]>),
    /// Lines along these curves.
    Curves(Curves),
}

impl Plan {
    /// The spots that stay where they were drawn.
    #[must_use]
    pub fn pinned_spots(&self) -> &[PinnedMark] {
        if let Arrangement::PinnedSpots { spots, .. } = &self.arrangement { spots } else { &[] }
    }

    /// The drawn spots that find no room.
    #[must_use]
    pub fn left_out(&self) -> &[LeftOut] {
        if let Arrangement::PinnedSpots { left_out, .. } = &self.arrangement { left_out } else { &[] }
    }

    /// The lines and paths that stripes begin along.
    #[must_use]
    pub fn pinned_lines(&self) -> &[Path] {
        if let Arrangement::PinnedLines(lines) = &self.arrangement { lines } else { &[] }
    }

    /// The places of its spots, px, if they are given.
    #[must_use]
    pub fn places(&self) -> Option<&[[f64; 2]]> {
        if let Arrangement::Inside(places) = &self.arrangement { Some(places) } else { None }
    }

    /// The curves of its lines, if they run along curves.
    #[must_use]
    pub fn curves(&self) -> Option<&Curves> {
        if let Arrangement::Curves(curves) = &self.arrangement { Some(curves) } else { None }
    }

    /// Parameters of every cell. `pitch` is the distance at which marks begin ÷ the system's own distance, by region.
    #[must_use]
    pub fn maps(&self, pitch: &[f64]) -> ParameterField {
        let maps = self.lookup.maps(pitch, &self.obstacles);
        match self.curves() {
            None => maps,
            Some(curves) => curves.guide(maps),
        }
    }

    /// Parameters of every cell, marks at the system's own distance.
    #[must_use]
    pub fn unpitched_maps(&self) -> ParameterField {
        self.maps(&vec![1.0; self.lookup.map.layout().len()])
    }

    /// Whether marks of the layers beneath have taken this place, px.
    fn is_taken(&self, point: [f64; 2]) -> bool {
        if self.obstacles.is_empty() {
            return false;
        }
        let grid = &self.lookup.grid;
        self.obstacles.get(grid.cell_at(grid.to_cells(point))).copied().unwrap_or(false)
    }

    /// The lines that grow at a place, px: the stripes, or the gaps between them. `None` for spots.
    #[must_use]
    pub fn lines_at(&self, point: [f64; 2]) -> Option<Stripes> {
        match self.lookup.polarity.lines(&self.lookup.map.at(point)) {
            Attributes::Stripes(stripes) => Some(stripes),
            Attributes::Spots(_) => None,
        }
    }

    /// Whether this place, px, is on a mark of the layers beneath, or on the ground around one.
    #[must_use]
    pub fn is_hidden(&self, point: [f64; 2]) -> bool {
        self.is_taken(point) || self.is_rim(point)
    }

    /// Whether this place, px, is on the ground around marks of the layers beneath.
    fn is_rim(&self, point: [f64; 2]) -> bool {
        if self.rim.is_empty() {
            return false;
        }
        let grid = &self.lookup.grid;
        self.rim.get(grid.cell_at(grid.to_cells(point))).is_some_and(|height| *height > RIM)
    }

    /// Calls `measure` by region on the canvas without the ground around the marks beneath, which would be measured as ends of
    /// stripes.
    pub fn by_region<T>(&self, measure: impl FnOnce(&Target) -> Vec<T>) -> Vec<T> {
        if self.rim.is_empty() {
            return self.on_canvas(measure);
        }
        self.on_canvas(|target| {
            let regions = target.regions.count();
            let of = |point: [f64; 2]| if self.is_rim(point) { regions } else { target.regions.of(point) };
            let mut found = measure(&Target { regions: Regions::Any(regions + 1, &of), ..*target });
            found.truncate(regions);
            found
        })
    }

    /// Calls `measure` with the canvas for comparing patterns: its regions, and the wanted attributes by place.
    pub fn on_canvas<T>(&self, measure: impl FnOnce(&Target) -> T) -> T {
        let layout = self.lookup.map.layout();
        measure(&Target {
            bounds: layout.bounds(),
            regions: Regions::Grid(layout),
            covered: &|point| self.is_taken(point),
            wanted: &|point| self.lookup.map.at(point),
            surface: self.lookup.map.metric(),
        })
    }

    /// The concentration `marks`, as a share of the peak nearby if lines run along curves, and with ground around the marks beneath
    /// if stripes are the gaps between lines.
    #[must_use]
    pub fn levelled(&self, mut marks: Field) -> Field {
        let on_plan = [marks.width, marks.height] == self.lookup.grid.size;
        if on_plan {
            marks.values.iter_mut().zip(&self.rim).for_each(|(value, rim)| *value = value.max(*rim));
        }
        if let Some(curves) = self.curves().filter(|_| on_plan) {
            let grid = self.lookup.grid;
            marks.values = curves.levelled(&marks.values, &grid, &line_widths(&self.lookup.map, &grid));
        }
        marks
    }
}
