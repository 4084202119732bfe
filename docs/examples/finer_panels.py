"""A case as a dictionary, on finer and finer grids."""

import numpy as np
import peristat

panel = {
    "title": "panel", "units": "mm-N-MPa",
    "model": {"bond_plane": {"youngs_modulus": 70000, "state": "plane_stress"}},
    "body": {"rectangle": {"size": [40, 20], "spacing": 1}},
    "supports": [{"at": {"region": "left"}, "ux": 0}, {"at": {"x": 0.5, "y": 0.5}, "uy": 0}],
    "loads": [{"traction": {"edge": "right", "uniform": [100, 0]}}],
}
for spacing in (4, 2, 1):
    result = peristat.run(panel, set={"body.rectangle.spacing": spacing})
    print(spacing, np.abs(result.field("ux") - result.points[:, 0] / 700).max())
