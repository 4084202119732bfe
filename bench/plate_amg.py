"""A clamped square plate in NumPy and SciPy, solved by pyamg's smoothed aggregation.

The matrix is the one that peristat assembles: bonds of a square lattice, horizon ratio 3, calibration `matched`, edges
`overlay`; `--check` compares it with a file of `peristat run --write-matrix`, entry by entry. The hierarchy gets the three
rigid motions as candidates and preconditions conjugate gradients to a residual of 1e-10 of the load. One line of JSON per
solve: seconds of assembly, set-up and solution, iterations, operator complexity. `bench/plate.sh` runs this.
"""

import argparse
import json
import sys
import time
import warnings
from itertools import product

import numpy as np
from scipy import sparse

RATIO = 3
E, THICKNESS = 70000.0, 1.0
C11 = 9 / 8 * E  # plane stress, Poisson's ratio 1/3
C = C11 * np.array([[1, 1 / 3, 0], [1 / 3, 1, 0], [0, 0, 1 / 3]])

# Strength of connections, smoothing of the tentative prolongation, smoother of the levels. Block Gauss-Seidel takes the two
# unknowns of a point together.
STRENGTHS = {f"symmetric strength {theta}": ("symmetric", {"theta": theta}) for theta in (0.0, 0.02, 0.05, 0.08)} | {
    "evolution strength": ("evolution", {"k": 2, "epsilon": 4.0})
}
PROLONGATIONS = {
    "Jacobi": ("jacobi", {"omega": 4 / 3, "degree": 1}),
    "energy": ("energy", {"krylov": "cg", "degree": 1, "maxiter": 2}),
}
SMOOTHERS = {
    "block Gauss-Seidel": ("block_gauss_seidel", {"sweep": "symmetric"}),
    "Chebyshev 2": ("chebyshev", {"degree": 2}),
    "Chebyshev 3": ("chebyshev", {"degree": 3}),
}
SETTINGS = {
    f"{s}, {p} prolongation, {r}": (STRENGTHS[s], PROLONGATIONS[p], SMOOTHERS[r])
    for s, p, r in product(STRENGTHS, PROLONGATIONS, SMOOTHERS)
}
SMALL = 100  # all settings are tried on a square of so many points a side, the best of each strength on the large one


def offsets():
    """One of each pair of opposite offsets within the horizon."""
    inside = lambda a, b: (b > 0 or a > 0) and a * a + b * b <= RATIO**2
    return [(a, b) for b in range(RATIO + 1) for a in range(-RATIO, RATIO + 1) if inside(a, b)]


def direction(a, b):
    """`N`: the stretch of a bond is `N` times the strains xx, yy and the shear angle."""
    return np.array([a * a, b * b, a * b]) / (a * a + b * b)


def weights():
    """Per offset `a`, `sum a N N^T = C`: of all solutions the one closest to weights in proportion to the length."""
    steps = offsets()
    rows, columns = [0, 1, 0, 2, 0, 1], [0, 1, 1, 2, 2, 2]
    equations = np.array([np.outer(n, n)[rows, columns] for n in (direction(*s) for s in steps)]).T
    wanted = C[rows, columns] / C11
    start = np.array([np.hypot(*s) for s in steps])
    start *= 2 * (wanted[0] + wanted[2]) / start.sum()
    scales = np.maximum(start, 0.3 * start.mean())
    found = start + scales * np.linalg.lstsq(equations * scales, wanted - equations @ start, rcond=1e-12)[0]
    assert found.min() > 0, "a weight is not positive: the closest solution has other bounds"
    return C11 * found


def blocks_of_bonds(number, volume, spacing):
    """Points, points and blocks of all bonds, and the stiffness `D` that every point lacks, 3 x 3."""
    lacks = np.zeros((number.size, 3, 3))
    rows, columns, parts = [], [], []
    height, width = number.shape
    for (a, b), weight in zip(offsets(), weights()):
        low = number[: height - b, max(-a, 0) : width - max(a, 0)].ravel()
        high = number[b:, max(a, 0) : width + min(a, 0)].ravel()
        n = np.array([a, b]) / np.hypot(a, b)
        block = np.outer(n, n) * weight * volume / (spacing**2 * (a * a + b * b))
        for i, j, sign in (low, low, 1), (high, high, 1), (low, high, -1), (high, low, -1):
            rows.append(i)
            columns.append(j)
            parts.append(np.broadcast_to(sign * block, (len(i), 2, 2)))
        present = np.bincount(np.concatenate([low, high]), minlength=number.size)
        lacks += (2 - present)[:, None, None] * 0.5 * weight * np.outer(direction(a, b), direction(a, b))
    return rows, columns, parts, lacks


def blocks_of_triangles(number, lacks, volume, spacing):
    """The same of the triangles that replace missing bonds: up to four at a point, with its next neighbours."""
    rows, columns, parts = [], [], []
    height, width = number.shape
    y, x = (k.ravel() for k in np.indices(number.shape))
    near = lacks[:, 0, 0] + lacks[:, 1, 1] > 1e-9 * C11
    sides = [(s, t) for s in (1, -1) for t in (1, -1)]
    exist = [(0 <= x + s) & (x + s < width) & (0 <= y + t) & (y + t < height) for s, t in sides]
    share = volume / np.maximum(sum(exist), 1)
    for (s, t), there in zip(sides, exist):
        points = np.flatnonzero(there & near)
        strain = np.zeros((3, 3, 2))  # strain, corner, component; the corner itself, along x, along y
        strain[0, 1, 0] = strain[2, 1, 1] = 1 / (s * spacing)
        strain[1, 2, 1] = strain[2, 2, 0] = 1 / (t * spacing)
        strain[:, 0] = -strain[:, 1:].sum(axis=1)
        corners = points, points + s, points + t * width
        modulus = lacks[points] * share[points, None, None]
        for i, j in product(range(3), repeat=2):
            rows.append(corners[i])
            columns.append(corners[j])
            parts.append(np.einsum("kc,pkl,ld->pcd", strain[:, i], modulus, strain[:, j]))
    return rows, columns, parts


def stiffness(width, height, spacing=1.0):
    """The stiffness before supports of points row by row, two unknowns each side by side, in blocks of a point."""
    number = np.arange(width * height).reshape(height, width)
    volume = spacing**2 * THICKNESS
    *bonds, lacks = blocks_of_bonds(number, volume, spacing)
    triangles = blocks_of_triangles(number, lacks, volume, spacing)
    i, j, parts = (np.concatenate(a + b) for a, b in zip(bonds, triangles))
    order = np.argsort(i * number.size + j, kind="stable")
    key = (i * number.size + j)[order]
    first = np.flatnonzero(np.r_[True, key[1:] != key[:-1]])
    blocks = np.add.reduceat(parts[order], first)
    rows, columns = np.divmod(key[first], number.size)
    starts = np.r_[0, np.cumsum(np.bincount(rows, minlength=number.size))]
    return sparse.bsr_matrix((blocks, columns, starts), shape=(2 * number.size,) * 2)


def clamped_square(side):
    """The plate held along its left edge: matrix, load on the right column, rigid motions, all without the left column.

    The edge lies half a spacing before the first column and moves as the first two columns say, in a straight line:
    `3/2 u_0 - 1/2 u_1 = 0` makes `u_0 = u_1/3`, as peristat holds an edge.
    """
    y, x = (k.ravel() for k in np.indices((side, side)))
    free = np.flatnonzero(x > 0)
    number = np.cumsum(x > 0) - 1
    held = np.flatnonzero(x == 0)
    entries = np.r_[np.ones(len(free)), np.full(side, 1 / 3)]
    extension = sparse.csr_matrix((entries, (np.r_[free, held], np.r_[number[free], number[held + 1]])))
    extension = sparse.kron(extension, np.eye(2), format="csr")
    matrix = (extension.T @ stiffness(side, side).tocsr() @ extension).tobsr((2, 2))
    load = np.zeros((len(free), 2))
    load[x[free] == side - 1, 1] = -1.0
    motions = np.zeros((len(free), 2, 3))
    motions[:, 0, 0] = motions[:, 1, 1] = 1
    motions[:, 0, 2], motions[:, 1, 2] = -(y[free] - side / 2) / side, (x[free] - side / 2) / side
    return matrix, load.ravel(), motions.reshape(-1, 3)


def solve(problem, setting):
    """Seconds of set-up and solution, iterations, operator complexity, true residual."""
    from pyamg import smoothed_aggregation_solver

    matrix, load, motions = problem
    strength, smooth, smoother = SETTINGS[setting]
    begin = time.perf_counter()
    levels = smoothed_aggregation_solver(
        matrix, B=motions, symmetry="symmetric", strength=strength, smooth=smooth, presmoother=smoother,
        postsmoother=smoother, improve_candidates=None, max_coarse=500,
    )  # fmt: skip
    ready = time.perf_counter()
    residuals = []
    x = levels.solve(load, tol=1e-10, accel="cg", maxiter=100, residuals=residuals)
    end = time.perf_counter()
    return {
        "setting": setting,
        "setup": ready - begin,
        "solve": end - ready,
        "total": end - begin,
        "iterations": len(residuals) - 1,
        "complexity": levels.operator_complexity(),
        "residual": float(np.linalg.norm(load - matrix @ x) / np.linalg.norm(load)),
    }


def fastest(problem):
    """For every strength the settings that take the shortest time, where they converge."""
    tried = [solve(problem, setting) for setting in SETTINGS]
    tried = [t for t in tried if t["residual"] < 1e-9]
    best = {t["setting"].split(",")[0]: t["setting"] for t in sorted(tried, key=lambda t: -t["total"])}
    return list(best.values())


def difference(path, width, height, spacing):
    """Largest difference from a Matrix Market file: `max abs(dK_ij) / sqrt(K_ii K_jj)`."""
    from scipy.io import mmread

    ours, theirs = stiffness(width, height, spacing).toarray(), mmread(path).toarray()
    scale = np.sqrt(np.outer(ours.diagonal(), ours.diagonal()))
    return float((abs(ours - theirs) / scale).max())


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    warnings.simplefilter("ignore")  # pyamg's, on matrix formats
    parser.add_argument("--side", type=int, default=100, help="points of a side")
    parser.add_argument("--setting", choices=SETTINGS, help="those that are fastest on a small square if it is not given")
    parser.add_argument("--check", metavar="FILE", help="compare a matrix of --size points instead")
    parser.add_argument("--size", type=int, nargs=2, default=(20, 20))
    parser.add_argument("--spacing", type=float, default=1.0)
    options = parser.parse_args()
    if options.check:
        print(difference(options.check, *options.size, options.spacing))
        return
    settings = [options.setting] if options.setting else fastest(clamped_square(min(SMALL, options.side)))
    begin = time.perf_counter()
    problem = clamped_square(options.side)
    assembled = time.perf_counter() - begin
    for setting in settings:
        print(json.dumps(solve(problem, setting) | {"assembly": assembled}), flush=True)


if __name__ == "__main__":
    sys.exit(main())
