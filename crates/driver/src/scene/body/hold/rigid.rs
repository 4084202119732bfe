//! Regions that move as one body: equations that leave them three unknowns in the plane, and six in a solid.

use peristat_assembly::bonds::Point;
use peristat_assembly::condition::{Equation, Unknown};

/// Points that move as a rigid body.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidPoints {
    /// Numbers of the points, ascending.
    pub points: Vec<u32>,
    /// What prescribed displacements are of.
    pub centre: Point,
    /// Prescribed displacements along x, y and z, and rotations about them; what is not given is free. In the plane there are
    /// the first two and the last.
    pub prescribed: [Option<f64>; MOTIONS],
    /// The same in every step; none where all grow with the load factor.
    pub by_step: Vec<[Option<f64>; MOTIONS]>,
    /// Where it stands in the case.
    pub origin: String,
}

/// Motions of a rigid body in space.
pub(crate) const MOTIONS: usize = 6;

/// Keys of [`RigidPoints::prescribed`] in a solid.
const IN_SPACE: [&str; MOTIONS] = ["ux", "uy", "uz", "phi_x", "phi_y", "phi_z"];
/// The same in the plane.
const IN_PLANE: [&str; MOTIONS] = ["ux", "uy", "", "", "", "phi"];

/// The key of a motion of rigid regions, among [`RigidPoints::prescribed`]; none where there is no such motion.
pub(crate) fn key(motion: usize, axes: usize) -> Option<&'static str> {
    let keys = if axes > 2 { IN_SPACE } else { IN_PLANE };
    Some(keys[motion]).filter(|key| !key.is_empty())
}

/// Unknowns of a few points that say how a rigid region moves.
pub(crate) struct Basis {
    /// A point of the region and its position.
    first: (usize, Point),
    turn: Turn,
    /// Along how many axes points move.
    axes: usize,
}

/// How the rotation of a rigid region is read.
enum Turn {
    /// The rotation of its first point, times this length.
    Own(f64),
    /// Displacements of other points less those of the first one; none of a region of one point, which does not turn.
    Differences(Vec<Difference>),
}

/// A component of another point less that of the first one.
struct Difference {
    other: usize,
    component: usize,
    /// Rotations about x, y and z per unit of it.
    turns: Point,
}

impl Basis {
    /// The first point is the lower end of the region along its longest axis; where points do not turn, those others go with
    /// it that tell its rotations best.
    pub(crate) fn new(
        rigid: &RigidPoints,
        (turning, axes): (Option<f64>, usize),
        position: &dyn Fn(usize) -> Point,
    ) -> Self {
        let end = |axis: usize| {
            let key = |p: &&u32| position(**p as usize)[axis];
            let order = |a: &&u32, b: &&u32| key(a).total_cmp(&key(b));
            let low = rigid.points.iter().min_by(order).map_or(0, |p| *p as usize);
            let high = rigid.points.iter().max_by(order).map_or(0, |p| *p as usize);
            (low, position(high)[axis] - position(low)[axis])
        };
        // The first of several axes that are as long.
        let ends = (0..axes).rev().map(end);
        let first = ends.max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |end| end.0);
        let first = (first, position(first));
        let turn = match turning {
            Some(turning) => Turn::Own(turning),
            None => Turn::Differences(differences(&rigid.points, first.1, axes, position)),
        };
        Self { first, turn, axes }
    }

    /// A rotation about an axis as a sum of unknowns.
    pub(super) fn rotation(&self, axis: usize, factor: f64) -> Vec<(Unknown, f64)> {
        let first = |component: usize| Unknown { component, point: self.first.0 };
        match &self.turn {
            Turn::Own(turning) if axis == 2 => vec![(first(2), factor / turning)],
            Turn::Own(_) => Vec::new(),
            Turn::Differences(differences) => {
                let terms = differences.iter().flat_map(|&Difference { other, component, turns }| {
                    let share = factor * turns[axis];
                    [(Unknown { component, point: other }, share), (first(component), -share)]
                });
                terms.filter(|term| term.1 != 0.0).collect()
            }
        }
    }

    /// An unknown of a point of the body at a position as a sum of those of the basis.
    fn unknown(&self, component: usize, at: Point) -> Vec<(Unknown, f64)> {
        let mut terms = vec![(Unknown { component, point: self.first.0 }, 1.0)];
        if component < self.axes {
            let arm = |axis: usize| at[axis] - self.first.1[axis];
            let [next, last] = [(component + 1) % 3, (component + 2) % 3];
            terms.extend(self.rotation(next, arm(last)));
            terms.extend(self.rotation(last, -arm(next)));
            terms.retain(|term| term.1 != 0.0);
        }
        terms
    }

    /// Whether an unknown is one of the basis.
    fn has(&self, point: usize, component: usize) -> bool {
        let is_other = |d: &Difference| (d.other, d.component) == (point, component);
        point == self.first.0
            || matches!(&self.turn, Turn::Differences(differences) if differences.iter().any(is_other))
    }
}

/// Components of points that tell the rotations of a region about its first point: one after the other that which moves most in
/// the rotations that leave the ones before alone.
fn differences(
    points: &[u32],
    first: Point,
    axes: usize,
    position: &dyn Fn(usize) -> Point,
) -> Vec<Difference> {
    /// What is left of an arm below this part of the longest is rounding.
    const ROUNDING: f64 = 1e-9;
    /// Rotations below this part of the largest are what rounding leaves of others.
    const ROUNDED: f64 = 1e-14;
    let dot = |a: &Point, b: &Point| (0..3).map(|k| a[k] * b[k]).sum::<f64>();
    let mut found: Vec<Difference> = Vec::new();
    // Orthonormal rotations, each by what the differences so far are per unit of it, and how they follow from these.
    let mut known: Vec<(Point, Vec<f64>)> = Vec::new();
    let mut longest = 0.0;
    for _ in 0..if axes > 2 { 3 } else { 1 } {
        // Per rotation, r × e of a displacement along e at r.
        let candidates =
            points.iter().flat_map(|&p| (0..axes).map(move |c| (p as usize, c))).map(|(p, c)| {
                let arm = position(p);
                let [next, last] = [(c + 1) % 3, (c + 2) % 3];
                let mut row = [0.0; 3];
                (row[next], row[last]) = (arm[last] - first[last], first[next] - arm[next]);
                if axes == 2 {
                    (row[0], row[1]) = (0.0, 0.0);
                }
                let shares: Vec<f64> = known.iter().map(|(turn, _)| dot(turn, &row)).collect();
                for ((turn, _), share) in known.iter().zip(&shares) {
                    (0..3).for_each(|k| row[k] -= share * turn[k]);
                }
                (p, c, row, shares)
            });
        let Some((other, component, row, shares)) =
            candidates.max_by(|a, b| dot(&a.2, &a.2).total_cmp(&dot(&b.2, &b.2)))
        else {
            break;
        };
        let length = dot(&row, &row).sqrt();
        longest = f64::max(longest, length);
        if length <= ROUNDING * longest {
            break;
        }
        let mut amounts = vec![0.0; found.len() + 1];
        amounts[found.len()] = 1.0 / length;
        for ((_, of), share) in known.iter().zip(&shares) {
            of.iter().enumerate().for_each(|(k, amount)| amounts[k] -= share * amount / length);
        }
        known.push((row.map(|r| r / length), amounts));
        found.push(Difference { other, component, turns: [0.0; 3] });
    }
    for (turn, amounts) in &known {
        for (difference, amount) in found.iter_mut().zip(amounts) {
            (0..3).for_each(|k| difference.turns[k] += turn[k] * amount);
        }
    }
    let turns = found.iter().flat_map(|difference| difference.turns);
    let least = ROUNDED * turns.fold(0.0, |most: f64, turn| most.max(turn.abs()));
    for turn in found.iter_mut().flat_map(|difference| &mut difference.turns) {
        *turn = if turn.abs() > least { *turn } else { 0.0 };
    }
    found
}

impl RigidPoints {
    /// The same with what is prescribed in a step in place of that at a factor of one.
    pub(super) fn in_step(&self, step: usize, factor: f64) -> Self {
        let proportional = || self.prescribed.map(|value| value.map(|value| factor * value));
        Self { prescribed: self.by_step.get(step).copied().unwrap_or_else(proportional), ..self.clone() }
    }

    pub(crate) fn prescribed_equations(&self, basis: &Basis) -> Vec<Equation> {
        let equation = |motion: usize| {
            let value = self.prescribed[motion]?;
            let terms = match motion {
                axis @ 0..3 => basis.unknown(axis, self.centre),
                turn => basis.rotation(turn - 3, 1.0),
            };
            let origin = format!("{}.{}", self.origin, key(motion, basis.axes)?);
            (!terms.is_empty()).then(|| Equation { terms: merged(terms), value, origin })
        };
        (0..MOTIONS).filter_map(equation).collect()
    }

    pub(crate) fn shape_equations<'a>(
        &'a self,
        basis: &'a Basis,
        position: &'a dyn Fn(usize) -> Point,
    ) -> impl Iterator<Item = Equation> + 'a {
        let components = basis.axes + usize::from(matches!(basis.turn, Turn::Own(_)));
        let all = self.points.iter().flat_map(move |&p| (0..components).map(move |c| (p as usize, c)));
        all.filter(|&(point, component)| !basis.has(point, component)).map(move |(point, component)| {
            let mut terms = vec![(Unknown { component, point }, 1.0)];
            let rest = basis.unknown(component, position(point));
            terms.extend(merged(rest).into_iter().map(|(unknown, c)| (unknown, -c)));
            Equation { terms, value: 0.0, origin: self.origin.clone() }
        })
    }
}

/// The same sum with every unknown once, without what rounding leaves of those that drop out, the largest share first: it is the one
/// to divide by.
fn merged(terms: Vec<(Unknown, f64)>) -> Vec<(Unknown, f64)> {
    /// What is left of a sum below this part of its terms is rounding.
    const ROUNDING: f64 = 1e-14;
    let mut sums: Vec<(Unknown, f64, f64)> = Vec::new();
    for (unknown, c) in terms {
        match sums.iter_mut().find(|sum| sum.0 == unknown) {
            Some(sum) => (sum.1, sum.2) = (sum.1 + c, sum.2 + c.abs()),
            None => sums.push((unknown, c, c.abs())),
        }
    }
    sums.retain(|sum| sum.1.abs() > ROUNDING * sum.2);
    // A stable order, so that the first of several shares as large stays the first.
    sums.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
    sums.into_iter().map(|(unknown, c, _)| (unknown, c)).collect()
}
