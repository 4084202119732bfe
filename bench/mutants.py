#!/usr/bin/env python3
"""Mutation test of a random sample: what share of small faults in `assembly` and `solve` do their own tests see?

    bench/mutants.py                     # 400 mutants, score at the end; about half an hour
    bench/mutants.py --only missed.txt   # the mutants of a file, one name per line

`cargo mutants` (install it with `cargo install cargo-mutants`) lists the mutants. They are compiled at once, in a copy
of the committed files, into programs that hold a switch for each (`switches.py`). Every test is run once by itself to see
which mutants it reaches and how long it takes; then each mutant is switched on in the tests that reach it, shortest first,
until one fails. A mutant that no switch can hold is compiled by itself. The sample are the mutants whose names, without
line and column, have the lowest hashes: an edit elsewhere leaves it as it is, and the first hundred are a sample, too.
Results are in target/mutants.
"""
import argparse
import collections
import hashlib
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import switches

ROOT = Path(__file__).resolve().parent.parent
OUTPUT = ROOT / "target" / "mutants"
TREE = OUTPUT / "tree"
PACKAGES = ["peristat-assembly", "peristat-solve"]
CRATES = [word for package in PACKAGES for word in ("--package", package)]
LIMIT = 20.0  # seconds of a processor for a test, beside ten times what it takes
LEFT_OUT = [
    r"in .*::bytes$",  # bytes of memory only feed the estimates that are printed
    r"impl std::fmt::Debug for",  # text for people who debug
    r"in worth_threads$",  # when a second thread is worth its start; the results are the same
]
Test = collections.namedtuple("Test", "package program name seconds reached")


def listed():
    """All mutants by name, in the order of the files."""
    command = ["cargo", "mutants", "--list", "--json", *CRATES]
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


def source(package):
    """The folder of a crate."""
    return Path("crates") / package.removeprefix("peristat-")


def prepare():
    """A copy of the committed files, which keeps what it has compiled."""
    for part in ("crates", "tests"):
        shutil.rmtree(TREE / part, ignore_errors=True)
    TREE.mkdir(parents=True, exist_ok=True)
    archive = subprocess.run(["git", "archive", "HEAD"], cwd=ROOT, check=True, capture_output=True)
    subprocess.run(["tar", "xm", "-C", str(TREE)], input=archive.stdout, check=True)


def written(span):
    """Where an error ends: file, line and column, where its macro is called."""
    while span["expansion"]:
        span = span["expansion"]["span"]
    return span["file_name"], span["line_end"], span["column_end"]


def built():
    """Builds all tests: pairs of a package and a program, and the places of the errors."""
    command = ["cargo", "test", "--profile", "mutants", "--no-run", "--message-format", "json", *CRATES]
    answer = subprocess.run(command, cwd=TREE, capture_output=True, text=True)
    messages = [json.loads(line) for line in answer.stdout.splitlines() if line.startswith("{")]
    if answer.returncode != 0:
        told = [m["message"] for m in messages if m["reason"] == "compiler-message"]
        spans = [span for message in told if message["level"] == "error" for span in message["spans"]]
        return [], {written(span) for span in spans if span["is_primary"]}
    programs = [m for m in messages if m.get("executable") and m["profile"]["test"]]
    return [(re.split("[#@]", m["package_id"])[-2], m["executable"]) for m in programs], set()


def blamed(error, lines):
    """The numbers of the mutants that may have made an error: that of the last switch before it, or all of its line."""
    file, line, column = error
    before = (TREE / file).read_text().splitlines()[line - 1][: column - 1] if (TREE / file).exists() else ""
    switches_before = re.findall(r"switch::on\((\d+)\)", before)
    if switches_before:
        return {int(switches_before[-1])}
    return {number for number, (f, first, last) in lines.items() if f == file and first <= line <= last}


def with_switches(mutants):
    """Programs that hold as many of the mutants as they can, and the numbers of those."""
    libraries = [str(source(package) / "src" / "lib.rs") for package in PACKAGES]
    texts = {file: (TREE / file).read_text() for file in {*libraries, *(mutant["file"] for mutant in mutants.values())}}
    held = set(mutants)
    while True:
        lines = {}
        for file, text in texts.items():
            changed, places = switches.switched(text, {k: mutants[k] for k in held if mutants[k]["file"] == file})
            (TREE / file).write_text(changed + (switches.module(len(mutants)) if file in libraries else ""))
            lines.update({k: (file, *place) for k, place in places.items()})
        programs, errors = built()
        if programs:
            return programs, set(lines)
        held = set(lines).difference(*(blamed(error, lines) for error in errors))
        if held == set(lines):
            sys.exit("the tests do not compile without a mutant")
        print(f"{len(held)} mutants are held by switches", flush=True)


def verdict(test, **environment):
    """Whether a test passes, fails or does not end."""
    limit = int(LIMIT + 10.0 * test.seconds)
    run = subprocess.Popen(
        [test.program, "--exact", test.name],
        cwd=TREE / source(test.package),
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        # Cases that fail are not kept: no mutant is to be seen by what another one left.
        env={**os.environ, "PROPTEST_DISABLE_FAILURE_PERSISTENCE": "1", **environment},
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit)),
    )
    try:
        code = run.wait(timeout=10 * limit)
    except subprocess.TimeoutExpired:
        run.kill()
        return "timeout"
    return {0: "passed", -signal.SIGXCPU: "timeout", -signal.SIGKILL: "timeout"}.get(code, "caught")


def measured(programs):
    """All tests with their times and the numbers of the mutants that they reach, shortest first."""
    tests = []
    record = OUTPUT / "reached.txt"
    for package, program in programs:
        command = [program, "--list", "--format", "terse"]
        names = subprocess.run(command, check=True, capture_output=True, text=True).stdout
        for name in re.findall(r"^(.*): test$", names, re.MULTILINE):
            record.write_text("")
            start = time.monotonic()
            test = Test(package, program, name, LIMIT, set())
            if verdict(test, REACHED=str(record)) != "passed":
                sys.exit(f"{name} fails without a mutant")
            seconds, reached = time.monotonic() - start, set(map(int, record.read_text().split()))
            tests.append(test._replace(seconds=seconds, reached=reached))
    return sorted(tests, key=lambda test: test.seconds)


def result(tests, **environment):
    """What becomes of a mutant, and by which test."""
    for test in tests:
        answer = verdict(test, **environment)
        if answer != "passed":
            return answer, test.name
    return "missed", "" if tests else "not reached"


def alone(mutant, tests):
    """The same of a mutant that is compiled by itself."""
    path = TREE / mutant["file"]
    text = path.read_text()
    path.write_text(switches.mutated(text, mutant))
    try:
        programs, _ = built()
        return result([t for t in tests if t.package == mutant["package"]]) if programs else ("unviable", "")
    finally:
        path.write_text(text)


def results(mutants):
    """Pairs of the number of a mutant and its result."""
    programs, held = with_switches(mutants)
    tests = measured(programs)
    for number in sorted(held):
        yield number, result([t for t in tests if number in t.reached], MUTANT=str(number))
    prepare()
    for number in sorted(set(mutants) - held):
        yield number, alone(mutants[number], tests)


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
    counts = collections.Counter()
    with open(OUTPUT / "results.txt", "w") as file:
        for number, (answer, test) in results({k: mutants[name] for k, name in enumerate(names)}):
            counts[answer] += 1
            line = f"{answer}\t{names[number]}\t{test}"
            print(line, file=file, flush=True)
            print(line, flush=True)
    seen = counts["caught"] + counts["timeout"]
    print(dict(counts), f"score {100 * seen / max(seen + counts['missed'], 1):.1f} %")


if __name__ == "__main__":
    main()
