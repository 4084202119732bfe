//! The coarser levels of a plate: the same plate and conditions at twice the spacing, again and again.

use crate::run::{Coarser, CoarserModels};
use crate::scene::PlateScene;
use peristat_assembly::condition::{Equation, Unknown};
use peristat_assembly::model::plate_bending::{PlateBending, PlateNodes, PlateTransfer, W};
use peristat_assembly::stiffness::{Spring, Springs, Term};
use peristat_assembly::system::{System, free_motions};
use std::collections::{BTreeMap, BTreeSet};

/// Points of a plate that has no coarser one.
const COARSEST: usize = 1500;
/// Rows or columns of cells that a coarsest plate keeps.
const NARROW: usize = 4;
/// Points of a coarser plate that a direct factor takes in no time, and those where it is as large as the finest and has an odd number
/// of cells along a side: the next one would be larger by half a cell, and a quarter more cycles be needed.
const FEW: usize = 5000;
const FEW_ODD: usize = 20_000;
/// The finest plate has so many times the points of one that is factored.
const FEWER: usize = 3;

/// How large a level is: columns and rows of cells, and points.
#[derive(Clone, Copy)]
struct Size {
    sides: [usize; 2],
    points: usize,
}

impl Size {
    fn of(nodes: &PlateNodes) -> Self {
        let sides = [nodes.cells().columns().len(), nodes.cells().rows().len()];
        Self { sides, points: nodes.points() }
    }

    /// That of the level whose cells are so many times as large as those of this one.
    fn coarser(self, times: usize) -> Self {
        let sides = self.sides.map(|count| count.div_ceil(times));
        let corners = |sides: [usize; 2]| -> usize { sides.iter().map(|count| count + 1).product() };
        Self { sides, points: self.points * corners(sides) / corners(self.sides) }
    }

    /// Whether there is no coarser level, or none that would help.
    fn is_coarsest(self) -> bool {
        self.points <= COARSEST || self.sides.iter().any(|count| *count < 2 * NARROW)
    }

    /// Whether a factor of this level costs little beside the finest one, whose cells are so many times smaller, and saves cycles.
    fn is_factored(self, finest: Self, times: usize) -> bool {
        let is_as_large = self.sides.map(|count| times * count) == finest.sides;
        let is_odd = self.sides.iter().any(|count| count % 2 == 1);
        let few = if is_as_large && is_odd { FEW_ODD } else { FEW };
        self.points <= few && FEWER * self.points <= finest.points
    }
}

/// Whether a plate has no coarser one, or none that would help.
pub(super) fn is_coarsest(nodes: &PlateNodes) -> bool {
    Size::of(nodes).is_coarsest()
}

/// About the number of points of the coarsest level of a plate.
pub(super) fn coarsest_points(nodes: &PlateNodes) -> usize {
    let finest = Size::of(nodes);
    let (mut level, mut times) = (finest, 1);
    while !level.is_coarsest() && !level.is_factored(finest, times) {
        times *= 2;
        level = finest.coarser(times);
    }
    level.points
}

/// The coarser levels of a plate; none if it is coarse itself.
pub(super) fn coarser(scene: &PlateScene) -> Option<Coarser<3>> {
    let mut levels = CoarserModels {
        systems: Vec::new(),
        transfers: Vec::new(),
        is_loose: false,
        is_unlike: true,
        visits_once: true,
        is_soft: true,
        beside_border: Vec::new(),
    };
    let (mut coarsest, mut held): (Option<PlateBending>, _) = (None, Conditions::of(scene));
    let finest = Size::of(scene.plate.nodes());
    loop {
        let fine = coarsest.as_ref().unwrap_or(&scene.plate);
        let level = Size::of(fine.nodes());
        if level.is_coarsest() || level.is_factored(finest, 1 << levels.systems.len()) {
            break;
        }
        let coarse = fine.coarser().ok()?;
        let transfer = PlateTransfer::new(fine.nodes(), coarse.nodes());
        held = held.coarser(fine.nodes(), coarse.nodes(), &transfer);
        let mut springs: Vec<Box<dyn Term<3>>> = Vec::new();
        if !held.springs.is_empty() {
            springs.push(Box::new(Springs::new(coarse.nodes().points(), held.springs.clone())));
        }
        // Conditions at rest contradict each other nowhere; if they do, there are no coarser levels.
        levels.systems.push(System::new(&coarse, springs, held.equations.clone()).ok()?);
        levels.transfers.push(Box::new(transfer));
        coarsest = Some(coarse);
    }
    let last = levels.systems.last()?;
    levels.is_loose = !free_motions(&coarsest?, last).is_empty();
    Some(Coarser::Models(levels))
}

/// What holds a plate at rest.
struct Conditions {
    equations: Vec<Equation>,
    springs: Vec<Spring>,
}

impl Conditions {
    /// Points of a clamp that follow those deeper in the plate are held themselves: on coarser plates, where both are near each
    /// other, cycles do not converge otherwise.
    fn of(scene: &PlateScene) -> Self {
        let mut equations = scene.equations.clone();
        for Equation { terms, .. } in &mut equations {
            let component = terms.first().map(|(unknown, _)| unknown.component);
            if terms.iter().all(|(unknown, _)| Some(unknown.component) == component) {
                terms.truncate(1);
            }
        }
        Self { equations, springs: scene.springs.clone() }
    }

    /// The same on the coarser plate: what the interpolation makes of a held unknown is zero. Where a coarse point is held, those
    /// between it and its neighbours are held as well as they can be.
    fn coarser(&self, fine: &PlateNodes, coarse: &PlateNodes, transfer: &PlateTransfer) -> Self {
        let parents = |point: usize| {
            let mut parents: Vec<usize> = transfer.shares(point).map(|share| share.0).collect();
            parents.sort_unstable();
            parents.dedup();
            parents
        };
        let mut by_parents: [Vec<(&Equation, Unknown, Vec<usize>)>; 3] = Default::default();
        for equation in &self.equations {
            let Some(&(pivot, _)) = equation.terms.first() else { continue };
            let parents = parents(pivot.point);
            by_parents[parents.len() / 2].push((equation, pivot, parents));
        }
        let is_beyond = |point: usize| fine.number(coarse.node(point).map(|k| 2 * k)).is_none();
        let mut held: BTreeSet<(usize, usize)> = BTreeSet::new();
        let mut equations = Vec::new();
        for group in by_parents {
            let before = held.clone();
            for (equation, pivot, parents) in group {
                let of_pivot = parents.iter().map(|&parent| (pivot.component, parent));
                if of_pivot.clone().any(|unknown| before.contains(&unknown)) {
                    continue;
                }
                held.extend(of_pivot);
                let mut terms = interpolated(equation, transfer);
                // A point beyond the edge follows those inside.
                terms.sort_by_key(|(unknown, _)| {
                    (unknown.component != pivot.component, !is_beyond(unknown.point))
                });
                equations.push(Equation { terms, value: 0.0, origin: equation.origin.clone() });
            }
        }
        Self { equations, springs: self.coarser_springs(transfer) }
    }

    /// Springs shared by the coarse points around theirs; what a bed does to rotations at its edge is left to
    /// finer lattices, and one across a slanted edge resists along both axes.
    fn coarser_springs(&self, transfer: &PlateTransfer) -> Vec<Spring> {
        let mut sums: BTreeMap<(usize, usize), f64> = BTreeMap::new();
        for spring in &self.springs {
            let turns = spring.shares[0].0 != W;
            for (component, part) in spring.shares.into_iter().filter(|own| turns || own.0 == W) {
                let stiffness = part * part * spring.stiffness;
                for (point, share) in transfer.shares(spring.point).filter(|_| stiffness > 0.0) {
                    *sums.entry((component, point)).or_default() += share * stiffness;
                }
            }
        }
        let spring = |((component, point), stiffness)| Spring::on(component, point, stiffness);
        sums.into_iter().map(spring).collect()
    }
}

/// What an equation says of coarse unknowns.
fn interpolated(equation: &Equation, transfer: &PlateTransfer) -> Vec<(Unknown, f64)> {
    let mut sums: BTreeMap<Unknown, f64> = BTreeMap::new();
    for (of, share) in &equation.terms {
        for (component, point, part) in transfer.row(of.component, of.point) {
            *sums.entry(Unknown { component, point }).or_default() += share * part;
        }
    }
    sums.into_iter().collect()
}
