"""Solving cases."""

from __future__ import annotations

import json
import warnings
from collections.abc import Callable, Iterable, Mapping
from os import PathLike, fspath
from typing import Any, Literal, NamedTuple, Optional, Union

from . import _peristat
from ._case import Case, checked_memory, checked_threads, given
from ._errors import Fault, NotConverged, PeristatWarning
from ._result import Result


class Output(NamedTuple):
    """A folder of results as the native half takes it."""

    folder: str
    force: bool
    resume: bool
    fields: str
    field_files: str


class Verified(NamedTuple):
    """What came of one file."""

    case: str
    """The file."""
    verdict: str
    """`passed`, `failed`, `not converged`, `error`, `without checks` or `skipped`."""
    passed: bool
    """Whether nothing is wrong with it."""
    seconds: float
    """Time it took."""
    checks: list[dict[str, Any]]
    """Every check with what it expected, what was found, and whether it passed."""
    warnings: list[str]
    """Doubts about the case or its answer."""
    faults: list[Fault]
    """Faults of the case."""
    reason: Optional[str]
    """Why it was skipped."""


def run(
    case: Case,
    *,
    set: Optional[Mapping[str, Any]] = None,
    threads: Optional[int] = None,
    max_memory: Optional[int] = None,
    on_state: Optional[Callable[[str, float], Optional[bool]]] = None,
    estimate: Optional[bool] = None,
    output: Optional[Union[str, PathLike[str]]] = None,
    force: bool = False,
    resume: bool = False,
    fields: Literal["all", "last", "none"] = "all",
    field_files: Literal["both", "vtu", "csv"] = "both",
    allow_outside: bool = False,
) -> Result:
    """Solve a case.

    `set` replaces values by their paths, such as `{"body.rectangle.spacing": 2}`; `threads` are all cores if not given; `max_memory` is in
    bytes. `on_state(name, load_factor)` is called for every recorded state; the run ends after it with `Interrupted` if it returns `False`.
    `estimate=True` asks for errors of discretisation from a finer grid, `False` for none; otherwise those are made that are cheap.

    `output` names a folder that results are written to while the case is solved, as the command writes it: `force` replaces an earlier run
    there, `resume` goes on with an interrupted run of a body that breaks or softens (`Result.states` are then those of this call). `fields` are
    the states whose fields at all points are written into it, `field_files` the files that these are; the result has all of them. Ctrl-C ends
    the call within a second; a solve that has begun goes on unseen to its end. `allow_outside` lets the case name files outside its folder,
    which is the working directory for a dictionary. A failed check is no exception: see `Result.status`.

    Raises `CaseError`, `NotConverged`, `Interrupted`, `MemoryError`, `OSError`; warns with `PeristatWarning`.
    """
    for name, value, known in (("fields", fields, ("all", "last", "none")), ("field_files", field_files, ("both", "vtu", "csv"))):
        if value not in known:
            raise ValueError(f"`{name}` is one of {', '.join(map(repr, known))}, found {value!r}")
    folder = None if output is None else Output(fspath(output), force, resume, fields, field_files)
    if folder is None and (force or resume or fields != "all" or field_files != "both"):
        raise ValueError("`force`, `resume`, `fields` and `field_files` are about the folder of `output`, which is not given")
    solved = _peristat.run(given(case, set, max_memory, allow_outside), checked_threads(threads), on_state, estimate, folder)
    result = Result(solved)
    for text in solved.warnings():
        warnings.warn(text, PeristatWarning, stacklevel=2)
    if result.status == "not_converged":
        raise NotConverged(result)
    return result


def check(
    case: Case,
    *,
    set: Optional[Mapping[str, Any]] = None,
    max_memory: Optional[int] = None,
    allow_outside: bool = False,
) -> tuple[dict[str, Any], list[Fault]]:
    """Build a case without solving it: its sizes (points, bonds, unknowns, estimated bytes) and its warnings.

    Raises `CaseError`, `MemoryError`.
    """
    found, sizes = _peristat.check(given(case, set, max_memory, allow_outside))
    return json.loads(sizes), [Fault(**fault) for fault in json.loads(found)]


def verify(
    paths: Union[str, PathLike[str], Iterable[Union[str, PathLike[str]]]],
    *,
    all: bool = False,
    threads: Optional[int] = None,
    max_memory: Optional[int] = None,
    allow_outside: bool = False,
) -> list[Verified]:
    """Make the checks of case files, and of those in folders, side by side; `all` includes slow ones and those in `bench` folders.

    Faults of a case are part of its answer. Raises `OSError` where a path is not there.
    """
    files = [fspath(paths)] if isinstance(paths, (str, PathLike)) else [fspath(path) for path in paths]
    outcomes = json.loads(_peristat.verify(files, all, checked_threads(threads), checked_memory(max_memory), allow_outside))
    return [Verified(**{**outcome, "faults": [Fault(**f) for f in outcome["faults"]]}) for outcome in outcomes]
