#!/usr/bin/env bash
# Runs every comparison and writes its table into the documents; names of tables run those alone, --check runs none and
# tells which tables are older than the code that they measure.
set -euo pipefail
cd "$(dirname "$0")/.."
exec python3 -B bench/all.py "$@"
