#!/bin/sh
# light.murk used again gives the plan of the run that made it, also from the
# resolved scene in another folder; a light of another seed, scene or mesh is
# refused, and measuring a plan on its own light gives the plan's coverage.
# usage: light_again.sh MURK
set -eu
murk=$1
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
mkdir "$dir/scene"
cat >"$dir/scene/box.obj" <<'END'
v 0.1 0.1 0.1
v 3.9 0.1 0.1
v 3.9 3.9 0.1
v 0.1 3.9 0.1
f 1 2 3
f 1 3 4
END
cat >"$dir/scene/s.yaml" <<'END'
murk: 1
domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}
geometry: [{file: box.obj}]
media: {fog: {extinction_per_m: 0.3, albedo: 0.9, phase: {hg: 0.8}}}
regions: [{medium: fog}]
lights: [{type: point, position_m: [2, 2, 2.5], power_w: 10}]
photons: {emit: 5000}
sensors:
  types: [{name: node, range_m: 1.5}]
  candidates: {grid: {min_m: [0.5, 0.5, 0.5], max_m: [3.5, 3.5, 2.5], size: [4, 4, 3]}}
  count: 2
END
scene=$dir/scene/s.yaml
light=$dir/first/light.murk
"$murk" place "$scene" -q -o "$dir/first"
"$murk" place "$scene" -q -o "$dir/again" --light "$light"
"$murk" place "$dir/first/scene.resolved.yaml" -q -o "$dir/moved" --light "$light"
"$murk" place "$scene" -q -o "$dir/three" --light "$light" --count 3
for name in sensors.csv coverage.csv plan.ply light.murk; do
    cmp "$dir/first/$name" "$dir/again/$name"
    cmp "$dir/first/$name" "$dir/moved/$name"
done
plan() {
    sed '/^  "run": {/,$d' "$1"
}
plan "$dir/first/plan.json" >"$dir/a"
plan "$dir/again/plan.json" >"$dir/b"
cmp "$dir/a" "$dir/b"

for given in first/plan.json first/sensors.csv; do
    "$murk" sense "$scene" -q --sensors "$dir/$given" --light "$light" -o "$dir/sense"
    cmp "$dir/first/coverage.csv" "$dir/sense/coverage.csv"
    grep '"in_sample"' "$dir/first/plan.json" | head -1 >"$dir/a"
    grep '"in_sample"' "$dir/sense/coverage.json" | head -1 >"$dir/b"
    cmp "$dir/a" "$dir/b"
done

# seed and number of photons are the light's, also against the scene's own
"$murk" place "$scene" -q -o "$dir/seven" --seed 7 --emit 3000
"$murk" place "$scene" -q -o "$dir/seven-again" --light "$dir/seven/light.murk"
"$murk" place "$scene" -q -o "$dir/stored" --seed 7 --store 4000
"$murk" place "$scene" -q -o "$dir/stored-again" --light "$dir/stored/light.murk"
"$murk" place "$scene" -q -o "$dir/stored-said" --light "$dir/stored/light.murk" --seed 7 --set photons.store=4000
for name in seven seven-again stored stored-again stored-said; do
    plan "$dir/$name/plan.json" >"$dir/$name.plan"
done
cmp "$dir/seven.plan" "$dir/seven-again.plan"
cmp "$dir/stored.plan" "$dir/stored-again.plan"
cmp "$dir/stored.plan" "$dir/stored-said.plan"
grep -q '"seed": 7' "$dir/seven-again/plan.json"

refused() {
    part=$1
    shift
    if "$murk" place "$@" -q --light "$light" 2>"$dir/stderr"; then
        echo "not refused: $*"
        exit 1
    fi
    grep -qF -- "$part" "$dir/stderr" || { cat "$dir/stderr"; exit 1; }
}
refused "seed" "$scene" --seed 2
refused "extinction_per_m" "$scene" --set media.fog.extinction_per_m=0.31
refused "emit" "$scene" --emit 5001
refused "emit" "$scene" --set photons.emit=5001
refused "emit" "$scene" --set "photons={emit: 5001}"
refused "store" "$scene" --store 5000
printf 'f 1 2 4\n' >>"$dir/scene/box.obj"
refused "checksum" "$scene"
