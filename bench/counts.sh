#!/usr/bin/env bash
# Counts the instructions of small cases and compares them with bench/counts.json; UPDATE=1 writes that file,
# --against COMMIT compares with a former commit instead, --binary FILE counts a command that was built with lines.
set -euo pipefail
cd "$(dirname "$0")/.."
if ! command -v valgrind >/dev/null && [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
    apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends valgrind >/dev/null || true
fi
if ! command -v valgrind >/dev/null; then
    echo "notice: no valgrind, instructions are not counted"
    exit 0
fi
case " $* " in
    *" --binary "*) ;;
    *) cargo build --profile profiling --quiet -p peristat-cli ;;
esac
exec python3 -B bench/counts.py "$@"
