//! Uniform strains: exact energies, strains and solutions, at free faces and corners too.

use super::super::super::plane::PlaneModel;
use super::*;
use crate::model::BodyModel;
use crate::model::Points;

/// Unknowns of a body under the stresses of a linear displacement, held as little as it takes: the largest error, relative
/// to the largest displacement.
fn traction(model: &StateBased, motion: [f64; 4], hold: &[(usize, usize)]) -> f64 {
    let exact = linear(model, motion);
    let points = real_points(model);
    let [a, b, c, d] = motion;
    let hoop = if model.parameters.is_axisymmetric() { a } else { 0.0 };
    let parameters = model.parameters();
    let (lame, shear) = (parameters.lame(), parameters.shear_modulus());
    let pressure = lame * (a + d + hoop);
    let stress = [pressure + 2.0 * shear * a, pressure + 2.0 * shear * d, shear * (b + c)];
    let mut force = vec![0.0; 2 * model.points()];
    model.add_stress_load(None, &|_, _| stress, &mut force);
    let n = model.points();
    let equations = hold.iter().map(|&(c, k)| held(c, points[k], exact[c * n + points[k]]));
    let u = solve(model, equations.collect(), &force);
    let off = points.iter().flat_map(|&p| [u[p] - exact[p], u[n + p] - exact[n + p]]);
    largest(off) / largest(exact.iter().copied())
}

/// Energy of a linear displacement over the exact one.
fn energy_ratio(model: &StateBased, motion: [f64; 4]) -> f64 {
    let u = linear(model, motion);
    let [a, b, c, d] = motion;
    let hoop = if model.parameters.is_axisymmetric() { a } else { 0.0 };
    let parameters = model.parameters();
    let (lame, shear) = (parameters.lame(), parameters.shear_modulus());
    let density =
        0.5 * lame * (a + d + hoop).powi(2) + shear * (a * a + d * d + hoop * hoop + 0.5 * (b + c).powi(2));
    let volume: f64 = (0..model.points()).map(|p| model.volume(p)).sum();
    let energy: f64 = model.terms().iter().map(|t| t.survey(&u).energy).sum();
    energy / (density * volume)
}

#[test]
fn plates_of_any_poisson_ratio_pass_everywhere() {
    let lattice = || SquareLattice::plane(0.1, [0.3, -0.2], 0..9, 0..8, |c| c != [4, 4] && c != [5, 4]);
    for geometry in [Geometry::PlaneStress(0.5), Geometry::PlaneStrain(0.5)] {
        for nu in [-0.5, 0.0, 0.25, 1.0 / 3.0, 0.45, 0.4999] {
            let dilatation = if nu > 0.45 { Dilatation::Blocks } else { Dilatation::Points };
            let parameters = StateParameters { geometry, poisson_ratio: nu, dilatation, ..RING };
            for edges in [StateEdges::Ghosts, StateEdges::MomentPlus] {
                let model: StateBased =
                    body(lattice(), Mirrors::NONE, StateParameters { edges, ..parameters });
                for motion in [[1e-3, 0.0, 0.0, 0.0], [0.0, 1e-3, 1e-3, 0.0], [-3e-4, 0.0, 0.0, 1e-3]] {
                    let ratio = energy_ratio(&model, motion);
                    assert!((ratio - 1.0).abs() < 1e-11, "{nu} {edges:?} {ratio}");
                    let error = traction(&model, motion, &[(0, 0), (1, 0), (1, 8)]);
                    assert!(error < 1e-11, "{geometry:?} {nu} {edges:?}: {error:e}");
                }
            }
        }
    }
}

#[test]
fn rings_pass_with_free_faces_and_corners() {
    let motions =
        [[0.0, 0.0, 0.0, 1e-3], [1e-3, 0.0, 0.0, 0.0], [-3e-4, 0.0, 0.0, 1e-3], [1e-3, 0.0, 0.0, 1e-3]];
    for radius in [0.0, 1.0] {
        for edges in [StateEdges::Ghosts, StateEdges::MomentPlus] {
            let parameters = StateParameters { edges, youngs_modulus: 210.0, ..RING };
            let model: StateBased = body(cells(1.0 / 12.0, radius, [12, 18]), Mirrors::NONE, parameters);
            for motion in motions {
                let ratio = energy_ratio(&model, motion);
                assert!((ratio - 1.0).abs() < 1e-12, "{radius} {edges:?} {ratio}");
                let error = traction(&model, motion, &[(1, 0)]);
                assert!(error < 1e-11, "{radius} {edges:?} {motion:?}: {error:e}");
            }
        }
    }
}

#[test]
fn the_table_of_the_axis_keeps_uniform_stresses_exact() {
    let parameters = StateParameters { axis: Axis::Table, influence: Influence::Linear, ..RING };
    let model: StateBased = body(cells(0.1, 0.0, [10, 12]), Mirrors::NONE, parameters);
    for motion in [[-3e-4, 0.0, 0.0, 1e-3], [1e-3, 0.0, 0.0, 1e-3]] {
        let error = traction(&model, motion, &[(1, 0)]);
        assert!(error < 1e-8, "{motion:?}: {error:e}");
    }
}

#[test]
fn plain_treatments_have_wrong_energies() {
    // Axial strain of a hollow block, corners and free faces: −0.13 and +0.055 (an independent Python implementation).
    for (edges, expected) in [(StateEdges::None, -0.13), (StateEdges::Calibrated, 0.055)] {
        let model: StateBased =
            body(cells(1.0 / 12.0, 1.0, [12, 18]), Mirrors::NONE, StateParameters { edges, ..RING });
        let off = energy_ratio(&model, [0.0, 0.0, 0.0, 1e-3]) - 1.0;
        assert!((off - expected).abs() < 5e-3, "{edges:?} {off}");
    }
    let moment = StateParameters { edges: StateEdges::Moment, ..RING };
    let lattice = Arc::new(cells(1.0 / 12.0, 1.0, [12, 18]));
    let error = StateBased::on_lattice(lattice, Mirrors::NONE, moment, &|_, _| false, &|_| Vec::new());
    assert_eq!(error.err(), Some(super::super::StateError::NegativeWeights(4)));
}

#[test]
fn a_third_in_plane_stress_has_one_hop() {
    let size = [24, 20];
    let entries = |nu: f64| {
        let parameters = StateParameters { poisson_ratio: nu, ..PLATE };
        let model: StateBased = body(cells(0.1, 0.0, size), Mirrors::NONE, parameters);
        let system = System::new(&model, Vec::new(), Vec::new()).unwrap();
        let middle = real_points(&model)[10 * 24 + 12];
        let row = system.assemble_sparse().outer_view(model.points() + middle).map_or(0, |r| r.nnz());
        (parameters.has_families(), row)
    };
    // Of 29 and 105 points the upper half comes later; the row of u_y has all of u_x.
    assert!(!entries(1.0 / 3.0).0);
    assert!(entries(0.3).0);
    let (one, two) = (entries(1.0 / 3.0).1, entries(0.3).1);
    assert!(one <= 29 + 15 && two > 105, "{one} {two}");
}

#[test]
fn strains_of_stresses_follow_hookes_law() {
    let StateParameters { youngs_modulus: e, poisson_ratio: nu, .. } = RING;
    let stress @ [x, y, xy] = [2.0, -0.7, 0.4];
    let follows = |strain: [f64; 3], across: f64| {
        let exact = [(x - nu * (y + across)) / e, (y - nu * (x + across)) / e, 2.0 * (1.0 + nu) / e * xy];
        (0..3).for_each(|k| assert!((strain[k] - exact[k]).abs() < 1e-14, "{strain:?} {exact:?}"));
    };
    for (geometry, across) in [(Geometry::PlaneStress(0.5), 0.0), (Geometry::PlaneStrain(0.5), nu * (x + y))]
    {
        let parameters = StateParameters { geometry, ..RING };
        let model: StateBased = body(cells(0.1, 0.0, [8, 8]), Mirrors::NONE, parameters);
        assert!((model.stress_across(stress) - across).abs() < 1e-15);
        follows(model.strain_of(stress), across);
        follows(model.strain_with(stress, f64::NAN), across);
    }
    let ring: StateBased = body(cells(0.1, 1.0, [8, 8]), Mirrors::NONE, RING);
    follows(ring.strain_with(stress, 1.1), 1.1);
}

#[test]
fn strains_and_stresses_are_those_of_the_motion() {
    for dilatation in [Dilatation::Points, Dilatation::Blocks] {
        let parameters = StateParameters { dilatation, ..RING };
        let model: StateBased = body(cells(0.1, 1.0, [10, 9]), Mirrors::NONE, parameters);
        let fields = model.fields(&linear(&model, [1e-3, 0.0, 0.0, -2e-3]));
        let shear = parameters.shear_modulus();
        // ϑ + h = 0.
        let expected = [2e-3 * shear, -4e-3 * shear, 0.0];
        for p in 0..model.points() {
            for k in 0..3 {
                assert!((fields.stress[k][p] - expected[k]).abs() < 1e-15, "{p} {k}");
            }
            assert!((fields.across[p] - 2e-3 * shear).abs() < 1e-15);
        }
        let parameters = StateParameters { dilatation, ..PLATE };
        let model: StateBased = body(cells(0.1, 1.0, [10, 9]), Mirrors::NONE, parameters);
        let [a, b, c, d] = [1e-3, 4e-4, -1e-4, 5e-4];
        let fields = model.fields(&linear(&model, [a, b, c, d]));
        let (lame, shear) = (parameters.lame(), parameters.shear_modulus());
        let (pressure, turn) = (lame * (a + d), b + c);
        let expected = [pressure + 2.0 * shear * a, pressure + 2.0 * shear * d, shear * turn];
        let density = 0.5 * (expected[0] * a + expected[1] * d + expected[2] * turn);
        for p in 0..model.points() {
            for k in 0..3 {
                assert!((fields.stress[k][p] - expected[k]).abs() < 1e-15, "{p} {k}");
            }
            assert!((fields.energy_density[p] / density - 1.0).abs() < 1e-11, "{p}");
        }
    }
}

#[test]
fn forces_on_ghosts_go_where_their_displacements_come_from() {
    let model: StateBased = body(cells(0.1, 1.0, [10, 9]), Mirrors::NONE, PLATE);
    let n = model.points();
    let force: Vec<f64> = (0..2 * n).map(|k| (k * 7919 % 1013) as f64 / 1013.0 - 0.5).collect();
    let mut folded = force.clone();
    model.fold(&mut folded);
    assert!(!model.ghosts().is_empty());
    model.ghosts().iter().for_each(|&g| assert_eq!([folded[g as usize], folded[n + g as usize]], [0.0; 2]));
    // Ghosts continue a linear displacement.
    for motion in [[1.0, 0.3, 0.0, 0.0], [0.0, 0.0, -0.4, 1.0]] {
        let u = linear(&model, motion);
        let work = |f: &[f64]| f.iter().zip(&u).map(|(f, u)| f * u).sum::<f64>();
        assert!((work(&folded) - work(&force)).abs() < 1e-12, "{} {}", work(&folded), work(&force));
    }
}
