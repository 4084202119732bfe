"""The beam of a million points against LAPACK's band Cholesky on the same matrix, in one run.

Side by side: a whole run of `peristat verify` (read, solve, certify, check every point), in strain and in displacement
form, and `dpbtrf` + `dpbtrs` in place; the factor kernels alone; accuracy, memory per point and growth with the number
of points; a frame. Competitors alternate and medians are compared, so that what else the machine does hits both.
`bench/run.sh` prepares everything and runs this.
"""

import argparse
import json
import os
import re
import subprocess
import sys
import time
from statistics import median

os.environ["OPENBLAS_NUM_THREADS"] = "1"  # before numpy is loaded: peristat has one thread, too

import numpy as np
import scipy
from scipy.io import mmread
from measure import EXAMPLES, PERISTAT, WORK, Report, processor, run
from scipy.linalg.lapack import dpbtrf, dpbtrs

ONE_THREAD = "--threads", "1"
VERIFY = PERISTAT, "verify", *ONE_THREAD
KERNEL = EXAMPLES / "timing"
MILLION = 1_000_000
SIZES = [10_000, 31_623, 100_000, 316_228, MILLION]
LONG = [*SIZES, 3_162_278, 10 * MILLION]


class Beam:
    """A steel cantilever of 1 m under a uniform load; slenderness is length over section height."""

    width, youngs_modulus, poisson_ratio = 0.05, 2.0e11, 0.3

    def __init__(self, slenderness, load, cells=MILLION, ratio=3, solver="auto", clamps=1):
        self.slenderness, self.load, self.cells, self.ratio = slenderness, load, cells, ratio
        self.solver, self.clamps = solver, clamps
        self.bending = self.youngs_modulus * self.width / slenderness**3 / 12
        self.shear = 5 / 6 * self.youngs_modulus / 2 / (1 + self.poisson_ratio) * self.width / slenderness

    def case(self):
        """Writes the case file: what `peristat new` prints, edited."""
        case = json.loads(subprocess.check_output([PERISTAT, "new", "timoshenko_beam"]))
        model = case["model"]["timoshenko_beam"]
        model |= {"youngs_modulus": self.youngs_modulus, "poisson_ratio": self.poisson_ratio, "bond_law": "exact"}
        model["section"] = {"rectangle": {"width": self.width, "height": 1 / self.slenderness}}
        case |= {"title": "Cantilever under a uniform load", "probes": [], "horizon_ratio": self.ratio}
        case["body"] = {"line": {"length": 1.0, "cells": self.cells}}
        case["loads"] = [{"distributed": {"force": {"uniform": self.load}}}]
        case["supports"] = [{"at": {"x": float(end)}, "w": 0.0, "phi": 0.0} for end in range(self.clamps)]
        case["solver"] = self.solver
        name = ["cantilever_uniform", "clamped_clamped_uniform"][self.clamps - 1]
        form = {"name": name, "tolerance": 1e-11}
        case["checks"] = [{"closed_form": form | {"field": field}} for field in ("w", "phi")]
        path = WORK / f"beam_{self.slenderness:g}_{self.cells}_{self.ratio}_{self.solver}_{self.clamps}.json"
        path.write_text(json.dumps(case, indent=2))
        return path

    def bonds(self):
        """Per offset: its length and the weights of its bonds, half-edge and cover-corrected."""
        weights = [np.full(self.cells + 1 - n, 2 / self.ratio**2) for n in range(1, self.ratio + 1)]
        weights[-1] *= 0.5
        cover = np.zeros(self.cells)
        for n, alpha in enumerate(weights, 1):
            steps = np.zeros(self.cells + 1)
            steps[: len(alpha)] += alpha
            steps[n:] -= alpha
            cover += np.cumsum(steps)[:-1]
        lack = 1 - cover
        weights[0] += np.where(abs(lack) > 1e-8, lack, 0.0)
        return [(n / self.cells, alpha) for n, alpha in enumerate(weights, 1)]

    def stiffness(self):
        """LAPACK's lower band of K, unknowns (w_0, phi_0, w_1, ...), before supports; Fortran order."""
        band = np.zeros((2 * self.ratio + 2, 2 * (self.cells + 1)), order="F")
        for n, (xi, alpha) in enumerate(self.bonds(), 1):
            points = len(alpha)
            b = self.bending / xi
            g = 1 / (1 / self.shear + xi**2 / (12 * self.bending)) / xi
            lower = np.array([[g, g * xi / 2], [g * xi / 2, b + g * xi**2 / 4]])
            upper = np.array([[g, -g * xi / 2], [-g * xi / 2, b + g * xi**2 / 4]])
            across = np.array([[-g, g * xi / 2], [-g * xi / 2, g * xi**2 / 4 - b]])
            for r in range(2):
                for c in range(r, 2):
                    band[c - r, r : 2 * points : 2] += alpha * lower[r, c]
                    band[c - r, 2 * n + r :: 2] += alpha * upper[r, c]
                for c in range(2):
                    band[2 * n + c - r, r : 2 * points : 2] += alpha * across[r, c]
        return band

    def system(self):
        """Matrix with the clamped unknowns decoupled, and load."""
        band, load = self.stiffness(), np.zeros(2 * (self.cells + 1))
        for n, (xi, alpha) in enumerate(self.bonds(), 1):
            force = alpha * self.load * xi / 2
            load[: 2 * len(alpha) : 2] += force
            load[2 * n :: 2] += force
            load[1 : 2 * len(alpha) : 2] += force * xi / 6
            load[2 * n + 1 :: 2] -= force * xi / 6
        band[1:, :2] = load[:2] = 0.0
        return band, load

    def error(self, u):
        """Largest error of w against the closed form, relative."""
        x = np.linspace(0, 1, self.cells + 1)
        w = self.load * (x**2 * (6 - 4 * x + x**2) / (24 * self.bending) + (2 - x) * x / (2 * self.shear))
        return abs(u[::2] - w).max() / w[-1]


def lapack(band, load, work):
    """Factors and solves in place, on memory already mapped: solution, info, CPU and wall, wall of the factor."""
    np.copyto(work, band)
    u = load.copy()
    cpu, wall = time.process_time(), time.perf_counter()
    factor, info = dpbtrf(work, lower=1, overwrite_ab=1)
    factored = time.perf_counter() - wall
    x, _ = dpbtrs(factor, u, lower=1, overwrite_b=1)
    cpu, wall = time.process_time() - cpu, time.perf_counter() - wall
    if not (np.shares_memory(factor, work) and np.shares_memory(x, u)):
        sys.exit("SciPy copied the matrix: LAPACK was not timed in place")
    return x, info, (cpu, wall), factored


def same_matrix(report, beams):
    """Proves on small beams that the matrix LAPACK gets is the one peristat assembles, entry by entry."""
    worst, file = 0.0, WORK / "matrix.mtx"
    for beam in beams:
        for ratio in range(1, 6):
            small = Beam(beam.slenderness, beam.load, 200, ratio, beam.solver)
            run(PERISTAT, "run", small.case(), "-q", "-o", WORK / "small", "--force", "--write-matrix", file)
            theirs, band = mmread(file).toarray(), small.stiffness()
            ours = sum(np.diag(row[: row.size - k], -k) for k, row in enumerate(band))
            ours += np.tril(ours, -1).T
            scale = np.sqrt(np.outer(ours.diagonal(), ours.diagonal()))
            worst = max(worst, (abs(ours - theirs) / scale).max())
    report.row("same matrix: `max abs(dK_ij) / sqrt(K_ii K_jj)`, m = 1..5, 200 cells",
               value=f"{worst:.1e}", measured=worst, target=1e-15)  # fmt: skip


def memory(report, beam, target):
    """Comes before the large arrays: a child's peak counts what its parent held when it was started."""
    peak = run(*VERIFY, beam.case())[2] / (beam.cells + 1)
    report.row(f"peak memory of a run without output, {form(beam)}, bytes per point", f"{peak:.0f}",
               measured=peak, target=target)  # fmt: skip


def form(beam):
    return {"auto": "strain form", "band": "displacement form"}[beam.solver]


def growth(report, beam, sizes, most, least, rounds):
    """Exponent of the time that a case takes, from its reading to its last check, over the number of cells."""
    cases = [Beam(beam.slenderness, beam.load, cells, solver=beam.solver).case() for cells in [4, *sizes]]
    seconds = lambda case: json.loads(run(*VERIFY, case, "--json")[0])[0]["time_s"]
    times = np.median([[seconds(case) for case in cases] for _ in range(rounds)], axis=0)
    times = times[1:] - times[0]  # four cells are what every case takes
    exponent = np.polyfit(np.log(sizes), np.log(times), 1)[0]
    listed = ", ".join(f"{ns:.0f}" for ns in 1e9 * times / sizes)
    what = f"growth exponent, {form(beam)}, {sizes[0]:.0e} to {sizes[-1]:.0e} points ({listed} ns per point)"
    report.row(what, value=f"{exponent:.3f}", measured=exponent, target=most, least=least)


def accuracy(report):
    """Errors of the strain form at a million cells, the slendernesses and clamps that cost other forms their digits."""
    for clamps, support in (1, "cantilever"), (2, "clamped at both ends"):
        for slenderness, load in (20, 1e4), (1e4, 1e-4), (1e6, 1e-10):
            beam = Beam(slenderness, load, clamps=clamps)
            worst = max(c["error"] for c in json.loads(run(*VERIFY, beam.case(), "--json")[0])[0]["checks"])
            report.row(f"error of w and phi, strain form, {support}, slenderness {slenderness:g}",
                       f"{worst:.1e}", measured=worst, target=1e-12)  # fmt: skip
    text, (cpu, wall), peak = run(*VERIFY, (beam := Beam(20, 1e4, 10 * MILLION)).case(), "--json")
    worst = max(c["error"] for c in json.loads(text)[0]["checks"])
    report.row("ten million cells, strain form: CPU (wall), error, bytes per point",
               f"{cpu:.2f} s ({wall:.2f} s)", value=f"{worst:.1e}, {peak / (beam.cells + 1):.0f}")  # fmt: skip


def frame(report, bays, storeys, cells, lapack, rounds):
    """A frame of rigid joints under its own weight and wind: a whole run without output against LAPACK's time of the beam."""
    name = lambda b, s: f"{b}/{s}"
    joints = [{"name": name(b, s), "x": 6.0 * b, "y": 3.5 * s} for s in range(storeys + 1) for b in range(bays + 1)]
    columns = [(name(b, s), name(b, s + 1)) for s in range(storeys) for b in range(bays + 1)]
    beams = [(name(b, s), name(b + 1, s)) for s in range(1, storeys + 1) for b in range(bays)]
    members = [{"name": f"{a}-{b}", "from": a, "to": b, "cells": cells} for a, b in columns + beams]
    case = json.loads(subprocess.check_output([PERISTAT, "new", "timoshenko_beam"]))
    case |= {"title": "Frame", "body": {"frame": {"joints": joints, "members": members}}, "checks": [], "probes": []}
    case["supports"] = [{"at": {"joint": name(b, 0)}, "ux": 0.0, "uy": 0.0, "phi": 0.0} for b in range(bays + 1)]
    weight = [{"distributed": {"member": m["name"], "force_y": {"uniform": -100.0}}} for m in members]
    wind = [{"point": {"at": {"joint": name(0, s)}, "force_x": 50.0}} for s in range(1, storeys + 1)]
    case["loads"] = weight + wind
    path = WORK / "frame.json"
    path.write_text(json.dumps(case))
    points = len(members) * (cells + 1)
    cpu, wall = np.median([run(*VERIFY, path)[1] for _ in range(rounds)], axis=0)
    report.row(f"frame of {points} points, {len(members)} members, whole run: CPU (wall)",
               f"{cpu:.2f} s ({wall:.2f} s)", value=f"{cpu / lapack:.2f} of the beam's LAPACK",
               measured=cpu / lapack, target=3)  # fmt: skip


def whole(report, beam, target, rounds):
    """A whole run against LAPACK's factor and solution, whose seconds it returns."""
    (band, load), case, name = beam.system(), beam.case(), f"{form(beam)}, slenderness {beam.slenderness:g}"
    work, ours, theirs, stages, peaks = np.empty_like(band), [], [], [], []
    row = lapack(band, load, work)[1]
    if row > 0:
        # Rounding made the matrix indefinite; a lift of the size of that rounding mends it.
        band[0] *= 1 + 4 * np.finfo(float).eps
        note = f"At slenderness {beam.slenderness:g} `dpbtrf` stops at row {row}: timed with the diagonal lifted by 4 eps."
        report.notes += [] if note in report.notes else [note]
    for _ in range(rounds):
        u, _, times, _ = lapack(band, load, work)
        theirs.append(times)
        text, times, _ = run(*VERIFY, case, "--json")
        ours.append(times)
        if len(stages) == 3:
            continue  # writing a million rows takes longer than all the rest
        summary = json.loads(run(PERISTAT, "run", case, *ONE_THREAD, "--json", "--force", "-o", WORK / "out")[0])
        stages.append(sum(summary["timing_s"][s] for s in ("assemble", "factor", "solve", "certify")))
        peaks.append(summary["peak_memory_bytes"] / (beam.cells + 1))
    ours, theirs, stage = np.median(ours, axis=0), np.median(theirs, axis=0), median(stages)
    ratio, seconds = ours / theirs, "{:.3f} s ({:.3f} s)".format
    report.row(f"whole run, {name}: CPU (wall)", seconds(*ours), seconds(*theirs),
               "{:.2f} ({:.2f})".format(*ratio), ratio[0], target)  # fmt: skip
    stages = f"{stage:.3f} s", f"{theirs[1]:.3f} s", f"{stage / theirs[1]:.2f}"
    report.row(f"its stages assemble to certify, {name}: wall", *stages)
    found = next(c["error"] for c in json.loads(text)[0]["checks"] if "w" in c["name"].split())
    report.row(f"error of w against the closed form, {name}", f"{found:.1e}", f"{beam.error(u):.1e}")
    report.row(f"peak memory of a run with output, {name}, bytes per point", f"{median(peaks):.0f}")
    return theirs[0]


def kernels(report, rounds):
    """Factor kernels on the matrix of crates/solve/examples/timing.rs: nanoseconds per point."""
    ours, theirs, order = [], [], 2 * MILLION
    for _ in range(rounds):
        printed = dict(re.findall(r"half bandwidth +(\d+): factor +([\d.]+) ns", run(KERNEL, str(MILLION))[0]))
        ours.append([float(printed[str(2 * m + 1)]) for m in range(1, 11)])
        theirs.append([])
        for width in range(4, 23, 2):
            k, j = np.ogrid[:width, :order]
            band = np.asfortranarray(np.where(k == 0, 2.0 * width, -1 + 0.01 * ((j + k) % 7)))
            load, work = np.ones(order), np.empty_like(band)
            theirs[-1].append(median(1e9 / MILLION * lapack(band, load, work)[3] for _ in range(5)))
    for m, a, b in zip(range(1, 11), np.median(ours, axis=0), np.median(theirs, axis=0)):
        report.row(f"factor kernel, m = {m}: ns per point", f"{a:.1f}", f"{b:.1f}", f"{a / b:.2f}", a / b, 1)


def machine():
    lib = scipy.show_config(mode="dicts")["Build Dependencies"]["lapack"]
    return f"{processor()}; SciPy {scipy.__version__} with {lib['name']} {lib['version']}, one thread"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--strict", action="store_true", help="exit 1 if a target is missed")
    parser.add_argument("--rounds", type=int, default=9, help="repeats that medians are taken of")
    options = parser.parse_args()
    WORK.mkdir(parents=True, exist_ok=True)
    report, loads = Report("LAPACK"), {20: 1e4, 1e4: 1e-4}
    stocky, slender = (Beam(slenderness, load) for slenderness, load in loads.items())
    band = [Beam(slenderness, load, solver="band") for slenderness, load in loads.items()]
    memory(report, stocky, 120)
    memory(report, band[0], 400)
    same_matrix(report, band)
    lapack_seconds = whole(report, stocky, 0.5, options.rounds)
    whole(report, slender, 0.5, options.rounds)
    whole(report, band[0], 2.8, options.rounds)
    whole(report, band[1], 9, options.rounds)
    accuracy(report)
    kernels(report, 3)
    growth(report, stocky, LONG, 1.08, 0.95, options.rounds)
    growth(report, band[0], SIZES, 1.15, None, options.rounds)
    frame(report, 30, 30, 53, lapack_seconds, options.rounds)
    text = f"{machine()}\n\n{report.markdown()}"
    (WORK / "beam.md").write_text(text)
    print(text, end="")
    return 1 if options.strict and report.missed else 0


if __name__ == "__main__":
    sys.exit(main())
