"""How the time and the memory of peristat grow with the points of a cube, on one thread."""

import sys
from math import log
from statistics import linear_regression

from solid_cases import cube, middle

MODELS = {  # model, horizon ratio, cells a side
    "`bond_solid`, m = 2": ("bonds", 2, (32, 64, 100)),
    "`bond_solid`, m = 3": ("bonds", 3, (32, 64, 100)),
    "`state_solid`, m = 2": ("families", 2, (32, 64, 100)),
    "`state_solid`, m = 3": ("families", 3, (32, 64)),
}
LARGE = 216
LONG = 5.0  # CPU seconds from which one run does
HEAD = "model", "cells a side", "iterations", "CPU s", "us per point", "peak MB", "bytes per point"


def measured(rounds, quick, large):
    """A row per model and size; runs alternate."""
    cases, rows = {}, []
    for name, (model, ratio, sizes) in MODELS.items():
        more = (LARGE,) if large and model == "bonds" else ()
        cases |= {(name, n): cube(n, ratio, model) for n in (sizes[:2] if quick else sizes + more)}
    runs = {key: [] for key in cases}
    for done in range(rounds):
        for key, solid in cases.items():
            if not done or runs[key][0].cpu < LONG:
                runs[key].append(solid.verify())
                print(f"  round {done + 1}: {key[0]}, {key[1]}: {runs[key][-1].cpu:.2f} s", file=sys.stderr)
    for (name, n), solid in cases.items():
        # A run writes its fields, gigabytes of the largest.
        steps = max(solid.summary()["solver"]["iterations"]) if n < LARGE else None
        cpu, peak = (middle(runs[name, n], key) for key in ("cpu", "peak"))
        rows.append({"model": name, "size": n, "iterations": steps, "cpu": cpu, "peak": peak})
    return rows


def cells(rows):
    for row in rows:
        points = row["size"] ** 3
        times = f"{row['cpu']:.2f}", f"{1e6 * row['cpu'] / points:.1f}"
        steps = "" if row["iterations"] is None else str(row["iterations"])
        yield [row["model"], str(row["size"]), steps, *times, f"{row['peak'] / 1e6:.0f}", f"{row['peak'] / points:.0f}"]


def growth(rows):
    slope, _ = linear_regression([log(row["size"] ** 3) for row in rows], [log(row["cpu"]) for row in rows])
    return slope


def verdicts(report, rows):
    per_point = lambda row: row["cpu"] / row["size"] ** 3
    grouped = {name: [row for row in rows if row["model"] == name] for name in MODELS}
    for name, mine in grouped.items():
        span = f"{mine[0]['size']} to {mine[-1]['size']} cells a side, {name}"
        report.row(f"growth exponent, {span}", value=f"{growth(mine):.3f}", measured=growth(mine), target=1.05)
        mine = [row for row in mine if row["size"] < LARGE]
        last, ratio, steps = mine[-1], per_point(mine[-1]) / per_point(mine[0]), max(row["iterations"] for row in mine)
        at, memory = f"{last['size']} cells a side, {name}", last["peak"] / last["size"] ** 3
        report.row(f"time per point over that of {mine[0]['size']} cells a side, {at}", value=f"{ratio:.2f}", measured=ratio, target=1.3)
        report.row(f"most iterations up to {at}", str(steps), measured=steps, target=16)
        report.row(f"peak memory, {at}, bytes per point", f"{memory:.0f}", measured=memory, target=280)
    for ratio in 2, 3:
        bonds, families = (grouped[f"`{model}`, m = {ratio}"] for model in ("bond_solid", "state_solid"))
        size = families[-1]["size"]
        a, b = (next(row for row in some if row["size"] == size) for some in (bonds, families))
        report.row(f"`state_solid` over `bond_solid`, m = {ratio}, {size} cells a side: CPU", f"{b['cpu']:.2f} s over {a['cpu']:.2f} s",
                   value=f"{b['cpu'] / a['cpu']:.2f}", measured=b["cpu"] / a["cpu"], target=2.3)  # fmt: skip
