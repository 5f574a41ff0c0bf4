#!/bin/sh
# A sanitizer reports a planted defect, and the program fails by it.
# usage: caught.sh DEFECTS NAME REPORT
set -eu
if said=$("$1" "$2" 2>&1); then
    echo "the defect \"$2\" did not fail the program; it said: $said"
    exit 1
fi
case $said in
*"$3"*) ;;
*)
    echo "no report of \"$3\" for the defect \"$2\": $said"
    exit 1
    ;;
esac
