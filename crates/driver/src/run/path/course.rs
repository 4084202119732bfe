//! Where a body is on its path: the committed state, and the energies on the way to it.

use super::super::solve_failure::SolveFailure;
use super::body::{Body, State, norm};
use super::kept::PathRestart;
use super::point::{Cost, PathPoint};
use peristat_assembly::law::Law;
use peristat_assembly::stiffness::Kinematics;
use peristat_assembly::sum::Sum;

/// Damage of a bond that is at its limit but for rounding.
const BARELY: f64 = 1e-12;

/// A body on its path.
pub(super) struct Course<const D: usize> {
    pub(super) body: Body<D>,
    /// The committed state.
    pub(super) state: State<D>,
    /// Unknowns per load factor of the virgin body.
    pub(super) elastic: Vec<f64>,
    /// The state of the virgin body at a load factor of one if it stayed elastic, and its work.
    pub(super) unit: (State<D>, f64),
    /// Force that residuals are measured with: what bonds do at points in an elastic step of the largest increment.
    pub(super) reference: f64,
    pub(super) points: Vec<PathPoint>,
    pub(super) island_points: usize,
    work: Sum,
    inner_work: Sum,
    largest_work: f64,
    /// The states that [`Self::accept`] has taken.
    pub(super) accepted: usize,
}

impl<const D: usize> Course<D> {
    /// A virgin body at rest; `increment` is the largest growth of the load factor.
    ///
    /// # Errors
    /// Its stiffness has no factor.
    pub(super) fn new(mut body: Body<D>, increment: f64) -> Result<Self, SolveFailure> {
        let size = body.system.size();
        let state = body.state(vec![0.0; size], 0.0);
        if !body.factor(&state, 0.0)? {
            return Err(SolveFailure::Supports);
        }
        let answers = &state.answers.bonds;
        let drive = body.drive(&state, |k| answers[k].tangent);
        let mut elastic = vec![0.0; size];
        body.solve(&drive, &mut elastic);
        elastic.iter_mut().for_each(|v| *v = -*v);
        let mut moving = elastic.clone();
        body.system.constraints().expand(1.0, &mut moving);
        let rates = body.bonds.elongation_rates(answers, &moving);
        let unit = body.elastic_state(&state, &moving, &rates);
        let mut sizes = vec![0.0; size];
        let points = body.system.points();
        for (bond, (answer, rate)) in answers.iter().zip(&rates).enumerate() {
            let force = (answer.tangent * rate * increment).abs();
            for (point, share) in body.bonds.shares(bond) {
                let force = share.abs() * force;
                (0..D).for_each(|c| sizes[c * points + point as usize] += answer.direction[c].abs() * force);
            }
        }
        body.system.constraints().rows().iter().for_each(|row| sizes[row.unknown] = 0.0);
        let reference = norm(&sizes);
        Ok(Self {
            body,
            state,
            elastic,
            unit,
            reference,
            points: Vec::new(),
            island_points: 0,
            work: Sum::default(),
            inner_work: Sum::default(),
            largest_work: 0.0,
            accepted: 0,
        })
    }

    /// Goes on from what was kept, which must fit.
    pub(super) fn resume(&mut self, kept: &PathRestart) {
        self.body.bonds.set_history(kept.history.clone());
        if kept.history.iter().any(|bond| bond.broken) {
            self.find_islands();
        }
        self.state = State::kept(kept.state.clone());
        self.points.clone_from(&kept.points);
        [self.work, self.inner_work] = kept.work;
        self.largest_work = kept.largest_work;
        self.accepted = kept.points.len() - 1;
    }

    /// Work of loads and motions, that of the forces of bonds, and the largest one so far.
    pub(super) fn works(&self) -> ([Sum; 2], f64) {
        ([self.work, self.inner_work], self.largest_work)
    }

    /// Commits a state in equilibrium. Returns what is known of it but for its probes.
    pub(super) fn accept(&mut self, state: State<D>, cost: Cost) -> PathPoint {
        self.add_work(&state);
        let changed = self.body.bonds.commit(&state.answers);
        self.state = state;
        self.accepted += 1;
        if changed[1] > 0 {
            self.find_islands();
        }
        self.point(changed[0], cost)
    }

    /// What is known of the body at rest.
    pub(super) fn at_rest(&self) -> PathPoint {
        self.point(0, Cost::default())
    }

    /// Adds the work from the committed state to another one.
    fn add_work(&mut self, next: &State<D>) {
        let (body, last) = (&self.body, &self.state);
        let motion = 0.5 * (body.motion_force(last) + body.motion_force(next));
        self.work.add(motion * (next.load_factor - last.load_factor));
        let mean = 0.5 * (last.load_factor + next.load_factor);
        let moved = body.loads.iter().zip(next.u.iter().zip(&last.u)).filter(|(load, _)| **load != 0.0);
        moved.for_each(|(load, (next, last))| self.work.add(mean * load * (next - last)));
        if body.bonds.kinematics() == Kinematics::Linear {
            let bonds = last.answers.bonds.iter().zip(&next.answers.bonds);
            bonds.for_each(|(a, b)| {
                self.inner_work.add(0.5 * (a.force + b.force) * (b.elongation - a.elongation))
            });
        } else {
            // Elongations are no linear function of the unknowns: forces on the points do the work.
            let force = |state: &State<D>, k: usize| state.forces[k] + state.load_factor * body.loads[k];
            let each =
                (0..next.u.len()).map(|k| 0.5 * (force(last, k) + force(next, k)) * (next.u[k] - last.u[k]));
            each.for_each(|part| self.inner_work.add(part));
        }
        self.largest_work = self.largest_work.max(self.work.total().abs());
    }

    fn point(&self, changed: usize, cost: Cost) -> PathPoint {
        let energies = self.body.bonds.energies(&self.state.answers);
        let relative = |lack: f64| if self.largest_work > 0.0 { lack / self.largest_work } else { 0.0 };
        let (work, inner) = (self.work.total(), self.inner_work.total());
        let mut counts = [0; 2];
        for (k, history) in self.body.bonds.history().iter().enumerate() {
            let softens = self.body.bonds.law(k).damage(history) > BARELY;
            counts[0] += usize::from(softens && !history.broken);
            counts[1] += usize::from(history.broken);
        }
        PathPoint {
            step: self.accepted,
            load_factor: self.state.load_factor,
            work,
            stored: energies.stored,
            dissipated: energies.dissipated,
            balance: relative(work - energies.stored - energies.dissipated),
            identity: relative(work - inner),
            changed,
            softened: counts[0],
            broken: counts[1],
            island_points: self.island_points,
            iterations: cost.effort.iterations,
            blended: cost.effort.blended,
            refused: cost.refused,
            negative_eigenvalues: cost.negative,
            factorisations: self.body.counters.factorisations,
            // Nothing drives a body without motions and loads.
            residual: if self.reference > 0.0 { self.state.norm() / self.reference } else { 0.0 },
            ..PathPoint::default()
        }
    }

    /// Load factor at which the search for a load ends: back through the state of rest and as far beyond it as the path
    /// was. A load that is not met by then is not there.
    pub(super) fn farthest_back(&self) -> f64 {
        -self.points.iter().map(|p| p.load_factor.abs()).fold(0.0, f64::max)
    }

    /// Stretch of a bond in the committed state.
    pub(super) fn stretch(&self, bond: usize) -> f64 {
        self.state.answers.bonds[bond].elongation / self.body.bonds.list()[bond].length
    }

    /// Breaks a bond that rounding has kept.
    pub(super) fn fail(&mut self, bond: usize) {
        if !self.body.bonds.history()[bond].broken {
            self.body.bonds.fail(bond);
            self.find_islands();
        }
    }

    /// Leaves what has come off where it is: a step that is extrapolated would move it on, and strain it.
    pub(super) fn hold_islands(&self, u: &mut [f64]) {
        self.body.masked.iter().for_each(|&unknown| u[unknown] = self.state.u[unknown]);
    }

    /// Finds parts that nothing holds any more and masks their unknowns. Where points have no bonds from the start, such as
    /// inside rigid regions, constraints hold them.
    pub(super) fn find_islands(&mut self) {
        let body = &mut self.body;
        let (points, constraints) = (body.system.points(), body.system.constraints());
        let mut joined = body.bonds.connected();
        for row in constraints.rows() {
            row.masters.iter().for_each(|&(m, _)| joined.join(row.unknown % points, m % points));
        }
        let parts = joined.numbered();
        let mut held = vec![false; parts.spans().len()];
        constraints.rows().iter().for_each(|row| held[parts.of(row.unknown % points)] = true);
        let loose: Vec<usize> = (0..points).filter(|&p| !held[parts.of(p)]).collect();
        self.island_points = loose.len();
        body.masked = loose.iter().flat_map(|&p| (0..D).map(move |c| c * points + p)).collect();
        body.masked.sort_unstable();
    }
}
