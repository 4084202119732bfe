//! Loads of a body in the plane as forces and stresses on its points.

use super::super::words::tidy;
use super::super::{Resultant, states};
use super::bonds::PlaneBonds;
use super::ground::{Ground, PLACE, Spot};
use super::interpolate::{Interpolation, Weights};
use super::model::Recipe;
use super::stress_field::StressField;
use super::symmetry::Symmetry;
use super::traction;
use super::{Held, root, shell};
use super::{asked, lump};
use crate::case::{BodyForce, Load, PointLoad};
use crate::diagnostic::{Faults, JsonPath};
use crate::input::gmsh::Curve;
use peristat_assembly::body::{Crack, PlaneBody};
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
    pub(super) bonds: &'a PlaneBonds,
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
        body.area(point as usize) * self.bonds.across(body.position(point as usize))
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
                Load::Point(load) => point(load, context, &path.key("point"), &mut resolved, faults),
                Load::BodyForce(load) => {
                    body_force(load, context, &path.key("body_force"), &mut resolved, faults)
                }
                Load::Traction(load) => {
                    tractions.extend(traction::resolve(load, context, path.key("traction"), faults))
                }
                Load::Pressure(load) => {
                    shell::pressure(load, context, &path.key("pressure"), &mut resolved, faults)
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

fn point(load: &PointLoad, context: &Context, path: &JsonPath, to: &mut PlaneLoads, faults: &mut Faults) {
    let (points_turn, deflects) = (context.bonds.has("phi"), context.bonds.has("w"));
    let foreign = [
        ("force", load.force != 0.0 && !deflects, "use `force_x` and `force_y`"),
        ("axial", load.axial != 0.0, "use `force_x` and `force_y`"),
        (
            "moment",
            load.moment != 0.0 && !points_turn,
            "points do not turn: use two forces, or a `linear` traction on an edge",
        ),
        ("spread", load.spread, "give a region as the place to spread a force"),
    ];
    for (key, _, hint) in foreign.iter().filter(|f| f.1) {
        faults.error(path.key(*key), format!("`{key}` is for beams")).hint(*hint);
    }
    let force = [load.force_x, load.force_y];
    let across = if deflects { load.force } else { load.moment };
    if force == [0.0; 2] && across == 0.0 && !foreign.iter().any(|f| f.1) {
        let keys = match (points_turn, deflects) {
            (true, _) => "give `force_x`, `force_y` or `moment`",
            (_, true) => "give `force_x`, `force_y` or `force`",
            _ => "give `force_x` or `force_y`",
        };
        faults.error(path.clone(), "this load is zero").hint(keys);
    }
    let at = path.key("at");
    if load.at.inward.is_some() {
        faults.error(at.key("inward"), "`inward` is for probes").hint(PLACE);
    }
    super::supports::not_mirrored(load.at.region.as_deref(), &at.key("region"), context.symmetry, faults);
    let Some(spot) = context.ground.spot(&load.at, &at, "the load", faults) else { return };
    let acts = force != [0.0; 2];
    let is_fixed = |c: usize| force[c] == 0.0 || spot.points.iter().all(|p| is_held(*p, c, context.held));
    let is_fixed = acts && (0..2).all(is_fixed);
    let shares = shares(load, &spot, is_fixed, context);
    let at_place = place(load, &shares, context, &at, faults);
    context.bonds.add_force(&mut to.asked, force, at_place);
    if points_turn {
        to.asked.add_moment(load.moment);
    }
    if is_fixed {
        faults
            .warning(at, format!("supports hold {} against this force: it deforms nothing", spot.words))
            .hint("it only adds to the reaction of the support");
    }
    if acts {
        to.forces.extend(shares.iter().map(|&(p, share)| (p, force.map(|f| share * f))));
    }
    if across != 0.0 {
        to.across.extend(shares.iter().map(|&(p, share)| (p, share * across)));
    }
}

/// Where a force acts: at the position that is given, or in the middle of a region. A doubt where no points around the position
/// can share it.
fn place(
    load: &PointLoad,
    shares: &Weights,
    context: &Context,
    path: &JsonPath,
    faults: &mut Faults,
) -> [f64; 2] {
    let body = context.ground.body;
    let middle = [0, 1].map(|k| shares.iter().map(|&(p, s)| s * body.position(p as usize)[k]).sum::<f64>());
    let (Some(x), Some(y)) = (load.at.x, load.at.y) else { return middle };
    let moved = (x - middle[0]).hypot(y - middle[1]);
    if moved < 1e-9 * body.spacing() {
        return [x, y];
    }
    if moved > 1e-3 * body.spacing() {
        let [a, b] = middle.map(tidy);
        faults
            .warning(path.clone(), format!("the load acts on the point at ({a}, {b})"))
            .hint("give the position of that point, or a region");
    }
    middle
}

/// Points and their shares of a force at a place: those of a region alike; at a position those with which values are
/// interpolated there, so that the force has its moment. A point that is held takes it alone.
fn shares(load: &PointLoad, spot: &Spot, is_fixed: bool, context: &Context) -> Weights {
    match (load.at.x, load.at.y, &spot.points[..]) {
        (Some(x), Some(y), &[nearest]) if !is_fixed => {
            let cracks: Vec<Crack> = context.cracks.iter().map(|c| c.crack.clone()).collect();
            let interpolation = Interpolation { body: context.ground.body, cracks: &cracks, reach: 1 };
            interpolation.at([x, y], nearest)
        }
        (.., points) => points.iter().map(|&p| (p, 1.0 / points.len() as f64)).collect(),
    }
}

/// Whether supports prescribe a component of a point of the body.
pub(super) fn is_held(point: u32, component: usize, held: &[Held]) -> bool {
    held.iter().any(|h| {
        let direct = h.motions.iter().any(|m| m.0[component].abs() == 1.0);
        direct && h.points.binary_search(&point).is_ok()
    })
}

fn body_force(
    load: &BodyForce,
    context: &Context,
    path: &JsonPath,
    to: &mut PlaneLoads,
    faults: &mut Faults,
) {
    if let Some(value) = load.spin {
        return spin(value, load, context, path, to, faults);
    }
    let (value, is_total) = match (load.density, load.total) {
        (Some(density), None) => (density, false),
        (None, Some(total)) => (total, true),
        (None, None) => {
            faults.error(path.clone(), "neither `density` nor `total` nor `spin` is given").hint(
                "`density` is a force per volume, such as that of gravity; `total` the force on all points together",
            );
            return;
        }
        (Some(_), Some(_)) => {
            faults
                .error(path.key("total"), "`density` and `total` are both given")
                .hint("remove one of them");
            return;
        }
    };
    if value == [0.0; 2] {
        faults.error(path.clone(), "this load is zero");
    }
    let points = match &load.region {
        Some(name) => match context.ground.region(name, &path.key("region"), faults) {
            Some(points) => Some(points),
            None => return,
        },
        None => None,
    };
    let Some(points) = points else { return on_body(value, is_total, context, to) };
    let volume: f64 = points.iter().map(|&p| context.volume(p)).sum();
    let density = if is_total { value.map(|f| f / volume) } else { value };
    for p in points {
        let force = density.map(|b| b * context.volume(p));
        context.bonds.add_force(&mut to.asked, force, context.ground.body.position(p as usize));
        to.forces.push((p, force));
    }
}

/// A force on the whole body, per volume or in all. Where cells do not fill the body their forces are those of what they have,
/// with what they lack of force and moment shared by all.
fn on_body(value: [f64; 2], is_total: bool, context: &Context, to: &mut PlaneLoads) {
    let body = context.ground.body;
    let unit = asked::of_body([1.0, 0.0], context).sizes()[0];
    let density = if is_total { value.map(|f| f / unit) } else { value };
    let asked = asked::of_body(density, context);
    to.asked.add_multiple(1.0, &asked);
    let force = |p: u32| (p, density.map(|b| b * context.volume(p)));
    let mut forces: lump::Forces = (0..body.points() as u32).map(force).collect();
    let mut missing = asked;
    let at = |p: u32| body.position(p as usize);
    forces.iter().for_each(|&(p, f)| context.bonds.add_force(&mut missing, f.map(|f| -f), at(p)));
    let is_whole = matches!(body, PlaneBody::Lattice(lattice) if lattice.cut_cells().is_empty());
    let lacks = missing.force().into_iter().chain([missing.moment() * asked.sizes()[0] / asked.sizes()[1]]);
    if is_whole && lacks.fold(0.0, |a: f64, f| a.max(f.abs())) <= 1e-12 * asked.sizes()[0] {
        (0..2).for_each(|k| to.density[k] += density[k]);
        return;
    }
    if context.symmetry.mirrors.is_none() && !context.bonds.is_revolved() {
        lump::add_resultant(&mut forces, &missing, context);
    } else {
        // A mirror takes moments, and rings have none.
        let found: f64 = forces.iter().map(|&(p, _)| context.volume(p)).sum();
        forces.iter_mut().for_each(|f| f.1 = f.1.map(|f| unit / found * f));
    }
    to.forces.extend(forces);
}

/// The inertia of a body that turns about its axis.
fn spin(
    value: f64,
    load: &BodyForce,
    context: &Context,
    path: &JsonPath,
    to: &mut PlaneLoads,
    faults: &mut Faults,
) {
    if !context.bonds.is_revolved() {
        faults
            .error(path.key("spin"), "`spin` is for bodies of revolution, which have an axis")
            .hint("use the model `axisymmetric`");
        return;
    }
    if load.density.is_some() || load.total.is_some() {
        faults
            .error(path.key("spin"), "`spin` stands beside another body force")
            .hint("give each a `body_force` of its own");
        return;
    }
    if value == 0.0 {
        faults.error(path.clone(), "this load is zero");
    }
    match &load.region {
        None => to.spin += value,
        Some(name) => {
            let points = context.ground.region(name, &path.key("region"), faults).unwrap_or_default();
            let radius = |p: u32| context.ground.body.position(p as usize)[0];
            let force = |&p: &u32| (p, [value * radius(p) * context.volume(p), 0.0]);
            to.forces.extend(points.iter().map(force));
        }
    }
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
