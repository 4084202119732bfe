//! How much memory solving in strains takes.

use crate::run::memory;
use crate::scene::beam::BeamScene;
use peristat_assembly::model::Model;
use peristat_assembly::model::timoshenko_beam::{StrainForm, TimoshenkoBeam};

/// Memory of bonds, factor and vectors, bytes; and, with `recover`, of fields and their files.
pub(in super::super) fn estimate<const D: usize>(scene: &BeamScene, form: &StrainForm, recover: bool) -> u64
where
    TimoshenkoBeam: Model<D>,
{
    let unknowns = D * scene.beam.points();
    memory::total(scene, 8 * unknowns + factor(form) + memory::fields(scene, recover))
}

/// The factor of the strain form and what it is made of, bytes.
fn factor(form: &StrainForm) -> usize {
    /// Reach up to which the columns of equal cells converge within [`CONVERGED`] times the reach, measured.
    const QUICK: usize = 50;
    const CONVERGED: usize = 10;
    let (cells, m, chain) = (form.cells(), form.reach(), form.chain());
    // Two columns and two rows of 2m numbers per cell.
    let factor = 8 * 2 * 2 * 2 * m;
    if !chain.is_uniform() {
        // Each cell is a run with its own two columns, in the matrix as well; lists that grow leave room behind.
        return cells * (2 * factor + 128);
    }
    let runs = 1 + chain.line().splits.len();
    let kept = if m > QUICK { cells } else { cells.min(CONVERGED * m * runs) };
    kept * factor
}
