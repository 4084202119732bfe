"""The sheared cube: error of the compliance against CPU seconds, peristat beside finite elements."""

import json
import os
import resource
import shutil
import subprocess
import sys
from dataclasses import dataclass, field
from statistics import median
from typing import Callable

import solid_ccx as ccx
from measure import ROOT, WORK, run
from solid_cases import COMPLIANCE, compliance, cube

CELLS = 8, 16, 24, 32, 48, 64
ELEMENTS = {"C3D8": (8, 12, 16, 20, 24, 32, 40, 48), "C3D20": (2, 4, 6, 8, 10, 12, 16, 20, 24)}
SOLVERS = {"direct": "", "iterative": "ITERATIVE SCALING"}
DIRECT_MOST = {"C3D8": 24, "C3D20": 12}  # a factor takes a minute beyond
SCRIPT = sys.executable, "-B", ROOT / "bench" / "solid_ccx.py"
LONG = 5.0  # CPU seconds from which one run does
HEAD = "program", "method", "size", "compliance", "error", "CPU s", "peak MB"


@dataclass
class Job:
    """One size of one method; `once` gives CPU seconds and peak memory, `found` the compliance after a run."""

    program: str
    method: str
    size: int
    once: Callable
    found: Callable
    times: list = field(default_factory=list)

    def row(self):
        cpu, peak = (median(t[k] for t in self.times) for k in (0, 1))
        value = self.found()
        keys = {"program": self.program, "method": self.method, "size": self.size, "compliance": value}
        return keys | {"error": abs(value / COMPLIANCE - 1), "cpu": cpu, "peak": peak}


def ours(sizes):
    for ratio in (2, 3):
        for n in sizes:
            solid = cube(n, ratio)

            def once(solid=solid):
                spent = solid.verify()
                return spent.cpu, spent.peak

            yield Job("peristat", f"`bond_solid`, m = {ratio}", n, once, lambda solid=solid: compliance(solid.summary()))


def process(command):
    def once():
        _, (cpu, _), peak = run(*command, errors=subprocess.DEVNULL)
        return cpu, peak

    return once


def calculix(quick):
    for kind, sizes in ELEMENTS.items():
        for words, solver in SOLVERS.items():
            for n in sizes[: 3 if quick else None]:
                if words == "direct" and n > DIRECT_MOST[kind]:
                    continue
                path = WORK / f"solid_{kind}_{words}_{n}"
                run(*SCRIPT, kind, str(n), path.with_suffix(".inp"), solver)
                found = lambda path=path, kind=kind, n=n: ccx.compliance(path.with_suffix(".dat"), kind, n)
                yield Job("CalculiX", f"{kind}, {words}", n, process(["ccx", "-i", os.path.relpath(path)]), found)


def scikit_fem(quick):
    """Where there is no CalculiX."""
    for order, sizes in {1: (8, 16, 24), 2: (2, 4, 8)}.items():
        for n in sizes[: 2 if quick else None]:
            command = [sys.executable, "-B", ROOT / "bench" / "solid_fe.py", str(order), str(n)]
            found = lambda command=command: json.loads(run(*command)[0])
            yield Job("scikit-fem", f"Q{order}, pyamg", n, process(command), found)


def measured(rounds, quick, lacks, notices):
    """A row per size; runs alternate."""
    jobs = list(ours(CELLS[:3] if quick else CELLS))
    if shutil.which("ccx"):
        jobs += calculix(quick)
    elif not lacks(["skfem", "pyamg"]):
        notices.append("notice: there is no ccx: scikit-fem stands in for CalculiX")
        jobs += scikit_fem(quick)
    for done in range(rounds):
        for job in jobs:
            if not done or job.times[0][0] < LONG:
                job.times.append(job.once())
                print(f"  round {done + 1}: {job.program} {job.method}, {job.size}: {job.times[-1][0]:.2f} s", file=sys.stderr)
    return [job.row() for job in jobs]


def own():
    """Peak memory of this process, below which that of a child cannot be seen."""
    return 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def cells(rows):
    for row in rows:
        peak = "<= " * (row["peak"] <= own()) + f"{row['peak'] / 1e6:.0f}"
        values = f"{row['compliance']:.4f}", f"{100 * row['error']:.2f} %", f"{row['cpu']:.3f}", peak
        yield [row["program"], row["method"], str(row["size"]), *values]


def cheapest(rows, methods, error):
    """The run with the least time of those from which on all finer ones have no larger error; `None` if there is none."""
    mine = [row for row in rows if row["method"].startswith(methods)]
    finer = lambda row: (other for other in mine if other["method"] == row["method"] and other["size"] >= row["size"])
    fits = [row for row in mine if all(other["error"] <= error for other in finer(row))]
    return min(fits, key=lambda row: row["cpu"], default=None)


def seconds(row):
    return f"{row['cpu']:.3f} s ({row['method']}, {row['size']})" if row else "not reached"


def verdicts(report, rows):
    """Errors of bonds over two spacings, the default, and which program is the faster one to an error."""
    for size, limit in (24, 1.5), (64, 0.5):
        for row in rows:
            if row["program"] == "peristat" and row["size"] == size:
                percent = 100 * row["error"]
                report.row(f"error at {size} cells, {row['method']}, per cent", f"{percent:.2f}", measured=percent, target=limit)
    for percent in (1.0, 0.4, 0.2, 0.1):
        mine = cheapest(rows, "`bond_solid`", percent / 100)
        for methods, words in (("C3D8", "C3D8"), ("C3D20", "C3D20"), ("Q", "Q1 and Q2")):
            if not any(row["method"].startswith(methods) for row in rows):
                continue
            other = cheapest(rows, methods, percent / 100)
            ratio = mine["cpu"] / other["cpu"] if mine and other else None
            # A program that does not get there is no faster one.
            goal = {"measured": ratio or 0.0, "target": 1} if (percent, methods) == (0.4, "C3D8") and mine else {}
            value = f"{ratio:.2f}" if ratio else ""
            report.row(f"CPU to an error of {percent:g} % against {words}", seconds(mine), seconds(other), value, **goal)
