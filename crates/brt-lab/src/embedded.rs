//! Pictures inside of pages.

use std::io::{self, Write};
use std::sync::{Arc, Mutex};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use brt::image::{EncodeError, PlainSink, encoder};
use brt::{Encoding, PictureSize};

/// The address of a PNG that stands in the page itself, of linear colours.
pub(crate) fn png_address(colors: &[[f32; 3]], size: PictureSize) -> Result<String, EncodeError> {
    let bytes = Bytes::default();
    let mut png = encoder(Box::new(PlainSink(bytes.clone())), size, Encoding::default())?;
    png.write(colors)?;
    png.finish()?;
    let data = bytes.0.lock().map(|bytes| STANDARD.encode(&*bytes)).unwrap_or_default();
    Ok(format!("data:image/png;base64,{data}"))
}

/// A file in memory.
#[derive(Clone, Default)]
struct Bytes(Arc<Mutex<Vec<u8>>>);

impl Write for Bytes {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut all = self.0.lock().map_err(|_| io::ErrorKind::Other)?;
        all.extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
