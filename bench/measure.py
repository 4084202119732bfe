"""What the comparisons share: running a program with its times and memory, and the table with its targets."""

import os
import platform
import re
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
WORK = ROOT / "target" / "bench"
PERISTAT = ROOT / "target" / "release" / "peristat"
EXAMPLES = ROOT / "target" / "release" / "examples"


def run(*command, errors=None):
    """Runs a process to its end: output, CPU and wall seconds, peak memory in bytes. `errors`: where stderr goes."""
    begin = time.perf_counter()
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=errors, text=True)
    output = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)  # this child's usage alone
    wall = time.perf_counter() - begin
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} ended with {process.returncode}:\n{output}")
    return output, (usage.ru_utime + usage.ru_stime, wall), usage.ru_maxrss * 1024


class Report:
    """Rows of the table, notes below it, and how many targets were missed."""

    def __init__(self, other, last="ratio or value"):
        self.head = ["", "peristat", other, last, "target"]
        self.rows, self.notes, self.missed = [], [], 0

    def row(self, what, ours="", theirs="", value="", measured=None, target=None, least=None):
        """`measured` meets the target if it is at most `target` and at least `least`, whichever are given."""
        verdict = ""
        if target is not None or least is not None:
            met = (target is None or measured <= target) and (least is None or measured >= least)
            self.missed += not met
            limits = f"<= {target:g}" if least is None else f">= {least:g}" if target is None else f"{least:g} to {target:g}"
            verdict = f"{limits}: {'met' if met else '**missed**'}"
        self.rows.append([what, ours, theirs, value, verdict])
        print(f"{what}: {' | '.join(filter(None, (ours, theirs, value, verdict)))}", file=sys.stderr)

    def markdown(self):
        table = [self.head, ["---"] * len(self.head), *self.rows]
        return "".join(f"| {' | '.join(row)} |\n" for row in table) + "".join(f"\n{note}\n" for note in self.notes)


def processor():
    """Processor, number of cores, operating system."""
    info = Path("/proc/cpuinfo")
    names = re.findall(r"model name\s*: (.*)", info.read_text()) if info.exists() else []
    return f"{names[0] if names else platform.processor()}, {os.cpu_count()} cores, {platform.system()}"
