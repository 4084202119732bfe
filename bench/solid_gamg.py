"""The sheared cube by PETSc's GAMG, on the matrix that `solid_amg.py --prepare` wrote: `solid_gamg.py FILE [SETTING]`.

The rigid motions as near null space, conjugate gradients to a residual of 1e-10 of the load. Runs under the Python that has
petsc4py, Debian's among them, with nothing but NumPy beside it. Without FILE it tells whether there is PETSc.
"""

import glob
import json
import sys
import time

import numpy as np

sys.path += glob.glob("/usr/lib/petscdir/petsc3*/*-real/lib/python3/dist-packages")
from petsc4py import PETSc  # noqa: E402

SETTINGS = {
    "default": {},
    "threshold 0.02": {"pc_gamg_threshold": "0.02"},
    "threshold 0.05, Chebyshev 3": {"pc_gamg_threshold": "0.05", "mg_levels_ksp_max_it": "3"},
}


def matrix_of(problem):
    size = len(problem["load"])
    rows = problem["starts"], problem["columns"], np.ascontiguousarray(problem["blocks"].transpose(0, 2, 1))
    matrix = PETSc.Mat().createBAIJ(size, 3, csr=rows, comm=PETSc.COMM_SELF)  # blocks go by columns
    matrix.assemble()
    matrix = matrix.convert("aij")
    matrix.setBlockSize(3)
    places = PETSc.Vec().createWithArray(problem["places"].ravel().copy(), bsize=3, comm=PETSc.COMM_SELF)
    matrix.setNearNullSpace(PETSc.NullSpace().createRigidBody(places))
    matrix.setOption(PETSc.Mat.Option.SPD, True)
    return matrix


def solve(matrix, problem, setting):
    options = PETSc.Options()
    for name, value in SETTINGS[setting].items():
        options[name] = value
    load = PETSc.Vec().createWithArray(problem["load"].copy(), comm=PETSc.COMM_SELF)
    u = load.duplicate()
    solver = PETSc.KSP().create(PETSc.COMM_SELF)
    solver.setOperators(matrix)
    solver.setType("cg")
    solver.setNormType(PETSc.KSP.NormType.UNPRECONDITIONED)
    solver.getPC().setType("gamg")
    solver.setTolerances(rtol=1e-10, max_it=200)
    solver.setFromOptions()
    begin = time.process_time()
    solver.setUp()
    ready = time.process_time()
    solver.solve(load, u)
    end = time.process_time()
    for name in SETTINGS[setting]:
        options.delValue(name)
    exact, rest = problem["displacements"], load - matrix * u
    return {
        "setting": setting,
        "setup": ready - begin,
        "solve": end - ready,
        "total": end - begin,
        "iterations": solver.getIterationNumber(),
        "residual": rest.norm() / load.norm(),
        "difference": float(np.abs(u.getArray() - exact).max() / np.abs(exact).max()),
    }


def main():
    if len(sys.argv) < 2:
        print(json.dumps({"version": ".".join(map(str, PETSc.Sys.getVersion()))}))
        return
    problem = np.load(sys.argv[1])
    problem = {name: problem[name] for name in problem.files}
    matrix = matrix_of(problem)
    for setting in sys.argv[2:] or SETTINGS:
        print(json.dumps(solve(matrix, problem, setting)), flush=True)


if __name__ == "__main__":
    main()
