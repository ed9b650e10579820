//! Buffers: inside a GLB, in the JSON itself, or in files beside it.

use std::borrow::Cow;

use base64::Engine;
use base64::engine::GeneralPurpose;
use base64::engine::general_purpose::GeneralPurposeConfig;
use gltf::Document;
use gltf::buffer::Source;

use crate::import::{Beside, Stop, fault};

/// The bytes of buffers; the binary part of a GLB is not copied.
pub(super) type Buffers<'b> = Vec<Cow<'b, [u8]>>;

/// The bytes of every buffer, at least as many as the file says.
pub(super) fn read<'b>(
    document: &Document,
    binary: Option<&'b [u8]>,
    beside: &mut Beside,
) -> Result<Buffers<'b>, Stop> {
    let mut buffers = Vec::new();
    for (i, buffer) in document.buffers().enumerate() {
        let bytes = match buffer.source() {
            Source::Bin => match binary {
                Some(binary) => Cow::Borrowed(binary),
                None => return Err(fault(format!("buffer {i}: the file has no binary part"), None)),
            },
            Source::Uri(uri) => {
                let read = if uri.starts_with("data:") { inline(uri) } else { beside.read(&decoded(uri)) };
                let bytes = read.map_err(|why| {
                    let name: String = uri.chars().take(60).collect();
                    fault(format!("buffer {i} (`{name}`) cannot be read: {why}"), None)
                })?;
                Cow::Owned(bytes)
            }
        };
        if bytes.len() < buffer.length() {
            let message = format!("buffer {i} has {} bytes instead of {}", bytes.len(), buffer.length());
            return Err(fault(message, None));
        }
        buffers.push(bytes);
    }
    Ok(buffers)
}

/// `data:…;base64,…`
pub(super) fn inline(uri: &str) -> Result<Vec<u8>, String> {
    let Some((_, data)) = uri.split_once(";base64,") else {
        return Err("only base64 can be read".to_owned());
    };
    let config =
        GeneralPurposeConfig::new().with_decode_padding_mode(base64::engine::DecodePaddingMode::Indifferent);
    let engine = GeneralPurpose::new(&base64::alphabet::STANDARD, config);
    engine.decode(data.trim()).map_err(|_| "its base64 is broken".to_owned())
}

/// Percent signs of a URI.
pub(super) fn decoded(uri: &str) -> String {
    let bytes = uri.as_bytes();
    let mut out = Vec::with_capacity(bytes.len());
    let mut i = 0;
    while i < bytes.len() {
        let code = uri.get(i + 1..i + 3).and_then(|digits| u8::from_str_radix(digits, 16).ok());
        match (bytes[i], code) {
            (b'%', Some(code)) => {
                out.push(code);
                i += 3;
            }
            (byte, _) => {
                out.push(byte);
                i += 1;
            }
        }
    }
    String::from_utf8_lossy(&out).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn uris_become_names() {
        assert_eq!(decoded("a%20b.bin"), "a b.bin");
        assert_eq!(decoded("100%"), "100%");
        assert_eq!(decoded("%2E%2E/x"), "../x");
    }

    #[test]
    fn data_may_lack_its_padding() {
        assert_eq!(inline("data:;base64,AAE=").unwrap(), [0, 1]);
        assert_eq!(inline("data:;base64,AAE").unwrap(), [0, 1]);
        assert!(inline("data:,x").is_err());
    }
}
