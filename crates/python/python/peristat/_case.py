"""Cases in whichever form they are given."""

from __future__ import annotations

import os
from collections.abc import Mapping
from decimal import Decimal
from numbers import Real
from operator import index
from os import PathLike, fspath
from pathlib import Path
from typing import Any, NamedTuple, Optional, Union

import numpy as np

from . import _peristat

Case = Union[Mapping[str, Any], str, "PathLike[str]"]
"""A dictionary, a path, or JSON text, which begins with `{`."""


class Given(NamedTuple):
    """A case or a study as the native half takes it."""

    text: str
    file: str
    base: Optional[str]
    overrides: list[str]
    max_memory: Optional[int]
    allow_outside: bool


def json_of(value: Any) -> str:
    """JSON, with the numbers and arrays of NumPy as those of Python. Raises `TypeError`, or `ValueError` for what is no finite number."""
    return _peristat.json_text(value, plain)


def plain(other: Any) -> Any:
    """What JSON has of a value that is none of its own. Raises `TypeError`."""
    if isinstance(other, np.ndarray):
        return other.tolist()
    if isinstance(other, (np.integer, np.bool_)):
        return other.item()
    if isinstance(other, (np.floating, Real, Decimal)):
        return float(other)
    if isinstance(other, Mapping):
        return dict(other)
    if isinstance(other, PathLike):
        return fspath(other)
    raise TypeError(f"a case holds numbers, texts, lists and dictionaries, found {other!r}")


def given(
    case: Case, set: Optional[Mapping[str, Any]], max_memory: Optional[int], allow_outside: bool, what: str = "case"
) -> Given:
    """A case as the native half takes it; a study may bring its base case along under `case`."""
    overrides = [f"{path}={json_of(value)}" for path, value in (set or {}).items()]
    limits = checked_memory(max_memory), allow_outside
    if isinstance(case, Mapping):
        base = case.get("case")
        if what == "study" and isinstance(base, Mapping):
            return Given(json_of({**case, "case": "case"}), what, json_of(base), overrides, *limits)
        return Given(json_of(case), what, None, overrides, *limits)
    if isinstance(case, str) and case.lstrip().startswith("{"):
        return Given(case, what, None, overrides, *limits)
    path = Path(fspath(case))
    # A mark of byte order is no part of the text.
    return Given(path.read_text(encoding="utf-8-sig"), str(path), None, overrides, *limits)


def checked_memory(limit: Optional[int]) -> Optional[int]:
    """A limit on memory as the native half takes it."""
    if limit is not None and not 1 <= index(limit) < 2**64:
        raise ValueError(f"`max_memory` is a number of bytes, found {limit}")
    return limit


def checked_threads(count: Optional[int]) -> Optional[int]:
    """A number of threads as the native half takes it: more than there are cores help nobody."""
    if count is None:
        return None
    if index(count) < 1:
        raise ValueError(f"`threads` must be at least 1, found {count}")
    return min(index(count), os.cpu_count() or 1)
