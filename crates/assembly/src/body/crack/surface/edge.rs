//! Straight edges of surfaces, at which they end.

use super::super::front::{FrontPlace, Recess};
use nalgebra::Vector3;
use std::collections::{HashMap, HashSet};

/// An edge that belongs to one piece alone.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Edge {
    /// Its ends, m.
    pub(super) ends: [Vector3<f64>; 2],
    /// Direction of length one in the plane of the piece, away from it.
    pub(super) outward: Vector3<f64>,
}

impl Edge {
    /// The same with places and directions moved.
    pub(super) fn mapped(
        &self,
        place: &dyn Fn(Vector3<f64>) -> Vector3<f64>,
        direction: &dyn Fn(Vector3<f64>) -> Vector3<f64>,
    ) -> Self {
        Self { ends: self.ends.map(place), outward: direction(self.outward) }
    }

    /// Its parts beyond which the body goes on.
    pub(super) fn fronts(&self, recess: &Recess) -> Vec<Self> {
        let mut found: Vec<Self> = Vec::new();
        for [from, to] in self.parts(recess.step, recess.within) {
            if !(recess.goes_on)(((from + to) * 0.5).into(), self.outward.into()) {
                continue;
            }
            match found.last_mut().filter(|last| last.ends[1] == from) {
                Some(last) => last.ends[1] = to,
                None => found.push(Self { ends: [from, to], outward: self.outward }),
            }
        }
        found
    }

    /// Distance of a place from it, m.
    pub(super) fn distance(&self, at: Vector3<f64>) -> f64 {
        let [from, to] = self.ends;
        let along = to - from;
        let share = (at - from).dot(&along) / along.norm_squared();
        (at - from - along * share.clamp(0.0, 1.0)).norm()
    }

    /// The place on it that is nearest to some place, m.
    pub(super) fn place_near(&self, place: Vector3<f64>) -> FrontPlace {
        let [from, to] = self.ends;
        let along = to - from;
        let share = ((place - from).dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
        FrontPlace {
            at: (from + along * share).into(),
            ahead: self.outward.into(),
            normal: self.outward.cross(&along.normalize()).into(),
        }
    }

    /// Its parts of about a length, m, within a box: their ends.
    fn parts(&self, step: f64, [low, high]: [[f64; 3]; 2]) -> Vec<[Vector3<f64>; 2]> {
        let [from, to] = self.ends;
        let along = to - from;
        let (mut first, mut last) = (0.0_f64, 1.0_f64);
        for k in 0..3 {
            let sides = [low[k], high[k]].map(|side| (side - from[k]) / along[k]);
            if along[k] != 0.0 {
                first = first.max(sides[0].min(sides[1]));
                last = last.min(sides[0].max(sides[1]));
            } else if !(low[k]..=high[k]).contains(&from[k]) {
                return Vec::new();
            }
        }
        let length = along.norm() * (last - first);
        if length.is_nan() || length <= 0.0 {
            return Vec::new();
        }
        let count = (length / step).ceil().max(1.0);
        let at = |k: f64| from + along * (first + (last - first) * k / count);
        (0..count as usize).map(|k| [at(k as f64), at(k as f64 + 1.0)]).collect()
    }
}

/// The edges of some plane polygons in space that are none of another one.
pub(super) fn border_edges(polygons: &[Vec<[f64; 3]>]) -> Vec<Edge> {
    // Zero has two signs.
    let bits = |at: &[f64; 3]| at.map(|x| (x + 0.0).to_bits());
    let sorted = |corners: &[[f64; 3]]| {
        let mut corners: Vec<[u64; 3]> = corners.iter().map(bits).collect();
        corners.sort_unstable();
        corners
    };
    // One that is listed twice is one.
    let mut known = HashSet::new();
    let polygons: Vec<&Vec<[f64; 3]>> = polygons.iter().filter(|p| known.insert(sorted(p))).collect();
    let edges = || {
        polygons.iter().flat_map(|&corners| {
            (0..corners.len()).map(move |k| (corners, [corners[k], corners[(k + 1) % corners.len()]]))
        })
    };
    let mut uses: HashMap<Vec<[u64; 3]>, usize> = HashMap::new();
    edges().for_each(|(_, ends)| *uses.entry(sorted(&ends)).or_default() += 1);
    let single = edges().filter(|(_, ends)| uses[&sorted(ends)] == 1);
    single.filter_map(|(corners, ends)| edge(corners, ends.map(Vector3::from))).collect()
}

/// An edge of a polygon; none of one without an area.
fn edge(corners: &[[f64; 3]], ends: [Vector3<f64>; 2]) -> Option<Edge> {
    let arm = |corner: &[f64; 3]| Vector3::from(*corner) - Vector3::from(corners[0]);
    let normal: Vector3<f64> = corners.windows(2).map(|pair| arm(&pair[0]).cross(&arm(&pair[1]))).sum();
    let outward = (ends[1] - ends[0]).cross(&normal).try_normalize(0.0)?;
    outward.iter().all(|x| x.is_finite()).then_some(Edge { ends, outward })
}
