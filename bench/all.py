"""Every comparison, one after the other, and its table between its markers in bench/README.md, edges.md or defaults.md.

A marker line holds a hash of the kernels that its table measures as they were then; `--check` compares it with the code.
"""

import argparse
import hashlib
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
README, EDGES, DEFAULTS = (ROOT / "bench" / name for name in ("README.md", "edges.md", "defaults.md"))
WORK = ROOT / "target" / "bench"
SOLVE, ASSEMBLY = "crates/solve/src", "crates/assembly/src"
BAND = [f"{SOLVE}/band*", f"{SOLVE}/pcg*", f"{SOLVE}/repeating*", f"{ASSEMBLY}/stiffness/lattice_bonds"]
SPARSE = [f"{SOLVE}/sparse*", f"{SOLVE}/dissect*"]
SOLID = [f"{ASSEMBLY}/cubic", f"{ASSEMBLY}/stiffness/grid_bonds", f"{ASSEMBLY}/model/solid", f"{ASSEMBLY}/model/bond_solid"]
GRID = [f"{SOLVE}/multigrid*", f"{SOLVE}/hierarchy.rs", f"{ASSEMBLY}/stiffness/grid_bonds", f"{ASSEMBLY}/system"]
# By name: command, document, and the sources of the kernels that decide on its figures: no more than these, or every
# table would be older than the code after every commit.
TABLES = {
    "beam": (["bench/run.sh"], README, [*BAND, f"{ASSEMBLY}/model/timoshenko_beam"]),
    "python": (["bench/python.sh"], README, [*BAND, f"{ASSEMBLY}/model/timoshenko_beam", "crates/python/src"]),
    "direct": (["bench/direct.sh"], README, SPARSE),
    "plate": (["bench/plate.sh"], README, GRID),
    "bending": (["bench/bending.sh"], README, [f"{ASSEMBLY}/model/plate_bending", f"{SOLVE}/multigrid*", f"{SOLVE}/hierarchy.rs", "crates/driver/src/run/plate/levels.rs"]),
    "solid": (["bench/solid.sh"], README, [*SOLID, f"{ASSEMBLY}/stiffness/grid_families", f"{ASSEMBLY}/stiffness/noded_bonds", f"{ASSEMBLY}/model/state_solid"]),
    "fracture": (["bench/fracture.sh"], README, [*SPARSE, f"{ASSEMBLY}/stiffness/grid_bonds", "crates/driver/src/run/fracture"]),
    "pareto": (["bench/pareto.sh"], README, [*BAND, *GRID]),
    "edges": ([sys.executable, "-B", "bench/edges.py"], EDGES, [f"{ASSEMBLY}/model/plane/edges", f"{ASSEMBLY}/model/bond_plane"]),
    "defaults": ([sys.executable, "-B", "bench/defaults.py"], DEFAULTS, [f"{ASSEMBLY}/model/plane/edges", f"{ASSEMBLY}/model/bond_plane"]),
}


def digest(sources):
    """Hash of the tracked files below some paths, as they are on disk."""
    listed = subprocess.run(["git", "ls-files", "-z", "--", *sources], cwd=ROOT, check=True, capture_output=True).stdout
    found = hashlib.sha256()
    for name in sorted(filter(None, listed.split(b"\0"))):
        path = ROOT / name.decode()
        found.update(name + b"\0" + (path.read_bytes() if path.exists() else b"") + b"\0")
    return found.hexdigest()[:12]


def markers(name):
    """What encloses a table; the first group is the hash, the second the table."""
    return re.compile(rf"<!-- table {name}: kernels (\S+) -->\n(.*?)<!-- end of {name} -->", re.DOTALL)


def found(name):
    document = TABLES[name][1]
    match = markers(name).search(document.read_text())
    return match or sys.exit(f"{document.relative_to(ROOT)} has no markers of the table {name}")


def check():
    """Tells which tables are older than the code; their number."""
    older = [name for name in TABLES if found(name)[1] != digest(TABLES[name][2])]
    for name in older:
        print(f"table {name} in {TABLES[name][1].relative_to(ROOT)} is older than the code, run bench/all.sh {name}")
    return len(older)


def write(name):
    """Runs a comparison and writes its table down."""
    command, document, sources = TABLES[name]
    found(name)
    print(f"== {name}: {' '.join(command[-1:])}", flush=True)
    kernels = digest(sources)  # of what is measured, whatever changes meanwhile
    printed = subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True).stdout
    file = WORK / f"{name}.md"
    table = file.read_text() if document is README else printed
    block = f"<!-- table {name}: kernels {kernels} -->\n{table.strip()}\n<!-- end of {name} -->"
    document.write_text(markers(name).sub(lambda _: block, document.read_text()))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="run nothing; exit 1 if a table is older than the code")
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"tables to write, all if none is named: {', '.join(TABLES)}")
    options = parser.parse_args()
    if unknown := set(options.names) - set(TABLES):
        sys.exit(f"no table {', '.join(sorted(unknown))}; there are {', '.join(TABLES)}")
    if options.check:
        return 1 if check() else 0
    for name in options.names or TABLES:
        write(name)
    if not options.names:
        return subprocess.run(["bench/counts.sh"], cwd=ROOT).returncode
    return 0


if __name__ == "__main__":
    sys.exit(main())
