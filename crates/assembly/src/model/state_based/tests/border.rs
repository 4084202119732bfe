//! Borders that are completed: uniform stresses are in equilibrium, and dilatations are exact at every point.

use super::super::BorderedState;
use super::*;
use crate::body::{Hole, Outline, Polygon, Shape, plus};
use crate::model::BodyModel;
use crate::model::Points;
use crate::model::plane::Solvable;
use crate::model::plane::through_border::{Side, through_border};

/// Above 0.45 in plane strain, with means over blocks.
const RATIOS: [f64; 5] = [-0.5, 0.0, 0.3, 0.45, 0.49];
const STRAINS: [[f64; 4]; 4] =
    [[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0], [0.0, 0.5, 0.5, 0.0], [0.3, 0.2, -0.1, -0.7]];

fn plate(lattice: &SquareLattice, mirrors: Mirrors, m: f64, nu: f64) -> BorderedState {
    let parameters = StateParameters {
        horizon_ratio: m,
        poisson_ratio: nu,
        influence: Influence::Linear,
        edges: StateEdges::Border,
        geometry: if nu > 0.45 { Geometry::PlaneStrain(0.5) } else { PLATE.geometry },
        dilatation: if nu > 0.45 { Dilatation::Blocks } else { Dilatation::Points },
        ..PLATE
    };
    BorderedState::on_lattice(lattice, mirrors, parameters).unwrap()
}

fn outlines() -> Vec<(&'static str, Outline)> {
    let rectangle = || Outline::rectangle([0.3, -2.0], [15.0, 13.0]).unwrap();
    let pierced = |mut outline: Outline, shape: Shape| {
        outline.cut(Hole { name: None, shape }).unwrap();
        outline
    };
    let circle = Shape::Circle { centre: [7.4, 4.7], radius: 3.2 };
    let window = Polygon::new(vec![[5.0, 2.0], [10.4, 3.1], [7.2, 7.0]]).unwrap();
    let oblique = Outline::polygon(vec![[0.0, 3.1], [14.4, 0.0], [16.0, 11.2], [2.2, 13.5]]).unwrap();
    let angle = vec![[0.0, 0.0], [14.0, 0.0], [14.0, 6.0], [7.0, 6.0], [7.0, 13.0], [0.0, 13.0]];
    vec![
        ("rectangle", rectangle()),
        ("L", Outline::polygon(angle).unwrap()),
        ("window", pierced(rectangle(), Shape::Polygon(window))),
        ("quadrilateral", oblique),
        ("hole", pierced(rectangle(), circle)),
    ]
}

/// Rows that run along x, and turned ones.
fn filled(outline: &Outline) -> Vec<SquareLattice> {
    [0.0, 0.3].map(|angle| outline.fill_turned(1.0, angle).unwrap()).to_vec()
}

fn density(plate: &dyn PlaneModel, [a, b, c, d]: [f64; 4]) -> f64 {
    let (strain, stiffness) = ([a, d, b + c], plate.stiffness());
    (0..3).map(|p| (0..3).map(|q| 0.5 * strain[p] * stiffness[p][q] * strain[q]).sum::<f64>()).sum()
}

fn force(plate: &BorderedState, u: &[f64]) -> Vec<f64> {
    let mut force = vec![0.0; u.len()];
    plate.terms().iter().for_each(|t| t.add_force(u, &mut force));
    force
}

#[test]
fn uniform_strains_have_their_energy_and_their_dilatation_everywhere() {
    for m in [2.0, 3.0, 4.0] {
        for (name, outline) in outlines() {
            for lattice in filled(&outline) {
                let plate = plate(&lattice, Mirrors::NONE, m, 0.2);
                let of = plate.dilatations.as_ref().unwrap();
                let inner = plate.points() - of.points.len();
                let area = of.volumes.iter().sum::<f64>() + inner as f64;
                for motion in STRAINS {
                    let u = linear(&plate, motion);
                    for k in 0..of.own.count() {
                        let mut theta = 0.0;
                        for member in of.own.members(k) {
                            let n = plate.points();
                            let moved = |c: usize| u[c * n + member.point as usize];
                            theta += member.rows[0][0] * moved(0) + member.rows[0][1] * moved(1);
                        }
                        let off = (theta - motion[0] - motion[3]).abs();
                        assert!(off < 1e-12, "{name} {m} {motion:?}: {off:e}");
                    }
                    let energy: f64 = plate.terms().iter().map(|t| t.survey(&u).energy).sum();
                    let found = energy / (0.5 * density(&plate, motion));
                    assert!((found / area - 1.0).abs() < 1e-12, "{name} {m}: {found} {area}");
                }
            }
        }
    }
}

#[test]
fn tractions_hold_every_uniform_stress() {
    for m in [2.0, 3.0, 4.0] {
        for (name, outline) in outlines().into_iter().take(4) {
            let mut sides: Vec<Side> = outline.edges().iter().map(|e| ([e.from, e.to], e.normal)).collect();
            if let Some(Shape::Polygon(hole)) = outline.holes().first().map(|h| &h.shape) {
                sides.extend((0..3).map(|k| (hole.edge(k), hole.normal(k).map(|x| -x))));
            }
            for lattice in filled(&outline) {
                for nu in RATIOS {
                    let plate = plate(&lattice, Mirrors::NONE, m, nu);
                    for stress in [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.7, -1.3, 0.4]] {
                        let [x, y, shear] = plate.strain_of(stress);
                        let u = linear(&plate, [x, 0.5 * shear, 0.5 * shear, y]);
                        let (internal, load) = (force(&plate, &u), through_border(&plate, &sides, stress));
                        let size = largest(load.iter().copied());
                        let off = largest(internal.iter().zip(&load).map(|(a, b)| a - b)) / size;
                        assert!(off < 1e-11, "{name} {m} {nu} {stress:?}: {off:e}");
                        let mut through_volume = vec![0.0; u.len()];
                        plate.add_stress_load(None, &|_, _| stress, &mut through_volume);
                        let off = largest(internal.iter().zip(&through_volume).map(|(a, b)| a - b)) / size;
                        assert!(off < 1e-11, "{name} {m} {nu} {stress:?}: {off:e}");
                        let found = plate.fields(&u).stress;
                        let off = (0..3).map(|k| largest(found[k].iter().map(|s| s - stress[k])));
                        assert!(off.fold(0.0, f64::max) < 1e-11, "{name} {m} {nu} {stress:?}");
                    }
                }
            }
        }
    }
}

/// Coarser lattices do not know their border: triangles of points complete families.
#[test]
fn coarser_plates_have_the_energy_of_their_area() {
    for (name, outline) in outlines() {
        let plate = plate(&outline.fill(0.5).unwrap(), Mirrors::NONE, 3.0, 0.0);
        let coarse = plate.coarser(&|_, _| Vec::new()).unwrap();
        let area: f64 = (0..coarse.points()).map(|p| coarse.volume(p)).sum();
        for motion in STRAINS {
            let u = linear(&*coarse, motion);
            let energy: f64 = coarse.terms().iter().map(|t| t.survey(&u).energy).sum();
            let found = energy / (area * density(coarse.as_plane().unwrap(), motion));
            assert!((found - 1.0).abs() < 1e-11, "{name} {motion:?}: {found}");
        }
    }
}

#[test]
fn three_motions_cost_nothing_and_none_less() {
    for m in [2.0, 3.0] {
        for (name, outline) in outlines() {
            let lattice = &filled(&outline)[usize::from(name != "L")];
            for nu in RATIOS {
                let plate = plate(lattice, Mirrors::NONE, m, nu);
                let system = System::new(&plate, Vec::new(), Vec::new()).unwrap();
                let values = stiffness(&system).symmetric_eigenvalues();
                let (least, most) = (values.min(), values.max());
                assert_eq!(values.iter().filter(|v| **v < 1e-9 * most).count(), 3, "{name} {m} {nu}");
                assert!(least > -1e-12 * most, "{name} {m} {nu}: {least:e}");
            }
        }
    }
}

/// A mean is over all points of its block, in the grid or beside it.
#[test]
fn blocks_are_not_divided() {
    let lattice = &filled(&outlines()[4].1)[0];
    let plate = plate(lattice, Mirrors::NONE, 3.0, 0.49);
    let own = &plate.dilatations.as_ref().unwrap().points;
    let is_own = |p: usize| own.binary_search(&(p as u32)).is_ok();
    let parent = |p: usize| SquareLattice::parent(lattice.cell(p));
    for p in (0..plate.points()).filter(|p| !is_own(*p)) {
        assert!((0..plate.points()).all(|q| parent(q) != parent(p) || !is_own(q)), "{p}");
    }
}

/// Forces and energy of a symmetric displacement, by cells.
#[test]
fn a_quarter_with_mirrors_is_the_whole() {
    let quarter = |from: [f64; 2], size: [f64; 2], holed: bool| {
        let mut outline = Outline::rectangle(from, size).unwrap();
        if holed {
            outline.cut(Hole { name: None, shape: Shape::Circle { centre: [0.0; 2], radius: 3.3 } }).unwrap();
        }
        outline.fill(1.0).unwrap()
    };
    for (m, nu, holed) in [(2.0, 0.0, true), (3.0, 0.45, true), (3.0, 0.2, false), (3.0, 0.49, true)] {
        let whole = plate(&quarter([-8.0; 2], [16.0; 2], holed), Mirrors::NONE, m, nu);
        let mirrors = Mirrors::in_plane([Some(0), None], [Some(0), None]);
        let part = plate(&quarter([0.0; 2], [8.0; 2], holed), mirrors, m, nu);
        // A displacement with the symmetry of the body.
        let at = |plate: &BorderedState, p: usize| {
            let [x, y] = plate.place(p);
            [0.3 * x + 1e-2 * x * y * y - 1e-3 * x.powi(3), -0.1 * y + 2e-2 * y * x * x]
        };
        let forces = |plate: &BorderedState| {
            let n = plate.points();
            let u: Vec<f64> = (0..2 * n).map(|k| at(plate, k % n)[k / n]).collect();
            (force(plate, &u), plate.terms().iter().map(|t| t.survey(&u).energy).sum::<f64>())
        };
        let ((all, energy), (own, quarter)) = (forces(&whole), forces(&part));
        assert!((4.0 * quarter / energy - 1.0).abs() < 1e-12, "{m} {nu}: {}", 4.0 * quarter / energy);
        // Forces on images act on what they are images of.
        let (n, lattice) = (part.points(), part.lattice().unwrap().0);
        let mut sums = vec![[0.0; 2]; n];
        for p in 0..n {
            let (cell, signs) = mirrors.image(lattice.cell(p));
            let real = lattice.number(cell).unwrap();
            (0..2).for_each(|k| sums[real][k] += signs[k] * own[k * n + p]);
        }
        let (count, wide) = (whole.points(), whole.lattice().unwrap().0);
        for p in real_points(&part) {
            let cell = lattice.cell(p);
            let other = wide.number(plus(cell, [8, 8, 0])).unwrap();
            for k in 0..2 {
                let off = sums[p][k] - all[k * count + other];
                assert!(off.abs() < 1e-12 * largest(all.iter().copied()), "{m} {nu} {cell:?}: {off:e}");
            }
        }
    }
}

#[test]
fn strips_between_held_edges_have_one_stress() {
    for (m, nu) in [(2.0, 0.3), (3.0, 0.0), (3.0, 0.3), (3.0, 0.45), (3.0, 0.49), (4.0, 0.3)] {
        let (columns, rows) = (24, 12);
        let plate = plate(&cells(1.0, 0.0, [columns, rows]), Mirrors::NONE, m, nu);
        let lattice = plate.lattice().unwrap().0.clone();
        let number = |cell| lattice.number(cell).unwrap();
        let edge = |row: i32, column: i32, inward: i32, value: f64| Equation {
            terms: [(0, 1.5), (inward, -0.5)]
                .map(|(k, share)| (Unknown { component: 0, point: number([column + k, row, 0]) }, share))
                .to_vec(),
            value,
            origin: "held".into(),
        };
        let moved = 0.01 * f64::from(columns);
        let mut held: Vec<Equation> =
            (0..rows).flat_map(|r| [edge(r, 0, 1, 0.0), edge(r, columns - 1, -1, moved)]).collect();
        held.push(super::held(1, number([0, 0, 0]), 0.0));
        let u = solve(&plate, held, &vec![0.0; 2 * plate.points()]);
        let fields = plate.fields(&u);
        // Across a strip of plane strain nothing is held but itself.
        let nu_across = if nu > 0.45 { nu } else { 0.0 };
        let exact = 0.01 * plate.parameters().youngs_modulus / (1.0 - nu_across * nu_across);
        for (k, expected) in [exact, 0.0, 0.0].into_iter().enumerate() {
            let off = largest(fields.stress[k].iter().map(|s| s - expected)) / exact;
            assert!(off < 1e-10, "{m} {nu} {k}: {off:e}");
        }
        let force: f64 = (0..rows)
            .map(|r| force(&plate, &u)[number([0, r, 0])] + self::force(&plate, &u)[number([1, r, 0])])
            .sum();
        let wanted = -exact * plate.thickness() * f64::from(rows);
        assert!((force / wanted - 1.0).abs() < 1e-11, "{m} {nu}: {force} {wanted}");
    }
}
