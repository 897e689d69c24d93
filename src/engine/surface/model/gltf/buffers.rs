//! Numbers in the buffers of a glTF file.

use gltf::accessor::{DataType, Dimensions, Item, Iter};
use gltf::buffer::{Source, View};
use gltf::{Accessor, Gltf};

/// The beginning of the address of an embedded buffer.
const DATA: &str = "data:";
/// The text before its bytes.
const BASE64: &str = ";base64,";

/// The bytes of all buffers.
pub struct Buffers<'a> {
    buffers: Vec<std::borrow::Cow<'a, [u8]>>,
}

impl<'a> Buffers<'a> {
    /// The buffers of a file.
    ///
    /// # Errors
    /// The problem: a buffer that is not in the file.
    pub fn new(read: &'a Gltf) -> Result<Self, String> {
        let bytes = |buffer: gltf::Buffer<'a>| match buffer.source() {
            Source::Bin => read
                .blob
                .as_deref()
                .map(std::borrow::Cow::from)
                .ok_or_else(|| "a buffer without its bytes".to_owned()),
            Source::Uri(uri) => uri
                .strip_prefix(DATA)
                .and_then(|data| data.split_once(BASE64))
                .and_then(|(_, text)| base64::decode(text).ok())
                .map(std::borrow::Cow::from)
                .ok_or_else(|| "a buffer in another file".to_owned()),
        };
        Ok(Self { buffers: read.buffers().map(bytes).collect::<Result<_, String>>()? })
    }

    /// The vectors of an accessor.
    ///
    /// # Errors
    /// The problem: other numbers, or too few.
    pub fn vectors<const N: usize>(&self, accessor: &Accessor) -> Result<Vec<[f64; N]>, String>
    where
        [f32; N]: Item,
    {
        let wanted = [(2, Dimensions::Vec2), (3, Dimensions::Vec3)];
        let is_wanted = wanted.contains(&(N, accessor.dimensions())) && accessor.data_type() == DataType::F32;
        if !is_wanted {
            return Err(format!("{:?} of {:?} as vectors", accessor.dimensions(), accessor.data_type()));
        }
        let values = self.values::<[f32; N]>(accessor)?;
        Ok(values.map(|vector| vector.map(f64::from)).collect())
    }

    /// Texture coordinates: numbers, or integers in units of 1/255 or 1/65535.
    ///
    /// # Errors
    /// The problem: too few numbers.
    pub fn uvs(&self, accessor: &Accessor) -> Result<Option<Vec<[f64; 2]>>, String> {
        Ok(match (accessor.dimensions(), accessor.data_type()) {
            (Dimensions::Vec2, DataType::F32) => Some(self.vectors(accessor)?),
            (Dimensions::Vec2, DataType::U8) => {
                let values = self.values::<[u8; 2]>(accessor)?;
                Some(values.map(|uv| uv.map(|part| f64::from(part) / 255.0)).collect())
            }
            (Dimensions::Vec2, DataType::U16) => {
                let values = self.values::<[u16; 2]>(accessor)?;
                Some(values.map(|uv| uv.map(|part| f64::from(part) / 65_535.0)).collect())
            }
            _ => None,
        })
    }

    /// Indices of vertices.
    ///
    /// # Errors
    /// The problem: other numbers, or too few.
    pub fn indices(&self, accessor: &Accessor) -> Result<Vec<u32>, String> {
        Ok(match (accessor.dimensions(), accessor.data_type()) {
            (Dimensions::Scalar, DataType::U8) => self.values::<u8>(accessor)?.map(u32::from).collect(),
            (Dimensions::Scalar, DataType::U16) => self.values::<u16>(accessor)?.map(u32::from).collect(),
            (Dimensions::Scalar, DataType::U32) => self.values::<u32>(accessor)?.collect(),
            (dimensions, kind) => return Err(format!("{dimensions:?} of {kind:?} as indices")),
        })
    }

    fn values<T: Item>(&self, accessor: &Accessor) -> Result<Iter<'_, T>, String> {
        let count = accessor.count();
        let bytes: usize = self.buffers.iter().map(|buffer| buffer.len()).sum();
        let few = || format!("{count} numbers that the buffers do not have");
        // The library computes with counts and offsets before it checks that the bytes exist.
        let (mut counts, mut offsets) = (vec![count], vec![accessor.offset()]);
        let mut views: Vec<View> = accessor.view().into_iter().collect();
        if let Some(sparse) = accessor.sparse() {
            let (indices, values) = (sparse.indices(), sparse.values());
            counts.push(sparse.count());
            offsets.extend([indices.offset(), values.offset()]);
            views.extend([indices.view(), values.view()]);
        }
        offsets.extend(views.iter().flat_map(|view| [view.offset(), view.length()]));
        if counts.contains(&0) || counts.iter().chain(&offsets).any(|number| *number > bytes) {
            return Err(few());
        }
        if accessor.view().and_then(|view| view.stride()).is_some_and(|stride| stride < size_of::<T>()) {
            return Err(format!("numbers that overlap in accessor {}", accessor.index()));
        }
        let buffer = |buffer: gltf::Buffer| self.buffers.get(buffer.index()).map(AsRef::as_ref);
        Iter::new(accessor.clone(), buffer).ok_or_else(few)
    }
}
