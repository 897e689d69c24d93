//! A plane with a material, as glTF 2.0 (ISO/IEC 12113): a `.gltf` with links to its pictures, and a `.bin` beside it.
//!
//! The plane is horizontal (normal +Y), its longer side is 1 m, the top of the picture is at −Z. The material is
//! metallic-roughness: one picture holds occlusion in red, roughness in green and metalness in blue.

/// A textured plane. All files are beside the `.gltf`; names consist of letters, digits, `_` and `-`.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane<'a> {
    /// The name of the plane and its material.
    pub name: &'a str,
    /// Width and height of the pictures, px.
    pub size: [usize; 2],
    /// Whether the pictures are seamless tiles.
    pub wraps: bool,
    /// Whether the colours have opacity.
    pub transparent: bool,
    /// The picture of colours.
    pub base_colour: &'a str,
    /// The picture of normals, green up.
    pub normal: &'a str,
    /// The picture of occlusion, roughness and metalness.
    pub orm: &'a str,
    /// The picture of the direction of reflections, if they have one (KHR_materials_anisotropy).
    pub anisotropy: Option<&'a str>,
    /// The file for the bytes of [`Self::buffer`].
    pub buffer: &'a str,
}

/// Offsets in the buffer of positions, normals, tangents, texture coordinates and indices, then its length; bytes.
const OFFSETS: [usize; 6] = [0, 48, 96, 160, 192, 204];

impl Plane<'_> {
    /// Half the sides along x and z, m.
    fn half(&self) -> [f32; 2] {
        let longest = self.size[0].max(self.size[1]) as f64;
        self.size.map(|side| (0.5 * side as f64 / longest) as f32)
    }

    /// The bytes of the vertices and indices.
    #[must_use]
    pub fn buffer(&self) -> Vec<u8> {
        let [x, z] = self.half();
        let positions = [[-x, 0.0, -z], [x, 0.0, -z], [x, 0.0, z], [-x, 0.0, z]];
        let mut floats: Vec<f32> = positions.into_iter().flatten().collect();
        floats.extend([0.0, 1.0, 0.0].repeat(4));
        // Tangents along u; w·(normal × tangent) = −Z points up in the picture.
        floats.extend([1.0, 0.0, 0.0, 1.0].repeat(4));
        floats.extend([0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0]);
        let mut bytes: Vec<u8> = floats.into_iter().flat_map(f32::to_le_bytes).collect();
        // Counter-clockwise seen from above.
        bytes.extend([0_u16, 3, 2, 0, 2, 1].into_iter().flat_map(u16::to_le_bytes));
        bytes
    }

    /// What reflections with a direction add to the text: to its beginning, the material, the textures and the images.
    fn anisotropic(&self) -> [String; 4] {
        let Some(file) = self.anisotropy else { return Default::default() };
        let name = "KHR_materials_anisotropy";
        [
            format!("\n  \"extensionsUsed\": [\"{name}\"],"),
            format!(
                ",\n    \"extensions\": {{\"{name}\": {{\"anisotropyStrength\": 1.0, \"anisotropyTexture\": {{\"index\": 3}}}}}}"
            ),
            ", {\"sampler\": 0, \"source\": 3}".to_owned(),
            format!(", {{\"uri\": \"{file}\"}}"),
        ]
    }

    /// The text of the `.gltf`.
    #[must_use]
    pub fn text(&self) -> String {
        let Self { name, base_colour, normal, orm, buffer, .. } = self;
        let [x, z] = self.half();
        // 10497 = repeat, 33071 = clamp to edge.
        let beyond = if self.wraps { 10_497 } else { 33_071 };
        let [used, extension, texture, image] = self.anisotropic();
        let opacity = if self.transparent { "\"BLEND\"" } else { "\"OPAQUE\"" };
        let views: Vec<String> = (0..5)
            .map(|view| {
                let (from, length) = (OFFSETS[view], OFFSETS[view + 1] - OFFSETS[view]);
                // 34962 = vertex attributes, 34963 = indices.
                let target = if view == 4 { 34_963 } else { 34_962 };
                format!(
                    "    {{\"buffer\": 0, \"byteOffset\": {from}, \"byteLength\": {length}, \"target\": {target}}}"
                )
            })
            .collect();
        format!(
            r#"{{
  "asset": {{"version": "2.0", "generator": "dapple {version}"}},{used}
  "scene": 0,
  "scenes": [{{"name": "{name}", "nodes": [0]}}],
  "nodes": [{{"name": "{name}", "mesh": 0}}],
  "meshes": [{{"name": "{name}", "primitives": [{{
    "attributes": {{"POSITION": 0, "NORMAL": 1, "TANGENT": 2, "TEXCOORD_0": 3}},
    "indices": 4, "material": 0, "mode": 4
  }}]}}],
  "materials": [{{
    "name": "{name}",
    "pbrMetallicRoughness": {{
      "baseColorTexture": {{"index": 0}},
      "metallicRoughnessTexture": {{"index": 2}},
      "metallicFactor": 1.0, "roughnessFactor": 1.0
    }},
    "normalTexture": {{"index": 1}},
    "occlusionTexture": {{"index": 2}},
    "alphaMode": {opacity}{extension}
  }}],
  "textures": [{{"sampler": 0, "source": 0}}, {{"sampler": 0, "source": 1}}, {{"sampler": 0, "source": 2}}{texture}],
  "samplers": [{{"magFilter": 9729, "minFilter": 9987, "wrapS": {beyond}, "wrapT": {beyond}}}],
  "images": [{{"uri": "{base_colour}"}}, {{"uri": "{normal}"}}, {{"uri": "{orm}"}}{image}],
  "accessors": [
    {{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [{left}, 0.0, {far}], "max": [{x}, 0.0, {z}]}},
    {{"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC3"}},
    {{"bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC4"}},
    {{"bufferView": 3, "componentType": 5126, "count": 4, "type": "VEC2"}},
    {{"bufferView": 4, "componentType": 5123, "count": 6, "type": "SCALAR"}}
  ],
  "bufferViews": [
{views}
  ],
  "buffers": [{{"uri": "{buffer}", "byteLength": {length}}}]
}}
"#,
            version = env!("CARGO_PKG_VERSION"),
            left = -x,
            far = -z,
            views = views.join(",\n"),
            length = OFFSETS[5],
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn another_reader_finds_the_plane_with_the_right_side_and_proportions() {
        let plane = Plane {
            name: "a",
            size: [400, 100],
            wraps: true,
            transparent: false,
            base_colour: "c.png",
            normal: "n.png",
            orm: "o.png",
            anisotropy: Some("d.png"),
            buffer: "a.bin",
        };
        let bytes = plane.buffer();
        assert_eq!(bytes.len(), OFFSETS[5]);
        let json: serde_json::Value = serde_json::from_str(&plane.text()).unwrap();
        let shine = &json["materials"][0]["extensions"]["KHR_materials_anisotropy"];
        let image =
            &json["textures"][shine["anisotropyTexture"]["index"].as_u64().unwrap() as usize]["source"];
        assert_eq!(json["images"][image.as_u64().unwrap() as usize]["uri"], "d.png");
        let plain = Plane { anisotropy: None, ..plane.clone() }.text();
        assert!(!plain.contains("KHR_") && serde_json::from_str::<serde_json::Value>(&plain).is_ok());
        let read = ::gltf::Gltf::from_slice(plane.text().as_bytes()).unwrap();
        let mesh = read.meshes().next().unwrap();
        let primitive = mesh.primitives().next().unwrap();
        let reader = primitive.reader(|_| Some(&bytes));
        let positions: Vec<[f32; 3]> = reader.read_positions().unwrap().collect();
        let corners: Vec<u32> = reader.read_indices().unwrap().into_u32().collect();
        let places: Vec<[f32; 2]> = reader.read_tex_coords(0).unwrap().into_f32().collect();
        assert_eq!(primitive.bounding_box().max, [0.5, 0.0, 0.125]);
        for triangle in corners.chunks(3) {
            let [a, b, c] = [0, 1, 2].map(|corner| positions[triangle[corner] as usize]);
            let [u, v] = [[b[0] - a[0], b[2] - a[2]], [c[0] - a[0], c[2] - a[2]]];
            // y of u × v.
            assert!(u[1] * v[0] - u[0] * v[1] > 0.0, "seen from above");
        }
        for (position, place) in positions.iter().zip(places) {
            assert_eq!([position[0] + 0.5, 4.0 * position[2] + 0.5], place);
        }
        for ((normal, tangent), _) in
            reader.read_normals().unwrap().zip(reader.read_tangents().unwrap()).zip(0..4)
        {
            assert_eq!((normal, tangent), ([0.0, 1.0, 0.0], [1.0, 0.0, 0.0, 1.0]));
        }
    }
}
