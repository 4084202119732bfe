//! Fields of many cells in few bytes: rounded to steps of their range, as differences from what their neighbours foretell,
//! deflated, in base64. `unpack` in `map.js` undoes it.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::{Deserialize, Serialize};

/// How hard to deflate: the next levels take far longer for a few percent.
const LEVEL: u8 = 4;

/// Values that take few bytes.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Packed {
    /// The smallest value, and the step between two of them.
    low: f64,
    step: f64,
    pub(super) data: String,
}

/// Cells that stand before others of their field, by which these are foretold: to the left, below, and left below.
pub(super) struct Order {
    before: Vec<[Option<u32>; 3]>,
}

impl Order {
    /// Of cells in rows: row, first column, and number of cells of every stretch, row by row from the lowest.
    pub(super) fn of_runs(columns: usize, runs: &[[usize; 3]]) -> Self {
        let mut before = Vec::new();
        let (mut below, mut own) = (vec![None; columns], vec![None; columns]);
        let mut current = None;
        for &[row, first, count] in runs {
            if current != Some(row) {
                below = std::mem::replace(&mut own, vec![None; columns]);
                // Rows that are left out have nothing to foretell the next one by.
                if current.is_none_or(|current| current + 1 != row) {
                    below.fill(None);
                }
                current = Some(row);
            }
            for column in first..first + count {
                let of = |row: &[Option<u32>], column: Option<usize>| column.and_then(|k| row[k]);
                let left = column.checked_sub(1);
                before.push([of(&own, left), below[column], of(&below, left)]);
                own[column] = Some(before.len() as u32 - 1);
            }
        }
        Self { before }
    }

    /// Of cells in a list.
    pub(super) fn of_list(count: usize) -> Self {
        let before = |k: usize| [k.checked_sub(1).map(|k| k as u32), None, None];
        Self { before: (0..count).map(before).collect() }
    }

    /// What a cell is likely to be: on the plane through its neighbours, else as one of them.
    pub(super) fn foretold(&self, steps: &[u16], cell: usize) -> u16 {
        let at = |k: Option<u32>| k.map(|k| steps[k as usize]);
        match self.before[cell].map(at) {
            [Some(left), Some(below), Some(corner)] => left.wrapping_add(below).wrapping_sub(corner),
            [Some(value), _, _] | [None, Some(value), _] => value,
            _ => 0,
        }
    }
}

/// Values, one per cell, in steps of their range over `2^bits − 1`.
pub(super) fn pack(values: &[f64], order: &Order, bits: u32) -> Packed {
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let most = f64::from((1_u32 << bits) - 1);
    // In two steps, since the range of numbers that fit may not fit.
    let step = high / most - low / most;
    let step = if step > 0.0 { step } else { 0.0 };
    let rounded = |value: &f64| if step > 0.0 { ((value - low) / step).round() as u16 } else { 0 };
    let steps: Vec<u16> = values.iter().map(rounded).collect();
    let mut bytes = vec![0; 2 * steps.len()];
    // Large and small parts apart: the large ones are nearly all zero.
    let (small, large) = bytes.split_at_mut(steps.len());
    for (cell, &value) in steps.iter().enumerate() {
        let difference = value.wrapping_sub(order.foretold(&steps, cell)) as i16;
        let folded = ((difference << 1) ^ (difference >> 15)) as u16;
        [small[cell], large[cell]] = folded.to_le_bytes();
    }
    let deflated = miniz_oxide::deflate::compress_to_vec_zlib(&bytes, LEVEL);
    Packed { low, step, data: STANDARD.encode(deflated) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What `map.js` does.
    fn unpack(packed: &Packed, order: &Order) -> Vec<f64> {
        let (low, step) = (packed.low, packed.step);
        let deflated = STANDARD.decode(&packed.data).unwrap();
        let bytes = miniz_oxide::inflate::decompress_to_vec_zlib(&deflated).unwrap();
        let (small, large) = bytes.split_at(bytes.len() / 2);
        let mut steps = Vec::new();
        for cell in 0..small.len() {
            let folded = u16::from_le_bytes([small[cell], large[cell]]);
            let difference = (folded >> 1) ^ (folded & 1).wrapping_neg();
            steps.push(difference.wrapping_add(order.foretold(&steps, cell)));
        }
        steps.into_iter().map(|value| low + step * f64::from(value)).collect()
    }

    #[test]
    fn values_come_back_to_half_a_step() {
        // Rows with a gap, one that is missing, and one that begins farther left.
        let runs = [[0, 3, 5], [1, 2, 3], [1, 6, 2], [3, 0, 8]];
        for order in [Order::of_runs(8, &runs), Order::of_list(18)] {
            for scale in [1.0, -1e-300, 1e300] {
                let values: Vec<f64> = (0..18).map(|k| scale * (f64::from(k) * 1.7).sin()).collect();
                let packed = pack(&values, &order, 16);
                let half = 0.51 * packed.step;
                for (found, expected) in unpack(&packed, &order).iter().zip(&values) {
                    assert!((found - expected).abs() <= half, "{found} {expected}");
                }
            }
            let constant = pack(&[2.5; 18], &order, 16);
            assert_eq!(unpack(&constant, &order), [2.5; 18]);
        }
    }

    #[test]
    fn a_smooth_field_takes_a_part_of_its_bytes() {
        let runs: Vec<[usize; 3]> = (0..300).map(|row| [row, 0, 300]).collect();
        let at = |k: usize| ((k % 300) as f64 / 40.0).sin() * ((k / 300) as f64 / 90.0).cos();
        let values: Vec<f64> = (0..90_000).map(at).collect();
        let packed = pack(&values, &Order::of_runs(300, &runs), 16);
        let length = packed.data.len();
        assert!(length < 60_000, "{length} bytes of 180 000");
    }
}
