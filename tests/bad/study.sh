#!/bin/sh
# Bad studies: one line on standard error that names the place, exit 2, nothing
# written, within 10 seconds of processor time and 2 GB. Under a sanitizer,
# which sets aside more, memory is not limited.
# usage: study.sh MURK [SANITIZER]
set -u
murk=$1
sanitizer=${2:-}
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
failed=0

cat >"$dir/scene.yaml" <<'END'
murk: 1
domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}
geometry: [{box: {min_m: [0.1, 0.1, 0.1], max_m: [3.9, 3.9, 2.9]}}]
media: {fog: {extinction_per_m: 0.3, albedo: 0.9}}
regions: [{medium: fog}]
lights: [{type: point, position_m: [2, 2, 2.5], power_w: 10}]
photons: {emit: 500}
tallies: [{name: floor, type: plane, point_m: [2, 2, 1], normal: [0, 0, -1]}]
conditions: {clear: {media.fog.extinction_per_m: 0}}
END

# refused PART-OF-MESSAGE STUDY OPTIONS...
refused() {
    part=$1
    echo "$2" >"$dir/bad.yaml"
    shift 2
    (
        ulimit -t 10
        [ -n "$sanitizer" ] || ulimit -v 2000000
        MALLOC_ARENA_MAX=2 timeout 60 "$murk" study "$dir/bad.yaml" -o "$dir/out" "$@"
    ) >"$dir/stdout" 2>"$dir/stderr"
    got=$?
    if [ "$got" -ne 2 ] || [ "$(wc -l <"$dir/stderr")" -ne 1 ] || ! grep -qF -- "$part" "$dir/stderr"; then
        cat "$dir/bad.yaml"
        echo "  exit $got, want 2; want one line with: $part"
        sed 's/^/  /' "$dir/stderr"
        failed=1
    fi
    if [ -d "$dir/out" ]; then
        echo "made $dir/out"
        failed=1
        rm -rf "$dir/out"
    fi
}

head='murk_study: 1
base: scene.yaml'
power='lights.0.power_w'
refused 'bad.yaml:1:1: misses murk_study' 'base: scene.yaml
axes: {}'
refused 'a best plan for placement.at_least, which' "$head
axes: {placement.redundancy: [1, 2]}
outputs: [coverage_best]" --set 'sensors={types: [{name: node, range_m: 3}], target: 0.1}' --set placement.at_least=2
refused 'murk_study: 2, must be 1' 'murk_study: 2
base: scene.yaml
axes: {}'
refused 'misses base, must be the name of a file' 'murk_study: 1
axes: {}'
refused 'misses axes, must be a map' "$head"
refused 'axis: unknown key, did you mean axes?' "$head
axis: {}"
refused "nowhere.yaml" 'murk_study: 1
base: nowhere.yaml
axes: {}'
# rows that are too many, before any of them is made
refused 'axes: 1000000000 rows, must be at most 10000' "$head
axes: {lights.0.power_w: {from: 1, to: 2, steps: 1000}, seed: {from: 1, to: 1000, steps: 1000}, media.fog.albedo: {from: 0, to: 1, steps: 1000}}"
refused 'bad.yaml:3:50: axes.lights.0.power_w.steps: 1e9, must be 1..10000' "$head
axes: {lights.0.power_w: {from: 1, to: 2, steps: 1e9}}"
refused 'bad.yaml:3:40: axes.seed.steps: 1000000000, must be 1..10000' "$head
axes: {seed: {from: 1, to: 1e9, steps: 1000000000}}"
refused 'steps: -3, must be 1..10000' "$head
axes: {$power: {from: 1, to: 2, steps: -3}}"
refused 'axes.lights.0.power_w: misses steps, must be a whole number' "$head
axes: {$power: {from: 1, to: 2}}"
refused 'from and to, must be two numbers' "$head
axes: {$power: {from: 1, to: 06:00, steps: 3}}"
refused 'from: 2026-06-21T00:00:00, must be a number, a time with the zone' "$head
axes: {$power: {from: 2026-06-21T00:00:00, to: 2026-06-22T00:00:00, steps: 3}}"
refused 'spacing: log, from and to must be numbers above 0' "$head
axes: {$power: {from: 0, to: 1, steps: 3, spacing: log}}"
refused 'axes.lights.0.power_w.step: unknown key, did you mean steps?' "$head
axes: {$power: {from: 0, to: 1, step: 3}}"
refused '0 values, must be 1..10000' "$head
axes: {$power: []}"
refused 'axes.lights.0.power_w: 5, must be a list of values' "$head
axes: {$power: 5}"
refused '5, must be a map of keys and values' "$head
axes: {weather: {dry: 5}}"
refused 'a key belongs to one axis' "$head
axes: {$power: [1, 2], lamp: {on: {lights.0: {type: point, position_m: [1, 1, 1], power_w: 1}}}}"
refused 'of which one lies within the other' "$head
axes: {lamp: {on: {lights.0.power_w: 1, lights.0: {type: point, position_m: [1, 1, 1], power_w: 1}}}}"
refused '2 values, must be as many as axis lights.0.power_w has, 3 (mode: paired)' "$head
mode: paired
axes: {$power: [1, 2, 3], seed: [1, 2]}"
refused 'mode: pair, must be grid, paired' "$head
mode: pair
axes: {}"
refused 'axes.a\x01b: a name with control characters' "$head
axes: {\"a\\x01b\": [1]}"
refused 'a name with control characters' "$head
axes: {lamp: {on: {\"a\\x01b\": 1}}}"
# values that no row can have
refused 'no meda in the scene, did you mean media?' "$head
axes: {meda.fog.albedo: [0.1, 0.2]}"
refused 'no albdo in media, did you mean albedo?' "$head
axes: {media.fog.albdo: [0.1, 0.2]}"
refused 'item 7 of a list of 1, must be 0..0' "$head
axes: {lights.7.power_w: [0.1, 0.2]}"
refused 'no fgo in media, did you mean fog?' "$head
axes: {media.fgo.albedo: [0.1, 0.2]}"
refused 'media.fog.albedo: 7, must be 0..1' "$head
axes: {media.fog.albedo: [7, 8]}"
refused 'conditions: claer is none of them, did you mean clear?' "$head
axes: {condition: [claer]}"
refused 'must be the name of a condition' "$head
axes: {condition: [[clear]]}"
# outputs
refused 'outputs: densty is no output, did you mean density?' "$head
axes: {}
outputs: [densty]"
refused 'density stands there twice' "$head
axes: {}
outputs: [density, density]"
refused 'coverage_fixed needs a plan' "$head
axes: {}
outputs: [coverage_fixed]"
refused 'coverage needs sensors' "$head
axes: {}
outputs: [coverage_best]"
refused 'plan.csv: cannot read' "$head
axes: {}
plan: plan.csv"
refused '/dev/zero: cannot read: not a file' "$head
axes: {}
plan: /dev/zero"
refused 'scene.yaml:2: 6 cells' "$head
axes: {}
plan: scene.yaml"
refused 'at most 2^31 cells' "$head
axes: {}
fluence_size: [4096, 4096, 4096]
outputs: [fluence_vdb]"
refused 'fluence_size' "$head
axes: {}
fluence_size: [1, 2]
outputs: [fluence_vdb]"
refused 'units: photns, must be radiometric' "$head
axes: {}
units: photns"
refused 'is set on the command line, too' "$head
axes: {$power: [1, 2]}" --set lights.0.power_w=5
exit $failed
