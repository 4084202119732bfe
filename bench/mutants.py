#!/usr/bin/env python3
"""Mutation test of a random sample: what share of small faults in `assembly` and `solve` do their own tests see?

    bench/mutants.py                     # 400 mutants, score at the end; hours
    bench/mutants.py --only missed.txt   # the mutants of a file, one name per line

`cargo mutants` (install it with `cargo install cargo-mutants`) lists the mutants; they are applied and tested here, one
by one in a copy of the committed files, because its filter of names lets some pass and it has no test stop at the first
failure. The sample are the mutants whose names, without line and column, have the lowest hashes: an edit elsewhere
leaves it as it is, and the first hundred are a sample, too. Results are in target/mutants.
"""
import argparse
import collections
import hashlib
import json
import re
import shutil
import subprocess
import sys
import threading
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
OUTPUT = ROOT / "target" / "mutants"
TREE = OUTPUT / "tree"
LIMIT = 300.0  # seconds for a program of tests, which takes 5 to 20
SLOW = [  # run only if all others pass
    "body::fill::tests::filling_agrees_with_exact_tests_of_every_centre",
    "model::bond_plane::tests::properties::the_stiffness_is_semidefinite_with_the_force_as_its_product",
    "model::shell_membrane::tests::spectrum::only_rigid_motions_are_free",
    "model::shell_membrane::tests::spectrum::short_horizons_leave_patterns_free",
]
LEFT_OUT = [
    r"in .*::bytes$",  # bytes of memory only feed the estimates that are printed
    r"impl std::fmt::Debug for",  # text for people who debug
    r"in worth_threads$",  # when a second thread is worth its start; the results are the same
]


def listed():
    """All mutants by name, in the order of the files."""
    command = ["cargo", "mutants", "--list", "--json", "-p", "peristat-assembly", "-p", "peristat-solve"]
    answer = subprocess.run(command, cwd=TREE, check=True, capture_output=True, text=True)
    mutants = {mutant["name"]: mutant for mutant in json.loads(answer.stdout)}
    return {name: mutant for name, mutant in mutants.items() if not any(re.search(e, name) for e in LEFT_OUT)}


def sample(names, seed, count):
    """The `count` names that hash lowest; mutants that differ in their place alone are told apart by their order."""
    seen = collections.Counter()
    ranks = {}
    for name in names:
        text = re.sub(r":\d+:\d+:", ":", name, count=1)
        seen[text] += 1
        ranks[name] = hashlib.sha256(f"{seed} {seen[text]} {text}".encode()).digest()
    return sorted(names, key=ranks.get)[:count]


def mutated(text, mutant):
    """The file with the span of the mutant replaced; rows and columns count from one."""
    starts = [0]
    for line in text.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))
    first, last = (starts[mutant["span"][end]["line"] - 1] + mutant["span"][end]["column"] - 1 for end in ("start", "end"))
    return text[:first] + mutant["replacement"] + text[last:]


def binaries(package, targets):
    """Builds tests of a crate and returns their programs; none if they do not compile."""
    command = ["cargo", "test", "--profile", "mutants", "--package", package, targets, "--no-run", "--message-format", "json"]
    built = subprocess.run(command, cwd=TREE, capture_output=True, text=True)
    messages = [json.loads(line) for line in built.stdout.splitlines() if line.startswith("{")]
    return [m["executable"] for m in messages if m.get("executable") and m["profile"]["test"]] if built.returncode == 0 else []


def verdict(program, folder, arguments):
    """Whether a test program passes, and by which test or signal it does not."""
    run = subprocess.Popen([program, *arguments], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    hung = threading.Event()
    timer = threading.Timer(LIMIT, lambda: (hung.set(), run.kill()))
    timer.start()
    for line in run.stdout:
        if line.startswith("test ") and line.rstrip().endswith("FAILED"):
            run.kill()
            run.wait()
            timer.cancel()
            return "caught", line.split()[1]
    timer.cancel()
    if hung.is_set():
        return "timeout", ""
    return ("passed", "") if run.wait() == 0 else ("caught", f"exit {run.returncode}")


def tested(mutant):
    """What becomes of a mutant: unviable, caught, timeout or missed."""
    path = TREE / mutant["file"]
    text = path.read_text()
    path.write_text(mutated(text, mutant))
    try:
        done = set()
        # Unit tests first: most mutants need no other program to be built.
        for targets in ("--lib", "--tests"):
            programs = binaries(mutant["package"], targets)
            if not programs:
                return "unviable", ""
            others = [word for test in SLOW for word in ("--skip", test)]
            for arguments in (others, ["--exact", *SLOW]):
                for program in set(programs) - done:
                    result = verdict(program, TREE / "crates" / mutant["file"].split("/")[1], arguments)
                    if result[0] != "passed":
                        return result
            done.update(programs)
        return "missed", ""
    finally:
        path.write_text(text)


def prepare():
    """A copy of the committed files, which keeps what it has compiled."""
    for folder in ("crates", "tests"):
        shutil.rmtree(TREE / folder, ignore_errors=True)
    TREE.mkdir(parents=True, exist_ok=True)
    archive = subprocess.run(["git", "archive", "HEAD"], cwd=ROOT, check=True, capture_output=True)
    subprocess.run(["tar", "x", "-C", str(TREE)], input=archive.stdout, check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=400, help="how many mutants (400)")
    parser.add_argument("--seed", type=int, default=1, help="which sample (1)")
    parser.add_argument("--only", type=Path, help="a file with the names of the mutants to test")
    given = parser.parse_args()
    if shutil.which("cargo-mutants") is None:
        sys.exit("cargo-mutants is not installed\nhint: cargo install cargo-mutants")
    prepare()
    mutants = listed()
    names = given.only.read_text().splitlines() if given.only else sample(mutants, given.seed, given.count)
    if any(not binaries(package, "--tests") for package in ("peristat-assembly", "peristat-solve")):
        sys.exit("the tests do not compile without a mutant")
    counts = collections.Counter()
    with open(OUTPUT / "results.txt", "w") as results:
        for name in names:
            result, test = tested(mutants[name])
            counts[result] += 1
            line = f"{result}\t{name}\t{test}"
            print(line, file=results, flush=True)
            print(line, flush=True)
    seen = counts["caught"] + counts["timeout"]
    print(dict(counts), f"score {100 * seen / max(seen + counts['missed'], 1):.1f} %")


if __name__ == "__main__":
    main()
