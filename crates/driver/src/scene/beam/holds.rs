//! What supports do to points: motions that they prescribe or resist, as equations and springs.

use super::one_way::{OneWay, Origin, Part};
use super::supports::HeldPoint;
use crate::case::{Sign, Support, number};
use peristat_assembly::condition::{Equation, Unknown};
use peristat_assembly::model::timoshenko_beam::{PHI, U, W};
use peristat_assembly::stiffness::Spring;

/// One motion that a support prescribes or resists.
#[derive(Clone, Debug)]
pub struct Hold {
    /// Which motion.
    pub motion: Motion,
    /// Prescribed value, or stiffness of a spring.
    pub how: How,
    /// Line and real point that it acts on: the hinged ends of a joint do not turn with the others.
    pub local: (usize, usize),
    /// Number of this point.
    pub point: usize,
    /// Unknowns of the point that make up the motion, with their coefficients, the largest first.
    pub terms: Vec<(usize, f64)>,
    /// Sign of the only force that it exerts, 1 or −1, and how far the motion may be passed before it does.
    pub(super) only: Option<[f64; 2]>,
    key: &'static str,
}

/// A motion of a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Motion {
    /// Displacement in a direction of the plane.
    Direction([f64; 2]),
    /// Rotation.
    Rotation,
}

/// How a motion is held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum How {
    /// It has this value at a load factor of one.
    Prescribed(f64),
    /// A spring of this stiffness resists it.
    Spring(f64),
}

const X: Motion = Motion::Direction([1.0, 0.0]);
const Y: Motion = Motion::Direction([0.0, 1.0]);

impl Motion {
    /// Components and coefficients of the motion of a point on a line of this direction, the largest first. Without
    /// axial unknowns the displacement along the line is zero.
    pub(super) fn terms(self, [c, s]: [f64; 2], has_axial: bool) -> Vec<(usize, f64)> {
        let Self::Direction([x, y]) = self else { return vec![(PHI, 1.0)] };
        // What rounding leaves of a right angle is no share.
        let all = [(W, c * y - s * x), (U, c * x + s * y)];
        let mut terms: Vec<(usize, f64)> = all.into_iter().filter(|t| t.1.abs() > 1e-15).collect();
        terms.retain(|t| has_axial || t.0 != U);
        terms.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
        terms
    }
}

impl Hold {
    /// Whether it holds the displacement along x, and nothing else.
    pub(super) fn is_along_x(&self) -> bool {
        self.motion == X
    }
}

/// Everything that a support does to the point that moves and the one that turns.
pub(super) fn holds(support: &Support, moving: (usize, usize), turning: (usize, usize)) -> Vec<Hold> {
    let inclined = support.inclined.map(|inclined| {
        let angle = inclined.degrees.to_radians();
        // What rounding leaves of a right angle is no share.
        let clean = |share: f64| if share.abs() < 1e-15 { 0.0 } else { share };
        (Motion::Direction([clean(angle.cos()), clean(angle.sin())]), inclined.displacement)
    });
    let prescribed = [
        (Y, number(support.w.as_ref()), "w"),
        (X, number(support.ux.as_ref()), "ux"),
        (Y, number(support.uy.as_ref()), "uy"),
        (inclined.map_or(Y, |i| i.0), inclined.map(|i| i.1), "inclined"),
        (Motion::Rotation, number(support.phi.as_ref()), "phi"),
    ];
    let springs = [
        (Y, support.w_spring, "w_spring"),
        (X, support.ux_spring, "ux_spring"),
        (Y, support.uy_spring, "uy_spring"),
        (Motion::Rotation, support.phi_spring, "phi_spring"),
    ];
    let prescribed = prescribed.into_iter().map(|(m, value, key)| (m, value.map(How::Prescribed), key));
    let springs = springs.into_iter().map(|(m, value, key)| (m, value.map(How::Spring), key));
    let only = support.only.map(|only| [Sign::factor(only), support.gap.unwrap_or(0.0)]);
    let hold = |(motion, how, key): (Motion, Option<How>, &'static str)| {
        let local = if motion == Motion::Rotation { turning } else { moving };
        Some(Hold { motion, how: how?, local, point: 0, terms: Vec::new(), only, key })
    };
    prescribed.chain(springs).filter_map(hold).collect()
}

/// Equations of what supports prescribe, in their order.
pub(super) fn equations(held: &[HeldPoint]) -> Vec<Equation> {
    let mut equations = Vec::new();
    for h in held {
        for hold in &h.holds {
            if let How::Prescribed(value) = hold.how
                && !hold.terms.is_empty()
            {
                let unknown = |&(component, c): &(usize, f64)| (Unknown { component, point: hold.point }, c);
                let terms = hold.terms.iter().map(unknown).collect();
                equations.push(Equation { terms, value, origin: h.path.key(hold.key).to_string() });
            }
        }
    }
    equations
}

/// What supports hold one way, by its number among the [`equations`] or the [`springs`].
pub(super) fn one_way(held: &[HeldPoint]) -> Vec<OneWay> {
    let (mut equations, mut springs, mut found) = (0, 0, Vec::new());
    for (number, h) in held.iter().enumerate() {
        for hold in h.holds.iter().filter(|hold| !hold.terms.is_empty()) {
            let (next, part): (&mut usize, fn(usize) -> Part) = match hold.how {
                How::Prescribed(_) => (&mut equations, Part::Equation),
                How::Spring(_) => (&mut springs, Part::Spring),
            };
            if let Some([sign, gap]) = hold.only {
                found.push(OneWay { part: part(*next), sign, gap, origin: Origin::Support(number) });
            }
            *next += 1;
        }
    }
    found
}

/// Springs of supports, in their order.
pub(super) fn springs(held: &[HeldPoint]) -> Vec<Spring> {
    let spring = |hold: &Hold| {
        let (How::Spring(stiffness), point) = (hold.how, hold.point) else { return None };
        match hold.terms[..] {
            [(component, c)] => Some(Spring { point, shares: [(component, c), (component, 0.0)], stiffness }),
            [a, b] => Some(Spring { point, shares: [a, b], stiffness }),
            _ => None,
        }
    };
    held.iter().flat_map(|h| &h.holds).filter_map(spring).collect()
}
