#!/bin/sh
# murk-mpi under a sanitizer: small commands of each kind in two ranks of two
# threads end without a finding. What Open MPI does, which is built without the
# sanitizer, is left out.
# usage: sanitized.sh MURK-MPI MPIRUN address|thread
set -u
murk_mpi=$1
mpirun=$2
sanitizer=$3
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
failed=0
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1

options=allocator_may_return_null=1:log_path=$dir/finding
libraries="mca_ libopen-pal libopen-rte libmpi ompi_ opal_ PMI libpmix libevent"
if [ "$sanitizer" = thread ]; then
    printf 'called_from_lib:libembree\ncalled_from_lib:libtbb.so\n' >"$dir/left_out"
    for library in $libraries; do
        printf 'race:%s\nmutex:%s\nthread:%s\ndeadlock:%s\n' "$library" "$library" "$library" "$library"
    done >>"$dir/left_out"
    export TSAN_OPTIONS="$options:suppressions=$dir/left_out:ignore_noninstrumented_modules=1:report_thread_leaks=0"
else
    # Open MPI leaves memory of modules that it has unloaded, which nothing can tell from others.
    export ASAN_OPTIONS="$options:detect_leaks=0"
fi

# expect ARGS...: exits with 0, without a finding
expect() {
    timeout 300 "$mpirun" -q -n 2 "$murk_mpi" "$@" -j 2 -q >"$dir/text" 2>&1
    got=$?
    if [ $got -ne 0 ] || ls "$dir"/finding.* >/dev/null 2>&1; then
        echo "$*: exit $got"
        cat "$dir/text" "$dir"/finding.* 2>/dev/null | head -n 60
        rm -f "$dir"/finding.*
        failed=1
    fi
}

cat >"$dir/study.yaml" <<END
murk_study: 1
base: $PWD/scenes/paper-room.yaml
axes: {seed: [1, 2]}
outputs: [coverage_best]
END
room=scenes/paper-room.yaml
expect trace $room --store 3000 -o "$dir/trace"
expect place $room --store 1000 -o "$dir/place"
expect place $room --store 15000 --set placement.method=greedy -o "$dir/own_rows" # 2^24 pairs and more
expect place $room --store 500 --set placement.knowledge=unknown --set placement.method=greedy -o "$dir/unknown"
expect place $room --store 500 --repeat 3 -o "$dir/repeat"
expect study "$dir/study.yaml" --store 300 -o "$dir/study"
expect render scenes/smoke-hall.yaml --emit 1000 -o "$dir/a.exr" \
    --set 'cameras=[{name: a, from_m: [1, 1, 1], to_m: [2, 2, 1], pixels: [8, 6], samples: 2}]'
expect fit scenes/calibrate-coverage.yaml --data scenes/calibrate/coverage.csv --free media.fog.visibility_m \
    --emit 12000 --starts 2 -o "$dir/fit"
exit $failed
