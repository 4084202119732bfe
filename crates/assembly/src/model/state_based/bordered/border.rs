//! What completes the border of a body of bonds, as sources of changes of volume.

use super::super::super::plane::By;
use super::rings::weight;
use super::sources::{ANY, Bonded, Kind, Source, Sources};
use crate::body::Cell;
use std::collections::BTreeMap;

/// Adds what completes the border of a body with the shear modulus μ, Pa.
pub(super) fn add_border(plate: &Bonded, shear_modulus: f64, to: &mut Sources) {
    add_runs(plate, shear_modulus, to);
    add_triangles(plate, shear_modulus, to);
    add_overlay(plate, shear_modulus, to);
}

/// Bonds that end on the border, by the real point that they begin at, those of images among them.
fn add_runs(plate: &Bonded, shear_modulus: f64, to: &mut Sources) {
    let Some(border) = plate.border.bonds() else { return };
    for (k, part) in border.kinds.iter().enumerate() {
        let mut direction = plate.neighbourhood.offsets[part.offset as usize];
        let [x, y, _] = plate.lattice.vector(direction);
        let length = part.share * x.hypot(y);
        // A modulus times the squared length is a part of `a V`, and the run has the shares of two points.
        let volume =
            border.bonds.moduli(k)[0] * length * length / (4.0 * shear_modulus * plate.kind.bond.volume);
        let [n] = border.bonds.rows(k).difference;
        let row = |share: f64| n.map(|n| volume / length * share * n);
        let mut source = Source {
            at: centre(plate, border.bonds.middle(k).map(|(point, share)| (point as u32, share))),
            tensor: [n[0] * n[0], n[1] * n[1], n[0] * n[1]].map(|t| volume * t),
            rows: border.bonds.difference(k).map(|(point, share)| (point, row(share))).collect(),
        };
        let Some((start, _)) = part.of[0] else {
            to.add(Kind::Single(k), [0; 3], direction, &source);
            continue;
        };
        let cell = plate.lattice.cell(start as usize);
        let (real, signs) = plate.mirrors.image(cell);
        for axis in 0..2 {
            let from_point = source.at[axis] - f64::from(cell[axis]);
            source.at[axis] = f64::from(real[axis]) + signs[axis] * from_point;
        }
        source.tensor[2] *= signs[0] * signs[1];
        direction[0] *= (signs[0] * signs[1]) as i32;
        to.add(Kind::Border, real, direction, &source);
    }
}

/// Triangles that the border cuts, by blocks.
fn add_triangles(plate: &Bonded, shear_modulus: f64, to: &mut Sources) {
    let By::Triangles(families) = &plate.border.by else { return };
    let bonded: Vec<usize> = plate.neighbourhood.bonded().collect();
    for (k, left) in plate.left_to_triangles().iter().enumerate() {
        let members = families.members(k);
        let at = centre(plate, members.iter().map(|m| (m.point, m.share)));
        let block = [at[0].floor() as i32, at[1].floor() as i32, 0];
        for (&offset, part) in bonded.iter().zip(left).filter(|(_, part)| **part > 0.0) {
            let direction: Cell = plate.neighbourhood.offsets[offset];
            let [x, y, _] = plate.lattice.vector(direction);
            let volume =
                part * plate.neighbourhood.weights[offset][0] / (4.0 * shear_modulus * (x * x + y * y));
            let tensor = [x * x, y * y, x * y].map(|t| volume * t);
            let row = |c: usize, rows: &[[f64; 2]; 3]| (0..3).map(|q| tensor[q] * rows[q][c]).sum();
            let rows: BTreeMap<u32, [f64; 2]> =
                members.iter().map(|m| (m.point, [0, 1].map(|c| row(c, &m.rows)))).collect();
            to.add(Kind::Border, block, direction, &Source { at, tensor, rows });
        }
    }
}

/// Triangles of points, on lattices that do not know their border: with its own a point lacks nothing.
fn add_overlay(plate: &Bonded, shear_modulus: f64, to: &mut Sources) {
    if follows(plate) {
        return;
    }
    for family in plate.triangles.list() {
        let cell = plate.lattice.cell(family.point as usize);
        let stress = family.stress(&[1.0, 1.0, 0.0]);
        let part = weight(plate, family.point as usize) / (4.0 * shear_modulus * plate.kind.bond.volume);
        let tensor = stress.map(|s| part * s);
        let at = [cell[0], cell[1]].map(f64::from);
        let mut source = Source { at, tensor, ..Source::default() };
        for (&other, rows) in family.others.iter().zip(&family.rows) {
            let row: [f64; 2] = [0, 1].map(|c| (0..3).map(|q| tensor[q] * rows[q][c]).sum());
            source.add_row(other, row);
            source.add_row(family.point, row.map(|r| -r));
        }
        to.add(Kind::Bonds, cell, ANY, &source);
    }
}

/// Whether the border of a plate is completed as it runs.
pub(super) fn follows(plate: &Bonded) -> bool {
    !plate.border.is_none()
}

/// The place that points have some shares in, in cells.
fn centre(plate: &Bonded, shares: impl Iterator<Item = (u32, f64)>) -> [f64; 2] {
    let mut at = [0.0; 2];
    for (point, share) in shares {
        let cell = plate.lattice.cell(point as usize);
        (0..2).for_each(|k| at[k] += share * f64::from(cell[k]));
    }
    at
}
