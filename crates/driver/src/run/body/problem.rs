//! A body in the plane as a problem to be solved.

use super::local::Local;
use super::{levels, solid_memory};
use crate::case::Solver;
use crate::model::Surface;
use crate::run::{Coarser, Corrections, Problem, Spread, TOO_MANY_POINTS};
use crate::scene::body::BodyScene;
use peristat_assembly::body::Crack;
use peristat_assembly::condition::Equation;
use peristat_assembly::model::Model;
use peristat_assembly::model::plane::Solvable;
use peristat_assembly::stiffness::Spring;
use peristat_assembly::system::{FreeMotion, System};

/// Points of a solid whose factor is worth having: at 5000 with bonds over three spacings it takes 2.4 s and 380 MB.
const MOST_OF_SOLID: usize = 5000;
/// The same where points feel the families of their neighbours: at 5000 it takes 21 s and 1.4 GB.
const MOST_WITH_FAMILIES: usize = 2500;
/// Points of a solid that a file lists, where no cycle helps: a bar of 17 500 takes 2700 steps of conjugate gradients with the blocks
/// of its points, and eight times as long as with a factor, of 1.9 GB.
const MOST_LISTED: usize = 20_000;
/// Points of a solid, without images, whose factor has twelve digits right where cycles have nine, for a third of a second more at
/// most: a cube of 1000 takes 0.07 and 0.19 s with bonds over two and three spacings, cycles 0.03 and 0.15 s; with families over three
/// spacings 0.45 and 0.19 s.
const FEW_OF_SOLID: usize = 1000;
/// Points of a membrane up to which a factor takes about as long as a cycle, and leaves more digits: a tube of 5000 takes 0.20 and
/// 0.17 s, one of 20 000 takes 1.8 and 1.3 s.
const FEW_OF_SHELL: usize = 10_000;

/// A scene with a model of its body: its own one, or one with other cracks. Points, conditions and loads are those of the
/// scene.
#[derive(Debug)]
pub struct BodyProblem<'a, M: ?Sized> {
    /// The scene.
    pub scene: &'a BodyScene,
    /// The model.
    pub model: Box<M>,
    /// Cracks of the model.
    pub cracks: Vec<Crack>,
    /// What the model has that the scene has not, for messages: `with the tip moved by a spacing `.
    apart: &'static str,
    /// What its displacements are corrected by, where that is asked for.
    pub(super) local: Option<Local<'a>>,
}

impl<'a, M: ?Sized> BodyProblem<'a, M> {
    /// The scene as it is, with its own model.
    pub fn new(scene: &'a BodyScene, model: Box<M>) -> Self {
        let cracks = scene.cracks.iter().map(|c| c.crack.clone()).collect();
        Self { scene, model, cracks, apart: "", local: None }
    }
}

impl<const D: usize, M: Solvable<D> + ?Sized> Problem<D> for BodyProblem<'_, M> {
    fn model(&self) -> &dyn Model<D> {
        self.model.as_solvable()
    }

    fn springs(&self) -> &[Spring] {
        &self.scene.conditions.springs
    }

    fn equations(&self) -> &[Equation] {
        &self.scene.equations
    }

    fn solver(&self) -> Solver {
        self.scene.solver
    }

    fn states(&self) -> usize {
        self.scene.states.len()
    }

    fn add_load(&self, state: usize, force: &mut [f64]) -> f64 {
        let state = &self.scene.states[state];
        for &(case, factor) in &state.terms {
            self.scene.load_cases[case].add_to(self.model.as_solvable(), factor, force);
        }
        state.motion_factor
    }

    fn motions(&self, state: usize) -> Option<Vec<f64>> {
        let of = self.scene.conditions.in_step(state, self.scene.states[state].load_factor)?;
        Some(of.equations(&|p| self.scene.model.position(p)).iter().map(|equation| equation.value).collect())
    }

    fn is_corrected(&self) -> bool {
        self.local.is_some()
    }

    fn corrected(
        &self,
        state: usize,
        from: (&[f64], usize),
        solve: &mut dyn FnMut(&[f64]) -> Vec<f64>,
    ) -> Option<(Vec<f64>, Corrections)> {
        self.local.as_ref()?.corrected(state, from, solve)
    }

    fn breaks(&self) -> bool {
        self.scene.case.is_traced()
    }

    fn spread(&self) -> Spread {
        let is_solid = self.scene.body().axes() > 2;
        let is_small_shell = self.model.needs_all_rows() && self.model.points() <= FEW_OF_SHELL;
        let real = self.model.points() - self.model.ghosts().len();
        match self.scene.solver {
            Solver::Auto if is_small_shell => Spread::Plane,
            Solver::Auto if is_solid && real <= FEW_OF_SOLID => Spread::Solid,
            _ if is_solid && self.model.lattice().is_none() => Spread::Solid,
            _ => levels::spread(self.model.as_solvable()),
        }
    }

    fn most_factored(&self) -> usize {
        match (self.scene.body().axes() > 2, self.scene.material().about().has_families) {
            (false, _) => TOO_MANY_POINTS,
            (true, false) if self.model.lattice().is_none() => MOST_LISTED,
            (true, false) => MOST_OF_SOLID,
            (true, true) => MOST_WITH_FAMILIES,
        }
    }

    fn solid_bytes(&self, with_factor: bool) -> Option<usize> {
        let about = self.scene.material().about();
        if self.scene.body().axes() > 2 && self.model.lattice().is_none() {
            let points = self.model.points();
            return Some(match with_factor {
                true => solid_memory::of_listed_factor(points, &about),
                false => solid_memory::of_listed(points, self.model.sizes().elements),
            });
        }
        let (lattice, _) = self.model.lattice().filter(|(lattice, _)| !lattice.is_plane())?;
        if with_factor {
            return Some(solid_memory::of_factor(lattice, &about));
        }
        let has_fronts = !self.scene.intensities.is_empty();
        Some(solid_memory::of(lattice, &about, has_fronts))
    }

    fn kept_bytes(&self) -> usize {
        let about = self.scene.material().about();
        if !about.has_families || self.scene.body().axes() > 2 {
            return 0;
        }
        /// Of a block of the coarsest level, bytes. Measured on squares of 22 500 to 160 000 points and on bodies of revolution, horizons
        /// of two to five spacings: the estimate is 1.0 to 1.25 times what a run takes.
        const BLOCK: f64 = 85.0;
        // Points are coupled with those of the families of their neighbours.
        let coupled = (4.0 * about.horizon_ratio + 1.0).powi(2);
        (BLOCK * coupled * self.model.points().min(levels::COARSEST) as f64) as usize
    }

    fn has_matrices(&self) -> bool {
        self.model.needs_all_rows()
    }

    fn positions(&self) -> Option<Vec<[f64; 2]>> {
        let is_plane = self.scene.body().axes() == 2;
        is_plane.then(|| (0..self.model.points()).map(|point| self.model.place(point)).collect())
    }

    fn coarser(&self, system: &System<D>) -> Option<Coarser<D>> {
        levels::coarser(self.model.as_solvable(), &self.cracks, &self.scene.conditions, system)
    }

    fn describe(&self, motion: &FreeMotion) -> String {
        format!("{}{}", self.apart, self.scene.describe(self.model.as_solvable(), motion))
    }

    fn describe_loose(&self, motion: &FreeMotion) -> Option<String> {
        let text = self.scene.describe_loose(self.model.as_solvable(), motion)?;
        Some(format!("{}{text}", self.apart))
    }

    fn remedy(&self) -> &'static str {
        match self.apart {
            "" if self.scene.material().surface() == Surface::Section => {
                "a body of revolution needs `uy` held on one place, in every part that cracks and holes leave"
            }
            "" if self.model.along(0).is_none() => {
                "a plate in antiplane shear needs `w` held on one place, in every part that cracks and holes leave"
            }
            "" if self.scene.body().axes() > 2 => {
                "a solid needs `ux`, `uy` and `uz` held so that it can neither move nor turn, such as on a face"
            }
            "" if self.model.along(2).is_some() => {
                "a shell needs `ux` and `uy` held on one place, and `w` where it could move across its axis or tilt: at two places a quarter of the circumference apart, each at both ends"
            }
            "" => {
                "a body in the plane needs `ux` and `uy` held on one place and one of them on another, in every part that cracks and holes leave"
            }
            _ => "a stress intensity needs a ligament of several spacings before the tip",
        }
    }
}

impl<'a, M: ?Sized> BodyProblem<'a, M> {
    /// The scene with a model that has the tips of a crack moved.
    pub fn with_moved_tips(scene: &'a BodyScene, model: Box<M>, cracks: Vec<Crack>) -> Self {
        Self { scene, model, cracks, apart: "with the tip moved by a spacing ", local: None }
    }
}
