//! Solids of state-based families of several materials: layers in series, a sphere in a body that is pulled, uniform strains.

use crate::support::mixed::Stiffness;
use nalgebra::SymmetricEigen;
use peristat_assembly::body::SquareLattice;
use peristat_assembly::model::bond_plane::{Influence, VolumeFactor};
use peristat_assembly::model::plane::{Calibration, Mirrors};
use peristat_assembly::model::solid::{SolidEdges, SolidModel, TENSOR};
use peristat_assembly::model::state_solid::{StateSolid, StateSolidParameters};
use peristat_assembly::model::{BodyModel, Points};
use serde_json::{Value, json};
use std::sync::Arc;

fn solid(cells: [i32; 3], poisson_ratio: f64, factors: Vec<f64>) -> StateSolid {
    let parameters = StateSolidParameters {
        youngs_modulus: 1.0,
        poisson_ratio,
        horizon_ratio: 2.0,
        influence: Influence::Constant,
        calibration: Calibration::Matched,
        volume_factor: VolumeFactor::Full,
        edges: SolidEdges::Border,
    };
    let lattice = Arc::new(SquareLattice::cuboid(1.0, [0.0; 3], cells));
    StateSolid::mixed(lattice, Mirrors::NONE, parameters, &[], factors).expect("the bonds exist")
}

/// Numbers of some values that look like chance.
fn chosen(count: usize, values: &[f64]) -> Vec<f64> {
    let mut state = 3_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize
    };
    (0..count).map(|_| values[next() % values.len()]).collect()
}

#[test]
fn uniform_strains_of_families_have_the_stress_of_every_point() {
    let cells = [10, 8, 9];
    for nu in [-0.3, 0.1, 0.3, 0.45] {
        let lattice = SquareLattice::cuboid(1.0, [0.0; 3], cells);
        let modulus = |[x, _, z]: [f64; 3]| if x > 5.0 && z > 4.0 { 25.0 } else { 1.0 };
        let factors: Vec<f64> = (0..lattice.points()).map(|p| modulus(lattice.position(p))).collect();
        let block = solid(cells, nu, factors.clone());
        let strain: [f64; TENSOR] = [1.0, -0.25, 0.5, 0.3, -0.2, 0.4];
        let n = block.points();
        let u: Vec<f64> = (0..3 * n)
            .map(|k| {
                let [x, y, z] = block.position(k % n);
                match k / n {
                    0 => strain[0] * x + strain[5] * y + strain[4] * z,
                    1 => strain[1] * y + strain[3] * z,
                    _ => strain[2] * z,
                }
            })
            .collect();
        let (fields, c) = (block.fields(&u), SolidModel::stiffness(&block));
        for (p, factor) in factors.iter().enumerate() {
            let stress: [f64; TENSOR] =
                std::array::from_fn(|q| factor * (0..TENSOR).map(|k| c[q][k] * strain[k]).sum::<f64>());
            let worst = (0..TENSOR).map(|q| (fields.stress[q][p] - stress[q]).abs()).fold(0.0, f64::max);
            assert!(worst <= 1e-12 * factor, "{nu} {p}: {worst}");
            let energy: f64 = (0..TENSOR).map(|q| 0.5 * stress[q] * strain[q]).sum();
            assert!((fields.energy_density[p] / energy - 1.0).abs() <= 1e-11);
            let told = block.strains_at(p, stress, 0.0);
            assert!((0..TENSOR).all(|q| (told[q] - strain[q]).abs() <= 1e-13));
        }
    }
}

#[test]
fn families_of_several_materials_in_space_are_definite() {
    for nu in [-0.5, 0.1, 0.25, 0.45] {
        let cells = [5, 6, 5];
        let body = solid(cells, nu, chosen(150, &[1.0, 1e-6, 1e-2, 1e2, 1e4]));
        let eigenvalues = SymmetricEigen::new(Stiffness::of(&body).dense()).eigenvalues;
        assert!(eigenvalues.min() >= -1e-13 * eigenvalues.max(), "{nu}: {}", eigenvalues.min());
        let u: Vec<f64> = (0..450).map(|k| (0.7 * f64::from(k)).sin()).collect();
        let of = |factors: Vec<f64>| Stiffness::of(&solid(cells, nu, factors)).forces(&u);
        let plain = of(Vec::new());
        assert!(plain == of(vec![1.0; 150]));
        let worst =
            of(vec![3.0; 150]).iter().zip(&plain).map(|(a, b)| (a - 3.0 * b).abs()).fold(0.0, f64::max);
        assert!(worst <= 1e-12, "{worst}");
    }
}

fn probes(case: &Value) -> Vec<f64> {
    let summary = peristat::solve_text(&format!("{case:#}")).unwrap_or_else(|e| panic!("{e}")).summary;
    summary.probes.iter().map(|probe| probe.value).collect()
}

/// Shortening of a column of two halves, ten layers each, between smooth walls under a pressure.
fn shortening(nu: f64, moduli: [f64; 2]) -> f64 {
    let mut case = json!({
        "title": "column", "units": "none",
        "model": { "state_solid": { "youngs_modulus": moduli[0], "poisson_ratio": nu } },
        "body": { "block": { "size": [4, 20, 4], "spacing": 1 } },
        "symmetry": ["left", "right", "back", "front"],
        "regions": { "lower half": { "box": { "from": [0, 0, 0], "to": [4, 10, 4] } } },
        "materials": { "other": { "at": "lower half", "youngs_modulus": moduli[1] } },
        "supports": [{ "at": { "region": "bottom" }, "uy": 0 }],
        "loads": [{ "traction": { "face": "top", "pressure": 1 } }],
        "probes": [{ "name": "end", "at": { "region": "top" }, "field": "uy", "of": "mean" }]
    });
    if moduli[0] == moduli[1] {
        case.as_object_mut().expect("an object").remove("materials");
    }
    probes(&case)[0]
}

#[test]
fn layers_of_families_of_solids_hardly_jump() {
    // Both orders of the layers have the ends of both materials, and twice the jump.
    let jump = |nu: f64, contrast: f64| {
        let of = |moduli: [f64; 2]| shortening(nu, moduli);
        let soft = of([1.0; 2]);
        let both = of([1.0, contrast]) + of([contrast, 1.0]) - soft - of([contrast; 2]);
        0.5 * both / (soft / 19.5)
    };
    // Measured -0.16, -0.16; -0.08, -0.07; 0.03, 0.08; 0.53, 0.73: what families feel of volumes beside the interface is softer.
    let cases = [(0.1, 0.2), (0.2, 0.1), (0.3, 0.1), (0.45, 0.8)];
    let found = cases.map(|(nu, most)| (nu, most, [10.0, 100.0].map(|contrast| jump(nu, contrast))));
    assert!(found.iter().all(|(_, most, jumps)| jumps.iter().all(|jump| jump.abs() <= *most)), "{found:?}");
}

/// A sphere of radius 1 that is ten times as stiff in a body that is pulled along x by a stress of 1, ν = 0.3 in both: an eighth of
/// both, with Goodier's displacements at two and a half radii. The errors of the stresses of its core along x, relative, and across,
/// over that along x.
fn sphere(per_radius: f64) -> [f64; 2] {
    let (nu, ratio, h) = (0.3, 10.0, 1.0 / per_radius);
    // Eshelby's parts of a sphere, and the strains inside.
    let (alpha, beta) = ((1.0 + nu) / (3.0 * (1.0 - nu)), 2.0 * (4.0 - 5.0 * nu) / (15.0 * (1.0 - nu)));
    let (mean, rest) = ((1.0 - 2.0 * nu) / 3.0, (1.0 + nu) / 3.0);
    let (mean_in, rest_in) = (mean / (1.0 + alpha * (ratio - 1.0)), rest / (1.0 + beta * (ratio - 1.0)));
    // Beyond those of the body without it: u_r = -A/r² - 3B/r⁴ + (k C/r² - 9B/r⁴) cos 2θ, u_θ = -(2C/r² + 6B/r⁴) sin 2θ.
    let (along, across) = (mean_in + 2.0 * rest_in - mean - 2.0 * rest, mean_in - rest_in - mean + rest);
    let (sum, half) = (0.5 * (along + across), 0.5 * (along - across));
    let k = (5.0 - 4.0 * nu) / (1.0 - 2.0 * nu);
    // k C - 9B = half, 2C + 6B = half.
    let c = 2.5 * half / (k + 3.0);
    let b = (half - 2.0 * c) / 6.0;
    let a = -sum - 3.0 * b;
    let (free, side) = (mean + 2.0 * rest, mean - rest);
    let r = "sqrt(x^2 + y^2 + z^2)";
    let radial =
        format!("(-({a})/{r}^2 - 3*({b})/{r}^4 + ({k}*({c})/{r}^2 - 9*({b})/{r}^4)*(2*x^2/{r}^2 - 1))/{r}");
    let turning = format!("(-(2*({c})/{r}^2 + 6*({b})/{r}^4))*2*x/{r}^3");
    let far = 2.5;
    let beyond = [far + 1.0; 3];
    let frame = |from: [f64; 3]| json!({ "box": { "from": from, "to": beyond } });
    let inner = far - 4.0 * h;
    let core = 2.0 * h;
    let probe = |name: &str, field: &str| json!({ "name": name, "at": { "x": core, "y": core, "z": core }, "field": field });
    let case = json!({
        "title": "sphere", "units": "none",
        "model": { "state_solid": { "youngs_modulus": 1, "poisson_ratio": nu } },
        "body": { "block": { "size": [far, far, far], "spacing": h } },
        "symmetry": ["left", "bottom", "back"],
        "regions": {
            "ball": { "ball": { "centre": [0, 0, 0], "radius": 1 } },
            "a": frame([inner, 0.0, 0.0]), "b": frame([0.0, inner, 0.0]), "c": frame([0.0, 0.0, inner])
        },
        "materials": { "stiff": { "at": "ball", "youngs_modulus": ratio } },
        "supports": [{
            "at": { "region": ["a", "b", "c"] },
            "ux": format!("{free}*x + x*{radial} - {turning}*(y^2 + z^2)"),
            "uy": format!("({side})*y + y*{radial} + {turning}*x*y"),
            "uz": format!("({side})*z + z*{radial} + {turning}*x*z")
        }],
        "probes": [probe("along", "stress_xx"), probe("across", "stress_yy")]
    });
    let found = probes(&case);
    let lame = ratio * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
    let exact = |deviator: f64| 3.0 * lame * mean_in + ratio / (1.0 + nu) * (mean_in + deviator * rest_in);
    [found[0] / exact(2.0) - 1.0, (found[1] - exact(-1.0)) / exact(2.0)]
}

#[test]
fn a_sphere_of_families_has_the_stress_of_eshelby() {
    let [x, y] = sphere(8.0);
    // Measured 0.0026, 0.0061.
    assert!(x.abs() <= 0.005 && y.abs() <= 0.01, "{x} {y}");
}
