//! Probes of a body.

use super::fields::Says;
use super::{edge_mean, fields, opening, reduced};
use crate::case::{FieldName, Names, Origin, Probe, Reduction, TipQuantity};
use crate::diagnostic::{Faults, JsonPath, suggest};
use crate::scene::body::hold::held_body::HeldBody;
use crate::scene::body::hold::supported::BodySupport;
use crate::scene::body::site::interpolate::Weights;
use crate::scene::words;
use peristat_assembly::body::in_space;

/// A value to report.
#[derive(Clone, Debug)]
pub struct BodyProbe {
    /// Name.
    pub name: String,
    /// What it is.
    pub quantity: Quantity,
    /// What the user calls the place.
    pub place: String,
    /// Where it is, unless the place is a region or a crack.
    pub position: Option<[f64; 3]>,
}

/// What a probe reports.
#[derive(Clone, Debug, PartialEq)]
pub enum Quantity {
    /// A sum of the values of a field at points of the model. `von_mises` is that of the summed stresses.
    Field {
        /// The field.
        field: FieldName,
        /// Points and shares.
        weights: Weights,
    },
    /// What is made of the values of a field at many points.
    Reduced {
        /// The field.
        field: FieldName,
        /// What is made of it.
        of: Reduction,
        /// Points of the body; all if none are given.
        points: Option<Vec<u32>>,
    },
    /// What supports do to the body.
    Reaction {
        /// Which of its forces, or its moment.
        field: FieldName,
        /// Indices of equations of the scene and how much of the force that holds each counts.
        equations: Vec<(usize, f64)>,
        /// Indices of springs of the scene along this component.
        springs: Vec<usize>,
    },
    /// Opening of a crack: a sum of displacements of points of the model.
    Opening {
        /// Along x, 0, or along y, 1.
        component: usize,
        /// Points and shares, which sum to zero.
        weights: Weights,
    },
    /// Rotation of a rigid region, rad.
    Rotation {
        /// Which one: about z in the plane.
        field: FieldName,
        /// Index of the region.
        region: usize,
    },
    /// What loads a tip of a crack, by its index in the scene.
    StressIntensity(usize, TipQuantity),
}

impl BodyProbe {
    /// Its field, unless it is a stress intensity.
    pub fn field(&self) -> Option<FieldName> {
        match &self.quantity {
            Quantity::Field { field, .. }
            | Quantity::Reduced { field, .. }
            | Quantity::Reaction { field, .. }
            | Quantity::Rotation { field, .. } => Some(*field),
            Quantity::Opening { .. } => Some(FieldName::Opening),
            Quantity::StressIntensity(..) => None,
        }
    }

    /// Name of the field in case files, or what it is of the tip of a crack.
    pub fn field_name(&self) -> &'static str {
        match &self.quantity {
            Quantity::StressIntensity(_, quantity) => quantity.name(),
            _ => self.field().map_or("", FieldName::name),
        }
    }

    /// Whether it needs stresses.
    pub fn is_recovered(&self) -> bool {
        matches!(&self.quantity, Quantity::Field { field, .. } | Quantity::Reduced { field, .. } if field.is_recovered())
    }

    /// What it makes of many points, if it does.
    pub fn reduction(&self) -> Option<Reduction> {
        if let Quantity::Reduced { of, .. } = self.quantity { Some(of) } else { None }
    }
}

/// Probes of the case.
pub(crate) fn probes(site: &HeldBody, faults: &mut Faults) -> Vec<BodyProbe> {
    let resolve = |probe: &Probe, path: &JsonPath, faults: &mut Faults| {
        let (quantity, place) = resolve(probe, site, path, faults)?;
        let position = probe.at.x.zip(probe.at.y).map(|(x, y)| [x, y, probe.at.z.unwrap_or(0.0)]);
        Some(BodyProbe { name: probe.name.clone(), quantity, place, position })
    };
    crate::scene::probes::probes(site.ground.case, resolve, faults)
}

fn resolve(
    probe: &Probe,
    site: &HeldBody,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(Quantity, String)> {
    let (at, field) = (path.key("at"), probe.field);
    let (ground, case) = (site.ground, site.ground.case);
    let there_are = fields::probed(site.model, case, Says::of(case, &*site.inputs.material));
    if !there_are.contains(&field) {
        fields::refuse(field, &there_are, case, path.key("field"), faults);
        return None;
    }
    if let Some(of) = probe.of {
        return reduced::resolve(probe, of, site, path, faults);
    }
    if field == FieldName::Opening {
        return opening::resolve(probe, site, &at, faults);
    }
    let is_rigid = |name: &Names| case.rigid.iter().any(|r| r.region == **name);
    let points_turn = site.model.component("phi").is_some();
    let is_turn = matches!(field.about().origin, Origin::Turn(_));
    let is_phi =
        || field == FieldName::Phi && (!points_turn || probe.at.region.as_ref().is_some_and(is_rigid));
    if is_turn || is_phi() {
        return rotation(probe, site, path, faults);
    }
    if field.is_reaction() {
        let spot = ground.spot(&probe.at, &at, "the probe", faults)?;
        let quantity = reaction(field, &spot.points, &spot.words, site, &at, faults)?;
        return Some((quantity, spot.words));
    }
    if probe.at.edge.is_some() {
        let (weights, words) = edge_mean::resolve(probe, site, &at, faults)?;
        return Some((Quantity::Field { field, weights }, words));
    }
    let number = |p: u32| site.inputs.number(site.model, p);
    let field = |weights| Quantity::Field { field, weights };
    if let Some(name) = ground.region_name(&probe.at, &at, faults)? {
        let points = ground.region(name, &at.key("region"), faults)?;
        let whole: f64 = points.iter().map(|&p| ground.body.measure(p as usize)).sum();
        let mean = points.iter().map(|&p| (number(p), ground.body.measure(p as usize) / whole)).collect();
        let inside = if edge_mean::ends_rows(name, site) { ", half a spacing inside" } else { "" };
        return Some((field(mean), format!("mean of the points of `{name}`{inside}")));
    }
    let position = ground.position(&probe.at, &at, faults)?;
    let words = words::place(position, ground.body);
    let nearest = ground.point_at(position, &at, "the probe", faults)?;
    let weights = match probe.at.inward {
        None => site.interpolation.at(position, number(nearest)),
        Some(inward) => {
            match on_axis(inward).and_then(|out| edge_mean::of_border(position, out, probe.field, site)) {
                Some(weights) => weights,
                None => from_inside(position, inward, site, &at.key("inward"), faults)?,
            }
        }
    };
    Some((field(weights), words))
}

/// The direction out of the body, if `inward` is along an axis.
fn on_axis(inward: [i8; 2]) -> Option<[f64; 3]> {
    let is_along_axis = i32::from(inward[0]).abs() + i32::from(inward[1]).abs() == 1;
    is_along_axis.then(|| in_space(inward.map(|k| -f64::from(k))))
}

fn from_inside(
    [x, y, _]: [f64; 3],
    inward: [i8; 2],
    site: &HeldBody,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Weights> {
    if i32::from(inward[0]).abs() + i32::from(inward[1]).abs() != 1 {
        faults
            .error(path.clone(), format!("`inward` must be along x or y, found {inward:?}"))
            .hint("it is the direction into the body: [1, 0], [-1, 0], [0, 1] or [0, -1]");
        return None;
    }
    let found = site.interpolation.inward([x, y], inward);
    if found.is_none() {
        let hint = match site.ground.body {
            peristat_assembly::body::PointBody::Lattice(lattice) if lattice.is_turned() => {
                "the rows of the lattice run along neither x nor y: leave `inward` out"
            }
            peristat_assembly::body::PointBody::Lattice(_) => {
                "it needs three points in a row that begin at the place; is this the direction into the body?"
            }
            peristat_assembly::body::PointBody::Solid(_) => {
                "it is for bodies in the plane: leave `inward` out"
            }
            _ => "listed points have no rows: leave `inward` out",
        };
        faults.error(path.clone(), "there are no three points in a row in this direction").hint(hint);
    }
    found
}

fn rotation(
    probe: &Probe,
    site: &HeldBody,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(Quantity, String)> {
    let rigid = &site.ground.case.rigid;
    let at = path.key("at");
    let name = site.ground.region_name(&probe.at, &at, faults)?;
    let found = name.and_then(|name| rigid.iter().position(|r| r.region == name));
    let Some(k) = found else {
        let regions = || rigid.iter().map(|r| r.region.as_str());
        let hint = match name {
            Some(name) => suggest(name, regions()),
            None => format!("write {{ \"region\": \"{}\" }}", regions().next().unwrap_or_default()),
        };
        let field = probe.field.name();
        faults.error(at, format!("`{field}` is the rotation of a rigid region, and this is none")).hint(hint);
        return None;
    };
    let quantity = Quantity::Rotation { field: probe.field, region: k };
    Some((quantity, format!("the region `{}`", rigid[k].region)))
}

/// Equations with their shares in a reaction, and springs, of the points that are `here`: of some supports, or if there are none of all.
/// A component of the displacement has a unit; a rigid region has a motion.
fn held_rows(
    site: &HeldBody,
    own: &[&BodySupport],
    here: &dyn Fn(u32) -> bool,
    (component, unit, motion): (Option<usize>, f64, Option<usize>),
) -> (Vec<(usize, f64)>, Vec<usize>) {
    let of_own = |k: usize| {
        own.is_empty() || own.iter().flat_map(|s| &s.equations).any(|(equations, _)| equations.contains(&k))
    };
    let (mut equations, mut next) = (Vec::new(), 0);
    for hold in &site.conditions.holds {
        let share = component.map_or(0.0, |component| unit * hold.direction[component]);
        let points = hold.points.iter().enumerate();
        let points = points.filter(|(k, p)| share != 0.0 && here(**p) && of_own(next + k));
        equations.extend(points.map(|(k, _)| (next + k, share)));
        next += hold.points.len();
    }
    for rigid in &site.conditions.rigid {
        let whole = rigid.points.iter().all(|&p| here(p));
        for (k, _) in rigid.prescribed.iter().enumerate().filter(|p| p.1.is_some()) {
            if whole && motion == Some(k) {
                equations.push((next, 1.0));
            }
            next += 1;
        }
    }
    let along = |k: &usize| {
        let spring = &site.conditions.springs[*k];
        let is_own = own.is_empty() || own.iter().any(|s| s.springs.contains(k));
        is_own && Some(spring.shares[0].0) == component && here(spring.point as u32)
    };
    (equations, (0..site.conditions.springs.len()).filter(along).collect())
}

/// Everything that holds one of the points along the component of the field.
fn reaction(
    field: FieldName,
    points: &[u32],
    words: &str,
    site: &HeldBody,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Quantity> {
    let of = fields::reaction_of(field, site.model, !site.ground.case.rigid.is_empty())?;
    let (component, unit) = of.unknown.map_or((None, 1.0), |(k, unknown)| (Some(k), unknown.scale));
    let mut numbers: Vec<u32> = points.iter().map(|&p| site.inputs.number(site.model, p)).collect();
    numbers.sort_unstable();
    let here = |p: u32| numbers.binary_search(&p).is_ok();
    // A point that two supports hold counts for the one that is listed with it: those of all supports sum to the whole.
    let own: Vec<&BodySupport> = site.supports.iter().filter(|support| support.name == words).collect();
    let rows = |own: &[&BodySupport]| held_rows(site, own, &here, (component, unit, of.motion));
    let mut found = rows(&own);
    if found.0.is_empty() && found.1.is_empty() {
        found = rows(&[]);
    }
    let (equations, springs) = found;
    if equations.is_empty() && springs.is_empty() {
        let places: Vec<&str> = site.held.iter().map(|h| h.name.as_str()).collect();
        let hint = match places.is_empty() {
            true if !site.inputs.symmetry.edges.is_empty() => {
                "forces through mirrors are listed with the results, and are no probes".to_string()
            }
            true => site.ground.place_hint().to_string(),
            false => format!("supports are at {}", places.join(", ")),
        };
        let how = match of.name {
            "ux" => "along x",
            "uy" => "along y",
            "uz" => "along z",
            "phi" => "against turning",
            "phi_x" => "against turning about x",
            "phi_y" => "against turning about y",
            "phi_z" => "against turning about z",
            _ => "across the plane",
        };
        faults
            .error(path.clone(), format!("nothing holds {words} {how}, so there is no reaction"))
            .hint(hint);
        return None;
    }
    Some(Quantity::Reaction { field, equations, springs })
}
