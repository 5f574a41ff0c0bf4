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
# smoke that is in one condition only is no mistake; in none, it is
smoke='placement.interest=[{name: a, medium: smoke}]'
over() {
    timeout 60 "$murk" place "$dir/hall.yaml" --quiet --set "$smoke" --set placement.over=mean --set "$1"
}
over 'conditions={fire: {}, clear: {media.smoke.extinction_per_m: 0}}' ||
    { echo "a region in one condition is refused"; failed=1; }
expect 1 "a is empty: none of the stored photons" --set "$smoke" --set placement.over=mean \
    --set 'conditions={clear: {media.smoke.extinction_per_m: 0}}'
# nothing has weight
expect 2 "all 0, one must be more than 0" --set placement.elsewhere=0
interest 1 "have no weight" '{name: a, material: wall, weight: 0}, {name: b, medium: smoke, weight: 0}, {name: c, weight: 0, material: crate}'

# ---- targets ----

# targets CODE PART-OF-MESSAGE MAP
targets() {
    expect "$1" "$2" --set "placement.targets=$3"
}
list() {
    printf "$3" >"$dir/list.csv"
    targets "$1" "$2" "{points: $dir/list.csv}"
}
targets 2 "light, must be photons or a map of keys" light
targets 2 "names no targets" '{band_nm: 550}'
targets 2 "points must stand alone" "{points: $dir/list.csv, surfaces: {}}"
targets 2 "560 nm is none of the scene's bands" '{surfaces: {}, band_nm: 560}'
targets 2 "0, must be 1..1e8 points" '{surfaces: {points: 0}}'
targets 2 "has points and spacing_m" '{surfaces: {points: 5, spacing_m: 1}}'
targets 2 "1e-6, must be 1..1e8 points" '{surfaces: {points: 1e-6}}'
targets 2 "spacing_m makes 8.6e+13 points" '{surfaces: {spacing_m: 1e-6}}'
targets 2 "spacing_m makes 4.8e+19 points" '{volume: {spacing_m: 1e-6}}'
targets 2 "an empty list, must be all or a list of names of materials" '{surfaces: {materials: []}}'
targets 2 "did you mean wall?" '{surfaces: {materials: [wal]}}'
targets 2 "no surface is of such a material" '{surfaces: {materials: [gold]}}'
targets 2 "min must be less than max" '{volume: {box: {min_m: [0, 0, 0], max_m: [1, 1, 0]}}}'
targets 2 "holds none of the domain's space" '{volume: {box: {min_m: [5, 0, 0], max_m: [6, 1, 1]}}}'
targets 2 "holds none of the domain's space" '{volume: {medium: steam}}'
targets 2 "lies in free space" '{volume: {sphere: {center_m: [1.5, 1.5, 0.5], radius_m: 0.2}}}'
targets 2 "open edges" "{volume: {mesh: $dir/open.obj}}"
targets 2 "not a key of a volume (without a shape)" '{volume: {scale: 2}}'
targets 2 "cannot read" "{points: $dir/no-such.csv}"
list 2 "misses column z_m" 'x_m,y_m\n1,1\n'
list 2 "list.csv:2" 'x_m,y_m,z_m\n1,1,9\n'
list 2 "0 targets, must be one or more" 'x_m,y_m,z_m\n'
list 2 "lies on a surface" 'x_m,y_m,z_m\n3,3,0\n'
expect 2 "arrival is toward, must be any" --set 'placement.targets={surfaces: {}}' \
    --set sensors.types.0.arrival=toward
expect 1 "a is empty: none of the" --set 'placement.targets={surfaces: {materials: [crate]}}' \
    --set 'placement.interest=[{name: a, material: wall}]'

exit $failed
