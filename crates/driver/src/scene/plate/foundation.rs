//! Winkler foundations under plates.

use super::site::Site;
use crate::case::{Amount, BedStiffness};
use crate::diagnostic::{Faults, JsonPath, root, tidy};
use crate::scene::prescribed::Prescribed;
use peristat_assembly::model::plate_bending::{Bed, EdgeSegment};
use peristat_assembly::stiffness::Spring;

/// Springs under all points. The bed goes on behind lines of symmetry, which are no edges.
pub(super) fn springs(site: &Site, faults: &mut Faults) -> Vec<Spring> {
    if site.case.foundation.is_empty() {
        return Vec::new();
    }
    let mut stiffness = vec![0.0; site.nodes.points()];
    let mirrors: Vec<_> = site.case.symmetry.iter().filter_map(|name| site.sides(name)).flatten().collect();
    let is_mirror = |segment: &EdgeSegment| mirrors.iter().any(|side| side.segment == *segment);
    let bed = Bed::new(site.nodes, site.nodes.edges().into_iter().filter(|segment| !is_mirror(segment)));
    for (k, given) in site.case.foundation.iter().enumerate() {
        let path = root("foundation").index(k);
        let keys = [
            ("member", given.member.is_some()),
            ("from", given.from.is_some()),
            ("to", given.to.is_some()),
            ("only", given.only.is_some()),
        ];
        for (key, _) in keys.iter().filter(|key| key.1) {
            faults
                .error(path.key(*key), format!("`{key}` is for foundations of beams"))
                .hint("the foundation of a plate is under all of it, and pushes and pulls");
        }
        if let Some(own) = stiffness_of(&given.stiffness, &bed, &path.key("stiffness"), faults) {
            stiffness.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
        }
    }
    bed.springs(&stiffness)
}

/// Force per area and deflection at every point.
fn stiffness_of(given: &BedStiffness, bed: &Bed, path: &JsonPath, faults: &mut Faults) -> Option<Vec<f64>> {
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
        let [x, y] = bed.place(p);
        let value = given.at([x, y, 0.0])?;
        let place = match given {
            Prescribed::Number(_) => String::new(),
            Prescribed::Formula(_) => format!(" at the point ({}, {})", tidy(x), tidy(y)),
        };
        let message =
            format!("the stiffness of a foundation must not be negative, found {}{place}", tidy(value));
        if value < 0.0 { Err(message) } else { Ok(value) }
    };
    let values: Result<Vec<f64>, String> = (0..bed.points()).map(at).collect();
    let refuse = |reason| {
        faults.error(path, reason);
    };
    values.map_err(refuse).ok()
}
