//! Bodies whose displacements are corrected until they are those of local elasticity.
//!
//! The factor or the cycle that solved a state solves its corrections. They have no resultant, so that reactions stay those of
//! the loads; what replaces displacements beside the border moves the points that are held, and the body follows them back.

use super::fields::BodyResult;
use super::layers;
use super::probed::Probed;
use crate::diagnostic::{Faults, root};
use crate::run::{Corrections, RunError, scan};
use crate::scene::body::{BodyScene, BodyState, HoleRing, LocalLimit};
use nalgebra::{DMatrix, DVector};
use peristat_assembly::body::Outline;
use peristat_assembly::correction::{Bounds, Correction, Fitting, HoleZone, Reading, State};
use peristat_assembly::model::plane::PlaneModel;
use peristat_assembly::recovery::hole::{Field, HoleFit};

/// Polynomials of the fourth degree over three spacings: 18 fields of 32 points.
const FITTING: Fitting = Fitting { degree: 4, reach: 3.0 };
/// A correction is not taken whose energy norm is a larger part of the one before it.
const STALLED: f64 = 0.5;
/// Corrections below this part of the displacements are rounding, which neither falls nor does harm.
const ROUNDING: f64 = 1e-10;
/// Singular values of the rigid motions that supports hold below this part of the largest are zero.
const NONE: f64 = 1e-9;

/// What the displacements of a body are corrected by.
#[derive(Debug)]
pub(super) struct Local<'a> {
    scene: &'a BodyScene,
    limit: &'a LocalLimit,
    correction: Correction,
    /// Around the holes that have fields of their own.
    rings: Vec<HoleRing>,
    /// Places of the probes that have one, and how they are read.
    places: Vec<Option<[f64; 2]>>,
    at_places: Reading,
    /// Where stresses are recovered or points turn, the points of the body.
    points: Vec<usize>,
    at_points: Reading,
}

/// What is known of a state beside its displacements.
struct Around {
    border: Vec<[f64; 2]>,
    weight: [f64; 2],
    holes: Vec<HoleFit>,
}

impl Around {
    fn state<'a>(&'a self, u: &'a [f64], points: usize) -> State<'a> {
        State { u, points, border: &self.border, weight: self.weight, holes: &self.holes }
    }
}

impl<'a> Local<'a> {
    /// Of a scene that asks for it, with or without the stresses of all points.
    ///
    /// # Errors
    /// A body that is too thin somewhere to tell a fit.
    pub(super) fn of(scene: &'a BodyScene, recover: bool) -> Result<Option<Self>, RunError> {
        let Some((limit, model, outline)) = parts(scene) else { return Ok(None) };
        let ratio = scene.material().about().horizon_ratio;
        let rings = HoleRing::of(scene);
        layers::check_seen(scene, &rings)?;
        let holes: Vec<HoleZone> = rings.iter().map(HoleRing::zone).collect();
        let bounds = Bounds { outline, pieces: &limit.pieces, holes: &holes, singular: &limit.singular };
        let places: Vec<Option<[f64; 2]>> =
            scene.probes.iter().map(|probe| probe.position.map(|[x, y, _]| [x, y])).collect();
        let reads_points = recover || scene.model.turning().is_some();
        let points: Vec<usize> = if reads_points { scene.real_points().collect() } else { Vec::new() };
        let made = Correction::new(model, bounds, ratio, FITTING).and_then(|correction| {
            let at_places = correction.reading(places.iter().flatten().copied().collect())?;
            let of_points = points.iter().map(|point| scene.model.place(*point));
            let at_points = correction.reading(of_points.collect())?;
            Some((correction, at_places, at_points))
        });
        match made {
            Some((correction, at_places, at_points)) => {
                Ok(Some(Self { scene, limit, correction, rings, places, at_places, points, at_points }))
            }
            None => {
                let mut faults = Faults::default();
                faults
                    .error(
                        root("limit"),
                        "`local` needs more points: somewhere too few of them are near to tell the stresses",
                    )
                    .hint("use a smaller spacing, four over the thinnest part of the body");
                Err(RunError::Case(faults))
            }
        }
    }

    /// Displacements of a state after so many corrections at most, and how it went; none where nothing moves around a hole.
    pub(super) fn corrected(
        &self,
        state: usize,
        (u, most): (&[f64], usize),
        solve: &mut dyn FnMut(&[f64]) -> Vec<f64>,
    ) -> Option<(Vec<f64>, Corrections)> {
        let state = &self.scene.states[state];
        let points = self.scene.model.points();
        let mut done = Corrections { sizes: Vec::new(), stalled: false };
        let (mut u, mut before) = (u.to_vec(), f64::INFINITY);
        for _ in 0..self.limit.corrections.min(most) {
            let around = self.around(state, &u)?;
            let now = around.state(&u, points);
            // No moments act on points that turn.
            let mut residual = self.correction.residual(now);
            residual.resize(u.len(), 0.0);
            let step = solve(&residual);
            let norm = step.iter().zip(&residual).map(|(d, r)| d * r).sum::<f64>().max(0.0).sqrt();
            let largest = |u: &[f64]| scan::largest(&u[..2 * points]);
            let is_rounding = largest(&step) <= ROUNDING * largest(&u);
            if norm > STALLED * before && !is_rounding {
                done.stalled = true;
                break;
            }
            before = norm;
            let mut next = self.correction.smooth(now);
            next.iter_mut().zip(&step).for_each(|(u, d)| *u += d);
            done.sizes.push(largest(&step) / largest(&next).max(f64::MIN_POSITIVE));
            u = next;
        }
        self.move_back(state, &mut u);
        fill_images(self.scene, &mut u);
        Some((u, done))
    }

    /// What is known of a state with some displacements; none where nothing moves around a hole.
    fn around(&self, state: &BodyState, u: &[f64]) -> Option<Around> {
        let holes = self.rings.iter().map(|ring| ring.fit(self.scene, state, u)).collect::<Option<_>>()?;
        let weight = state.terms.iter().fold([0.0; 2], |sum, &(case, factor)| {
            let [x, y, _] = self.scene.load_cases[case].weight;
            [sum[0] + factor * x, sum[1] + factor * y]
        });
        Some(Around { border: self.limit.known(state, self.correction.samples()), weight, holes })
    }

    /// Gives the result of a state the rotations and stresses of the fits, and its probes what these find where they are.
    pub(super) fn complete(&self, result: &mut BodyResult) {
        let (scene, n) = (self.scene, self.scene.model.points());
        let Some(around) = self.around(&scene.states[result.record.index], &result.record.u) else { return };
        let now = around.state(&result.record.u, n);
        result.probed = self.probed(&around, now);
        let of_points = self.correction.read(&self.at_points, now);
        if let Some((component, scale)) = scene.model.turning() {
            for (point, field) in self.points.iter().zip(&of_points) {
                result.record.u[component * n + point] = scale * field.rotation;
            }
            fill_images(scene, &mut result.record.u);
        }
        let Some(recovered) = &mut result.recovered else { return };
        for (&point, &Field { stress: [xx, yy, xy], .. }) in self.points.iter().zip(&of_points) {
            (0..3).for_each(|k| recovered.stress[k][point] = [xx, yy, xy][k]);
            let stress = [xx, yy, xy, 0.0, 0.0, 0.0];
            let across = scene.model.across_of(stress);
            let strain = scene.model.strains_of(stress, across);
            recovered.energy_density[point] = 0.5 * (0..3).map(|k| stress[k] * strain[k]).sum::<f64>();
            if let Some(own) = recovered.across.get_mut(point) {
                *own = across;
            }
        }
        recovered.fill_images(scene);
    }

    /// What is found where probes are.
    fn probed(&self, around: &Around, now: State) -> Vec<Option<Probed>> {
        let fields = self.correction.read(&self.at_places, now);
        let misfits = self.correction.misfits(&self.at_places, now);
        let samples = self.correction.samples().iter().zip(&around.border);
        let largest = samples
            .map(|(sample, known)| {
                let held = self.limit.pieces[sample.piece].held;
                let [x, y] = [0, 1].map(|c| if held[c] { 0.0 } else { known[c] });
                x.hypot(y)
            })
            .fold(0.0, f64::max);
        let mut found = Probed::all(fields, &misfits, largest).into_iter();
        self.places.iter().map(|at| at.and_then(|_| found.next())).collect()
    }

    /// Moves the body as a rigid one until its points are where they are held.
    fn move_back(&self, state: &BodyState, u: &mut [f64]) {
        let (model, free, n) = (&self.scene.model, &self.limit.free, self.scene.model.points());
        let holds = free.holds.iter().map(|k| &self.scene.conditions.holds[*k]);
        let held: Vec<(usize, [f64; 3], f64)> = holds
            .flat_map(|hold| {
                hold.points.iter().zip(&hold.values).map(|(p, v)| (*p as usize, hold.direction, *v))
            })
            .collect();
        if held.is_empty() || free.motions.is_empty() {
            return;
        }
        let along = |direction: &[f64; 3], [x, y]: [f64; 2]| direction[0] * x + direction[1] * y;
        let works = DMatrix::from_fn(held.len(), free.motions.len(), |r, c| {
            along(&held[r].1, free.at(free.motions[c], model.place(held[r].0)))
        });
        let off = held
            .iter()
            .map(|(p, direction, value)| state.motion_factor * value - along(direction, [u[*p], u[n + *p]]));
        let off = DVector::from_iterator(held.len(), off);
        let Ok(shares) = works.svd(true, true).solve(&off, NONE) else { return };
        for point in 0..n {
            for (share, motion) in shares.iter().zip(&free.motions) {
                let by = free.at(*motion, model.place(point));
                (0..2).for_each(|c| u[c * n + point] += share * by[c]);
            }
        }
        let turn: f64 =
            shares.iter().zip(&free.motions).map(|(share, motion)| share * free.turn(*motion)).sum();
        if let Some((component, turning)) = model.turning() {
            u[component * n..(component + 1) * n].iter_mut().for_each(|phi| *phi += turning * turn);
        }
    }
}

/// The limit with the body that it is of.
fn parts(scene: &BodyScene) -> Option<(&LocalLimit, &dyn PlaneModel, &Outline)> {
    Some((scene.limit.as_deref()?, scene.model.as_plane()?, scene.outline()?))
}

/// Gives images the displacements of their points.
fn fill_images(scene: &BodyScene, u: &mut [f64]) {
    let (n, Some((lattice, mirrors))) = (scene.model.points(), scene.model.lattice()) else { return };
    for &ghost in scene.model.ghosts() {
        let (cell, signs) = mirrors.image(lattice.cell(ghost as usize));
        let Some(real) = lattice.number(cell) else { continue };
        for c in 0..u.len() / n {
            // Points that turn do so the other way.
            let sign = if c < 2 { signs[c] } else { signs[0] * signs[1] };
            u[c * n + ghost as usize] = sign * u[c * n + real];
        }
    }
}
