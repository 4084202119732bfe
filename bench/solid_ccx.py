"""Decks of the sheared cube for CalculiX, and the compliance from what it prints. Written and read outside its time.

`solid_ccx.py KIND ELEMENTS FILE [SOLVER]` writes a deck, in a process of its own: a child's peak of memory counts what its
parent holds.
"""

import sys
from collections import Counter
from pathlib import Path

from pareto_ccx import number
from solid_cases import POISSON_RATIO, YOUNGS_MODULUS

CORNERS = (0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)
PAIRS = (0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)


def around(order):
    """The nodes of an element from its first corner, in the order of CalculiX: corners, then middles of edges."""
    corners = [tuple(order * c for c in corner) for corner in CORNERS]
    middles = [tuple((a + b) // 2 for a, b in zip(corners[i], corners[j])) for i, j in PAIRS]
    return corners + (middles if order == 2 else [])


def places(order, n):
    """Nodes by their place in a lattice, from 1 on; order 2 has none in the middle of elements and of their faces."""
    steps = range(order * n + 1)
    kept = ((i, j, k) for k in steps for j in steps for i in steps if order == 1 or (i & 1) + (j & 1) + (k & 1) < 2)
    return {place: label for label, place in enumerate(kept, 1)}


def shear(order, n):
    """Consistent forces of a traction of 1 on the face `x = 1`, by places across it."""
    forces, area = Counter(), 1 / n**2
    if order == 1:
        shares = {(a, b): area / 4 for a in (0, 1) for b in (0, 1)}
    else:
        shares = {(a, b): -area / 12 for a in (0, 2) for b in (0, 2)}
        shares |= {place: area / 3 for place in ((1, 0), (0, 1), (2, 1), (1, 2))}
    for j in range(0, order * n, order):
        for k in range(0, order * n, order):
            for (a, b), share in shares.items():
                forces[j + a, k + b] += share
    return forces


def deck(kind, n, solver):
    """`kind` is C3D8, C3D8I or C3D20; `solver` is what the step names, the direct one of the installation if nothing."""
    order = 2 if kind == "C3D20" else 1
    label, side = places(order, n), order * n
    lines = ["*NODE,NSET=ALL", *(f"{l},{','.join(number(c / side) for c in p)}" for p, l in label.items())]
    lines.append(f"*ELEMENT,TYPE={kind},ELSET=E")
    cells = ((i, j, k) for k in range(0, side, order) for j in range(0, side, order) for i in range(0, side, order))
    for element, (i, j, k) in enumerate(cells, 1):
        row = [str(element), *(str(label[i + a, j + b, k + c]) for a, b, c in around(order))]
        lines += [",".join(row[:11]) + ",", ",".join(row[11:])] if order == 2 else [",".join(row)]
    end = [node for (i, _, _), node in label.items() if i == side]
    lines += ["*NSET,NSET=END", *(f"{node}," for node in end)]
    lines += ["*MATERIAL,NAME=M", "*ELASTIC", f"{number(YOUNGS_MODULUS)},{number(POISSON_RATIO)}"]
    lines += ["*SOLID SECTION,ELSET=E,MATERIAL=M", "*BOUNDARY"]
    lines += [f"{node},1,3" for (i, _, _), node in label.items() if i == 0]
    lines += ["*STEP", "*STATIC" + f",SOLVER={solver}" * bool(solver), "*CLOAD"]
    lines += [f"{label[side, j, k]},3,{number(f)}" for (j, k), f in shear(order, n).items()]
    return "\n".join([*lines, "*NODE PRINT,NSET=END", "U", "*END STEP", ""])


def compliance(path, kind, n):
    """Work of the forces times Young's modulus. The table has the nodes of the end in the order of their labels."""
    order = 2 if kind == "C3D20" else 1
    steps = range(order * n + 1)
    end = ((j, k) for k in steps for j in steps if order == 1 or not j & k & 1)
    rows = (line.split() for line in path.open())
    moved = (float(row[3]) for row in rows if len(row) >= 4 and row[0].isdigit())
    forces = shear(order, n)
    return YOUNGS_MODULUS * sum(forces[place] * u for place, u in zip(end, moved, strict=True))


def main():
    kind, n, path, *solver = sys.argv[1:]
    Path(path).write_text(deck(kind, int(n), "".join(solver)))


if __name__ == "__main__":
    main()
