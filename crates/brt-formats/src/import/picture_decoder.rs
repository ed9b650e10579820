//! Bytes of a PNG or JPEG file as texels: colours of 8 bits with opacity.

use std::io::Cursor;

use png::{BitDepth, ColorType, Transformations};
use zune_jpeg::JpegDecoder;
use zune_jpeg::zune_core::bytestream::ZCursor;
use zune_jpeg::zune_core::colorspace::ColorSpace;
use zune_jpeg::zune_core::options::DecoderOptions;

/// Memory that the library for PNG may take beside the pixels: rows, tables and texts.
const SURROUNDINGS: usize = 64 << 20;

/// What is stored just as texels are.
const AS_TEXELS: (ColorType, BitDepth) = (ColorType::Rgba, BitDepth::Eight);

/// A picture whose head is read.
pub(super) enum PictureDecoder<'b> {
    Png(Box<png::Reader<Cursor<&'b [u8]>>>),
    Jpeg { decoder: Box<JpegDecoder<ZCursor<&'b [u8]>>>, size: [u32; 2], components: u8 },
}

impl<'b> PictureDecoder<'b> {
    /// Reads the head. What the bytes are is said by themselves: names lie.
    pub(super) fn new(bytes: &'b [u8]) -> Result<Self, String> {
        if bytes.starts_with(b"\x89PNG\r\n\x1a\n") {
            Self::png(bytes).map_err(|error| short(&error.to_string()))
        } else if bytes.starts_with(b"\xff\xd8\xff") {
            refuse_many_scans(bytes)?;
            Self::jpeg(bytes)
        } else {
            Err("it is neither PNG nor JPEG".to_owned())
        }
    }

    fn png(bytes: &'b [u8]) -> Result<Self, png::DecodingError> {
        let limits = png::Limits { bytes: SURROUNDINGS };
        let mut decoder = png::Decoder::new_with_limits(Cursor::new(bytes), limits);
        decoder.set_ignore_text_chunk(true);
        decoder.set_ignore_iccp_chunk(true);
        // Palettes become colours, small depths 8 bits, a transparent colour an opacity.
        decoder.set_transformations(Transformations::EXPAND);
        Ok(Self::Png(Box::new(decoder.read_info()?)))
    }

    fn jpeg(bytes: &'b [u8]) -> Result<Self, String> {
        let options = DecoderOptions::default()
            .set_strict_mode(false)
            .set_max_width(usize::from(u16::MAX))
            .set_max_height(usize::from(u16::MAX));
        let mut decoder = Box::new(JpegDecoder::new_with_options(ZCursor::new(bytes), options));
        decoder.decode_headers().map_err(|error| short(&error.to_string()))?;
        let info = decoder.info().ok_or("it has no frame")?;
        let space = match info.components {
            1 => ColorSpace::Luma,
            3 | 4 => ColorSpace::RGB,
            other => return Err(format!("it has {other} components")),
        };
        decoder.set_options(options.jpeg_set_out_colorspace(space));
        let size = [u32::from(info.width), u32::from(info.height)];
        Ok(Self::Jpeg { decoder, size, components: info.components })
    }

    /// Width and height in pixels.
    pub(super) fn size(&self) -> [u32; 2] {
        match self {
            Self::Png(reader) => [reader.info().width, reader.info().height],
            Self::Jpeg { size, .. } => *size,
        }
    }

    /// Bytes that so many pixels need beside their texels while they are decoded: as they are stored, those of 16 bits
    /// rounded to 8, and for a progressive JPEG all its coefficients.
    pub(super) fn passing_bytes(&self, pixels: u64) -> u64 {
        const COEFFICIENT: u64 = 2;
        match self {
            Self::Png(reader) if reader.output_color_type() == AS_TEXELS => 0,
            Self::Png(reader) => {
                let stored = reader.output_buffer_size().unwrap_or(usize::MAX) as u64;
                let is_deep = reader.output_color_type().1 == BitDepth::Sixteen;
                stored.saturating_add(if is_deep { stored / 2 } else { 0 })
            }
            Self::Jpeg { components, .. } => pixels.saturating_mul(3 + COEFFICIENT * u64::from(*components)),
        }
    }

    /// Adds all texels, row by row from the top.
    pub(super) fn decode(self, texels: &mut Vec<[u8; 4]>) -> Result<(), String> {
        match self {
            Self::Png(mut reader) if reader.output_color_type() == AS_TEXELS => {
                let [width, height] = [reader.info().width, reader.info().height];
                texels.resize(width as usize * height as usize, [0; 4]);
                reader.next_frame(texels.as_flattened_mut()).map_err(|error| short(&error.to_string()))?;
            }
            Self::Png(mut reader) => {
                let mut stored = vec![0; reader.output_buffer_size().ok_or("it is too large")?];
                let frame = reader.next_frame(&mut stored).map_err(|error| short(&error.to_string()))?;
                stored.truncate(frame.buffer_size());
                if frame.bit_depth == BitDepth::Sixteen {
                    stored = stored.as_chunks().0.iter().map(|&level| rounded(level)).collect();
                }
                add_texels(&stored, frame.color_type.samples(), texels);
            }
            Self::Jpeg { mut decoder, size: [width, height], components } => {
                let channels = if components == 1 { 1 } else { 3 };
                let mut stored = vec![0; width as usize * height as usize * channels];
                decoder.decode_into(&mut stored).map_err(|error| short(&error.to_string()))?;
                add_texels(&stored, channels, texels);
            }
        }
        Ok(())
    }
}

/// A scan may be a few bytes and costs as much time as all the picture. Progressive files have about ten.
fn refuse_many_scans(jpeg: &[u8]) -> Result<(), String> {
    const MOST_SCANS: usize = 200;
    let scans = jpeg.windows(2).filter(|pair| pair == b"\xff\xda").count();
    if scans > MOST_SCANS { Err(format!("it has {scans} scans")) } else { Ok(()) }
}

/// The nearest of 256 levels to one of 65,536.
fn rounded(level: [u8; 2]) -> u8 {
    ((u32::from(u16::from_be_bytes(level)) + 128) / 257) as u8
}

/// Adds pixels of one to four channels.
fn add_texels(stored: &[u8], channels: usize, texels: &mut Vec<[u8; 4]>) {
    let pixels = stored.chunks_exact(channels);
    texels.extend(pixels.map(|pixel| match *pixel {
        [grey] => [grey, grey, grey, 255],
        [grey, alpha] => [grey, grey, grey, alpha],
        [r, g, b] => [r, g, b, 255],
        [r, g, b, alpha, ..] => [r, g, b, alpha],
        [] => [0; 4],
    }));
}

/// The first line of a decoder's message.
fn short(message: &str) -> String {
    message.lines().next().unwrap_or_default().chars().take(200).collect()
}
