"""A clamped plate of up to four million points: iterations, whole runs, break-even of solvers, against pyamg.

Whole runs are `peristat verify` on a case as a child process: read, solve, certify, check, no files. Iterations and
counters are those of `peristat run --json`. pyamg solves the same matrix in a process of its own (`plate_amg.py`).
Competitors alternate, and medians are compared. This program itself needs nothing but Python: a child's peak of memory
counts what its parent holds. `bench/plate.sh` prepares everything and runs this.
"""

import argparse
import json
import os
import re
import subprocess
import sys
from math import cos, log, sin
from statistics import linear_regression, median

from measure import EXAMPLES, PERISTAT, ROOT, WORK, Report, processor, run

AMG = ROOT / "bench" / "plate_amg.py"
CORES = os.cpu_count()
SIDE = 1000.0  # mm; all plates are so high


class Plate:
    """Clamped on the left, sheared on the right; points over its height and its other features."""

    def __init__(self, points, aspect=1, hole=False, crack=False, solver="auto", loads=1, edges=None):
        spacing, width = SIDE / points, SIDE * aspect
        self.points = points * points * aspect
        rectangle = {"size": [width, SIDE], "spacing": spacing}
        if hole:
            rectangle["holes"] = [{"circle": {"centre": [width / 2, SIDE / 2], "radius": 0.2 * SIDE}}]
        self.case = json.loads((ROOT / "cases" / "bench" / "plate_1e6.json").read_text())
        self.case |= {"title": "Clamped plate", "body": {"rectangle": rectangle}, "solver": solver}
        self.case |= {"probes": [], "checks": []}
        if crack:
            self.case["cracks"] = [{"path": [[width / 2, 0.0], [width / 2, SIDE / 2]]}]
        if edges:
            self.case["model"]["bond_plane"]["edges"] = edges
        traction = lambda k: [{"traction": {"edge": "right", "uniform": [sin(k), -cos(k)]}}]
        if loads > 1:
            del self.case["loads"]
            self.case["load_cases"] = [{"name": f"load {k}", "loads": traction(k)} for k in range(loads)]
        kind = f"{'hole_' * hole}{'crack_' * crack}{solver}{edges or ''}"
        self.path = WORK / f"plate_{points}_{aspect}_{kind}_{loads}.json"
        self.path.write_text(json.dumps(self.case))

    def verify(self, threads=CORES):
        """Seconds in the process, CPU and wall seconds of the process, its peak memory."""
        output, times, peak = run(PERISTAT, "verify", self.path, "--json", "--threads", str(threads))
        return json.loads(output)[0]["time_s"], times, peak

    def summary(self):
        output = run(PERISTAT, "run", self.path, "--json", "--force", "-o", WORK / "plate")[0]
        return json.loads(output)


def pyamg(*options):
    """Lines of `plate_amg.py` on one thread."""
    one = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    command = [sys.executable, "-B", AMG, *map(str, options)]
    return [json.loads(line) for line in subprocess.check_output(command, env=os.environ | one).splitlines()]


def has(*packages):
    imports = subprocess.run([sys.executable, "-c", f"import {', '.join(packages)}"], capture_output=True)
    return imports.returncode == 0


def count(threads):
    return f"{threads} thread{'s'[: threads - 1]}"


def seconds(times):
    """Medians of wall and CPU seconds as a cell."""
    cpu, wall = (median(t[k] for t in times) for k in (0, 1))
    return f"{wall:.3f} s ({cpu:.3f} s)"


def kernel(report, rounds):
    """Speed of the internal force on a lattice of a million points."""
    line = re.compile(r"(\d+) thread\(s\): median ([\d.]+), best ([\d.]+)")
    found = [line.findall(run(EXAMPLES / "lattice_product")[0]) for _ in range(rounds)]
    for lines in zip(*found):
        threads = int(lines[0][0])
        middle, best = (f([float(line[k]) for line in lines]) for f, k in ((median, 1), (max, 2)))
        report.row(f"stencil kernel, {count(threads)}: million points per second; best of all", f"{middle:.1f}",
                   value=f"{best:.1f}", measured=middle, least=65 if threads == 1 else None)  # fmt: skip


def same_matrix(report):
    """The matrix that pyamg gets is the one peristat assembles, entry by entry, edges included."""
    plate = Plate(14, edges="overlay")  # those of `plate_amg.py`
    size, spacing = (19, 13), 0.5
    body = {"rectangle": {"size": [n * spacing for n in size], "spacing": spacing}}
    plate.path.write_text(json.dumps(plate.case | {"body": body}))
    file = WORK / "plate.mtx"
    run(PERISTAT, "run", plate.path, "-q", "-o", WORK / "plate", "--force", "--write-matrix", file)
    [worst] = pyamg("--check", file, "--size", *size, "--spacing", spacing)
    report.row("same matrix: `max abs(dK_ij) / sqrt(K_ii K_jj)`, 19 x 13 points", value=f"{worst:.1e}",
               measured=worst, target=1e-14)  # fmt: skip


def iterations(report, quick):
    """Conjugate-gradient iterations to a residual of 1e-10 of the load."""

    def of(plate):
        solver = plate.summary()["solver"]
        if solver["method"] != "multigrid":
            report.notes.append(f"{plate.path.name} was solved with {solver['method']}, not multigrid.")
        return max(solver["iterations"])

    counts = [of(Plate(side)) for side in (100, 316, 1000)]
    spread = max(counts) - min(counts)
    listed = ", ".join(map(str, counts))
    report.row("iterations to 1e-10: intact squares of 1e4, 1e5, 1e6 points; largest difference", listed,
               value=str(spread), measured=spread, target=3)  # fmt: skip
    cantilevers = {"512 x 64": Plate(64, 8), "1024 x 128": Plate(128, 8)}
    if not quick:
        cantilevers["4096 x 512"] = Plate(512, 8)
    plates = {f"8:1 cantilever, {size} points": plate for size, plate in cantilevers.items()} | {
        "hole of radius 0.2, 512 x 512": Plate(512, hole=True),
        "crack over half the height, 512 x 512": Plate(512, crack=True),
        "hole and crack, 512 x 512": Plate(512, hole=True, crack=True),
    }
    for name, plate in plates.items():
        found = of(plate)
        report.row(f"iterations to 1e-10: {name}", str(found), measured=found, target=25)


def million(report, rounds):
    """The case of cases/bench, checks included."""
    command = PERISTAT, "verify", ROOT / "cases" / "bench" / "plate_1e6.json", "--threads"
    both, one = [], []
    for _ in range(rounds):
        both.append(run(*command, str(CORES)))
        one.append(run(*command, "1"))
    wall = median(times[1] for _, times, _ in both)
    report.row(f"whole run, 1e6 points, {CORES} threads: wall (CPU)", seconds([b[1] for b in both]), measured=wall, target=3)
    report.row("whole run, 1e6 points, 1 thread: wall (CPU)", seconds([o[1] for o in one]))
    peak = max(b[2] for b in both) / 1e9
    report.row("its peak memory, GB", f"{peak:.3f}", measured=peak, target=1)


def against_pyamg(report, rounds, side=316):
    """A plate of 1e5 points; of pyamg set-up and solution alone, its matrix is there already."""
    plate, theirs = Plate(side, edges="overlay"), []
    setting = None
    if has("pyamg", "scipy"):
        same_matrix(report)
        setting = min(pyamg("--side", side), key=lambda found: found["total"])["setting"]
    both, one = [], []
    for _ in range(rounds):
        both.append(plate.verify()[1])
        one.append(plate.verify(1)[1])
        theirs += pyamg("--side", side, "--setting", setting) if setting else []
    for threads, times, limit in (CORES, both, 0.45), (1, one, None):
        wall = median(t[1] for t in times)
        what = f"whole run, 1e5 points, {count(threads)}: wall (CPU)"
        report.row(what, seconds(times), measured=wall, target=limit)
        if setting:
            total, setup = (median(t[k] for t in theirs) for k in ("total", "setup"))
            cell = f"{total:.2f} s (set-up {setup:.2f} s)"
            report.row(f"the same against set-up and solution of pyamg, {count(threads)}",
                       f"{wall:.3f} s", cell, f"{wall / total:.3f}", wall / total, limit and 1 / 6)  # fmt: skip
    if setting:
        assembly = median(t["assembly"] for t in theirs)
        found = theirs[-1]
        report.notes.append(
            f"pyamg: {setting}; {found['iterations']} iterations to a residual of {found['residual']:.0e}, operator "
            f"complexity {found['complexity']:.2f}, one thread; assembly in NumPy ({assembly:.1f} s) not counted."
        )  # fmt: skip


def growth(report, rounds, quick):
    """Exponent of the time that a case takes, from its reading to its last check, over the number of points."""
    plates = [Plate(side) for side in (8, 100, 178, 316, 562, 1000, 2000)]
    plates = plates[:-1] if quick else plates
    sizes = [plate.points for plate in plates[1:]]
    for threads in sorted({1, CORES}):
        found = [[plate.verify(threads) for plate in plates] for _ in range(rounds)]
        times = [median(f[k][0] for f in found) for k in range(len(plates))]
        times = [t - times[0] for t in times[1:]]  # 64 points are what every case takes
        slope = lambda k: linear_regression([log(n) for n in sizes[k:]], [log(t) for t in times[k:]]).slope
        listed = ", ".join(f"{1e6 * t / n:.2f}" for t, n in zip(times, sizes))
        span = f"{sizes[0]:.0e} to {sizes[-1]:.0e} points ({listed} microseconds per point)"
        limits = {"measured": slope(0), "target": 1.1, "least": 0.9} if threads == 1 else {}
        value = f"{slope(0):.3f} ({slope(2):.3f} from {sizes[2]:.0e})"
        report.row(f"growth exponent, {count(threads)}, {span}", value=value, **limits)
        if not quick:
            peak, times = max(f[-1][2] for f in found) / 1e9, [f[-1][1] for f in found]
            what = f"whole run, 4e6 points, {count(threads)}: wall (CPU); peak memory"
            report.row(what, seconds(times), value=f"{peak:.2f} GB")


def crossing(sizes, ratios):
    """Size from which a ratio stays below 1, between two sizes by its logarithm; `None` if it is above 1 to the end."""
    above = [k for k, ratio in enumerate(ratios) if ratio > 1]
    if not above:
        return sizes[0]
    if above[-1] + 1 == len(sizes):
        return None
    (n, m), (a, b) = sizes[above[-1] :][:2], ratios[above[-1] :][:2]
    return n * (m / n) ** (log(a) / (log(a) - log(b)))


def break_even(report, rounds, quick):
    """Where a multigrid cycle beats a factor: points of a square, and load cases at 1e5 points."""
    # Below 1500 points there are no coarser levels.
    sides = (40, 63, 126, 316) if quick else (40, 45, 54, 63, 77, 100, 141, 200, 251, 316)
    sparse, cycle = ([Plate(side, solver=solver) for side in sides] for solver in ("sparse", "multigrid"))
    chosen = ", ".join(Plate(side).summary()["solver"]["method"][0] for side in sides)
    for threads in sorted({1, CORES}):
        # Milliseconds are many: small plates take more rounds.
        found = []
        for a, b in zip(sparse, cycle):
            often = rounds * (1 if a.points > 2e4 else 3)
            pairs = [(a.verify(threads)[0], b.verify(threads)[0]) for _ in range(often)]
            found.append([median(p[k] for p in pairs) for k in (0, 1)])
        sizes = [plate.points for plate in sparse]
        listed = ", ".join(f"{n}: {1e3 * d:.1f} / {1e3 * m:.1f}" for n, (d, m) in zip(sizes, found))
        at = crossing(sizes, [m / d for d, m in found])
        words = "multigrid is slower" if at is None else f"multigrid is faster from {at:.0f} points"
        report.row(f"break-even, one load, {count(threads)}: ms by points, factor / multigrid", listed, value=words)
    report.row("what `auto` takes for these: s(parse) or m(ultigrid)", chosen)
    sides_of = lambda solver: [Plate(316, solver=solver, loads=loads) for loads in (1, 9)]
    plates = sides_of("sparse") + sides_of("multigrid")
    for threads in sorted({1, CORES}):
        found = [[plate.verify(threads)[0] for plate in plates] for _ in range(rounds)]
        d, ds, m, ms = (median(f[k] for f in found) for k in range(4))
        solve, cycles = (ds - d) / 8, (ms - m) / 8
        loads = 1 + (d - m) / (cycles - solve) if cycles > solve else None
        words = f"factor is faster from {loads:.0f} loads" if loads else "a load costs more with the factor"
        report.row(f"break-even, 1e5 points, {count(threads)}: first load, each other one, factor / multigrid",
                   f"{d:.2f} / {m:.2f} s, {solve:.3f} / {cycles:.3f} s", value=words)  # fmt: skip


def skipping(report):
    """Counters of an intact lattice, and what a second load adds to them."""
    for solver in "multigrid", "sparse":
        one, two = (Plate(100, solver=solver, loads=loads).summary()["counters"] for loads in (1, 2))
        if solver == "multigrid":
            stored = one["stored_bond_factors"]
            report.row("numbers stored for bonds, intact lattice of 1e4 points", str(stored), measured=stored, target=0)
        added = {k: two[k] - one[k] for k in ("analyses", "factorisations", "right_hand_sides")}
        extra = added["analyses"] + added["factorisations"]
        words = f"{added['analyses']}, {added['factorisations']}, {added['right_hand_sides']}"
        report.row(f"a second load adds analyses, factorisations, right-hand sides, {solver}", words,
                   measured=extra, target=0)  # fmt: skip


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--strict", action="store_true", help="exit 1 if a target is missed")
    parser.add_argument("--quick", action="store_true", help="leave out the largest plates and some sizes")
    parser.add_argument("--rounds", type=int, default=7, help="repeats that medians are taken of")
    options = parser.parse_args()
    WORK.mkdir(parents=True, exist_ok=True)
    report = Report("pyamg")
    kernel(report, options.rounds)
    iterations(report, options.quick)
    million(report, options.rounds)
    against_pyamg(report, options.rounds)
    growth(report, options.rounds, options.quick)
    break_even(report, options.rounds, options.quick)
    skipping(report)
    load = f"load {os.getloadavg()[0]:.1f} at the end" if hasattr(os, "getloadavg") else ""
    text = f"{processor()}; medians of {options.rounds} rounds; {load}\n\n{report.markdown()}"
    (WORK / "plate.md").write_text(text)
    print(text, end="")
    return 1 if options.strict and report.missed else 0


if __name__ == "__main__":
    sys.exit(main())
