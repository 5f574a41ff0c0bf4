#!/bin/sh
# The reference cases give the same numbers for 1, 2 and 5 threads: by events,
# by murk's tallies, with weights, in a wide and in a periodic domain. Joined,
# they are the same again, and rows of another seed are refused.
set -eu
validate=$1
cases='published/oblique published/plane'
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
for threads in 1 2 5; do
    # shellcheck disable=SC2086
    "$validate" --quick --threads $threads --csv "$dir/$threads.csv" $cases \
        "slabs/albedo 0.5 g 0.5 tau 1" >"$dir/$threads.md" 2>"$dir/log" || {
        cat "$dir/log"
        exit 1
    }
done
for threads in 2 5; do
    cmp "$dir/1.csv" "$dir/$threads.csv"
    cmp "$dir/1.md" "$dir/$threads.md"
done
"$validate" --csv "$dir/joined.csv" --join "$dir/1.csv" >"$dir/joined.md"
cmp "$dir/1.csv" "$dir/joined.csv"
cmp "$dir/1.md" "$dir/joined.md"
sed 's/,quick,1,/,quick,2,/' "$dir/1.csv" >"$dir/other.csv"
if cmp -s "$dir/1.csv" "$dir/other.csv" ||
    "$validate" --join "$dir/1.csv" "$dir/other.csv" >/dev/null 2>"$dir/log" ||
    ! grep -q 'seed 2, but rows before have seed 1' "$dir/log"; then
    echo "rows of two seeds were joined" >&2
    exit 1
fi
