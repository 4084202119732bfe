use super::*;
use crate::body::turn::Turn;
use proptest::prelude::*;

/// Half of the offsets no longer than `reach` cells: one of each pair of opposite ones.
fn half_steps(reach: f64) -> Vec<Cell> {
    let n = reach as i32;
    let all = (0..=n).flat_map(|j| (-n..=n).map(move |i| [i, j]));
    let near = all.filter(|[i, j]| (*j > 0 || *i > 0) && f64::from(i * i + j * j) <= reach * reach);
    near.map(|[i, j]| [i, j, 0]).collect()
}

fn every_cut_bond(lattice: &SquareLattice, steps: &[Cell], cracks: &[Crack]) -> Vec<(usize, usize)> {
    let mut found = Vec::new();
    for (class, step) in steps.iter().enumerate() {
        for p in 0..lattice.points() {
            let cell = lattice.cell(p);
            let other = plus(cell, *step);
            let [a, b] = [cell, other].map(|c| lattice.centre(c));
            let slack = CRACK_SLACK * lattice.spacing();
            if lattice.number(other).is_some() && cracks.iter().any(|c| c.cuts(a, b, slack)) {
                found.push((class, p));
            }
        }
    }
    found
}

/// A compact-tension specimen; the numbers of cut bonds are those of an independent Python implementation
/// (neighbours within 3.5 spacings). The tip is on the border of two columns, so ties decide.
#[test]
fn cut_bonds_of_the_compact_tension_specimen() {
    let width = 50.0;
    for (k, expected) in [(5, 380), (10, 770), (15, 1160), (20, 1550)] {
        for unit in [1.0, 1e-3, 1.0 / 3.0] {
            let h = width * unit / f64::from(4 * k);
            let corner = [-0.25 * width * unit, -0.6 * width * unit];
            let lattice = SquareLattice::rectangle(h, corner, [5 * k, 24 * k / 5]);
            let crack = Crack::new(vec![[corner[0] - h, 0.0], [0.5 * width * unit, 0.0]]).unwrap();
            let steps = half_steps(3.5);
            let cut = cut_bonds(&lattice, &steps, std::slice::from_ref(&crack));
            assert_eq!(cut.len(), expected, "k = {k}, unit {unit}");
            assert_eq!(cut, every_cut_bond(&lattice, &steps, &[crack]));
        }
    }
}

#[test]
fn ties_count_as_cut() {
    let crack = Crack::new(vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]).unwrap();
    let cuts = |a, b| crack.cuts(in_space(a), in_space(b), 1e-6);
    assert!(cuts([0.5, -1.0], [0.5, 1.0]));
    // Through a tip, to the crack, along it, through the bend.
    assert!(cuts([-0.5, 0.5], [0.5, -0.5]));
    assert!(cuts([0.5, 0.0], [0.5, 1.0]));
    assert!(cuts([-1.0, 0.0], [0.25, 0.0]));
    assert!(cuts([0.5, -0.5], [1.5, 0.5]));
    // Beyond the tip by less than the slack, and by more.
    assert!(cuts([-9e-7, -1.0], [-9e-7, 1.0]));
    assert!(!cuts([-2e-6, -1.0], [-2e-6, 1.0]));
    assert!(!cuts([0.5, 0.1], [0.9, 0.9]));
}

#[test]
fn vertices_are_checked() {
    assert_eq!(Crack::new(vec![[0.0; 2]]), Err(CrackError::TooFewVertices { found: 1 }));
    assert_eq!(Crack::new(vec![[0.0; 2], [f64::NAN, 0.0]]), Err(CrackError::NotFinite { vertex: 2 }));
    assert_eq!(Crack::new(vec![[0.0; 2], [1.0; 2], [1.0; 2]]), Err(CrackError::Repeated { vertex: 2 }));
}

#[test]
fn listed_bonds_are_cut_alike() {
    let positions = [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]];
    let crack = Crack::new(vec![[-1.0, 0.5], [0.5, 0.5]]).unwrap();
    let pairs = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];
    assert_eq!(cut_pairs(&positions, pairs, 1e-6, &[crack]), [0, 2, 3]);
}

#[test]
fn a_long_crack_in_a_large_lattice_visits_few_points() {
    let lattice = SquareLattice::rectangle(1.0, [0.0; 2], [1000, 1000]);
    let crack = Crack::new(vec![[-1.0, 500.0], [500.0, 500.0]]).unwrap();
    let steps = half_steps(3.5);
    let cut = cut_bonds(&lattice, &steps, std::slice::from_ref(&crack));
    // A step crosses in as many rows as it rises, in every column but a few at the tip.
    let rising: i32 = steps.iter().map(|s| s[1]).sum();
    assert!(cut.len() as i32 > 500 * rising - 100 && (cut.len() as i32) < 500 * rising + 100);
}

proptest! {
    #[test]
    fn cutting_does_not_depend_on_directions(
        a in [-2..3i32, -2..3], b in [-2..3i32, -2..3], c in [-4..5i32, -4..5], d in [-4..5i32, -4..5],
        h in 0.01..10.0f64, angle in 0.0..6.3f64,
    ) {
        prop_assume!(c != d);
        let turned = |[x, y]: [i32; 2]| {
            let (x, y) = (f64::from(x) * h, f64::from(y) * h / 2.0);
            [x * angle.cos() - y * angle.sin(), x * angle.sin() + y * angle.cos()]
        };
        let [a1, b1, c1, d1] = [a, b, c, d].map(turned);
        let crack = Crack::new(vec![c1, d1]).unwrap();
        let back = Crack::new(vec![d1, c1]).unwrap();
        let slack = 1e-6 * h;
        let ends = [in_space(a1), in_space(b1)];
        let cut = crack.cuts(ends[0], ends[1], slack);
        prop_assert_eq!(cut, crack.cuts(ends[1], ends[0], slack));
        prop_assert_eq!(cut, back.cuts(ends[0], ends[1], slack));
        // Turning moves ties off by rounding; the answer is that of whole numbers.
        let whole = [a, b, c, d].map(|p| p.map(f64::from));
        prop_assert_eq!(cut, crate::body::geometry::meet(whole[0], whole[1], whole[2], whole[3]));
    }

    #[test]
    fn visiting_near_points_finds_all_cut_bonds(
        vertices in proptest::collection::vec([-3..30i32, -3..24], 2..6), m in 2.0..4.0f64, h in 0.1..4.0f64,
        coarser: bool, angle in prop_oneof![Just(0.0), -4.0..4.0f64],
    ) {
        prop_assume!(vertices.windows(2).all(|w| w[0] != w[1]));
        let hole = |[i, j]: [i32; 2]| (5..9).contains(&i) && (4..12).contains(&j);
        let mut lattice = SquareLattice::plane(h, [0.3, -0.7], 0..14, 0..11, |c| !hole(c));
        if coarser {
            lattice = lattice.coarser();
        }
        // Half cells: through centres, along rows and borders of cells.
        let place = |v: &[i32; 2]| {
            let at = [0.3 + 0.5 * h * f64::from(v[0]), -0.7 + 0.5 * h * f64::from(v[1])];
            Turn::new(angle, [2.0, 5.0]).map_or(at, |turn| turn.outwards(at))
        };
        lattice = lattice.turned(angle, [2.0, 5.0]);
        let crack = Crack::new(vertices.iter().map(place).collect()).unwrap();
        let steps = half_steps(m);
        let near = cut_bonds(&lattice, &steps, std::slice::from_ref(&crack));
        prop_assert_eq!(near, every_cut_bond(&lattice, &steps, &[crack]));
    }
}

/// Half of the offsets within a distance in space.
fn half_offsets(reach: f64) -> Vec<Cell> {
    let far = reach.floor() as i32;
    let side = || -far..=far;
    let all = side().flat_map(|c| side().flat_map(move |b| side().map(move |a| [a, b, c])));
    let is_half = |[a, b, c]: &Cell| (*c, *b, *a) > (0, 0, 0);
    let length = |step: &Cell| f64::from(step.iter().map(|k| k * k).sum::<i32>()).sqrt();
    all.filter(|step| is_half(step) && length(step) <= reach).collect()
}

fn cuts_of(cube: &SquareLattice, surface: &CrackSurface) -> Vec<(usize, usize)> {
    cut_bonds(cube, &half_offsets(3.0), &[Crack::from(surface.clone())])
}

#[test]
fn surfaces_cut_what_they_meet_and_nothing_else() {
    let cube = SquareLattice::cuboid(0.5, [-2.0, -1.5, -2.5], [8, 7, 9]);
    let slanted = [[-1.0, -1.0, -1.2], [1.3, -0.9, 0.4], [1.1, 0.8, 0.7], [0.1, 0.3, -0.1]];
    // The last corner is put into the plane of the first ones.
    let corner = [0, 1, 2].map(|k| slanted[0][k] + 0.3 * (slanted[2][k] - slanted[0][k]));
    let surfaces = [
        CrackSurface::disc([0.1, 0.0, 0.25], [0.0, 0.0, 2.0], [0.0, 1.2]).unwrap(),
        CrackSurface::disc([0.1, 0.0, 0.25], [1.0, -2.0, 0.5], [0.4, 1.3]).unwrap(),
        CrackSurface::polygon(&[slanted[0], slanted[1], slanted[2], corner]).unwrap(),
    ];
    let steps = half_offsets(3.0);
    for surface in &surfaces {
        let mut every = Vec::new();
        for (class, step) in steps.iter().enumerate() {
            for point in 0..cube.points() {
                let upper = plus(cube.cell(point), *step);
                let ends = [cube.position(point), cube.centre(upper)];
                let met = surface.cuts(ends[0], ends[1], 5e-7);
                assert_eq!(met, surface.cuts(ends[1], ends[0], 5e-7));
                if met && cube.number(upper).is_some() {
                    every.push((class, point));
                }
            }
        }
        assert!(every.len() > 50);
        assert_eq!(cuts_of(&cube, surface), every);
    }
}

#[test]
fn triangles_cut_as_the_polygon_that_they_fill() {
    let cube = SquareLattice::cuboid(1.0, [0.0; 3], [9, 8, 7]);
    let [a, b, c, d] = [[1.0, 1.0, 3.0], [7.0, 1.0, 3.0], [7.0, 6.0, 3.0], [1.0, 6.0, 3.0]];
    let whole = CrackSurface::polygon(&[a, b, c, d]).unwrap();
    let halves = CrackSurface::triangles([[a, b, c], [a, c, d], [a, a, d]]).unwrap();
    assert_eq!(cuts_of(&cube, &whole), cuts_of(&cube, &halves));
    // Bonds straight across: one per cell of 6 × 5 for lengths 1, 2 and 3, times the layers they begin in.
    let straight = |rows: i32| half_offsets(3.0).iter().position(|step| *step == [0, 0, rows]).unwrap();
    for rows in 1..=3 {
        let count = cuts_of(&cube, &whole).iter().filter(|cut| cut.0 == straight(rows)).count();
        assert_eq!(count, 30 * rows as usize);
    }
}

#[test]
fn images_and_moved_surfaces_cut_images_and_moved_bonds() {
    let surface = CrackSurface::disc([0.4, 0.2, 0.1], [1.0, 2.0, 3.0], [0.0, 1.0]).unwrap();
    let bonds = [
        ([0.0, 0.0, 0.0], [0.5, 0.4, 0.4]),
        ([0.2, 0.9, -0.6], [0.3, 0.1, 0.5]),
        ([2.0, 0.0, 0.0], [2.0, 1.0, 1.0]),
    ];
    for (a, b) in bonds {
        let cut = surface.cuts(a, b, 1e-9);
        let image = |at: [f64; 3]| [6.0 - at[0], at[1], -2.0 - at[2]];
        assert_eq!(surface.reflected([Some(3.0), None, Some(-1.0)]).cuts(image(a), image(b), 1e-9), cut);
        let moved = |at: [f64; 3]| [at[0] + 1.0, at[1] - 2.0, at[2] + 0.5];
        assert_eq!(surface.shifted([1.0, -2.0, 0.5]).cuts(moved(a), moved(b), 1e-9), cut);
    }
}

#[test]
fn what_is_no_surface_is_refused() {
    use CrackSurfaceError::{NoArea, NoNormal, NoRadius, NotFinite, NotFlat};
    let disc = |normal, radii| CrackSurface::disc([0.0; 3], normal, radii);
    assert_eq!(disc([0.0; 3], [0.0, 1.0]), Err(NoNormal));
    assert_eq!(disc([0.0, 0.0, 1.0], [1.0, 1.0]), Err(NoRadius));
    assert_eq!(disc([0.0, 0.0, 1.0], [0.0, f64::NAN]), Err(NoRadius));
    let polygon = |corners: &[[f64; 3]]| CrackSurface::polygon(corners);
    assert_eq!(polygon(&[[0.0; 3], [1.0; 3]]), Err(NoArea));
    assert_eq!(polygon(&[[0.0; 3], [1.0; 3], [2.0; 3]]), Err(NoArea));
    assert_eq!(polygon(&[[0.0; 3], [f64::INFINITY; 3], [2.0; 3]]), Err(NotFinite));
    let square = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.1]];
    assert!(matches!(polygon(&square), Err(NotFlat { .. })));
    assert_eq!(CrackSurface::triangles([]), Err(NoArea));
}

#[test]
fn fronts_of_triangles_are_those_of_their_outline() {
    let sheet =
        CrackSurface::polygon(&[[0.0, 0.0, 2.0], [4.0, 0.0, 2.0], [4.0, 6.0, 2.0], [0.0, 6.0, 2.0]]).unwrap();
    let at = |x: f64, y: f64| [x, y, 2.0];
    // Turned differently, one without an area, and one twice.
    let triangles = CrackSurface::triangles([
        [at(0.0, 0.0), at(4.0, 0.0), at(4.0, 6.0)],
        [at(0.0, 6.0), at(0.0, 0.0), at(4.0, 6.0)],
        [at(4.0, 0.0), at(4.0, 0.0), at(4.0, 6.0)],
        [at(4.0, 6.0), at(0.0, 0.0), at(4.0, 0.0)],
    ])
    .unwrap();
    let goes_on = |_: [f64; 3], ahead: [f64; 3]| ahead[0] > 0.5;
    let recess = Recess { by: 0.3, step: 1.0, within: [[-9.0; 3], [9.0; 3]], goes_on: &goes_on };
    let [sheet, triangles] = [sheet, triangles].map(|surface| Crack::from(surface).receded(&recess));
    for k in 0..900 {
        let (x, y) = (0.05 + 0.15 * f64::from(k % 30), 0.1 + 0.21 * f64::from(k / 30));
        let ends = [[x, y, 1.0], [x, y, 3.0]];
        let expected = x <= 3.7 + 1e-9 && y <= 6.0;
        for crack in [&sheet, &triangles] {
            assert_eq!(crack.cuts(ends[0], ends[1], 1e-9), expected, "{x} {y}");
        }
    }
    let recess = Recess { goes_on: &|at, _| at[1] > 3.0, ..recess };
    let surface = sheet.surface().unwrap();
    let place = surface.fronts(&recess).near([5.0, 1.0, 2.0]).unwrap();
    assert!(place.at[1] >= 3.0 - 1e-9 && (place.at[0] - 4.0).abs() < 1e-12, "{place:?}");
    assert!((place.ahead[0] - 1.0).abs() < 1e-12 && place.normal[2].abs() > 1.0 - 1e-12, "{place:?}");
}
