//! Stress intensities of cracks from the energy that their growth releases.
//!
//! `√(E' G)`, `G = −dΠ/dA` at constant loads and prescribed motions, `Π` the stored energy less the work of the loads.
//! The derivative is a central difference of two more solves, the tips moved by one spacing or one step of the lattice back and forth along the last
//! segments of the crack, or of its front along a disc (`E' = E` in plane stress, `E/(1 − ν²)` in plane strain). Mode II, if there is any, is in G, too: how
//! the faces part tells `K_I` and `K_II`, whose squares sum to `E' G`. In antiplane shear it is K_III, with twice the shear modulus in place of E'.

use super::modes::stiffness;
use crate::case::{TipQuantity, Tips};
use crate::diagnostic::Faults;
use crate::model::with_body;
use crate::run::body::BodyProblem;
use crate::run::{Counters, RunError, RunOptions, SolvedState, prepare, solve_states};
use crate::scene::body::{BodyScene, Intensity};
use peristat_assembly::body::in_space;
use peristat_assembly::model::plane::Solvable;
use peristat_assembly::sum::Sum;
use std::time::Instant;

/// Stress intensities of all states and what they have cost.
pub(super) struct Found {
    /// `√(E' G)`, or G where that is asked for, by stress intensity and state.
    pub(super) values: Vec<Vec<f64>>,
    pub(super) counters: Counters,
    pub(super) converged: bool,
    /// Wall time, s.
    pub(super) seconds: f64,
}

/// All stress intensities that a case asks for.
///
/// # Errors
/// As [`prepare`] for the body with a moved tip; a crack that cannot be made shorter is a fault of the case.
pub(super) fn of_states(scene: &BodyScene, options: &RunOptions) -> Result<Found, RunError> {
    let begin = Instant::now();
    let mut found =
        Found { values: Vec::new(), counters: Counters::default(), converged: true, seconds: 0.0 };
    let options = &RunOptions { recover: false, ..*options };
    let mut rates: Vec<Vec<f64>> = Vec::new();
    for (k, intensity) in scene.intensities.iter().enumerate() {
        let same = |other: &Intensity| {
            other.front.is_none() && (other.crack, other.tips) == (intensity.crack, intensity.tips)
        };
        let known = scene.intensities[..k].iter().position(same);
        if intensity.front.is_some() {
            // Its modes follow from how faces part.
            let states = vec![f64::NAN; scene.states.len()];
            found.values.push(states.clone());
            rates.push(states);
            continue;
        }
        let own = match known {
            Some(known) => rates[known].clone(),
            None => release_rates(scene, intensity, options, &mut found)?,
        };
        let stiffness = stiffness(scene);
        let reported = |rate: &f64| match intensity.quantity {
            TipQuantity::EnergyReleaseRate => *rate,
            TipQuantity::K | TipQuantity::KI | TipQuantity::KII | TipQuantity::KIII => {
                (stiffness * rate).sqrt()
            }
        };
        found.values.push(own.iter().map(reported).collect());
        rates.push(own);
    }
    found.seconds = begin.elapsed().as_secs_f64();
    Ok(found)
}

/// Energy release rates of all states, N/m.
fn release_rates(
    scene: &BodyScene,
    intensity: &Intensity,
    options: &RunOptions,
    found: &mut Found,
) -> Result<Vec<f64>, RunError> {
    let step = step(scene, intensity);
    let longer = potentials(scene, intensity, step, options, found)?;
    let shorter = potentials(scene, intensity, -step, options, found)?;
    let area = area(scene, intensity, step);
    Ok(longer
        .into_iter()
        .zip(shorter)
        .map(|(longer, shorter)| ((shorter - longer) / area).max(0.0))
        .collect())
}

/// Spacings up to which steps along a crack are looked for after which its tip meets the same bonds.
const REPEATS: i32 = 4;

/// By how much tips move, m: from one place of the lattice to the next one that is alike, so that the bonds that are cut in between are
/// those of a longer crack. With single spacings √(E' G) of a crack along diagonals is up to 12 % off. One spacing along rows, and where no
/// such place is near.
fn step(scene: &BodyScene, intensity: &Intensity) -> f64 {
    let spacing = scene.spacing();
    let crack = &scene.cracks[intensity.crack].crack;
    let (Some((lattice, _)), Some(tips), v) = (scene.model.lattice(), intensity.tips, crack.vertices())
    else {
        return spacing;
    };
    let axes = lattice.axes();
    let of = |from: [f64; 2], to: [f64; 2]| {
        let d = [0, 1].map(|k| (0..2).map(|j| (to[j] - from[j]) * axes[k][j]).sum::<f64>());
        repeat(d).map(|cells| cells * spacing)
    };
    let (start, end) = (of(v[1], v[0]), of(v[v.len() - 2], v[v.len() - 1]));
    let found = match tips {
        Tips::Start => start,
        Tips::End => end,
        Tips::Both => start.filter(|step| end == Some(*step)),
    };
    found.unwrap_or(spacing)
}

/// Length of the shortest whole number of cells along a direction, in cells.
fn repeat([x, y]: [f64; 2]) -> Option<f64> {
    let length = x.hypot(y);
    let is_along = |i: i32, j: i32| {
        let [a, b] = [f64::from(i), f64::from(j)];
        (a * y - b * x).abs() < 1e-6 * length && a * x + b * y > 0.0
    };
    let all = (-REPEATS..=REPEATS).flat_map(|i| (-REPEATS..=REPEATS).map(move |j| (i, j)));
    let sizes = all.filter(|&(i, j)| is_along(i, j)).map(|(i, j)| f64::from(i).hypot(f64::from(j)));
    sizes.min_by(f64::total_cmp)
}

/// The area by which a crack grows where its tips, or its front, move from a step back to one ahead, m².
fn area(scene: &BodyScene, intensity: &Intensity, step: f64) -> f64 {
    let sides = sides(scene, intensity);
    let (Some(surface), Some((lattice, mirrors))) =
        (scene.cracks[intensity.crack].crack.surface(), scene.model.lattice())
    else {
        let tips = if intensity.tips == Some(Tips::Both) { 2.0 } else { 1.0 };
        return 2.0 * step * tips * scene.material().about().thickness / sides;
    };
    let beside = 1e-3 * lattice.spacing();
    // Parts between two cells belong to the body if one of them does.
    let is_own = |at: &[f64; 3]| {
        [-beside, beside].into_iter().any(|off| {
            let cell = lattice.cell_around(at.map(|x| x + off));
            mirrors.is_real(cell) && lattice.number(cell).is_some()
        })
    };
    let (middles, part) = surface.added([-step, step]);
    middles.iter().filter(|at| is_own(at)).count() as f64 * part / sides
}

/// Sides of a crack that the body has: one if it lies on a line of symmetry, so that the body releases half the energy.
fn sides(scene: &BodyScene, intensity: &Intensity) -> f64 {
    let Some((lattice, mirrors)) = scene.model.lattice() else { return 1.0 };
    let crack = &scene.cracks[intensity.crack].crack;
    let bounds: Vec<[[f64; 3]; 2]> =
        crack.surface().map_or_else(Vec::new, |surface| surface.boxes().collect());
    let corners = crack.vertices().iter().map(|v| in_space(*v)).chain(bounds.into_iter().flatten());
    let corners: Vec<[f64; 3]> = corners.collect();
    let lies_on = |axis: usize, line: i32| {
        let at = lattice.corner()[axis] + f64::from(line) * lattice.spacing();
        corners.iter().all(|v| (v[axis] - at).abs() <= 1e-6 * lattice.spacing())
    };
    let mut all = (0..if lattice.is_plane() { 2 } else { 3 })
        .flat_map(|axis| mirrors.lines[axis].into_iter().flatten().map(move |line| (axis, line)));
    if all.any(|(axis, line)| lies_on(axis, line)) { 2.0 } else { 1.0 }
}

/// Potential energies of all states with the tips moved by some length.
fn potentials(
    scene: &BodyScene,
    intensity: &Intensity,
    by: f64,
    options: &RunOptions,
    found: &mut Found,
) -> Result<Vec<f64>, RunError> {
    let fault = |message: String| {
        let mut faults = Faults::default();
        let number = scene.intensities.iter().position(|i| i.name == intensity.name).unwrap_or(0);
        let path = crate::diagnostic::JsonPath::default().key("stress_intensity").index(number);
        faults
            .error(path, message)
            .hint("use a smaller spacing: the crack needs several spacings at each tip, or in its radius");
        RunError::Case(faults)
    };
    let (model, cracks) = match scene.with_moved_tips(intensity, by) {
        Ok(Some(moved)) => moved,
        Ok(None) => {
            return Err(fault("the crack is not longer than the spacing that its tips are moved by".into()));
        }
        Err(error) => return Err(fault(format!("with its tips moved by a spacing: {error}"))),
    };
    with_body!(model, body => of_problem(&BodyProblem::with_moved_tips(scene, body, cracks), options, found))
}

/// Potential energies of all states of a problem.
fn of_problem<const D: usize>(
    problem: &BodyProblem<dyn Solvable<D>>,
    options: &RunOptions,
    found: &mut Found,
) -> Result<Vec<f64>, RunError> {
    let (system, sizes) = prepare(problem, options)?;
    let mut potentials = Vec::new();
    let mut take = |solved: SolvedState| {
        let mut potential = Sum::default();
        potential.add(solved.certificate.energy);
        solved.load.iter().zip(&solved.solution.u).for_each(|(f, u)| potential.add(-f * u));
        potentials.push(potential.total());
        Ok(())
    };
    let report = solve_states(problem, (&system, sizes), &mut take)?;
    super::add(&mut found.counters, &report.counters);
    found.converged &= report.converged;
    Ok(potentials)
}

#[cfg(test)]
mod tests {
    use super::repeat;

    #[test]
    fn cracks_meet_the_same_bonds_after_whole_cells() {
        assert_eq!(repeat([3.0, 0.0]), Some(1.0));
        assert_eq!(repeat([-2.0, 2.0]), Some(2.0_f64.sqrt()));
        assert_eq!(repeat([-0.4, -0.8]), Some(5.0_f64.sqrt()));
        assert_eq!(repeat([1.0, 0.61]), None);
    }
}
