#!/bin/sh
# Runs a Python test; skips it where there is no python3.
# usage: python.sh TEST.py ARGS...
command -v python3 >/dev/null || {
    echo "skipped: no python3"
    exit 77
}
exec python3 -B "$@"
