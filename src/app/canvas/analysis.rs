//! What the program sees in the sketch, as in the paper's figures: regions, neighbours, directions.

use eframe::egui::{Align2, FontId, Stroke};

use super::ink::Ink;
use crate::app::desk::Desk;
use crate::app::theme::Palette;
use crate::attributes::regions::{Region, RegionMap};
use crate::attributes::{Attributes, spacing};
use crate::marks::{Ellipse, Mark};

/// The analysed sketch: one map a layer that has marks.
#[derive(Default)]
pub struct Analysis {
    revision: Option<u64>,
    maps: Vec<Option<RegionMap>>,
}

impl Analysis {
    /// Brings it up to date with what is drawn.
    pub fn follow(&mut self, desk: &Desk) {
        if self.revision == Some(desk.revision()) {
            return;
        }
        self.revision = Some(desk.revision());
        let document = desk.document();
        let size = document.size.map(f64::from);
        let grid = document.regions.map(|n| n as usize);
        let map = |layer| RegionMap::of(&desk.marks_of(layer), size, grid, document.edges).ok();
        self.maps = (0..document.layers.len()).map(map).collect();
    }

    /// Another document is on the desk.
    pub fn forget(&mut self) {
        *self = Self::default();
    }

    /// The map of a layer, if it has marks.
    #[must_use]
    pub fn map(&self, layer: usize) -> Option<&RegionMap> {
        self.maps.get(layer)?.as_ref()
    }

    /// The region at a point (px) of a layer.
    #[must_use]
    pub fn region(&self, layer: usize, point: [f64; 2]) -> Option<([usize; 2], &Region)> {
        let map = self.map(layer)?;
        let place = map.region_of(point);
        Some((place, map.region(place)))
    }

    /// Paints what is seen in layer `layer`.
    pub fn paint(&self, ink: &Ink, desk: &Desk, layer: usize, colours: &Palette) {
        let Some(map) = self.map(layer) else { return };
        let marks = desk.marks_of(layer);
        for index in 0..map.layout().len() {
            let own =
                |mark: &&Mark| map.layout().index(map.region_of(crate::app::shape::middle(mark))) == index;
            let own: Vec<Mark> = marks.iter().filter(own).copied().collect();
            neighbours(ink, &own, colours);
        }
        for mark in &marks {
            axes(ink, mark, colours);
        }
        for (place, region) in map.regions() {
            direction(ink, map, place, region, colours);
        }
    }
}

/// The Delaunay edges of one region: those whose mean is the spacing in full, those left out pale.
fn neighbours(ink: &Ink, own: &[Mark], colours: &Palette) {
    let centers: Vec<[f64; 2]> = own
        .iter()
        .filter_map(|mark| match mark {
            Mark::Ellipse(ellipse) => Some(ellipse.center),
            Mark::Line(_) => None,
        })
        .collect();
    let edges = spacing::edges(&centers, None);
    let inner = edges.iter().filter(|edge| !edge.hull).count();
    let kept = spacing::neighbour_lengths(&centers);
    let longest = kept.last().copied().unwrap_or(f64::INFINITY);
    for edge in edges {
        let counts = (inner < 3 || !edge.hull) && edge.length <= longest;
        let stroke =
            if counts { Stroke::new(1.2, colours.edge) } else { Stroke::new(0.8, colours.edge_pale) };
        ink.segment(edge.ends.map(|end| centers[end]), stroke);
    }
}

/// A mark's axes.
fn axes(ink: &Ink, mark: &Mark, colours: &Palette) {
    let stroke = Stroke::new(1.2, colours.axis);
    match mark {
        Mark::Ellipse(ellipse) => {
            let end = |x, y| crate::app::shape::out_of_frame([x, y], ellipse.center, ellipse.angle);
            let [a, b] = ellipse.radii;
            ink.mark(mark, eframe::egui::Color32::TRANSPARENT, stroke);
            ink.segment([end(-a, 0.0), end(a, 0.0)], stroke);
            ink.segment([end(0.0, -b), end(0.0, b)], stroke);
        }
        Mark::Line(line) => ink.segment([line.from, line.to], stroke),
    }
}

/// What a region stands for: its mean mark, in its middle.
fn direction(ink: &Ink, map: &RegionMap, place: [usize; 2], region: &Region, colours: &Palette) {
    let center = map.layout().center(place);
    let stroke = Stroke::new(2.0, if region.own.is_some() { colours.accent } else { colours.accent_pale });
    match map.at(center) {
        Attributes::Spots(spots) => {
            let mean = Ellipse::of(center, spots.area, spots.aspect, spots.angle);
            ink.mark(&Mark::Ellipse(mean), eframe::egui::Color32::TRANSPARENT, stroke);
        }
        Attributes::Stripes(stripes) => {
            let half =
                0.12 * map.layout().size[0].min(map.layout().size[1]) / map.layout().grid[0].max(1) as f64;
            let end = |x| crate::app::shape::out_of_frame([x, 0.0], center, stripes.angle);
            ink.segment([end(-half), end(half)], Stroke::new(stroke.width + 1.0, stroke.color));
        }
    }
    let text = format!("{}", region.marks);
    let at = ink.at(center) + eframe::egui::vec2(6.0, 6.0);
    ink.painter.text(at, Align2::LEFT_TOP, text, FontId::proportional(11.0), stroke.color);
}
