#!/usr/bin/env bash
# Compares beams solved from Python with other programs that Python calls: prints a table and writes it to target/bench/python.md.
# Options go to python.py.
set -euo pipefail
cd "$(dirname "$0")/.."
venv=target/bench-venv
[ -x "$venv/bin/python" ] || python3 -m venv "$venv"
for package in numpy scipy "maturin>=1.7,<2" scikit-fem openseespy; do
    "$venv/bin/pip" install --quiet "$package" || echo "notice: $package cannot be installed: what needs it is left out"
done
cargo build --release --quiet -p peristat-cli -p peristat --bin peristat --example many_beams
PATH="$PWD/$venv/bin:$PATH" "$venv/bin/pip" install --quiet --no-build-isolation ./crates/python
exec "$venv/bin/python" -B bench/python.py "$@"
