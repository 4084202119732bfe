//! Lists that are clouds, and those that are none.

use super::*;

fn fault(positions: &[[f64; 2]], areas: &[f64]) -> CloudError {
    Cloud::in_plane(positions.to_vec(), areas.to_vec(), Vec::new()).unwrap_err()
}

#[test]
fn lists_are_checked() {
    assert_eq!(fault(&[], &[]), CloudError::Number { found: 0 });
    assert_eq!(fault(&[[0.0; 2]], &[]), CloudError::Lengths { positions: 1, sizes: 0 });
    assert_eq!(fault(&[[0.0, f64::INFINITY]], &[1.0]), CloudError::NotFinite { point: 0 });
    assert_eq!(fault(&[[0.0; 2], [1.0; 2]], &[1.0, 0.0]), CloudError::Size { point: 1, found: 0.0 });
    let group = |name: &str, points: &[u32]| Group { name: name.into(), points: points.to_vec() };
    let with = |groups: Vec<Group>| Cloud::in_plane(vec![[0.0; 2], [1.0; 2]], vec![2.0; 2], groups);
    assert!(matches!(with(vec![group("a", &[0, 2])]), Err(CloudError::NoSuchPoint { point: 2, .. })));
    assert!(matches!(with(vec![group("a", &[]), group("a", &[])]), Err(CloudError::SameName { .. })));
    let cloud = with(vec![group("a", &[1, 0, 1])]).unwrap();
    assert_eq!(cloud.group("a").unwrap().points, [0, 1]);
    assert_eq!(cloud.spacing(), 2.0f64.sqrt());
}

/// Points of a regular grid, which share their coordinates with many others, and one that is nearly a copy.
#[test]
fn copies_are_found_on_either_side_of_any_strip() {
    let grid = (0..40).flat_map(|i| (0..40).map(move |j| [f64::from(i) * 0.7, f64::from(j) * 0.7]));
    let grid: Vec<[f64; 2]> = grid.collect();
    let areas = vec![0.49; grid.len() + 1];
    assert!(Cloud::in_plane(grid.clone(), areas[1..].to_vec(), Vec::new()).is_ok());
    for (k, by) in [(0, [0.0, 0.0]), (777, [5e-10, 0.0]), (800, [-5e-10, 1e-10]), (1599, [0.0, -6e-10])] {
        let mut points = grid.clone();
        points.push([grid[k][0] + by[0], grid[k][1] + by[1]]);
        assert_eq!(fault(&points, &areas), CloudError::Coincident { first: k, second: 1600 });
    }
}
/// The same in space, where a copy may be on either side of two borders.
#[test]
fn copies_in_space_are_found_in_any_column() {
    let at = |k: i32| f64::from(k) * 0.7;
    let grid = (0..1000).map(|k| [at(k % 10), at(k / 10 % 10), at(k / 100)]);
    let grid: Vec<[f64; 3]> = grid.collect();
    let volumes = vec![0.343; 1001];
    let cloud = Cloud::in_space(grid.clone(), volumes[1..].to_vec(), Vec::new()).unwrap();
    assert_eq!((cloud.axes(), cloud.place(123)), (3, [at(3), at(2)]));
    assert!((cloud.spacing() - 0.7).abs() < 1e-13);
    let by =
        [[0.0; 3], [5e-10, 0.0, 0.0], [-4e-10, 4e-10, -1e-10], [3e-10, -4e-10, 2e-10], [0.0, 0.0, -6e-10]];
    for (k, by) in [0, 555, 700, 123, 999].into_iter().zip(by) {
        let mut points = grid.clone();
        points.push([0, 1, 2].map(|axis| grid[k][axis] + by[axis]));
        let found = Cloud::in_space(points, volumes.clone(), Vec::new()).unwrap_err();
        assert_eq!(found, CloudError::Coincident { first: k, second: 1000 });
    }
    // Points above each other differ.
    assert!(Cloud::in_space(vec![[0.0; 3], [0.0, 0.0, 1.0]], vec![1.0; 2], Vec::new()).is_ok());
}
