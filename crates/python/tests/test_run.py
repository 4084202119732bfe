"""The package as its users meet it."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import peristat
import pytest

CASES = Path(__file__).resolve().parents[3] / "cases"

STRIP = {
    "title": "strip",
    "units": "mm-N-MPa",
    "model": {"bond_plane": {"youngs_modulus": 70000, "state": "plane_stress"}},
    "body": {"rectangle": {"size": [40, 20], "spacing": 1}},
    "supports": [{"at": {"region": "left"}, "ux": 0}, {"at": {"x": 0.5, "y": 0.5}, "uy": 0}],
    "loads": [{"traction": {"edge": "right", "uniform": [100, 0]}}],
    "probes": [{"name": "end", "at": {"x": 39.5, "y": 10.5}, "field": "ux"}],
    "checks": [{"value": {"probe": "end", "expected": 39.5 / 700, "tolerance": 1e-10, "source": "sigma x/E"}}],
}


def test_fields_are_arrays_at_points() -> None:
    result = peristat.run(STRIP)
    assert (result.status, result.states) == ("passed", ["loads"])
    x, ux = result.points[:, 0], result.field("ux")
    # sigma x/E to rounding.
    assert np.abs(ux - x / 700).max() < 1e-12
    assert result.volumes is not None and abs(result.volumes.sum() - 800) < 1e-9
    assert result.points.shape == (800, 3)
    assert set(result.fields()) >= {"ux", "uy", "stress_xx", "von_mises"}
    assert result.probes["end"] == pytest.approx(39.5 / 700, rel=1e-12)
    assert result.certificate["converged"] and result.checks[0]["passed"]
    assert "800 points" in repr(result)


def test_principal_stresses_and_numbers_of_all_points_have_units() -> None:
    asked = {"peak": ("principal_stress_1", "largest"), "virial": ("stress_xx", "integral"), "mean": ("ux", "mean")}
    probes = [{"name": name, "field": field, "of": of} for name, (field, of) in asked.items()]
    result = peristat.run({**STRIP, "probes": probes, "checks": []})
    assert np.abs(result.field("principal_stress_1") - 100).max() < 1e-9
    assert np.abs(result.field("principal_direction")).max() < 1e-9
    assert result.unit("max_shear") == "MPa" and "max_shear" not in result.fields()
    assert [str(result.probes[name].unit) for name in asked] == ["MPa", "N mm", "mm"]
    # The stress times 40 x 20 mm and a thickness of one; the displacement of the middle.
    assert result.probes["virial"] == pytest.approx(80000, rel=1e-9)
    assert result.probes["mean"] == pytest.approx(20 / 700, rel=1e-9)
    found = {probe["name"]: probe for probe in result.summary["probes"]}
    assert {"x", "y", "of"} <= found["peak"].keys() and found["virial"]["extent"] == pytest.approx(800)


def test_stress_intensities_are_probes_with_a_unit() -> None:
    case = json.loads((CASES / "plate/edge_crack.json").read_text())
    name = case["stress_intensity"][0]["name"]
    assert peristat.run(case).probes[name].unit == "MPa √mm"


def test_a_path_a_text_and_a_dictionary_are_the_same_case(tmp_path: Path) -> None:
    file = tmp_path / "strip.json"
    file.write_text(json.dumps(STRIP))
    values = [peristat.run(case).probes["end"] for case in (STRIP, json.dumps(STRIP), file, str(file))]
    assert len(set(values)) == 1


def test_values_are_set_by_their_paths() -> None:
    coarse = peristat.run(CASES / "plate/cantilever.json", set={"body.rectangle.spacing": 2, "checks": []})
    assert len(coarse.points) == 800
    threads = peristat.run(STRIP, threads=1)
    assert threads.probes["end"] == pytest.approx(39.5 / 700, rel=1e-12)


def test_faults_have_their_parts() -> None:
    text = json.dumps(STRIP, indent=1).replace('"spacing": 1', '"spacin": 1')
    with pytest.raises(peristat.CaseError) as caught:
        peristat.run(text)
    fault = caught.value.faults[0]
    assert fault.severity == "error" and "spacin" in fault.message
    assert fault.path == "body.rectangle" or fault.path.startswith("body.rectangle")
    assert fault.line is not None and text.splitlines()[fault.line - 1].strip().startswith('"spacin"')
    assert fault.hint is not None and "spacing" in fault.hint
    assert "spacin" in str(caught.value)


def test_missing_fields_states_and_files_are_told() -> None:
    result = peristat.run(STRIP)
    with pytest.raises(KeyError, match="there are ux"):
        result.field("w")
    with pytest.raises(KeyError, match="there is no state `b`; there are loads"):
        result.field("ux", "b")
    with pytest.raises(KeyError, match="there is no state 1"):
        result.field("ux", 1)
    with pytest.raises(FileNotFoundError):
        peristat.run("no_such_file.json")


def test_memory_is_bounded() -> None:
    with pytest.raises((MemoryError, peristat.CaseError)):
        peristat.run(STRIP, set={"body.rectangle.spacing": 0.01}, max_memory=10_000_000)


def test_doubts_are_warnings() -> None:
    with pytest.warns(peristat.PeristatWarning, match="stairs"):
        peristat.run(CASES / "solid/pressed_tube.json")
    sizes, faults = peristat.check(CASES / "solid/pressed_tube.json")
    assert sizes["points"] > 0 and any("stairs" in fault.message for fault in faults)


def test_states_are_reported_as_they_come_and_may_end_a_run() -> None:
    case = CASES / "orthotropic/case_b_45.json"
    seen: list[tuple[str, float]] = []
    with pytest.warns(peristat.PeristatWarning, match="softer"):
        whole = peristat.run(case, on_state=lambda name, factor: seen.append((name, factor)))
    assert [name for name, _ in seen] == whole.states and len(seen) > 1
    with pytest.raises(peristat.Interrupted):
        peristat.run(case, on_state=lambda name, factor: False)

    def broken(name: str, factor: float) -> bool:
        raise ZeroDivisionError(name)

    with pytest.raises(ZeroDivisionError):
        peristat.run(case, on_state=broken)


def test_curves_are_arrays() -> None:
    with pytest.warns(peristat.PeristatWarning, match="softer"):
        result = peristat.run(CASES / "orthotropic/case_b_45.json")
    curve = result.curve
    assert curve["load"].max() == pytest.approx(result.summary["fracture"]["facts"]["peak_load"], rel=1e-12)
    # Work is what is stored and what was released; 1e-12 measured.
    lost = curve["work"] - curve["stored"] - curve["released"]
    assert np.abs(lost).max() < 1e-8 * curve["work"].max()
    assert peristat.run(STRIP).curve == {}


def test_values_of_numpy_are_numbers() -> None:
    size = np.array([40, 20])
    case = STRIP | {"body": {"rectangle": {"size": size, "spacing": np.int64(1)}}}
    assert peristat.run(case, set={"loads[0].traction.uniform": np.array([200.0, 0.0]), "checks": []}).probes["end"] == pytest.approx(79 / 700)


def test_other_threads_run_while_a_case_is_solved() -> None:
    ticks: list[float] = []
    done = threading.Event()

    def tick() -> None:
        while not done.wait(0.01):
            ticks.append(time.monotonic())

    thread = threading.Thread(target=tick)
    thread.start()
    begin = time.monotonic()
    with pytest.warns(peristat.PeristatWarning, match="softer"):
        peristat.run(CASES / "orthotropic/case_b_45.json")
    spent = time.monotonic() - begin
    done.set()
    thread.join()
    # A tick takes 0.01 s and a little; a blocked interpreter leaves none.
    assert len(ticks) > 0.2 * spent / 0.01


def test_threads_solve_at_once_and_agree() -> None:
    alone = peristat.run(STRIP).field("ux")
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda _: peristat.run(STRIP).field("ux"), range(12)))
    assert all(np.array_equal(alone, field) for field in found)


@pytest.mark.skipif(sys.platform == "win32", reason="signals")
def test_an_interrupt_ends_a_run_at_once() -> None:
    program = (
        "import peristat, signal\n"
        # Jobs in the background begin with this signal ignored, which Python leaves as it is.
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
        "print('begin', flush=True)\n"
        "try:\n"
        f"    peristat.run({str(CASES / 'orthotropic/case_b_45.json')!r}, set={{'body.rectangle.spacing': 0.25}})\n"
        "except KeyboardInterrupt:\n"
        "    print('interrupted', flush=True)\n"
    )
    process = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None and process.stdout.readline() == "begin\n"
    time.sleep(1.0)
    begin = time.monotonic()
    process.send_signal(signal.SIGINT)
    assert process.stdout.readline() == "interrupted\n"
    # 0.05 s measured.
    assert time.monotonic() - begin < 5.0
    process.kill()
    process.wait()


def test_the_version_is_that_of_the_command() -> None:
    manifest = (CASES.parent / "Cargo.toml").read_text(encoding="utf-8")
    assert f'version = "{peristat.__version__}"' in manifest.split("[workspace.package]")[1]


def test_models_and_schema_are_those_of_the_program() -> None:
    assert set(peristat.models()) >= {"bond_plane", "bond_solid", "timoshenko_beam"}
    properties = peristat.schema()["properties"]
    assert isinstance(properties, dict) and "horizon_ratio" in properties
