//! How much memory a run takes, told before its terms and its matrix are built.

use super::Problem;
use crate::case::Solver;
use peristat_assembly::condition::{Constraints, Equation};
use peristat_assembly::model::{Model, ModelSizes};
use peristat_solve::{Method, Profile, choose};

/// Memory of the program itself, bytes.
const PROGRAM: usize = 8_000_000;
/// Memory of the fields of a point and of what is written of them, bytes.
const FIELDS: usize = 256;
/// Memory of their smallest and largest values over several states, bytes per point.
const ENVELOPE: usize = 64;
/// Vectors of unknowns that conjugate gradients and the states need.
const VECTORS: usize = 7;
/// Memory of an entry of a sparse matrix, bytes: triplets while it is put together; then compressed rows, their order,
/// and a factor with about as many entries.
const SPARSE: usize = 64;

/// Memory of bonds, matrix, factor and vectors, bytes; and, with `recover`, of fields and their files.
pub(super) fn estimate<const D: usize, P: Problem<D>>(problem: &P, recover: bool) -> u64 {
    let (sizes, unknowns) = (problem.model().sizes(), D * problem.model().points());
    let fields = fields(problem, recover);
    let solving = 8 * VECTORS * unknowns + matrix(problem, &sizes);
    // The last state is recorded without the factor.
    total(problem, if problem.states() > 1 { solving + fields } else { solving.max(fields) })
}

/// Memory of the fields of all points and of their files, if they are recovered, bytes.
pub(super) fn fields<const D: usize, P: Problem<D>>(problem: &P, recover: bool) -> usize {
    let points = problem.model().points();
    let per_point = FIELDS + if problem.states() > 1 { ENVELOPE } else { 0 };
    if recover { 8 * D * points + per_point * points } else { 0 }
}

/// Memory of program, bonds and `rest`, bytes.
pub(super) fn total<const D: usize, P: Problem<D>>(problem: &P, rest: usize) -> u64 {
    let needed = PROGRAM + problem.model().sizes().bytes + rest;
    // Allocators take a little more than they are asked for.
    (needed + needed / 10) as u64
}

/// The stiffness and its factor, bytes.
fn matrix<const D: usize, P: Problem<D>>(problem: &P, sizes: &ModelSizes) -> usize {
    let points = problem.model().points();
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
