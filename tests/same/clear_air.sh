#!/bin/sh
# Extinction 0 everywhere gives exactly the plan of the same scene without
# media.
# usage: clear_air.sh MURK
set -eu
murk=$1
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
sed -n '/^media:/,/^$/!p' scenes/smoke-hall.yaml | sed -n '/^regions:/,/^$/!p' |
    sed '/^conditions:/,$d' |
    sed "s|meshes/|$PWD/scenes/meshes/|" >"$dir/without.yaml"
if grep -qE '^(media|regions):' "$dir/without.yaml"; then
    echo "the media are still there"
    exit 1
fi
set -- --emit 20000 --set placement.restarts=5 --quiet --format text
"$murk" place scenes/smoke-hall.yaml "$@" -o "$dir/zero" \
    --set media.smoke.extinction_per_m=0 --set media.haze.extinction_per_m=0
"$murk" place "$dir/without.yaml" "$@" -o "$dir/none"
"$murk" place scenes/smoke-hall.yaml "$@" -o "$dir/smoke"
# the plan without what names the run: scene, identity, checksums of its files
plan() {
    sed -e '/^  "run": {/,$d' -e '/"scene/d' -e '/^  "identity": /d' \
        -e '/^  "files": {/,/}/d' "$1/plan.json"
}
plan "$dir/zero" >"$dir/a"
plan "$dir/none" >"$dir/b"
plan "$dir/smoke" >"$dir/c"
grep -q '"sensors"' "$dir/a"
cmp "$dir/a" "$dir/b"
cmp "$dir/zero/sensors.csv" "$dir/none/sensors.csv"
if cmp -s "$dir/a" "$dir/c"; then
    echo "the smoke changes nothing"
    exit 1
fi
