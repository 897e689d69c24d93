//! Compares flat maps of parametric surfaces, corrected by the metric, with growth on a mesh of the same surface.

use std::f64::consts::TAU;
use std::sync::Arc;

use dapple_engine::attributes::Spots;
use dapple_engine::attributes::metric_field::Metric;
use dapple_engine::document::{
    Body, BodySource, Document, Edges, Ellipse, Layer, ParametricSurface, Relief, Stroke,
};
use dapple_engine::grid::Field;
use dapple_engine::measure::{Spot, spots, surface_edges, surface_spots};
use dapple_engine::surface::{HeightField, Mesh, Surface, SurfacePoint};
use dapple_engine::synth::body::BodyGrowth;
use dapple_engine::synth::{Growth, Options};

use super::triangulations::Triangulation;
use super::{mean, variation};

/// Distance of round spots on the surface, px.
const SPACING: f64 = 40.0;
/// Radius of the spots, px (area 141 px²).
const RADIUS: f64 = 6.7;
/// Pattern at the edge of a mark.
const EDGE: f32 = 0.5;
/// The step between vertices of the mesh on which a flat map is measured, px of the canvas.
const STEP: usize = 2;

/// A surface that has a flat map.
pub struct Case {
    /// Its name in tables.
    pub name: &'static str,
    /// The canvas, px.
    size: [u32; 2],
    edges: Edges,
    surface: ParametricSurface,
    /// The place on the surface of a point of the canvas, px.
    at: fn([f64; 2]) -> [f64; 3],
}

/// Hills up to this height, px.
const HEIGHT: f64 = 160.0;
/// The canvas of the hills, px.
const HILLS: [u32; 2] = [720, 600];
/// The canvas of the torus, px: the circumferences of its ring and of its tube, radii × 2π.
const TORUS: [u32; 2] = [960, 360];

/// Heights of hills with slopes up to about 1.3, as shares of [`HEIGHT`].
fn hills([x, y]: [f64; 2]) -> f64 {
    let hill =
        |[a, b]: [f64; 2], wide: f64| libm::exp(-((x - a) * (x - a) + (y - b) * (y - b)) / (wide * wide));
    let ridge = 0.5 + 0.5 * libm::sin(TAU * (x + 0.4 * y) / 420.0);
    0.55 * hill([230.0, 220.0], 90.0) + 0.5 * hill([520.0, 380.0], 80.0) + 0.3 * ridge
}

fn on_hills([x, y]: [f64; 2]) -> [f64; 3] {
    // Seen from above, the canvas lies as it is drawn: y runs down.
    [x, -y, HEIGHT * hills([x, y])]
}

fn on_torus([x, y]: [f64; 2]) -> [f64; 3] {
    let [wide, thin] = TORUS.map(|side| f64::from(side) / TAU);
    let (around, (sin, cos)) = (TAU * x / f64::from(TORUS[0]), libm::sincos(TAU * y / f64::from(TORUS[1])));
    let radius = wide + thin * cos;
    let (s, c) = libm::sincos(around);
    [radius * c, radius * s, -thin * sin]
}

/// Hills and a torus.
pub fn cases() -> Result<[Case; 2], String> {
    let [width, height] = HILLS.map(|side| side as usize);
    let value = |index: usize| {
        let at = [index % width, index / width].map(|place| place as f64 + 0.5);
        hills(at) as f32
    };
    let heights = HeightField::new([width, height], (0..width * height).map(value).collect());
    let heights = heights.map(Arc::new).ok_or("no heights")?;
    let relief = Relief { heights: Ok(heights), ..Relief::new("hills.png".to_owned(), HEIGHT) };
    let surface = ParametricSurface::Heights(relief);
    Ok([
        Case { name: "hills", size: HILLS, edges: Edges::Closed, surface, at: on_hills },
        Case {
            name: "torus",
            size: TORUS,
            edges: Edges::Wrap,
            surface: ParametricSurface::Torus,
            at: on_torus,
        },
    ])
}

/// Means of whole spots on a surface.
#[derive(Clone, Copy, Debug)]
pub struct Means {
    /// The number of spots.
    pub spots: usize,
    /// Mean area, px².
    pub area: f64,
    /// The coefficient of variation of the areas.
    pub variation: f64,
    /// Mean spacing, px.
    pub spacing: f64,
    /// Mean of minor ÷ major radius.
    pub aspect: f64,
}

/// Round spots in a hexagonal lattice.
fn layer() -> Layer {
    let at = |i: i32| {
        let shift = 0.5 * f64::from(i / 5 % 2);
        [60.0 + SPACING * (f64::from(i % 5) + shift), 60.0 + SPACING * 0.75_f64.sqrt() * f64::from(i / 5)]
    };
    Layer::new((0..25).map(|i| Stroke::ellipse(at(i), [RADIUS; 2], 0.0)))
}

impl Case {
    /// The surface as a mesh with a vertex for every `step` px of the canvas.
    fn mesh(&self, step: usize) -> Mesh {
        let [width, height] = self.size.map(|side| side as usize / step);
        let is_closed = self.edges == Edges::Closed;
        let vertex = |column: usize, row: usize| ((row % height) * width + column % width) as u32;
        let place = |index: usize| (self.at)(self.on_canvas(index, step));
        let squares = [width, height].map(|count| count - usize::from(is_closed));
        let square = |index: usize| {
            let (column, row) = (index % squares[0], index / squares[0]);
            let [a, b] = [vertex(column, row), vertex(column + 1, row)];
            let [c, d] = [vertex(column, row + 1), vertex(column + 1, row + 1)];
            // Down on the canvas is to the right on the surface, seen from outside.
            [[a, c, b], [b, c, d]]
        };
        let faces = (0..squares[0] * squares[1]).flat_map(square).collect();
        Mesh { positions: (0..width * height).map(place).collect(), faces }
    }

    /// The point of the canvas for a vertex, px.
    fn on_canvas(&self, vertex: usize, step: usize) -> [f64; 2] {
        let width = self.size[0] as usize / step;
        [vertex % width, vertex / width].map(|place| (place as f64 + 0.5) * step as f64)
    }

    fn document(&self, parametric: Option<ParametricSurface>, seed: u64) -> Document {
        let sketch = Document::new(self.size).with_layer(layer());
        Document { parametric, edges: self.edges, regions: Some([1, 1]), seed, ..sketch }
    }

    /// Grows the flat map, with the metric or as if it were flat, and measures it on the surface.
    pub fn flat(&self, corrected: bool, seed: u64) -> Result<Means, String> {
        let pattern = self.pattern(corrected, seed)?;
        let surface = Surface::new(self.mesh(STEP), [1.0, 0.0, 0.0]);
        let spots = spots(&pattern, EDGE);
        let places: Vec<SurfacePoint> =
            spots.iter().map(|spot| surface.closest((self.at)(spot.ellipse.center))).collect();
        let on_surface = |spot: &Spot| {
            let Ellipse { center, .. } = spot.ellipse;
            let [area, aspect, angle] =
                [spot.ellipse.area(), spot.ellipse.aspect(), spot.ellipse.major_angle()];
            self.metric(center).spots_to_surface(&Spots { area, aspect, angle, spacing: None })
        };
        let whole =
            spots.iter().filter(|spot| spot.whole).map(on_surface).map(|spot| [spot.area, spot.aspect]);
        Ok(Means::new(&whole.collect::<Vec<_>>(), &surface, &places))
    }

    /// The surface as a mesh, and at its vertices the pattern of the flat map, grown with the metric or as if it were flat.
    pub fn flat_map(&self, corrected: bool, seed: u64) -> Result<(Mesh, Vec<f32>), String> {
        Ok((self.mesh(STEP), self.pattern(corrected, seed)?.values))
    }

    fn pattern(&self, corrected: bool, seed: u64) -> Result<Field, String> {
        let document = self.document(corrected.then(|| self.surface.clone()), seed);
        let grown = Growth::begin(&document, &Options::default(), None).run();
        let grown = grown.map_err(|error| error.to_string())?;
        let [width, height] = self.size.map(|side| side as usize / STEP);
        let pattern = grown.layers[0].pattern().field(width, height);
        Ok(Field { cell: [STEP as f64; 2], edges: self.edges, ..pattern })
    }

    /// The metric at a point of the canvas, by finite differences.
    fn metric(&self, [x, y]: [f64; 2]) -> Metric {
        const STEP: f64 = 1e-3;
        let slope = |[dx, dy]: [f64; 2]| {
            let [after, before] = [(self.at)([x + dx, y + dy]), (self.at)([x - dx, y - dy])];
            [0, 1, 2].map(|axis| (after[axis] - before[axis]) / (2.0 * STEP))
        };
        let (along_x, along_y) = (slope([STEP, 0.0]), slope([0.0, STEP]));
        let product = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        Metric { xx: product(along_x, along_x), xy: product(along_x, along_y), yy: product(along_y, along_y) }
    }

    /// Grows on a mesh of the surface.
    pub fn meshed(&self, seed: u64) -> Result<Means, String> {
        let mesh = self.mesh(6);
        let [low, high] = mesh.bounds();
        let px = (0..3).map(|axis| high[axis] - low[axis]).fold(0.0, f64::max);
        let source = BodySource::File { path: "surface.obj".to_owned(), sha256: None };
        let model = Some(Body { px, ..Body::new(source) });
        let document = Document { model, seed, ..Document::new([320, 320]).with_layer(layer()) };
        let obj = Triangulation::of_triangles(self.name, mesh).obj();
        let growth = BodyGrowth::begin(&document, Some(obj.as_bytes()), &Options::default());
        let grown = growth.map_err(|error| error.to_string())?.run().map_err(|error| error.to_string())?;
        Ok(means(grown.layers[0].plan.surface(), &grown.layers[0].levelled.pattern))
    }
}

fn means(surface: &Surface, pattern: &[f32]) -> Means {
    let spots = surface_spots(surface, pattern, &vec![EDGE; pattern.len()]);
    let places: Vec<SurfacePoint> = spots.iter().map(|spot| spot.place).collect();
    let whole = spots.iter().filter(|spot| spot.whole).map(|spot| [spot.area, spot.radii[1] / spot.radii[0]]);
    Means::new(&whole.collect::<Vec<_>>(), surface, &places)
}

impl Means {
    /// Means of the areas and aspects of whole spots, and of the distances of all places.
    fn new(whole: &[[f64; 2]], surface: &Surface, places: &[SurfacePoint]) -> Self {
        let edges = surface_edges(surface, places);
        let [sum, length] = edges.iter().fold([0.0; 2], |[sum, length], edge| {
            let weight = edge.weight(SPACING);
            [sum + weight, length + weight * edge.length]
        });
        Self {
            spots: places.len(),
            area: mean(whole.iter().map(|[area, _]| *area)),
            variation: variation(whole.iter().map(|[area, _]| *area)),
            spacing: length / sum,
            aspect: mean(whole.iter().map(|[_, aspect]| *aspect)),
        }
    }
}

/// Prints the means over all seeds: of the flat map, of the mesh, and of a flat map that is not corrected.
pub fn table(seeds: u64) -> Result<(), String> {
    crate::say("| surface | way | spots | area, px² | its variation | spacing, px | aspect |")?;
    crate::say("|---|---|---|---|---|---|---|")?;
    for case in cases()? {
        type Way<'a> = (&'static str, &'a dyn Fn(u64) -> Result<Means, String>);
        let ways: [Way; 3] = [
            ("flat map, by the metric", &|seed| case.flat(true, seed)),
            ("mesh", &|seed| case.meshed(seed)),
            ("flat map, not corrected", &|seed| case.flat(false, seed)),
        ];
        for (name, way) in ways {
            let found = (1..=seeds).map(way).collect::<Result<Vec<Means>, _>>()?;
            let of = |value: fn(&Means) -> f64| mean(found.iter().map(value));
            crate::say(&format!(
                "| {} | {name} | {:.1} | {:.2} | {:.3} | {:.2} | {:.3} |",
                case.name,
                of(|means| means.spots as f64),
                of(|means| means.area),
                of(|means| means.variation),
                of(|means| means.spacing),
                of(|means| means.aspect),
            ))?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_flat_map_by_the_metric_has_the_spots_of_the_mesh() {
        for case in cases().expect("surfaces") {
            let [flat, mesh] = [case.flat(true, 1), case.meshed(1)].map(|means| means.expect("it grows"));
            let apart = |of: fn(&Means) -> f64| (of(&flat) / of(&mesh) - 1.0).abs();
            let found = format!("{}: {flat:?} {mesh:?}", case.name);
            assert!(apart(|means| means.area) < 0.02, "{found}");
            assert!(apart(|means| means.spacing) < 0.02, "{found}");
            assert!(apart(|means| means.aspect) < 0.02, "{found}");
            // At a border, the map also has halves of spots.
            assert!(case.edges == Edges::Closed || apart(|means| means.spots as f64) < 0.03, "{found}");
        }
    }
}
