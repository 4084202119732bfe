//! The processes at work on one body.

use super::agree::agree;
use super::boxes::Boxes;
use super::lead::{Follower, Task};
use super::levels::{SharedCycle, SharedLevels};
use super::order::Order;
use super::part::{Part, width};
use super::refuse::{check_plan, refused, too_small};
use crate::run::body::levels::models;
use crate::run::body::problem::BodyProblem;
use crate::run::measures::worst;
use crate::run::multigrid::{Levels, options};
use crate::run::shared_solver::SharedSolver;
use crate::run::{CoarserModels, Counters, RunError, SolverReport};
use peristat_assembly::model::plane::Solvable;
use peristat_assembly::system::{Level, System};
use peristat_solve::{
    LinearOperator, Multigrid, MultigridOptions, PcgOptions, PcgReport, Preconditioner, Ranks,
};

/// How far the products of the parts may be from that of the whole, per its largest number: rounding leaves 1e-15.
const SAME: f64 = 1e-11;
/// How often the halo is as deep as bonds ask for, at most.
const MOST_TIMES: i32 = 3;

/// What a process has of a body that several solve: its part of the finest level, and all coarser ones.
pub(crate) struct Crew<'r, const D: usize> {
    ranks: &'r dyn Ranks,
    order: Order,
    part: Part<'r, D>,
    coarser: CoarserModels<D>,
    points: usize,
}

impl<'r, const D: usize> Crew<'r, D> {
    /// Builds it for this process, while all others do so for theirs, and compares the product of all parts with that of the whole.
    ///
    /// # Errors
    /// [`RunError::NotShared`], on all processes, where the body is none that can be shared.
    pub(crate) fn new(
        problem: &BodyProblem<dyn Solvable<D>>,
        whole: &System<D>,
        ranks: &'r dyn Ranks,
    ) -> Result<Self, RunError> {
        let width = width(problem.scene);
        // Corners beyond a border may move with points that lie farther inside than bonds reach.
        for times in 1..MOST_TIMES {
            let crew = agree(ranks, Self::unchecked(problem, whole, ranks, times * width))?;
            if crew.check(whole).is_ok() {
                return Ok(crew);
            }
        }
        let crew = agree(ranks, Self::unchecked(problem, whole, ranks, MOST_TIMES * width))?;
        crew.check(whole)?;
        Ok(crew)
    }

    fn unchecked(
        problem: &BodyProblem<dyn Solvable<D>>,
        whole: &System<D>,
        ranks: &'r dyn Ranks,
        width: i32,
    ) -> Result<Self, RunError> {
        check_plan(problem)?;
        let (scene, model) = (problem.scene, &*problem.model);
        let Some(((lattice, mirrors), real)) = model.lattice().zip(scene.body().cells()) else {
            return refused("bodies of listed points");
        };
        let Some(boxes) = Boxes::new(real, ranks.count()) else {
            return too_small(real.points(), ranks.count());
        };
        let order = Order::new(lattice, mirrors, &boxes, ranks.count());
        let (part, of_part) = Part::new(scene, (model, whole), (&boxes, &order, width), ranks)?;
        let Some(mut coarser) = models(model, &*of_part, &problem.cracks, &scene.conditions) else {
            return refused("bodies without coarser lattices");
        };
        let own = part.own();
        coarser.beside_border.retain(|&point| own.binary_search(&(point as u32)).is_ok());
        Ok(Self { ranks, order, part, coarser, points: whole.points() })
    }

    /// Compares the product of all parts with that of the whole, which the first process has.
    fn check(&self, whole: &System<D>) -> Result<(), RunError> {
        let leads = self.ranks.number() == 0;
        let [mut long, mut product] = [0; 2].map(|_| vec![0.0; if leads { whole.size() } else { 0 }]);
        if leads {
            let mut q: Vec<f64> = (0..whole.size()).map(arbitrary).collect();
            whole.constraints().rows().iter().for_each(|row| q[row.unknown] = 0.0);
            self.order.arrange(&q, &mut long);
            whole.product(&q, &mut product);
        }
        let [mut own, mut found] = [0; 2].map(|_| vec![0.0; self.part.size()]);
        self.ranks.deal(&long, &mut own);
        self.part.apply(&own, &mut found);
        self.ranks.gather(&found, &mut long);
        let mut differs = [0.0];
        if leads {
            let mut all = vec![0.0; whole.size()];
            self.order.restore(&long, &mut all);
            let largest = product.iter().fold(f64::MIN_POSITIVE, |a: f64, b| a.max(b.abs()));
            let apart = all.iter().zip(&product).map(|(a, b)| (a - b).abs() / largest);
            differs[0] = worst(apart);
        }
        self.ranks.broadcast(&mut differs);
        match differs[0] <= SAME {
            true => Ok(()),
            false => {
                let by = format!("by {:.0e} of the largest force", differs[0]);
                refused(&format!("bodies whose parts act otherwise than the whole, as this one {by},"))
            }
        }
    }

    /// Its multigrid cycle.
    ///
    /// # Errors
    /// [`RunError::Solve`] where some factor does not exist, on all processes.
    fn cycle(&self) -> Result<SharedCycle<'_, D>, RunError> {
        let finest = Level::coarse(&self.part.system);
        let beside = &self.coarser.beside_border;
        let below = Levels::below(finest, &self.coarser, beside, &mut Counters::default());
        let (levels, coarsest, _) = agree(self.ranks, below.map_err(RunError::Solve))?;
        let levels = SharedLevels { levels, part: &self.part, ranks: self.ranks };
        let multigrid = Multigrid::new(levels, coarsest, &self.options());
        let vectors = [0; 2].map(|_| vec![0.0; self.part.system.size()]);
        Ok(SharedCycle { multigrid, vectors })
    }

    /// How the cycle is made. Whether the finest level finds its largest eigenvalue must not depend on the size of a part, since all
    /// processes find it together: where one is too large for that, all are.
    fn options(&self) -> MultigridOptions {
        let mut options = options(&self.coarser);
        let mut sizes = vec![0.0; self.ranks.count()];
        sizes[self.ranks.number()] = self.part.system.size() as f64;
        self.ranks.sum(&mut sizes);
        let [least, most] = [f64::min, f64::max].map(|of| sizes.iter().copied().fold(sizes[0], of) as usize);
        if most > options.measured_size {
            options.measured_size = options.measured_size.min(least - 1);
        }
        options
    }

    /// The solver of the first process.
    ///
    /// # Errors
    /// As [`Crew::new`].
    pub(crate) fn leader(&self) -> Result<Box<dyn SharedSolver + '_>, RunError> {
        let own = [0; 2].map(|_| vec![0.0; self.part.size()]);
        Ok(Box::new(Leader { crew: self, cycle: self.cycle()?, own, long: vec![0.0; D * self.points] }))
    }
}

impl<const D: usize> Follower for Crew<'_, D> {
    fn follow(&self) -> Result<(), RunError> {
        let (mut cycle, [mut r, mut z]) = (self.cycle()?, [0; 2].map(|_| vec![0.0; self.part.size()]));
        loop {
            match Task::next(self.ranks) {
                Task::End | Task::Build => return Ok(()),
                Task::Precondition => {
                    self.ranks.deal(&[], &mut r);
                    cycle.apply(&r, &mut z);
                }
                Task::Solve { residual_drop, max_iterations } => {
                    self.ranks.deal(&[], &mut r);
                    let options = PcgOptions { residual_drop, max_iterations, ..PcgOptions::default() };
                    z.fill(0.0);
                    self.ranks.conjugate_gradients(&self.part, &mut cycle, &r, &mut z, &options);
                }
            }
            self.ranks.gather(&z, &mut []);
        }
    }
}

/// Between -1/2 and 1/2, as if by chance.
fn arbitrary(k: usize) -> f64 {
    let turns = (k as f64 + 1.0) * 0.618_033_988_749_894_9;
    (turns.fract() * 7919.0).fract() - 0.5
}

/// The first process, which has whole vectors.
struct Leader<'a, const D: usize> {
    crew: &'a Crew<'a, D>,
    cycle: SharedCycle<'a, D>,
    own: [Vec<f64>; 2],
    long: Vec<f64>,
}

impl<const D: usize> Leader<'_, D> {
    /// Deals unknowns to all processes.
    fn deal(&mut self, planes: &[f64]) {
        self.crew.order.arrange(planes, &mut self.long);
        self.crew.ranks.deal(&self.long, &mut self.own[0]);
    }

    /// Gathers what all processes made of them.
    fn gather(&mut self) {
        self.crew.ranks.gather(&self.own[1], &mut self.long);
    }
}

impl<const D: usize> Preconditioner for Leader<'_, D> {
    fn size(&self) -> usize {
        D * self.crew.points
    }

    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        Task::Precondition.tell(self.crew.ranks);
        self.deal(r);
        let [own, found] = &mut self.own;
        self.cycle.apply(own, found);
        self.gather();
        self.crew.order.restore(&self.long, z);
    }
}

impl<const D: usize> SharedSolver for Leader<'_, D> {
    fn solve(&mut self, residual: &[f64], x: &mut [f64], options: &PcgOptions) -> PcgReport {
        let PcgOptions { residual_drop, max_iterations, .. } = *options;
        Task::Solve { residual_drop, max_iterations }.tell(self.crew.ranks);
        self.deal(residual);
        let [own, found] = &mut self.own;
        found.fill(0.0);
        let crew = self.crew;
        let report = crew.ranks.conjugate_gradients(&crew.part, &mut self.cycle, own, found, options);
        self.gather();
        crew.order.add(&self.long, x);
        report
    }

    fn report(&self) -> SolverReport {
        let (points, processes) = (self.crew.points, self.crew.ranks.count());
        let s = if processes == 1 { "" } else { "es" };
        let reason = format!("{points} points of a lattice, shared by {processes} process{s}");
        SolverReport { method: "multigrid".into(), reason, ..SolverReport::default() }
    }
}
