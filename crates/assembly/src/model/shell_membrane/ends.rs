//! Ends of a membrane: bonds that leave it there are cut off, and end on its border.
//!
//! A bond is a chord in space. Of one that leaves at an end there remains the part `f`. It ends on the straight line between
//! the two places where the rows i and j of its points meet the border. Such a place moves as the two points behind it do,
//! continued linearly, `u_b = 3/2 u_0 − 1/2 u_1`, and the end of the bond by the shares `1 − f` and `f` of both places:
//! `e = [dX ((1 − f) u_bi + f u_bj − u_i) + R sin Δ ((1 − f) v_bi + f v_bj − v_i) + 2R sin²(Δ/2) (w_i − (1 − f) w_bi + f w_bj)]/L`.
//!
//! This is `f` times the elongation of the whole bond in every motion that is the same in all columns, in every rigid motion, in
//! a uniform axial strain and in a twist. The modulus of the part is that of the whole bond over `f`, so that both have the same
//! force. Points beside an end are therefore in the balance of a tube that goes on. A uniform stress acts on the places of the
//! border alone, by its traction, with nothing across the surface.

use super::super::plane::{BorderShares, Mirrors, near_points};
use super::ShellBond;
use super::family::{ShellFamilies, ShellOffset};
use crate::body::SquareLattice;
use crate::bonds::Rows;
use crate::stiffness::{Place, PlacedBond, PlacedBonds};
use std::ops::Range;
use std::sync::Arc;

/// The bonds that end on the border.
#[derive(Clone, Debug)]
pub(super) struct Ends {
    pub(super) bonds: Arc<PlacedBonds<3, 1>>,
    /// What they are parts of, in the order of the bonds: by ascending points, then those without one.
    parts: Vec<Part>,
}

/// What a bond that ends on the border is a part of.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    /// The point that it goes out from; none where it crosses a short tube from end to end.
    pub(super) point: Option<u32>,
    pub(super) offset: usize,
    /// Whether it goes upwards from there.
    pub(super) up: bool,
    /// Its length over that of the whole bond.
    pub(super) share: f64,
    /// Weight of the whole bond, 1/m².
    weight: f64,
    /// Part of it that is real.
    counted: f64,
    /// Points of the rows in which the whole bond begins and ends.
    rows: [u32; 2],
}

/// An end of a part: the share of the bond up to there, and places in the rows in which the bond begins and ends.
struct Stop {
    share: f64,
    places: [Place; 2],
}

/// A membrane with its images whose bonds are cut.
struct Sheet<'a> {
    lattice: &'a SquareLattice,
    mirrors: &'a Mirrors,
    families: &'a ShellFamilies,
    columns: Range<i32>,
    found: Vec<([Stop; 2], Part)>,
}

/// The columns of a lattice of whole rows.
fn columns(lattice: &SquareLattice) -> Range<i32> {
    lattice.runs().first().map_or(0..0, |run| run.columns.clone())
}

/// The place of the border in a row, at the low or at the high end of some columns.
fn border(lattice: &SquareLattice, columns: &Range<i32>, high: bool, row: i32) -> Option<Place> {
    let behind = if high { [columns.end - 1, columns.end - 2] } else { [columns.start, columns.start + 1] };
    let of = |(column, share)| Some((lattice.number([column, row, 0])? as u32, share));
    behind.into_iter().zip([1.5, -0.5]).map(of).collect()
}

impl Sheet<'_> {
    fn number(&self, column: i32, row: i32) -> Option<u32> {
        self.lattice.number([column, row, 0]).map(|point| point as u32)
    }

    /// Where a bond between two rows leaves that begins in a column and goes on by `dx` columns.
    fn leaves(&self, column: i32, dx: i32, rows: [i32; 2], high: bool) -> Option<Stop> {
        let until = if high { self.columns.end - column } else { self.columns.start - column };
        let [i, j] = rows.map(|row| border(self.lattice, &self.columns, high, row));
        Some(Stop { share: (f64::from(until) - 0.5) / f64::from(dx), places: [i?, j?] })
    }

    /// Adds the bonds of a point that leave the membrane.
    fn cut_at(&mut self, point: usize) {
        let cell = self.lattice.cell(point);
        for (offset, up) in self.families.directions() {
            let [dx, ds] = self.families.step(offset, up);
            let other = [cell[0], cell[1] + ds, 0];
            let Some(number) = self.lattice.number(other) else { continue };
            if self.columns.contains(&(cell[0] + dx)) {
                continue;
            }
            let own = vec![(point as u32, 1.0)];
            let from = Stop { share: 0.0, places: [own.clone(), own] };
            let Some(to) = self.leaves(cell[0], dx, [cell[1], other[1]], dx > 0) else { continue };
            let body = (self.lattice, self.mirrors);
            let (weight, share) = (self.families.shared_weight(body, [cell, other], offset, up), to.share);
            let rows = [point, number].map(|p| p as u32);
            let part = Part { point: Some(rows[0]), offset, up, share, weight, counted: 1.0, rows };
            self.found.push(([from, to], part));
        }
    }

    /// Adds the bonds that begin in a row and are longer than the tube; a line of symmetry halves each.
    fn cut_twice(&mut self, row: i32) {
        let columns = self.columns.clone();
        let counted = if self.mirrors.lines[0] == [None; 2] { 1.0 } else { 0.5 };
        for (offset, up) in self.families.directions() {
            let [dx, ds] = self.families.step(offset, up);
            let rows = [row, row + ds];
            let [Some(i), Some(j)] = rows.map(|row| self.number(columns.start, row)) else { continue };
            let (body, cells) = ((self.lattice, self.mirrors), rows.map(|row| [columns.start, row, 0]));
            let weight = self.families.shared_weight(body, cells, offset, up);
            for begin in columns.end - dx..columns.start {
                let [Some(from), Some(to)] = [false, true].map(|high| self.leaves(begin, dx, rows, high))
                else {
                    continue;
                };
                let share = to.share - from.share;
                let part = Part { point: None, offset, up, share, weight, counted, rows: [i, j] };
                self.found.push(([from, to], part));
            }
        }
    }
}

/// The part of a bond between two stops, its modulus that of the whole one.
fn placed([from, to]: &[Stop; 2], offset: &ShellOffset, up: bool, modulus: f64) -> PlacedBond<3, 1> {
    let [u, v, w] = offset.row;
    let (sign, share) = (if up { 1.0 } else { -1.0 }, to.share - from.share);
    let scaled = |place: &Place, by: f64| place.iter().map(move |&(p, s)| (p, by * s)).collect::<Vec<_>>();
    let both = |stop: &Stop, of: [f64; 2]| {
        let places = stop.places.iter().zip(of).filter(|(_, by)| *by != 0.0);
        places.flat_map(|(place, by)| scaled(place, by)).collect::<Place>()
    };
    let ends = [from, to].map(|stop| both(stop, [1.0 - stop.share, stop.share]));
    let across = |stop: &Stop, sign: f64| both(stop, [1.0 - stop.share, -stop.share].map(|s| sign * s));
    // Of w the sum counts, not the difference: its shares sum to twice the part.
    let mean: Place = across(from, 0.5 / share).into_iter().chain(across(to, -0.5 / share)).collect();
    let rows = Rows { difference: [[sign * u, sign * v, 0.0]], mean: [[0.0, 0.0, 2.0 * share * w]] };
    PlacedBond { ends, mean: Some(mean), rows, moduli: [modulus / share] }
}

impl Ends {
    /// Those of a lattice with its images.
    pub(super) fn new(
        (lattice, mirrors): (&SquareLattice, &Mirrors),
        families: &ShellFamilies,
        bond: &ShellBond,
    ) -> Self {
        let mut sheet = Sheet { lattice, mirrors, families, columns: columns(lattice), found: Vec::new() };
        let near = near_points(lattice, families.reach());
        near.into_iter().filter(|&p| mirrors.is_real(lattice.cell(p))).for_each(|p| sheet.cut_at(p));
        let real = |row: &i32| mirrors.image([sheet.columns.start, *row, 0]).0[1] == *row;
        lattice.rows().filter(real).collect::<Vec<_>>().into_iter().for_each(|row| sheet.cut_twice(row));
        let (mut bonds, mut parts) = (PlacedBonds::new(lattice.points()), Vec::new());
        for (stops, part) in sheet.found {
            let modulus = part.counted * bond.modulus * part.weight;
            bonds.push(&placed(&stops, &families.offsets[part.offset], part.up, modulus));
            parts.push(part);
        }
        Self { bonds: Arc::new(bonds), parts }
    }

    /// The parts of the bonds of a point, with their numbers.
    pub(super) fn of(&self, point: usize) -> impl Iterator<Item = (usize, &Part)> {
        let is_before = |part: &Part| part.point.is_some_and(|p| (p as usize) < point);
        let first = self.parts.partition_point(is_before);
        let own = move |(_, part): &(usize, &Part)| part.point.is_some_and(|p| p as usize == point);
        self.parts.iter().enumerate().skip(first).take_while(own)
    }

    /// Adds the forces of the bonds in strains `t` of the points, three planes: those of whole bonds.
    pub(super) fn add_work(
        &self,
        (lattice, mirrors): (&SquareLattice, &Mirrors),
        families: &ShellFamilies,
        (t, modulus): (&[f64], f64),
        force: &mut [f64],
    ) {
        let n = lattice.points();
        for (k, part) in self.parts.iter().enumerate() {
            let mut strain = [0.0; 3];
            for point in part.rows {
                let (cell, [x, s, _]) = mirrors.image(lattice.cell(point as usize));
                let Some(real) = lattice.number(cell) else { continue };
                let signs = [1.0, 1.0, x * s];
                (0..3).for_each(|q| strain[q] += 0.5 * signs[q] * t[q * n + real]);
            }
            let product = families.offsets[part.offset].product;
            let measured: f64 = product.iter().zip(strain).map(|(n, t)| n * t).sum();
            self.bonds.add_work(k, &[part.counted * modulus * part.weight * measured], force);
        }
    }
}

/// How places on the ends of a lattice move: from a position, m, and the outward normal to points and their shares.
pub(super) fn shares(lattice: &SquareLattice) -> BorderShares<'_> {
    let columns = columns(lattice);
    Box::new(move |at, normal| {
        /// Positions are those of ends up to this part of a spacing.
        const SLACK: f64 = 1e-6;
        let [x, s] = [0, 1].map(|k| (at[k] - lattice.corner()[k]) / lattice.spacing());
        let high = normal[0] > 0.0;
        let end = if high { columns.end } else { columns.start };
        if normal[0].abs() < 1.0 - 1e-9 || (x - f64::from(end)).abs() > SLACK {
            return None;
        }
        let low = (s - 0.5).floor();
        let part = s - 0.5 - low;
        let mut all = Vec::new();
        for (row, by) in [(low as i32, 1.0 - part), (low as i32 + 1, part)].into_iter().filter(|r| r.1 != 0.0)
        {
            let place = border(lattice, &columns, high, row)?;
            all.extend(place.into_iter().map(|(p, share)| (p as usize, by * share)));
        }
        Some(all)
    })
}
