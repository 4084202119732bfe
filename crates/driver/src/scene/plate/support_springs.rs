//! Springs of supports of a plate.

use super::border::Side;
use super::site::Site;
use crate::case::Support;
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::model::plate_bending::{PHI_X, PHI_Y, W};
use peristat_assembly::stiffness::Spring;
use std::collections::BTreeMap;

/// The springs of a support at some points, on some sides of cells.
pub(super) fn springs(
    support: &Support,
    site: &Site,
    (points, sides): (&[u32], &[Side]),
    path: &JsonPath,
    faults: &mut Faults,
) -> Vec<Spring> {
    let mut springs = Vec::new();
    if let Some(stiffness) = support.w_spring.filter(|stiffness| *stiffness > 0.0) {
        let shares = shares(site, points, sides);
        let whole: f64 = shares.values().sum();
        springs.extend(shares.iter().map(|(&p, share)| Spring::on(W, p as usize, stiffness * share / whole)));
    }
    let Some(stiffness) = support.phi_n_spring.filter(|stiffness| *stiffness > 0.0) else { return springs };
    let path = path.key("phi_n_spring");
    if sides.is_empty() {
        faults
            .error(path, "`phi_n_spring` resists the rotation across an edge, and here is none")
            .hint("name an edge");
        return springs;
    }
    if sides.iter().any(|side| !side.is_true) {
        faults
            .error(path, "`phi_n_spring` is for edges along x or y: the cells of this one are steps")
            .hint("clamp such an edge, or hold `w` alone: these bound what lies between");
        return springs;
    }
    let mut turned: BTreeMap<(usize, u32), f64> = BTreeMap::new();
    for side in sides {
        let component = if side.segment.outward[0] != 0.0 { PHI_X } else { PHI_Y };
        for point in side.segment.points {
            *turned.entry((component, point)).or_default() += 0.5 * site.nodes.spacing() * stiffness;
        }
    }
    springs.extend(turned.into_iter().map(|((component, p), k)| Spring::on(component, p as usize, k)));
    springs
}

/// What points have of the length of an edge, or of a row inside of the plate; others count alike.
fn shares(site: &Site, points: &[u32], sides: &[Side]) -> BTreeMap<u32, f64> {
    let mut shares: BTreeMap<u32, f64> = points.iter().map(|&p| (p, 0.0)).collect();
    let mut add = |[a, b]: [u32; 2], length: f64| {
        [a, b].into_iter().for_each(|p| *shares.entry(p).or_default() += 0.5 * length);
    };
    let of_side = |side: &Side| {
        let [x, y] = side.segment.outward;
        (x * side.normal[0] + y * side.normal[1]).max(0.0)
    };
    sides.iter().for_each(|side| add(side.segment.points, of_side(side)));
    if sides.is_empty() {
        site.steps_of_line(points).into_iter().for_each(|(_, step)| add(step, 1.0));
    }
    if shares.values().any(|share| *share == 0.0) {
        shares.values_mut().for_each(|share| *share = 1.0);
    }
    shares
}
