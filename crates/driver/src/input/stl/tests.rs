use super::*;
use peristat_assembly::body::Surface;
use proptest::prelude::*;

/// A tetrahedron with a face of its own name; names, cases and blanks as programs write them.
const SMALL: &str = "solid the base
  facet normal 0 0 -1
    outer loop
      vertex 0 0 0
      vertex 0 1 0
      vertex 1.0e0 0 0
    endloop
  endfacet
endsolid the base
SOLID
facet normal nan nan nan
OUTER LOOP
VERTEX 0 0 0
VERTEX 1 0 0
VERTEX 0 0 1
ENDLOOP
ENDFACET
facet normal 0 0 0
outer  loop
vertex 0 0 0
vertex 0 0 1
vertex 0 1 0
endloop
endfacet
facet normal 0 0 0
outer loop
vertex 1 0 0
vertex 0 1 0
vertex 0 0 1
endloop
endfacet
endsolid
";

/// The same in binary, behind 80 bytes that begin like one in ASCII.
fn binary() -> Vec<u8> {
    let facets = read(SMALL.as_bytes()).unwrap().facets;
    let mut bytes = [b' '; 80].to_vec();
    bytes[..14].copy_from_slice(b"solid by a CAD");
    bytes.extend((facets.len() as u32).to_le_bytes());
    for facet in facets {
        bytes.extend([0; 12]);
        bytes.extend(facet.corners.iter().flatten().flat_map(|x| (0.1 * *x as f32).to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

#[test]
fn sections_with_names_are_parts() {
    let read = read(SMALL.as_bytes()).unwrap();
    assert_eq!(read.names, ["the base"]);
    assert_eq!(read.facets.iter().map(|f| f.name).collect::<Vec<_>>(), [Some(0), None, None, None]);
    assert_eq!(read.facets[0].corners, [[0.0; 3], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]);
    let volume = Surface::new(read.facets, read.names).unwrap().volume();
    assert!((volume - 1.0 / 6.0).abs() < 1e-15);
    assert_eq!(super::read(SMALL.replace('\n', "\r\n").as_bytes()).unwrap().facets.len(), 4);
}

#[test]
fn one_section_alone_has_no_name() {
    let whole = SMALL.replace("endsolid the base\nSOLID\n", "");
    let read = read(whole.as_bytes()).unwrap();
    assert!(read.names.is_empty() && read.facets.len() == 4 && read.facets.iter().all(|f| f.name.is_none()));
}

#[test]
fn binary_files_that_begin_like_text_have_the_decimals_that_were_drawn() {
    let read = read(&binary()).unwrap();
    assert_eq!(read.facets[0].corners, [[0.0; 3], [0.0, 0.1, 0.0], [0.1, 0.0, 0.0]]);
    assert!(Surface::new(read.facets, Vec::new()).is_ok());
}

#[test]
fn faults_say_what_is_wrong() {
    let fault = |bytes: &[u8]| read(bytes).unwrap_err().to_string();
    let text = |from: &str, to: &str| {
        assert!(SMALL.contains(from), "{from}");
        fault(SMALL.replacen(from, to, 1).as_bytes())
    };
    assert_eq!(text("vertex 0 1 0", "vertex 0 1"), "line 5: a vertex: expected z, found the end of the line");
    assert_eq!(text("vertex 0 1 0", "vertex 0 inf 0"), "line 5: a vertex: y is not finite");
    assert_eq!(text("outer loop", "outer"), "line 3: expected `outer loop`, found `outer`");
    assert_eq!(text("endloop", "vertex 0 0 0"), "line 7: expected `endloop`, found `vertex 0 0 0`");
    assert_eq!(text("endsolid the base\n", ""), "line 9: expected `facet` or `endsolid`, found `SOLID`");
    assert_eq!(fault(SMALL.rsplit_once("endfacet").unwrap().0.as_bytes()), "ends where endfacet belongs");
    assert_eq!(fault(b""), "is no STL file: 0 bytes are too few");
    let whole = binary();
    assert_eq!(fault(&whole[..whole.len() - 30]), "says that it has 4 triangles, and has bytes for 3.4");
    let mut wrong = whole.clone();
    wrong[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
    assert_eq!(fault(&wrong), "says that it has 4294967295 triangles, and has bytes for 4");
    wrong[80..84].copy_from_slice(&3u32.to_le_bytes());
    assert_eq!(fault(&wrong), "says that it has 3 triangles, and has bytes for 4");
    let mut none = whole;
    none[96..100].copy_from_slice(&f32::NAN.to_le_bytes());
    let error = Surface::new(read(&none).unwrap().facets, Vec::new()).unwrap_err();
    assert_eq!(error.to_string(), "has a triangle with a corner that is not finite: number 1");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]
    #[test]
    fn any_change_of_bytes_is_read_or_refused(
        is_binary in any::<bool>(), changes in proptest::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6), end in any::<prop::sample::Index>(),
    ) {
        let mut bytes = if is_binary { binary() } else { SMALL.as_bytes().to_vec() };
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        bytes.truncate(end.index(2 * bytes.len()));
        if let Ok(read) = read(&bytes) && let Ok(surface) = Surface::new(read.facets, read.names) {
            let bounds = surface.bounds();
            let most = (0..3).map(|k| bounds[1][k] - bounds[0][k]).fold(0.0, f64::max);
            if let Ok(grid) = surface.grid(most / 7.0) {
                let filled = surface.fill(&grid).lattice;
                surface.walls(&grid, &filled);
            }
        }
    }

    #[test]
    fn any_bytes_are_refused(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        prop_assert!(read(&bytes).is_err());
    }
}
