"""Kirchhoff's plate by scikit-fem: a quarter of a clamped square of side 1 with D = 1 under a unit pressure.

`python bending_fe.py morley|argyris SIZE` prints the deflection in the middle, with SIZE x SIZE x 2 triangles.
"""

import json
import sys
import time

import numpy as np
from scipy.sparse.linalg import spsolve
from skfem import Basis, BilinearForm, ElementTriArgyris, ElementTriMorley, LinearForm, MeshTri, condense
from skfem.helpers import dd, ddot, eye, trace

NU = 0.3


@BilinearForm
def bending(u, v, _):
    curvature, other = dd(u), dd(v)
    return ddot((1 - NU) * curvature + NU * eye(trace(curvature), 2), other)


@LinearForm
def pressure(v, _):
    return 1.0 * v


def held(basis):
    """Unknowns at rest: all of clamped edges but what bends across them, slopes across the two lines of symmetry."""
    known, rest = set(basis.elem.dofnames), []
    for axis, (across, bends) in enumerate((("u_x", "u_xx"), ("u_y", "u_yy"))):
        for at, names in ((0.0, {across, "u_xy", "u_n"}), (0.5, known - {bends})):
            facets = basis.mesh.facets_satisfying(lambda x: np.isclose(x[axis], at), boundaries_only=True)
            rest.append(basis.get_dofs(facets).all(sorted(names & known)))
    return np.unique(np.concatenate(rest))


def main():
    element = {"morley": ElementTriMorley, "argyris": ElementTriArgyris}[sys.argv[1]]()
    size, begin = int(sys.argv[2]), time.perf_counter()
    line = np.linspace(0, 0.5, size + 1)
    basis = Basis(MeshTri.init_tensor(line, line), element, intorder=8 if sys.argv[1] == "argyris" else 4)
    matrix, force, u, free = condense(bending.assemble(basis), pressure.assemble(basis), D=held(basis))
    u[free] = spsolve(matrix, force, permc_spec="COLAMD")
    corner = np.flatnonzero((basis.mesh.p == 0).all(axis=0))[0]
    inside = time.perf_counter() - begin
    print(json.dumps({"deflection": u[basis.nodal_dofs[0, corner]], "inside_s": inside}))


if __name__ == "__main__":
    main()
