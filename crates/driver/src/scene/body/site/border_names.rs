//! Names of several parts of a border that the case uses: lists of names, the whole border, and the outer one.

use crate::case::{Case, Load, Names, Region};
use crate::diagnostic::{Faults, JsonPath, root};
use peristat_assembly::body::{BorderMember, Outline};

/// The whole border with all holes.
const ALL: &str = "all";
/// The border without holes.
const OUTER: &str = "outer";

/// Lists of names of a case with where they stand; those of places may have regions of any kind.
pub(crate) struct List<'a> {
    pub(crate) path: JsonPath,
    pub(crate) names: &'a Names,
    pub(crate) is_place: bool,
}

/// Names in a case that may be lists.
pub(crate) fn lists<'c>(case: &'c Case) -> Vec<List<'c>> {
    let mut found = Vec::new();
    let mut take = |names: Option<&'c Names>, path: JsonPath, is_place: bool| {
        found.extend(names.filter(|n| n.is_list()).map(|names| List { path, names, is_place }));
    };
    let at = |path: JsonPath| path.key("at").key("region");
    for (k, support) in case.supports.iter().enumerate() {
        take(support.at.region.as_ref(), at(root("supports").index(k)), true);
    }
    for (k, probe) in case.probes.iter().enumerate() {
        take(probe.at.region.as_ref(), at(root("probes").index(k)), true);
    }
    for (name, material) in &case.materials {
        take(material.at.as_ref(), root("materials").key(name).key("at"), true);
    }
    let of_cases = case.load_cases.iter().enumerate();
    let of_cases = of_cases.map(|(k, c)| (root("load_cases").index(k).key("loads"), &c.loads));
    for (path, loads) in std::iter::once((root("loads"), &case.loads)).chain(of_cases) {
        for (k, load) in loads.iter().enumerate() {
            let path = path.index(k);
            match load {
                Load::Point(load) => take(load.at.region.as_ref(), at(path.key("point")), true),
                Load::Line(load) => take(load.edge.as_ref(), path.key("line").key("edge"), false),
                Load::Traction(load) => take(load.edge.as_ref(), path.key("traction").key("edge"), false),
                _ => {}
            }
        }
    }
    for (name, region) in &case.regions {
        if let Region::Edge(edge) = region {
            take(Some(&edge.name), root("regions").key(name).key("edge").key("name"), false);
        }
    }
    found
}

/// Gives the outline of a case the names that it uses: what has a name already keeps it.
pub(crate) fn give(case: &Case, outline: &mut Outline, faults: &mut Faults) {
    let edges = || (0..outline.edges().len()).map(BorderMember::Edge);
    let holes = (0..outline.holes().len()).map(BorderMember::Hole);
    let (all, outer) = (edges().chain(holes).collect(), edges().collect());
    for (name, members) in [(ALL, all), (OUTER, outer)] {
        if outline.members(name).is_some() {
            faults
                .warning(
                    root("body"),
                    format!("`{name}` is a part of this outline: it does not stand for its whole border"),
                )
                .hint("give the part another name, if the whole border is meant anywhere");
        } else if !case.regions.contains_key(name) {
            outline.name_aside(name, members);
        }
    }
    for List { names, .. } in lists(case) {
        let members: Option<Vec<_>> = names.each().iter().map(|name| outline.members(name)).collect();
        if let Some(members) = members.filter(|_| outline.members(names).is_none()) {
            outline.name_aside(names, members.into_iter().flatten().collect());
        }
    }
}

/// Whether a name is that of the whole border, which leaves out what is no border: mirrors and joined sides.
pub(crate) fn is_whole(name: &str, outline: &Outline) -> bool {
    let is_aside = |name: &str| outline.groups().iter().any(|group| group.name == name && !group.is_known);
    [ALL, OUTER].contains(&name) && is_aside(name)
}

/// Edges of the outline that names have, by the names of the edges; the whole border has none that is worth a fault.
pub(crate) fn edges_of(outline: Option<&Outline>, names: &Names) -> Vec<String> {
    let mut found = Vec::new();
    for name in names.each() {
        match outline.and_then(|outline| Some((outline, outline.members(name)?))) {
            Some((outline, _)) if is_whole(name, outline) => {}
            Some((outline, members)) => {
                let edges = members.into_iter().filter(|m| matches!(m, BorderMember::Edge(_)));
                found.extend(edges.filter_map(|m| outline.straight(m)).map(|edge| edge.name));
            }
            None => found.push(name.clone()),
        }
    }
    found
}
