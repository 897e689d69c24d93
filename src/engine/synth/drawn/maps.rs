//! Reads the maps of a layer as numbers at nodes over the canvas.

use crate::attributes::AttributeMap;
use crate::attributes::modulation::{Change, Modulated, ModulatedAttribute, Modulation};
use crate::attributes::regions::RegionGrid;
use crate::document::{Document, LayerMap, MapChange, MapKey, MapSource, limits};
use crate::grid::{Edges, Grid};
use crate::photo::tone::{Frame, sampled};
use crate::points::noise::Noise;

/// Nodes along the longer side of maps that change what grows: a map finer than marks has no effect, and even of 64 marks in a row
/// each has a node.
const GROWN: usize = 64;
/// Nodes along the longer side of colour maps, by a picture and by noise. Noise costs more and is smooth. Between nodes colours are
/// linear.
const PAINTED: [usize; 2] = [512, 256];
/// The pattern at the edge of a mark.
const EDGE: f32 = 0.5;
/// Difference between the seeds of the maps of a layer; an odd number, so that none repeats (a multiplier of Steele and Vigna,
/// "Computationally Easy, Spectrally Good Multipliers for Congruential Pseudorandom Number Generators", 2022).
const MAP_SEED: u64 = 0xD134_2543_DE82_EF95;

/// `map`, that of layer `index` on a canvas of `size` px, varied by the maps of the layer.
#[must_use]
pub fn modulated_by(document: &Document, index: usize, size: [f64; 2], map: AttributeMap) -> AttributeMap {
    match modulation(document, index, size) {
        Some(maps) => map.modulated(maps),
        None => map,
    }
}

/// The variation of the attributes of layer `index` by its maps, on a canvas of `size` px; `None` without maps of attributes.
#[must_use]
pub fn modulation(document: &Document, index: usize, size: [f64; 2]) -> Option<Modulation> {
    let maps = &document.layers.get(index)?.maps;
    let nodes = nodes(document.edges, size, GROWN);
    let attribute = |(key, map): (MapKey, &LayerMap)| {
        Some(ModulatedAttribute {
            attribute: modulated(key)?,
            change: change(map, key),
            values: values(map, &nodes, document.layer_seed(index).wrapping_add(seed(key))),
        })
    };
    let attributes: Vec<_> = maps.iter().filter_map(attribute).collect();
    (!attributes.is_empty()).then_some(Modulation { nodes, attributes })
}

/// How a map of `key` changes what it varies.
#[must_use]
pub fn change(map: &LayerMap, key: MapKey) -> Change {
    match map.change(key) {
        MapChange::Replace => Change::Replace,
        MapChange::Multiply => Change::Multiply,
        MapChange::Add => Change::Add,
    }
}

/// What a map of `key` varies of marks; `None` of colours, growth and ground.
#[must_use]
pub fn modulated(key: MapKey) -> Option<Modulated> {
    match key {
        MapKey::Area => Some(Modulated::Area),
        MapKey::Spacing => Some(Modulated::Spacing),
        MapKey::Direction => Some(Modulated::Direction),
        MapKey::Aspect => Some(Modulated::Aspect),
        MapKey::Duty => Some(Modulated::Duty),
        MapKey::Colour | MapKey::Growth | MapKey::Ground => None,
    }
}

/// A map that changes colours only, over its canvas.
#[derive(Clone, Debug)]
pub struct PaintedMap {
    nodes: RegionGrid,
    values: Vec<f64>,
}

impl PaintedMap {
    /// The map of `key` of layer `index` on a canvas of `size` px, if it has one.
    #[must_use]
    pub fn of(document: &Document, index: usize, key: MapKey, size: [f64; 2]) -> Option<Self> {
        let map = document.layers.get(index)?.maps.get(key)?;
        let [picture, noise] = PAINTED;
        let most = if matches!(map.source, MapSource::Image { .. }) { picture } else { noise };
        let nodes = nodes(document.edges, size, most);
        let seed = document.layer_seed(index).wrapping_add(seed(key));
        Some(Self { nodes, values: values(map, &nodes, seed) })
    }

    /// Its value at `point`, px of the canvas.
    #[must_use]
    pub fn at(&self, point: [f64; 2]) -> f32 {
        let corners = self.nodes.corners(point);
        corners.iter().map(|&(node, weight)| weight * self.values[node]).sum::<f64>() as f32
    }
}

/// The variation of the places in the gradient of a layer over its canvas.
#[derive(Clone, Debug)]
pub struct ColourMap {
    map: PaintedMap,
    multiplies: bool,
}

impl ColourMap {
    /// The colour map of layer `index` on a canvas of `size` px, if it has one.
    #[must_use]
    pub fn of(document: &Document, index: usize, size: [f64; 2]) -> Option<Self> {
        let map = PaintedMap::of(document, index, MapKey::Colour, size)?;
        let change = document.layers[index].maps.get(MapKey::Colour)?.change(MapKey::Colour);
        Some(Self { map, multiplies: change == MapChange::Multiply })
    }

    /// The pattern `value` at `point` (px of the canvas) as a place in the gradient, 0..1.
    ///
    /// A shift moves the ends of the gradient: 0, of the ground, and 1, of the marks. A factor multiplies the distance from the
    /// edge. The edge, 0.5, stays where it is: marks keep the area that was asked for.
    #[must_use]
    pub fn place(&self, value: f32, point: [f64; 2]) -> f32 {
        place_by(value, self.map.at(point), self.multiplies)
    }
}

/// The pattern `value` as a place in the gradient, 0..1, where a map of colours has the number `by`: see [`ColourMap::place`].
#[must_use]
pub fn place_by(value: f32, by: f32, multiplies: bool) -> f32 {
    let from_edge = value.clamp(0.0, 1.0) - EDGE;
    let factor = match multiplies {
        true => by,
        false if from_edge < 0.0 => 1.0 - 2.0 * by,
        false => 1.0 + 2.0 * by,
    };
    (EDGE + factor * from_edge).clamp(0.0, 1.0)
}

/// The parameter G at each cell of `grid` by the map of layer `index`, if it has one: the map replaces the value `usual`, or
/// multiplies it.
#[must_use]
pub fn growth_by_map(document: &Document, index: usize, grid: &Grid, usual: f32) -> Option<Vec<f32>> {
    let map = document.layers.get(index)?.maps.get(MapKey::Growth)?;
    let nodes = RegionGrid { size: grid.bounds_px().size, grid: grid.size, edges: grid.edges };
    let seed = document.layer_seed(index).wrapping_add(seed(MapKey::Growth));
    let factor = map.change(MapKey::Growth) == MapChange::Multiply;
    let allowed = limits::MAP_GROWTH;
    let asked = |value: f64| if factor { f64::from(usual) * value } else { value };
    let growth = values(map, &nodes, seed).into_iter().map(asked);
    Some(growth.map(|growth| growth.clamp(allowed.low, allowed.high) as f32).collect())
}

/// Nearly square nodes over a canvas of `size` px, `most` along its longer side and at most one per px.
pub(in crate::synth) fn nodes(edges: Edges, size: [f64; 2], most: usize) -> RegionGrid {
    let longer = size[0].max(size[1]);
    let most = (most as f64).min(longer);
    let grid = size.map(|side| ((most * side / longer).round() as usize).max(1));
    RegionGrid { size, grid, edges }
}

/// What is added to the seed of a layer for its map of `key`.
#[must_use]
pub fn seed(key: MapKey) -> u64 {
    (key as u64 + 1).wrapping_mul(MAP_SEED)
}

/// The values of a map at nodes, in the unit of its attribute.
fn values(map: &LayerMap, nodes: &RegionGrid, seed: u64) -> Vec<f64> {
    let [low, high] = map.range;
    let shares = match &map.source {
        MapSource::Image { image, .. } => {
            let size = image.size();
            let whole = Frame { from: [0.0; 2], size: size.map(|side| side as f64) };
            let values = image.values();
            sampled(&|px| f32::from(values[px]) / f32::from(u8::MAX), size, &whole, nodes.grid)
        }
        MapSource::Noise { size, octaves } => noise(*size, *octaves, nodes, seed),
    };
    shares.into_iter().map(|share| low + f64::from(share) * (high - low)).collect()
}

/// Noise at nodes, 0..1. With any number of octaves its spread is that of one octave, which takes nearly all of that range.
fn noise(size: f64, octaves: u32, nodes: &RegionGrid, seed: u64) -> Vec<f32> {
    let cell = [0, 1].map(|axis| nodes.size[axis] / nodes.grid[axis] as f64);
    let grid = Grid { size: nodes.grid, cell, edges: nodes.edges };
    // Noise finer than the nodes would only cost more points.
    let radius = size.max(grid.px_a_cell());
    let halvings = libm::log2(radius / grid.px_a_cell()).floor() as u32;
    let octaves = octaves.min(halvings + 1);
    let share = |octave: u32| 0.5f32.powi(octave as i32);
    let total: f32 = (0..octaves).map(share).sum();
    let squares: f32 = (0..octaves).map(|octave| share(octave) * share(octave)).sum();
    let spread = total / squares.sqrt();
    let field = Noise { radius, octaves, fold: false, seed }.field(&grid);
    field.values.into_iter().map(|value| (0.5 + spread * (value - 0.5)).clamp(0.0, 1.0)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Layer, ToneImage};

    fn document(key: MapKey, map: LayerMap) -> Document {
        let layer = Layer::default().with_map(key, map);
        Document { layers: vec![layer.clone(), layer], edges: Edges::Wrap, ..Document::default() }
    }

    fn noise_of(octaves: u32) -> LayerMap {
        LayerMap { source: MapSource::Noise { size: 60.0, octaves }, range: [0.0, 1.0] }
    }

    fn numbers(document: &Document, index: usize) -> Vec<f64> {
        let of = modulation(document, index, [512.0, 512.0]).expect("a map");
        of.attributes[0].values.clone()
    }

    #[test]
    fn black_has_the_first_and_white_the_second_number_of_the_range() {
        let image = ToneImage::new([2, 1], vec![0, 255]).expect("two px");
        let map = LayerMap { source: MapSource::Image { image, factor: false }, range: [300.0, 100.0] };
        let of = numbers(&document(MapKey::Area, map), 0);
        assert_eq!([of[0], of[63], of[64 * 64 - 1]], [300.0, 100.0, 100.0]);
    }

    #[test]
    fn noise_takes_the_whole_range_whatever_its_octaves_and_differs_by_layer_and_key() {
        let of = |octaves, key, index| numbers(&document(key, noise_of(octaves)), index);
        for octaves in [1, 3, 8] {
            let all = of(octaves, MapKey::Area, 0);
            let mean = all.iter().sum::<f64>() / all.len() as f64;
            let deviation =
                (all.iter().map(|one| (one - mean).powi(2)).sum::<f64>() / all.len() as f64).sqrt();
            assert!(
                (mean - 0.5).abs() < 0.08 && (deviation - 0.22).abs() < 0.04,
                "{octaves}: {mean} {deviation}"
            );
        }
        assert_eq!(of(2, MapKey::Area, 0), of(2, MapKey::Area, 0));
        assert!(of(2, MapKey::Area, 0) != of(2, MapKey::Area, 1));
        assert!(of(2, MapKey::Area, 0) != of(2, MapKey::Spacing, 0));
    }

    #[test]
    fn colours_shift_or_multiply_about_the_edge_and_stay_in_the_gradient() {
        let image = ToneImage::new([1, 1], vec![255]).expect("a px");
        let place = |factor, high, value| {
            let source = MapSource::Image { image: image.clone(), factor };
            let document = document(MapKey::Colour, LayerMap { source, range: [0.0, high] });
            assert!(modulation(&document, 0, [512.0, 512.0]).is_none());
            ColourMap::of(&document, 0, [512.0, 512.0]).expect("a map").place(value, [100.0, 100.0])
        };
        // The ends move by the whole shift; halfway to the edge colours move by half of it.
        assert_eq!(
            [0.0, 0.25, 0.5, 0.75, 1.0].map(|value| place(false, 0.25, value)),
            [0.25, 0.375, 0.5, 0.875, 1.0]
        );
        assert_eq!(
            [0.0, 0.25, 0.5, 0.75, 1.0].map(|value| place(false, -0.25, value)),
            [0.0, 0.125, 0.5, 0.625, 0.75]
        );
        assert_eq!(
            [0.0, 0.25, 0.5, 0.75, 1.0].map(|value| place(true, 0.5, value)),
            [0.25, 0.375, 0.5, 0.625, 0.75]
        );
        assert_eq!([place(true, 4.0, 0.4), place(true, 4.0, 0.9)], [0.100_000_024, 1.0]);
    }
}
