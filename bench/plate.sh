#!/usr/bin/env bash
# Measures plates of up to four million points and compares them with pyamg: prints a table and writes it to
# target/bench/plate.md. Options go to plate_table.py.
set -euo pipefail
cd "$(dirname "$0")/.."
venv=target/bench-venv
[ -x "$venv/bin/python" ] || python3 -m venv "$venv"
for package in numpy scipy pyamg; do
    "$venv/bin/python" -c "import $package" 2>/dev/null || "$venv/bin/python" -m pip install --quiet "$package" ||
        echo "notice: $package cannot be installed: what needs it is left out"
done
cargo build --release --quiet -p peristat-cli
cargo build --release --quiet -p peristat-assembly --example lattice_product
exec "$venv/bin/python" -B bench/plate_table.py "$@"
