//! Pairs of points by a list of square boxes.

use super::BondPlaneError;
use std::collections::HashMap;

/// Pairs of points at most `reach` apart, the lower number first, ordered by it.
///
/// # Errors
/// [`BondPlaneError::Coincident`].
pub(super) fn within(positions: &[[f64; 2]], reach: f64) -> Result<Vec<[u32; 2]>, BondPlaneError> {
    let place = |at: [f64; 2]| at.map(|x| (x / reach).floor() as i64);
    let mut boxes: HashMap<[i64; 2], Vec<u32>> = HashMap::new();
    for (p, &at) in positions.iter().enumerate() {
        boxes.entry(place(at)).or_default().push(p as u32);
    }
    let mut pairs = Vec::new();
    for (i, &at) in positions.iter().enumerate() {
        let ([column, row], begin) = (place(at), pairs.len());
        for b in -1..=1 {
            for a in -1..=1 {
                let Some(others) = boxes.get(&[column + a, row + b]) else { continue };
                for &j in others.iter().filter(|&&j| j as usize > i) {
                    let other = positions[j as usize];
                    let squared = (other[0] - at[0]).powi(2) + (other[1] - at[1]).powi(2);
                    if squared == 0.0 {
                        return Err(BondPlaneError::Coincident { first: i, second: j as usize });
                    }
                    if squared <= reach * reach {
                        pairs.push([i as u32, j]);
                    }
                }
            }
        }
        pairs[begin..].sort_unstable();
    }
    Ok(pairs)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_find_what_all_pairs_find() {
        let at = |k: usize| [((k * 37) % 101) as f64 * 0.07 - 3.0, ((k * 61) % 97) as f64 * 0.05 - 1.0];
        let positions: Vec<[f64; 2]> = (0..200).map(at).collect();
        let reach = 0.9;
        let close = |i: usize, j: usize| {
            (positions[i][0] - positions[j][0]).hypot(positions[i][1] - positions[j][1]) <= reach
        };
        let all = (0..200).flat_map(|i| (i + 1..200).map(move |j| [i, j]));
        let expected: Vec<[u32; 2]> =
            all.filter(|&[i, j]| close(i, j)).map(|[i, j]| [i as u32, j as u32]).collect();
        assert_eq!(within(&positions, reach).unwrap(), expected);
    }

    #[test]
    fn coincident_points_are_named() {
        let positions = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [1.0, 0.0]];
        let error = within(&positions, 1.5).unwrap_err();
        assert_eq!(error, BondPlaneError::Coincident { first: 1, second: 3 });
    }
}
