#!/bin/sh
# OR-Library's set covering file scp41 as maximum coverage, by the command: 2,
# 3, 4 and 5 columns cover at most 21, 30, 39 and 48 rows (placement.md's gate,
# proven by others), and here, too, it is proven. Source: Beasley, J. Oper.
# Res. Soc. 41 (1990) 1069.
# usage: matrix.sh MURK
set -eu
murk=$1
file=../shared/data/placement/scp41.txt
[ -e "$file" ] || {
    echo "skipped: no $file"
    exit 77
}
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT

# has TEXT: plan.json, on one line without blanks, holds it
has() {
    tr -d ' \n' <"$dir/plan.json" | grep -qF -- "$1" || {
        echo "plan.json lacks $1"
        tr -d '\n' <"$dir/plan.json"
        exit 1
    }
}

count=2
for rows in 21 30 39 48; do
    "$murk" place --matrix "$file" --count $count -q -o "$dir"
    has '"rows":200,"columns":1000,"entries":4009'
    has "\"covered\":$rows,\"covered_at_most\":$rows}"
    has '"proven_optimal":true'
    # and as many rows are the target of as many columns, and of no fewer
    share=$(awk "BEGIN { print $rows / 200 }")
    "$murk" place --matrix "$file" --target "$share" -q -o "$dir"
    has "\"covered\":$rows,"
    has "\"asked\":$share,\"fewest_possible\":$count,"
    count=$((count + 1))
done
# one row more than 48 takes a sixth
"$murk" place --matrix "$file" --target 0.245 -q -o "$dir"
has '"fewest_possible":6,'
echo "scp41: 21, 30, 39 and 48 rows, proven"
