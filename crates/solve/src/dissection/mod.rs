//! Fill-reducing orders of points in a plane by nested dissection.

mod cut;
mod directions;
mod graph;
mod minimum_degree;
mod tree;

use cut::Cut;
use directions::Direction;
pub use graph::PointGraph;
use minimum_degree::MinimumDegree;

/// Sets of at most so many points are ordered by minimum degree. Fill of a square lattice of 1e5
/// points with 28 neighbours: 30 points +0.3 %, 120 points +0.4 %, 500 points +1.7 %.
const LEAF: usize = 64;

/// An order of elimination of points: two halves that are not coupled with each other, then what
/// separates them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Dissection {
    pub(crate) order: Vec<usize>,
    pub(crate) halves: [usize; 2],
}

impl Dissection {
    /// The points in the order of elimination.
    #[must_use]
    pub fn order(&self) -> &[usize] {
        &self.order
    }

    /// How many points the first and the second half have; the separator has the rest.
    #[must_use]
    pub fn halves(&self) -> [usize; 2] {
        self.halves
    }
}

/// Orders points so that elimination fills little (George 1973).
///
/// The points are cut in two along a line, and those with neighbours across the line become the
/// separator, which is eliminated last; so on with the halves, down to sets that are ordered by
/// minimum degree, their neighbours in separators counted. Lines run along the edges of the convex
/// hull of what points reach; the cut with the smallest separator for the evenness of its sides is
/// taken. A separator holds only points that are coupled with the other side: cuts, holes and
/// disconnected parts make it thinner. On a square lattice of 1e5 points with 28 neighbours the
/// factor has 2 % less entries than with METIS.
///
/// # Panics
///
/// If there are not as many positions as points.
#[must_use]
pub fn nested_dissection(positions: &[[f64; 2]], graph: &PointGraph) -> Dissection {
    assert_eq!(positions.len(), graph.points(), "one position for each point");
    let points = positions.len();
    let mut order: Vec<u32> = (0..points as u32).collect();
    let mut state = Dissecting {
        positions,
        graph,
        directions: directions::directions(positions, graph),
        side: vec![Side::default(); points],
        sides: 0,
        place: vec![NONE; points],
        minimum_degree: MinimumDegree::default(),
        lists: Default::default(),
    };
    let halves = state.dissect(&mut order);
    tree::postorder(graph, &mut order, halves[0] + halves[1]);
    Dissection { order: order.into_iter().map(|p| p as usize).collect(), halves }
}

const NONE: u32 = u32::MAX;

/// A number for each side of each cut; 0 for separators.
type Side = u32;

struct Dissecting<'a> {
    positions: &'a [[f64; 2]],
    graph: &'a PointGraph,
    directions: Vec<Direction>,
    /// The side on which a point was put last.
    side: Vec<Side>,
    sides: Side,
    /// Number of a point in the set that is being ordered.
    place: Vec<u32>,
    minimum_degree: MinimumDegree,
    lists: [Vec<u32>; 2],
}

impl Dissecting<'_> {
    /// Orders a set of points; returns the sizes of its halves, the second 0 if it was not cut.
    fn dissect(&mut self, points: &mut [u32]) -> [usize; 2] {
        let halves = if points.len() > LEAF { self.separate(points) } else { None };
        let Some([left, right]) = halves else {
            self.finish(points);
            return [points.len(), 0];
        };
        let (first, rest) = points.split_at_mut(left);
        self.dissect(first);
        self.dissect(&mut rest[..right]);
        [left, right]
    }

    /// Sorts points into left half, right half and separator; `None` if no line has points on
    /// either side.
    fn separate(&mut self, points: &mut [u32]) -> Option<[usize; 2]> {
        let cut = cut::cheapest(points, self.positions, &self.directions)
            .or_else(|| cut::median(points, self.positions, &self.directions))?;
        let sides = [self.sides + 1, self.sides + 2];
        self.sides += 2;
        let counts = self.assign(points, &cut, sides);
        let [left, right] = counts.map(|count| count as f64);
        let [from_left, from_right] = self.lists.each_ref().map(|list| list.len() as f64);
        let thinner =
            cut::price(left - from_left, from_left, right) < cut::price(left, from_right, right - from_right);
        for p in &self.lists[usize::from(!thinner)] {
            self.side[*p as usize] = 0;
        }
        let [others, separator] = &mut self.lists;
        others.clear();
        separator.clear();
        let mut to = 0;
        for k in 0..points.len() {
            let p = points[k];
            match self.side[p as usize] {
                0 => separator.push(p),
                side if side == sides[0] => {
                    points[to] = p;
                    to += 1;
                }
                _ => others.push(p),
            }
        }
        let halves = [to, others.len()];
        for (to, p) in points[to..].iter_mut().zip(others.iter().chain(separator.iter())) {
            *to = *p;
        }
        Some(halves).filter(|halves| !halves.contains(&0))
    }

    /// Puts points on either side of a cut, and those with neighbours across it on the lists of
    /// their side.
    fn assign(&mut self, points: &[u32], cut: &Cut, sides: [Side; 2]) -> [usize; 2] {
        let Cut { direction, at } = *cut;
        let mut counts = [0; 2];
        self.lists.iter_mut().for_each(Vec::clear);
        for p in points {
            let x = direction.along(self.positions[*p as usize]) - at;
            let right = usize::from(x >= 0.0);
            self.side[*p as usize] = sides[right];
            counts[right] += 1;
            // A little farther than neighbours reach, for the rounding of projections.
            if x.abs() <= 1.000_001 * direction.reach {
                self.lists[right].push(*p);
            }
        }
        for (list, across) in self.lists.iter_mut().zip([sides[1], sides[0]]) {
            let (graph, side) = (self.graph, &self.side);
            list.retain(|p| graph.neighbours(*p as usize).iter().any(|q| side[*q as usize] == across));
        }
        counts
    }

    /// Orders a set of points by minimum degree among their neighbours, all of which are eliminated
    /// later.
    fn finish(&mut self, points: &mut [u32]) {
        let (graph, place, nodes) = (self.graph, &mut self.place, &mut self.lists[0]);
        nodes.clear();
        nodes.extend_from_slice(points);
        for (k, p) in points.iter().enumerate() {
            place[*p as usize] = k as u32;
        }
        for p in points.iter() {
            for q in graph.neighbours(*p as usize) {
                if place[*q as usize] == NONE {
                    place[*q as usize] = nodes.len() as u32;
                    nodes.push(*q);
                }
            }
        }
        let inner = points.len();
        self.minimum_degree.begin(nodes.len());
        for (k, p) in nodes.iter().enumerate() {
            for q in graph.neighbours(*p as usize) {
                let j = place[*q as usize];
                if j != NONE && (k < inner || (j as usize) < inner) {
                    self.minimum_degree.neighbour(j);
                }
            }
            self.minimum_degree.close();
        }
        let mut to = points.iter_mut();
        self.minimum_degree.order(inner, |node| {
            if let Some(to) = to.next() {
                *to = nodes[node as usize];
            }
        });
        nodes.iter().for_each(|p| place[*p as usize] = NONE);
    }
}

#[cfg(test)]
mod tests;
