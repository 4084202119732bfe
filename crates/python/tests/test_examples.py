"""The examples of the guide run as they are shown."""

from __future__ import annotations

import runpy
from pathlib import Path

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
