//! Cases with materials of regions in models of families: liners of tubes, mirrors, joined sides, solvers, and what is refused.

use crate::support::plane::{PlaneRun, refusal, solve};
use peristat::case::FieldName;
use serde_json::{Value, json};

/// A tube of radii 20 and 40, ν = 0.2, with a liner up to 25 that is seven times as stiff, ν = 0.3, under an internal pressure of 1 in
/// plane strain: the widening of its inside and of its outside over Lamé's.
fn tube(points: i32) -> [f64; 2] {
    let h = 20.0 / f64::from(points);
    let probe = |name: &str, x: f64| json!({ "name": name, "at": { "x": x, "y": 0.5 * h }, "field": "ux" });
    let (inside, outside) = (20.0 + 0.5 * h, 40.0 - 0.5 * h);
    let case = json!({
        "title": "tube", "units": "none",
        "model": { "axisymmetric": { "youngs_modulus": 1, "poisson_ratio": 0.2 } },
        "body": { "rectangle": { "from": [20, 0], "size": [20, h], "spacing": h } },
        "regions": { "inside": { "box": { "from": [20, 0], "to": [25, h] } } },
        "materials": { "liner": { "at": "inside", "youngs_modulus": 7, "poisson_ratio": 0.3 } },
        "periodic": [{ "along": "y" }],
        "supports": [{ "at": { "x": inside, "y": 0.5 * h }, "uy": 0 }],
        "loads": [{ "traction": { "edge": "left", "pressure": 1 } }],
        "probes": [probe("inside", inside), probe("outside", outside)]
    });
    // u = A r + B/r in both layers: σ_r = 2 μ (A/(1 − 2ν) − B/r²).
    let row = |[e, nu]: [f64; 2], r: f64| {
        let shear = e / (2.0 * (1.0 + nu));
        [2.0 * shear / (1.0 - 2.0 * nu), -2.0 * shear / (r * r)]
    };
    let (steel, concrete) = ([7.0, 0.3], [1.0, 0.2]);
    let ([a, b], [c, d]) = (row(steel, 20.0), row(concrete, 40.0));
    let ([e, f], [g, h]) = (row(steel, 25.0), row(concrete, 25.0));
    let rows = [a, b, 0.0, 0.0, 0.0, 0.0, c, d, e, f, -g, -h, 25.0, 0.04, -25.0, -0.04];
    let of = nalgebra::Matrix4::from_row_slice(&rows).lu();
    let of = of.solve(&nalgebra::Vector4::new(-1.0, 0.0, 0.0, 0.0)).expect("two layers");
    let exact = [of[0] * inside + of[1] / inside, of[2] * outside + of[3] / outside];
    let found = peristat::solve_text(&format!("{case:#}")).unwrap_or_else(|e| panic!("{e}")).summary.probes;
    [found[0].value / exact[0] - 1.0, found[1].value / exact[1] - 1.0]
}

#[test]
fn tubes_with_liners_widen_as_lame_has_it() {
    let errors = [20, 40, 80].map(tube);
    // -0.009 at 40 points through the wall.
    assert!(errors[1].iter().all(|e| e.abs() <= 0.012), "{errors:?}");
    // Both fall with the spacing.
    for side in 0..2 {
        let orders = [0, 1].map(|k| (errors[k][side] / errors[k + 1][side]).log2());
        assert!(orders.iter().all(|order| *order >= 0.8), "{errors:?}");
    }
}

/// A plate with a disc of another material around its middle, of which a quarter has a small hole: the whole of it or a quarter with mirrors.
fn disc(model: &Value, is_quarter: bool, other: [f64; 2]) -> Value {
    let n = 24.0;
    let (from, size) = if is_quarter { (0.0, n) } else { (-n, 2.0 * n) };
    let pull = |edge: &str, x: i32| json!({ "traction": { "edge": edge, "uniform": [x, 0] } });
    let mut case = json!({
        "title": "families of two materials", "units": "none", "solver": "sparse", "model": { "state_plane": model },
        "body": { "rectangle": { "from": [from, from], "size": [size, size], "spacing": 1 } },
        "regions": { "disc": { "disc": { "centre": [0, 0], "radius": 8.2 } } },
        "materials": { "other": { "at": "disc", "youngs_modulus": other[0], "poisson_ratio": other[1] } },
        "loads": [pull("right", 1)]
    });
    if is_quarter {
        case["symmetry"] = json!(["left", "bottom"]);
    } else {
        case["loads"] = json!([pull("right", 1), pull("left", -1)]);
        case["supports"] = json!([
            { "at": { "x": -0.5, "y": 0.5 - n }, "ux": 0 },
            { "at": { "x": 0.5 - n, "y": -0.5 }, "uy": 0 },
            { "at": { "x": n - 0.5, "y": -0.5 }, "uy": 0 }
        ]);
    }
    case
}

/// Plane strain with ν = 0.3.
fn strain() -> Value {
    json!({ "youngs_modulus": 1, "poisson_ratio": 0.3, "state": "plane_strain" })
}

/// A field at the points of the upper right quarter in and around the disc, in the order of rows. Ghosts near a line of symmetry are fits
/// of points on one side of it, so that edges of the whole and of its quarter differ.
fn upper_right(run: &PlaneRun, field: FieldName) -> Vec<f64> {
    let values = run.field(0, field);
    let all = run.positions().into_iter().zip(values);
    all.filter(|([x, y], _)| *x > 0.0 && *y > 0.0 && x.hypot(*y) < 13.0).map(|(_, value)| value).collect()
}

#[test]
fn a_quarter_of_families_with_mirrors_is_the_whole() {
    let blocks =
        json!({ "youngs_modulus": 1, "poisson_ratio": 0.3, "state": "plane_strain", "dilatation": "blocks" });
    for (model, other) in [(strain(), [10.0, 0.1]), (strain(), [1e-6, 0.3]), (blocks, [10.0, 0.48])] {
        let [quarter, whole] = [true, false].map(|is_quarter| solve(&disc(&model, is_quarter, other)));
        for field in [FieldName::StressXx, FieldName::StressZz, FieldName::StrainXx, FieldName::EnergyDensity]
        {
            let [a, b] = [&quarter, &whole].map(|run| upper_right(run, field));
            let size = b.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
            let worst = a.iter().zip(&b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            // Measured 1e-5 at most.
            assert!(a.len() == b.len() && worst <= 2e-4 * size, "{other:?} {field:?}: {worst} of {size}");
        }
    }
}

#[test]
fn families_like_the_base_change_no_bit() {
    let mut case = disc(&strain(), true, [1.0, 0.3]);
    case["loads"] = json!([]);
    case["horizon_ratio"] = json!(3);
    case["supports"] = json!([{ "at": { "region": "right" }, "ux": 1, "uy": 0.5 }]);
    let own = solve(&case);
    case.as_object_mut().unwrap().remove("materials");
    case["model"]["state_plane"]["edges"] = json!("ghosts");
    assert!(own.states[0].record.u == solve(&case).states[0].record.u);
}

/// A cycle for a stiff inclusion in a fine grid gives up at once; its zeros were taken for a motion that nothing resists.
#[test]
fn a_cycle_that_breaks_down_is_no_mechanism() {
    let solved = peristat::solve_text(&format!(
        "{:#}",
        json!({
            "title": "stiff inclusion", "units": "none", "solver": "multigrid", "model": { "state_plane": strain() },
            "horizon_ratio": 3,
            "body": { "rectangle": { "size": [16, 8], "spacing": 0.0625 } },
            "regions": { "box": { "box": { "from": [4, 2], "to": [10, 6] } } },
            "materials": { "stiff": { "at": "box", "youngs_modulus": 1e4 } },
            "supports": [{ "at": { "region": "left" }, "ux": 0, "uy": 0 }],
            "loads": [{ "traction": { "edge": "right", "uniform": [0.3, 1] } }]
        })
    ));
    let summary = solved.unwrap_or_else(|error| panic!("{error}")).summary;
    assert!(!summary.states[0].certificate.converged && summary.states[0].certificate.digits == 0);
}

#[test]
fn coarser_families_precondition_mixtures() {
    let square = |modulus: f64, solver: &str| {
        let mut case = disc(&strain(), true, [modulus, 0.3]);
        case["body"]["rectangle"]["size"] = json!([64, 64]);
        case["regions"] = json!({ "disc": { "disc": { "centre": [30, 30], "radius": 14 } } });
        case["solver"] = json!(solver);
        solve(&case).report.solver
    };
    // 67 at 1e4.
    for (modulus, most) in [(10.0, 20), (100.0, 25), (0.01, 25), (1e4, 90)] {
        let solver = square(modulus, "multigrid");
        assert!(solver.method == "multigrid" && solver.iterations[0] <= most, "{modulus}: {solver:?}");
    }
    let solver = square(1e4, "auto");
    assert!(solver.method.contains("cholesky") && solver.reason.contains("differ by"), "{solver:?}");
}

#[test]
fn what_families_of_several_materials_do_not_know_is_refused() {
    let mut case = disc(&strain(), true, [10.0, 0.6]);
    assert!(refusal(&case).contains("Poisson's ratio must lie between -1 and 1/2"), "{}", refusal(&case));
    case["materials"]["other"]["poisson_ratio"] = json!(0.2);
    for edges in ["border", "moment", "moment_plus", "calibrated", "none"] {
        let mut case = case.clone();
        case["model"]["state_plane"]["edges"] = json!(edges);
        assert!(refusal(&case).contains("families of several materials need the edges `ghosts`"), "{edges}");
    }
    case["thermal_expansion"] = json!(1e-5);
    case["loads"] = json!([{ "temperature": { "change": 100 } }]);
    assert!(refusal(&case).contains("other Poisson's ratios have no `temperature`"));
}
