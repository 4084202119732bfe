"""Folders, pictures, meshes, and runs that are ended."""

from __future__ import annotations

import gc
import os
import signal
import threading
import time
from pathlib import Path
from typing import Any

import numpy as np
import peristat
import pytest

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
CASES = Path(__file__).resolve().parents[3] / "cases"
PLATE = CASES / "plate" / "cantilever.json"
COARSE = {"body.rectangle.spacing": 4, "checks": []}


def test_a_result_is_saved_as_the_command_saves_it(tmp_path: Path) -> None:
    result = peristat.run(PLATE, set=COARSE, output=tmp_path / "written")
    result.save(tmp_path / "saved")
    names = [sorted(str(p.relative_to(tmp_path / f)) for p in (tmp_path / f).rglob("*") if p.is_file()) for f in ("written", "saved")]
    assert names[0] == names[1] and "report.html" in names[0]
    with pytest.raises(FileExistsError, match="force"):
        result.save(tmp_path / "saved")
    result.save(tmp_path / "saved", force=True)
    with pytest.raises(ValueError, match="output"):
        peristat.run(PLATE, set=COARSE, force=True)


def test_fields_are_written_of_the_states_and_as_the_files_asked_for(tmp_path: Path) -> None:
    def written(name: str, **asked: Any) -> set[str]:
        peristat.run(PLATE, set=COARSE, output=tmp_path / name, **asked)
        return {path.suffix for path in (tmp_path / name / "fields").glob("*")}

    assert written("both") >= {".csv", ".vtu"}
    assert ".csv" not in written("vtu", field_files="vtu", fields="last")
    assert ".vtu" not in written("csv", field_files="csv")
    assert not written("none", fields="none")
    unknown: list[dict[str, Any]] = [{"fields": "some"}, {"field_files": "xml"}]
    for wrong in unknown:
        with pytest.raises(ValueError, match="is one of"):
            peristat.run(PLATE, set=COARSE, output=tmp_path / "wrong", **wrong)
    with pytest.raises(ValueError, match="which is not given"):
        peristat.run(PLATE, set=COARSE, fields="none")


def test_fields_are_the_solvers_own_and_not_to_be_written() -> None:
    result = peristat.run(PLATE, set=COARSE)
    first, second = result.field("ux"), result.field("ux")
    assert first.__array_interface__["data"] == second.__array_interface__["data"]
    for values in (first, result.points, result.volumes, result.field("von_mises")):
        assert values is not None
        with pytest.raises(ValueError, match="read-only"):
            values[:] = 0
    kept = result.field("uy")
    expected = kept.copy()
    del result
    assert np.array_equal(kept, expected)


@pytest.mark.parametrize("name", ["beam/cantilever.json", "frame/portal.json", "plate/plate_with_hole.json", "solid/tension.json"])
def test_a_result_shows_itself(name: str) -> None:
    result = peristat.run(CASES / name)
    page = result._repr_html_()
    assert "certificate" in page and "data:image/png" in page
    assert result.plot(next(iter(result.fields())), deformed=10) is not None
    matplotlib.pyplot.close("all")


def test_grids_go_to_meshio() -> None:
    pytest.importorskip("meshio")
    result = peristat.run(PLATE, set=COARSE)
    mesh = result.to_meshio()
    arrays = {**mesh.point_data, **{key: values[0] for key, values in mesh.cell_data.items()}}
    assert any(len(values) == 200 for values in arrays.values())


def test_errors_are_estimated() -> None:
    assert peristat.run(PLATE, set=COARSE).estimate["tip"]["error"] > 0
    assert peristat.run(PLATE, set=COARSE, estimate=False).estimate == {}
    assert peristat.run(PLATE, set=COARSE, estimate=True).estimate["tip"]["error"] > 0


def test_a_run_that_is_interrupted_goes_on(tmp_path: Path) -> None:
    case = CASES / "plate" / "breaking_batch.json"
    folder = tmp_path / "run"
    whole = peristat.run(case, output=tmp_path / "whole")
    seen: list[str] = []

    def two(name: str, load_factor: float) -> bool:
        seen.append(name)
        return len(seen) < 2

    with pytest.raises(peristat.Interrupted):
        peristat.run(case, on_state=two, output=folder)
    assert (folder / "restart.bin").exists()
    resumed = peristat.run(case, output=folder, resume=True)
    for key, values in whole.curve.items():
        assert np.array_equal(values, resumed.curve[key]), key
    with pytest.raises(RuntimeError, match="resumed"):
        resumed.save(tmp_path / "part")


def test_a_run_of_load_cases_ends_where_it_is_told_to() -> None:
    seen: list[str] = []

    def first(name: str, load_factor: float) -> bool:
        seen.append(name)
        return False

    with pytest.raises(peristat.Interrupted):
        peristat.run(CASES / "beam" / "load_cases.json", on_state=first)
    assert len(seen) == 1


def test_ctrl_c_ends_a_run_within_a_second() -> None:
    calls: list[str] = []
    case = CASES / "plate" / "breaking_batch.json"
    # Jobs in the background begin with this signal ignored, which Python leaves as it is.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    # Python drops what is raised in a finalizer, of figures of other tests too: a signal must not meet one.
    gc.collect()
    gc.disable()
    late = time.monotonic() + 20
    try:
        with pytest.raises(KeyboardInterrupt):
            while time.monotonic() < late:
                peristat.run(case, on_state=lambda name, factor: calls.append(name))
    finally:
        gc.enable()
        signal.signal(signal.SIGINT, before)
    known = len(calls)
    time.sleep(0.3)
    assert len(calls) == known


def test_limits_are_checked() -> None:
    with pytest.raises(ValueError, match="at least 1"):
        peristat.run(PLATE, threads=0)
    with pytest.raises(MemoryError):
        peristat.run(PLATE, max_memory=1)
    with pytest.raises(ValueError, match="bytes"):
        peristat.run(PLATE, max_memory=-1)
    with pytest.raises(ValueError):
        peristat.run(PLATE, set={"body.rectangle.spacing": float("nan")})
    with pytest.raises(TypeError, match="object"):
        peristat.run(PLATE, set={"title": object()})
    peristat.run(PLATE, set={**COARSE, "body.rectangle.spacing": np.float32(4)}, threads=10**6)
