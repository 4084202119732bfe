"""Decks for CalculiX and what it prints. Written and read outside its time; its tables have seven digits."""

from pareto_problems import LOAD, POISSON_RATIO, SHEAR_FACTOR, WIDTH, YOUNGS_MODULUS, Beam, Plate

THICKNESS = 0.01  # mm: ccx makes solid elements of plane ones; at 1 mm they are 1e-4 off plane stress, which has none
GAUSS = (-(0.6**0.5), 5 / 9), (0.0, 8 / 9), (0.6**0.5, 5 / 9)


def number(value):
    """A number is cut after twenty characters by `ccx`."""
    return f"{value:.11e}"


def deck(nodes, elements, material, section, loads, asked=("*NODE PRINT,NSET=ALL", "U")):
    """The whole file; `loads` begins with what is held. `material`: two constants, or four of an orthotropic lamina."""
    lines = ["*NODE,NSET=ALL"]
    lines += [f"{k},{number(x)},{number(y)},0" for k, (x, y) in enumerate(nodes, 1)]
    lines += [*elements, "*MATERIAL,NAME=M", *elastic(*material), *section, *loads]
    return "\n".join([*lines, *asked, "*END STEP", ""])


def elastic(along, *rest):
    """Of Young's modulus and Poisson's ratio, or of both moduli, Poisson's ratio and the shear modulus of a lamina."""
    if len(rest) == 1:
        return "*ELASTIC", f"{number(along)},{number(*rest)}"
    across, poisson, shear = rest
    # Nothing of what is across the plane is seen in plane stress.
    first = along, across, across, poisson, 0.0, 0.0, shear, shear
    return "*ELASTIC,TYPE=ENGINEERING CONSTANTS", ",".join(map(number, first)), number(shear)


def beam_deck(kind, n, slenderness):
    """`U1`: a Timoshenko beam with consistent shape functions; `B31`: a beam that ccx makes solid elements of."""
    beam, l = Beam(slenderness), 1 / n
    bars = [f"{i},{i},{i + 1}" for i in range(1, n + 1)]
    elements = [f"*ELEMENT,TYPE={kind},ELSET=E", *bars]
    loads = ["*BOUNDARY", "1,1,6", "*STEP", "*STATIC"]
    if kind == "U1":
        elements.insert(0, "*USER ELEMENT,TYPE=U1,NODES=2,INTEGRATION POINTS=2,MAXDOF=6")
        second = beam.second_moment
        numbers = ",".join(map(number, (beam.area, second, 0, second, SHEAR_FACTOR)))
        section = ["*BEAM SECTION,ELSET=E,MATERIAL=M,SECTION=GENERAL", numbers, "0,1,0"]
        forces = [LOAD * l] * (n - 1) + [LOAD * l / 2]
        loads += ["*CLOAD", *(f"{i},2,{number(f)}" for i, f in enumerate(forces, 2))]
        loads.append(f"{n + 1},6,{number(-LOAD * l * l / 12)}")
    else:
        size = f"{number(WIDTH)},{number(beam.height)}"
        section = ["*BEAM SECTION,ELSET=E,MATERIAL=M,SECTION=RECT", size, "0,0,1"]
        loads += ["*DLOAD", f"E,P2,{number(-LOAD / WIDTH)}"]
    nodes = [(i * l, 0.0) for i in range(n + 1)]
    return deck(nodes, elements, (YOUNGS_MODULUS, POISSON_RATIO), section, loads)


def end_forces(plate, right, heights):
    """Consistent forces of a traction on the nodes of an end: of two or, with a middle one, of three per element."""
    order = 2 if len(heights[0]) == 3 else 1
    forces = []
    for nodes in heights:
        low, high = nodes[0], nodes[-1]
        shares = [[0.0, 0.0] for _ in nodes]
        for s, weight in GAUSS:
            shape = [s * (s - 1) / 2, 1 - s * s, s * (s + 1) / 2] if order == 2 else [(1 - s) / 2, (1 + s) / 2]
            traction = plate.traction(right, (low + high) / 2 + s * (high - low) / 2)
            for share, value in zip(shares, shape):
                for d in (0, 1):
                    share[d] += THICKNESS * value * weight * (high - low) / 2 * traction[d]
        forces.append(shares)
    return forces


def plate_nodes(order, size):
    """Positions of nodes by their place in a lattice; those of order 2 lack the middles of elements."""
    across, up = order * 6 * size, order * 2 * size
    places = ((i, j) for i in range(across + 1) for j in range(up + 1) if order == 1 or not i & j & 1)
    return {(i, j): (i * Plate.length / across, j * Plate.height / up) for i, j in places}


def plate_deck(order, size):
    """Elements CPS4 or CPS8 of plane stress, 6 `size` x 2 `size`."""
    plate, columns, rows = Plate(), 6 * size, 2 * size
    nodes = plate_nodes(order, size)
    label = {place: k for k, place in enumerate(nodes, 1)}
    height = lambda j: j * plate.height / (order * rows)
    corners = [(0, 0), (order, 0), (order, order), (0, order)]
    around = corners if order == 1 else [*corners, (1, 0), (2, 1), (1, 2), (0, 1)]
    cells = [(order * i, order * j) for i in range(columns) for j in range(rows)]
    elements = [f"*ELEMENT,TYPE=CPS{4 * order},ELSET=E"]
    for k, (i, j) in enumerate(cells, 1):
        elements.append(",".join(map(str, (k, *(label[i + a, j + b] for a, b in around)))))
    on_axis = lambda x: label[round(x / plate.length * order * columns), order * rows // 2]
    middle, second = on_axis(plate.middle), on_axis(plate.second)
    loads = ["*BOUNDARY", f"{middle},1,2", f"{second},2,2", "*STEP", "*STATIC", "*CLOAD"]
    for right in (False, True):
        edges = [range(order * j, order * (j + 1) + 1) for j in range(rows)]
        for edge, shares in zip(edges, end_forces(plate, right, [[height(j) for j in edge] for edge in edges])):
            for j, share in zip(edge, shares):
                node = label[order * columns * right, j]
                loads += [f"{node},{d + 1},{number(share[d])}" for d in (0, 1) if share[d]]
    section = ["*SOLID SECTION,ELSET=E,MATERIAL=M", number(THICKNESS)]
    return deck(nodes.values(), elements, (plate.youngs_modulus, plate.poisson_ratio), section, loads)


def table(path):
    """Both displacements of every node, in their order."""
    rows = (line.split() for line in path.open())
    return ((float(row[1]), float(row[2])) for row in rows if len(row) >= 4 and row[0].isdigit())


def beam_error(path, n, slenderness):
    beam = Beam(slenderness)
    return max(abs(w - beam.deflection(i / n)) for i, (_, w) in enumerate(table(path))) / beam.deflection(1.0)


def plate_error(path, order, size):
    plate, worst, largest = Plate(), 0.0, 0.0
    for (x, y), found in zip(plate_nodes(order, size).values(), table(path)):
        exact = plate.displacement(x, y)
        worst = max(worst, *(abs(a - b) for a, b in zip(found, exact)))
        largest = max(largest, *map(abs, exact))
    return worst / largest


def hole_deck(plate, size):
    """Elements CPS8 that follow the hole, `size` along it and as many away from it."""
    import numpy as np
    from pareto_mesh import quarter

    places = quarter(plate, size)
    label = {}
    for i, j in np.ndindex(places.shape[:2]):
        if not i & j & 1:
            label[i, j] = len(label) + 1
    around = (0, 0), (0, 2), (2, 2), (2, 0), (0, 1), (1, 2), (2, 1), (1, 0)
    elements = ["*ELEMENT,TYPE=CPS8,ELSET=E"]
    for k, (i, j) in enumerate(((2 * i, 2 * j) for i in range(size) for j in range(size)), 1):
        elements.append(",".join(map(str, (k, *(label[i + a, j + b] for a, b in around)))))
    last, middle = 2 * size, label[0, 2 * size]
    side, upper = ([label[i, j] for j in range(last + 1)] for i in (0, last))
    elements += ["*NSET,NSET=SIDE", *map("{},".format, side), "*NSET,NSET=UPPER", *map("{},".format, upper)]
    elements += ["*NSET,NSET=TOP", str(upper[0]), "*NSET,NSET=END", str(middle)]
    loads = ["*BOUNDARY", "SIDE,2,2", "UPPER,1,1", "*STEP", "*STATIC", "*CLOAD"]
    # The first half of the rays ends at the loaded side.
    for i in range(0, size, 2):
        share = THICKNESS * plate.traction * (places[i + 2, last, 1] - places[i, last, 1]) / 6
        loads += [f"{label[i + k, last]},1,{number(part * share)}" for k, part in enumerate((1, 4, 1))]
    section = ["*ORIENTATION,NAME=FIBRES", "1,0,0,0,1,0", "*SOLID SECTION,ELSET=E,MATERIAL=M,ORIENTATION=FIBRES"]
    asked = "*NODE PRINT,NSET=END", "U", "*EL FILE,NSET=TOP,OUTPUT=2D", "S"
    nodes = (places[place] for place in label)
    return deck(nodes, elements, plate.material, [*section, number(THICKNESS)], loads, asked)


def hole_error(path, plate):
    """Of the way of the end, and of the stress at the top of the hole that it continues from inside the elements."""
    [(moved, _)] = table(path)
    stresses = path.with_suffix(".frd").read_text().split(" STRESS ")[1]
    line = next(line for line in stresses.splitlines() if line.startswith(" -1"))
    return abs(moved / plate.moved - 1), abs(float(line[13:25]) / plate.stress - 1)
