//! Accessors: typed, strided, possibly sparse views into the buffers.

use glam::{Vec2, Vec3};
use gltf::json;
use json::accessor::{Accessor, ComponentType, Type};
use json::validation::Checked;

use super::buffers::Buffers;

/// Reads the accessors of a document.
pub(super) struct Accessors<'a> {
    root: &'a json::Root,
    buffers: &'a Buffers<'a>,
}

/// Elements at equal distances in some bytes.
struct Elements<'a> {
    bytes: &'a [u8],
    stride: usize,
    size: usize,
    count: usize,
}

impl<'a> Elements<'a> {
    fn iter(&self) -> impl Iterator<Item = &'a [u8]> {
        let (bytes, stride, size) = (self.bytes, self.stride, self.size);
        (0..self.count).map(move |i| &bytes[i * stride..i * stride + size])
    }
}

impl<'a> Accessors<'a> {
    pub(super) fn new(root: &'a json::Root, buffers: &'a Buffers<'a>) -> Self {
        Self { root, buffers }
    }

    /// Positions: three components of any type.
    pub(super) fn positions(&self, index: usize) -> Result<Vec<Vec3>, String> {
        let place = |fault: String| format!("accessor {index}: {fault}");
        let accessor = self.accessor(index)?;
        let kind = component_type(accessor).map_err(place)?;
        if !matches!(accessor.type_, Checked::Valid(Type::Vec3)) {
            return Err(place("positions must be of type VEC3; export again".to_owned()));
        }
        let normalized = accessor.normalized;
        let size = kind.size();
        self.read(accessor, 3 * size, |bytes| {
            Vec3::from_array(
                [0, 1, 2].map(|i| real(&bytes[i * size..(i + 1) * size], kind, normalized)),
            )
        })
        .map_err(place)
    }

    /// Texture coordinates: two components of any type.
    pub(super) fn coordinates(&self, index: usize) -> Result<Vec<Vec2>, String> {
        let place = |fault: String| format!("accessor {index}: {fault}");
        let accessor = self.accessor(index)?;
        let kind = component_type(accessor).map_err(place)?;
        if !matches!(accessor.type_, Checked::Valid(Type::Vec2)) {
            return Err(place("texture coordinates must be of type VEC2; export again".to_owned()));
        }
        let normalized = accessor.normalized;
        let size = kind.size();
        self.read(accessor, 2 * size, |bytes| {
            let component = |i: usize| real(&bytes[i * size..(i + 1) * size], kind, normalized);
            Vec2::new(component(0), component(1))
        })
        .map_err(place)
    }

    /// Vertex indices: unsigned scalars.
    pub(super) fn indices(&self, index: usize) -> Result<Vec<u32>, String> {
        let place = |fault: String| format!("accessor {index}: {fault}");
        let accessor = self.accessor(index)?;
        let kind = component_type(accessor).map_err(place)?;
        let is_unsigned =
            matches!(kind, ComponentType::U8 | ComponentType::U16 | ComponentType::U32);
        if !is_unsigned || !matches!(accessor.type_, Checked::Valid(Type::Scalar)) {
            return Err(place("indices must be unsigned SCALARs; export again".to_owned()));
        }
        self.read(accessor, kind.size(), unsigned).map_err(place)
    }

    fn accessor(&self, index: usize) -> Result<&'a Accessor, String> {
        self.root
            .accessors
            .get(index)
            .ok_or_else(|| format!("accessor {index} does not exist; export again"))
    }

    fn read<T: Copy + Default>(
        &self,
        accessor: &Accessor,
        size: usize,
        decode: impl Fn(&[u8]) -> T,
    ) -> Result<Vec<T>, String> {
        let count = accessor.count.0 as usize;
        let offset = accessor.byte_offset.unwrap_or_default().0;
        let mut values = match accessor.buffer_view {
            Some(view) => {
                self.elements(view.value(), offset, size, count)?.iter().map(&decode).collect()
            }
            // Zeros behind which there are no bytes: believed up to the size of the file's data.
            None if accessor.sparse.is_some() && count <= self.buffers.total_bytes() => {
                vec![T::default(); count]
            }
            None => return Err("it has no data; export again".to_owned()),
        };
        if let Some(sparse) = &accessor.sparse {
            self.substitute(&mut values, sparse, size, decode)
                .map_err(|fault| format!("sparse: {fault}"))?;
        }
        Ok(values)
    }

    fn substitute<T>(
        &self,
        values: &mut [T],
        sparse: &json::accessor::sparse::Sparse,
        size: usize,
        decode: impl Fn(&[u8]) -> T,
    ) -> Result<(), String> {
        let Checked::Valid(kind) = sparse.indices.component_type else {
            return Err("its indices have an unknown component type; export again".to_owned());
        };
        let (indices, new) = (&sparse.indices, &sparse.values);
        let count = sparse.count.0 as usize;
        let targets = self.elements(
            indices.buffer_view.value(),
            indices.byte_offset.0,
            kind.0.size(),
            count,
        )?;
        let new = self.elements(new.buffer_view.value(), new.byte_offset.0, size, count)?;
        for (target, bytes) in targets.iter().map(unsigned).zip(new.iter()) {
            let value = values
                .get_mut(target as usize)
                .ok_or_else(|| format!("element {target} does not exist; export again"))?;
            *value = decode(bytes);
        }
        Ok(())
    }

    /// The bytes of a buffer view.
    pub(super) fn view(&self, view: usize) -> Result<&'a [u8], String> {
        let fault = |what: &str| format!("buffer view {view} {what}; export again");
        let json = self.root.buffer_views.get(view).ok_or_else(|| fault("does not exist"))?;
        let buffer = self
            .buffers
            .get(json.buffer.value())
            .ok_or_else(|| fault("names a buffer that does not exist"))?;
        let start = json.byte_offset.unwrap_or_default().0;
        range(buffer, start, json.byte_length.0).ok_or_else(|| fault("reaches beyond its buffer"))
    }

    /// `count` elements of `size` bytes from `offset` in a buffer view, after checking that they
    /// are there.
    fn elements(
        &self,
        view: usize,
        offset: u64,
        size: usize,
        count: usize,
    ) -> Result<Elements<'a>, String> {
        let fault = |what: &str| format!("buffer view {view} {what}; export again");
        let bytes = self.view(view)?;
        let stride = self.root.buffer_views[view].byte_stride.map_or(size, |stride| stride.0);
        if stride < size {
            return Err(fault("has a stride smaller than its elements"));
        }
        let length = match count as u64 {
            0 => Some(0),
            count => {
                (stride as u64).checked_mul(count - 1).and_then(|n| n.checked_add(size as u64))
            }
        };
        let bytes = length
            .and_then(|length| range(bytes, offset, length))
            .ok_or_else(|| fault(&format!("is too short for {count} elements")))?;
        Ok(Elements { bytes, stride, size, count })
    }
}

fn component_type(accessor: &Accessor) -> Result<ComponentType, String> {
    match accessor.component_type {
        Checked::Valid(kind) => Ok(kind.0),
        Checked::Invalid => Err("its component type is unknown; export again".to_owned()),
    }
}

fn range(bytes: &[u8], start: u64, length: u64) -> Option<&[u8]> {
    let end = start.checked_add(length)?;
    bytes.get(usize::try_from(start).ok()?..usize::try_from(end).ok()?)
}

/// A little-endian unsigned integer of one, two or four bytes.
fn unsigned(bytes: &[u8]) -> u32 {
    bytes.iter().rev().fold(0, |value, byte| value << 8 | u32::from(*byte))
}

/// One component as a real number; integers as they are or, if `normalized`, over their largest
/// value (glTF 2.0 §3.6.2.2).
fn real(bytes: &[u8], kind: ComponentType, normalized: bool) -> f32 {
    let bits = unsigned(bytes);
    let (value, largest) = match kind {
        ComponentType::F32 => return f32::from_bits(bits),
        ComponentType::I8 => (f32::from(bits as u8 as i8), f32::from(i8::MAX)),
        ComponentType::U8 => (bits as f32, f32::from(u8::MAX)),
        ComponentType::I16 => (f32::from(bits as u16 as i16), f32::from(i16::MAX)),
        ComponentType::U16 => (bits as f32, f32::from(u16::MAX)),
        ComponentType::U32 => (bits as f32, u32::MAX as f32),
    };
    if normalized { (value / largest).max(-1.0) } else { value }
}
