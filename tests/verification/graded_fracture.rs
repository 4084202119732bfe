//! Cracks in bodies whose modulus varies: every bond takes the energy of one of the base material, whatever its modulus.

use crate::support::breaking::{growing, imbalance, solve};
use crate::support::mixed::{parameters, plate};
use peristat_assembly::body::SquareLattice;
use peristat_assembly::model::bond_plane::{critical_stretch, crossing_bonds};
use peristat_assembly::model::plane::{CriticalStretch, Edges, ToughMaterials, Toughness};
use peristat_assembly::model::{Breakable, Points};
use serde_json::{Value, json};

/// Energy that a crack between two rows takes of all bonds from one column on, over that of the energy release rate, all points being
/// of one material whose modulus varies.
fn cut(modulus: fn([f64; 2]) -> f64, ratio: f64) -> f64 {
    let lattice = SquareLattice::rectangle(1.0, [0.0; 2], [24, 16]);
    let of = parameters(ratio, Edges::Border);
    let body = plate(lattice, of, modulus);
    let n = body.points();
    let materials = ToughMaterials {
        numbers: vec![0; n],
        moduli: (0..n).map(|p| body.factor(p)).collect(),
        own: vec![Toughness::Energy(1.0)],
        interfaces: vec![None],
        crossing: crossing_bonds(&of).expect("the bonds exist"),
    };
    let stretch = critical_stretch(1.0, &of, 1.0).expect("the bonds exist");
    let critical = CriticalStretch::new(vec![stretch; 64]).of_materials(materials);
    let at = |p: usize| body.position(p);
    let u: Vec<f64> = (0..2 * n).map(|k| if k < n { 0.0 } else { 1e-3 * at(k - n)[1] }).collect();
    let mut energy = 0.0;
    body.for_each_ratio(&u, &critical, &mut |bond, ratio| {
        let ends = body.ends(bond).map(at);
        let is_middle = (ends[0][0].min(ends[1][0]) - 12.5).abs() < 0.25;
        if is_middle && (ends[0][1] < 8.0) != (ends[1][1] < 8.0) {
            // At its critical stretch.
            energy += body.part(&[bond])[0].survey(&u).energy / (ratio * ratio);
        }
    });
    energy
}

#[test]
fn a_cut_takes_its_energy_at_any_modulus() {
    let moduli: [fn([f64; 2]) -> f64; 3] =
        [|_| 1.0, |[x, _]| (x / 8.0).exp(), |[x, y]| 1.0 + x + y * y / 10.0];
    for (modulus, ratio) in
        moduli.into_iter().flat_map(|modulus| [(modulus, 2.0), (modulus, 3.0), (modulus, 4.0)])
    {
        let found = cut(modulus, ratio);
        // 2e-14 at most.
        assert!((found - 1.0).abs() < 1e-12, "{ratio}: {found}");
    }
}

/// Stress over that of the strain 0.01 in the base material at which a bar between smooth walls first breaks, where no bond breaks
/// within four spacings of its ends and eight of its middle.
fn first_break(materials: &Value, critical: &Value) -> f64 {
    let walls = |edge: &str| json!({ "at": { "region": edge }, "uy": 0 });
    let across = |from: f64, to: f64| json!({ "box": { "from": [from, -1], "to": [to, 13] } });
    let case = json!({
        "title": "bar", "units": "mm-N-MPa",
        "model": { "bond_plane": { "youngs_modulus": 1000, "state": "plane_stress" } },
        "body": { "rectangle": { "size": [40, 12], "spacing": 1 } },
        "regions": { "far half": across(20.0, 41.0), "middle": across(12.0, 28.0), "left end": across(-1.0, 4.0),
            "right end": across(36.0, 41.0) },
        "materials": materials,
        "supports": [ { "at": { "region": "left" }, "ux": 0 }, { "at": { "region": "right" }, "ux": 1 },
            walls("bottom"), walls("top") ],
        "probes": [ { "name": "pull", "at": { "region": "right" }, "field": "reaction_x" } ],
        "fracture": { "critical": critical, "strategy": "worst", "load": "pull", "max_solves": 1,
            "no_fail": ["middle", "left end", "right end"] }
    });
    // All strains are along x: M = E/(1 - 1/9).
    solve(&case).0[0].load / (12.0 * 0.01 * 1125.0)
}

#[test]
fn bars_in_series_break_at_the_strength_of_the_weaker_part() {
    // By stretch: the base half breaks at 0.01, the other one, four times as stiff, at 0.002 of its own strain.
    let critical = json!({ "stretch": 0.01 });
    for (other, expected) in [(0.01, 1.0), (0.002, 0.8)] {
        let materials = json!({ "other": { "at": "far half", "youngs_modulus": 4000,
            "critical": { "stretch": other }, "interface": { "stretch": 1 } } });
        let found = first_break(&materials, &critical) / expected;
        assert!((found - 1.0).abs() < 2e-3, "{other}: {found}");
    }
}

#[test]
fn a_graded_bar_breaks_where_it_is_softest() {
    // Bonds break at s √(E₀/E), so that the stress is s √(E₀ E): of the softest bond that can break, from 4.5 to 5.5.
    let rate = json!({ "energy_release_rate": 0.1 });
    let uniform = first_break(&json!({ "same": { "youngs_modulus": 1000 } }), &rate);
    let graded = first_break(&json!({ "graded": { "youngs_modulus": "1000*(1 + x/40)" } }), &rate);
    let found = graded / (uniform * (1.0 + 5.0_f64 / 40.0).sqrt());
    assert!((found - 1.0).abs() < 2e-3, "{found}");
    // By stretch the stress is s E.
    let stretch = json!({ "stretch": 0.01 });
    let found = first_break(&json!({ "graded": { "youngs_modulus": "1000*(1 + x/40)" } }), &stretch)
        / (1.0 + 5.0 / 40.0);
    assert!((found - 1.0).abs() < 2e-3, "{found}");
}

/// The motion at which a long crack in a ribbon of height 20 between grips grows over Griffith's, `G = U²/2 / ∫ dy/M`.
fn along(modulus: &str, compliance: f64) -> f64 {
    let rate = 0.3;
    let griffith = (2.0 * rate * compliance * (1.0 - 1.0 / 9.0)).sqrt();
    let case = json!({
        "title": "ribbon", "units": "mm-N-MPa",
        "model": { "bond_plane": { "youngs_modulus": 3000, "state": "plane_stress" } },
        "body": { "rectangle": { "size": [60, 20], "spacing": 1 } },
        "cracks": [ { "name": "notch", "path": [[-1, 10], [20, 10]] } ],
        "materials": { "graded": { "youngs_modulus": modulus } },
        "supports": [ { "at": { "region": "bottom" }, "ux": 0, "uy": 0 },
            { "at": { "region": "top" }, "ux": 0, "uy": 2.0 * griffith } ],
        "probes": [ { "name": "pull", "at": { "region": "top" }, "field": "reaction_y" } ],
        "fracture": { "critical": { "energy_release_rate": rate }, "strategy": "worst", "load": "pull", "max_solves": 160 }
    });
    2.0 * growing(&solve(&case).0)
}

#[test]
fn cracks_in_graded_ribbons_grow_at_their_energy() {
    // E = 3000 e^{|y − 10|/5}, stiff at the grips, and 3000 (1 + y/20), of which the crack turns to the softer side.
    let soft = along("3000*exp(abs(y - 10)/5)", 2.0 * 5.0 * (1.0 - (-2.0_f64).exp()) / 3000.0);
    let tilted = along("3000*(1 + y/20)", 20.0 * 2.0_f64.ln() / 3000.0);
    assert!((soft - 1.0).abs() < 0.06 && (tilted - 1.0).abs() < 0.06, "{soft} {tilted}");
}

#[test]
fn energies_of_graded_bodies_balance_on_any_border() {
    for (strategy, most) in [("worst", 1e-11), ("batch", 1e-7)] {
        let case = json!({
            "title": "graded", "units": "mm-N-MPa",
            "model": { "bond_plane": { "youngs_modulus": 3000, "state": "plane_strain" } },
            "body": { "outline": { "vertices": [[0, 0], [30, 3], [28, 31], [1, 29]], "spacing": 1.0,
                "holes": [ { "circle": { "centre": [9, 16], "radius": 4 } } ] } },
            "regions": { "core": { "disc": { "centre": [20, 15], "radius": 5 } } },
            "materials": {
                "core": { "at": "core", "youngs_modulus": "9000*(1 + x/30)", "interface": { "energy_release_rate": 0.05 } },
                "rest": { "youngs_modulus": "3000*exp(y/15)", "critical": { "energy_release_rate": 0.2 } } },
            "supports": [ { "at": { "region": "edge_1" }, "ux": 0, "uy": 0 },
                { "at": { "region": "edge_3" }, "ux": 0, "uy": 0.6 } ],
            "probes": [ { "name": "pull", "at": { "region": "edge_3" }, "field": "reaction_y" } ],
            "fracture": { "critical": { "energy_release_rate": 0.3 }, "strategy": strategy, "load": "pull", "max_solves": 80 }
        });
        let (events, _) = solve(&case);
        assert!(
            imbalance(&events) < most && events.len() > 30,
            "{strategy}: {} {:e}",
            events.len(),
            imbalance(&events)
        );
    }
}
