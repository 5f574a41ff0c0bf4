#!/bin/sh
# Bad goals: regions of interest that are empty or say nothing. One line on
# standard error, the right exit code, nothing written.
# usage: goals.sh MURK
set -u
murk=$1
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
failed=0

cat >"$dir/hall.yaml" <<'END'
murk: 1
domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}
geometry:
  - {box: {min_m: [0, 0, 0], max_m: [4, 4, 3]}, material: wall}
  - {box: {min_m: [1, 1, 0], max_m: [2, 2, 1]}, material: crate}
materials: {wall: {diffuse: 0.5}, crate: {diffuse: 0.5}, gold: {diffuse: 0.5}}
media: {smoke: {extinction_per_m: 0.5, albedo: 0.9}, steam: {extinction_per_m: 1, albedo: 1}}
regions: [{medium: smoke, box: {min_m: [0, 0, 2], max_m: [4, 4, 3]}}]
lights: [{type: point, position_m: [3, 3, 2.5], power_w: 10}]
photons: {emit: 2000}
sensors:
  types: [{name: node, range_m: 3}]
  candidates: {grid: {min_m: [0.5, 0.5, 1.5], max_m: [3.5, 3.5, 2.5], size: [4, 4, 2]}}
  count: 2
END
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n' \
    >"$dir/open.obj"

# expect CODE PART-OF-MESSAGE ARGS...: runs murk place, which must say that
expect() {
    code=$1
    part=$2
    shift 2
    timeout 60 "$murk" place "$dir/hall.yaml" -o "$dir/out" "$@" \
        >"$dir/stdout" 2>"$dir/stderr"
    got=$?
    lines=$(grep -cv '^murk: warning:' "$dir/stderr")
    if [ "$got" -ne "$code" ] || [ "$lines" -ne 1 ] ||
        ! grep -qF -- "$part" "$dir/stderr"; then
        echo "murk place $*"
        echo "  exit $got, want $code; want one line with: $part"
        sed 's/^/  /' "$dir/stderr"
        failed=1
    fi
    if [ -d "$dir/out" ] && [ -n "$(ls -A "$dir/out")" ]; then
        echo "murk place $*: wrote $(ls -A "$dir/out")"
        failed=1
    fi
    rm -rf "$dir/out"
}

# interest CODE PART-OF-MESSAGE ITEMS
interest() {
    expect "$1" "$2" --set "placement.interest=[$3]"
}

# what cannot be a region of interest at all
interest 2 "says no place" '{name: a}'
interest 2 "misses name" '{box: {min_m: [0, 0, 0], max_m: [1, 1, 1]}}'
interest 2 "min must be less than max" '{name: a, box: {min_m: [0, 0, 0], max_m: [1, 1, 0]}}'
interest 2 "must be more than 0" '{name: a, sphere: {center_m: [1, 1, 1], radius_m: 0}}'
interest 2 "nan, must be" '{name: a, sphere: {center_m: [1, 1, 1], radius_m: nan}}'
interest 2 "-1, must be 0..1e6" '{name: a, weight: -1, material: wall}'
interest 2 "did you mean wall?" '{name: a, material: wal}'
interest 2 "has box and sphere" '{name: a, box: {min_m: [0, 0, 0], max_m: [1, 1, 1]}, sphere: {center_m: [1, 1, 1], radius_m: 1}}'
interest 2 "has material and medium" '{name: a, material: wall, medium: smoke}'
interest 2 "a is the name of an earlier" '{name: a, material: wall}, {name: a, material: crate}'
interest 2 "not a key of a region of interest (box)" '{name: a, box: {min_m: [0, 0, 0], max_m: [1, 1, 1]}, unit_m: 1}'
interest 2 "open edges" "{name: a, mesh: $dir/open.obj}"
interest 2 "no-such.obj" "{name: a, mesh: $dir/no-such.obj}"
# empty before anything is traced
interest 2 "a is empty: it spans" '{name: a, box: {min_m: [5, 0, 0], max_m: [6, 1, 1]}}'
interest 2 "no surface is of material gold" '{name: a, material: gold}'
interest 2 "medium steam is in no region" '{name: a, medium: steam}'
# empty once it is: the inside of the crate, and the crate in the smoke
interest 1 "a is empty: none of the" '{name: a, sphere: {center_m: [1.5, 1.5, 0.5], radius_m: 0.2}}'
interest 1 "placement.interest.1: b is empty" '{name: a, material: wall}, {name: b, material: crate, box: {min_m: [0, 0, 2], max_m: [4, 4, 3]}}'
# nothing has weight
expect 2 "all 0, one must be more than 0" --set placement.elsewhere=0
interest 1 "have no weight" '{name: a, material: wall, weight: 0}, {name: b, medium: smoke, weight: 0}, {name: c, weight: 0, material: crate}'

exit $failed
