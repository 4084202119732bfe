//! Regions that move as one body: equations that leave them three unknowns.

use peristat_assembly::condition::{Equation, Unknown};

/// Points that move as a rigid body.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidPoints {
    /// Numbers of the points, ascending.
    pub points: Vec<u32>,
    /// What prescribed displacements are of.
    pub centre: [f64; 2],
    /// Prescribed displacements along x and y, and rotation; what is not given is free.
    pub prescribed: [Option<f64>; 3],
    /// Where it stands in the case.
    pub origin: String,
}

/// Keys of [`RigidPoints::prescribed`].
pub const RIGID_KEYS: [&str; 3] = ["ux", "uy", "phi"];

/// Three unknowns of one or two points that say how a rigid region moves.
pub(crate) struct Basis {
    /// A point of the region and its position.
    first: (usize, [f64; 2]),
    /// Where the rotation is read; none if the region is one point that does not turn.
    turn: Option<Turn>,
}

/// How the rotation of a rigid region is read.
enum Turn {
    /// The rotation of its first point, times this length.
    Own(f64),
    /// A component of another point less that of the first one, over a signed distance.
    Difference { other: usize, component: usize, arm: f64 },
}

impl Basis {
    /// The two points that are farthest from each other along an axis; where points turn, the first of them.
    pub(crate) fn new(
        rigid: &RigidPoints,
        turning: Option<f64>,
        position: &dyn Fn(usize) -> [f64; 2],
    ) -> Self {
        let ends = |axis: usize| {
            let key = |p: &&u32| position(**p as usize)[axis];
            let order = |a: &&u32, b: &&u32| key(a).total_cmp(&key(b));
            let low = rigid.points.iter().min_by(order).map_or(0, |p| *p as usize);
            let high = rigid.points.iter().max_by(order).map_or(0, |p| *p as usize);
            (low, high, position(high)[axis] - position(low)[axis])
        };
        let (along_x, along_y) = (ends(0), ends(1));
        // u_y grows along x by the rotation, u_x falls along y.
        let ((first, other, length), component) =
            if along_x.2 >= along_y.2 { (along_x, 1) } else { (along_y, 0) };
        let arm = if component == 1 { length } else { -length };
        let difference = (length > 0.0).then_some(Turn::Difference { other, component, arm });
        let turn = turning.map(Turn::Own).or(difference);
        Self { first: (first, position(first)), turn }
    }

    /// Rotation as a sum of unknowns.
    fn rotation(&self, factor: f64) -> Vec<(Unknown, f64)> {
        let first = |component: usize| Unknown { component, point: self.first.0 };
        match self.turn {
            None => Vec::new(),
            Some(Turn::Own(turning)) => vec![(first(2), factor / turning)],
            Some(Turn::Difference { other, component, arm }) => {
                let share = factor / arm;
                vec![(Unknown { component, point: other }, share), (first(component), -share)]
            }
        }
    }

    /// An unknown of a point of the body at a position as a sum of those of the basis.
    fn unknown(&self, component: usize, at: [f64; 2]) -> Vec<(Unknown, f64)> {
        if component == 2 {
            return vec![(Unknown { component, point: self.first.0 }, 1.0)];
        }
        let arm = [self.first.1[1] - at[1], at[0] - self.first.1[0]][component];
        let mut terms = vec![(Unknown { component, point: self.first.0 }, 1.0)];
        terms.extend(self.rotation(arm).into_iter().filter(|t| t.1 != 0.0));
        terms
    }
}

impl RigidPoints {
    pub(crate) fn prescribed_equations(&self, basis: &Basis) -> Vec<Equation> {
        let equation = |(k, key): (usize, &&str)| {
            let value = self.prescribed[k]?;
            let terms = match k {
                2 => basis.rotation(1.0),
                component => basis.unknown(component, self.centre),
            };
            let origin = format!("{}.{key}", self.origin);
            (!terms.is_empty()).then(|| Equation { terms: merged(terms), value, origin })
        };
        RIGID_KEYS.iter().enumerate().filter_map(equation).collect()
    }

    pub(crate) fn shape_equations<'a>(
        &'a self,
        basis: &'a Basis,
        points_turn: bool,
        position: &'a dyn Fn(usize) -> [f64; 2],
    ) -> impl Iterator<Item = Equation> + 'a {
        let components = if points_turn { 3 } else { 2 };
        let all = self.points.iter().flat_map(move |&p| (0..components).map(move |c| (p as usize, c)));
        let is_basis = |point: usize, component: usize| match basis.turn {
            Some(Turn::Difference { other, component: c, .. }) if (other, c) == (point, component) => true,
            _ => point == basis.first.0,
        };
        all.filter(move |&(point, component)| !is_basis(point, component)).map(move |(point, component)| {
            let mut terms = vec![(Unknown { component, point }, 1.0)];
            let rest = basis.unknown(component, position(point));
            terms.extend(merged(rest).into_iter().map(|(unknown, c)| (unknown, -c)));
            Equation { terms, value: 0.0, origin: self.origin.clone() }
        })
    }
}

/// The same sum with every unknown once, without those that drop out.
fn merged(terms: Vec<(Unknown, f64)>) -> Vec<(Unknown, f64)> {
    let mut sum: Vec<(Unknown, f64)> = Vec::new();
    for (unknown, c) in terms {
        match sum.iter_mut().find(|t| t.0 == unknown) {
            Some(t) => t.1 += c,
            None => sum.push((unknown, c)),
        }
    }
    sum.retain(|t| t.1 != 0.0);
    sum
}
