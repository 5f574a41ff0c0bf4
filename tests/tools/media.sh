#!/bin/sh
# make_media writes grids that murk reads where it should, the same on each run,
# sequences for `frame`; murk media --profile makes a grid of the right depth; both
# refuse what cannot be on one line.
# usage: media.sh MURK MAKE_MEDIA
set -eu
murk=$1
make=$2
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT

scene() { # FILE KEYS-OF-THE-MEDIUM
    cat >"$dir/scene.yaml" <<YAML
murk: 1
bands_nm: [532]
domain: {min_m: [0, 0, -50], max_m: [40, 40, 50]}
media: {cloud: {vdb: $1, extinction_per_m: 0.1, albedo: 0.9$2}}
regions: [{medium: cloud}]
lights: [{type: point, position_m: [20, 20, 20], power_w: 1}]
photons: {emit: 200}
YAML
}

for kind in fog-bank rain-shafts plume chlorophyll smoke; do
    thick=
    [ $kind = smoke ] && thick='soot_g_per_s=1000 radius_m=3'
    for n in 1 2; do
        "$make" $kind -o "$dir/$kind.vdb" --size 20,20,20 --voxel 2 $thick >/dev/null
        scene "$dir/$kind.vdb" ""
        "$murk" trace "$dir/scene.yaml" --quiet -o "$dir/$kind$n"
    done
    # the file's id differs, what is in it does not
    python3 - "$dir/${kind}1/ledger.json" "$dir/${kind}2/ledger.json" <<'PYTHON'
import json, sys
one, two = (json.load(open(path)) for path in sys.argv[1:])
for key in "run", "scene_sha256", "files": # light.murk holds the checksum of the grid's file
    one.pop(key, 0), two.pop(key, 0)
assert one == two, "differs from run to run"
assert one["collisions"] > 0, "nothing in the way"
PYTHON
done

"$make" fog-bank -o "$dir/fog.####.vdb" --size 20,20,20 --voxel 2 --frames 3 --step 5 >"$dir/made"
[ "$(wc -l <"$dir/made")" = 3 ]
for frame in 1 3; do
    scene "$dir/fog.####.vdb" ", frame: $frame"
    "$murk" trace "$dir/scene.yaml" --quiet -o "$dir/frame$frame"
done
cmp -s "$dir/frame1/light.murk" "$dir/frame3/light.murk" && { echo "frames are alike"; exit 1; }

# between two frames: from the command line, whole numbers as before to the byte, and as rows of a study
scene "$dir/fog.####.vdb" ", frame: 1"
for frame in 1 2 1.25; do
    "$murk" check "$dir/scene.yaml" --set media.cloud.frame=$frame --format json >"$dir/check$frame"
done
python3 - "$dir/check1" "$dir/check2" "$dir/check1.25" <<'PYTHON'
import json, sys
one, two, between = (json.load(open(path))["media"][0]["grid"]["sum"] for path in sys.argv[1:])
want = .75 * one + .25 * two
assert abs(between - want) < 1e-6 * want and abs(one - two) > 1e-3 * want, (one, two, between)
PYTHON
"$murk" trace "$dir/scene.yaml" --set media.cloud.frame=1.0 --quiet -o "$dir/frame1.0"
cmp "$dir/frame1/light.murk" "$dir/frame1.0/light.murk"
cat >"$dir/study.yaml" <<YAML
murk_study: 1
base: scene.yaml
axes: {media.cloud.frame: [1, 1.5, 2, 2.5, 3]}
outputs: [density]
YAML
"$murk" study "$dir/study.yaml" --quiet -o "$dir/study"
python3 - "$dir/study/table.csv" <<'PYTHON'
import csv, sys
rows = list(csv.DictReader(line for line in open(sys.argv[1]) if not line.startswith("#")))
frames = [row["media.cloud.frame"] for row in rows]
assert frames == ["1", "1.5", "2", "2.5", "3"], frames
assert not any(row.get("failed") for row in rows), rows
density = [row[next(name for name in row if name.startswith("density"))] for row in rows]
assert len(set(density)) == 5, density
PYTHON
for pair in 3.5:4 0.5:0; do # time, and the frame that is missing
    state=0
    "$murk" check "$dir/scene.yaml" --set media.cloud.frame=${pair%:*} >"$dir/out" 2>"$dir/err" || state=$?
    text="frame ${pair%:*} is between two frames, and frame ${pair#*:} of $dir/fog.####.vdb is not there; there are 1..3"
    [ $state = 2 ] && [ "$(wc -l <"$dir/err")" = 1 ] && grep -qF "$text" "$dir/err" ||
        { echo "frame $pair: $state"; cat "$dir/err"; exit 1; }
done

# the frames beside the scene with rising smoke are what the tool makes: sums of one of them
root=$(cd "$(dirname "$0")/../.." && pwd)
"$make" smoke -o "$dir/rise.##.vdb" --frames 12 --step 1 --size 30,30,20 --voxel 0.4 burned_s=0.5 ceiling_m=7.9 \
    layer_m=1.2 heat_kw=20 soot_g_per_s=0.1 >/dev/null
for of in "$dir/rise" "$root/media/rising_smoke"; do
    "$murk" check "$root/scenes/rising-smoke.yaml" --at 10 --set "timeline.tracks.0.frames=$of.##.vdb" --format json \
        >"$dir/$(basename "$of").json"
done
python3 - "$dir/rise.json" "$dir/rising_smoke.json" <<'PYTHON'
import json, sys
made, there = (json.load(open(path))["media"][0]["grid"] for path in sys.argv[1:])
assert made["sum"] > 0 and abs(made["sum"] - there["sum"]) < 1e-5 * made["sum"], (made, there)
PYTHON

# a profile: what is read, and straight down through the grid e^-2.4 is left
printf '# a cast\nstation,depth[m],c532[1/m],c514[1/m]\n' >"$dir/casts.csv"
printf 'A,%s,%s,9\n' 0 .1 2 .3 10 .2 >>"$dir/casts.csv"
printf 'B,%s,%s,9\n' 0 .1 2 .3 >>"$dir/casts.csv"
profile="--profile $dir/casts.csv -o $dir/cast.vdb --column c532[1/m] --rows station=A"
"$murk" media $profile --voxel 0.3 >"$dir/said"
tr -s ' \n' ' ' <"$dir/said" >"$dir/line" # however its lines are broken
grep -q "3 rows, 0 down to -10 m, optical depth 2.4 " "$dir/line" || { cat "$dir/said"; exit 1; }
grep -q "34 voxels of 0.3 m, 1000 m wide" "$dir/line"
"$murk" media $profile --format json | python3 -c '
import json, sys
said = json.load(sys.stdin)
assert said["voxels"] == 100 and abs(said["optical_depth"] - 2.4) < 1e-12, said'
scene "$dir/cast.vdb" ""
sed -i 's/0.1, albedo: 0.9/1, albedo: 0/; s/^lights.*/lights: [{type: beam, origin_m: [20, 20, 20], direction: [0, 0, -1], power_w: 1}]/
        s/emit: 200/emit: 20000/' "$dir/scene.yaml"
"$murk" trace "$dir/scene.yaml" --quiet -o "$dir/cast"
python3 - "$dir/cast/ledger.json" <<'PYTHON'
import json, math, sys
left = json.load(open(sys.argv[1]))["escaped_w"]["total"]
want = math.exp(-2.4)
# 6 sigma of 20000 photons: once in 5e8 seeds
assert abs(left - want) < 6 * math.sqrt(want * (1 - want) / 20000), (left, want)
PYTHON

refused_by_murk() { # TEXT ARGUMENTS...
    text=$1
    shift
    state=0
    "$murk" media "$@" >"$dir/out" 2>"$dir/err" || state=$?
    [ $state = 2 ] && [ "$(wc -l <"$dir/err")" = 1 ] && grep -qF -- "$text" "$dir/err" ||
        { echo "murk media $*: $state"; cat "$dir/err"; exit 1; }
}
refused_by_murk "misses -o" --profile "$dir/casts.csv"
refused_by_murk "must be one of them" fog/kim $profile
refused_by_murk "need --profile" --voxel 2
refused_by_murk "--voxel: 0, must be more than 0" $profile --voxel 0
refused_by_murk "--width: 1m, must be more than 0" $profile --width 1m
refused_by_murk "casts.csv:6: depth[m]: 0 after 10, must go one way" \
    --profile "$dir/casts.csv" -o "$dir/x.vdb" --column "c532[1/m]"
refused_by_murk "no-such.csv" --profile "$dir/no-such.csv" -o "$dir/x.vdb"
[ ! -e "$dir/x.vdb" ]

refused() { # TEXT ARGUMENTS...
    text=$1
    shift
    state=0
    "$make" "$@" >"$dir/out" 2>"$dir/err" || state=$?
    [ $state = 2 ] && [ "$(wc -l <"$dir/err")" = 1 ] && grep -qF -- "$text" "$dir/err" ||
        { echo "make_media $*: $state"; cat "$dir/err"; exit 1; }
}
refused "fgo-bank, must be fog-bank" fgo-bank -o x.vdb
refused "-o: nothing" plume
refused "followed by its value" plume -o
refused "X,Y,Z" plume -o x.vdb --size 3,4
refused "each 1..65536" plume -o x.vdb --size 3,0,4
refused "2e8 voxels at most" plume -o x.vdb --size 60000,60000,2
refused "1e-6..1e9 m" plume -o x.vdb --voxel nan
refused "0..4294967295" plume -o x.vdb --seed -1
refused "current_m_per_s: 0, must be 0.001..10" plume -o x.vdb current_m_per_s=0
refused "wind=3: no such number" plume -o x.vdb wind=3
refused "a pattern such as" plume -o "$dir/x.vdb" --frames 2
echo "five kinds, three frames, times between them, a profile, twenty refusals"
