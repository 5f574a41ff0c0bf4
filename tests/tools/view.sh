#!/bin/sh
# What murk writes for viewers opens in Blender and ParaView with all that its
# headers promise, and shows something; a file that is cut short does not pass.
# usage: view.sh MURK
set -eu
command -v blender >/dev/null || command -v pvpython >/dev/null || {
    echo "skipped: no blender and no paraview"
    exit 77
}
murk=$1
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
sed -n '/^murk: 1/,/^"""/p' tests/golden/crate.py | sed '/^"""/d' >"$dir/scene.yaml"
"$murk" place "$dir/scene.yaml" -q -o "$dir/out" --export fields,photons,surfaces --voxel 0.5
tools/view "$dir/out" "$dir/pictures" >"$dir/said" || {
    cat "$dir/said"
    exit 1
}
cat "$dir/said"
files=0
for viewer in blender paraview; do
    grep -q "^$viewer .*skipped" "$dir/said" && continue
    case $viewer in
    blender) kinds="vdb ply" ;;
    *) kinds="vti vtp ply" ;;
    esac
    for kind in $kinds; do
        for file in "$dir/out"/*."$kind"; do
            grep -q "^$viewer *$(basename "$file") " "$dir/said" || {
                echo "$viewer says nothing of $(basename "$file")"
                exit 1
            }
            files=$((files + 1))
        done
    done
done
[ "$files" -ge 5 ] || exit 1
# teeth: a mesh that lacks its end, a volume without its grids
mkdir "$dir/cut"
head -c 20000 "$dir/out/surfaces.ply" >"$dir/cut/surfaces.ply"
cp "$dir/out/fields.vti" "$dir/cut/"
cp "$dir/out/box.vdb" "$dir/cut/coverage.vdb"
if tools/view "$dir/cut" "$dir/pictures" >"$dir/said"; then
    echo "files that are cut or exchanged passed:"
    cat "$dir/said"
    exit 1
fi
for file in surfaces.ply coverage.vdb; do
    grep -q "^blender .*skipped" "$dir/said" || grep -q "^blender *$file *FAILED" "$dir/said" || {
        echo "$file did not fail:"
        cat "$dir/said"
        exit 1
    }
done
