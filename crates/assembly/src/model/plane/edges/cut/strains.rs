//! Strains of points beside the border, from the displacements around them.
//!
//! A sum over the bonds of a point is a mean over its horizon, of which half is missing beside the border: it lags behind stresses
//! that rise towards a hole. A quadratic function through the displacements around has a strain at the point itself.

use super::super::super::mixture::Mixture;
use super::corners::{Corners, WIDE};
use crate::body::SquareLattice;
use std::collections::{HashMap, HashSet};

/// How the strains of some points follow from displacements.
#[derive(Clone, Debug)]
pub(in super::super::super::super) struct Strains {
    points: Vec<u32>,
    /// Behind the last neighbour of every point.
    ends: Vec<u32>,
    /// Neighbours, and what their displacements have in the derivatives along x and y, 1/m.
    rows: Vec<(u32, [f64; 2])>,
}

impl Strains {
    /// Those of some points, where enough others are around to tell. Where these are of several materials strains have jumps, and
    /// are not told.
    pub(super) fn new(
        corners: &Corners,
        points: impl Iterator<Item = usize>,
        mixture: Option<&Mixture>,
    ) -> Self {
        let lattice: &SquareLattice = corners.blocks.lattice;
        let axes = lattice.axes();
        let mut strains = Self { points: Vec::new(), ends: Vec::new(), rows: Vec::new() };
        for point in points {
            let cell = lattice.cell(point);
            let Some(found) = corners.fit(cell, cell, WIDE) else { continue };
            let along =
                |[_, a, b]: [f64; 3]| [0, 1].map(|k| (a * axes[0][k] + b * axes[1][k]) / lattice.spacing());
            let named = |(cell, rows)| Some((lattice.number(cell)? as u32, along(rows)));
            let Some(mut rows) = found.into_iter().map(named).collect::<Option<Vec<_>>>() else { continue };
            let differs = |mixture: &Mixture, row: u32| !mixture.are_alike([row as usize, point]);
            if mixture.is_some_and(|mixture| rows.iter().any(|row| differs(mixture, row.0))) {
                continue;
            }
            strains.points.push(point as u32);
            strains.rows.append(&mut rows);
            strains.ends.push(strains.rows.len() as u32);
        }
        strains
    }

    /// Whether the strain of a point follows so.
    pub(in super::super::super::super) fn tells(&self, point: usize) -> bool {
        self.points.binary_search(&(point as u32)).is_ok()
    }

    /// Forgets the points whose strain follows from both sides of one of some pairs of points that are parted.
    pub(in super::super::super::super) fn forget(&mut self, broken: &HashSet<[u32; 2]>) {
        let mut partners = HashMap::<u32, Vec<u32>>::new();
        broken.iter().for_each(|&[a, b]| partners.entry(a).or_default().push(b));
        let mut kept = Self { points: Vec::new(), ends: Vec::new(), rows: Vec::new() };
        let mut from = 0;
        for (&point, &end) in self.points.iter().zip(&self.ends) {
            let rows = &self.rows[from..end as usize];
            let has = |other: &u32| rows.iter().any(|row| row.0 == *other);
            if !rows.iter().filter_map(|row| partners.get(&row.0)).flatten().any(has) {
                kept.points.push(point);
                kept.rows.extend_from_slice(rows);
                kept.ends.push(kept.rows.len() as u32);
            }
            from = end as usize;
        }
        *self = kept;
    }

    /// The points.
    pub(in super::super::super::super) fn points(&self) -> impl Iterator<Item = usize> + '_ {
        self.points.iter().map(|&point| point as usize)
    }

    /// Calls `visit` with every point and its strain `[ε_xx, ε_yy, γ_xy]`; `u` are components of all points. Where points have one
    /// component, across the plane, it is `[γ_xz, γ_yz, 0]`.
    pub(in super::super::super::super) fn for_each(
        &self,
        (points, u): (usize, &[f64]),
        visit: &mut dyn FnMut(usize, [f64; 3]),
    ) {
        let components = 2.min(u.len() / points.max(1));
        let mut from = 0;
        for (&point, &end) in self.points.iter().zip(&self.ends) {
            let mut slope = [[0.0; 2]; 2];
            for &(other, rows) in &self.rows[from..end as usize] {
                for (c, slope) in slope.iter_mut().enumerate().take(components) {
                    // Relative to the point: a translation costs no digits.
                    let moved = u[c * points + other as usize] - u[c * points + point as usize];
                    (0..2).for_each(|k| slope[k] += rows[k] * moved);
                }
            }
            let [x, y] = slope;
            let strain = if components == 1 { [x[0], x[1], 0.0] } else { [x[0], y[1], x[1] + y[0]] };
            visit(point as usize, strain);
            from = end as usize;
        }
    }
}
