//! What holds a body, by points: equations for its lattice and for any coarser one are made of it.

use super::held_points::HeldPoints;
use super::rigid::{Basis, RigidPoints};
use peristat_assembly::body::SquareLattice;
use peristat_assembly::bonds::Point;
use peristat_assembly::condition::{Equation, Unknown};
use peristat_assembly::stiffness::Spring;
use std::collections::BTreeMap;

/// What holds a body.
#[derive(Clone, Debug, Default)]
pub struct Conditions {
    /// Points with prescribed motions.
    pub holds: Vec<HeldPoints>,
    /// Regions that move as rigid bodies.
    pub rigid: Vec<RigidPoints>,
    /// Springs to the ground.
    pub springs: Vec<Spring>,
    /// What multiplies rotations to make unknowns of them, m; none where points do not turn.
    pub turning: Option<f64>,
    /// Along how many axes the points of rigid regions move.
    pub axes: usize,
}

impl Conditions {
    /// Numbers of the points that supports hold and of those of rigid regions, as often as they are.
    pub(crate) fn held_points(&self) -> impl Iterator<Item = usize> + '_ {
        let held = self.holds.iter().map(|h| &h.points);
        held.chain(self.rigid.iter().map(|r| &r.points)).flatten().map(|&p| p as usize)
    }

    /// Those of edges that are held on their lines, which stretches the bonds there far more than those of the rest.
    pub(crate) fn gripped_points(&self) -> impl Iterator<Item = usize> + '_ {
        let on_line = |h: &&HeldPoints| h.is_on_border();
        self.holds.iter().filter(on_line).flat_map(|h| &h.points).map(|&p| p as usize)
    }

    /// All equations: of every hold one per point, in their order, then of every rigid region one per prescribed motion,
    /// in the order of [`RigidPoints::prescribed`], then those that make them rigid.
    pub fn equations(&self, position: &dyn Fn(usize) -> Point) -> Vec<Equation> {
        let mut equations: Vec<Equation> = self.holds.iter().flat_map(HeldPoints::equations).collect();
        let moves = (self.turning, self.axes);
        let bodies: Vec<Basis> = self.rigid.iter().map(|r| Basis::new(r, moves, position)).collect();
        for (rigid, basis) in self.rigid.iter().zip(&bodies) {
            equations.extend(rigid.prescribed_equations(basis));
        }
        for (rigid, basis) in self.rigid.iter().zip(&bodies) {
            equations.extend(rigid.shape_equations(basis, position));
        }
        equations
    }

    /// The same with the motions of a step in place of those at a factor of one; none where all grow with the load factor.
    pub(crate) fn in_step(&self, step: usize, factor: f64) -> Option<Self> {
        let varies = self.holds.iter().any(|h| !h.by_step.is_empty())
            || self.rigid.iter().any(|r| !r.by_step.is_empty());
        varies.then(|| Self {
            holds: self.holds.iter().map(|h| h.in_step(step, factor)).collect(),
            rigid: self.rigid.iter().map(|r| r.in_step(step, factor)).collect(),
            ..self.clone()
        })
    }

    /// The rotation of one of the rigid regions about an axis, rad, of a state by its unknowns.
    pub(crate) fn rotation(
        &self,
        rigid: &RigidPoints,
        axis: usize,
        position: &dyn Fn(usize) -> Point,
        unknown: &dyn Fn(Unknown) -> f64,
    ) -> f64 {
        let basis = Basis::new(rigid, (self.turning, self.axes), position);
        basis.rotation(axis, 1.0).into_iter().map(|(of, share)| share * unknown(of)).sum()
    }

    /// What holds the body on the next coarser lattice, without motion: a coarse point is held where any point in its cell is, it is
    /// rigid with all others that hold a point of the same region, and springs add up.
    ///
    /// Points that a lattice does not have are left out; there are none if `coarse` is the coarser one of `fine`.
    pub fn coarser(&self, fine: &SquareLattice, coarse: &SquareLattice) -> Self {
        let parent = |point: u32| {
            let number = coarse.number(SquareLattice::parent(fine.cell(point as usize)));
            number.map(|p| p as u32)
        };
        let parents = |points: &[u32]| {
            let mut parents: Vec<u32> = points.iter().filter_map(|&p| parent(p)).collect();
            parents.sort_unstable();
            parents.dedup();
            parents
        };
        let holds = self.holds.iter().map(|h| {
            let points = parents(&h.points);
            let chains = h.edge.as_ref().map_or(Vec::new(), |edge| edge.chains(coarse, &points));
            let (values, pieces, by_step) = (vec![0.0; points.len()], Vec::new(), Vec::new());
            HeldPoints { values, by_step, points, chains, pieces, ..h.clone() }
        });
        let rigid = self.rigid.iter().map(|r| RigidPoints {
            points: parents(&r.points),
            prescribed: r.prescribed.map(|p| p.map(|_| 0.0)),
            by_step: Vec::new(),
            ..r.clone()
        });
        let mut springs: BTreeMap<(usize, [(usize, u64); 2]), Spring> = BTreeMap::new();
        for spring in &self.springs {
            let Some(point) = parent(spring.point as u32).map(|p| p as usize) else { continue };
            let key = (point, spring.shares.map(|(component, share)| (component, share.to_bits())));
            let sum = springs.entry(key).or_insert(Spring { point, stiffness: 0.0, ..*spring });
            sum.stiffness += spring.stiffness;
        }
        Self {
            holds: holds.collect(),
            rigid: rigid.collect(),
            springs: springs.into_values().collect(),
            turning: self.turning,
            axes: self.axes,
        }
    }

    /// Whether nothing holds the body.
    pub fn is_empty(&self) -> bool {
        self.holds.is_empty() && self.rigid.is_empty() && self.springs.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use peristat_assembly::condition::Constraints;

    fn region(lattice: &SquareLattice, [ux, uy, phi]: [Option<f64>; 3]) -> Conditions {
        let points = (0..lattice.points() as u32).collect();
        let prescribed = [ux, uy, None, None, None, phi];
        let (centre, origin) = ([0.7, -0.2, 0.0], "rigid[0]".into());
        let rigid = RigidPoints { points, centre, prescribed, by_step: Vec::new(), origin };
        Conditions { rigid: vec![rigid], axes: 2, ..Default::default() }
    }

    /// Displacements of a rigid motion about a centre.
    fn motion(lattice: &SquareLattice, [a, b, turn]: [f64; 3], centre: [f64; 2]) -> Vec<f64> {
        let at = |p: usize| lattice.place(p);
        let x = (0..lattice.points()).map(|p| a - turn * (at(p)[1] - centre[1]));
        let y = (0..lattice.points()).map(|p| b + turn * (at(p)[0] - centre[0]));
        x.chain(y).collect()
    }

    #[test]
    fn a_rigid_region_moves_by_three_numbers() {
        for size in [[3, 2], [2, 5], [4, 1], [1, 3]] {
            let lattice = SquareLattice::rectangle(0.3, [1.0, 2.0], size);
            let conditions = region(&lattice, [None; 3]);
            let constraints =
                Constraints::new(lattice.points(), &conditions.equations(&|p| lattice.position(p))).unwrap();
            assert_eq!(constraints.rows().len(), 2 * lattice.points() - 3, "{size:?}");
            // What a rigid motion leaves of the equations is rounding.
            let expected = motion(&lattice, [0.3, -0.5, 0.8], [0.1, 0.2]);
            let mut u = expected.clone();
            constraints.rows().iter().for_each(|r| u[r.unknown] = f64::NAN);
            constraints.expand(1.0, &mut u);
            for (found, expected) in u.iter().zip(&expected) {
                assert!((found - expected).abs() < 1e-14, "{found} {expected}");
            }
        }
    }

    /// In space three displacements and three rotations are left, whatever the region; of prescribed ones none.
    #[test]
    fn a_rigid_region_of_a_solid_moves_by_six_numbers() {
        let (moved, turn, centre) = ([0.3, -0.5, 0.2], [0.8, -0.3, 0.4], [0.7, -0.2, 9.0]);
        let value = |k: usize| if k < 3 { moved[k] } else { turn[k - 3] };
        for (size, held) in [([3, 2, 4], 0), ([1, 2, 5], 3), ([9, 1, 2], 4), ([2, 2, 1], 6)] {
            let lattice = SquareLattice::cuboid(0.3, [1.0, 2.0, -1.0], size);
            let points = (0..lattice.points() as u32).collect();
            // Rotations first.
            let prescribed = [5, 4, 3, 2, 1, 0].map(|k| (k < held).then_some(k));
            let prescribed = std::array::from_fn(|k| prescribed[k].map(|_| value(k)));
            let (by_step, origin) = (Vec::new(), String::new());
            let rigid = RigidPoints { points, centre, prescribed, by_step, origin };
            let conditions = Conditions { rigid: vec![rigid.clone()], axes: 3, ..Default::default() };
            let at = |p: usize| lattice.position(p);
            let constraints = Constraints::new(lattice.points(), &conditions.equations(&at)).unwrap();
            assert_eq!(constraints.rows().len(), 3 * lattice.points() + held - 6, "{size:?}");
            let n = lattice.points();
            let place = |k: usize| {
                let [c, next, last] = [k / n, (k / n + 1) % 3, (k / n + 2) % 3];
                let arm = |axis: usize| at(k % n)[axis] - centre[axis];
                moved[c] + turn[next] * arm(last) - turn[last] * arm(next)
            };
            let expected: Vec<f64> = (0..3 * n).map(place).collect();
            let mut u = expected.clone();
            constraints.rows().iter().for_each(|r| u[r.unknown] = f64::NAN);
            constraints.expand(1.0, &mut u);
            for (found, expected) in u.iter().zip(&expected) {
                assert!((found - expected).abs() < 1e-13, "{size:?} {held}: {found} {expected}");
            }
            for (axis, turn) in turn.into_iter().enumerate() {
                let found = conditions.rotation(&rigid, axis, &at, &|of| u[of.component * n + of.point]);
                assert!((found - turn).abs() < 1e-13, "{size:?} {axis}: {found}");
            }
        }
    }

    #[test]
    fn points_that_turn_turn_with_their_region() {
        let (lattice, turning) = (SquareLattice::rectangle(0.3, [1.0, 2.0], [3, 2]), 0.3);
        for prescribed in [[None; 3], [Some(0.1), Some(-0.2), Some(0.4)]] {
            let conditions = Conditions { turning: Some(turning), ..region(&lattice, prescribed) };
            let constraints =
                Constraints::new(lattice.points(), &conditions.equations(&|p| lattice.position(p))).unwrap();
            let free = prescribed.iter().filter(|p| p.is_none()).count();
            assert_eq!(constraints.rows().len(), 3 * lattice.points() - free);
            let mut expected = motion(&lattice, [0.1, -0.2, 0.4], [0.7, -0.2]);
            expected.extend(vec![turning * 0.4; lattice.points()]);
            let mut u = expected.clone();
            constraints.rows().iter().for_each(|r| u[r.unknown] = f64::NAN);
            constraints.expand(1.0, &mut u);
            for (found, expected) in u.iter().zip(&expected) {
                assert!((found - expected).abs() < 1e-14, "{found} {expected}");
            }
        }
    }

    #[test]
    fn prescribed_motions_are_those_of_the_centre() {
        let lattice = SquareLattice::rectangle(0.5, [0.0; 2], [3, 4]);
        let conditions = region(&lattice, [Some(0.1), Some(-0.2), Some(0.3)]);
        let equations = conditions.equations(&|p| lattice.position(p));
        let constraints = Constraints::new(lattice.points(), &equations).unwrap();
        let mut u = vec![0.0; 2 * lattice.points()];
        constraints.expand(1.0, &mut u);
        let expected = motion(&lattice, [0.1, -0.2, 0.3], [0.7, -0.2]);
        assert!(u.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-14), "{u:?} {expected:?}");
        // A pin turns: ux and uy of its centre leave one unknown.
        let pin = region(&lattice, [Some(0.1), Some(-0.2), None]).equations(&|p| lattice.position(p));
        let rows = Constraints::new(lattice.points(), &pin).unwrap().rows().len();
        assert_eq!(rows, 2 * lattice.points() - 1);
    }

    #[test]
    fn coarse_points_are_held_where_a_child_is_and_springs_add_up() {
        let fine = SquareLattice::rectangle(1.0, [0.0; 2], [4, 2]);
        let (points, direction) = (vec![1, 2, 5], [1.0, 0.0, 0.0]);
        let (edge, chains, origin) = (None, Vec::new(), String::new());
        let (pieces, values, by_step) = (Vec::new(), vec![3.0; 3], Vec::new());
        let hold = HeldPoints { points, edge, chains, pieces, direction, values, by_step, origin };
        let spring = |point| Spring { point, shares: [(1, 1.0), (1, 0.0)], stiffness: 2.0 };
        let springs = vec![spring(2), spring(3), spring(0)];
        let conditions = Conditions { holds: vec![hold], springs, ..region(&fine, [Some(1.0), None, None]) };
        let coarse = conditions.coarser(&fine, &fine.coarser());
        assert_eq!((&coarse.holds[0].points[..], &coarse.holds[0].values[..]), (&[0, 1][..], &[0.0; 2][..]));
        assert_eq!((&coarse.rigid[0].points[..], coarse.rigid[0].prescribed[0]), (&[0, 1][..], Some(0.0)));
        let sums: Vec<(usize, f64)> = coarse.springs.iter().map(|s| (s.point, s.stiffness)).collect();
        assert_eq!(sums, [(0, 2.0), (1, 4.0)]);
    }
}
