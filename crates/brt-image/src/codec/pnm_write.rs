//! Writes PPM (P6), and makes the integer samples that PPM and PNG share.

use std::io::Write;

use rayon::prelude::*;

use super::error::EncodeError;
use super::format::{BandWriter, BitDepth};
use super::rows::RowCount;
use super::sink::Sink;
use crate::{PictureSize, Transfer};

/// Streams a PPM file.
pub(crate) struct PpmEncoder {
    sink: Box<dyn Sink>,
    rows: RowCount,
    samples: SampleBytes,
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
        Ok(Self { sink, rows, samples: SampleBytes::new(depth, transfer) })
    }
}

impl BandWriter for PpmEncoder {
    fn write(&mut self, rows: &[[f32; 3]]) -> Result<(), EncodeError> {
        let after = self.rows.after(rows.len())?;
        let Self { sink, samples, .. } = self;
        samples.for_each_part(rows, |bytes| Ok(sink.write_all(bytes)?))?;
        self.rows = after;
        Ok(())
    }

    fn finish(self: Box<Self>) -> Result<(), EncodeError> {
        self.rows.check_complete()?;
        Ok(self.sink.commit()?)
    }
}

/// Pixels turned into bytes by one task: enough to outweigh handing the task over.
const TASK_PIXELS: usize = 1 << 14;
/// Pixels turned into bytes before they are handed on, so that memory does not follow the band.
const PART_PIXELS: usize = 1 << 20;

/// Makes integer samples, most significant byte first as PNG and PPM want them.
pub(crate) struct SampleBytes {
    depth: BitDepth,
    transfer: Transfer,
    bytes: Vec<u8>,
}

impl SampleBytes {
    pub(crate) fn new(depth: BitDepth, transfer: Transfer) -> Self {
        Self { depth, transfer, bytes: Vec::new() }
    }

    /// Hands the bytes of `pixels` in order to `take`, in parts of bounded length.
    pub(crate) fn for_each_part(
        &mut self,
        pixels: &[[f32; 3]],
        mut take: impl FnMut(&[u8]) -> Result<(), EncodeError>,
    ) -> Result<(), EncodeError> {
        let pixel_bytes = match self.depth {
            BitDepth::Eight => 3,
            BitDepth::Sixteen => 6,
        };
        for part in pixels.chunks(PART_PIXELS) {
            let needed = part.len() * pixel_bytes;
            if self.bytes.len() < needed {
                self.bytes.resize(needed, 0);
            }
            let bytes = &mut self.bytes[..needed];
            let (depth, transfer) = (self.depth, self.transfer);
            part.par_chunks(TASK_PIXELS)
                .zip(bytes.par_chunks_mut(TASK_PIXELS * pixel_bytes))
                .for_each(|(pixels, bytes)| sample_bytes(pixels, depth, transfer, bytes));
            take(bytes)?;
        }
        Ok(())
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
