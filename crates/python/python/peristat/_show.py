"""Results as pictures, pages and meshes of other libraries."""

from __future__ import annotations

import base64
import html
import io
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from ._errors import missing

if TYPE_CHECKING:
    import matplotlib.axes
    import meshio
    import pyvista
    from matplotlib.collections import Collection
    from numpy.typing import NDArray

    from ._result import Result

# Fields that a page shows, the first that there is.
SHOWN = ("von_mises", "damage", "ux", "w", "uy")


def plot(result: Result, field: str, state: int, deformed: float, ax: Optional[matplotlib.axes.Axes]) -> matplotlib.axes.Axes:
    """Draws a field with Matplotlib."""
    try:
        import matplotlib.pyplot as plt
    except ImportError as error:
        raise missing("Matplotlib", "plot") from error
    values, unit = result.field(field, state), result.unit(field)
    label = f"{field} [{unit}]" if unit else field
    if ax is None:
        ax = plt.subplots()[1]
    places = result.points + deformed * displacements(result, state)
    if np.ptp(result.points[:, 1:]) == 0.0:
        ax.plot(places[:, 0], values)
        ax.set_xlabel("x")
        ax.set_ylabel(label)
        return ax
    flat = np.ptp(places[:, 2]) == 0.0
    # Solids are seen from the front.
    order = np.arange(len(values)) if flat else np.argsort(places[:, 2])
    ax.set_aspect("equal")
    ax.set_xlabel("x")
    ax.set_ylabel("y")
    drawn = cells_of(result, places[order], ax)
    drawn.set_array(values[order])
    ax.figure.colorbar(drawn, ax=ax, label=label)
    return ax


def cells_of(result: Result, places: NDArray[np.float64], ax: matplotlib.axes.Axes) -> Collection:
    """Squares of the size of cells, or dots for the points of a frame."""
    from matplotlib.collections import PolyCollection

    spacing = result.summary["model"].get("spacing")
    if not isinstance(spacing, (int, float)):
        return ax.scatter(places[:, 0], places[:, 1], s=16.0)
    corners = 0.5 * spacing * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    # Lines of the colour of the cells leave no gaps, where they are stretched, too.
    squares = PolyCollection(list(places[:, None, :2] + corners), edgecolors="face", linewidths=1.5)
    ax.add_collection(squares)
    ax.autoscale_view()
    return squares


def displacements(result: Result, state: int) -> NDArray[np.float64]:
    """Displacements of all points along x, y and z; those of a beam are across it."""
    fields, moved = result.fields(state), np.zeros_like(result.points)
    for axis, names in enumerate((("ux", "u"), ("uy", "w"), ("uz",))):
        for name in names:
            if name in fields:
                moved[:, axis] = fields[name]
    return moved


def grid(result: Result, state: int, read: Any) -> Any:
    """What a library reads of the grid that a results folder has of a state."""
    with tempfile.TemporaryDirectory() as folder:
        result.save(Path(folder) / "results")
        return read(str(Path(folder) / "results" / "fields" / f"step_{state:03}.vtu"))


def to_meshio(result: Result, state: int) -> meshio.Mesh:
    """A state as a mesh of meshio."""
    try:
        import meshio
    except ImportError as error:
        raise missing("meshio", "meshio") from error
    return grid(result, state, meshio.read)


def to_pyvista(result: Result, state: int) -> pyvista.DataSet:
    """A state as a data set of PyVista."""
    try:
        import pyvista
    except ImportError as error:
        raise missing("PyVista", "pyvista") from error
    return grid(result, state, pyvista.read)


def html_of(result: Result) -> str:
    """A result as notebooks show it: checks, probes, certificate, and a figure where Matplotlib is there."""
    parts = [f"<b>{html.escape(result.summary['title'])}</b>: {result.status}, {len(result.points)} points"]
    if result.probes:
        rows = [(name, repr(value), error_of(result, name)) for name, value in result.probes.items()]
        parts.append(table(("probe", "value", "estimated error"), rows))
    if result.checks:
        keys = ("expected", "found", "error", "tolerance")
        verdicts = ["passed" if check["passed"] else "FAILED" for check in result.checks]
        numbers = [[check["name"], *(f"{check[key]:.6g}" for key in keys)] for check in result.checks]
        parts.append(table(("check", *keys, ""), [[*row, verdict] for row, verdict in zip(numbers, verdicts)]))
    certificate = result.certificate
    trusted = f"{certificate['digits']} digits of the solution of the discrete equations" if certificate["converged"] else "not converged"
    parts.append(f"<div>certificate: {trusted}</div>")
    parts.append(figure(result))
    return "".join(parts)


def error_of(result: Result, probe: str) -> str:
    """The estimated error of a probe in words."""
    estimate = result.estimate.get(probe)
    relative = None if estimate is None else estimate.get("relative")
    return "" if relative is None else f"{100 * relative:.2g} %"


def cells(texts: Sequence[str], tag: str) -> str:
    """A row of a table."""
    return "<tr>" + "".join(f"<{tag}>{html.escape(text)}</{tag}>" for text in texts) + "</tr>"


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table of texts."""
    return f"<table>{cells(head, 'th')}{''.join(cells(row, 'td') for row in rows)}</table>"


def figure(result: Result) -> str:
    """A picture of a field, nothing without Matplotlib."""
    try:
        from matplotlib.figure import Figure
    except ImportError:
        return ""
    known = result.fields()
    shown = next((field for field in SHOWN if field in known), None)
    if shown is None:
        return ""
    drawing = Figure(figsize=(6.0, 3.5), layout="constrained")
    plot(result, shown, len(result.states) - 1, 0.0, drawing.add_subplot())
    picture = io.BytesIO()
    drawing.savefig(picture, format="png")
    return f'<img alt="{shown}" src="data:image/png;base64,{base64.b64encode(picture.getvalue()).decode()}">'
