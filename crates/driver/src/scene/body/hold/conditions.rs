//! What holds a body, by points: equations for its lattice and for any coarser one are made of it.

use super::held_edge::HeldEdge;
use super::rigid::{Basis, RigidPoints};
use peristat_assembly::body::SquareLattice;
use peristat_assembly::bonds::Point;
use peristat_assembly::condition::{Equation, Unknown};
use peristat_assembly::model::BodyModel;
use peristat_assembly::stiffness::Spring;
use std::array::from_fn;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

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

/// Points of held edges and the bits of directions, with the value, none of a formula, and the origin of what holds them.
pub(super) type HeldCorners = BTreeMap<(u32, [u64; 3]), (Option<f64>, String)>;

/// Points with a prescribed motion.
#[derive(Clone, Debug, PartialEq)]
pub struct HeldPoints {
    /// Numbers of the points, ascending.
    pub points: Vec<u32>,
    /// How an edge is held, where it is not its points that are.
    pub edge: Option<HeldEdge>,
    /// With an edge, the points behind each point; none where the point itself is held.
    pub chains: Vec<Vec<u32>>,
    /// Pieces of a border that are held in place of the points, by points and their shares; none where no border is.
    pub pieces: Vec<Vec<(u32, f64)>>,
    /// What is held, a unit vector: a direction, or the rotation, which is the third component.
    pub direction: [f64; 3],
    /// The unknown along it at a factor of one, of each point: a displacement, or the rotation times [`Conditions::turning`].
    pub values: Vec<f64>,
    /// Whether a formula gives these.
    pub varies: bool,
    /// Where it stands in the case.
    pub origin: String,
}

impl Conditions {
    /// Numbers of the points that supports hold and of those of rigid regions, as often as they are.
    pub(crate) fn held_points(&self) -> impl Iterator<Item = usize> + '_ {
        let held = self.holds.iter().map(|h| &h.points);
        held.chain(self.rigid.iter().map(|r| &r.points)).flatten().map(|&p| p as usize)
    }

    /// Those of edges that are held on their lines, which stretches the bonds there far more than those of the rest.
    pub(crate) fn gripped_points(&self) -> impl Iterator<Item = usize> + '_ {
        let on_line = |h: &&HeldPoints| h.edge.is_some() || !h.pieces.is_empty();
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
            HeldPoints { values: vec![0.0; points.len()], points, chains, pieces: Vec::new(), ..h.clone() }
        });
        let rigid = self.rigid.iter().map(|r| RigidPoints {
            points: parents(&r.points),
            prescribed: r.prescribed.map(|p| p.map(|_| 0.0)),
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

impl HeldPoints {
    /// Leaves out points whose edge another hold has held along the same direction: what both hold of the points beside a
    /// corner says the rest, and to hold it twice is no more than to the rounding of both. Points that are held at another
    /// number stay, and the origins of these are returned; formulas have other values at other places.
    pub(super) fn leave_corners(&mut self, held: &mut HeldCorners) -> Vec<String> {
        if self.edge.is_none() && self.pieces.is_empty() {
            return Vec::new();
        }
        let direction = self.direction.map(f64::to_bits);
        let mut others = Vec::new();
        let mut keep = |point: u32, value: Option<f64>| match held.entry((point, direction)) {
            Entry::Vacant(place) => {
                place.insert((value, self.origin.clone()));
                true
            }
            Entry::Occupied(place) if place.get().0.zip(value).is_none_or(|(other, own)| other == own) => {
                false
            }
            Entry::Occupied(place) => {
                others.push(place.get().1.clone());
                true
            }
        };
        let kept: Vec<bool> = self
            .points
            .iter()
            .zip(&self.values)
            .map(|(&point, &value)| keep(point, (!self.varies).then_some(value)))
            .collect();
        retain(&mut self.points, &kept);
        retain(&mut self.chains, &kept);
        retain(&mut self.pieces, &kept);
        retain(&mut self.values, &kept);
        others
    }

    /// The places that it holds: of its points, or of the border that moves with them.
    pub(super) fn places(&self, model: &dyn BodyModel) -> Vec<Point> {
        // The shares of an edge are the same along both axes, or only one of them is held.
        let component = self.direction.iter().position(|d| *d != 0.0).unwrap_or_default();
        let sum = |terms: &mut dyn Iterator<Item = (u32, f64)>| {
            terms.fold([0.0; 3], |sum, (point, share)| {
                let at = model.position(point as usize);
                from_fn(|k| sum[k] + share * at[k])
            })
        };
        let place = |(k, &point): (usize, &u32)| {
            let chain = self.chains.get(k).filter(|chain| !chain.is_empty()).zip(self.edge.as_ref());
            match (self.pieces.get(k), chain) {
                (Some(piece), _) => sum(&mut piece.iter().copied()),
                (_, Some((chain, edge))) => {
                    let points = std::iter::once(&point).chain(chain).copied();
                    sum(&mut points.zip(edge.shares(component).iter().copied()))
                }
                (_, None) => model.position(point as usize),
            }
        };
        self.points.iter().enumerate().map(place).collect()
    }

    fn equations(&self) -> impl Iterator<Item = Equation> + '_ {
        let [x, y, turn] = self.direction;
        // The larger share first: it is the one to divide by.
        let [first, second] = if x.abs() >= y.abs() { [(0, x), (1, y)] } else { [(1, y), (0, x)] };
        let shares = [first, second, (2, turn)];
        self.points.iter().enumerate().map(move |(k, &point)| {
            let chain = self.chains.get(k).filter(|chain| !chain.is_empty()).zip(self.edge.as_ref());
            let mut terms = Vec::new();
            for (component, share) in shares.into_iter().filter(|s| s.1 != 0.0) {
                let mut term =
                    |point: u32, c: f64| terms.push((Unknown { component, point: point as usize }, c));
                match (self.pieces.get(k), chain) {
                    (Some(piece), _) => piece.iter().for_each(|&(p, s)| term(p, share * s)),
                    (_, None) => term(point, share),
                    (_, Some((chain, edge))) => {
                        let points = std::iter::once(&point).chain(chain);
                        points.zip(edge.shares(component)).for_each(|(&p, s)| term(p, share * s));
                    }
                }
            }
            Equation { terms, value: self.values[k], origin: self.origin.clone() }
        })
    }
}

/// Keeps what stands beside points that are kept, in a list of as many or of none.
fn retain<T>(list: &mut Vec<T>, kept: &[bool]) {
    let mut each = kept.iter();
    list.retain(|_| each.next().is_none_or(|kept| *kept));
}

#[cfg(test)]
mod tests {
    use super::*;
    use peristat_assembly::condition::Constraints;

    fn region(lattice: &SquareLattice, [ux, uy, phi]: [Option<f64>; 3]) -> Conditions {
        let points = (0..lattice.points() as u32).collect();
        let prescribed = [ux, uy, None, None, None, phi];
        let rigid = RigidPoints { points, centre: [0.7, -0.2, 0.0], prescribed, origin: "rigid[0]".into() };
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
            let rigid = RigidPoints { points, centre, prescribed, origin: String::new() };
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
        let hold = HeldPoints {
            points,
            edge,
            chains,
            pieces: Vec::new(),
            direction,
            values: vec![3.0; 3],
            varies: false,
            origin,
        };
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
