#!/bin/sh
# Every result file is the same for photons traced one by one and side by side
# with each instruction set (MURK_LANES, src/base/lanes.h), but for the
# object "run", which stands last in each JSON: with a number of stored photons,
# so that a batch is cut, in two bands, through even media, a grid of smoke, and
# a room of surfaces in mist and in clear air.
# usage: lanes.sh MURK SMOKE.vdb
set -eu
murk=$1
smoke=$2
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cat >"$dir/even.yaml" <<END
murk: 1
bands_nm: [450, 650]
domain: {min_m: [0, 0, 0], max_m: [6, 6, 4]}
media:
  fog: {extinction_per_m: [0.5, 0.8], albedo: [0.9, 0.7], phase: {hg: 0.8}}
  haze: {extinction_per_m: [2, 1], albedo: 0.95, phase: {hg: 0.3}}
regions:
  - {medium: fog}
  - {medium: haze, sphere: {center_m: [3, 3, 2], radius_m: 1}, replace: true}
lights:
  - {type: point, position_m: [1, 1, 1], power_w: [1, 2]}
  - {type: directional, direction: [0, 0.2, -1], irradiance_w_per_m2: 1}
photons: {store: 20000, maps: volume, least_weight: 0.1}
tallies:
  - {name: light, type: grid, min_m: [0, 0, 0], max_m: [6, 6, 4], size: [12, 10, 8]}
  - {name: floor, type: plane, point_m: [0, 0, 0], normal: [0, 0, -1], bins: [4, 4]}
END
cat >"$dir/smoke.yaml" <<END
murk: 1
domain: {min_m: [-2, -2, -1], max_m: [2, 2, 4]}
media:
  smoke: {extinction_per_m: 3, albedo: 0.8, phase: {hg: 0.4}, vdb: $smoke}
regions:
  - {medium: smoke, translate_m: [-2, -2, -2]}
lights:
  - {type: point, position_m: [0, 0, 3], power_w: 1}
photons: {emit: 5000, maps: volume}
END
for room in misty clear; do
    extinction=0.4
    [ $room = misty ] || extinction=0
    cat >"$dir/$room.yaml" <<END
murk: 1
bands_nm: [450, 650]
domain: {min_m: [-1, -1, 0], max_m: [7, 7, 3], sides: open}
materials:
  paint: {diffuse: [0.7, 0.4]}
  varnish: {diffuse: 0.4, specular: 0.3}
  glass: {transmit: 1, ior: 1.5}
geometry:
  - {rect: {corner_m: [0, 0, 0], edge1_m: [6, 0, 0], edge2_m: [0, 6, 0]}, material: paint}
  - {rect: {corner_m: [0, 0, 3], edge1_m: [6, 0, 0], edge2_m: [0, 6, 0]}, material: paint}
  - {rect: {corner_m: [0, 0, 0], edge1_m: [6, 0, 0], edge2_m: [0, 0, 3]}, material: varnish}
  - {rect: {corner_m: [0, 6, 0], edge1_m: [6, 0, 0], edge2_m: [0, 0, 3]}, material: paint}
  - {sphere: {center_m: [3, 3, 1], radius_m: 0.5}, material: glass}
media:
  mist: {extinction_per_m: $extinction, albedo: [0.9, 0.8], phase: {hg: 0.5}}
regions:
  - {medium: mist, box: {min_m: [0, 0, 0], max_m: [6, 6, 3]}}
lights:
  - {type: point, position_m: [2, 2, 3], power_w: [1, 2]}
  - {type: directional, direction: [1, 0.2, -0.5], irradiance_w_per_m2: 1}
photons: {store: 20000, maps: both, least_weight: 0.3}
tallies:
  - {name: light, type: grid, min_m: [0, 0, 0], max_m: [6, 6, 3], size: [12, 10, 8]}
END
done
compared=0
for scene in even smoke misty clear; do
    for lanes in off baseline avx2 avx512; do
        MURK_LANES=$lanes "$murk" trace "$dir/$scene.yaml" --threads 2 --quiet \
            -o "$dir/$scene-$lanes"
    done
    for file in "$dir/$scene-off"/*; do
        name=$(basename "$file")
        for lanes in baseline avx2 avx512; do
            for kind in off "$lanes"; do
                sed '/^  "run": {/,$d' "$dir/$scene-$kind/$name" >"$dir/$kind.part"
            done
            case "$name" in
            *.json) cmp "$dir/off.part" "$dir/$lanes.part" ;;
            *) cmp "$file" "$dir/$scene-$lanes/$name" ;;
            esac || { echo "$scene: $name differs: off and $lanes"; exit 1; }
            compared=$((compared + 1))
        done
    done
done
[ "$compared" -ge 42 ] || { echo "only $compared comparisons"; exit 1; }
# The records are stored: 32 bytes each.
for scene in even smoke misty clear; do
    [ "$(wc -c <"$dir/$scene-off/light.murk")" -ge 50000 ] || {
        echo "$scene: hardly any record"
        exit 1
    }
done
# The files hold something: another seed gives other light.
"$murk" trace "$dir/even.yaml" --threads 2 --quiet -o "$dir/other" --seed 5
for name in light.murk light.vdb; do
    if cmp -s "$dir/even-off/$name" "$dir/other/$name"; then
        echo "another seed gave the same $name"
        exit 1
    fi
done
echo "$compared files compared"
