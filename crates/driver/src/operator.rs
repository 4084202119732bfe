//! The stiffness of a case as an operator, for programs that bring a solver of their own.

use crate::model::with_body;
use crate::run::body::BodyProblem;
use crate::run::{Problem, RunError, constrained, moved};
use crate::scene::Scene;
use crate::{Error, Loaded};
use peristat_assembly::condition::Constraints;
use peristat_assembly::system::System;
use sprs::{CsMat, TriMat};
use std::array::from_fn;

/// The stiffness of a case under its supports, links and springs, with its loads: `K q = f`, in the units of the case. Its unknowns are
/// the displacements and rotations that no equation prescribes; a case without supports keeps its free motions, and `K` is then
/// singular. Bonds are as they are before any of them breaks or yields, and
/// what acts one way acts both ways.
pub struct Operator {
    form: Box<dyn Form>,
    components: Vec<&'static str>,
    unknowns: Vec<(usize, usize)>,
    points: usize,
    states: Vec<State>,
}

/// What drives a state: forces on the independent unknowns, and the factor on prescribed motions, of the system or its own.
struct State {
    forces: Vec<f64>,
    motion_factor: f64,
    own: Option<Constraints>,
}

/// The operator for any number of unknowns per point.
trait Form: Send + Sync {
    fn product(&self, q: &[f64], out: &mut [f64]);
    fn matrix(&self) -> CsMat<f64>;
    fn expand(&self, q: &[f64], state: &State) -> Vec<f64>;
}

impl Operator {
    /// The operator of a case, within a limit on the memory that solving it would take, bytes.
    ///
    /// # Errors
    /// [`Error::Case`] where supports contradict each other; [`Error::Run`] where the memory does not suffice.
    pub fn new(loaded: &Loaded, max_memory: Option<u64>) -> Result<Self, Error> {
        match &loaded.scene {
            Scene::Beam(scene) => {
                let points = (0..scene.beam.points()).collect();
                match scene.has_axial {
                    true => Self::of::<3>((loaded, max_memory), &**scene, points),
                    false => Self::of::<2>((loaded, max_memory), &**scene, points),
                }
            }
            Scene::Body(scene) => with_body!(&scene.model, body => {
                Self::of((loaded, max_memory), &BodyProblem::new(scene, body.clone()), scene.real_points().collect())
            }),
            Scene::Plate(scene) => {
                Self::of((loaded, max_memory), &**scene, (0..scene.body.points()).collect())
            }
        }
    }

    fn of<const D: usize>(
        (loaded, max_memory): (&Loaded, Option<u64>),
        problem: &dyn Problem<D>,
        points: Vec<usize>,
    ) -> Result<Self, Error> {
        let system = constrained(problem, max_memory).map_err(|error| loaded.explain(error))?;
        let (model, n) = (problem.model(), system.points());
        let mut is_free = vec![true; system.size()];
        system.constraints().rows().iter().for_each(|row| is_free[row.unknown] = false);
        let place = |&(k, c): &(usize, usize)| c * n + points[k];
        let all = (0..points.len()).flat_map(|k| (0..D).map(move |c| (k, c)));
        let free = all.filter(|unknown| is_free[place(unknown)]);
        let (idle, unknowns): (Vec<_>, Vec<_>) = free.partition(|&(k, c)| model.is_idle(c, points[k]));
        let form = Numbered {
            numbers: unknowns.iter().map(place).collect(),
            scales: from_fn(|c| model.scale(c)),
            idle: idle.iter().map(place).collect(),
            points,
            system,
        };
        let states = (0..problem.states()).map(|state| form.state(problem, state)).collect::<Result<_, _>>();
        let states = states.map_err(|error| loaded.explain(error))?;
        Ok(Self {
            components: model.components().iter().take(D).map(|component| component.name).collect(),
            points: form.points.len(),
            form: Box::new(form),
            unknowns,
            states,
        })
    }

    /// Names of the displacements and rotations of a point, in order.
    pub fn components(&self) -> &[&'static str] {
        &self.components
    }

    /// Point, in the order of [`Solved::points`](crate::Solved::points), and index of the component of every unknown.
    pub fn unknowns(&self) -> &[(usize, usize)] {
        &self.unknowns
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        self.points
    }

    /// Number of states, each with its own right-hand side.
    pub fn states(&self) -> usize {
        self.states.len()
    }

    /// Overwrites `out` with `K q`, bond by bond, without a matrix.
    ///
    /// # Panics
    /// A vector has not one value for every unknown.
    pub fn product(&self, q: &[f64], out: &mut [f64]) {
        assert_eq!([q.len(), out.len()], [self.unknowns.len(); 2], "a value for every unknown");
        self.form.product(q, out);
    }

    /// `K` assembled.
    pub fn matrix(&self) -> CsMat<f64> {
        self.form.matrix()
    }

    /// `f`: the loads of a state, less the forces of its prescribed motions.
    ///
    /// # Panics
    /// There is no such state.
    pub fn right_hand_side(&self, state: usize) -> &[f64] {
        &self.states[state].forces
    }

    /// Displacements and rotations of all points, one point after the other, with what a state prescribes; NaN along members of frames
    /// that stretch as one bar, whose points have no displacement of their own along them.
    ///
    /// # Panics
    /// There is no such state, or `q` has not one value for every unknown.
    pub fn expand(&self, q: &[f64], state: usize) -> Vec<f64> {
        assert_eq!(q.len(), self.unknowns.len(), "a value for every unknown");
        self.form.expand(q, &self.states[state])
    }
}

/// A system with its independent unknowns numbered.
struct Numbered<const D: usize> {
    system: System<D>,
    /// Where the independent unknowns stand in a vector of the system.
    numbers: Vec<usize>,
    /// What multiplies displacements and rotations to make the unknowns of the system.
    scales: [f64; D],
    /// Numbers of the points that are no images and no ghosts.
    points: Vec<usize>,
    /// Where nothing is solved for.
    idle: Vec<usize>,
}

impl<const D: usize> Numbered<D> {
    fn scale(&self, number: usize) -> f64 {
        self.scales[number / self.system.points()]
    }

    fn spread(&self, q: &[f64]) -> Vec<f64> {
        let mut u = vec![0.0; self.system.size()];
        self.numbers.iter().zip(q).for_each(|(&number, q)| u[number] = self.scale(number) * q);
        u
    }

    fn gather(&self, forces: &[f64], out: &mut [f64]) {
        let own = self.numbers.iter().map(|&number| self.scale(number) * forces[number]);
        out.iter_mut().zip(own).for_each(|(out, own)| *out = own);
    }

    fn state(&self, problem: &dyn Problem<D>, state: usize) -> Result<State, RunError> {
        let own = moved(problem, &self.system, state)?.map(|system| system.constraints().clone());
        let constraints = own.as_ref().unwrap_or(self.system.constraints());
        let mut forces = vec![0.0; self.system.size()];
        let factor = problem.add_load(state, &mut forces);
        let motion_factor = if own.is_some() { 1.0 } else { factor };
        if constraints.moves() {
            let (mut moved, mut held) = (vec![0.0; forces.len()], vec![0.0; forces.len()]);
            constraints.expand(motion_factor, &mut moved);
            self.system.force(&moved, &mut held);
            forces.iter_mut().zip(held).for_each(|(force, held)| *force -= held);
        }
        constraints.restrict(&mut forces);
        let mut gathered = vec![0.0; self.numbers.len()];
        self.gather(&forces, &mut gathered);
        Ok(State { forces: gathered, motion_factor, own })
    }
}

impl<const D: usize> Form for Numbered<D> {
    fn product(&self, q: &[f64], out: &mut [f64]) {
        let mut forces = vec![0.0; self.system.size()];
        self.system.product(&self.spread(q), &mut forces);
        self.gather(&forces, out);
    }

    fn matrix(&self) -> CsMat<f64> {
        let (size, points) = (self.system.size(), self.system.points());
        let mut column = vec![None; size];
        let mut dependence = TriMat::new((size, self.numbers.len()));
        for (k, &number) in self.numbers.iter().enumerate() {
            column[number] = Some(k);
            dependence.add_triplet(number, k, self.scale(number));
        }
        for row in self.system.constraints().rows() {
            for &(master, factor) in &row.masters {
                if let Some(k) = column[master] {
                    dependence.add_triplet(row.unknown, k, factor * self.scale(master));
                }
            }
        }
        let dependence: CsMat<f64> = dependence.to_csr();
        let stiffness = self.system.stiffness().to_csr(|point, component| component * points + point);
        &dependence.transpose_view().to_csr() * &(&stiffness * &dependence)
    }

    fn expand(&self, q: &[f64], state: &State) -> Vec<f64> {
        let (mut u, n) = (self.spread(q), self.system.points());
        state.own.as_ref().unwrap_or(self.system.constraints()).expand(state.motion_factor, &mut u);
        self.idle.iter().for_each(|&number| u[number] = f64::NAN);
        let of_point = |&point: &usize| from_fn::<f64, D, _>(|c| u[c * n + point] / self.scales[c]);
        self.points.iter().flat_map(of_point).collect()
    }
}
