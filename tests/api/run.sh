#!/bin/sh
# Installs a build into a folder of its own, builds the programs of this folder
# against it with find_package(murk) and with pkg-config, runs them, and compares
# the exported symbols with the functions of murk.h, and all that built programs
# rely on with abi.txt, the recorded list: the soname, the versions of symbols, the
# layout of structs and the values of enumerations.
#
#     run.sh BUILD
set -eu
build=$1
here=$(cd "$(dirname "$0")" && pwd)
. "$here/installed.sh"
install_and_build "$build" "$here" # with find_package()
"$work/build/plan" "$work/results"
test -s "$work/results/plan.json" || { echo "no plan.json was saved"; exit 1; }
"$work/build/contexts"
"$here/same_files.sh" "$build/murk" "$work/build/saves" "$work"
"$work/build/cpp"
"$work/build/refused"
"$work/build/sizes"
"$work/build/arrays"
"$work/build/places"
"$work/build/rows"

# with pkg-config, as C11 and as C17
for standard in c11 c17; do
    # shellcheck disable=SC2046
    cc -std=$standard -D_DEFAULT_SOURCE -Wall -Wextra -Werror -pedantic "$here/plan.c" -o "$work/plan" \
        $(PKG_CONFIG_PATH="$library/pkgconfig" pkg-config --cflags --libs murk) -lm
done
"$work/plan" "$work/results-again"
cmp "$work/results/sensors.csv" "$work/results-again/sensors.csv"

# exports: the functions of the header, the recorded list, and nothing more
nm -D --defined-only "$library/libmurk.so" | awk '$2 == "T" {sub(/@.*/, "", $3); print $3}' | sort >"$work/exported"
sed -n 's/^[a-z].*[ *]\(murk_[a-z0-9_]*\)(.*/\1/p' "$work/murk/include/murk.h" | grep -v '^typedef' | sort >"$work/declared"
diff "$work/declared" "$work/exported" || { echo "libmurk exports other functions than murk.h declares"; exit 1; }
# the table of constructors: the functions of the header that have an `out`
tr -s '\n ' ' ' <"$work/murk/include/murk.h" | grep -o 'murk_[a-z0-9_]*(murk_[a-z]* \*\*out' | sed 's/(.*//' |
    sort >"$work/constructors"
sed -n 's/^ *X([a-z]*, \(murk_[a-z_]*\),.*/\1/p' "$here/refused.c" | sort >"$work/refused"
diff "$work/constructors" "$work/refused" || { echo "refused.c has other constructors than murk.h"; exit 1; }
# the table of structs: those of the header that begin with their size
sed -n 's/^place \(murk_[a-z_]*\)\.size 0$/\1/p' "$here/abi.txt" | sort >"$work/structs"
grep -o '"murk_[a-z_]*"' "$here/sizes.c" | tr -d '"' | sort -u >"$work/sizes"
diff "$work/structs" "$work/sizes" || { echo "sizes.c has other structs than murk.h"; exit 1; }
# shellcheck disable=SC2046
awk -f "$here/layout.awk" "$work/murk/include/murk.h" >"$work/layout.c" &&
    cc "$work/layout.c" -o "$work/layout" $(PKG_CONFIG_PATH="$library/pkgconfig" pkg-config --cflags murk)
{
    readelf -d "$library/libmurk.so" | sed -n 's/.*(SONAME).*\[\(.*\)\]/soname \1/p'
    nm -D --defined-only "$library/libmurk.so" | awk '$2 == "T" {print "function", $3}' | LC_ALL=C sort
    "$work/layout"
} >"$work/abi"
diff "$here/abi.txt" "$work/abi" || { echo "what programs rely on differs from tests/api/abi.txt"; exit 1; }
nm -D --defined-only "$library/libmurk.so" | grep -v ' [TA] ' && { echo "libmurk exports data"; exit 1; }
exit 0
