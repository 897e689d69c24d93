//! The data that are kept of an element of a PLY file: a vertex, a face, or triangle strips.

use ply_rs_bw::ply::{Property, PropertyAccess};

/// A vertex, a face, or triangle strips.
#[derive(Clone, Debug, Default)]
pub struct Element {
    /// x, y, z.
    pub position: [Option<f64>; 3],
    /// Its normal.
    pub normal: Option<[f64; 3]>,
    /// Its texture coordinate.
    pub uv: Option<[f64; 2]>,
    /// The vertices of its corners.
    pub indices: Vec<i64>,
    /// Texture coordinates of its corners, two numbers each.
    pub uvs: Vec<f64>,
}

impl PropertyAccess for Element {
    fn new() -> Self {
        Self::default()
    }

    fn set_property(&mut self, name: &str, property: Property) {
        match name {
            "x" => self.position[0] = number(&property),
            "y" => self.position[1] = number(&property),
            "z" => self.position[2] = number(&property),
            "nx" => set(&mut self.normal, 0, &property),
            "ny" => set(&mut self.normal, 1, &property),
            "nz" => set(&mut self.normal, 2, &property),
            // Blender, MeshLab and others use different names.
            "s" | "u" | "texture_u" => set(&mut self.uv, 0, &property),
            "t" | "v" | "texture_v" => set(&mut self.uv, 1, &property),
            "vertex_indices" | "vertex_index" => self.indices = integers(property),
            "texcoord" => self.uvs = numbers(property),
            _ => {}
        }
    }
}

fn set<const N: usize>(vector: &mut Option<[f64; N]>, axis: usize, property: &Property) {
    vector.get_or_insert([0.0; N])[axis] = number(property).unwrap_or_default();
}

fn number(property: &Property) -> Option<f64> {
    Some(match *property {
        Property::Char(value) => f64::from(value),
        Property::UChar(value) => f64::from(value),
        Property::Short(value) => f64::from(value),
        Property::UShort(value) => f64::from(value),
        Property::Int(value) => f64::from(value),
        Property::UInt(value) => f64::from(value),
        Property::Float(value) => f64::from(value),
        Property::Double(value) => value,
        _ => return None,
    })
}

fn numbers(property: Property) -> Vec<f64> {
    match property {
        Property::ListFloat(values) => values.into_iter().map(f64::from).collect(),
        Property::ListDouble(values) => values,
        _ => Vec::new(),
    }
}

fn integers(property: Property) -> Vec<i64> {
    fn all<T: Into<i64>>(values: Vec<T>) -> Vec<i64> {
        values.into_iter().map(Into::into).collect()
    }
    match property {
        Property::ListChar(values) => all(values),
        Property::ListUChar(values) => all(values),
        Property::ListShort(values) => all(values),
        Property::ListUShort(values) => all(values),
        Property::ListInt(values) => all(values),
        Property::ListUInt(values) => all(values),
        _ => Vec::new(),
    }
}
