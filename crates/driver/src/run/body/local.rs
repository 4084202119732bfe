//! Bodies whose displacements are corrected until they are those of local elasticity.
//!
//! The factor or the cycle that solved a state solves its corrections. They have no resultant, so that reactions stay those of
//! the loads; what replaces displacements beside the border moves the points that are held, and the body follows them back.

use super::fields::BodyResult;
use super::of_stress::{Medium, of_stress};
use crate::diagnostic::{Faults, root};
use crate::run::{Corrections, RunError, scan};
use crate::scene::body::{BodyProbe, BodyScene, BodyState, LocalLimit, Quantity};
use nalgebra::{DMatrix, DVector};
use peristat_assembly::correction::{Correction, Fitting, State};
use peristat_assembly::model::plane::PlaneModel;
use peristat_assembly::recovery::hole::Field;

/// Polynomials of the fourth degree over three spacings: 18 fields of 32 points.
const FITTING: Fitting = Fitting { degree: 4, reach: 3.0 };
/// A correction is not taken whose energy norm is a larger part of the one before it.
const STALLED: f64 = 0.5;
/// Singular values of the rigid motions that supports hold below this part of the largest are zero.
const NONE: f64 = 1e-9;

/// What the displacements of a body are corrected by.
#[derive(Debug)]
pub(super) struct Local {
    correction: Correction,
}

impl Local {
    /// Of a scene that asks for it.
    ///
    /// # Errors
    /// A body that is too thin somewhere to tell a fit.
    pub(super) fn of(scene: &BodyScene) -> Result<Option<Self>, RunError> {
        let Some((limit, model, outline)) = parts(scene) else { return Ok(None) };
        let ratio = scene.material().about().horizon_ratio;
        match Correction::new(model, outline, &limit.pieces, ratio, FITTING) {
            Some(correction) => Ok(Some(Self { correction })),
            None => {
                let mut faults = Faults::default();
                faults
                    .error(
                        root("limit"),
                        "`local` needs more points: somewhere too few of them are near to tell the stresses",
                    )
                    .hint("use a smaller spacing, four over the thinnest part of the body");
                Err(RunError::Case(faults))
            }
        }
    }

    /// Corrected displacements of a state, and how it went.
    pub(super) fn corrected(
        &self,
        scene: &BodyScene,
        state: usize,
        u: &[f64],
        solve: &mut dyn FnMut(&[f64]) -> Vec<f64>,
    ) -> (Vec<f64>, Corrections) {
        let border = self.border(scene, &scene.states[state]);
        let points = scene.model.points();
        let mut done = Corrections { sizes: Vec::new(), stalled: false };
        let (mut u, mut before) = (u.to_vec(), f64::INFINITY);
        let most = scene.limit.as_ref().map_or(0, |limit| limit.corrections);
        for _ in 0..most {
            let now = State { u: &u, points, border: &border };
            let residual = self.correction.residual(now);
            let step = solve(&residual);
            let norm = step.iter().zip(&residual).map(|(d, r)| d * r).sum::<f64>().max(0.0).sqrt();
            if norm > STALLED * before {
                done.stalled = true;
                break;
            }
            before = norm;
            let mut next = self.correction.smooth(now);
            next.iter_mut().zip(&step).for_each(|(u, d)| *u += d);
            done.sizes.push(scan::largest(&step) / scan::largest(&next).max(f64::MIN_POSITIVE));
            u = next;
        }
        move_back(scene, &scene.states[state], &mut u);
        fill_images(scene, &mut u);
        (u, done)
    }

    /// Gives the result of a state the stresses of the fits, and its probes what these find where they are.
    pub(super) fn complete(&self, scene: &BodyScene, result: &mut BodyResult) {
        let border = self.border(scene, &scene.states[result.record.index]);
        let now = State { u: &result.record.u, points: scene.model.points(), border: &border };
        let probed = scene.probes.iter().map(|probe| {
            let [x, y, _] = probe.position?;
            self.correction.at([x, y], now)
        });
        result.probed = probed.collect();
        if let Some(recovered) = &mut result.recovered {
            for (point, Field { stress, .. }) in self.correction.fields(now) {
                (0..3).for_each(|k| recovered.stress[k][point] = stress[k]);
                let stress = [stress[0], stress[1], stress[2], 0.0, 0.0, 0.0];
                let across = scene.model.across_of(stress);
                let strain = scene.model.strains_of(stress, across);
                recovered.energy_density[point] = 0.5 * (0..3).map(|k| stress[k] * strain[k]).sum::<f64>();
                if let Some(own) = recovered.across.get_mut(point) {
                    *own = across;
                }
            }
            recovered.fill_images(scene);
        }
    }

    fn border(&self, scene: &BodyScene, state: &BodyState) -> Vec<[f64; 2]> {
        scene.limit.as_ref().map_or(Vec::new(), |limit| limit.known(state, self.correction.samples()))
    }
}

/// What a probe finds at its place of corrected displacements, by its number.
pub(super) fn read(scene: &BodyScene, result: &BodyResult, (k, probe): (usize, &BodyProbe)) -> Option<f64> {
    let Quantity::Field { field, .. } = &probe.quantity else { return None };
    let Field { displacement, stress } = (*result.probed.get(k)?)?;
    if let Some((component, _)) = scene.model.component(field.name()) {
        return displacement.get(component).copied();
    }
    let stress = [stress[0], stress[1], stress[2], 0.0, 0.0, 0.0];
    of_stress(field.about().origin, Medium::of(scene), (0, stress), scene.model.across_of(stress))
}

/// The limit with the body that it is of.
fn parts(scene: &BodyScene) -> Option<(&LocalLimit, &dyn PlaneModel, &peristat_assembly::body::Outline)> {
    Some((scene.limit.as_deref()?, scene.model.as_plane()?, scene.outline()?))
}

/// Moves a body as a rigid one until its points are where they are held.
fn move_back(scene: &BodyScene, state: &BodyState, u: &mut [f64]) {
    let n = scene.model.points();
    let place = |point: usize| scene.model.place(point);
    let free = free_motions(scene);
    let motion = |k: usize, point: usize| match k {
        0 => [1.0, 0.0],
        1 => [0.0, 1.0],
        _ => [-place(point)[1], place(point)[0]],
    };
    let equations = &scene.equations;
    let works = DMatrix::from_fn(equations.len(), free.len(), |r, c| {
        equations[r].terms.iter().map(|(of, share)| share * motion(free[c], of.point)[of.component]).sum()
    });
    let off = DVector::from_iterator(
        equations.len(),
        equations.iter().map(|equation| {
            let is = equation.terms.iter().map(|(of, share)| share * u[of.component * n + of.point]);
            state.motion_factor * equation.value - is.sum::<f64>()
        }),
    );
    let svd = works.svd(true, true);
    let least = NONE * svd.singular_values.max();
    let Ok(shares) = svd.solve(&off, least) else { return };
    for (share, k) in shares.iter().zip(free) {
        for point in 0..n {
            let by = motion(k, point);
            (0..2).for_each(|c| u[c * n + point] += share * by[c]);
        }
    }
}

/// Translations along x and y and the rotation, those that lines of symmetry leave.
fn free_motions(scene: &BodyScene) -> Vec<usize> {
    let lines = scene.model.lattice().map_or([[None; 2]; 3], |(_, mirrors)| mirrors.lines);
    let is_free = |axis: usize| lines[axis] == [None; 2];
    let free = [is_free(0), is_free(1), is_free(0) && is_free(1)];
    (0..3).filter(|k| free[*k]).collect()
}

/// Gives images the displacements of their points.
fn fill_images(scene: &BodyScene, u: &mut [f64]) {
    let (n, Some((lattice, mirrors))) = (scene.model.points(), scene.model.lattice()) else { return };
    for &ghost in scene.model.ghosts() {
        let (cell, signs) = mirrors.image(lattice.cell(ghost as usize));
        let Some(real) = lattice.number(cell) else { continue };
        (0..2).for_each(|c| u[c * n + ghost as usize] = signs[c] * u[c * n + real]);
    }
}
