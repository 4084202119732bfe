//! The coarser levels of a body on a lattice: the same body, cracks and conditions at twice the spacing, again and again.

use super::{cubes, lines};
use crate::run::single_cycle::is_slender;
use crate::run::{Coarser, CoarserModels, Spread};
use crate::scene::body::Conditions;
use peristat_assembly::body::{CRACK_SLACK, Cell, Crack, SquareLattice, Transfer, cut_bonds};
use peristat_assembly::model::BodyModel;
use peristat_assembly::model::plane::{Mirrors, Solvable};
use peristat_assembly::stiffness::{Springs, Term};
use peristat_assembly::system::{System, free_motions};

/// Points that a direct factor takes in no time.
pub(super) const COARSEST: usize = 1500;
/// The same of a solid, whose factor fills up sooner.
pub(super) const COARSEST_SOLID: usize = 500;
/// Rows or columns that a coarsest lattice keeps: with fewer, all of its points are at an edge.
const NARROW: usize = 12;
/// The same of a solid: a cantilever of 96 x 16 x 8 points takes 33 cycles, and with the blocks of its points 1591 iterations.
const NARROW_SOLID: usize = 3;
/// The same of a solid that is thin in one direction alone, and long in both others beside it: a plate of 100 x 100 x 8 points takes
/// 50 iterations, where without coarser lattices it takes 6451.
const NARROW_PLATE: usize = 2;
/// How long these are beside its thickness.
const THIN: usize = 4;

/// Rows and columns around a block that a border cuts whose points are smoothed together: with none cycles are up to two fifths
/// more, and with two the factor has half as many entries again for a cycle less.
const STRIP: i32 = 1;
/// Points that are smoothed together in any body; in a larger one a tenth of all.
const MOST_BESIDE: usize = 20_000;

/// How the points of a body lie.
pub(super) fn spread(model: &dyn BodyModel) -> Spread {
    match model.lattice() {
        Some((lattice, _)) if model.needs_all_rows() => {
            if lines::suits(lattice) {
                Spread::Lattice
            } else {
                Spread::Plane
            }
        }
        Some((lattice, mirrors)) if !is_coarsest(lattice, mirrors) && !model.hardly_compresses() => {
            Spread::Lattice
        }
        Some((lattice, _)) if !lattice.is_plane() => Spread::Solid,
        _ => Spread::Plane,
    }
}

/// Whether a lattice has no coarser one, or none that would help.
fn is_coarsest(lattice: &SquareLattice, mirrors: &Mirrors) -> bool {
    let sides = [lattice.layers().len(), lattice.columns().len(), lattice.rows().len()];
    let (narrow, few) = match lattice.is_plane() {
        true => (sides[1].min(sides[2]) < 2 * NARROW, COARSEST),
        false => (is_narrow(sides), COARSEST_SOLID),
    };
    lattice.points() <= few || narrow || mirrors.coarser().is_none()
}

/// Whether a solid with these numbers of points along its sides is too thin to be coarser.
pub(super) fn is_narrow(mut sides: [usize; 3]) -> bool {
    sides.sort_unstable();
    let least = if sides[1] >= THIN * sides[0] { NARROW_PLATE } else { NARROW_SOLID };
    sides[0] < 2 * least
}

/// The coarser levels of a model with its system; none of a cloud, or of a lattice that is coarse itself.
pub(super) fn coarser<const D: usize>(
    model: &dyn Solvable<D>,
    cracks: &[Crack],
    conditions: &Conditions,
    system: &System<D>,
) -> Option<Coarser<D>> {
    let lines = || lines::places(model, system).map(Coarser::Lines);
    let cubes = || cubes::levels(model, conditions, system).map(Coarser::Cubes);
    let models = || models(model, model, cracks, conditions).map(Coarser::Models);
    lines().or_else(cubes).or_else(models)
}

/// Coarser models of the body. What the finest of them gives goes to the points of `part`, the model itself or one of a part of the
/// body.
pub(super) fn models<const D: usize>(
    model: &dyn Solvable<D>,
    part: &dyn Solvable<D>,
    cracks: &[Crack],
    conditions: &Conditions,
) -> Option<CoarserModels<D>> {
    let cracks: Vec<Crack> = model.lattice().map_or(Vec::new(), |(lattice, _)| beside(cracks, lattice));
    let find = |lattice: &SquareLattice, steps: &[Cell]| cut_bonds(lattice, steps, &cracks);
    // Coarser lattices do not know how a border cuts their blocks.
    let is_unlike = model.follows_border();
    let beside_border = if is_unlike { beside_border(part) } else { Vec::new() };
    let mut levels = CoarserModels {
        systems: Vec::new(),
        transfers: Vec::new(),
        is_loose: false,
        is_unlike,
        visits_once: false,
        is_soft: model.lattice().is_some_and(|(lattice, _)| {
            is_slender([lattice.columns().len(), lattice.rows().len()], lattice.points())
        }),
        beside_border,
    };
    let (mut coarsest, mut conditions): (Option<Box<dyn Solvable<D>>>, _) = (None, conditions.clone());
    loop {
        let fine = coarsest.as_deref().unwrap_or(model);
        let (lattice, mirrors) = fine.lattice()?;
        if is_coarsest(lattice, mirrors) {
            break;
        }
        let coarse = fine.coarser(&find)?;
        let (coarse_lattice, _) = coarse.lattice()?;
        let receiver = if coarsest.is_some() { fine } else { part };
        let (receiving, _) = receiver.lattice()?;
        let damage = if cracks.is_empty() { Vec::new() } else { receiver.damage() };
        let slack = CRACK_SLACK * lattice.spacing();
        levels.transfers.push(Box::new(Transfer::new(
            receiving,
            coarse_lattice,
            &|point| damage.get(point).is_some_and(|damage| *damage > 0.0),
            &|a, b| !cracks.iter().any(|crack| crack.cuts(a, b, slack)),
        )));
        conditions = conditions.coarser(lattice, coarse_lattice);
        let mut springs: Vec<Box<dyn Term<D>>> = Vec::new();
        if !conditions.springs.is_empty() {
            springs.push(Box::new(Springs::new(coarse.points(), conditions.springs.clone())));
        }
        let equations = conditions.equations(&|point| coarse.position(point));
        // Conditions at rest contradict each other nowhere; if they do, there are no coarser levels.
        levels.systems.push(System::new(&*coarse, springs, equations).ok()?);
        coarsest = Some(coarse);
    }
    let last = levels.systems.last()?;
    levels.is_loose = !free_motions(&*coarsest?, last).is_empty();
    Some(levels)
}

/// Points of the blocks that a border cuts and around them, in order; none where they are so many that their factor would be
/// large.
fn beside_border(model: &dyn BodyModel) -> Vec<usize> {
    let Some((lattice, _)) = model.lattice() else { return Vec::new() };
    let around = |&(block, ..): &(Cell, _)| {
        let along = |k: usize| block[k] - STRIP..=block[k] + 1 + STRIP;
        let cells: Vec<Cell> = along(1).flat_map(|j| along(0).map(move |i| [i, j, 0])).collect();
        cells.into_iter().filter_map(|cell| lattice.number(cell))
    };
    let mut points: Vec<usize> = lattice.blocks().iter().flat_map(around).collect();
    points.sort_unstable();
    points.dedup();
    if points.len() > MOST_BESIDE.max(lattice.points() / 10) {
        points.clear();
    }
    points
}

/// Cracks moved by a small part of the spacing. A crack between the points of a lattice may run right through those of
/// a coarser one and cut all of their bonds; moved, it leaves them on one of its sides.
fn beside(cracks: &[Crack], lattice: &SquareLattice) -> Vec<Crack> {
    /// In spacings, in no direction that cracks are likely to have.
    const SHIFT: [f64; 3] = [0.047, 0.029, 0.037];
    cracks.iter().map(|crack| crack.shifted(SHIFT.map(|part| part * lattice.spacing()))).collect()
}
