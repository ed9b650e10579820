//! The binary container (GLB): a header of twelve bytes, then chunks. The `gltf` crate's own reader computes with what the
//! header says before checking it.

use crate::import::{Stop, fault};

const JSON: u32 = 0x4E4F_534A;
const BINARY: u32 = 0x004E_4942;

/// The JSON of a file.
#[derive(Clone, Copy)]
pub(super) struct Json<'b> {
    pub(super) text: &'b [u8],
    /// Where it begins in a file that is text.
    pub(super) start: Option<usize>,
}

/// The JSON and, in a GLB that has one, its binary part.
pub(super) fn parts(bytes: &[u8]) -> Result<(Json<'_>, Option<&[u8]>), Stop> {
    if !bytes.starts_with(b"glTF") {
        return Ok((whole(bytes)?, None));
    }
    let (Some(version), Some(length)) = (word(bytes, 4), word(bytes, 8)) else {
        return Err(fault("the file ends within its header", None));
    };
    if version != 2 {
        return Err(fault(format!("version {version} of the binary container, expected 2"), None));
    }
    let Some(body) = bytes.get(12..length as usize) else {
        let message = format!("the header says {length} bytes, the file has {}", bytes.len());
        return Err(fault(message, None));
    };
    let (kind, json, rest) = chunk(body)?;
    if kind != JSON {
        return Err(fault("the first chunk is not JSON", None));
    }
    let json = Json { text: json, start: None };
    if rest.is_empty() {
        return Ok((json, None));
    }
    let (kind, data, _) = chunk(rest)?;
    Ok((json, (kind == BINARY).then_some(data)))
}

/// A file that is nothing but JSON, which is an object.
fn whole(bytes: &[u8]) -> Result<Json<'_>, Stop> {
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    if !text.trim_ascii_start().starts_with(b"{") {
        return Err(fault(
            "the file does not begin with `glTF`, as a GLB does, or with `{`, as JSON does",
            None,
        ));
    }
    Ok(Json { text, start: Some(bytes.len() - text.len()) })
}

/// Kind and content of the first chunk, and what follows it.
fn chunk(bytes: &[u8]) -> Result<(u32, &[u8], &[u8]), Stop> {
    let (Some(length), Some(kind)) = (word(bytes, 0), word(bytes, 4)) else {
        return Err(fault("the file ends within the header of a chunk", None));
    };
    match bytes[8..].split_at_checked(length as usize) {
        Some((content, rest)) => Ok((kind, content, rest)),
        None => Err(fault(format!("a chunk of {length} bytes reaches beyond the end of the file"), None)),
    }
}

fn word(bytes: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_le_bytes(bytes.get(at..at + 4)?.try_into().ok()?))
}
