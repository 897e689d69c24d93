//! Automatic texture coordinates: pieces that are nearly flat, laid out side by side.

use uvunwrap::{Density, Error, MeshInput, Options, generate};

use super::atlas::Atlas;
use super::corners::Corners;
use crate::surface::Model;

/// The side of the picture for which pieces are laid out, texels.
const SIDE: u32 = 1_024;
/// Texels of that picture around each piece.
const PADDING: u32 = 4;

/// The atlas of the parts of a model for which `is_grown` holds, with coordinates of its own. All of them are in one picture.
///
/// # Errors
/// The triangles cannot be laid out in one picture: why, and what to do.
pub fn automatic(model: &Model, is_grown: &dyn Fn(usize) -> bool) -> Result<Atlas, String> {
    let corners = Corners::new(model, is_grown);
    let [low, high] = model.bounds();
    let size = (0..3).map(|axis| high[axis] - low[axis]).fold(f64::MIN_POSITIVE, f64::max);
    // About the origin and of size 1, so that no product of lengths is too large or too small for 32 bits.
    let place = |at: &[f64; 3]| [0, 1, 2].map(|axis| finite((at[axis] - low[axis]) / size));
    let positions: Vec<[f32; 3]> = corners.mesh.positions.iter().map(place).collect();
    let indices: Vec<u32> = corners.mesh.faces.iter().flatten().copied().collect();
    let options =
        Options { density: Density::Auto { page_size: SIDE }, padding: PADDING, ..Options::default() };
    let remedy = "give the model texture coordinates in a modeller, such as Blender, and export it again";
    let refused = |error: Error| format!("no texture coordinates can be made for it ({error}); {remedy}");
    let laid = generate(&[MeshInput::new(&positions, &indices)], &options).map_err(refused)?;
    if laid.page_count > 1 {
        return Err(format!("its {} pieces do not fit into one texture; {remedy}", laid.chart_count));
    }
    // The page ends where it is empty: the picture is square.
    let scale =
        [laid.width, laid.height].map(|side| f64::from(side) / f64::from(laid.width.max(laid.height)));
    let of_corner = |index: &u32| {
        let uv = laid.meshes[0].vertices[*index as usize].uv;
        [0, 1].map(|axis| f64::from(uv[axis]) * scale[axis])
    };
    let uvs: Vec<[[f64; 2]; 3]> = laid.meshes[0]
        .indices
        .chunks_exact(3)
        .map(|corners| [of_corner(&corners[0]), of_corner(&corners[1]), of_corner(&corners[2])])
        .collect();
    Ok(Atlas::new(&corners, &uvs))
}

fn finite(value: f64) -> f32 {
    let value = value as f32;
    if value.is_finite() { value } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::built_in;

    #[test]
    fn a_shell_without_coordinates_gets_few_pieces_that_do_not_overlap_and_are_not_mirrored() {
        let shell = built_in("shell").expect("a body");
        let atlas = automatic(&shell, &|_| true).expect("coordinates");
        assert!((2..200).contains(&atlas.charts), "{}", atlas.charts);
        assert_eq!(atlas.mesh.faces.len(), shell.faces.len());
        assert!(atlas.uvs.iter().flatten().all(|part| (0.0..=1.0).contains(part)));
        let share = |is_mirrored: bool| {
            let signs = atlas.tangents.iter().filter(|tangent| (tangent[3] < 0.0) == is_mirrored);
            signs.count() as f64 / atlas.tangents.len() as f64
        };
        assert!(share(true) < 0.01, "{}", share(true));
        // Written as a model and read again, its coordinates are fit.
        let corners = Corners::new(&shell, &|_| true);
        let of_face = |face: &[u32; 3]| face.map(|vertex| atlas.uvs[vertex as usize]);
        let uvs = atlas.mesh.faces.iter().map(of_face).collect();
        assert!(super::super::own::overlap_of(&Corners { uvs, ..corners }) < 1e-3);
    }
}
