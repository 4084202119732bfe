#!/usr/bin/env bash
# Solids beside finite elements, algebraic multigrid and LAMMPS: prints tables and writes them to target/bench/solid.md,
# with a plot beside them. Options go to solid.py.
set -euo pipefail
cd "$(dirname "$0")/.."
venv=target/bench-venv
[ -x "$venv/bin/python" ] || python3 -m venv "$venv"
install() { # package, module
    "$venv/bin/python" -c "import $2" >/dev/null 2>&1 || "$venv/bin/python" -m pip install --quiet "$1" ||
        echo "notice: $1 cannot be installed: what needs it is left out"
}
debian() { # package, file or program that it brings
    command -v "$2" >/dev/null || compgen -G "$2" >/dev/null && return
    [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null && apt-get install --yes --quiet "$1" >/dev/null 2>&1 ||
        echo "notice: $1 cannot be installed"
}
install numpy numpy
install scipy scipy
install pyamg pyamg
install matplotlib matplotlib
debian calculix-ccx ccx
command -v ccx >/dev/null || install scikit-fem skfem
debian python3-petsc4py '/usr/lib/petscdir/*/*-real/lib/python3/dist-packages/petsc4py'
debian lammps lmp
cargo build --release --quiet -p peristat-cli
exec "$venv/bin/python" -B bench/solid.py "$@"
