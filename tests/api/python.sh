#!/bin/sh
# Runs the test of the Python module with Debian's Python; skips it where there is
# none, or no cffi or numpy.
#
#     python.sh MURK LIBRARY
command -v /usr/bin/python3 >/dev/null || {
    echo "skipped: no /usr/bin/python3"
    exit 77
}
exec /usr/bin/python3 -B -W ignore "$(dirname "$0")/python.py" "$@"
