//! What bodies of revolution have beside plates: radii by which bonds and points count, and an axis on which the body ends.
//!
//! A volume is that of a cell one spacing from the axis times a radius in spacings. A bond has the radius of its middle:
//! inside, what bonds of one stretch do to their points is then the divergence of their stress times the radius, exactly. A
//! triangle that the border cuts has the radius of the centre of its part, so that what uniform stresses do there is what their
//! tractions do on the true border, on the axis nothing. Between both remains, of the bonds, a part `c (Δ_x Δ_y u_y)` of every block,
//! c about 0.02 spacings times the stress: the mixed differences cancel but for corners of the region of whole blocks.

use super::super::super::bond_plane::CentralBond;
use super::super::super::plane::{By, Mirrors};
use super::super::{StateError, StateParameters};
use super::border::follows;
use super::sources::Bonded;
use crate::body::SquareLattice;
use crate::stiffness::{Families, GridBonds, Offset, Term};
use std::collections::HashSet;

/// The lattice of a body of revolution with the parts of its blocks, and its lines with the axis among them.
///
/// # Errors
/// [`StateError::NoBorder`] where centres of parts are not known, [`StateError::OffAxis`].
pub(super) fn ringed(
    parameters: &StateParameters,
    real: &SquareLattice,
    mirrors: Mirrors,
) -> Result<(SquareLattice, Mirrors), StateError> {
    let (mirrors, _) = super::super::body::with_axis(parameters, real, mirrors)?;
    let mirrors = Mirrors { revolved: true, ..mirrors };
    match (real.blocks().is_empty(), real.centres().is_empty()) {
        (true, _) if real.cut_cells().is_empty() => Ok((real.clone().with_whole_blocks(), mirrors)),
        (_, false) => Ok((real.clone(), mirrors)),
        _ => Err(StateError::NoBorder),
    }
}

/// What a point counts by: in a body of revolution its radius in spacings, beyond the axis that of its image.
pub(super) fn weight(plate: &Bonded, point: usize) -> f64 {
    match plate.mirrors.revolved {
        true => (plate.lattice.place(point)[0] / plate.lattice.spacing()).abs(),
        false => 1.0,
    }
}

/// Bonds and what completes them.
pub(super) fn terms(plate: &Bonded) -> Vec<Box<dyn Term<2>>> {
    if !plate.mirrors.revolved {
        return plate.terms();
    }
    let mut terms: Vec<Box<dyn Term<2>>> = vec![Box::new(bonds(plate))];
    match &plate.border.by {
        By::Triangles(families) => terms.push(Box::new(families.clone())),
        By::Points | By::Bonds(_) => {
            let mut list = plate.triangles.list().to_vec();
            for family in &mut list {
                let weight = weight(plate, family.point as usize);
                family.modulus.iter_mut().flatten().for_each(|c| *c *= weight);
            }
            terms.push(Box::new(Families::new(plate.lattice.points(), list)));
        }
    }
    terms
}

/// The bonds with the radii of their middles, halved by lines of symmetry and without those that give way to the border.
fn bonds(plate: &Bonded) -> GridBonds<2, 1, CentralBond> {
    let (lattice, neighbourhood) = (&plate.lattice, &plate.neighbourhood);
    let bonded: Vec<usize> = neighbourhood.bonded().collect();
    let steps: Vec<Offset<1>> = bonded
        .iter()
        .map(|&k| Offset { step: neighbourhood.offsets[k], weights: neighbourhood.weights[k] })
        .collect();
    let gaps: HashSet<(usize, usize)> = plate.border.gaps.iter().map(|gap| (gap.offset, gap.lower)).collect();
    let all = || 0..lattice.points();
    let weights: Vec<f64> = all().map(|p| weight(plate, p)).collect();
    let is_real: Vec<bool> = all().map(|p| plate.mirrors.is_real(lattice.cell(p))).collect();
    let part = |p: usize| if follows(plate) { 1.0 } else { lattice.fraction(p) };
    GridBonds::with_factors(lattice.clone(), &plate.kind.bond, &steps, |k, [lower, upper]| {
        if gaps.contains(&(bonded[k], lower)) {
            return 0.0;
        }
        let counted: f64 = [lower, upper].iter().map(|&p| 0.5 * f64::from(u8::from(is_real[p]))).sum();
        counted * part(lower).min(part(upper)) * 0.5 * (weights[lower] + weights[upper])
    })
}
