#!/bin/sh
# Compares the folders that a program of a user saves with those of the same
# commands of murk: the same names of files, and the same bytes but for `run`, which
# has times, and for the identity of commands that name a file.
#
#     same_files.sh MURK SAVES WORK
set -eu
murk=$1 saves=$2 work=$3
here=$(cd "$(dirname "$0")/../.." && pwd)
scenes=$work/in/small fog=$work/in/scenes/calibrate-fog.yaml data=$work/in/scenes/calibrate/fog.csv
room=$scenes/room.yaml
mkdir "$work/in"
cp -r "$here/scenes" "$here/media" "$work/in"
cp -r "$here/tests/same/recorded/scenes" "$scenes"
key=media.fog.extinction_per_m
program=$work/by-program api=$work/by-api
mkdir "$program" "$api"

"$murk" trace "$room" --emit 300 --export fields,photons,surfaces -o "$program/trace" -q
"$murk" place "$room" --emit 300 --export matrix --repeat 2 -o "$program/place" -q
"$murk" sense "$room" --light "$program/trace/light.murk" --sensors "$program/place/sensors.csv" -o "$program/sense" -q
"$murk" study "$scenes/log-study.yaml" --emit 200 -o "$program/study" -q
"$murk" fit "$fog" --data "$data" --free $key --bounds $key=0.001:5 --loss huber:2 --starts 1 --traces 2 --next 1 \
    --emit 2000 -o "$program/fit" -q 2>"$work/refused" || { cat "$work/refused"; exit 1; }
"$murk" fit "$fog" --data "$data" --predict "$program/fit/fit.json" --emit 2000 -o "$program/predict" \
    -q 2>"$work/refused" || { cat "$work/refused"; exit 1; }
"$murk" fit "$fog" --data "$data" --emit 2000 -o "$program/predict_scene" -q 2>"$work/refused" ||
    { cat "$work/refused"; exit 1; }
"$saves" "$room" "$scenes/log-study.yaml" "$fog" "$data" "$api"

# without_run FILE: a JSON up to `run`
without_run() {
    case $1 in
    */place/* | */study/* | */trace/*) sed '/^  "run": {/,$d' "$1" ;;
    *) sed '/^  "run": {/,$d; /^  "identity": /d' "$1" ;;
    esac
}
(cd "$program" && find . -type f | sort) >"$work/program-files"
(cd "$api" && find . -type f | sort) >"$work/api-files"
diff "$work/program-files" "$work/api-files" || { echo "other files than those of the program"; exit 1; }
while read -r file; do
    case $file in
    *.json)
        without_run "$program/$file" >"$work/a"
        without_run "$api/$file" >"$work/b"
        ;;
    *)
        cp "$program/$file" "$work/a"
        cp "$api/$file" "$work/b"
        ;;
    esac
    [ -s "$work/a" ] || { echo "nothing of $file is compared"; exit 1; }
    cmp "$work/a" "$work/b" || { echo "$file differs from that of the program"; exit 1; }
done <"$work/program-files"
[ "$(wc -l <"$work/program-files")" -gt 30 ] || { echo "too few files"; exit 1; }
