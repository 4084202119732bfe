//! Borders that cut cells: uniform stresses are in equilibrium, wherever the border runs.

use super::super::*;
use super::bodies::*;
use super::mirrors::compare;
use super::patch::{STRAINS, check_rigid};
use crate::body::{Crack, Hole, Outline, Polygon, Shape, cut_bonds};
use crate::model::Breakable;
use crate::model::Points;
use crate::model::plane::through_border::{Side, through_border};
use crate::model::plane::{CriticalStretch, Edges, Mirrors, PlaneModel};

fn bordered(m: f64) -> PlaneParameters {
    PlaneParameters { edges: Edges::Border, ..parameters(m, [1.0, 1.0, 1.0]) }
}

fn pierced(mut outline: Outline, holes: Vec<Shape>) -> Outline {
    holes.into_iter().for_each(|shape| outline.cut(Hole { name: None, shape }).unwrap());
    outline
}

/// Rows that run along x, and turned ones.
fn filled(outline: &Outline) -> Vec<Arc<SquareLattice>> {
    [0.0, 0.3].map(|angle| Arc::new(outline.fill_turned(1.0, angle).unwrap())).to_vec()
}

fn outlines() -> Vec<(&'static str, Outline)> {
    let rectangle = || Outline::rectangle([0.3, -2.0], [19.0, 16.0]).unwrap();
    let circle = Shape::Circle { centre: [9.4, 5.7], radius: 3.7 };
    let window = Polygon::new(vec![[6.0, 3.0], [12.4, 4.1], [8.2, 9.0]]).unwrap();
    let oblique = Outline::polygon(vec![[0.0, 3.1], [18.4, 0.0], [20.0, 14.2], [2.2, 17.5]]).unwrap();
    let angle = [[0.1, 0.0], [17.0, 2.0], [16.2, 9.0], [9.3, 8.1], [8.4, 18.0], [-0.7, 17.0]];
    vec![
        ("hole", pierced(rectangle(), vec![circle])),
        ("ellipse", pierced(rectangle(), vec![Shape::ellipse([9.4, 5.7], [5.2, 2.6], 0.0).unwrap()])),
        ("window", pierced(rectangle(), vec![Shape::Polygon(window)])),
        ("quadrilateral", oblique),
        ("L", Outline::polygon(angle.to_vec()).unwrap()),
    ]
}

fn energy_of(plane: &BondPlane, g: [[f64; 2]; 2]) -> f64 {
    let strain = [g[0][0], g[1][1], g[0][1] + g[1][0]];
    let c = plane.stiffness();
    (0..3).map(|a| (0..3).map(|b| 0.5 * strain[a] * c[a][b] * strain[b]).sum::<f64>()).sum()
}

#[test]
fn every_uniform_strain_has_the_energy_of_the_true_area() {
    for m in [2.0, 3.0, 4.0] {
        for (name, outline) in outlines() {
            let holes: f64 = outline
                .holes()
                .iter()
                .map(|hole| match &hole.shape {
                    Shape::Polygon(polygon) | Shape::Ellipse { chords: polygon, .. } => polygon.area().abs(),
                    Shape::Circle { radius, .. } => std::f64::consts::PI * radius * radius,
                    Shape::Slot { .. } => unreachable!(),
                })
                .sum();
            let area = outline.border().area().abs() - holes;
            for lattice in filled(&outline) {
                let plane = plane(&lattice, bordered(m));
                assert_eq!(
                    (plane.uncorrected(), BodyModel::edges(&plane)),
                    (0, Some(Edges::Border)),
                    "{name}"
                );
                check_rigid(name, &plane);
                for g in STRAINS {
                    let found = energy(&plane, &linear(&plane, g)) / energy_of(&plane, g);
                    // 1e-6 of a cell is not seen, and corners are sampled.
                    assert!((found / area - 1.0).abs() < 2e-4, "{name} {m}: {found} {area}");
                }
            }
        }
    }
}

/// The load of a uniform stress is that of its tractions on the true border, which knows no bonds.
#[test]
fn tractions_on_the_true_border_hold_every_uniform_stress() {
    for m in [2.0, 3.0, 4.0] {
        for (name, outline) in outlines().into_iter().skip(1) {
            let mut sides: Vec<Side> = outline.edges().iter().map(|e| ([e.from, e.to], e.normal)).collect();
            let shape = outline.holes().first().map(|h| &h.shape);
            if let Some(Shape::Polygon(hole) | Shape::Ellipse { chords: hole, .. }) = shape {
                let count = hole.vertices().len();
                sides.extend((0..count).map(|k| (hole.edge(k), hole.normal(k).map(|x| -x))));
            }
            for lattice in filled(&outline) {
                let plane = plane(&lattice, bordered(m));
                for stress in [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.7, -1.3, 0.4]] {
                    let strain = plane.strain_of(stress);
                    let u = linear(&plane, [[strain[0], 0.5 * strain[2]], [0.5 * strain[2], strain[1]]]);
                    let (internal, load) = (force(&plane, &u), through_border(&plane, &sides, stress));
                    let off = difference(&internal, &load) / largest(&load);
                    assert!(off < 1e-12, "{name} {m} {stress:?}: {off:e}");
                }
            }
        }
    }
}

/// Three rigid motions cost nothing, and all else something.
#[test]
fn only_rigid_motions_cost_nothing() {
    for m in [2.0, 3.0] {
        for (name, outline) in outlines() {
            let values = matrix(&plane(&filled(&outline)[1], bordered(m))).symmetric_eigenvalues();
            let most = values.max();
            // Rounding makes 1e-15 of the largest.
            assert_eq!(values.iter().filter(|v| **v < 1e-9 * most).count(), 3, "{name} {m}");
            assert!(values.min() > -1e-13 * most, "{name} {m}: {}", values.min());
        }
    }
}

/// A quarter with its images is the whole body: the hole is cut by both lines of symmetry.
#[test]
fn a_quarter_is_the_whole_body() {
    let body = |from: [f64; 2], size: [f64; 2]| {
        let hole = Shape::Circle { centre: [0.0; 2], radius: 3.7 };
        pierced(Outline::rectangle(from, size).unwrap(), vec![hole]).fill(1.0).unwrap()
    };
    for m in [2.0, 3.0, 4.0] {
        let parameters = bordered(m);
        // The lower left quarter: its cells have the same numbers.
        let whole = body([-11.0, -9.0], [22.0, 18.0]);
        let full = BondPlane::on_lattice(Arc::new(whole), Mirrors::NONE, parameters, &[]).unwrap();
        let mirrors = Mirrors::in_plane([None, Some(11)], [None, Some(9)]);
        let real = body([-11.0, -9.0], [11.0, 9.0]);
        let part = mirrors.extended(&real, BondPlane::depth(&parameters).unwrap());
        let part = BondPlane::on_lattice(Arc::new(part), mirrors, parameters, &[]).unwrap();
        assert_eq!(BodyModel::edges(&part), Some(Edges::Border));
        compare(&full, &part, mirrors);
    }
}

/// Stresses of uniform strains are exact at every point, and the load that belongs to such a stress is that of its strain.
#[test]
fn stresses_of_uniform_strains_are_exact() {
    for m in [2.0, 3.0] {
        for (name, outline) in outlines() {
            for lattice in filled(&outline) {
                let plane = plane(&lattice, bordered(m));
                for g in STRAINS {
                    let (u, strain) = (linear(&plane, g), [g[0][0], g[1][1], g[0][1] + g[1][0]]);
                    let (fields, stress) = (plane.fields(&u), plane.parameters().material.stress(strain));
                    for (found, expected) in fields.stress.iter().zip(stress) {
                        // 1e-14 is found.
                        let off = found.iter().map(|s| (s - expected).abs()).fold(0.0, f64::max);
                        assert!(off < 1e-12 * largest(&stress), "{name} {m}: {off:e}");
                    }
                    let mut load = vec![0.0; u.len()];
                    plane.add_stress_load(None, &|_, _| stress, &mut load);
                    let internal = force(&plane, &u);
                    assert!(difference(&load, &internal) < 1e-12 * largest(&internal), "{name}");
                }
            }
        }
    }
}

/// Springs by the directions of bonds are the triangles, taken apart.
#[test]
fn a_body_that_can_break_resists_as_before() {
    for m in [2.0, 3.0, 4.0] {
        for (name, outline) in outlines() {
            for lattice in filled(&outline) {
                let elastic = plane(&lattice, bordered(m));
                let mut breaking = elastic.clone();
                breaking.prepare_to_break();
                let u = random(2 * elastic.points());
                let [expected, found] = [&elastic, &breaking].map(|plane| force(plane, &u));
                // 1e-15 is found.
                assert!(difference(&expected, &found) < 1e-13 * largest(&expected), "{name} {m}");
                let [expected, found] = [&elastic, &breaking].map(|plane| plane.fields(&u).stress);
                for (expected, found) in expected.iter().zip(&found) {
                    assert!(difference(expected, found) < 1e-13 * largest(expected), "{name} {m}");
                }
                assert!(breaking.completing() > 2 * elastic.completing(), "{name} {m}");
            }
        }
    }
}

/// Broken bonds take the springs with them whose corners move with points on both sides: nothing is left between two parts.
#[test]
fn a_body_breaks_from_border_to_border() {
    for (name, outline) in outlines() {
        for lattice in filled(&outline) {
            let mut plane = plane(&lattice, bordered(3.0));
            plane.prepare_to_break();
            let n = plane.points();
            let above = |p: usize| plane.place(p)[1] > 10.13 + 0.05 * plane.place(p)[0];
            let (mut u, rises) = (vec![0.0; 2 * n], (0..n).filter(|&p| above(p)).collect::<Vec<_>>());
            rises.iter().for_each(|&p| u[n + p] = 1.0);
            let before = energy(&plane, &u);
            let is_across = |&bond: &u64| {
                let [a, b] = plane.ends(bond);
                a != b && above(a) != above(b)
            };
            let mut broken: Vec<u64> = (0..plane.bond_numbers()).filter(is_across).collect();
            let critical = CriticalStretch::new(vec![1e-6; 14]);
            plane.for_each_ratio(&u, &critical, &mut |bond, ratio| {
                if ratio > 1.0 {
                    broken.push(bond)
                }
            });
            broken.sort_unstable();
            broken.dedup();
            plane.break_bonds(&broken);
            // 1e-30 of it is found.
            assert!(energy(&plane, &u) < 1e-20 * before, "{name}: {:e}", energy(&plane, &u) / before);
            let stress = plane.fields(&u).stress;
            assert!(stress.iter().all(|s| largest(s) < 1e-9), "{name}: {:e}", largest(&stress[1]));
        }
    }
}

/// Nothing holds the two parts of a body that a crack divides, also where it meets the border.
#[test]
fn a_crack_divides_a_body_from_border_to_border() {
    for m in [2.0, 3.0, 4.0] {
        for (name, outline) in outlines() {
            for lattice in filled(&outline) {
                let crack = Crack::new(vec![[-9.0, 10.13], [30.0, 12.41]]).unwrap();
                let parameters = bordered(m);
                let offsets = BondPlane::offsets(&parameters).unwrap();
                let cuts = cut_bonds(&lattice, &offsets, &[crack]);
                let plane = BondPlane::on_lattice(lattice.clone(), Mirrors::NONE, parameters, &cuts).unwrap();
                let above = |[x, y]: [f64; 2]| y > 10.13 + (x + 9.0) * 2.28 / 39.0;
                let n = plane.points();
                let mut u = vec![0.0; 2 * n];
                for p in (0..n).filter(|&p| above(plane.place(p))) {
                    let [x, y] = plane.place(p);
                    (u[p], u[n + p]) = (0.3 - 0.01 * y, 0.7 + 0.01 * x);
                }
                // 1e-27 is found, and 1e-1 without the crack.
                let energy = energy(&plane, &u);
                assert!(energy < 1e-20, "{name} {m}: {energy:e}");
                assert_eq!(plane.uncorrected(), 0, "{name} {m}");
            }
        }
    }
}
