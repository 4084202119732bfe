//! A scene for every reference, and the tests that hold for all of them.

mod consistency;
mod targets;

use super::{BondClass, End, Facts, Load, TABLE, find};

/// The bond laws of the beam: how the shear stiffness of a bond follows from its length.
#[derive(Clone, Copy)]
pub(super) enum Law {
    /// That of the beam.
    Published,
    /// In series with the bending of the mean bond.
    Mean,
    /// In series with the bending of the bond itself.
    Corrected,
}

impl Law {
    /// Bonds of 1..=m spacings, those of the horizon with half weight.
    pub(super) fn bonds(self, m: u32, spacing: f64, bending: f64, shear: f64) -> Vec<BondClass> {
        let weight = |n: u32| 2.0 / f64::from(m * m) * if n == m { 0.5 } else { 1.0 };
        let squared = |n: u32| (f64::from(n) * spacing).powi(2);
        let mean: f64 = (1..=m).map(|n| weight(n) * f64::from(n) * squared(n)).sum();
        let length_squared = |n| match self {
            Self::Published => 0.0,
            Self::Mean => mean,
            Self::Corrected => squared(n),
        };
        (1..=m)
            .map(|n| BondClass {
                weight: weight(n),
                shear_stiffness: 1.0 / (1.0 / shear + length_squared(n) / (12.0 * bending)),
            })
            .collect()
    }
}

/// Unit length, EI = 1, S = 4, image ends, lumped sine load of one half wave.
pub(super) fn sine_facts(law: Law, m: u32, spacing: f64) -> Facts {
    let sine = Load::Sine { amplitude: 1.0, half_waves: 1 };
    Facts {
        length: 1.0,
        bending_stiffness: 1.0,
        shear_stiffness: 4.0,
        spacing,
        horizon: f64::from(m) * spacing,
        bonds: law.bonds(m, spacing, 1.0, 4.0),
        image_ends: true,
        lumped_loads: true,
        published_law: matches!(law, Law::Published),
        ..facts(End::Simple, End::Simple, sine)
    }
}

/// A beam whose numbers are all different, so that no symbol can stand in for another.
fn facts(left: End, right: End, load: Load) -> Facts {
    Facts {
        length: 1.7,
        bending_stiffness: 3.1,
        shear_stiffness: 7.3,
        ends: [left, right],
        interior_supports: vec![],
        loads: vec![load],
        spacing: 0.1,
        horizon: 0.3,
        uniform_grid: true,
        bonds: vec![],
        image_ends: false,
        lumped_loads: false,
        published_law: false,
    }
}

/// The scene with a foundation under it.
fn on_foundation(mut facts: Facts) -> Facts {
    facts.loads.push(Load::Foundation { stiffness: 8.9 });
    facts
}

/// A scene that the reference accepts. A new reference adds a line here.
pub(super) fn facts_for(name: &str) -> Facts {
    use End::{Clamped, Free, Guided, Simple};
    const LENGTH: f64 = 1.7;
    let tip = Load::Force { x: LENGTH, value: 2.3 };
    let middle = Load::Force { x: LENGTH / 2.0, value: -2.3 };
    let moment = Load::Moment { x: LENGTH, value: 1.9 };
    let uniform = Load::Uniform { value: 5.9 };
    let moments = Load::UniformMoment { value: -4.7 };
    let sine = Load::Sine { amplitude: 6.1, half_waves: 3 };
    match name {
        "cantilever_tip_force" => facts(Clamped, Free, tip),
        "cantilever_end_moment" => facts(Clamped, Free, moment),
        "cantilever_uniform" => facts(Clamped, Free, uniform),
        "cantilever_uniform_moment" => facts(Clamped, Free, moments),
        "simply_supported_uniform" => facts(Simple, Simple, uniform),
        "simply_supported_mid_force" => facts(Simple, Simple, middle),
        "simply_supported_uniform_moment" => facts(Simple, Simple, moments),
        "simply_supported_sine" => facts(Simple, Simple, sine),
        "simply_supported_sine_discrete" => sine_facts(Law::Corrected, 4, 0.05),
        "simply_supported_sine_nonlocal" => sine_facts(Law::Published, 4, 0.05),
        "clamped_clamped_uniform" => facts(Clamped, Clamped, uniform),
        "clamped_clamped_mid_force" => facts(Clamped, Clamped, middle),
        "clamped_simply_supported_uniform" => facts(Clamped, Simple, uniform),
        "clamped_guided_uniform" => facts(Clamped, Guided, uniform),
        "clamped_guided_tip_force" => facts(Clamped, Guided, tip),
        "two_span_uniform" => {
            Facts { interior_supports: vec![LENGTH / 2.0], ..facts(Simple, Simple, uniform) }
        }
        "simply_supported_sine_foundation" => on_foundation(facts(Simple, Simple, sine)),
        "free_free_foundation_mid_force" => on_foundation(facts(Free, Free, middle)),
        other => panic!("`{other}` has no scene to be tested with: add one in reference/tests"),
    }
}

#[test]
fn every_reference_is_found_under_the_name_of_its_file() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/src/reference/");
    for reference in TABLE {
        let found = find(reference.name).expect("a reference is found by its name");
        assert_eq!(found.about, reference.about, "two references are named {}", reference.name);
        let file = format!("{folder}{}.rs", reference.name);
        assert!(std::path::Path::new(&file).exists(), "{file}");
        assert!(!reference.about.contains('\n') && !reference.source.is_empty(), "{}", reference.name);
    }
    assert!(find("cantilever").is_none());
}

#[test]
fn every_reference_accepts_its_scene_and_no_other_ends_or_loads() {
    for reference in TABLE {
        let scene = facts_for(reference.name);
        assert!((reference.build)(&scene).is_ok(), "{}", reference.name);
        let wrong = [
            Facts { ends: [End::Other, scene.ends[1]], ..scene.clone() },
            Facts { ends: [scene.ends[0], End::Other], ..scene.clone() },
            Facts { interior_supports: vec![0.3 * scene.length], ..scene.clone() },
            Facts { loads: vec![Load::Other], ..scene.clone() },
            Facts { loads: vec![], ..scene.clone() },
            Facts { loads: vec![scene.loads[0]; 2], ..scene.clone() },
            Facts { loads: [scene.loads[..1].to_vec(), scene.loads.clone()].concat(), ..scene.clone() },
            on_foundation(scene.clone()),
        ];
        for facts in &wrong {
            let message = (reference.build)(facts).expect_err(reference.name);
            assert!(message.starts_with("it needs ") && message.contains(", the scene has "), "{message}");
        }
    }
}

#[test]
fn only_the_answers_of_a_grid_need_a_uniform_one() {
    for reference in TABLE {
        let graded = Facts { uniform_grid: false, ..facts_for(reference.name) };
        let found = (reference.build)(&graded).map(|_| ());
        if ["simply_supported_sine_discrete", "simply_supported_sine_nonlocal"].contains(&reference.name) {
            assert_eq!(found, Err("it needs a uniform grid, the scene has a graded one".to_owned()));
        } else {
            assert_eq!(found, Ok(()), "{}", reference.name);
        }
    }
}
