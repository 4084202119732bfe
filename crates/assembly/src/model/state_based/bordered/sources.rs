//! What completes the border of a body of bonds, as places that have parts of the change of volume.
//!
//! A bond with the weight a and the stretch s has the parts `a s/(8μ)` of the dilatations of both of its points. What a border
//! has in place of missing bonds, runs of bonds or triangles, has the same per stretch, and belongs to no point yet.

use super::super::super::bond_plane::CentralBond;
use super::super::super::plane::LatticeBody;
use crate::bonds::Mat;
use std::collections::BTreeMap;

/// The bonds of a state-based body with `λ = μ`.
pub(in super::super) type Bonded = LatticeBody<2, 1, 3, CentralBond>;

/// Parts of a change of volume, `Σ rows·u`, with the tensor t of them: in a strain E it is `t : E`. Volumes are in cells.
#[derive(Clone, Debug, Default)]
pub(super) struct Source {
    /// Where it is, in cells.
    pub(super) at: [f64; 2],
    /// `[t_xx, t_yy, t_xy]`; half of the trace is its volume.
    pub(super) tensor: [f64; 3],
    /// Points and the coefficients of their displacements, 1/m.
    pub(super) rows: Vec<(u32, [f64; 2])>,
}

impl Source {
    /// Its volume.
    pub(super) fn volume(&self) -> f64 {
        0.5 * (self.tensor[0] + self.tensor[1])
    }

    /// Adds another one.
    fn join(&mut self, other: Self) {
        let (own, theirs) = (self.volume(), other.volume());
        (0..2).for_each(|k| self.at[k] = (own * self.at[k] + theirs * other.at[k]) / (own + theirs));
        (0..3).for_each(|q| self.tensor[q] += other.tensor[q]);
        self.rows.extend(other.rows);
    }
}

/// What completes the border of a body with the shear modulus μ, Pa.
pub(super) fn sources(plate: &Bonded, shear_modulus: f64) -> Vec<Source> {
    let found = match (plate.border.ended(), plate.border.cut()) {
        (Some(_), _) => runs(plate, shear_modulus),
        (_, Some(cut)) => {
            let of = |k: usize| {
                let members = cut.families.members(k).iter().map(|m| (m.point, m.share, m.rows));
                of_triangle(plate, shear_modulus, cut.families.stress(k, &[1.0, 1.0, 0.0]), members.collect())
            };
            (0..cut.families.count()).map(of).collect()
        }
        _ => plate.triangles.list().iter().map(|family| {
            let mut members = vec![(family.point, 1.0 / 3.0, [[0.0; 2]; 3])];
            for (&point, rows) in family.others.iter().zip(family.rows) {
                (0..3).for_each(|q| (0..2).for_each(|c| members[0].2[q][c] -= rows[q][c]));
                members.push((point, 1.0 / 3.0, rows));
            }
            of_triangle(plate, shear_modulus, family.stress(&[1.0, 1.0, 0.0]), members)
        }).collect(),
    };
    found.into_iter().filter(|source: &Source| source.volume() > 0.0).collect()
}

/// A triangle that has a stress, times its volume, in a strain of one along all directions.
fn of_triangle(
    plate: &Bonded,
    shear_modulus: f64,
    stress: [f64; 3],
    members: Vec<(u32, f64, Mat<3, 2>)>,
) -> Source {
    let tensor = stress.map(|s| s / (4.0 * shear_modulus * plate.kind.bond.volume));
    let row = |rows: &Mat<3, 2>| [0, 1].map(|c| (0..3).map(|q| tensor[q] * rows[q][c]).sum());
    Source {
        at: centre(plate, members.iter().map(|m| (m.0, m.1))),
        tensor,
        rows: members.iter().map(|(point, _, rows)| (*point, row(rows))).collect(),
    }
}

/// Bonds that end on the border, by the real point that they begin at, those of images among them.
fn runs(plate: &Bonded, shear_modulus: f64) -> Vec<Source> {
    let Some(border) = plate.border.ended() else { return Vec::new() };
    let (mut of_points, mut found) = (BTreeMap::<usize, Source>::new(), Vec::new());
    for (k, part) in border.kinds.iter().enumerate() {
        let [x, y] = plate.lattice.vector(plate.hood.offsets[part.offset as usize]);
        let length = part.share * x.hypot(y);
        // Half a modulus times the length squared is half the energy per squared stretch; both points have their share.
        let volume = border.bonds.moduli(k)[0] * length * length
            / (4.0 * shear_modulus * plate.kind.bond.volume);
        let [n] = border.bonds.rows(k).difference;
        let row = |share: f64| n.map(|n| volume / length * share * n);
        let mut source = Source {
            at: centre(plate, border.bonds.middle(k).map(|(point, share)| (point as u32, share))),
            tensor: [n[0] * n[0], n[1] * n[1], n[0] * n[1]].map(|t| volume * t),
            rows: border.bonds.difference(k).map(|(point, share)| (point, row(share))).collect(),
        };
        let Some(start) = part.start else {
            found.push(source);
            continue;
        };
        let (cell, image) = (plate.lattice.cell(start as usize), plate.mirrors.image(plate.lattice.cell(start as usize)));
        let Some(real) = plate.lattice.number(image.0) else { continue };
        let signs = image.1;
        (0..2).for_each(|k| {
            let from_point = source.at[k] - f64::from(cell[k]);
            source.at[k] = f64::from(image.0[k]) + signs[k] * from_point;
        });
        source.tensor[2] *= signs[0] * signs[1];
        match of_points.get_mut(&real) {
            Some(known) => known.join(source),
            None => _ = of_points.insert(real, source),
        }
    }
    found.extend(of_points.into_values());
    found
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
