//! Writes PPM (P6), and makes the integer samples that PPM and PNG share.

use std::io::Write;

use rayon::prelude::*;

use super::error::EncodeError;
use super::format::{BandWriter, BitDepth, Channels, Encoding};
use super::rows::RowCount;
use super::sink::Sink;
use super::work_clock::WorkClock;
use crate::{PictureSize, PixelRows, Transfer};

/// Pixels turned into bytes by one task: enough to outweigh handing the task over.
const TASK_PIXELS: usize = 1 << 14;
/// Pixels turned into bytes before they are handed on, so that memory does not follow the band.
const PART_PIXELS: usize = 1 << 20;

/// Streams a PPM file.
pub(crate) struct PpmEncoder {
    sink: Box<dyn Sink>,
    rows: RowCount,
    samples: SampleBytes,
    /// The bytes of a part, kept.
    bytes: Vec<u8>,
    clock: WorkClock,
}

impl PpmEncoder {
    /// Writes the header.
    pub(crate) fn new(
        mut sink: Box<dyn Sink>,
        size: PictureSize,
        encoding: Encoding,
    ) -> Result<Self, EncodeError> {
        let rows = RowCount::new(size, "PPM")?;
        let max = match encoding.depth {
            BitDepth::Eight => 255,
            BitDepth::Sixteen => 65535,
        };
        write!(sink, "P6\n{} {}\n{max}\n", size.width, size.height)?;
        let samples = SampleBytes::new(encoding);
        Ok(Self { sink, rows, samples, bytes: Vec::new(), clock: WorkClock::default() })
    }

    fn write_part(&mut self, pixels: &[[f32; 3]]) -> Result<(), EncodeError> {
        let Self { sink, samples, bytes, clock, .. } = self;
        let pixel_bytes = samples.pixel_bytes(3);
        bytes.resize(pixels.len() * pixel_bytes, 0);
        pixels
            .par_chunks(TASK_PIXELS)
            .zip(bytes.par_chunks_mut(TASK_PIXELS * pixel_bytes))
            .for_each(|(pixels, bytes)| clock.time(|| samples.put(pixels, bytes)));
        Ok(clock.time(|| sink.write_all(bytes))?)
    }
}

impl BandWriter for PpmEncoder {
    fn write_pixels(&mut self, rows: PixelRows<'_>) -> Result<(), EncodeError> {
        let after = self.rows.after_pixels(&rows, Channels::Rgb)?;
        for part in rows.colors.chunks(PART_PIXELS) {
            self.write_part(part)?;
        }
        self.rows = after;
        Ok(())
    }

    fn seconds(&self) -> f64 {
        self.clock.seconds()
    }

    fn finish(self: Box<Self>) -> Result<(), EncodeError> {
        self.rows.check_complete()?;
        Ok(self.sink.commit()?)
    }
}

/// Makes integer samples, most significant byte first as PNG and PPM want them.
#[derive(Clone, Copy)]
pub(crate) struct SampleBytes {
    depth: BitDepth,
    transfer: Transfer,
}

impl SampleBytes {
    pub(crate) fn new(Encoding { depth, transfer, .. }: Encoding) -> Self {
        Self { depth, transfer }
    }

    /// Bytes of a pixel of so many channels.
    pub(crate) fn pixel_bytes(self, channels: usize) -> usize {
        match self.depth {
            BitDepth::Eight => channels,
            BitDepth::Sixteen => 2 * channels,
        }
    }

    /// The bytes of some pixels: of three channels, or of four, of which the last is alpha.
    pub(crate) fn put<const N: usize>(self, pixels: &[[f32; N]], bytes: &mut [u8]) {
        self.put_colors(pixels.as_flattened(), bytes);
        if N == 4 {
            self.put_alpha(pixels, bytes);
        }
    }

    fn put_colors(self, linear: &[f32], bytes: &mut [u8]) {
        match self.depth {
            BitDepth::Eight => self.transfer.quantize_8(linear, bytes),
            BitDepth::Sixteen => {
                let mut codes = [0; 512];
                for (linear, bytes) in linear.chunks(codes.len()).zip(bytes.chunks_mut(2 * codes.len())) {
                    let codes = &mut codes[..linear.len()];
                    self.transfer.quantize_16(linear, codes);
                    for (pair, code) in bytes.chunks_exact_mut(2).zip(&*codes) {
                        pair.copy_from_slice(&code.to_be_bytes());
                    }
                }
            }
        }
    }

    /// Alpha once more: it is linear whatever the colours are.
    fn put_alpha<const N: usize>(self, pixels: &[[f32; N]], bytes: &mut [u8]) {
        for (pixel, bytes) in pixels.iter().zip(bytes.chunks_exact_mut(self.pixel_bytes(N))) {
            let alpha = pixel[N - 1];
            match self.depth {
                BitDepth::Eight => Transfer::Linear.quantize_8(&[alpha], &mut bytes[N - 1..]),
                BitDepth::Sixteen => {
                    let mut code = [0];
                    Transfer::Linear.quantize_16(&[alpha], &mut code);
                    bytes[2 * (N - 1)..].copy_from_slice(&code[0].to_be_bytes());
                }
            }
        }
    }
}
