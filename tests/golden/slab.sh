#!/bin/sh
# scenes/slab.yaml as a user runs it: van de Hulst's slab from tallies.csv.
# Two z-tests share a 1e-6 chance of a false alarm: 5.0 sigma each (Sidak). An
# albedo of .88 must fail. The error of what goes through is that of the angle
# bins' sum: each photon is in one bin, so variances add but for -p q, and the
# plain binomial error of the sum is taken.
# usage: slab.sh MURK
set -eu
murk=$1
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT

# measure ARGS...: prints the sigmas that reflected and transmitted are off
measure() {
    "$murk" trace scenes/slab.yaml --quiet --emit 200000 -o "$dir" "$@"
    awk -F, -v n=200000 '
        $1 == "top" && $6 == "forward" { r = $7; e = $8 }
        $1 == "bottom" && $6 == "backward" { t += $7 }
        END {
            off_r = (r - .09739) / e
            off_t = (t - .66096) / sqrt(t * (1 - t) / n)
            printf "%.2f %.2f\n", off_r < 0 ? -off_r : off_r, off_t < 0 ? -off_t : off_t
        }' "$dir/tallies.csv"
}

right=$(measure)
wrong=$(measure --set media.fog.albedo=0.88)
echo "sigmas off: $right; with a wrong albedo: $wrong"
echo "$right" | awk '{ exit !($1 <= 5 && $2 <= 5) }'
echo "$wrong" | awk '{ exit !($1 > 5 && $2 > 5) }'
