"""Instructions that small fixed cases take, against committed numbers, so that a slower kernel is seen on a noisy machine.

`bench/counts.sh` prepares everything and runs this; bench/README.md says what is counted and when a count fails.
"""

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDER = ROOT / "bench" / "counts"
RECORD = ROOT / "bench" / "counts.json"
TARGET = ROOT / "target" / "bench"
# Allowed increase of a count.
MOST = 0.02
# Files with a smaller share of the instructions of a case are counted in its sum only.
SHARE = 0.03
VALGRIND = ["valgrind", "--tool=callgrind", "--error-exitcode=99"]
# A source line of the workspace, in a worktree or not; of a dependency; of the standard library.
OURS = re.compile(r"(?:^|/)(crates/\w+/src/.+)$")
CRATE = re.compile(r"registry/src/[^/]+/([\w-]+?)-\d[^/]*/")


def cases():
    """By name: what the command is asked to do."""
    files = sorted(FOLDER.glob("*.json"))
    plain = [file for file in files if not file.stem.startswith("study")]
    return {file.stem: ["verify", file] for file in plain} | {"study": ["study", FOLDER / "study.json"]}


def group(file):
    """What a source file belongs to: itself, a crate, or the rest."""
    if found := OURS.search(file):
        return found[1]
    if found := CRATE.search(file):
        return found[1]
    return "std" if "/library/" in file or file.startswith("library/") else "other"


def collect(path, binary):
    """Instructions by group in what callgrind wrote, of the command alone: the C library is that of the machine."""
    names, counts = {"ob": {}, "fl": {}}, {}
    inside, file, called = True, "other", False
    for line in path.read_text().splitlines():
        if found := re.match(r"(ob|fl|fi|fe)=\((\d+)\)(?: (.*))?$", line):
            kind, number, name = found.groups()
            known = names["ob" if kind == "ob" else "fl"]
            if name is not None:
                known[number] = name
            if kind == "ob":
                inside = Path(known[number]).name == binary.name
            else:
                file = group(known[number])
        elif found := re.match(r"cfi=\((\d+)\) (.*)$|cfl=\((\d+)\) (.*)$|cob=\((\d+)\) (.*)$", line):
            a, b, c, d, e, f = found.groups()
            names["ob" if e else "fl"][a or c or e] = b or d or f
        elif line.startswith("calls="):
            called = True
        elif found := re.match(r"[+\-*\d]\S* (\d+)$", line):
            # The line after a call has the cost of what was called, which is counted there.
            if inside and not called:
                counts[file] = counts.get(file, 0) + int(found[1])
            called = False
    return counts


def measure(binary, arguments):
    """Instructions of one run on one thread: the sum, and those of the files that matter."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "callgrind"
        options = [f"--callgrind-out-file={out}", "--quiet"]
        output = ["-o", Path(folder) / "out"] if arguments[0] == "study" else []
        command = [*VALGRIND, *options, binary, "--threads", "1", "--quiet", *arguments, *output]
        done = subprocess.run(command, capture_output=True, text=True, cwd=folder)
        if done.returncode not in (0, 1) or not out.exists():
            sys.exit(f"{' '.join(map(str, command))} ended with {done.returncode}:\n{done.stdout}{done.stderr}")
        counts = collect(out, binary)
    total = sum(counts.values())
    if done.returncode:
        sys.exit(f"a check of {arguments[-1].name} fails, so that its count means nothing:\n{done.stdout}{done.stderr}")
    files = {file: count for file, count in counts.items() if file.startswith("crates/") and count >= SHARE * total}
    return {"sum": total, **dict(sorted(files.items(), key=lambda item: -item[1]))}


def measured(binary):
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return dict(zip(cases(), pool.map(lambda arguments: measure(binary, arguments), cases().values())))


def key():
    """What else decides on the counts: the compiler, and the processor as valgrind shows it to a program."""
    program = TARGET / "features"
    subprocess.run(["rustc", "--edition", "2024", "-O", "-o", program, FOLDER / "features.rs"], check=True, cwd=ROOT)
    features = subprocess.run(["valgrind", "--quiet", program], capture_output=True, text=True, check=True).stdout
    rustc = subprocess.run(["rustc", "--version"], capture_output=True, text=True, check=True, cwd=ROOT).stdout
    return {"rustc": rustc.strip(), "features": features.strip()}


def compare(before, after):
    """Prints what changed by more than is allowed; the number of counts that grew."""
    grown = 0
    for case, counts in after.items():
        for what, count in counts.items():
            old = before.get(case, {}).get(what)
            if old is None:
                print(f"notice: {case}: {what} takes {count / counts['sum']:.1%} of the instructions and is not in the record")
            elif abs(count / old - 1) > MOST:
                slower = count > old
                grown += slower
                print(f"{'SLOWER' if slower else 'faster'}: {case}: {what}: {old} -> {count} instructions ({count / old - 1:+.1%})")
    return grown


def build(folder, target):
    """Builds the command of a source tree with the lines that counts are grouped by."""
    environment = os.environ | {"CARGO_TARGET_DIR": str(target), "CARGO_PROFILE_RELEASE_DEBUG": "line-tables-only"}
    subprocess.run(["cargo", "build", "--profile", "profiling", "--quiet", "-p", "peristat-cli"], check=True, cwd=folder, env=environment)
    return target / "profiling" / "peristat"


def former(commit):
    """Counts of another commit, built in a worktree of its own."""
    tree = TARGET / "against"
    shutil.rmtree(tree, ignore_errors=True)
    git = ["git", "-C", str(ROOT), "worktree"]
    subprocess.run([*git, "prune"], check=True)
    subprocess.run([*git, "add", "--quiet", "--detach", str(tree), commit], check=True)
    try:
        return measured(build(tree, TARGET / "against-target"))
    finally:
        subprocess.run([*git, "remove", "--force", str(tree)], check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--against", metavar="COMMIT", help="build this commit, too, and compare with it")
    parser.add_argument("--binary", type=Path, default=ROOT / "target" / "profiling" / "peristat", help="the command to measure")
    options = parser.parse_args()
    TARGET.mkdir(parents=True, exist_ok=True)
    now, binary = key(), options.binary.resolve()
    if options.against:
        grown = compare(former(options.against), measured(binary))
        print(f"{grown} counts grew by more than {MOST:.0%} since {options.against}")
        return 1 if grown else 0
    if os.environ.get("UPDATE") == "1":
        record = now | {"cases": measured(binary)}
        RECORD.write_text(json.dumps(record, indent=1) + "\n")
        return 0
    if not RECORD.exists():
        print("notice: there is no bench/counts.json; UPDATE=1 bench/counts.sh writes it")
        return 0
    record = json.loads(RECORD.read_text())
    other = [f"{what} `{record[what]}` there, `{now[what]}` here" for what in now if record[what] != now[what]]
    if other:
        print(f"notice: bench/counts.json is of another machine ({'; '.join(other)});")
        print("        bench/counts.sh --against COMMIT builds a former commit and measures both here")
        return 0
    grown = compare(record["cases"], measured(binary))
    if grown:
        print(f"{grown} counts grew by more than {MOST:.0%}; if that is meant: UPDATE=1 bench/counts.sh")
    return 1 if grown else 0


if __name__ == "__main__":
    sys.exit(main())
