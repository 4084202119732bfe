//! Bytes inside an XML file: base64 of zlib blocks, as `vtkZLibDataCompressor` expects them.
//!
//! A header of 64-bit numbers comes first: count of blocks, size of a block, size of the last block if it
//! is a partial one (else 0), compressed size of each. See "VTK XML file formats" in the documentation of
//! VTK.

use base64::Engine;
use base64::engine::general_purpose::STANDARD as BASE64;
use base64::write::EncoderWriter;
use miniz_oxide::deflate::compress_to_vec_zlib;
use rayon::prelude::*;
use std::io::{self, Write};
use std::ops::Range;

/// Bytes of a block before compression.
const BLOCK: usize = 1 << 20;
/// Fields of a plate of a million points shrink to 36 % here, by 1 % more at level 3, which takes five times as long.
const LEVEL: u8 = 1;

/// Numbers that become bytes block by block, so that they never lie in memory as a whole.
pub(super) struct Items<'a> {
    /// How many there are.
    pub(super) count: usize,
    /// Bytes of one, a divisor of the size of a block.
    pub(super) size: usize,
    /// Bytes of some that follow each other.
    pub(super) bytes: &'a (dyn Fn(Range<usize>) -> Vec<u8> + Sync),
}

/// Writes numbers.
///
/// # Errors
/// What `out` reports.
pub(super) fn encode(out: &mut dyn Write, items: &Items<'_>) -> io::Result<()> {
    let (count, in_block) = (items.count, BLOCK / items.size);
    let starts: Vec<usize> = (0..count).step_by(in_block).collect();
    let block =
        |&start: &usize| compress_to_vec_zlib(&(items.bytes)(start..count.min(start + in_block)), LEVEL);
    let blocks: Vec<Vec<u8>> = starts.par_iter().map(block).collect();
    let counts = [blocks.len(), BLOCK, count * items.size % BLOCK];
    let sizes = counts.into_iter().chain(blocks.iter().map(Vec::len));
    let header: Vec<_> = sizes.flat_map(|size| (size as u64).to_le_bytes()).collect();
    // The header is encoded by itself: a reader needs it to know how much follows.
    out.write_all(BASE64.encode(header).as_bytes())?;
    let mut encoder = EncoderWriter::new(out, &BASE64);
    blocks.iter().try_for_each(|block| encoder.write_all(block))?;
    encoder.finish().map(drop)
}

/// Reads what [`encode`] wrote, as a reader of VTK does: first the header, then block by block.
#[cfg(test)]
pub(super) fn decode(text: &str) -> Vec<u8> {
    // Three numbers are 24 bytes, exactly 32 characters.
    let blocks = numbers(&text[..32])[0];
    let (header, data) = text.split_at((8 * (3 + blocks)).div_ceil(3) * 4);
    let header = numbers(header);
    let data = BASE64.decode(data).unwrap();
    let mut rest = data.as_slice();
    let mut out = Vec::new();
    for &size in &header[3..] {
        let block = rest.split_off(..size).unwrap();
        out.extend(miniz_oxide::inflate::decompress_to_vec_zlib(block).unwrap());
    }
    assert!(rest.is_empty());
    let whole = blocks - usize::from(header[2] > 0);
    assert_eq!(out.len(), whole * header[1] + header[2]);
    out
}

#[cfg(test)]
fn numbers(text: &str) -> Vec<usize> {
    let bytes = BASE64.decode(text).unwrap();
    let numbers = bytes.chunks(8).map(|number| u64::from_le_bytes(number.try_into().unwrap()));
    numbers.map(|number| number as usize).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn encoded(bytes: &[u8]) -> String {
        let mut out = Vec::new();
        let items = Items { count: bytes.len(), size: 1, bytes: &|range| bytes[range].to_vec() };
        encode(&mut out, &items).unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn whole_and_partial_blocks_and_none_are_read_back() {
        for count in [0, 1, BLOCK - 1, BLOCK, BLOCK + 1, 3 * BLOCK - 7] {
            let bytes: Vec<_> = (0..count).map(|i| (i * i / 7) as u8).collect();
            assert!(decode(&encoded(&bytes)) == bytes, "{count}");
        }
    }

    #[test]
    fn nothing_is_a_header_that_says_so() {
        assert_eq!(numbers(&encoded(&[])), [0, BLOCK, 0]);
    }
}
