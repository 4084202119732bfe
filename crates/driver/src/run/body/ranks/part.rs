//! The part of a process in the finest level.

use super::boxes::Boxes;
use super::order::Order;
use super::refuse::refused;
use crate::run::RunError;
use crate::scene::body::BodyScene;
use peristat_assembly::body::SquareLattice;
use peristat_assembly::model::plane::Solvable;
use peristat_assembly::stiffness::{Spring, Springs, Term};
use peristat_assembly::system::System;
use peristat_solve::{Halo, LinearOperator, Ranks};
use std::ops::Range;
use std::sync::Mutex;

/// Points of a box and of the halo around it, with their system. Vectors of the part have planes of all of its points; those of the
/// process have planes of its own ones.
pub(super) struct Part<'r, const D: usize> {
    pub(super) system: System<D>,
    own: Vec<u32>,
    /// Points of the halo that other processes own.
    others: Vec<u32>,
    halo: Box<dyn Halo + 'r>,
    room: Mutex<Room>,
}

/// Own unknowns, those of others, and two vectors of the part.
struct Room {
    own: Vec<f64>,
    others: Vec<f64>,
    part: [Vec<f64>; 2],
}

impl<'r, const D: usize> Part<'r, D> {
    /// The part of this process, and its model.
    ///
    /// # Errors
    /// [`RunError::NotShared`] where the part has no model, or one with other points.
    pub(super) fn new(
        scene: &BodyScene,
        (model, whole): (&dyn Solvable<D>, &System<D>),
        (boxes, order, width): (&Boxes, &Order, i32),
        ranks: &'r dyn Ranks,
    ) -> Result<(Self, Box<dyn Solvable<D>>), RunError> {
        let Some(part) = model_of(scene, model, |deeper| boxes.widened(ranks.number(), width + deeper))
        else {
            return refused("bodies whose parts have no model of their own");
        };
        let (Some((lattice, _)), Some((there, _))) = (part.lattice(), model.lattice()) else {
            return refused("bodies of listed points");
        };
        let numbers: Vec<Option<usize>> = (0..part.points()).map(|p| there.number(lattice.cell(p))).collect();
        let is_own = |point: &Option<usize>| point.is_some_and(|p| order.owner(p) == ranks.number());
        let numbered = |keep: &dyn Fn(&Option<usize>) -> bool| -> Vec<u32> {
            (0..numbers.len()).filter(|&p| keep(&numbers[p])).map(|p| p as u32).collect()
        };
        let (own, others) = (numbered(&is_own), numbered(&|point| point.is_some() && !is_own(point)));
        if own.len() != order.count(ranks.number()) {
            return refused("bodies whose parts have other points than the whole");
        }
        let system = system(scene, (&*part, lattice, &numbers), (whole, there));
        let places: Vec<(usize, usize)> =
            others.iter().filter_map(|&p| Some(order.place(numbers[p as usize]?, D))).collect();
        let wanted: Vec<usize> =
            (0..D).flat_map(|c| places.iter().map(move |(first, step)| first + c * step)).collect();
        let room = Room {
            own: vec![0.0; D * own.len()],
            others: vec![0.0; wanted.len()],
            part: [0; 2].map(|_| vec![0.0; system.size()]),
        };
        let halo = ranks.halo(D * own.len(), &wanted);
        Ok((Self { system, own, others, halo, room: Mutex::new(room) }, part))
    }

    /// Numbers of the points that the process owns, in the part.
    pub(super) fn own(&self) -> &[u32] {
        &self.own
    }

    /// Writes own unknowns into a vector of the part that is zero elsewhere.
    pub(super) fn put(&self, own: &[f64], part: &mut [f64]) {
        part.fill(0.0);
        self.each_own(|own_unknown, unknown| part[unknown] = own[own_unknown]);
    }

    /// Takes own unknowns out of a vector of the part.
    pub(super) fn take(&self, part: &[f64], own: &mut [f64]) {
        self.each_own(|own_unknown, unknown| own[own_unknown] = part[unknown]);
    }

    /// Fetches the unknowns of others, and writes over dependent ones what they are.
    pub(super) fn refresh(&self, part: &mut [f64]) {
        let Room { own, others, .. } = &mut *self.room.lock().expect("no holder of the lock panics");
        self.take(part, own);
        self.halo.fetch(own, others);
        let points = self.system.points();
        for (plane, values) in others.chunks_exact(self.others.len().max(1)).enumerate() {
            values
                .iter()
                .zip(&self.others)
                .for_each(|(value, &p)| part[plane * points + p as usize] = *value);
        }
        self.system.constraints().expand(0.0, part);
    }

    /// Leaves zeros in a vector of the part but at own unknowns.
    pub(super) fn mute(&self, part: &mut [f64]) {
        let Room { own, .. } = &mut *self.room.lock().expect("no holder of the lock panics");
        self.take(part, own);
        self.put(own, part);
    }

    /// Calls `visit` with the numbers of all own unknowns, among own ones and in the part.
    fn each_own(&self, mut visit: impl FnMut(usize, usize)) {
        let (count, points) = (self.own.len(), self.system.points());
        for c in 0..D {
            self.own.iter().enumerate().for_each(|(k, &p)| visit(c * count + k, c * points + p as usize));
        }
    }
}

/// The product of the whole body, of own unknowns.
impl<const D: usize> LinearOperator for Part<'_, D> {
    fn size(&self) -> usize {
        D * self.own.len()
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        let room = || self.room.lock().expect("no holder of the lock panics");
        let [mut from, mut to] = std::mem::take(&mut room().part);
        self.put(x, &mut from);
        self.refresh(&mut from);
        self.system.product(&from, &mut to);
        self.take(&to, y);
        room().part = [from, to];
    }
}

/// The model of a part, which is as deep as needed around its box and at most some cells deeper: where the cut leaves a sliver of the
/// body, the part would have other edges than the whole.
fn model_of<const D: usize>(
    scene: &BodyScene,
    whole: &dyn Solvable<D>,
    box_with: impl Fn(i32) -> [Range<i32>; 3],
) -> Option<Box<dyn Solvable<D>>> {
    /// Cells by which it may be deeper.
    const DEEPER: i32 = 4;
    let edges =
        |model: &dyn Solvable<D>| (model.follows_border(), model.as_solid().map(|solid| solid.faces()));
    let mut last = None;
    for deeper in 0..=DEEPER {
        let part = scene.part(&box_with(deeper)).ok().and_then(|body| body.of::<D>());
        let is_alike = part.as_deref().is_some_and(|part| edges(part) == edges(whole));
        last = part.or(last);
        if is_alike {
            break;
        }
    }
    last
}

/// Cells around a box within which the cut there changes bonds, or own points have neighbours: those of a point have neighbours
/// themselves that border treatments move, and a row beyond that dependent points reach. Points that feel the families of their
/// neighbours reach twice as far.
pub(super) fn width(scene: &BodyScene) -> i32 {
    let steps = scene.material().offsets().unwrap_or_default();
    let reach = steps.iter().flatten().map(|k| k.abs()).max().unwrap_or(0);
    let sweeps = if scene.material().about().has_families { 2 } else { 1 };
    2 * sweeps * reach + 2
}

/// The system of a part, with the constraints of the whole.
fn system<const D: usize>(
    scene: &BodyScene,
    (part, lattice, numbers): (&dyn Solvable<D>, &SquareLattice, &[Option<usize>]),
    (whole, there): (&System<D>, &SquareLattice),
) -> System<D> {
    let points = part.points();
    let number = |point: usize| lattice.number(there.cell(point));
    let unknown = |of: usize| Some(of / whole.points() * points + number(of % whole.points())?);
    let strays = (0..points).filter(|&p| numbers[p].is_none());
    let still = strays.flat_map(|p| (0..D).map(move |c| c * points + p));
    let constraints = whole.constraints().renumbered(&unknown, still);
    let springs = scene.conditions.springs.iter();
    let springs: Vec<Spring> =
        springs.filter_map(|spring| Some(Spring { point: number(spring.point)?, ..*spring })).collect();
    let mut terms: Vec<Box<dyn Term<D>>> = Vec::new();
    if !springs.is_empty() {
        terms.push(Box::new(Springs::new(points, springs)));
    }
    System::with_constraints(part, terms, constraints)
}
