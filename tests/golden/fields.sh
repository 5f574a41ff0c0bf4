#!/bin/sh
# Runs a Python test with a python3 that has OpenVDB's module; skips it where
# there is none. That of the system may be another than the first in the path.
# usage: fields.sh MURK
for python in python3 /usr/bin/python3; do
    if "$python" -c 'import pyopenvdb' 2>/dev/null || "$python" -c 'import openvdb' 2>/dev/null; then
        exec "$python" -B tests/golden/fields.py "$@"
    fi
done
echo "skipped: no python3-openvdb"
exit 77
