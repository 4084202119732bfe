//! A body ready to be solved: terms, constraints, operator, reactions.

mod elimination;
mod in_precision;
mod level;
mod mobility;
mod pattern;
mod scatter;

pub use in_precision::InPrecision;
pub use level::{Level, inverse_of};
pub use mobility::{FreeMotion, PartMotion, free_motions, sprung_motions};
pub use pattern::DifferencePattern;

use crate::condition::{Constraints, Contradiction, Equation};
use crate::model::Model;
use crate::stiffness::{BlockMatrix, Survey, TakeForces, Term, Twofold};
use crate::sum::Sum;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

/// Terms and constraints of one body with `D` unknowns per point.
///
/// The stiffness on the independent unknowns is `Tᵀ (Σ BᵀCB) T`; vectors hold `D` component planes and keep inert,
/// zero entries for constrained unknowns.
pub struct System<const D: usize> {
    points: usize,
    terms: Vec<Box<dyn Term<D>>>,
    constraints: Constraints,
    /// Room to expand a vector in, used only where some unknown depends on others.
    expanded: Mutex<Vec<f64>>,
    /// Terms that are not of the model: the last ones.
    extra: usize,
    elements: usize,
    evaluations: AtomicU64,
}

impl<const D: usize> System<D> {
    /// Joins a model's terms and relations with further terms (springs) and equations (supports, links).
    ///
    /// # Errors
    /// [`Contradiction`] between equations.
    pub fn new(
        model: &dyn Model<D>,
        extra_terms: Vec<Box<dyn Term<D>>>,
        mut equations: Vec<Equation>,
    ) -> Result<Self, Contradiction> {
        equations.extend(model.relations());
        let constraints = Constraints::new(model.points(), &equations)?;
        Ok(Self::with_constraints(model, extra_terms, constraints))
    }

    /// The same with constraints of all unknowns, those of the model's relations among them.
    pub fn with_constraints(
        model: &dyn Model<D>,
        extra_terms: Vec<Box<dyn Term<D>>>,
        constraints: Constraints,
    ) -> Self {
        let mut terms = model.terms();
        let extra = extra_terms.len();
        terms.extend(extra_terms);
        let room = if constraints.has_slaves() { D * model.points() } else { 0 };
        Self {
            points: model.points(),
            elements: terms.iter().map(|t| t.elements()).sum(),
            extra,
            terms,
            constraints,
            expanded: Mutex::new(vec![0.0; room]),
            evaluations: AtomicU64::new(0),
        }
    }

    /// Changes the model, such as by breaking bonds, and takes its terms anew: while it is changed no term of it is alive.
    pub fn change_model<T: Model<D> + ?Sized>(&mut self, model: &mut T, change: impl FnOnce(&mut T)) {
        let extra = self.terms.split_off(self.terms.len() - self.extra);
        self.terms.clear();
        change(model);
        self.terms = model.terms();
        self.terms.extend(extra);
        self.elements = self.terms.iter().map(|t| t.elements()).sum();
    }

    /// Replaces all constraints by the relations of the model and `equations`.
    ///
    /// # Errors
    /// [`Contradiction`] between equations.
    pub fn constrain(
        &mut self,
        model: &dyn Model<D>,
        mut equations: Vec<Equation>,
    ) -> Result<(), Contradiction> {
        equations.extend(model.relations());
        self.constraints = Constraints::new(model.points(), &equations)?;
        let room = if self.constraints.has_slaves() { D * model.points() } else { 0 };
        self.expanded = Mutex::new(vec![0.0; room]);
        Ok(())
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        self.points
    }

    /// Length of a vector of unknowns, `D · points`.
    pub fn size(&self) -> usize {
        D * self.points
    }

    /// Number of independent unknowns.
    pub fn independent(&self) -> usize {
        self.size() - self.constraints.rows().len()
    }

    /// The constraints.
    pub fn constraints(&self) -> &Constraints {
        &self.constraints
    }

    /// The terms.
    pub fn terms(&self) -> &[Box<dyn Term<D>>] {
        &self.terms
    }

    /// Number of elements of all terms.
    pub fn elements(&self) -> usize {
        self.elements
    }

    /// Element evaluations so far.
    pub fn evaluations(&self) -> u64 {
        self.evaluations.load(Ordering::Relaxed)
    }

    fn count(&self) {
        self.evaluations.fetch_add(self.elements as u64, Ordering::Relaxed);
    }

    /// Overwrites `force` with the internal force `Σ BᵀCB u`.
    pub fn force(&self, u: &[f64], force: &mut [f64]) {
        let set: TakeForces<'_, D> = &|_, forces, own| {
            own.into_iter().zip(forces).for_each(|(own, forces)| own.copy_from_slice(forces));
        };
        let (first, others) = self.terms.split_first().expect("a model has a term");
        if !first.sweep(u, force, set) {
            force.fill(0.0);
            first.add_force(u, force);
        }
        others.iter().for_each(|t| t.add_force(u, force));
        self.count();
    }

    /// Overwrites `force` with the internal force of unknowns in two parts, in twice the precision. `false` if some term
    /// cannot.
    pub fn force_twofold(&self, u: Twofold<'_>, force: &mut [Sum]) -> bool {
        force.fill(Sum::default());
        self.count();
        self.terms.iter().all(|term| term.add_force_twofold(u, force))
    }

    /// Overwrites `y` with `Tᵀ (Σ BᵀCB) T q`.
    pub fn product(&self, q: &[f64], y: &mut [f64]) {
        if self.constraints.has_slaves() {
            let mut u = self.expanded.lock().expect("no holder of the lock panics");
            u.copy_from_slice(q);
            self.constraints.expand(0.0, &mut u);
            self.force(&u, y);
        } else {
            self.force(q, y);
        }
        self.constraints.restrict(y);
    }

    /// Stored energy and largest end action of an element.
    pub fn survey(&self, u: &[f64]) -> Survey<D> {
        self.count();
        self.terms.iter().map(|t| t.survey(u)).fold(Survey::EMPTY, Survey::join)
    }

    /// The same twice: of what strains, as [`System::survey_body`] has it, and of all.
    pub fn surveys(&self, u: &[f64]) -> [Survey<D>; 2] {
        self.count();
        self.terms.iter().fold([Survey::EMPTY; 2], |[body, all], term| {
            let own = term.survey(u);
            [if term.is_grounded() { body } else { body.join(own) }, all.join(own)]
        })
    }

    /// The same of what strains: all but what is held to the ground.
    pub fn survey_body(&self, u: &[f64]) -> Survey<D> {
        self.count();
        let strains = self.terms.iter().filter(|t| !t.is_grounded());
        strains.map(|t| t.survey(u)).fold(Survey::EMPTY, Survey::join)
    }

    /// Largest difference of the numbers of two coupled points.
    pub fn reach(&self) -> usize {
        self.terms.iter().map(|t| t.reach()).max().unwrap_or(0)
    }

    /// The stiffness without constraints.
    pub fn stiffness(&self) -> BlockMatrix<D> {
        let mut k = BlockMatrix::sparse(self.points, &self.terms);
        self.terms.iter().for_each(|t| t.add_tangent(&mut k));
        k
    }

    /// The constrained stiffness as a lower band, half bandwidth b and values `K[j + k, j]` at `j·(b + 1) + k`, unknown
    /// `D·point + component`; constrained unknowns keep a positive diagonal and couple to nothing.
    ///
    /// # Panics
    /// Some unknown depends on others: their products belong into [`System::assemble_sparse`].
    pub fn assemble_band(&self) -> (usize, Vec<f64>) {
        assert!(!self.constraints.has_slaves(), "a band is assembled without slaves only");
        let mut k = BlockMatrix::band(self.points, self.reach());
        self.terms.iter().for_each(|t| t.add_tangent(&mut k));
        let (half_bandwidth, mut values) = k.into_band();
        let width = half_bandwidth + 1;
        for row in self.constraints.rows() {
            let j = D * (row.unknown % self.points) + row.unknown / self.points;
            let diagonal = values[j * width];
            values[j * width..(j + 1) * width].fill(0.0);
            values[j * width] = if diagonal > 0.0 { diagonal } else { 1.0 };
            for back in 1..=half_bandwidth.min(j) {
                values[(j - back) * width + back] = 0.0;
            }
        }
        // Unknowns that nothing reads have no stiffness.
        values.iter_mut().step_by(width).filter(|d| **d == 0.0).for_each(|d| *d = 1.0);
        (half_bandwidth, values)
    }
}
