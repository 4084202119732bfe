"""Convergence studies."""

from __future__ import annotations

import html
import json
import warnings
from collections.abc import Mapping
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any, Optional, Union

from . import _peristat
from ._case import Case, checked_threads, given
from ._errors import Fault, PeristatWarning, missing

if TYPE_CHECKING:
    import pandas


class Study:
    """What a study found."""

    def __init__(self, findings: dict[str, Any], faults: list[Fault]) -> None:
        self.findings = findings
        """Everything that `study.json` has: series with their levels, quantities, orders and limits."""
        self.faults = faults
        """Why some tasks have no result; they were too large for the memory."""

    @property
    def expectations(self) -> list[dict[str, Any]]:
        """What the study had to find, what was found, and whether it passed."""
        return list(self.findings["expectations"])

    @property
    def passed(self) -> bool:
        """Whether every task was solved and converged, and every expectation is met."""
        unsolved = self.findings["missing"] or self.findings["not_converged"]
        return not unsolved and all(expectation["passed"] for expectation in self.expectations)

    @property
    def quantities(self) -> list[dict[str, Any]]:
        """Every quantity of every series: its values from coarse to fine, errors, orders, fit and limit, with the settings of the series."""
        return [{"settings": series["settings"], **quantity} for series in self.findings["series"] for quantity in series["quantities"]]

    @property
    def table(self) -> list[dict[str, Any]]:
        """One row per task: what was varied, the grid, and the values and errors that were measured."""
        rows = []
        for series in self.findings["series"]:
            for level in series["levels"]:
                grid = {key: level[key] for key in ("task", "spacing", "horizon", "points", "unknowns", "seconds")}
                values = {measured["name"]: measured["value"] for measured in level["values"]}
                errors = {f"error of {measured['name']}": measured["value"] for measured in level["errors"]}
                rows.append({**series["settings"], **grid, **values, **errors})
        return rows

    def to_pandas(self) -> pandas.DataFrame:
        """The table as a data frame; needs pandas."""
        try:
            import pandas
        except ImportError as error:
            raise missing("pandas", "pandas") from error
        return pandas.DataFrame(self.table)

    def __repr__(self) -> str:
        return f"<peristat.Study {self.findings['title']!r}: {self.findings['tasks']} tasks, {'passed' if self.passed else 'not passed'}>"

    def _repr_html_(self) -> str:
        rows = self.table
        names = list(dict.fromkeys(name for row in rows for name in row))

        def shown(value: Any) -> str:
            return html.escape(f"{value:.6g}" if isinstance(value, float) else str(value))

        head = "".join(f"<th>{html.escape(name)}</th>" for name in names)
        body = "".join("<tr>" + "".join(f"<td>{shown(row.get(name, ''))}</td>" for name in names) + "</tr>" for row in rows)
        title = html.escape(self.findings["title"])
        return f"<b>{title}</b>: {'passed' if self.passed else 'not passed'}<table><tr>{head}</tr>{body}</table>"


def study(
    study: Case,
    *,
    set: Optional[Mapping[str, Any]] = None,
    threads: Optional[int] = None,
    max_memory: Optional[int] = None,
    output: Optional[Union[str, PathLike[str]]] = None,
    force: bool = False,
    allow_outside: bool = False,
) -> Study:
    """Solve a case on many discretisations: orders of convergence, and extrapolated values.

    `study` is a dictionary, a path or JSON text; the `case` of a dictionary may be a dictionary, too. `threads` are tasks that are solved at
    the same time. `output` names a folder that keeps finished tasks: the same call goes on there after an interrupt. Paths
    are relative to the file of the study, to the working directory for a dictionary; `allow_outside` lets them leave its folder.

    Raises `CaseError`, `MemoryError`, `OSError`; warns with `PeristatWarning`.
    """
    if output is None and force:
        raise ValueError("`force` is about the folder of `output`, which is not given")
    folder = None if output is None else fspath(output)
    made_of = given(study, set, max_memory, allow_outside, "study")
    found, faults = _peristat.study(made_of, checked_threads(threads), folder, force)
    made = Study(json.loads(found), [Fault(**fault) for fault in json.loads(faults)])
    levels = [level for series in made.findings["series"] for level in series["levels"]]
    for text in dict.fromkeys(text for level in levels for text in level.get("warnings", [])):
        warnings.warn(text, PeristatWarning, stacklevel=2)
    for fault in made.faults:
        warnings.warn(f"{fault.tasks}: {fault.message}", PeristatWarning, stacklevel=2)
    return made
