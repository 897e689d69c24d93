//! Built-in bodies, made by formula: y is up, a head points toward +x, and the longest side is about 2.

mod animal;
mod bars;
mod cube;
mod curve;
mod implicit;
mod revolved;
mod rings;
mod sheets;
mod shell;
mod snake;
mod torus;

use super::model::Model;

/// The names of the built-in bodies.
pub const BODIES: [&str; 11] =
    ["sphere", "torus", "cylinder", "capsule", "cube", "animal", "spindle", "vase", "shell", "snake", "egg"];

/// The built-in body of a name; `None` if there is none.
///
/// ```
/// use dapple_engine::surface::{BODIES, built_in};
///
/// let model = built_in(BODIES[0]).unwrap();
/// assert!(model.mesh(&[])?.area() > 0.0);
/// assert!(built_in("unknown").is_none());
/// # Ok::<(), dapple_engine::surface::ModelError>(())
/// ```
#[must_use]
pub fn built_in(name: &str) -> Option<Model> {
    let model = match name {
        "sphere" => revolved::sphere(),
        "cylinder" => revolved::cylinder(),
        "capsule" => revolved::capsule(),
        "spindle" => revolved::spindle(),
        "vase" => revolved::vase(),
        "egg" => revolved::egg(),
        "torus" => torus::torus(),
        "cube" => cube::cube(),
        "snake" => snake::snake(),
        "shell" => shell::shell(),
        "animal" => animal::animal(),
        _ => return None,
    };
    Some(Model { name: name.to_owned(), ..model })
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;
    use std::sync::LazyLock;

    use super::*;
    use crate::surface::Mesh;

    /// Made once for all tests.
    static MESHES: LazyLock<Vec<Mesh>> =
        LazyLock::new(|| BODIES.map(|name| built_in(name).unwrap().mesh(&[]).unwrap()).to_vec());

    fn meshes() -> impl Iterator<Item = (&'static str, &'static Mesh)> {
        BODIES.into_iter().zip(MESHES.iter())
    }

    /// Six times the volume that the triangles enclose.
    fn volume(mesh: &Mesh) -> f64 {
        let of = |face: &[u32; 3]| {
            let [a, b, c] = face.map(|vertex| mesh.positions[vertex as usize]);
            a[0] * (b[1] * c[2] - b[2] * c[1])
                + a[1] * (b[2] * c[0] - b[0] * c[2])
                + a[2] * (b[0] * c[1] - b[1] * c[0])
        };
        mesh.faces.iter().map(of).sum()
    }

    #[test]
    fn every_body_is_a_closed_surface_with_its_outside_out() {
        for (name, mesh) in meshes() {
            let mut edges: BTreeMap<[u32; 2], usize> = BTreeMap::new();
            for [a, b, c] in &mesh.faces {
                for edge in [[*a, *b], [*b, *c], [*c, *a]] {
                    *edges.entry(edge).or_default() += 1;
                }
            }
            let whole = edges.iter().all(|([a, b], count)| *count == 1 && edges.get(&[*b, *a]) == Some(&1));
            assert!(whole, "{name}: an edge without exactly one face on either side");
            let characteristic =
                mesh.positions.len() as i64 - edges.len() as i64 / 2 + mesh.faces.len() as i64;
            assert_eq!(characteristic, if name == "torus" { 0 } else { 2 }, "{name}");
            assert!(volume(mesh) > 0.0, "{name} is inside out");
            assert!(mesh.faces.len() < 60_000, "{name}: {}", mesh.faces.len());
        }
    }

    /// Around each vertex the faces form one ring: no two sheets share a vertex.
    #[test]
    fn no_vertex_belongs_to_two_sheets() {
        for (name, mesh) in meshes() {
            let mut around: Vec<Vec<[u32; 2]>> = vec![Vec::new(); mesh.positions.len()];
            for [a, b, c] in &mesh.faces {
                for (vertex, opposite) in [(a, [*b, *c]), (b, [*c, *a]), (c, [*a, *b])] {
                    around[*vertex as usize].push(opposite);
                }
            }
            for (vertex, opposite) in around.iter().enumerate() {
                let mut at = opposite[0][1];
                let mut steps = 1;
                while at != opposite[0][0] && steps <= opposite.len() {
                    at = opposite.iter().find(|edge| edge[0] == at).unwrap()[1];
                    steps += 1;
                }
                assert_eq!(steps, opposite.len(), "{name}: vertex {vertex}");
            }
        }
    }

    #[test]
    fn no_triangle_of_a_body_is_without_area() {
        for (name, mesh) in meshes() {
            for face in &mesh.faces {
                let [a, b, c] = face.map(|vertex| mesh.positions[vertex as usize]);
                let [u, v]: [[f64; 3]; 2] = [b, c].map(|end| [0, 1, 2].map(|axis| end[axis] - a[axis]));
                let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
                let area = cross.iter().map(|value| value * value).sum::<f64>().sqrt() / 2.0;
                assert!(area > 1e-8, "{name}: {area} at {a:?}");
            }
        }
    }

    #[test]
    fn bodies_have_about_the_same_size_and_stand_on_their_axes() {
        for (name, mesh) in meshes() {
            let side = |axis: usize, pick: fn(f64, f64) -> f64| {
                mesh.positions.iter().map(|place| place[axis]).reduce(pick).unwrap()
            };
            let [low, high] = [f64::min, f64::max].map(|pick| [0, 1, 2].map(|axis| side(axis, pick)));
            let longest = (0..3).map(|axis| high[axis] - low[axis]).fold(0.0, f64::max);
            assert!((1.5..=2.5).contains(&longest), "{name}: {low:?} to {high:?}");
        }
        assert!(built_in("horse").is_none());
    }

    #[test]
    fn texture_coordinates_lie_in_the_unit_square() {
        for name in BODIES.into_iter().filter(|name| !["animal", "shell"].contains(name)) {
            let model = built_in(name).unwrap();
            assert!(
                model.faces.iter().all(|face| face.corners.iter().all(|corner| corner.uv.is_some())),
                "{name}"
            );
            assert!(model.uvs.iter().flatten().all(|value| (0.0..=1.0).contains(value)), "{name}");
        }
    }
}
