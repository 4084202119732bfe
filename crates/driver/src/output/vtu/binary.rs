//! Bytes inside an XML file: base64 of zlib blocks, as `vtkZLibDataCompressor` expects them.
//!
//! A header of 64-bit numbers comes first: count of blocks, size of a block, size of the last block if it
//! is a partial one (else 0), compressed size of each. See "VTK XML file formats" in the documentation of
//! VTK.

use base64::Engine;
use base64::engine::general_purpose::STANDARD as BASE64;
use miniz_oxide::deflate::compress_to_vec_zlib;
use rayon::prelude::*;

/// Bytes of a block before compression.
const BLOCK: usize = 1 << 20;
/// Fields hardly shrink further at higher levels, only slower.
const LEVEL: u8 = 3;

pub(super) fn encode(bytes: &[u8]) -> String {
    let blocks: Vec<_> = bytes.par_chunks(BLOCK).map(|block| compress_to_vec_zlib(block, LEVEL)).collect();
    let counts = [blocks.len(), BLOCK, bytes.len() % BLOCK];
    let sizes = counts.into_iter().chain(blocks.iter().map(Vec::len));
    let header: Vec<_> = sizes.flat_map(|size| (size as u64).to_le_bytes()).collect();
    // The header is encoded by itself: a reader needs it to know how much follows.
    BASE64.encode(header) + &BASE64.encode(blocks.concat())
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

    #[test]
    fn whole_and_partial_blocks_and_none_are_read_back() {
        for count in [0, 1, BLOCK - 1, BLOCK, BLOCK + 1, 3 * BLOCK - 7] {
            let bytes: Vec<_> = (0..count).map(|i| (i * i / 7) as u8).collect();
            assert!(decode(&encode(&bytes)) == bytes, "{count}");
        }
    }

    #[test]
    fn nothing_is_a_header_that_says_so() {
        assert_eq!(numbers(&encode(&[])), [0, BLOCK, 0]);
    }
}
