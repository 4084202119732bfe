"""Read the results of a run with nothing but Python."""

import csv
import json
from pathlib import Path

folder = Path("results/breaking_plate")


def table(name: str) -> dict[str, list[float]]:
    """Columns of a table by their names, without units."""
    with open(folder / name, encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return {key.split(" [")[0]: [float(row[key]) for row in rows] for key in rows[0]}


summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
print(summary["status"], summary["fracture"]["facts"]["peak_load"])

curve = table("curve.csv")                       # every equilibrium
worst = max(map(abs, curve["balance"]))
print(len(curve["load"]), "equilibria, energy balance within", worst)

fields = table("fields/step_002.csv")            # one row per point
broken = [(x, y) for x, y, d in zip(fields["x"], fields["y"], fields["damage"]) if d > 0.3]
print(len(broken), "points with more than 0.3 of their bonds cut")
