#!/bin/sh
# tools/tables prints the paper's figures beside ours: best is no less than
# plain SPOQ on the same light and no more than the optimum, and the paper's own
# columns are the paper's.
# usage: tables.sh MURK
set -eu
command -v python3 >/dev/null || { echo "skipped: no python3"; exit 77; }
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
tools/tables --murk "$1" --photons 1000 --seeds 2 >"$dir/table"
awk -F '|' '
function holds(condition, what) {
    if (!condition) {
        print "does not hold: " what ": " $0
        bad = 1
    }
}
/268 triangles, 1188 stations/ { sizes = 1 }
/^\*\*Table 1, six rooms: 1000 photons/ { tables = 1 }
/^\*\*Table 1, one room: 1000 photons/ { ++tables; last = 0 }
/^\| 10000 \| (known|unknown) / { ++growth }
/^\| [2-5] / {
    ++rows
    paper = paper $2 + 0 ":" $3 + 0 ":" $15 + 0 " "
    holds(NF == 16, "14 columns")
    holds($14 + 0 <= $13 + 0, "choosing takes no more than seeing and choosing")
    holds($6 + 0 <= $8 + 0, "best is no worse than SPOQ")
    holds($7 + 0 <= $8 + 0, "best is no worse than greedy")
    holds($7 + 0 >= .632 * $8, "greedy has its guarantee")
    holds($8 + 0 <= $9 + 0, "no better than the optimum")
    holds($8 + 0 >= last + 0, "more observers see no less")
    last = $8
}
END {
    holds(sizes && tables == 2 && rows == 8, "the sizes, two titles, eight rows")
    holds(growth == 2, "memory and growth, known and unknown")
    once = "2:95.3:0.8 3:96.5:4.5 4:95.8:3.9 5:97:2.9 "
    holds(paper == once once, paper)
    exit bad
}' "$dir/table" || {
    cat "$dir/table"
    exit 1
}
for wrong in --photons=2000 --seeds=0 --sizes=3; do
    if tools/tables --murk "$1" "$wrong" >"$dir/out" 2>&1; then
        echo "$wrong is not refused"
        exit 1
    fi
done
echo "the table is as it should be"
