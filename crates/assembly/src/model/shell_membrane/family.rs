//! The weights of the bonds of every point: those of a full family, and those of the points that lack bonds.

use super::super::plane::{
    Calibration, Mirrors, Neighbourhood, at, half_offsets, is_up, is_within, near_points,
};
use super::weights::{Member, matched};
use super::{ShellBond, ShellError, ShellParameters};
use crate::body::{Cell, SquareLattice};
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// Bonds of one half offset, as all points see them.
#[derive(Clone, Copy, Debug)]
pub(super) struct ShellOffset {
    pub(super) step: Cell,
    /// `[dX, dS]`, m.
    pub(super) xi: [f64; 2],
    /// Coefficients of `u_j − u_i`, `v_j − v_i` and `w_i + w_j`.
    pub(super) row: [f64; 3],
    /// `L [n_x², n_s², n_x n_s]`, m.
    pub(super) product: [f64; 3],
    /// Weight of its bonds in a full family, 1/m².
    pub(super) weight: f64,
    /// The published one, 1/m², from which others start.
    pub(super) start: f64,
}

/// A lattice with its images.
type Body<'a> = (&'a SquareLattice, &'a Mirrors);

/// The weights of all points, 1/m².
#[derive(Clone, Debug)]
pub(super) struct ShellFamilies {
    pub(super) offsets: Vec<ShellOffset>,
    /// Of the real points that lack bonds: per offset, upwards and downwards, zero where there is no bond.
    pub(super) special: BTreeMap<u32, Vec<[f64; 2]>>,
    /// Points whose weights miss some uniform strains.
    pub(super) uncorrected: usize,
}

/// Offsets of the neighbours of a point, one of each opposite pair, with the weights of a full family.
///
/// # Errors
/// [`ShellError`].
pub(super) fn offsets(
    parameters: &ShellParameters,
    bond: &ShellBond,
    spacing: f64,
) -> Result<Vec<ShellOffset>, ShellError> {
    let m = parameters.horizon_ratio;
    let horizon = m * spacing;
    if horizon >= 0.5 * PI * parameters.radius {
        return Err(ShellError::Around { horizon, radius: parameters.radius });
    }
    let mut found: Vec<ShellOffset> = steps(m)
        .into_iter()
        .map(|step| {
            let xi = [0, 1].map(|k| spacing * f64::from(step[k]));
            let (length, [x, s]) = (bond.length(xi), bond.direction(xi));
            let product = [x * x, s * s, x * s].map(|n| length * n);
            let start = start(parameters, bond, spacing, xi);
            ShellOffset { step, xi, row: bond.coefficients(xi), product, weight: start, start }
        })
        .collect();
    let fits = |o: &ShellOffset| o.start.is_normal() && o.product.iter().chain(&o.row).all(|v| v.is_finite());
    if !found.iter().all(fits) {
        return Err(ShellError::OutOfRange { spacing, radius: parameters.radius });
    }
    if parameters.calibration == Calibration::Matched {
        let half: Vec<Member> = found.iter().map(|o| o.member(bond)).collect();
        let full: Vec<Member> = half.iter().flat_map(|m| [*m, *m]).collect();
        let (weights, exact) = matched(&full);
        if !exact || weights.iter().any(|w| *w <= 0.0) {
            let per_radius = spacing / parameters.radius;
            return Err(ShellError::NotRepresentable { horizon_ratio: m, per_radius });
        }
        found.iter_mut().zip(weights.chunks_exact(2)).for_each(|(o, w)| o.weight = w[0]);
    }
    Ok(found)
}

/// One of each pair of opposite offsets inside a horizon of m spacings.
pub(super) fn steps(m: f64) -> Vec<Cell> {
    half_offsets(m, 1).into_iter().filter(|&step| is_within(step, m)).collect()
}

/// `ω A/q` with the influence ω = 1/L, the area A of a point and `q = 2πδ³/3`: with it `c = 9E/(π h δ³)`, as published.
fn start(parameters: &ShellParameters, bond: &ShellBond, spacing: f64, xi: [f64; 2]) -> f64 {
    let horizon = parameters.horizon_ratio * spacing;
    let whole = 2.0 * PI * horizon.powi(3) / 3.0;
    spacing * spacing / (bond.length(xi) * whole)
}

impl ShellOffset {
    fn member(&self, bond: &ShellBond) -> Member {
        Member { weight: self.start, length: bond.length(self.xi), direction: bond.direction(self.xi) }
    }
}

impl ShellFamilies {
    /// The weights of a lattice whose points have the offsets `offsets`. Bonds that end on the border, if there are any, are
    /// not missing.
    pub(super) fn new(
        (lattice, mirrors): (&SquareLattice, &Mirrors),
        (calibration, has_border): (Calibration, bool),
        bond: &ShellBond,
        offsets: Vec<ShellOffset>,
    ) -> Self {
        let mut families = Self { offsets, special: BTreeMap::new(), uncorrected: 0 };
        let mut known: BTreeMap<Vec<bool>, (Vec<[f64; 2]>, bool)> = BTreeMap::new();
        let near = near_points(lattice, families.reach());
        for point in near.into_iter().filter(|&p| mirrors.is_real(lattice.cell(p))) {
            let cell = lattice.cell(point);
            let sides = families.offsets.iter().flat_map(|o| [true, false].map(|up| at(cell, o.step, up)));
            let is_present = |other: Cell| {
                let beside = [cell[0], other[1], 0];
                lattice.number(if has_border { beside } else { other }).is_some()
            };
            let present: Vec<bool> = sides.map(is_present).collect();
            if present.iter().all(|p| *p) {
                continue;
            }
            let (weights, exact) =
                known.entry(present.clone()).or_insert_with(|| families.of(&present, calibration, bond));
            families.uncorrected += usize::from(!*exact);
            families.special.insert(point as u32, weights.clone());
        }
        families
    }

    /// Weights of a point with some bonds, upwards and downwards of every offset.
    fn of(&self, present: &[bool], calibration: Calibration, bond: &ShellBond) -> (Vec<[f64; 2]>, bool) {
        let own = |k: usize| present[k].then(|| self.offsets[k / 2].member(bond));
        let family: Vec<Member> = (0..present.len()).filter_map(own).collect();
        let (weights, exact) = match calibration {
            Calibration::Matched => matched(&family),
            Calibration::Published => (family.iter().map(|m| m.weight).collect(), true),
        };
        let mut next = weights.into_iter();
        let mut all = present.iter().map(|p| if *p { next.next().unwrap_or(0.0) } else { 0.0 });
        let pairs = (0..self.offsets.len()).map(|_| [all.next().unwrap_or(0.0), all.next().unwrap_or(0.0)]);
        (pairs.collect(), exact)
    }

    /// Weight of a bond of an image, given the weights of its real point and the signs of the image: a mirror image sees the
    /// mirror image of the bond.
    pub(super) fn seen(&self, weights: &[[f64; 2]], k: usize, up: bool, signs: [f64; 3]) -> f64 {
        let sign = if up { 1 } else { -1 };
        let step = [0, 1, 2].map(|axis| sign * self.offsets[k].step[axis] * signs[axis] as i32);
        let half = if is_up(step) { step } else { step.map(|k| -k) };
        let index = self.offsets.iter().position(|o| o.step == half);
        index.map_or(0.0, |index| weights[index][usize::from(!is_up(step))])
    }

    /// All directions of bonds: offsets and whether they go upwards.
    pub(super) fn directions(&self) -> impl Iterator<Item = (usize, bool)> + use<> {
        (0..self.offsets.len()).flat_map(|k| [(k, true), (k, false)])
    }

    /// Columns and rows that a direction goes on by.
    pub(super) fn step(&self, offset: usize, up: bool) -> [i32; 2] {
        let [dx, ds, _] = self.offsets[offset].step;
        if up { [dx, ds] } else { [-dx, -ds] }
    }

    /// Weight of the bonds of a cell in a direction, whether they end on the border or not.
    pub(super) fn weight(&self, (lattice, mirrors): Body, cell: Cell, offset: usize, up: bool) -> f64 {
        let (real, signs) = mirrors.image(cell);
        let special = lattice.number(real).and_then(|p| self.special.get(&(p as u32)));
        special.map_or(self.offsets[offset].weight, |weights| self.seen(weights, offset, up, signs))
    }

    /// Weight of a bond that leaves the first of two cells and arrives from that direction at the second one: the mean of both.
    pub(super) fn shared_weight(&self, body: Body, cells: [Cell; 2], offset: usize, up: bool) -> f64 {
        0.5 * (self.weight(body, cells[0], offset, up) + self.weight(body, cells[1], offset, !up))
    }

    /// Rows or columns that bonds reach.
    pub(super) fn reach(&self) -> i32 {
        self.offsets.iter().flat_map(|o| o.step.map(i32::abs)).max().unwrap_or(0)
    }

    /// The offsets with their weights in a full family.
    pub(super) fn neighbourhood(&self) -> Neighbourhood<1> {
        let steps: Vec<Cell> = self.offsets.iter().map(|o| o.step).collect();
        let weights: Vec<[f64; 1]> = self.offsets.iter().map(|o| [o.weight]).collect();
        Neighbourhood::new(&steps, &weights, &vec![1.0; steps.len()])
    }

    /// Visits the bonds of a real point: the offset, the other point, its direction (1 upwards, −1 downwards) and weight.
    pub(super) fn for_each_bond(
        &self,
        lattice: &SquareLattice,
        point: usize,
        mut visit: impl FnMut(&ShellOffset, usize, f64, f64),
    ) {
        let special = self.special.get(&(point as u32));
        let cell = lattice.cell(point);
        for (k, offset) in self.offsets.iter().enumerate() {
            for (side, sign) in [(0, 1.0), (1, -1.0)] {
                if let Some(other) = lattice.number(at(cell, offset.step, side == 0)) {
                    visit(offset, other, sign, special.map_or(offset.weight, |s| s[k][side]));
                }
            }
        }
    }
}
