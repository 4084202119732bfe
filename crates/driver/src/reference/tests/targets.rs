//! Numbers at single points: closed forms of the Timoshenko beam evaluated with 50 digits (mpmath).
//!
//! The beam is 1 m long and 0.05 m wide, E = 200e9 Pa, nu = 0.3, kappa = 5/6, and 0.2, 0.05, 0.01 or 1e-4 m
//! high. Those of the free beam on a foundation are the exponentials of its equation, fitted to its ends.

use super::super::{Facts, Field, Load, find};
use super::facts_for;

/// Height, m; point force, N, or point moment, N m; uniform load, N/m.
const SECTIONS: [(f64, f64, f64); 4] =
    [(0.2, 1e6, 1e7), (0.05, 1e3, 1e4), (0.01, 10.0, 100.0), (1e-4, 1e-5, 1e-4)];

/// Foundation, N/m² for a uniform load of 1 N/m: it alone sinks by a millimetre.
const FOUNDATION: f64 = 1e3;

/// Reference, field, x, and the value for each section.
#[rustfmt::skip]
const TARGETS: [(&str, Field, f64, [f64; 4]); 27] = [
    ("cantilever_tip_force", Field::W, 1.0, [0.05156, 0.00320624, 0.004000312, 0.0040000000312]),
    ("cantilever_tip_force", Field::Phi, 1.0, [0.075, 0.0048, 0.006, 0.006]),
    ("cantilever_end_moment", Field::W, 1.0, [0.075, 0.0048, 0.006, 0.006]),
    ("cantilever_end_moment", Field::Phi, 1.0, [0.15, 0.0096, 0.012, 0.012]),
    ("cantilever_uniform", Field::W, 1.0, [0.1953, 0.0120312, 0.01500156, 0.015000000156]),
    ("cantilever_uniform", Field::Phi, 1.0, [0.25, 0.016, 0.02, 0.02]),
    ("simply_supported_uniform", Field::W, 0.5, [0.02148125, 0.0012578, 0.00156289, 0.001562500039]),
    ("simply_supported_uniform", Field::Phi, 0.0, [0.0625, 0.004, 0.005, 0.005]),
    ("simply_supported_mid_force", Field::W, 0.5, [0.003515, 0.00020156, 0.000250078, 0.0002500000078]),
    ("simply_supported_mid_force", Field::Phi, 0.0, [0.009375, 0.0006, 0.00075, 0.00075]),
    ("clamped_clamped_uniform", Field::W, 0.5, [0.00585625, 0.0002578, 0.00031289, 0.000312500039]),
    ("clamped_clamped_uniform", Field::Phi, 0.25, [0.01171875, 0.00075, 0.0009375, 0.0009375]),
    ("clamped_simply_supported_uniform", Field::W, 0.5, [0.010117062645461599, 0.0005092596536753331, 0.0006254631192966948, 0.0006250000463125]),
    ("clamped_simply_supported_uniform", Field::Phi, 1.0, [-0.03408650116369279, -0.0020116772294026647, -0.002500584954373559, -0.0025000000584999996]),
    ("clamped_simply_supported_uniform", Field::V, 1.0, [-3787820.015515904, -3752.432756125555, -37.50097492395593, -3.75000000975e-05]),
    ("clamped_guided_uniform", Field::W, 1.0, [0.0703, 0.0040312, 0.00500156, 0.005000000156]),
    ("clamped_guided_uniform", Field::M, 0.0, [3333333.3333333335, 3333.3333333333335, 33.333333333333336, 3.3333333333333335e-05]),
    ("two_span_uniform", Field::W, 0.75, [0.0010570456970128022, 3.3562795197459815e-05, 3.917827554802902e-05, 3.906251157812494e-05]),
    ("two_span_uniform", Field::Phi, 0.0, [0.005206481152204836, 0.00025580472315935704, 0.0003127924087684642, 0.0003125000292499991]),
    ("two_span_uniform", Field::M, 0.5, [277827.1692745377, 310.0813653502679, 3.1240253041051194, 3.124999902500003e-06]),
    ("free_free_foundation_mid_force", Field::W, 0.5, [0.0002917695440887802, 0.00012587145944324614, 0.00013065681494921772, 0.00013063546479007826]),
    ("free_free_foundation_mid_force", Field::Phi, 0.0, [0.0005364819590295302, 0.00016499947728787026, 0.00019780778461714056, 0.00019782278276115828]),
    ("free_free_foundation_mid_force", Field::M, 0.5, [-53895.48209969106, -110.87752987628146, -1.0816240279209732, -1.0816800345428488e-06]),
    ("free_free_foundation_mid_force", Field::W, 0.0, [-5.058282313595076e-05, 6.233418593489209e-05, 5.4995243788551755e-05, 5.500221373159777e-05]),
    ("simply_supported_sine_foundation", Field::W, 0.5, [-0.00026779308608101715, -1.2706061893532148e-05, -1.5015097323965987e-05, -1.498102175786374e-05]),
    ("simply_supported_sine_foundation", Field::Phi, 0.0, [0.0013119331386936006, 0.00011321509134410622, 0.00014118788668816782, 0.00014119277108502772]),
    ("simply_supported_sine_foundation", Field::M, 0.5, [82431.19021041629, 111.14865601316922, 1.1088870689885404, 1.1089254309517711e-06]),
];

/// The scene of the reference, with this section and these loads.
fn scene(name: &str, (height, point, uniform): (f64, f64, f64)) -> Facts {
    let template = facts_for(name);
    let place = |x: f64| x / template.length;
    let loads = template.loads.iter().map(|load| match *load {
        Load::Force { x, .. } => Load::Force { x: place(x), value: point },
        Load::Moment { x, .. } => Load::Moment { x: place(x), value: point },
        Load::Uniform { .. } => Load::Uniform { value: uniform },
        Load::Sine { half_waves, .. } => Load::Sine { amplitude: uniform, half_waves },
        Load::Foundation { .. } => Load::Foundation { stiffness: FOUNDATION * uniform },
        other => panic!("{name}: {other} has no target"),
    });
    Facts {
        length: 1.0,
        bending_stiffness: 200e9 * 0.05 * height.powi(3) / 12.0,
        shear_stiffness: 5.0 / 6.0 * (200e9 / 2.6) * 0.05 * height,
        interior_supports: template.interior_supports.iter().map(|&x| place(x)).collect(),
        loads: loads.collect(),
        ..template
    }
}

#[test]
fn targets_are_met_for_thick_and_slender_beams() {
    for (name, field, x, values) in TARGETS {
        for (section, expected) in SECTIONS.into_iter().zip(values) {
            let facts = scene(name, section);
            let solution = (find(name).unwrap().build)(&facts).unwrap();
            let found = solution.value(field, x).unwrap();
            let error = (found / expected - 1.0).abs();
            // Measured at most 6e-16.
            assert!(error < 3e-15, "{name}, {field} at {x}, height {}: {error:e}", section.0);
        }
    }
}
