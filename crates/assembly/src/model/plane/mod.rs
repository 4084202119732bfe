//! What models of bodies in the plane share: bonds on a square lattice with images in lines of symmetry, what is done about
//! the bonds that points near edges lack, stresses and the loads that belong to them, critical stretches.

mod apart;
mod body;
mod bond;
mod breaking;
mod critical;
mod critical_along;
mod damage;
mod edges;
mod exceptions;
mod fields;
mod free;
mod interface;
mod mirrors;
mod mixture;
mod near;
mod neighbourhood;
mod parameters;
mod projection;
mod solvable;
mod terms;
#[cfg(test)]
pub(super) mod through_border;
pub mod toughness;
mod uneven;

pub use apart::thin_points;
pub use bond::{LatticeBond, PlaneBond};
pub use critical::{CriticalStretch, ToughMaterials, Toughness};
pub use edges::{BorderShares, FARTHEST, has_border};
pub use fields::PlaneFields;
pub use mirrors::Mirrors;
pub use parameters::{Calibration, Edges};
pub use solvable::{AsSolvable, BreakingModel, SofteningModel, Solvable};

pub(super) use apart::{Apart, apart_bonds};
pub(super) use body::{Kind, LatticeBody};
pub(super) use breaking::{remove_spanning, spanning};
pub(super) use critical_along::{CriticalAlong, PartOfPath};
pub(super) use edges::{
    By, Cells, End, Nodes, Path, Run, around, border_shares, can_end, energy_factor, for_each_part, is_cut,
    strain_rows, volume_factor,
};
pub(super) use exceptions::{grid, halved};
pub(super) use mixture::Mixture;
pub(super) use near::{at, near_points};
pub(super) use neighbourhood::{Neighbourhood, direction_product, half_offsets, is_up, is_within, length};
pub(super) use projection::project;
pub(super) use uneven::{MixedBonds, UnevenBonds};

use crate::body::{Cell, SquareLattice};
use crate::bonds::{BondGeometry, Mat, Point};
use crate::model::solid::TENSOR;
use crate::model::{BodyModel, Component, Points, RigidMotion};
use rayon::prelude::*;

/// Component of the displacement along x.
pub const UX: usize = 0;
/// Component of the displacement along y.
pub const UY: usize = 1;

/// The unknowns of a point that moves in the plane.
pub(super) const COMPONENTS: [Component; 2] =
    [Component::displacement("ux", 0), Component::displacement("uy", 1)];

/// The rigid motions of a body in the plane.
pub(super) const RIGID_MOTIONS: [RigidMotion; 3] = [
    RigidMotion::translation("translation along x", "move along {direction}"),
    RigidMotion::translation("translation along y", "move along {direction}"),
    RigidMotion::rotation("rotation about z", "turn about {centre}"),
];

/// Displacements `[ux, uy]` of a place and the rotation under a unit motion of these.
pub(super) fn rigid_motion(kind: usize, [x, y, _]: Point, centre: Point) -> [f64; 3] {
    match kind {
        0 => [1.0, 0.0, 0.0],
        1 => [0.0, 1.0, 0.0],
        _ => [centre[1] - y, x - centre[0], 1.0],
    }
}

/// Relative error of weights that make a lattice exact, which are found by solving; the largest that the stress suite sees
/// in the solution of a square is 9e-14.
pub(super) const CALIBRATION: f64 = 2e-14;

/// Relative error of a body of so many axes with such weights: they bend it, and a long one the more, by its length over its width.
pub(super) fn calibration_error<P: Points + ?Sized>(model: &P, axes: usize) -> f64 {
    let places = || (0..model.points()).map(|p| model.position(p));
    let side = |k: usize| {
        let [low, high] = [f64::min, f64::max].map(|of| places().map(|at| at[k]).reduce(of).unwrap_or(0.0));
        high - low
    };
    let sides = || (0..axes).map(side);
    let (short, long) = (sides().fold(f64::INFINITY, f64::min), sides().fold(0.0, f64::max));
    // A single row or layer does not bend: its bonds lie in a line or a plane.
    if short > 0.0 { CALIBRATION * long / short } else { CALIBRATION }
}

/// Strains of stresses of a body in the plane, the first three of six.
pub(super) fn in_plane(
    model: &dyn PlaneModel,
    [x, y, shear, ..]: [f64; TENSOR],
    across: f64,
) -> [f64; TENSOR] {
    let [x, y, shear] = model.strain_with([x, y, shear], across);
    [x, y, shear, 0.0, 0.0, 0.0]
}

/// Finds the cuts on a lattice: indices into the offsets, and lower points.
pub type FindCuts<'a> = dyn Fn(&SquareLattice, &[Cell]) -> Vec<(usize, usize)> + 'a;

/// A bond of a lattice at an offset.
fn geometry(lattice: &SquareLattice, step: Cell) -> BondGeometry {
    BondGeometry { xi: lattice.vector(step) }
}

/// A body in the plane with its bonds, whatever they are. Its strains and stresses are `[xx, yy, xy]` in all that is said here,
/// but for points that move across the plane.
pub trait PlaneModel: BodyModel {
    /// Thickness, m.
    fn thickness(&self) -> f64;

    /// Length of the body across the plane at x, m: the thickness, or the way around an axis at x = 0.
    fn length_across(&self, _x: f64) -> f64 {
        self.thickness()
    }

    /// Stiffness of the material, Pa, from strains `[ε_xx, ε_yy, γ_xy]` to stresses `[σ_xx, σ_yy, σ_xy]`.
    fn stiffness(&self) -> Mat<3, 3>;

    /// The same of a point, whose material may be another.
    fn stiffness_at(&self, _point: usize) -> Mat<3, 3> {
        self.stiffness()
    }

    /// Strains of stresses: its inverse.
    fn strain_of(&self, stress: [f64; 3]) -> [f64; 3];

    /// Strains of stresses in the plane and the one across it; where that one follows from the others it is not read.
    fn strain_with(&self, stress: [f64; 3], _across: f64) -> [f64; 3] {
        self.strain_of(stress)
    }

    /// The same of a point, whose material may be another.
    fn strain_at(&self, _point: usize, stress: [f64; 3], across: f64) -> [f64; 3] {
        self.strain_with(stress, across)
    }

    /// Stress across the plane that belongs to stresses in it.
    fn stress_across(&self, _stress: [f64; 3]) -> f64 {
        0.0
    }

    /// Stresses and energy densities of a state.
    fn fields(&self, u: &[f64]) -> PlaneFields;

    /// Adds the forces `Σ_k t_k·V_k σ_k` per unit strain, with the strains `t` in three planes: the adjoint of the stresses.
    /// `points` are those where t can be other than zero, none for all; images of real points have no part in it, but get
    /// forces from bonds to them.
    fn add_strain_work(&self, t: &mut [f64], points: Option<&[usize]>, force: &mut [f64]);

    /// Adds the forces that keep the body in strains `t` that its points have without stress; the rest is as there.
    fn add_free_work(&self, t: &mut [f64], points: Option<&[usize]>, force: &mut [f64]) {
        self.add_strain_work(t, points, force);
    }

    /// Stresses of points, three planes, that strains `t` without stress have beyond those of the points' own, beside interfaces of
    /// materials; none where there are none.
    fn free_stress_beyond(&self, _t: &[f64]) -> Option<[Vec<f64>; 3]> {
        None
    }

    /// Energy of the body where nothing moves and its points would stretch by the strains `t`, three planes, without stress: what
    /// [`add_free_work`](Self::add_free_work) makes of these lacks that of the state. None where its elements are not known to
    /// be free at such strains.
    fn energy_at_rest(&self, _t: &[f64]) -> Option<f64> {
        None
    }

    /// Strains `[ε_xx, ε_yy, γ_xy]` of every point.
    fn strain(&self, stress: &[Vec<f64>; 3]) -> [Vec<f64>; 3] {
        let mut strain = stress.clone();
        let [xx, yy, xy] = &mut strain;
        let points = xx.par_iter_mut().zip(yy.par_iter_mut()).zip(xy.par_iter_mut()).with_min_len(4096);
        let own = points.enumerate();
        own.for_each(|(p, ((x, y), s))| {
            let stress = [*x, *y, *s];
            [*x, *y, *s] = self.strain_at(p, stress, self.stress_across(stress));
        });
        strain
    }

    /// Adds the forces `Σ_k V_k S_k : E_k` of a stress `[S_xx, S_yy, S_xy]`, Pa, with E the strain of a point: with one
    /// stress for all points and the tractions that it has at the edges, the linear displacement that belongs to it is the
    /// solution to rounding. The forces have no resultant: `V div S` has to be added by the caller, in the plane where S
    /// varies, in a body of revolution, where the stress across is S_xx, also `V S_xy/x` along the axis. `points` are those
    /// where S can be other than zero, none for all. S is asked for by the number of a point and its position.
    fn add_stress_load(
        &self,
        points: Option<&[usize]>,
        stress_at: &(dyn Fn(usize, [f64; 2]) -> [f64; 3] + Sync),
        force: &mut [f64],
    ) {
        add_stress_work(self, points, stress_at, force);
    }
}

/// Adds the forces of [`PlaneModel::add_stress_load`] by the strains of the points.
pub(super) fn add_stress_work<M: PlaneModel + ?Sized>(
    model: &M,
    points: Option<&[usize]>,
    stress_at: &(dyn Fn(usize, [f64; 2]) -> [f64; 3] + Sync),
    force: &mut [f64],
) {
    let n = model.points();
    // V_k S_k : E_k = (C⁻¹ S_k)·(V_k σ_k)
    let mut t = vec![0.0; 3 * n];
    let mut enter = |point: usize, position: [f64; 2]| {
        let stress = stress_at(point, position);
        // The stress across a body of revolution is that along x.
        let strain = model.strain_at(point, stress, stress[0]);
        (0..3).for_each(|q| t[q * n + point] = strain[q]);
    };
    match (points, model.lattice()) {
        (Some(points), _) => points.iter().for_each(|&p| enter(p, model.place(p))),
        // Run by run: to find the cell of a point takes a search.
        (None, Some((lattice, _))) => {
            for run in lattice.runs() {
                for column in run.columns.clone() {
                    enter(run.number(column), lattice.place_of(run.cell(column)));
                }
            }
        }
        (None, None) => (0..n).for_each(|p| enter(p, model.place(p))),
    }
    model.add_strain_work(&mut t, points, force);
}
