"""Times the breaking of a plate and of a solid: wall and CPU seconds, iterations, factorisations."""

import json
import os
import resource
import statistics
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
OWN = ROOT / "target/release/peristat"
PLATE = ROOT / "cases/bench/cracked_plate.json"
SOLID = ROOT / "bench/notched_block.json"
TARGETS = {"wall": 20.0, "speed": 2.5, "iterations": 12.0, "factorisations": 3}
# CPU time of an equilibrium of the solid over that of one solution of the intact one.
RATIO = 1.5


def once(case, threads, command=OWN):
    """Wall and CPU seconds of a run, and its summary."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    begin = time.perf_counter()
    call = [command, "run", case, "--json", "--force", "--threads", str(threads), "-o", ROOT / "target/bench/fracture"]
    done = subprocess.run(call, check=True, capture_output=True, text=True)
    wall = time.perf_counter() - begin
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return wall, cpu, json.loads(done.stdout)


def met(is_met):
    return "met" if is_met else "**missed**"


def broken(summary):
    """What must not depend on how equilibria are found."""
    return summary["fracture"]["solves"], summary["fracture"]["broken_bonds"], summary["fracture"]["ending"]


def plate(rounds, other):
    """Rows of the plate; beside another command, in turn with it."""
    rows = []
    for threads in (2, 1):
        runs, others = [], []
        for _ in range(rounds):
            runs.append(once(PLATE, threads))
            if other:
                others.append(once(PLATE, threads, other))
        wall, cpu = (statistics.median(run[k] for run in runs) for k in (0, 1))
        target = f"<= {TARGETS['wall']:g}: {met(wall <= TARGETS['wall'])}" if threads == 2 else ""
        rows.append((f"plate, {threads} threads: wall (CPU)", f"{wall:.1f} s ({cpu:.1f} s)", target))
        if other:
            theirs = statistics.median(run[0] for run in others)
            faster = theirs / wall
            same = broken(others[-1][2]) == broken(runs[-1][2])
            verdict = f">= {TARGETS['speed']:g}: {met(faster >= TARGETS['speed'] and same)}"
            rows.append((f"the other command, {threads} threads: wall", f"{theirs:.1f} s, {faster:.1f} times", verdict))
    summary = runs[-1][2]
    broke = summary["fracture"]
    rows.append(("equilibria; bonds that broke", f"{broke['solves']}; {broke['broken_bonds']}", ""))
    iterations, counters = broke["mean_iterations"], summary["counters"]
    verdict = f"<= {TARGETS['iterations']:g}: {met(iterations <= TARGETS['iterations'])}"
    rows.append(("iterations per equilibrium", f"{iterations:.1f}", verdict))
    verdict = f"<= {TARGETS['factorisations']}: {met(counters['factorisations'] <= TARGETS['factorisations'])}"
    rows.append(("factorisations", str(counters["factorisations"]), verdict))
    rows.append(("analyses", str(counters["analyses"]), ""))
    return rows


def solid():
    """Rows of the solid, on one thread."""
    case = json.loads(SOLID.read_text())
    for key in ("fracture", "cracks"):
        del case[key]
    intact = ROOT / "target/bench/intact_block.json"
    intact.write_text(json.dumps(case))
    solve = once(intact, 1)[2]["timing_s"]["solve"]
    _, cpu, summary = once(SOLID, 1)
    broke = summary["fracture"]
    each = cpu / broke["solves"]
    verdict = f"<= {RATIO:g} of the intact one: {met(each <= RATIO * solve)}"
    return [
        ("solid, one solution of the intact one: CPU", f"{solve:.1f} s", ""),
        ("solid, each equilibrium, records and all: CPU", f"{each:.1f} s", verdict),
        ("equilibria; bonds that broke", f"{broke['solves']}; {broke['broken_bonds']}", ""),
        ("iterations per equilibrium", f"{broke['mean_iterations']:.1f}", ""),
    ]


def main(rounds, other=None):
    rows = plate(rounds, other) + solid()
    lines = [f"{os.cpu_count()} cores; medians of {rounds} rounds, one of the solid; load {os.getloadavg()[0]:.1f} at the end", ""]
    lines += ["|  | peristat | target |", "| --- | --- | --- |"]
    lines += [f"| {what} | {value} | {target} |" for what, value, target in rows]
    text = "\n".join(lines) + "\n"
    (ROOT / "target/bench/fracture.md").write_text(text)
    print(text)


if __name__ == "__main__":
    (ROOT / "target/bench").mkdir(parents=True, exist_ok=True)
    main(int(sys.argv[1]), *sys.argv[2:3])
