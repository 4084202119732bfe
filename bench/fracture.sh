#!/usr/bin/env bash
# Breaks a plate of 11 200 points of beam bonds, and 98 304 points of a solid: prints a table and writes it to
# target/bench/fracture.md. The number of rounds may be given, 3 if not, and another command that breaks the plate in turn.
set -euo pipefail
cd "$(dirname "$0")/.."
cargo build --release --quiet -p peristat-cli
exec python3 bench/fracture.py "${1:-3}" "${@:2}"
