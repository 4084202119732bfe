//! Smallest and largest values of the fields of a beam, over a state and over its lines.

use super::BeamResult;
use super::between::Between;
use super::ends::Ends;
use crate::case::FieldName;
use crate::run::Range;
use crate::scene::beam::{BeamScene, FrameLayout, MemberLayout};
use serde::{Deserialize, Serialize};

/// Smallest and largest section forces of a member.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MemberForces {
    /// Name.
    pub name: String,
    /// Axial force, tension positive.
    #[serde(rename = "N")]
    pub axial: [f64; 2],
    /// Shear force.
    #[serde(rename = "V")]
    pub shear: [f64; 2],
    /// Bending moment.
    #[serde(rename = "M")]
    pub moment: [f64; 2],
}

/// The cells of all lines of a state.
pub(crate) struct Along<'a>(Vec<Between<'a>>);

impl<'a> Along<'a> {
    pub(crate) fn new(scene: &'a BeamScene, result: &'a BeamResult) -> Self {
        Self((0..result.lines.len()).map(|line| Between::new(scene, result, line)).collect())
    }

    /// Smallest and largest value of a field, at points and between them, with the lines and positions.
    pub(crate) fn extremes(&self, field: FieldName) -> Option<[(f64, usize, f64); 2]> {
        let ends: Vec<Ends<'_>> = self.0.iter().map(|line| line.ends(field)).collect::<Option<_>>()?;
        let found: Vec<[(f64, usize); 2]> = ends.iter().map(Ends::extremes).collect::<Option<_>>()?;
        let low = found.iter().fold(f64::INFINITY, |low, [least, _]| low.min(least.0));
        let high = found.iter().fold(f64::NEG_INFINITY, |high, [_, most]| high.max(most.0));
        let mut range = Range::default();
        for (line, between) in self.0.iter().enumerate() {
            let extremes = between.extremes_beyond([low, high], field, &ends[line], found[line])?;
            range.take(extremes.map(|(value, x)| (value, (line, x))));
        }
        range.ends().map(|ends| ends.map(|(value, (line, x))| (value, line, x)))
    }

    /// The largest magnitude of a field.
    pub(crate) fn largest(&self, field: FieldName) -> Option<f64> {
        self.extremes(field).map(|ends| ends.map(|(value, ..)| value.abs()).into_iter().fold(0.0, f64::max))
    }

    /// A field along a line as it is drawn: positions and values, both of a place where it jumps.
    pub(crate) fn curve(&self, field: FieldName, line: usize) -> Option<Vec<(f64, f64)>> {
        self.0[line].curve(field)
    }

    /// Section forces per member of a frame, where they were recovered.
    pub(crate) fn member_forces(&self, frame: &FrameLayout) -> Vec<MemberForces> {
        let of = |(member, between): (&MemberLayout, &Between)| {
            let range = |field| between.extremes(field).map(|e| e.map(|(value, _)| value));
            let (axial, shear) = (range(FieldName::N)?, range(FieldName::V)?);
            Some(MemberForces { name: member.name.clone(), axial, shear, moment: range(FieldName::M)? })
        };
        frame.members.iter().zip(&self.0).filter_map(of).collect()
    }
}

impl Between<'_> {
    /// Smallest and largest value of a field and their positions, at points and between them.
    fn extremes(&self, field: FieldName) -> Option<[(f64, f64); 2]> {
        let ends = self.ends(field)?;
        let found = ends.extremes()?;
        self.extremes_beyond(found.map(|(value, _)| value), field, &ends, found)
    }

    /// The same, where those between points count only outside of a range; `found` are those at points.
    fn extremes_beyond(
        &self,
        range_of_points: [f64; 2],
        field: FieldName,
        ends: &Ends<'_>,
        found: [(f64, usize); 2],
    ) -> Option<[(f64, f64); 2]> {
        let mut range = Range::default();
        range.take(found.map(|(value, point)| (value, self.position(point))));
        for cell in self.high_cells(field, ends, found).into_iter().map(|number| self.cell(number)) {
            for part in cell.parts(field)? {
                part.corners().into_iter().for_each(|found| range.take([found; 2]));
                let value = |x: f64| cell.value(field, x, true);
                if !cell.is_straight(field) && part.may_leave(range_of_points, value)? {
                    part.peaks(value)?.into_iter().for_each(|found| range.take([found; 2]));
                }
            }
        }
        range.ends()
    }

    /// The cells that may rise above the largest value at a point, or fall below the smallest.
    pub(super) fn high_cells(
        &self,
        field: FieldName,
        ends: &Ends<'_>,
        [low, high]: [(f64, usize); 2],
    ) -> Vec<usize> {
        // Ends of so few cells tell nothing of what is between them.
        const FEW: usize = 8;
        // So many leave 1e-8 between points beside other cells than those at the extremes.
        const MANY: usize = 4096;
        let all = self.cells();
        let may_turn = |cell: &usize| self.cell(*cell).may_turn(field);
        if all <= FEW {
            return (0..all).filter(may_turn).collect();
        }
        if all > MANY {
            let beside = |(_, point): (f64, usize)| point.saturating_sub(1)..(point + 1).min(all);
            return beside(low).chain(beside(high)).filter(may_turn).collect();
        }
        let ends = ends.all();
        let mut rises = vec![0.0; all + 2];
        rises[1..].iter_mut().zip(ends.iter()).for_each(|(rise, [a, b])| *rise = (b - a).abs());
        // A cell rises above its ends by less than these differ, or those of the cells beside it.
        let mut high_cells = Vec::new();
        for (cell, ([a, b], rises)) in ends.iter().zip(rises.windows(3)).enumerate() {
            let rise = rises[0].max(rises[1]).max(rises[2]);
            let (bottom, top) = (low.0 + rise, high.0 - rise);
            if (*a >= top || *b >= top || *a <= bottom || *b <= bottom) && may_turn(&cell) {
                high_cells.push(cell);
            }
        }
        high_cells
    }
}

impl BeamResult {
    /// Smallest and largest value of a field at the points and their positions; both sides of a point where the field may jump.
    pub fn extremes(&self, field: FieldName) -> Option<[(f64, f64); 2]> {
        let mut range = Range::default();
        for line in 0..self.lines.len() {
            let x = &self.lines[line].x;
            range.take(self.ends(field, line)?.extremes()?.map(|(value, point)| (value, x.at(point))));
        }
        range.ends()
    }
}
