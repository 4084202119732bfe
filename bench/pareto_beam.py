"""Programs for beams that are called from Python: `pareto_beam.py METHOD ELEMENTS SLENDERNESS` prints one line of JSON.

`error`: the largest error of the deflection over the nodes, relative to the largest deflection of the closed form.
`inside_s`: seconds in the program from the first node to the solution, without start and imports; its parts are
imported before. Every function is a small script as a user would write it.
"""

import json
import sys
import time

from pareto_problems import LOAD, POISSON_RATIO, SHEAR_FACTOR, SHEAR_MODULUS, YOUNGS_MODULUS, Beam


def exact_element(beam, l):
    """Stiffness and load of the two-node element with the shape functions of the equations themselves."""
    import numpy as np

    phi = 12 * beam.bending / (beam.shear * l * l)
    matrix = np.array([[12, 6 * l, -12, 6 * l],
                       [6 * l, (4 + phi) * l * l, -6 * l, (2 - phi) * l * l],
                       [-12, -6 * l, 12, -6 * l],
                       [6 * l, (2 - phi) * l * l, -6 * l, (4 + phi) * l * l]])  # fmt: skip
    load = LOAD * np.array([l / 2, l * l / 12, l / 2, -l * l / 12])
    return matrix * beam.bending / (l**3 * (1 + phi)), load


def linear_element(beam, l):
    """Linear shape functions, shear at the middle: the textbook element that does not lock."""
    import numpy as np

    shear, bending = np.array([-1 / l, -0.5, 1 / l, -0.5]), np.array([0, -1, 0, 1]) / l
    matrix = l * (beam.shear * np.outer(shear, shear) + beam.bending * np.outer(bending, bending))
    return matrix, LOAD * np.array([l / 2, 0, l / 2, 0])


def banded(element):
    import numpy as np
    from scipy.linalg import solveh_banded

    def solve(beam, n):
        matrix, load = element(beam, 1 / n)
        band, f = np.zeros((4, 2 * n + 2)), np.zeros(2 * n + 2)
        for i in range(4):
            f[i : i + 2 * n : 2] += load[i]
            for j in range(i + 1):
                band[i - j, j : j + 2 * n : 2] += matrix[i, j]
        return np.append(0.0, solveh_banded(band[:, 2:], f[2:], lower=True)[::2])

    return solve


def sparse(element):
    import numpy as np
    from scipy.sparse import coo_matrix
    from scipy.sparse.linalg import spsolve

    def solve(beam, n):
        matrix, load = element(beam, 1 / n)
        unknowns = 2 * np.arange(n)[:, None] + np.arange(4)
        rows, columns = np.repeat(unknowns, 4, axis=1), np.tile(unknowns, 4)
        k = coo_matrix((np.tile(matrix.ravel(), n), (rows.ravel(), columns.ravel()))).tocsc()
        f = np.bincount(unknowns.ravel(), np.tile(load, n))
        return np.append(0.0, spsolve(k[2:, 2:], f[2:])[::2])

    return solve


def scikit_fem(order):
    """Deflections of one order, rotations of one less: free of locking."""
    import numpy as np
    from skfem import Basis, BilinearForm, ElementLineP1, ElementLineP2, LinearForm, MeshLine, condense, solve as direct
    from skfem.element import ElementLinePp

    lines = {1: ElementLineP1, 2: ElementLineP2}
    element = lambda p: lines[p]() if p in lines else ElementLinePp(p)

    def solve(beam, n):
        mesh = MeshLine(np.linspace(0, 1, n + 1))
        deflection = Basis(mesh, element(order) * element(order - 1), intorder=2 * order)

        @BilinearForm
        def stiffness(w, phi, v, psi, _):
            return beam.bending * phi.grad[0] * psi.grad[0] + beam.shear * (w.grad[0] - phi) * (v.grad[0] - psi)

        @LinearForm
        def load(v, psi, _):
            return LOAD * v

        clamp = deflection.get_dofs(lambda x: np.isclose(x[0], 0))
        u = direct(*condense(stiffness.assemble(deflection), load.assemble(deflection), D=clamp))
        return u[deflection.nodal_dofs[0]]

    return solve


def opensees():
    import openseespy.opensees as ops

    def solve(beam, n):
        ops.model("basic", "-ndm", 2, "-ndf", 3)
        for i in range(n + 1):
            ops.node(i, i / n, 0.0)
        ops.fix(0, 1, 1, 1)
        ops.geomTransf("Linear", 1)
        section = YOUNGS_MODULUS, SHEAR_MODULUS, beam.area, beam.second_moment, SHEAR_FACTOR * beam.area
        for i in range(n):
            ops.element("ElasticTimoshenkoBeam", i, i, i + 1, *section, 1)
        ops.timeSeries("Constant", 1)
        ops.pattern("Plain", 1, 1)
        ops.eleLoad("-range", 0, n - 1, "-type", "-beamUniform", LOAD)
        ops.system("BandSPD")
        ops.numberer("Plain")
        ops.constraints("Plain")
        ops.algorithm("Linear")
        ops.integrator("LoadControl", 1)
        ops.analysis("Static")
        if ops.analyze(1) != 0:
            sys.exit("OpenSees did not solve it")
        return [ops.nodeDisp(i, 2) for i in range(n + 1)]

    return solve


def pynite():
    """Its members have no shear deformation."""
    from Pynite import FEModel3D

    def solve(beam, n):
        model = FEModel3D()
        model.add_material("steel", YOUNGS_MODULUS, SHEAR_MODULUS, POISSON_RATIO, 7850.0)
        model.add_section("bar", beam.area, beam.second_moment, beam.second_moment, beam.second_moment)
        for i in range(n + 1):
            model.add_node(f"N{i}", i / n, 0, 0)
        for i in range(n):
            model.add_member(f"M{i}", f"N{i}", f"N{i + 1}", "steel", "bar")
            model.add_member_dist_load(f"M{i}", "Fy", LOAD, LOAD)
        model.def_support("N0", *[True] * 6)
        model.analyze_linear(check_stability=False)
        return [next(iter(model.nodes[f"N{i}"].DY.values())) for i in range(n + 1)]

    return solve


METHODS = {
    "banded_exact": lambda: banded(exact_element),
    "banded_linear": lambda: banded(linear_element),
    "sparse_exact": lambda: sparse(exact_element),
    "scikit_fem_2": lambda: scikit_fem(2),
    "scikit_fem_3": lambda: scikit_fem(3),
    "opensees": opensees,
    "pynite": pynite,
}


def main():
    name, elements, slenderness = sys.argv[1], int(sys.argv[2]), float(sys.argv[3])
    beam, solve = Beam(slenderness), METHODS[name]()
    begin = time.perf_counter()
    w = solve(beam, elements)
    inside = time.perf_counter() - begin
    if isinstance(w, list):
        worst = max(abs(found - beam.deflection(i / elements)) for i, found in enumerate(w))
    else:
        import numpy as np

        worst = np.abs(w - beam.deflection(np.linspace(0, 1, elements + 1))).max()
    print(json.dumps({"error": float(worst) / beam.deflection(1.0), "inside_s": inside}))


if __name__ == "__main__":
    main()
