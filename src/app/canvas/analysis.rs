//! The analysed sketch, drawn over it as in the paper's figures: regions, neighbours, directions.

use std::cell::OnceCell;

use egui::{Align2, Color32, FontId, Stroke, vec2};

use super::ink::Ink;
use super::wanted::is_one_field;
use crate::app::theme::Palette;
use crate::attributes::regions::{Region, RegionMap};
use crate::attributes::{Attributes, spacing};
use crate::document::sketch_notes::{SketchNote, sketch_notes};
use crate::document::{AreaKind, Document, Layer, SystemChoice};
use crate::editor::session::Session;
use crate::editor::shape;
use crate::editor::suggestion::{Suggestion, suggestions};
use crate::marks::{Ellipse, Line, Mark};

/// The analysed sketch: a region map for each layer that has marks, and what will not grow as it was drawn.
#[derive(Default)]
pub struct Analysis {
    revision: Option<u64>,
    /// The maps that have been asked for: that of a hundred lines takes longer than a frame.
    maps: Vec<OnceCell<Option<RegionMap>>>,
    /// What will not grow as it was drawn.
    pub notes: Vec<SketchNote>,
    /// The layers whose lines cross and are a weave, as their system is chosen automatically.
    pub weaves: Vec<usize>,
    /// The layers whose system is chosen automatically and whose marks are too dense for spots, with what grows instead.
    pub dense: Vec<(usize, AreaKind)>,
    /// The layers whose outlines lie side by side as cells do, but which grow something else.
    pub cells: Vec<usize>,
    /// Options that would help layers.
    pub suggestions: Vec<(usize, Suggestion)>,
}

impl Analysis {
    /// Updates it after a change of the document.
    pub fn update(&mut self, session: &Session) {
        if self.revision == Some(session.revision()) {
            return;
        }
        self.revision = Some(session.revision());
        let document = session.document();
        self.maps = vec![OnceCell::new(); document.layers.len()];
        let marks = session.fitted_marks();
        self.notes = sketch_notes(document, marks);
        let layers = document.layers.iter().zip(marks).enumerate();
        let dense = |(index, (layer, _)): (usize, (&Layer, _))| {
            session.areas(index).filter(|_| layer.areas().is_none()).map(|kind| (index, kind))
        };
        self.dense = layers.clone().filter_map(dense).collect();
        let cells = layers.clone().filter(|(index, (layer, marks))| {
            session.areas(*index) != Some(AreaKind::Polygons) && document.looks_like_cells(layer, marks)
        });
        self.cells = cells.map(|(index, _)| index).collect();
        let weaves = layers.filter(|(_, (layer, marks))| {
            layer.system == SystemChoice::Auto && document.pairs_of(layer, marks).is_some()
        });
        self.weaves = weaves.map(|(index, _)| index).collect();
        let of_layer = |layer| suggestions(session, layer).into_iter().map(move |one| (layer, one));
        self.suggestions = (0..document.layers.len()).flat_map(of_layer).collect();
    }

    /// Another document is open.
    pub fn forget(&mut self) {
        *self = Self::default();
    }

    /// The map of a layer of `session`, if it has marks.
    #[must_use]
    pub fn map(&self, session: &Session, layer: usize) -> Option<&RegionMap> {
        self.maps.get(layer)?.get_or_init(|| map(session, layer)).as_ref()
    }

    /// Paints the analysis of a layer.
    pub fn paint(&self, ink: &Ink, session: &Session, layer: usize, colours: &Palette) {
        let Some(map) = self.map(session, layer) else { return };
        let marks = session.marks_of(layer);
        neighbours(ink, map, &marks, colours);
        for mark in &marks {
            axes(ink, mark, colours);
        }
        for (place, region) in map.regions() {
            mean(ink, map, place, region, colours);
        }
    }
}

fn map(session: &Session, layer: usize) -> Option<RegionMap> {
    let document = session.document();
    let (size, grid) = (document.size.map(f64::from), document.region_grid());
    let map = RegionMap::from_marks(&session.marks_on_tile(layer), size, grid, document.edges).ok()?;
    Some(with_period(map, document, layer))
}

/// The map of a layer with the stripe period from its options; without a period where the drawn lines do not determine
/// one.
fn with_period(map: RegionMap, document: &Document, layer: usize) -> RegionMap {
    match document.layers[layer].options.duty.given() {
        _ if !is_one_field(document, layer) => map.with_free_wavelength(),
        Some(duty) => map.with_duty(duty),
        None => map,
    }
}

/// The Delaunay edges between ellipses. Edges that count for more than half of the full weight in the spacing of a
/// region have the full colour, the others are pale.
fn neighbours(ink: &Ink, map: &RegionMap, marks: &[Mark], colours: &Palette) {
    let centers: Vec<[f64; 2]> = marks.iter().filter_map(|mark| Some(mark.ellipse()?.center)).collect();
    let segment = |ends: [usize; 2], stroke| ink.segment(ends.map(|end| centers[end]), stroke);
    for edge in spacing::edges(&centers, None) {
        segment(edge.ends, Stroke::new(0.8, colours.edge_pale));
    }
    let layout = map.layout();
    let region = |index: usize| layout.index(layout.region_of(centers[index]));
    for edge in spacing::grouped_neighbours(&centers, layout.len(), region).iter().flatten() {
        if edge.weight > 0.5 {
            segment(edge.ends, Stroke::new(1.2, colours.edge));
        }
    }
}

/// A mark with its axes.
fn axes(ink: &Ink, mark: &Mark, colours: &Palette) {
    let stroke = Stroke::new(1.2, colours.axis);
    match mark {
        Mark::Ellipse(ellipse) => {
            let end = |x, y| shape::out_of_frame([x, y], ellipse.center, ellipse.angle);
            let [a, b] = ellipse.radii;
            ink.mark(mark, Color32::TRANSPARENT, stroke);
            ink.segment([end(-a, 0.0), end(a, 0.0)], stroke);
            ink.segment([end(0.0, -b), end(0.0, b)], stroke);
        }
        Mark::Line(line) => ink.segment([line.from, line.to], stroke),
        Mark::Path(path) => ink.path(&path.points, stroke),
    }
}

/// The mean mark of a region, in its upper left corner.
fn mean(ink: &Ink, map: &RegionMap, place: [usize; 2], region: &Region, colours: &Palette) {
    let layout = map.layout();
    let center = layout.center(place);
    let colour = if region.own.is_some() { colours.accent } else { colours.accent_pale };
    let stroke = Stroke::new(2.0, colour);
    let side = [0, 1].map(|axis| layout.size[axis] / layout.grid[axis] as f64);
    let corner = [0, 1].map(|axis| center[axis] - 0.5 * side[axis]);
    let off = |reach: f64| [0, 1].map(|axis| corner[axis] + (reach + 6.0).min(0.5 * side[axis]));
    let (at, reach) = match map.at(center) {
        Attributes::Spots(spots) => {
            let reach = Ellipse::from_area(center, spots.area, spots.aspect, 0.0).radii[0];
            let at = off(reach);
            let mean = Ellipse::from_area(at, spots.area, spots.aspect, spots.angle);
            ink.mark(&Mark::Ellipse(mean), Color32::TRANSPARENT, stroke);
            (at, reach)
        }
        Attributes::Stripes(stripes) => {
            let reach = 0.12 * side[0].min(side[1]);
            let at = off(reach);
            let end = |x| shape::out_of_frame([x, 0.0], at, stripes.angle);
            let mean = Line { from: end(-reach), to: end(reach), width: stripes.width };
            ink.mark(&Mark::Line(mean), Color32::TRANSPARENT, stroke);
            (at, reach)
        }
    };
    let text = if region.marks == 1 { "1 mark".to_owned() } else { format!("{} marks", region.marks) };
    let beside = ink.at([at[0] + reach, at[1]]) + vec2(8.0, 0.0);
    ink.painter.text(beside, Align2::LEFT_CENTER, text, FontId::proportional(11.5), colour);
}
