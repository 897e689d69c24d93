//! Different meshes of one surface.

use std::fmt::Write;

use dapple_engine::surface::{Mesh, built_in, prepare, remesh};

/// Vertices of the even mesh.
pub const VERTICES: f64 = 24_000.0;
/// Longest ÷ shortest edge of the graded mesh.
const GRADED: f64 = 10.0;
/// The distance of a sliver's new vertex from a corner, as a share of the distance from there to the middle of the
/// face.
const SLIVER: f64 = 0.03;

/// Polygons of a model.
pub struct Triangulation {
    /// Its name in tables.
    pub name: &'static str,
    /// Places of its vertices.
    positions: Vec<[f64; 3]>,
    /// The corners of its polygons.
    polygons: Vec<Vec<u32>>,
}

impl Triangulation {
    /// A mesh.
    pub fn of_triangles(name: &'static str, mesh: Mesh) -> Self {
        let polygons = mesh.faces.iter().map(|face| face.to_vec()).collect();
        Self { name, positions: mesh.positions, polygons }
    }

    /// Number of polygons.
    pub fn polygons(&self) -> usize {
        self.polygons.len()
    }

    /// The body in the OBJ format.
    pub fn obj(&self) -> String {
        let mut text = String::new();
        for [x, y, z] in &self.positions {
            let _ = writeln!(text, "v {x} {y} {z}");
        }
        for polygon in &self.polygons {
            text.push('f');
            polygon.iter().for_each(|corner| text.push_str(&format!(" {}", corner + 1)));
            text.push('\n');
        }
        text
    }

    /// The triangles; each polygon becomes a fan.
    pub fn mesh(&self) -> Mesh {
        let fan = |polygon: &Vec<u32>| {
            let ends = polygon.array_windows().skip(1).map(|[b, c]| [polygon[0], *b, *c]);
            ends.collect::<Vec<[u32; 3]>>()
        };
        Mesh { positions: self.positions.clone(), faces: self.polygons.iter().flat_map(fan).collect() }
    }
}

/// The edge length of equilateral triangles with which a surface has this number of vertices.
pub fn edge(area: f64, vertices: f64) -> f64 {
    (area / vertices * 2.0 / 3.0_f64.sqrt()).sqrt()
}

/// A mesh of even triangles with about this number of vertices.
pub fn evenly(mesh: &Mesh, vertices: f64) -> Mesh {
    let edge = edge(mesh.area(), vertices);
    remesh(mesh, &|_| edge)
}

/// The built-in animal, prepared.
pub fn animal() -> Result<Mesh, String> {
    let model = built_in("animal").ok_or("there is no built-in animal")?;
    let mesh = model.mesh(&[]).map_err(|error| error.to_string())?;
    prepare(&mesh).map(|(mesh, _)| mesh).map_err(|error| error.to_string())
}

/// The animal as four meshes of the same surface; the even one has about this number of vertices.
pub fn four(vertices: f64) -> Result<[Triangulation; 4], String> {
    let animal = animal()?;
    let even = evenly(&animal, vertices);
    Ok([
        Triangulation::of_triangles("even", even.clone()),
        Triangulation::of_triangles("graded 1 : 10 along the body", graded(&animal, vertices)),
        slivers(&even),
        quads(&even),
    ])
}

/// The animal with fewer triangles. This is a different surface, because its curves are cut off.
pub fn decimated() -> Result<[Triangulation; 2], String> {
    let animal = animal()?;
    let with = |name: &'static str, share: f64| {
        let mesh = evenly(&animal, share * VERTICES);
        Triangulation::of_triangles(name, mesh)
    };
    Ok([with("decimated to a tenth", 0.1), with("decimated to a hundredth", 0.01)])
}

/// A mesh whose edges are ten times as long at one end as at the other, with about this number of vertices.
fn graded(animal: &Mesh, vertices: f64) -> Mesh {
    let [low, high] = animal.bounds();
    let usual = edge(animal.area(), vertices);
    remesh(animal, &|[x, _, _]| {
        let share = (x - low[0]) / (high[0] - low[0]);
        usual * libm::pow(GRADED, share - 0.5)
    })
}

/// Splits every third triangle into three at a point next to one of its corners: two of the three are slivers.
fn slivers(mesh: &Mesh) -> Triangulation {
    let (mut positions, mut polygons) = (mesh.positions.clone(), Vec::new());
    for (index, face) in mesh.faces.iter().enumerate() {
        if index % 3 != 0 {
            polygons.push(face.to_vec());
            continue;
        }
        let [a, b, c] = face.map(|corner| mesh.positions[corner as usize]);
        let near = |i: usize| (1.0 - SLIVER) * a[i] + SLIVER * (a[i] + b[i] + c[i]) / 3.0;
        let middle = positions.len() as u32;
        positions.push([0, 1, 2].map(near));
        polygons.extend([0, 1, 2].map(|k| vec![face[k], face[(k + 1) % 3], middle]));
    }
    Triangulation { name: "a third split into slivers", positions, polygons }
}

/// Splits each triangle into three quads, each of a corner, the middles of two sides, and the middle of the triangle.
fn quads(mesh: &Mesh) -> Triangulation {
    let mut positions = mesh.positions.clone();
    let mut middles = std::collections::BTreeMap::new();
    let mut polygons = Vec::new();
    for face in &mesh.faces {
        let places = face.map(|corner| mesh.positions[corner as usize]);
        let centre = positions.len() as u32;
        positions.push([0, 1, 2].map(|i| places.iter().map(|place| place[i]).sum::<f64>() / 3.0));
        let sides = [0, 1, 2].map(|k| {
            let (a, b) = (face[k], face[(k + 1) % 3]);
            *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                let [p, q] = [places[k], places[(k + 1) % 3]];
                positions.push([0, 1, 2].map(|i| 0.5 * (p[i] + q[i])));
                positions.len() as u32 - 1
            })
        });
        polygons.extend([0, 1, 2].map(|k| vec![face[k], sides[k], centre, sides[(k + 2) % 3]]));
    }
    Triangulation { name: "quads", positions, polygons }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slivers_and_quads_have_the_surface_of_the_even_triangles() {
        let animal = animal().expect("an animal");
        let even = evenly(&animal, 800.0);
        for other in [slivers(&even), quads(&even)] {
            let mesh = other.mesh();
            assert!((mesh.area() / even.area() - 1.0).abs() < 1e-9, "{}", other.name);
            assert!(mesh.faces.len() > even.faces.len(), "{}", other.name);
        }
        assert!(quads(&even).polygons.iter().all(|polygon| polygon.len() == 4));
    }
}
