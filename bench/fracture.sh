#!/usr/bin/env bash
# Breaks a plate of 11 200 points of beam bonds: prints a table and writes it to target/bench/fracture.md. The number of
# rounds may be given, 3 if not.
set -euo pipefail
cd "$(dirname "$0")/.."
cargo build --release --quiet -p peristat-cli
exec python3 bench/fracture.py "${1:-3}"
