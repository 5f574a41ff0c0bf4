#!/bin/sh
# murk render as a user runs it: the image's channels and provenance as Debian's
# exrheader reads them, the same bytes on any threads, and what is refused.
# usage: render.sh MURK
set -eu
murk=$1
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cat >"$dir/room.yaml" <<EOF
murk: 1
bands_nm: [414.5, 650]
seed: 3
domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}
geometry: [{box: {min_m: [0, 0, 0], max_m: [4, 4, 3]}, material: wall}]
materials: {wall: {diffuse: 0.5}}
media: {fog: {extinction_per_m: 0.2, albedo: 0.9}}
regions: [{medium: fog}]
lights: [{type: sphere, center_m: [1, 3, 2.5], radius_m: 0.2, power_w: 50}]
photons: {emit: 20000}
cameras:
  - {name: gate, from_m: [1, 1, 1], to_m: [3, 3, 1], pixels: [40, 30], samples: 2}
  - {name: out, from_m: [-1, 1, 1], to_m: [3, 3, 1]}
EOF
fail() { echo "$1"; exit 1; }

# refused CODE TEXT ARGS...
refused() {
    code=$1 text=$2
    shift 2
    status=0
    said=$("$murk" "$@" 2>&1 >/dev/null) || status=$?
    [ "$status" = "$code" ] || fail "murk $*: exit $status, want $code"
    case $said in *"$text"*) ;; *) fail "murk $*: $said" ;; esac
    [ "$(ls "$dir")" = room.yaml ] || fail "murk $*: has written a file"
}
# what pictures take goes by their tiles of 16 x 16 pixels, but for the maps
foretold() {
    "$murk" check "$dir/room.yaml" --quiet --format json --set cameras.0.pixels="$1" |
        sed -n '/"name": *"gate"/,/memory_bytes/s/.*"memory_bytes": *\([0-9.e+]*\).*/\1/p'
}
awk -v a="$(foretold '[1600, 160]')" -v b="$(foretold '[1600, 1600]')" -v c="$(foretold '[3200, 1600]')" \
    'BEGIN { exit !(a > 0 && (c - b) * 9 == (b - a) * 10) }' || fail "check foretells pictures wrongly"
refused 2 "gete is no camera of the scene, did you mean gate?" \
    render "$dir/room.yaml" --camera gete
refused 2 "must be within the domain, [0, 0, 0]..[4, 4, 3] m" \
    render "$dir/room.yaml" --camera out
refused 2 "cameras: the scene has none" render "$dir/room.yaml" --set 'cameras=[]'
refused 2 "volume, must be both for --method maps" \
    render "$dir/room.yaml" --set photons.maps=volume
refused 2 "bidirectional, must be maps | path" \
    render "$dir/room.yaml" --method bidirectional

for method in maps maps-only path; do
    "$murk" render "$dir/room.yaml" --quiet --method $method --threads 1 -o "$dir/1.exr"
    for threads in 2 5; do
        "$murk" render "$dir/room.yaml" --quiet --method $method --threads $threads \
            -o "$dir/more.exr"
        cmp "$dir/1.exr" "$dir/more.exr"
    done
    "$murk" render "$dir/room.yaml" --quiet --method $method --seed 4 -o "$dir/more.exr"
    cmp -s "$dir/1.exr" "$dir/more.exr" && fail "another seed gives the same image"
done
rm "$dir"/*.exr

said=$("$murk" render "$dir/room.yaml" --camera gate)
[ -f "$dir/room-gate.exr" ] || fail "no image beside the scene"
case $said in *"$dir/room-gate.exr"*) ;; *) fail "does not say where the image is" ;; esac

command -v exrheader >/dev/null || { echo "no exrheader here (Debian: openexr)"; exit 77; }
header=$(exrheader "$dir/room-gate.exr")
for line in "    S0.414,5nm, 32-bit floating-point" "    error.414,5nm" "    surface.650nm" \
    "    volume.650nm" "    depth.650nm" "    R, " "    error.G, " "    Z, " "    P.X, " \
    "dataWindow (type box2i): (0 0) - (39 29)" 'murkSeed (type string): "3"' \
    "murkCommand (type string): \"murk render $dir/room.yaml --camera gate\"" \
    'murkCamera (type string): "gate"' 'murkPhotons (type string): "20000"' \
    "murkSceneSha256 (type string): \"$(sha256sum <"$dir/room.yaml" | cut -d' ' -f1)\"" \
    'software (type string): "murk '; do
    case $header in *"$line"*) ;; *) fail "the header has no $line" ;; esac
done
