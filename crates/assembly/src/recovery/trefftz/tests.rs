//! Fits against the fields that they are made of, and against one that they are not.

use super::*;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;

fn isotropic(e: f64, nu: f64) -> [[f64; 3]; 3] {
    let c = e / (1.0 - nu * nu);
    [[c, nu * c, 0.0], [nu * c, c, 0.0], [0.0, 0.0, 0.5 * (1.0 - nu) * c]]
}

const ORTHOTROPIC: [[f64; 3]; 3] = [[140.6, 2.5, 0.4], [2.5, 10.0, -0.2], [0.4, -0.2, 2.93]];

/// Points of a lattice around a place between them, above a border.
fn points(radius: f64, border: f64) -> Vec<[f64; 2]> {
    let steps = -6..6;
    let all =
        steps.clone().flat_map(|j| steps.clone().map(move |i| [f64::from(i) + 0.5, f64::from(j) + 0.5]));
    let near = all.filter(|[x, y]| x.hypot(*y) <= radius && *y > border);
    near.map(|at| at.map(|x| x / radius)).collect()
}

#[test]
fn there_are_as_many_fields_as_equilibrium_leaves() {
    for degree in 1..=6 {
        for stiffness in [isotropic(70.0, 0.3), isotropic(1.0, 0.499), ORTHOTROPIC] {
            let count = Basis::new(&stiffness, degree).count();
            assert_eq!(count, 4 * degree as usize + 2);
        }
    }
}

/// By differences of the displacements: stresses and their divergence.
#[test]
fn stresses_are_those_of_the_displacements_and_in_equilibrium() {
    let h = 1e-4;
    let stiffness = ORTHOTROPIC;
    let basis = Basis::new(&stiffness, 4);
    let at = [0.3, -0.4];
    let moved = |k: usize, by: f64| [0, 1].map(|c| at[c] + if c == k { by } else { 0.0 });
    let slope = |k: usize| (basis.displacements(moved(k, h)) - basis.displacements(moved(k, -h))) / (2.0 * h);
    let (by_x, by_y) = (slope(0), slope(1));
    let (rotation, stress) = (basis.rotations(at), basis.stresses(at));
    let turn = |k: usize| (basis.stresses(moved(k, h)) - basis.stresses(moved(k, -h))) / (2.0 * h);
    let (along, across) = (turn(0), turn(1));
    for k in 0..basis.count() {
        let strain = [by_x[(k, 0)], by_y[(k, 1)], by_y[(k, 0)] + by_x[(k, 1)]];
        // Found: 6e-9, the differences.
        assert!((rotation[k] - 0.5 * (by_x[(k, 1)] - by_y[(k, 0)])).abs() < 5e-8, "{k}");
        for r in 0..3 {
            let expected: f64 = (0..3).map(|c| stiffness[r][c] * strain[c]).sum::<f64>() / stiffness[0][0];
            // Found: 7e-9, the differences.
            assert!((stress[(k, r)] - expected).abs() < 5e-8, "{k} {r}");
        }
        // Found: 2e-9.
        assert!((along[(k, 0)] + across[(k, 2)]).abs() < 5e-8);
        assert!((along[(k, 2)] + across[(k, 1)]).abs() < 5e-8);
    }
}

/// Fields of the basis come back, with a border whose tractions or displacements are known.
#[test]
fn fits_reproduce_their_fields() {
    for (degree, radius) in [(4, 3.2), (5, 4.0)] {
        for stiffness in [isotropic(70e9, 0.3), ORTHOTROPIC] {
            let basis = Basis::new(&stiffness, degree);
            for held in [[false; 2], [true, false], [true; 2]] {
                let mut known: Vec<Known> =
                    points(radius, -1.0).into_iter().map(Known::Displacement).collect();
                let sample = |k: i32| Known::Border {
                    at: [f64::from(k) / (3.0 * radius), -1.0 / radius],
                    normal: [0.0, -1.0],
                    held,
                };
                known.extend((-8..=8).map(sample));
                let fit = LocalFit::new(&basis, radius, &known).unwrap();
                let given = |field: usize| -> Vec<f64> {
                    let of = |one: &Known| match *one {
                        Known::Displacement(at) => basis.displacements(at).row(field).transpose(),
                        Known::Border { at, normal: [x, y], held } => {
                            let (s, u) = (basis.stresses(at), basis.displacements(at));
                            let unit = basis.unit() / radius;
                            let t = [
                                s[(field, 0)] * x + s[(field, 2)] * y,
                                s[(field, 2)] * x + s[(field, 1)] * y,
                            ];
                            nalgebra::Vector2::from_fn(
                                |c, _| if held[c] { u[(field, c)] } else { unit * t[c] },
                            )
                        }
                    };
                    known.iter().flat_map(|one| [of(one)[0], of(one)[1]]).collect()
                };
                for field in 0..basis.count() {
                    let found = fit.coefficients(&given(field));
                    for (k, c) in found.iter().enumerate() {
                        let expected = if k == field { 1.0 } else { 0.0 };
                        // Worst found: 2e-13.
                        assert!((c - expected).abs() < 1e-12, "{degree} {field} {k}: {c}");
                    }
                }
            }
        }
    }
}

/// Where less is known than there are fields, or points in a row see some of them alone, a fit still meets what is known.
#[test]
fn fits_of_few_points_meet_them() {
    let basis = Basis::new(&isotropic(70e9, 0.3), 4);
    let square = vec![[-0.2, -0.2], [0.2, -0.2], [-0.2, 0.2], [0.2, 0.2]];
    let row: Vec<[f64; 2]> = (0..12).map(|k| [f64::from(k) / 12.0 - 0.5, 0.1]).collect();
    for points in [square, row] {
        let known: Vec<Known> = points.iter().map(|at| Known::Displacement(*at)).collect();
        let fit = LocalFit::new(&basis, 3.2, &known).unwrap();
        // A polynomial of degree four along the row, and any four values.
        let given: Vec<f64> = points.iter().flat_map(|[x, y]| [1.0 + x - x.powi(4), y + x * x * x]).collect();
        let coefficients = fit.coefficients(&given);
        let matrix = DMatrix::from_fn(given.len(), basis.count(), |r, field| {
            basis.displacements(points[r / 2])[(field, r % 2)]
        });
        let given = DVector::from_vec(given);
        // Worst found: 2e-14.
        assert!((&matrix * &coefficients - &given).amax() < 3e-13);
        // Of the many that meet them it is the smallest; worst found: 1.2e-13.
        let smallest = matrix.svd(true, true).solve(&given, 1e-8).unwrap();
        assert!((coefficients - smallest).amax() < 1e-12);
    }
}

/// `2G u = κ φ − z conj(φ')` of φ = e^z by Kolosov, which no polynomial is.
fn exponential(e: f64, nu: f64, [x, y]: [f64; 2]) -> [f64; 2] {
    let (kappa, twice_shear) = ((3.0 - nu) / (1.0 + nu), e / (1.0 + nu));
    let (c, s, size) = (y.cos(), y.sin(), x.exp());
    let conj = [size * c, -size * s];
    let u = [kappa * size * c - (x * conj[0] - y * conj[1]), kappa * size * s - (x * conj[1] + y * conj[0])];
    u.map(|u| u / twice_shear)
}

/// The fit of that field at points around a place, with the places and the values it was made of.
fn of_exponential(basis: &Basis, spacing: f64) -> (LocalFit, Vec<Known>, Vec<f64>) {
    let all = points(3.2, -9.0);
    let known: Vec<Known> = all.iter().map(|at| Known::Displacement(*at)).collect();
    let fit = LocalFit::new(basis, 3.2 * spacing, &known).unwrap();
    let values = all.iter().flat_map(|at| exponential(1.0, 0.3, at.map(|x| 0.2 + 3.2 * spacing * x)));
    (fit, known, values.collect())
}

#[test]
fn fits_are_of_the_fifth_order() {
    let basis = Basis::new(&isotropic(1.0, 0.3), 4);
    let misses = |spacing: f64| {
        let (fit, _, values) = of_exponential(&basis, spacing);
        let found = basis.displacements([0.1, 0.2]).tr_mul(&fit.coefficients(&values));
        let expected = exponential(1.0, 0.3, [0.1, 0.2].map(|x| 0.2 + 3.2 * spacing * x));
        (found[0] - expected[0]).hypot(found[1] - expected[1])
    };
    let order = (misses(0.08 * PI) / misses(0.04 * PI)).log2();
    // Found: 5.0.
    assert!(order > 4.7, "{order}");
}

/// Relative to displacements that are linear in the radius it is the fourth; a rigid motion counts for nothing.
#[test]
fn misfits_are_of_the_fourth_order_and_of_what_strains() {
    let basis = Basis::new(&isotropic(1.0, 0.3), 4);
    let misfit = |spacing: f64, [shift, turn]: [f64; 2]| {
        let (fit, known, mut values) = of_exponential(&basis, spacing);
        for (one, u) in known.iter().zip(values.chunks_exact_mut(2)) {
            let Known::Displacement([x, y]) = one else { continue };
            u[0] += shift - turn * y;
            u[1] += turn * x;
        }
        fit.missed(&basis, 3.2 * spacing, &known, &values) / fit.strained(&basis, &known, &values)
    };
    let [coarse, fine] = [0.04, 0.02].map(|spacing| misfit(spacing * PI, [0.0; 2]));
    // Found: 2.0e-4 and an order of 3.9.
    assert!((coarse / fine).log2() > 3.7 && (1e-4..4e-4).contains(&coarse), "{coarse} {fine}");
    let moved = misfit(0.04 * PI, [30.0, -5.0]);
    assert!((moved / coarse - 1.0).abs() < 1e-9, "{moved} {coarse}");
    // Of a rigid motion alone rounding is left, which strains nothing.
    let (fit, known, _) = of_exponential(&basis, 0.1);
    let rigid = known.iter().flat_map(|one| match one {
        Known::Displacement([x, y]) => [0.1 - 0.3 * y, 0.7 + 0.3 * x],
        Known::Border { .. } => unreachable!(),
    });
    assert_eq!(fit.strained(&basis, &known, &rigid.collect::<Vec<f64>>()), 0.0);
}
