#!/bin/sh
# Bad conditions: one line on standard error that names the place, the right
# exit code, nothing written, within 10 seconds of processor time and 2 GB.
# Under a sanitizer, which sets aside more, memory is not limited.
# usage: conditions.sh MURK [SANITIZER]
set -u
murk=$1
sanitizer=${2:-}
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
failed=0

scene() {
    echo 'murk: 1'
    echo 'domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}'
    echo 'geometry: [{box: {min_m: [0.1, 0.1, 0.1], max_m: [3.9, 3.9, 2.9]}}]'
    echo 'media: {fog: {extinction_per_m: 0.3, albedo: 0.9}}'
    echo 'regions: [{medium: fog}]'
    echo 'lights: [{type: point, position_m: [2, 2, 2.5], power_w: 10}]'
    echo 'photons: {emit: 500}'
    echo 'sensors: {types: [{name: node, range_m: 3}], count: 2}'
    cat
}

command=place
# refused EXIT PART-OF-MESSAGE CONDITIONS OPTIONS...
refused() {
    want=$1
    part=$2
    conditions=$3
    shift 3
    echo "$conditions" | scene >"$dir/bad.yaml"
    (
        ulimit -t 10
        [ -n "$sanitizer" ] || ulimit -v 2000000
        MALLOC_ARENA_MAX=2 timeout 60 "$murk" "$command" "$dir/bad.yaml" -o "$dir/out" "$@"
    ) >"$dir/stdout" 2>"$dir/stderr"
    got=$?
    lines=$(grep -cv '^murk: warning:' "$dir/stderr")
    if [ "$got" -ne "$want" ] || [ "$lines" -ne 1 ] || ! grep -qF -- "$part" "$dir/stderr"; then
        echo "$command $conditions $*"
        echo "  exit $got, want $want; want one line with: $part"
        sed 's/^/  /' "$dir/stderr"
        failed=1
    fi
    if [ -d "$dir/out" ] && [ -n "$(ls -A "$dir/out")" ]; then
        echo "$conditions: wrote $(ls -A "$dir/out")"
        failed=1
    fi
    rm -rf "$dir/out"
}

good='conditions: {clear: {media.fog.extinction_per_m: 0}, fog: {}}'
over='--set placement.over=worst'
# shellcheck disable=SC2086
{
    refused 2 'worst, but the scene has no conditions' '' $over
    refused 2 'bad.yaml:9:20: conditions.fog.media.fgo.albedo: no fgo in media, did you mean fog?' \
        'conditions: {fog: {media.fgo.albedo: 1}}'
    refused 2 'bad.yaml:9:38: conditions.fog.media.fog.albedo: 7, must be 0..1' \
        'conditions: {fog: {media.fog.albedo: 7}}'
    refused 2 'conditions.a.sensors: must be the same in all conditions' \
        'conditions: {a: {sensors: {}}}'
    refused 2 '--light: not over conditions' "$good" $over --light nowhere.murk
    refused 2 '--export: not over conditions' "$good" $over --export matrix
    refused 2 'no such condition, did you mean fog?' "$good" $over \
        --set 'placement.condition_weights={fogg: 2}'
    refused 2 'knowledge must be known' "$good" $over --set placement.knowledge=unknown
    # a file of one condition, named at its place there
    refused 2 'conditions.smoke.media.fog' \
        'conditions: {smoke: {media.fog: {vdb: none.vdb, extinction_per_m: 1, albedo: 0}}}' $over
    # light of all together that no machine holds, told before any is traced;
    # in memory, because a disk may hold it
    MURK_MEMORY_MB=1000000000
    export MURK_MEMORY_MB
    refused 2 'over: the light of 2 conditions takes about' "$good" $over \
        --set 'photons={emit: 4e9, max_stored: 4e9}'
    unset MURK_MEMORY_MB
    refused 2 'target 0.999 cannot be reached in the worst condition' "$good" $over --target 0.999
    # one condition's crate fills the room where the other's candidates are
    refused 2 'usable' 'conditions: {empty: {}, full: {geometry: [{box: {min_m: [0.1, 0.1, 0.1],
      max_m: [3.9, 3.9, 2.9]}}, {box: {min_m: [0.12, 0.12, 0.12], max_m: [3.88, 3.88, 2.4]}}],
      lights.0.position_m: [2, 2, 2.8]}}' $over --set 'sensors.candidates={grid: {min_m: [1, 1, 1],
      max_m: [3, 3, 2], size: [3, 3, 2]}}'
    command=sense
    printf 'type,x_m,y_m,z_m\nnode,2,2,1\n' >"$dir/sensors.csv"
    for by in mean worst; do
        refused 2 'over: sense measures one scene' "$good" --sensors "$dir/sensors.csv" \
            --set placement.over=$by
    done
}
[ "$failed" -eq 0 ] && echo "every one is refused in one line"
exit "$failed"
