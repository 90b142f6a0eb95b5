//! The bytes behind a document: the binary chunk, data URIs and files beside it.

use std::borrow::Cow;
use std::path::{Component, Path, PathBuf};

use gltf::json;

use super::container::MAX_FILE_BYTES;
use crate::whole_file;

/// Most bytes of all external buffers together.
const MAX_EXTERNAL_BYTES: usize = 1 << 32;

/// The buffers of a document, each exactly as long as declared.
pub(super) struct Buffers<'a>(Vec<Cow<'a, [u8]>>);

impl<'a> Buffers<'a> {
    /// Fetches every buffer; files are looked for relative to `folder`.
    pub(super) fn load(
        root: &json::Root,
        blob: Option<&'a [u8]>,
        folder: &Path,
    ) -> Result<Self, String> {
        let mut buffers = Vec::new();
        let mut external = 0;
        for (index, buffer) in root.buffers.iter().enumerate() {
            let place = |fault: String| format!("buffer {index}: {fault}");
            let bytes = match (&buffer.uri, blob) {
                (Some(uri), _) if uri.starts_with("data:") => {
                    Cow::Owned(data_uri(uri).map_err(place)?)
                }
                (Some(uri), _) => {
                    let bytes = file_uri(uri, folder, MAX_FILE_BYTES).map_err(place)?;
                    external += bytes.len();
                    Cow::Owned(bytes)
                }
                (None, Some(blob)) if index == 0 => Cow::Borrowed(blob),
                (None, _) => {
                    return Err(place("it has neither URI nor binary chunk; export again".into()));
                }
            };
            if external > MAX_EXTERNAL_BYTES {
                return Err(format!("its buffers are larger than {MAX_EXTERNAL_BYTES} bytes"));
            }
            let declared = buffer.byte_length.0;
            if (bytes.len() as u64) < declared {
                return Err(place(format!(
                    "{declared} bytes are declared, but only {} are there; \
                     the file is truncated, copy or export it again",
                    bytes.len()
                )));
            }
            buffers.push(match bytes {
                Cow::Borrowed(bytes) => Cow::Borrowed(&bytes[..declared as usize]),
                Cow::Owned(mut bytes) => {
                    bytes.truncate(declared as usize);
                    Cow::Owned(bytes)
                }
            });
        }
        Ok(Self(buffers))
    }

    /// The bytes of buffer `index`.
    pub(super) fn get(&self, index: usize) -> Option<&[u8]> {
        self.0.get(index).map(AsRef::as_ref)
    }

    /// Bytes of all buffers together.
    pub(super) fn total_bytes(&self) -> usize {
        self.0.iter().map(|bytes| bytes.len()).sum()
    }
}

/// The bytes of a file beside the document, of at most `max_bytes` bytes.
pub(super) fn file_uri(uri: &str, folder: &Path, max_bytes: u64) -> Result<Vec<u8>, String> {
    let decoded = percent_decoded(uri)?;
    let path = PathBuf::from(&decoded);
    let leaves_root = |part: Component| matches!(part, Component::Prefix(_) | Component::RootDir);
    if decoded.contains(':') || path.components().any(leaves_root) {
        return Err(format!("'{uri}' is not a relative path; put the file beside the glTF"));
    }
    whole_file::read(&folder.join(path), max_bytes).map_err(|fault| format!("'{decoded}': {fault}"))
}

fn percent_decoded(uri: &str) -> Result<String, String> {
    let fault = || format!("'{uri}' is not a valid URI");
    let mut bytes = Vec::with_capacity(uri.len());
    let mut rest = uri.bytes();
    while let Some(byte) = rest.next() {
        if byte == b'%' {
            let mut digit = || rest.next().and_then(|d| char::from(d).to_digit(16));
            let (high, low) = (digit().ok_or_else(fault)?, digit().ok_or_else(fault)?);
            bytes.push((high * 16 + low) as u8);
        } else {
            bytes.push(byte);
        }
    }
    String::from_utf8(bytes).map_err(|_| fault())
}

/// The bytes that stand in a URI itself.
pub(super) fn data_uri(uri: &str) -> Result<Vec<u8>, String> {
    let (_, text) = uri
        .split_once(";base64,")
        .ok_or("its data URI is not base64; export with a separate or binary buffer")?;
    base64(text).ok_or_else(|| "its data URI is not valid base64; export again".to_owned())
}

/// Decodes base64 (RFC 4648 §4), padding optional.
fn base64(text: &str) -> Option<Vec<u8>> {
    let text = text.trim_end_matches('=').as_bytes();
    let mut bytes = Vec::with_capacity(text.len() / 4 * 3 + 2);
    for group in text.chunks(4) {
        let mut bits = 0_u32;
        for &letter in group {
            bits = bits << 6 | u32::from(sextet(letter)?);
        }
        match group.len() {
            4 => bytes.extend_from_slice(&bits.to_be_bytes()[1..]),
            3 => bytes.extend_from_slice(&(bits << 6).to_be_bytes()[1..3]),
            2 => bytes.push((bits >> 4) as u8),
            _ => return None,
        }
    }
    Some(bytes)
}

fn sextet(letter: u8) -> Option<u8> {
    match letter {
        b'A'..=b'Z' => Some(letter - b'A'),
        b'a'..=b'z' => Some(letter - b'a' + 26),
        b'0'..=b'9' => Some(letter - b'0' + 52),
        b'+' => Some(62),
        b'/' => Some(63),
        _ => None,
    }
}
