//! Pictures of the steps of Turk's method side by side, like figure 7 of the paper.

use std::path::Path;

use dapple::files;
use dapple_engine::export::body::{Paint, Painted, Picture, View, draw, normals};
use dapple_engine::export::{Format, picture};
use dapple_engine::grid::Domain;
use dapple_engine::surface::voronoi::{RelaxedPoints, WeightedSum, random_points};
use dapple_engine::surface::{Mesh, Surface};
use rayon::prelude::*;

use super::parametric;
use super::triangulations::{animal, evenly};
use super::turk::{Points, grown};

/// Width and height of each picture, px.
const SIZE: [u32; 2] = [560, 400];
/// Pictures side by side.
const COLUMNS: usize = 3;
/// Vertices of the surface that carries the colours.
const VERTICES: f64 = 120_000.0;
/// The number of spots, about: with few spots there are as few points as in the paper.
const SPOTS: f64 = 40.0;
/// Points per spacing, which gives 1,250 points.
const FINENESS: f64 = 6.0;
/// Radius of a point, radii of repulsion.
const DOT: f64 = 0.16;
/// Linear light of the ground, of the points and of the spots.
const COLOURS: [[f32; 3]; 3] = [[0.80, 0.78, 0.74], [0.02, 0.03, 0.08], [0.03, 0.08, 0.40]];

/// Draws the six steps.
pub fn save(output: &Path) -> Result<(), String> {
    let model = animal()?;
    let points = Points { fineness: FINENESS, ..Points::USUAL };
    let grown = grown(&model, SPOTS, points, 1)?;
    let random = RelaxedPoints {
        places: random_points(&grown.surface, grown.points.places.len(), 1),
        radius: grown.points.radius,
    };
    let mesh = evenly(&model, VERTICES);
    let fine = Surface::new(mesh, [1.0, 0.0, 0.0]);
    let on = |vertex: usize| grown.surface.closest_facing(fine.mesh.positions[vertex], fine.normal(vertex));
    let nearest = |points: &RelaxedPoints| -> Vec<Option<(usize, f64)>> {
        let sums = WeightedSum::new(&grown.surface, points);
        (0..fine.cells()).into_par_iter().map(|vertex| sums.nearest(on(vertex))).collect()
    };
    let [scattered, relaxed] = [nearest(&random), nearest(&grown.points)];
    let dots = |nearest: &[Option<(usize, f64)>]| -> Vec<[f32; 3]> {
        let dot =
            |found: &Option<(usize, f64)>| found.is_some_and(|(_, far)| far < DOT * grown.points.radius);
        nearest.iter().map(|found| COLOURS[usize::from(dot(found))]).collect()
    };
    let by_point = |colour: &dyn Fn(usize) -> [f32; 3]| -> Vec<[f32; 3]> {
        relaxed.iter().map(|found| found.map_or(COLOURS[0], |(point, _)| colour(point))).collect()
    };
    let sums = WeightedSum::new(&grown.surface, &grown.points);
    let smooth: Vec<f32> = (0..fine.cells())
        .into_par_iter()
        .map(|vertex| sums.at(on(vertex), &grown.marks).unwrap_or_default())
        .collect();
    let panels: [(&Mesh, Vec<[f32; 3]>); 6] = [
        (&model, vec![COLOURS[0]; model.positions.len()]),
        (&fine.mesh, dots(&scattered)),
        (&fine.mesh, dots(&relaxed)),
        (&fine.mesh, by_point(&cell_colour)),
        (&fine.mesh, by_point(&|point| shade(grown.marks[point]))),
        (&fine.mesh, smooth.into_iter().map(shade).collect()),
    ];
    let pictures: Vec<Picture> = panels.iter().map(|(mesh, colours)| panel(mesh, colours)).collect();
    write(output, &pictures)
}

/// Draws a flat map of hills, the hills with it, and with a map that is not corrected.
pub fn save_heights(output: &Path) -> Result<(), String> {
    let [hills, _] = parametric::cases()?;
    let [corrected, flat] = [true, false].map(|corrected| hills.flat_map(corrected, 1));
    let ((mesh, corrected), (_, flat)) = (corrected?, flat?);
    // Heights are z; up is y.
    let upright = |height: f64| {
        let positions = mesh.positions.iter().map(|[x, y, z]| [*x, height * z, -y]).collect();
        Mesh { positions, faces: mesh.faces.clone() }
    };
    let shown = |mesh: &Mesh, pattern: &[f32], view: [f64; 2]| {
        let colours: Vec<[f32; 3]> = pattern.iter().map(|value| shade(2.0 * value - 0.5)).collect();
        seen(mesh, &colours, view)
    };
    let (plane, hills) = (upright(0.0), upright(1.0));
    let aside = [-25.0, 40.0];
    let pictures = [
        shown(&plane, &corrected, [0.0, 90.0]),
        shown(&hills, &corrected, aside),
        shown(&hills, &flat, aside),
    ];
    write(output, &pictures)
}

/// One of a few light colours.
fn cell_colour(point: usize) -> [f32; 3] {
    let part = |k: usize| 0.25 + 0.6 * ((point * (2 * k + 7) * 29 % 97) as f32 / 97.0);
    [part(0), part(1), part(2)]
}

/// From the ground to a spot.
fn shade(value: f32) -> [f32; 3] {
    let share = value.clamp(0.0, 1.0);
    std::array::from_fn(|i| COLOURS[0][i] + share * (COLOURS[2][i] - COLOURS[0][i]))
}

fn panel(mesh: &Mesh, colours: &[[f32; 3]]) -> Picture {
    seen(mesh, colours, [-30.0, 15.0])
}

/// A mesh with a colour for each vertex, seen from this azimuth and elevation, degrees.
fn seen(mesh: &Mesh, colours: &[[f32; 3]], [azimuth, elevation]: [f64; 2]) -> Picture {
    let shown = normals(mesh);
    let view = View::new(azimuth, elevation, SIZE);
    draw(&[Painted { mesh, normals: &shown, paint: Paint::Colours(colours) }], &view)
}

/// Writes pictures of the same size side by side.
fn write(output: &Path, pictures: &[Picture]) -> Result<(), String> {
    let [width, height] = SIZE.map(|side| side as usize);
    let rows = pictures.len().div_ceil(COLUMNS);
    let size = [width * COLUMNS, height * rows];
    let mut rgb = vec![0; 3 * size[0] * size[1]];
    for (index, picture) in pictures.iter().enumerate() {
        let [left, top] = [index % COLUMNS * width, index / COLUMNS * height];
        let shown = picture.rgb();
        for (row, line) in shown.chunks_exact(3 * width).enumerate() {
            let at = 3 * ((top + row) * size[0] + left);
            rgb[at..at + line.len()].copy_from_slice(line);
        }
    }
    let saved = files::save(output, |out| picture::rgb8(out, Format::Png, size, &rgb));
    saved.map_err(|error| error.to_string())
}
