"""The direct path of peristat-solve against MKL PARDISO on the stiffness of a plate, and its order against METIS.

A square lattice whose points are coupled with 28 neighbours, two unknowns per point, one column of points clamped.
`crates/solve/examples/plate` builds the matrix and times order, analysis, factor and solve; PARDISO solves the same
matrix with the unknowns of a point side by side, which it likes better than component planes, as positive definite
(mtype 2), with each of its settings below; the fastest counts. Competitors alternate, and medians are compared.
`bench/direct.sh` prepares everything and runs this.
"""

import argparse
import ctypes
import json
import os
import platform
import subprocess
import sys
import time
from pathlib import Path
from statistics import median

os.environ["KMP_BLOCKTIME"] = "0"  # before MKL is loaded: its threads do not spin while the other program runs

import numpy as np
import scipy.sparse as sparse

ROOT = Path(__file__).resolve().parent.parent
WORK = ROOT / "target" / "bench"
PLATE = ROOT / "target" / "release" / "examples" / "plate"
STAGES = ["order", "analyse", "factor", "solve", "total"]
# Order (2: METIS, 3: METIS in threads) and method of factorisation (0: classic, 1 and 10: two levels).
SETTINGS = {1: [(2, 0), (2, 1)], 2: [(2, 0), (3, 1), (3, 10)]}
NAMES = {2: "METIS", 3: "METIS in threads"}


def plate(*options):
    """The lines that the example prints."""
    output = subprocess.check_output([PLATE, *map(str, options)], text=True)
    return [json.loads(line) for line in output.splitlines()]


def read(path):
    """Lower triangle in component planes."""
    raw = path.read_bytes()
    order, entries = np.frombuffer(raw, "<u8", 2).astype(int)
    at = 16 + 8 * (order + 1)
    starts = np.frombuffer(raw, "<u8", order + 1, 16).astype(np.int64)
    columns = np.frombuffer(raw, "<u4", entries, at).astype(np.int32)
    values = np.frombuffer(raw, "<f8", entries, at + 4 * entries)
    return sparse.csr_matrix((values, columns, starts), (order, order))


class Pardiso:
    """PARDISO for one positive definite matrix."""

    def __init__(self, matrix):
        from pypardiso import PyPardisoSolver

        self.solver = PyPardisoSolver(mtype=2)
        order = matrix.shape[0]
        beside = np.arange(order).reshape(2, -1).T.ravel()
        whole = matrix + sparse.tril(matrix, -1).T
        self.whole = whole.tocsr()[beside][:, beside]
        upper = sparse.triu(self.whole).tocsr()
        upper.sort_indices()
        self.values = upper.data
        self.starts = upper.indptr.astype(np.int32) + 1
        self.columns = upper.indices.astype(np.int32) + 1
        # Load on the free points only.
        self.b = (np.diff(self.whole.indptr) > 1).astype(float)
        self.x = np.zeros(order)

    def call(self, phase):
        error, one, pointer = ctypes.c_int32(0), ctypes.c_int32(1), ctypes.c_void_p
        arrays = [self.values, self.starts, self.columns, self.perm]
        arrays = [array.ctypes.data_as(pointer) for array in arrays]
        run = self.solver.libmkl.pardiso
        run.argtypes = None
        run(
            self.pt.ctypes.data_as(pointer), ctypes.byref(one), ctypes.byref(one), ctypes.byref(ctypes.c_int32(2)),
            ctypes.byref(ctypes.c_int32(phase)), ctypes.byref(ctypes.c_int32(len(self.b))), *arrays,
            ctypes.byref(one), self.iparm.ctypes.data_as(pointer), ctypes.byref(ctypes.c_int32(0)),
            self.b.ctypes.data_as(pointer), self.x.ctypes.data_as(pointer), ctypes.byref(error),
        )  # fmt: skip
        if error.value:
            raise RuntimeError(f"PARDISO: error {error.value} in phase {phase}")

    def time(self, threads, setting):
        """Seconds of its stages, the order within the analysis; fill and backward error."""
        self.solver.libmkl.MKL_Set_Num_Threads(threads)
        self.pt, self.iparm = np.zeros(64, np.int64), np.zeros(64, np.int32)
        self.perm = np.zeros(len(self.b), np.int32)
        self.iparm[[0, 1, 17, 23]] = 1, setting[0], -1, setting[1]
        clock = [time.perf_counter()]
        for phase in (11, 22, 33):
            self.call(phase)
            clock.append(time.perf_counter())
        found = dict(zip(["analyse", "factor", "solve"], np.diff(clock))) | {"total": clock[-1] - clock[0]}
        rows = abs(self.whole).sum(axis=1).max()
        left = abs(self.whole @ self.x - self.b).max() / (rows * abs(self.x).max() + abs(self.b).max())
        found |= {"fill": int(self.iparm[17]), "residual": left}
        self.call(-1)
        return found


def metis_fill(matrix, points):
    """Fill with the order of METIS on the graph of points, counted like that of the own order."""
    try:
        import pymetis
    except ImportError:
        return None
    count = matrix.shape[0] // 2
    lower = sparse.coo_matrix(matrix)
    pairs = sparse.coo_matrix((np.ones(lower.nnz), (lower.row % count, lower.col % count)), (count, count))
    graph = (pairs + pairs.T).tocsr()
    graph.setdiag(0)
    graph.eliminate_zeros()
    order, _ = pymetis.nested_dissection(adjacency=pymetis.CSRAdjacency(graph.indptr, graph.indices))
    path = WORK / "metis.order"
    np.array(order, "<u4").tofile(path)
    return plate(points, "--order", path)[0]


def seconds(found):
    """Medians of the stages as one cell of the table."""
    middle = {stage: median(f[stage] for f in found) for stage in STAGES if stage in found[0]}
    return f"{middle.pop('total'):.2f} s ({', '.join(f'{k} {v:.2f}' for k, v in middle.items())})"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--points", type=int, default=100_000)
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--strict", action="store_true", help="exit code 1 if a target is missed")
    options = parser.parse_args()
    WORK.mkdir(parents=True, exist_ok=True)
    path = WORK / "plate.bin"
    plate(options.points, "--write", path)
    matrix = read(path)
    try:
        pardiso = Pardiso(matrix)
    except ImportError:
        print("notice: pypardiso is missing, nothing to compare with: times of peristat alone")
        pardiso = None
    ours = {1: [], 2: []}
    theirs = {(threads, setting): [] for threads in (1, 2) for setting in SETTINGS[threads]}
    for _ in range(options.rounds):
        for threads in (1, 2):
            ours[threads] += plate(options.points, "--threads", threads)
            for setting in SETTINGS[threads] if pardiso else []:
                theirs[threads, setting].append(pardiso.time(threads, setting))
    rows, missed = [], False
    for threads, target in ((1, 0.8), (2, 1.0)):
        row = [f"{threads} thread{'s'[: threads - 1]}: order, analyse, factor, solve", seconds(ours[threads])]
        if pardiso:
            total = {s: median(f["total"] for f in theirs[threads, s]) for s in SETTINGS[threads]}
            best = min(total, key=total.get)
            ratio = median(f["total"] for f in ours[threads]) / total[best]
            missed |= ratio > target
            row += [f"{seconds(theirs[threads, best])}, {NAMES[best[0]]}, method {best[1]}", f"{ratio:.2f}"]
            row += [f"<= {target}: {'met' if ratio <= target else 'missed'}"]
        rows.append(row)
    own, metis = plate(options.points, "--fill")[0], metis_fill(matrix, options.points)
    if metis:
        for name, key, target in (("entries of L", "fill", 1.08), ("operations of the factor", "work", None)):
            ratio = own[key] / metis[key]
            missed |= bool(target) and ratio > target
            met = f"<= {target}: {'met' if ratio <= target else 'missed'}" if target else ""
            rows.append([f"{name}, order against METIS", f"{own[key]:.3e}", f"{metis[key]:.3e}", f"{ratio:.3f}", met])
    else:
        print("notice: pymetis is missing, fill is not compared")
        rows.append(["entries of L", f"{own['fill']:.3e}"])
    if pardiso:
        fill = min(f[0]["fill"] for f in theirs.values())
        rows.append(["entries of L, order against PARDISO", f"{own['fill']:.3e}", f"{fill:.3e}", f"{own['fill'] / fill:.3f}"])
        error = max(f["residual"] for found in theirs.values() for f in found)
        rows.append(["backward error", f"{max(f['residual'] for t in ours.values() for f in t):.1e}", f"{error:.1e}"])
    lines = ["| | peristat | PARDISO or METIS | ratio | target |", "| --- | --- | --- | --- | --- |"]
    lines += ["| " + " | ".join(row + [""] * (5 - len(row))) + " |" for row in rows]
    head = f"{own['points']} points, {matrix.shape[0]} unknowns; medians of {options.rounds} rounds; {platform.processor() or platform.machine()}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}"
    text = "\n".join([head, "", *lines])
    print(text)
    (WORK / "direct.md").write_text(text + "\n")
    if options.strict and missed:
        sys.exit(1)


main()
