#!/bin/sh
# Known and unknown environments lead SPOQ and best to the same plan, in clear
# air and through smoke.
# usage: known_unknown.sh MURK
set -eu
murk=$1
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
for case in "paper-room 1500 best" "paper-room 1500 spoq" "paper-room 1500 greedy" "smoke-hall 1500 best"; do
    # shellcheck disable=SC2086
    set -- $case
    for knowledge in known unknown; do
        "$murk" place "scenes/$1.yaml" --quiet --store "$2" -o "$dir/$knowledge" \
            --set "placement={method: $3, restarts: 2, nodes: 0, knowledge: $knowledge}"
    done
    cmp "$dir/known/sensors.csv" "$dir/unknown/sensors.csv"
    cmp "$dir/known/coverage.csv" "$dir/unknown/coverage.csv"
    grep -q '"knowledge": "unknown"' "$dir/unknown/plan.json"
done
# teeth: plain SPOQ from another start does end elsewhere
for seed in 1 2; do
    "$murk" trace scenes/paper-room.yaml --quiet --store 1500 -o "$dir/$seed" --seed $seed
    "$murk" place scenes/paper-room.yaml --quiet --store 1500 -o "$dir/$seed" --seed $seed \
        --light "$dir/$seed/light.murk" --set placement.method=spoq
done
if cmp -s "$dir/1/sensors.csv" "$dir/2/sensors.csv"; then
    echo "another seed gave the same sensors"
    exit 1
fi
