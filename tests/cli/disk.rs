//! Disks that are full or read-only.

use super::faults::is_finished;
use super::fracture::{assert_same, case as breaking, solve};
use super::support::{gallery, names, notice, root};
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Command, Output};

/// A shell in a folder, where `$peristat` is the command; in vain where what it is started by is not there.
fn shell(folder: &Path, prefix: &[&str], script: &str) -> Output {
    let words: Vec<&str> = prefix.iter().copied().chain(["sh", "-c", script]).collect();
    let mut command = Command::new("env");
    command.args(words).current_dir(folder).env("peristat", env!("CARGO_BIN_EXE_peristat"));
    command.output().expect("a command starts")
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

#[test]
fn files_that_cannot_grow_end_a_run_without_a_summary() {
    let folder = tempfile::tempdir().unwrap();
    let whole = solve(folder.path(), &breaking(), &["-o", "whole"]);
    assert_eq!(whole.code, 0, "{}", whole.stderr);
    let (out, mut refused) = (folder.path().join("out"), 0);
    for blocks in [0, 1, 2, 4, 8, 16, 32, 64, 4096] {
        // The signal kills the process, unless it is ignored: then the write fails.
        for trap in ["", "trap '' XFSZ; "] {
            let run = "exec \"$peristat\" run breaking.json -o out -q";
            let ended = shell(folder.path(), &[], &format!("ulimit -f {blocks}; {trap}{run}"));
            let finished = is_finished(&out);
            assert_eq!(finished, ended.status.success(), "{blocks}: {ended:?}");
            refused += usize::from(!finished);
            if !finished && trap.is_empty() {
                assert_eq!(ended.status.signal(), Some(25), "{blocks}: {ended:?}");
            } else if !finished {
                assert_eq!(ended.status.code(), Some(2), "{blocks}: {ended:?}");
                let told = stderr(&ended);
                assert!(told.starts_with("error: cannot write out: File too large"), "{blocks}: {told}");
            }
            // With more room it goes on, or is run again.
            let more = if out.join("restart.bin").exists() { "--resume" } else { "--force" };
            let last = solve(folder.path(), &breaking(), &["-o", "out", more]);
            assert_eq!(last.code, 0, "{blocks}, {more}: {}", last.stderr);
            assert_same(&out, &folder.path().join("whole"));
            fs::remove_dir_all(&out).unwrap();
        }
    }
    // All but those of the last size.
    assert!((8..17).contains(&refused), "{refused}");
}

#[test]
fn a_full_disk_ends_a_run_without_a_summary() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("disk")).unwrap();
    // Of root, or of a user in a name space of his own.
    let forms: [&[&str]; 2] = [&["unshare", "-m"], &["unshare", "-rm"]];
    let mounts = |form: &&[&str]| shell(folder.path(), form, "mount -t tmpfs tmpfs disk").status.success();
    let Some(form) = forms.into_iter().find(mounts) else {
        return notice("no tmpfs can be mounted here, so no disk is full");
    };
    let whole = solve(folder.path(), &breaking(), &["-o", "whole"]);
    assert_eq!(whole.code, 0, "{}", whole.stderr);
    let mut full = 0;
    for size in [8, 24, 48, 96, 144, 192, 256, 384, 16384] {
        let script = format!(
            "mount -t tmpfs -o size={size}k tmpfs disk
             \"$peristat\" run breaking.json -o disk/out -q
             code=$?
             rm -rf first out; cp -r disk/out first
             mount -o remount,size=16m disk
             if [ -e first/restart.bin ]; then more=--resume; else more=--force; fi
             \"$peristat\" run breaking.json -o disk/out $more -q || exit 99
             cp -r disk/out out
             exit $code"
        );
        let ended = shell(folder.path(), form, &script);
        let (told, finished) = (stderr(&ended), is_finished(&folder.path().join("first")));
        assert_eq!(ended.status.code(), Some(if finished { 0 } else { 2 }), "{size} kB: {told}");
        let said = "error: cannot write disk/out: No space left on device";
        assert_eq!(told.starts_with(said), !finished, "{size} kB: {told}");
        full += usize::from(!finished);
        assert_same(&folder.path().join("out"), &folder.path().join("whole"));
    }
    assert!((4..9).contains(&full), "{full}");
}

#[test]
fn a_read_only_folder_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    fs::create_dir(&out).unwrap();
    fs::set_permissions(&out, fs::Permissions::from_mode(0o555)).unwrap();
    // Root may write anywhere, unless it gives that up.
    let forms: [&[&str]; 2] = [&[], &["setpriv", "--bounding-set=-dac_override", "--inh-caps=-dac_override"]];
    let is_bound = |form: &&[&str]| {
        stderr(&shell(folder.path(), form, "touch out/x && rm out/x")).contains("Permission denied")
    };
    let Some(form) = forms.into_iter().find(is_bound) else {
        return notice("no folder is read-only for root without `setpriv`");
    };
    let case = gallery("cantilever.json");
    for place in ["out", "out/below"] {
        let ended = shell(folder.path(), form, &format!("exec \"$peristat\" run {case} -o {place}"));
        let said = format!("error: cannot write {place}: Permission denied");
        assert!(ended.status.code() == Some(2) && stderr(&ended).starts_with(&said), "{}", stderr(&ended));
    }
    let study = format!("exec \"$peristat\" study {}/cases/beam_orders.study.json -o out", root().display());
    let ended = shell(folder.path(), form, &study);
    assert!(
        ended.status.code() == Some(2) && stderr(&ended).contains("cannot write out"),
        "{}",
        stderr(&ended)
    );
    assert!(names(&out).is_empty());
    // An earlier run stays.
    fs::set_permissions(&out, fs::Permissions::from_mode(0o755)).unwrap();
    assert!(shell(folder.path(), &[], &format!("exec \"$peristat\" run {case} -o out")).status.success());
    for part in [out.join("fields"), out.clone()] {
        fs::set_permissions(part, fs::Permissions::from_mode(0o555)).unwrap();
    }
    let ended = shell(folder.path(), form, &format!("exec \"$peristat\" run {case} -o out --force"));
    assert!(
        ended.status.code() == Some(2) && stderr(&ended).contains("Permission denied"),
        "{}",
        stderr(&ended)
    );
    assert!(is_finished(&out));
    for part in [out.clone(), out.join("fields")] {
        fs::set_permissions(part, fs::Permissions::from_mode(0o755)).unwrap();
    }
}
