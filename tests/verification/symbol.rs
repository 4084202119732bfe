//! Sines are eigenvectors of the bonds of an infinite lattice: what the discrete equations do to them is known exactly.
//!
//! For `w = W sin kx`, `φ = P cos kx` and `θ_n = k n h` the internal forces are `(aW − bP) sin kx` and
//! `(cP − bW) cos kx` with
//!
//! ```text
//! a = Σ α_n S_n 4 sin²(θ_n/2)/(n h)      b = Σ α_n S_n sin θ_n
//! c = Σ α_n [ 4 EI sin²(θ_n/2)/(n h) + S_n n h cos²(θ_n/2) ]
//! ```

use crate::support::chain::{Body, Calibration};
use crate::support::standard::unit;
use crate::support::{largest, relative, run};
use peristat_assembly::condition::{Equation, Unknown};
use peristat_assembly::stiffness::Override;
use peristat_assembly::system::System;
use serde_json::{Value, json};
use std::f64::consts::PI;

/// a, b, c of the formulas above.
fn symbol(bonds: &Calibration, k: f64) -> [f64; 3] {
    let mut sums = [0.0; 3];
    for (n, alpha) in bonds.numbered() {
        let (xi, s) = (n * bonds.spacing, alpha * bonds.shear_of(n as usize));
        let (sine, cosine) = (0.5 * k * xi).sin_cos();
        sums[0] += s * 4.0 * sine * sine / xi;
        sums[1] += s * (k * xi).sin();
        sums[2] += alpha * 4.0 * bonds.bending * sine * sine / xi + s * xi * cosine * cosine;
    }
    sums
}

/// A ring of `n` points: a chain whose last points are, by constraints, its first ones again.
fn ring(bonds: &Calibration, n: usize) -> System<2> {
    let reach = bonds.weights.len();
    let beyond = |k| n + k;
    let copies = (0..reach).flat_map(|k| {
        (0..2).map(move |component| Equation {
            terms: [(beyond(k), 1.0), (k, -1.0)].map(|(point, c)| (Unknown { component, point }, c)).to_vec(),
            value: 0.0,
            origin: "ring".into(),
        })
    });
    let absent: Vec<Override> = (0..reach)
        .flat_map(|class| (0..reach).map(move |k| Override { class, lower: beyond(k), factor: 0.0 }))
        .collect();
    let body = Body {
        points: n + reach,
        bonds: bonds.bonds(n + reach, &absent),
        spacing: bonds.spacing,
        relations: copies.collect(),
    };
    System::new(&body, Vec::new(), Vec::new()).expect("no contradiction")
}

/// Largest deviation of the ring's operator from a, b, c for one wave number, relative to a, √(ac), c.
fn deviation(bonds: &Calibration, n: usize, k: f64, [a, b, c]: [f64; 3]) -> f64 {
    let system = ring(bonds, n);
    let points = system.points();
    let wave = |f: fn(f64) -> f64, scale: f64| -> Vec<f64> {
        (0..n).map(|j| scale * f(k * j as f64 * bonds.spacing)).collect()
    };
    let image = |plane: usize, f: fn(f64) -> f64| {
        let mut q = vec![0.0; 2 * points];
        q[plane * points..][..n].copy_from_slice(&wave(f, 1.0));
        let mut y = vec![0.0; 2 * points];
        system.product(&q, &mut y);
        [y[..n].to_vec(), y[points..][..n].to_vec()]
    };
    let ([ww, wp], [pw, pp]) = (image(0, f64::sin), image(1, f64::cos));
    let off = |found: &[f64], expected: Vec<f64>, scale: f64| {
        let difference: Vec<f64> = found.iter().zip(&expected).map(|(f, e)| f - e).collect();
        largest(&difference) / scale
    };
    // b vanishes for the shortest wave, so it is compared with what it stands between.
    let mixed = (a * c).sqrt();
    off(&ww, wave(f64::sin, a), a)
        .max(off(&wp, wave(f64::cos, -b), mixed))
        .max(off(&pw, wave(f64::sin, -b), mixed))
        .max(off(&pp, wave(f64::cos, c), c))
}

#[test]
fn the_operator_on_a_ring_has_the_tabulated_symbol() {
    // The sums above for EI = 1, S = 4, h = 1/32, k = π, m = 3 in double precision.
    let table = [
        ("published", [1.22875698275478, 0.389555378642596, 0.430691548342542]),
        ("corrected", [1.22676030257481, 0.388922366977593, 0.430490862117886]),
        ("exact", [1.22676450137673, 0.388924650346998, 0.430491887727568]),
    ];
    for (law, abc) in table {
        let bonds = Calibration::half_edge(law, 3, 1.0 / 32.0, [1.0, 4.0]);
        let deviation = deviation(&bonds, 64, PI, abc);
        // A8, measured 7e-15: the 15 digits of the table.
        assert!(deviation <= 1e-12, "{law}: {deviation:e}");
    }
}

#[test]
fn the_operator_on_a_ring_has_the_symbol_of_every_wave() {
    for law in ["published", "corrected", "exact"] {
        for (m, stiffness) in [(1, [1.0, 4.0]), (2, [3.0, 1e4]), (3, [1.0, 100.0]), (6, [2.0, 0.5])] {
            let bonds = Calibration::half_edge(law, m, 0.01, stiffness);
            for waves in [1, 5, 20, 31] {
                let k = 2.0 * PI * f64::from(waves) / (64.0 * bonds.spacing);
                let deviation = deviation(&bonds, 64, k, symbol(&bonds, k));
                // Measured 9e-14, for the longest wave.
                assert!(deviation <= 1e-12, "{law}, m = {m}, {waves} waves: {deviation:e}");
            }
        }
    }
}

/// Simple supports by images under `sin πx` as nodal forces.
fn sine_case(law: &str, m: u32, cells: usize) -> Value {
    let mut case = unit(4.0, law, cells);
    case["model"]["timoshenko_beam"]["end_treatment"] = json!("image");
    case["horizon_ratio"] = json!(m);
    case["supports"] = json!([{ "at": { "x": 0.0 }, "w": 0.0 }, { "at": { "x": 1.0 }, "w": 0.0 }]);
    case["loads"] = json!([{ "distributed": { "force": { "sine": { "amplitude": 1.0 } } } }]);
    case
}

#[test]
fn a_simply_supported_beam_with_images_bends_as_the_symbol_says() {
    // h c/(ac − b²) and h b/(ac − b²) with the numbers above, 15 digits.
    let table = [
        ("published", 0.0356568769226821, 0.0322512207269516),
        ("corrected", 0.0356982705268559, 0.0322512208552043),
        ("exact", 0.0356982334119764, 0.0322512998352822),
    ];
    for (law, w, phi) in table {
        let [w_error, phi_error] =
            run(&sine_case(law, 3, 32)).errors(|x| (w * (PI * x).sin(), phi * (PI * x).cos()));
        // A11, measured 1.2e-15.
        assert!(w_error <= 1e-12 && phi_error <= 1e-12, "{law}: {w_error:e}, {phi_error:e}");
    }
}

#[test]
fn the_published_law_converges_to_the_nonlocal_continuum_with_the_square_of_the_spacing() {
    // W = c/(ac − b²) with the sums replaced by integrals over the horizon δ = 0.1 (m → ∞).
    let continuum = 0.0356583351285065;
    let error =
        |m: u32| relative(run(&sine_case("published", m, 10 * m as usize)).w(5 * m as usize), continuum);
    let errors = [8, 16, 32].map(error);
    // A12, measured 1.70e-6 and order 2.00.
    assert!(errors[2] <= 2e-6, "{errors:?}");
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() <= 0.02, "order {order}");
    }
}
