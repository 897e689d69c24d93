//! A cube with sharp edges.

use std::collections::BTreeMap;

use super::super::model::{Corner, Face, Model, Part};

/// Squares along an edge.
const ALONG: i32 = 24;

/// A cube of side 2. Its sides lie in the texture in three columns and two rows.
pub fn cube() -> Model {
    let mut model = Model { parts: vec![Part::default()], ..Model::default() };
    let mut vertices: BTreeMap<[i32; 3], u32> = BTreeMap::new();
    for side in 0..6 {
        let (axis, is_high) = (side % 3, side >= 3);
        let start = model.uvs.len() as u32;
        let mut corners = Vec::new();
        for v in 0..=ALONG {
            for u in 0..=ALONG {
                let mut place = [0; 3];
                place[axis] = if is_high { ALONG } else { 0 };
                // Right-handed with the normal, which points outward.
                place[(axis + 1) % 3] = if is_high { u } else { ALONG - u };
                place[(axis + 2) % 3] = v;
                let next = vertices.len() as u32;
                let position = *vertices.entry(place).or_insert_with(|| {
                    model.positions.push(place.map(|at| 2.0 * f64::from(at) / f64::from(ALONG) - 1.0));
                    next
                });
                let [u, v] = [u, v].map(|at| f64::from(at) / f64::from(ALONG));
                model.uvs.push([(axis as f64 + u) / 3.0, (f64::from(u8::from(is_high)) + v) / 2.0]);
                corners.push(Corner { uv: Some(start + corners.len() as u32), ..Corner::from(position) });
            }
        }
        let row = ALONG as usize + 1;
        for at in (0..row * (row - 1)).filter(|at| at % row < row - 1) {
            let [a, b, c, d] = [at, at + 1, at + row + 1, at + row].map(|at| corners[at]);
            model.faces.extend([[a, b, c], [a, c, d]].map(|corners| Face { corners, part: 0 }));
        }
    }
    model
}
