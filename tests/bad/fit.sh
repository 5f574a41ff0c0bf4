#!/bin/sh
# Bad calibrations: one line on standard error that names the place, exit 2,
# nothing written, within 10 seconds of processor time and 2 GB. And data that
# say too little: no crash, and what is not known has no error bar. Under a
# sanitizer, which sets aside more, memory is not limited.
# usage: fit.sh MURK [SANITIZER]
set -u
murk=$1
sanitizer=${2:-}
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
failed=0

cat >"$dir/scene.yaml" <<'END_OF_SCENE'
murk: 1
bands_nm: [550]
domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}
geometry: [{box: {min_m: [0.1, 0.1, 0.1], max_m: [3.9, 3.9, 2.9]}}]
media:
  fog: {extinction_per_m: 0.3, albedo: 0.9, phase: {hg: 0.6}}
  clean: {extinction_per_m: 0, albedo: 0.5}
  soot: {extinction_per_m: 0.001, albedo: 0}
regions: [{medium: fog}, {medium: clean}, {medium: soot}]
lights: [{type: point, position_m: [2, 2, 2.5], power_w: 10}]
photons: {emit: 2000}
sensors:
  types: [{name: node, range_m: 4}, {name: cam, range_m: 4, view: {cone_deg: 60}}]
  count: 1
conditions: {dim: {lights.0.power_w: 5}}
END_OF_SCENE

# refused PART-OF-MESSAGE HEADER-AND-ROWS OPTIONS...
refused() {
    part=$1
    echo "$2" >"$dir/data.csv"
    shift 2
    (
        ulimit -t 10
        [ -n "$sanitizer" ] || ulimit -v 2000000
        MALLOC_ARENA_MAX=2 timeout 60 "$murk" fit "$dir/scene.yaml" --data "$dir/data.csv" -o "$dir/out" "$@"
    ) >"$dir/stdout" 2>"$dir/stderr"
    got=$?
    if [ "$got" -ne 2 ] || [ "$(wc -l <"$dir/stderr")" -ne 1 ] || ! grep -qF -- "$part" "$dir/stderr"; then
        cat "$dir/data.csv"
        echo "  $*"
        echo "  exit $got, want 2; want one line with: $part"
        sed 's/^/  /' "$dir/stderr"
        failed=1
    fi
    if [ -d "$dir/out" ]; then
        echo "made $dir/out"
        failed=1
        rm -rf "$dir/out"
    fi
}

# said PART-OF-SUMMARY HEADER-AND-ROWS OPTIONS...
said() {
    part=$1
    echo "$2" >"$dir/data.csv"
    shift 2
    timeout 60 "$murk" fit "$dir/scene.yaml" --data "$dir/data.csv" "$@" \
        >"$dir/stdout" 2>"$dir/stderr"
    got=$?
    if [ "$got" -ne 0 ] || ! grep -qF -- "$part" "$dir/stdout" || grep -qi 'nan\|inf ' "$dir/stdout"; then
        cat "$dir/data.csv"
        echo "  $*"
        echo "  exit $got, want 0 and: $part"
        sed 's/^/  /' "$dir/stdout" "$dir/stderr"
        failed=1
    fi
}

beam='kind,x_m,y_m,z_m,x2_m,y2_m,z2_m,unit,value,standard_error'
beams="$beam
transmittance,1,1,1,3,1,1,fraction,0.5,0.01
transmittance,1,1,1,1,3,1,fraction,0.52,0.01
transmittance,1,1,1,1,2,1,percent,70,1"
light='kind,condition,x_m,y_m,z_m,radius_m,gain,unit,value,standard_error,use'
lights="$light
fluence,,1,1,1,.4,,W/m2,.3,.01,
fluence,,3,1,1,.4,,W/m2,.3,.01,
fluence,dim,1,3,2,.4,,W/m2,.3,.01,"
fog=media.fog.extinction_per_m

# memory: foretold before light is traced, however many photons are asked for
wide="$light
$(for i in 1 2 3 4 5 6 7 8 9 10 11 12; do echo "fluence,,2,2,1.5,1.2,,W/m2,.$i,.01,"; done)"
refused 'the fit would keep about' "$wide" --free $fog --emit 4294967295
refused 'the fit would keep about' "$wide" --free $fog --set photons.max_stored=4294967295 --store 4294967295

# keys: unknown ones, and what is no single number
refused "--free nope: a key of nope, must be of media, regions, lights or site" "$beams" --free nope
refused 'no meda in the scene, did you mean media?' "$beams" --free meda.fog.albedo
refused 'no fgo' "$beams" --free media.fgo.albedo
refused 'no albdo' "$beams" --free media.fog.albdo
refused '--free media.fog: a map, must be one number' "$beams" --free media.fog
refused '--free regions.0.medium: fog, must be a number' "$beams" --free regions.0.medium
refused '--free lights.0.position_m: a list of 3' "$lights" --free lights.0.position_m
refused 'lights.7' "$lights" --free lights.7.power_w
refused 'asked for twice' "$beams" --free $fog,$fog
refused '@dim behind the key, must be @each' "$lights" --free $fog@dim
refused 'no reading of' "$beams" --free gain.a
refused 'must be words with commas between' "$beams" --free ''
refused 'fits nothing' "$beams" --free $fog --predict fit.json
refused 'cannot read' "$beams" --predict "$dir/nowhere.json"
refused 'has no list of parameters' "$beams" --predict "$dir/scene.yaml"
i=0
while [ $i -lt 600 ]; do
    echo "- {key: media.fog.x$i, value: 1}"
    i=$((i + 1))
done | { echo 'parameters:'; cat; } >"$dir/long.json"
echo '{parameters: []}' >"$dir/none.json"
echo '{parameters: [{key: media.fog.albedo, value: 7}]}' >"$dir/seven.json"
echo '{parameters: [{key: media.fog.albedo@noon, value: .7}]}' >"$dir/noon.json"
refused 'long.json: 600 parameters, must be 1..512' "$beams" --predict "$dir/long.json"
refused 'none.json: 0 parameters, must be 1..512' "$beams" --predict "$dir/none.json"
refused 'media.fog.albedo: 7, must be 0..1' "$beams" --predict "$dir/seven.json"
refused 'has no value of media.fog.albedo@scene' "$beams" --predict "$dir/noon.json"
echo 'media.fog.albedo: [1, 2]' >"$dir/list.yaml"
refused 'list.yaml:1:1: media.fog.albedo: must be a number or a word' "$beams" --free $fog --set "@$dir/list.yaml"
refused '--set @: no name' "$beams" --free $fog --set @
# a start that cannot be re-weighted, with advice
refused 'must start above 0, by another value of media.clean.extinction_per_m' "$lights" --free media.clean.extinction_per_m
refused 'must start above 0, by another value of media.soot.albedo' "$lights" --free media.soot.albedo
# bounds and other options
refused 'the first must be less than the second' "$beams" --free $fog --bounds $fog=2:1
refused 'must be KEY=LOW:HIGH' "$beams" --free $fog --bounds $fog=nan:1
refused 'is no free key' "$beams" --free $fog --bounds media.fog.albedo=.1:.9
refused 'must be within its bounds, 0.5 to 1' "$beams" --free $fog --bounds $fog=.5:1
refused 'must be none, huber or cauchy' "$beams" --free $fog --loss tukey
refused 'must be none, huber or cauchy' "$beams" --free $fog --loss huber:0
refused '--starts: 0' "$beams" --free $fog --starts 0
refused '--next: -1' "$beams" --free $fog --next -1
refused 'new places are proposed for such readings' "$beams" --free $fog --next 2
# more parameters than rows
refused '3 rows to be fitted (0 held out) for 4 parameters' "$lights" --free $fog,media.fog.albedo,media.fog.phase.hg,lights.0.power_w
refused '2 rows to be fitted (1 held out) for 3 parameters' "${lights}hold_out" --free $fog,media.fog.albedo,media.fog.phase.hg
# rows: outside the domain, without errors, NaN, in contradictory units
refused 'data.csv:2: x_m: the place [9, 1, 1] m is outside the domain' "$beam
transmittance,9,1,1,3,1,1,fraction,.5,.01" --free $fog
refused 'data.csv:3: x2_m' "$beam
transmittance,1,1,1,3,1,1,fraction,.5,.01
transmittance,1,1,1,3,1,8,fraction,.5,.01" --free $fog
refused 'data.csv:2: radius_m' "$light
fluence,,.1,1,1,.4,,W/m2,.3,.01," --free $fog
refused 'data.csv:2: standard_error: 0, must be more than 0' "$beam
transmittance,1,1,1,3,1,1,fraction,.5,0" --free $fog
refused 'data.csv:2: standard_error: nothing' "$beam
transmittance,1,1,1,3,1,1,fraction,.5," --free $fog
refused 'data.csv:2: standard_error: -1' "$beam
transmittance,1,1,1,3,1,1,fraction,.5,-1" --free $fog
refused 'data.csv:2: value: nan' "$beam
transmittance,1,1,1,3,1,1,fraction,nan,.01" --free $fog
refused 'data.csv:2: standard_error: inf' "$beam
transmittance,1,1,1,3,1,1,fraction,.5,inf" --free $fog
refused 'data.csv:2: x_m: nan' "$beam
transmittance,nan,1,1,3,1,1,fraction,.5,.01" --free $fog
refused 'data.csv:2: value: 1e400' "$beam
transmittance,1,1,1,3,1,1,fraction,1e400,.01" --free $fog
refused 'data.csv:2: unit: percent_per_m' "$beam
transmittance,1,1,1,3,1,1,percent_per_m,50,1" --free $fog
refused 'data.csv:2: unit: lux' "$beam
transmittance,1,1,1,3,1,1,lux,50,1" --free $fog
refused 'data.csv:2: gain: is empty, but light with the unit relative has an unknown factor' "$light
fluence,,1,1,1,.4,,relative,.3,.01," --free $fog
refused 'which is not free: gain.a must be a free key' "$light
fluence,,1,1,1,.4,a,relative,.3,.01," --free $fog
refused 'data.csv:3: unit: W/m2, but line 2 of factor a is in relative' "$light
fluence,,1,1,1,.4,a,relative,.3,.01,
fluence,,1,1,1,.4,a,W/m2,.3,.01," --free gain.a
refused 'data.csv:2: condition: noon' "$light
fluence,noon,1,1,1,.4,,W/m2,.3,.01," --free $fog
refused 'data.csv:2: kind: no radiance, did you mean irradiance?' "$light
radiance,,1,1,1,.4,,W/m2,.3,.01," --free $fog
refused 'data.csv:2: use: test' "$light
fluence,,1,1,1,.4,,W/m2,.3,.01,test" --free $fog
# files of another shape
refused 'data.csv:5: 9 cells, must be 10' "$beams
transmittance,1,1,1,3,1,1,fraction,.5" --free $fog
refused 'data.csv:1:' 'a,b
1,2' --free $fog
refused 'data.csv:1:' '{"murk": 1}' --free $fog
refused 'data.csv' '' --free $fog
refused '0 readings' "$beam" --free $fog
# coverage that has no derivative
coverage='kind,x_m,y_m,z_m,sensor,value,standard_error
coverage,1,1,1,node,.4,.01'
refused 'threshold' "$coverage" --free $fog --set placement.detection=threshold

# light that enters through the outside
refused 'domain: outside: continued does not go with fits, use sides: periodic or outside: empty' \
    "$lights" --free $fog --set domain.outside=continued

# singular: said, with the combination that is free; no error bar of what has none
said 'undetermined 1.00 media.fog.albedo' "$beams" --free media.fog.albedo
said 'media.fog.albedo = 0.9 (not determined by these data)' "$beams" --free $fog,media.fog.albedo
said 'media.fog.extinction_per_m = 0.339597 +- 0.0063' "$beams" --free $fog,media.fog.albedo
# nothing is there where light is as bright as in clear air, and relative light
# of any size is no trouble
said 'gain.a' "$light
fluence,,1,1,1,.4,a,relative,3e9,1e8,
fluence,,3,1,1,.4,a,relative,3e9,1e8,
fluence,,3,3,1,.4,a,relative,3e9,1e8," --free $fog,gain.a
said 'converged' "$beam
transmittance,1,1,1,3,1,1,fraction,1,.001
transmittance,1,1,1,1,3,1,fraction,1,.001" --free $fog
exit $failed
