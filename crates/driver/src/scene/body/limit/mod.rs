//! The limit of local elasticity: what is known on the border of a body whose displacements are corrected, and which bodies can be.

mod bearing;
mod corners;
mod jumps;
mod refuse;
mod supports;

use super::hold::held_body::HeldBody;
use super::load::sums::BodyLoads;
use super::load::traction::on_border::OnBorder;
use super::load::traction::profile::Profile;
use super::scene::BodyState;
use super::site::boundary::{self, Border};
use crate::diagnostic::{Faults, root};
use crate::memory;
use crate::scene::Resultant;
use crate::scene::prescribed::Motion;
use peristat_assembly::body::{BorderMember, BorderPart, Edge, Outline, in_space};
use peristat_assembly::correction::{BorderPiece, Sample};
pub(crate) use supports::FreeMotions;

/// Corrections of a case that gives no number.
const USUAL: usize = 2;

/// What is known on the border, and how often displacements are corrected.
#[derive(Clone, Debug)]
pub(crate) struct LocalLimit {
    pub(crate) corrections: usize,
    /// The border, lines of symmetry left out.
    pub(crate) pieces: Vec<BorderPiece>,
    members: Vec<BorderMember>,
    /// By load case.
    tractions: Vec<Vec<Acting>>,
    /// What supports prescribe along edges, by member and axis.
    held: Vec<(BorderMember, usize, Motion)>,
    /// Where stresses are infinite, m.
    pub(crate) singular: Vec<[f64; 2]>,
    /// Rigid motions that nothing but points holds.
    pub(crate) free: FreeMotions,
}

/// A traction on a member of the border.
#[derive(Clone, Debug)]
struct Acting {
    member: BorderMember,
    /// Along which the profile runs; none of a hole.
    edge: Option<Edge>,
    profile: Profile,
}

impl LocalLimit {
    /// That of a case with the tractions of its load cases; none of one that asks for no limit. Adds a fault for everything that
    /// stands against it.
    pub(super) fn resolve(
        site: &HeldBody,
        (loads, states): (&[BodyLoads], &[BodyState]),
        max_memory: Option<u64>,
        faults: &mut Faults,
    ) -> Option<Self> {
        let case = site.ground.case;
        refuse::check_keys(case, faults);
        if !case.is_corrected() {
            return None;
        }
        let corrections = case.corrections.unwrap_or(USUAL);
        let outline = refuse::body(site, faults)?;
        refuse::loads(case, faults);
        refuse::rotations(case, faults);
        let weights: Vec<[f64; 3]> = loads.iter().map(|loads| loads.weight).collect();
        refuse::weight(&weights, site, faults);
        let held = supports::along_border(site, outline, faults);
        let (members, pieces) = pieces(outline, site, &held);
        let free = supports::check(site, &held, outline, faults);
        bearing::check(site, &free, &resultants(loads, states), faults);
        let singular = corners::check(&pieces, site.ground.body.spacing(), faults);
        if !fits(&pieces, site, max_memory, faults) {
            return None;
        }
        let mut acting =
            |on: &[OnBorder]| on.iter().filter_map(|on| Acting::new(on, outline, faults)).collect();
        let tractions = loads.iter().map(|loads| acting(&loads.on_border)).collect();
        let corrections = if singular.is_empty() { corrections } else { corrections.min(1) };
        let limit = Self { corrections, singular, pieces, members, tractions, held, free };
        if !faults.has_errors() {
            jumps::check(&limit, site, states, faults);
        }
        Some(limit)
    }

    /// What is known of a state at samples of the border, by axes: the displacement where it is held, m, else the traction, Pa.
    pub(crate) fn known(&self, state: &BodyState, samples: &[Sample]) -> Vec<[f64; 2]> {
        samples.iter().map(|sample| self.known_at(state, sample)).collect()
    }

    fn known_at(&self, state: &BodyState, sample: &Sample) -> [f64; 2] {
        let member = self.members[sample.piece];
        let terms = state.terms.iter().flat_map(|&(case, factor)| {
            let own = self.tractions[case].iter().filter(move |acting| acting.member == member);
            own.map(move |acting| (acting, factor))
        });
        let mut known = terms.fold([0.0; 2], |sum, (acting, factor)| {
            let traction = acting.at(sample);
            [0, 1].map(|k| sum[k] + factor * traction[k])
        });
        for (_, axis, motion) in self.held.iter().filter(|held| held.0 == member) {
            let value = motion.values(in_space(sample.at), None).ok();
            known[*axis] = value.and_then(|v| v.first().copied()).unwrap_or(f64::NAN) * state.motion_factor;
        }
        known
    }
}

impl Acting {
    fn new(on: &OnBorder, outline: &Outline, faults: &mut Faults) -> Option<Self> {
        let (member, edge) = match &on.border {
            Border::Edge(edge) => {
                let k = outline.edges().iter().position(|other| other.name == edge.name)?;
                (BorderMember::Edge(k), Some(edge.clone()))
            }
            Border::Curved { hole: Some(k), .. } => (BorderMember::Hole(*k), None),
            Border::Curved { hole: None, .. } => return None,
        };
        refuse::profile(on, faults);
        Some(Self { member, edge, profile: on.profile.clone() })
    }

    fn at(&self, sample: &Sample) -> [f64; 2] {
        let place = self.edge.as_ref().map_or(0.0, |edge| boundary::place_on(edge, sample.at));
        let [x, y, _] = self.profile.at(place, sample.at, sample.normal);
        [x, y]
    }
}

/// The states with the resultants of their loads as they are asked for.
fn resultants<'a>(loads: &[BodyLoads], states: &'a [BodyState]) -> Vec<(&'a BodyState, Resultant)> {
    let of = |state: &'a BodyState| {
        let mut sum = Resultant::default();
        state.terms.iter().for_each(|&(case, factor)| sum.add_multiple(factor, &loads[case].asked));
        (state, sum)
    };
    states.iter().map(of).collect()
}

/// What a point and its square read, bytes.
const PER_POINT: f64 = 1500.0;
/// A place of the box around the body, bytes.
const PER_PLACE: f64 = 100.0;
/// Fits beside a border that runs across rows and columns, each of its own, bytes per spacing of it: one takes 14 kB.
const PER_SPACING: f64 = 1e5;

/// Whether what displacements are corrected by fits into memory.
fn fits(pieces: &[BorderPiece], site: &HeldBody, max_memory: Option<u64>, faults: &mut Faults) -> bool {
    let spacing = site.ground.body.spacing();
    let is_along =
        |part: &BorderPart| matches!(part, BorderPart::Straight { normal, .. } if normal.contains(&0.0));
    let across: f64 =
        pieces.iter().map(|piece| piece.part).filter(|part| !is_along(part)).map(|part| part.length()).sum();
    let box_around = site.outline.map_or([[0.0; 2]; 2], Outline::bounds);
    let places = [0, 1].map(|k| (box_around[1][k] - box_around[0][k]) / spacing).iter().product::<f64>();
    let points = site.ground.body.points() as f64;
    let bytes = PER_POINT * points + PER_PLACE * places + PER_SPACING * across / spacing;
    let what = ("fits of the limit `local`", "use a larger spacing, or leave `limit` out");
    memory::fits(bytes, what, max_memory, root("limit"), faults)
}

/// The border of a body by its members, lines of symmetry left out.
fn pieces(
    outline: &Outline,
    site: &HeldBody,
    held: &[(BorderMember, usize, Motion)],
) -> (Vec<BorderMember>, Vec<BorderPiece>) {
    let edges = outline.edges().iter().enumerate();
    let edges = edges.filter(|(_, edge)| !site.inputs.symmetry.replaces(&edge.name));
    let edges = edges
        .flat_map(|(k, edge)| outline.edge_parts(edge).into_iter().map(move |p| (BorderMember::Edge(k), p)));
    let holes = (0..outline.holes().len())
        .flat_map(|k| outline.hole_parts(k).into_iter().map(move |p| (BorderMember::Hole(k), p)));
    let is_held = |member, axis| held.iter().any(|(other, k, _)| *other == member && *k == axis);
    let piece =
        |(member, part)| (member, BorderPiece { part, held: [0, 1].map(|axis| is_held(member, axis)) });
    edges.chain(holes).map(piece).unzip()
}
