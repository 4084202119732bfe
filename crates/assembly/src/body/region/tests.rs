use super::*;
use crate::body::Hole;
use crate::body::geometry::{distance, to_segment};
use crate::body::polygon::Polygon;
use crate::body::{Cloud, Group};
use proptest::prelude::*;

fn plate() -> (Outline, PointBody) {
    let mut outline = Outline::rectangle([0.0; 2], [2.0, 1.0]).unwrap();
    let shape = Shape::Circle { centre: [0.5, 0.5], radius: 0.2 };
    outline.cut(Hole { name: Some("pin".into()), shape }).unwrap();
    let square = vec![[1.4, 0.4], [1.6, 0.4], [1.6, 0.6], [1.4, 0.6]];
    let shape = Shape::Polygon(Polygon::new(square).unwrap());
    outline.cut(Hole { name: Some("window".into()), shape }).unwrap();
    let lattice = outline.fill(0.1).unwrap();
    (outline, PointBody::Lattice(lattice))
}

fn as_cloud(body: &PointBody) -> PointBody {
    let all = 0..body.points();
    let positions = all.clone().map(|p| body.place(p)).collect();
    let group = Group { name: "some".into(), points: vec![7, 3, 3] };
    PointBody::Cloud(Cloud::in_plane(positions, all.map(|p| body.measure(p)).collect(), vec![group]).unwrap())
}

fn select(region: &Region) -> Result<Vec<u32>, RegionError> {
    let (outline, body) = plate();
    let mut named = BTreeMap::from([
        ("corners".into(), Region::Union { of: vec!["a".into(), "b".into()] }),
        ("a".into(), Region::Corner { at: [0.0, 0.0] }),
        ("b".into(), Region::Corner { at: [9.0, 0.5] }),
        ("loop".into(), Region::Union { of: vec!["a".into(), "loop".into()] }),
    ]);
    // Two hundred unions, each of the next one twice: of the last sixty there are 2⁶⁰ ways to a corner.
    named.extend((0..200).map(|k| {
        let next = if k == 199 { "a".into() } else { format!("u{}", k + 1) };
        (format!("u{k}"), Region::Union { of: vec![next.clone(), next] })
    }));
    let regions = Regions { body: &body, outline: Some(&outline), walls: &[], parts: &[], named: &named };
    let found = regions.select(region);
    // Listed points give the same answer, though another code finds it.
    let cloud = as_cloud(&body);
    if !matches!(region, Region::Group { .. }) {
        let listed = Regions { body: &cloud, ..regions };
        assert_eq!(found, listed.select(region));
        return found;
    }
    Regions { body: &cloud, ..regions }.select(region)
}

fn edge(name: &str, depth: Option<f64>) -> Region {
    Region::Edge { name: name.into(), depth }
}

#[test]
fn edges_corners_and_holes() {
    let count = |region: &Region| select(region).unwrap().len();
    for (name, cells) in [("left", 10), ("right", 10), ("bottom", 20), ("top", 20)] {
        assert_eq!(count(&edge(name, None)), cells, "{name}");
        assert_eq!(count(&edge(name, Some(0.25))), 3 * cells, "{name}");
        assert_eq!(count(&edge(name, Some(0.049))), 0, "{name}");
    }
    assert_eq!(select(&edge("bottom", None)).unwrap(), (0..20).collect::<Vec<u32>>());
    assert_eq!(select(&Region::Corner { at: [2.0, 0.0] }).unwrap(), [19]);
    // Amid four cells, and on the line between two.
    assert_eq!(count(&Region::Corner { at: [1.0, 0.5] }), 4);
    assert_eq!(count(&Region::Corner { at: [1.0, -3.0] }), 2);
    // Between circles of radius 2 and 3 around a corner of cells: 32 − 12 centres of cells.
    assert_eq!(count(&Region::Hole { name: "pin".into(), depth: None }), 20);
    // The layer of cells around a square of 2 × 2: the nearest centres are half a spacing off.
    assert_eq!(count(&Region::Hole { name: "window".into(), depth: Some(0.08) }), 12);
}

#[test]
fn boxes_discs_half_planes_and_groups() {
    let count = |region: &Region| select(region).unwrap().len();
    // Centres of cells as corners: borders count.
    let on_centres = Region::Box { from: [0.35, 0.15], to: [0.05, 0.05] };
    assert_eq!(select(&on_centres).unwrap(), [0, 1, 2, 3, 20, 21, 22, 23]);
    assert_eq!(count(&Region::Box { from: [1.05, 0.0], to: [1.05, 1.0] }), 10);
    assert_eq!(count(&Region::Disc { centre: [1.05, 0.45], radius: 0.2 }), 13);
    assert_eq!(count(&Region::HalfPlane { point: [1.95, 0.0], normal: [3.0, 0.0] }), 10);
    assert_eq!(count(&Region::HalfPlane { point: [0.0, 0.95], normal: [0.0, 2.0] }), 20);
    // x + y ≤ 0.3 through centres.
    assert_eq!(count(&Region::HalfPlane { point: [0.15, 0.15], normal: [-1.0, -1.0] }), 6);
    assert_eq!(select(&Region::Group { name: "some".into() }).unwrap(), [3, 7]);
    assert_eq!(select(&Region::Union { of: vec!["corners".into(), "a".into()] }).unwrap().len(), 3);
}

#[test]
fn faults_are_named() {
    let unknown = select(&edge("lefft", None)).unwrap_err();
    assert_eq!(unknown.to_string(), "there is no edge `lefft`, only bottom, right, top, left, pin, window");
    assert!(matches!(
        select(&Region::Hole { name: "x".into(), depth: None }),
        Err(RegionError::Unknown { kind: "hole", .. })
    ));
    let looped = Region::Union { of: vec!["loop".into()] };
    assert_eq!(select(&looped), Err(RegionError::Cycle { name: "loop".into() }));
    let nested = |first: usize| select(&Region::Union { of: vec![format!("u{first}")] });
    assert_eq!(nested(140), Ok(vec![0]));
    assert_eq!(nested(0), Err(RegionError::Deep));
    assert_eq!(
        select(&edge("left", Some(-1.0))),
        Err(RegionError::NotPositive { what: "depth", found: -1.0 })
    );
    let flat = Region::HalfPlane { point: [0.0; 2], normal: [0.0; 2] };
    assert_eq!(select(&flat), Err(RegionError::Position { what: "normal" }));
}

proptest! {
    /// Rows of a turned lattice are searched in its own axes, listed points one by one.
    #[test]
    fn turned_points_are_those_of_a_list(
        angle in 0.01..1.56f64, at in [-0.2..2.2f64, -0.2..1.2], to in [-0.2..2.2f64, -0.2..1.2], size in 0.05..0.6f64,
    ) {
        let (outline, _) = plate();
        let body = PointBody::Lattice(outline.fill_turned(0.07, angle).unwrap());
        let cloud = as_cloud(&body);
        let named = BTreeMap::new();
        let on = |body| Regions { body, outline: Some(&outline), walls: &[], parts: &[], named: &named };
        let normal = [to[0] - at[0], to[1] - at[1]];
        let own = |name: &str| Region::Hole { name: name.into(), depth: Some(size) };
        let regions = [
            Region::Corner { at },
            Region::Box { from: at, to },
            Region::Disc { centre: at, radius: size },
            Region::HalfPlane { point: at, normal },
            edge("left", Some(0.07)),
            edge("top", Some(size)),
            own("pin"),
            own("window"),
        ];
        for region in regions {
            prop_assert_eq!(on(&body).select(&region), on(&cloud).select(&region), "{:?}", region);
        }
        // A strip as deep as the spacing has one point per spacing, more or less by the last layer: at 45° one or two layers
        // of 1/√2 each. Those at the ends are in or out.
        let found = on(&body).select(&edge("left", None)).unwrap().len() as f64 * 0.07;
        prop_assert!((0.6..1.5).contains(&found), "{}", found);
    }

    #[test]
    fn edges_of_polygons_are_measured_along_their_normal(
        turn in 0.0..6.3f64, depth in 0.3..3.0f64, reverse: bool, which in 0..4usize,
    ) {
        let place = |x: f64, y: f64| [x * turn.cos() - y * turn.sin(), x * turn.sin() + y * turn.cos()];
        let mut vertices = vec![place(0.0, 0.0), place(7.0, 0.0), place(6.0, 5.0), place(1.0, 4.0)];
        if reverse {
            vertices.reverse();
        }
        let outline = Outline::polygon(vertices).unwrap();
        let body = PointBody::Lattice(outline.fill(0.31).unwrap());
        let regions = Regions { body: &body, outline: Some(&outline), walls: &[], parts: &[], named: &BTreeMap::new() };
        let found = regions.select(&edge(&format!("edge_{}", which + 1), Some(depth))).unwrap();
        let e = &outline.edges()[which];
        for p in 0..body.points() {
            let at = body.place(p);
            let along = crate::body::geometry::dot(
                crate::body::geometry::minus(at, e.from), crate::body::geometry::minus(e.to, e.from),
            ) / distance(e.from, e.to);
            let inside = to_segment(at, e.from, e.to) <= depth && (0.0..=distance(e.from, e.to)).contains(&along);
            prop_assert_eq!(found.binary_search(&(p as u32)).is_ok(), inside, "{:?}", at);
        }
    }
}
