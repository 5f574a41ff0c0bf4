#!/bin/sh
# A fit is the same for 1, 2 and 5 threads, in runs of their own: fit.json but for
# its object "run", fit.csv and calibrated.yaml. Rows of light in two conditions
# with the next places, of a grid, of bands, of coverage; and a key that turns
# the world.
# usage: fit.sh MURK
set -eu
murk=$1
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
compared=0
fit() { # OUT NAME OPTIONS...
    out=$1
    name=$2
    shift 2
    "$murk" fit "scenes/calibrate-$name.yaml" --data "scenes/calibrate/$name.csv" --quiet --force -o "$dir/$out" "$@" \
        2>"$dir/said" || { cat "$dir/said"; exit 1; }
    sed '/^  "run": {/,$d' "$dir/$out/fit.json" >"$dir/$out/fit.json.kept"
    [ -s "$dir/$out/fit.json.kept" ]
    rm "$dir/$out/fit.json"
}
same() { # NAME OPTIONS...
    for variant in 1 2 5; do
        fit "$variant" "$@" --threads "$variant"
    done
    for variant in 2 5; do
        for file in fit.json.kept fit.csv calibrated.yaml; do
            cmp "$dir/1/$file" "$dir/$variant/$file" || { echo "$1: $file differs: 1 and $variant"; exit 1; }
            compared=$((compared + 1))
        done
    done
}
same fog --emit 10000 --next 2 --free media.fog.extinction_per_m,media.fog.phase.hg
# teeth: another seed gives another fit
fit other fog --emit 10000 --next 2 --free media.fog.extinction_per_m,media.fog.phase.hg --seed 2
if cmp -s "$dir/1/calibrated.yaml" "$dir/other/calibrated.yaml"; then
    echo "another seed gave the same fit"
    exit 1
fi
same smoke --emit 20000 --starts 2 --loss huber --free media.smoke.extinction_per_m,media.smoke.albedo
same water --emit 20000 --starts 2 --free media.sea.extinction_per_m.1,media.sea.albedo.1
same coverage --emit 500 --free media.fog.visibility_m --set placement.detection=independent
same fog --emit 5000 --traces 3 --starts 2 --free media.fog.extinction_per_m,lights.0.divergence_deg
[ "$compared" -eq 30 ] || { echo "only $compared comparisons"; exit 1; }
