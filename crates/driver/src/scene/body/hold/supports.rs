//! Supports of a body.

use super::held_border::{self, Piece};
use super::held_edge::{EdgeShares, HeldEdge};
use super::held_points::HeldPoints;
use super::{support_keys, support_parts};
use crate::case::Support;
use crate::diagnostic::{Faults, JsonPath, root};
use crate::model::{Material, Surface};
use crate::scene::body::site::boundary::{self, Stretch};
use crate::scene::body::site::ground::{Ground, NamedPoints};
use crate::scene::body::site::model_inputs::ModelInputs;
use crate::scene::body::site::place_of_point;
use crate::scene::body::site::symmetry::Symmetry;
use crate::scene::prescribed::{Motion, Prescribed};
use peristat_assembly::body::{PointBody, Wall};
use peristat_assembly::model::BodyModel;
use peristat_assembly::stiffness::Spring;

/// A support, resolved, with what it holds by numbers of the body.
#[derive(Clone, Debug)]
pub(crate) struct HeldSupport {
    /// What the user calls the place.
    pub(crate) name: String,
    /// Where it stands in the case.
    pub(crate) path: JsonPath,
    /// Its points.
    pub(crate) points: Vec<u32>,
    /// How an edge is held on its line.
    edge: Option<HeldEdge>,
    /// With an edge, the points behind each point; none where the point itself is held.
    chains: Vec<Vec<u32>>,
    /// Stretches of the border that it holds, if it holds one.
    border: Vec<Stretch>,
    /// Directions, or the rotation or the displacement across the plane as the third component, with what is prescribed and
    /// their keys.
    pub(crate) motions: Vec<([f64; 3], Motion, &'static str)>,
    /// Axes and total stiffnesses of springs.
    pub(crate) springs: Vec<(usize, f64)>,
}

/// What holds a body of revolution.
const REVOLVED_EXAMPLE: &str = r#"a body of revolution can move along its axis alone: { "at": { "region": "bottom" }, "uy": 0.0 } holds it"#;

/// A support that gives no motion of a line or frame.
const EXAMPLE: &str =
    r#"a clamped edge is { "at": { "region": "left" }, "ux": 0.0, "uy": 0.0 }, a roller gives one of them"#;

/// What holds a solid.
const SOLID_EXAMPLE: &str =
    r#"a clamped face is { "at": { "region": "left" }, "ux": 0.0, "uy": 0.0, "uz": 0.0 }"#;

/// Supports of the case.
pub(crate) fn held(
    ground: &Ground,
    symmetry: &Symmetry,
    material: &dyn Material,
    faults: &mut Faults,
) -> Vec<HeldSupport> {
    let case = ground.case;
    if case.supports.is_empty() && case.rigid.is_empty() && case.symmetry.is_empty() {
        let hint = match material.surface() {
            Surface::Section => REVOLVED_EXAMPLE,
            Surface::Solid => SOLID_EXAMPLE,
            Surface::Flat | Surface::Cylinder(_) => EXAMPLE,
        };
        let message = "nothing holds the body: `supports` is empty";
        faults.error(root("supports"), message).hint(hint).in_solution_only();
    }
    let each = case.supports.iter().enumerate();
    let shares = EdgeShares::new(material);
    let resolved = each.filter_map(|(k, support)| {
        let path = root("supports").index(k);
        support_keys::check(support, material, &path, faults);
        let at = path.key("at");
        if support.at.inward.is_some() {
            faults.error(at.key("inward"), "`inward` is for probes").hint(ground.place_hint());
        }
        for edge in support.at.region.iter().flat_map(|names| ground.edges_of(names)) {
            not_mirrored(Some(&edge), &at.key("region"), symmetry, faults);
        }
        let spot = ground.spot(&support.at, &at, "the support", faults)?;
        place_of_point::doubt(ground, &support.at, &spot, &at, faults);
        let whole = resolve(support, spot, path, (ground, faults))?;
        Some(match &support.at.region {
            Some(names) => support_parts::parts(whole, names, ground, (symmetry, material, &shares)),
            None => vec![whole],
        })
    });
    resolved.flatten().collect()
}

impl HeldSupport {
    /// The same on what a name calls, if that is one edge, one hole, one face, or a region.
    pub(super) fn on(
        mut self,
        name: &str,
        ground: &Ground,
        material: &dyn Material,
        shares: &EdgeShares,
    ) -> Self {
        self.border = border(name, ground);
        if let PointBody::Solid(lattice) = ground.body {
            let wall = ground.walls.iter().find(|wall| wall.name == *name);
            self.edge = wall.and_then(Wall::face).map(HeldEdge::of_face);
            self.chains = self.edge.as_ref().map_or(Vec::new(), |edge| edge.chains(lattice, &self.points));
        }
        if let PointBody::Lattice(lattice) = ground.body {
            let edge = ground.outline.and_then(|outline| outline.edge(name));
            let is_cylinder = material.cylinder_radius().is_some();
            self.edge = edge.and_then(|edge| match is_cylinder {
                true => HeldEdge::of_cylinder(edge).filter(|_| material.ends_on_border(lattice)),
                false => HeldEdge::new(edge, lattice, shares),
            });
            self.chains = self.edge.as_ref().map_or(Vec::new(), |edge| edge.chains(lattice, &self.points));
        }
        self
    }

    /// The same with other points, along a border, and without springs.
    pub(super) fn along(&self, points: Vec<u32>, border: Vec<Stretch>) -> Self {
        Self { points, border, springs: Vec::new(), ..self.clone() }
    }

    pub(super) fn has_springs(&self) -> bool {
        !self.springs.is_empty()
    }

    /// Its springs alone.
    pub(super) fn springs_alone(self) -> Self {
        Self { motions: Vec::new(), ..self }
    }
}

/// Stretches of the edge or hole of a name; none of other regions.
fn border(name: &str, ground: &Ground) -> Vec<Stretch> {
    let Some(outline) = ground.outline else { return Vec::new() };
    let hole = || outline.holes().iter().position(|hole| hole.name.as_deref() == Some(name));
    match (outline.edge(name), hole()) {
        (Some(edge), _) => boundary::of_edge(edge, ground),
        (_, Some(hole)) => boundary::of_hole(hole, outline, ground.body.spacing()),
        _ => Vec::new(),
    }
}

/// A fault for an edge that a mirror replaces, or that is joined to another one.
pub(crate) fn not_mirrored(region: Option<&str>, path: &JsonPath, symmetry: &Symmetry, faults: &mut Faults) {
    let side = if symmetry.is_solid { "face" } else { "edge" };
    if let Some(name) = region.filter(|name| symmetry.axis.iter().any(|e| e == name)) {
        faults
            .error(path.clone(), format!("the edge `{name}` is the axis, no edge of the body"))
            .hint("points on the axis stay there, and nothing acts on it");
    } else if let Some(name) = region.filter(|name| symmetry.replaces(name)) {
        faults
            .error(path.clone(), format!("the {side} `{name}` is a mirror by `symmetry`, no {side} of the body"))
            .hint("the mirror holds the displacement across it already, and nothing acts on it: remove one of both");
    }
    if let Some(name) = region.filter(|name| symmetry.joins(name)) {
        faults
            .error(path.clone(), format!("the {side} `{name}` is joined to the opposite one by `periodic`"))
            .hint("no border is there: take another region, or remove `periodic`");
    }
}

fn resolve(
    support: &Support,
    spot: NamedPoints,
    path: JsonPath,
    (ground, faults): (&Ground, &mut Faults),
) -> Option<HeldSupport> {
    let inclined = support.inclined.map(|inclined| {
        let angle = inclined.degrees.to_radians();
        // What rounding leaves of a right angle is no share.
        let clean = |share: f64| if share.abs() < 1e-15 { 0.0 } else { share };
        let moved = Motion::Proportional(Prescribed::Number(inclined.displacement));
        ([clean(angle.cos()), clean(angle.sin()), 0.0], moved, "inclined")
    });
    let given = [
        ([1.0, 0.0, 0.0], &support.ux, "ux"),
        ([0.0, 1.0, 0.0], &support.uy, "uy"),
        ([0.0, 0.0, 1.0], &support.uz, "uz"),
        ([0.0, 0.0, 1.0], &support.phi, "phi"),
        ([0.0, 0.0, 1.0], &support.w, "w"),
    ];
    let mut motions = Vec::new();
    for (direction, value, key) in given {
        if let Some(value) = value {
            let (axes, steps) = (ground.body.axes(), ground.case.steps.as_ref());
            motions.push((direction, Motion::new(value, axes, steps, &path.key(key), faults)?, key));
        }
    }
    motions.extend(inclined);
    let springs = [(0, support.ux_spring), (1, support.uy_spring), (2, support.uz_spring)];
    Some(HeldSupport {
        name: spot.words,
        path,
        points: spot.points,
        edge: None,
        chains: Vec::new(),
        border: Vec::new(),
        motions,
        springs: springs.into_iter().filter_map(|(component, k)| Some((component, k?))).collect(),
    })
}

impl HeldSupport {
    /// Points that share what acts on the edge at a point, with their shares, where the edge is held along a component.
    pub(crate) fn sharing(
        &self,
        point: u32,
        component: usize,
    ) -> Option<impl Iterator<Item = (u32, f64)> + '_> {
        let direct = self.motions.iter().any(|m| m.2 != "phi" && m.0[component].abs() == 1.0);
        let k = self.points.binary_search(&point).ok().filter(|_| direct)?;
        let chain = self.chains.get(k).filter(|chain| !chain.is_empty())?;
        let points = std::iter::once(point).chain(chain.iter().copied());
        Some(points.zip(self.edge.as_ref()?.shares(component).iter().copied()))
    }

    /// What it prescribes, by numbers of the model.
    pub(crate) fn holds(
        &self,
        inputs: &ModelInputs,
        model: &dyn BodyModel,
        faults: &mut Faults,
    ) -> Vec<HeldPoints> {
        let points: Vec<u32> = self.points.iter().map(|&p| inputs.number(model, p)).collect();
        let number = |p: &u32| inputs.number(model, *p);
        let chains: Vec<Vec<u32>> = self.chains.iter().map(|c| c.iter().map(number).collect()).collect();
        let pieces = held_border::pieces(&self.border, &points, model);
        let on_border: Vec<u32> = match &pieces {
            Some(pieces) => (0..points.len()).filter(|&k| !pieces[k].is_empty()).map(|k| points[k]).collect(),
            None => Vec::new(),
        };
        let pieces: Vec<Piece> = pieces.into_iter().flatten().filter(|piece| !piece.is_empty()).collect();
        let mut hold = |(direction, motion, key): &([f64; 3], Motion, &'static str)| {
            // Rotations are those of the points, wherever the edge is.
            let turns = *key == "phi";
            let follows = !turns && !pieces.is_empty();
            let mut held = HeldPoints {
                points: if follows { on_border.clone() } else { points.clone() },
                edge: self.edge.clone().filter(|_| !turns && !follows),
                chains: if turns || follows { Vec::new() } else { chains.clone() },
                pieces: if follows { pieces.clone() } else { Vec::new() },
                direction: by_component(*direction, turns, model),
                values: Vec::new(),
                by_step: Vec::new(),
                origin: self.path.key(*key).to_string(),
            };
            let scale = if turns { model.scale(2) } else { 1.0 };
            let values = held.places(model).into_iter().map(|place| motion.values(place, None));
            let values = values.collect::<Result<Vec<Vec<f64>>, String>>().unwrap_or_else(|reason| {
                faults.error(self.path.key(*key), reason);
                vec![vec![0.0]; held.points.len()]
            });
            held.values = values.iter().map(|own| scale * motion.standing(own)).collect();
            if matches!(motion, Motion::BySteps(_)) {
                let scaled = |own: Vec<f64>| own.into_iter().map(|value| scale * value).collect();
                held.by_step = values.into_iter().map(scaled).collect();
            }
            held
        };
        self.motions.iter().map(&mut hold).collect()
    }

    /// Its springs, shared by volume.
    pub(crate) fn spring_list(&self, inputs: &ModelInputs, model: &dyn BodyModel) -> Vec<Spring> {
        let points: Vec<usize> = self.points.iter().map(|&p| inputs.number(model, p) as usize).collect();
        let volume: f64 = points.iter().map(|&p| model.volume(p)).sum();
        let on = |component: usize, stiffness: f64| {
            let share = move |&p: &usize| Spring::on(component, p, stiffness * model.volume(p) / volume);
            points.iter().map(share).collect::<Vec<_>>()
        };
        let along = |&(axis, stiffness): &(usize, f64)| Some(on(model.along(axis)?, stiffness));
        self.springs.iter().filter_map(along).flatten().collect()
    }
}

/// A direction along x, y and z, or a rotation, by the unknowns of a model.
fn by_component(direction: [f64; 3], turns: bool, model: &dyn BodyModel) -> [f64; 3] {
    let mut shares = [0.0; 3];
    for axis in (0..3).filter(|&axis| direction[axis] != 0.0) {
        let component = if turns { model.turning().map(|(k, _)| k) } else { model.along(axis) };
        if let Some(component) = component {
            shares[component] = direction[axis];
        }
    }
    shares
}
