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
    for side in sides {
        let stiffness = 0.5 * site.nodes.spacing() * length(side) * stiffness;
        let spring = |point: u32| match (side.is_true, side.segment.outward) {
            (true, [0.0, _]) => Spring::on(PHI_Y, point as usize, stiffness),
            (true, _) => Spring::on(PHI_X, point as usize, stiffness),
            // The lengths of the steps of a round or slanted edge add up to its own.
            (false, _) => {
                let [x, y] = side.normal;
                Spring { point: point as usize, shares: [(PHI_X, x), (PHI_Y, y)], stiffness }
            }
        };
        springs.extend(side.segment.points.into_iter().filter(|_| stiffness > 0.0).map(spring));
    }
    springs
}

/// What a side of a cell has of the length of the edge that it stands for, over its own.
fn length(side: &Side) -> f64 {
    let [x, y] = side.segment.outward;
    (x * side.normal[0] + y * side.normal[1]).max(0.0)
}

/// What points have of the length of an edge, or of a row inside of the plate; others count alike.
fn shares(site: &Site, points: &[u32], sides: &[Side]) -> BTreeMap<u32, f64> {
    let mut shares: BTreeMap<u32, f64> = points.iter().map(|&p| (p, 0.0)).collect();
    let mut add = |[a, b]: [u32; 2], length: f64| {
        [a, b].into_iter().for_each(|p| *shares.entry(p).or_default() += 0.5 * length);
    };
    sides.iter().for_each(|side| add(side.segment.points, length(side)));
    if sides.is_empty() {
        site.steps_of_line(points).into_iter().for_each(|(_, step)| add(step, 1.0));
    }
    if shares.values().any(|share| *share == 0.0) {
        shares.values_mut().for_each(|share| *share = 1.0);
    }
    shares
}
