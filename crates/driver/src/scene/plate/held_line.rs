//! Straight lines of points that supports hold, along which reactions are per length.

use super::restraints::Restraints;
use super::site::{Site, points_of};
use peristat_assembly::condition::Equation;
use peristat_assembly::model::plate_bending::{PHI_X, PHI_Y};
use std::collections::{BTreeMap, BTreeSet};

/// Points next to each other along x or y that supports hold: an edge of the plate, or a line inside of it. It ends where another
/// such line begins or crosses it.
#[derive(Clone, Debug, PartialEq)]
pub struct HeldLine {
    /// What the user calls the place, such as ``the edge `left` ``.
    pub name: String,
    /// Points, towards +x or +y.
    pub points: Vec<u32>,
    /// Component of the rotation along the line.
    pub along: usize,
    /// Sign of the rotation across it that counts as positive: that along the outward normal of an edge, and along +x or +y inside.
    pub outward: f64,
    /// Whether the plate and its support go on behind the first and the last point, in a mirror.
    pub is_mirrored: [bool; 2],
    /// Indices of the supports that hold it.
    pub supports: Vec<usize>,
    /// How many lines along the same axis end at the first and at the last point.
    pub sharing: [usize; 2],
    /// Whether a line across it that does not turn ends at the first and at the last point: what holds the slope along this line there
    /// bends the plate across the other one, and does not twist it.
    pub meets_clamp: [bool; 2],
}

impl HeldLine {
    /// The length that a point stands for, spacings.
    pub fn weight(&self, place: usize) -> f64 {
        if place == 0 || place + 1 == self.points.len() { 0.5 } else { 1.0 }
    }

    /// Component of the rotation across the line.
    pub fn across(&self) -> usize {
        PHI_X + PHI_Y - self.along
    }

    /// Its first and its last point.
    pub fn ends(&self) -> [u32; 2] {
        [self.points[0], self.points[self.points.len() - 1]]
    }

    /// Its ends behind which it does not go on in a mirror.
    pub fn free_ends(&self) -> impl Iterator<Item = u32> {
        self.ends().into_iter().zip(self.is_mirrored).filter(|end| !end.1).map(|end| end.0)
    }
}

/// A step of a line from a point to the next one.
struct Step {
    to: u32,
    name: String,
    outward: f64,
    supports: Vec<usize>,
}

impl Step {
    fn new(to: u32, name: String, outward: f64) -> Self {
        Self { to, name, outward, supports: Vec::new() }
    }
}

/// Steps by the component along them and the point where they begin.
type Steps = BTreeMap<(usize, u32), Step>;

/// The lines that supports hold.
pub(super) fn lines(site: &Site, held: &Restraints) -> Vec<HeldLine> {
    let mut steps = Steps::new();
    let all = held.supports.iter().zip(held.sides.iter().zip(&held.points));
    for (index, (support, (sides, points))) in all.enumerate().filter(|(_, all)| !all.0.is_mirror) {
        // Forces on points beside the edge would be left out along it.
        let is_edge = points_of(sides).len() == points.len();
        for side in sides.iter().filter(|side| side.is_true && is_edge) {
            let [x, y] = side.segment.outward;
            let along = if x == 0.0 { PHI_X } else { PHI_Y };
            let [a, b] = side.segment.points;
            let name = format!("the edge `{}`", site.border.name(side, site.outline));
            let step = steps.entry((along, a.min(b))).or_insert(Step::new(a.max(b), name, x + y));
            step.supports.push(index);
        }
        if sides.is_empty() {
            inner_steps(site, points, (index, &support.name), &mut steps);
        }
    }
    let is_mirror = |name: &String| site.sides(name).map(|sides| points_of(&sides));
    let mirrors: BTreeSet<u32> = site.case.symmetry.iter().filter_map(is_mirror).flatten().collect();
    let is_one = |equation: &&Equation| equation.terms.len() == 1;
    let unknowns = held.equations.iter().filter(is_one).flat_map(|equation| &equation.terms);
    let unknowns: BTreeSet<(usize, u32)> =
        unknowns.map(|(unknown, _)| (unknown.component, unknown.point as u32)).collect();
    with_ends(chained(steps), &mirrors, &unknowns)
}

/// Steps between the points of a support inside of the plate, if they are in one row or one column.
fn inner_steps(site: &Site, points: &[u32], (index, name): (usize, &str), steps: &mut Steps) {
    for (along, [from, to]) in site.steps_of_line(points) {
        let step = steps.entry((along, from)).or_insert(Step::new(to, name.into(), 1.0));
        step.supports.push(index);
    }
}

/// Steps one behind the other, as far as the same supports hold them and no other line meets them.
fn chained(mut steps: Steps) -> Vec<HeldLine> {
    let ends = |along: usize| -> BTreeSet<u32> {
        let own = steps.iter().filter(|((axis, _), _)| *axis == along);
        own.flat_map(|((_, from), step)| [*from, step.to]).collect()
    };
    let (rows, columns) = (ends(PHI_X), ends(PHI_Y));
    let meet: BTreeSet<u32> = rows.intersection(&columns).copied().collect();
    let mut lines: Vec<HeldLine> = Vec::new();
    let mut open: BTreeMap<(usize, u32), usize> = BTreeMap::new();
    // Points ascend along rows and columns, so that a line is known before the step that goes on from it.
    while let Some(((along, from), step)) = steps.pop_first() {
        let Step { to, name, outward, supports } = step;
        let goes_on = open.remove(&(along, from)).filter(|line| {
            let line = &lines[*line];
            line.name == name && line.supports == supports && line.outward == outward && !meet.contains(&from)
        });
        let line = goes_on.unwrap_or_else(|| {
            let points = vec![from];
            let (is_mirrored, sharing, meets_clamp) = ([false; 2], [1; 2], [false; 2]);
            lines.push(HeldLine {
                name,
                points,
                along,
                outward,
                is_mirrored,
                supports,
                sharing,
                meets_clamp,
            });
            lines.len() - 1
        });
        lines[line].points.push(to);
        open.insert((along, to), line);
    }
    lines
}

/// The lines with what is known of their ends.
fn with_ends(
    mut lines: Vec<HeldLine>,
    mirrors: &BTreeSet<u32>,
    held: &BTreeSet<(usize, u32)>,
) -> Vec<HeldLine> {
    // Lines that do not turn about themselves, by the component along them and their ends; corners that others hold, too, do not tell.
    let stiff: BTreeSet<(usize, u32)> = (lines.iter())
        .flat_map(|line| {
            let beside = [line.points[1], line.points[line.points.len() - 2]];
            line.ends().into_iter().zip(beside).map(move |(end, beside)| (line, end, beside))
        })
        .filter(|(line, _, beside)| held.contains(&(line.across(), *beside)))
        .map(|(line, end, _)| (line.along, end))
        .collect();
    let all: Vec<(usize, u32)> =
        lines.iter().flat_map(|line| line.ends().map(|point| (line.along, point))).collect();
    for line in &mut lines {
        let count = |point: u32| all.iter().filter(|end| end.1 == point).count();
        line.is_mirrored = line.ends().map(|point| mirrors.contains(&point) && count(point) == 1);
        line.meets_clamp = line.ends().map(|point| stiff.contains(&(line.across(), point)));
        line.sharing = line.ends().map(|point| all.iter().filter(|end| **end == (line.along, point)).count());
    }
    lines
}
