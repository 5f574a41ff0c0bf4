#!/bin/sh
# Bad and hostile candidates: one line on standard error that names the place,
# exit 2, nothing written, within 10 seconds of processor time and 2 GB.
# Under a sanitizer, 25 seconds: the longest case, five million places, then
# takes 14.5 s in place of 6.9 s while both cores work.
# usage: candidates.sh MURK [SANITIZER]
set -u
murk=$1
sanitizer=${2:-}
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
failed=0

within_limits() (
    ulimit -t "$([ -n "$sanitizer" ] && echo 25 || echo 10)"
    [ -n "$sanitizer" ] || {
        ulimit -s 2048
        ulimit -v 2000000
    }
    MALLOC_ARENA_MAX=2 timeout 60 "$murk" "$@"
)

# refused PART-OF-MESSAGE CANDIDATES
refused() {
    {
        echo 'murk: 1'
        echo 'domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}'
        echo 'materials: {wall: {diffuse: 0.3}, ground: {diffuse: 0.2}}'
        echo 'geometry:'
        echo '  - {box: {min_m: [0.1, 0.1, 0.1], max_m: [3.9, 3.9, 2.9]}, material: wall}'
        echo '  - {rect: {corner_m: [-20, -20, 0], edge1_m: [40, 0, 0], edge2_m: [0, 40, 0]}, material: ground}'
        echo 'lights: [{type: point, position_m: [2, 2, 2.5], power_w: 10}]'
        echo 'photons: {emit: 2000}'
        echo 'sensors: {types: [{name: node, range_m: 3}], count: 2,'
        echo "  candidates: {$2}}"
    } >"$dir/bad.yaml"
    within_limits place "$dir/bad.yaml" -o "$dir/out" >"$dir/stdout" 2>"$dir/stderr"
    got=$?
    lines=$(grep -cv '^murk: warning:' "$dir/stderr")
    if [ "$got" -ne 2 ] || [ "$lines" -ne 1 ] || ! grep -qF -- "$1" "$dir/stderr"; then
        echo "$2"
        echo "  exit $got, want 2; want one line with: $1"
        sed 's/^/  /' "$dir/stderr"
        failed=1
    fi
    if [ -d "$dir/out" ] && [ -n "$(ls -A "$dir/out")" ]; then
        echo "$2: wrote $(ls -A "$dir/out")"
        failed=1
    fi
    rm -rf "$dir/out"
}

# ---- points ----
refused 'nowhere.csv' 'points: nowhere.csv'
refused "$dir" "points: $dir"
: >"$dir/p.csv"
refused 'p.csv' 'points: p.csv'
printf 'x_m,y_m\n1,1\n' >"$dir/p.csv"
refused 'p.csv: misses column z_m' 'points: p.csv'
printf 'x_m,y_m,z_m\n1,1,1\n1,1\n' >"$dir/p.csv"
refused 'p.csv:3' 'points: p.csv'
printf 'x_m,y_m,z_m\n1,1,1\n1,0x1,1\n' >"$dir/p.csv"
refused 'p.csv:3: y_m' 'points: [p.csv]'
printf 'x_m,y_m,z_m\n1,1,1\n1,1,nan\n' >"$dir/p.csv"
refused 'p.csv:3: z_m' 'points: [[1, 1, 1], p.csv]'
printf 'x_m,y_m,z_m\n1,1,-0.001\n' >"$dir/p.csv"
refused 'p.csv:2: [1, 1, -0.001] m is outside the domain' 'points: p.csv'
head -c 3000000 /dev/zero >"$dir/p.csv"
refused 'p.csv' 'points: p.csv'
refused 'points.0.1' 'points: [[1, .inf, 1]]'
# two million points, all of them in the wall or behind it
{
    echo x_m,y_m,z_m
    yes 0.05,0.05,0.05 | head -n 1000000
    yes 0.1,1,1 | head -n 1000000
} >"$dir/p.csv"
refused '2000000 candidates is usable: 1 out of reach of any light, 1 on a surface' 'points: p.csv'
refused '1999998 duplicates' 'points: p.csv'
rm "$dir/p.csv"

# ---- mounts ----
refused 'mount: ' 'mount: wall'
refused 'mount.surfaces.0' 'mount: {surfaces: [wal]}'
refused 'mount.spacing_m' 'mount: {spacing_m: 0}'
refused 'must be more than' 'mount: {spacing_m: 1e-7}'
refused 'lays more than 5000000 places' 'mount: {surfaces: [wall], spacing_m: 0.001}'
refused 'lays more than 5000000 places' 'mount: {surfaces: [wall], spacing_m: 0.0021}'
refused 'nothing to mount on' 'mount: {z_m: [2.95, 2.99]}'
refused 'none of the' 'mount: {surfaces: [ground], spacing_m: 0.5}'
refused 'offset_m' 'mount: {offset_m: 1e-9}'
refused 'none of the' 'mount: {offset_m: 50}'

# ---- zones ----
corners='v 1 1 1\nv 1 2 1\nv 2 1 1\nv 1 1 2\n'
printf "${corners}f 1 2 3\nf 1 2 4\nf 1 3 4\n" >"$dir/open.obj"
refused 'avoid.0: the mesh is open: 3 of its edges' 'avoid: [{mesh: open.obj}]'
refused 'within.1' 'within: [{box: {min_m: [0, 0, 0], max_m: [1, 1, 1]}}, {mesh: nowhere.obj}]'
refused 'within.0.box' 'within: [{box: {min_m: [0, 0, 0], max_m: [1, 0, 1]}}]'
refused 'avoid.0.sphere' 'avoid: [{sphere: {center_m: [0, 0, 0]}}]'
refused '1000 forbidden by zones' 'grid: {min_m: [1, 1, 1], max_m: [2, 2, 2], size: [10, 10, 10]}, avoid: [{sphere: {center_m: [1, 1, 1], radius_m: 9}}]'
refused 'forbidden by zones' 'within: [{box: {min_m: [7, 7, 7], max_m: [8, 8, 8]}}]'

exit $failed
