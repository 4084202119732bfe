//! One stress that has the tractions of all borders of a body, as one least-squares fit: of hundreds of edges neighbours are
//! all but parallel, and conditions met one after the other hand the rounding of each on to the next.

use super::lump;
use super::on_border::{OnBorder, may_be_consistent};
use super::profile::Profile;
use crate::diagnostic::Faults;
use crate::scene::body::load::context::{LoadContext, is_held};
use crate::scene::body::load::joined_sides;
use crate::scene::body::load::stress_field::traction_of;
use crate::scene::body::load::sums::Forces;
use crate::scene::body::site::boundary::{self, Border};
use nalgebra::{Matrix3, SymmetricEigen, Vector3};
use peristat_assembly::body::Edge;

/// How far a stress may miss a traction, relative to the largest one: what vertices of ten digits do to the normals of short
/// edges. What is missed acts on its edge by itself.
const SLACK: f64 = 1e-9;
/// Misses below this part of the largest traction are rounding.
const ROUNDING: f64 = 1e-13;
/// Directions of stress whose squared share in the conditions is below this part of the largest one are not settled by them.
const UNSETTLED: f64 = 1e-12;

/// A stress that acts everywhere.
pub(crate) struct UniformStress {
    /// `[S_xx, S_yy, S_xy]`, Pa.
    pub(crate) stress: [f64; 3],
    /// What acts beyond it: on edges, what supports hold there and what it misses; in a body of revolution its divergence.
    pub(crate) forces: Forces,
}

/// Linear conditions `row · S = value` on a stress.
#[derive(Default)]
struct Conditions {
    /// Those that it must meet.
    needed: Vec<(Vector3<f64>, f64)>,
    /// Those that settle it where the others do not.
    otherwise: Vec<(Vector3<f64>, f64)>,
    /// The largest value.
    size: f64,
}

impl Conditions {
    fn need(&mut self, row: [f64; 3], value: f64) {
        self.needed.push((row.into(), value));
        self.size = self.size.max(value.abs());
    }

    fn settle(&mut self, row: [f64; 3], value: f64) {
        self.otherwise.push((row.into(), value));
    }

    /// The smallest stress that meets all conditions as one fit, if there is one.
    fn met(&self) -> Option<[f64; 3]> {
        let squares = self.needed.iter().fold(Matrix3::zeros(), |sum, (row, _)| sum + row * row.transpose());
        let fit = SymmetricEigen::try_new(squares, f64::EPSILON, 100)?;
        let least = UNSETTLED * fit.eigenvalues.max();
        let directions = fit.eigenvalues.iter().copied().zip(fit.eigenvectors.column_iter());
        let kept = directions.filter(|(value, _)| *value > least).map(|(value, d)| (value, d.into_owned()));
        let (weights, mut settled): (Vec<f64>, Vec<Vector3<f64>>) = kept.unzip();
        let mut stress = Vector3::zeros();
        // What the squares lose by rounding, the same step gives back.
        for _ in 0..3 {
            let missed = |(row, value): &(Vector3<f64>, f64)| row * (value - row.dot(&stress));
            let missed: Vector3<f64> = self.needed.iter().map(missed).sum();
            stress +=
                weights.iter().zip(&settled).map(|(w, d)| d * (d.dot(&missed) / w)).sum::<Vector3<f64>>();
        }
        let missed = |(row, value): &(Vector3<f64>, f64)| (value - row.dot(&stress)).abs();
        if self.needed.iter().map(missed).any(|miss| miss > SLACK * self.size) {
            return None;
        }
        for (row, value) in &self.otherwise {
            let rest = settled.iter().fold(*row, |rest, d| rest - d * rest.dot(d));
            if rest.norm_squared() > UNSETTLED * row.norm_squared() {
                let direction = rest.normalize();
                stress += direction * ((value - row.dot(&stress)) / rest.norm());
                settled.push(direction);
            }
        }
        Some(stress.into())
    }
}

/// Rows of `(S n)_x` and `(S n)_y` by `[S_xx, S_yy, S_xy]`.
fn rows([x, y]: [f64; 2]) -> [[f64; 3]; 2] {
    [[x, 0.0, y], [0.0, y, x]]
}

/// The stress, if there is one and all tractions may be consistent.
pub(crate) fn find(tractions: &[OnBorder], context: &LoadContext) -> Option<UniformStress> {
    let outline = context.ground.outline?;
    if !tractions.iter().all(|t| may_be_consistent(t, context)) {
        return None;
    }
    let mut on_edge = vec![[0.0; 2]; outline.edges().len()];
    let mut pressure = vec![0.0; outline.holes().len()];
    for traction in tractions {
        match (&traction.border, &traction.profile) {
            (Border::Edge(edge), profile) => {
                let t = profile.constant(edge.normal)?;
                let k = outline.edges().iter().position(|e| e.name == edge.name)?;
                (0..2).for_each(|c| on_edge[k][c] += t[c]);
            }
            (Border::Curved { hole: Some(k), .. }, Profile::Pressure(p)) => {
                pressure[*k] += p;
            }
            _ => return None,
        }
    }
    let mut conditions = Conditions::default();
    for p in pressure {
        let whole = [([1.0, 0.0, 0.0], -p), ([0.0, 1.0, 0.0], -p), ([0.0, 0.0, 1.0], 0.0)];
        whole.into_iter().for_each(|(row, value)| conditions.need(row, value));
    }
    // Faces of cracks are free.
    for crack in context.cracks {
        for ends in crack.crack.vertices().windows(2) {
            let length = (ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1]);
            let normal = [(ends[0][1] - ends[1][1]) / length, (ends[1][0] - ends[0][0]) / length];
            rows(normal).into_iter().for_each(|row| conditions.need(row, 0.0));
        }
    }
    let mut real = Vec::new();
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
            conditions.need(tangential, 0.0);
            continue;
        }
        let holds = held_components(edge, context);
        for (component, row) in [x, y].into_iter().enumerate().filter(|(c, _)| !holds[*c]) {
            conditions.need(row, t[component]);
        }
        real.push((edge, *t));
    }
    along_joined_sides(&mut conditions, context);
    let stress = conditions.met()?;
    let acts = |rest: &[f64; 2]| rest.iter().any(|r| r.abs() > ROUNDING * conditions.size);
    let beyond = real.into_iter().map(|(edge, t)| (edge, beyond(t, stress, edge.normal)));
    let beyond = beyond.filter(|(_, rest)| acts(rest));
    let mut forces: Forces = beyond.flat_map(|(edge, rest)| on_edge_points(edge, rest, context)).collect();
    forces.extend(divergence(stress, context));
    Some(UniformStress { stress, forces })
}

/// Forces of the divergence that a uniform shear has in a body of revolution.
fn divergence(stress: [f64; 3], context: &LoadContext) -> Forces {
    if context.material.surface().axis().is_none() || stress[2] == 0.0 {
        return Vec::new();
    }
    let force = |p: u32| {
        let position = context.ground.body.place(p as usize);
        (p, [0.0, context.volume(p) * context.around_axis(stress, position), 0.0])
    };
    (0..context.ground.body.points() as u32).map(force).collect()
}

/// What a stress is along sides that are joined or both mirrors: that of the force through sides which move apart, and where
/// they stay, that which keeps their distance, if nothing else settles it.
fn along_joined_sides(conditions: &mut Conditions, context: &LoadContext) {
    let mirrors = context.symmetry.mirrors;
    for axis in 0..2 {
        let along = [f64::from(u8::from(axis == 0)), f64::from(u8::from(axis == 1)), 0.0];
        if mirrors.stretches[axis] {
            conditions.need(along, joined_sides::stress(axis, context).unwrap_or(0.0));
        } else if axis == 1 && context.material.cylinder_radius().is_some() {
            // A tube grows wider as it likes.
            conditions.settle(along, 0.0);
        } else if mirrors.joined[axis] || mirrors.lines[axis].iter().all(Option::is_some) {
            conditions.settle(context.material.strain_row(axis), 0.0);
        }
    }
}

/// Which components supports prescribe on all points of an edge.
fn held_components(edge: &Edge, context: &LoadContext) -> [bool; 2] {
    if context.held.is_empty() {
        return [false; 2];
    }
    let points = context.ground.region(&edge.name, &Default::default(), &mut Faults::default());
    let points = points.unwrap_or_default();
    [0, 1].map(|c| !points.is_empty() && points.iter().all(|&p| is_held(p, c, context.held)))
}

/// What a traction is beyond that of a stress.
fn beyond(t: [f64; 2], stress: [f64; 3], normal: [f64; 2]) -> [f64; 2] {
    let own = traction_of(stress, normal);
    [0, 1].map(|k| t[k] - own[k])
}

/// Forces of a uniform traction on the points of an edge.
fn on_edge_points(edge: &Edge, [x, y]: [f64; 2], context: &LoadContext) -> Forces {
    let points = context.ground.region(&edge.name, &Default::default(), &mut Faults::default());
    let stretches = boundary::of_edge(edge, context.ground);
    lump::on_points(&stretches, &|s| lump::constant([x, y, 0.0], s), &points.unwrap_or_default(), context)
}
