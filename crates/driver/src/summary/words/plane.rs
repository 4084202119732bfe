//! Bodies in the plane in words: the model and the forces of what holds it.

use super::{Fact, Listing, MOST_ROWS, number};
use crate::case::Units;
use crate::run::plane::PlaneReaction;
use crate::summary::{FamilySummary, OrthotropicSummary, PlaneForces, PlaneMaterialSummary, PlaneSummary};
use peristat_assembly::model::beam_bond_orthotropic::Start;
use peristat_assembly::model::bond_plane::Influence;
use peristat_assembly::model::plane::{Calibration, Edges};
use peristat_assembly::model::shell_membrane::ShellKinematics;
use peristat_assembly::model::state_based::{Axis, Dilatation, Measure, StateEdges};

/// Model, material, horizon and edges.
pub(super) fn model(m: &PlaneSummary, units: Units) -> Vec<Fact> {
    let mut told = Vec::new();
    let mut line = |key: &str, text: String| told.push((key.to_string(), text));
    let length = |value: f64| units.quantity(&number(value), units.length());
    let stress = |value: f64| units.quantity(&number(value), units.stress());
    let calibration = match m.calibration {
        Some(Calibration::Published) => "bonds with the published constant",
        _ => "bonds with the exact moduli of the material",
    };
    let t = length(m.thickness);
    let mut influence = "";
    match &m.material {
        PlaneMaterialSummary::Central { state, youngs_modulus, influence: law, .. } => {
            line("model", format!("{}, {}, {calibration}", m.name, state.replace('_', " ")));
            let nu = if *state == "plane_stress" { "1/3" } else { "1/4" };
            let e = stress(*youngs_modulus);
            line("material", format!("E = {e}, ν = {nu}, thickness {t}"));
            influence = of_influence(*law);
        }
        PlaneMaterialSummary::State(of) => {
            let (e, nu) = (stress(of.youngs_modulus), number(of.poisson_ratio));
            let (state, across) = match of.state {
                "axisymmetric" => (String::new(), String::new()),
                state => (format!(", {}", state.replace('_', " ")), format!(", thickness {t}")),
            };
            line("model", format!("{}{state}, {}", m.name, families(of)));
            line("material", format!("E = {e}, ν = {nu}{across}"));
            influence = of_influence(of.influence);
        }
        PlaneMaterialSummary::Beams(of) => {
            let calibration = match of.start {
                Some(Start::Aligned) => "bonds with the exact moduli of the material, fibres along bonds",
                Some(Start::Oblique) => "bonds with the exact moduli of the material, fibres between bonds",
                None => calibration,
            };
            line("model", format!("{}, plane stress, {calibration}", m.name));
            orthotropic(of, &mut line, &format!("thickness {t}"), stress);
        }
        PlaneMaterialSummary::Shell { youngs_modulus, radius, kinematics, bending, .. } => {
            let kinematics = match kinematics {
                ShellKinematics::Chord => "elongations of chords",
                ShellKinematics::Published => "elongations as published",
            };
            let bending = if *bending { ", rows of bending" } else { "" };
            line("model", format!("{}, {calibration}, {kinematics}{bending}", m.name));
            let (e, r) = (stress(*youngs_modulus), length(*radius));
            line("material", format!("E = {e}, ν = 1/3, thickness {t}, radius {r}"));
        }
    }
    let (ratio, horizon) = (number(m.horizon_ratio), length(m.horizon_ratio * m.spacing));
    let kind = if m.lattice { "" } else { " of listed points" };
    line("horizon", format!("{ratio} spacings{kind} = {horizon}{influence}"));
    let edges = match (m.edges, &m.material) {
        (None, PlaneMaterialSummary::Shell { .. }) if m.calibration == Some(Calibration::Matched) => {
            "every point has weights that make uniform strains exact".into()
        }
        (Some(Edges::Border), _) if m.cut_triangles > 0 => {
            format!("{} triangles have what bonds leave along the true border", m.cut_triangles)
        }
        (Some(Edges::Border), _) if m.cut_springs > 0 => {
            format!("{} springs have what bonds leave along the true border", m.cut_springs)
        }
        (Some(Edges::Border), _) => "bonds end on the border, which moves with the points beside it".into(),
        (Some(Edges::Overlay), _) => format!("{} triangles replace missing bonds", m.triangles),
        (Some(Edges::Volume), _) => "bonds are stiffened by the missing volume".into(),
        (Some(Edges::Energy), _) => "bonds are stiffened by the missing energy".into(),
        (None, PlaneMaterialSummary::State(of)) => family_edges(of),
        _ => "missing bonds are not replaced".into(),
    };
    let bare = match m.uncorrected_points {
        0 => String::new(),
        1 => ", 1 point has none".into(),
        points => format!(", {points} points have none"),
    };
    line("edges", edges + &bare);
    if m.images > 0 {
        line("images", format!("{} points are images", m.images));
    }
    if m.cracks > 0 {
        let s = if m.cracks == 1 { "" } else { "s" };
        let cut = m.cut_bonds.map_or(String::new(), |cut| format!(", {cut} bonds cut"));
        line("cracks", format!("{} crack{s}{cut}", m.cracks));
    }
    told
}

fn of_influence(influence: Influence) -> &'static str {
    match influence {
        Influence::Constant => "",
        Influence::Inverse => ", influence δ/ξ",
        Influence::Linear => ", influence 1 − ξ/δ",
    }
}

/// What families measure, in a few words.
fn families(of: &FamilySummary) -> String {
    let measure = match (of.families, of.dilatation) {
        (false, _) => "bonds alone: λ = μ",
        (true, Dilatation::Points) => "state-based families",
        (true, Dilatation::Blocks) => "state-based families, dilatation by blocks",
    };
    let rings =
        if of.measure == Measure::Published { ", neighbours by the volumes of their rings" } else { "" };
    let axis = match of.axis {
        None => "",
        Some(Axis::Table) => ", corrected at the axis",
        Some(Axis::Images) => ", images across the axis",
        Some(Axis::Truncated) => ", cut off at the axis",
    };
    format!("{measure}{rings}{axis}")
}

fn family_edges(of: &FamilySummary) -> String {
    match of.families_at_edges {
        StateEdges::Border => "families are completed along the border".into(),
        StateEdges::Ghosts => format!("{} ghosts complete the families", of.ghosts),
        StateEdges::Moment | StateEdges::MomentPlus => "weights of what is left are exact".into(),
        StateEdges::Calibrated => "families are weighed by what is left of them".into(),
        StateEdges::None => "missing neighbours are not replaced".into(),
    }
}

/// Tells an orthotropic material and its fibres.
fn orthotropic(
    m: &OrthotropicSummary,
    line: &mut impl FnMut(&str, String),
    thickness: &str,
    stress: impl Fn(f64) -> String,
) {
    let moduli = [m.youngs_modulus_1, m.youngs_modulus_2, m.shear_modulus_12].map(&stress);
    let ([e1, e2, g], nu) = (moduli, number(m.poisson_ratio_12));
    line("material", format!("E1 = {e1}, E2 = {e2}, ν12 = {nu}, G12 = {g}, {thickness}"));
    let rows = match m.lattice_angle {
        0.0 => "rows of the lattice along x".into(),
        angle => format!("rows of the lattice at {}°", number(angle)),
    };
    line("fibres", format!("at {}° from x, {rows}", number(m.fibre_angle)));
    if !m.consistent {
        let effective = stress(m.effective_shear_modulus_12);
        line("shear", format!("strain and rotation are coupled: a body acts as if G12 = {effective}"));
    }
}

/// Forces of supports, rigid regions and lines of symmetry.
pub(super) fn forces(forces: &PlaneForces, units: Units) -> Vec<Listing> {
    let of_supports = forces.reactions.iter().flat_map(|r| [r.force_x, r.force_y, r.force_w.unwrap_or(0.0)]);
    let size =
        of_supports.chain(forces.mirrors.iter().map(|m| m.force)).fold(0.0, |a: f64, f| a.max(f.abs()));
    // What is rounding beside the largest force reads as zero.
    let force = |value: f64| number(if value.abs() < 1e-11 * size { 0.0 } else { value });
    let turns = forces.reactions.iter().any(|r| r.moment.is_some());
    let deflects = forces.reactions.iter().any(|r| r.force_w.is_some());
    let row = |r: &PlaneReaction| {
        let place = match r.centre {
            Some([x, y]) => format!("{} about ({}, {})", r.place, number(x), number(y)),
            None => r.place.clone(),
        };
        let mut cells = vec![place, force(r.force_x), force(r.force_y)];
        cells.extend(turns.then(|| r.moment.map_or(String::new(), number)));
        cells.extend(deflects.then(|| r.force_w.map_or(String::new(), force)));
        cells
    };
    let mut rows: Vec<Vec<String>> = forces.reactions.iter().take(MOST_ROWS).map(row).collect();
    for mirror in &forces.mirrors {
        let across = force(mirror.force);
        let is_x = matches!(&*mirror.side, "left" | "right");
        let (x, y) = if is_x { (across, String::new()) } else { (String::new(), across) };
        let mut cells = vec![format!("symmetry `{}`", mirror.side), x, y];
        cells.extend((turns || deflects).then(String::new));
        rows.push(cells);
    }
    let third = if deflects { units.label("force w", "N") } else { units.label("moment", units.moment()) };
    let [x, y] = ["force x", "force y"].map(|name| units.label(name, "N"));
    let header = ["support", x.as_str(), y.as_str(), third.as_str()];
    let header = &header[..if turns || deflects { 4 } else { 3 }];
    let count = forces.reactions.len() + forces.mirrors.len();
    Listing::new(header, rows, count, "supports").into_iter().collect()
}
