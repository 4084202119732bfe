//! How much memory a run takes, told before any of it is allocated.

use super::{Problem, strain};
use crate::case::Solver;
use peristat_assembly::condition::Equation;
use peristat_assembly::model::Model;
use peristat_solve::{Method, Profile, choose};

/// Memory of matrix, factor and vectors, bytes; and, with `recover`, of fields and their files.
pub(super) fn estimate<const D: usize, P: Problem<D>>(problem: &P, recover: bool) -> u64 {
    let model = problem.model();
    let unknowns = (D * model.points()) as u64;
    let terms = model.terms();
    let reach = terms.iter().map(|t| t.reach()).max().unwrap_or(0);
    let relations = model.relations();
    let equations = || problem.equations().iter().chain(&relations);
    let slaves = equations().any(|e| e.terms.len() > 1);
    // Points that an equation joins come as close as neighbours do.
    let span = |e: &Equation| {
        let points = || e.terms.iter().map(|(u, _)| u.point);
        points().max().unwrap_or(0) - points().min().unwrap_or(0)
    };
    let far = equations().map(span).max().unwrap_or(0);
    let band = |reach: usize| 8 * unknowns * (D * (reach + 1)) as u64;
    let elements: usize = terms.iter().map(|t| t.elements()).sum();
    let profile = Profile {
        unknowns: D * model.points(),
        half_bandwidth: D * (reach + 1) - 1,
        entries: model.points() * D * (D + 1) / 2 + elements * D * D,
    };
    // Blocks, triplets, compressed rows, and a factor about as large as all of them.
    let sparse = 80 * profile.entries as u64;
    let in_strains =
        matches!(problem.solver(), Solver::Auto | Solver::Strain) && strain::applies(problem).is_ok();
    let matrix = match (slaves, problem.solver()) {
        _ if in_strains => 0,
        (true, Solver::Band) => band(reach + far) + sparse,
        (true, _) | (false, Solver::Sparse) => sparse,
        (false, Solver::Auto | Solver::Strain) if choose(&profile).0 == Method::Sparse => sparse,
        (false, _) => band(reach),
    };
    // Bonds that are each their own are kept here and where they were made.
    let kept: usize = terms.iter().map(|t| t.stored_factors()).sum();
    let vectors = if in_strains { 1 } else { 6 };
    let fields = if recover { 8 * unknowns + 256 * model.points() as u64 } else { 0 };
    matrix + 16 * kept as u64 + 8 * vectors * unknowns + fields
}

/// Memory that programs can have without swapping, bytes, on systems that have `/proc`.
pub(super) fn available() -> Option<u64> {
    let info = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = info.lines().find(|l| l.starts_with("MemAvailable:"))?;
    let kilobytes: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(1024 * kilobytes)
}
