//! Doubts about borders across the rows of a lattice that families without bonds to the border hold or load: on the outermost points,
//! which stand in steps.

use crate::case::Load;
use crate::diagnostic::{Faults, JsonPath, root};
use crate::scene::body::scene::BodyScene;
use peristat_assembly::body::{BorderMember, Outline, PointBody, Shape};

/// Part of a unit vector that is rounding.
const ALONG: f64 = 1e-9;

/// Adds a warning where the first of such borders is held or loaded.
pub(super) fn warn(scene: &BodyScene, faults: &mut Faults) {
    let about = scene.material().about();
    let (Some(outline), PointBody::Lattice(lattice)) = (scene.outline(), scene.body()) else { return };
    let sees_steps = about.has_families && about.edges.is_none() && about.is_exact_at_edges;
    // Nothing else breaks.
    if !sees_steps || scene.case.is_traced() {
        return;
    }
    let supports = scene.case.supports.iter().enumerate();
    let held = supports.filter_map(|(k, support)| {
        let names = support.at.region.as_ref()?;
        Some((names.each().to_vec(), root("supports").index(k).key("at").key("region")))
    });
    let cases = scene.case.load_cases.iter().enumerate();
    let cases = cases.map(|(k, own)| (&own.loads, root("load_cases").index(k).key("loads")));
    let loads = std::iter::once((&scene.case.loads, root("loads"))).chain(cases);
    let loaded = loads.flat_map(|(loads, path)| {
        let each = loads.iter().enumerate();
        each.filter_map(move |(k, load)| {
            let Load::Traction(load) = load else { return None };
            let names = load.edge.as_ref()?.each().to_vec();
            Some((names, path.index(k).key("traction").key("edge")))
        })
    });
    let is_across = |name: &String| {
        let members = outline.members(name).unwrap_or_default();
        let own = members.into_iter().filter(|member| !is_mirror(*member, outline, scene));
        own.into_iter().any(|member| lattice.is_turned() || crosses_rows(member, outline))
    };
    let found = held.chain(loaded).find_map(|(names, path)| Some((names.into_iter().find(is_across)?, path)));
    if let Some((name, path)) = found {
        tell(&name, about.name, path, faults);
    }
}

fn tell(name: &str, model: &str, path: JsonPath, faults: &mut Faults) {
    faults
        .warning(
            path,
            format!(
                "`{name}` runs across the rows of points, and families of these edges are held and loaded there by their outermost points, up to a spacing inside: between two held spheres stresses are 9 % too large with ten spacings, 4 % with twenty"
            ),
        )
        .hint(format!("give `{model}` the edges `border`, which follow it, or many spacings to the thickness"));
}

fn is_mirror(member: BorderMember, outline: &Outline, scene: &BodyScene) -> bool {
    let symmetry = &scene.inputs.symmetry;
    let edge = matches!(member, BorderMember::Edge(_)).then(|| outline.straight(member)).flatten();
    edge.is_some_and(|edge| symmetry.replaces(&edge.name) || symmetry.joins(&edge.name))
}

/// Whether some of a part of the border runs neither along x nor along y.
fn crosses_rows(member: BorderMember, outline: &Outline) -> bool {
    let is_oblique = |normal: [f64; 2]| normal.iter().all(|n| n.abs() > ALONG);
    match member {
        BorderMember::Hole(k) => match &outline.holes()[k].shape {
            Shape::Polygon(polygon) => {
                (0..polygon.vertices().len()).any(|edge| is_oblique(polygon.normal(edge)))
            }
            Shape::Circle { .. } | Shape::Slot { .. } | Shape::Ellipse { .. } => true,
        },
        other => outline.straight(other).is_some_and(|edge| is_oblique(edge.normal)),
    }
}
