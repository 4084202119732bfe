//! Pictures in the formats that a case asks for.

use super::support::{gallery, names, run};
use std::fs;
use std::path::Path;

fn pictures(folder: &Path, ending: &str) -> Vec<String> {
    let all = names(&folder.join("plots")).into_iter();
    all.filter_map(|name| name.strip_suffix(ending).map(String::from)).collect()
}

#[test]
fn every_picture_of_a_run_has_the_formats_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    // Diagrams, pictures of frames, maps and slices of a solid.
    for case in ["cantilever.json", "../frame/portal.json", "../plate/shear.json", "../solid/bent_bar.json"] {
        let path = gallery(case);
        let formats = r#"drawing.formats=["png","pdf"]"#;
        let run = |set: &str| {
            run(folder.path(), &["run", &path, "-o", "out", "-q", "--fields", "none", "--set", set])
        };
        let out = folder.path().join("out");
        let outcome = run(formats);
        assert_eq!(outcome.code, 0, "{case}: {}", outcome.stderr);
        let svg = pictures(&out, ".svg");
        assert!(!svg.is_empty(), "{case}");
        for (ending, begin) in [(".png", &b"\x89PNG"[..]), (".pdf", b"%PDF")] {
            assert_eq!(pictures(&out, ending), svg, "{case}");
            for name in &svg {
                let bytes = fs::read(out.join(format!("plots/{name}{ending}"))).unwrap();
                assert!(bytes.starts_with(begin) && bytes.len() > 1000, "{case}: {name}{ending}");
            }
        }
        // The next run takes them away.
        assert_eq!(run(r#"drawing.formats=["png"]"#).code, 0, "{case}");
        assert_eq!((pictures(&out, ".png"), pictures(&out, ".pdf")), (svg, vec![]), "{case}");
        fs::remove_dir_all(&out).unwrap();
    }
}
