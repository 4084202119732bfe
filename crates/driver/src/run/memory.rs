//! How much memory a run takes, stated before its terms and its matrix are built.

use super::Problem;
use super::method::{self, Plan};
use super::problem::Spread;
use crate::case::Solver;
use peristat_assembly::condition::{Constraints, Equation};
use peristat_assembly::model::ModelSizes;
use peristat_solve::{Method, Profile, choose};

/// Memory of the program itself, bytes, and of what its allocator leaves between pieces.
const PROGRAM: usize = 20_000_000;
/// Memory of threads and of what they keep, bytes, where points spread in a plane.
const THREADS: usize = 3_000_000;
/// Memory of the fields of a point and of what is written of them, bytes: along lines, and in a plane.
const FIELDS: [usize; 2] = [256, 400];
/// Memory of their smallest and largest values over several states, bytes per point.
const ENVELOPE: usize = 64;
/// Vectors of unknowns that conjugate gradients and the states need.
const VECTORS: usize = 8;
/// Memory of an entry of a sparse matrix of a frame, bytes: its blocks while it is put together; then compressed rows,
/// their order, and a factor with about as many entries.
const SPARSE: usize = 70;
/// Memory of a multigrid solve, bytes per point: the vectors of conjugate gradients, levels with theirs, inverse blocks.
const CYCLE: usize = 246;
/// Memory of the factor of the coarsest level of a plate in bending, bytes per point: it has 350 to 530 entries per point.
const COARSEST: usize = 6000;
/// Memory of the matrices and factors of its levels where these are assembled, bytes per point and per entry of the stiffness:
/// measured on tubes of 20 000 to 1e5 points, with bending and without, where the estimate is 1.1 to 1.5 times what a run takes.
const MATRICES: [usize; 2] = [9000, 26];
/// Memory of a solve with the blocks of the points, bytes per point: vectors and inverse blocks.
const BLOCKS: usize = 166;

/// Memory of bonds, matrix, factor and vectors, bytes; and, with `recover`, of fields and their files.
pub(super) fn estimate<const D: usize>(problem: &dyn Problem<D>, recover: bool) -> u64 {
    let (sizes, unknowns) = (problem.model().sizes(), D * problem.model().points());
    let fields = fields(problem, recover);
    let plan = method::plan(problem);
    let kept = if plan == Plan::Cycle { problem.kept_bytes() } else { 0 };
    let solving = match plan {
        Plan::Factor => {
            8 * VECTORS * unknowns + problem.solid_bytes(true).unwrap_or_else(|| matrix(problem, &sizes))
        }
        Plan::Cycle => problem.solid_bytes(false).unwrap_or_else(|| cycle(problem, &sizes)),
        Plan::Blocks => problem.solid_bytes(false).unwrap_or(BLOCKS * problem.model().points()),
    };
    // The last state is recorded without the factor, unless it may not be the last.
    let last = if problem.states() > 1 || problem.breaks() { solving + fields } else { solving.max(fields) };
    total(problem, last + kept)
}

/// Memory of a multigrid solve in the plane, bytes.
fn cycle<const D: usize>(problem: &dyn Problem<D>, sizes: &ModelSizes) -> usize {
    let points = problem.model().points();
    let [of_point, of_entry] = if problem.has_matrices() { MATRICES } else { [0; 2] };
    (CYCLE + of_point) * points + of_entry * sizes.entries + COARSEST * problem.coarsest_points()
}

/// Memory of the fields of all points and of their files, if they are recovered, bytes.
pub(super) fn fields<const D: usize>(problem: &dyn Problem<D>, recover: bool) -> usize {
    let points = problem.model().points();
    let kind = usize::from(problem.spread() != Spread::Chain);
    let per_point = FIELDS[kind] + if problem.states() > 1 { ENVELOPE } else { 0 };
    if recover { 8 * D * points + per_point * points } else { 0 }
}

/// Memory of program, bonds and `rest`, bytes.
pub(super) fn total<const D: usize>(problem: &dyn Problem<D>, rest: usize) -> u64 {
    let threads = if problem.spread() == Spread::Chain { 0 } else { THREADS };
    let needed = PROGRAM + threads + problem.model().sizes().bytes + rest;
    // Allocators take a little more than they are asked for.
    (needed + needed / 10) as u64
}

/// The stiffness of points in a plane and its dissected factor, bytes.
///
/// Measured on squares of 2500 to 1e5 points with 2 unknowns: with b bonds per point and u unknowns the factor has
/// 2.1 to 2.7 b u log₂ u entries, and everything else takes 130 to 220 bytes per bond.
fn dissected(unknowns: usize, bonds: usize) -> usize {
    const ENTRIES: f64 = 2.8;
    const REST: usize = 160;
    let per_point = 2.0 * bonds as f64 / unknowns as f64;
    let entries = ENTRIES * per_point * unknowns as f64 * (unknowns as f64).log2().max(1.0);
    8 * entries as usize + REST * bonds
}

/// The stiffness and its factor, bytes.
fn matrix<const D: usize>(problem: &dyn Problem<D>, sizes: &ModelSizes) -> usize {
    let points = problem.model().points();
    if problem.spread() != Spread::Chain && problem.solver() != Solver::Band {
        let dissected = dissected(D * points, sizes.elements);
        // The factor of a solid fills up sooner: measured 1.4 times as much.
        return if problem.spread() == Spread::Solid { dissected + dissected / 2 } else { dissected };
    }
    let relations = problem.model().relations();
    let equations = || problem.equations().iter().chain(&relations);
    // Equations that contradict each other are refused before there is a matrix.
    let all: Vec<Equation> = equations().cloned().collect();
    let slaves = Constraints::new(points, &all).is_ok_and(|constraints| constraints.has_slaves());
    // Points that an equation joins come as close as neighbours do.
    let span = |e: &Equation| {
        let points = || e.terms.iter().map(|(u, _)| u.point);
        points().max().unwrap_or(0) - points().min().unwrap_or(0)
    };
    let far = equations().map(span).max().unwrap_or(0);
    let band = |reach: usize| 8 * D * points * D * (reach + 1);
    let profile = Profile {
        unknowns: D * points,
        half_bandwidth: D * (sizes.reach + 1) - 1,
        entries: points * D * (D + 1) / 2 + sizes.elements * D * D,
    };
    let sparse = SPARSE * sizes.entries;
    match (slaves, problem.solver()) {
        (true, Solver::Band) => band(sizes.reach + far) + sparse,
        (true, _) | (false, Solver::Sparse) => sparse,
        (false, Solver::Auto | Solver::Strain) if choose(&profile).0 == Method::Sparse => sparse,
        (false, _) => band(sizes.reach),
    }
}
