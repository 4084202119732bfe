//! Parts of a body that have come off.
//!
//! Nothing holds such a part any more. Its unknowns are taken out of the system, as if they were held at zero, so that it
//! is free of strain, and what held or moved parts of it does so no more; where it is drawn it stays where it was when it
//! came off.

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
        let mut free = vec![false; self.parts];
        let motions = free_motions(model, system);
        let moving = motions.iter().flat_map(|motion| motion.parts.iter().map(|span| parts.of(span[0])));
        moving.for_each(|part| free[part] = true);
        keep_tied(&mut free, equations, |point| parts.of(point));
        let points = system.points();
        self.off.resize(points, false);
        let new: Vec<usize> = (0..points).filter(|&p| !self.off[p] && free[parts.of(p)]).collect();
        for &point in &new {
            self.off[point] = true;
            self.frozen.extend((0..D).map(|c| c * points + point).map(|k| (k as u64, u[k])));
        }
        if !new.is_empty() {
            self.take_out(model, system, equations);
        }
        !new.is_empty()
    }

    /// Holds what has come off at zero.
    fn take_out<const D: usize>(
        &self,
        model: &impl Model<D>,
        system: &mut System<D>,
        equations: &[Equation],
    ) {
        // In their places, for the sake of the forces that hold them.
        let mut all = equations.to_vec();
        let is_off = |equation: &&mut Equation| equation.terms.iter().any(|(named, _)| self.off[named.point]);
        all.iter_mut().filter(is_off).for_each(|equation| equation.value = 0.0);
        let off = self.off.iter().enumerate().filter(|(_, off)| **off).map(|(point, _)| point);
        let unknowns = off.flat_map(|point| (0..D).map(move |component| Unknown { component, point }));
        all.extend(unknowns.map(|unknown| Equation {
            terms: vec![(unknown, 1.0)],
            value: 0.0,
            origin: ORIGIN.into(),
        }));
        // All of an equation is off or nothing, and zero fulfils what has no value: nothing can contradict.
        system.constrain(model, all).expect("what has come off is held apart from all else");
    }
}

/// Takes parts that an equation ties to others that are not free from those that are: they can only turn about the tie.
fn keep_tied(free: &mut [bool], equations: &[Equation], part: impl Fn(usize) -> usize) {
    let is_free = |free: &[bool], (unknown, _): &(Unknown, f64)| free[part(unknown.point)];
    // What was tied to such a part is tied with it.
    while let Some(equation) = equations.iter().find(|equation| {
        let count = equation.terms.iter().filter(|term| is_free(free, term)).count();
        0 < count && count < equation.terms.len()
    }) {
        equation.terms.iter().for_each(|(unknown, _)| free[part(unknown.point)] = false);
    }
}
