#!/bin/sh
# Builds the examples of doc/api against an installed murk, runs each in a folder
# of its own, and compares what it prints with the comment at its end.
#
#     examples.sh BUILD
set -eu
build=$1
top=$(cd "$(dirname "$0")/../.." && pwd)
. "$top/tests/api/installed.sh"
install_and_build "$build" "$top/doc/api/examples"
failed=0
for source in "$top"/doc/api/examples/*.c; do
    name=$(basename "$source" .c)
    mkdir "$work/$name"
    sed -n '/^\/\* Prints:$/,$ s/^ \* \(..*\)/\1/p' "$source" >"$work/$name.expected"
    (cd "$work/$name" && "$work/build/$name" >"$work/$name.printed") || {
        echo "$name: exit status $?"
        failed=1
    }
    diff "$work/$name.expected" "$work/$name.printed" || {
        echo "$name prints other lines than its comment says"
        failed=1
    }
done
exit $failed
