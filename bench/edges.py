"""What treatments of edges cost: errors of bodies with known answers, iterations, time. Prints the table of edges.md.

Usage: edges.py [PERISTAT], the command; target/release/peristat if not given.
"""

import csv
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from pareto_problems import Plate  # noqa: E402

COMMAND = sys.argv[1] if len(sys.argv) > 1 else str(Path(__file__).parent.parent / "target/release/peristat")
FORMS = ["none", "overlay", "border"]
STATE_FORMS = ["none", "ghosts", "border"]
E = 70000.0
# Poisson's ratio of the models that do not fix it.
NU = 0.3
ELASTIC = {
    "bond_plane": {"youngs_modulus": E, "state": "plane_stress", "calibration": "matched"},
    "beam_bond_orthotropic": {
        "youngs_modulus_1": E,
        "youngs_modulus_2": E,
        "poisson_ratio_12": NU,
        "shear_modulus_12": E / (2 + 2 * NU),
        "fibre_angle": 0,
        "calibration": "matched",
    },
    "state_plane": {"youngs_modulus": E, "poisson_ratio": NU, "state": "plane_stress"},
}
RING = "displacements / hoop stress at points / on the bore"
HOLE = [{"circle": {"centre": [128, 128], "radius": 51.2}}]


def solve(case):
    """Summary of a case."""
    return solve_with_fields(case)[0]


def solve_with_fields(case):
    """Summary of a case, and the rows of the fields of its last state."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "case.json"
        path.write_text(json.dumps(case))
        arguments = ["run", str(path), "-o", f"{folder}/out", "-q", "--json", "--no-estimate"]
        done = subprocess.run([COMMAND, *arguments], capture_output=True, text=True, check=False)
        tables = sorted(Path(folder).glob("out/fields/*.csv"))
        lines = list(csv.DictReader(tables[-1].open())) if tables else []
    summary = json.loads(done.stdout)
    if "model" not in summary:
        raise SystemExit(done.stderr)
    return summary, [{key.split(" [")[0]: float(value) for key, value in line.items()} for line in lines]


def values(case):
    return [probe["value"] for probe in solve(case)["probes"]]


def plate(form, body, ratio=3, kind="bond_plane", **more):
    model = {kind: ELASTIC[kind] | {"edges": form}}
    case = {"title": "edges", "units": "mm-N-MPa", "model": model, "body": body, "horizon_ratio": ratio}
    return case | more


def rectangle(size, spacing=1.0, **more):
    return {"rectangle": {"size": size, "spacing": spacing, **more}}


def probe(x, y, field, **more):
    return {"name": f"{field} {x} {y}", "at": {"x": x, "y": y, **more}, "field": field}


def pulled(form, ratio, **more):
    """40 x 20 between held edges, one moved by a hundredth of the length: one stress of 700."""
    supports = [
        {"at": {"region": "left"}, "ux": 0},
        {"at": {"x": 0.5, "y": 2.5}, "uy": 0},
        {"at": {"region": "right"}, "ux": 0.4},
    ]
    force = {"name": "F", "at": {"region": "right"}, "field": "reaction_x"}
    probes = [force, probe(0.5, 0.5, "stress_xx"), probe(20.5, 0.5, "stress_xx")]
    return plate(form, rectangle([40, 20]), ratio, supports=supports, probes=probes, **more)


def held(form, ratio, **more):
    force, corner, free = values(pulled(form, ratio, **more))
    return [force / 14000 - 1, corner / 700 - 1, free / 700 - 1]


def angle(form, ratio):
    """An L under the tractions of one stress with shear: the largest error of a stress at its re-entrant corner."""
    vertices = [[0, 0], [20, 0], [20, 8], [9, 8], [9, 16], [0, 16]]
    stress = [300.0, -120.0, 80.0]
    loads = []
    for k, [x, y] in enumerate([[0, -1], [1, 0], [0, 1], [1, 0], [0, 1], [-1, 0]]):
        traction = [stress[0] * x + stress[2] * y, stress[2] * x + stress[1] * y]
        loads.append({"traction": {"edge": f"edge_{k + 1}", "uniform": traction}})
    supports = [{"at": {"x": 0.5, "y": 0.5}, "ux": 0, "uy": 0}, {"at": {"x": 19.5, "y": 0.5}, "uy": 0}]
    fields = ["stress_xx", "stress_yy", "stress_xy"]
    probes = [probe(x, y, f) for x, y in [(8.5, 7.5), (9.5, 7.5), (8.5, 8.5)] for f in fields]
    body = {"outline": {"vertices": vertices, "spacing": 1}}
    found = values(plate(form, body, ratio, loads=loads, supports=supports, probes=probes))
    return max(abs(value - stress[k % 3]) for k, value in enumerate(found)) / 300


def cantilever(form, ratio, rows):
    """Clamped, length twice the height, parabolic shear; converged biquadratic finite elements have 0.021674."""
    case = plate(
        form,
        rectangle([80, 40], 40 / rows),
        ratio,
        supports=[{"at": {"region": "left"}, "ux": 0, "uy": 0}],
        loads=[{"traction": {"edge": "right", "parabolic": [0, 1.5]}}],
        probes=[probe(80, 20, "uy", inward=[-1, 0])],
    )
    return values(case)[0] / 0.021674 - 1


def smooth(form, ratio, rows):
    """The free plate of the Pareto bench, all tractions by its exact stress: largest displacement error over the largest displacement."""
    exact = Plate()
    h, axis = exact.height / rows, exact.height / 2
    moment, shear = exact.traction(False, exact.height)[0], exact.traction(True, axis)[1]
    chosen = [sorted({*range(0, count, rows // 7), count - 1}) for count in (27 * rows // 7, rows)]
    places = [((i + 0.5) * h, (j + 0.5) * h) for i in chosen[0] for j in chosen[1]]
    case = plate(
        form,
        rectangle([exact.length, exact.height], h),
        ratio,
        supports=[{"at": {"x": exact.middle, "y": axis}, "ux": 0, "uy": 0}, {"at": {"x": exact.second, "y": axis}, "uy": 0}],
        loads=[
            {"traction": {"edge": "right", "parabolic": [0, shear]}},
            {"traction": {"edge": "left", "parabolic": [0, -shear]}},
            {"traction": {"edge": "left", "linear": [[-moment, 0], [moment, 0]]}},
        ],
        probes=[probe(x, y, field) for x, y in places for field in ("ux", "uy")],
    )
    found = values(case)
    wanted = [value for x, y in places for value in exact.displacement(x, y)]
    return max(abs(a - b) for a, b in zip(found, wanted)) / max(map(abs, wanted))


def first_break(form):
    """Load factor at which the strip breaks whose bonds fail at its nominal strain."""
    fracture = {"critical": {"stretch": 0.01}, "strategy": "worst", "load": "F", "max_solves": 1}
    case = pulled(form, 3, fracture=fracture)
    case["supports"][2]["ux"] = 0.8
    return 2 * solve(case)["fracture"]["facts"]["first_break_load_factor"]


def ring(form, ratio, count, kind="bond_plane"):
    """A quarter of a ring, 10 to 25, under a pressure of 100 inside (Lamé), `count` points per inner radius: the mean error of
    displacements, and the largest of the hoop stress at points and on the bore, per the largest."""
    a, b, p = 10.0, 25.0, 100.0
    arc = [[round(b * math.cos(math.pi * k / 360), 12), round(b * math.sin(math.pi * k / 360), 12)] for k in range(181)]
    bore = {"circle": {"name": "bore", "centre": [0, 0], "radius": a}}
    body = {"outline": {"vertices": [[0, 0], *arc], "spacing": a / count, "holes": [bore]}}
    load = {"traction": {"edge": "bore", "pressure": p}}
    # Stress along x over the middle and along y beside it: both are the hoop stress there.
    probes = [probe(0, a, "stress_xx", inward=[0, 1]), probe(a, 0, "stress_yy", inward=[1, 0])]
    case = plate(form, body, ratio, kind, symmetry=["left", "bottom"], loads=[load], probes=probes)
    summary, points = solve_with_fields(case)
    size = p * a**2 / (b**2 - a**2)
    nu = 1 / 3 if kind == "bond_plane" else NU
    most = size * (1 + b**2 / a**2)
    bore = max(abs(found["value"] / most - 1) for found in summary["probes"])
    off = whole = hoop = 0.0
    for q in points:
        r = math.hypot(q["x"], q["y"])
        c, s = q["x"] / r, q["y"] / r
        radial = size / E * ((1 - nu) * r + (1 + nu) * b**2 / r)
        off += (q["ux"] - radial * c) ** 2 + (q["uy"] - radial * s) ** 2
        whole += radial**2
        found = q["stress_xx"] * s**2 + q["stress_yy"] * c**2 - 2 * q["stress_xy"] * s * c
        hoop = max(hoop, abs(found - size * (1 + b**2 / r**2)) / most)
    return math.sqrt(off / whole), hoop, bore


def slanted(form, ratio, rows, kind="bond_plane"):
    """A strip 40 x 16 in pure bending, turned by 0.3 to the rows: the largest error of a normal stress, per the largest."""
    c, s = math.cos(0.3), math.sin(0.3)
    vertices = [[c * x - s * y, s * x + c * y] for x, y in [[-20, -8], [20, -8], [20, 8], [-20, 8]]]
    profile = [[10 * c, 10 * s], [-10 * c, -10 * s]]
    case = plate(
        form,
        {"outline": {"vertices": vertices, "spacing": 16 / rows}},
        ratio,
        kind,
        supports=[{"at": {"x": 0, "y": 0}, "ux": 0, "uy": 0}, {"at": {"x": 12 * c, "y": 12 * s}, "uy": 0}],
        loads=[{"traction": {"edge": edge, "linear": profile}} for edge in ("edge_2", "edge_4")],
    )
    worst = 0.0
    for q in solve_with_fields(case)[1]:
        along = q["stress_xx"] * c**2 + q["stress_yy"] * s**2 + 2 * q["stress_xy"] * s * c
        across = q["stress_xx"] * s**2 + q["stress_yy"] * c**2 - 2 * q["stress_xy"] * s * c
        height = c * q["y"] - s * q["x"]
        worst = max(worst, abs(along + 10 / 8 * height) / 10, abs(across) / 10)
    return worst


def iterations(form, solver, size, kind="bond_plane", **more):
    """Conjugate gradients of a clamped square under shear."""
    case = plate(
        form,
        rectangle([size, size], **more),
        kind=kind,
        supports=[{"at": {"region": "left"}, "ux": 0, "uy": 0}],
        loads=[{"traction": {"edge": "right", "uniform": [0, -1]}}],
        solver=solver,
    )
    summary = solve(case)
    seconds = sum(summary["timing_s"][stage] for stage in ("assemble", "factor", "solve"))
    return summary["solver"]["iterations"][0], seconds / size**2


def row(name, found):
    print(f"| {name} | " + " | ".join(found) + " |", flush=True)


def head(forms):
    print("| | " + " | ".join(f"`{form}`" for form in forms) + " |\n|---|" + "---|" * len(forms))


def percent(found):
    return " / ".join(f"{100 * v:.2g} %" for v in found)


def others(kind, forms):
    """Rows of a model other than central bonds."""
    head(forms)
    row("strip between held edges, m = 3: force / corner stress / stress at the free edge", [percent(held(form, 3, kind=kind)) for form in forms])
    for count in (10, 20):
        row(f"ring under pressure, m = 3, {count} points per radius: {RING}", [percent(ring(form, 3, count, kind)) for form in forms])
    for rows in (16, 32):
        row(f"slanted strip in bending, m = 3, {rows} rows: stress", [percent([slanted(form, 3, rows, kind)]) for form in forms])
    row("multigrid iterations, 256 x 256", [str(iterations(form, "multigrid", 256, kind)[0]) for form in forms])
    row("multigrid iterations, 256 x 256 with a hole", [str(iterations(form, "multigrid", 256, kind, holes=HOLE)[0]) for form in forms])


def main():
    head(FORMS)
    for ratio in (2, 3, 4):
        row(f"strip between held edges, m = {ratio}: force / corner stress / stress at the free edge", [percent(held(form, ratio)) for form in FORMS])
    for ratio in (2, 3, 4):
        row(f"angle under one stress with shear, m = {ratio}: stress at the re-entrant corner", [f"{angle(form, ratio):.1e}" for form in FORMS])
    for ratio in (2, 3):
        for rows in (10, 20, 40, 80):
            row(f"clamped cantilever, m = {ratio}, {rows} rows", [f"{100 * cantilever(form, ratio, rows):.3f} %" for form in FORMS])
    for ratio in (2, 3):
        for rows in (7, 21, 35, 63):
            row(f"free plate under smooth tractions, m = {ratio}, {rows} rows", [f"{smooth(form, ratio, rows):.2e}" for form in FORMS])
    for ratio in (2, 3):
        for count in (5, 10, 20, 40):
            row(f"ring under pressure, m = {ratio}, {count} points per radius: {RING}", [percent(ring(form, ratio, count)) for form in FORMS])
    for ratio in (2, 3):
        for rows in (8, 16, 32):
            row(f"slanted strip in bending, m = {ratio}, {rows} rows: stress", [f"{100 * slanted(form, ratio, rows):.2g} %" for form in FORMS])
    row("first break over the nominal strain", [f"{first_break(form):.4f}" for form in FORMS])
    for size in (64, 256):
        row(f"multigrid iterations, {size} x {size}", [str(iterations(form, "multigrid", size)[0]) for form in FORMS])
    row("multigrid iterations, 256 x 256 with a hole", [str(iterations(form, "multigrid", 256, holes=HOLE)[0]) for form in FORMS])
    row("Jacobi iterations, 64 x 64", [str(iterations(form, "pcg", 64)[0]) for form in FORMS])
    cost = [min(iterations(form, "multigrid", 500)[1] for _ in range(3)) for form in FORMS]
    row("assembly and solution, 500 x 500, per point", [f"{1e6 * seconds:.1f} µs" for seconds in cost])
    print("\nBeam bonds, isotropic, Poisson's ratio 0.3:\n")
    others("beam_bond_orthotropic", FORMS)
    print("\nState-based families, Poisson's ratio 0.3:\n")
    others("state_plane", STATE_FORMS)


main()
