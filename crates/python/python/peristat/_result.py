"""What a run found."""

from __future__ import annotations

import json
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ._peristat import Solved


class Result:
    """A solved case. All numbers are in the units of the case."""

    def __init__(self, solved: Solved) -> None:
        self._solved = solved

    @cached_property
    def summary(self) -> dict[str, Any]:
        """The record of the run, as `summary.json` has it."""
        found: dict[str, Any] = json.loads(self._solved.summary())
        return found

    @property
    def status(self) -> str:
        """`passed`, `check_failed` or `not_converged`."""
        return str(self.summary["status"])

    @property
    def checks(self) -> list[dict[str, Any]]:
        """Every check with what it expected, what was found, and whether it passed."""
        return list(self.summary["checks"])

    @property
    def certificate(self) -> dict[str, Any]:
        """The certificate of the last state: convergence, digits to trust, balance of forces, resultants."""
        return dict(self.summary["states"][-1]["certificate"])

    @cached_property
    def probes(self) -> dict[str, float]:
        """Values of the probes in the last state, by name."""
        return {probe["name"]: probe["value"] for probe in self.summary["probes"]}

    @property
    def states(self) -> list[str]:
        """Names of the recorded states."""
        return self._solved.states()

    @cached_property
    def curve(self) -> dict[str, NDArray[np.float64]]:
        """Every equilibrium of a body that breaks or softens: load factor, load, energies, broken bonds and the other columns of
        `curve.csv`, one array each; empty for elastic bodies."""
        rows = json.loads(self._solved.curve())
        return {key: np.array([row[key] for row in rows]) for key in (rows[0] if rows else {})}

    @cached_property
    def points(self) -> NDArray[np.float64]:
        """Positions of all points, n x 3."""
        return self._solved.points()

    @cached_property
    def volumes(self) -> NDArray[np.float64] | None:
        """Volumes of all points; None where the case gives stiffnesses and no areas."""
        return self._solved.volumes()

    def field(self, name: str, state: int | str = -1) -> NDArray[np.float64]:
        """A field at all points in a state, by its name or number; the last one if not given. Raises `KeyError`."""
        return self._solved.field(self._number(state), name)

    def fields(self, state: int | str = -1) -> dict[str, NDArray[np.float64]]:
        """All fields of a state by name."""
        number = self._number(state)
        return {name: self._solved.field(number, name) for name in self._solved.fields(number)}

    def _number(self, state: int | str) -> int:
        names = self.states
        if isinstance(state, str):
            if state not in names:
                raise KeyError(f"there is no state `{state}`; there are {', '.join(names)}")
            return names.index(state)
        if not -len(names) <= state < len(names):
            raise KeyError(f"there is no state {state}: there are {len(names)}")
        return state % len(names)

    def __repr__(self) -> str:
        title = self.summary["title"]
        return f"<peristat.Result {title!r}: {self.status}, {len(self.points)} points, {len(self.states)} states>"
