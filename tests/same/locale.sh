#!/bin/sh
# A host program's locale with a decimal comma changes no result: plans, fields,
# meshes, presets, studies, fits and pages are the same with it and without,
# and numbers on the command line and in messages have a point.
# usage: locale.sh MURK PRELOADED LOCPATH
set -eu
murk=$1
preloaded=$2
locales=$3
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
# run COMMAND...: in the folder that $out names
comma() {
    env LD_PRELOAD="$preloaded" MURK_TEST_LOCALE=de_DE.UTF-8 LOCPATH="$locales" "$murk" "$@"
}
status=0
comma --version >"$dir/version" 2>&1 || status=$?
if [ "$status" = 77 ]; then
    echo "skipped: no locale de_DE.UTF-8 could be built (package locales)"
    exit 77
fi
without_run() { # the command's own facts, and the folder it wrote to
    sed -e '/^  "run": {/,$d' "$1"
}
compared=0
same() { # NAME COMMAND OPTIONS...: result files and what is said
    name=$1
    shift
    "$murk" "$@" -o "$dir/$name.point" >"$dir/$name.point.said" 2>&1 || { cat "$dir/$name.point.said"; exit 1; }
    comma "$@" -o "$dir/$name.comma" >"$dir/$name.comma.said" 2>&1 || { cat "$dir/$name.comma.said"; exit 1; }
    for file in "$dir/$name.point"/*; do
        other=$dir/$name.comma/$(basename "$file")
        case "$file" in
        *.json)
            without_run "$file" >"$dir/a"
            without_run "$other" >"$dir/b"
            cmp "$dir/a" "$dir/b" || { diff "$dir/a" "$dir/b" | head -n 5; exit 1; }
            ;;
        *) cmp "$file" "$other" || exit 1 ;;
        esac
        compared=$((compared + 1))
    done
    # times and sizes differ from run to run; a comma between digits is a fault
    if grep -nE '[0-9],[0-9]{1,2}([^0-9]|$)' "$dir/$name.comma.said" >"$dir/commas"; then
        grep -nE '[0-9],[0-9]{1,2}([^0-9]|$)' "$dir/$name.point.said" >"$dir/usual" || true
        cmp -s "$dir/commas" "$dir/usual" || { echo "$name: numbers with a comma"; cat "$dir/commas"; exit 1; }
    fi
}
same place place scenes/fog-yard.yaml --emit 500 --count 2 --set placement.restarts=2 \
    --set media.fog.visibility_m=12.75 --export fields,photons --voxel 2.5 --threads 2
same trace trace scenes/smoke-hall.yaml --emit 500 --threads 2
same fit fit scenes/calibrate-fog.yaml --data scenes/calibrate/fog.csv --emit 2000 --starts 1 \
    --free media.fog.extinction_per_m,media.fog.phase.hg
[ "$compared" -ge 20 ] || { echo "only $compared files"; exit 1; }
# a refusal names the number as it was written
if comma check scenes/fog-yard.yaml --set domain.min_m=[0,0,12.75] --set seed=1.5 >"$dir/said" 2>&1; then
    echo "a seed of 1.5 was taken"
    exit 1
fi
grep -q '1\.5' "$dir/said" || { cat "$dir/said"; exit 1; }
