//! Central bonds that yield, soften and fail: their stretches, and the list of them.

use super::super::plane::SofteningModel;
use super::{Body, BondPlane, PlaneMaterial};
use crate::body::{Cell, SquareLattice};
use crate::bonds::Rows;
use crate::model::BodyModel;
use crate::stiffness::{EndedBond, HistoryBond};

/// Stretch `s_y = σ_y/(C11 + C12)` at which all bonds that cross a plane bear the normal stress σ_y, Pa: `5σ_y/(8E)` in
/// plane strain (Yolum, Taştan, Güler 2016, Eq. 12), `2σ_y/(3E)` in plane stress.
///
/// All of them have this stretch in a state of equal stretch in all directions only. In uniaxial stress those along it
/// yield first: the body does at 2/3 of σ_y, and its strength is 0.67 to 0.9 of it, growing with `s_f/s_y`.
pub fn yield_stretch(yield_stress: f64, material: &PlaneMaterial) -> f64 {
    yield_stress / (material.c11() * 4.0 / 3.0)
}

/// Stretch `s_f = s_c²/s_y` at which a bond fails that yields at `s_y` and takes as much energy as a brittle one with the
/// critical stretch `s_c`: without E and t this is `2πG/(3σ_y δ)` for the published ones.
pub fn failure_stretch(critical_stretch: f64, yield_stretch: f64) -> f64 {
    critical_stretch * critical_stretch / yield_stretch
}

impl SofteningModel<2> for BondPlane {
    fn history_bonds(&self, law: &dyn Fn([usize; 2]) -> Option<usize>) -> Vec<HistoryBond<2>> {
        let mut list = Vec::new();
        let mut push = |points: [u32; 2], rows: &Rows<2, 1>, stiffness: f64, length: f64| {
            if let Some(law) = law(points.map(|p| p as usize)) {
                list.push(HistoryBond { points, direction: rows.difference[0], length, stiffness, law });
            }
        };
        match &self.body {
            Body::Lattice(body) => {
                let grid = &*body.bonds;
                let lengths: Vec<f64> = body
                    .neighbourhood
                    .bonded()
                    .map(|k| length(&body.lattice, body.neighbourhood.offsets[k]))
                    .collect();
                grid.for_each_bond(|index, [lower, _], _| {
                    if let Some(bond) = grid.bond(index, lower) {
                        push(bond.points, &bond.rows, bond.moduli[0], lengths[index]);
                    }
                });
            }
            Body::Cloud(body) => {
                let all = body.bonds.list().iter();
                all.for_each(|bond| push(bond.points, &bond.rows, bond.moduli[0], body.length(bond)));
            }
        }
        list
    }

    fn stress_volume(&self, point: usize) -> f64 {
        match &self.body {
            Body::Lattice(body) => body.stress_volume(point),
            Body::Cloud(_) => BodyModel::volume(self, point),
        }
    }

    fn ended_bonds(&self, law: &mut dyn FnMut(&[u32], f64) -> Option<usize>) -> Vec<EndedBond<2>> {
        let Body::Lattice(body) = &self.body else { return Vec::new() };
        let Some(border) = body.border.bonds() else { return Vec::new() };
        let mut list = Vec::new();
        for (k, of) in border.kinds.iter().enumerate() {
            let part = of.share;
            let shares: Vec<(u32, f64)> = border.bonds.difference(k).collect();
            let points: Vec<u32> = shares.iter().map(|s| s.0).collect();
            let Some(law) = law(&points, part) else { continue };
            let bond = HistoryBond {
                points: of.foremost,
                direction: border.bonds.rows(k).difference[0],
                length: part * length(&body.lattice, body.neighbourhood.offsets[of.offset as usize]),
                stiffness: border.bonds.moduli(k)[0],
                law,
            };
            list.push(EndedBond { bond, shares, share: part, of: of.of.into_iter().flatten().collect() });
        }
        list
    }
}

/// Length of a bond at an offset, m.
fn length(lattice: &SquareLattice, [a, b, _]: Cell) -> f64 {
    lattice.spacing() * f64::from(a).hypot(f64::from(b))
}
