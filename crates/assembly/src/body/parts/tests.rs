use crate::body::geometry::Point;
use crate::body::{Cell, Hole, Outline, Polygon, Shape, SquareLattice};
use proptest::prelude::*;
use std::collections::BTreeMap;
use std::f64::consts::PI;

fn with_holes(mut outline: Outline, holes: Vec<Shape>) -> Outline {
    holes.into_iter().for_each(|shape| outline.cut(Hole { name: None, shape }).unwrap());
    outline
}

fn rectangle(from: Point, size: Point, holes: Vec<Shape>) -> Outline {
    with_holes(Outline::rectangle(from, size).unwrap(), holes)
}

fn area(lattice: &SquareLattice) -> f64 {
    (0..lattice.points()).map(|p| lattice.area(p)).sum()
}

#[test]
fn whole_cells_stay_whole() {
    let l = vec![[0.3, 0.0], [1.3, 0.0], [1.3, 0.4], [0.8, 0.4], [0.8, 0.9], [0.3, 0.9]];
    let hole = Polygon::new(vec![[0.5, 0.1], [0.7, 0.1], [0.7, 0.3], [0.5, 0.3]]).unwrap();
    let notch = [[0.1, 0.1], [0.2, 0.1], [0.2, 0.3], [0.1, 0.3]].map(|[x, y]| [1e6 + x, y]);
    let notch = Polygon::new(notch.to_vec()).unwrap();
    let bodies = [
        rectangle([-0.7, 0.3], [0.9, 0.6], Vec::new()),
        rectangle([0.3, 0.0], [0.9, 0.6], vec![Shape::Polygon(hole)]),
        Outline::polygon(l).unwrap(),
        // Far from the origin a corner is known to 1e-9 cells.
        rectangle([1e6, 0.0], [0.4, 0.2], vec![Shape::Polygon(notch)]),
    ];
    for body in bodies {
        for h in [0.1, 0.05, 0.025] {
            let lattice = body.fill(h).unwrap();
            assert!(lattice.cut_cells().is_empty(), "{h} {:?}", lattice.cut_cells());
        }
    }
}

#[test]
fn areas_sum_to_that_of_the_body() {
    let circle = |centre, radius| Shape::Circle { centre, radius };
    let slot = Shape::Slot { from: [3.0, 2.0], to: [7.0, 5.0], radius: 0.8 };
    let quarter = rectangle([0.0; 2], [20.0, 8.0], vec![circle([0.0; 2], 2.0)]);
    let inner = rectangle([0.0; 2], [20.0, 8.0], vec![circle([12.3, 4.1], 2.0), slot]);
    let oblique = [[0.0, 0.0], [9.0, 2.0], [8.0, 7.0], [5.0, 3.0], [1.0, 6.0]];
    let polygon = Outline::polygon(oblique.to_vec()).unwrap();
    let polygon_area = polygon.border().area();
    let window = Polygon::new(vec![[3.0, 1.2], [4.0, 1.7], [3.5, 2.6]]).unwrap();
    let window_area = window.area();
    let disc: Vec<Point> =
        (0..720).map(|k| (f64::from(k) * PI / 360.0).sin_cos()).map(|(s, c)| [c, s]).collect();
    let disc = Outline::polygon(disc).unwrap();
    let disc_area = disc.border().area();
    let cases = [
        ("quarter", quarter, 160.0 - PI, 1e-7),
        ("hole and slot", inner, 160.0 - 4.0 * PI - 8.0 - 0.64 * PI, 1e-6),
        ("polygon", polygon.clone(), polygon_area, 1e-3),
        ("window", with_holes(polygon, vec![Shape::Polygon(window)]), polygon_area - window_area, 1e-3),
        ("disc", disc, disc_area, 1e-9),
        // The circles overlap in a lens; the cells at its tips are sampled.
        (
            "lens",
            rectangle([0.0; 2], [8.0, 4.0], vec![circle([3.0, 2.0], 1.0), circle([4.0, 2.0], 1.0)]),
            32.0 - 2.0 * PI + (2.0 * PI / 3.0 - 0.75f64.sqrt()),
            1e-5,
        ),
    ];
    for (name, outline, exact, error) in cases {
        for h in [0.25, 0.1, 0.05] {
            let found = area(&outline.fill(h).unwrap());
            assert!((found / exact - 1.0).abs() < error, "{name} {h}: {found} {exact}");
        }
    }
}

/// In axes of its own a lattice cuts a rectangle obliquely. Here no cell has two borders, nor a part below a millionth,
/// which would count as none.
#[test]
fn areas_of_turned_cells_sum_to_that_of_the_body() {
    let window = Polygon::new(vec![[3.0, 1.2], [4.0, 1.7], [3.5, 2.6]]).unwrap();
    let (whole, gap) = (6.1 * 3.7, window.area());
    let plain = rectangle([0.3, -0.2], [6.1, 3.7], Vec::new());
    let disc = Shape::Circle { centre: [3.0, 1.5], radius: 1.0 };
    let cases = [
        ("plain", plain.clone(), whole),
        ("window", with_holes(plain.clone(), vec![Shape::Polygon(window)]), whole - gap),
        ("disc", with_holes(plain, vec![disc]), whole - PI),
    ];
    for (name, outline, exact) in cases {
        for degrees in [30.0f64, -30.0, 120.0, 10.0] {
            for h in [0.25, 0.1] {
                let found = area(&outline.fill_turned(h, degrees.to_radians()).unwrap());
                // Measured 1e-13 at most.
                assert!(
                    (found / exact - 1.0).abs() < 1e-12,
                    "{name} {degrees} {h}: {:e}",
                    found / exact - 1.0
                );
            }
        }
    }
}

#[test]
fn parts_without_points_go_to_the_fullest_neighbour() {
    // The upper side is 0.3 cells above the third row, the right one 0.4 behind the fourth column.
    let outline = Outline::polygon(vec![[0.0; 2], [4.4, 0.0], [4.4, 3.3], [0.0, 3.3]]).unwrap();
    let lattice = outline.fill(1.0).unwrap();
    assert_eq!(lattice.points(), 12);
    for p in 0..12 {
        let expected = match lattice.cell(p) {
            // The corner, 0.12, goes to the only point across it.
            [3, 2, _] => 1.0 + 0.3 + 0.4 + 0.12,
            [3, _, _] => 1.4,
            [_, 2, _] => 1.3,
            _ => 1.0,
        };
        assert!((lattice.fraction(p) - expected).abs() < 1e-12, "{:?}", lattice.cell(p));
    }
}

#[test]
fn symmetric_bodies_have_symmetric_areas() {
    for (centre, cells) in [([0.0; 2], [20, 20]), ([1.0 / 3.0, 1e3], [21, 21])] {
        for radius in [3.0, 5.0, 7.7] {
            let h = 0.1;
            let size = cells.map(|n| f64::from(n) * h);
            let from = [centre[0] - 0.5 * size[0], centre[1] - 0.5 * size[1]];
            let hole = Shape::Circle { centre, radius: radius * h };
            let lattice = rectangle(from, size, vec![hole]).fill(h).unwrap();
            assert!(lattice.cut_cells().len() > 8);
            let n = cells[0] - 1;
            for &(point, part) in lattice.cut_cells() {
                let [i, j, _] = lattice.cell(point as usize);
                let images: [Cell; 4] = [[n - i, j, 0], [i, n - j, 0], [j, i, 0], [n - j, n - i, 0]];
                for image in images {
                    let other = lattice.fraction(lattice.number(image).unwrap());
                    assert!((part - other).abs() < 1e-9, "{centre:?} {radius}: {part} {other}");
                }
            }
        }
    }
}

proptest! {
    #[test]
    fn areas_of_oblique_boxes_are_exact(turn in 0.0..1.5f64, w in 6.0..9.0f64, t in 3.0..5.0f64) {
        let (s, c) = turn.sin_cos();
        let at = |x: f64, y: f64| [c * x - s * y, s * x + c * y];
        let outline = Outline::polygon(vec![at(0.0, 0.0), at(w, 0.0), at(w, t), at(0.0, t)]).unwrap();
        let lattice = outline.fill(0.37).unwrap();
        prop_assert!((area(&lattice) / (w * t) - 1.0).abs() < 1e-4);
        prop_assert!(lattice.cut_cells().iter().all(|c| (0.2..2.6).contains(&c.1)), "{:?}", lattice.cut_cells());
    }
}

/// The parts of all triangles of a body make its area twice, once by either diagonal.
#[test]
fn triangles_of_blocks_have_the_area_of_the_body() {
    let hole = Shape::Circle { centre: [6.2, 4.3], radius: 2.1 };
    let corners = vec![[0.2, 0.1], [12.0, 1.3], [11.1, 8.4], [1.7, 7.9]];
    let whole = |corners: Vec<Point>| Outline::polygon(corners).unwrap();
    let inside = whole(corners.clone()).border().area() - PI * 2.1 * 2.1;
    // Half a hole is in a body that ends in its middle.
    let notched = whole(vec![[0.0, 0.0], [0.0, 4.3], [12.5, 4.3], [12.5, 0.0]]);
    for (outline, area_of) in [(whole(corners), inside), (notched, 12.5 * 4.3 - 0.5 * PI * 2.1 * 2.1)] {
        check_triangles(&with_holes(outline, vec![hole.clone()]).fill(0.5).unwrap(), area_of);
    }
}

fn check_triangles(lattice: &SquareLattice, area_of: f64) {
    let listed: BTreeMap<Cell, [f64; 4]> = lattice.blocks().iter().copied().collect();
    let is_whole = |[i, j, _]: Cell| {
        [[0, 0], [1, 0], [0, 1], [1, 1]].into_iter().all(|[a, b]| lattice.number([i + a, j + b, 0]).is_some())
    };
    let blocks = (-2..30).flat_map(|j| (-2..30).map(move |i| [i, j, 0]));
    let whole = blocks.filter(|b| !listed.contains_key(b) && is_whole(*b)).count() as f64;
    for pair in [[0, 3], [1, 2]] {
        let cut: f64 = listed.values().map(|parts| 0.5 * (parts[pair[0]] + parts[pair[1]])).sum();
        let found = (whole + cut) * 0.25;
        // A circle of chords has its area; half of one where it is divided, too.
        assert!((found / area_of - 1.0).abs() < 1e-9, "{found} {area_of}");
    }
    assert!(listed.values().flatten().all(|part| (0.0..=1.0).contains(part)));
}
