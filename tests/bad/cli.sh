#!/bin/sh
# Bad input on the command line: one line on standard error, the right exit
# code, nothing written, within 10 seconds of processor time and 2 GB. (Time on
# the clock is the machine's, which others may use; only a hang meets its
# limit.)
# usage: cli.sh MURK [SANITIZER]
set -u
murk=$1
sanitizer=${2:-}
dir=$(mktemp -d)
trap '[ -e "$dir/mounted" ] && umount "$dir/small"; chmod -R u+w "$dir"; rm -rf "$dir"' EXIT
failed=0

fail() {
    echo "$*"
    failed=1
}

# Runs murk within 10 s and 2 GB of address space, without which a sanitizer
# cannot be. Small stacks and few heaps: what idle threads reserve for each of
# many cores is not what murk needs.
within_limits() (
    ulimit -t 10
    [ -n "$sanitizer" ] || {
        ulimit -s 2048
        ulimit -v 2000000
    }
    MALLOC_ARENA_MAX=2 timeout 60 "$murk" "$@"
)

cat >"$dir/good.yaml" <<'END'
murk: 1
domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}
geometry: [{box: {min_m: [0.1, 0.1, 0.1], max_m: [3.9, 3.9, 2.9]}}]
lights: [{type: point, position_m: [2, 2, 2.5], power_w: 10}]
photons: {emit: 2000}
sensors:
  types: [{name: node, range_m: 3}]
  candidates: {grid: {min_m: [0.5, 0.5, 0.5], max_m: [3.5, 3.5, 2.5], size: [4, 4, 3]}}
  count: 2
END

# expect CODE PART-OF-MESSAGE ARGS...: runs murk, which must say that and fail
expect() {
    code=$1
    part=$2
    shift 2
    within_limits "$@" >"$dir/stdout" 2>"$dir/stderr"
    got=$?
    lines=$(grep -cv '^murk: warning:' "$dir/stderr")
    if [ "$got" -ne "$code" ] || [ "$lines" -ne 1 ] || ! grep -qF -- "$part" "$dir/stderr"; then
        echo "murk $*"
        echo "  exit $got, want $code; want one line with: $part"
        sed 's/^/  /' "$dir/stderr"
        failed=1
    fi
    if [ -d "$dir/out" ] && [ -n "$(ls -A "$dir/out")" ]; then
        fail "murk $*: wrote $(ls -A "$dir/out")"
    fi
    rm -rf "$dir/out"
}

# with KEY VALUE: the good scene with one line replaced
with() {
    sed "s|^$1:.*|$1: $2|" "$dir/good.yaml" >"$dir/bad.yaml"
}
place() {
    code=$1
    part=$2
    shift 2
    expect "$code" "$part" place "$dir/bad.yaml" -o "$dir/out" "$@"
}

# ---- usage ----
expect 2 "no command"
expect 2 "no such command" plaice "$dir/good.yaml"
expect 2 "no scene" place
expect 2 "no such option" place "$dir/good.yaml" --sed 3
expect 2 "--seed: -1" place "$dir/good.yaml" --seed -1
expect 2 "--seed: 4294967296" place "$dir/good.yaml" --seed 4294967296
expect 2 "--threads: 0" place "$dir/good.yaml" --threads 0
expect 2 "--threads: 0" place "$dir/good.yaml" -j0
expect 2 "-x2: no such option" place "$dir/good.yaml" -x2
expect 2 "--emit: 12abc" place "$dir/good.yaml" --emit 12abc
expect 2 "--emit: nan" place "$dir/good.yaml" --emit nan
expect 2 "--emit: 1152921504606846976" place "$dir/good.yaml" --emit 1152921504606846976
expect 2 "emit" place "$dir/good.yaml" --emit 10 --store 10
expect 2 "needs a value" place "$dir/good.yaml" --emit
expect 2 "not an option of murk trace" trace "$dir/good.yaml" --count 3
expect 2 "must be more than 0" place "$dir/good.yaml" --budget 0
expect 2 "make no linear problem" place "$dir/good.yaml" -o "$dir/none" --export lp --set placement.detection=independent
expect 2 "KEY=VALUE" place "$dir/good.yaml" --set seed
expect 2 "must be text | json" place "$dir/good.yaml" --format xml
expect 2 "replay needs --photon" replay "$dir/good.yaml"
expect 2 "--photon: 2000" replay "$dir/good.yaml" --photon 2000
expect 2 "sense needs --sensors" sense "$dir/good.yaml"

# ---- tallies ----
tallies() {
    code=$1
    part=$2
    expect "$code" "$part" trace "$dir/good.yaml" -o "$dir/out" --threads 1 --set "tallies=[$3]"
}
plane="type: plane, point_m: [1, 1, 1], normal: [0, 0, 1]"
grid="type: grid, min_m: [0, 0, 0], max_m: [4, 4, 3]"
tallies 2 "point_m is outside the domain" "{name: a, type: plane, point_m: [1, 1, 4], normal: [0, 0, 1]}"
tallies 2 "must point somewhere" "{name: a, type: plane, point_m: [1, 1, 1], normal: [0, 0, 0]}"
tallies 2 "1e+12 bins, must be 1..1000000" "{name: a, $plane, bins: [1000000, 1000000]}"
tallies 2 "reaches outside the domain" "{name: a, type: sphere, center_m: [1, 1, 1], radius_m: 1.5}"
tallies 2 "min must be less than max" "{name: a, type: grid, min_m: [0, 0, 0], max_m: [4, 0, 3], size: [1, 1, 1]}"
tallies 2 "size makes 1e+18 cells" "{name: a, $grid, size: [1000000, 1000000, 1000000]}"
tallies 2 "the tallies take 120 GB" "{name: a, $grid, size: [1000, 1000, 2000]}"
tallies 2 "is also that of another tally" "{name: a, $plane}, {name: a, $plane}"
tallies 2 "its files are also those" "{name: a, $grid, size: [1, 1, 1]}, {name: a_error, $grid, size: [1, 1, 1]}"
tallies 2 "files are named by it" "{name: ../../a, $plane}"
tallies 2 "not a key of a tally (plane)" "{name: a, $plane, radius_m: 1}"

# ---- scene files ----
expect 2 "No such file" place "$dir/nowhere.yaml" -o "$dir/out"
expect 2 "a folder" place "$dir" -o "$dir/out"
: >"$dir/bad.yaml"
place 2 "bad.yaml"
truncate -s 1G "$dir/huge.yaml"
expect 2 "must be at most" place "$dir/huge.yaml" -o "$dir/out"
rm "$dir/huge.yaml"
head -c 200000 /dev/zero | tr '\0' '[' >"$dir/bad.yaml"
place 2 "bad.yaml"
{
    echo 'a: &a [x, x, x, x, x, x, x, x, x, x]'
    for pair in ba cb dc ed fe gf hg; do
        to=${pair%?} from=${pair#?}
        echo "$to: &$to [*$from, *$from, *$from, *$from, *$from, *$from, *$from, *$from, *$from, *$from]"
    done
} >"$dir/bad.yaml"
place 2 "bad.yaml"

# ---- values ----
with lights '[]'
place 2 "lights"
with photons '{emit: 0}'
place 2 "bad.yaml:5:17: photons.emit"
with photons '{emit: 1152921504606846976}'
place 2 "photons.emit"
with photons '{emit: 10, store: 10}'
place 2 "photons"
with photons '{emit: .nan}'
place 2 "photons.emit"
with photons '{emit: 100, max_stored: 5}'
place 2 "max_stored"
with lights '[{type: point, position_m: [2, .nan, 2], power_w: 1}]'
place 2 "lights.0.position_m"
with lights '[{type: point, position_m: [2, 2, 20], power_w: 1}]'
place 2 "lights.0"
with lights '[{type: sun, latitude_deg: 52}]'
place 2 "misses longitude_deg"
with lights '[{type: sun, latitude_deg: 52, longitude_deg: 5, time: 2300-01-01T00:00:00Z, irradiance_w_per_m2: 1}]'
place 2 "outside the years 1900..2149"
with lights '[{type: sun, latitude_deg: 95, longitude_deg: 5, time: 2026-01-01T00:00:00Z}]'
place 2 "latitude_deg"
{
    grep -v '^geometry' "$dir/good.yaml"
    echo 'media: {water: {extinction_per_m: 0.1, albedo: 0.5}}'
    echo 'regions:'
    echo '  - {medium: water, below_z_m: 1, ior: 1.34}'
    echo '  - {medium: water, sphere: {center_m: [2, 2, 1], radius_m: 0.5}, ior: 1.5}'
} >"$dir/bad.yaml"
place 2 "bad.yaml:12:5: regions.1: crosses"
place 2 "regions.0.ior=0.9: 0.9, must be 1..10" --set regions.0.ior=0.9
sed -i '/^domain/d' "$dir/bad.yaml"
place 2 "bad.yaml:10:5: regions.0: a half space needs a domain or geometry"
expect 2 "sensors" place "$dir/good.yaml" --count 49 -o "$dir/out"
expect 2 "count: 49 sensors, but only 48 candidates" place "$dir/good.yaml" --count 49 -o "$dir/out"
expect 2 "candidates" place "$dir/good.yaml" -o "$dir/out" \
    --set 'sensors.candidates.grid={min_m: [0.02, 0.02, 0.02], max_m: [0.05, 0.05, 0.05], size: [2, 2, 2]}'

# ---- files that a scene names ----
with geometry '[{file: nowhere.obj}]'
place 2 "nowhere.obj"
with geometry "[{file: $dir}]"
place 2 "geometry.0"
: >"$dir/empty.obj"
with geometry '[{file: empty.obj}]'
place 2 "geometry.0"
truncate -s 1G "$dir/huge.obj"
with geometry '[{file: huge.obj}]'
place 2 "geometry.0"
rm "$dir/huge.obj"
printf 'v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >"$dir/nan.obj"
with geometry '[{file: nan.obj}]'
place 2 "geometry.0"
# regions that are meshes: tetrahedra, one of them short of a face
corners='v 1 1 1\nv 1 2 1\nv 2 1 1\nv 1 1 2\n'
printf "${corners}f 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n" >"$dir/closed.obj"
printf "${corners}f 1 2 3\nf 1 2 4\nf 1 3 4\n" >"$dir/open.obj"
meshes() {
    {
        cat "$dir/good.yaml"
        echo 'media: {sea: {extinction_per_m: 1, albedo: 0.5}}'
        echo 'regions:'
        for region in "$@"; do
            echo "  - {medium: sea, $region}"
        done
    } >"$dir/bad.yaml"
}
meshes 'mesh: nowhere.obj'
place 2 "regions.0: "
meshes 'mesh: nan.obj'
place 2 "regions.0: "
meshes 'mesh: open.obj, ior: 1.3'
place 2 "bad.yaml:12:5: regions.0: the mesh is open: 3 of its edges belong to an odd number of its 3 triangles"
place 2 "unit_m" --set regions.0.unit_m=0
meshes 'below_z_m: 1.5, ior: 1.3' 'mesh: closed.obj, ior: 1.5'
place 2 "bad.yaml:13:5: regions.1: crosses $dir/bad.yaml:12:5: regions.0 near [1, 1, 1] m, must lie in it"
meshes 'sphere: {center_m: [1, 1, 1], radius_m: 0.9}, ior: 1.3' 'mesh: closed.obj, ior: 1.5'
place 2 "regions.1: crosses"
meshes 'mesh: closed.obj, ior: 1.5' 'mesh: closed.obj, translate_m: [0.2, 0, 0], ior: 1.5'
place 2 "regions.1: crosses"
{
    cat "$dir/good.yaml"
    echo 'media: {smoke: {vdb: nowhere.vdb, extinction_per_m: 1, albedo: 0.5, phase: isotropic}}'
    echo 'regions: [{medium: smoke}]'
} >"$dir/bad.yaml"
place 2 "nowhere.vdb"
sed 's|nowhere.vdb|good.yaml|' "$dir/bad.yaml" >"$dir/bad2.yaml"
expect 2 "media.smoke" place "$dir/bad2.yaml" -o "$dir/out"

printf 'angle_deg,phase_per_sr\n0,1\n90,1\n80,1\n180,1\n' >"$dir/turns.csv"
{
    cat "$dir/good.yaml"
    echo 'media: {sea: {extinction_per_m: 1, albedo: 0.5, phase: {table: turns.csv}}}'
    echo 'regions: [{medium: sea}]'
} >"$dir/bad.yaml"
place 2 "turns.csv:4: angle_deg: 80, must be more than the 90 degrees before"

# ---- more than the 2 GB that there are, said before it is begun ----
[ -n "$sanitizer" ] || expect 2 "GB free" trace "$dir/good.yaml" -o "$dir/out" --store 100000000

# ---- results that cannot be written: the old ones stay ----
contents() {
    (cd "$1" && for file in * .[!.]*; do [ ! -e "$file" ] || cksum "$file"; done)
}

# full_disk FOLDER HOW ARGS...: a run into a folder of older results, of which
# the command `within_limits` or `with_small_files` lets only a part be written
full_disk() {
    folder=$1
    how=$2
    shift 2
    before=$(contents "$folder")
    "$how" place "$dir/good.yaml" -q -o "$folder" "$@" 2>"$dir/stderr"
    got=$?
    [ $got -eq 1 ] && [ "$(wc -l <"$dir/stderr")" -eq 1 ] || {
        fail "a full disk: exit $got, want 1 and one line:"
        cat "$dir/stderr"
    }
    [ "$before" = "$(contents "$folder")" ] || fail "a full disk changed: $(ls -A "$folder")"
}
with_small_files() (
    ulimit -f 40 # blocks of 512 bytes: light.murk does not fit
    within_limits "$@"
)

expect 1 "not a folder" place "$dir/good.yaml" -o "$dir/good.yaml"
within_limits place "$dir/good.yaml" -q -o "$dir/kept" || fail "the good scene failed"
[ "$(ls -A "$dir/kept" | wc -l)" -eq 7 ] || fail "not seven files: $(ls -A "$dir/kept")"
full_disk "$dir/kept" with_small_files --emit 20000

mkdir "$dir/small"
if mount -t tmpfs -o size=1m tmpfs "$dir/small" 2>/dev/null; then
    : >"$dir/mounted"
    cp "$dir/kept"/* "$dir/small"
    full_disk "$dir/small" within_limits --emit 60000
    head -c 2000000 /dev/zero >"$dir/small/filler" 2>/dev/null
    full_disk "$dir/small" within_limits
    umount "$dir/small" && rm "$dir/mounted"
else
    echo "skipped: a small file system, may not mount"
fi

# root may write anywhere but where the kernel keeps no files
if [ "$(id -u)" -ne 0 ]; then
    chmod a-w "$dir/kept"
    before=$(contents "$dir/kept")
    expect 1 "cannot write" place "$dir/good.yaml" -q -o "$dir/kept"
    [ "$before" = "$(contents "$dir/kept")" ] || fail "wrote into a folder that may not be written"
    chmod u+w "$dir/kept"
    expect 1 "cannot make the folder" place "$dir/good.yaml" -q -o /nowhere
elif [ -e /proc/self/status ]; then
    expect 1 "cannot write" place "$dir/good.yaml" -q -o /proc/self
    expect 1 "cannot make the folder" place "$dir/good.yaml" -q -o /proc/self/nowhere
else
    echo "skipped: folders that root may not write, no /proc here"
fi
# A region whose layers end below its box holds nothing, and check says so.
cat >"$dir/nothing.yaml" <<'END'
murk: 1
domain: {min_m: [0, 0, 0], max_m: [10, 10, 10]}
media: {smoke: {profile: {z_m: [0, 5], extinction_per_m: [1, 2]}, albedo: 0.5}}
regions: [{medium: smoke, box: {min_m: [0, 0, 8], max_m: [1, 1, 9]}}]
lights: [{type: point, position_m: [1, 1, 1], power_w: 1}]
END
within_limits check "$dir/nothing.yaml" >"$dir/stdout" 2>"$dir/stderr"
grep -q "smoke, empty: " "$dir/stdout" && ! grep -q inf "$dir/stdout" ||
    fail "an empty region is not called so: $(grep region "$dir/stdout")"
# Layers in a mesh are bounded by the mesh: they need no domain.
cat >"$dir/layers.yaml" <<'END'
murk: 1
media: {smoke: {profile: {z_m: [0, 1.5], extinction_per_m: [1, 2]}, albedo: 0.5}}
regions: [{medium: smoke, mesh: closed.obj}]
lights: [{type: point, position_m: [1.1, 1.1, 1.1], power_w: 1}]
END
within_limits check "$dir/layers.yaml" >"$dir/stdout" 2>"$dir/stderr" ||
    fail "layers in a mesh without a domain are refused: $(cat "$dir/stderr")"
! grep -q "smoke, empty: " "$dir/stdout" || fail "layers in a mesh are called empty"
# Where the sun meets water in an open side, the warning names both remedies.
cat >"$dir/sea.yaml" <<'END'
murk: 1
domain: {min_m: [0, 0, 0], max_m: [10, 10, 10]}
media: {sea: {extinction_per_m: 0.1, albedo: 0.5}}
regions: [{medium: sea, below_z_m: 5}]
lights: [{type: directional, direction: [1, 0, -1], irradiance_w_per_m2: 1}]
END
within_limits check "$dir/sea.yaml" >/dev/null 2>"$dir/stderr"
grep -q "domain.sides: periodic, or domain.outside: continued" "$dir/stderr" ||
    fail "light through an open side of water is not warned of"
within_limits check "$dir/sea.yaml" --set domain.outside=continued >/dev/null 2>"$dir/stderr"
[ ! -s "$dir/stderr" ] || fail "a continued domain is warned of: $(cat "$dir/stderr")"
# Ways to portals would have to be bent.
expect 2 "lights.0: aim: portals beside a region with an ior do not go with domain.outside: continued, use outside: empty or sides: periodic, or leave aim out" \
    trace "$dir/sea.yaml" -o "$dir/out" --emit 1000 --set domain.outside=continued --set regions.0.ior=1.34 \
    --set 'lights.0.aim=[{corner_m: [0, 0, 10], edge1_m: [0, 10, 0], edge2_m: [10, 0, 0]}]'

[ -e /dev/full ] && { within_limits check "$dir/good.yaml" >/dev/full 2>"$dir/stderr"
    [ $? -eq 1 ] || fail "a full standard output went unnoticed"; }

# ---- interrupt: no half file, exit 130 ----
# interrupted SECONDS ARGS...: murk, stopped by Ctrl-C after so long
interrupted() {
    seconds=$1
    shift
    "$murk" "$@" -q -o "$dir/stopped" 2>"$dir/stderr" &
    pid=$!
    sleep "$seconds"
    kill -INT $pid || fail "murk $*: over within $seconds s, too soon to be stopped"
    asked=$(date +%s)
    wait $pid
    got=$?
    [ $got -eq 130 ] && [ "$(cat "$dir/stderr")" = "murk: interrupted" ] || {
        fail "murk $*: interrupted: exit $got, want 130"
        cat "$dir/stderr"
    }
    [ $(($(date +%s) - asked)) -le 10 ] || fail "murk $*: took more than 10 s to stop"
    [ -z "$(ls -A "$dir/stopped" 2>/dev/null)" ] || fail "interrupted: left $(ls -A "$dir/stopped")"
    rm -rf "$dir/stopped"
}
interrupted 1 trace "$dir/good.yaml" --emit 4e9 --set photons.maps=none
interrupted 2 place scenes/fog-yard.yaml --emit 200000 # while it looks

# ---- repeated runs: what is finished is kept ----
expect 2 "--repeat: 0, must be a whole number 1..10000" place "$dir/good.yaml" --repeat 0
expect 2 "--repeat: 2.5, must be" place "$dir/good.yaml" --repeat 2.5
expect 2 "--repeat: needs a value" place "$dir/good.yaml" --repeat
expect 2 "--repeat: not an option of murk sense" sense "$dir/good.yaml" --repeat 2
expect 2 "--repeat: 3 seeds from 4294967294 on" place "$dir/good.yaml" --seed 4294967294 --repeat 3 -o "$dir/out"
expect 2 "conditions.clear: seed: one of its own" place "$dir/good.yaml" --repeat 2 \
    --set 'conditions={clear: {seed: 8}}' --set placement.over=mean
expect 2 "at_least is given, which repeats do not take: place once for each seed, or use placement.redundancy" \
    place "$dir/good.yaml" --repeat 2 --target 0.1 --set placement.at_least=2 -o "$dir/out"
expect 2 "at_least is given, which the export lp does not take: use the export matrix or or-library" \
    place "$dir/good.yaml" --export lp --target 0.1 --set placement.at_least=2 -o "$dir/out"
printf '1,1\n1,0\n' >"$dir/matrix.csv"
expect 2 "--set placement.at_least: a matrix has no such key; there are seed" \
    place --matrix "$dir/matrix.csv" --target 0.9 --set placement.at_least=2 -o "$dir/out"
expect 2 "--repeat: a matrix is one sample" place --matrix "$dir/matrix.csv" --count 1 --repeat 2

# kept_after FOLDER: its plan is whole, with as many runs as repeat.csv has rows
kept_after() {
    runs=$(sed -n '/"repeat": {/,/}/s/.*"runs": \([0-9]*\).*/\1/p' "$1/plan.json" | head -n 1)
    rows=$(($(wc -l <"$1/repeat.csv") - 1))
    [ "$runs" -ge 1 ] && [ "$runs" -lt 10000 ] && [ "$runs" -eq $rows ] ||
        fail "kept $runs runs in plan.json, $rows in repeat.csv"
    [ -z "$(ls -A "$1" | grep staged)" ] || fail "left $(ls -A "$1")"
    rm -rf "$1"
}
# a target that the first seed's candidates just meet, and a later one's do not
within_limits place "$dir/good.yaml" -q --repeat 9 --target 0.926 -o "$dir/runs" \
    --set sensors.types.0.range_m=0.7 --set placement.restarts=1 --set placement.nodes=0 2>"$dir/stderr"
got=$?
[ $got -eq 2 ] && [ "$(wc -l <"$dir/stderr")" -eq 1 ] && grep -q "seed [2-9]: target 0.926 cannot" "$dir/stderr" ||
    fail "a later seed's failure: exit $got, $(cat "$dir/stderr")"
kept_after "$dir/runs"
"$murk" place "$dir/good.yaml" -q --repeat 10000 -o "$dir/runs" 2>"$dir/stderr" &
pid=$!
for _ in 1 2 3 4 5 6 7 8 9 10; do # the first run's plan is there before the others end
    sleep 1
    [ ! -e "$dir/runs/plan.json" ] || break
done
kill -INT $pid
wait $pid
got=$?
[ $got -eq 130 ] && [ "$(cat "$dir/stderr")" = "murk: interrupted" ] ||
    fail "interrupted while repeating: exit $got, $(cat "$dir/stderr")"
kept_after "$dir/runs"

# targets
expect 2 "cannot be reached: all" place "$dir/good.yaml" --target 1 --set sensors.types.0.range_m=0.5
expect 2 "must be more than 0 and at most 1" place "$dir/good.yaml" --target 2
expect 2 "count" place "$dir/good.yaml" --target 0.5 --count 2

# light that never ends
cat >"$dir/white.yaml" <<'END'
murk: 1
domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}
geometry: [{box: {min_m: [0.1, 0.1, 0.1], max_m: [3.9, 3.9, 2.9]}, material: white}]
materials: {white: {diffuse: 0.9, specular: 0.1}}
media: {fog: {extinction_per_m: 1, albedo: 1}}
regions: [{medium: fog}]
lights: [{type: point, position_m: [2, 2, 2.5], power_w: 10}]
photons: {emit: 1000000}
END
expect 2 "no surface or medium absorbs and no way out was found" trace "$dir/white.yaml"
expect 2 "light of 550 nm does not end" check "$dir/white.yaml"
expect 2 "does not end" trace "$dir/white.yaml" --set photons.maps=none
expect 2 "light of 600 nm does not end" trace "$dir/white.yaml" --set "bands_nm=[450, 600]" \
    --set "media.fog.albedo=[0.5, 1]"
expect 2 "more absorption" trace "$dir/white.yaml" --set media.fog.albedo=0.9999999

# a small stack is no crash: threads and the program itself have their own
[ -n "$sanitizer" ] || for command in check place; do
    (
        ulimit -s 128
        exec "$murk" "$command" "$dir/good.yaml" --threads 2 >"$dir/stdout" 2>"$dir/stderr"
    ) || fail "$command with a stack of 128 kB: exit code $?: $(cat "$dir/stderr")"
done

[ $failed -eq 0 ] && echo "all refused as they should be"
exit $failed
