//! The materials of coarser lattices.
//!
//! The cells of a coarser lattice have the means of what the points in them have, factors and weights. Means of weights are tables
//! of their own; so that these are few, parts of a material count in eighths, and more of one rather than less: where a coarser
//! lattice is too soft, its corrections are too large.

use super::super::Mirrors;
use super::Mixture;
use crate::body::SquareLattice;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Parts in which a blend counts, if there are not too many blends so; else the next ones, and at last only the largest part does.
const PARTS: [f64; 2] = [8.0, 2.0];
/// Most tables of a lattice.
const MOST: usize = 254;

/// Parts of the materials of the finest lattice in a table of weights, of which the sum is one or a little more.
pub(in super::super::super) type Blend = Vec<f64>;

impl Mixture {
    /// That of the lattice of twice the spacing, of a body of some materials with tables of their own; none where all points are of
    /// the base material.
    pub(in super::super::super) fn coarser(
        &self,
        fine: &SquareLattice,
        (coarse, mirrors): (&SquareLattice, &Mirrors),
        materials: usize,
    ) -> Option<Arc<Self>> {
        let cells = (0..coarse.points()).map(|point| inside(point, fine, (coarse, mirrors)));
        if self.tables.is_empty() {
            return Self::new(cells.map(|points| self.mean(&points)).collect());
        }
        let cells: Vec<(f64, Blend)> =
            cells.map(|points| (self.mean(&points), self.blend(&points, materials))).collect();
        let factors: Vec<f64> = cells.iter().map(|(factor, _)| *factor).collect();
        let found = PARTS.iter().find_map(|parts| tables(&cells, materials, *parts));
        let (tables, blends) = found.unwrap_or_else(|| (cells.iter().map(largest).collect(), Vec::new()));
        Some(Arc::new(Self { factors, tables, blends }))
    }

    /// The mean factor of some points.
    fn mean(&self, points: &[usize]) -> f64 {
        let sum: f64 = points.iter().map(|point| self.of(*point)).sum();
        if points.is_empty() { 1.0 } else { sum / points.len() as f64 }
    }

    /// The parts that materials have in the weights of some points.
    fn blend(&self, points: &[usize], materials: usize) -> Blend {
        let sum: f64 = points.iter().map(|point| self.of(*point)).sum();
        let mut blend = vec![0.0; materials];
        for &point in points {
            let (table, part) = (self.table(point), self.of(point) / sum);
            match table.checked_sub(materials) {
                None => blend[table] += part,
                Some(place) => {
                    blend.iter_mut().zip(&self.blends[place]).for_each(|(to, own)| *to += part * own)
                }
            }
        }
        if points.is_empty() {
            blend[0] = 1.0;
        }
        blend
    }
}

/// The points of a lattice in a cell of that of twice the spacing.
fn inside(point: usize, fine: &SquareLattice, (coarse, mirrors): (&SquareLattice, &Mirrors)) -> Vec<usize> {
    let cell = coarse.cell(point);
    let [i, j, k] = if mirrors.is_none() { cell } else { mirrors.image(cell).0 };
    let plane = coarse.is_plane();
    let layer = |child: i32| if plane { k } else { 2 * k + (child >> 2) };
    let children = (0..if plane { 4 } else { 8 })
        .map(|child| [2 * i + (child & 1), 2 * j + (child >> 1 & 1), layer(child)]);
    children.filter_map(|cell| fine.number(cell)).collect()
}

/// The material that has the largest part of a cell.
fn largest((_, blend): &(f64, Blend)) -> u8 {
    (0..blend.len()).max_by(|a, b| blend[*a].total_cmp(&blend[*b])).unwrap_or(0) as u8
}

/// The table of every cell, and the blends behind those of the materials; none if there are too many.
fn tables(cells: &[(f64, Blend)], materials: usize, parts: f64) -> Option<(Vec<u8>, Vec<Blend>)> {
    let mut known = BTreeMap::<Vec<u32>, u8>::new();
    let mut blends = Vec::new();
    let mut tables = Vec::with_capacity(cells.len());
    for (_, blend) in cells {
        // Sums of parts round.
        let counts: Vec<u32> =
            blend.iter().map(|part| (part * parts - 1e-9).ceil().max(0.0) as u32).collect();
        let mut present = (0..materials).filter(|k| counts[*k] > 0);
        if let (Some(only), None) = (present.next(), present.next()) {
            tables.push(only as u8);
            continue;
        }
        let table = match known.get(&counts) {
            Some(table) => *table,
            None => {
                let next = materials + blends.len();
                if next > MOST {
                    return None;
                }
                blends.push(counts.iter().map(|count| f64::from(*count) / parts).collect());
                known.insert(counts, next as u8);
                next as u8
            }
        };
        tables.push(table);
    }
    Some((tables, blends))
}
