//! Motions that nothing holds, found before anything is factorised.

use super::System;
use super::elimination::Elimination;
use crate::bonds::Point;
use crate::model::Model;
use crate::stiffness::{ConnectedParts, NumberedParts};

/// A motion that costs no energy and no constraint prevents.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeMotion {
    /// First and last point of every part that moves.
    pub parts: Vec<[usize; 2]>,
    /// The motion of every part that moves, in the order of `parts`.
    pub moves: Vec<PartMotion>,
}

/// How one part moves.
#[derive(Clone, Debug, PartialEq)]
pub struct PartMotion {
    /// Centre that its rotation is about.
    pub centre: Point,
    /// Amount of each of the model's rigid motions; zero where it does not matter.
    pub amounts: Vec<f64>,
}

impl FreeMotion {
    /// How it moves the unknowns of a point; `parts` are those of the model.
    pub fn at<const D: usize>(&self, model: &dyn Model<D>, parts: &NumberedParts, point: usize) -> [f64; D] {
        let (mut sum, own) = ([0.0; D], parts.of(point));
        if let Some(k) = self.parts.iter().position(|span| parts.of(span[0]) == own) {
            let PartMotion { centre, amounts } = &self.moves[k];
            for (kind, amount) in amounts.iter().enumerate().filter(|a| *a.1 != 0.0) {
                let unit = model.rigid_motion(kind, point, *centre);
                (0..D).for_each(|c| sum[c] += amount * unit[c]);
            }
        }
        sum
    }
}

/// All independent free motions of a system.
pub fn free_motions<const D: usize>(model: &dyn Model<D>, system: &System<D>) -> Vec<FreeMotion> {
    motions(model, system, true)
}

/// All independent motions that no constraint prevents and that cost no energy but that of springs to the ground.
pub fn sprung_motions<const D: usize>(model: &dyn Model<D>, system: &System<D>) -> Vec<FreeMotion> {
    motions(model, system, false)
}

fn motions<const D: usize>(model: &dyn Model<D>, system: &System<D>, springs_hold: bool) -> Vec<FreeMotion> {
    let mut parts = ConnectedParts::new(system.points());
    system.terms().iter().for_each(|t| t.join(&mut parts));
    let parts = parts.numbered();
    let (spans, count) = (parts.spans(), parts.spans().len());
    let centres: Vec<Point> = spans
        .iter()
        .map(|&[a, b]| {
            let (a, b) = (model.position(a), model.position(b));
            std::array::from_fn(|k| 0.5 * (a[k] + b[k]))
        })
        .collect();
    let kinds = model.rigid_motions().len();
    // Amounts of the motions of every part are unknowns; each is measured by how far it moves the end of its part.
    let scales = scales(model, spans, &centres);
    let amounts = |unknown: usize, coefficient: f64| {
        let (component, point) = (unknown / system.points(), unknown % system.points());
        let part = parts.of(point);
        let (scales, centre) = (&scales, centres[part]);
        (0..kinds).map(move |kind| {
            let value = model.rigid_motion(kind, point, centre)[component] / scales[part * kinds + kind];
            (kind * count + part, coefficient * value)
        })
    };
    let mut held: Vec<Vec<(usize, f64)>> = system.constraints().equations().to_vec();
    for term in system.terms().iter().filter(|_| springs_hold) {
        term.ground_motions(&mut |motion| {
            let number = |&(component, point, share)| (component * system.points() + point, share);
            held.push(motion.iter().map(number).collect());
        });
    }
    let mut elimination = Elimination::new(count * kinds);
    for part in 0..count {
        for kind in superfluous(model, spans[part], centres[part]) {
            elimination.add(&[(kind * count + part, 1.0)]);
        }
    }
    for equation in &held {
        let mut terms: Vec<(usize, f64)> =
            equation.iter().flat_map(|&(unknown, c)| amounts(unknown, c)).collect();
        // The largest coefficient is the safest one to divide by.
        terms.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
        elimination.add(&terms);
    }
    let free = elimination.free().into_iter();
    free.map(|unknown| {
        let motion = elimination.solution(unknown);
        // From component planes to parts.
        let sizes: Vec<f64> = (0..count * kinds).map(|k| motion[(k % kinds) * count + k / kinds]).collect();
        describe(&sizes, &scales, spans, &centres)
    })
    .collect()
}

/// Kinds of motions that are none of a part: they move neither of its ends, such as a rotation of a single point that has no
/// unknown for it; or they move a single point as others do.
fn superfluous<const D: usize>(model: &dyn Model<D>, [first, last]: [usize; 2], centre: Point) -> Vec<usize> {
    /// What is left of a motion below this part of it is rounding.
    const ROUNDING: f64 = 1e-9;
    let size = |v: &[f64; D]| v.iter().map(|v| v * v).sum::<f64>().sqrt();
    // Orthonormal motions of the first point.
    let mut known: Vec<[f64; D]> = Vec::new();
    let is_superfluous = |kind: &usize| {
        let [own, other] = [first, last].map(|point| model.rigid_motion(*kind, point, centre));
        if first != last {
            return size(&own) == 0.0 && size(&other) == 0.0;
        }
        let mut rest = own;
        for direction in &known {
            let share: f64 = rest.iter().zip(direction).map(|(a, b)| a * b).sum();
            (0..D).for_each(|c| rest[c] -= share * direction[c]);
        }
        let left = size(&rest);
        let is_known = left <= ROUNDING * size(&own);
        if !is_known {
            known.push(rest.map(|v| v / left));
        }
        is_known
    };
    (0..model.rigid_motions().len()).filter(is_superfluous).collect()
}

/// How far a unit of every motion moves the end of its part.
fn scales<const D: usize>(model: &dyn Model<D>, spans: &[[usize; 2]], centres: &[Point]) -> Vec<f64> {
    let scale = |part: usize, kind: usize| {
        let displacement = model.displacement(kind, spans[part][1], centres[part]);
        // A part of one point has nothing that its rotation moves.
        if displacement > 0.0 { displacement } else { 1.0 }
    };
    let kinds = model.rigid_motions().len();
    (0..spans.len() * kinds).map(|k| scale(k / kinds, k % kinds)).collect()
}

/// A free motion from the displacements `sizes` that it makes at the ends of the parts, one per part and kind.
fn describe(sizes: &[f64], scales: &[f64], spans: &[[usize; 2]], centres: &[Point]) -> FreeMotion {
    let kinds = sizes.len() / spans.len();
    let least = 1e-6 * sizes.iter().fold(f64::MIN_POSITIVE, |a, s| a.max(s.abs()));
    let matters = |part: usize, kind: usize| sizes[part * kinds + kind].abs() > least;
    let moving: Vec<usize> =
        (0..spans.len()).filter(|&part| (0..kinds).any(|kind| matters(part, kind))).collect();
    let amount = |part: usize, kind: usize| {
        let k = part * kinds + kind;
        if matters(part, kind) { sizes[k] / scales[k] } else { 0.0 }
    };
    let moves = moving.iter().map(|&part| PartMotion {
        centre: centres[part],
        amounts: (0..kinds).map(|kind| amount(part, kind)).collect(),
    });
    FreeMotion { moves: moves.collect(), parts: moving.iter().map(|&p| spans[p]).collect() }
}
