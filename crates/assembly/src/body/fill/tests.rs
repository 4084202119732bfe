use super::*;
use crate::body::geometry::to_segment;
use crate::body::{Hole, Shape};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

fn plate(from: Point, size: Point, holes: &[Shape]) -> Outline {
    let mut outline = Outline::rectangle(from, size).unwrap();
    holes.iter().for_each(|s| outline.cut(Hole { name: None, shape: s.clone() }).unwrap());
    outline
}

fn has_symmetric_cells(lattice: &SquareLattice, [columns, rows]: [i32; 2]) -> bool {
    (0..lattice.points()).map(|p| lattice.cell(p)).all(|[i, j, _]| {
        let mirrored = [[columns - 1 - i, j], [i, rows - 1 - j], [columns - 1 - i, rows - 1 - j]];
        mirrored.into_iter().all(|[i, j]| lattice.number([i, j, 0]).is_some())
    })
}

#[test]
fn a_rectangle_has_whole_cells() {
    let outline = plate([0.3, -0.1], [0.3, 0.1], &[]);
    let lattice = outline.fill(0.1).unwrap();
    assert_eq!(lattice, SquareLattice::rectangle(0.1, [0.3, -0.1], [3, 1]));
    assert_eq!(outline.fill(0.1 * (1.0 + 5e-10)).unwrap().points(), 3);
    let Err(FillError::NotWhole { fitting, .. }) = plate([0.0; 2], [3.0, 2.0], &[]).fill(0.45) else {
        panic!("2/0.45 is no whole number");
    };
    assert_eq!(fitting, [2.0 / 6.0, 0.5]);
    // The sides have no common measure.
    let Err(FillError::NotWhole { fitting, .. }) = plate([0.0; 2], [1.0, f64::sqrt(2.0)], &[]).fill(0.1)
    else {
        panic!("no spacing fits");
    };
    assert!(fitting.is_empty());
    // Far from the origin the size is known less exactly than to 1e-9 of a cell.
    assert_eq!(plate([1e6, 0.0], [0.3, 0.1], &[]).fill(1e-4).unwrap().points(), 3_000_000);
}

#[test]
fn faults_are_reported() {
    let outline = plate([0.0; 2], [1.0; 2], &[]);
    assert_eq!(outline.fill(0.0), Err(FillError::Spacing { found: 0.0 }));
    assert_eq!(outline.fill(1e-6), Err(FillError::TooManyCells { cells: 1e12 }));
    let hole = Shape::Circle { centre: [0.5; 2], radius: 0.06 };
    // The hole is centred on the corner of four cells, 0.0707 from their centres.
    let missed = plate([0.0; 2], [1.0; 2], std::slice::from_ref(&hole));
    assert_eq!(missed.fill(0.1), Err(FillError::NoCellInHole { hole: 0 }));
    let all = plate([0.0; 2], [1.0; 2], &[Shape::Circle { centre: [0.5; 2], radius: 1.0 }]);
    assert_eq!(all.fill(0.1), Err(FillError::NoPoints));
}

#[test]
fn symmetric_holes_leave_symmetric_cells() {
    for (from, h) in [([0.0; 2], 1.0), ([-0.7, 0.3], 0.1), ([1.0 / 3.0, 1e3], 0.03)] {
        for cells in [[20, 16], [21, 17], [20, 17]] {
            let size = cells.map(|n| f64::from(n) * h);
            let centre = [from[0] + 0.5 * size[0], from[1] + 0.5 * size[1]];
            let along = [centre[0] - 2.0 * h, centre[0] + 2.0 * h];
            // Centres of cells are at distances of exactly 5, √8.5, … spacings from the centre.
            for radius in [5.0, 2.0, 8.5f64.sqrt(), 0.5f64.sqrt() * 3.0] {
                let radius = radius * h;
                let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
                    .map(|s: Point| [centre[0] + s[0] * radius, centre[1] + s[1] * radius]);
                let diamond = [[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]]
                    .map(|s: Point| [centre[0] + s[0] * radius, centre[1] + s[1] * radius]);
                let shapes = [
                    Shape::Circle { centre, radius },
                    Shape::Slot { from: [along[0], centre[1]], to: [along[1], centre[1]], radius },
                    Shape::Polygon(crate::body::Polygon::new(square.to_vec()).unwrap()),
                    Shape::Polygon(crate::body::Polygon::new(diamond.to_vec()).unwrap()),
                ];
                for shape in shapes {
                    let lattice = plate(from, size, std::slice::from_ref(&shape)).fill(h).unwrap();
                    assert!(has_symmetric_cells(&lattice, cells), "{shape:?} {cells:?} {h}");
                }
            }
        }
    }
}

/// Centres at whole distances: of a disc of radius 5 around a centre, 81 lattice positions are inside or on the
/// circle (Gauss), 12 on it; those on it stay in the body.
#[test]
fn the_edge_of_a_hole_belongs_to_the_body() {
    let hole = |h: f64| Shape::Circle { centre: [10.5 * h, 10.5 * h], radius: 5.0 * h };
    for h in [1.0, 0.1, 1.0 / 3.0, 2e-5] {
        let lattice = plate([0.0; 2], [21.0 * h; 2], &[hole(h)]).fill(h).unwrap();
        assert_eq!(lattice.points(), 441 - (81 - 12));
    }
}

#[test]
fn holes_may_cut_the_outline_and_each_other() {
    let notch = Shape::Slot { from: [-5.0, 5.0], to: [4.0, 5.0], radius: 1.0 };
    let disc = Shape::Circle { centre: [4.0, 5.0], radius: 2.0 };
    let outline = plate([0.0; 2], [10.0; 2], &[notch, disc]);
    let lattice = outline.fill(1.0).unwrap();
    // Two rows of the slot up to x = 4 and the disc of 12 cells, of which four are in the slot.
    assert_eq!(lattice.points(), 100 - (2 * 4 + 12 - 4));
    assert!(!outline.contains([0.5, 5.5]) && outline.contains([0.5, 6.0]));
}

/// A star-shaped polygon with random radii.
fn star() -> impl Strategy<Value = Vec<Point>> {
    proptest::collection::vec(2.0..10.0f64, 3..24).prop_map(|radii| {
        let n = radii.len() as f64;
        let place = |(k, r): (usize, f64)| {
            let angle = std::f64::consts::TAU * (k as f64 + 0.25) / n;
            [r * angle.cos(), r * angle.sin()]
        };
        radii.into_iter().enumerate().map(place).collect()
    })
}

/// A quarter turn, or none, is no turn: not a bit is different.
#[test]
fn an_angle_of_zero_fills_as_none() {
    let hole = Shape::Circle { centre: [0.31, 0.22], radius: 0.1 };
    let notch = Outline::polygon(vec![[0.1, 0.0], [0.9, 0.2], [0.7, 0.8], [0.5, 0.3]]).unwrap();
    for outline in [plate([0.1, -0.2], [0.6, 0.7], &[]), plate([0.1, 0.0], [0.6, 0.5], &[hole]), notch] {
        let plain = outline.fill(0.1 / 3.0).unwrap();
        for angle in [0.0, FRAC_PI_2, -PI] {
            let lattice = outline.fill_turned(0.1 / 3.0, angle).unwrap();
            assert_eq!(lattice, plain);
            assert_eq!(outline.cells(0.1 / 3.0, angle), outline.cells(0.1 / 3.0, 0.0));
        }
    }
}

#[test]
fn turned_cells_are_symmetric_about_the_middle() {
    // No whole numbers of cells: turned, that is no fault.
    let outline = plate([0.2, -0.3], [3.17, 1.31], &[Shape::Circle { centre: [1.785, 0.355], radius: 0.3 }]);
    assert!(matches!(outline.fill(0.1), Err(FillError::NotWhole { .. })));
    for degrees in [30.0f64, -45.0, 71.5] {
        let lattice = outline.fill_turned(0.1, degrees.to_radians()).unwrap();
        let middle = lattice.cell_at([1.785, 0.355]);
        let [x, y] = lattice.place_of(middle);
        assert!((x - 1.785).abs() < 1e-15 && (y - 0.355).abs() < 1e-15);
        for p in 0..lattice.points() {
            let [i, j, _] = lattice.cell(p);
            let image = lattice.number([2 * middle[0] - i, 2 * middle[1] - j, 0]).unwrap();
            assert!((lattice.fraction(image) - lattice.fraction(p)).abs() < 1e-9);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// The cells of a lattice in axes of its own are those whose centres are in the body where that is.
    #[test]
    fn turned_filling_agrees_with_exact_tests_of_every_centre(
        vertices in star(), cut in star(), at in [-4.0..4.0f64, -4.0..4.0], angle in -4.0..4.0f64, r in 1.0..3.0f64,
    ) {
        let mut outline = Outline::polygon(vertices).unwrap();
        let moved: Vec<Point> = cut.iter().map(|c| [0.3 * c[0] + at[0], 0.3 * c[1] + at[1]]).collect();
        let slot = Shape::Slot { from: [at[1], -at[0]], to: [-at[0], at[0]], radius: r };
        let disc = Shape::Circle { centre: [-at[0], -at[1]], radius: 0.5 * r };
        for shape in [Shape::Polygon(crate::body::Polygon::new(moved).unwrap()), slot, disc] {
            prop_assume!(outline.cut(Hole { name: None, shape }).is_ok());
        }
        let lattice = match outline.fill_turned(0.37, angle) {
            Err(FillError::NoCellInHole { .. } | FillError::NoPoints) => return Ok(()),
            made => made.unwrap(),
        };
        let size = outline.cells(0.37, angle).unwrap();
        for cell in (-2..size[0] + 2).flat_map(|i| (-2..size[1] + 2).map(move |j| [i, j, 0])) {
            let position = lattice.place_of(cell);
            let borders = outline.border().edges();
            if borders.map(|[a, b]| to_segment(position, a, b)).all(|d| d > 1e-8) {
                prop_assert_eq!(lattice.number(cell).is_some(), outline.contains(position), "{:?}", cell);
            }
        }
    }
}

proptest! {
    #[test]
    fn filling_agrees_with_exact_tests_of_every_centre(
        vertices in star(), cut in star(), at in [-4.0..4.0f64, -4.0..4.0], clockwise: bool, r in 1.0..3.0f64,
    ) {
        let mut vertices = vertices;
        if clockwise {
            vertices.reverse();
        }
        let mut outline = Outline::polygon(vertices).unwrap();
        let moved: Vec<Point> = cut.iter().map(|c| [0.3 * c[0] + at[0], 0.3 * c[1] + at[1]]).collect();
        let slot = Shape::Slot { from: [at[1], -at[0]], to: [-at[0], at[0]], radius: r };
        for shape in [Shape::Polygon(crate::body::Polygon::new(moved).unwrap()), slot] {
            prop_assume!(outline.cut(Hole { name: None, shape }).is_ok());
        }
        let lattice = match outline.fill(0.37) {
            Err(FillError::NoCellInHole { .. } | FillError::NoPoints) => return Ok(()),
            made => made.unwrap(),
        };
        let size = outline.cells(0.37, 0.0).unwrap();
        for cell in (0..size[0]).flat_map(|i| (0..size[1]).map(move |j| [i, j, 0])) {
            let position = lattice.place_of(cell);
            let borders = outline.border().edges();
            if borders.map(|[a, b]| to_segment(position, a, b)).all(|d| d > 1e-8) {
                prop_assert_eq!(lattice.number(cell).is_some(), outline.contains(position), "{:?}", cell);
            }
        }
    }

    /// Centres of cells as vertices: ties everywhere. The cells on the border belong to the body, and so the polygon
    /// read in the other direction, mirrored or moved has the same cells.
    #[test]
    fn ties_do_not_depend_on_direction_or_place(
        radii in proptest::collection::vec(1..12i32, 8), shift in [-9..9i32, -9..9], h in 0.01..3.0f64,
    ) {
        let steps = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1]];
        let whole: Vec<[i32; 2]> =
            steps.iter().zip(&radii).map(|(s, r)| [s[0] * r, s[1] * r]).collect();
        let fill = |vertices: Vec<[i32; 2]>| {
            let place = |v: &[i32; 2]| v.map(|x| f64::from(x) * h);
            let lattice = Outline::polygon(vertices.iter().map(place).collect()).unwrap().fill(h / 2.0).unwrap();
            (0..lattice.points()).map(|p| lattice.cell(p)).collect::<std::collections::BTreeSet<_>>()
        };
        let cells = fill(whole.clone());
        prop_assert_eq!(&cells, &fill(whole.iter().rev().copied().collect()));
        let moved = whole.iter().map(|v| [v[0] + shift[0], v[1] + shift[1]]).collect();
        prop_assert_eq!(&cells, &fill(moved));
        let width = cells.iter().map(|c| c[0]).max().unwrap();
        let extent = whole.iter().map(|v| v[0]).max().unwrap() - whole.iter().map(|v| v[0]).min().unwrap();
        let mirrored = fill(whole.iter().map(|v| [-v[0], v[1]]).collect());
        prop_assert!(width < 2 * extent);
        let flipped = mirrored.iter().map(|c| [2 * extent - 1 - c[0], c[1], 0]).collect();
        prop_assert_eq!(cells, flipped);
    }
}
