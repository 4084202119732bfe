"""Solids beside finite elements, algebraic multigrid and LAMMPS, and how their times and memory grow.

Whole runs are `peristat verify` on one thread as a child process: read, solve, certify, check, no files. Programs alternate,
and medians of CPU seconds are compared, which other work on the machine lengthens less than those of the clock. This program
needs nothing but Python: a child's peak of memory counts what its parent holds. `bench/solid.sh` prepares everything.
"""

import argparse
import json
import os
import subprocess
import sys
import time

import solid_error
import solid_scaling
from measure import ROOT, WORK, Report, processor
from pareto import THREADS, table
from pareto_jobs import missing
from solid_cases import COMPLIANCE
from solid_peers import against_amg, against_lammps


def section(title, words, head, rows):
    return f"{title}. {words}\n\n{table(head, rows)}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--strict", action="store_true", help="exit 1 if a target is missed")
    parser.add_argument("--quick", action="store_true", help="small sizes, no LAMMPS")
    parser.add_argument("--large", action="store_true", help="ten million points, too: 7 GB and ten minutes")
    parser.add_argument("--rounds", type=int, default=3, help="repeats that medians are taken of")
    options = parser.parse_args()
    os.environ |= dict.fromkeys(THREADS, "1")
    WORK.mkdir(parents=True, exist_ok=True)
    os.chdir(WORK)  # ccx leaves files where it runs
    report, notices, begin = Report("other"), [], time.perf_counter()
    lacks = missing(notices.append)
    without_plot = lacks(["matplotlib"])
    error = solid_error.measured(options.rounds, options.quick, lacks, notices)
    solid_error.verdicts(report, error)
    against_amg(report, options.rounds, lacks, notices, 16 if options.quick else 32)
    scaling = solid_scaling.measured(options.rounds, options.quick, options.large)
    solid_scaling.verdicts(report, scaling)
    if not options.quick:
        against_lammps(report, options.rounds, notices)
    load = f"load {os.getloadavg()[0]:.1f} at the end" if hasattr(os, "getloadavg") else ""
    spent = time.perf_counter() - begin
    parts = [
        f"{processor()}, one thread; medians of {options.rounds} rounds; {load}; {spent:.0f} s in all\n",
        report.markdown(),
        section("Sheared cube", f"Error: difference from the compliance {COMPLIANCE:g}.", solid_error.HEAD, solid_error.cells(error)),
        section("Growth", "Cube of the same load.", solid_scaling.HEAD, solid_scaling.cells(scaling)),
        *(f"{notice}\n" for notice in notices),
    ]
    text = "\n".join(parts)
    (WORK / "solid.md").write_text(text)
    (WORK / "solid.json").write_text(json.dumps({"error": error, "scaling": scaling}))
    print(text, end="")
    if not without_plot:
        subprocess.run([sys.executable, "-B", ROOT / "bench" / "solid_plot.py"], check=True)
    return 1 if options.strict and report.missed else 0


if __name__ == "__main__":
    sys.exit(main())
