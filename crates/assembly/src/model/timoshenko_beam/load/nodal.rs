//! Loads as forces on points.

use super::{BeamLoads, Distributed, Intensity, PointAction};
use super::{EndForces, Span};
use crate::model::Model;
use crate::model::timoshenko_beam::{Chain, Grid, TimoshenkoBeam};
use std::array::from_fn;

impl BeamLoads {
    /// Adds the nodal forces to `force`, two planes of `beam.points()` entries.
    pub fn add_to(&self, beam: &TimoshenkoBeam, force: &mut [f64]) {
        for load in &self.distributed {
            if self.lumped {
                add_lumped(load, beam, force);
            } else {
                add_consistent(load, beam, force);
            }
        }
        for action in &self.point {
            add_point(action, beam, force);
        }
    }
}

fn scatter(force: &mut [f64], n: usize, i: usize, j: usize, weight: f64, ends: &EndForces) {
    force[i] += weight * ends[0];
    force[n + i] += weight * ends[1];
    force[j] += weight * ends[2];
    force[n + j] += weight * ends[3];
}

fn add_consistent(load: &Distributed, beam: &TimoshenkoBeam, force: &mut [f64]) {
    let (n, bonds) = (beam.points(), &beam.bonds()[load.chain]);
    let (chain, lattice) = (&beam.chains()[load.chain], bonds.lattice());
    for (class, c) in bonds.classes().iter().enumerate() {
        // A load that is straight over a bond is the sum of two unit loads, integrated once per class.
        let unit = |start: f64, end: f64| {
            let length = c.geometry.length();
            let intensity = Intensity::Linear { start, end };
            let load = Distributed { from: 0.0, to: length, intensity, ..*load };
            load.on(&Span { x: 0.0, ..beam.span(load.chain, class, 0) })
        };
        let (at_start, at_end) = (unit(1.0, 0.0), unit(0.0, 1.0));
        let constant = load.constant().map(|q| -> EndForces { from_fn(|k| q * (at_start[k] + at_end[k])) });
        bonds.for_each_run(class, |run, weight| {
            let (i, from, to) =
                (lattice.first + run.start, chain.position(run.start), chain.position(run.end - 1 + c.step));
            if let Some(ends) = constant.filter(|_| from >= load.from && to <= load.to) {
                let [wi, pi, wj, pj] = ends.map(|e| weight * e);
                for (plane, shift, end) in [(0, 0, wi), (n, 0, pi), (0, c.step, wj), (n, c.step, pj)] {
                    force[plane + i + shift..][..run.len()].iter_mut().for_each(|f| *f += end);
                }
                return;
            }
            for lower in run {
                let (a, b) = (chain.position(lower), chain.position(lower + c.step));
                if b <= load.from || a >= load.to {
                    continue;
                }
                let ends = match load.is_linear_over(a, b) {
                    Some([qa, qb]) => from_fn(|k| qa * at_start[k] + qb * at_end[k]),
                    None => load.on(&beam.span(load.chain, class, lower)),
                };
                let i = lattice.first + lower;
                scatter(force, n, i, i + c.step, weight, &ends);
            }
        });
    }
}

fn add_lumped(load: &Distributed, beam: &TimoshenkoBeam, force: &mut [f64]) {
    let chain = &beam.chains()[load.chain];
    let first = beam.first_real(load.chain);
    let plane = if load.is_moment { beam.points() } else { 0 };
    for k in 0..chain.points {
        let (a, b) = tributary(chain, k);
        let (a, b) = (a.max(load.from), b.min(load.to));
        if b > a {
            // The value at the point, as the literature does, where the load covers its whole share.
            let x = chain.position(chain.ghosts[0] + k);
            let at = if x >= a && x <= b { x } else { 0.5 * (a + b) };
            force[plane + first + k] += load.value(at) * (b - a);
        }
    }
}

/// The part of the line that belongs to a real point.
fn tributary(chain: &Chain, k: usize) -> (f64, f64) {
    let (x, half) = (chain.position(chain.ghosts[0] + k), 0.5 * chain.spacing);
    match chain.line().grid {
        Grid::Cells => (x - half, x + half),
        Grid::Nodes => {
            let a = if k == 0 { x } else { x - half };
            (a, if k + 1 == chain.points { x } else { x + half })
        }
    }
}

fn add_point(action: &PointAction, beam: &TimoshenkoBeam, force: &mut [f64]) {
    let n = beam.points();
    let (chain, bonds) = (&beam.chains()[action.chain], &beam.bonds()[action.chain]);
    let nearest = ((action.x - chain.origin) / chain.spacing).round().max(0.0) as usize;
    let nearest = nearest.min(chain.points - 1);
    let mut rest = 1.0;
    if action.spread {
        let middle = chain.ghosts[0] + nearest;
        for (class, c) in bonds.classes().iter().enumerate() {
            for lower in middle.saturating_sub(c.step)..=middle {
                let weight = bonds.weight(class, lower);
                let span = beam.span(action.chain, class, lower);
                let Some(z) = span.inside(action.x).filter(|_| weight != 0.0) else {
                    continue;
                };
                let (f, m) = (span.of_force(z), span.of_moment(z));
                let ends = from_fn(|k| action.force * f[k] + action.moment * m[k]);
                let i = bonds.lattice().first + lower;
                scatter(force, n, i, i + c.step, weight, &ends);
                rest -= weight;
            }
        }
    }
    // What no bond spans belongs to the point; inside a cell that is the rounding of zero.
    let on_point = (action.x - chain.position(chain.ghosts[0] + nearest)).abs() < 1e-6 * chain.spacing;
    if on_point || !action.spread {
        let point = beam.first_real(action.chain) + nearest;
        force[point] += rest * action.force;
        force[n + point] += rest * action.moment;
    }
}
