"""The stiffness as an operator of SciPy."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import peristat
import pytest
from scipy.sparse import diags
from scipy.sparse.linalg import eigsh, spsolve

CASES = Path(__file__).resolve().parents[3] / "cases"

BLOCK: dict[str, Any] = {
    "title": "free block",
    "model": {"bond_solid": {"youngs_modulus": 1.0}},
    "body": {"block": {"size": [4, 3, 3], "spacing": 0.5}},
    "loads": [],
}

SECTION = {"rectangle": {"width": 0.01, "height": 0.01}}
BEAM: dict[str, Any] = {
    "title": "free beam",
    "model": {"timoshenko_beam": {"youngs_modulus": 2e11, "poisson_ratio": 0.3, "section": SECTION}},
    "body": {"line": {"length": 1.0, "cells": 200}},
    "loads": [],
}


@pytest.mark.parametrize(
    "name",
    ["beam/cantilever.json", "beam/settlement_end.json", "frame/portal.json", "plate/cantilever.json", "plate/inclined_roller.json", "plate/crack_tips.json", "plate/shear.json", "solid/springs.json", "solid/bent_bar.json"],
)
def test_scipy_solves_what_peristat_solves(name: str) -> None:
    case = CASES / name
    if not case.exists():
        pytest.fail(f"there is no {case}")
    operator, result = peristat.operator(case), peristat.run(case)
    q = spsolve(operator.matrix().tocsc(), operator.rhs())
    found, expected = operator.expand(q), np.stack([result.field(name) for name in operator.components], axis=1)
    is_known = ~np.isnan(found)
    assert is_known.all() or name.startswith("frame/")
    # Both solve the same equations: conditioning is what parts them, 1e-10 at most here.
    assert np.abs(found - expected)[is_known].max() <= 1e-8 * np.abs(expected).max()


@pytest.mark.parametrize("name", ["beam/cantilever.json", "frame/portal.json", "plate/cantilever.json"])
def test_the_operator_is_its_matrix(name: str) -> None:
    operator = peristat.operator(CASES / name)
    q = np.random.default_rng(1).standard_normal(operator.shape[0])
    matrix = peristat.stiffness(CASES / name)
    assert np.abs(operator @ q - matrix @ q).max() <= 1e-12 * np.abs(matrix @ q).max()
    assert abs(matrix - matrix.T).max() <= 1e-12 * abs(matrix).max()
    assert operator.unknowns.shape == (len(q), 2)


def test_a_free_solid_has_six_zero_modes() -> None:
    operator = peristat.operator(BLOCK)
    values = np.sort(eigsh(operator.matrix(), k=8, sigma=-1e-3, which="LM", return_eigenvectors=False))
    assert np.abs(values[:6]).max() < 1e-10 * values[6], values


def test_the_first_frequency_of_a_free_beam() -> None:
    operator = peristat.operator(BEAM)
    density, side = 7850.0, 0.01
    points, components = operator.unknowns.T
    length = np.full(201, 1 / 200)
    length[[0, -1]] /= 2
    area, inertia = side**2, side**4 / 12
    mass = density * length[points] * np.where(components == 0, area, inertia)
    scale = 1 / np.sqrt(mass)
    scaled = diags(scale) @ operator.matrix() @ diags(scale)
    values = np.sort(eigsh(scaled, k=3, sigma=-1e3, which="LM", return_eigenvectors=False))
    # Two rigid motions, then (4.73004/L)^2 sqrt(EI/(rho A)).
    frequency = np.sqrt(values[2])
    assert frequency == pytest.approx(4.730040745**2 * np.sqrt(2e11 * inertia / (density * area)), rel=0.01)


def test_wrong_vectors_and_states_are_refused() -> None:
    operator = peristat.operator(CASES / "beam/cantilever.json")
    with pytest.raises(ValueError, match="dimension mismatch|shape"):
        operator @ np.ones(3)
    with pytest.raises(ValueError, match="unknowns"):
        operator.expand(np.ones(3))
    with pytest.raises(IndexError, match="no state 5"):
        operator.rhs(5)
    with pytest.raises(MemoryError):
        peristat.stiffness(CASES / "plate/cantilever.json", max_memory=1_000_000)
