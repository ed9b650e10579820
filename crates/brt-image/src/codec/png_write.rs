//! Writes PNG: RGB or RGBA with 8 or 16 bits, on all threads of the calling pool.
//!
//! Rows are gathered to segments whose height follows from the width alone, so the bytes of a file depend neither on
//! threads nor on bands. A segment is quantised, filtered and compressed by one thread while it is in its cache.
//! Measured on seed scenes A and B, 4096², one thread of a busy machine (the least of one to three runs), ns and bytes per pixel:
//!
//! | | deflate | filter | 8 bit, A | 8 bit, B | 16 bit, A | 16 bit, B |
//! |---|---|---|---|---|---|---|
//! | fast | runs | Paeth | 6.9, 0.119 | 10.4, 0.299 | 35, 1.97 | 38, 2.64 |
//! | balanced | level 2 | up | 7.4, 0.103 | 13.3, 0.291 | 56, 1.11 | 76, 1.59 |
//! | small | level 6 | adaptive | 26, 0.077 | 55, 0.235 | 174, 0.80 | 162, 1.37 |
//! | (lost) | level 9 | adaptive | 153, 0.066 | 330, 0.213 | 1153, 0.74 | 675, 1.36 |
//!
//! Quantising is part of it. `fast` is the default: filling a pixel costs about a nanosecond, so a slower writer would
//! cost more than the picture.

use png::chunk::IDAT;
use png::{ColorType, Encoder, ScaledFloat, SrgbRenderingIntent, Writer};
use rayon::prelude::*;

use super::deflate::{Checksum, Deflate, ZLIB_HEADER};
use super::error::EncodeError;
use super::format::{BandWriter, BitDepth, Channels, Compression, Encoding};
use super::latch::Latch;
use super::png_filter::{FilterChoice, RowFilter, filter_row};
use super::pnm_write::SampleBytes;
use super::rows::RowCount;
use super::sink::Sink;
use super::work_clock::WorkClock;
use crate::{PictureSize, PixelRows, Transfer, straight};

/// Bytes of a segment before it is compressed, about: large beside what each costs, small beside a cache.
const SEGMENT_BYTES: usize = 1 << 18;
/// Most rows of a segment. Powers of two divide the bands that are rendered, so that few rows wait for the next.
const SEGMENT_ROWS: usize = 128;
/// Segments worked on together: enough for the threads of a desktop.
const SEGMENTS_AT_ONCE: usize = 32;

/// Streams a PNG file of pixels with so many channels: 3, or 4 with alpha.
pub(crate) struct PngEncoder<const N: usize> {
    writer: Writer<Latch>,
    latch: Latch,
    rows: RowCount,
    format: RowFormat,
    /// Rows of a segment.
    segment_rows: usize,
    /// Rows of a segment that is not complete.
    waiting: Vec<[f32; N]>,
    /// The last row of the last complete segment; empty if there is none.
    above: Vec<[f32; N]>,
    checksum: Checksum,
    /// Buffers, kept.
    segments: Vec<Segment>,
    clock: WorkClock,
}

/// How rows become bytes.
#[derive(Clone, Copy)]
struct RowFormat {
    samples: SampleBytes,
    filter: FilterChoice,
    deflate: Deflate,
}

/// A segment on its way.
#[derive(Default)]
struct Segment {
    /// The row above, and one row.
    rows: [Vec<u8>; 2],
    filtered: Vec<u8>,
    compressed: Vec<u8>,
    checksum: u32,
}

impl<const N: usize> PngEncoder<N> {
    /// Writes the header.
    pub(crate) fn new(
        sink: Box<dyn Sink>,
        size: PictureSize,
        encoding: Encoding,
    ) -> Result<Self, EncodeError> {
        let rows = RowCount::new(size, "PNG")?;
        let (writer, latch) = Latch::pair(sink);
        let mut png = Encoder::new(writer, size.width, size.height);
        png.set_color(if N == 4 { ColorType::Rgba } else { ColorType::Rgb });
        png.set_depth(match encoding.depth {
            BitDepth::Eight => png::BitDepth::Eight,
            BitDepth::Sixteen => png::BitDepth::Sixteen,
        });
        match encoding.transfer {
            Transfer::Srgb => png.set_source_srgb(SrgbRenderingIntent::Perceptual),
            Transfer::Linear => png.set_source_gamma(ScaledFloat::new(1.0)),
        }
        let writer = png.write_header().map_err(|e| refused(&e))?;
        latch.check()?;
        let (filter, deflate) = match encoding.compression {
            Compression::Fast => (FilterChoice::Always(RowFilter::Paeth), Deflate::Runs),
            Compression::Balanced => (FilterChoice::Always(RowFilter::Up), Deflate::Level(2)),
            Compression::Small => (FilterChoice::Adaptive, Deflate::Level(6)),
        };
        let samples = SampleBytes::new(encoding);
        Ok(Self {
            writer,
            latch,
            rows,
            segment_rows: segment_rows(rows.width() * samples.pixel_bytes(N)),
            format: RowFormat { samples, filter, deflate },
            waiting: Vec::new(),
            above: Vec::new(),
            checksum: Checksum::EMPTY,
            segments: Vec::new(),
            clock: WorkClock::default(),
        })
    }

    /// Compresses and writes segments that follow each other; `above` is the row above the first, if there is one.
    fn write_segments(&mut self, segments: &[&[[f32; N]]], above: &[[f32; N]]) -> Result<(), EncodeError> {
        let width = self.rows.width();
        let above = |i: usize| if i == 0 { above } else { &segments[i - 1][segments[i - 1].len() - width..] };
        let Self { format, clock, .. } = self;
        if self.segments.len() < segments.len() {
            self.segments.resize_with(segments.len(), Segment::default);
        }
        let compress = |(buffer, (i, rows)): (&mut Segment, (usize, &&[[f32; N]]))| {
            clock.time(|| buffer.compress(*format, rows, above(i), width))
        };
        if let ([buffer, ..], [rows]) = (&mut self.segments[..], segments) {
            // No pool is asked, and none started, for the end of a picture.
            compress((buffer, (0, rows)))?;
        } else {
            let buffers = self.segments.par_iter_mut().zip(segments.par_iter().enumerate());
            buffers.with_max_len(1).try_for_each(compress)?;
        }
        clock.time(|| {
            for buffer in &self.segments[..segments.len()] {
                self.checksum = self.checksum.followed_by(buffer.checksum, buffer.filtered.len());
                self.writer.write_chunk(IDAT, &buffer.compressed).map_err(|e| refused(&e))?;
                self.latch.check()?;
            }
            Ok(())
        })
    }

    /// Moves rows from the front of `rows` to those that wait, and writes these if they are a segment then.
    fn complete_waiting<'r>(&mut self, rows: &'r [[f32; N]]) -> Result<&'r [[f32; N]], EncodeError> {
        let missing = self.segment_rows * self.rows.width() - self.waiting.len();
        let (front, rest) = rows.split_at(missing.min(rows.len()));
        self.waiting.extend_from_slice(front);
        if front.len() == missing {
            self.write_waiting()?;
        }
        Ok(rest)
    }

    fn write_waiting(&mut self) -> Result<(), EncodeError> {
        let (mut waiting, above) = (std::mem::take(&mut self.waiting), std::mem::take(&mut self.above));
        self.write_segments(&[&waiting], &above)?;
        self.above = above;
        self.keep_above(&waiting);
        waiting.clear();
        self.waiting = waiting;
        Ok(())
    }

    fn keep_above(&mut self, segment: &[[f32; N]]) {
        self.above.clear();
        self.above.extend_from_slice(&segment[segment.len() - self.rows.width()..]);
    }

    /// Takes rows that were counted.
    fn add(&mut self, rows: &[[f32; N]]) -> Result<(), EncodeError> {
        let mut rest = rows;
        if !self.waiting.is_empty() {
            rest = self.complete_waiting(rest)?;
        }
        let segment = self.segment_rows * self.rows.width();
        let (whole, rest) = rest.split_at(rest.len() / segment * segment);
        for together in whole.chunks(segment * SEGMENTS_AT_ONCE) {
            let segments: Vec<_> = together.chunks_exact(segment).collect();
            let above = std::mem::take(&mut self.above);
            self.write_segments(&segments, &above)?;
            self.above = above;
            self.keep_above(together);
        }
        self.waiting.extend_from_slice(rest);
        Ok(())
    }
}

/// Rows of a segment, for bytes of a row.
fn segment_rows(row_bytes: usize) -> usize {
    let most = (SEGMENT_BYTES / row_bytes).clamp(1, SEGMENT_ROWS);
    1 << most.ilog2()
}

impl Segment {
    fn compress<const N: usize>(
        &mut self,
        format: RowFormat,
        rows: &[[f32; N]],
        above: &[[f32; N]],
        width: usize,
    ) -> Result<(), EncodeError> {
        let RowFormat { samples, filter, deflate } = format;
        let step = samples.pixel_bytes(N);
        let [before, now] = &mut self.rows;
        before.resize(width * step, 0);
        now.resize(width * step, 0);
        if above.is_empty() {
            before.fill(0);
        } else {
            samples.put(above, before);
        }
        self.filtered.clear();
        for row in rows.chunks_exact(width) {
            samples.put(row, now);
            filter_row(filter, now, before, step, &mut self.filtered);
            std::mem::swap(before, now);
        }
        self.compressed.clear();
        if above.is_empty() {
            self.compressed.extend(ZLIB_HEADER);
        }
        self.checksum = deflate.segment(&self.filtered, &mut self.compressed)?;
        Ok(())
    }
}

/// The sink never fails in the library's eyes, so this is the library's own complaint.
fn refused(error: &dyn std::fmt::Display) -> EncodeError {
    EncodeError::Library { format: "PNG", message: error.to_string() }
}

/// A pixel as PNG has it: the colour is that of what covers the pixel, however little that is.
fn with_alpha<const N: usize>(color: [f32; 3], alpha: f32) -> [f32; N] {
    let color = straight(color, alpha);
    std::array::from_fn(|i| *color.get(i).unwrap_or(&alpha))
}

impl<const N: usize> BandWriter for PngEncoder<N> {
    fn write_pixels(&mut self, rows: PixelRows<'_>) -> Result<(), EncodeError> {
        let channels = if N == 4 { Channels::Rgba } else { Channels::Rgb };
        let after = self.rows.after_pixels(&rows, channels)?;
        match rows.alpha {
            None => self.add(rows.colors.as_flattened().as_chunks().0)?,
            Some(alpha) => {
                let pixels = rows.colors.iter().zip(alpha).map(|(&color, &alpha)| with_alpha(color, alpha));
                let pixels: Vec<_> = self.clock.time(|| pixels.collect());
                self.add(&pixels)?;
            }
        }
        self.rows = after;
        Ok(())
    }

    fn finish(mut self: Box<Self>) -> Result<(), EncodeError> {
        self.rows.check_complete()?;
        if !self.waiting.is_empty() {
            self.write_waiting()?;
        }
        let Self { mut writer, latch, checksum, .. } = *self;
        writer.write_chunk(IDAT, &checksum.stream_end()).map_err(|e| refused(&e))?;
        writer.finish().map_err(|e| refused(&e))?;
        Ok(latch.commit()?)
    }

    fn seconds(&self) -> f64 {
        self.clock.seconds()
    }
}
