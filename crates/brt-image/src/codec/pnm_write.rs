//! Writes PPM (P6), and makes the integer samples that PPM and PNG share.

use std::io::Write;

use rayon::prelude::*;

use super::error::EncodeError;
use super::format::{BandWriter, BitDepth};
use super::rows::RowCount;
use super::sink::Sink;
use super::work_clock::WorkClock;
use crate::{PictureSize, Transfer};

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
        depth: BitDepth,
        transfer: Transfer,
    ) -> Result<Self, EncodeError> {
        let rows = RowCount::new(size, "PPM")?;
        let max = match depth {
            BitDepth::Eight => 255,
            BitDepth::Sixteen => 65535,
        };
        write!(sink, "P6\n{} {}\n{max}\n", size.width, size.height)?;
        let samples = SampleBytes::new(depth, transfer);
        Ok(Self { sink, rows, samples, bytes: Vec::new(), clock: WorkClock::default() })
    }

    fn write_part(&mut self, pixels: &[[f32; 3]]) -> Result<(), EncodeError> {
        let Self { sink, samples, bytes, clock, .. } = self;
        let pixel_bytes = samples.pixel_bytes();
        bytes.resize(pixels.len() * pixel_bytes, 0);
        pixels
            .par_chunks(TASK_PIXELS)
            .zip(bytes.par_chunks_mut(TASK_PIXELS * pixel_bytes))
            .for_each(|(pixels, bytes)| clock.time(|| samples.put(pixels, bytes)));
        Ok(clock.time(|| sink.write_all(bytes))?)
    }
}

impl BandWriter for PpmEncoder {
    fn write(&mut self, rows: &[[f32; 3]]) -> Result<(), EncodeError> {
        let after = self.rows.after(rows.len())?;
        for part in rows.chunks(PART_PIXELS) {
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
    pub(crate) fn new(depth: BitDepth, transfer: Transfer) -> Self {
        Self { depth, transfer }
    }

    /// Bytes of a pixel.
    pub(crate) fn pixel_bytes(self) -> usize {
        match self.depth {
            BitDepth::Eight => 3,
            BitDepth::Sixteen => 6,
        }
    }

    /// The bytes of some pixels.
    pub(crate) fn put(self, pixels: &[[f32; 3]], bytes: &mut [u8]) {
        sample_bytes(pixels, self.depth, self.transfer, bytes);
    }
}

/// The bytes of some pixels.
fn sample_bytes(pixels: &[[f32; 3]], depth: BitDepth, transfer: Transfer, bytes: &mut [u8]) {
    let linear = pixels.as_flattened();
    match depth {
        BitDepth::Eight => transfer.quantize_8(linear, bytes),
        BitDepth::Sixteen => {
            let mut codes = [0; 512];
            for (linear, bytes) in linear.chunks(codes.len()).zip(bytes.chunks_mut(2 * codes.len())) {
                let codes = &mut codes[..linear.len()];
                transfer.quantize_16(linear, codes);
                for (pair, code) in bytes.chunks_exact_mut(2).zip(&*codes) {
                    pair.copy_from_slice(&code.to_be_bytes());
                }
            }
        }
    }
}
