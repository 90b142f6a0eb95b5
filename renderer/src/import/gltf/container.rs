//! The file itself: JSON alone, or JSON and binary chunks in a GLB.

use std::io;
use std::path::Path;

use gltf::json;

use crate::whole_file;

/// Largest file that is read, in bytes.
pub(super) const MAX_FILE_BYTES: u64 = 1 << 32;

/// Extensions a file may require. Those on materials and textures alone never change the geometry
/// and are accepted beside these.
const EXTENSIONS: [&str; 2] = ["KHR_lights_punctual", "KHR_mesh_quantization"];
const EXTENSION_FAMILIES: [&str; 3] = ["KHR_materials_", "KHR_texture_", "EXT_texture_"];

/// Reads a regular file whole.
pub(super) fn read_file(path: &Path) -> io::Result<Vec<u8>> {
    whole_file::read(path, MAX_FILE_BYTES)
}

/// The document and the binary chunk, if there is one.
pub(super) fn parse(file: &[u8]) -> Result<(json::Root, Option<&[u8]>), String> {
    let (text, blob) = if file.starts_with(b"glTF") {
        chunks(file)?
    } else {
        (file.strip_prefix(b"\xef\xbb\xbf").unwrap_or(file), None)
    };
    let root: json::Root = json::deserialize::from_slice(text)
        .map_err(|fault| format!("not a readable glTF 2.0 document ({fault}); export it again"))?;
    if !root.asset.version.starts_with("2.") {
        return Err(format!("glTF version {}; export it as glTF 2.0", root.asset.version));
    }
    let unknown = |name: &&String| {
        !EXTENSIONS.contains(&name.as_str())
            && !EXTENSION_FAMILIES.iter().any(|family| name.starts_with(family))
    };
    if let Some(name) = root.extensions_required.iter().find(unknown) {
        return Err(format!(
            "it requires the extension {name}, which is not supported; export it without \
             (for Draco or meshopt: without compression)"
        ));
    }
    Ok((root, blob))
}

/// The JSON chunk and the binary chunk of a GLB (glTF 2.0 §4.4).
fn chunks(file: &[u8]) -> Result<(&[u8], Option<&[u8]>), String> {
    let truncated = || "the GLB is truncated; copy or export it again".to_owned();
    let version = word(file, 4).ok_or_else(truncated)?;
    if version != 2 {
        return Err(format!("GLB version {version}; export it as glTF 2.0"));
    }
    let length = word(file, 8).ok_or_else(truncated)? as usize;
    let body = file.get(..length).ok_or_else(truncated)?;
    let text = chunk(body, 12).ok_or_else(truncated)?;
    if text.kind != b"JSON" {
        return Err("the GLB does not begin with a JSON chunk; export it again".to_owned());
    }
    // Chunks are padded to four bytes; any after the second are extensions, to be ignored.
    let end = (12 + 8 + text.bytes.len()).next_multiple_of(4);
    if end >= body.len() {
        return Ok((text.bytes, None));
    }
    let blob = chunk(body, end).ok_or_else(truncated)?;
    Ok((text.bytes, (blob.kind == b"BIN\0").then_some(blob.bytes)))
}

struct Chunk<'a> {
    kind: &'a [u8],
    bytes: &'a [u8],
}

fn chunk(body: &[u8], at: usize) -> Option<Chunk<'_>> {
    let length = word(body, at)? as usize;
    let start = at + 8;
    Some(Chunk { kind: body.get(at + 4..start)?, bytes: body.get(start..start + length)? })
}

/// The little-endian word at byte `at`.
fn word(bytes: &[u8], at: usize) -> Option<u32> {
    bytes.get(at..)?.first_chunk().map(|word| u32::from_le_bytes(*word))
}
