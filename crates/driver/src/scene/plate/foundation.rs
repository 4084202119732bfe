//! Winkler foundations under plates.

use super::site::Site;
use crate::case::{Amount, BedStiffness};
use crate::diagnostic::{Faults, JsonPath, root, tidy};
use crate::scene::prescribed::Prescribed;
use peristat_assembly::model::plate_bending::W;
use peristat_assembly::stiffness::Spring;

/// Springs under all points: their areas times the stiffness there.
pub(super) fn springs(site: &Site, faults: &mut Faults) -> Vec<Spring> {
    let mut stiffness = vec![0.0; site.nodes.points()];
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
        if let Some(own) = stiffness_of(&bed.stiffness, site, &path.key("stiffness"), faults) {
            stiffness.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
        }
    }
    let acting = stiffness.into_iter().enumerate().filter(|(_, value)| *value > 0.0);
    acting.map(|(p, value)| Spring::on(W, p, value * site.nodes.area(p))).collect()
}

/// Force per area and deflection at every point.
fn stiffness_of(given: &BedStiffness, site: &Site, path: &JsonPath, faults: &mut Faults) -> Option<Vec<f64>> {
    let (given, path) = match given {
        BedStiffness::Uniform(value) => (Amount::Number(*value), path.key("uniform")),
        BedStiffness::Formula(text) => (Amount::Formula(text.clone()), path.key("formula")),
        BedStiffness::Polynomial(_) | BedStiffness::Table(_) => {
            faults
                .error(path.clone(), "the foundation of a plate has no start from which distances are")
                .hint(
                    "give { \"uniform\": … } or { \"formula\": … } of x and y, force per area and deflection",
                );
            return None;
        }
    };
    let given = Prescribed::new(&given, (2, None), &path, faults)?;
    let at = |p: usize| {
        let [x, y] = site.nodes.place(p);
        let value = given.at([x, y, 0.0])?;
        let place = match given {
            Prescribed::Number(_) => String::new(),
            Prescribed::Formula(_) => format!(" at the point ({}, {})", tidy(x), tidy(y)),
        };
        let message =
            format!("the stiffness of a foundation must not be negative, found {}{place}", tidy(value));
        if value < 0.0 { Err(message) } else { Ok(value) }
    };
    let values: Result<Vec<f64>, String> = (0..site.nodes.points()).map(at).collect();
    let refuse = |reason| {
        faults.error(path, reason);
    };
    values.map_err(refuse).ok()
}
