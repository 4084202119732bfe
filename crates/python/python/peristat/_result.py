"""What a run found."""

from __future__ import annotations

import json
from functools import cached_property
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any, NoReturn, Optional, Union

import numpy as np

from . import _show

if TYPE_CHECKING:
    import matplotlib.axes
    import meshio
    import pyvista
    from numpy.typing import NDArray

    from ._peristat import Solved


class Value(float):
    """A number with its `unit`, such as `mm`; empty where it has none."""

    unit: str

    def __new__(cls, value: float, unit: str = "") -> Value:
        made = super().__new__(cls, value)
        made.unit = unit
        return made

    def __reduce__(self) -> tuple[type[Value], tuple[float, str]]:
        return type(self), (float(self), self.unit)

    def __repr__(self) -> str:
        return f"{float(self)!r} {self.unit}".rstrip()

    # Texts and tables take numbers.
    __str__ = float.__repr__


class Result:
    """A solved case. All numbers are in the units of the case; points and states are in the order of `points` and `states`."""

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
        return self._solved.status()

    @property
    def checks(self) -> list[dict[str, Any]]:
        """Every check with what it expected, what was found, and whether it passed."""
        return list(self.summary["checks"])

    @property
    def certificate(self) -> dict[str, Any]:
        """The certificate of the last state: convergence, digits to trust, balance of forces, resultants."""
        return dict(self.summary["states"][-1]["certificate"])

    @property
    def reactions(self) -> list[dict[str, Any]]:
        """Forces of the supports in the last state, each with its place."""
        return list(self.summary["states"][-1].get("reactions", []))

    @property
    def estimate(self) -> dict[str, dict[str, Any]]:
        """Estimated errors of discretisation of every probe and of the energy, by name; empty where none was made: then
        `summary.get("no_estimate")` says why, if one was asked for."""
        quantities = self.summary.get("estimate", {}).get("quantities", [])
        return {quantity["name"]: quantity for quantity in quantities}

    @cached_property
    def probes(self) -> dict[str, Value]:
        """Values of the probes in the last state, by name."""
        unit = self._solved.probe_unit
        return {probe["name"]: Value(probe["value"], unit(probe["name"]) or "") for probe in self.summary["probes"]}

    @property
    def states(self) -> list[str]:
        """Names of the recorded states."""
        return self._solved.states()

    @cached_property
    def curve(self) -> dict[str, NDArray[np.float64]]:
        """Every equilibrium of a body that breaks or softens: load factor, load, energies, broken bonds and more, one array each; empty
        for elastic bodies."""
        rows = json.loads(self._solved.curve())
        found = {key: np.array([row[key] for row in rows]) for key in (rows[0] if rows else {})}
        for values in found.values():
            values.setflags(write=False)
        return found

    @cached_property
    def points(self) -> NDArray[np.float64]:
        """Positions of all points, n x 3."""
        return self._solved.points()

    @cached_property
    def volumes(self) -> NDArray[np.float64] | None:
        """Volumes of all points; None where the case gives stiffnesses and no areas."""
        return self._solved.volumes()

    def unit(self, field: str) -> str:
        """The unit of a field of any body, such as `mm`; empty where it has none. Raises `KeyError`."""
        unit = self._solved.unit(field)
        if unit is None:
            raise KeyError(f"there is no field `{field}`")
        return unit

    def field(self, name: str, state: int | str = -1) -> NDArray[np.float64]:
        """A field at all points in a state, by its name or number; the last one if not given. The array may be the solver's own and cannot be
        written: `copy()` it to do so. Raises `KeyError`."""
        return self._solved.field(self._number(state), name)

    def fields(self, state: int | str = -1) -> dict[str, NDArray[np.float64]]:
        """All fields of a state by name."""
        number = self._number(state)
        return {name: self._solved.field(number, name) for name in self._solved.fields(number)}

    def save(self, folder: Union[str, PathLike[str]], *, force: bool = False) -> None:
        """Write the folder of results that the command writes: fields as `.vtu` and `.csv`, `summary.json`, pictures, `report.html`. `force`
        replaces an earlier run there. Raises `OSError`, and `RuntimeError` for a run that was resumed, whose folder has more than it."""
        self._solved.save(fspath(folder), force)

    def plot(
        self, field: str, state: int | str = -1, *, deformed: float = 0.0, ax: Optional[matplotlib.axes.Axes] = None
    ) -> matplotlib.axes.Axes:
        """Draw a field, over the length of a straight beam or on the points of a body, which `deformed` moves by so many times their
        displacements. Needs Matplotlib."""
        return _show.plot(self, field, self._number(state), deformed, ax)

    def to_meshio(self, state: int | str = -1) -> meshio.Mesh:
        """The cells and fields of a state as a mesh of meshio, which writes many formats. Needs meshio."""
        return _show.to_meshio(self, self._number(state))

    def to_pyvista(self, state: int | str = -1) -> pyvista.DataSet:
        """The cells and fields of a state as a data set of PyVista. Needs PyVista."""
        return _show.to_pyvista(self, self._number(state))

    def __reduce__(self) -> NoReturn:
        raise TypeError("a result lives in the process that solved the case: send what is needed of it, such as `probes`, or `save` it")

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

    def _repr_html_(self) -> str:
        return _show.html_of(self)
