#!/bin/sh
# Every result file is the same for records in memory and in a scratch file
# (MURK_MEMORY_MB, src/base/block.h), but for the object "run", which stands last
# in each JSON: a trace, parts of a trace that are merged, a plan, and coverage
# measured with light that was read. A folder without space for the scratch file
# is one line.
# usage: memory.sh MURK
set -eu
murk=$1
scene=scenes/paper-room.yaml
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
compared=0
# same A B: compares the files of two result folders.
same() {
    for file in "$dir/$1"/*; do
        name=$(basename "$file")
        for folder in "$1" "$2"; do
            sed '/^  "run": {/,$d' "$dir/$folder/$name" >"$dir/$folder.part"
        done
        case "$name" in
        *.json) cmp "$dir/$1.part" "$dir/$2.part" ;;
        *) cmp "$file" "$dir/$2/$name" ;;
        esac || { echo "$name differs: $1 and $2"; exit 1; }
        compared=$((compared + 1))
    done
}
for memory in much none; do
    if [ $memory = none ]; then
        MURK_MEMORY_MB=0
    else
        MURK_MEMORY_MB=100000
    fi
    export MURK_MEMORY_MB
    "$murk" trace "$scene" --store 200000 --quiet -o "$dir/trace-$memory"
    for part in 1 2; do
        "$murk" trace "$scene" --store 200000 --shard $part/2 --quiet \
            -o "$dir/part$part-$memory"
    done
    "$murk" merge "$dir/part1-$memory" "$dir/part2-$memory" --quiet \
        -o "$dir/merged-$memory"
    "$murk" place "$scene" --store 20000 --quiet -o "$dir/place-$memory"
    "$murk" sense "$scene" --store 20000 --light "$dir/place-much/light.murk" \
        --sensors "$dir/place-much/plan.json" --quiet -o "$dir/sense-$memory"
done
same trace-much trace-none
same merged-much merged-none
cmp "$dir/trace-none/light.murk" "$dir/merged-none/light.murk"
same place-much place-none
same sense-much sense-none
[ "$compared" -ge 14 ] || { echo "only $compared comparisons"; exit 1; }
# Records in a file, and no such folder: each command needs one.
MURK_MEMORY_MB=0
TMPDIR=/nowhere/at/all
export MURK_MEMORY_MB TMPDIR
refused() {
    status=0
    said=$("$murk" "$@" --quiet -o "$dir/nowhere" 2>&1) || status=$?
    case "$said" in
    */nowhere/at/all*) ;;
    *) status=0 ;;
    esac
    [ "$status" -ne 0 ] && [ "$(echo "$said" | wc -l)" = 1 ] && [ ! -e "$dir/nowhere" ] || {
        echo "no scratch folder: $1: $said"
        exit 1
    }
}
refused trace "$scene" --store 20000
refused merge "$dir/part1-much" "$dir/part2-much"
refused place "$scene" --store 20000
refused sense "$scene" --store 20000 --light "$dir/place-much/light.murk" \
    --sensors "$dir/place-much/plan.json"
echo "$compared files compared"
