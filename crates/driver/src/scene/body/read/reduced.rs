//! Probes of what is made of a field over a region or the whole body.

use super::fields::{self, Says};
use super::probes::Quantity;
use crate::case::{FieldName, Probe, Reduction};
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::body::hold::held_body::HeldBody;
use crate::scene::words;

/// What a probe reads that makes `of` of a field that there is, and its place in words.
pub(super) fn resolve(
    probe: &Probe,
    of: Reduction,
    site: &HeldBody,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(Quantity, String)> {
    let (ground, field, at) = (site.ground, probe.field, path.key("at"));
    let name = ground.region_name(&probe.at, &at, faults)?;
    if name.is_none() && !probe.at.is_nowhere() {
        faults.error(path.key("of"), "`of` is for a region or the whole body, and this is a point").hint(
            "a point has one value: leave `of` out; or name a region, or leave `at` out for the whole body",
        );
        return None;
    }
    if field == FieldName::PrincipalDirection {
        faults
            .error(
                path.key("of"),
                "a direction has neither extremes nor a mean: −π/2 and π/2 are the same one",
            )
            .hint("without `of` a region answers with the direction of its mean stress");
        return None;
    }
    let fits = |field: &FieldName| *field != FieldName::PrincipalDirection;
    let there_are: Vec<FieldName> =
        fields::answered(site.model, Says::of(ground.case, &*site.inputs.material)).filter(fits).collect();
    if !there_are.contains(&field) {
        faults
            .error(
                path.key("of"),
                format!("`{}` is no field of all points, so there is nothing to make of it", field.name()),
            )
            .hint(format!("leave `of` out, or take another field: {}", words::there_are(&there_are)));
        return None;
    }
    let (points, words) = match name {
        Some(name) => (Some(ground.region(name, &at.key("region"), faults)?), format!("the region `{name}`")),
        None => (None, "the body".to_string()),
    };
    Some((Quantity::Reduced { field, of, points }, words))
}
