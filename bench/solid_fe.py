"""The sheared cube by scikit-fem and pyamg: `solid_fe.py ORDER ELEMENTS` prints the compliance. A script as a user writes it."""

import json
import sys

import numpy as np
import pyamg
from skfem import Basis, ElementHex1, ElementHex2, ElementVector, FacetBasis, LinearForm, MeshHex
from skfem.models.elasticity import lame_parameters, linear_elasticity
from solid_cases import POISSON_RATIO, YOUNGS_MODULUS


def rigid_motions(places):
    """Displacements of three translations and three rotations at the places (3 x points), unknowns of a point together."""
    x, y, z = places - places.mean(axis=1)[:, None]
    motions = np.zeros((x.size, 3, 6))
    motions[:, [0, 1, 2], [0, 1, 2]] = 1
    motions[:, 0, 3], motions[:, 1, 3] = -y, x
    motions[:, 1, 4], motions[:, 2, 4] = -z, y
    motions[:, 2, 5], motions[:, 0, 5] = -x, z
    return motions.reshape(-1, 6)


def main():
    order, n = int(sys.argv[1]), int(sys.argv[2])
    mesh = MeshHex.init_tensor(*[np.linspace(0, 1, n + 1)] * 3)
    element = ElementVector({1: ElementHex1, 2: ElementHex2}[order]())
    basis = Basis(mesh, element)
    k = linear_elasticity(*lame_parameters(YOUNGS_MODULUS, POISSON_RATIO)).assemble(basis)
    end = FacetBasis(mesh, element, facets=mesh.facets_satisfying(lambda x: np.isclose(x[0], 1)))
    f = LinearForm(lambda v, _: v[2]).assemble(end)
    # Unknowns by points, so that the three of one stand together.
    by_point = np.lexsort((np.arange(basis.N), *np.round(basis.doflocs * 2 * order * n)))
    free = by_point[~np.isclose(basis.doflocs[0, by_point], 0)]
    matrix = k.tocsr()[free][:, free].tobsr((3, 3))
    motions = rigid_motions(basis.doflocs[:, free[::3]])
    levels = pyamg.smoothed_aggregation_solver(matrix, B=motions, strength=("symmetric", {"theta": 0.0}))
    u = levels.solve(f[free], tol=1e-8, accel="cg")
    print(json.dumps(YOUNGS_MODULUS * float(f[free] @ u)))


if __name__ == "__main__":
    main()
