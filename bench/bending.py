"""Clamped square plates in bending: time against error beside elements, size, iterations, and a plate in its plane.

Every run is a process of its own on one thread; programs alternate, and medians of CPU seconds count, start and imports
included. `bench/bending.sh` prepares everything and runs this.
"""

import argparse
import json
import os
import sys
import time
from math import log
from pathlib import Path
from statistics import linear_regression, median

from measure import PERISTAT, ROOT, WORK, Report, processor, run
from pareto import measured, section, table
from pareto_jobs import Job, last, missing, script, verify

# Deflection in the middle of a thin clamped square in units of q a^4 / D: Taylor and Govindjee (2004), doi:10.1002/cnm.681.
DEFLECTION = 0.00126531908739
THIN, POISSON_RATIO = 1e-5, 0.3
MODULUS = 12 * (1 - POISSON_RATIO**2) / THIN**3  # so that D = 1
SIZES = 16, 32, 64, 128, 256, 512
ELEMENTS = {  # sizes of a quarter
    "morley": ("Morley", (8, 16, 32, 64, 128)),
    "argyris": ("Argyris", (1, 2, 4, 8, 16)),
}
ITERATIONS = 128, 256, 512, 750, 1000
THICKNESSES = 0.2, 1e-2, 1e-3, 1e-5


def case(cells, thickness, solver="auto"):
    """A square of side 1, clamped all around, under a uniform pressure; its deflection is told against the thin plate's."""
    modulus = 12 * (1 - POISSON_RATIO**2) / thickness**3
    model = {"youngs_modulus": modulus, "poisson_ratio": POISSON_RATIO, "thickness": thickness}
    path = WORK / f"bending_{cells}_{thickness:g}_{solver}.json"
    path.write_text(
        json.dumps(
            {
                "title": "Clamped square",
                "units": "none",
                "model": {"plate_bending": model},
                "body": {"rectangle": {"size": [1.0, 1.0], "spacing": 1 / cells}},
                "supports": [{"at": {"region": "all"}, "w": 0.0, "phi_n": 0.0, "phi_t": 0.0}],
                "loads": [{"pressure": {"value": 1.0}}],
                "solver": solver,
                "probes": [{"name": "middle", "at": {"x": 0.5, "y": 0.5}, "field": "w"}],
                "checks": [{"limit": {"probe": "middle", "at_most": 1.0, "why": "the bench compares it"}}],
            }
        )
    )
    return path


def answer(path):
    """Deflection of the middle, and iterations."""
    command = PERISTAT, "run", path, "--json", "--force", "--no-estimate", "--threads", "1", "-o", WORK / "bending"
    summary = json.loads(run(*command)[0])
    return summary["probes"][0]["value"], summary["counters"]["pcg_iterations"]


def jobs(quick, lacks):
    """Runs whose error and time are compared."""
    seconds = lambda output: json.loads(output)[0]["time_s"]
    for cells in SIZES[:4] if quick else SIZES:
        path = case(cells, THIN)
        error = lambda _, path=path: abs(answer(path)[0] / DEFLECTION - 1)
        yield Job("peristat", "`plate_bending`, default", f"{cells} x {cells}", 0, verify(path), error, seconds)
    for name, (method, sizes) in ELEMENTS.items():
        for size in () if lacks(["skfem"]) else sizes[:3] if quick else sizes:
            error = lambda output: abs(last(output)["deflection"] / DEFLECTION - 1)
            command = script("bending_fe.py", name, size)
            grid = f"quarter of {size} x {size} x 2"
            yield Job("scikit-fem", method, grid, 0, command, error, lambda output: last(output)["inside_s"])


def sizes(report, quick, rounds):
    """Iterations by size and thickness, and a million points against as many in a plane."""
    cells = [n for n in ITERATIONS if n < 750 or not quick]
    most = {n: {t: answer(case(n, t, "multigrid"))[1] for t in THICKNESSES} for n in cells}
    for t in THICKNESSES:
        found = [most[n][t] for n in cells]
        what = f"iterations, thickness {t:g} of the side, {', '.join(map(str, cells))} cells a side"
        report.row(what, ", ".join(map(str, found)), measured=max(found), target=18)
    side = cells[-1]
    plane = json.loads((ROOT / "cases" / "bench" / "plate_1e6.json").read_text())
    plane |= {"probes": [], "checks": [], "body": {"rectangle": {"size": [1000.0, 1000.0], "spacing": 1000 / side}}}
    (WORK / "bending_plane.json").write_text(json.dumps(plane))
    pair = {"bent": case(side, 1e-3), "plane": WORK / "bending_plane.json"}
    times = {name: [] for name in pair}
    for _ in range(rounds):
        for name, path in pair.items():
            times[name].append(run(*verify(path))[1][0])
    bent, flat = (median(times[name]) for name in pair)
    what = f"whole run, {side} x {side} cells, thickness 1e-3, against the same plate in its plane: CPU"
    report.row(what, f"{bent:.2f} s", f"{flat:.2f} s", f"{bent / flat:.2f}", measured=bent / flat, target=2.5)


def growth(rows):
    """Order of the error in the spacing, of peristat's runs."""
    mine = [row for row in rows if row["program"] == "peristat" and int(row["size"].split()[0]) >= 32]
    spacing = [-log(int(row["size"].split()[0])) for row in mine]
    return linear_regression(spacing, [log(row["error"]) for row in mine]).slope


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="small sizes")
    parser.add_argument("--strict", action="store_true", help="exit code 1 if a target is missed")
    parser.add_argument("--rounds", type=int, default=3, help="repeats that medians are taken of")
    options = parser.parse_args()
    os.environ |= dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")
    WORK.mkdir(parents=True, exist_ok=True)
    notices, begin = [], time.perf_counter()
    lacks = missing(notices.append)
    rows = measured(list(jobs(options.quick, lacks)), options.rounds)
    report = Report("plate in its plane")
    report.row("order of the error of the deflection in the spacing", value=f"{growth(rows):.2f}", measured=growth(rows), least=1.85)
    sizes(report, options.quick, options.rounds)
    words = "Runs of every error count; one is below if peristat needs more time for an error no larger."
    head = f"{processor()}, one thread; medians of {options.rounds} rounds; {time.perf_counter() - begin:.0f} s in all\n"
    cells = [[row["program"], row["method"], row["size"], f"{row['error']:.1e}", f"{row['cpu']:.3f}"] for row in rows]
    runs = table(["program", "method", "size", "error", "CPU s"], cells)
    text = "\n".join([head, report.markdown(), section("Clamped square", words, rows, None), runs, *(f"{n}\n" for n in notices)])
    (WORK / "bending.md").write_text(text)
    print(text, end="")
    if not lacks(["matplotlib"]):
        draw(rows, WORK / "bending_error.svg")
    sys.exit(1 if options.strict and report.missed else 0)


def draw(rows, path: Path):
    """Error over CPU seconds."""
    import matplotlib

    matplotlib.use("svg")
    import matplotlib.pyplot as plt
    from pareto_plot import STYLE

    looks = {"`plate_bending`, default": ("#d55e00", "o"), "Morley": ("#009e73", "^"), "Argyris": ("#004d38", "s")}
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(figsize=(7, 4.6), layout="constrained")
        for method, (colour, marker) in looks.items():
            mine = [row for row in rows if row["method"] == method]
            label = f"{mine[0]['program']}: {method}".replace("`", "") if mine else None
            axes.plot([r["cpu"] for r in mine], [r["error"] for r in mine], color=colour, marker=marker, label=label)
        axes.set(xscale="log", yscale="log", xlabel="CPU seconds of the whole process", ylabel="relative error of the deflection")
        axes.set_title("Thin clamped square, uniform pressure")
        axes.grid(alpha=0.3)
        axes.legend()
        figure.savefig(path, metadata={"Date": None})


if __name__ == "__main__":
    main()
