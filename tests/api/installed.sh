# Sourced by the tests of an installed murk. install_and_build BUILD PROGRAMS installs
# the build into $work/murk, builds the CMake project in the folder PROGRAMS against
# it in $work/build, and sets $library to the folder of the library, which the
# programs then find. $work is removed at the end.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
install_and_build() {
    {
        cmake --install "$1" --prefix "$work/murk" &&
            cmake -S "$2" -B "$work/build" -DCMAKE_PREFIX_PATH="$work/murk" &&
            cmake --build "$work/build"
    } >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
    library=$(dirname "$(find "$work/murk" -name libmurk.so)")
    export LD_LIBRARY_PATH="$library"
}
