"""Draws error over time of all runs that `pareto.py` left in target/bench/pareto.json, with peristat's front."""

import json
import re

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt
from measure import ROOT, WORK
from pareto_front import front

LOOKS = {  # colours of Okabe and Ito, which the colour-blind tell apart
    "peristat exact": ("#d55e00", "o"),
    "peristat corrected": ("#e69f00", "h"),
    "peristat published": ("#999999", "o"),
    "peristat bond_plane": ("#d55e00", "o"),
    "peristat beam_bond_orthotropic": ("#d55e00", "o"),
    "peristat local": ("#900c3f", "*"),
    "peristat state_plane": ("#e69f00", "h"),
    "SciPy solveh_banded": ("#0072b2", "s"),
    "SciPy spsolve": ("#56b4e9", "D"),
    "scikit-fem Q1": ("#009e73", "^"),
    "scikit-fem Q2": ("#004d38", "^"),
    "scikit-fem": ("#009e73", "^"),
    "OpenSeesPy": ("#cc79a7", "v"),
    "PyNite": ("#000000", "x"),
    "CalculiX CPS4": ("#b8a24a", "P"),
    "CalculiX CPS8": ("#6b5600", "P"),
    "CalculiX": ("#8a6d00", "P"),
    "NumPy peridynamics": ("#0072b2", "s"),
}
CLOCKS = {"cpu": "whole process: CPU seconds", "inside": "inside the program: wall seconds"}
STYLE = {"svg.fonttype": "none", "svg.hashsalt": "peristat", "font.size": 11, "font.family": "sans-serif"}


def name(row):
    """Of what has one colour: a program, or with the law, model, limit or element where it has a look of its own."""
    program, parts = row["program"].replace("`", ""), row["method"].replace("`", "").split(", ")
    part = "local" if "local" in parts else parts[0]
    return f"{program} {part}" if f"{program} {part}" in LOOKS else program


def grouped(rows, key):
    groups = {}
    for row in rows:
        groups.setdefault(key(row), []).append(row)
    return groups.items()


def area(row):
    """Markers of beams grow with the points that a run gives."""
    return 9 * len(str(row["points"])) if row["points"] else 30


def panel(axes, rows, clock, words):
    top, far = 2 * max(row["error"] for row in rows), 3 * max(row[clock] for row in rows)
    places = lambda some: ([row[clock] for row in some], [row["error"] for row in some])
    ours, (times, errors) = LOOKS["peristat exact"][0], places(front(rows, clock))
    axes.fill_between([*times, far], [*errors, errors[-1]], top, step="post", color=ours, alpha=0.08, lw=0)
    axes.step([times[0], *times, far], [top, *errors, errors[-1]], where="post", color=ours, lw=1.2)
    for label, mine in grouped(rows, name):
        colour, marker = LOOKS[label]
        for _, line in grouped(mine, lambda row: row["method"]):
            axes.plot(*places(line), color=colour, lw=0.6, alpha=0.5)
        for k, (size, some) in enumerate(grouped(mine, area)):
            axes.scatter(*places(some), s=size, color=colour, marker=marker, alpha=0.8, lw=1, label="" if k else label)
    axes.set(xscale="log", yscale="log", xlabel=words)
    axes.set_xlim(min(row[clock] for row in rows) / 2, far)
    axes.grid(alpha=0.25, lw=0.5)


def figure(panels, title, note, path):
    """`panels`: two of rows, a clock and the words below."""
    picture, places = plt.subplots(1, 2, figsize=(11, 6), sharey=True)
    for axes, (rows, clock, words) in zip(places, panels):
        panel(axes, rows, clock, words)
    errors = [row["error"] for rows, *_ in panels for row in rows]
    places[0].set(ylabel="largest error / largest value", ylim=(min(errors) / 3, 2 * max(errors)))
    picture.suptitle(title)
    looks = {label: handle for axes in places for handle, label in zip(*axes.get_legend_handles_labels())}
    picture.legend(looks.values(), looks.keys(), loc="lower center", ncols=5, frameon=False, bbox_to_anchor=(0.5, 0.035))
    picture.text(0.5, 0.015, note, ha="center", fontsize=9)
    picture.subplots_adjust(left=0.07, right=0.985, top=0.92, bottom=0.23, wspace=0.04)
    picture.savefig(path, metadata={"Date": None})
    plt.close(picture)
    path.write_text(re.sub(r"(\d\.\d\d)\d+", r"\1", path.read_text()))  # a hundredth of a point is enough


def both_clocks(rows):
    return [(rows, clock, words) for clock, words in CLOCKS.items()]


def of_stress(rows, words):
    return [row | {"error": row["stress"]} for row in rows], "cpu", f"{words}: {CLOCKS['cpu']}"


def main():
    sets = json.loads((WORK / "pareto.json").read_text())
    with plt.rc_context(STYLE):
        line = "Line and shade: peristat's front; runs in the shade are slower and no more accurate. "
        beam = "Cantilever of slenderness 20 under a uniform load: error of the deflection over the points"
        figure(both_clocks(sets["beam_20"]), beam, line + "Larger markers: more points.", WORK / "pareto_beam.svg")
        plate = "Plane-stress cantilever: error of the displacements over the points"
        figure(both_clocks(sets["plate"]), plate, line.strip(), WORK / "pareto_plate.svg")
        hole = "Quarter of a strip with a round hole: error of the largest stress"
        kinds = ("hole_isotropic", "isotropic"), ("hole_laminate", "laminate, 14 : 1")
        figure([of_stress(sets[key], words) for key, words in kinds], hole, line.strip(), WORK / "pareto_hole.svg")


if __name__ == "__main__":
    main()
