"""Cases of the problems for peristat, as a user would write them."""

import json

from measure import WORK
from pareto_problems import LOAD, POISSON_RATIO, WIDTH, YOUNGS_MODULUS, Beam, Hole, Plate


# Displacements, and the stresses that are not zero.
FIELDS = "ux", "uy", "stress_xx", "stress_xy"


def written(name, case):
    path = WORK / f"pareto_{name}.json"
    path.write_text(json.dumps(case))
    return path


def beam_case(law, ratio, solver, cells, slenderness):
    """Its check compares every point with the closed form; no tolerance, the error is what is asked."""
    section = {"rectangle": {"width": WIDTH, "height": Beam(slenderness).height}}
    model = {"youngs_modulus": YOUNGS_MODULUS, "poisson_ratio": POISSON_RATIO, "section": section, "bond_law": law}
    case = {
        "title": "Cantilever under a uniform load",
        "model": {"timoshenko_beam": model},
        "body": {"line": {"length": 1.0, "cells": cells}},
        "horizon_ratio": ratio,
        "supports": [{"at": {"x": 0.0}, "w": 0.0, "phi": 0.0}],
        "loads": [{"distributed": {"force": {"uniform": LOAD}}}],
        "checks": [{"closed_form": {"name": "cantilever_uniform", "field": "w", "tolerance": 1e9}}],
        "solver": solver,
    }
    return written(f"beam_{law}_{ratio}_{solver}_{cells}_{slenderness:g}", case)


def plate_case(name, options, ratio, solver, rest, rows):
    """Two cases: one asks for the deflection at the end, the other compares every point with the closed form.

    `rest`: further keys of the case, such as its limit.
    """
    plate = Plate()
    h, columns = plate.height / rows, round(rows * plate.length / plate.height)
    axis, moment = plate.height / 2, plate.traction(False, plate.height)[0]
    model = {"youngs_modulus": plate.youngs_modulus, "state": "plane_stress", **options}
    shear = plate.traction(True, axis)[1]
    tip = {"x": (columns - 0.5) * h, "y": axis}
    case = {
        "title": "Cantilever of plane stress",
        "model": {name: model},
        "body": {"rectangle": {"size": [plate.length, plate.height], "spacing": h}},
        **({"horizon_ratio": ratio} if ratio else {}),
        "supports": [
            {"at": {"x": plate.middle, "y": axis}, "ux": 0, "uy": 0},
            {"at": {"x": plate.second, "y": axis}, "uy": 0},
        ],
        "loads": [
            {"traction": {"edge": "right", "parabolic": [0, shear]}},
            {"traction": {"edge": "left", "parabolic": [0, -shear]}},
            {"traction": {"edge": "left", "linear": [[-moment, 0], [moment, 0]]}},
        ],
        "probes": [{"name": "end", "at": tip, "field": "uy"}],
        "solver": solver,
        **rest,
    }
    exact = WORK / f"pareto_plate_{rows}.csv"
    largest = [0.0] * len(FIELDS)
    with exact.open("w") as file:  # row by row: what this process holds counts in the peaks of its children
        file.write("x,y,ux,uy,stress_xx,stress_xy\n")
        for x, y in (((i + 0.5) * h, (j + 0.5) * h) for j in range(rows) for i in range(columns)):
            values = *plate.displacement(x, y), *plate.stress(x, y)
            largest = [max(a, abs(b)) for a, b in zip(largest, values)]
            file.write(",".join(map(repr, (x, y, *values))) + "\n")
    words = [name, *(value for value in options.values() if isinstance(value, str))]
    label = "_".join(map(str, (*words, ratio, solver, *rest.values(), rows)))
    expected = plate.displacement(*tip.values())[1]
    value = {"probe": "end", "expected": expected, "tolerance": 1e9, "source": "closed form"}
    asked = written(f"plate_{label}", case | {"checks": [{"value": value}]})
    fields = [{"baseline": {"file": exact.name, "field": field, "tolerance": 1e9}} for field in FIELDS]
    return asked, written(f"plate_{label}_all", case | {"checks": fields}), largest


def hole_case(name, rest, rows):
    """Its checks compare both answers with what is known. `rest`: further keys of the case, such as its limit."""
    plate = Hole(name)
    (length, height), radius = plate.size, plate.radius
    along, across, poisson, shear = plate.material
    isotropic = {"bond_plane": {"youngs_modulus": along, "state": "plane_stress"}}
    moduli = {"youngs_modulus_1": along, "youngs_modulus_2": across, "poisson_ratio_12": poisson, "shear_modulus_12": shear}
    hole = {"circle": {"name": "hole", "centre": [0, 0], "radius": radius}}
    value = lambda probe, expected: {"value": {"probe": probe, "expected": expected, "tolerance": 1e9, "source": "elements"}}
    case = {
        "title": "Quarter of a strip with a hole",
        "model": isotropic if name == "isotropic" else {"beam_bond_orthotropic": {**moduli, "fibre_angle": 0}},
        "body": {"rectangle": {"size": [length, height], "spacing": height / rows, "holes": [hole]}},
        "symmetry": ["left", "bottom"],
        "loads": [{"traction": {"edge": "right", "uniform": [plate.traction, 0]}}],
        "probes": [
            {"name": "end", "at": {"x": length, "y": 0}, "field": "ux"},
            {"name": "top", "at": {"x": 0, "y": radius, "inward": [0, 1]}, "field": "stress_xx"},
        ],
        "checks": [value("end", plate.moved), value("top", plate.stress)],
        **rest,
    }
    return written("_".join(map(str, ("hole", name, *rest.values(), rows))), case)
