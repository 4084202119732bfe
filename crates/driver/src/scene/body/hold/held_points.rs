//! Points that a support holds, or the places of a border that move with them.

use super::held_edge::HeldEdge;
use peristat_assembly::bonds::Point;
use peristat_assembly::condition::{Equation, Unknown};
use peristat_assembly::model::BodyModel;
use std::array::from_fn;

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
    /// The unknown along it at a factor of one, of each point: a displacement, or the rotation times [`Conditions::turning`](super::conditions::Conditions::turning).
    pub values: Vec<f64>,
    /// The same in every step, of each point; none where it grows with the load factor.
    pub by_step: Vec<Vec<f64>>,
    /// Where it stands in the case.
    pub origin: String,
}

impl HeldPoints {
    /// Keeps the points for which that is asked, with all that stands beside them.
    pub(super) fn retain(&mut self, kept: &[bool]) {
        retain(&mut self.points, kept);
        retain(&mut self.chains, kept);
        retain(&mut self.pieces, kept);
        retain(&mut self.values, kept);
        retain(&mut self.by_step, kept);
    }

    /// The same with what it prescribes in a step in place of that at a factor of one.
    pub(super) fn in_step(&self, step: usize, factor: f64) -> Self {
        let values = match self.by_step.is_empty() {
            true => self.values.iter().map(|value| factor * value).collect(),
            false => self.by_step.iter().map(|own| own[step]).collect(),
        };
        Self { values, ..self.clone() }
    }

    /// Whether a border is held, not its points.
    pub(super) fn is_on_border(&self) -> bool {
        self.edge.is_some() || !self.pieces.is_empty()
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

    pub(super) fn equations(&self) -> impl Iterator<Item = Equation> + '_ {
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
