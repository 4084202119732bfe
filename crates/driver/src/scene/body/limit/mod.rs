//! The limit of local elasticity: what is known on the border of a body whose displacements are corrected, and which bodies can be.

mod corners;
mod refuse;
mod supports;

use super::hold::held_body::HeldBody;
use super::load::traction::on_border::OnBorder;
use super::load::traction::profile::Profile;
use super::scene::BodyState;
use super::site::boundary::{self, Border};
use crate::diagnostic::Faults;
use peristat_assembly::body::{BorderMember, Edge, Outline};
use peristat_assembly::correction::{BorderPiece, Sample};

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
    pub(super) fn resolve(site: &HeldBody, tractions: &[&[OnBorder]], faults: &mut Faults) -> Option<Self> {
        let case = site.ground.case;
        refuse::check_keys(case, faults);
        if case.limit.is_nonlocal() {
            return None;
        }
        let corrections = case.corrections.unwrap_or(USUAL);
        let outline = refuse::body(site, faults)?;
        refuse::loads(case, faults);
        supports::check(site, faults);
        let (members, pieces) = pieces(outline, site);
        corners::check(&pieces, site.ground.body.spacing(), faults);
        let acting = |on: &&[OnBorder]| on.iter().filter_map(|on| Acting::new(on, outline, faults)).collect();
        let tractions = tractions.iter().map(acting).collect();
        Some(Self { corrections, pieces, members, tractions })
    }

    /// Tractions of a state at samples of the border, Pa.
    pub(crate) fn known(&self, state: &BodyState, samples: &[Sample]) -> Vec<[f64; 2]> {
        let at = |sample: &Sample| {
            let member = self.members[sample.piece];
            let terms = state.terms.iter().flat_map(|&(case, factor)| {
                let own = self.tractions[case].iter().filter(move |acting| acting.member == member);
                own.map(move |acting| (acting, factor))
            });
            terms.fold([0.0; 2], |sum, (acting, factor)| {
                let traction = acting.at(sample);
                [0, 1].map(|k| sum[k] + factor * traction[k])
            })
        };
        samples.iter().map(at).collect()
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

/// The border of a body by its members, lines of symmetry left out.
fn pieces(outline: &Outline, site: &HeldBody) -> (Vec<BorderMember>, Vec<BorderPiece>) {
    let edges = outline.edges().iter().enumerate();
    let edges = edges.filter(|(_, edge)| !site.inputs.symmetry.replaces(&edge.name));
    let edges = edges
        .flat_map(|(k, edge)| outline.edge_parts(edge).into_iter().map(move |p| (BorderMember::Edge(k), p)));
    let holes = (0..outline.holes().len())
        .flat_map(|k| outline.hole_parts(k).into_iter().map(move |p| (BorderMember::Hole(k), p)));
    edges.chain(holes).map(|(member, part)| (member, BorderPiece { part, held: [false; 2] })).unzip()
}
