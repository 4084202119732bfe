//! Probes of a plate.

use super::border::Side;
use super::held_line::HeldLine;
use super::line_probe::{self, OnLine};
use super::restraints::Restraints;
use super::site::Site;
use crate::case::{FieldName, Probe, Reduction};
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::body::site::interpolate::{Interpolation, Weights};
use crate::scene::words;
use peristat_assembly::model::plate_bending::{PHI_X, PHI_Y, W};

/// A value to report.
#[derive(Clone, Debug)]
pub struct PlateProbe {
    /// Name.
    pub name: String,
    /// Its field.
    pub field: FieldName,
    /// How it is found.
    pub quantity: PlateQuantity,
    /// What the user calls the place.
    pub place: String,
    /// Where it is, unless the place is a region.
    pub position: Option<[f64; 2]>,
}

/// How a probe is found.
#[derive(Clone, Debug, PartialEq)]
pub enum PlateQuantity {
    /// A sum over points; what follows from moments is that of the summed moments.
    Field(Weights),
    /// What is made of the values at some points, or at all.
    Reduced {
        /// What is made of them.
        of: Reduction,
        /// The points; all if none are given.
        points: Option<Vec<u32>>,
    },
    /// What supports do to the plate.
    Reaction {
        /// Component of the unknowns.
        component: usize,
        /// Indices of equations of the scene and how much of the force that holds each counts.
        equations: Vec<(usize, f64)>,
        /// The same of springs of the scene.
        springs: Vec<(usize, f64)>,
    },
    /// What supports do to the plate along lines that they hold.
    OnLine(OnLine),
}

/// The forces of supports, by what they act on.
const REACTIONS: [(FieldName, usize); 3] =
    [(FieldName::ReactionForce, W), (FieldName::ReactionMomentX, PHI_X), (FieldName::ReactionMomentY, PHI_Y)];

impl PlateProbe {
    /// Whether it needs more than the unknowns and reactions.
    pub fn is_recovered(&self) -> bool {
        self.field != FieldName::Damage && self.field.is_recovered()
    }

    /// What it makes of many points, if it does.
    pub fn reduction(&self) -> Option<Reduction> {
        match self.quantity {
            PlateQuantity::Reduced { of, .. } | PlateQuantity::OnLine(OnLine::Reduced { of, .. }) => Some(of),
            _ => None,
        }
    }
}

/// The fields that probes can ask for.
pub(super) fn askable() -> Vec<FieldName> {
    let reactions = REACTIONS.map(|(field, _)| field).into_iter().chain(line_probe::FIELDS);
    FieldName::PLATE.into_iter().chain(reactions).collect()
}

/// Probes of the case.
pub(super) fn probes(
    site: &Site,
    (held, lines): (&Restraints, &[HeldLine]),
    faults: &mut Faults,
) -> Vec<PlateProbe> {
    let resolve = |probe: &Probe, path: &JsonPath, faults: &mut Faults| {
        if !askable().contains(&probe.field) {
            faults
                .error(
                    path.key("field"),
                    format!("`{}` is no field of a plate in bending", probe.field.name()),
                )
                .hint(words::there_are(&askable()));
            return None;
        }
        let (quantity, place) = match probe.of {
            _ if line_probe::FIELDS.contains(&probe.field) => {
                let (found, place) = line_probe::of(probe, site, (held, lines), path, faults)?;
                (PlateQuantity::OnLine(found), place)
            }
            Some(of) => reduced(probe, of, site, path, faults)?,
            None => at_place(probe, site, held, &path.key("at"), faults)?,
        };
        let position = probe.at.x.zip(probe.at.y).map(|(x, y)| [x, y]);
        Some(PlateProbe { name: probe.name.clone(), field: probe.field, quantity, place, position })
    };
    crate::scene::probes::probes(site.case, resolve, faults)
}

/// What is made of a field at the points of a region or of the whole plate.
fn reduced(
    probe: &Probe,
    of: Reduction,
    site: &Site,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(PlateQuantity, String)> {
    if !FieldName::PLATE.contains(&probe.field) || probe.field == FieldName::MomentDirection {
        faults
            .error(
                path.key("of"),
                format!("there is nothing to make of `{}` at many points", probe.field.name()),
            )
            .hint("leave `of` out");
        return None;
    }
    if probe.at.is_nowhere() {
        return Some((PlateQuantity::Reduced { of, points: None }, "the plate".into()));
    }
    if probe.at.region.is_none() {
        faults
            .error(path.key("of"), "`of` is for a region or the whole plate, and this is a point")
            .hint("leave `of` out");
        return None;
    }
    let spot = site.spot(&probe.at, &path.key("at"), "the probe", faults)?;
    Some((PlateQuantity::Reduced { of, points: Some(spot.points) }, spot.words))
}

fn at_place(
    probe: &Probe,
    site: &Site,
    held: &Restraints,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(PlateQuantity, String)> {
    let spot = site.spot(&probe.at, path, "the probe", faults)?;
    if let Some(&(_, component)) = REACTIONS.iter().find(|reaction| reaction.0 == probe.field) {
        let sides = probe.at.region.as_ref().and_then(|name| site.sides(name));
        let found = reaction(component, &spot.points, sides.as_deref(), held);
        if found.is_none() {
            let places: Vec<&str> = held.supports.iter().map(|support| support.name.as_str()).collect();
            faults
                .error(path.clone(), format!("nothing holds {} so, and there is no reaction", spot.words))
                .hint(format!("supports are at {}", places.join(", ")));
        }
        return found.map(|quantity| (quantity, spot.words));
    }
    let weights = match (probe.at.x, probe.at.y, &spot.points[..]) {
        (Some(x), Some(y), &[nearest]) => {
            Interpolation { body: site.ground.body, cracks: &[], reach: 1 }.at([x, y, 0.0], nearest)
        }
        (.., points) => {
            let area = |p: u32| site.nodes.area(p as usize);
            let whole: f64 = points.iter().map(|&p| area(p)).sum();
            points.iter().map(|&p| (p, area(p) / whole)).collect()
        }
    };
    Some((PlateQuantity::Field(weights), spot.words))
}

/// What a point that a support holds by some sides counts on others: a half where both of its edges at a corner are held and one is
/// asked for, so that reactions of all edges sum to the whole. None if it holds the point by no side.
fn share(point: u32, held: &[Side], asked: &[Side]) -> Option<f64> {
    let at = |side: &&Side| side.segment.points.contains(&point);
    let is_asked = |side: &&Side| asked.iter().any(|own| own.segment == side.segment);
    let all = held.iter().filter(at).count();
    let own = held.iter().filter(at).filter(is_asked).count();
    (all != 0).then(|| own as f64 / all as f64)
}

/// Indices of equations and of springs, and how much of the force of each counts.
type ReactionTerms = [Vec<(usize, f64)>; 2];

/// What a support does along a component at some points, by what each of them counts.
fn terms(component: usize, number: usize, held: &Restraints, share: &dyn Fn(u32) -> f64) -> ReactionTerms {
    let support = &held.supports[number];
    let equation = |k: usize| {
        // What an equation does to other points is the reaction of the one that it holds, its first.
        let terms = &held.equations[k].terms;
        let share = terms.first().map_or(0.0, |(unknown, _)| share(unknown.point as u32));
        let own = terms.iter().filter(|(unknown, _)| unknown.component == component);
        (k, share * own.map(|(_, c)| c).sum::<f64>())
    };
    let resists =
        |k: &usize| held.springs[*k].shares.iter().any(|(own, part)| *own == component && *part != 0.0);
    let springs = support.springs.clone().filter(resists);
    let springs = springs.map(|k| (k, share(held.springs[k].point as u32)));
    let acts = |part: &(usize, f64)| part.1 != 0.0;
    [support.equations.clone().map(equation).filter(acts).collect(), springs.filter(acts).collect()]
}

/// What supports do to points, of a part of the border by its sides. At the place of a support that is what this support does, and
/// a line inside keeps the point where it meets an edge: the sum over all supports is the load.
fn reaction(
    component: usize,
    points: &[u32],
    asked: Option<&[Side]>,
    held: &Restraints,
) -> Option<PlateQuantity> {
    let numbers = || 0..held.supports.len();
    let by_edge = |point: u32| {
        let is_own = |k: usize| share(point, &held.sides[k], &[]).is_some();
        let holds = |k: usize| terms(component, k, held, &|other| f64::from(u8::from(other == point)));
        numbers().any(|k| is_own(k) && holds(k) != ReactionTerms::default())
    };
    let counts = |number: usize, point: u32| match (points.binary_search(&point), asked) {
        (Err(_), _) => 0.0,
        (Ok(_), Some(asked)) => {
            share(point, &held.sides[number], asked).unwrap_or_else(|| f64::from(u8::from(!by_edge(point))))
        }
        (Ok(_), None) => 1.0,
    };
    let of = |number: usize| terms(component, number, held, &|point| counts(number, point));
    let is_here = |number: &usize| held.points[*number] == points;
    let mut all: Vec<ReactionTerms> = numbers().filter(is_here).map(of).collect();
    if all.iter().all(|own| *own == ReactionTerms::default()) {
        all = numbers().map(of).collect();
    }
    let [equations, springs]: ReactionTerms =
        [0, 1].map(|k| all.iter().flat_map(|own| own[k].clone()).collect());
    let is_held = !(equations.is_empty() && springs.is_empty());
    is_held.then_some(PlateQuantity::Reaction { component, equations, springs })
}
