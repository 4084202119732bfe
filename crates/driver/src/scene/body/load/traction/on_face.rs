//! Tractions on faces of solids.
//!
//! A traction does its work on the displacement of the border. Where bonds end there, each place of it moves with known points,
//! and a uniform traction on the side of a cell does the work of the place in its middle. Elsewhere the border moves with
//! the two points behind it, continued linearly, so that force and moment are exact either way.

use crate::case::Traction;
use crate::diagnostic::{Faults, JsonPath, suggest};
use crate::scene::body::hold::supports;
use crate::scene::body::load::context::LoadContext;
use crate::scene::body::load::sums::BodyLoads;
use crate::scene::body::site::resultants;
use peristat_assembly::body::{Face, PointBody, SquareLattice, plus};

/// Adds a traction on a face.
pub(crate) fn resolve(
    load: &Traction,
    context: &LoadContext,
    path: &JsonPath,
    to: &mut BodyLoads,
    faults: &mut Faults,
) {
    let place = path.key("face");
    if load.edge.is_some() {
        faults
            .error(path.key("edge"), "edges are those of bodies in the plane")
            .hint("give the `face` on which it acts");
        return;
    }
    let Some(name) = &load.face else {
        faults.error(path.clone(), "`face` is missing").hint("give the name of a face, such as `right`");
        return;
    };
    supports::not_mirrored(Some(name), &place, context.symmetry, faults);
    let Some(face) = context.ground.faces.iter().find(|face| face.name == name) else {
        let known = context.ground.faces.iter().map(|face| face.name);
        faults.error(place, format!("there is no face `{name}`")).hint(suggest(name, known));
        return;
    };
    let PointBody::Solid(lattice) = context.ground.body else { return };
    let cells = cells_at(face, lattice);
    let area = cells.len() as f64 * lattice.spacing().powi(2);
    if cells.is_empty() {
        faults.error(place, format!("nothing is left of the face `{name}`"));
        return;
    }
    let Some(traction) = value(load, face, area, context, path, faults) else { return };
    let force = traction.map(|t| t * lattice.spacing().powi(2));
    let shares = context.model.and_then(|model| model.border_shares());
    for point in cells {
        let at = on_face(face, lattice.position(point));
        resultants::add_force(context.material, &mut to.asked, force, at);
        match &shares {
            Some(shares) => {
                let Some(shares) = shares(at, face.normal()) else { continue };
                let part = |(point, share): (usize, f64)| (point as u32, force.map(|f| share * f));
                to.through_border.extend(shares.into_iter().map(part));
            }
            None => {
                let part = |(point, share): (usize, f64)| (point as u32, force.map(|f| share * f));
                to.forces.extend(behind(face, lattice, point).into_iter().map(part));
            }
        }
    }
}

/// The place of a face before a point.
fn on_face(face: &Face, mut at: [f64; 3]) -> [f64; 3] {
    at[face.axis] = face.at;
    at
}

/// Points whose cells have a side on a face.
fn cells_at(face: &Face, lattice: &SquareLattice) -> Vec<usize> {
    let half = 0.5 * lattice.spacing() * (1.0 + 1e-6);
    (0..lattice.points()).filter(|&p| (lattice.position(p)[face.axis] - face.at).abs() <= half).collect()
}

/// The points that move a place of a face before a point, and their shares.
fn behind(face: &Face, lattice: &SquareLattice, point: usize) -> Vec<(usize, f64)> {
    let mut inwards = [0; 3];
    inwards[face.axis] = if face.is_high { -1 } else { 1 };
    match lattice.number(plus(lattice.cell(point), inwards)) {
        Some(next) => vec![(point, 1.5), (next, -0.5)],
        None => vec![(point, 1.0)],
    }
}

/// Force per area along x, y and z.
fn value(
    load: &Traction,
    face: &Face,
    area: f64,
    context: &LoadContext,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<[f64; 3]> {
    const VALUES: &str = "give one of `uniform`, `pressure` and `total`";
    let of_edges = [
        ("linear", load.linear.is_some()),
        ("parabolic", load.parabolic.is_some()),
        ("hertz", load.hertz.is_some()),
        ("depth", load.depth.is_some()),
        ("sharing", load.sharing.is_some()),
    ];
    if let Some((key, _)) = of_edges.iter().find(|key| key.1) {
        faults.error(path.key(*key), format!("`{key}` is for edges in the plane")).hint(VALUES);
        return None;
    }
    let given = [
        ("uniform", load.uniform.is_some()),
        ("pressure", load.pressure.is_some()),
        ("total", load.total.is_some()),
    ];
    let keys: Vec<&str> = given.iter().filter(|g| g.1).map(|g| g.0).collect();
    let traction = match (keys.as_slice(), load) {
        ([], _) => {
            faults.error(path.clone(), "the value of this traction is missing").hint(VALUES);
            return None;
        }
        ([first, second, ..], _) => {
            let message = format!("`{first}` and `{second}` are both given");
            faults.error(path.key(*second), message).hint(VALUES);
            return None;
        }
        (_, Traction { uniform: Some(t), .. }) => {
            context.force(*t, "uniform", &path.key("uniform"), faults)?
        }
        (_, Traction { total: Some(total), .. }) => {
            context.force(*total, "total", &path.key("total"), faults)?.map(|f| f / area)
        }
        _ => face.normal().map(|n| -n * load.pressure.unwrap_or(0.0)),
    };
    if traction == [0.0; 3] {
        faults.error(path.clone(), "this traction is zero");
    }
    Some(traction)
}
