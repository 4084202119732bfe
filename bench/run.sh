#!/usr/bin/env bash
# Compares peristat with LAPACK: prints a table and writes it to target/bench/beam.md. Options go to beam_lapack.py.
set -euo pipefail
cd "$(dirname "$0")/.."
venv=target/bench-venv
[ -x "$venv/bin/python" ] || python3 -m venv "$venv"
"$venv/bin/python" -c 'import numpy, scipy' 2>/dev/null || "$venv/bin/pip" install --quiet numpy scipy
cargo build --release --quiet -p peristat-cli
cargo build --release --quiet -p peristat-solve --example timing
exec "$venv/bin/python" -B bench/beam_lapack.py "$@"
