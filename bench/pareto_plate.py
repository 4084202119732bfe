"""Programs for plates that are called from Python: `pareto_plate.py METHOD SIZE` prints one line of JSON.

`error`: the largest error of a displacement over the points, relative to the largest displacement of the closed form.
`stress_error`: the same of stresses, of finite elements in the four points of each where they are best.
`inside_s`: seconds in the program from the first point to the solution, without start and imports. Finite elements:
6 SIZE x 2 SIZE nearly square ones; peridynamics: SIZE points over the height.
"""

import json
import sys
import time

import numpy as np
from pareto_problems import Plate
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import spsolve


def held(plate, x, y):
    """The three displacements that fix the rigid motion, as pairs of a point and a direction."""
    nearest = lambda place: np.argmin((x - place) ** 2 + (y - plate.height / 2) ** 2)
    middle, second = nearest(plate.middle), nearest(plate.second)
    return [(middle, 0), (middle, 1), (second, 1)]


def reduced(k, f, fixed):
    """Solves with some unknowns held at zero; k is symmetric, which the order of elimination may use."""
    free = np.setdiff1d(np.arange(len(f)), fixed)
    u = np.zeros(len(f))
    u[free] = spsolve(k[free][:, free], f[free], permc_spec="MMD_AT_PLUS_A")
    return u


def scikit_fem(order):
    """Bilinear or biquadratic elements of plane stress."""
    from skfem import Basis, BilinearForm, ElementQuad1, ElementQuad2, ElementVector, FacetBasis, LinearForm, MeshQuad

    def solve(plate, size):
        sides = (np.linspace(0, s, n * size + 1) for s, n in ((plate.length, 6), (plate.height, 2)))
        mesh = MeshQuad.init_tensor(*sides)
        basis = Basis(mesh, ElementVector({1: ElementQuad1, 2: ElementQuad2}[order]()))
        modulus, nu = plate.youngs_modulus, plate.poisson_ratio
        lame, shear = modulus * nu / (1 - nu**2), modulus / 2 / (1 + nu)

        @BilinearForm
        def stiffness(u, v, _):
            (ux, uy), (vx, vy) = u.grad, v.grad
            normal = lame * (ux[0] + uy[1]) * (vx[0] + vy[1]) + 2 * shear * (ux[0] * vx[0] + uy[1] * vy[1])
            return normal + shear * (ux[1] + uy[0]) * (vx[1] + vy[0])

        f = np.zeros(basis.N)
        for right in (False, True):
            facets = mesh.facets_satisfying(lambda x: np.isclose(x[0], right * plate.length))
            end = FacetBasis(mesh, basis.elem, facets=facets, intorder=5)

            @LinearForm
            def traction(v, w):
                tx, ty = plate.traction(right, w.x[1])
                return tx * v[0] + ty * v[1]

            f += traction.assemble(end)
        parts = basis.split_indices()
        x, y = basis.doflocs[:, parts[0]]
        u = reduced(stiffness.assemble(basis), f, [parts[d][point] for point, d in held(plate, x, y)])
        # Two points a side.
        inner = Basis(mesh, basis.elem, intorder=3)
        (xx, xy), (yx, yy) = inner.interpolate(u).grad
        at = inner.global_coordinates().value
        stress = lame * (xx + yy) + 2 * shear * xx, shear * (xy + yx)
        return (x, y, u[parts[0]], u[parts[1]]), (*at, *stress)

    return solve


def peridynamics(ratio, correction):
    """Central bonds with the constant of the continuum and partial volumes, as papers write it; K is assembled.

    Tractions are forces on the outermost points. `correction`: bonds are stiffened by the volumes of both families.
    """

    def solve(plate, rows):
        h, columns = plate.height / rows, round(rows * plate.length / plate.height)
        horizon, volume = ratio * h, h * h
        micromodulus = 9 * plate.youngs_modulus / (np.pi * horizon**3)
        number = np.arange(columns * rows).reshape(columns, rows)
        x, y = (h * (axis.ravel() + 0.5) for axis in np.indices(number.shape))
        bonds, volumes = [], np.zeros(x.size)
        for a in range(ratio + 1):
            for b in range(-ratio, ratio + 1):
                length = h * np.hypot(a, b)
                part = min(1.0, (horizon + h / 2 - length) / h)
                if part <= 0 or (a, b) <= (0, 0):
                    continue
                i = number[: columns - a, max(0, -b) : rows - max(0, b)].ravel()
                bonds.append((i, i + a * rows + b, np.array([a, b]) * h / length, length, part))
                for end in bonds[-1][:2]:
                    volumes[end] += part * volume
        entries, rows_of, columns_of = [], [], []
        for i, j, direction, length, part in bonds:
            stiffness = np.full(i.size, micromodulus * part * volume**2 / length)
            if correction:
                stiffness *= 2 * volumes.max() / (volumes[i] + volumes[j])
            shape = np.outer(np.append(-direction, direction), np.append(-direction, direction))
            unknowns = np.stack([2 * i, 2 * i + 1, 2 * j, 2 * j + 1], axis=1)
            rows_of.append(np.repeat(unknowns, 4, axis=1).ravel())
            columns_of.append(np.tile(unknowns, 4).ravel())
            entries.append((stiffness[:, None] * shape.ravel()).ravel())
        f = np.zeros((x.size, 2))
        for right, column in (False, number[0]), (True, number[-1]):
            f[column] += h * np.stack(plate.traction(right, y[column]), axis=1)
        places = np.concatenate(rows_of), np.concatenate(columns_of)
        k = coo_matrix((np.concatenate(entries), places)).tocsr()
        u = reduced(k, f.ravel(), [2 * point + d for point, d in held(plate, x, y)])
        return (x, y, u[::2], u[1::2]), None

    return solve


METHODS = {
    "scikit_fem_1": lambda: scikit_fem(1),
    "scikit_fem_2": lambda: scikit_fem(2),
    "peridynamics": lambda: peridynamics(3, False),
    "peridynamics_volume": lambda: peridynamics(3, True),
}


def main():
    plate, solve = Plate(), METHODS[sys.argv[1]]()
    begin = time.perf_counter()
    moved, stressed = solve(plate, int(sys.argv[2]))
    inside = time.perf_counter() - begin
    printed = {"error": worst(moved, plate.displacement), "inside_s": inside}
    if stressed:
        printed["stress_error"] = worst(stressed, plate.stress, plate.largest_stress())
    print(json.dumps(printed))


def worst(found, exact, largest=None):
    """The largest difference of two fields at places x and y, over the largest of both."""
    x, y, *found = found
    expected = exact(x, y)
    return max(np.abs(a - b).max() for a, b in zip(found, expected)) / (largest or max(np.abs(b).max() for b in expected))


if __name__ == "__main__":
    main()
