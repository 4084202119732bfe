//! What `serde_json` reads, and what it refuses, is the same here, but for lists in the place of objects.

use super::super::parse::tests::{Case, GOOD};
use super::*;
use proptest::prelude::*;
use serde::Deserialize;
use serde_json::Value;

/// What is expected instead of a value, or all that is said: `serde_json` writes the value itself in its own way.
fn expected(words: Option<&str>) -> Option<&str> {
    words.map(|words| words.rsplit_once(", expected ").map_or(words, |(_, expected)| expected))
}

/// Both read the same value, or neither does.
fn agree(text: &str) {
    let (ours, theirs) = (read::<Value>(text), serde_json::from_str::<Value>(text));
    match (&ours, &theirs) {
        (Ok(ours), Ok(theirs)) => assert_eq!(ours, theirs, "{text}"),
        (Err(_), Err(_)) => {}
        _ => panic!("{ours:?} for {theirs:?}: {text}"),
    }
    // A type asks otherwise than a tree does; what it calls a fault of syntax there may be a misfit here.
    let (ours, theirs) = (read::<Case>(text), serde_json::from_str::<Case>(text));
    let is_list = |fault: &Fault| {
        fault.misfit().is_some_and(|it| it.starts_with("invalid type: sequence, expected struct"))
    };
    if ours.as_ref().is_err_and(is_list) {
        // There the values of an object may stand in a list.
        return;
    }
    assert_eq!(ours.is_ok(), theirs.is_ok(), "{ours:?} for {theirs:?}: {text}");
    if let (Err(ours), Err(theirs)) = (ours, theirs)
        && theirs.is_data()
    {
        let theirs = theirs.to_string();
        let theirs = theirs.rsplit_once(" at line ").map(|(words, _)| words);
        // Of a list that is too long `serde_json` does not say how many it wants.
        match expected(theirs) {
            Some("fewer elements in array") => {
                assert!(
                    expected(ours.misfit()).is_some_and(|it| it.starts_with("an array of length")),
                    "{text}"
                );
            }
            theirs => assert_eq!(expected(ours.misfit()), theirs, "{text}"),
        }
    }
}

#[test]
fn numbers_are_the_same_to_the_bit() {
    let whole =
        ["0", "-0", "1", "-1", "18446744073709551615", "18446744073709551616", "-9223372036854775808"];
    let broken =
        ["-9223372036854775809", "0.1", "-0.0", "1e-7", "1E+5", "1.5e308", "1e309", "-1e400", "4.9e-324"];
    let tiny =
        ["1e-400", "2.2250738585072011e-308", "9007199254740993", "123456789012345678901234567890", "1e0"];
    let wrong = ["01", "-", "+1", ".5", "1.", "1e", "1e+", "0x1", "NaN", "1_0", "--1", "00", "-01", "1.e5"];
    for text in [&whole[..], &broken, &tiny, &wrong].concat() {
        agree(text);
        if let Ok(Value::Number(ours)) = read(text) {
            let theirs: f64 = serde_json::from_str(text).expect("a number");
            assert_eq!(ours.as_f64().expect("a double").to_bits(), theirs.to_bits(), "{text}");
        }
    }
}

#[test]
fn strings_and_names_are_the_same_with_escapes() {
    for text in [
        r#""a\"b""#,
        r#""\u00e4\n""#,
        r#""\ud83d\ude00""#,
        r#""\ud83d""#,
        r#""\x""#,
        "\"a\nb\"",
        "\"ab",
        "\"a\\",
    ] {
        agree(text);
    }
    agree(r#"{ "title\u0073": 1 }"#);
    agree("{ \"\\\u{e4}\": 1 }");
    agree(&GOOD.replace("\"title\"", r#""t\u0069tle""#));
}

#[test]
fn nesting_ends_where_it_ends_there() {
    for (open, close) in [("[", "]"), ("{\"a\":", "}")] {
        for levels in [1, 126, 127, 128, 129, 100_000] {
            agree(&format!("{}1{}", open.repeat(levels), close.repeat(levels)));
        }
    }
}

#[test]
fn one_wrong_character_anywhere_is_refused_there_and_here() {
    for (at, old) in GOOD.char_indices() {
        for new in
            ["", "é", "\"", "{", "]", ",", "\\", "-", ".", "\n", "x", "1e999", "\u{0}", "null", "[]", " "]
        {
            agree(&format!("{}{new}{}", &GOOD[..at], &GOOD[at + old.len_utf8()..]));
        }
    }
}

#[test]
fn a_name_that_stands_twice_reaches_the_type_with_its_place() {
    #[derive(Debug, Deserialize)]
    #[serde(deny_unknown_fields)]
    struct Pair {
        #[allow(dead_code, reason = "read by serde only")]
        a: f64,
    }
    let text = r#"[[{"a": 1}], [{"a": 1, "a": 2}]]"#;
    let fault = read::<Vec<Vec<Pair>>>(text).expect_err("twice");
    assert_eq!(fault.misfit(), Some("duplicate field `a`"));
    assert_eq!(
        (fault.path().to_string().as_str(), &text[..fault.at()]),
        ("[1][0]", r#"[[{"a": 1}], [{"a": 1, "a""#)
    );
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(4000) })]

    #[test]
    fn pieces_of_json_in_any_order_are_the_same(
        pieces in proptest::collection::vec(
            prop::sample::select(vec![
                "{", "}", "[", "]", ",", ":", " ", "\n", "\"a\"", "\"\\u0061\"", "1", "-2", "3.5", "1e5", "true", "false", "null",
                "tru", "\"", "{\"a\":1}", "[1,2]", "{}", "[]",
            ]),
            0..12,
        )
    ) {
        agree(&pieces.concat());
    }
}
