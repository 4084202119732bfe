"""What there is."""

from __future__ import annotations

import json
from typing import Any

from . import _peristat


def models() -> dict[str, str]:
    """All models by name, each with a sentence on what it is."""
    return dict(_peristat.models())


def schema(*, study: bool = False) -> dict[str, Any]:
    """The JSON schema of cases, or of studies."""
    found: dict[str, Any] = json.loads(_peristat.schema(study))
    return found
