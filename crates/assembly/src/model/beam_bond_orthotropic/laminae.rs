//! Laminae: parts of a body whose fibres run at other angles, and the forces of loads on these.

use super::{BeamBondOrthotropic, OrthotropicParameters};
use crate::bonds::Mat;
use crate::model::{BodyModel, Model, Points};
use nalgebra::{Matrix3, Vector3};

/// The laminae of a body beside that of its parameters.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Laminae {
    /// Angles of their fibres from x, counter-clockwise, rad.
    pub angles: Vec<f64>,
    /// The lamina of every point: zero is that of the parameters, others follow from one on. None where all points are of that.
    pub of: Vec<u8>,
}

/// What a lamina has in uniform states.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moduli {
    /// Pa, from strains to stresses along x and y.
    pub(super) stiffness: Mat<3, 3>,
    /// 1/Pa, from stresses to strains.
    pub(super) compliance: Mat<3, 3>,
}

impl Moduli {
    /// Those of the parameters, and of laminae with other angles.
    pub(super) fn of(parameters: &OrthotropicParameters, angles: &[f64]) -> Vec<Self> {
        let at = |&angle: &f64| Self {
            stiffness: parameters.material.stiffness_at(angle),
            compliance: parameters.material.compliance_at(angle),
        };
        [parameters.fibre_angle].iter().chain(angles).map(at).collect()
    }
}

impl Laminae {
    /// The most angles beside that of the parameters.
    pub const MOST: usize = 64;

    /// # Panics
    /// There are more than [`MOST`](Self::MOST) angles, a point is of a lamina that is not there, or there is not one for every point.
    pub(super) fn check(&self, points: usize) {
        assert!(self.angles.len() <= Self::MOST, "not too many other angles");
        assert!(self.of.is_empty() || self.of.len() == points, "one lamina per point");
        assert!(self.of.iter().all(|own| usize::from(*own) <= self.angles.len()), "a lamina of the body");
    }
}

/// Of forces on bodies that are all of one lamina, in order, those on the points that are of it; images leave theirs to their points.
/// Where laminae meet they leave out a little of what keeps each of these in balance: points whose forces are not those of the first
/// lamina share what the resultants lack.
pub(super) fn by_lamina(
    model: &BeamBondOrthotropic,
    lamina: &dyn Fn(usize) -> usize,
    mut all: Vec<Vec<f64>>,
) -> Vec<f64> {
    let n = model.points();
    let is_mirror = all.iter_mut().fold([false; 2], |_, force| fold(model, force));
    let mut own: Vec<f64> = (0..3 * n).map(|unknown| all[lamina(unknown % n)][unknown]).collect();
    let is_other = |point: usize| (0..3).any(|c| own[c * n + point] != all[0][c * n + point]);
    let others: Vec<usize> = (0..n).filter(|point| is_other(*point)).collect();
    let centre = model.position(n / 2);
    // What mirrors hold has no resultant.
    let is_held = [is_mirror[0], is_mirror[1], is_mirror != [false; 2]];
    let motion = |kind: usize, point: usize| match is_held[kind] {
        true => [0.0; 3],
        false => model.rigid_motion(kind, point, centre),
    };
    let work = |kind: usize, point: usize, force: &dyn Fn(usize) -> f64| -> f64 {
        motion(kind, point).into_iter().enumerate().map(|(c, by)| by * force(c)).sum()
    };
    let lacks = Vector3::from_fn(|kind, _| {
        let lack = |&point: &usize| work(kind, point, &|c| all[0][c * n + point] - own[c * n + point]);
        others.iter().map(lack).sum::<f64>()
    });
    let matrix = Matrix3::from_fn(|a, b| {
        let product = |&point: &usize| work(a, point, &|c| motion(b, point)[c]);
        let held = if a == b && is_held[a] { 1.0 } else { 0.0 };
        held + others.iter().map(product).sum::<f64>()
    });
    let Some(parts) = matrix.cholesky().map(|matrix| matrix.solve(&lacks)) else { return own };
    for &point in &others {
        for kind in 0..3 {
            let by = motion(kind, point);
            (0..3).for_each(|c| own[c * n + point] += parts[kind] * by[c]);
        }
    }
    own
}

/// Gives points the forces on their images; whether lines across x and across y mirror them.
fn fold(model: &BeamBondOrthotropic, force: &mut [f64]) -> [bool; 2] {
    let n = model.points();
    let Some((lattice, mirrors)) = model.lattice() else { return [false; 2] };
    let mut is_mirror = [false; 2];
    for &ghost in model.ghosts() {
        let (cell, [x, y, _]) = mirrors.image(lattice.cell(ghost as usize));
        let Some(real) = lattice.number(cell) else { continue };
        is_mirror = [is_mirror[0] || x < 0.0, is_mirror[1] || y < 0.0];
        for (c, sign) in [x, y, x * y].into_iter().enumerate() {
            let own = std::mem::take(&mut force[c * n + ghost as usize]);
            force[c * n + real] += sign * own;
        }
    }
    is_mirror
}
