//! Pieces of a texture: triangles that are joined in it by common edges.

use std::collections::BTreeMap;

/// Which triangles of a texture are joined.
#[derive(Clone, Debug)]
pub struct Islands {
    /// How many pieces there are.
    pub charts: usize,
    /// By triangle and side, whether no other triangle is joined there. Side k follows corner k.
    pub is_rim: Vec<[bool; 3]>,
}

/// A corner in the texture: its position and its coordinates.
type Corner = (u32, [u64; 2]);

impl Islands {
    /// The pieces of triangles with the texture coordinates `uvs` of their corners.
    pub fn new(faces: &[[u32; 3]], uvs: &[[[f64; 2]; 3]]) -> Self {
        let corner = |face: usize, at: usize| -> Corner {
            (faces[face][at % 3], uvs[face][at % 3].map(|part| (part + 0.0).to_bits()))
        };
        let mut sides: BTreeMap<[Corner; 2], Vec<(usize, usize)>> = BTreeMap::new();
        for face in 0..faces.len() {
            for side in 0..3 {
                let [a, b] = [corner(face, side), corner(face, side + 1)];
                sides.entry(if a < b { [a, b] } else { [b, a] }).or_default().push((face, side));
            }
        }
        let mut is_rim = vec![[false; 3]; faces.len()];
        let mut root: Vec<usize> = (0..faces.len()).collect();
        for joined in sides.values() {
            if let [(face, side)] = joined[..] {
                is_rim[face][side] = true;
            }
            for pair in joined.windows(2) {
                let [a, b] = [pair[0].0, pair[1].0].map(|face| find(&mut root, face));
                root[a.max(b)] = a.min(b);
            }
        }
        let charts = (0..faces.len()).filter(|face| root[*face] == *face).count();
        Self { charts, is_rim }
    }
}

/// The first triangle of a piece.
fn find(root: &mut [usize], face: usize) -> usize {
    let mut at = face;
    while root[at] != at {
        root[at] = root[root[at]];
        at = root[at];
    }
    at
}

#[cfg(test)]
mod tests {
    use crate::export::bake::own;
    use crate::surface::built_in;

    #[test]
    fn a_cube_has_six_pieces_with_twenty_four_times_four_rims_each() {
        let atlas = own(&built_in("cube").expect("a body"), &|_| true).expect("coordinates");
        assert_eq!(atlas.charts, 6);
        assert_eq!(atlas.is_rim.iter().flatten().filter(|is_rim| **is_rim).count(), 6 * 4 * 24);
        // Each side is seen from outside: no coordinate is shared with another side, and 25² vertices have one each.
        assert_eq!(atlas.uvs.len(), 6 * 25 * 25);
        assert!(atlas.tangents.iter().all(|tangent| tangent[3] == 1.0), "none is mirrored");
    }
}
