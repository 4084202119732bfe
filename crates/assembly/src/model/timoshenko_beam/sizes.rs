//! Sizes of the terms of a beam, known without building them.

use super::{BeamBond, BondTable, Chain, TimoshenkoBeam, U};
use crate::model::ModelSizes;
use crate::stiffness::Bond;

impl TimoshenkoBeam {
    /// Sizes of the terms for `D` unknowns per point.
    pub(super) fn term_sizes<const D: usize>(&self) -> ModelSizes {
        let of = |chain: &Chain| match D > U {
            false => bending(chain),
            true => with_axial(chain),
        };
        self.chains.iter().map(of).fold(ModelSizes::default(), ModelSizes::join)
    }
}

/// A line with the unknowns (w, φ).
fn bending(chain: &Chain) -> ModelSizes {
    let (points, bonds) = (chain.extended(), chain.weights.bonds());
    let bytes = stored(chain, size_of::<Bond<2, 2>>());
    ModelSizes { reach: chain.weights.reach(), elements: bonds, entries: 3 * points + 4 * bonds, bytes }
}

/// A line with the unknowns (w, φ, u).
fn with_axial(chain: &Chain) -> ModelSizes {
    let (points, bonds) = (chain.extended(), chain.weights.bonds());
    let bytes = stored(chain, size_of::<Bond<3, 3>>());
    let (bent, reach) = (4 * points + 4 * bonds, chain.weights.reach());
    match &chain.bonds {
        BondTable::Uniform { .. } if chain.stretches_as_bar() => {
            ModelSizes { reach: reach.max(points - 1), elements: bonds + 1, entries: bent + 1, bytes }
        }
        BondTable::Uniform { .. } => ModelSizes { reach, elements: 2 * bonds, entries: bent + bonds, bytes },
        BondTable::Each { .. } if chain.line().stiffness.couples() => {
            ModelSizes { reach, elements: bonds, entries: 6 * points + 9 * bonds, bytes }
        }
        BondTable::Each { .. } => ModelSizes { reach, elements: bonds, entries: bent + bonds, bytes },
    }
}

/// Memory of what is kept per bond, by the line and by its term: bonds of `bond` bytes that are each their own, or
/// exceptions from the weights of classes.
fn stored(chain: &Chain, bond: usize) -> usize {
    let (points, classes) = (chain.extended(), chain.weights.classes());
    let weights = 2 * size_of::<f64>() * chain.weights.stored_factors();
    match &chain.bonds {
        BondTable::Uniform { .. } => weights,
        BondTable::Each { .. } => weights + points * classes * (size_of::<BeamBond>() + bond),
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Axial, BeamParameters, Line, VolumeFactor, bond_law, end_treatment};
    use super::*;
    use crate::material::SectionStiffness;
    use crate::model::Model;

    /// Largest reach and number of elements of the terms themselves.
    fn built<const D: usize>(beam: &TimoshenkoBeam) -> [usize; 2]
    where
        TimoshenkoBeam: Model<D>,
    {
        let terms = Model::<D>::terms(beam);
        [terms.iter().map(|t| t.reach()).max().unwrap(), terms.iter().map(|t| t.elements()).sum()]
    }

    #[test]
    fn sizes_are_those_of_the_terms() {
        let (volume_factor, bond_law) = (VolumeFactor::HalfEdge, bond_law::find("exact").unwrap());
        let end_treatment = end_treatment::find("cover").unwrap();
        let line =
            || Line { splits: vec![4], ..Line::new(1.0, 9, SectionStiffness::uniform(1.0, 2.0, 3.0, 1.0)) };
        let stations = Some((0..=9).map(|k| f64::from(k * k) / 81.0).collect());
        let graded = Line { stations, ..line() };
        let points = Line { axial: Axial::Points, ..line() };
        for lines in [vec![line()], vec![line(), points.clone()], vec![graded.clone()], vec![points, graded]]
        {
            let parameters = BeamParameters { volume_factor, bond_law, end_treatment };
            let beam = TimoshenkoBeam::new(parameters, lines).unwrap();
            let told = [Model::<2>::sizes(&beam), Model::<3>::sizes(&beam)].map(|s| [s.reach, s.elements]);
            assert_eq!(told, [built::<2>(&beam), built::<3>(&beam)]);
        }
    }
}
