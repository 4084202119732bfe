//! Terms of the energy of a beam, by what its lines need.

use super::bond::UniformStretch;
use super::{BeamBond, BondTable, Chain, TimoshenkoBeam};
use crate::bonds::{BondGeometry, Rows};
use crate::stiffness::{Bond, Bonds, Lattice, LatticeBonds, Term, Weights};

impl TimoshenkoBeam {
    /// Terms for the unknowns (w, φ).
    pub(super) fn bending_terms(&self) -> Vec<Box<dyn Term<2>>> {
        let of = |(chain, &first): (&Chain, &usize)| -> Box<dyn Term<2>> {
            match &chain.bonds {
                BondTable::Uniform { model, classes } => {
                    let geometries = BondTable::geometries(classes);
                    Box::new(LatticeBonds::new(
                        self.lattice(chain, first),
                        model,
                        &geometries,
                        chain.weights.clone(),
                    ))
                }
                BondTable::Each { .. } => {
                    Box::new(self.listed(chain, first, BeamBond::rows2, |b| [b.bending, b.shear]))
                }
            }
        };
        self.chains.iter().zip(&self.first).map(of).collect()
    }

    /// Terms for the unknowns (w, φ, u).
    pub(super) fn frame_terms(&self) -> Vec<Box<dyn Term<3>>> {
        let mut terms: Vec<Box<dyn Term<3>>> = Vec::new();
        for (chain, &first) in self.chains.iter().zip(&self.first) {
            let lattice = self.lattice(chain, first);
            match &chain.bonds {
                BondTable::Uniform { model, classes } => {
                    let (geometries, weights) = (BondTable::geometries(classes), chain.weights.clone());
                    let stretch = UniformStretch { axial_stiffness: model.section.axial_stiffness };
                    terms.push(if chain.stretches_as_bar() {
                        Box::new(bar(chain, lattice, &stretch))
                    } else {
                        Box::new(LatticeBonds::new(lattice, &stretch, &geometries, weights.clone()))
                    });
                    terms.push(Box::new(LatticeBonds::<3, 2, _>::new(lattice, model, &geometries, weights)));
                }
                BondTable::Each { .. } => {
                    let moduli = |b: &BeamBond| [b.bending, b.shear, b.axial];
                    terms.push(Box::new(self.listed(chain, first, BeamBond::coupled_rows, moduli)));
                }
            }
        }
        terms
    }

    fn lattice(&self, chain: &Chain, first: usize) -> Lattice {
        Lattice { points: self.points, first, count: chain.extended() }
    }

    /// The bonds of a line one by one, in the order of their lower points.
    fn listed<const D: usize, const M: usize>(
        &self,
        chain: &Chain,
        first: usize,
        rows: impl Fn(&BeamBond) -> Rows<D, M>,
        moduli: impl Fn(&BeamBond) -> [f64; M],
    ) -> Bonds<D, M> {
        let weights = &chain.weights;
        let all =
            (0..weights.points()).flat_map(|lower| (0..weights.classes()).map(move |class| (lower, class)));
        let bonds = all.filter_map(|(lower, class)| chain.listed(first, class, lower, &rows, &moduli));
        Bonds::new(self.points, bonds)
    }
}

impl Chain {
    /// A bond as one of its own, in a body that gives the line's first point the number `first`; none where there is no
    /// such bond.
    pub(super) fn listed<const D: usize, const M: usize>(
        &self,
        first: usize,
        class: usize,
        lower: usize,
        rows: impl Fn(&BeamBond) -> Rows<D, M>,
        moduli: impl Fn(&BeamBond) -> [f64; M],
    ) -> Option<Bond<D, M>> {
        let weight = self.weights.weight(class, lower);
        let bond = self.bonds.bond(class, lower);
        let points = [first + lower, first + lower + self.weights.step(class)].map(|p| p as u32);
        (weight != 0.0).then(|| Bond { points, rows: rows(bond), moduli: moduli(bond).map(|c| weight * c) })
    }
}

/// A line as one bar from end to end: the bonds that cross a section have weights that sum to one, so all of them
/// together stretch no differently.
fn bar(chain: &Chain, lattice: Lattice, stretch: &UniformStretch) -> LatticeBonds<3, 1, UniformStretch> {
    let weights = Weights::new(chain.points, vec![(chain.points - 1, 1.0)], &[]);
    LatticeBonds::new(lattice, stretch, &[BondGeometry { xi: [chain.line().length, 0.0, 0.0] }], weights)
}
