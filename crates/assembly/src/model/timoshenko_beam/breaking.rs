//! Breaking bonds of a beam.

#[cfg(test)]
mod tests;

use super::{BeamBond, PHI, TimoshenkoBeam, U, W};
use crate::bonds::Rows;
use crate::model::Breakable;
use crate::stiffness::{Bonds, Term};

/// Strains at which the bonds of a line break, infinite where they do not: `(Δφ/ξ)²/κ_c² + γ²/γ_c² = 1`.
///
/// γ is the shear strain of the sections under the bond. Where a bond is the exact element of its span that is
/// `V_b/(α S)`: its own `γ_b = (w_j − w_i)/ξ − (φ_i + φ_j)/2` holds bending, too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CriticalStrain {
    /// Change of rotation over length κ_c, 1/m.
    pub curvature: f64,
    /// Shear strain γ_c.
    pub shear_strain: f64,
}

/// Critical strains of every line of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct CriticalStrains(pub Vec<CriticalStrain>);

/// Which bond of which line a number stands for.
struct Place {
    chain: usize,
    class: usize,
    lower: usize,
}

impl CriticalStrain {
    /// The ratio of a bond with the measures Δφ and shear.
    fn ratio(&self, bond: &BeamBond, [bending, shear, _]: [f64; 3]) -> f64 {
        (bending / (bond.length * self.curvature)).hypot(bond.shear_strain * shear / self.shear_strain)
    }
}

impl TimoshenkoBeam {
    /// Most classes of a line: a bond has the number `class · points + lower point`.
    fn classes(&self) -> usize {
        self.chains.iter().map(|c| c.weights.classes()).max().unwrap_or(0)
    }

    fn number(&self, chain: usize, class: usize, lower: usize) -> u64 {
        (class * self.points + self.first[chain] + lower) as u64
    }

    fn place_of(&self, bond: u64) -> Place {
        let (class, point) = (bond as usize / self.points, bond as usize % self.points);
        let chain = self.chain_of(point);
        Place { chain, class, lower: point - self.first[chain] }
    }

    /// Ends of a bond, the lower one twice where no line has such a bond.
    fn ends_of(&self, bond: u64) -> [usize; 2] {
        let Place { chain, class, lower } = self.place_of(bond);
        let (first, weights) = (self.first[chain], &self.chains[chain].weights);
        let step = if class < weights.classes() { weights.step(class) } else { 0 };
        [first + lower, first + (lower + step).min(weights.points() - 1)]
    }

    /// As [`Breakable::for_each_ratio`], for two or three planes of unknowns.
    fn ratios(&self, u: &[f64], critical: &CriticalStrains, visit: &mut dyn FnMut(u64, f64)) {
        let n = self.points;
        let difference = |component: usize, [i, j]: [usize; 2]| {
            u.get(component * n..).filter(|plane| !plane.is_empty()).map_or(0.0, |plane| plane[j] - plane[i])
        };
        for (chain, (c, critical)) in self.chains.iter().zip(&critical.0).enumerate() {
            for class in 0..c.weights.classes() {
                let step = c.weights.step(class);
                for lower in 0..c.extended().saturating_sub(step) {
                    if c.weights.weight(class, lower) == 0.0 {
                        continue;
                    }
                    let ends = [self.first[chain] + lower, self.first[chain] + lower + step];
                    let bond = c.bonds.bond(class, lower);
                    let rotations = u[PHI * n + ends[0]] + u[PHI * n + ends[1]];
                    let ratio = critical
                        .ratio(bond, bond.measures([W, PHI, U].map(|k| difference(k, ends)), rotations));
                    if ratio > 0.0 {
                        visit(self.number(chain, class, lower), ratio);
                    }
                }
            }
        }
    }

    /// The bonds with these numbers that are there, as bonds of their own.
    fn listed_part<const D: usize, const M: usize>(
        &self,
        bonds: &[u64],
        rows: impl Fn(&BeamBond) -> Rows<D, M>,
        moduli: impl Fn(&BeamBond) -> [f64; M],
    ) -> Bonds<D, M> {
        let listed = bonds.iter().filter_map(|&bond| {
            let Place { chain, class, lower } = self.place_of(bond);
            let c = &self.chains[chain];
            (class < c.weights.classes())
                .then(|| c.listed(self.first[chain], class, lower, &rows, &moduli))
                .flatten()
        });
        Bonds::new(self.points, listed)
    }

    /// Removes bonds.
    ///
    /// # Panics
    /// The body has ghost points: the image of a bond would not break with it.
    fn remove(&mut self, bonds: &[u64]) {
        assert!(
            self.chains.iter().all(|c| c.ghosts == [0; 2]),
            "the image of a bond would not break with it"
        );
        for &bond in bonds {
            let Place { chain, class, lower } = self.place_of(bond);
            let chain = &mut self.chains[chain];
            if class < chain.weights.classes() && chain.weights.weight(class, lower) != 0.0 {
                chain.break_bond(class, lower);
            }
        }
    }

    /// # Panics
    /// Some line stretches as one bar.
    fn check_axial(&self) {
        let single = self.chains.iter().all(|c| !c.stretches_as_bar());
        assert!(single, "a bar from end to end does not break bond by bond");
    }
}

impl Breakable<2> for TimoshenkoBeam {
    type Critical = CriticalStrains;

    fn bond_numbers(&self) -> u64 {
        (self.classes() * self.points) as u64
    }

    fn ends(&self, bond: u64) -> [usize; 2] {
        self.ends_of(bond)
    }

    fn for_each_ratio(&self, u: &[f64], critical: &CriticalStrains, visit: &mut dyn FnMut(u64, f64)) {
        self.ratios(u, critical, visit);
    }

    fn part(&self, bonds: &[u64]) -> Vec<Box<dyn Term<2>>> {
        vec![Box::new(self.listed_part(bonds, BeamBond::rows2, |b| [b.bending, b.shear]))]
    }

    /// # Panics
    /// The body has ghost points.
    fn break_bonds(&mut self, bonds: &[u64]) {
        self.remove(bonds);
    }
}

/// Of lines with axial unknowns on all points: see [`Axial::Points`](super::Axial::Points).
impl Breakable<3> for TimoshenkoBeam {
    type Critical = CriticalStrains;

    fn bond_numbers(&self) -> u64 {
        Breakable::<2>::bond_numbers(self)
    }

    fn ends(&self, bond: u64) -> [usize; 2] {
        self.ends_of(bond)
    }

    fn for_each_ratio(&self, u: &[f64], critical: &CriticalStrains, visit: &mut dyn FnMut(u64, f64)) {
        self.ratios(u, critical, visit);
    }

    /// # Panics
    /// Some line stretches as one bar.
    fn part(&self, bonds: &[u64]) -> Vec<Box<dyn Term<3>>> {
        self.check_axial();
        let moduli = |b: &BeamBond| [b.bending, b.shear, b.axial];
        vec![Box::new(self.listed_part(bonds, BeamBond::coupled_rows, moduli))]
    }

    /// # Panics
    /// The body has ghost points, or some line stretches as one bar.
    fn break_bonds(&mut self, bonds: &[u64]) {
        self.check_axial();
        self.remove(bonds);
    }
}
