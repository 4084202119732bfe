use super::{tidied, tokens};
use proptest::prelude::*;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};

fn tidy(text: &str) -> String {
    tidied("case", text).unwrap_or_else(|report| panic!("{report}\n{text}"))
}

/// Tidies twice, and finds every word, number and comment again.
fn checked(text: &str) -> String {
    let once = tidy(text);
    assert_eq!(tidy(&once), once, "of {text:?}");
    let value = |text: &str| super::parse::<Value>("case", text).unwrap();
    assert_eq!(value(&once), value(text), "{text:?}");
    let pieces = |text: &str, kind| -> Vec<String> {
        let text = text.replace("\r\n", "\n");
        tokens::tokens(&text).iter().filter(|t| t.kind == kind).map(|t| t.text.to_string()).collect()
    };
    let (scalars, comments) = (tokens::Kind::Scalar, tokens::Kind::Comment);
    assert_eq!(pieces(&once, scalars), pieces(text, scalars), "{text:?}");
    let (mut found, mut written) = (pieces(&once, comments), pieces(text, comments));
    found.sort();
    written.sort();
    assert_eq!(found, written, "{text:?}\n{once}");
    assert!(once.lines().all(|line| line.trim_end() == line || text.contains("/*")), "{once}");
    once
}

fn cases(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let of = |path: PathBuf| if path.is_dir() { cases(&path) } else { vec![path] };
    entries.flat_map(of).filter(|path| path.extension().is_some_and(|e| e == "json")).collect()
}

fn gallery() -> Vec<(PathBuf, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let read = |path: PathBuf| Some((path.clone(), fs::read_to_string(path).ok()?));
    cases(&folder).into_iter().filter_map(read).collect()
}

#[test]
fn the_gallery_is_tidy_and_its_faults_keep_their_words() {
    let mut untidy = Vec::new();
    let mut seen = 0;
    for (path, text) in gallery() {
        let is_invalid = path.components().any(|part| part.as_os_str() == "invalid");
        if super::parse::<Value>("case", &text).is_ok() {
            seen += 1;
            if checked(&text) != text && !is_invalid {
                untidy.push(path);
            }
        }
    }
    assert!(seen > 400, "{seen}");
    assert!(untidy.is_empty(), "`peristat fmt` would change {untidy:#?}");
    for start in peristat::model::starts() {
        assert_eq!(checked(start.case), start.case, "{}", start.name);
    }
}

#[test]
fn comments_stand_where_they_say_something() {
    let text = "// head\n\n{ // of the case\n\"a\":1,// of a\n\n\n// of b\n/* too */ \"b\" // key\n: /* x */ [ 1 , 2,\n3 ] , /* c */ \"c\":{},
        \"d\": {\n // empty\n }, \"e\": { \"f\": 1 // of f\n}, \"g\": [ /* no */ ], \"h\": [1, // one\n2\n// end\n,],\n}// foot\n\n\n// end";
    let expected = "// head

{ // of the case
  \"a\": 1, // of a

  // of b
  /* too */ // key
  \"b\": /* x */ [1, 2, 3],
  /* c */ \"c\": {},
  \"d\": {
    // empty
  },
  \"e\": {
    \"f\": 1 // of f
  },
  \"g\": [ /* no */ ],
  \"h\": [
    1, // one
    2 // end
  ]
} // foot

// end
";
    assert_eq!(checked(text), expected);
}

#[test]
fn lines_are_joined_filled_and_kept() {
    for (text, expected) in [
        ("{}", "{}\n"),
        (" 5 ", "5\n"),
        ("{\"a\":{\"b\":[{\"c\":1}]}}", "{\n  \"a\": { \"b\": [ { \"c\": 1 } ] }\n}\n"),
        ("{\"a\":{\n\"b\":[\n1,\n2]}}", "{\n  \"a\": {\n    \"b\": [1, 2]\n  }\n}\n"),
        ("{\"n\":1.0e+05,\r\n\"m\":-0}", "{\r\n  \"n\": 1.0e+05,\r\n  \"m\": -0\r\n}\r\n"),
    ] {
        assert_eq!(checked(text), expected);
    }
    let numbers = (0..100).map(|k| k.to_string()).collect::<Vec<_>>().join(", ");
    let filled = checked(&format!("{{ \"a\": [{numbers}] }}"));
    assert!(filled.lines().count() > 4 && filled.lines().all(|line| line.chars().count() <= 160), "{filled}");
    let long = "x".repeat(300);
    let kept = format!("{{\n  \"a\": [ {{ \"b\": \"{long}\" }} ]\n}}\n");
    assert_eq!(checked(&kept), kept);
}

/// What may stand between two tokens.
fn between() -> impl Strategy<Value = String> {
    let piece = prop_oneof![
        4 => Just(""),
        2 => Just(" "),
        2 => Just("\n"),
        1 => Just("\n\n \n"),
        1 => Just("\r\n"),
        1 => Just("// a \" { , \n"),
        1 => Just("// b\r\n"),
        1 => Just("/* c ] // */"),
        1 => Just("/* d\n  e */"),
        1 => Just("/**/"),
    ];
    prop::collection::vec(piece, 0..4).prop_map(|pieces| pieces.concat())
}

proptest! {
    #[test]
    fn comments_in_hostile_places_are_kept(which in 0usize..8, gaps in prop::collection::vec(between(), 40)) {
        let bodies = [
            "{ \"a\" : [ 1 , 2 , ] , \"b\" : { \"c\" : { } , } , \"d\" : [ [ 1 , 2 ] , [ 3 , 4 ] , ] }",
            "[ { \"a\" : 1 , \"b\" : [ ] , } , { \"c\" : [ { } , [ ] ] } , -1.50 ]",
            "[ [ [ ] ] , [ [ 1 ] , [ \"x // y\" , ] , ] , null ]",
            "{ \"a\" : { \"b\" : { \"c\" : { \"d\" : true , } } } }",
            "[ 1 , 2 , 3 , 4 , 5 , ]",
            "\"alone\"",
            "{ }",
            "[ { } , ]",
        ];
        let mut gaps = gaps.iter().cycle();
        let mut text = gaps.next().cloned().unwrap_or_default();
        for token in bodies[which].split_inclusive(' ') {
            text.push_str(token);
            // A text with blanks in it is no place for more.
            if !token.contains('x') && !token.contains("//") {
                text.push_str(gaps.next().unwrap());
            }
        }
        checked(&text);
    }

    #[test]
    fn comments_between_any_words_of_the_gallery_are_kept(pick in 0usize..10_000, gaps in prop::collection::vec(between(), 64)) {
        let all = gallery();
        let (_, text) = &all[pick % all.len()];
        prop_assume!(text.len() < 4000 && super::parse::<Value>("case", text).is_ok());
        let mut gaps = gaps.iter().cycle();
        let mut hostile = String::new();
        for token in tokens::tokens(text) {
            hostile.push_str(token.text);
            hostile.push_str(gaps.next().unwrap());
        }
        checked(&hostile);
    }
}
