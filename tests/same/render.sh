#!/bin/sh
# A picture is the same for 1, 2 and 5 threads, by maps, by maps alone and by
# paths: through fog of droplets, whose phase function is worked out in threads,
# too, and of so many photons that kernels are laid in several batches.
# usage: render.sh MURK
set -eu
murk=$1
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
camera='cameras=[{name: c, from_m: [2, 2, 1.7], to_m: [12, 9, 1], vfov_deg: 60, pixels: [32, 24], samples: 4}]'
picture() { # OUT OPTIONS...
    out=$1
    shift
    "$murk" render scenes/fog-yard.yaml --set "$camera" --emit 20000 --quiet -o "$dir/$out.exr" "$@"
}
for method in maps maps-only path; do
    for threads in 1 2 5; do
        picture $method$threads --method $method --threads $threads
    done
    for threads in 2 5; do
        cmp "$dir/${method}1.exr" "$dir/$method$threads.exr" || {
            echo "$method: threads change the picture: 1 and $threads"
            exit 1
        }
    done
    # teeth: another seed must not give the same picture
    picture other --method $method --threads 2 --seed 12345
    if cmp -s "$dir/${method}1.exr" "$dir/other.exr"; then
        echo "$method: another seed gave the same picture"
        exit 1
    fi
done
