//! Borders of bodies of revolution that are completed.

use crate::model::Points;
use super::super::BorderedState;
use super::*;
use crate::body::{Hole, Outline, Shape};
use crate::model::plane::through_border::{Side, through_border};
use std::f64::consts::{PI, TAU};

/// Above 0.45 with means over blocks.
const RATIOS: [f64; 5] = [-0.5, 0.0, 0.3, 0.45, 0.49];

fn ring(lattice: &SquareLattice, mirrors: Mirrors, m: f64, nu: f64) -> BorderedState {
    let dilatation = if nu > 0.45 { Dilatation::Blocks } else { Dilatation::Points };
    let parameters = StateParameters {
        horizon_ratio: m,
        poisson_ratio: nu,
        influence: Influence::Linear,
        edges: StateEdges::Border,
        dilatation,
        ..RING
    };
    BorderedState::on_lattice(lattice, mirrors, parameters).unwrap()
}

fn polygon(vertices: &[[f64; 2]]) -> Outline {
    Outline::polygon(vertices.to_vec()).unwrap()
}

/// Bodies with the volumes of their sections by Pappus, and whether all of their border is straight.
fn outlines() -> Vec<(&'static str, Outline, f64)> {
    let pierced = |mut outline: Outline, centre: [f64; 2], radius: f64| {
        outline.cut(Hole { name: None, shape: Shape::Circle { centre, radius } }).unwrap();
        outline
    };
    let torus = pierced(Outline::rectangle([2.0, 0.0], [13.0, 12.0]).unwrap(), [8.4, 5.7], 3.2);
    let frustum = |a: f64, b: f64, height: f64| PI / 3.0 * height * (a * a + a * b + b * b);
    vec![
        ("solid cylinder", Outline::rectangle([0.0, 0.0], [9.0, 13.0]).unwrap(), PI * 81.0 * 13.0),
        ("hollow cylinder", Outline::rectangle([4.0, 0.0], [9.0, 13.0]).unwrap(), PI * (169.0 - 16.0) * 13.0),
        ("frustum", polygon(&[[0.0, 0.0], [13.3, 0.0], [7.1, 12.2], [0.0, 12.2]]), frustum(13.3, 7.1, 12.2)),
        (
            "slanted sleeve",
            polygon(&[[3.3, 0.2], [14.3, 0.0], [12.1, 12.2], [5.2, 11.3]]),
            TAU * moment(&[[3.3, 0.2], [14.3, 0.0], [12.1, 12.2], [5.2, 11.3]]),
        ),
        ("torus", torus, PI * (225.0 - 4.0) * 12.0 - TAU * 8.4 * PI * 3.2 * 3.2),
    ]
}

/// `∫ x dA` of a polygon.
fn moment(vertices: &[[f64; 2]]) -> f64 {
    let side = |k: usize| {
        let ([a, b], [c, d]) = (vertices[k], vertices[(k + 1) % vertices.len()]);
        (a * d - c * b) * (a + c) / 6.0
    };
    (0..vertices.len()).map(side).sum()
}

fn filled(outline: &Outline, spacing: f64) -> SquareLattice {
    let lattice = outline.fill(spacing).unwrap();
    if lattice.blocks().is_empty() { lattice } else { outline.with_centres(lattice) }
}

/// Displacements with `ε_rr = ε_θθ = a` and `ε_zz = b`.
fn uniform(ring: &BorderedState, [a, b]: [f64; 2]) -> Vec<f64> {
    let n = ring.points();
    (0..2 * n).map(|k| [a, b][k / n] * ring.place(k % n)[k / n]).collect()
}

fn density(ring: &BorderedState, [a, b]: [f64; 2]) -> f64 {
    let (lame, shear) = (ring.parameters().lame(), ring.parameters().shear_modulus());
    0.5 * lame * (2.0 * a + b).powi(2) + shear * (2.0 * a * a + b * b)
}

fn force(ring: &BorderedState, u: &[f64]) -> Vec<f64> {
    let mut force = vec![0.0; u.len()];
    ring.terms().iter().for_each(|t| t.add_force(u, &mut force));
    folded(ring, force)
}

/// Forces on images act on what they are images of.
fn folded(ring: &BorderedState, mut force: Vec<f64>) -> Vec<f64> {
    let (n, (lattice, mirrors)) = (ring.points(), ring.lattice().unwrap());
    for &ghost in ring.ghosts() {
        let (cell, signs) = mirrors.image(lattice.cell(ghost as usize));
        let real = lattice.number(cell).unwrap();
        for k in 0..2 {
            let own = std::mem::take(&mut force[k * n + ghost as usize]);
            force[k * n + real] += signs[k] * own;
        }
    }
    force
}

#[test]
fn uniform_strains_have_the_energy_of_the_true_body() {
    for m in [2.0, 3.0, 4.0] {
        for (name, outline, volume) in outlines() {
            let lattice = filled(&outline, 1.0);
            for nu in RATIOS {
                let ring = ring(&lattice, Mirrors::NONE, m, nu);
                for strain in [[1.0, 0.0], [0.0, 1.0], [0.3, -0.7]] {
                    let u = uniform(&ring, strain);
                    let energy: f64 = ring.terms().iter().map(|t| t.survey(&u).energy).sum();
                    let off = energy / (volume * density(&ring, strain)) - 1.0;
                    println!("{name} {m} {nu} {strain:?}: energy {off:e}");
                }
            }
        }
    }
}

#[test]
fn tractions_hold_uniform_stresses() {
    for m in [2.0, 3.0, 4.0] {
        for (name, outline, _) in outlines().into_iter().take(4) {
            let sides: Vec<Side> = outline.edges().iter().map(|e| ([e.from, e.to], e.normal)).collect();
            let lattice = filled(&outline, 1.0);
            for nu in RATIOS {
                let ring = ring(&lattice, Mirrors::NONE, m, nu);
                for strain in [[1.0, 0.0], [0.0, 1.0], [0.3, -0.7]] {
                    let u = uniform(&ring, strain);
                    let (lame, shear) = (ring.parameters().lame(), ring.parameters().shear_modulus());
                    let of = |e: f64| lame * (2.0 * strain[0] + strain[1]) + 2.0 * shear * e;
                    let stress = [of(strain[0]), of(strain[1]), 0.0];
                    let internal = force(&ring, &u);
                    let load = folded(&ring, through_border(&ring, &sides, stress));
                    let size = largest(internal.iter().copied());
                    let n = ring.points();
                    let mut most = [0.0_f64; 2];
                    for k in 0..2 * n {
                        most[k / n] = most[k / n].max((internal[k] - load[k]).abs());
                    }
                    let left = ring.dilatations.as_ref().unwrap().left;
                    let mut through_volume = vec![0.0; u.len()];
                    ring.add_stress_load(None, &|_| stress, &mut through_volume);
                    let through = folded(&ring, through_volume);
                    let off = largest(internal.iter().zip(&through).map(|(a, b)| a - b)) / size;
                    let fields = ring.fields(&u);
                    let real = real_points(&ring);
                    let s = (0..3).map(|k| largest(real.iter().map(|&p| fields.stress[k][p] - stress[k]))).fold(0.0, f64::max);
                    let s = s.max(largest(real.iter().map(|&p| fields.across[p] - stress[0])));
                    println!("{name} {m} {nu} {strain:?}: r {:.2e} z {:.2e} left {left:.1e} volume {off:.1e} fields {s:.1e} size {size:.1e} per 2 pi {:.4}", most[0] / size, most[1] / size, most[1] / TAU);
                }
            }
        }
    }
}

#[test]
fn one_motion_costs_nothing_and_none_less() {
    for m in [2.0, 3.0] {
        for (name, outline, _) in outlines() {
            let lattice = filled(&outline, 1.0);
            for nu in RATIOS {
                let ring = ring(&lattice, Mirrors::NONE, m, nu);
                let system = System::new(&ring, Vec::new(), Vec::new()).unwrap();
                let (all, n) = (stiffness(&system), ring.points());
                // Images are no unknowns of their own.
                let real: Vec<usize> = [0, n].iter().flat_map(|k| real_points(&ring).into_iter().map(move |p| k + p)).collect();
                let values = all.select_rows(&real).select_columns(&real).symmetric_eigenvalues();
                let (least, most) = (values.min(), values.max());
                let zero = values.iter().filter(|v| **v < 1e-9 * most).count();
                println!("{name} {m} {nu}: {zero} {:e}", least / most);
            }
        }
    }
}
