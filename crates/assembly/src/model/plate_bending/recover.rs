//! Curvatures, moments and shear forces of a state.
//!
//! Moments come from differences of the rotations, one-sided ones of second order at edges. `S (∇w − φ)` would be the small
//! difference of large numbers in a thin plate, and hundreds of times too large; shear forces come from the bonds, each of which
//! knows `V·n = s γ_b/(2ω)`. What curvatures have that need no moments is taken off the curvature and off γ_b. At an edge half of the bonds are missing: there shear forces are continued from inside. On a line of
//! symmetry the other half is the image of this one: rotations across it, and shear forces across it, have the other sign.
//!
//! Beside a step of the thickness differences are one-sided, as the curvature is not continuous there, and a point on the step has the
//! mean of its cells: of moments that bend across the step, which are the same on both sides, and of those along it, which are not.

use super::free::FreeCurvature;
use super::nodes::part_along;
use super::part::Part;
use super::weights::Weighted;
use super::{PHI_X, PHI_Y, PlateBending};

/// Fields of a state per point.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PlateFields {
    /// Curvatures `[κ_xx, κ_yy, κ_xy]`, 1/m, the last one of the tensor.
    pub curvature: Vec<[f64; 3]>,
    /// Moments `[M_xx, M_yy, M_xy]` per width, N.
    pub moment: Vec<[f64; 3]>,
    /// Shear forces `[V_x, V_y]` per width, N/m.
    pub shear: Vec<[f64; 2]>,
}

/// On which lines of symmetry a point lies, by the axis across them.
type OnMirror<'a> = &'a dyn Fn(usize) -> [bool; 2];

impl PlateBending {
    /// The fields of unknowns under multiples of curvatures that need no moments; `on_mirror` says of a point whether it is on lines of symmetry across
    /// x and y, behind which the plate goes on.
    pub fn fields(&self, u: &[f64], free: &[(f64, &FreeCurvature)], on_mirror: OnMirror) -> PlateFields {
        let n = self.nodes().points();
        let (mut curvature, mut moment) = (vec![[0.0; 3]; n], vec![[0.0; 3]; n]);
        for point in 0..n {
            let about = self.sections().about(self.nodes(), point);
            let area: f64 = about.iter().map(|part| part.1).sum();
            for (number, part) in about {
                let own = self.curvature(u, point, number, on_mirror(point));
                let own_moment = self.parts()[number].parameters.section.moments(own);
                for k in 0..3 {
                    curvature[point][k] += part / area * own[k];
                    moment[point][k] += part / area * own_moment[k];
                }
            }
            for (factor, free) in free {
                let mut without = self.moments_of(free, point);
                if on_mirror(point).contains(&true) {
                    // Behind a mirror the twist has the other sign.
                    without[2] = 0.0;
                }
                moment[point].iter_mut().zip(without).for_each(|(own, without)| *own -= factor * without);
            }
        }
        PlateFields { curvature, moment, shear: self.shear_forces(u, free, on_mirror) }
    }

    /// Curvature at a point of the part with a section.
    fn curvature(&self, u: &[f64], point: usize, number: usize, on_mirror: [bool; 2]) -> [f64; 3] {
        let n = self.nodes().points();
        let slope = |c: usize, axis: usize| {
            let sign = if c == PHI_X + axis { -1.0 } else { 1.0 };
            let image = on_mirror[axis].then_some(sign);
            self.slope(&u[c * n..(c + 1) * n], point, (axis, image), number)
        };
        let twist = slope(PHI_X, 1).zip(slope(PHI_Y, 0)).map_or(0.0, |(a, b)| 0.5 * (a + b));
        [slope(PHI_X, 0).unwrap_or(0.0), slope(PHI_Y, 1).unwrap_or(0.0), twist]
    }

    /// Numbers of the points up to `count` steps along an axis, as far as the part with a section goes and no bond between them has broken.
    fn ahead(&self, point: usize, axis: usize, (sign, number): (i32, usize), count: usize) -> Vec<usize> {
        let nodes = self.nodes();
        let inside = |cell: [i32; 2]| self.sections().has(nodes, number, cell);
        let mut node = nodes.node(point);
        let mut found = Vec::with_capacity(count);
        while found.len() < count {
            let mut next = node;
            next[axis] += sign;
            let lower = if sign > 0 { node } else { next };
            let is_joined = part_along(&inside, lower, axis) > 0.0 && !self.is_cut(number, lower, axis);
            match nodes.number(next).filter(|_| is_joined) {
                Some(number) => found.push(number),
                None => break,
            }
            node = next;
        }
        found
    }

    /// Derivative of values along an axis at a point of the part with a section; on a mirror across the axis with the sign of values
    /// behind it. None where no bond along the axis is left.
    fn slope(
        &self,
        values: &[f64],
        point: usize,
        (axis, image): (usize, Option<f64>),
        number: usize,
    ) -> Option<f64> {
        let h = self.nodes().spacing();
        let own = values[point];
        let of = |points: &[usize]| points.iter().map(|&p| values[p] - own).collect::<Vec<_>>();
        let [back, ahead] = [-1, 1].map(|sign| of(&self.ahead(point, axis, (sign, number), 2)));
        // Differences to the own value: a uniform rotation has no curvature.
        if let (Some(sign), Some((near, from))) = (image, beside(&back, &ahead)) {
            return Some(from * (near - (sign * (near + own) - own)) / (2.0 * h));
        }
        Some(match (&back[..], &ahead[..]) {
            ([b, ..], [a, ..]) => (a - b) / (2.0 * h),
            ([], [a, b]) => (4.0 * a - b) / (2.0 * h),
            ([a, b], []) => -(4.0 * a - b) / (2.0 * h),
            ([], [a, ..]) => a / h,
            ([a, ..], []) => -a / h,
            ([], []) => return None,
        })
    }

    /// Shear forces of all points.
    fn shear_forces(&self, u: &[f64], free: &[(f64, &FreeCurvature)], on_mirror: OnMirror) -> Vec<[f64; 2]> {
        let by_bonds = self.shear_of_bonds(u, free, on_mirror);
        let h = self.nodes().spacing();
        // All four cells about it belong to the body, or are images of some.
        let is_inner = |point: usize| {
            let images: f64 = on_mirror(point).iter().map(|is_on| if *is_on { 2.0 } else { 1.0 }).product();
            let is_whole = self.cut.get(point).is_none_or(|cut| *cut == 0.0);
            is_whole && images * self.nodes().area(point) > 0.99 * h * h
        };
        let of_point = |point: usize| match is_inner(point) {
            true => by_bonds[point],
            false => self.continued(&by_bonds, point, &is_inner).unwrap_or(by_bonds[point]),
        };
        (0..by_bonds.len()).map(of_point).collect()
    }

    /// Values at inner points next to a point, continued to it: linearly where two follow each other, the mean of all ways.
    fn continued(
        &self,
        values: &[[f64; 2]],
        point: usize,
        is_inner: &dyn Fn(usize) -> bool,
    ) -> Option<[f64; 2]> {
        let nodes = self.nodes();
        let [i, j] = nodes.node(point);
        let (mut sum, mut ways) = ([0.0; 2], 0.0);
        let around = [[1, 0], [-1, 0], [0, 1], [0, -1], [1, 1], [-1, 1], [1, -1], [-1, -1]];
        for [a, b] in around {
            // Diagonal ways are for corners, which have no others.
            if a * b != 0 && ways > 0.0 {
                break;
            }
            let at = |k: i32| nodes.number([i + k * a, j + k * b]).filter(|&p| is_inner(p));
            if let Some(near) = at(1) {
                let far = at(2).unwrap_or(near);
                (0..2).for_each(|c| sum[c] += 2.0 * values[near][c] - values[far][c]);
                ways += 1.0;
            }
        }
        (ways > 0.0).then(|| sum.map(|v| v / ways))
    }

    /// Shear forces by the bonds of every point: least squares of `V·n = s γ_b/(2ω)`, weighed by ω and the part in the body.
    fn shear_of_bonds(
        &self,
        u: &[f64],
        free: &[(f64, &FreeCurvature)],
        on_mirror: OnMirror,
    ) -> Vec<[f64; 2]> {
        let n = self.nodes().points();
        let (mut matrices, mut right) = (vec![[0.0; 3]; n], vec![[0.0; 2]; n]);
        for (number, part) in self.parts().iter().enumerate() {
            let ways = self.ways(part);
            part.bonds.for_each_bond(|offset, [i, j], [factor, ..]| {
                let Way { direction: [x, y], length, unit } = ways[offset];
                let weight = factor * part.offsets[offset].shear;
                let turn = |plane: usize| 0.5 * (u[plane * n + i] + u[plane * n + j]);
                let strain = (u[j] - u[i]) / length - x * turn(PHI_X) - y * turn(PHI_Y);
                for point in [i, j] {
                    let products = [x * x, x * y, y * y];
                    matrices[point].iter_mut().zip(products).for_each(|(sum, part)| *sum += weight * part);
                    add(&mut right[point], weight * 0.5 * unit * strain, [x, y]);
                }
            });
            for (multiple, free) in free {
                self.each_free((part, number), free, |bond| {
                    let weight = multiple * bond.factors[0] * part.offsets[bond.offset].shear;
                    let without = weight * 0.5 * ways[bond.offset].unit * bond.measures[1];
                    bond.ends.iter().for_each(|&point| add(&mut right[point], -without, bond.direction));
                });
            }
        }
        // Bonds and their images together have no product of both axes, and no shear force across a mirror.
        let with_images = |(point, ([xx, xy, yy], [x, y])): (usize, ([f64; 3], [f64; 2]))| {
            let is_on = on_mirror(point);
            let xy = if is_on.contains(&true) { 0.0 } else { xy };
            solved([xx, xy, yy], [if is_on[0] { 0.0 } else { x }, if is_on[1] { 0.0 } else { y }])
        };
        matrices.into_iter().zip(right).enumerate().map(with_images).collect()
    }

    /// What the bonds of every offset of a part know of shear.
    pub(super) fn ways(&self, part: &Part) -> Vec<Way> {
        let way = |offset: &Weighted| {
            let [x, y, _] = self.nodes().lattice().vector(offset.step);
            let length = x.hypot(y);
            let unit = part.parameters.shear(1.0, length);
            Way { direction: [x / length, y / length], length, unit }
        };
        part.offsets.iter().map(way).collect()
    }
}

/// A direction of bonds, their length, and their shear stiffness at the weight one.
#[derive(Clone, Copy)]
pub(super) struct Way {
    direction: [f64; 2],
    length: f64,
    pub(super) unit: f64,
}

/// Adds a value along a direction.
fn add(sum: &mut [f64; 2], value: f64, direction: [f64; 2]) {
    sum.iter_mut().zip(direction).for_each(|(sum, part)| *sum += value * part);
}

/// The value of a point on an end of the plate that is next to it, and the sign of its side; none of an inner point.
fn beside(back: &[f64], ahead: &[f64]) -> Option<(f64, f64)> {
    match (back, ahead) {
        ([], [near, ..]) => Some((*near, 1.0)),
        ([near, ..], []) => Some((*near, -1.0)),
        _ => None,
    }
}

/// Solution of a symmetric 2 × 2 system `[xx, xy, yy]`; zero where it has none.
fn solved([xx, xy, yy]: [f64; 3], [x, y]: [f64; 2]) -> [f64; 2] {
    let determinant = xx * yy - xy * xy;
    match determinant > 1e-9 * (xx + yy).powi(2) {
        true => [(yy * x - xy * y) / determinant, (xx * y - xy * x) / determinant],
        false => [0.0; 2],
    }
}
