//! Isolines and arrows of maps, from the means over blocks.

use super::apart::Side;
use super::raster::Raster;
use crate::output::plot::{Isoline, levels};
use std::collections::HashSet;

/// Arrows along the longer side of a body, about.
const ALONG: usize = 24;

/// An arrow from a place to another one.
pub(super) type Arrow = [[f64; 2]; 2];

/// Lines on which a field has round values, about `count` of them between both ends of `range`: linear on triangles between the
/// `middles` of blocks, none of which crosses a side that is apart.
pub(super) fn isolines(
    raster: &Raster,
    (values, middles): (&[f64], &[[f64; 2]]),
    apart: &[Side],
    (range, count): ([f64; 2], usize),
) -> Vec<Isoline> {
    let triangles = triangles(raster, apart);
    let on = |value: f64| Isoline {
        value,
        segments: triangles.iter().filter_map(|corners| segment(*corners, values, middles, value)).collect(),
    };
    levels(range, count).into_iter().map(on).filter(|line| !line.segments.is_empty()).collect()
}

/// Triangles between the middles of blocks that hang together.
fn triangles(raster: &Raster, apart: &[Side]) -> Vec<[usize; 3]> {
    let apart: HashSet<Side> = apart.iter().copied().collect();
    let quad = |block: usize| {
        let at = |step: [i32; 2]| raster.beside(block, step);
        let (right, above, across) = (at([1, 0])?, at([0, 1])?, at([1, 1])?);
        let torn = [[block, 0], [block, 1], [right, 1], [above, 0]].iter().any(|side| apart.contains(side));
        (!torn).then_some([[block, right, across], [block, across, above]])
    };
    (0..raster.blocks.len()).filter_map(quad).flatten().collect()
}

/// Where a linear function on a triangle has a value.
fn segment(corners: [usize; 3], values: &[f64], places: &[[f64; 2]], level: f64) -> Option<[[f64; 2]; 2]> {
    let mut ends = (0..3).filter_map(|k| {
        let (a, b) = (corners[k], corners[(k + 1) % 3]);
        // A corner at the level counts as above it, so that every crossed triangle has two ends.
        let crossed = (values[a] < level) != (values[b] < level) && (values[a] - values[b]).is_finite();
        let part = (level - values[a]) / (values[b] - values[a]);
        crossed.then(|| [0, 1].map(|c| places[a][c] + part * (places[b][c] - places[a][c])))
    });
    Some([ends.next()?, ends.next()?])
}

/// Blocks that have an arrow, and the length of the side of the square around one.
fn chosen(raster: &Raster) -> (Vec<usize>, f64) {
    let count = raster.blocks.len();
    let Some(grid) = &raster.grid else {
        let step = count.div_ceil(ALONG * ALONG).max(1);
        let side = |block: usize| raster.blocks[block][2][0] - raster.blocks[block][0][0];
        return ((0..count).step_by(step).collect(), (step as f64).sqrt() * side(0));
    };
    let step = (grid.columns.max(grid.rows) as usize).div_ceil(ALONG) as i32;
    let own = (0..count).filter(|&block| grid.cells[block].iter().all(|at| at % step == step / 2)).collect();
    let [a, b] = [0, 1].map(|corner| raster.blocks[0][corner]);
    (own, f64::from(step) * (b[0] - a[0]).hypot(b[1] - a[1]))
}

/// Where blocks go, `factor` times.
pub(super) fn displacements(raster: &Raster, mean: &[Vec<f64>; 2], factor: f64) -> Vec<Arrow> {
    let arrow = |block: usize| {
        let at = raster.middle(block);
        [at, [0, 1].map(|c| at[c] + factor * mean[c][block])]
    };
    chosen(raster).0.into_iter().map(arrow).collect()
}

/// Principal stresses of blocks from the components xx, yy and xy, the largest as long as blocks with arrows are apart.
pub(super) fn principal_stresses(raster: &Raster, [xx, yy, xy]: &[Vec<f64>; 3]) -> Vec<Arrow> {
    let (blocks, room) = chosen(raster);
    let principal = |block: &usize| {
        let (mean, half) = (f64::midpoint(xx[*block], yy[*block]), 0.5 * (xx[*block] - yy[*block]));
        let (radius, angle) = (half.hypot(xy[*block]), 0.5 * xy[*block].atan2(half));
        [(mean + radius, [angle.cos(), angle.sin()]), (mean - radius, [-angle.sin(), angle.cos()])]
    };
    let all: Vec<_> = blocks.iter().map(|block| (raster.middle(*block), principal(block))).collect();
    let largest =
        all.iter().flat_map(|(_, two)| two).fold(0.0_f64, |most, (stress, _)| most.max(stress.abs()));
    let arrows = all.into_iter().flat_map(|(at, two)| {
        two.into_iter().flat_map(move |(stress, along)| {
            let length = 0.47 * room * stress.abs() / largest;
            [1.0, -1.0].map(|sign| {
                let end = [0, 1].map(|c| at[c] + sign * length * along[c]);
                if stress > 0.0 { [at, end] } else { [end, at] }
            })
        })
    });
    arrows.filter(|arrow| arrow.iter().flatten().all(|v| v.is_finite())).collect()
}

#[cfg(test)]
mod tests {
    use super::super::raster::tests::raster;
    use super::*;

    #[test]
    fn isolines_of_a_linear_field_are_straight_and_where_it_has_their_values() {
        let raster = raster();
        let middles: Vec<[f64; 2]> = (0..6).map(|block| raster.middle(block)).collect();
        let values: Vec<f64> = middles.iter().map(|at| 2.0 * at[0] + at[1]).collect();
        let lines = isolines(&raster, (&values, &middles), &[], ([1.5, 6.5], 5));
        assert_eq!(lines.iter().map(|line| line.value).collect::<Vec<_>>(), [2.0, 3.0, 4.0, 5.0, 6.0]);
        for line in &lines {
            for [x, y] in line.segments.iter().flatten() {
                assert!((2.0 * x + y - line.value).abs() < 1e-14, "{line:?}");
            }
        }
        // None crosses a side that is apart.
        let torn = isolines(&raster, (&values, &middles), &[[0, 1]], ([1.5, 6.5], 5));
        assert!(torn.iter().flat_map(|line| &line.segments).flatten().all(|[x, _]| *x >= 1.5));
    }

    #[test]
    fn pure_shear_is_tension_and_compression_under_45_degrees() {
        let raster = raster();
        let [zero, one] = [0.0, 1.0].map(|v| vec![v; 6]);
        let arrows = principal_stresses(&raster, &[zero.clone(), zero, one]);
        assert_eq!(arrows.len(), 4 * 6);
        let at = raster.middle(0);
        // 0.47 of a side of one under 45°: outwards along (1, 1), inwards along (−1, 1).
        let half = 0.47 / 2.0_f64.sqrt();
        let close = |a: [f64; 2], b: [f64; 2]| (0..2).all(|k| (a[k] - b[k]).abs() < 1e-12);
        assert!(close(arrows[0][0], at) && close(arrows[0][1], [at[0] + half, at[1] + half]), "{arrows:?}");
        assert!(close(arrows[2][1], at) && close(arrows[2][0], [at[0] - half, at[1] + half]), "{arrows:?}");
    }
}
