"""Cases in whichever form they are given, checked and solved."""

from __future__ import annotations

import json
import warnings
from collections.abc import Callable, Mapping
from os import PathLike, fspath
from pathlib import Path
from typing import Any, NamedTuple, Optional, Union

from . import _peristat
from ._errors import Fault, NotConverged, PeristatWarning
from ._result import Result

Case = Union[Mapping[str, Any], str, "PathLike[str]"]
"""A dictionary, a path, or JSON text, which begins with `{`."""


class _Given(NamedTuple):
    text: str
    name: str
    folder: str
    overrides: list[str]
    max_memory: Optional[int]


def _json(value: Any) -> str:
    """Values of NumPy, which have a `tolist`, are those of Python."""
    return json.dumps(value, default=lambda other: other.tolist() if hasattr(other, "tolist") else dict(other))


def _given(case: Case, set: Optional[Mapping[str, Any]], max_memory: Optional[int]) -> _Given:
    overrides = [f"{path}={_json(value)}" for path, value in (set or {}).items()]
    if isinstance(case, Mapping):
        return _Given(_json(case), "case", ".", overrides, max_memory)
    if isinstance(case, str) and case.lstrip().startswith("{"):
        return _Given(case, "case", ".", overrides, max_memory)
    path = Path(fspath(case))
    return _Given(path.read_text(encoding="utf-8"), str(path), str(path.parent), overrides, max_memory)


def run(
    case: Case,
    *,
    set: Optional[Mapping[str, Any]] = None,
    threads: Optional[int] = None,
    max_memory: Optional[int] = None,
    on_state: Optional[Callable[[str, float], Optional[bool]]] = None,
) -> Result:
    """Solve a case.

    `set` replaces values by their paths, such as `{"body.rectangle.spacing": 2}`; `threads` are all cores if not given; `max_memory` is in
    bytes. `on_state(name, load_factor)` is called for every recorded state; a body that breaks ends after it with `Interrupted` if it
    returns `False`. Ctrl-C ends the call within a second. A failed check is no exception: see `Result.status`.

    Raises `CaseError`, `NotConverged`, `MemoryError`; warns with `PeristatWarning`.
    """
    result = Result(_peristat.run(_given(case, set, max_memory), threads, on_state))
    for text in result.summary["warnings"]:
        warnings.warn(text, PeristatWarning, stacklevel=2)
    if result.status == "not_converged":
        raise NotConverged(result)
    return result


def check(
    case: Case, *, set: Optional[Mapping[str, Any]] = None, max_memory: Optional[int] = None
) -> tuple[dict[str, Any], list[Fault]]:
    """Build a case without solving it: its sizes (points, bonds, unknowns, estimated bytes) and its warnings.

    Raises `CaseError`, `MemoryError`.
    """
    found, sizes = _peristat.check(_given(case, set, max_memory))
    return json.loads(sizes), [Fault(*fault) for fault in found]
