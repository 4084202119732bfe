//! Parts of a body that have come off.
//!
//! Nothing holds such a part any more. Its unknowns are taken out of the system, as if they were held at zero, so that it
//! is free of strain, and what held or moved parts of it does so no more; where it is drawn it stays where it was when it
//! came off.

use peristat_assembly::condition::{Equation, Unknown};
use peristat_assembly::model::Model;
use peristat_assembly::stiffness::NumberedParts;
use peristat_assembly::system::{FreeMotion, System, free_motions};

/// Work of loads on a motion over the sum of its parts, below which it is rounding.
const NO_WORK: f64 = 1e-9;
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
    /// Unknowns that stop motions on which nothing works.
    stops: Vec<Unknown>,
}

impl Islands {
    /// Before anything breaks.
    pub(super) fn new<const D: usize>(model: &dyn Model<D>) -> Self {
        Self { parts: model.connected().spans().len(), ..Self::default() }
    }

    /// Whether a point has come off, by its number; empty as long as none has.
    pub(super) fn off(&self) -> &[bool] {
        &self.off
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
    /// `u` are the unknowns at this time, `loads` those at the unit load. Whether there is something new.
    pub(super) fn find<const D: usize>(
        &mut self,
        model: &dyn Model<D>,
        system: &mut System<D>,
        equations: &[Equation],
        [u, loads]: [&[f64]; 2],
    ) -> bool {
        let parts = model.connected();
        if parts.spans().len() == self.parts {
            return false;
        }
        self.parts = parts.spans().len();
        let points = system.points();
        self.off.resize(points, false);
        let before = self.points();
        loop {
            let motions = free_motions(model, system);
            if motions.is_empty() {
                break;
            }
            let held = held_parts(system, equations, |point| parts.of(point));
            let mut free = vec![false; self.parts];
            let mut still = Vec::new();
            for motion in &motions {
                let moving: Vec<usize> = motion.parts.iter().map(|span| parts.of(span[0])).collect();
                if moving.iter().any(|part| held[*part]) && !is_driven(motion, model, &parts, loads) {
                    still.push(stop(motion, model, system, &parts));
                } else {
                    moving.iter().for_each(|&part| free[part] = true);
                }
            }
            keep_tied(&mut free, equations, |point| parts.of(point));
            let new: Vec<usize> = (0..points).filter(|&p| !self.off[p] && free[parts.of(p)]).collect();
            if new.is_empty() && still.iter().all(Option::is_none) {
                break;
            }
            for point in new {
                self.off[point] = true;
                self.frozen.extend((0..D).map(|c| c * points + point).map(|k| (k as u64, u[k])));
            }
            // One at a time: a motion that is stopped may have been part of another.
            self.stops.extend(still.into_iter().flatten().take(1));
            self.take_out(model, system, equations);
        }
        self.points() > before
    }

    /// Holds what has come off at zero, and stops what can move without strain.
    fn take_out<const D: usize>(&self, model: &dyn Model<D>, system: &mut System<D>, equations: &[Equation]) {
        // In their places, for the sake of the forces that hold them.
        let mut all = equations.to_vec();
        let is_off = |equation: &&mut Equation| equation.terms.iter().any(|(named, _)| self.off[named.point]);
        all.iter_mut().filter(is_off).for_each(|equation| equation.value = 0.0);
        let off = self.off.iter().enumerate().filter(|(_, off)| **off).map(|(point, _)| point);
        let unknowns = off.flat_map(|point| (0..D).map(move |component| Unknown { component, point }));
        all.extend(unknowns.chain(self.stops.iter().copied()).map(|unknown| Equation {
            terms: vec![(unknown, 1.0)],
            value: 0.0,
            origin: ORIGIN.into(),
        }));
        // All of an equation is off or nothing, and zero fulfils what has no value: nothing can contradict.
        system.constrain(model, all).expect("what has come off is held apart from all else");
    }
}

/// Whether loads work on a motion.
fn is_driven<const D: usize>(
    motion: &FreeMotion,
    model: &dyn Model<D>,
    parts: &NumberedParts,
    loads: &[f64],
) -> bool {
    let points = model.points();
    let (mut work, mut size) = (0.0, 0.0);
    for point in 0..points {
        for (c, moved) in motion.at(model, parts, point).into_iter().enumerate() {
            let part = moved * loads[c * points + point];
            work += part;
            size += part.abs();
        }
    }
    work.abs() > NO_WORK * size
}

/// The free unknown that a motion moves most, to be held: nothing works on it.
fn stop<const D: usize>(
    motion: &FreeMotion,
    model: &dyn Model<D>,
    system: &System<D>,
    parts: &NumberedParts,
) -> Option<Unknown> {
    let points = model.points();
    let mut is_held = vec![false; D * points];
    system.constraints().rows().iter().for_each(|row| is_held[row.unknown] = true);
    let all = (0..points).flat_map(|point| {
        let moved = motion.at(model, parts, point);
        (0..D).map(move |component| (moved[component].abs(), Unknown { component, point }))
    });
    let free = all.filter(|(moved, u)| *moved > 0.0 && !is_held[u.component * points + u.point]);
    // The first of those that move alike.
    free.fold(None, |best: Option<(f64, Unknown)>, next| match best {
        Some(best) if best.0 >= next.0 => Some(best),
        _ => Some(next),
    })
    .map(|(_, unknown)| unknown)
}

/// Which parts an equation names, or a spring holds.
fn held_parts<const D: usize>(
    system: &System<D>,
    equations: &[Equation],
    part: impl Fn(usize) -> usize,
) -> Vec<bool> {
    let mut held = vec![false; (0..system.points()).map(&part).max().map_or(0, |last| last + 1)];
    equations.iter().flat_map(|e| &e.terms).for_each(|(unknown, _)| held[part(unknown.point)] = true);
    for term in system.terms() {
        term.ground_motions(&mut |motion| motion.iter().for_each(|share| held[part(share.1)] = true));
    }
    held
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
