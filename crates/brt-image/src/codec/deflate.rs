//! A zlib stream made of segments that are compressed independently of each other, on any thread.
//!
//! Each segment is some deflate blocks, none of them the last, and ends at a whole byte: segments can be joined as they
//! are. The checksum of the whole follows from those of the parts.

use flate2::{Compress, FlushCompress};

use super::error::EncodeError;

/// The start of a zlib stream: deflate, a window of 32 KiB, no dictionary.
pub(crate) const ZLIB_HEADER: [u8; 2] = [0x78, 0x01];
/// An empty last block.
const LAST_BLOCK: [u8; 2] = [0x03, 0x00];
/// An empty stored block after its three bits of header and the rest of their byte: its length, and the complement.
const EMPTY_BLOCK: [u8; 4] = [0x00, 0x00, 0xff, 0xff];

/// How bytes are compressed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Deflate {
    /// Runs and one fixed Huffman table, made for filtered rows.
    Runs,
    /// A level of zlib, 1 to 9.
    Level(u32),
}

impl Deflate {
    /// Appends `data` in compressed form to `out` and returns its checksum.
    ///
    /// # Errors
    /// If a library refuses.
    pub(crate) fn segment(self, data: &[u8], out: &mut Vec<u8>) -> Result<u32, EncodeError> {
        match self {
            Self::Runs => runs(data, out),
            Self::Level(level) => zlib(level, data, out),
        }
    }
}

/// The fdeflate crate makes a whole zlib stream of one last block. Without its header and its checksum, with the bit
/// "last" cleared, and an empty stored block behind, which leads to a whole byte, it is a segment.
fn runs(data: &[u8], out: &mut Vec<u8>) -> Result<u32, EncodeError> {
    let start = out.len();
    // Its writer is taken from and given back to the caller, for the buffer.
    let mut compressor = fdeflate::Compressor::new(std::mem::take(out)).map_err(|e| refused(&e))?;
    compressor.write_data(data).map_err(|e| refused(&e))?;
    *out = compressor.finish().map_err(|e| refused(&e))?;
    let end = out.len() - size_of::<u32>();
    let checksum = out[end..].iter().fold(0, |sum, &byte| sum << 8 | u32::from(byte));
    out.truncate(end);
    out.drain(start..start + ZLIB_HEADER.len());
    out[start] &= !1;
    // The library's code for the end of a block ends in a set bit, so the last set bit is where the block ends.
    let unused_bits = out.last().map_or(0, |last| last.leading_zeros());
    if unused_bits < 3 {
        out.push(0);
    }
    out.extend(EMPTY_BLOCK);
    Ok(checksum)
}

fn zlib(level: u32, data: &[u8], out: &mut Vec<u8>) -> Result<u32, EncodeError> {
    let mut compressor = Compress::new(flate2::Compression::new(level), false);
    loop {
        let taken = compressor.total_in() as usize;
        // Room is left only when all is written, the empty block of the flush included.
        out.reserve((data.len() - taken) / 4 + 64);
        compressor.compress_vec(&data[taken..], out, FlushCompress::Sync).map_err(|e| refused(&e))?;
        if compressor.total_in() as usize == data.len() && out.len() < out.capacity() {
            return Ok(simd_adler32::adler32(&data));
        }
    }
}

fn refused(error: &dyn std::fmt::Display) -> EncodeError {
    EncodeError::Library { format: "deflate", message: error.to_string() }
}

/// The checksum of a stream that grows by segments: Adler-32.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Checksum(u32);

impl Checksum {
    /// Of nothing.
    pub(crate) const EMPTY: Self = Self(1);
    const MODULUS: u64 = 65521;

    /// Of what was there before and `length` bytes with the checksum `next` behind.
    ///
    /// Adler-32 is the sum `a` of 1 and all bytes, and the sum `b` of all values that `a` takes on the way.
    pub(crate) fn followed_by(self, next: u32, length: usize) -> Self {
        let split = |sum: u32| (u64::from(sum & 0xffff), u64::from(sum >> 16));
        let ((a, b), (next_a, next_b)) = (split(self.0), split(next));
        let before = a + Self::MODULUS - 1;
        let length = length as u64 % Self::MODULUS;
        let a = (before + next_a) % Self::MODULUS;
        let b = (b + next_b + before % Self::MODULUS * length) % Self::MODULUS;
        Self((b << 16 | a) as u32)
    }

    /// The end of a zlib stream whose data have this checksum.
    pub(crate) fn stream_end(self) -> [u8; 6] {
        let [b3, b2, b1, b0] = self.0.to_be_bytes();
        let [last0, last1] = LAST_BLOCK;
        [last0, last1, b3, b2, b1, b0]
    }
}

#[cfg(test)]
mod tests {
    use std::io::Read;

    use super::*;

    fn noise(length: usize, seed: u32) -> Vec<u8> {
        let mut state = seed.wrapping_mul(0x9e37_79b9) | 1;
        let next = |_| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            // Runs of zeros, small values and any values.
            match state >> 29 {
                0..4 => 0,
                4..7 => (state >> 24) as u8 & 3,
                _ => (state >> 16) as u8,
            }
        };
        (0..length).map(next).collect()
    }

    #[test]
    fn joined_segments_are_one_valid_stream() {
        for deflate in [Deflate::Runs, Deflate::Level(1), Deflate::Level(2), Deflate::Level(9)] {
            // Many lengths, so that blocks end at every bit of a byte.
            let parts: Vec<Vec<u8>> = (0..200).map(|i| noise(i * i % 701, i as u32)).collect();
            let mut stream = ZLIB_HEADER.to_vec();
            let mut checksum = Checksum::EMPTY;
            for part in &parts {
                let next = deflate.segment(part, &mut stream).unwrap();
                checksum = checksum.followed_by(next, part.len());
            }
            stream.extend(checksum.stream_end());
            let mut back = Vec::new();
            flate2::read::ZlibDecoder::new(&stream[..]).read_to_end(&mut back).unwrap();
            assert!(back == parts.concat(), "{deflate:?}");
            assert_eq!(fdeflate::decompress_to_vec(&stream).unwrap(), back);
        }
    }

    #[test]
    fn incompressible_segments_have_room() {
        let mut state = 1_u64;
        let data: Vec<u8> = (0..300_000)
            .map(|_| {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                (state >> 56) as u8
            })
            .collect();
        for deflate in [Deflate::Runs, Deflate::Level(1), Deflate::Level(6)] {
            let mut stream = ZLIB_HEADER.to_vec();
            let checksum = deflate.segment(&data, &mut stream).unwrap();
            stream.extend(Checksum::EMPTY.followed_by(checksum, data.len()).stream_end());
            assert!(fdeflate::decompress_to_vec(&stream).unwrap() == data, "{deflate:?}");
        }
    }

    #[test]
    fn checksums_of_parts_make_that_of_the_whole() {
        let all = noise(200_000, 3);
        for cut in [0, 1, 65_520, 65_521, 65_522, 131_043, 200_000] {
            let (front, back) = all.split_at(cut);
            let checksum = Checksum::EMPTY
                .followed_by(simd_adler32::adler32(&front), front.len())
                .followed_by(simd_adler32::adler32(&back), back.len());
            assert_eq!(checksum.0, simd_adler32::adler32(&&all[..]), "{cut}");
        }
    }
}
