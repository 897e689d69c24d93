//! Models with colours by vertex, as binary glTF 2.0 (ISO/IEC 12113).

use std::io::{self, Write};

use serde_json::{Map, Value, json};

use super::paint::Coloured;
use super::skin::{Skin, SkinPicture};
use super::vector::unit;
use crate::export::Stopped;

/// The extension of materials whose reflections have a direction.
const ANISOTROPY: &str = "KHR_materials_anisotropy";
/// The component type of 32-bit floats, and that of 32-bit indices.
const FLOAT: u32 = 5126;
const INDEX: u32 = 5125;
/// Target of a buffer view: vertex attributes, or indices.
const ATTRIBUTES: u32 = 34_962;
const INDICES: u32 = 34_963;

/// How a picture is read: between four texels, from copies of all sizes, and not repeated beyond its border.
const LINEAR: u32 = 9_729;
const MIPS: u32 = 9_987;
const CLAMP: u32 = 33_071;

/// Writes a `.glb` with a mesh for each part. Colours are linear light, as the format wants them, and multiply a rough white
/// material of the part's name. Parts without triangles are left out; coordinates that are no numbers become 0.
///
/// # Errors
/// The bytes cannot be written, or are more than the format can hold: 4 GiB.
pub fn glb(out: impl Write, parts: &[Coloured]) -> Result<(), Stopped> {
    File::new(parts, None).write(out)
}

/// Writes a `.glb` as [`glb`] does; the material that the `skin` names has its pictures.
///
/// # Errors
/// The bytes cannot be written, or are more than the format can hold: 4 GiB.
pub fn textured_glb(out: impl Write, parts: &[Coloured], skin: &Skin) -> Result<(), Stopped> {
    File::new(parts, Some(skin)).write(out)
}

/// The text of a `.gltf` with a mesh for each part, and the bytes of the file beside it, which it names `buffer`. The material that
/// the `skin` names has its pictures.
#[must_use]
pub fn gltf(parts: &[Coloured], skin: &Skin, buffer: &str) -> [Vec<u8>; 2] {
    let file = File::new(parts, Some(skin));
    [file.text(Some(buffer)), file.bytes]
}

/// Writes the chunks of a `.glb`.
fn chunks(mut out: impl Write, mut text: Vec<u8>, mut bytes: Vec<u8>) -> Result<(), Stopped> {
    // Both chunks end at a multiple of 4, the text with blanks.
    text.resize(text.len().next_multiple_of(4), b' ');
    bytes.resize(bytes.len().next_multiple_of(4), 0);
    let length = |count: usize| {
        u32::try_from(count).map_err(|_| io::Error::other("a .glb cannot hold more than 4 GiB"))
    };
    let binary = if bytes.is_empty() { 0 } else { 8 + bytes.len() };
    out.write_all(b"glTF")?;
    for number in [2, length(20 + text.len() + binary)?, length(text.len())?] {
        out.write_all(&number.to_le_bytes())?;
    }
    out.write_all(b"JSON")?;
    out.write_all(&text)?;
    if !bytes.is_empty() {
        out.write_all(&length(bytes.len())?.to_le_bytes())?;
        out.write_all(b"BIN\0")?;
        out.write_all(&bytes)?;
    }
    Ok(())
}

#[derive(Default)]
struct File {
    meshes: Vec<Value>,
    nodes: Vec<Value>,
    materials: Vec<String>,
    accessors: Vec<Value>,
    views: Vec<Value>,
    bytes: Vec<u8>,
    /// The pictures of the skin, in the order of [`Skin::pictures`].
    images: Vec<Value>,
    /// The name of the material with pictures, and whether it is transparent.
    skinned: Option<(String, bool)>,
}

impl File {
    fn new(parts: &[Coloured], skin: Option<&Skin>) -> Self {
        let mut file = Self::default();
        parts.iter().filter(|part| !part.mesh.faces.is_empty()).for_each(|part| file.push(part));
        if let Some(skin) = skin {
            file.images = skin.pictures().iter().map(|picture| file.image(picture)).collect();
            file.skinned = Some((skin.material.to_owned(), skin.transparent));
        }
        file
    }

    fn write(self, out: impl Write) -> Result<(), Stopped> {
        chunks(out, self.text(None), self.bytes)
    }

    fn image(&mut self, picture: &SkinPicture) -> Value {
        let bytes = match picture {
            SkinPicture::Beside(name) => return json!({"uri": name}),
            SkinPicture::Inside(bytes) => bytes,
        };
        let view = json!({"buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len()});
        self.views.push(view);
        self.bytes.extend_from_slice(bytes);
        // What follows is aligned.
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        json!({"bufferView": self.views.len() - 1, "mimeType": "image/png"})
    }

    fn push(&mut self, part: &Coloured) {
        let places: Vec<[f32; 3]> = part.mesh.positions.iter().map(|place| place.map(finite)).collect();
        let mut attributes = Map::new();
        let position = self.floats(&places);
        // Positions are the only attribute that must have bounds.
        self.accessors[position]["min"] = json!(bound(&places, f32::min));
        self.accessors[position]["max"] = json!(bound(&places, f32::max));
        attributes.insert("POSITION".to_owned(), json!(position));
        if !part.normals.is_empty() {
            let normals: Vec<[f32; 3]> =
                part.normals.iter().map(|normal| unit(*normal).map(|value| value as f32)).collect();
            attributes.insert("NORMAL".to_owned(), json!(self.floats(&normals)));
        }
        if !part.uvs.is_empty() {
            // From the upper left corner.
            let uvs: Vec<[f32; 2]> = part.uvs.iter().map(|[u, v]| [finite(*u), finite(1.0 - v)]).collect();
            attributes.insert("TEXCOORD_0".to_owned(), json!(self.floats(&uvs)));
        }
        if !part.tangents.is_empty() {
            attributes.insert("TANGENT".to_owned(), json!(self.floats(part.tangents)));
        }
        if !part.colours.is_empty() {
            let colours: Vec<[f32; 3]> =
                part.colours.iter().map(|colour| colour.map(|light| light.clamp(0.0, 1.0))).collect();
            attributes.insert("COLOR_0".to_owned(), json!(self.floats(&colours)));
        }
        let corners = part.mesh.faces.iter().flatten();
        let bytes = corners.flat_map(|vertex| vertex.to_le_bytes()).collect();
        let indices =
            self.accessor(bytes, INDICES, 3 * part.mesh.faces.len(), [INDEX.into(), "SCALAR".into()]);
        let mut primitive = json!({"attributes": attributes, "indices": indices, "mode": 4});
        if !part.material.is_empty() {
            primitive["material"] = json!(self.material(part.material));
        }
        self.nodes.push(json!({"name": part.name, "mesh": self.meshes.len()}));
        self.meshes.push(json!({"name": part.name, "primitives": [primitive]}));
    }

    fn material(&mut self, name: &str) -> usize {
        let known = self.materials.iter().position(|known| known == name);
        known.unwrap_or_else(|| {
            self.materials.push(name.to_owned());
            self.materials.len() - 1
        })
    }

    fn floats<const N: usize>(&mut self, values: &[[f32; N]]) -> usize {
        let bytes = values.iter().flatten().flat_map(|value| value.to_le_bytes()).collect();
        self.accessor(bytes, ATTRIBUTES, values.len(), [FLOAT.into(), format!("VEC{N}").into()])
    }

    /// Adds bytes with their description; returns the index of the accessor.
    fn accessor(
        &mut self,
        bytes: Vec<u8>,
        target: u32,
        count: usize,
        [component, kind]: [Value; 2],
    ) -> usize {
        let view =
            json!({"buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len(), "target": target});
        self.accessors.push(json!({
            "bufferView": self.views.len(), "componentType": component, "count": count, "type": kind,
        }));
        self.views.push(view);
        self.bytes.extend(bytes);
        self.accessors.len() - 1
    }

    /// The text of the file; `buffer` names the file of the bytes, if it is another one.
    fn text(&self, buffer: Option<&str>) -> Vec<u8> {
        let generator = format!("dapple {}", env!("CARGO_PKG_VERSION"));
        let mut root = json!({"asset": {"version": "2.0", "generator": generator}});
        // The format does not allow empty lists.
        if !self.meshes.is_empty() {
            root["scene"] = json!(0);
            root["scenes"] = json!([{"nodes": (0..self.nodes.len()).collect::<Vec<_>>()}]);
            root["nodes"] = json!(self.nodes);
            root["meshes"] = json!(self.meshes);
            root["accessors"] = json!(self.accessors);
            root["bufferViews"] = json!(self.views);
            root["buffers"] = json!([{"byteLength": self.bytes.len()}]);
            if let Some(name) = buffer {
                root["buffers"][0]["uri"] = json!(name);
            }
        }
        if self.is_anisotropic() {
            root["extensionsUsed"] = json!([ANISOTROPY]);
        }
        if !self.materials.is_empty() {
            root["materials"] = self.materials.iter().map(|name| self.described(name)).collect();
        }
        if !self.images.is_empty() {
            root["images"] = json!(self.images);
            root["samplers"] =
                json!([{"magFilter": LINEAR, "minFilter": MIPS, "wrapS": CLAMP, "wrapT": CLAMP}]);
            let texture = |source| json!({"sampler": 0, "source": source});
            root["textures"] = (0..self.images.len()).map(texture).collect();
        }
        root.to_string().into_bytes()
    }

    /// A material: the pictures of the skin, or a rough white.
    fn described(&self, name: &str) -> Value {
        let is_skinned = self.skinned.as_ref().is_some_and(|(skinned, _)| skinned == name);
        let mut described = match &self.skinned {
            Some((skinned, transparent)) if skinned == name => json!({
                "name": name,
                "pbrMetallicRoughness": {
                    "baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 2},
                    "metallicFactor": 1.0, "roughnessFactor": 1.0
                },
                "normalTexture": {"index": 1},
                "occlusionTexture": {"index": 2},
                "alphaMode": if *transparent { "BLEND" } else { "OPAQUE" },
            }),
            _ => {
                json!({"name": name, "pbrMetallicRoughness": {"metallicFactor": 0.0, "roughnessFactor": 0.8}})
            }
        };
        if is_skinned && self.is_anisotropic() {
            described["extensions"][ANISOTROPY] =
                json!({"anisotropyStrength": 1.0, "anisotropyTexture": {"index": 3}});
        }
        described
    }

    /// Whether the skin has a picture of the direction of reflections, the fourth.
    fn is_anisotropic(&self) -> bool {
        self.images.len() > 3
    }
}

fn finite(value: f64) -> f32 {
    let value = value as f32;
    if value.is_finite() { value } else { 0.0 }
}

fn bound(places: &[[f32; 3]], pick: fn(f32, f32) -> f32) -> [f32; 3] {
    let first = places.first().copied().unwrap_or_default();
    places.iter().fold(first, |bound, place| [0, 1, 2].map(|axis| pick(bound[axis], place[axis])))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::Mesh;

    fn written(parts: &[Coloured]) -> Vec<u8> {
        let mut bytes = Vec::new();
        glb(&mut bytes, parts).unwrap();
        bytes
    }

    #[test]
    fn another_reader_finds_every_part_with_its_colours_and_materials() {
        let [head, tail] = [0.0, 5.0].map(|x| Mesh {
            positions: vec![[x, 0.0, 0.0], [x + 1.0, 0.0, 0.0], [x, 2.0, 0.1], [x, 0.0, -3.0]],
            faces: vec![[0, 1, 2], [0, 2, 3]],
        });
        let colours = [[0.0, 0.25, 1.0], [1.0, 0.5, 0.0], [0.1, 0.2, 0.3], [0.0; 3]];
        let plain = Coloured {
            name: "head \"1\"",
            material: "fur",
            mesh: &head,
            normals: &[],
            uvs: &[],
            tangents: &[],
            colours: &colours,
        };
        let rich = Coloured {
            name: "tail",
            mesh: &tail,
            normals: &[[0.0, 0.0, 2.0]; 4],
            uvs: &[[0.0, 0.0], [1.0, 0.0], [0.5, 0.75], [0.0, 1.0]],
            colours: &[],
            ..plain
        };
        let empty = Mesh::default();
        let none = Coloured { name: "none", material: "claw", mesh: &empty, colours: &[], ..plain };
        let bytes = written(&[plain, none, rich, Coloured { material: "", ..rich }]);
        let (document, buffers, _) = ::gltf::import_slice(&bytes).unwrap();
        assert_eq!(
            document.nodes().map(|node| node.name().unwrap().to_owned()).collect::<Vec<_>>(),
            ["head \"1\"", "tail", "tail"]
        );
        assert_eq!(
            document.materials().map(|material| material.name().map(str::to_owned)).collect::<Vec<_>>(),
            [Some("fur".to_owned())]
        );
        let primitives: Vec<_> =
            document.meshes().flat_map(|mesh| mesh.primitives().collect::<Vec<_>>()).collect();
        let read = primitives[0].reader(|buffer| Some(&buffers[buffer.index()]));
        assert_eq!(read.read_colors(0).unwrap().into_rgb_f32().collect::<Vec<_>>(), colours);
        assert_eq!(read.read_positions().unwrap().nth(2), Some([0.0, 2.0, 0.1]));
        assert_eq!(read.read_indices().unwrap().into_u32().collect::<Vec<_>>(), [0, 1, 2, 0, 2, 3]);
        assert!(read.read_normals().is_none() && read.read_tex_coords(0).is_none());
        assert_eq!(primitives[0].bounding_box().min, [0.0, 0.0, -3.0]);
        let read = primitives[1].reader(|buffer| Some(&buffers[buffer.index()]));
        assert_eq!(read.read_normals().unwrap().next(), Some([0.0, 0.0, 1.0]));
        assert_eq!(read.read_tex_coords(0).unwrap().into_f32().nth(2), Some([0.5, 0.25]));
        assert!(read.read_colors(0).is_none());
        assert_eq!((primitives[1].material().index(), primitives[2].material().index()), (Some(0), None));
    }

    #[test]
    fn another_reader_finds_the_pictures_of_a_skin_inside_or_beside() {
        let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let mesh = Mesh { positions, faces: vec![[0, 1, 2]] };
        let part = Coloured {
            name: "a",
            material: "fur",
            mesh: &mesh,
            normals: &[[0.0, 0.0, 1.0]; 3],
            uvs: &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
            tangents: &[[1.0, 0.0, 0.0, -1.0]; 3],
            colours: &[],
        };
        let claw = Coloured { material: "claw", uvs: &[], tangents: &[], ..part };
        let mut png = Vec::new();
        crate::export::png::rgb8(&mut png, [1, 1], None, &[9, 8, 7]).unwrap();
        let skin = Skin {
            material: "fur",
            base_colour: SkinPicture::Inside(&png),
            normal: SkinPicture::Inside(&png),
            orm: SkinPicture::Inside(&png),
            anisotropy: None,
            transparent: true,
        };
        let mut bytes = Vec::new();
        textured_glb(&mut bytes, &[part, claw], &skin).unwrap();
        let (document, buffers, images) = ::gltf::import_slice(&bytes).unwrap();
        assert_eq!(images.len(), 3);
        assert!(images.iter().all(|image| image.pixels == [9, 8, 7]));
        let material = document.materials().next().unwrap();
        assert_eq!(material.alpha_mode(), ::gltf::material::AlphaMode::Blend);
        assert_eq!(material.normal_texture().map(|found| found.texture().source().index()), Some(1));
        let others = document.materials().nth(1).unwrap();
        assert!(others.pbr_metallic_roughness().base_color_texture().is_none());
        let primitive = document.meshes().next().unwrap().primitives().next().unwrap();
        let read = primitive.reader(|buffer| Some(&buffers[buffer.index()]));
        assert_eq!(read.read_tangents().unwrap().next(), Some([1.0, 0.0, 0.0, -1.0]));
        let beside = SkinPicture::Beside("a.png");
        let skin = Skin { base_colour: beside, normal: beside, orm: beside, ..skin };
        let [text, bytes] = gltf(&[part], &skin, "a.bin");
        let document = ::gltf::Gltf::from_slice(&text).unwrap();
        assert_eq!(document.buffers().next().map(|buffer| buffer.length()), Some(bytes.len()));
        let source = document.images().next().unwrap().source();
        assert!(matches!(source, ::gltf::image::Source::Uri { uri: "a.png", .. }));
    }

    #[test]
    fn a_file_without_parts_and_one_without_numbers_can_be_read() {
        assert_eq!(::gltf::import_slice(written(&[])).unwrap().0.meshes().len(), 0);
        let mesh = Mesh { positions: vec![[f64::NAN, f64::INFINITY, 1e300]; 3], faces: vec![[0, 1, 2]] };
        let normals = [[0.0; 3]; 3];
        let part = Coloured {
            name: "",
            material: "",
            mesh: &mesh,
            normals: &normals,
            uvs: &[],
            tangents: &[],
            colours: &[[f32::NAN; 3]; 3],
        };
        assert_eq!(::gltf::import_slice(written(&[part])).unwrap().0.meshes().len(), 1);
    }
}
