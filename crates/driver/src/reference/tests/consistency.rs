//! The differential equations, the supports and the energy, for every reference there is.

use super::super::{End, Facts, Field, Load, Solution, TABLE};
use super::facts_for;

/// Load per length and moment per length at x, without what the foundation pushes back.
fn load_at(facts: &Facts, x: f64) -> (f64, f64) {
    facts.loads.iter().fold((0.0, 0.0), |(q, c), load| match *load {
        Load::Uniform { value } => (q + value, c),
        Load::UniformMoment { value } => (q, c + value),
        Load::Sine { amplitude, half_waves } => {
            let angle = f64::from(half_waves) * std::f64::consts::PI * x / facts.length;
            (q + amplitude * angle.sin(), c)
        }
        Load::Force { .. } | Load::Moment { .. } | Load::Foundation { .. } => (q, c),
        Load::Other => panic!("a reference for another kind of load needs its own test"),
    })
}

/// Stiffness of the foundation, zero where there is none.
fn foundation(facts: &Facts) -> f64 {
    let stiffness = |load: &Load| match *load {
        Load::Foundation { stiffness } => stiffness,
        _ => 0.0,
    };
    facts.loads.iter().map(stiffness).sum()
}

/// Derivative by central differences of fourth order, exact for polynomials up to the fourth degree.
fn derivative(f: impl Fn(f64) -> f64, x: f64, step: f64) -> f64 {
    (8.0 * (f(x + step) - f(x - step)) - (f(x + 2.0 * step) - f(x - 2.0 * step))) / (12.0 * step)
}

fn scenes() -> impl Iterator<Item = (&'static str, Facts, Solution)> {
    TABLE.iter().map(|reference| {
        let facts = facts_for(reference.name);
        let solution = (reference.build)(&facts).unwrap();
        (reference.name, facts, solution)
    })
}

fn gives_all(solution: &Solution) -> bool {
    [Field::W, Field::Phi, Field::M, Field::V].iter().all(|field| solution.fields.contains(field))
}

#[test]
fn every_local_reference_satisfies_the_beam_equations() {
    let mut tested = 0;
    for (name, facts, solution) in scenes().filter(|(_, _, solution)| gives_all(solution)) {
        tested += 1;
        let (bending, shear, step) = (facts.bending_stiffness, facts.shear_stiffness, 3e-4 * facts.length);
        for i in 0..11 {
            let x = facts.length * (f64::from(i) + 0.37) / 11.0;
            let state = (solution.at)(x);
            let (q, c) = load_at(&facts, x);
            let slope =
                |field: fn(&super::super::State) -> f64| derivative(|x| field(&(solution.at)(x)), x, step);
            let residuals = [
                slope(|state| state.phi) - state.moment / bending,
                slope(|state| state.w) - state.phi - state.shear / shear,
                slope(|state| state.moment) + state.shear + c,
                slope(|state| state.shear) + q - foundation(&facts) * state.w,
            ];
            // Measured at most 1.3e-11, in the sine; loads and stiffnesses are of order one.
            assert!(residuals.iter().all(|residual| residual.abs() < 1e-10), "{name} at {x}: {residuals:?}");
        }
    }
    assert!(tested >= 12, "only {tested} references give all fields");
}

#[test]
fn every_reference_meets_its_supports() {
    for (name, facts, solution) in scenes() {
        let end_loads = facts.loads.iter().fold((0.0, 0.0), |(force, moment), load| match *load {
            Load::Force { x, value } if x == facts.length => (force + value, moment),
            Load::Moment { x, value } if x == facts.length => (force, moment + value),
            _ => (force, moment),
        });
        for (end, x, (force, moment)) in
            [(facts.ends[0], 0.0, (0.0, 0.0)), (facts.ends[1], facts.length, end_loads)]
        {
            let state = (solution.at)(x);
            let mut zeros = match end {
                End::Clamped => vec![state.w, state.phi],
                End::Simple => vec![state.w, state.moment - moment],
                End::Guided => vec![state.phi, state.shear - force],
                End::Free => vec![state.shear - force, state.moment - moment],
                End::Other => panic!("{name}: no reference is about other ends"),
            };
            if !gives_all(&solution) {
                zeros.truncate(1); // the fields it gives come first
            }
            assert!(zeros.iter().all(|zero| zero.abs() < 1e-14), "{name} at {x}: {zeros:?}");
        }
        for &x in &facts.interior_supports {
            assert!((solution.at)(x).w.abs() < 1e-14, "{name} at {x}");
        }
    }
}

#[test]
fn at_mid_span_only_a_force_makes_a_jump_and_the_value_is_the_left_one() {
    for (name, facts, solution) in scenes().filter(|(_, _, solution)| gives_all(solution)) {
        let middle = facts.length / 2.0;
        let [left, at, right] = [middle - 1e-13, middle, middle + 1e-13].map(|x| (solution.at)(x));
        let close = |a: f64, b: f64| (a - b).abs() < 1e-11;
        assert!(close(left.w, right.w) && close(left.phi, right.phi), "{name}");
        assert!(close(left.moment, right.moment) && close(left.shear, at.shear), "{name}");
        let force: f64 = facts
            .loads
            .iter()
            .map(|load| match *load {
                Load::Force { x, value } if x == middle => value,
                _ => 0.0,
            })
            .sum();
        if facts.interior_supports.is_empty() {
            assert!(close(right.shear - left.shear, -force), "{name}");
        }
    }
}

/// Simpson's rule from 0 to the length; a jump in the middle falls on a node.
fn integral(length: f64, f: impl Fn(f64) -> f64) -> f64 {
    let panels = 1000;
    let weight = |i| {
        if i == 0 || i == panels {
            1.0
        } else if i % 2 == 1 {
            4.0
        } else {
            2.0
        }
    };
    let sum: f64 = (0..=panels).map(|i| weight(i) * f(length * f64::from(i) / f64::from(panels))).sum();
    sum * length / (3.0 * f64::from(panels))
}

/// Clapeyron: supports that do not move do no work.
#[test]
fn every_energy_is_half_the_work_of_the_loads() {
    for (name, facts, solution) in scenes() {
        let energy = solution.value(Field::Energy, 0.0).expect("every reference so far has an energy");
        let spread = integral(facts.length, |x| {
            let (state, (q, c)) = ((solution.at)(x), load_at(&facts, x));
            q * state.w + c * state.phi
        });
        let points: f64 = facts
            .loads
            .iter()
            .map(|load| match *load {
                Load::Force { x, value } => value * (solution.at)(x).w,
                Load::Moment { x, value } => value * (solution.at)(x).phi,
                _ => 0.0,
            })
            .sum();
        let error = (spread + points) / 2.0 / energy - 1.0;
        // Simpson's rule; measured at most 2e-12.
        assert!(error.abs() < 1e-11, "{name}: {error:e}");
    }
}

#[test]
fn every_local_energy_is_that_of_the_beam_and_its_foundation() {
    for (name, facts, solution) in scenes().filter(|(_, _, solution)| gives_all(solution)) {
        let stored = integral(facts.length, |x| {
            let state = (solution.at)(x);
            state.moment * state.moment / facts.bending_stiffness
                + state.shear * state.shear / facts.shear_stiffness
                + foundation(&facts) * state.w * state.w
        });
        let error = stored / 2.0 / solution.value(Field::Energy, 0.0).unwrap() - 1.0;
        // Simpson's rule; measured at most 9.7e-12.
        assert!(error.abs() < 3e-11, "{name}: {error:e}");
    }
}
