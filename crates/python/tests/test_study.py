"""Studies, checks of many cases, and the command."""

from __future__ import annotations

import json
import multiprocessing
import pickle
import subprocess
import sys
from pathlib import Path
from typing import Any

import peristat
import pytest

CASES = Path(__file__).resolve().parents[3] / "cases"

BEAM: dict[str, Any] = {
    "title": "cantilever",
    "model": {
        "timoshenko_beam": {"youngs_modulus": 2e11, "poisson_ratio": 0.3, "section": {"rectangle": {"width": 0.05, "height": 0.05}}, "bond_law": "published"}
    },
    "body": {"line": {"length": 1.0, "cells": 24}},
    "supports": [{"at": {"x": 0.0}, "w": 0.0, "phi": 0.0}],
    "loads": [{"point": {"at": {"x": 1.0}, "force": 1000.0}}],
    "probes": [{"name": "tip", "at": {"x": 1.0}, "field": "w"}],
}

STUDY: dict[str, Any] = {"title": "orders", "case": BEAM, "refine": {"delta_convergence": {"factors": [1, 2, 4]}}}


def test_a_study_of_a_dictionary_has_orders_and_rows() -> None:
    study = peristat.study(STUDY)
    assert study.passed and not study.faults
    assert [row["points"] for row in study.table] == [25, 49, 97]
    tip = next(quantity for quantity in study.quantities if quantity["name"] == "tip")
    # F L^3/3EI + F L/kGA of this section.
    assert abs(tip["values"][-1] / 0.00320624 - 1) < abs(tip["values"][0] / 0.00320624 - 1)
    assert len(study.to_pandas()) == 3
    assert "<table>" in study._repr_html_() and "3 tasks" in repr(study)


def test_a_folder_keeps_finished_tasks(tmp_path: Path) -> None:
    first = peristat.study(STUDY, output=tmp_path / "study")
    again = peristat.study(STUDY, output=tmp_path / "study")
    assert [row["seconds"] for row in first.table] == [row["seconds"] for row in again.table]
    assert (tmp_path / "study" / "study.json").exists()


def test_faults_of_tasks_are_told_with_their_tasks() -> None:
    with pytest.raises(peristat.CaseError) as caught:
        peristat.study({**STUDY, "vary": [{"model.timoshenko_beam.poisson_ratio": [0.3, 0.7]}]})
    assert caught.value.faults[0].tasks is not None and "poisson_ratio" in str(caught.value)
    with pytest.raises(peristat.CaseError, match="refin"):
        peristat.study({**STUDY, "refin": {}})


def test_verify_answers_for_every_file(tmp_path: Path) -> None:
    outcomes = peristat.verify(CASES / "beam" / "cantilever.json")
    assert [(outcome.verdict, outcome.passed) for outcome in outcomes] == [("passed", True)]
    assert outcomes[0].checks[0]["passed"]
    (tmp_path / "bad.json").write_text(json.dumps({**BEAM, "titel": "x"}))
    (tmp_path / "good.json").write_text(json.dumps(BEAM))
    bad, good = peristat.verify(tmp_path)
    assert (bad.verdict, bad.passed, good.verdict) == ("error", False, "without checks")
    assert "titel" in bad.faults[0].message
    with pytest.raises(OSError, match="nowhere"):
        peristat.verify([tmp_path / "nowhere"])


def command(*arguments: str, cwd: Path | None = None) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-m", "peristat", *arguments], capture_output=True, text=True, cwd=cwd)


def test_the_package_brings_the_command(tmp_path: Path) -> None:
    assert command("--version").stdout.strip() == f"peristat {peristat.__version__}"
    assert command("verify", str(CASES / "beam" / "cantilever.json")).returncode == 0
    refused = command("rn")
    assert refused.returncode == 2 and "unrecognized subcommand" in refused.stderr
    (tmp_path / "bad.json").write_text(json.dumps({**BEAM, "titel": "x"}))
    told = json.loads(command("run", "bad.json", "--json", cwd=tmp_path).stdout)
    with pytest.raises(peristat.CaseError) as caught:
        peristat.run({**BEAM, "titel": "x"})
    fault = caught.value.faults[0]
    assert (told["faults"][0]["message"], told["faults"][0]["hint"]) == (fault.message, fault.hint)


def tip(force: float) -> float:
    """What a process of a pool does."""
    return float(peristat.run(BEAM, set={"loads[0].point.force": force}, estimate=False).probes["tip"])


def test_forked_processes_solve_what_their_parent_solves() -> None:
    expected = [tip(force) for force in (1.0, 2.0)]
    with multiprocessing.get_context("fork").Pool(2) as pool:
        assert pool.map_async(tip, [1.0, 2.0]).get(timeout=60) == expected


def test_exceptions_and_values_go_from_process_to_process() -> None:
    result = peristat.run(BEAM)
    value = pickle.loads(pickle.dumps(result.probes["tip"]))
    assert (value, value.unit) == (result.probes["tip"], "m") and repr(value).endswith(" m")
    with pytest.raises(peristat.CaseError) as caught:
        peristat.run({**BEAM, "titel": "x"})
    assert pickle.loads(pickle.dumps(caught.value)).faults == caught.value.faults
    with pytest.raises(TypeError, match="send what is needed"):
        pickle.dumps(result)
    lost = pickle.loads(pickle.dumps(peristat.NotConverged(result)))
    with pytest.raises(RuntimeError, match="stayed in the process"):
        lost.result


def many_in_a_child(_: int) -> str:
    """What a forked process says of a study."""
    try:
        peristat.study(STUDY)
    except RuntimeError as error:
        return str(error)
    return "solved"


def test_a_forked_process_refuses_what_would_hang(tmp_path: Path) -> None:
    peristat.study(STUDY)
    peristat.run(BEAM).save(tmp_path / "saved")
    with multiprocessing.get_context("fork").Pool(1) as pool:
        assert "spawn" in pool.map_async(many_in_a_child, [0]).get(timeout=60)[0]


def test_a_callback_may_solve_a_case_itself() -> None:
    tips: list[float] = []

    def inner(name: str, load_factor: float) -> None:
        peristat.run(BEAM, on_state=lambda name, factor: tips.append(tip(2.0)))

    assert peristat.run(BEAM, on_state=inner).status == "passed" and len(tips) == 1


def test_numbers_become_texts_without_their_units() -> None:
    value = peristat.run(BEAM).probes["tip"]
    assert float(str(value)) == value == float(f"{value}")


def test_files_outside_are_read_where_that_is_allowed(tmp_path: Path) -> None:
    (tmp_path / "study").mkdir()
    (tmp_path / "case.json").write_text(json.dumps(BEAM))
    file = tmp_path / "study" / "orders.json"
    file.write_text(json.dumps({**STUDY, "case": "../case.json"}))
    with pytest.raises(peristat.CaseError, match="`allow_outside=True`"):
        peristat.study(file)
    assert peristat.study(file, allow_outside=True).passed


def test_a_study_warns_of_what_its_runs_doubt() -> None:
    # A tip force that turns the beam by more than 5 degrees.
    with pytest.warns(peristat.PeristatWarning, match="not small"):
        peristat.study(STUDY, set={"loads[0].point.force": 1e6})
