#!/bin/sh
# Bad presets, in scenes and asked of murk media: one line on standard error,
# exit code 2, nothing written. Good ones, with a word of each kind, are read.
# usage: presets.sh MURK
set -u
murk=$1
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
failed=0

cat >"$dir/fog.yaml" <<'END'
murk: 1
bands_nm: [550]
domain: {min_m: [0, 0, 0], max_m: [9, 9, 9]}
media: {fog: {preset: fog/kim, visibility_m: 50}}
regions: [{medium: fog}]
lights: [{type: point, position_m: [4, 4, 4], power_w: 1}]
photons: {emit: 100}
END

# bad PART-OF-MESSAGE ARGS...
bad() {
    part=$1
    shift
    timeout 60 "$murk" "$@" >"$dir/stdout" 2>"$dir/stderr"
    got=$?
    lines=$(grep -c '' "$dir/stderr")
    if [ "$got" -ne 2 ] || [ "$lines" -ne 1 ] || [ -s "$dir/stdout" ] ||
        ! grep -qF -- "$part" "$dir/stderr"; then
        echo "murk $*"
        echo "  exit $got, want 2; want one line with: $part"
        sed 's/^/  /' "$dir/stderr"
        failed=1
    fi
    if [ -d "$dir/out" ] && [ -n "$(ls -A "$dir/out")" ]; then
        echo "murk $*: wrote $(ls -A "$dir/out")"
        failed=1
    fi
    rm -rf "$dir/out"
}
scene() {
    part=$1
    shift
    bad "$part" trace "$dir/fog.yaml" -o "$dir/out" "$@"
}
# good PART-OF-OUTPUT ARGS...
good() {
    part=$1
    shift
    if ! timeout 60 "$murk" "$@" >"$dir/stdout" 2>"$dir/stderr" ||
        [ -s "$dir/stderr" ] || ! grep -qF -- "$part" "$dir/stdout"; then
        echo "murk $*: want: $part"
        sed 's/^/  /' "$dir/stderr"
        failed=1
    fi
}

scene "0, must be more than 0" --set media.fog.visibility_m=0
scene "-50, must be more than 0" --set media.fog.visibility_m=-50
scene "nan, must be a number" --set media.fog.visibility_m=nan
scene "5, must be 10..200000 m for fog/kim" --set media.fog.visibility_m=5
scene "did you mean fog/kim?" --set media.fog.preset=fog/kin
scene "no preset /etc/passwd" --set media.fog.preset=/etc/passwd
scene "no preset ../fog/kim" --set media.fog.preset=../fog/kim
scene "both on the command line" --set media.fog.visibility_m=50 \
    --set media.fog.mor_m=50
scene "has visibility_m and mor_m" \
    --set "media.fog={preset: fog/kim, visibility_m: 50, mor_m: 50}"
scene "fog/kim does not know it" --set media.fog.rain_mm_per_h=5
scene "did you mean visibility_m?" --set media.fog.visibilty_m=5
scene "400..1550 nm for fog/kim" --set "bands_nm=[399]"
scene "400..1550 nm for fog/kim" --set "bands_nm=[550, 1e9]"
scene "not a key of a medium (preset)" \
    --set "media.fog.profile={z_m: [0, 1], extinction_per_m: [1, 2]}"
scene "not a key of a medium (homogeneous)" \
    --set "media.fog={extinction_per_m: 1, albedo: 1, visibility_m: 5}"
scene "a visibility of 330000 m, must be at most" \
    --set "media.fog={preset: air/haze, visibility_m: 330000, pressure_hpa: 1100}"
bad "did you mean rain/itu-r?" media rain/itu
bad "0, must be more than 0" media fog/kim --set visibility_m=0
bad "did you mean visibility_m?" media fog/kim --set visiblity_m=9
bad "400..1550 nm for fog/kim" media fog/kim --set "bands_nm=[300]"
bad "needs the name of a preset" media --set visibility_m=9

good "fog/kim" media
good "extinction/m" media fog/kim --set mor_m=80
good '"extinction_per_m"' media smoke/flaming --set soot_g_per_m3=2 --format json
good "extinction" check "$dir/fog.yaml" --set media.fog.mor_m=30

# Headings of the page of a preset stand on lines of their own.
"$murk" media water/case-1 >"$dir/stdout" 2>&1
for heading in words sources doubts; do
    if ! grep -qx "$heading" "$dir/stdout"; then
        echo "murk media water/case-1: no heading: $heading"
        failed=1
    fi
done

exit $failed
