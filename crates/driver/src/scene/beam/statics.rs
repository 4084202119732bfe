//! Resultants of what acts on a beam or frame.

use super::scene::BeamScene;
use super::state::State;
use crate::scene::{ASKED, Counted, Resultant};
use peristat_assembly::model::timoshenko_beam::{
    Along, BeamLoads, Distributed, Intensity, Line, PHI, TimoshenkoBeam, U, W,
};
use std::f64::consts::PI;

impl BeamScene {
    /// Resultant of the loads of a state, as the case asks for them: by integrals in closed form along its lines.
    pub fn asked(&self, state: &State) -> Resultant {
        let mut sum = Resultant::default();
        for load in &state.loads.point {
            let line = self.beam.chains()[load.chain].line();
            let parts = [(W, load.force), (PHI, load.moment), (U, load.axial)];
            parts.into_iter().for_each(|(component, value)| act(&mut sum, line, load.x, (component, value)));
        }
        for load in &state.loads.distributed {
            let (value, first) = moments(load);
            let line = self.beam.chains()[load.chain].line();
            act(&mut sum, line, load.from, (load.along.component(), value));
            if load.along == Along::Transverse {
                sum.add_moment(2, first);
            }
        }
        sum
    }

    /// Difference of the loads as asked and as applied, relative to their magnitudes, that is no fault: values at points times
    /// lengths, and loads beyond the last point of a grid of cells, are forms of the literature that have none in the limit.
    pub fn slack(&self, loads: &BeamLoads) -> f64 {
        let is_lumped = loads.lumped && !loads.distributed.is_empty();
        let is_exact = !is_lumped && self.beam.parameters().end_treatment.covers();
        if is_exact { ASKED } else { f64::INFINITY }
    }

    /// Which parts of resultants mean anything: forces along x and y, that of w on a line, and the moment.
    pub fn statical(&self) -> Counted {
        Counted { force: [self.has_axial, true, false], moment: [false, false, true] }
    }
}

/// Resultant of forces on all unknowns, component by component, ghosts included.
pub(crate) fn resultant(beam: &TimoshenkoBeam, forces: &[f64]) -> Resultant {
    let (n, mut sum) = (beam.points(), Resultant::default());
    for (c, chain) in beam.chains().iter().enumerate() {
        chain.positions(0, chain.extended(), |k, x| {
            let point = beam.first(c) + k;
            for (component, plane) in forces.chunks_exact(n).enumerate().filter(|p| p.1[point] != 0.0) {
                act(&mut sum, chain.line(), x, (component, plane[point]));
            }
        });
    }
    sum
}

/// The same of forces on some unknowns, by number.
pub(crate) fn resultant_of(beam: &TimoshenkoBeam, forces: impl Iterator<Item = (usize, f64)>) -> Resultant {
    let (n, mut sum) = (beam.points(), Resultant::default());
    for (unknown, force) in forces {
        let (component, point) = (unknown / n, unknown % n);
        let c = beam.chain_of(point);
        let chain = &beam.chains()[c];
        act(&mut sum, chain.line(), chain.position(point - beam.first(c)), (component, force));
    }
    sum
}

/// Adds a force or a moment on an unknown of a line at a position along it.
fn act(sum: &mut Resultant, line: &Line, x: f64, (component, value): (usize, f64)) {
    let [c, s] = line.direction;
    let at = [line.origin[0] + x * c, line.origin[1] + x * s, 0.0];
    match component {
        _ if value == 0.0 => {}
        W => sum.add([-s * value, c * value, 0.0], at),
        U => sum.add([c * value, s * value, 0.0], at),
        _ => sum.add_moment(2, value),
    }
}

/// Integrals of a distributed load, and of the load times the distance from its start.
fn moments(load: &Distributed) -> (f64, f64) {
    let length = load.to - load.from;
    let (value, first) = match load.intensity {
        Intensity::Linear { start, end } => (0.5 * (start + end), (start + 2.0 * end) / 6.0),
        // Simpson's rule is exact for them.
        Intensity::Parabola { start, middle, end } => {
            ((start + 4.0 * middle + end) / 6.0, (2.0 * middle + end) / 6.0)
        }
        Intensity::Sine { amplitude, half_waves } => {
            let waves = f64::from(half_waves) * PI;
            // cos nπ is 1 or −1.
            let last = if half_waves.is_multiple_of(2) { 1.0 } else { -1.0 };
            (amplitude * (1.0 - last) / waves, -amplitude * last / waves)
        }
    };
    (value * length, first * length * length)
}
