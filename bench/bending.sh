#!/usr/bin/env bash
# Measures clamped plates in bending of up to a million points beside a plate in its plane and elements of scikit-fem: prints
# tables and writes them to target/bench/bending.md, with a plot beside them. Options go to bending.py.
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
cargo build --release --quiet -p peristat-cli
exec "$venv/bin/python" -B bench/bending.py "$@"
