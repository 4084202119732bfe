"""The examples of the guide run as they are shown."""

from __future__ import annotations

import runpy
from pathlib import Path

import peristat
import pytest

ROOT = Path(__file__).resolve().parents[3]


def test_the_first_run_has_what_the_page_shows(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    result = runpy.run_path(str(ROOT / "docs/examples/first_run.py"))["result"]
    page = (ROOT / "docs/src/python.md").read_text(encoding="utf-8")
    shown = page.split('result.probes["tip"]')[1].split("# ")[1].split("...")[0]
    assert str(abs(result.probes["tip"])).startswith(shown)
    assert result.status == "check_failed"


def test_finer_panels_are_exact_on_every_grid(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(ROOT)
    runpy.run_path(str(ROOT / "docs/examples/finer_panels.py"))
    rows = [line.split() for line in capsys.readouterr().out.splitlines()]
    assert [row[0] for row in rows] == ["4", "2", "1"]
    # 1e-14 measured.
    assert all(float(row[1]) < 1e-11 for row in rows)


def test_a_study_and_checks_run_from_the_root(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(ROOT)
    names = runpy.run_path(str(ROOT / "docs/examples/study_and_checks.py"))
    assert names["study"].passed
    assert all(outcome.passed for outcome in peristat.verify(ROOT / "cases/beam"))
    assert "passed" in capsys.readouterr().out


def test_another_solver_finds_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("scipy")
    monkeypatch.chdir(ROOT)
    names = runpy.run_path(str(ROOT / "docs/examples/own_solver.py"))
    expected = peristat.run("cases/plate/cantilever.json", set={"body.rectangle.spacing": 4}).field("uy")
    # The tolerance of `cg` is 1e-5 of the residual; 1e-6 measured.
    assert abs(names["u"][:, 1] - expected).max() < 1e-4 * abs(expected).max()


def test_results_are_read_without_a_package(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(tmp_path)
    result = peristat.run(ROOT / "cases/plate/breaking_plate.json", output="results/breaking_plate")
    names = runpy.run_path(str(ROOT / "docs/examples/read_results.py"))
    assert names["summary"]["fracture"]["facts"]["peak_load"] == max(result.curve["load"])
    assert len(names["curve"]["load"]) == 96 and names["worst"] < 1e-10
    assert len(names["broken"]) == 52
    assert "96 equilibria" in capsys.readouterr().out
