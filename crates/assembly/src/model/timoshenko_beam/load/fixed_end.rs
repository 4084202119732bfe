//! Fixed-end forces: what the loads inside a bond put on its two points.

use super::{BeamLoads, Carried, Distributed, EndForces, Intensity, PointAction, Span};
use crate::model::timoshenko_beam::Chain;
use crate::model::timoshenko_beam::chain::pieces;
use crate::quadrature::GAUSS;
use std::array::from_fn;
use std::ops::Range;

/// Fixed-end forces of the loads on one line.
pub(in super::super) struct FixedEnd<'a> {
    carried: Carried<'a>,
    chain: &'a Chain,
    /// EI and S, where they do not vary.
    plain: Option<(f64, f64)>,
    /// Per distributed load and class of a uniform line: end forces of loads that fall from one at the start of a bond to zero at its
    /// end, and the reverse. A load that is straight over a bond is a sum of them.
    units: Vec<Vec<[EndForces; 2]>>,
    /// Distances from the start at which the stiffness or the loads are not smooth, in order.
    breaks: Vec<f64>,
}

impl<'a> FixedEnd<'a> {
    /// The loads that bonds of a line carry.
    pub(in super::super) fn new(loads: &'a BeamLoads, number: usize, chain: &'a Chain) -> Self {
        let stiffness = &chain.line().stiffness;
        let carried = Carried::of(loads, number);
        let breaks = carried.breaks(chain);
        let plain = stiffness.plain();
        let units = match plain.filter(|_| chain.is_uniform()) {
            Some(plain) => carried.distributed.iter().map(|load| units(load, chain, plain)).collect(),
            None => vec![Vec::new(); carried.distributed.len()],
        };
        Self { carried, chain, plain, units, breaks }
    }

    /// The distributed loads that bonds carry.
    pub(super) fn distributed(&self) -> &[&'a Distributed] {
        &self.carried.distributed
    }

    /// End forces of a distributed load of one per length on the bonds of a class, where they are all alike.
    pub(super) fn of_unit(&self, number: usize, class: usize) -> Option<EndForces> {
        let [falling, rising] = self.units[number].get(class)?;
        Some(from_fn(|k| falling[k] + rising[k]))
    }

    /// Forces of all loads inside one bond, weight not included.
    pub(in super::super) fn of(&self, class: usize, lower: usize) -> EndForces {
        if self.plain.is_none() {
            return self.by_flexibility(&self.carried, class, lower);
        }
        let mut sum = self.of_spread(class, lower).unwrap_or_default();
        for number in 0..self.carried.distributed.len() {
            let part = self.of_one(number, class, lower);
            (0..6).for_each(|k| sum[k] += part[k]);
        }
        sum
    }

    /// Forces of one of the distributed loads inside a bond.
    pub(super) fn of_one(&self, number: usize, class: usize, lower: usize) -> EndForces {
        let load = self.carried.distributed[number];
        let ends = [lower, lower + self.chain.weights.step(class)].map(|point| self.chain.position(point));
        match load.is_linear_over(ends).zip(self.units[number].get(class)) {
            Some(([qa, qb], [falling, rising])) => from_fn(|k| qa * falling[k] + qb * rising[k]),
            None => {
                let carried = Carried { distributed: vec![load], point: Vec::new() };
                self.end_forces(&carried, class, lower)
            }
        }
    }

    /// Forces of the concentrated loads that bonds carry, if there are any inside a bond.
    pub(super) fn of_spread(&self, class: usize, lower: usize) -> Option<EndForces> {
        let bond = self.chain.bonds.bond(class, lower);
        let span = Span { x: self.chain.position(lower), length: bond.length, shear_ratio: 0.0 };
        let inside = |p: &&&PointAction| span.inside(p.x).is_some();
        let point: Vec<&PointAction> = self.carried.point.iter().filter(inside).copied().collect();
        (!point.is_empty())
            .then(|| self.end_forces(&Carried { distributed: Vec::new(), point }, class, lower))
    }

    /// `(∫ q, ∫ (b − x) q − ∫ c, ∫ p)` of all loads that bonds carry inside `[a, b]`; a concentrated one at `b` only if
    /// `with_end`.
    pub(in super::super) fn resultant(&self, a: f64, b: f64, with_end: bool) -> [f64; 3] {
        self.carried.resultant(a, b, with_end)
    }

    /// The points or cells of a range between its outermost ones whose bonds are all ordinary and carry the same of `loads`, where
    /// all between them are so; else none, at its end. The bonds of a point or cell begin up to `before` points before it.
    pub(super) fn alike(&self, loads: &[&Distributed], before: usize, range: &Range<usize>) -> Range<usize> {
        let none = range.end..range.end;
        if !self.chain.is_uniform() || loads.iter().any(|load| load.constant().is_none()) {
            return none;
        }
        let (chain, reach) = (self.chain, self.chain.weights.reach());
        let are_alike = |part: &Range<usize>| {
            part.start >= before
                && chain.intact_weights().are_ordinary(part.start - before..part.end)
                && loads.iter().all(|load| {
                    chain.position(part.start - before) >= load.from
                        && chain.position(part.end - 1 + reach) <= load.to
                })
        };
        let is_alike = |one: &usize| are_alike(&(*one..*one + 1));
        let ends = range.clone().find(is_alike).zip(range.clone().rfind(is_alike));
        ends.map(|(first, last)| first..last + 1).filter(are_alike).unwrap_or(none)
    }

    /// As [`Self::alike`], of cells under all loads.
    pub(in super::super) fn cells_alike(&self, range: &Range<usize>) -> Range<usize> {
        let loads = if self.spreads() { return range.end..range.end } else { &self.carried.distributed };
        self.alike(loads, self.chain.weights.reach() - 1, range)
    }

    /// Whether bonds carry any load.
    pub(in super::super) fn is_needed(&self) -> bool {
        !self.carried.distributed.is_empty() || self.spreads()
    }

    /// Whether bonds carry concentrated loads.
    pub(super) fn spreads(&self) -> bool {
        !self.carried.point.is_empty()
    }

    fn end_forces(&self, carried: &Carried, class: usize, lower: usize) -> EndForces {
        let Some((bending, shear)) = self.plain else {
            return self.by_flexibility(carried, class, lower);
        };
        let span = Span::new(self.chain, class, lower, bending, shear);
        let mut sum = [0.0; 6];
        let mut add = |part: EndForces, factor: f64| (0..6).for_each(|k| sum[k] += factor * part[k]);
        carried.distributed.iter().for_each(|load| add(load.on(&span), 1.0));
        for action in &carried.point {
            if let Some(z) = span.inside(action.x) {
                action.parts().for_each(|(along, value)| add(span.of(along, z), value));
            }
        }
        sum
    }

    /// The force method: the bond held at its upper point alone deforms under its loads; the end actions that close this
    /// deformation, and what the loads leave at the upper point, are the fixed-end forces.
    fn by_flexibility(&self, carried: &Carried, class: usize, lower: usize) -> EndForces {
        let chain = self.chain;
        let bond = chain.bonds.bond(class, lower);
        let step = chain.weights.step(class);
        let a = chain.position(lower);
        let middle = a + 0.5 * bond.length;
        // Deformations Δu, Δφ, ξγ.
        let mut open = [0.0; 3];
        for cell in lower..lower + step {
            for (from, to) in
                pieces(chain.line(), &self.breaks, chain.position(cell), chain.position(cell + 1))
            {
                for (z, g) in GAUSS {
                    let (x, width) = (from + z * (to - from), g * (to - from));
                    let [q, moment, p] = carried.resultant(a, x, true);
                    let (normal, shear) = (-p, -q);
                    let c = chain.line().stiffness.compliance(x - chain.line().from);
                    let curvature = c.bending * moment + c.coupling * normal;
                    // A line without axial unknowns need not say how stiff it is along its axis.
                    let strain = c.coupling * moment + if p == 0.0 { 0.0 } else { c.axial * normal };
                    open[0] += width * strain;
                    open[1] += width * curvature;
                    open[2] += width * (c.shear * shear - curvature * (x - middle));
                }
            }
        }
        let [q, moment, p] = carried.resultant(a, a + bond.length, false);
        // Basic forces N, M₀, V that close the deformation: −C open, with C = UᵀDU.
        let axial = bond.axial * (open[0] + bond.axial_bending * open[1]);
        let v = bond.shear * (open[2] + bond.eccentricity * open[1] + bond.shear_axial * open[0]);
        let n = axial + bond.shear_axial * v;
        let m = bond.bending * open[1] + bond.eccentricity * v + bond.axial_bending * axial;
        let half = 0.5 * bond.length;
        // The forces on the points are minus those on the bond.
        [-v, -m - half * v, q + v, m - half * v - moment, -n, p + n]
    }
}

/// End forces of unit loads on the bonds of every class of a uniform line.
fn units(load: &Distributed, chain: &Chain, (bending, shear): (f64, f64)) -> Vec<[EndForces; 2]> {
    let unit = |class: usize, start: f64, end: f64| {
        let span = Span { x: 0.0, ..Span::new(chain, class, 0, bending, shear) };
        let intensity = Intensity::Linear { start, end };
        Distributed { from: 0.0, to: span.length, intensity, ..*load }.on(&span)
    };
    (0..chain.weights.classes()).map(|class| [unit(class, 1.0, 0.0), unit(class, 0.0, 1.0)]).collect()
}
