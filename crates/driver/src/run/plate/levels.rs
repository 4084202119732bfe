//! The coarser levels of a plate: the same plate and conditions at twice the spacing, again and again.

use crate::run::{Coarser, CoarserModels};
use crate::scene::PlateScene;
use peristat_assembly::condition::{Equation, Unknown};
use peristat_assembly::model::plate_bending::{PHI_X, PHI_Y, PlateBending, PlateNodes, PlateTransfer, W};
use peristat_assembly::stiffness::{Spring, Springs, Term};
use peristat_assembly::system::{System, free_motions};
use std::collections::{BTreeMap, BTreeSet};

/// Points that a direct factor takes in no time.
const COARSEST: usize = 1500;
/// Rows or columns of cells that a coarsest plate keeps.
const NARROW: usize = 4;

/// Whether a plate has no coarser one, or none that would help.
pub(super) fn is_coarsest(nodes: &PlateNodes) -> bool {
    let cells = nodes.cells();
    nodes.points() <= COARSEST || cells.columns().len().min(cells.rows().len()) < 2 * NARROW
}

/// The coarser levels of a plate; none if it is coarse itself.
pub(super) fn coarser(scene: &PlateScene) -> Option<Coarser<3>> {
    let mut levels = CoarserModels {
        systems: Vec::new(),
        transfers: Vec::new(),
        is_loose: false,
        is_unlike: true,
        beside_border: Vec::new(),
    };
    let (mut coarsest, mut held): (Option<PlateBending>, _) = (None, Conditions::of(scene));
    loop {
        let fine = coarsest.as_ref().unwrap_or(&scene.plate);
        if is_coarsest(fine.nodes()) {
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
    fn of(scene: &PlateScene) -> Self {
        Self { equations: scene.equations.clone(), springs: scene.springs.clone() }
    }

    /// The same on the coarser plate. What holds a point that both have holds it there, too; what holds another one, unless a
    /// coarse point beside it is held so, is held by a coarse point beside it: a deflection by that and its slopes.
    fn coarser(&self, fine: &PlateNodes, coarse: &PlateNodes, transfer: &PlateTransfer) -> Self {
        let mut held: BTreeSet<(usize, usize)> = BTreeSet::new();
        let mut equations = Vec::new();
        let mut apart = Vec::new();
        for equation in &self.equations {
            let Some(&(Unknown { component, point }, _)) = equation.terms.first() else { continue };
            let node = fine.node(point);
            match node.iter().all(|k| k % 2 == 0).then(|| coarse.number(node.map(|k| k / 2))).flatten() {
                Some(number) if held.insert((component, number)) => {
                    equations.push(moved(equation, number, [0.0; 2]));
                }
                Some(_) => {}
                None => apart.push((equation, component, point)),
            }
        }
        for (equation, component, point) in apart {
            let mut parents: Vec<usize> = transfer.shares(point).map(|share| share.0).collect();
            if parents.iter().any(|&parent| held.contains(&(component, parent))) {
                continue;
            }
            // A point beyond the edge of the fine plate is nearer to what holds it than one inside.
            let is_beyond = |parent: &usize| fine.number(coarse.node(*parent).map(|k| 2 * k)).is_none();
            parents.sort_by_key(|parent| !is_beyond(parent));
            if let Some(&parent) = parents.first() {
                let ([x, y], [a, b]) = (fine.place(point), coarse.place(parent));
                held.insert((component, parent));
                equations.push(moved(equation, parent, [x - a, y - b]));
            }
        }
        Self { equations, springs: self.coarser_springs(transfer) }
    }

    /// Springs shared by the coarse points around theirs.
    fn coarser_springs(&self, transfer: &PlateTransfer) -> Vec<Spring> {
        let mut sums: BTreeMap<usize, f64> = BTreeMap::new();
        for (spring, (_, stiffness)) in self.springs.iter().filter_map(|s| Some((s, s.single()?))) {
            for (point, share) in transfer.shares(spring.point) {
                *sums.entry(point).or_default() += share * stiffness;
            }
        }
        sums.into_iter().map(|(point, stiffness)| Spring::on(W, point, stiffness)).collect()
    }
}

/// An equation on another point, which is a way before the one that it held, at rest.
fn moved(equation: &Equation, point: usize, way: [f64; 2]) -> Equation {
    let mut terms: Vec<(Unknown, f64)> = equation
        .terms
        .iter()
        .map(|&(Unknown { component, .. }, share)| (Unknown { component, point }, share))
        .collect();
    if terms[0].0.component == W {
        for (component, d) in [PHI_X, PHI_Y].into_iter().zip(way).filter(|turn| turn.1 != 0.0) {
            match terms.iter_mut().find(|term| term.0.component == component) {
                Some(term) => term.1 += d,
                None => terms.push((Unknown { component, point }, d)),
            }
        }
    }
    Equation { terms, value: 0.0, origin: equation.origin.clone() }
}
