#!/usr/bin/env bash
# Compares the direct path on a plate with MKL PARDISO and METIS: prints a table and writes it to target/bench/direct.md.
# Options go to plate_pardiso.py.
set -euo pipefail
cd "$(dirname "$0")/.."
venv=target/bench-venv
[ -x "$venv/bin/python" ] || python3 -m venv "$venv"
for package in numpy scipy pypardiso pymetis; do
    "$venv/bin/python" -c "import $package" 2>/dev/null || "$venv/bin/python" -m pip install --quiet "$package" ||
        echo "notice: $package cannot be installed"
done
cargo build --release --quiet -p peristat-solve --example plate
exec "$venv/bin/python" bench/plate_pardiso.py "$@"
