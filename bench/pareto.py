"""Run time against error of peristat and of programs that a user would take instead, on a beam, on a plate and at holes.

Every run is a process of its own on one thread: its user and system seconds, start and imports included, its peak of
memory (medians), and the seconds that it gives itself (the least). Programs alternate. Every other program is told
whether a run of it lies below peristat's front. `bench/pareto.sh` prepares everything and runs this.
"""

import argparse
import json
import os
import resource
import shutil
import subprocess
import sys
import time
from statistics import median

from measure import ROOT, WORK, processor
from pareto_front import costs, verdicts
from pareto_jobs import beams, holes, missing, plates
from pareto_problems import HOLES

THREADS = "OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"
LIMIT = 1e-3  # of the errors of beams that count
BELOW = "one is below if peristat needs more time for an error no larger"
TITLES = {"plate": "Plate", "hole_isotropic": "Hole in an isotropic plate", "hole_laminate": "Hole in a laminate"}
LONG = 2.0  # CPU seconds from which three runs do


def measured(jobs, rounds):
    """A row per run; runs alternate."""
    for done in range(rounds):
        begin = time.perf_counter()
        for job in jobs:
            if done < 3 or job.times[0][0] < LONG:
                job.run()
        print(f"  round {done + 1} of {rounds}: {time.perf_counter() - begin:.0f} s", file=sys.stderr)
    rows = []
    for job in jobs:
        cpu, peak = (median(times[k] for times in job.times) for k in (0, 2))
        inside = min(times[1] for times in job.times)  # wall seconds, which others on the machine lengthen
        keys = {"program": job.program, "method": job.method, "size": job.size, "points": job.points}
        times = {"cpu": cpu, "inside": inside, "peak": peak, "unseen": peak <= own()}
        rows.append(keys | {"error": job.found, "stress": job.stress} | times)
    return rows


def own():
    """Peak memory of this process, below which that of a child cannot be seen."""
    return 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def table(head, rows):
    return "".join(f"| {' | '.join(row)} |\n" for row in (head, ["---"] * len(head), *rows))


def points(rows):
    cells, has_stress = [], any(row["stress"] is not None for row in rows)
    for row in rows:
        times = f"{row['cpu']:.3f}", f"{1e3 * row['inside']:.2f}"
        peak = "<= " * row["unseen"] + f"{row['peak'] / 1e6:.0f}"
        stress = f"{row['stress']:.1e}" if row["stress"] is not None else ""
        errors = [f"{row['error']:.1e}", *([stress] if has_stress else [])]
        cells.append([row["program"], row["method"], row["size"], *errors, *times, peak])
    errors = ["error", *(["of stress"] if has_stress else [])]
    return table(["program", "method", "size", *errors, "CPU s", "inside ms", "peak MB"], cells)


def section(title, words, rows, limit):
    errors, least = ((1e-3, 1e-6, 1e-9, 1e-12), 1000) if limit else ((1e-1, 1e-2, 1e-3, 1e-4, 1e-5), 0)
    at = f" at {least} points or more" if least else ""
    cost = f"CPU milliseconds to an error{at}, in brackets those inside the program:\n\n"
    parts = [f"#### {title}\n\n{cost}{table(*costs(rows, errors, least))}", f"{words}\n"]
    stressed = [row | {"error": row["stress"]} for row in rows if row["stress"] is not None]
    if stressed:
        parts.insert(1, f"The same to an error of the stress:\n\n{table(*costs(stressed, errors, least))}")
    clocks = {"cpu": "whole process, CPU seconds", "inside": "inside the program, wall seconds"}
    for clock, name in clocks.items():
        head, cells = verdicts(rows, clock, limit)
        parts.append(f"Verdicts, {name}:\n\n{table(head, cells)}")
    return "\n".join(parts)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="small sizes, one beam, two rounds")
    parser.add_argument("--rounds", type=int, help="repeats that medians are taken of; 5, or 2 with --quick")
    options = parser.parse_args()
    rounds = options.rounds or (2 if options.quick else 5)
    os.environ |= dict.fromkeys(THREADS, "1")
    WORK.mkdir(parents=True, exist_ok=True)
    os.chdir(WORK)  # ccx leaves files where it runs
    notices, begin = [], time.perf_counter()
    lacks, has_ccx = missing(notices.append), shutil.which("ccx") is not None
    if not has_ccx:
        notices.append("notice: there is no ccx: CalculiX is left out")
    without_plots = lacks(["matplotlib"])
    sets = {}
    for slenderness, most in [(20, 1000)] if options.quick else [(20, 10**6), (1000, 1000)]:
        print(f"beam, slenderness {slenderness}", file=sys.stderr)
        sets[f"beam_{slenderness}"] = measured(list(beams(slenderness, most, lacks, has_ccx)), rounds)
    print("plate", file=sys.stderr)
    sets["plate"] = measured(list(plates(options.quick, lacks, has_ccx)), rounds)
    for name in HOLES:
        print(f"hole, {name}", file=sys.stderr)
        sets[f"hole_{name}"] = measured(list(holes(name, options.quick, lacks, has_ccx)), rounds)
    parts = []
    for name, rows in sets.items():
        if name in TITLES:
            parts.append(section(TITLES[name], f"Runs of every error count; {BELOW}.", rows, None))
        else:
            words = f"Runs with errors under {LIMIT:g} count; {BELOW} at no fewer points."
            parts.append(section(f"Beam of slenderness {name.split('_')[1]}", words, rows, LIMIT))
    load = f"load {os.getloadavg()[0]:.1f} at the end" if hasattr(os, "getloadavg") else ""
    spent = time.perf_counter() - begin
    head = f"{processor()}, one thread; medians of {rounds} rounds; {load}; {spent:.0f} s in all\n"
    text = "\n".join([head, *parts, *(f"{notice}\n" for notice in notices)])
    (WORK / "pareto.md").write_text(text)
    runs = (f"#### {name.replace('_', ', slenderness ')}\n\n{points(rows)}" for name, rows in sets.items())
    (WORK / "pareto_runs.md").write_text("\n".join(runs))
    (WORK / "pareto.json").write_text(json.dumps(sets))
    print(text, end="")
    if not without_plots:
        subprocess.run([sys.executable, "-B", ROOT / "bench" / "pareto_plot.py"], check=True)


if __name__ == "__main__":
    sys.exit(main())
