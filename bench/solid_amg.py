"""The sheared cube by pyamg's smoothed aggregation, on the matrix that peristat assembles.

`--prepare MATRIX FIELDS CELLS FILE` reads the stiffness that `peristat run --write-matrix` writes and the displacements of
that run, holds the clamp and writes blocks of a point, load, places and displacements for this script and for
`solid_gamg.py`. `FILE` alone solves: the rigid motions as candidates, conjugate gradients to a residual of 1e-10 of the load.
One line of JSON: seconds of set-up and solution, iterations, residual, difference from peristat's displacements.
"""

import argparse
import csv
import json
import sys
import time
import warnings

import numpy as np

SMOOTHERS = {
    "Chebyshev 2": ("chebyshev", {"degree": 2}),
    "Chebyshev 3": ("chebyshev", {"degree": 3}),
    "block Gauss-Seidel": ("block_gauss_seidel", {"sweep": "symmetric"}),
}
SETTINGS = {f"strength {theta}, {name}": (theta, name) for theta in (0.0, 0.02, 0.05) for name in SMOOTHERS}


def rigid_motions(places):
    """Three translations and three rotations, two numbers past the points: component and motion."""
    x, y, z = (places - places.mean(axis=0)).T
    motions = np.zeros((len(places), 3, 6))
    motions[:, [0, 1, 2], [0, 1, 2]] = 1
    motions[:, 0, 3], motions[:, 1, 3] = -y, x
    motions[:, 1, 4], motions[:, 2, 4] = -z, y
    motions[:, 2, 5], motions[:, 0, 5] = -x, z
    return motions.reshape(-1, 6)


def displacements(path):
    with open(path) as file:
        rows = csv.reader(file)
        # Heads have their unit behind the name.
        heads = [head.split(" [")[0] for head in next(rows)]
        wanted = [heads.index(key) for key in ("ux", "uy", "uz")]
        return np.array([[float(row[k]) for k in wanted] for row in rows])


def prepare(matrix, fields, cells, file):
    """The face lies half a spacing before the first layer and is at rest, in a straight line: `u_0 = u_1/3`.

    The load is what peristat's displacements need, so that the solution is known: zero but in the last two layers.
    """
    from scipy import sparse
    from scipy.io import mmread

    z, y, x = (k.ravel() for k in np.indices((cells,) * 3))
    free, held = np.flatnonzero(x > 0), np.flatnonzero(x == 0)
    number = np.cumsum(x > 0) - 1
    entries = np.r_[np.ones(len(free)), np.full(len(held), 1 / 3)]
    extension = sparse.csr_matrix((entries, (np.r_[free, held], np.r_[number[free], number[held + 1]])))
    extension = sparse.kron(extension, np.eye(3), format="csr")
    reduced = (extension.T @ mmread(matrix).tocsr() @ extension).tobsr((3, 3))
    u = displacements(fields)[free].ravel()
    load = reduced @ u
    layer = np.abs(load.reshape(-1, 3)).max(axis=1)
    inside = layer[x[free] < cells - 2].max() / layer.max()
    load.reshape(-1, 3)[x[free] < cells - 2] = 0
    places = np.stack([x, y, z], axis=1)[free].astype(float)
    reduced.sort_indices()
    parts = {"starts": reduced.indptr, "columns": reduced.indices, "blocks": reduced.data}
    np.savez(file, **parts, load=load, places=places, displacements=u)
    return {"inside": float(inside), "unknowns": len(load), "entries": reduced.nnz}


def solve(problem, setting):
    from pyamg import smoothed_aggregation_solver
    from scipy import sparse

    theta, smoother = SETTINGS[setting]
    size = (len(problem["load"]),) * 2
    matrix = sparse.bsr_matrix((problem["blocks"], problem["columns"], problem["starts"]), shape=size)
    motions, load = rigid_motions(problem["places"]), problem["load"]
    begin = time.process_time()
    levels = smoothed_aggregation_solver(
        matrix, B=motions, symmetry="symmetric", strength=("symmetric", {"theta": theta}),
        presmoother=SMOOTHERS[smoother], postsmoother=SMOOTHERS[smoother], improve_candidates=None, max_coarse=500,
    )  # fmt: skip
    ready = time.process_time()
    residuals = []
    u = levels.solve(load, tol=1e-10, accel="cg", maxiter=100, residuals=residuals)
    end = time.process_time()
    exact = problem["displacements"]
    return {
        "setting": setting,
        "setup": ready - begin,
        "solve": end - ready,
        "total": end - begin,
        "iterations": len(residuals) - 1,
        "residual": float(np.linalg.norm(load - matrix @ u) / np.linalg.norm(load)),
        "difference": float(np.abs(u - exact).max() / np.abs(exact).max()),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--prepare", nargs=3, metavar=("MATRIX", "FIELDS", "CELLS"))
    parser.add_argument("--setting", choices=SETTINGS, help="all of them one after the other if it is not given")
    parser.add_argument("file", metavar="FILE")
    options = parser.parse_args()
    warnings.simplefilter("ignore")  # pyamg's, on matrix formats
    if options.prepare:
        matrix, fields, cells = options.prepare
        print(json.dumps(prepare(matrix, fields, int(cells), options.file)))
        return
    problem = np.load(options.file)
    problem = {name: problem[name] for name in problem.files}
    for setting in [options.setting] if options.setting else SETTINGS:
        print(json.dumps(solve(problem, setting)), flush=True)


if __name__ == "__main__":
    sys.exit(main())
