"""Implicit static and quasi-static peridynamics.

A case is a dictionary of the keys that `peristat schema` describes, a path to a JSON file, or JSON text::

    import peristat

    result = peristat.run("cases/plate/cantilever.json", set={"body.rectangle.spacing": 2})
    result.probes["tip"], result.status, result.fields()["uy"]
"""

from ._case import Case, check, run
from ._errors import CaseError, Fault, Interrupted, NotConverged, PeristatWarning
from ._peristat import __version__
from ._peristat import models as _models
from ._peristat import schema as _schema
from ._result import Result

__all__ = [
    "Case",
    "CaseError",
    "Fault",
    "Interrupted",
    "NotConverged",
    "PeristatWarning",
    "Result",
    "__version__",
    "check",
    "models",
    "run",
    "schema",
]


def models() -> dict[str, str]:
    """All models by name, each with a sentence on what it is."""
    return dict(_models())


def schema() -> dict[str, object]:
    """The JSON schema of cases."""
    import json

    found: dict[str, object] = json.loads(_schema())
    return found
