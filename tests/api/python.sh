#!/bin/sh
# Runs a test of the Python module with Debian's Python; skips it where there is
# none, or no cffi or numpy.
#
#     python.sh TEST.py MURK LIBRARY
command -v /usr/bin/python3 >/dev/null || {
    echo "skipped: no /usr/bin/python3"
    exit 77
}
test=$1
shift
exec /usr/bin/python3 -B -W ignore "$(dirname "$0")/$test" "$@"
