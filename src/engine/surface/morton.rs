//! Vertices and faces in the order of a space-filling curve, so that neighbours are close in memory.
//!
//! G. M. Morton, "A computer oriented geodetic data base and a new technique in file sequencing", IBM 1966.

use super::mesh::Mesh;

/// Base-2 logarithm of the number of steps along each axis.
const BITS: u32 = 21;

/// Distributes the lowest 21 bits of `x` to every third bit of the result.
fn spread(x: u64) -> u64 {
    let mut x = x & 0x1f_ffff;
    x = (x | x << 32) & 0x001f_0000_0000_ffff;
    x = (x | x << 16) & 0x001f_0000_ff00_00ff;
    x = (x | x << 8) & 0x100f_00f0_0f00_f00f;
    x = (x | x << 4) & 0x10c3_0c30_c30c_30c3;
    (x | x << 2) & 0x1249_2492_4924_9249
}

/// The positions of points of a box along the curve.
pub fn codes(points: &[[f64; 3]], [low, high]: [[f64; 3]; 2]) -> Vec<u64> {
    let size = (0..3).map(|axis| high[axis] - low[axis]).fold(f64::MIN_POSITIVE, f64::max);
    let scale = f64::from(1u32 << BITS) * (1.0 - 1e-9) / size;
    let code = |at: &[f64; 3]| {
        (0..3).map(|axis| spread(((at[axis] - low[axis]) * scale) as u64) << axis).sum::<u64>()
    };
    points.iter().map(code).collect()
}

/// The mesh with its vertices in the order of their codes.
pub fn ordered(mesh: &Mesh) -> Mesh {
    let codes = codes(&mesh.positions, mesh.bounds());
    let mut order: Vec<u32> = (0..mesh.positions.len() as u32).collect();
    order.sort_by_key(|vertex| (codes[*vertex as usize], *vertex));
    let mut new = vec![0; order.len()];
    order.iter().enumerate().for_each(|(place, vertex)| new[*vertex as usize] = place as u32);
    let renamed = |face: &[u32; 3]| {
        let [a, b, c] = face.map(|vertex| new[vertex as usize]);
        // The lowest index first, with the same orientation.
        if a < b && a < c {
            [a, b, c]
        } else if b < c {
            [b, c, a]
        } else {
            [c, a, b]
        }
    };
    let mut faces: Vec<[u32; 3]> = mesh.faces.iter().map(renamed).collect();
    faces.sort_unstable();
    Mesh { positions: order.iter().map(|vertex| mesh.positions[*vertex as usize]).collect(), faces }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::test_meshes::sphere;

    #[test]
    fn bits_of_three_axes_alternate() {
        assert_eq!(spread(0b1011), 0b1_000_001_001);
        assert_eq!(spread(0x1f_ffff), 0x1249_2492_4924_9249);
    }

    #[test]
    fn the_order_does_not_depend_on_the_one_before_and_neighbours_are_near() {
        let mesh = sphere(24, 3.0);
        let count = mesh.positions.len();
        let mixed = |vertex: u32| (u64::from(vertex) * 7_919 % count as u64) as u32;
        let mut positions = vec![[0.0; 3]; count];
        (0..count).for_each(|vertex| positions[mixed(vertex as u32) as usize] = mesh.positions[vertex]);
        let faces = mesh.faces.iter().rev().map(|[a, b, c]| [b, c, a].map(|vertex| mixed(*vertex))).collect();
        let (ordered, again) = (ordered(&mesh), ordered(&Mesh { positions, faces }));
        assert_eq!(ordered, again);
        let apart = |mesh: &Mesh| {
            let far = mesh.faces.iter().map(|[a, b, _]| f64::from(a.abs_diff(*b)));
            far.sum::<f64>() / mesh.faces.len() as f64
        };
        assert!(apart(&ordered) < 0.2 * count as f64, "{}", apart(&ordered));
        assert!((ordered.volume() - mesh.volume()).abs() < 1e-9);
    }
}
