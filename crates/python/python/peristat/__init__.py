"""Implicit static and quasi-static peridynamics.

A case is a dictionary of the keys that `peristat schema` describes, a path to a JSON file, or JSON text::

    import peristat

    result = peristat.run("cases/plate/cantilever.json", set={"body.rectangle.spacing": 2})
    result.probes["tip"], result.status, result.fields()["uy"]
"""

from ._case import Case
from ._errors import CaseError, Fault, Interrupted, NotConverged, PeristatWarning
from ._lists import models, schema
from ._operator import operator, stiffness
from ._peristat import __version__
from ._result import Result, Value
from ._solve import Verified, check, run, verify
from ._study import Study, study

__all__ = [
    "Case",
    "CaseError",
    "Fault",
    "Interrupted",
    "NotConverged",
    "PeristatWarning",
    "Result",
    "Study",
    "Value",
    "Verified",
    "__version__",
    "check",
    "models",
    "operator",
    "run",
    "schema",
    "stiffness",
    "study",
    "verify",
]
