//! Writes `OpenEXR`: 32-bit float RGB, alpha and named layers, in scan-line blocks as they come.
//!
//! The exr crate compresses the blocks and writes the header; its own file writer works only
//! from inside a closure and a seekable file, so the order of the file is kept here: header,
//! table of block offsets, blocks. A sink that can go back gets compressed blocks and its table
//! at the end. Any other gets plain blocks, whose offsets are known in advance.
//!
//! Blocks are compressed in parallel, and a few blocks is all that is held. Measured on the
//! picture of `png_write`, one thread, ns per pixel and bytes per pixel (of 12): ZIP of 16 rows
//! 175, 3.9; ZIP of one row 260, 3.9; PIZ 155, 3.9; RLE 47, 12.0; none 42, 12.0. RLE gains
//! nothing on shaded floats, PIZ reads four times more slowly: ZIP of 16 rows, the format's
//! common choice, it is.

use std::io::Write;
use std::ops::Range;

use exr::block::chunk::{Chunk, CompressedBlock};
use exr::block::{BlockIndex, UncompressedBlock};
use exr::compression::Compression;
use exr::math::Vec2;
use exr::meta::attribute::{ChannelDescription, LineOrder, SampleType, Text};
use exr::meta::header::Header;
use exr::meta::{BlockDescription, MetaData, magic_number};
use rayon::prelude::*;

use super::error::EncodeError;
use super::format::{BandWriter, Channels};
use super::rows::RowCount;
use super::sink::Sink;
use super::work_clock::WorkClock;
use crate::{PictureSize, PixelRows};

/// Blocks compressed together: enough for the threads of a desktop.
const BLOCKS_AT_ONCE: usize = 16;
/// Row number and length before the bytes of a block.
const BLOCK_HEAD_BYTES: u64 = 8;
/// The names of the picture's own channels.
const COLOR_NAMES: [&str; 3] = ["R", "G", "B"];
const ALPHA_NAME: &str = "A";

/// Names of the channels stored beside R, G and B, such as `depth.Z` or `normal.X`.
///
/// Programs show what stands before the last dot as a layer.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ExrLayers {
    /// One name for each channel, in the order in which the values will be given.
    pub names: Vec<String>,
}

impl ExrLayers {
    /// These channels.
    pub fn new<N: Into<String>>(names: impl IntoIterator<Item = N>) -> Self {
        Self { names: names.into_iter().map(Into::into).collect() }
    }

    /// These channels, after alpha if the picture has it: to the format it is one more.
    pub fn beside<N: Into<String>>(channels: Channels, names: impl IntoIterator<Item = N>) -> Self {
        let alpha = (channels == Channels::Rgba).then(|| ALPHA_NAME.to_owned());
        Self { names: alpha.into_iter().chain(names.into_iter().map(Into::into)).collect() }
    }
}

/// Streams an EXR file, by [`BandWriter`] or, with further layers, by
/// [`ExrEncoder::write_with_layers`].
pub struct ExrEncoder {
    sink: Box<dyn Sink>,
    rows: RowCount,
    header: Header,
    /// Where each stored channel comes from: 0 to 2 are R, G, B, then the layers.
    sources: Vec<usize>,
    /// Where the table of offsets starts.
    table_start: u64,
    /// Where each block starts, in bytes from the start of the file.
    offsets: Vec<u64>,
    /// Where the next block will start.
    position: u64,
    /// Bytes of one row.
    row_bytes: usize,
    block_rows: usize,
    /// The block being filled: for each row, for each channel, the values in native byte order.
    block: Vec<u8>,
    full_blocks: Vec<UncompressedBlock>,
    blocks_begun: usize,
    clock: WorkClock,
}

impl ExrEncoder {
    /// Writes the header.
    ///
    /// # Errors
    /// If the format cannot hold the size, layer names are empty, repeated or too long, or the
    /// sink fails.
    pub fn new(mut sink: Box<dyn Sink>, size: PictureSize, layers: &ExrLayers) -> Result<Self, EncodeError> {
        let rows = RowCount::new(size, "EXR")?;
        let sources = channel_order(layers)?;
        let can_patch = sink.can_patch();
        let header = make_header(size, layers, &sources, can_patch);
        let bytes = header_bytes(&header)?;
        let table_start = bytes.len() as u64;
        let row_bytes = rows.width() * sources.len() * size_of::<f32>();
        let block_rows = header.compression.scan_lines_per_block();
        let table =
            if can_patch { vec![0; header.chunk_count] } else { plain_offsets(table_start, size, row_bytes) };
        sink.write_all(&bytes)?;
        write_table(&mut sink, &table)?;
        let position = table_start + 8 * header.chunk_count as u64;
        let offsets = Vec::with_capacity(header.chunk_count);
        let (block, full_blocks) = (Vec::new(), Vec::new());
        Ok(Self {
            sink,
            rows,
            header,
            sources,
            table_start,
            offsets,
            position,
            row_bytes,
            block_rows,
            block,
            full_blocks,
            blocks_begun: 0,
            clock: WorkClock::default(),
        })
    }

    /// Encodes the next rows: the colours, and for each layer one value for each pixel.
    ///
    /// # Errors
    /// If the rows do not fit the picture, a layer is missing or of another length, or the sink
    /// fails.
    pub fn write_with_layers(&mut self, rows: &[[f32; 3]], layers: &[&[f32]]) -> Result<(), EncodeError> {
        let expected = self.sources.len() - COLOR_NAMES.len();
        if layers.len() != expected {
            let message = format!("{expected} were announced, {} given", layers.len());
            return Err(EncodeError::Layers(message));
        }
        if let Some(layer) = layers.iter().find(|layer| layer.len() != rows.len()) {
            let message = format!("one has {} values for {} pixels", layer.len(), rows.len());
            return Err(EncodeError::Layers(message));
        }
        let after = self.rows.after(rows.len())?;
        let width = self.rows.width();
        for first in (0..rows.len()).step_by(width) {
            self.push_row(rows, layers, first..first + width);
            if self.block.len() == self.block_rows * self.row_bytes {
                self.end_block();
            }
            if self.full_blocks.len() == BLOCKS_AT_ONCE {
                self.write_blocks()?;
            }
        }
        self.rows = after;
        Ok(())
    }

    /// Appends a row to the block, channel by channel.
    fn push_row(&mut self, rows: &[[f32; 3]], layers: &[&[f32]], row: Range<usize>) {
        let start = self.block.len();
        self.block.reserve_exact(self.block_rows * self.row_bytes - start);
        self.block.resize(start + self.row_bytes, 0);
        let channels = self.block[start..].chunks_exact_mut(size_of::<f32>() * row.len());
        for (channel, &source) in channels.zip(&self.sources) {
            if source < COLOR_NAMES.len() {
                put_values(channel, rows[row.clone()].iter().map(|pixel| pixel[source]));
            } else {
                let layer = layers[source - COLOR_NAMES.len()];
                put_values(channel, layer[row.clone()].iter().copied());
            }
        }
    }

    fn end_block(&mut self) {
        let data = std::mem::take(&mut self.block);
        let rows = data.len() / self.row_bytes;
        let index = BlockIndex {
            layer: 0,
            pixel_position: Vec2(0, self.blocks_begun * self.block_rows),
            pixel_size: Vec2(self.rows.width(), rows),
            level: Vec2(0, 0),
        };
        self.blocks_begun += 1;
        self.full_blocks.push(UncompressedBlock { index, data });
    }

    fn write_blocks(&mut self) -> Result<(), EncodeError> {
        let headers = std::slice::from_ref(&self.header);
        let blocks = std::mem::take(&mut self.full_blocks);
        let chunks: Vec<Chunk> = blocks
            .into_par_iter()
            .map(|block| self.clock.time(|| block.compress_to_chunk(headers)))
            .collect::<Result<_, _>>()
            .map_err(|e| refused(&e))?;
        for chunk in &chunks {
            let CompressedBlock::ScanLine(lines) = &chunk.compressed_block else {
                return Err(refused(&"a block that is not of scan lines"));
            };
            self.offsets.push(self.position);
            self.position += BLOCK_HEAD_BYTES + lines.compressed_pixels_le.len() as u64;
            let Self { sink, clock, .. } = self;
            clock.time(|| chunk.write(sink, 1)).map_err(from_library)?;
        }
        Ok(())
    }
}

impl BandWriter for ExrEncoder {
    fn write_pixels(&mut self, rows: PixelRows<'_>) -> Result<(), EncodeError> {
        self.write_with_layers(rows.colors, rows.alpha.as_slice())
    }

    fn seconds(&self) -> f64 {
        self.clock.seconds()
    }

    fn finish(mut self: Box<Self>) -> Result<(), EncodeError> {
        self.rows.check_complete()?;
        if !self.block.is_empty() {
            self.end_block();
        }
        self.write_blocks()?;
        if self.sink.can_patch() {
            let mut table = Vec::with_capacity(8 * self.offsets.len());
            write_table(&mut table, &self.offsets)?;
            self.sink.patch(self.table_start, &table)?;
        }
        Ok(self.sink.commit()?)
    }
}

/// Values in native byte order, as the library wants them.
fn put_values(bytes: &mut [u8], values: impl Iterator<Item = f32>) {
    for (bytes, value) in bytes.chunks_exact_mut(size_of::<f32>()).zip(values) {
        bytes.copy_from_slice(&value.to_ne_bytes());
    }
}

/// The channels in the order of the file, which is by name; each says where it comes from.
fn channel_order(layers: &ExrLayers) -> Result<Vec<usize>, EncodeError> {
    for name in &layers.names {
        // Longer names need a later version of the format.
        if name.is_empty() || name.len() > 31 || name.contains('\0') {
            let message = format!("`{name}` is no name of 1 to 31 bytes");
            return Err(EncodeError::Layers(message));
        }
    }
    let mut order: Vec<usize> = (0..COLOR_NAMES.len() + layers.names.len()).collect();
    order.sort_by_key(|&source| source_name(layers, source));
    for pair in order.windows(2) {
        let name = source_name(layers, pair[0]);
        if name == source_name(layers, pair[1]) {
            return Err(EncodeError::Layers(format!("two channels are named `{name}`")));
        }
    }
    Ok(order)
}

fn source_name(layers: &ExrLayers, source: usize) -> &str {
    match COLOR_NAMES.get(source) {
        Some(name) => name,
        None => &layers.names[source - COLOR_NAMES.len()],
    }
}

fn make_header(size: PictureSize, layers: &ExrLayers, sources: &[usize], compressed: bool) -> Header {
    let channels = sources
        .iter()
        .map(|&source| {
            let name = Text::new_or_panic(source_name(layers, source));
            ChannelDescription::named(name, SampleType::F32)
        })
        .collect();
    let compression = if compressed { Compression::ZIP16 } else { Compression::Uncompressed };
    let size = Vec2(size.width as usize, size.height as usize);
    let mut header = Header::new(Text::default(), size, channels).with_encoding(
        compression,
        BlockDescription::ScanLines,
        LineOrder::Increasing,
    );
    // A file of one part needs no name for it.
    header.own_attributes.layer_name = None;
    header
}

/// Everything before the table of offsets.
fn header_bytes(header: &Header) -> Result<Vec<u8>, EncodeError> {
    let headers = std::slice::from_ref(header);
    let requirements = MetaData::validate(headers, true).map_err(|e| refused(&e))?;
    let mut bytes = Vec::new();
    magic_number::write(&mut bytes).map_err(|e| refused(&e))?;
    requirements.write(&mut bytes).map_err(|e| refused(&e))?;
    Header::write_all(headers, &mut bytes, false).map_err(|e| refused(&e))?;
    Ok(bytes)
}

/// Offsets of blocks of one uncompressed row.
fn plain_offsets(table_start: u64, size: PictureSize, row_bytes: usize) -> Vec<u64> {
    let first = table_start + 8 * u64::from(size.height);
    (0..u64::from(size.height)).map(|y| first + y * (BLOCK_HEAD_BYTES + row_bytes as u64)).collect()
}

fn write_table(sink: &mut impl Write, table: &[u64]) -> std::io::Result<()> {
    table.iter().try_for_each(|offset| sink.write_all(&offset.to_le_bytes()))
}

fn refused(error: &dyn std::fmt::Display) -> EncodeError {
    EncodeError::Library { format: "EXR", message: error.to_string() }
}

fn from_library(error: exr::error::Error) -> EncodeError {
    match error {
        exr::error::Error::Io(error) => error.into(),
        other => refused(&other),
    }
}
