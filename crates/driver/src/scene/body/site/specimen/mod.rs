//! Specimens of crack tests: bodies that stand for a rectangle with a crack, regions and what holds it. They become these
//! before anything else is resolved, and nothing behind it knows of specimens.

mod centre_cracked_panel;
mod compact_tension;
mod plan;
mod single_edge_bend;

use crate::case::{Body, Case, GivenCrack, RectangleBody, Region, Rigid, Support};
use crate::diagnostic::{Faults, JsonPath, Segment, root};
use plan::Plan;

/// Name of the crack of a specimen.
const CRACK: &str = "crack";

/// What a specimen stands for.
struct SpecimenParts {
    body: RectangleBody,
    /// Path of its crack.
    crack: Vec<[f64; 2]>,
    regions: Vec<(&'static str, Region)>,
    rigid: Vec<Rigid>,
    supports: Vec<Support>,
}

/// A case without specimens.
pub(crate) struct Expanded {
    /// The case; what a specimen brings stands behind what it has of its own.
    pub(crate) case: Case,
    /// Where its specimen stands, if it had one.
    specimen: Option<JsonPath>,
    /// Names of regions that it brought.
    regions: Vec<&'static str>,
    /// Keys of lists that it has added to, and how long they were.
    lists: [(&'static str, usize); 3],
}

/// The case with its specimen taken apart, whose defaults are filled in; `None` if that has faults. `usual` is the horizon
/// per spacing of a case that says nothing.
pub(crate) fn expand(case: &mut Case, usual: f64, faults: &mut Faults) -> Option<Expanded> {
    let lists =
        [("cracks", case.cracks.len()), ("rigid", case.rigid.len()), ("supports", case.supports.len())];
    let Some(kind) = kind(&case.body) else {
        return Some(Expanded { case: case.clone(), specimen: None, regions: Vec::new(), lists });
    };
    let before = faults.errors();
    let mut body = case.body.clone();
    let horizon =
        |spacing: f64| case.horizon.unwrap_or_else(|| case.horizon_ratio.unwrap_or(usual) * spacing);
    let mut plan = Plan { path: root("body").key(kind), horizon: &horizon, faults };
    let parts = match &mut body {
        Body::CompactTension(given) => compact_tension::parts(given, &mut plan)?,
        Body::SingleEdgeBend(given) => single_edge_bend::parts(given, &mut plan)?,
        Body::CentreCrackedPanel(given) => {
            let alone = case.supports.is_empty() && case.rigid.is_empty();
            centre_cracked_panel::parts(given, alone, &mut plan)?
        }
        _ => return None,
    };
    check_names(case, &parts, faults);
    if !case.symmetry.is_empty() {
        faults
            .error(root("symmetry"), format!("`{kind}` is a whole body, which has no mirrors"))
            .hint("remove `symmetry`, or write the half as a `rectangle` with its crack and what holds it");
    }
    if faults.errors() > before {
        return None;
    }
    case.body = body;
    let mut whole = case.clone();
    let regions = parts.regions.iter().map(|r| r.0).collect();
    whole.body = Body::Rectangle(parts.body);
    whole.cracks.push(GivenCrack {
        name: Some(CRACK.into()),
        path: Some(parts.crack),
        ..GivenCrack::default()
    });
    whole.regions.extend(parts.regions.into_iter().map(|(name, region)| (name.to_string(), region)));
    whole.rigid.extend(parts.rigid);
    whole.supports.extend(parts.supports);
    Some(Expanded { case: whole, specimen: Some(root("body").key(kind)), regions, lists })
}

/// Key of a specimen in a case.
pub(crate) fn kind(body: &Body) -> Option<&'static str> {
    match body {
        Body::CompactTension(_) => Some("compact_tension"),
        Body::SingleEdgeBend(_) => Some("single_edge_bend"),
        Body::CentreCrackedPanel(_) => Some("centre_cracked_panel"),
        _ => None,
    }
}

/// Faults of names that a specimen takes.
fn check_names(case: &Case, parts: &SpecimenParts, faults: &mut Faults) {
    for (name, _) in parts.regions.iter().filter(|r| case.regions.contains_key(r.0)) {
        faults
            .error(root("regions").key(*name), format!("the specimen has a region `{name}` of its own"))
            .hint("use that one, or give this one another name");
    }
    for (k, _) in case.cracks.iter().enumerate().filter(|c| c.1.name.as_deref() == Some(CRACK)) {
        faults
            .error(
                root("cracks").index(k).key("name"),
                format!("the specimen has a crack `{CRACK}` of its own"),
            )
            .hint("give this one another name");
    }
}

impl Expanded {
    /// Moves faults of what the specimen brought to the specimen: the case does not show it.
    pub(crate) fn relocate(&self, faults: &mut Faults) {
        let Some(specimen) = &self.specimen else { return };
        faults.relocate(|path| {
            let [Segment::Key(first), rest @ ..] = &path.0[..] else { return None };
            let brought = match (first.as_str(), rest) {
                ("body", [Segment::Key(kind), rest @ ..]) if kind == "rectangle" => {
                    let is_size = matches!(rest, [Segment::Key(key)] if key == "spacing" || key == "size");
                    return Some(if is_size { specimen.key("cells") } else { specimen.clone() });
                }
                ("regions", [Segment::Key(name), ..]) => self.regions.iter().any(|r| r == name),
                (list, [Segment::Index(k), ..]) => self.lists.iter().any(|&(key, n)| key == list && *k >= n),
                (list, []) => self.lists.contains(&(list, 0)),
                _ => false,
            };
            brought.then(|| specimen.clone())
        });
    }
}
