use super::*;

#[test]
fn cells_between_two_lines_repeat() {
    let mirrors = Mirrors::in_plane([Some(0), Some(2)], [None; 2]);
    let images: Vec<(i32, f64)> =
        (-4..6).map(|c| (mirrors.image([c, 7, 0]).0[0], mirrors.image([c, 7, 0]).1[0])).collect();
    let expected = [
        (0, 1.0),
        (1, 1.0),
        (1, -1.0),
        (0, -1.0),
        (0, 1.0),
        (1, 1.0),
        (1, -1.0),
        (0, -1.0),
        (0, 1.0),
        (1, 1.0),
    ];
    assert_eq!(images, expected);
    assert!(mirrors.is_real([1, -3, 0]) && !mirrors.is_real([2, 0, 0]));
}

#[test]
fn behind_a_joined_side_the_other_one_follows() {
    for (from, period) in [(0, 5), (-2, 1), (3, 4)] {
        let lines = Mirrors::in_plane([None; 2], [Some(from), Some(from + period)]);
        let mirrors = Mirrors { joined: [false, true, false], ..lines };
        for row in from - 12..from + 12 {
            let (cell, signs) = mirrors.image([7, row, 0]);
            assert_eq!((cell[0], signs), (7, [1.0; 3]));
            assert!(mirrors.is_real(cell) && (cell[1] - row) % period == 0);
            assert_eq!(mirrors.is_real([7, row, 0]), cell[1] == row);
        }
        assert_eq!(mirrors.coarser().is_some(), from % 2 == 0 && period % 2 == 0);
    }
}

#[test]
fn copies_of_a_body_that_stretches_grow_by_whole_periods() {
    let [joined, stretches] = [[true, false, false]; 2];
    let mirrors = Mirrors { joined, stretches, ..Mirrors::in_plane([Some(1), Some(4)], [None; 2]) };
    let real = SquareLattice::plane(1.0, [0.0; 2], 1..4, 0..2, |_| true);
    let lattice = mirrors.extended(&real, 7);
    let relations = mirrors.relations::<2>(&lattice, &mirrors.ghosts(&lattice), |[x, y, _]| [x, y]);
    // What repeats, and half a unit more along x per column.
    let value = |Unknown { component, point }: Unknown| {
        let [column, row, _] = lattice.cell(point);
        let repeated = (column.rem_euclid(3) * 5 + row * 3) % 7 + component as i32;
        f64::from(repeated) + if component == 0 { 0.5 * f64::from(column) } else { 0.0 }
    };
    assert!(relations.iter().any(|relation| relation.terms.len() > 2));
    for Equation { terms, value: right, origin } in relations {
        let left: f64 = terms.iter().map(|(unknown, factor)| factor * value(*unknown)).sum();
        assert!((left - right).abs() < 1e-13, "{terms:?}");
        assert_eq!(origin, "periodic");
    }
}

#[test]
fn images_are_added_and_taken_away() {
    let hole = |c: [i32; 2]| c != [1, 1];
    let real = SquareLattice::plane(1.0, [0.0; 2], 0..5, 0..4, hole);
    let mirrors = Mirrors::in_plane([None, Some(5)], [Some(0), None]);
    let extended = mirrors.extended(&real, 4);
    // The hole and its three images.
    assert_eq!(extended.points(), 9 * 8 - 4);
    assert_eq!(extended.number([8, -2, 0]), None);
    assert_eq!(mirrors.real(&extended).runs(), real.runs());
    assert_eq!(mirrors.ghosts(&extended).len(), extended.points() - real.points());
}

#[test]
fn a_solid_is_mirrored_along_three_axes() {
    let mut mirrors = Mirrors::NONE;
    for (side, line) in [(0, 0), (3, 4), (4, 0), (5, 3)] {
        mirrors.set_line(side, line);
    }
    assert_eq!(mirrors.image([-1, 5, 4]), ([0, 2, 1], [-1.0; 3]));
    assert_eq!(mirrors.image([2, 3, -4]), ([2, 3, 2], [1.0, 1.0, 1.0]));
    let real = SquareLattice::new(1.0, [0.0; 3], [0..5, 0..4, 0..3], |c| c != [1, 1, 1]);
    let extended = mirrors.extended(&real, 2);
    // The hole has images on the left, in front and behind, and those have theirs on the left.
    assert_eq!(extended.points(), 7 * 6 * 7 - 6);
    for p in 0..extended.points() {
        assert!(real.number(mirrors.image(extended.cell(p)).0).is_some());
    }
    assert_eq!(extended.number([-2, 1, -2]), None);
    assert_eq!(mirrors.real(&extended), real);
    assert_eq!(mirrors.ghosts(&extended).len(), extended.points() - real.points());
    let coarse = mirrors.coarser().unwrap();
    assert_eq!(coarse.lines, [[Some(0), None], [None, Some(2)], [Some(0), Some(2)]]);
}

#[test]
fn copies_of_a_solid_grow_along_z() {
    let [joined, stretches] = [[false, false, true]; 2];
    let mut mirrors = Mirrors { joined, stretches, ..Mirrors::NONE };
    mirrors.set_line(4, 0);
    mirrors.set_line(5, 2);
    let lattice = mirrors.extended(&SquareLattice::cuboid(1.0, [0.0; 3], [3, 2, 2]), 3);
    let relations = mirrors.relations::<3>(&lattice, &mirrors.ghosts(&lattice), |signs| signs);
    let value = |Unknown { component, point }: Unknown| {
        let [i, j, k] = lattice.cell(point);
        let repeated = (i * 5 + j * 3 + k.rem_euclid(2) * 7) % 11 + component as i32;
        f64::from(repeated) + if component == 2 { 0.25 * f64::from(k) } else { 0.0 }
    };
    assert!(relations.iter().any(|relation| relation.terms.len() > 2));
    for Equation { terms, value: right, .. } in relations {
        let left: f64 = terms.iter().map(|(unknown, factor)| factor * value(*unknown)).sum();
        assert!((left - right).abs() < 1e-13, "{terms:?}");
    }
}
