"""Algebraic multigrid on peristat's own matrix of a cube, and LAMMPS on a bar, against whole runs of peristat."""

import json
import os
import shutil
import subprocess
import sys
from statistics import median

from measure import ROOT, WORK, run
from solid_cases import YOUNGS_MODULUS, bar, cube, energy, middle

AMG, GAMG = (ROOT / "bench" / f"solid_{name}.py" for name in ("amg", "gamg"))
SMALL = 16  # cells of a side of the cube that settings are tried on
LENGTH, HEIGHT, FORCE = 80, 16, 256e-6
LAMMPS_MODULUS = 1.5  # Young's, of the bulk modulus 1
PYTHONS = sys.executable, "/usr/bin/python3"  # petsc4py of Debian belongs to its own
BAR = """units lj
boundary s s s
atom_style peri
atom_modify map array
lattice sc 1.0
region box block 0 {x} 0 {y} 0 {y} units lattice
create_box 1 box
create_atoms 1 box
pair_style peri/pmb
pair_coeff * * {bond} 3.0001 10.0 0.0
set group all density 1.0
set group all volume 1.0
velocity all set 0 0 0
neighbor 1.0 bin
neigh_modify every 100000 delay 100000 check no
region lo block INF 3.5 INF INF INF INF units lattice
region hi block {last} INF INF INF INF INF units lattice
group lo region lo
group hi region hi
fix clamp lo setforce 0 0 0
fix pull hi addforce 0 {each} 0
fix_modify pull energy yes
timestep 0.05
min_style fire
min_modify norm two
thermo 500
thermo_style custom step pe fnorm
thermo_modify norm no
minimize 0 {tolerance} 20000 1000000
"""


def lines(*command):
    return [json.loads(line) for line in run(*command)[0].splitlines()]


def amg(python, script, small, large):
    """A function that solves once, by the setting that is the fastest of all on a small cube."""
    good = [line for line in lines(python, "-B", script, small) if line["residual"] < 1e-9]
    setting = min(good, key=lambda line: line["total"])["setting"]
    option = ["--setting", setting] if script == AMG else [setting]
    return lambda: lines(python, "-B", script, large, *option)[0]


def with_petsc():
    """The Python that has petsc4py; `None` if none has."""
    for python in filter(os.path.exists, PYTHONS):
        if subprocess.run([python, "-B", GAMG], capture_output=True).returncode == 0:
            return python
    return None


def matrix(cells):
    """The assembled matrix of a cube, held and with its load, on disk; what was found on the way."""
    text, file = WORK / "solid.mtx", WORK / f"solid_matrix_{cells}.npz"
    cube(cells, 3).summary("--write-matrix", text)
    fields = WORK / "solid" / "fields" / "step_000.csv"
    [found] = lines(sys.executable, "-B", AMG, "--prepare", text, fields, str(cells), file)
    text.unlink()
    return file, found


def peers(report, lacks, notices, cells):
    """Functions that solve once, by the name of the program."""
    if lacks(["scipy", "pyamg"]):
        return {}
    (small, _), (large, found) = matrix(SMALL), matrix(cells)
    report.row(f"same matrix, {found['unknowns']} unknowns, {found['entries'] / 1e6:.1f} million entries: largest force "
               "that peristat's displacements leave at points without a load, over the largest load",
               value=f"{found['inside']:.0e}", measured=found["inside"], target=1e-8)  # fmt: skip
    solvers = {"pyamg": amg(sys.executable, AMG, small, large)}
    if python := with_petsc():
        solvers["PETSc GAMG"] = amg(python, GAMG, small, large)
    else:
        notices.append("notice: petsc4py cannot be imported: PETSc is left out")
    return solvers


def against_amg(report, rounds, lacks, notices, cells=32):
    solid, solvers = cube(cells, 3), peers(report, lacks, notices, cells)
    bare = cube(cells, 3, edges="none")
    runs, bares, theirs = [], [], {name: [] for name in solvers}
    for _ in range(rounds):
        runs.append(solid.verify())
        bares.append(bare.verify())
        for name, once in solvers.items():
            theirs[name].append(once())
    mine = middle(runs, "cpu")
    report.row(f"whole run, {cells} x {cells} x {cells} points, m = 3: CPU", f"{mine:.3f} s")
    report.row("the same with `edges` `none`, another matrix", f"{middle(bares, 'cpu'):.3f} s")
    for name, times in theirs.items():
        setup, total = (median(t[k] for t in times) for k in ("setup", "total"))
        last = times[-1]
        report.row(f"the same, and set-up and solution of {name}: ratio", f"{mine:.3f} s",
                   f"{total:.2f} s (set-up {setup:.2f} s)", f"{total / mine:.1f}", measured=total / mine, least=30)  # fmt: skip
        report.notes.append(
            f"{name}: {last['setting']}; {last['iterations']} iterations to a residual of {last['residual']:.0e}; its "
            f"displacements differ by {last['difference']:.0e} of the largest from peristat's."
        )
    for file in WORK.glob("solid_matrix_*.npz"):
        file.unlink()


def lammps_input():
    """Bonds of the bulk modulus 1, the load of a bar in equal parts on its last layer, forces to 1e-6 of it."""
    each = FORCE / HEIGHT**2
    text = BAR.format(x=LENGTH - 0.5, y=HEIGHT - 0.5, last=LENGTH - 1.5, bond=18 / (3.141592653589793 * 3.0001**4),
                      each=each, tolerance=1e-6 * each * HEIGHT)  # fmt: skip
    path = WORK / "solid_bar.in"
    path.write_text(text)
    return path


def against_lammps(report, rounds, notices):
    """One run of LAMMPS, as it takes minutes."""
    command = shutil.which("lmp")
    known = command and "peri/pmb" in subprocess.run([command, "-h"], capture_output=True, text=True).stdout
    if not known:
        notices.append("notice: there is no lmp with peri/pmb: LAMMPS is left out")
        return
    solids = {name: bar(LENGTH, HEIGHT, FORCE, name) for name in ("matched", "published")}
    runs = {name: [solid.verify() for _ in range(2 * rounds)] for name, solid in solids.items()}
    output, (cpu, _), _ = run(command, "-in", lammps_input(), "-log", "none")
    for name, solid in solids.items():
        mine = middle(runs[name] + [solid.verify() for _ in range(2 * rounds)], "cpu")
        report.row(f"bar of {LENGTH} x {HEIGHT} x {HEIGHT} points, m = 3, calibration `{name}`, against LAMMPS: CPU",
                   f"{mine:.3f} s", f"{cpu:.0f} s", f"{cpu / mine:.0f}", measured=cpu / mine, least=500)  # fmt: skip
    steps = output.split("Iterations, force evaluations =")[1].split()[0]
    reason = output.split("Stopping criterion =")[1].splitlines()[0].strip()
    first, *_, last = map(float, output.split("Energy initial, next-to-last, final =")[1].split()[:3])
    exact = {name: energy(solid.summary()) * YOUNGS_MODULUS / LAMMPS_MODULUS for name, solid in solids.items()}
    softer = ", ".join(f"{(first - last) / value:.2f} times that of `{name}`" for name, value in exact.items())
    report.notes.append(
        f"LAMMPS `peri/pmb`, `fire`: {steps} steps, ended by its {reason} (1e-6 of the load); its energy is {softer}."
    )
