"""Beams one after the other from Python, beside other programs that Python calls: bench/README.md says what is compared.

`bench/python.sh` prepares everything and runs this.
"""

import argparse
import gc
import statistics
import sys
import time

import numpy as np
import peristat
from scipy.linalg import solveh_banded

from beam_lapack import Beam as Steel
from measure import EXAMPLES, ROOT, WORK, Report, processor, run
from pareto_beam import Beam, opensees, scikit_fem

CELLS, SLENDERNESS, LOAD = 100, 20.0, 1000.0


def each(count, solve):
    """Seconds of one call of `solve(k)`."""
    gc.collect()
    begin = time.perf_counter()
    for k in range(count):
        solve(k)
    return (time.perf_counter() - begin) / count


def beams(estimate):
    """Solves a beam of the package under a load of its own."""
    import json

    case = json.loads(Steel(SLENDERNESS, LOAD, cells=CELLS).case().read_text())

    def solve(k):
        case["loads"][0]["distributed"]["force"]["uniform"] = LOAD + k
        result = peristat.run(case, estimate=estimate)
        assert result.status == "passed"
        return result.field("w")

    return solve


def banded(k):
    """The same equations assembled by NumPy and solved by LAPACK."""
    band, load = Steel(SLENDERNESS, LOAD + k, cells=CELLS).system()
    # What LAPACK asks for below the clamp.
    return solveh_banded(band, load, lower=True)[::2]


def other(make):
    """Another program, whose model is built anew for every beam as `banded` builds its matrix."""
    solve, beam = make(), Beam(SLENDERNESS)

    def once(_):
        if make is opensees:
            import openseespy.opensees as ops

            ops.wipe()
        return solve(beam, CELLS)

    return once


def memory(count):
    """Bytes that the process holds more for every run, after a warm-up."""

    def resident():
        with open("/proc/self/statm") as file:
            return int(file.read().split()[1]) * 4096

    solve = beams(False)
    each(count // 10, solve)
    before = resident()
    each(count, solve)
    return (resident() - before) / count


def field(report):
    """A field of a million points arrives without a copy."""
    result = peristat.run(Steel(SLENDERNESS, LOAD, cells=1_000_000).case(), estimate=False)
    first, second = result.field("w"), result.field("w")
    same = first.__array_interface__["data"][0] == second.__array_interface__["data"][0]
    begin = time.perf_counter()
    result.field("w")
    report.row("a field of 1e6 points", f"{1e6 * (time.perf_counter() - begin):.0f} us", "", "one address" if same else "copies", measured=float(same), least=1.0)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--strict", action="store_true", help="exit code 1 if a target is missed")
    options = parser.parse_args()
    WORK.mkdir(parents=True, exist_ok=True)
    report = Report("other", "other over peristat")
    solvers = {"peristat": beams(False), "peristat with its estimate": beams(None), "NumPy and solveh_banded": banded}
    for name, make in (("scikit-fem", lambda: scikit_fem(2)), ("OpenSeesPy", opensees)):
        try:
            solvers[name] = other(make)
            solvers[name](0)
        except (ImportError, RuntimeError):
            report.notes.append(f"{name} cannot be used here.")
            solvers.pop(name, None)
    exact = np.asarray(solvers["peristat"](0))
    apart = np.abs(banded(0) - exact).max() / exact.max()
    counts = {name: 1000 if name.startswith(("peristat", "NumPy")) else 20 for name in solvers}
    times = {name: [] for name in solvers}
    for _ in range(5):
        for name, solve in solvers.items():
            times[name].append(each(counts[name] // 5, solve))
    median = {name: statistics.median(seconds) for name, seconds in times.items()}
    ours = median["peristat"]
    shown = lambda seconds: f"{1e3 * seconds:.2f} ms"
    for name, target in (("NumPy and solveh_banded", 1.0), ("scikit-fem", 30.0), ("OpenSeesPy", 30.0)):
        if name in median:
            ratio = median[name] / ours
            report.row(f"a beam of {CELLS} cells: {name}", shown(ours), shown(median[name]), f"{ratio:.1f}", measured=ratio, least=target)
    report.row("the same with its estimate of errors", shown(median["peristat with its estimate"]))
    case = Steel(SLENDERNESS, LOAD, cells=CELLS).case()
    rust = statistics.median(float(run(EXAMPLES / "many_beams", case, "200")[0]) for _ in range(5))
    over = ours - rust
    report.row("more than the same in Rust", shown(ours), shown(rust), f"{1e3 * over:.2f} ms", measured=1e3 * over, target=0.5)
    grown = memory(10_000)
    report.row("memory that 10 000 runs leave, each", f"{grown:.0f} bytes", measured=grown, target=100.0)
    field(report)
    report.notes.append(f"solveh_banded differs by {apart:.0e} from peristat. {processor()}, Python {sys.version.split()[0]}.")
    text = report.markdown()
    (WORK / "python.md").write_text(text)
    print(text)
    return 1 if options.strict and report.missed else 0


if __name__ == "__main__":
    sys.exit(main())
