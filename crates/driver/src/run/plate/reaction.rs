//! What supports and lines of symmetry do to a plate.

use crate::scene::PlateScene;
use crate::scene::plate::PlateSupport;
use peristat_assembly::model::plate_bending::{PHI_X, PHI_Y, W};
use peristat_assembly::sum::Sum;
use serde::{Deserialize, Serialize};

/// What a support does to a plate.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PlateReaction {
    /// What is held, such as ``the region `left` ``.
    pub place: String,
    /// Force along w.
    pub force: f64,
    /// Moment that does work with phi_x, the sum over its points.
    pub moment_x: f64,
    /// Moment that does work with phi_y.
    pub moment_y: f64,
}

/// Forces of supports from the multipliers of all equations and the unknowns.
pub(super) fn of_supports(scene: &PlateScene, multipliers: &[f64], u: &[f64]) -> Vec<PlateReaction> {
    let n = scene.plate.nodes().points();
    let of = |support: &PlateSupport| {
        let mut sums = [0; 3].map(|_| Sum::default());
        for k in support.equations.clone() {
            let terms = &scene.equations[k].terms;
            terms.iter().for_each(|(unknown, share)| sums[unknown.component].add(share * multipliers[k]));
        }
        for spring in &scene.springs[support.springs.clone()] {
            spring.forces(n, u).into_iter().for_each(|(unknown, force)| sums[unknown / n].add(-force));
        }
        let [force, moment_x, moment_y] = [W, PHI_X, PHI_Y].map(|component| sums[component].total());
        PlateReaction { place: support.name.clone(), force, moment_x, moment_y }
    };
    scene.supports.iter().map(of).collect()
}
