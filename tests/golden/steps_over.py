#!/usr/bin/env python3
"""One plan for all steps of a timeline (placement.over) with fixed sensors that move and fail, from outside: in each step
the plan covers what murk sense and murk place say of the sensors as they are then. Standard library only.
usage: steps_over.py MURK
"""

import os
import subprocess
import sys
import tempfile

import from_outside
from from_outside import ROOM, check, near

STEPS = [0, 10, 20]
FIXED = "fixed: [{type: node, position_m: [2, 2, 1]}, {type: node, position_m: [1, 3, 2]}]"
TRACKS = """\
timeline:
  from_s: 0
  to_s: 20
  every_s: 10
  tracks:
    - {sensor: 0, keyframes: [{t_s: 0, position_m: [2, 2, 1]}, {t_s: 20, position_m: [3.5, 1, 2]}]}
    - {sensor: 1, fails_at_s: 10}
    - {key: media.fog.albedo, keyframes: [{t_s: 0, value: 0.9}, {t_s: 20, value: 0.8}]}
"""
SCENE = ROOM.replace("  count: 3", f"  {FIXED}\n  count: 4") + TRACKS


def sensors_at(positions, t_s):
    """The sensors of a plan, whose last two are fixed, as they are at a time."""
    planned = [list(x) for x in positions[:-2]]
    check([list(x) for x in positions[-2:]] == [[2, 2, 1], [1, 3, 2]], "the fixed sensors come last", positions)
    share = t_s / 20
    return planned + [[2 + 1.5 * share, 2 - share, 1 + share]] + ([[1, 3, 2]] if t_s < 10 else [])


def sensed(murk, scene, positions, t_s, *words):
    murk.write("then.csv", "type,x_m,y_m,z_m\n" + "".join("node,{},{},{}\n".format(*x) for x in sensors_at(positions, t_s)))
    return murk.run("sense", scene, "--at", str(t_s), "--sensors", murk.path("then.csv"), *words)["coverage"]["in_sample"]


def places(plan):
    return [sensor["position_m"] for sensor in plan["sensors"]]


def each_step_is_sensed(murk, scene):
    """All plans by all objectives, in the light that chose them; and a step of weight 0."""
    plans = {}
    for over in ("mean", "worst", "regret"):
        plan = plans[over] = murk.run("place", scene, "--set", f"placement.over={over}", "--set",
                                      "placement.condition_weights={step-0001: 0}", "--set", "placement.hold_out=false", "-o",
                                      murk.path(over))
        for at, row in zip(STEPS, plan["conditions"]):
            near(row["in_sample"], sensed(murk, scene, places(plan), at), 1e-12, over, "at", at)
        for made in plan["regret"]["plans"]:
            for k, at in enumerate(STEPS):
                near(made["coverage"][k], sensed(murk, scene, made["positions_m"], at), 1e-12, made["made_for"], "at", at)
        check(plan["bound"]["upper"] >= plan["coverage"]["in_sample"], over, plan["bound"])
        check(plan["bound"]["proven_optimal"], over, "is not proven, so that bounds say little:", plan["bound"])
    # What a proven plan does not reach no other plan reaches.
    least = {over: min(plan["conditions"][k]["in_sample"] for k in (0, 2)) for over, plan in plans.items()}
    check(least["worst"] >= max(least.values()) - 1e-5, "the plan for the worst step is not the best there", least)
    # The row of the failed sensor counts in the first step alone.
    worst = plans["worst"]
    step = min((0, 2), key=lambda k: worst["conditions"][k]["in_sample"])
    check((worst["sensors"][-1]["covers"] > 0) == (step == 0), "covers of the failed sensor", worst["sensors"][-1])
    # The failed sensor is in no picture of later steps.
    for k, sensors in enumerate((4, 3, 3)):
        with open(murk.path("mean", f"plan-step-{k:04}.ply"), "rb") as file:
            head = file.read().split(b"end_header", 1)[0].decode()
        vertices = int(head.split("element vertex ")[1].split()[0])
        photons = plans["mean"]["conditions"][k]["photons"]
        corners = vertices - photons["surface"] - photons["volume"]
        check(corners == sensors * 7, "a sensor is a vertex and an octahedron: plan of step", k, corners, sensors)


def a_late_step_is_that_plan(murk, scene):
    """Over one step held-out light, jitter and the plan of another seed are those of plain plans at that time."""
    late = ["--set", "conditions={late: {timeline.at_s: 20}}", "--set", "placement.over=mean"]
    plan = murk.run("place", scene, *late)
    listed = ", ".join("{{type: node, position_m: [{}, {}, {}]}}".format(*x) for x in sensors_at(places(plan), 20))
    still = murk.write("still.yaml", SCENE.replace(FIXED, f"fixed: [{listed}]").replace("count: 4", "count: 3")
                       .replace("    - {sensor: 0", "    #").replace("    - {sensor: 1", "    #"))
    alone = murk.run("place", still, "--at", "20")
    for name in ("in_sample", "held_out", "held_out_standard_error"):
        near(plan["coverage"][name], alone["coverage"][name], 1e-9, "late", name)
    jitter = ["--set", "placement.jitter_m=1e-9", "--set", "placement.jitter_draws=20"]
    shaken = murk.run("place", scene, *late, *jitter)["robustness"]["jitter"]
    near(shaken["mean"], plan["coverage"]["held_out"], 1e-9, "jitter of nothing")


def other_seeds(murk, scene):
    """The first plan under another seed."""
    words = ["--set", "placement.over=mean"]
    murk.run("place", scene, *words, "--repeat", "2", "-o", murk.path("repeat"))
    first = murk.run("place", scene, *words)
    with open(murk.path("repeat", "repeat.csv"), encoding="utf-8") as file:
        rows = [line.strip().split(",") for line in file]
    seen = [sensed(murk, scene, places(first), at, "--seed", rows[2][0]) for at in STEPS]
    of_plan = float(dict(zip(rows[0], rows[2]))["plan"])
    near(of_plan, sum(seen) / 3, 1e-8, "the first plan under another seed")


def refused(murk, says, *words):
    done = subprocess.run([murk.program, "place", *words], capture_output=True, text=True, timeout=60, check=False)
    check(done.returncode == 2 and done.stderr.count("\n") == 1 and says in done.stderr, words, done.returncode, done.stderr)


def main():
    with tempfile.TemporaryDirectory() as folder:
        murk = from_outside.Murk(os.path.abspath(sys.argv[1]), folder)
        scene = murk.write("room.yaml", SCENE)
        each_step_is_sensed(murk, scene)
        a_late_step_is_that_plan(murk, scene)
        other_seeds(murk, scene)
        over = ["--set", "placement.over=mean"]
        refused(murk, "over: the plan is for all steps of the timeline, so a time", scene, *over, "--at", "5")
        refused(murk, "conditions.early: sensors.fixed.1 has failed by the scene's own time, at 15 s", scene, *over, "--at",
                "15", "--set", "conditions={early: {timeline.at_s: 0}}")
    print("steps see fixed sensors as they are" if not from_outside.failures else f"{from_outside.failures} failed")
    return from_outside.failures != 0


if __name__ == "__main__":
    sys.exit(main())
