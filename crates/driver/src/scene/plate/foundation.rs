//! Winkler foundations under plates.

use super::site::Site;
use crate::diagnostic::{Faults, root};
use peristat_assembly::model::plate_bending::W;
use peristat_assembly::stiffness::Spring;

/// Springs under all points: their areas times the stiffness.
pub(super) fn springs(site: &Site, faults: &mut Faults) -> Vec<Spring> {
    let mut stiffness = 0.0;
    for (k, bed) in site.case.foundation.iter().enumerate() {
        let path = root("foundation").index(k);
        let keys = [
            ("member", bed.member.is_some()),
            ("from", bed.from.is_some()),
            ("to", bed.to.is_some()),
            ("only", bed.only.is_some()),
        ];
        for (key, _) in keys.iter().filter(|key| key.1) {
            faults
                .error(path.key(*key), format!("`{key}` is for foundations of beams"))
                .hint("the foundation of a plate is under all of it, and pushes and pulls");
        }
        match bed.stiffness.uniform() {
            Some(value) if value >= 0.0 => stiffness += value,
            Some(value) => {
                faults.error(
                    path.key("stiffness"),
                    format!("the stiffness of a foundation must not be negative, found {value}"),
                );
            }
            None => {
                faults
                    .error(path.key("stiffness"), "the foundation of a plate is the same everywhere")
                    .hint("give { \"uniform\": … }, force per area and deflection");
            }
        }
    }
    let points = 0..if stiffness > 0.0 { site.nodes.points() } else { 0 };
    points.map(|p| Spring::on(W, p, stiffness * site.nodes.area(p))).collect()
}
