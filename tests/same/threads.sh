#!/bin/sh
# Every result file is the same for 1, 2 and 5 threads, in runs of their own,
# but for the object "run", which stands last in each JSON.
# usage: threads.sh MURK SCENE [OPTIONS...]
set -eu
murk=$1
scene=$2
shift 2
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
without_run() {
    sed '/^  "run": {/,$d' "$1"
}
for variant in 1 2 5; do
    "$murk" place "$scene" --threads "$variant" --quiet -o "$dir/$variant" "$@"
done
compared=0
for file in "$dir"/1/*; do
    name=$(basename "$file")
    for variant in 2 5; do
        case "$name" in
        *.json)
            without_run "$file" >"$dir/a"
            without_run "$dir/$variant/$name" >"$dir/b"
            [ -s "$dir/a" ]
            cmp "$dir/a" "$dir/b" || { echo "$name differs: 1 and $variant"; exit 1; }
            ;;
        *)
            cmp "$file" "$dir/$variant/$name" || { echo "$name differs: 1 and $variant"; exit 1; }
            ;;
        esac
        compared=$((compared + 1))
    done
done
[ "$compared" -ge 14 ] || { echo "only $compared comparisons of 7 files"; ls "$dir/1"; exit 1; }
# teeth: another seed must not give the same light
"$murk" place "$scene" --threads 2 --quiet -o "$dir/other" "$@" --seed 12345
if cmp -s "$dir/1/light.murk" "$dir/other/light.murk"; then
    echo "another seed gave the same light"
    exit 1
fi
