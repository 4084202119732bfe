//! Breaking bonds of a plate.
//!
//! A bond breaks by what it bends and shears, `(κ_b/κ_c)² + (γ_b/γ_b,c)² = 1`. Its critical shear follows from that of the plate under it,
//! whose shear strain is `V·n/S` with `V·n = s γ_b/(2ω)`, or from an energy: in a thin plate `γ_b` is bending that other bonds do not see,
//! and the plate hardly shears. With a bond go the triangles that have it as a side.

use super::part::Part;
use super::recover::Way;
use super::{PlateBending, PlateSection};
use crate::model::Breakable;
use crate::stiffness::{Bond, Bonds, Term};
use std::sync::Arc;

/// Strains at which the bonds of cells of one section break, infinite where they do not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CriticalCurvature {
    /// Change of rotation over length κ_c, 1/m.
    pub curvature: f64,
    /// What bonds bear in shear.
    pub shear: CriticalShear,
}

/// What the bonds of a plate bear in shear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CriticalShear {
    /// A shear strain of the plate.
    Strain(f64),
    /// An energy per weight and area of a cell, `½ s γ_b²/ω`, N/m.
    Energy(f64),
}

/// How much more a long crack along the rows needs than Griffith's load if bonds hold just its energy: measured on ribbons whose edges are
/// turned, for Poisson's ratios from 0 to 0.45 to 3 %. Cells that are longer than the plate is thick shear little; short ones shear.
fn trapping(section: &PlateSection, h: f64) -> f64 {
    const THICK: (f64, f64) = (0.875, 1.56);
    const THIN: (f64, f64) = (4.0, 1.33);
    let slenderness = section.shear * h * h / section.bending;
    let part = ((slenderness / THICK.0).ln() / (THIN.0 / THICK.0).ln()).clamp(0.0, 1.0);
    THICK.1 + part * (THIN.1 - THICK.1)
}

impl CriticalShear {
    /// The ratio to it of what bonds of a shear stiffness per weight bear at `γ_b = 1`, in a plate of the shear stiffness S.
    fn ratio(self, unit: f64, plate: f64) -> f64 {
        match self {
            Self::Strain(strain) => 0.5 * unit / (plate * strain),
            Self::Energy(energy) => (0.5 * unit / energy).sqrt(),
        }
    }
}

/// Those of the sections by number, the base first.
#[derive(Clone, Debug, PartialEq)]
pub struct CriticalCurvatures(pub Vec<CriticalCurvature>);

/// Which bond of which part a number stands for.
struct Place {
    part: usize,
    offset: usize,
    lower: usize,
}

impl PlateBending {
    /// Strains under which the bonds that cross a row of the lattice hold so much energy per length, J/m, by section:
    ///
    /// ```text
    /// κ_c² (2β Σ ω |ξ_y| + ¼ (c_tr + c_dev) h) = Σ ½ s γ_b,c² |ξ_y| = G_c t
    /// ```
    ///
    /// `energies` are G_c t of the sections by number.
    pub fn critical_of_energy(&self, energies: &[f64]) -> CriticalCurvatures {
        let h = self.nodes().spacing();
        let of_part = |(part, energy): (&Part, &f64)| {
            let section = &part.parameters.section;
            let crossing = |weight: &dyn Fn(usize) -> f64| -> f64 {
                let steps = part.offsets.iter().enumerate();
                steps.map(|(k, offset)| weight(k) * h * f64::from(offset.step[1].abs())).sum()
            };
            let bending = 2.0 * section.common() * crossing(&|k| part.offsets[k].bending);
            let triangles = 0.25 * h * section.rest().iter().sum::<f64>();
            let shear = CriticalShear::Energy(energy / crossing(&|k| part.offsets[k].shear));
            CriticalCurvature { curvature: (energy / (bending + triangles)).sqrt(), shear }
        };
        CriticalCurvatures(self.parts().iter().zip(energies).map(of_part).collect())
    }

    /// The same divided by the lattice trapping: strains with which a long crack along the rows that opens by bending grows at the energy.
    pub fn critical_of_growth(&self, energies: &[f64]) -> CriticalCurvatures {
        let h = self.nodes().spacing();
        let trapping = |part: &Part| trapping(&part.parameters.section, h).powi(2);
        let held: Vec<f64> = energies.iter().zip(self.parts()).map(|(e, part)| e / trapping(part)).collect();
        self.critical_of_energy(&held)
    }

    /// Part of the bonds of every point that has broken.
    pub fn damage(&self) -> Vec<f64> {
        if self.cut.is_empty() {
            return vec![0.0; self.nodes().points()];
        }
        let mut whole = self.cut.clone();
        for part in self.parts() {
            part.bonds.for_each_bond(|_, ends, [factor, ..]| ends.iter().for_each(|&p| whole[p] += factor));
        }
        self.cut.iter().zip(whole).map(|(cut, whole)| if *cut > 0.0 { cut / whole } else { 0.0 }).collect()
    }

    /// Whether the bond of a part from a point to the next one along an axis has broken.
    pub(super) fn is_cut(&self, part: usize, node: [i32; 2], axis: usize) -> bool {
        if self.cut.is_empty() {
            return false;
        }
        let Some(lower) = self.nodes().number(node).filter(|&point| self.cut[point] > 0.0) else {
            return false;
        };
        let part = &self.parts()[part];
        let step = if axis == 0 { [1, 0, 0] } else { [0, 1, 0] };
        let offset = part.offsets.iter().position(|offset| offset.step == step);
        offset.is_some_and(|offset| part.bonds.bond(offset, lower).is_none())
    }

    fn offsets(&self) -> usize {
        self.parts()[0].offsets.len()
    }

    fn number(&self, part: usize, offset: usize, lower: usize) -> u64 {
        ((part * self.offsets() + offset) * self.nodes().points() + lower) as u64
    }

    fn place_of(&self, bond: u64) -> Place {
        let (class, lower) = (bond as usize / self.nodes().points(), bond as usize % self.nodes().points());
        Place { part: class / self.offsets(), offset: class % self.offsets(), lower }
    }

    /// The bonds with these numbers that are there, by part, as bonds of their own.
    fn listed(&self, bonds: &[u64], number: usize) -> Vec<Bond<3, 2>> {
        let places = bonds.iter().map(|&bond| self.place_of(bond)).filter(|place| place.part == number);
        places.filter_map(|place| self.parts()[number].bonds.bond(place.offset, place.lower)).collect()
    }
}

impl Breakable<3> for PlateBending {
    type Critical = CriticalCurvatures;

    fn bond_numbers(&self) -> u64 {
        (self.parts().len() * self.offsets() * self.nodes().points()) as u64
    }

    fn ends(&self, bond: u64) -> [usize; 2] {
        let Place { part, offset, lower } = self.place_of(bond);
        let [p, q, _] = self.parts()[part].offsets[offset].step;
        let [i, j] = self.nodes().node(lower);
        [lower, self.nodes().number([i + p, j + q]).unwrap_or(lower)]
    }

    fn offset(&self, bond: u64) -> usize {
        self.place_of(bond).offset
    }

    fn for_each_ratio(&self, u: &[f64], critical: &CriticalCurvatures, visit: &mut dyn FnMut(u64, f64)) {
        for (number, (part, critical)) in self.parts().iter().zip(&critical.0).enumerate() {
            let of_way = |way: &Way| critical.shear.ratio(way.unit, part.parameters.section.shear);
            let shears: Vec<f64> = self.ways(part).iter().map(of_way).collect();
            part.bonds.for_each_measured(u, |offset, [lower, _], [bending, shear]| {
                let ratio = (bending / critical.curvature).hypot(shear * shears[offset]);
                if ratio > 0.0 {
                    visit(self.number(number, offset, lower), ratio);
                }
            });
        }
    }

    fn part(&self, bonds: &[u64]) -> Vec<Box<dyn Term<3>>> {
        let mut terms: Vec<Box<dyn Term<3>>> = Vec::new();
        for (number, part) in self.parts().iter().enumerate() {
            let listed = self.listed(bonds, number);
            if listed.is_empty() {
                continue;
            }
            let ends: Vec<[usize; 2]> = listed.iter().map(|bond| bond.points.map(|p| p as usize)).collect();
            if let Some(triangles) = part.triangles() {
                terms.push(Box::new(Arc::new(triangles.beside(self.nodes(), &ends))));
            }
            terms.push(Box::new(Bonds::new(self.nodes().points(), listed.into_iter())));
        }
        terms
    }

    /// # Panics
    /// Bonds reach further than to the next points: the pieces of a bond would not break with it.
    fn break_bonds(&mut self, bonds: &[u64]) {
        assert!(self.offsets() == 4, "the pieces of a bond would not break with it");
        for &bond in bonds {
            let Place { part, offset, lower } = self.place_of(bond);
            self.cut_bond(part, (offset, lower));
        }
    }
}
