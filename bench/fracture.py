"""Times the breaking of a plate: wall and CPU seconds of the whole run, iterations, factorisations."""

import json
import os
import resource
import statistics
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
CASE = ROOT / "cases/bench/cracked_plate.json"
TARGETS = {"wall": 20.0, "iterations": 12.0, "factorisations": 3}


def once(threads):
    """Wall and CPU seconds of a run, and its summary."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    begin = time.perf_counter()
    command = [ROOT / "target/release/peristat", "run", CASE, "--json", "--force", "--threads", str(threads)]
    command += ["-o", ROOT / "target/bench/fracture"]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    wall = time.perf_counter() - begin
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return wall, cpu, json.loads(done.stdout)


def verdict(value, name):
    target = TARGETS[name]
    return f"<= {target:g}: {'met' if value <= target else '**missed**'}"


def main(rounds):
    rows = []
    for threads in (2, 1):
        runs = [once(threads) for _ in range(rounds)]
        wall, cpu = (statistics.median(run[k] for run in runs) for k in (0, 1))
        rows.append((f"whole run, {threads} threads: wall (CPU)", f"{wall:.1f} s ({cpu:.1f} s)", verdict(wall, "wall") if threads == 2 else ""))
    summary = runs[-1][2]
    broke, counters = summary["fracture"], summary["counters"]
    rows.append(("equilibria; bonds that broke", f"{broke['solves']}; {broke['broken_bonds']}", ""))
    rows.append(("iterations per equilibrium", f"{broke['mean_iterations']:.1f}", verdict(broke["mean_iterations"], "iterations")))
    rows.append(("factorisations", str(counters["factorisations"]), verdict(counters["factorisations"], "factorisations")))
    rows.append(("analyses", str(counters["analyses"]), ""))
    lines = [f"{os.cpu_count()} cores; medians of {rounds} rounds; load {os.getloadavg()[0]:.1f} at the end", ""]
    lines += ["|  | peristat | target |", "| --- | --- | --- |"]
    lines += [f"| {what} | {value} | {target} |" for what, value, target in rows]
    text = "\n".join(lines) + "\n"
    (ROOT / "target/bench/fracture.md").write_text(text)
    print(text)


if __name__ == "__main__":
    (ROOT / "target/bench").mkdir(parents=True, exist_ok=True)
    main(int(sys.argv[1]))
