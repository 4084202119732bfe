//! Bodies whose bonds end on the border and soften: uniform stresses, their strength, and what they take to part.

use peristat::summary::Summary;
use peristat_assembly::body::SquareLattice;
use peristat_assembly::law::{Bilinear, Compression, History, Law, Unloading};
use peristat_assembly::model::bond_plane::{
    BondPlane, Influence, PlaneMaterial, PlaneParameters, PlaneState, VolumeFactor, Weights,
};
use peristat_assembly::model::plane::SofteningModel;
use peristat_assembly::model::plane::{Calibration, Edges, Mirrors};
use peristat_assembly::stiffness::HistoryBond;
use serde_json::{Value, json};
use std::sync::Arc;

/// Stretch at which bonds yield.
const YIELD: f64 = 0.01;
const YOUNGS: f64 = 7e4;

fn solve(case: &Value) -> Summary {
    peristat::solve_text(&format!("{case:#}")).unwrap_or_else(|error| panic!("{error}: {case}")).summary
}

/// Facts of a path by their names.
fn facts<const N: usize>(case: &Value, names: [&str; N]) -> [f64; N] {
    let mut case = case.clone();
    let check = |name| json!({ "limit": { "probe": name, "at_most": 1e99, "why": "found" } });
    case["checks"] = names.iter().map(check).collect();
    let summary = solve(&case);
    std::array::from_fn(|k| summary.checks[k].found)
}

/// A bar between held edges, one of them moved; free to contract.
fn bar(size: [u32; 2], brittleness: f64, moved: f64, path: &Value) -> Value {
    let law = json!({ "bilinear": { "yield_stretch": YIELD, "failure_stretch": brittleness * YIELD, "unloading": "damage" } });
    let mut followed = json!({ "load": "F", "record_every": 100_000 });
    path.as_object().expect("keys").iter().for_each(|(key, value)| followed[key] = value.clone());
    json!({
        "title": "bar", "units": "mm-N-MPa",
        "model": { "bond_plane": { "youngs_modulus": YOUNGS, "state": "plane_stress", "bond_law": law } },
        "body": { "rectangle": { "size": size, "spacing": 1 } },
        "horizon_ratio": 3,
        "supports": [ { "at": { "region": "left" }, "ux": 0 },
            { "at": { "x": 0.5, "y": f64::from(size[1] / 2) + 0.5 }, "uy": 0 },
            { "at": { "region": "right" }, "ux": moved } ],
        "probes": [ { "name": "F", "at": { "region": "right" }, "field": "reaction_x" } ],
        "path": followed
    })
}

#[test]
fn a_strip_that_does_not_yield_yet_has_one_stress() {
    for m in [2.0, 3.0, 4.0] {
        for kinematics in ["linear", "finite"] {
            // A stretch of a hundredth, or a millionth, at which large rotations make no difference.
            let moved = if kinematics == "linear" { 0.4 } else { 4e-5 };
            let mut case = bar([40, 20], 10.0, moved, &json!({ "increment": 1 }));
            case["horizon_ratio"] = json!(m);
            let law = &mut case["model"]["bond_plane"]["bond_law"]["bilinear"];
            (law["yield_stretch"], law["failure_stretch"]) = (json!(0.02), json!(0.2));
            law["kinematics"] = json!(kinematics);
            let places = [(0.5, 0.5), (39.5, 19.5), (20.5, 0.5), (20.5, 10.5)];
            let probe = |(x, y)| json!({ "name": format!("{x}, {y}"), "at": { "x": x, "y": y }, "field": "stress_xx" });
            case["probes"].as_array_mut().expect("a list").extend(places.map(probe));
            let found: Vec<f64> = solve(&case).probes.iter().map(|probe| probe.value).collect();
            let stress = YOUNGS * moved / 40.0;
            // 8e-15 for linear kinematics, whose tolerance is that of residuals, and 7e-7.
            let near = if kinematics == "linear" { 1e-9 } else { 1e-5 };
            assert!((found[0] / (20.0 * stress) - 1.0).abs() < near, "{m} {kinematics}: {}", found[0]);
            found[1..].iter().for_each(|s| assert!((s / stress - 1.0).abs() < near, "{m} {kinematics}: {s}"));
        }
    }
}

#[test]
fn the_first_bonds_yield_at_the_nominal_stretch() {
    for m in [2.0, 3.0] {
        let mut case = bar([40, 20], 10.0, 0.8, &json!({ "control": "event", "max_steps": 3 }));
        case["horizon_ratio"] = json!(m);
        let [load, load_factor] = facts(&case, ["first_yield_load", "first_yield_load_factor"]);
        // Measured: 5e-14.
        assert!((load / (20.0 * YOUNGS * YIELD) - 1.0).abs() < 1e-6, "{m}: {load}");
        assert!((load_factor - 0.5).abs() < 1e-6, "{m}: {load_factor}");
    }
}

/// Bonds of an inner point to half of its neighbours, with a volume of one.
fn family() -> Vec<HistoryBond<2>> {
    let parameters = PlaneParameters {
        material: PlaneMaterial { youngs_modulus: 1.0, thickness: 1.0, state: PlaneState::Stress },
        horizon_ratio: 3.0,
        influence: Influence::Constant,
        calibration: Calibration::Matched,
        weights: Weights::Nearest,
        volume_factor: VolumeFactor::Full,
        edges: Edges::None,
    };
    let lattice = Arc::new(SquareLattice::rectangle(1.0, [0.0; 2], [9, 9]));
    let middle = lattice.number([4, 4, 0]).expect("a point") as u32;
    let plane = BondPlane::on_lattice(lattice, Mirrors::NONE, parameters, &[]).expect("bonds");
    plane.history_bonds(&|_| Some(0)).into_iter().filter(|bond| bond.points[0] == middle).collect()
}

/// Strength of a material point in uniaxial stress, per E s_y.
fn strength(brittleness: f64) -> f64 {
    let law = Bilinear::new([1.0, brittleness], Unloading::Damage, Compression::Elastic).expect("a law");
    let bonds = family();
    let stress = |strain: [f64; 2]| {
        let mut sum = [0.0; 2];
        for bond in &bonds {
            let n = bond.direction.map(|n| n * n);
            let force = law.response(n[0] * strain[0] + n[1] * strain[1], &History::default()).force;
            (0..2).for_each(|c| sum[c] += bond.stiffness * bond.length * bond.length * force * n[c]);
        }
        sum
    };
    let uniaxial = |strain: f64| {
        let [mut low, mut high] = [-2.0 * strain, 0.5 * strain];
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if stress([strain, middle])[1] > 0.0 { high = middle } else { low = middle }
        }
        stress([strain, low])[0]
    };
    (450..2500).map(|k| uniaxial(0.002 * f64::from(k))).fold(0.0, f64::max)
}

#[test]
fn bars_are_as_strong_as_their_material() {
    // Where bonds soften late the load is flat before its peak, and a bar fails in one place a little earlier: −0.2 and −0.6 %
    // are found.
    for (size, brittleness, expected) in [([14, 10], 5.0, 1.0984), ([30, 10], 10.0, 1.2320)] {
        let strength = strength(brittleness);
        assert!((strength - expected).abs() < 1e-4, "{strength}");
        let moved = 0.3 * YIELD * brittleness * f64::from(size[0]);
        let [peak] = facts(
            &bar(size, brittleness, moved, &json!({ "increment": 0.005, "stop_below": 0.9 })),
            ["peak_load"],
        );
        let found = peak / (YOUNGS * YIELD * f64::from(size[1])) / strength - 1.0;
        assert!((-0.01..0.003).contains(&found), "{brittleness}: {found}");
    }
}

/// A bar with a short crack that is pulled far beyond what its bonds bear.
fn parted(brittleness: f64, unloading: &str, path: &Value) -> Value {
    let mut case = bar([14, 10], brittleness, 1.0, path);
    case["cracks"] = json!([{ "path": [[7, -1], [7, 1]] }]);
    case["model"]["bond_plane"]["bond_law"]["bilinear"]["unloading"] = json!(unloading);
    case
}

#[test]
fn bars_part_with_the_work_that_is_done_on_them() {
    for unloading in ["damage", "plastic"] {
        let names = ["peak_load", "end_load", "energy_balance", "work_identity"];
        let case = parted(5.0, unloading, &json!({ "control": "displacement", "increment": 0.005 }));
        let [peak, end, balance, identity] = facts(&case, names);
        // 1.2 % are left: a place on the border between two cells that have come apart moves with the mean of both.
        assert!(end.abs() < 0.02 * peak, "{unloading}: {end} of {peak}");
        // Measured: 2.5e-12, and 4.4e-3 and 1.2e-3 for steps of this size.
        assert!(identity < 1e-9, "{unloading}: {identity:e}");
        assert!(balance < 1e-2, "{unloading}: {balance:e}");
    }
}

#[test]
fn a_bar_that_snaps_back_is_traced_without_loss() {
    let case = parted(3.0, "damage", &json!({ "control": "event", "stop_below": 0.4 }));
    let [backs, balance, identity] = facts(&case, ["snap_back_steps", "energy_balance", "work_identity"]);
    // Measured: 60, 6e-15 and 8e-14.
    assert!(backs > 30.0 && balance < 1e-12 && identity < 1e-11, "{backs} {balance:e} {identity:e}");
}
