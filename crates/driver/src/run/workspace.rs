//! The vectors that solutions are found and weighed with.

use super::corrections::Corrections;
use super::scan::largest;
use super::{Problem, Spread, extent};
use peristat_assembly::condition::Row;
use peristat_assembly::system::System;
use peristat_solve::{LinearOperator, Pcg, PcgOptions, PcgReport, PcgStatus, Preconditioner};

/// The element-wise stiffness of a system as the solver sees it.
pub(super) struct Elementwise<'a, const D: usize>(pub(super) &'a System<D>);

impl<const D: usize> LinearOperator for Elementwise<'_, D> {
    fn size(&self) -> usize {
        self.0.size()
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        self.0.product(x, y);
    }
}

/// Unknowns of one state with the record of how they were found.
#[derive(Clone, Debug)]
pub(super) struct StateSolution {
    /// `D` component planes.
    pub(super) u: Vec<f64>,
    /// Energy of the prescribed motions as a sudden jump of the constrained unknowns alone; 0 without such motions.
    pub(super) jump_energy: f64,
    /// Whether its loads are in balance without any strain, so that rounding alone strains it: forces on what is held, and those of
    /// strains that need no stress.
    pub(super) cancels: bool,
    /// Forces of the constraints on the unknowns they hold and on their masters, by number of the unknown.
    pub(super) held: Vec<(usize, f64)>,
    /// Force that holds each equation, in the order of the system's equations.
    pub(super) multipliers: Vec<f64>,
    /// Largest element-wise residual per component, constrained unknowns left out.
    pub(super) residual: Vec<f64>,
    /// The correction that one more solve would make, relative to the unknowns.
    pub(super) next_correction: f64,
    /// Twice the energy of that correction.
    pub(super) correction_energy: f64,
    /// The largest end action of the body in that correction, as a work on [`Workspace::scales`].
    pub(super) correction_action: f64,
    /// What rounding makes of the forces of constraints, as a work.
    pub(super) held_error: f64,
    /// The largest end action of the body, as a work.
    pub(super) action: f64,
    /// Stored energy and largest end action of each component, where they are known.
    pub(super) stored: Option<(f64, Vec<f64>)>,
    /// Whether it was found with a factor, which knows soft motions as well as stiff ones.
    pub(super) by_factor: bool,
    /// Least eigenvalue of the preconditioned stiffness that was seen, at most 1: the preconditioner alone corrects a part
    /// of the error that is no smaller.
    pub(super) least_eigenvalue: f64,
    /// Size of all corrections after the first solve with the preconditioner, relative to the solution, in energy norm.
    pub(super) first_correction: f64,
    /// Iterations of all passes.
    pub(super) iterations: usize,
    /// How the last pass ended.
    pub(super) status: PcgStatus,
    /// How the unknowns were corrected after all else here was found.
    pub(super) corrections: Option<Corrections>,
}

impl StateSolution {
    /// Unknowns of which nothing else is known.
    pub(super) fn of(u: Vec<f64>) -> Self {
        Self {
            u,
            jump_energy: 0.0,
            cancels: false,
            held: Vec::new(),
            multipliers: Vec::new(),
            residual: Vec::new(),
            next_correction: f64::INFINITY,
            correction_energy: 0.0,
            correction_action: 0.0,
            held_error: 0.0,
            action: 0.0,
            stored: None,
            by_factor: true,
            least_eigenvalue: 1.0,
            first_correction: 0.0,
            iterations: 0,
            status: PcgStatus::Converged,
            corrections: None,
        }
    }
}

/// Energy over work below which a motion is one of a mechanism.
const YIELDING: f64 = 1e-3;

/// Vectors of one system, or of others with the same unknowns.
pub(super) struct Workspace<const D: usize> {
    pub(super) pcg: Pcg,
    pub(super) residual: Vec<f64>,
    /// Internal force of the solution that was weighed last.
    pub(super) force: Vec<f64>,
    /// Displacements of each component that count as equally large.
    pub(super) scales: [f64; D],
    /// Whether strains are judged by the actions of bonds, not by their energy.
    pub(super) counts_actions: bool,
}

impl<const D: usize> Workspace<D> {
    pub(super) fn new(problem: &dyn Problem<D>, system: &System<D>) -> Self {
        Self {
            pcg: Pcg::new(system.size()),
            residual: vec![0.0; system.size()],
            force: vec![0.0; system.size()],
            scales: extent::scales(problem.model()),
            counts_actions: problem.spread() != Spread::Chain,
        }
    }

    /// Starts from nothing but prescribed motions as a sudden jump; its energy, 0 without motions.
    pub(super) fn start(
        &mut self,
        system: &System<D>,
        load: &[f64],
        motion_factor: f64,
        u: &mut [f64],
    ) -> f64 {
        let (constraints, mut energy) = (system.constraints(), 0.0);
        if constraints.moves() {
            constraints.expand(motion_factor, u);
            energy = system.survey(u).energy;
            self.refresh_residual(system, load, u);
        } else {
            self.residual.copy_from_slice(load);
        }
        constraints.restrict(&mut self.residual);
        energy
    }

    /// A pass of conjugate gradients on the residual at hand.
    pub(super) fn pass(
        &mut self,
        system: &System<D>,
        preconditioner: &mut dyn Preconditioner,
        options: &PcgOptions,
        u: &mut [f64],
    ) -> PcgReport {
        self.pcg.solve(&Elementwise(system), preconditioner, &mut self.residual, u, options)
    }

    /// Improves unknowns under a load and the prescribed motions until the residual is at most `target` in the 2-norm, or
    /// for some iterations. The preconditioner may be that of another system with the same unknowns.
    pub(super) fn follow(
        &mut self,
        system: &System<D>,
        preconditioner: &mut dyn Preconditioner,
        (load, u): (&[f64], &mut [f64]),
        target: f64,
        max_iterations: usize,
    ) -> Followed {
        let constraints = system.constraints();
        constraints.expand(1.0, u);
        self.refresh_residual(system, load, u);
        constraints.restrict(&mut self.residual);
        let mut residual = norm(&self.residual);
        let (mut iterations, mut least_eigenvalue) = (0, 1.0);
        if residual > target {
            let options = PcgOptions {
                max_iterations,
                residual_drop: target / residual,
                // Only the residual decides: it is that of a few bonds.
                energy_drop: 0.0,
                stagnation_window: max_iterations,
            };
            let mut preconditioner = Inert { inner: preconditioner, rows: constraints.rows() };
            let report = self.pass(system, &mut preconditioner, &options, u);
            (iterations, residual) = (report.iterations, norm(&self.residual));
            least_eigenvalue = report.least_eigenvalue.min(1.0);
            constraints.expand(1.0, u);
        }
        Followed { iterations, residual, least_eigenvalue, reached: residual <= target }
    }

    /// Whether the residual of some unknowns acts on a motion that costs next to no energy: the direction in which the
    /// preconditioner, a factor of the system, would go has less than it would have if the system bore the residual.
    pub(super) fn yields(
        &mut self,
        system: &System<D>,
        preconditioner: &mut dyn Preconditioner,
        (load, u): (&[f64], &[f64]),
    ) -> bool {
        self.refresh_residual(system, load, u);
        system.constraints().restrict(&mut self.residual);
        let mut preconditioner = Inert { inner: preconditioner, rows: system.constraints().rows() };
        let direction = self.pcg.precondition(&mut preconditioner, &self.residual);
        let work: f64 = direction.iter().zip(&self.residual).map(|(z, r)| z * r).sum();
        system.constraints().expand(0.0, direction);
        // A factor of what is singular may have pivots below zero.
        2.0 * system.survey(direction).energy < YIELDING * work.abs()
    }

    /// Forces that hold the equations, and twice the work of prescribed motions with them.
    pub(super) fn hold(&mut self, system: &System<D>, load: &[f64], u: &[f64]) -> (Vec<f64>, f64) {
        self.refresh_residual(system, load, u);
        let constraints = system.constraints();
        let multipliers = constraints.multipliers(|unknown| -self.residual[unknown]);
        let work = constraints.rows().iter().map(|row| -self.residual[row.unknown] * row.value).sum();
        (multipliers, work)
    }

    /// The residual `load − F(u)`, whole: forces of constraints, negative, on what they hold.
    pub(super) fn refresh_residual(&mut self, system: &System<D>, load: &[f64], u: &[f64]) {
        system.force(u, &mut self.residual);
        self.residual.iter_mut().zip(load).for_each(|(r, f)| *r = f - *r);
    }
}

/// The 2-norm of the residual of loads and prescribed motions as a sudden jump of the constrained unknowns alone.
pub(super) fn jump<const D: usize>(system: &System<D>, load: &[f64]) -> f64 {
    let (mut u, mut residual) = (vec![0.0; system.size()], vec![0.0; system.size()]);
    system.constraints().expand(1.0, &mut u);
    system.force(&u, &mut residual);
    residual.iter_mut().zip(load).for_each(|(r, f)| *r = f - *r);
    system.constraints().restrict(&mut residual);
    norm(&residual)
}

/// Energy of the prescribed motions as a sudden jump of the constrained unknowns alone; 0 without such motions.
pub(super) fn jump_energy<const D: usize>(system: &System<D>) -> f64 {
    if !system.constraints().moves() {
        return 0.0;
    }
    let mut u = vec![0.0; system.size()];
    system.constraints().expand(1.0, &mut u);
    system.survey(&u).energy
}

/// How unknowns were improved.
pub(super) struct Followed {
    pub(super) iterations: usize,
    /// The last residual, 2-norm.
    pub(super) residual: f64,
    /// As in [`StateSolution`].
    pub(super) least_eigenvalue: f64,
    /// Whether it is small enough.
    pub(super) reached: bool,
}

/// A preconditioner made before some unknowns were constrained: these stay inert.
struct Inert<'a> {
    inner: &'a mut dyn Preconditioner,
    rows: &'a [Row],
}

impl Preconditioner for Inert<'_> {
    fn size(&self) -> usize {
        self.inner.size()
    }

    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        self.inner.apply(r, z);
        self.rows.iter().for_each(|row| z[row.unknown] = 0.0);
    }
}

pub(super) fn norm(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Largest entry of a vector of unknowns with every component in units of its scale.
pub(super) fn size<const D: usize>(v: &[f64], scales: &[f64; D]) -> f64 {
    let n = v.len() / D;
    (0..D).map(|c| largest(&v[c * n..][..n]) / scales[c]).fold(0.0, f64::max)
}
