#!/usr/bin/env python3
"""murk place --start from outside: a plan is kept or improved with little work,
whatever form the file has and however many threads there are, and what cannot be
a start is refused in one line. Standard library only.
usage: start_plan.py MURK
"""

import os
import subprocess
import sys
import tempfile

import from_outside
from from_outside import ROOM, check

FOG = ("--set", "media.fog.extinction_per_m=[0.6, 1.2]")
# Greedy for the worst condition finds the level that it reaches by bisection, in steps that
# depend on the plans before, down to this one (src/placement/worst.c).
LEVEL_FINEST = 2 ** -16
CONDITIONS = ("--set", "conditions={clear: {media.fog.extinction_per_m: 0.01}, "
              "fog: {media.fog.extinction_per_m: 1}}")


def place_of(plan):
    return [(s["type"], s["position_m"]) for s in plan["sensors"]]


def value_of(plan):
    return plan["bound"]["upper"] * (1 - plan["bound"]["gap"])


def test_the_same_plan(murk, scene):
    plan = murk.run("place", scene, "-o", murk.path("first"))
    check("started_from" not in plan["placement"], "started_from without a start")
    for file in ("plan.json", "sensors.csv"):
        again = murk.run("place", scene, "--start", murk.path("first", file))
        work = again["placement"]
        check(place_of(again) == place_of(plan), file, place_of(again))
        check(again["coverage"] == plan["coverage"], file, again["coverage"])
        check(work["started_from"] == 3 and work["starts"] == 0 and work["nodes"] == 0,
              file, work)
        check(work["evaluations"] < plan["placement"]["evaluations"] / 4, file,
              work["evaluations"], "evaluations of", plan["placement"]["evaluations"])
        check(again["bound"]["upper"] >= plan["coverage"]["in_sample"] - 1e-12, again["bound"])


def test_a_step(murk, scene):
    """Denser fog: the plan of the step before is improved, and no worse than
    greedy's, for any threads and in an unknown environment alike."""
    start = ("--start", murk.path("first", "plan.json"))
    greedy = murk.run("place", scene, *FOG, "--set", "placement.method=greedy")
    kept = murk.run("sense", scene, *FOG, "--sensors", murk.path("first", "plan.json"))
    plan = murk.run("place", scene, *FOG, *start, "-j1")
    for other in (greedy, kept):
        check(plan["coverage"]["in_sample"] >= other["coverage"]["in_sample"] - 1e-12,
              plan["coverage"], other["coverage"])
    for options in (("-j2",), ("-j5",), ("--set", "placement.knowledge=unknown")):
        again = murk.run("place", scene, *FOG, *start, *options)
        check(place_of(again) == place_of(plan), options, place_of(again))
    for method in ("spoq", "exact"):
        again = murk.run("place", scene, *FOG, *start, "--set", f"placement.method={method}")
        check(again["placement"]["started_from"] == 3, method, again["placement"])


def test_other_numbers(murk, scene):
    start = ("--start", murk.path("first", "plan.json"))
    for count, taken in ((2, 2), (5, 3)):
        plan = murk.run("place", scene, *start, "--count", str(count))
        check(len(plan["sensors"]) == count, count, plan["sensors"])
        check(plan["placement"]["started_from"] == taken, count, plan["placement"])
    plan = murk.run("place", scene, *start, "--set", "sensors.candidates.spacing_m=1.5",
                    "--set", "sensors.fixed=[{type: node, position_m: [1, 1, 1]}]")
    check(len(plan["sensors"]) == 3, plan["sensors"])
    for goal in (("--target", "0.4"), ("--budget", "2")):
        plan = murk.run("place", scene, *start, *goal)
        check(plan["placement"]["started_from"] > 0, goal, plan["placement"])


def test_over_conditions(murk, scene):
    start = ("--start", murk.path("first", "plan.json"))
    for over in ("mean", "worst", "regret"):
        options = (*CONDITIONS, "--set", f"placement.over={over}")
        plan = murk.run("place", scene, *options, *start)
        greedy = murk.run("place", scene, *options, "--set", "placement.method=greedy")
        check(plan["placement"]["started_from"] == 3, over, plan["placement"])
        check(plan["placement"]["nodes"] == 0, over, plan["placement"])
        if over != "regret":  # the value there depends on the plans for comparison
            check(value_of(plan) >= value_of(greedy) - LEVEL_FINEST, over, plan["bound"],
                  greedy["bound"])


def test_notes(murk, scene):
    start = ("--start", murk.path("first", "plan.json"))
    done = murk.call("place", scene, *start, "--set", "placement.method=greedy",
                     "--set", "photons.emit=3000")
    check(done.stderr.count("\n") == 1 and "has no effect with method: greedy" in done.stderr,
          done.stderr)
    murk.write("far.csv", "type,x_m,y_m,z_m\nnode,0.5,0.5,0.5\nnode,0.2,0.2,0.2\n")
    wide = ("--set", "sensors.candidates={grid: {min_m: [3, 3, 1], max_m: [3.5, 3.5, 2], "
            "size: [2, 2, 2]}}")
    done = murk.call("place", scene, "--start", murk.path("far.csv"), *wide)
    check(done.stderr.count("\n") == 1 and "far.csv: sensor 2 lies" in done.stderr, done.stderr)


def refused(murk, says, *words):
    done = subprocess.run([murk.program, *words], capture_output=True, text=True, timeout=60)
    check(done.returncode == 2 and done.stderr.count("\n") == 1 and says in done.stderr,
          words, "ends with", done.returncode, done.stderr)


def test_refusals(murk, scene):
    murk.write("buoy.csv", "type,x_m,y_m,z_m\nbuoy,1,1,1\n")
    murk.write("broken.json", '{"sensors": [{"type": "node", "position_m": [1, 1')
    murk.write("other.json", '{"lights": []}')
    for command in ("place", "check"):
        refused(murk, "buoy.csv:2: type: buoy is no type of the scene's sensors",
                command, scene, "--start", murk.path("buoy.csv"))
    refused(murk, "broken.json:2:1: not YAML", "place", scene, "--start", murk.path("broken.json"))
    refused(murk, 'other.json: has no list "sensors"', "place", scene, "--start",
            murk.path("other.json"))
    refused(murk, "none.json", "place", scene, "--start", murk.path("none.json"))
    start = ("--start", murk.path("first", "plan.json"))
    refused(murk, "start_plan is given with knowledge: explore", "place", scene, *start,
            "--set", "placement.knowledge=explore", "--set", "placement.start_m=[1, 1, 1]")
    refused(murk, "is read by this run", "place", scene, *start, "--force", "-o",
            murk.path("first"))
    murk.write("matrix.csv", "1,1\n1,0\n")
    refused(murk, "a matrix has no such key", "place", "--matrix", murk.path("matrix.csv"),
            "--count", "1", *start)


def main():
    with tempfile.TemporaryDirectory() as folder:
        murk = from_outside.Murk(os.path.abspath(sys.argv[1]), folder)
        scene = murk.write("room.yaml", ROOM)
        test_the_same_plan(murk, scene)
        test_a_step(murk, scene)
        test_other_numbers(murk, scene)
        test_over_conditions(murk, scene)
        test_notes(murk, scene)
        test_refusals(murk, scene)
    print("searches begin at given plans" if not from_outside.failures
          else f"{from_outside.failures} failed")
    return from_outside.failures != 0


if __name__ == "__main__":
    sys.exit(main())
