"""Placement at size, as `murk place` does it: the known environment with its
matrix, and greedy in the unknown one, with what each may take and must reach.

usage: scale.py MURK [known|unknown]

Time is limited twice: ten minutes by the clock, which is what a user of two
processors waits, and as processor time, which what else runs does not change.
"""

import json
import resource
import subprocess
import sys
import time

SCENE = "tests/nightly/warehouse.yaml"
CLOCK_S = 600
CASES = {
    # 100,000 photons, 20,024 places that see 5 % of them, 20 sensors
    "known": ([], dict(photons=100000, places=20000, bytes=4e9, cpu_s=1200, gap=0.05)),
    # 1,000,000 photons, 5182 places
    "unknown": (
        ["--store", "1000000",
         "--set", "placement.knowledge=unknown", "--set", "placement.method=greedy",
         "--set", "sensors.candidates.grid.size=[40, 28, 5]"],
        dict(photons=1000000, places=5000, bytes=2e9, cpu_s=600, gap=0.15)),
}


def run(murk, name):
    options, limits = CASES[name]
    begun_s, before = time.monotonic(), resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(
        [murk, "place", SCENE, "--quiet", "--format", "json", *options],
        capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    wall_s = time.monotonic() - begun_s
    cpu_s = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    if done.returncode:
        return [done.stderr.strip() or "exit %d" % done.returncode]
    plan = json.loads(done.stdout)
    took = plan["run"]["peak_memory_bytes"]
    gap = plan["bound"]["gap"]
    print("%s: %d photons, %d places, coverage %.4f, gap %.2f %%, %.0f s of processor (at most "
          "%d), %.0f s by the clock (at most %d), %.2f GB"
          % (name, plan["photons"]["surface"], plan["candidates"]["usable"],
             plan["coverage"]["in_sample"], 100 * gap, cpu_s, limits["cpu_s"], wall_s, CLOCK_S,
             took * 1e-9))
    checks = [
        ("photons", plan["photons"]["surface"] >= limits["photons"]),
        ("places", plan["candidates"]["usable"] >= limits["places"]),
        ("sensors", len(plan["sensors"]) == 20),
        ("memory", took <= limits["bytes"]),
        ("processor time", cpu_s <= limits["cpu_s"]),
        ("time by the clock", wall_s <= CLOCK_S),
        ("gap", 0 <= gap < limits["gap"]),
    ]
    return ["%s: %s" % (name, what) for what, holds in checks if not holds]


def main(murk, names):
    failures = [text for name in names or CASES for text in run(murk, name)]
    for text in failures:
        print("failed:", text)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
