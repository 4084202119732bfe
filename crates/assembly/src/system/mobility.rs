//! Motions that nothing holds, found before anything is factorised.

use super::System;
use crate::bonds::Point;
use crate::model::Model;
use crate::stiffness::Parts;
use nalgebra::DMatrix;

/// A motion that costs no energy and no constraint prevents.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeMotion {
    /// First and last point of every part that moves.
    pub parts: Vec<[usize; 2]>,
    /// Amount of each of the model's rigid motions about the centre of the first moving part, scaled so that the
    /// largest is one.
    pub motions: Vec<(&'static str, f64)>,
    /// Centre that rotations are about.
    pub centre: Point,
}

/// Relative size below which a singular value counts as zero.
const NULL: f64 = 1e-9;

/// All independent free motions of a system.
pub fn free_motions<const D: usize, T: Model<D>>(model: &T, system: &System<D>) -> Vec<FreeMotion> {
    let mut parts = Parts::new(system.points());
    system.terms().iter().for_each(|t| t.join(&mut parts));
    let (labels, count) = parts.labels();
    let spans = spans(&labels, count);
    let centres: Vec<Point> = spans
        .iter()
        .map(|&[a, b]| {
            let (a, b) = (model.position(a), model.position(b));
            std::array::from_fn(|k| 0.5 * (a[k] + b[k]))
        })
        .collect();
    let kinds = T::RIGID_MOTIONS.len();
    let about = |unknown: usize, kind: usize| {
        let (component, point) = (unknown / system.points(), unknown % system.points());
        let part = labels[point] as usize;
        let (x, c) = (model.position(point), centres[part]);
        let motion = model.rigid_motion(kind, std::array::from_fn(|k| x[k] - c[k]));
        (part * kinds + kind, motion[component])
    };
    let mut held: Vec<Vec<(usize, f64)>> = system.constraints().equations().to_vec();
    for term in system.terms() {
        term.grounded(&mut |component, point| {
            held.push(vec![(component * system.points() + point, 1.0)]);
        });
    }
    let mut matrix = DMatrix::<f64>::zeros(held.len().max(count * kinds), count * kinds);
    for (row, equation) in held.iter().enumerate() {
        for &(unknown, coefficient) in equation {
            for kind in 0..kinds {
                let (column, value) = about(unknown, kind);
                matrix[(row, column)] += coefficient * value;
            }
        }
    }
    null_space(matrix).into_iter().map(|vector| describe(model, &vector, &spans, &centres)).collect()
}

/// First and last point of every part.
fn spans(labels: &[u32], count: usize) -> Vec<[usize; 2]> {
    let mut spans = vec![[usize::MAX, 0]; count];
    for (point, &label) in labels.iter().enumerate() {
        let span = &mut spans[label as usize];
        *span = [span[0].min(point), point];
    }
    spans
}

/// Vectors that the matrix maps to zero, in the units of its columns.
fn null_space(mut matrix: DMatrix<f64>) -> Vec<Vec<f64>> {
    // Columns and rows have different units; scaled to one they can be compared.
    let mut scale = vec![1.0; matrix.ncols()];
    for (k, mut column) in matrix.column_iter_mut().enumerate() {
        let largest = column.amax();
        if largest > 0.0 {
            scale[k] = largest;
            column /= largest;
        }
    }
    for mut row in matrix.row_iter_mut() {
        let largest = row.amax();
        if largest > 0.0 {
            row /= largest;
        }
    }
    let svd = matrix.svd(false, true);
    let Some(v) = svd.v_t else { return Vec::new() };
    let largest = svd.singular_values.max().max(f64::MIN_POSITIVE);
    (0..v.nrows())
        .filter(|&k| svd.singular_values[k] <= NULL * largest)
        .map(|k| v.row(k).iter().zip(&scale).map(|(value, s)| value / s).collect())
        .collect()
}

fn describe<const D: usize, T: Model<D>>(
    model: &T,
    vector: &[f64],
    spans: &[[usize; 2]],
    centres: &[Point],
) -> FreeMotion {
    let kinds = T::RIGID_MOTIONS.len();
    // Motions of different units are compared by how far they move the ends of a part.
    let reach = |part: usize, kind: usize| {
        let (x, c) = (model.position(spans[part][1]), centres[part]);
        let motion = model.rigid_motion(kind, std::array::from_fn(|k| x[k] - c[k]));
        motion.iter().fold(0.0, |a: f64, v| a.max(v.abs())) * vector[part * kinds + kind].abs()
    };
    let sizes: Vec<f64> = (0..vector.len()).map(|k| reach(k / kinds, k % kinds)).collect();
    let largest = sizes.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
    let moves = |part: usize| (0..kinds).any(|k| sizes[part * kinds + k] > 1e-6 * largest);
    let moving: Vec<usize> = (0..spans.len()).filter(|&part| moves(part)).collect();
    let first = moving.first().copied().unwrap_or(0);
    let motions = (0..kinds)
        .filter(|k| sizes[first * kinds + k] > 1e-6 * largest)
        .map(|k| (T::RIGID_MOTIONS[k], vector[first * kinds + k]))
        .collect();
    FreeMotion { parts: moving.iter().map(|&p| spans[p]).collect(), motions, centre: centres[first] }
}
