"""Biquadratic elements of scikit-fem for plates with a hole: `pareto_hole.py PLATE SIZE` prints one line of JSON.

`error`: of the way that the middle of the pulled end moves; `stress_error`: of the stress at the top of the hole, both
relative. `inside_s`: seconds from the first node to the stress, without start and imports.
`pareto_hole.py reference` prints what both answers tend to, of which `pareto_problems.py` has the digits that stay.
"""

import json
import sys
import time

import numpy as np
from pareto_mesh import corners, quarter
from pareto_problems import HOLES, Hole
from scipy.sparse.linalg import spsolve
from skfem import Basis, BilinearForm, ElementQuad2, ElementVector, FacetBasis, LinearForm, MeshQuad, MeshQuad2
from skfem.helpers import sym_grad


def mesh_of(plate, size):
    """Elements whose sides follow the hole; the last ray's first has the top of the hole as its fourth corner."""
    nodes = quarter(plate, size)
    across, along = (n // 2 + 1 for n in nodes.shape[:2])
    cells = corners(across, along)
    # Which node is where, told by elements between whole numbers.
    numbers = np.stack(np.divmod(np.arange(across * along), along)).astype(float)
    lattice = MeshQuad2.from_mesh(MeshQuad(numbers, cells))
    i, j = np.rint(2 * lattice.doflocs).astype(int)
    return MeshQuad2(nodes[i, j].T, lattice.t), (across - 2) * (along - 1)


def solve(plate, size):
    """How far the middle of the end moves, and the stress at the top of the hole."""
    mesh, last = mesh_of(plate, size)
    element, c = ElementVector(ElementQuad2()), plate.stiffness
    basis = Basis(mesh, element, intorder=4)

    def stress(u):
        e = sym_grad(u)
        strain = e[0, 0], e[1, 1], 2 * e[0, 1]
        return [sum(c[i][j] * strain[j] for j in range(3) if c[i][j]) for i in range(3)]

    @BilinearForm
    def stiffness(u, v, _):
        s, e = stress(u), sym_grad(v)
        return s[0] * e[0, 0] + s[1] * e[1, 1] + 2 * s[2] * e[0, 1]

    at_end = lambda x: x[0] > plate.size[0] * (1 - 1e-9)
    end = FacetBasis(mesh, element, facets=mesh.facets_satisfying(at_end, boundaries_only=True), intorder=5)
    f = plate.traction * LinearForm(lambda v, _: v[0]).assemble(end)
    parts, places = basis.split_indices(), basis.doflocs
    held = [part[axis[part] < 1e-9] for part, axis in zip(parts, places)]
    free, u = np.setdiff1d(np.arange(basis.N), np.concatenate(held)), np.zeros(basis.N)
    k = stiffness.assemble(basis)
    u[free] = spsolve(k[free][:, free], f[free], permc_spec="MMD_AT_PLUS_A")
    along = parts[0]
    middle = along[at_end(places[:, along]) & (places[1, along] < 1e-9)][0]
    return u[middle], top_stress(mesh, element, last, u, stress)


def top_stress(mesh, element, last, u, stress):
    """Along the pull, in the fourth corner of an element."""
    corner = Basis(mesh, element, elements=[last], quadrature=(np.array([[0.0], [1.0]]), np.ones(1)))
    return stress(corner.interpolate(u))[0][0, 0]


def reference():
    for name in HOLES:
        for size in (16, 32, 64, 96):
            print(name, size, *(f"{found:.9g}" for found in solve(Hole(name), size)))


def main():
    if sys.argv[1] == "reference":
        return reference()
    plate = Hole(sys.argv[1])
    begin = time.perf_counter()
    moved, stress = solve(plate, int(sys.argv[2]))
    inside = time.perf_counter() - begin
    print(json.dumps({"error": abs(moved / plate.moved - 1), "stress_error": abs(stress / plate.stress - 1), "inside_s": inside}))


if __name__ == "__main__":
    main()
