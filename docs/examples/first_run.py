"""A case that is solved, and what its result has."""

import peristat

result = peristat.run("cases/plate/cantilever.json", set={"body.rectangle.spacing": 2})
result.status                # 'check_failed': the check of this case is for a finer grid
result.probes["tip"]         # 0.0216588... mm
result.field("uy")           # one value per point, in the order of result.points
result.certificate["converged"]
