"""The stiffness of a case in a solver of SciPy."""

import numpy as np
import peristat
from scipy.sparse.linalg import cg

operator = peristat.operator("cases/plate/cantilever.json", set={"body.rectangle.spacing": 4})
q, _ = cg(operator, operator.rhs())
u = operator.expand(q)                  # points x components, with what supports prescribe
print(operator.components, u[:, 1].max())
