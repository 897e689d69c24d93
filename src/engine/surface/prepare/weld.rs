//! Joins vertices at one place, and drops the faces that degenerate.

use std::collections::BTreeMap;

use super::{Repairs, flatness};
use crate::surface::adjacency::{Adjacency, NONE, next, previous};
use crate::surface::mesh::Mesh;
use crate::surface::vector::{distance, dot, minus};

/// Joins vertices nearer to each other than `near`. Returns the old index of each vertex that is left.
pub fn weld(mesh: &mut Mesh, near: f64, repairs: &mut Repairs) -> Vec<usize> {
    let mut is_used = vec![false; mesh.positions.len()];
    mesh.faces.iter().flatten().for_each(|vertex| is_used[*vertex as usize] = true);
    // Candidates are in boxes of twice the distance, and in the adjacent boxes.
    let cell = |at: [f64; 3]| at.map(|part| (part / (2.0 * near)).floor() as i64);
    let mut boxes: BTreeMap<[i64; 3], Vec<u32>> = BTreeMap::new();
    let mut kept: Vec<usize> = Vec::new();
    let mut new = vec![0u32; mesh.positions.len()];
    for vertex in (0..mesh.positions.len()).filter(|vertex| is_used[*vertex]) {
        let at = mesh.positions[vertex];
        let (low, high) = (cell(at.map(|part| part - near)), cell(at.map(|part| part + near)));
        let mut found: Option<u32> = None;
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    let same = boxes.get(&[x, y, z]).into_iter().flatten();
                    let same =
                        same.filter(|other| distance(mesh.positions[kept[**other as usize]], at) <= near);
                    found = found.into_iter().chain(same.copied()).min();
                }
            }
        }
        new[vertex] = found.unwrap_or_else(|| {
            boxes.entry(cell(at)).or_default().push(kept.len() as u32);
            kept.push(vertex);
            kept.len() as u32 - 1
        });
        repairs.welded += usize::from(found.is_some());
    }
    mesh.faces.iter_mut().for_each(|face| *face = face.map(|vertex| new[vertex as usize]));
    mesh.positions = kept.iter().map(|vertex| mesh.positions[*vertex]).collect();
    kept
}

/// Drops faces with two equal corners, and all but the first with the same corners.
pub fn drop_doubled(mesh: &mut Mesh, repairs: &mut Repairs) {
    let before = mesh.faces.len();
    mesh.faces.retain(|[a, b, c]| a != b && b != c && c != a);
    repairs.flat += before - mesh.faces.len();
    let mut sorted: Vec<([u32; 3], usize)> = (0..)
        .zip(&mesh.faces)
        .map(|(index, face)| {
            let mut corners = *face;
            corners.sort_unstable();
            (corners, index)
        })
        .collect();
    sorted.sort_unstable();
    let mut is_again = vec![false; mesh.faces.len()];
    for pair in sorted.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
        is_again[pair[1].1] = true;
    }
    let mut again = is_again.iter();
    let before = mesh.faces.len();
    mesh.faces.retain(|_| !again.next().is_some_and(|again| *again));
    repairs.doubled += before - mesh.faces.len();
}

/// Rounds of removing faces without area: each leaves fewer.
const ROUNDS: usize = 16;

/// Removes faces whose corners lie in a line: the longest side, which passes a corner, is flipped with the face beyond it, so that
/// no crack is left. If there is no such face, the face is dropped.
pub fn drop_flat(mesh: &mut Mesh, flat: f64, repairs: &mut Repairs) {
    for round in 0..ROUNDS {
        let is_flat = |mesh: &Mesh, face: usize| {
            let [height, longest] = flatness(mesh, face);
            height <= flat * longest
        };
        let found: Vec<usize> = (0..mesh.faces.len()).filter(|face| is_flat(mesh, *face)).collect();
        if found.is_empty() {
            return;
        }
        let adjacency = Adjacency::new(mesh.positions.len(), &mesh.faces);
        let mut is_changed = vec![false; mesh.faces.len()];
        let mut goes = vec![false; mesh.faces.len()];
        for face in found {
            let twin = adjacency.twins[longest_side(mesh, face) as usize];
            let beyond = twin as usize / 3;
            if twin == NONE || round + 1 == ROUNDS {
                goes[face] = true;
                repairs.flat += usize::from(!is_changed[face]);
            } else if !is_changed[face] && !is_changed[beyond] {
                flip(mesh, longest_side(mesh, face), twin);
                (is_changed[face], is_changed[beyond]) = (true, true);
                repairs.flat += 1;
            }
        }
        let mut goes = goes.iter();
        mesh.faces.retain(|_| !goes.next().is_some_and(|goes| *goes));
        drop_doubled(mesh, repairs);
    }
}

/// The half-edge of a face that is longest.
fn longest_side(mesh: &Mesh, face: usize) -> u32 {
    let corners = mesh.corners(face);
    let square = |k: usize| {
        let side = minus(corners[(k + 1) % 3], corners[k]);
        dot(side, side)
    };
    let longest = (0..3).max_by(|a, b| square(*a).total_cmp(&square(*b))).unwrap_or(0);
    (3 * face + longest) as u32
}

/// Replaces an edge by the one between the corners opposite to it.
fn flip(mesh: &mut Mesh, half: u32, twin: u32) {
    let at = |half: u32| mesh.faces[half as usize / 3][half as usize % 3];
    let [a, b, c, d] = [half, next(half), previous(half), previous(twin)].map(at);
    (mesh.faces[half as usize / 3], mesh.faces[twin as usize / 3]) = ([a, d, c], [d, b, c]);
}
