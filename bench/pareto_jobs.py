"""Which programs solve which problem in which sizes: a list of runs, each a process that can be timed."""

import json
import os
import subprocess
import sys
from dataclasses import dataclass, field
from typing import Callable

import pareto_ccx as ccx
from measure import PERISTAT, ROOT, WORK, run
from pareto_peristat import beam_case, hole_case, plate_case
from pareto_problems import Hole

BEAM = {  # bond law, horizon ratio, solver, most cells
    "`exact`, m = 1, strain": ("exact", 1, "strain", 10**6),
    "`exact`, m = 3, strain": ("exact", 3, "strain", 10**6),
    "`exact`, m = 3, band": ("exact", 3, "band", 10**5),
    "`corrected`, m = 1, strain": ("corrected", 1, "strain", 10**5),
    "`corrected`, m = 3, strain": ("corrected", 3, "strain", 10**5),
    "`published`, m = 1, strain": ("published", 1, "strain", 10**5),
    "`published`, m = 3, strain": ("published", 3, "strain", 10**5),
}
BEAM_SCRIPTS = {  # program, packages, largest number of elements
    "banded_exact": ("SciPy `solveh_banded`", "exact elements", ["scipy"], 10**5),
    "banded_linear": ("SciPy `solveh_banded`", "linear elements", ["scipy"], 10**5),
    "sparse_exact": ("SciPy `spsolve`", "exact elements", ["scipy"], 10**5),
    "scikit_fem_2": ("scikit-fem", "orders 2 and 1", ["skfem"], 10**5),
    "scikit_fem_3": ("scikit-fem", "orders 3 and 2", ["skfem"], 10**4),
    "opensees": ("OpenSeesPy", "`ElasticTimoshenkoBeam`", ["openseespy.opensees"], 10**4),
    "pynite": ("PyNite", "members", ["Pynite"], 10**3),
}
SIZES = 10, 100, 1000, 10_000, 100_000, 1_000_000
LOCAL = {"limit": "local"}
NU = {"poisson_ratio": 1 / 3}
PLATE = {  # model, its options, horizon ratio, solver, further keys of the case, most points over the height
    "`bond_plane`, default": ("bond_plane", {}, None, "auto", {}, 189),
    "`bond_plane`, default, `local`": ("bond_plane", {}, None, "auto", LOCAL, 189),
    "`bond_plane`, default, `local`, 4 corrections": ("bond_plane", {}, None, "auto", {**LOCAL, "corrections": 4}, 189),
    "`bond_plane`, m = 3": ("bond_plane", {}, 3, "auto", {}, 189),
    "`bond_plane`, default, sparse": ("bond_plane", {}, None, "sparse", {}, 105),
    "`published`, m = 3": ("bond_plane", {"calibration": "published"}, 3, "auto", {}, 105),
    "`state_plane`, default": ("state_plane", NU, None, "auto", {}, 105),
}
ROWS = 7, 21, 35, 63, 105, 189
PLATE_SCRIPTS = {  # program, method, packages, sizes
    "scikit_fem_1": ("scikit-fem", "Q1", ["skfem"], (2, 4, 8, 16, 32, 64)),
    "scikit_fem_2": ("scikit-fem", "Q2", ["skfem"], (1, 2, 4, 8, 16)),
    "peridynamics": ("NumPy peridynamics", "m = 3", ["scipy"], (7, 21, 35, 63)),
    "peridynamics_volume": ("NumPy peridynamics", "m = 3, volume method", ["scipy"], (7, 21, 35, 63)),
}
PLATE_DECKS = {1: (2, 4, 8, 16, 32), 2: (1, 2, 4, 8)}
HOLE = {"default": {}, "`local`": LOCAL, "`local`, 1 correction": {**LOCAL, "corrections": 1}}
HOLE_ROWS = 20, 40, 80, 160
HOLE_SIZES = 4, 8, 16, 32, 64
HOLE_DECKS = 4, 8, 16, 32


@dataclass
class Job:
    """One run; `error` and `inside` read what it printed. `points` is what it gives the deflection at."""

    program: str
    method: str
    size: str
    points: int
    command: list
    error: Callable
    inside: Callable
    times: list = field(default_factory=list)
    found: float = None
    stress: float = None

    def run(self):
        output, (cpu, _), peak = run(*self.command, errors=subprocess.DEVNULL)
        if self.found is None:
            # A pair where stresses are known, too.
            found = self.error(output)
            self.found, self.stress = found if isinstance(found, tuple) else (found, None)
        self.times.append((cpu, self.inside(output), peak))


def missing(report):
    """A function that says whether packages are there, and notes once for each that is not."""
    known = {}

    def lacks(packages):
        for package in packages:
            if package not in known:
                tried = subprocess.run([sys.executable, "-c", f"import {package}"], capture_output=True)
                known[package] = tried.returncode == 0
                if not known[package]:
                    report(f"notice: {package} cannot be imported: what needs it is left out")
        return not all(known[package] for package in packages)

    return lacks


def last(output):
    return json.loads(output.strip().splitlines()[-1])


def script(file, name, size, *rest):
    return [sys.executable, "-B", ROOT / "bench" / file, name, str(size), *map(str, rest)]


def verify(path):
    return [PERISTAT, "verify", path, "--json", "--threads", "1"]


def deck(name, text, error):
    """CalculiX on a deck; it says how long it took in its last lines."""
    path = WORK / f"pareto_{name}"
    path.with_suffix(".inp").write_text(text)
    command = ["ccx", "-i", os.path.relpath(path)]
    inside = lambda output: float(output.split("Total CalculiX Time:")[1].split()[0])
    return command, lambda _: error(path.with_suffix(".dat")), inside


def beams(slenderness, most, lacks, has_ccx):
    sizes = [n for n in SIZES if n <= most]
    seconds = lambda output: json.loads(output)[0]["time_s"]
    worst = lambda output: json.loads(output)[0]["checks"][0]["error"]
    for method, (law, ratio, solver, limit) in BEAM.items():
        for n in (n for n in sizes if n <= limit):
            path = beam_case(law, ratio, solver, n, slenderness)
            yield Job("peristat", method, f"{n}", n, verify(path), worst, seconds)
    value = lambda key: lambda output: last(output)[key]
    for name, (program, method, packages, limit) in BEAM_SCRIPTS.items():
        if lacks(packages):
            continue
        for n in (n for n in sizes if n <= limit):
            command = script("pareto_beam.py", name, n, slenderness)
            yield Job(program, method, f"{n}", n, command, value("error"), value("inside_s"))
    for kind in ("U1", "B31") if has_ccx else ():
        for n in (n for n in sizes if n <= (10**4 if kind == "U1" else 10**3)):
            text = ccx.beam_deck(kind, n, slenderness)
            found = deck(f"{kind}_{n}_{slenderness:g}", text, lambda path, n=n: ccx.beam_error(path, n, slenderness))
            yield Job("CalculiX", kind, f"{n}", n, *found)


def plate_error(path, largest):
    """Errors of displacements and of stresses over the largest of each, of a run that compares every point."""
    checks = json.loads(run(*verify(path))[0])[0]["checks"]
    errors = [check["error"] * size for check, size in zip(checks, largest)]
    return max(errors[:2]) / max(largest[:2]), max(errors[2:]) / max(largest[2:])


def plates(quick, lacks, has_ccx):
    few = lambda sizes: sizes[:3] if quick else sizes
    seconds = lambda output: json.loads(output)[0]["time_s"]
    for method, (model, options, ratio, solver, rest, most) in PLATE.items():
        for rows in few([rows for rows in ROWS if rows <= most]):
            asked, every, largest = plate_case(model, options, ratio, solver, rest, rows)
            error = lambda _, every=every, largest=largest: plate_error(every, largest)
            yield Job("peristat", method, f"{rows * 27 // 7} x {rows}", 0, verify(asked), error, seconds)
    value = lambda key: lambda output: last(output)[key]
    for name, (program, method, packages, sizes) in PLATE_SCRIPTS.items():
        for size in () if lacks(packages) else few(sizes):
            grid = f"{6 * size} x {2 * size}" if program == "scikit-fem" else f"{size * 27 // 7} x {size}"
            command = script("pareto_plate.py", name, size)
            both = lambda output: (last(output)["error"], last(output).get("stress_error"))
            yield Job(program, method, grid, 0, command, both, value("inside_s"))
    for order, sizes in PLATE_DECKS.items() if has_ccx else ():
        for size in few(sizes):
            error = lambda path, order=order, size=size: ccx.plate_error(path, order, size)
            found = deck(f"cps{order}_{size}", ccx.plate_deck(order, size), error)
            yield Job("CalculiX", f"CPS{4 * order}", f"{6 * size} x {2 * size}", 0, *found)


def holes(name, quick, lacks, has_ccx):
    few = lambda sizes: sizes[:3] if quick else sizes
    value = lambda key: lambda output: last(output)[key]
    seconds = lambda output: json.loads(output)[0]["time_s"]
    errors = lambda output: tuple(check["error"] for check in json.loads(output)[0]["checks"])
    model = "`bond_plane`" if name == "isotropic" else "`beam_bond_orthotropic`"
    for method, rest in HOLE.items():
        for rows in few(HOLE_ROWS):
            path = hole_case(name, rest, rows)
            yield Job("peristat", f"{model}, {method}", f"{rows * 5 // 2} x {rows}", 0, verify(path), errors, seconds)
    for size in () if lacks(["skfem"]) else few(HOLE_SIZES):
        command = script("pareto_hole.py", name, size)
        both = lambda output: (last(output)["error"], last(output)["stress_error"])
        yield Job("scikit-fem", "Q2", f"{size} x {size}", 0, command, both, value("inside_s"))
    for size in few(HOLE_DECKS) if has_ccx and not lacks(["numpy"]) else ():
        plate = Hole(name)
        error = lambda path, plate=plate: ccx.hole_error(path, plate)
        found = deck(f"hole_{name}_{size}", ccx.hole_deck(plate, size), error)
        yield Job("CalculiX", "CPS8", f"{size} x {size}", 0, *found)
