//! Doubts about a plate that is solved all the same.

use super::site::Site;
use crate::case::{Load, Support};
use crate::diagnostic::{Faults, JsonPath, root, tidy};
use peristat_assembly::body::BorderMember;
use peristat_assembly::model::plate_bending::{PlateParameters, ShearLaw};

/// Horizon ratios above this have bonds that pass over points.
const NEXT: f64 = 1.5;
/// A warning tells of springs across steps with a `k h` above this part of the bending stiffness: deflections are half a per cent off there.
const STIFF: f64 = 0.5;

/// Adds the doubts.
pub(super) fn collect(site: &Site, (parameters, thickness): (&PlateParameters, f64), faults: &mut Faults) {
    let (h, ratio) = (site.nodes.spacing(), parameters.horizon_ratio);
    let model = site.case.model.name();
    if parameters.shear_law == ShearLaw::Published && ratio * h > thickness {
        faults
            .warning(
                root("model").key(model).key("shear_law"),
                format!(
                    "the horizon {} is longer than the plate is thick, {}: as published it locks, and deflects too little, in thin plates by nearly all",
                    tidy(ratio * h),
                    tidy(thickness)
                ),
            )
            .hint("use `corrected`, the default, or a spacing below the thickness over the horizon ratio");
    }
    if ratio > NEXT + 1e-9 && !site.case.symmetry.is_empty() {
        faults
            .warning(
                root("symmetry"),
                "bonds longer than those to the next points are cut at lines of symmetry: shear forces beside these are off by 9 per cent with three spacings per horizon",
            )
            .hint("use a `horizon_ratio` of 1.5, the default, with which a part is the whole plate exactly");
    }
    beside_the_border(site, faults);
    for (path, load) in all_loads(site) {
        if matches!(load, Load::Point(load) if load.force != 0.0) && ratio > NEXT + 1e-9 {
            faults
                .warning(
                    path.key("point"),
                    "bonds pass over the point that is loaded: its deflection is too large, at 16 cells along a side by 3 to 6 per cent",
                )
                .hint("use a `horizon_ratio` of 1.5, the default, or spread the force over a region");
        }
    }
    on_edges(site, (parameters.section.bending, thickness), faults);
}

/// Doubts about supports of edges of a plate with a bending stiffness and a thickness.
fn on_edges(site: &Site, (bending, thickness): (f64, f64), faults: &mut Faults) {
    let h = site.nodes.spacing();
    for (k, support) in site.case.supports.iter().enumerate() {
        let Some(sides) = support.at.region.as_ref().and_then(|name| site.sides(name)) else { continue };
        let Support { w, phi_x, phi_y, phi_n, phi_t, .. } = support;
        let turns = [phi_x, phi_y, phi_n, phi_t].iter().any(|given| given.is_some());
        let path = root("supports").index(k);
        if w.is_some() && !turns && thickness < 2.0 * h && sides.iter().any(|side| side.is_true) {
            faults
                .warning(
                    path.clone(),
                    "beside a simple support that lets the edge turn along itself, thin plates have a layer as wide as they are thick, which this spacing does not resolve",
                )
                .hint("add `phi_t`: 0.0, the hard simple support, to which thin plates tend");
        }
        let has_steps = sides.iter().any(|side| !side.is_true);
        if w.is_some() && turns && has_steps {
            faults
                .warning(path.clone(), "the cells of this edge are steps: with a clamp on it deflections are off by 4, 1.5 and 1 per cent at 8, 20 and 30 cells along the radius of a round one, by 10 and 3 at 8 and 20 of a slanted one, and by 7, 5 and 4 where it turns or moves by a formula")
                .hint("use a small spacing");
        }
        if support.phi_n_spring.is_some_and(|stiffness| stiffness * h > STIFF * bending) && has_steps {
            faults
                .warning(path.key("phi_n_spring"), "the cells of this edge are steps, and the spring resists more than the plate within one of them: deflections are off by up to 16, 7 and 3 per cent at 8, 20 and 40 cells along the radius")
                .hint("use a smaller spacing, or clamp the edge with `phi_n` and `phi_t`");
        }
    }
}

/// A border that is not where the case has it: doubts about edges between rows of points, faults for holes between middles of cells.
fn beside_the_border(site: &Site, faults: &mut Faults) {
    let Site { outline, nodes, border, .. } = site;
    let hole_words = |hole: usize| match &outline.holes()[hole].name {
        Some(name) => format!("the hole `{name}`"),
        None => format!("hole {}", hole + 1),
    };
    let mut moved = border.moved(nodes);
    moved.retain(|(member, _)| !matches!(member, BorderMember::Edge(k) if outline.edges()[*k].is_chord));
    for (member, distance) in moved {
        let words = match member {
            BorderMember::Edge(k) => format!("the edge `{}`", outline.edges()[k].name),
            BorderMember::Hole(hole) => hole_words(hole),
            BorderMember::HoleEdge { hole, edge } => format!("edge {} of {}", edge + 1, hole_words(hole)),
        };
        let message =
            format!("{words} lies between rows of points: the plate ends {} beside it", tidy(distance));
        faults.warning(root("body"), message).hint("use a spacing of which all lengths are multiples");
    }
    for hole in (0..outline.holes().len()).filter(|hole| !border.has_hole(*hole)) {
        let message = format!("no cell has its centre in {}: it would do nothing", hole_words(hole));
        faults.error(root("body"), message).hint("use a smaller spacing");
    }
}

/// All loads with their paths.
fn all_loads<'a>(site: &'a Site) -> impl Iterator<Item = (JsonPath, &'a Load)> {
    let own = site.case.loads.iter().enumerate().map(|(k, load)| (root("loads").index(k), load));
    let of_cases = site.case.load_cases.iter().enumerate().flat_map(|(c, load_case)| {
        let path = root("load_cases").index(c).key("loads");
        load_case.loads.iter().enumerate().map(move |(k, load)| (path.index(k), load))
    });
    own.chain(of_cases)
}
