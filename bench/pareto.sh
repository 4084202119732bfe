#!/usr/bin/env bash
# Run time against error on a beam and a plate, beside other programs: prints tables and writes them to
# target/bench/pareto.md, with plots beside them. Options go to pareto.py.
set -euo pipefail
cd "$(dirname "$0")/.."
venv=target/bench-venv
[ -x "$venv/bin/python" ] || python3 -m venv "$venv"
install() { # package, module
    "$venv/bin/python" -c "import $2" >/dev/null 2>&1 || "$venv/bin/python" -m pip install --quiet "$1" ||
        echo "notice: $1 cannot be installed: what needs it is left out"
}
install numpy numpy
install scipy scipy
install matplotlib matplotlib
install scikit-fem skfem
install openseespy openseespy.opensees
install PyNiteFEA Pynite
if ! command -v ccx >/dev/null && [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
    apt-get install --yes --quiet calculix-ccx >/dev/null 2>&1 || echo "notice: calculix-ccx cannot be installed"
fi
cargo build --release --quiet -p peristat-cli
exec "$venv/bin/python" -B bench/pareto.py "$@"
