"""Solids for peristat as a user would write them, and what their runs take on one thread."""

import json
from dataclasses import dataclass
from statistics import median

from measure import PERISTAT, WORK, run

YOUNGS_MODULUS, POISSON_RATIO = 1000.0, 0.25  # central bonds have this ratio
# Force times displacement of the sheared cube in units of side, load and modulus. C3D20 with 6, 12, 24 and with 4, 8, 16
# elements a side, extrapolated by the order that each three show (1.5), give 6.8247 and 6.8242, C3D8 with 8, 16, 32 6.8241.
COMPLIANCE = 6.825
MODELS = {
    "bonds": {"bond_solid": {"youngs_modulus": YOUNGS_MODULUS}},
    "families": {"state_solid": {"youngs_modulus": YOUNGS_MODULUS, "poisson_ratio": 0.3}},
}
HELD = {"ux": 0.0, "uy": 0.0, "uz": 0.0}


@dataclass
class Spent:
    """One run: CPU and wall seconds of the process, wall seconds in it, peak memory in bytes."""

    cpu: float
    wall: float
    inside: float
    peak: int


class Solid:
    """A case on disk."""

    def __init__(self, name, **parts):
        probe = {"name": "end", "at": {"region": "right"}, "field": "uz"}
        check = {"limit": {"probe": "end", "at_most": 1e9, "why": "every run has a check"}}
        self.path = WORK / f"solid_{name}.json"
        self.path.write_text(json.dumps({"title": name, "units": "none", **parts, "probes": [probe], "checks": [check]}))

    def verify(self):
        """Reads, solves, certifies and checks, writes nothing."""
        output, (cpu, wall), peak = run(PERISTAT, "verify", self.path, "--json", "--threads", "1")
        return Spent(cpu, wall, json.loads(output)[0]["time_s"], peak)

    def summary(self, *options):
        command = PERISTAT, "run", self.path, "--json", "--force", "--no-estimate", "-o", WORK / "solid", *options
        return json.loads(run(*command)[0])


def cube(cells, ratio, model="bonds", **options):
    """The cube of side 1, clamped on the left, a shear of 1 on the right; `options` of the model."""
    [(kind, values)] = MODELS[model].items()
    return Solid(
        "_".join(map(str, ("cube", model, ratio, cells, *options.values()))),
        model={kind: values | options},
        body={"block": {"size": [1.0, 1.0, 1.0], "spacing": 1 / cells}},
        horizon_ratio=ratio,
        supports=[{"at": {"region": "left"}, **HELD}],
        loads=[{"traction": {"face": "right", "uniform": [0.0, 0.0, 1.0]}}],
    )


def bar(length, height, force, calibration="matched"):
    """A bar with a spacing of 1 whose first four layers are held, under a total force on its end."""
    return Solid(
        f"bar_{calibration}",
        model={"bond_solid": {**MODELS["bonds"]["bond_solid"], "calibration": calibration}},
        body={"block": {"size": [length, height, height], "spacing": 1.0}},
        horizon_ratio=3,
        regions={"clamp": {"box": {"from": [0.0, 0.0, 0.0], "to": [4.0, height, height]}}},
        supports=[{"at": {"region": "clamp"}, **HELD}],
        loads=[{"traction": {"face": "right", "total": [0.0, force, 0.0]}}],
    )


def energy(summary):
    return summary["states"][0]["certificate"]["energy"]


def compliance(summary):
    """Twice the strain energy in units of side, load and modulus."""
    return 2 * YOUNGS_MODULUS * energy(summary)


def middle(runs, key):
    return median(getattr(one, key) for one in runs)
