//! Parts of a body that have come off.
//!
//! Nothing holds such a part any more. Its unknowns are taken out of the system, as if they were held at zero, so that it
//! is free of strain; where it is drawn it stays where it was when it came off.

use peristat_assembly::condition::{Equation, Unknown};
use peristat_assembly::model::Model;
use peristat_assembly::system::{System, free_motions};

/// Who holds what has come off, in messages.
const ORIGIN: &str = "what has come off";

/// The points that have come off.
#[derive(Clone, Debug, Default)]
pub(super) struct Islands {
    /// Whether a point has come off, by its number; empty as long as none has.
    off: Vec<bool>,
    /// Connected parts of the body when they were last looked at.
    parts: usize,
    /// Unknowns of what has come off, and where they stay.
    frozen: Vec<(u64, f64)>,
}

impl Islands {
    /// Before anything breaks.
    pub(super) fn new<const D: usize>(model: &impl Model<D>) -> Self {
        Self { parts: model.connected().spans().len(), ..Self::default() }
    }

    /// Number of points that have come off.
    pub(super) fn points(&self) -> usize {
        self.off.iter().filter(|off| **off).count()
    }

    /// Unknowns of what has come off, and where they stay.
    pub(super) fn frozen(&self) -> &[(u64, f64)] {
        &self.frozen
    }

    /// Says where unknowns stay that another run has found.
    pub(super) fn set_frozen(&mut self, frozen: Vec<(u64, f64)>) {
        self.frozen = frozen;
    }

    /// Puts what has come off to where it stays.
    pub(super) fn place(&self, u: &mut [f64]) {
        self.frozen.iter().for_each(|&(unknown, value)| u[unknown as usize] = value);
    }

    /// Whether a bond belongs to what has come off.
    pub(super) fn holds(&self, [i, _]: [usize; 2]) -> bool {
        self.off.get(i).is_some_and(|off| *off)
    }

    /// Loads without those on what has come off.
    pub(super) fn left_of(&self, loads: &[f64]) -> Vec<f64> {
        let is_off = |k: usize| !self.off.is_empty() && self.off[k % self.off.len()];
        loads.iter().enumerate().map(|(k, f)| if is_off(k) { 0.0 } else { *f }).collect()
    }

    /// Finds what has come off of a changed model and takes it out of the system, which has the equations of the problem;
    /// `u` are the unknowns at this time. Whether there is something new.
    pub(super) fn find<const D: usize, M: Model<D>>(
        &mut self,
        model: &M,
        system: &mut System<D>,
        equations: &[Equation],
        u: &[f64],
    ) -> bool {
        let parts = model.connected();
        if parts.spans().len() == self.parts {
            return false;
        }
        self.parts = parts.spans().len();
        let free: Vec<usize> = free_motions(model, system)
            .iter()
            .flat_map(|motion| motion.parts.iter().map(|span| parts.of(span[0])))
            .collect();
        let points = system.points();
        self.off.resize(points, false);
        let new: Vec<usize> = (0..points).filter(|&p| !self.off[p] && free.contains(&parts.of(p))).collect();
        for &point in &new {
            self.off[point] = true;
            self.frozen.extend((0..D).map(|c| c * points + point).map(|k| (k as u64, u[k])));
        }
        if !new.is_empty() {
            self.take_out(model, system, equations);
        }
        !new.is_empty()
    }

    /// Holds what has come off at zero, but for what the problem holds anyway.
    fn take_out<const D: usize>(
        &self,
        model: &impl Model<D>,
        system: &mut System<D>,
        equations: &[Equation],
    ) {
        let is_off = |point: usize| self.off[point];
        // What only moves or holds a part that has come off must not strain it.
        let at_rest = |equation: &Equation| match equation.terms.iter().all(|(u, _)| is_off(u.point)) {
            true => Equation { value: 0.0, ..equation.clone() },
            false => equation.clone(),
        };
        let mut all: Vec<Equation> = equations.iter().map(at_rest).collect();
        let is_named =
            |unknown: &Unknown| equations.iter().any(|e| e.terms.iter().any(|(named, _)| named == unknown));
        let off = self.off.iter().enumerate().filter(|(_, off)| **off).map(|(point, _)| point);
        let unknowns = off.flat_map(|point| (0..D).map(move |component| Unknown { component, point }));
        all.extend(unknowns.filter(|unknown| !is_named(unknown)).map(|unknown| Equation {
            terms: vec![(unknown, 1.0)],
            value: 0.0,
            origin: ORIGIN.into(),
        }));
        // No equation names an unknown of another, so nothing can contradict.
        system.constrain(model, all).expect("what has come off is held apart from all else");
    }
}
