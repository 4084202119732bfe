use super::*;
use proptest::prelude::*;

const PLATE: &str = include_str!("../../../../../cases/plate/lug.dxf");
const GUSSET: &str = include_str!("../../../../../cases/plate/gusset.svg");
const LINK: &str = include_str!("../../../../../cases/plate/link.msh");

/// A DXF file of entities: kind and groups.
fn dxf(entities: &[(&str, &[(i32, &str)])]) -> String {
    let mut text = "0\nSECTION\n2\nENTITIES\n".to_string();
    for (kind, groups) in entities {
        text += &format!("0\n{kind}\n");
        groups.iter().for_each(|(code, value)| text += &format!("{code}\n{value}\n"));
    }
    text + "0\nENDSEC\n0\nEOF\n"
}

fn svg(inner: &str) -> String {
    format!("<svg viewBox=\"0 0 20 10\">\n{inner}\n</svg>")
}

fn drawn(text: &str) -> Drawing {
    read(text.as_bytes(), 0.01).unwrap_or_else(|error| panic!("{error}"))
}

fn fault(text: &str) -> String {
    read(text.as_bytes(), 0.01).unwrap_err().to_string()
}

fn line(layer: &'static str, [x, y, u, v]: [&'static str; 4]) -> (&'static str, Vec<(i32, &'static str)>) {
    ("LINE", vec![(8, layer), (10, x), (20, y), (11, u), (21, v)])
}

fn lines(all: &[(&'static str, Vec<(i32, &'static str)>)]) -> String {
    let all: Vec<(&str, &[(i32, &str)])> = all.iter().map(|(kind, groups)| (*kind, &groups[..])).collect();
    dxf(&all)
}

#[test]
fn lines_in_any_order_and_direction_are_a_loop_with_the_names_of_layers() {
    let all = [
        line("top", ["4", "2", "0", "2"]),
        line("side", ["4", "0", "4", "2"]),
        // One line in two parts.
        line("base", ["2", "0", "4", "0"]),
        line("base", ["2", "0", "0", "0"]),
        line("side", ["0", "0", "0", "2"]),
    ];
    let found = drawn(&lines(&all));
    assert_eq!(found.border.vertices, [[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [0.0, 2.0]]);
    assert_eq!(found.border.sides, [1; 4]);
    let edge = BorderMember::Edge;
    let names = [("base", vec![edge(0)]), ("side", vec![edge(1), edge(3)]), ("top", vec![edge(2)])];
    assert_eq!(found.names, names.map(|(name, members)| (name.to_string(), members)));
}

#[test]
fn bulges_arcs_circles_and_paths_are_the_same_shape() {
    // A stadium 4 by 2 with a hole.
    let polyline: &[(i32, &str)] = &[
        (8, "rim"),
        (90, "4"),
        (70, "1"),
        (10, "1"),
        (20, "0"),
        (10, "3"),
        (20, "0"),
        (42, "1"),
        (10, "3"),
        (20, "2"),
        (10, "1"),
        (20, "2"),
        (42, "1"),
    ];
    let circle: &[(i32, &str)] = &[(8, "bore"), (10, "2"), (20, "1"), (40, "0.5")];
    let by_bulge = drawn(&dxf(&[("LWPOLYLINE", polyline), ("CIRCLE", circle)]));
    let arc = |x: &'static str, from: &'static str, to: &'static str| {
        ("ARC", vec![(8, "rim"), (10, x), (20, "1"), (40, "1"), (50, from), (51, to)])
    };
    let all = [
        line("rim", ["1", "0", "3", "0"]),
        arc("3", "270", "90"),
        line("rim", ["1", "2", "3", "2"]),
        arc("1", "90", "270"),
        ("CIRCLE", circle.to_vec()),
    ];
    let by_arc = drawn(&lines(&all));
    let by_path = drawn(&svg(
        "<path id='rim' d='M1 10H3a1 1 0 0 0 0-2H1A1,1 0,0 0 1,10z'/><circle id='bore' cx='2' cy='9' r='.5'/>",
    ));
    let area = |drawing: &Drawing| {
        let v = &drawing.border.vertices;
        let next = v.iter().cycle().skip(1);
        0.5 * v.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum::<f64>()
    };
    for found in [&by_bulge, &by_arc, &by_path] {
        assert!((area(found) - 4.0 - std::f64::consts::PI).abs() < 0.06, "{}", area(found));
        assert_eq!(found.holes.len(), 1, "{found:?}");
        let DrawnHole::Circle { centre, radius } = found.holes[0] else { panic!("a circle") };
        assert_eq!((centre, radius), ([2.0, 1.0], 0.5));
        let names: Vec<&str> = found.names.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["bore", "rim"]);
        assert_eq!(found.border.sides.iter().filter(|count| **count > 1).count(), 2);
    }
}

#[test]
fn transforms_and_shapes_of_svg_are_where_they_are_drawn() {
    let found = drawn(&svg("<defs><rect width='1' height='1'/></defs>
         <g transform='translate(2 1)'><rect id='plate' width='8' height='6'/>
         <g transform='scale(2)'><polygon points='1,1 2,1 1,2'/></g></g>"));
    assert_eq!(found.border.vertices, [[2.0, 3.0], [10.0, 3.0], [10.0, 9.0], [2.0, 9.0]]);
    let DrawnHole::Loop(hole) = &found.holes[0] else { panic!("a loop") };
    assert_eq!(hole.vertices, [[4.0, 5.0], [6.0, 7.0], [4.0, 7.0]]);
    let rounded = drawn(&svg("<rect x='0' y='0' width='8' height='6' rx='1'/>"));
    assert_eq!(rounded.border.sides.iter().filter(|count| **count == 1).count(), 4);
    let disc = drawn(&svg("<circle r='1'/>"));
    assert!(disc.holes.is_empty() && disc.border.vertices.len() > 8);
}

#[test]
fn a_hole_of_several_names_has_them_on_its_edges() {
    let found = drawn(&svg(
        "<rect width='8' height='6'/><path id='sill' d='M2 4H6'/><path id='frame' d='M6 4V2H2V4'/>",
    ));
    let sill = found.names.iter().find(|(name, _)| name == "sill").unwrap();
    assert_eq!(sill.1.len(), 1);
    assert!(matches!(sill.1[0], BorderMember::HoleEdge { hole: 0, .. }));
}

#[test]
fn faults_say_the_line_and_what_is_wrong() {
    let square = |x: f64| format!("<rect x='{x}' width='4' height='4'/>\n");
    let cases = [
        (svg("<path d='M0 0H4V4'/>"), "line 2: the outline is open at (0, 10)"),
        (svg("<path d='M0 0H4V4H0Z M0 0L4 4'/>"), "3 lines end at"),
        (svg("<path d='M0 0L4 4V0L0 4Z'/>"), "crosses or touches itself"),
        (svg(&(square(0.0) + &square(6.0))), "line 3: there is a second outline beside that of line 2"),
        (
            svg(&(square(0.0) + "<circle cx='2' cy='2' r='1.5'/><circle cx='2' cy='2' r='1'/>")),
            "is in the hole of line 3",
        ),
        (svg("<text>plate</text>"), "has no closed line"),
        (svg("<use href='#a'/>"), "line 2: elements `use` are not read"),
        (svg("<rect width='4mm' height='4'/>"), "expected a number of `width`, found `4mm`"),
        (svg("<rect width='4'/>"), "the `rect` has no attribute `height`"),
        (svg("<circle r='0'/>"), "the radius of a circle must be greater than zero"),
        (svg("<path d='M0 0 X'/>"), "the path is broken"),
        ("<svg><g></svg>".into(), "the XML is broken"),
        ("<html/>".into(), "expected `svg`, found `html`"),
        ("plate".into(), "is no Gmsh mesh, no DXF file and no SVG file"),
        (dxf(&[("SPLINE", &[(8, "0")])]), "line 6: entities `SPLINE` are not read"),
        (dxf(&[("LINE", &[(10, "0"), (20, "0"), (11, "1")])]), "the LINE has no group 21"),
        (dxf(&[("CIRCLE", &[(10, "0"), (20, "x"), (40, "1")])]), "expected a number of group 20, found `x`"),
        ("0\nSECTION\n2\nHEADER\n0\nENDSEC\n0\nEOF\n".into(), "has no section `ENTITIES`"),
        ("0\nSECTION\n2\nENTITIES\n0".into(), "the file ends where the value of a group belongs"),
        ("0\nSECTION\n2\nENTITIES\nLINE\n0\n".into(), "expected the number of a group, found `LINE`"),
    ];
    for (text, wanted) in cases {
        let found = fault(&text);
        assert!(found.contains(wanted), "{found:?} instead of {wanted:?}");
    }
    let deep = svg(&"<g>".repeat(100_000));
    assert!(fault(&deep).contains("deep within each other"));
}

#[test]
fn what_a_style_hides_is_left_out_and_what_it_moves_is_refused() {
    let plate = "<rect width='8' height='4'/>";
    for hidden in [
        "style='display:none'",
        "display='none'",
        "style='fill:red; visibility: hidden'",
        "visibility='hidden'",
    ] {
        let layer = format!("{plate}<g {hidden}><path d='M1 1L9 9'/></g>");
        assert_eq!(drawn(&svg(&layer)).border.vertices.len(), 4, "{hidden}");
    }
    assert_eq!(
        drawn(&svg(&format!("<style>.a{{fill:none;stroke-width:1}}</style>{plate}"))).border.vertices.len(),
        4
    );
    for (inner, wanted) in [
        ("<svg x='3'><rect width='1' height='1'/></svg>", "drawings `svg` within a drawing"),
        ("<style>.hidden { display : none }</style>", "style sheets with `display`"),
        ("<g style='transform:scale(2)'><rect width='1' height='1'/></g>", "styles with `transform`"),
        ("<switch><rect width='1' height='1'/></switch>", "elements `switch`"),
    ] {
        let found = fault(&svg(&format!("{plate}{inner}")));
        assert!(found.contains(wanted), "{found}");
    }
}

#[test]
fn curves_of_dxf_out_of_their_plane_are_refused_and_frames_of_splines_left_out() {
    let up: &[(i32, &str)] = &[(10, "0"), (20, "0"), (30, "0"), (11, "4"), (21, "0"), (31, "1")];
    let tilted: &[(i32, &str)] = &[(10, "0"), (20, "0"), (40, "1"), (210, "0"), (220, "0.7"), (230, "0.7")];
    let in_space: &[(i32, &str)] = &[(70, "9")];
    for (kind, groups) in [("LINE", up), ("CIRCLE", tilted), ("POLYLINE", in_space)] {
        let found = fault(&dxf(&[(kind, groups)]));
        assert!(found.contains(&format!("the {kind} leaves the plane")), "{found}");
    }
    let vertex = |x: &'static str, y: &'static str, bits: &'static str| [(10, x), (20, y), (70, bits)];
    let corners =
        [vertex("0", "0", "8"), vertex("9", "9", "16"), vertex("4", "0", "8"), vertex("4", "2", "8")];
    let mut entities: Vec<(&str, &[(i32, &str)])> = vec![("POLYLINE", &[(70, "5")])];
    entities.extend(corners.iter().map(|groups| ("VERTEX", &groups[..])));
    entities.push(("SEQEND", &[]));
    assert_eq!(drawn(&dxf(&entities)).border.vertices, [[0.0, 0.0], [4.0, 0.0], [4.0, 2.0]]);
}

#[test]
fn curves_with_too_many_chords_are_refused() {
    let text = svg(&format!("<path d='M0 0{}'/>", "a1 1 0 0 1 2 0".repeat(300)));
    let error = read(text.as_bytes(), 1e-12).unwrap_err();
    assert!(error.message.contains("more than 4000000 chords"), "{error}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn broken_drawings_give_a_drawing_or_a_fault(
        which in 0..3usize,
        cuts in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0..4u8), 1..6),
    ) {
        let mut bytes = [PLATE, GUSSET, LINK][which].as_bytes().to_vec();
        for (at, byte, how) in cuts {
            if bytes.is_empty() {
                continue;
            }
            let k = at.index(bytes.len());
            match how {
                0 => bytes[k] = byte,
                1 => bytes.truncate(k),
                2 => drop(bytes.remove(k)),
                _ => bytes.insert(k, b"0123456789.-e\n<>\"'AMZ"[byte as usize % 21]),
            }
        }
        if let Ok(found) = read(&bytes, 0.05) {
            prop_assert!(found.border.vertices.len() == found.border.sides.iter().sum::<usize>());
            prop_assert!(found.border.vertices.iter().flatten().all(|x| x.is_finite()));
        }
    }
}
