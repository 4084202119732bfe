"""The problems of the comparison and what is known of them: what every program is asked, by whichever way.

Nothing but arithmetic, so that numbers and arrays do alike and no program pays for an import that it does not need.
"""

LOAD = 1000.0  # N/m across the beam
WIDTH = 0.05  # m
YOUNGS_MODULUS, POISSON_RATIO = 2.0e11, 0.3
SHEAR_MODULUS = YOUNGS_MODULUS / 2 / (1 + POISSON_RATIO)
SHEAR_FACTOR = 5 / 6


class Beam:
    """A steel cantilever of 1 m under a uniform load; slenderness is length over section height."""

    def __init__(self, slenderness):
        self.height = 1 / slenderness
        self.area, self.second_moment = WIDTH * self.height, WIDTH * self.height**3 / 12
        self.bending = YOUNGS_MODULUS * self.second_moment
        self.shear = SHEAR_FACTOR * SHEAR_MODULUS * self.area

    def deflection(self, x):
        """Of Timoshenko's beam: bending and shear."""
        bent = x * x * (x * x - 4 * x + 6) / (24 * self.bending)
        return LOAD * (bent + x * (1 - x / 2) / self.shear)


class Plate:
    """A cantilever of plane stress, thickness 1 mm, whose stresses are those of the beam exactly.

    Both ends carry tractions: a parabolic shear on both, and on the left also the linear stress of the moment that
    balances them. The displacements are polynomials of third order. Three held displacements on the axis, in the middle
    and at `second`, are no constraint but fix the rigid motion.
    """

    length, height = 81.0, 21.0  # mm
    youngs_modulus, poisson_ratio = 70000.0, 1 / 3  # MPa; central bonds have this ratio
    force = 1000.0  # N
    middle, second = 40.5, 67.5

    def __init__(self):
        self.second_moment = self.height**3 / 12
        self.compliance = self.force / (self.youngs_modulus * self.second_moment)
        shear_modulus = self.youngs_modulus / 2 / (1 + self.poisson_ratio)
        self.shear = self.force / (2 * shear_modulus * self.second_moment)
        self.base, at_second = self._free(self.middle, 0.0), self._free(self.second, 0.0)
        self.turn = (at_second[1] - self.base[1]) / (self.second - self.middle)

    def _free(self, x, y):
        nu, rest, c = self.poisson_ratio, self.length - x, self.height / 2
        u = -self.compliance * (x * (self.length - x / 2) * y - nu * y**3 / 6) - self.shear * y**3 / 3
        v = self.compliance * (nu * rest * y * y / 2 + x * x * (self.length / 2 - x / 6)) + self.shear * c * c * x
        return u, v

    def displacement(self, x, y):
        """At x from the left end and y from the lower edge."""
        y = y - self.height / 2
        u, v = self._free(x, y)
        return u - self.base[0] + self.turn * y, v - self.base[1] - self.turn * (x - self.middle)

    def stress(self, x, y):
        """Along the beam and of shear, the two that are not zero; the largest is at the left end, on both edges."""
        y = y - self.height / 2
        along = -self.force * (self.length - x) * y / self.second_moment
        return along, self.force / (2 * self.second_moment) * ((self.height / 2) ** 2 - y * y) + 0.0 * x

    def largest_stress(self):
        return self.force * self.length * self.height / 2 / self.second_moment

    def traction(self, right, y):
        """Force per area on the right or on the left end."""
        y = y - self.height / 2
        shear = self.force / (2 * self.second_moment) * ((self.height / 2) ** 2 - y * y)
        return (0.0 * y, shear) if right else (self.force * self.length * y / self.second_moment, -shear)


class Hole:
    """A quarter of a strip with a round hole, pulled at its end; symmetry on the two sides through the hole.

    Asked are the stress at the top of the hole and how far the middle of the end moves, as elements of second order have
    them in the limit (`pareto_hole.py reference`).
    """

    size, radius, traction = (200.0, 80.0), 20.0, 100.0  # length and half height, mm; mm; MPa

    def __init__(self, name):
        self.material, self.finer, self.moved, self.stress = HOLES[name]

    @property
    def stiffness(self):
        """From strains to stresses of plane stress, MPa, fibres along x."""
        along, across, poisson, shear = self.material
        share = 1 / (1 - poisson**2 * across / along)
        coupling = poisson * across * share
        return (along * share, coupling, 0.0), (coupling, across * share, 0.0), (0.0, 0.0, shear)


HOLES = {  # moduli along and across, Poisson's ratio, shear modulus, MPa; gradings of elements; mm and MPa of the answers
    "isotropic": ((70000.0, 70000.0, 1 / 3, 26250.0), (0.0, 2.0), 0.30418786, 324.8238),
    "laminate": ((140000.0, 10000.0, 0.25, 2930.0), (3.0, 4.0), 0.212543, 950.52),
}
