//! Supports of bodies whose displacements are corrected.
//!
//! Along an edge that is held the displacement is known in place of the traction. Points hold what is left of the rigid motions and
//! no more: at a point that is held besides the stress is infinite. What displacements are corrected by moves such a body as a
//! rigid one, and that is taken back.

use crate::diagnostic::{Faults, root};
use crate::scene::Resultant;
use crate::scene::body::hold::held_body::HeldBody;
use crate::scene::body::site::boundary::is_left_out;
use crate::scene::prescribed::Motion;
use nalgebra::DMatrix;
use peristat_assembly::body::{BorderMember, Outline};

/// Singular values of what holds rigid motions that are smaller, relative to the largest, are zero.
const NONE: f64 = 1e-9;

/// Hold the body otherwise.
const HOLD: &str = "hold an edge, or the rigid motions alone: one point in both directions and another in one; symmetry holds some of them";

/// Rigid motions, each a translation along x and along y and a turn about an origin, over the size of the body.
#[derive(Clone, Debug)]
pub(crate) struct FreeMotions {
    pub(crate) motions: Vec<[f64; 3]>,
    /// Those of the holds of the conditions that are of points, not of a border.
    pub(crate) holds: Vec<usize>,
    origin: [f64; 2],
    size: f64,
}

impl FreeMotions {
    /// What a motion is at a position.
    pub(crate) fn at(&self, [x, y, turn]: [f64; 3], at: [f64; 2]) -> [f64; 2] {
        let [dx, dy] = [0, 1].map(|k| (at[k] - self.origin[k]) / self.size);
        [x - turn * dy, y + turn * dx]
    }

    /// By how much a motion turns the body, rad.
    pub(crate) fn turn(&self, [_, _, turn]: [f64; 3]) -> f64 {
        turn / self.size
    }

    /// Work of a resultant on a motion.
    pub(super) fn work(&self, [x, y, turn]: [f64; 3], load: &Resultant) -> f64 {
        let ([force_x, force_y, _], moment) = (load.force(), load.moment()[2]);
        let about = moment - self.origin[0] * force_y + self.origin[1] * force_x;
        x * force_x + y * force_y + turn * about / self.size
    }

    /// What points hold of the motions, one row each, and where these are.
    pub(super) fn works(&self, site: &HeldBody) -> (DMatrix<f64>, Vec<[f64; 2]>) {
        let holds = self.holds.iter().map(|k| &site.conditions.holds[*k]);
        let points = holds.flat_map(|hold| hold.points.iter().map(|point| (*point as usize, hold.direction)));
        let held: Vec<([f64; 2], [f64; 3])> =
            points.map(|(point, direction)| (site.model.place(point), direction)).collect();
        let work = |r: usize, c: usize| {
            let ((at, direction), motion) = (&held[r], self.motions[c]);
            let [x, y] = self.at(motion, *at);
            direction[0] * x + direction[1] * y
        };
        let works = DMatrix::from_fn(held.len(), self.motions.len(), work);
        (works, held.into_iter().map(|(at, _)| at).collect())
    }
}

/// What supports prescribe along members of the border, by axes; faults of those that hold two with one axis.
pub(super) fn along_border(
    site: &HeldBody,
    outline: &Outline,
    faults: &mut Faults,
) -> Vec<(BorderMember, usize, Motion)> {
    let mut held: Vec<(BorderMember, usize, Motion)> = Vec::new();
    for (k, support) in site.ground.case.supports.iter().enumerate() {
        let path = root("supports").index(k);
        let names = support.at.region.iter().flat_map(|names| names.each());
        let members = names.flat_map(|name| {
            let members = outline.members(name).unwrap_or_default().into_iter();
            members.filter(|member| !is_left_out(name, *member, site.ground, &site.inputs.symmetry))
        });
        let members: Vec<BorderMember> = members.collect();
        let motions = site.held.iter().find(|held| held.path == path).map_or(&[][..], |held| &held.motions);
        // Rotations have their own fault.
        let along_axes = motions.iter().filter(|(direction, ..)| direction[2] == 0.0);
        for (direction, motion, _) in along_axes.filter(|_| !members.is_empty()) {
            let Some(axis) = direction.iter().position(|share| share.abs() == 1.0) else {
                faults
                    .error(path.key("inclined"), "the limit `local` has edges that are held along x or y")
                    .hint(HOLD);
                continue;
            };
            if members.len() > 1 || held.iter().any(|(_, other, _)| *other == axis) {
                faults
                    .error(path.clone(), "the limit `local` knows the forces of one held edge along each axis: how several share them is a matter of the bonds")
                    .hint("load one of them by its traction, or leave `limit` out");
                continue;
            }
            if matches!(motion, Motion::BySteps(_)) {
                faults
                    .error(path.clone(), "the limit `local` has motions that grow with the load factor")
                    .hint("solve one step at a time");
            }
            held.extend(members.iter().map(|member| (*member, axis, motion.clone())));
        }
    }
    held
}

/// Numbers of the holds that are not of a border.
fn of_points(site: &HeldBody, outline: &Outline) -> Vec<usize> {
    let supports = site.ground.case.supports.iter().enumerate();
    let of_border = supports.filter(|(_, support)| {
        let mut names = support.at.region.iter().flat_map(|names| names.each());
        names.any(|name| outline.members(name).is_some())
    });
    let paths: Vec<String> = of_border.map(|(k, _)| format!("{}.", root("supports").index(k))).collect();
    let holds = site.conditions.holds.iter().enumerate();
    holds
        .filter(|(_, hold)| !paths.iter().any(|path| hold.origin.starts_with(path)))
        .map(|(k, _)| k)
        .collect()
}

/// The rigid motions that lines of symmetry and held edges leave; faults of points that hold more than these.
pub(super) fn check(
    site: &HeldBody,
    held: &[(BorderMember, usize, Motion)],
    outline: &Outline,
    faults: &mut Faults,
) -> FreeMotions {
    let [low, high] = outline.bounds();
    let size = (high[0] - low[0]).hypot(high[1] - low[1]);
    let mut free = FreeMotions {
        motions: vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        holds: of_points(site, outline),
        origin: low,
        size,
    };
    free.motions = left(&free, site, held, outline);
    if !site.conditions.springs.is_empty() {
        faults
            .error(
                root("supports"),
                "the limit `local` knows no springs to the ground: their forces are not among its tractions",
            )
            .hint(HOLD);
    }
    let (works, places) = free.works(site);
    let is_empty = works.is_empty();
    if is_empty != places.is_empty() || !is_empty && works.rank(NONE) < places.len() {
        faults
            .error(root("supports"), "the limit `local` needs points that hold rigid motions alone: where they hold more, stresses are infinite")
            .hint(HOLD);
    }
    free
}

/// What is left of the rigid motions.
fn left(
    all: &FreeMotions,
    site: &HeldBody,
    held: &[(BorderMember, usize, Motion)],
    outline: &Outline,
) -> Vec<[f64; 3]> {
    let mut rows = Vec::new();
    let mut row = |at: [f64; 2], axis: usize| rows.push([0, 1, 2].map(|k| all.at(all.motions[k], at)[axis]));
    for (side, at) in site.inputs.symmetry.at[..4].iter().enumerate() {
        let axis = side / 2;
        for along in at.iter().flat_map(|at| [0.0, all.size].map(|far| (*at, all.origin[1 - axis] + far))) {
            row(if axis == 0 { [along.0, along.1] } else { [along.1, along.0] }, axis);
        }
    }
    for (member, axis, _) in held {
        let parts = match *member {
            BorderMember::Edge(k) => outline.edge_parts(&outline.edges()[k]),
            BorderMember::Hole(k) | BorderMember::HoleEdge { hole: k, .. } => outline.hole_parts(k),
        };
        for part in parts {
            [0.0, 0.5, 1.0].iter().for_each(|share| row(part.at(*share), *axis));
        }
    }
    let count = rows.len().max(3);
    let matrix = DMatrix::from_fn(count, 3, |r, c| rows.get(r).map_or(0.0, |row: &[f64; 3]| row[c]));
    let svd = matrix.svd(false, true);
    let Some(vectors) = svd.v_t else { return Vec::new() };
    let free = (0..3).filter(|k| svd.singular_values[*k] <= NONE);
    free.map(|k| [vectors[(k, 0)], vectors[(k, 1)], vectors[(k, 2)]]).collect()
}
