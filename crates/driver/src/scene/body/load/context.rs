//! What loads are resolved on.

use crate::case::{Amount, Amounts, Vector};
use crate::diagnostic::{Faults, JsonPath};
use crate::input::gmsh::Curve;
use crate::model::Material;
use crate::scene::body::hold::supports::HeldSupport;
use crate::scene::body::site::boundary::Stretch;
use crate::scene::body::site::ground::Ground;
use crate::scene::body::site::model_inputs::ModelInputs;
use crate::scene::body::site::symmetry::Symmetry;
use crate::scene::prescribed::{Along, Prescribed};
use peristat_assembly::model::BodyModel;

/// What the resolution of loads looks at.
#[derive(Clone, Copy)]
pub(crate) struct LoadContext<'a> {
    pub(crate) ground: &'a Ground<'a>,
    pub(crate) symmetry: &'a Symmetry,
    pub(crate) curves: &'a [Curve],
    pub(crate) material: &'a dyn Material,
    pub(crate) horizon: f64,
    pub(crate) held: &'a [HeldSupport],
    /// Paths of cracks, images left out.
    pub(crate) cracks: &'a [crate::scene::body::site::cracks::NamedCrack],
    /// What numbers the points of the body in the model.
    pub(crate) inputs: &'a ModelInputs,
    /// The discretised body, if it can be made.
    pub(crate) model: Option<&'a dyn BodyModel>,
    /// The load factor of the step whose loads these are, where their formulas know it: they may be zero there.
    pub(crate) factor: Option<f64>,
}

impl LoadContext<'_> {
    /// Volume of a point of the body, m³.
    pub(crate) fn volume(&self, point: u32) -> f64 {
        let body = self.ground.body;
        let measure = body.measure(point as usize);
        if body.is_solid() { measure } else { measure * self.material.across(body.place(point as usize)) }
    }

    /// The numbers of a force by `key`, along x, y and z; none where their count is not that of the axes along which points move, or
    /// where they act along others.
    pub(crate) fn force(
        &self,
        given: Vector,
        key: &str,
        path: &JsonPath,
        faults: &mut Faults,
    ) -> Option<[f64; 3]> {
        let (force, count) = given.parts();
        let moves = ["ux", "uy", "uz"].map(|name| self.material.has(name));
        let moves = [moves[0], moves[1], moves[2] || self.material.has("w")];
        // What acts on a shell across its surface may be left out.
        let needed = if moves[2] { 3 } else { 2 };
        let is_shell = moves == [true; 3] && self.material.has("w");
        if count != needed && !(is_shell && count == 2) {
            let on = match moves {
                [_, _, false] => "forces in the plane have 2, along x and y",
                [true, ..] => "forces on this body have 3, along x, y and z",
                _ => "forces across the plane have 3, along x, y and z",
            };
            let s = if count == 1 { "" } else { "s" };
            faults.error(path.clone(), format!("`{key}` has {count} number{s}, and {on}"));
            return None;
        }
        let Some(beside) = (0..3).find(|&axis| force[axis] != 0.0 && !moves[axis]) else {
            return Some(force);
        };
        let name = ["x", "y", "z"][beside];
        faults
            .error(path.index(beside), format!("points of this body do not move along {name}"))
            .hint("give a zero there");
        None
    }

    /// What is given along x, y and z by `key`, as [`force`](Self::force) takes it, numbers or formulas.
    pub(crate) fn along(
        &self,
        given: &Amounts,
        key: &str,
        path: &JsonPath,
        faults: &mut Faults,
    ) -> Option<Along> {
        // Where a formula acts, something does.
        let numbers: Vec<f64> = given.0.iter().map(|amount| amount.number().unwrap_or(1.0)).collect();
        self.force(Vector::from(&numbers[..]), key, path, faults)?;
        let mut along = [const { Prescribed::Number(0.0) }; 3];
        for (k, (own, amount)) in along.iter_mut().zip(&given.0).enumerate() {
            *own = self.prescribed(amount, &path.index(k), faults)?;
        }
        Some(along)
    }

    /// What is given at a place by a number or a formula.
    pub(crate) fn prescribed(
        &self,
        given: &Amount,
        path: &JsonPath,
        faults: &mut Faults,
    ) -> Option<Prescribed> {
        Prescribed::new(given, (self.ground.body.axes(), self.factor), path, faults)
    }

    /// Area of stretches of a border, m².
    pub(crate) fn area(&self, stretches: &[Stretch]) -> f64 {
        stretches.iter().flat_map(Stretch::samples).map(|s| s.length * self.material.across(s.at)).sum()
    }

    /// What the divergence of a stress along the axis of a body of revolution has beside that in the plane: `S_xy/x`, N/m³.
    pub(crate) fn around_axis(&self, [_, _, shear]: [f64; 3], [x, _]: [f64; 2]) -> f64 {
        if self.material.surface().axis().is_some() { shear / x } else { 0.0 }
    }
}

/// Whether supports prescribe a component of a point of the body.
pub(crate) fn is_held(point: u32, component: usize, held: &[HeldSupport]) -> bool {
    held.iter().any(|h| {
        let direct = h.motions.iter().any(|m| m.2 != "phi" && m.0[component].abs() == 1.0);
        direct && h.points.binary_search(&point).is_ok()
    })
}
