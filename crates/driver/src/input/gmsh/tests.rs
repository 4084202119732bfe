use super::*;
use peristat_assembly::body::{Facet, Surface};
use proptest::prelude::*;

/// Two unit squares side by side: the left one of two triangles (the second clockwise), the right one a quadrilateral of
/// second order; tags of nodes have gaps, and one block is parametric.
const SMALL: &str = r#"$MeshFormat
4.1 0 8
$EndMeshFormat
$Comments
anything
$EndComments
$PhysicalNames
3
1 7 "the left"
2 3 "steel"
2 4 "all"
$EndPhysicalNames
$Entities
1 3 2 0
1 0 0 5 0
1 0 0 5 0 1 5 1 7 2 1 2
2 1 0 5 1 1 5 1 -9 2 2 3
3 0 0 5 1 0 5 0 2 1 2
1 0 0 5 1 1 5 2 3 4 3 1 2 3
2 1 0 5 2 1 5 1 4 1 2
$EndEntities
$Nodes
2 10 1 1000
1 2 1 2
10
20
1 0 5 0
1 1 5 1
2 1 0 8
1
2
1000
30
31
32
33
34
0 0 5
0 1 5
2 0 5
2 1 5
1.5 0 5
2 0.5 5
1.5 1 5
1 0.5 5
$EndNodes
$Elements
5 6 1 100
0 1 15 1
1 1
1 1 1 1
2 1 2
1 2 8 1
3 10 20 34
2 1 2 2
50 1 10 20
51 1 2 20
2 2 16 1
100 10 1000 30 20 31 32 33 34
$EndElements
"#;

#[test]
fn elements_become_points_and_physical_groups_groups() {
    let mesh = read(SMALL.as_bytes()).unwrap();
    let third = 1.0 / 3.0;
    let expected = [[2.0 * third, third], [third, 2.0 * third], [1.5, 0.5]];
    for (found, expected) in mesh.cloud.positions().iter().zip(expected) {
        assert!((found[0] - expected[0]).abs() < 1e-15 && (found[1] - expected[1]).abs() < 1e-15);
    }
    assert_eq!(mesh.cloud.sizes(), [0.5, 0.5, 1.0]);
    let group = |name: &str| mesh.cloud.group(name).unwrap().points.clone();
    assert_eq!(group("steel"), [0, 1]);
    assert_eq!(group("all"), [0, 1, 2]);
    assert_eq!(group("the left"), [1]);
    // The line between the squares has a tag and no name; both its sides count.
    assert_eq!(group("curve_9"), [0, 2]);
    let names: Vec<&str> = mesh.curves.iter().map(|c| c.name.as_str()).collect();
    assert_eq!(names, ["curve_9", "the left"]);
    // Elements are on the left of their sides, though the second triangle runs clockwise.
    assert_eq!(mesh.curves[1].sides, [Side { point: 1, from: [0.0, 1.0], to: [0.0, 0.0] }]);
    let inner = [
        Side { point: 0, from: [1.0, 0.0], to: [1.0, 1.0] },
        Side { point: 2, from: [1.0, 1.0], to: [1.0, 0.0] },
    ];
    assert_eq!(mesh.curves[0].sides, inner);
    assert_eq!(read(SMALL.replace('\n', "\r\n").as_bytes()).unwrap(), mesh);
}

#[test]
fn the_bracket_of_the_gallery_has_its_area() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/plate/bracket.msh");
    let mesh = read(&std::fs::read(file).unwrap()).unwrap();
    assert_eq!(mesh.cloud.points(), 3120);
    let area: f64 = mesh.cloud.sizes().iter().sum();
    // 100 × 40 + 40 × 40 and a fillet of radius 10, less an eye of radius 10, all in mm; polygons for circles.
    let pi = std::f64::consts::PI;
    let exact = 1e-6 * (5600.0 + 100.0 * (1.0 - pi / 4.0) - 100.0 * pi);
    assert!((area - exact).abs() < 1e-3 * exact, "{area} {exact}");
    let length = |name: &str| -> f64 {
        let curve = mesh.curves.iter().find(|c| c.name == name).unwrap();
        curve.sides.iter().map(|s| (s.to[0] - s.from[0]).hypot(s.to[1] - s.from[1])).sum()
    };
    assert!((length("fixed") - 0.04).abs() < 1e-12);
    // Chords of the circle.
    assert!((length("loaded") - 0.02 * pi).abs() < 2e-3 * 0.02 * pi);
    assert_eq!(mesh.cloud.group("steel").unwrap().points.len(), 3120);
}

#[test]
fn faults_name_the_line() {
    let fault = |from: &str, to: &str| {
        assert!(SMALL.contains(from), "{from}");
        read(SMALL.replacen(from, to, 1).as_bytes()).unwrap_err().to_string()
    };
    assert_eq!(fault("$MeshFormat", "solid"), "line 1: is no Gmsh mesh: expected $MeshFormat");
    assert_eq!(fault("4.1 0 8", "4.1 1 8"), "line 2: the mesh is binary, ASCII is read");
    assert_eq!(fault("4.1 0 8", "2.2 0 8"), "line 2: the mesh has format 2.2, 4.1 is read");
    assert_eq!(fault("$EndComments", "$End"), "line 4: the section that starts here has no end");
    assert_eq!(fault("\"steel\"", "steel"), "line 10: expected dimension, tag and name in quotes");
    assert_eq!(
        fault("\"the left\"", "\"steel\""),
        "a physical curve and a physical surface have the name `steel`"
    );
    assert_eq!(fault("2 10 1 1000", "2 11 1 1000"), "line 23: the section says 11 nodes and has 10");
    assert_eq!(fault("1 1 5 1\n2 1", "1 nan 5 1\n2 1"), "line 28: coordinates of a node: y is not finite");
    assert_eq!(
        fault("1.5 0 5", "1.5 0"),
        "line 42: coordinates of a node: expected z, found the end of the line"
    );
    assert_eq!(fault("50 1 10 20", "50 1 10 21"), "line 56: the element has a node 21, which does not exist");
    assert_eq!(fault("50 1 10 20", "50 1 10 20 2"), "line 56: an element: expected 3 nodes, found more");
    assert_eq!(
        fault("50 1 10 20", "50 1 10 x"),
        "line 56: an element: expected the tag of a node, found `x`"
    );
    assert_eq!(fault("51 1 2 20", "51 1 1 20"), "line 57: the element has no area");
    assert_eq!(
        fault("51 1 2 20", "51 10 1 20"),
        "line 57: the element is at the place of the one in line 56"
    );
    assert_eq!(
        fault("0 1 5\n2 0", "0 1 6\n2 0"),
        "line 57: the element has a corner at z = 6, others are at z = 5"
    );
    assert_eq!(fault("2 2 16 1", "2 2 36 1"), "line 58: elements of type 36 are not read");
    assert_eq!(
        fault("5 6 1 100", "9999999999999 6 1 100"),
        "line 60: a block of elements: expected the dimension of its entity, found `$EndElements`"
    );
    let none = SMALL.split("$Nodes").next().unwrap();
    assert_eq!(read(none.as_bytes()).unwrap_err().to_string(), "has no triangles or quadrilaterals");
}

/// Two tetrahedra of second order beside each other in two volumes, the second turned inside out, a physical surface on one side and one
/// between them.
const SOLID: &str = r#"$MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
3
2 1 "side"
2 2 "between"
3 5 "first"
$EndPhysicalNames
$Entities
0 0 2 2
1 0 0 0 1 1 1 1 1 0
2 0 0 0 1 1 1 1 2 0
1 0 0 0 1 1 1 1 5 0
2 0 0 0 1 1 1 1 9 0
$EndEntities
$Nodes
1 5 1 5
3 1 0 5
1
2
3
4
5
0 0 0
1 0 0
0 1 0
0 0 1
1 1 1
$EndNodes
$Elements
4 4 1 4
2 1 2 1
1 1 3 2
2 2 2 1
2 4 3 2
3 1 4 1
3 1 2 3 4
3 2 4 1
4 2 3 4 5
$EndElements
"#;

#[test]
fn tetrahedra_have_a_border_with_surfaces_and_volumes() {
    let read = read_solid(SOLID.as_bytes()).unwrap();
    assert_eq!(read.surface.names, ["side", "between"]);
    assert_eq!(read.surface.facets.len(), 6);
    let named = |name| read.surface.facets.iter().filter(|f| f.name == name).count();
    assert_eq!([named(Some(0)), named(Some(1)), named(None)], [1, 0, 5]);
    let volume =
        |facets: &[Facet]| Surface::new(facets.to_vec(), read.surface.names.clone()).unwrap().volume();
    let parts: Vec<(&str, f64)> =
        read.parts.iter().map(|(name, part)| (name.as_str(), volume(part))).collect();
    // 1/6, and 1/3 of a cube whose corner tetrahedra are taken away.
    let expected = [("first", 1.0 / 6.0), ("volume_9", 1.0 / 3.0)];
    for ((name, volume), expected) in parts.iter().zip(expected) {
        assert!(*name == expected.0 && (volume - expected.1).abs() < 1e-15, "{parts:?}");
    }
    assert!((volume(&read.surface.facets) - 0.5).abs() < 1e-15);
}

#[test]
fn faults_of_solids_name_the_line() {
    let fault = |from: &str, to: &str| {
        assert!(SOLID.contains(from), "{from}");
        read_solid(SOLID.replacen(from, to, 1).as_bytes()).unwrap_err().to_string()
    };
    assert_eq!(fault("3 1 2 3 4\n", "3 1 2 3 3\n"), "line 38: the element has no volume");
    assert_eq!(
        fault("3 1 2 3 4\n", "3 1 2 3 7\n"),
        "line 38: the element has a node 7, which does not exist"
    );
    assert_eq!(fault("3 2 4 1\n", "3 2 5 1\n"), "line 39: elements of type 5 are not read");
    assert_eq!(
        fault("3 5 \"first\"", "3 5 \"side\""),
        "a physical surface and a physical volume have the name `side`"
    );
    assert_eq!(
        fault("2 0 0 0 1 1 1 1 2 0", "2 0 0 0 1 1 1 2 2 1 0"),
        "line 36: the triangle is in the physical surfaces `between` and `side`"
    );
    let third = SOLID
        .replace("4 4 1 4", "4 5 1 5")
        .replace("3 2 4 1\n4 2 3 4 5\n", "3 2 4 2\n4 2 3 4 5\n5 2 3 4 1\n");
    let third = read_solid(third.as_bytes()).unwrap_err().to_string();
    assert_eq!(third, "line 41: a side of the element belongs to two others");
    let plane = read_solid(SMALL.as_bytes()).unwrap_err();
    assert_eq!(plane.to_string(), "has no tetrahedra");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]
    #[test]
    fn any_change_of_bytes_is_read_or_refused(
        changes in proptest::collection::vec((0..SMALL.len(), any::<u8>(), 0..3u8), 1..6), end in 0..2 * SMALL.len(),
    ) {
        let mut bytes = SMALL.as_bytes().to_vec();
        for (at, byte, how) in changes {
            let at = at.min(bytes.len() - 1);
            match how {
                0 => bytes[at] = byte,
                1 => bytes[at] = b'0' + byte % 10,
                _ => bytes.insert(at, b"-9 .e\n$"[usize::from(byte % 7)]),
            }
        }
        bytes.truncate(end);
        let _ = read(&bytes);
        let _ = read_solid(&bytes);
    }

    #[test]
    fn any_lines_are_read_or_refused(lines in proptest::collection::vec(0..SMALL.lines().count(), 0..80)) {
        let all: Vec<&str> = SMALL.lines().collect();
        let picked: Vec<&str> = all[..3].iter().copied().chain(lines.into_iter().map(|k| all[k])).collect();
        let _ = read(picked.join("\n").as_bytes());
    }

    #[test]
    fn any_bytes_are_refused(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        prop_assert!(read(&bytes).is_err());
    }
}
