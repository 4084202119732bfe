//! Loads of a body in the plane as forces and stresses on its points.

use super::super::{Resultant, states};
use super::ground::Ground;
use super::model::Recipe;
use super::stress_field::StressField;
use super::symmetry::Symmetry;
use super::traction;
use super::{Held, pressure, root};
use super::{asked, body_force, point_load};
use crate::case::Load;
use crate::diagnostic::{Faults, JsonPath};
use crate::input::gmsh::Curve;
use crate::model::Material;
use peristat_assembly::model::plane::PlaneModel;

/// The loads of one load case.
#[derive(Clone, Debug, Default)]
pub struct PlaneLoads {
    /// Forces on points of the model, N.
    pub(super) forces: Vec<(u32, [f64; 2])>,
    /// The same of tractions that act through the border, by numbers of the model from the start.
    pub(super) through_border: Vec<(u32, [f64; 2])>,
    /// Moments on points of the model, N m; where points move across the plane, forces along that, N.
    pub(super) across: Vec<(u32, f64)>,
    /// Force on every point per volume, N/m³.
    pub(super) density: [f64; 2],
    /// Force on every point along x per volume and per x, N/m⁴.
    pub(super) spin: f64,
    /// Stresses that act by the rows of the bonds.
    pub(super) stresses: Vec<StressField>,
    /// Whether these carry the forces through joined sides.
    pub(super) carry_ends: bool,
    /// Resultant as the case asks for it.
    pub(super) asked: Resultant,
    /// Along which axes stresses that are asked for nothing there go through a mirror.
    pub(super) inside: [bool; 2],
}

/// What the resolution of loads looks at.
pub(super) struct Context<'a> {
    pub(super) ground: &'a Ground<'a>,
    pub(super) symmetry: &'a Symmetry,
    pub(super) curves: &'a [Curve],
    pub(super) material: &'a dyn Material,
    pub(super) horizon: f64,
    pub(super) held: &'a [Held],
    /// Paths of cracks, images left out.
    pub(super) cracks: &'a [super::NamedCrack],
    /// What numbers the points of the body in the model.
    pub(super) recipe: &'a Recipe,
    /// The discretised body, if it can be made.
    pub(super) model: Option<&'a dyn PlaneModel>,
}

impl Context<'_> {
    /// Volume of a point of the body, m³.
    pub(super) fn volume(&self, point: u32) -> f64 {
        let body = self.ground.body;
        body.area(point as usize) * self.material.across(body.position(point as usize))
    }
}

/// All load cases, by numbers of the body.
pub(super) fn load_cases(context: &Context, faults: &mut Faults) -> Vec<PlaneLoads> {
    let resolve = |loads: &[Load], path: &JsonPath, faults: &mut Faults| {
        let mut resolved = PlaneLoads::default();
        let mut tractions = Vec::new();
        for (k, load) in loads.iter().enumerate() {
            let path = path.index(k);
            match load {
                Load::Point(load) => {
                    point_load::resolve(load, context, &path.key("point"), &mut resolved, faults)
                }
                Load::BodyForce(load) => {
                    body_force::resolve(load, context, &path.key("body_force"), &mut resolved, faults)
                }
                Load::Traction(load) => {
                    tractions.extend(traction::resolve(load, context, path.key("traction"), faults))
                }
                Load::Pressure(load) => {
                    pressure::resolve(load, context, &path.key("pressure"), &mut resolved, faults)
                }
                Load::Distributed(_) => {
                    faults
                        .error(path.key("distributed"), "`distributed` loads are for beams")
                        .hint("in the plane a force per area on an edge is a `traction`, one per volume a `body_force`");
                }
            }
        }
        tractions.iter().for_each(|t| resolved.asked.add_multiple(1.0, &asked::of_traction(t, context)));
        traction::add(&tractions, context, &mut resolved, faults);
        resolved
    };
    states::load_cases(context.ground.case, resolve, faults)
}

/// Whether supports prescribe a component of a point of the body.
pub(super) fn is_held(point: u32, component: usize, held: &[Held]) -> bool {
    held.iter().any(|h| {
        let direct = h.motions.iter().any(|m| m.0[component].abs() == 1.0);
        direct && h.points.binary_search(&point).is_ok()
    })
}

impl PlaneLoads {
    /// The same with the numbers that points have in the model.
    pub(super) fn numbered(mut self, number: &dyn Fn(u32) -> u32) -> Self {
        self.forces.iter_mut().for_each(|f| f.0 = number(f.0));
        self.forces.append(&mut self.through_border);
        self.across.iter_mut().for_each(|m| m.0 = number(m.0));
        self.stresses.iter_mut().for_each(|field| *field = field.numbered(number));
        self
    }

    /// The same with the forces through joined sides, on points of the model.
    pub(super) fn with_ends(mut self, forces: &[(u32, [f64; 2])]) -> Self {
        if !self.carry_ends {
            self.forces.extend(forces);
        }
        self
    }

    /// Whether nothing acts.
    pub fn is_zero(&self) -> bool {
        self.forces.is_empty()
            && self.through_border.is_empty()
            && self.across.is_empty()
            && self.density == [0.0; 2]
            && self.spin == 0.0
            && self.stresses.is_empty()
    }

    /// Adds the loads times a factor to `force`, N, the plane of x first, then that of y and, where points turn, that of
    /// moments per length by which rotations are multiplied, or that across the plane.
    pub fn add_to(&self, model: &dyn PlaneModel, factor: f64, force: &mut [f64]) {
        let n = model.points();
        for &(point, f) in &self.forces {
            (0..2).for_each(|c| force[c * n + point as usize] += factor * f[c]);
        }
        // A moment does its work on the rotation, the unknown is a multiple of that.
        let turning = model.scale(2);
        for &(point, value) in &self.across {
            force[2 * n + point as usize] += factor * value / turning;
        }
        if self.density != [0.0; 2] || self.spin != 0.0 {
            for point in 0..n {
                let volume = factor * model.volume(point);
                (0..2).for_each(|c| force[c * n + point] += volume * self.density[c]);
                if self.spin != 0.0 {
                    force[point] += volume * self.spin * model.place(point)[0];
                }
            }
        }
        self.stresses.iter().for_each(|field| field.add_to(model, factor, force));
    }
}

/// Sums of load cases that are solved, with no load among them that is missing.
pub(super) fn check_loaded(ground: &Ground, cases: &[PlaneLoads], moves: bool, faults: &mut Faults) {
    let case = ground.case;
    let stretched = case.periodic.iter().any(|p| p.force.is_some());
    if cases.iter().all(PlaneLoads::is_zero) && !moves && !stretched && !faults.has_errors() {
        let key = if case.load_cases.is_empty() { "loads" } else { "load_cases" };
        faults
            .warning(root(key), "nothing acts on the body: all results will be zero")
            .hint("give `loads`, or a support with a displacement that is not zero");
    }
}
