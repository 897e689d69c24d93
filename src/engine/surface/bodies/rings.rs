//! Surfaces of rings of vertices: revolved profiles and tubes.

use super::super::model::{Corner, Face, Model, Part};

/// A surface of successive rings. All rings have equal numbers of vertices, except poles, which have one. Seen from outside the
/// vertices of a ring run to the right if the next ring is above. Texture coordinates run once around and once along.
pub fn surface(rings: &[Vec<[f64; 3]>], is_closed: bool) -> Model {
    let around = rings.iter().map(Vec::len).max().unwrap_or(0);
    let mut model = Model { parts: vec![Part::default()], ..Model::default() };
    let mut starts = Vec::new();
    for ring in rings {
        starts.push(model.positions.len());
        model.positions.extend(ring);
    }
    let rows = if is_closed { rings.len() } else { rings.len() - 1 };
    for row in 0..=rows {
        let v = row as f64 / rows as f64;
        model.uvs.extend((0..=around).map(|column| [column as f64 / around as f64, v]));
    }
    let corner = |row: usize, column: usize| {
        let ring = row % rings.len();
        let position = starts[ring] + column % rings[ring].len();
        Corner { uv: Some((row * (around + 1) + column) as u32), ..Corner::from(position as u32) }
    };
    for row in 0..rows {
        let [is_below, is_above] = [row, row + 1].map(|row| rings[row % rings.len()].len() > 1);
        for column in 0..around {
            let [a, b] = [corner(row, column), corner(row, column + 1)];
            let [c, d] = [corner(row + 1, column + 1), corner(row + 1, column)];
            let lower = is_below.then_some([a, b, c]);
            let upper = is_above.then_some([a, c, d]);
            model.faces.extend(lower.into_iter().chain(upper).map(|corners| Face { corners, part: 0 }));
        }
    }
    model
}

/// The directions of a full turn in this many steps: cosine and sine.
pub fn turn(steps: usize) -> impl Iterator<Item = [f64; 2]> {
    (0..steps).map(move |step| {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * step as f64 / steps as f64);
        [cos, sin]
    })
}
