#!/bin/sh
# Bad input on the command line: one line on standard error, the right exit
# code, nothing written, within 10 seconds and 2 GB.
# usage: cli.sh MURK
set -u
murk=$1
dir=$(mktemp -d)
trap 'chmod -R u+w "$dir"; rm -rf "$dir"' EXIT
failed=0

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
    (
        ulimit -t 10
        timeout 20 "$murk" "$@" >"$dir/stdout" 2>"$dir/stderr"
    )
    got=$?
    lines=$(grep -cv '^murk: warning:' "$dir/stderr")
    if [ "$got" -ne "$code" ] || [ "$lines" -ne 1 ] || ! grep -qF -- "$part" "$dir/stderr"; then
        echo "murk $*"
        echo "  exit $got, want $code; want one line with: $part"
        sed 's/^/  /' "$dir/stderr"
        failed=1
    fi
    if [ -d "$dir/out" ] && [ -n "$(ls -A "$dir/out")" ]; then
        echo "murk $*: wrote $(ls -A "$dir/out")"
        failed=1
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
expect 2 "not supported yet" render "$dir/good.yaml"
expect 2 "no scene" place
expect 2 "no such option" place "$dir/good.yaml" --sed 3
expect 2 "--seed: -1" place "$dir/good.yaml" --seed -1
expect 2 "--seed: 4294967296" place "$dir/good.yaml" --seed 4294967296
expect 2 "--threads: 0" place "$dir/good.yaml" --threads 0
expect 2 "--emit: 12abc" place "$dir/good.yaml" --emit 12abc
expect 2 "--emit: nan" place "$dir/good.yaml" --emit nan
expect 2 "--emit: 1152921504606846976" place "$dir/good.yaml" --emit 1152921504606846976
expect 2 "emit" place "$dir/good.yaml" --emit 10 --store 10
expect 2 "needs a value" place "$dir/good.yaml" --emit
expect 2 "not an option of murk trace" trace "$dir/good.yaml" --count 3
expect 2 "not supported yet" place "$dir/good.yaml" --target 0.9
expect 2 "KEY=VALUE" place "$dir/good.yaml" --set seed
expect 2 "must be text | json" place "$dir/good.yaml" --format xml
expect 2 "replay needs --photon" replay "$dir/good.yaml"
expect 2 "--photon: 2000" replay "$dir/good.yaml" --photon 2000
expect 2 "sense needs --sensors" sense "$dir/good.yaml"

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
place 2 "not supported yet"
expect 2 "sensors" place "$dir/good.yaml" --count 49 -o "$dir/out"
expect 2 "must be 1..48" place "$dir/good.yaml" --count 49 -o "$dir/out"
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
{
    cat "$dir/good.yaml"
    echo 'media: {smoke: {vdb: nowhere.vdb, extinction_per_m: 1, albedo: 0.5, phase: isotropic}}'
    echo 'regions: [{medium: smoke}]'
} >"$dir/bad.yaml"
place 2 "nowhere.vdb"
sed 's|nowhere.vdb|good.yaml|' "$dir/bad.yaml" >"$dir/bad2.yaml"
expect 2 "media.smoke" place "$dir/bad2.yaml" -o "$dir/out"

# ---- results that cannot be written: the old ones stay ----
expect 1 "not a folder" place "$dir/good.yaml" -o "$dir/good.yaml"
"$murk" place "$dir/good.yaml" -q -o "$dir/kept" || failed=1
sum=$(cat "$dir"/kept/* | cksum)
(
    ulimit -f 40 # blocks of 512 bytes: light.murk does not fit
    "$murk" place "$dir/good.yaml" -q -o "$dir/kept" --emit 20000 2>"$dir/stderr"
)
[ $? -eq 1 ] && [ "$(wc -l <"$dir/stderr")" -eq 1 ] || {
    echo "a full disk: exit code or message is off"
    cat "$dir/stderr"
    failed=1
}
[ "$sum" = "$(cat "$dir"/kept/* | cksum)" ] || { echo "a full disk hurt older results"; failed=1; }
[ "$(ls -A "$dir/kept" | wc -l)" -eq 6 ] || { echo "left behind: $(ls -A "$dir/kept")"; failed=1; }
if [ "$(id -u)" -ne 0 ]; then
    chmod a-w "$dir/kept"
    (expect 1 "cannot write" place "$dir/good.yaml" -o "$dir/kept")
    chmod u+w "$dir/kept"
fi
[ -e /dev/full ] && { "$murk" check "$dir/good.yaml" >/dev/full 2>"$dir/stderr"; [ $? -eq 1 ] || {
    echo "a full standard output went unnoticed"; failed=1; }; }

# ---- interrupt: no half file, exit 130 ----
"$murk" trace "$dir/good.yaml" -q -o "$dir/stopped" --emit 4e9 --set photons.maps=none 2>"$dir/stderr" &
pid=$!
sleep 1
kill -INT $pid
wait $pid
got=$?
[ $got -eq 130 ] && grep -q interrupted "$dir/stderr" || {
    echo "interrupted: exit $got, want 130"
    cat "$dir/stderr"
    failed=1
}
[ -z "$(ls -A "$dir/stopped" 2>/dev/null)" ] || { echo "interrupted: left $(ls -A "$dir/stopped")"; failed=1; }

[ $failed -eq 0 ] && echo "all refused as they should be"
exit $failed
