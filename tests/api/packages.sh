#!/bin/sh
# Builds the Debian packages, asks lintian, installs them with apt into a bare Debian
# 12 made by debootstrap, and runs the program and the Python module there. Without
# lintian or debootstrap, or without root for debootstrap, that part is skipped with
# a line. Needs a network for debootstrap and for the packages that murk depends on.
#
#     packages.sh BUILD [BASE]
#
# The packages are built in the folder BUILD; murk-mpi is one of them if that folder
# was configured with -DMURK_MPI=ON before. BASE is a root that debootstrap made
# before, which is copied; without it one is made.
set -eu
build=$1
base=${2:-}
source=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
    echo "$*"
    exit 1
}

# the packages
rm -f "$build"/*.deb
{
    cmake -S "$source" -B "$build" -DCMAKE_INSTALL_PREFIX=/usr -DMURK_PYTHON=ON -DMURK_TESTS=OFF &&
        cmake --build "$build" && (cd "$build" && cpack -G DEB)
} >"$work/log" 2>&1 || {
    tail -n 40 "$work/log"
    exit 1
}
packages="murk libmurk0 libmurk-dev python3-murk murk-doc"
grep -q '^MURK_MPI:BOOL=ON' "$build/CMakeCache.txt" && packages="$packages murk-mpi"
for package in $packages; do
    [ -f "$(echo "$build/$package"_*.deb)" ] || fail "no package $package"
done

# every man page of the build is in a package, compressed; so are the changelogs
find "$build/man" -name '*.[1-8]' | sed "s|$build/man/\(.*\)|./usr/share/man/\1.gz|" | sort >"$work/made"
for package in "$build"/*.deb; do
    dpkg-deb --fsys-tarfile "$package" | tar -t
done >"$work/packed"
grep '^\./usr/share/man/.*[^/]$' "$work/packed" | sort | diff "$work/made" - || fail "packages with other man pages"
grep '^\./usr/share/doc/[^/]*/changelog' "$work/packed" | grep -v '\.gz$' && fail "a changelog is not compressed"

# lintian
if command -v lintian >/dev/null; then
    [ "$(id -u)" = 0 ] && as_root=--allow-root || as_root=
    lintian $as_root --fail-on error,warning "$build"/*.deb || fail "lintian refuses the packages"
else
    echo "skipped: no lintian"
fi

# a bare Debian 12
[ "$(id -u)" = 0 ] || { echo "skipped: installing needs root"; exit 77; }
if [ -n "$base" ]; then
    cp -a "$base" "$work/root"
else
    command -v debootstrap >/dev/null || { echo "skipped: no debootstrap"; exit 77; }
    debootstrap --variant=minbase bookworm "$work/root" >"$work/log" 2>&1 || {
        tail -n 20 "$work/log"
        fail "debootstrap failed"
    }
fi
mkdir "$work/root/packages"
cp "$build"/*.deb "$work/root/packages"
inside() {
    chroot "$work/root" env DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 "$@" >"$work/log" 2>&1 || {
        tail -n 40 "$work/log"
        fail "failed in the bare Debian: $*"
    }
}
inside apt-get update
inside sh -c 'apt-get install -y --no-install-recommends /packages/*.deb'
inside murk --version
inside murk place /usr/share/doc/murk-doc/scenes/paper-room.yaml --store 2000 --set placement.restarts=2 -o /results
[ -s "$work/root/results/plan.json" ] || fail "murk place wrote no plan.json"
cat >"$work/root/module.py" <<'PYTHON'
import murk
scene = murk.Scene(file="/usr/share/doc/murk-doc/scenes/paper-room.yaml")
scene["photons"] = {"store": 2000}
scene["placement.restarts"] = 2
assert scene.place().sensors, "the plan has no sensors"
assert not any(row["failed"] for row in scene.study({"seed": [1, 2]}, ["coverage_best"]).rows), "a row failed"
PYTHON
inside python3 /module.py
inside python3 /usr/share/doc/python3-murk/examples/numpy_grid.py
inside test -e /usr/share/bash-completion/completions/murk -a -e /usr/share/zsh/site-functions/_murk

case $packages in *murk-mpi*)
    inside mpirun --allow-run-as-root --oversubscribe -n 2 murk-mpi trace /usr/share/doc/murk-doc/scenes/paper-room.yaml --store 2000 -o /ranks
    [ -s "$work/root/ranks/ledger.json" ] || fail "murk-mpi trace wrote no ledger.json"
    ;;
esac

# removing the packages leaves no file
# shellcheck disable=SC2086
inside apt-get purge -y $packages
left=$(find "$work/root/usr" -name '*murk*')
[ -z "$left" ] || fail "left by the packages: $left"
