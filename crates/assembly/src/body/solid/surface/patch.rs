//! Sides of cells that stand for parts of a surface.

use super::super::super::lattice::{SquareLattice, plus};
use super::super::shape::{Face, SIDES};
use super::super::wall::Side;
use super::distance;
use super::facets::{Facet, Surface, dot};
use super::grid::Grid;

/// How far the surface can be from a side between a cell inside and one outside, in spacings; it passes between their centres.
const REACH: f64 = 0.51;

/// Name of what has no other name.
pub(super) const REST: &str = "rest";

/// Normals are along an axis within this, rad.
const ALONG: f64 = 1e-5;

/// A part of a surface, with the sides of cells that stand for it.
#[derive(Clone, Debug, PartialEq)]
pub struct Patch {
    /// Sides of cells, in the order of their points, and the cosines of the angles between their normals and that of the surface.
    pub(in super::super) sides: Vec<(Side, f64)>,
    /// What lies on the sides of the box around the body, in their order, and the rest.
    parts: [Area; 7],
    /// Whether parts of it are not across axes, so that sides of cells make stairs of them.
    is_slanted: bool,
}

/// The area of a part of a surface, as a number and as a vector out of the body, m².
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Area {
    size: f64,
    vector: [f64; 3],
}

/// A side of a cell with what it stands for of a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallSide {
    /// The side.
    pub side: Side,
    /// Area of the wall, m².
    pub area: f64,
    /// Area as a vector out of the body, m².
    pub outwards: [f64; 3],
}

/// What a triangle belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Part {
    /// A name of the surface.
    Named(u32),
    /// A side of the box around it, which it is flat on.
    Side(usize),
    /// Neither.
    Rest,
}

impl Surface {
    /// The side of the box on which a triangle lies flat.
    fn box_side(&self, facet: &Facet) -> Option<usize> {
        let (axis, is_high) = across(facet.normal())?;
        let [low, high] = self.bounds();
        let (at, slack) = (if is_high { high[axis] } else { low[axis] }, self.rounding());
        let is_on = facet.range(axis).iter().all(|x| (x - at).abs() <= slack);
        is_on.then_some(2 * axis + usize::from(is_high))
    }

    /// The sides of the box on which some of it lies flat.
    pub fn flat_sides(&self) -> [bool; 6] {
        let mut flat = [false; 6];
        self.facets.iter().filter_map(|facet| self.box_side(facet)).for_each(|side| flat[side] = true);
        flat
    }

    /// A name of it that means something else: that of a side of the box around it for what lies elsewhere, or that of the rest.
    pub fn misnamed(&self) -> Option<&str> {
        let is_wrong = |facet: &&Facet, name: &str| match SIDES.iter().position(|side| *side == name) {
            Some(side) => self.box_side(facet) != Some(side),
            None => name == REST,
        };
        let named = |facet: &Facet| facet.name.map(|name| self.names[name as usize].as_str());
        self.facets.iter().find_map(|facet| named(facet).filter(|name| is_wrong(&facet, name)))
    }

    /// Its parts, each with the sides of cells that are nearest to triangles of it that look the same way.
    pub(super) fn patches(&self, grid: &Grid, lattice: &SquareLattice) -> Vec<(Part, Patch)> {
        let own = |name: u32| SIDES.iter().position(|side| *side == self.names[name as usize]);
        let part = |facet: &Facet, side: Option<usize>| match (facet.name, side) {
            (Some(name), _) => own(name).map_or(Part::Named(name), Part::Side),
            (None, Some(side)) => Part::Side(side),
            (None, None) => Part::Rest,
        };
        let names = (0..self.names.len() as u32).filter(|&name| own(name).is_none()).map(Part::Named);
        let mut patches: Vec<(Part, Patch)> = names
            .chain((0..6).map(Part::Side))
            .chain([Part::Rest])
            .map(|part| (part, Patch { sides: Vec::new(), parts: Default::default(), is_slanted: false }))
            .collect();
        let mut numbers = Vec::with_capacity(self.facets.len());
        for facet in &self.facets {
            let side = self.box_side(facet);
            let number = patches.binary_search_by_key(&part(facet, side), |patch| patch.0).unwrap_or(0);
            numbers.push(number);
            let patch = &mut patches[number].1;
            patch.is_slanted |= across(facet.normal()).is_none();
            let area = &mut patch.parts[side.unwrap_or(6)];
            *area = area.plus(&Area { size: facet.area(), vector: facet.area_vector() });
        }
        for (side, facet) in self.nearest(grid, lattice) {
            let facing = dot(side.normal(), self.facets[facet].normal());
            patches[numbers[facet]].1.sides.push((side, facing));
        }
        patches
    }

    /// Sides on the border of a lattice with the triangle that is nearest to each.
    fn nearest(&self, grid: &Grid, lattice: &SquareLattice) -> Vec<(Side, usize)> {
        let border = border(lattice);
        let first: Vec<u32> = border.iter().map(|side| side.point as u32).collect();
        let mut best = vec![(f64::INFINITY, 0.0, usize::MAX); border.len()];
        let (reach, slack) = (REACH * grid.spacing + self.rounding(), 1e-9 * grid.spacing * grid.spacing);
        for (number, facet) in self.facets.iter().enumerate() {
            let normal = facet.normal();
            grid.near(facet, reach + 0.5 * grid.spacing, |[row, layer], columns| {
                for point in columns.filter_map(|column| lattice.number([column, row, layer])) {
                    let from = first.partition_point(|other| (*other as usize) < point);
                    let own = border[from..].iter().zip(&mut best[from..]);
                    for (side, best) in own.take_while(|(side, _)| side.point == point) {
                        let facing = dot(side.normal(), normal);
                        if facing <= 0.0 {
                            continue;
                        }
                        let far = distance::squared(side.middle(lattice), facet.corners);
                        // Of those at an edge the one that looks more like the side.
                        let is_better = far < best.0 - slack || far <= best.0 + slack && facing > best.1;
                        if far <= reach * reach && is_better {
                            *best = (far, facing, number);
                        }
                    }
                }
            });
        }
        border
            .into_iter()
            .zip(best)
            .filter(|(_, best)| best.2 != usize::MAX)
            .map(|(side, best)| (side, best.2))
            .collect()
    }
}

/// The axis across which a surface of this unit normal is, and whether it looks along it.
fn across(normal: [f64; 3]) -> Option<(usize, bool)> {
    let axis = (0..3).find(|&k| (0..3).all(|other| other == k || normal[other].abs() <= ALONG))?;
    Some((axis, normal[axis] > 0.0))
}

/// Sides of cells beyond which there is no cell, in the order of their points.
pub(super) fn border(lattice: &SquareLattice) -> Vec<Side> {
    let mut found = Vec::new();
    for run in lattice.runs() {
        for column in run.columns.clone() {
            let (point, cell) = (run.number(column), run.cell(column));
            let sides = (0..6).map(|k| Side { point, axis: k / 2, is_high: k % 2 == 1 });
            found.extend(sides.filter(|side| lattice.number(plus(cell, side.outwards())).is_none()));
        }
    }
    found
}

impl Area {
    fn plus(&self, other: &Self) -> Self {
        let vector = [0, 1, 2].map(|k| self.vector[k] + other.vector[k]);
        Self { size: self.size + other.size, vector }
    }
}

impl Patch {
    /// Whether triangles belong to it.
    pub(super) fn is_there(&self) -> bool {
        self.parts.iter().any(|part| part.size > 0.0)
    }

    /// Whether sides of cells make stairs of it.
    pub fn is_slanted(&self) -> bool {
        self.is_slanted
    }

    /// The plane across an axis in which all of its sides lie; none where it is slanted or has steps.
    pub(super) fn plane(&self, lattice: &SquareLattice) -> Option<Face> {
        let (first, _) = self.sides.first().filter(|_| !self.is_slanted)?;
        let at = |side: &Side| side.middle(lattice)[side.axis];
        let face = Face { axis: first.axis, is_high: first.is_high, at: at(first) };
        self.sides.iter().all(|(side, _)| face.has(side, lattice)).then_some(face)
    }

    /// Takes away what lies on planes of symmetry.
    pub(in super::super) fn mirror(&mut self, faces: &[Face], lattice: &SquareLattice) {
        for face in faces {
            self.parts[2 * face.axis + usize::from(face.is_high)] = Area::default();
            self.sides.retain(|(side, _)| !face.has(side, lattice));
        }
    }

    /// Its sides with their parts of its area and of its area vector, which have those sums exactly.
    ///
    /// A side has the more of the area the more it looks as the surface does. Its area vector is its own, with a part of what is missing
    /// along its axis; what is missing along axes across which no side is, all sides have. Nothing is missing of what closes by itself,
    /// such as the border of a bore or of a ball.
    pub(in super::super) fn areas(&self, spacing: f64) -> Vec<WallSide> {
        let whole = self.parts.iter().fold(Area::default(), |sum, part| sum.plus(part));
        let facing: f64 = self.sides.iter().map(|side| side.1).sum();
        let (own, mut counts, mut missing) = (spacing * spacing, [0.0; 3], whole.vector);
        for (side, _) in &self.sides {
            counts[side.axis] += 1.0;
            (0..3).for_each(|k| missing[k] -= own * side.normal()[k]);
        }
        let each = self.sides.iter().map(|&(side, facing_here)| {
            let share = facing_here / facing;
            let part = |axis: usize| match counts[axis] {
                0.0 => share * missing[axis],
                count if axis == side.axis => own * side.normal()[axis] + missing[axis] / count,
                _ => 0.0,
            };
            WallSide { side, area: share * whole.size, outwards: [0, 1, 2].map(part) }
        });
        each.collect()
    }
}
