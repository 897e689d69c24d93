//! Height → normals.
//!
//! ```text
//! n = (−∂h/∂x, ∂h/∂y, 1) / |…|,  ∂h/∂x ≈ (h(x + 1) − h(x − 1)) / 2
//! ```
//!
//! h in px, x points right, y down in the picture; the y of n points up, as in OpenGL and glTF 2.0 (3.9.3). In DirectX it points
//! down.

use super::Height;

/// The direction of green in a normal map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Green {
    /// Up in the picture: OpenGL, glTF, Blender, Unity, Godot.
    Up,
    /// Down in the picture: DirectX, Unreal.
    Down,
}

/// The unit normal at each px; the margin is at least 1.
#[must_use]
pub fn normals(height: &Height) -> Vec<[f32; 3]> {
    let stride = height.stride();
    let mut normals = Vec::with_capacity(height.width * height.rows);
    for y in 0..height.rows {
        let start = height.start(y);
        for at in start..start + height.width {
            let h = &height.values;
            let (dx, dy) = ((h[at + 1] - h[at - 1]) / 2.0, (h[at + stride] - h[at - stride]) / 2.0);
            let length = (dx * dx + dy * dy + 1.0).sqrt();
            normals.push([-dx / length, dy / length, 1.0 / length]);
        }
    }
    normals
}

/// A normal as picture values 0..1: −1 becomes 0, 1 becomes 1.
#[must_use]
pub fn encoded([x, y, z]: [f32; 3], green: Green) -> [f32; 3] {
    let y = if green == Green::Up { y } else { -y };
    [x, y, z].map(|part| 0.5 * part + 0.5)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Edges, Field};

    fn normals_of(f: impl Fn(f64, f64) -> f64, edges: Edges) -> Vec<[f32; 3]> {
        let field = Field::from_fn([16, 12], [1.0; 2], edges, |[x, y]| f(x, y) as f32);
        normals(&Height::from_field(&field, 1))
    }

    #[test]
    fn a_plane_has_its_geometric_normal() {
        // Up to the right by 3 of 4 and up the picture by 2.
        let normals = normals_of(|x, y| 0.75 * x - 2.0 * y, Edges::Closed);
        let length = (0.75_f32 * 0.75 + 4.0 + 1.0).sqrt();
        let [x, y, z] = normals[5 * 16 + 7];
        // It leans left and down in the picture.
        assert!(
            (x + 0.75 / length).abs() < 1e-6
                && (y + 2.0 / length).abs() < 1e-6
                && (z - 1.0 / length).abs() < 1e-6
        );
        let green = |way| encoded([x, y, z], way)[1];
        assert!(green(Green::Up) < 0.5 && (green(Green::Up) + green(Green::Down) - 1.0).abs() < 1e-6);
    }

    #[test]
    fn a_tile_has_the_same_normals_after_a_shift() {
        use std::f64::consts::TAU;
        let wave = |x: f64, y: f64| 2.0 * (TAU * x / 16.0).sin() * (TAU * y / 12.0).cos();
        let (one, moved) =
            (normals_of(wave, Edges::Wrap), normals_of(|x, y| wave(x + 5.0, y + 7.0), Edges::Wrap));
        for (i, normal) in moved.iter().enumerate() {
            let there = one[(i / 16 + 7) % 12 * 16 + (i % 16 + 5) % 16];
            assert!(normal.iter().zip(there).all(|(a, b)| (a - b).abs() < 1e-6));
        }
    }

    #[test]
    fn flat_ground_has_the_usual_blue() {
        let blue = encoded(normals_of(|_, _| 3.0, Edges::Closed)[0], Green::Up);
        assert_eq!(blue.map(|part| (255.0 * part).round() as u8), [128, 128, 255]);
    }
}
