"""Which horizon ratio and influence a plate should have: error and CPU time of bodies with known answers. Prints the tables of
defaults.md.

Usage: defaults.py [PERISTAT], the command; target/release/peristat if not given.
"""

import json
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
COMMAND = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "target/release/peristat")
RATIOS = [2, 3, 4]
INFLUENCES = ["constant", "inverse", "linear"]
# Exact bonds whose higher moments have no direction, in the place of an influence.
ISOTROPIC = "isotropic"
RUNS = 3
# What the errors are those of, the case, its checks, and what is set beside the horizon ratio.
WHOLE = [
    ("clamped cantilever, 20 rows: deflection", "plate/cantilever", ["tip"], ["body.rectangle.spacing=2"]),
    ("clamped cantilever, 40 rows: deflection", "plate/cantilever", ["tip"], []),
    ("free strip in bending, 21 rows: deflection", "plate/bending_strip", ["end deflection"], []),
    ("strip under its weight: displacements", "plate/hanging_strip", ["uy formula"], []),
    ("ring under pressure, 20 points per radius: widening", "plate/ring", ["widening"], []),
    ("ring under pressure: hoop stress", "plate/ring", ["hoop stress"], []),
    ("plate with a hole, 10 points per radius: largest stress", "plate/plate_with_hole", ["stress at the hole"],
     ["body.rectangle.spacing=2"]),
    ("plate with a hole, 40 points per radius: largest stress", "plate/plate_with_hole", ["stress at the hole"], []),
]
CRACKED = [
    ("edge crack: K", "plate/edge_crack", ["K"], []),
    ("centre crack: K of the whole plate", "plate/centre_crack", ["K"], []),
]
# Of the ratio of the bonds, whose answers are known.
FAMILIES_OF_BONDS = ['model={"state_plane":{"youngs_modulus":70000,"poisson_ratio":0.3333333333333333,"state":"plane_stress"}}']
FAMILIES = [
    ("clamped cantilever, 20 rows: deflection", "plate/cantilever", ["tip"], [*FAMILIES_OF_BONDS, "body.rectangle.spacing=2"]),
    ("clamped cantilever, 40 rows: deflection", "plate/cantilever", ["tip"], FAMILIES_OF_BONDS),
    ("ring under pressure: widening", "plate/state_ring", ["widening inside"], []),
    ("ring under pressure: hoop stress", "plate/state_ring", ["hoop stress"], []),
    ("ring of rubber: widening", "plate/state_incompressible", ["widening inside"], []),
    ("strip in bending, ν = 0.45: deflection", "plate/state_bending", ["end deflection"], []),
    ("strip in bending, ν = 0.45: rise of the sides", "plate/state_bending", ["rise of the upper edge"], []),
    ("strip in bending, ν = 0: deflection", "plate/state_bending", ["end deflection"], ["model.state_plane.poisson_ratio=0"]),
    ("strip in bending, ν = −0.3: deflection", "plate/state_bending", ["end deflection"], ["model.state_plane.poisson_ratio=-0.3"]),
    ("disc of glass in a resin: stress along the pull", "plate/state_inclusion", ["stress of the fibre"], []),
]


# A crack that is inclined by 30 degrees grows across the tension: its direction is 0 degrees.
GROWING = {
    "title": "inclined crack",
    "units": "mm-N-MPa",
    "model": {"bond_plane": {"youngs_modulus": 70000, "state": "plane_stress"}},
    "body": {"rectangle": {"from": [-15, -20], "size": [30, 40], "spacing": 1}},
    "cracks": [{"path": [[-4.3, -2.5], [4.3, 2.5]]}],
    "supports": [
        {"at": {"region": "bottom"}, "ux": 0, "uy": -0.2},
        {"at": {"region": "top"}, "ux": 0, "uy": 0.2},
    ],
    "probes": [{"name": "pull", "at": {"region": "top"}, "field": "reaction_y"}],
    "fracture": {
        "critical": {"energy_release_rate": 10},
        "strategy": "worst",
        "load": "pull",
        "directions": [{"name": "right", "from": [3, -15], "to": [15, 15]}],
    },
    "checks": [{"value": {"probe": "right_direction", "expected": 0, "tolerance": 90, "source": "across the tension"}}],
}


def measured(name, checks, settings):
    """Largest relative error of some checks, and the CPU time of the run, s: the median of three; none of what is refused."""
    times = []
    for _ in range(RUNS):
        with tempfile.TemporaryDirectory() as folder:
            command = [COMMAND, "--threads", "1", "run", ROOT / f"cases/{name}.json", "-o", f"{folder}/out", "--json", "--no-estimate"]
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            done = subprocess.run([*command, *(part for s in settings for part in ("--set", s))], capture_output=True, text=True)
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
        times.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    summary = json.loads(done.stdout)
    if "checks" not in summary:
        return None
    found = {check["name"]: check for check in summary["checks"]}
    errors = [abs(found[check]["found"] / found[check]["expected"] - 1) for check in checks]
    return max(errors), sorted(times)[RUNS // 2]


def table(title, model, problems):
    has_weights = model == "bond_plane"
    columns = [(m, i) for m in RATIOS for i in (INFLUENCES + has_weights * [ISOTROPIC] if m < 4 else INFLUENCES[:1])]
    print(f"| {title} | " + " | ".join(f"m = {m}, `{i}`" for m, i in columns) + " |")
    print("|---|" + "---|" * len(columns))
    for words, case, checks, settings in problems:
        cells = []
        for m, influence in columns:
            key = "weights" if influence == ISOTROPIC else "influence"
            chosen = [f"horizon_ratio={m}", f'model.{model}.{key}="{influence}"']
            found = measured(case, checks, [*settings, *chosen])
            cells.append("refused" if found is None else f"{100 * found[0]:.2g} %, {found[1]:.2f} s")
        print(f"| {words} | " + " | ".join(cells) + " |", flush=True)
    print()


def directions():
    print("| a growing crack, inclined by 30°: direction | " + " | ".join(f"m = {m}" for m in RATIOS) + " |")
    print("|---|" + "---|" * len(RATIOS))
    for rows in [40, 80]:
        body = {"rectangle": GROWING["body"]["rectangle"] | {"spacing": 40 / rows}}
        cells = []
        for m in RATIOS:
            with tempfile.TemporaryDirectory() as folder:
                path = Path(folder) / "case.json"
                path.write_text(json.dumps(GROWING | {"horizon_ratio": m, "body": body}))
                done = subprocess.run([COMMAND, "run", path, "-o", f"{folder}/out", "--json"], capture_output=True, text=True)
            cells.append(f"{json.loads(done.stdout)['checks'][0]['found']:.0f}°")
        print(f"| {rows} rows, 0° is expected | " + " | ".join(cells) + " |", flush=True)
    print()


def main():
    table("`bond_plane`, whole", "bond_plane", WHOLE)
    table("`bond_plane`, cracked", "bond_plane", CRACKED)
    directions()
    table("`state_plane`, whole", "state_plane", FAMILIES)


if __name__ == "__main__":
    main()
