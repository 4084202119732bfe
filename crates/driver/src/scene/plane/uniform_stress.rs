//! One stress that has the tractions of all borders of a body.

use super::boundary::{self, Border};
use super::fading::around_axis;
use super::loads::{Context, is_held};
use super::lump::{self, Forces};
use super::periodic;
use super::traction::{OnBorder, Profile, may_be_consistent};
use crate::diagnostic::Faults;
use peristat_assembly::body::Edge;

/// How far a stress may miss a traction, relative to the largest one.
const SLACK: f64 = 1e-12;

/// A stress that acts everywhere.
pub(super) struct UniformStress {
    /// `[S_xx, S_yy, S_xy]`, Pa.
    pub(super) stress: [f64; 3],
    /// What it does to edges that supports hold, taken back there, and its divergence in a body of revolution.
    pub(super) forces: Forces,
}

/// Linear conditions on a stress, met one after the other by the smallest change.
struct Conditions {
    stress: [f64; 3],
    /// Directions in which it is settled, orthonormal.
    settled: Vec<[f64; 3]>,
    slack: f64,
}

impl Conditions {
    /// Whether `row · S = value` can be met together with all before.
    fn meet(&mut self, row: [f64; 3], value: f64) -> bool {
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let mut rest = row;
        for direction in &self.settled {
            let share = dot(rest, *direction);
            (0..3).for_each(|k| rest[k] -= share * direction[k]);
        }
        let (size, missing) = (dot(rest, rest).sqrt(), value - dot(row, self.stress));
        if size < 1e-9 {
            return missing.abs() <= self.slack;
        }
        let direction = rest.map(|r| r / size);
        (0..3).for_each(|k| self.stress[k] += missing / size * direction[k]);
        self.settled.push(direction);
        true
    }
}

/// Rows of `(S n)_x` and `(S n)_y` by `[S_xx, S_yy, S_xy]`.
fn rows([x, y]: [f64; 2]) -> [[f64; 3]; 2] {
    [[x, 0.0, y], [0.0, y, x]]
}

/// The stress, if there is one and all tractions may be consistent.
pub(super) fn find(tractions: &[OnBorder], context: &Context) -> Option<UniformStress> {
    let outline = context.ground.outline?;
    if !tractions.iter().all(|t| may_be_consistent(t, context)) {
        return None;
    }
    let mut size = 0.0_f64;
    let mut on_edge = vec![[0.0; 2]; outline.edges().len()];
    let mut pressure = vec![0.0; outline.holes().len()];
    for traction in tractions {
        match (&traction.border, &traction.profile) {
            (Border::Edge(edge), profile) => {
                let t = profile.constant(edge.normal)?;
                let k = outline.edges().iter().position(|e| e.name == edge.name)?;
                (0..2).for_each(|c| on_edge[k][c] += t[c]);
                size = size.max(t[0].abs()).max(t[1].abs());
            }
            (Border::Curved { hole: Some(k), .. }, Profile::Pressure(p)) => {
                pressure[*k] += p;
                size = size.max(p.abs());
            }
            _ => return None,
        }
    }
    let mut conditions = Conditions { stress: [0.0; 3], settled: Vec::new(), slack: SLACK * size };
    for p in pressure {
        let fine = [([1.0, 0.0, 0.0], -p), ([0.0, 1.0, 0.0], -p), ([0.0, 0.0, 1.0], 0.0)]
            .into_iter()
            .all(|(row, value)| conditions.meet(row, value));
        if !fine {
            return None;
        }
    }
    // Faces of cracks are free.
    for crack in context.cracks {
        for ends in crack.crack.vertices().windows(2) {
            let length = (ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1]);
            let normal = [(ends[0][1] - ends[1][1]) / length, (ends[1][0] - ends[0][0]) / length];
            if !rows(normal).into_iter().all(|row| conditions.meet(row, 0.0)) {
                return None;
            }
        }
    }
    let mut held = Vec::new();
    for (edge, t) in outline.edges().iter().zip(&on_edge) {
        let [x, y] = rows(edge.normal);
        if context.symmetry.joins(&edge.name) {
            // What the stress does on one of two joined edges, it takes back on the other.
            continue;
        }
        if context.symmetry.replaces(&edge.name) {
            // A mirror holds what is normal to it; along it nothing acts.
            let [nx, ny] = edge.normal;
            let tangential = [0, 1, 2].map(|k| nx * y[k] - ny * x[k]);
            if !conditions.meet(tangential, 0.0) {
                return None;
            }
            continue;
        }
        let holds = held_components(edge, context);
        for (component, row) in [x, y].into_iter().enumerate() {
            if !holds[component] && !conditions.meet(row, t[component]) {
                return None;
            }
        }
        if holds != [false; 2] {
            held.push((edge, *t));
        }
    }
    if !meet_along_joined_sides(&mut conditions, size, context) {
        return None;
    }
    let stress = conditions.stress;
    let mut forces: Forces =
        held.iter().flat_map(|(edge, t)| taken_back(edge, *t, stress, context)).collect();
    forces.extend(divergence(stress, context));
    Some(UniformStress { stress, forces })
}

/// Forces of the divergence that a uniform shear has in a body of revolution.
fn divergence(stress: [f64; 3], context: &Context) -> Forces {
    if !context.bonds.is_revolved() || stress[2] == 0.0 {
        return Vec::new();
    }
    let force = |p: u32| {
        let position = context.ground.body.position(p as usize);
        (p, [0.0, context.volume(p) * around_axis(stress, position, context)])
    };
    (0..context.ground.body.points() as u32).map(force).collect()
}

/// What a stress is along sides that are joined or both mirrors: that of the force through sides which move apart, and where
/// they stay, that which keeps their distance, if nothing else settles it. False where the force asks for another one.
fn meet_along_joined_sides(conditions: &mut Conditions, size: f64, context: &Context) -> bool {
    let mirrors = context.symmetry.mirrors;
    for axis in 0..2 {
        let along = [f64::from(u8::from(axis == 0)), f64::from(u8::from(axis == 1)), 0.0];
        if mirrors.stretches[axis] {
            let wanted = periodic::stress(axis, context).unwrap_or(0.0);
            conditions.slack = SLACK * size.max(wanted.abs());
            if !conditions.meet(along, wanted) {
                return false;
            }
        } else if axis == 1 && context.bonds.deflects() {
            // A tube grows wider as it likes.
            conditions.meet(along, 0.0);
        } else if mirrors.joined[axis] || mirrors.lines()[axis].iter().all(Option::is_some) {
            conditions.meet(context.bonds.strain_row(axis), 0.0);
        }
    }
    true
}

/// Which components supports prescribe on all points of an edge.
fn held_components(edge: &Edge, context: &Context) -> [bool; 2] {
    if context.held.is_empty() {
        return [false; 2];
    }
    let points = context.ground.region(&edge.name, &Default::default(), &mut Faults::default());
    let points = points.unwrap_or_default();
    [0, 1].map(|c| !points.is_empty() && points.iter().all(|&p| is_held(p, c, context.held)))
}

/// Forces of what acts on a held edge beyond the stress.
fn taken_back(edge: &Edge, t: [f64; 2], stress: [f64; 3], context: &Context) -> Forces {
    let own = traction_of(stress, edge.normal);
    let rest = [0, 1].map(|k| t[k] - own[k]);
    let points = context.ground.region(&edge.name, &Default::default(), &mut Faults::default());
    let stretches = boundary::of_edge(edge, context.ground);
    lump::on_points(&stretches, &|s| lump::constant(rest, s), &points.unwrap_or_default(), context)
}

/// `S n`.
pub(super) fn traction_of([xx, yy, xy]: [f64; 3], [x, y]: [f64; 2]) -> [f64; 2] {
    [xx * x + xy * y, xy * x + yy * y]
}
