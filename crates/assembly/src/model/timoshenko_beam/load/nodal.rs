//! Loads as forces on points.

use super::{BeamLoads, Distributed, EndForces, FixedEnd, PointAction, Span};
use crate::model::timoshenko_beam::{Chain, TimoshenkoBeam};
use std::ops::Range;

/// Points per block: enough to make little of what is done once per block.
const BLOCK: usize = 1024;

/// The loads on one line, made ready to be turned into forces on its points.
pub struct ChainLoads<'a> {
    chain: &'a Chain,
    /// Distributed loads that no bond carries.
    lumped: Vec<&'a Distributed>,
    fixed_end: FixedEnd<'a>,
    /// Per distributed load that bonds carry: forces (w, φ, u) on a point all of whose bonds are ordinary and carry the same load.
    interior: Vec<Option<[f64; 3]>>,
    /// Forces of concentrated loads: extended point, component, value.
    nodal: Vec<(usize, usize, f64)>,
}

impl BeamLoads {
    /// Adds the nodal forces to `force`, two or three planes of `beam.points()` entries.
    pub fn add_to(&self, beam: &TimoshenkoBeam, force: &mut [f64]) {
        for (number, chain) in beam.chains().iter().enumerate() {
            let loads = self.on_chain(beam, number);
            let first = beam.first(number);
            let mut start = 0;
            while start < chain.extended() && !loads.is_empty() {
                let range = start..(start + BLOCK).min(chain.extended());
                let planes = force.chunks_exact_mut(beam.points());
                let mut planes: Vec<&mut [f64]> =
                    planes.map(|plane| &mut plane[first + range.start..first + range.end]).collect();
                loads.add_block(range.clone(), &mut planes);
                start = range.end;
            }
        }
    }

    /// The loads on one line.
    pub fn on_chain<'a>(&'a self, beam: &'a TimoshenkoBeam, number: usize) -> ChainLoads<'a> {
        let chain = &beam.chains()[number];
        let mine = self.distributed.iter().filter(|load| self.lumped && load.chain == number);
        let lumped = mine.collect();
        let mut nodal = Vec::new();
        let fixed_end = FixedEnd::new(self, number, chain);
        for action in self.point.iter().filter(|p| p.chain == number) {
            place(action, chain, &mut nodal);
        }
        let interior = (0..fixed_end.distributed().len()).map(|k| interior(&fixed_end, k, chain)).collect();
        ChainLoads { chain, lumped, fixed_end, interior, nodal }
    }
}

/// Forces (w, φ, u) of a load on a point all of whose bonds are ordinary and carry the same load; none of one that varies.
fn interior(fixed_end: &FixedEnd, number: usize, chain: &Chain) -> Option<[f64; 3]> {
    let q = fixed_end.distributed()[number].constant()?;
    let mut forces = [0.0; 3];
    for class in 0..chain.weights.classes() {
        let (ends, weight) = (fixed_end.of_unit(number, class)?, chain.weights.of_class(class));
        let on_point = [ends[0] + ends[2], ends[1] + ends[3], ends[4] + ends[5]];
        (0..3).for_each(|k| forces[k] += q * weight * on_point[k]);
    }
    Some(forces)
}

impl ChainLoads<'_> {
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.lumped.is_empty() && self.nodal.is_empty() && !self.fixed_end.is_needed()
    }

    /// Adds the forces on a range of extended points to planes of as many entries, (w, φ) or (w, φ, u).
    pub fn add_block(&self, range: Range<usize>, planes: &mut [&mut [f64]]) {
        for load in &self.lumped {
            self.add_lumped(load, &range, planes);
        }
        for (number, (load, interior)) in self.fixed_end.distributed().iter().zip(&self.interior).enumerate()
        {
            let before = self.chain.weights.reach();
            let alike =
                interior.map_or(range.end..range.end, |_| self.fixed_end.alike(&[load], before, &range));
            for (plane, value) in planes.iter_mut().zip(interior.unwrap_or_default()) {
                plane[alike.start - range.start..alike.end - range.start]
                    .iter_mut()
                    .for_each(|f| *f += value);
            }
            for rest in
                [range.start..alike.start, alike.end..range.end].iter().filter(|rest| !rest.is_empty())
            {
                let mut planes: Vec<&mut [f64]> = planes
                    .iter_mut()
                    .map(|p| &mut p[rest.start - range.start..rest.end - range.start])
                    .collect();
                self.add_consistent(number, load, rest, &mut planes);
            }
        }
        if self.fixed_end.spreads() {
            self.add_spread(&range, planes);
        }
        for &(point, component, value) in &self.nodal {
            if range.contains(&point) && component < planes.len() {
                planes[component][point - range.start] += value;
            }
        }
    }

    /// Visits the bonds that end in a range: class, lower point, weight.
    fn each_bond(&self, range: &Range<usize>, mut visit: impl FnMut(usize, usize, f64)) {
        let weights = self.chain.intact_weights();
        for class in 0..weights.classes() {
            for lower in range.start.saturating_sub(weights.step(class))..range.end {
                let weight = weights.weight(class, lower);
                if weight != 0.0 {
                    visit(class, lower, weight);
                }
            }
        }
    }

    fn add_consistent(
        &self,
        number: usize,
        load: &Distributed,
        range: &Range<usize>,
        planes: &mut [&mut [f64]],
    ) {
        let chain = self.chain;
        self.each_bond(range, |class, lower, weight| {
            let upper = lower + chain.weights.step(class);
            if chain.position(upper) > load.from && chain.position(lower) < load.to {
                let ends = self.fixed_end.of_one(number, class, lower);
                scatter(range, planes, [lower, upper], weight, &ends);
            }
        });
    }

    /// Shares of concentrated loads that bonds carry.
    fn add_spread(&self, range: &Range<usize>, planes: &mut [&mut [f64]]) {
        self.each_bond(range, |class, lower, weight| {
            if let Some(ends) = self.fixed_end.of_spread(class, lower) {
                scatter(range, planes, [lower, lower + self.chain.weights.step(class)], weight, &ends);
            }
        });
    }

    fn add_lumped(&self, load: &Distributed, range: &Range<usize>, planes: &mut [&mut [f64]]) {
        let (chain, component) = (self.chain, load.along.component());
        let real = range.start.max(chain.ghosts[0])..range.end.min(chain.ghosts[0] + chain.points);
        let Some(plane) = planes.get_mut(component) else { return };
        for point in real {
            if let Some(([a, b], at)) = chain.share(point - chain.ghosts[0], [load.from, load.to]) {
                let force =
                    at.map_or_else(|| load.integrate(a, b, |_| [1.0])[0], |x| load.value(x) * (b - a));
                plane[point - range.start] += force;
            }
        }
    }
}

fn scatter(
    range: &Range<usize>,
    planes: &mut [&mut [f64]],
    points: [usize; 2],
    weight: f64,
    ends: &EndForces,
) {
    for (side, point) in points.into_iter().enumerate() {
        if range.contains(&point) {
            let values = [ends[2 * side], ends[2 * side + 1], ends[4 + side]];
            for (plane, value) in planes.iter_mut().zip(values) {
                plane[point - range.start] += weight * value;
            }
        }
    }
}

/// The part of a concentrated load that no bond carries: all of it at a split or an end, at a point inside an unsplit
/// chain what the weights of the bonds that span it leave.
fn place(action: &PointAction, chain: &Chain, nodal: &mut Vec<(usize, usize, f64)>) {
    let nearest = chain.ghosts[0] + chain.nearest(action.x);
    let mut rest = 1.0;
    if action.spread {
        for class in 0..chain.weights.classes() {
            let step = chain.weights.step(class);
            for lower in nearest.saturating_sub(step)..=nearest {
                let weight = chain.intact_weights().weight(class, lower);
                let inside = |length: f64| {
                    Span { x: chain.position(lower), length, shear_ratio: 0.0 }.inside(action.x)
                };
                if weight != 0.0 && inside(chain.bonds.bond(class, lower).length).is_some() {
                    rest -= weight;
                }
            }
        }
    }
    // Inside a cell the rest is the rounding of zero.
    let on_point = (action.x - chain.position(nearest)).abs() < 1e-6 * chain.spacing;
    if on_point || !action.spread {
        nodal.extend(action.parts().map(|(along, value)| (nearest, along.component(), rest * value)));
    }
}
