//! `fmt`: what it changes, what it leaves, and how it is used in a pipe and by a check.

use super::support::{names, peristat, root, run};
use std::fs;
use std::io::Write;
use std::process::Stdio;

const UNTIDY: &str = "{\"title\":\"a\", // why\n\"checks\":[1.50e+3,\n2,],}";
const TIDY: &str = "{\n  \"title\": \"a\", // why\n  \"checks\": [1.50e+3, 2]\n}\n";

#[test]
fn a_file_is_tidied_in_place_once() {
    let folder = tempfile::tempdir().unwrap();
    let (path, bad) = (folder.path().join("a.jsonc"), folder.path().join("bad.json"));
    fs::write(&path, UNTIDY).unwrap();
    fs::write(&bad, "{\n  \"title\": \"a\"\n  \"about\": 1\n}\n").unwrap();
    let check = run(folder.path(), &["fmt", "--check", "a.jsonc"]);
    assert_eq!((check.code, check.stdout.as_str()), (1, "a.jsonc is not tidy\n"));
    assert_eq!(fs::read_to_string(&path).unwrap(), UNTIDY);

    let both = run(folder.path(), &["fmt", "bad.json", "a.jsonc"]);
    assert_eq!((both.code, both.stdout.as_str()), (2, "tidied a.jsonc\n"));
    assert!(both.stderr.contains("--> bad.json:3:3\n") && both.stderr.contains("^"), "{}", both.stderr);
    assert!(fs::read_to_string(&bad).unwrap().contains("\"a\"\n  \"about\""), "as it was");
    assert_eq!(fs::read_to_string(&path).unwrap(), TIDY);

    let again = run(folder.path(), &["fmt", "--check", "a.jsonc"]);
    assert_eq!((again.code, again.stdout.as_str(), again.stderr.as_str()), (0, "", ""));
    let json = run(folder.path(), &["fmt", "--json", "--check", "a.jsonc"]).stdout;
    assert!(json.contains("\"tidy\": true"), "{json}");
    assert_eq!(names(folder.path()), ["a.jsonc", "bad.json"], "nothing else is left");
}

#[cfg(unix)]
#[test]
fn a_link_and_its_permissions_stay() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = tempfile::tempdir().unwrap();
    let (path, link) = (folder.path().join("a.json"), folder.path().join("link.json"));
    fs::write(&path, UNTIDY).unwrap();
    fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).unwrap();
    symlink("a.json", &link).unwrap();
    assert_eq!(run(folder.path(), &["fmt", "link.json"]).code, 0);
    assert!(link.is_symlink());
    assert_eq!(fs::read_to_string(&path).unwrap(), TIDY);
    assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o777, 0o640);

    fs::write(&path, UNTIDY).unwrap();
    fs::set_permissions(&path, fs::Permissions::from_mode(0o440)).unwrap();
    let refused = run(folder.path(), &["fmt", "a.json"]);
    assert_eq!(refused.code, 2, "it may not be written");
    assert!(refused.stderr.contains("a.json may not be written"), "{}", refused.stderr);
    assert_eq!(fs::read_to_string(&path).unwrap(), UNTIDY);
}

#[test]
fn stdin_is_tidied_to_stdout() {
    for (given, code, stdout) in [(UNTIDY, 0, TIDY), (TIDY, 0, TIDY), ("{", 2, "")] {
        let mut child = peristat(&root())
            .args(["fmt", "-"])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        child.stdin.take().unwrap().write_all(given.as_bytes()).unwrap();
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(code));
        assert_eq!(String::from_utf8(output.stdout).unwrap(), stdout);
        assert_eq!(String::from_utf8(output.stderr).unwrap().contains("stdin:1:2"), code == 2);
    }
}
