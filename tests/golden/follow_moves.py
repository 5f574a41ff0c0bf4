#!/usr/bin/env python3
"""murk follow with moves that are few or cost something, and with plans that look ahead, from outside: each step keeps
the rule and equals murk place from the same start; the figures of plans and tables agree; a run that was stopped goes on
to the same tables; no result depends on the threads; what the rule cannot be kept with is refused. Standard library only.
usage: follow_moves.py MURK
"""

import csv
import json
import os
import shutil
import subprocess
import sys
import tempfile

MURK = os.path.abspath(sys.argv[1])
failures = 0

SCENE = """murk: 1
domain: {min_m: [0, 0, 0], max_m: [16, 8, 4]}
timeline:
  from_s: 0
  to_s: 5
  every_s: 1
  tracks:
    - {geometry: load, lights: [0], keyframes: [{t_s: 0, translate_m: [2, 4, 1.2]}, {t_s: 5, translate_m: [14, 4, 1.2]}]}
    - {sensor: 1, fails_at_s: 4}
geometry:
  - {box: {min_m: [0, 0, 0], max_m: [16, 8, 4]}}
  - {name: load, box: {min_m: [-0.6, -1, -1], max_m: [0.6, 1, 1]}, translate_m: [2, 4, 1.2]}
media: {fog: {extinction_per_m: 0.1, albedo: 0.9}}
regions: [{medium: fog}]
lights:
  - {type: point, position_m: [2, 4, 2.5], power_w: 20}
  - {type: point, position_m: [8, 1, 3.8], power_w: 2}
photons: {emit: 600}
sensors:
  types: [{name: node, range_m: 5}]
  candidates: {grid: {min_m: [1, 1, 1], max_m: [15, 7, 3], size: [8, 4, 2]}}
  count: 3
"""


def check(holds, *text):
    global failures
    if not holds:
        print("follow_moves.py:", *text)
        failures += 1


def run(*words, code=0):
    done = subprocess.run([MURK, *words], capture_output=True, text=True)
    check(done.returncode == code, words, "ends with", done.returncode, done.stderr)
    return done


def json_of(*path):
    with open(os.path.join(*path)) as file:
        return json.load(file)


def plan_of(folder):
    plan = json_of(folder, "plan.json")
    return {key: value for key, value in plan.items() if key not in ("run", "files")}


def table(*path):
    with open(os.path.join(*path), newline="") as file:
        return [{key: value for key, value in row.items() if key != "seconds"} for row in csv.DictReader(file)]


def places(*path):
    return {tuple(row[key] for key in ("type", "x_m", "y_m", "z_m")) for row in table(*path)}


def follow(scene, out, *words):
    run("follow", scene, "-o", out, *words)
    return table(out, "follow.csv")


def steps_keep_the_rule(scene, out, words, at_most, cost):
    """Each step against the rule, the tables, and murk place."""
    rows = follow(scene, out, *words)
    value = upper = 0
    for k, row in enumerate(rows):
        step, alone = os.path.join(out, f"steps/{k:04}"), out + "-alone"
        start = os.path.join(step, "start.csv")
        plan = plan_of(step)
        run("place", scene, "--at", row["t_s"], "-o", alone, "--force", *words, *(["--start", start] if k else []))
        check(plan == plan_of(alone), words, "plan of step", k)
        bound = plan["bound"]
        check(("moves" in plan) == (k > 0), "moves of step", k)
        worth = float(row["in_sample"])
        if k:
            before, after = places(start), places(step, "sensors.csv")
            moves = min(len(before - after), len(after - before))
            check(moves == plan["moves"]["count"] == int(row["moves"]) <= at_most, words, k, moves, row)
            check(abs(plan["moves"]["cost"] - moves * cost) < 1e-9, words, k, plan["moves"])
            check(abs(float(row["move_cost"]) - moves * cost) < 1e-9, words, k, row)
            worth -= moves * cost
            if "look_ahead" not in plan:
                check(abs(plan["moves"]["value"] - worth) < 1e-9, words, k, plan["moves"], worth)
            check(plan["free"]["upper"] == float(row["upper_free"]), words, k, row)
            shutil.rmtree(alone)
        if "look_ahead" not in plan:
            check(worth <= bound["upper"] + 1e-12 and bound["upper"] <= float(row["upper_free"]) + 1e-12, words, k, row)
        check(float(row["in_sample"]) <= float(row["upper_free"]) + 1e-12, words, k, row)
        value += worth
        upper += float(row["upper_free"])
    seen = json_of(out, "follow.json")["hindsight"]
    check(seen["steps"] == len(rows), seen)
    check(abs(seen["value"] - value) < 1e-9 and abs(seen["upper"] - upper) < 1e-9, seen, value, upper)
    check(seen["gap"] >= 0 and abs(seen["gap"] - (upper - value)) < 1e-9, seen)
    check(abs(seen["mean_value"] * len(rows) - value) < 1e-9, seen)
    return rows, value


def goes_on(scene, out, words):
    """A stop and other threads change nothing."""
    rows, moves = table(out, "follow.csv"), table(out, "moves.csv")
    for missing in (2, 4):
        shutil.rmtree(os.path.join(out, f"steps/{missing:04}"))
    check(follow(scene, out, *words) == rows, words, "follow.csv after a stop")
    for threads in ("1", "5"):
        other = out + "-threads"
        check(follow(scene, other, *words, "-j", threads) == rows, words, threads, "threads")
        check(table(other, "moves.csv") == moves, words, threads, "threads")
        shutil.rmtree(other)


def moves_are_few(folder, scene):
    free = follow(scene, os.path.join(folder, "free"))
    check(sum(int(row["moved"]) for row in free[1:]) > 6, "moves without a rule", free)
    for method in ("best", "spoq", "exact"):
        words = ["--set", f"placement.method={method}", "--set", "placement.moves_at_most=1"]
        rows, value = steps_keep_the_rule(scene, os.path.join(folder, method), words, 1, 0)
        check(sum(int(row["moves"]) for row in rows[1:]) >= 3, method, "moves", rows)
        if method == "best":
            goes_on(scene, os.path.join(folder, method), words)
    # Nothing may move: the plan stays, but for the sensor that fails.
    rows, none = steps_keep_the_rule(scene, os.path.join(folder, "none"), ["--set", "placement.moves_at_most=0"], 0, 0)
    check(all(row["moved"] == "0" for row in rows[1:]) and none < value, "no moves", rows)
    # A cost: fewer moves than without; each is worth it.
    words = ["--set", "placement.move_cost=0.02"]
    out = os.path.join(folder, "cost")
    rows, _ = steps_keep_the_rule(scene, out, words, 3, 0.02)
    moves = sum(int(row["moves"]) for row in rows[1:])
    check(0 < moves < sum(int(row["moved"]) for row in free[1:]), "moves at a cost", moves)
    goes_on(scene, out, words)


def plans_look_ahead(folder, scene):
    """A plan is chosen for its own step and the next ones."""
    words = ["--set", "placement.moves_at_most=1", "--set", "placement.move_cost=0.001"]
    one = follow(scene, os.path.join(folder, "one"), *words)
    check(follow(scene, os.path.join(folder, "also-one"), *words, "--set", "placement.look_ahead=1") == one, "look_ahead: 1")
    words += ["--set", "placement.look_ahead=3"]
    out = os.path.join(folder, "ahead")
    rows, _ = steps_keep_the_rule(scene, out, words, 1, 0.001)
    check([row["moved"] for row in rows] != [row["moved"] for row in one], "looking ahead changes nothing")
    for k, row in enumerate(rows):
        plan = plan_of(os.path.join(out, f"steps/{k:04}"))
        ahead = plan.get("look_ahead")
        check((ahead["steps"] if ahead else 1) == min(3, len(rows) - k), "steps of", k, ahead)
        if not ahead:
            continue
        # The value is the mean of the coverage in each step, less moves, and keeps its bound.
        seen = []
        for step in range(k, k + ahead["steps"]):
            words_at = ["--at", rows[step]["t_s"], "--sensors", os.path.join(out, f"steps/{k:04}/plan.json")]
            done = run("sense", scene, *words_at, "--set", "sensors.count=3", "--format", "json")
            seen.append(json.loads(done.stdout)["coverage"]["in_sample"])
        cost = plan["moves"]["cost"] if k else 0
        check(abs(sum(seen) / len(seen) - cost - ahead["value"]) < 1e-6, "mean of", k, seen, ahead)
        check(ahead["value"] <= plan["bound"]["upper"] + 1e-12, "bound of", k, plan["bound"])
        check(abs(seen[0] - plan["coverage"]["in_sample"]) < 1e-9, "own time of", k, seen)
    # Light and sightlines are computed once: of three steps, two are those of the step before.
    for k in range(1, 4):
        kept, traced = int(rows[k]["photons_kept"]), int(rows[k]["photons_traced"])
        check(kept + traced == 1800 and traced <= 600, "photons of step", k, rows[k])
        kept, looked = int(rows[k]["pairs_kept"]), int(rows[k]["pairs_looked"])
        check(kept >= looked, "sightlines of step", k, rows[k])
    check(rows[5]["photons_kept"] == "600", "photons of the last step", rows[5])
    goes_on(scene, out, words)


def fixed_sensors_ahead(folder):
    """At each step ahead a fixed sensor is where it is then, and is absent once it has failed."""
    scene, out, poses = (os.path.join(folder, name) for name in ("fixed.yaml", "fixed", "fixed.csv"))
    with open(scene, "w") as file:
        file.write(SCENE.replace("{sensor: 1, fails_at_s: 4}", "{sensor: 0, fails_at_s: 3}\n    - {sensor: 1, keyframes: "
                                 "[{t_s: 0, position_m: [3, 6, 2]}, {t_s: 5, position_m: [13, 6.5, 2]}]}")
                   .replace("  count: 3", "  fixed: [{type: node, position_m: [8, 4, 1]}, {type: node, position_m: [3, 6, 2]}]"
                            "\n  count: 5"))
    words = ["--set", "placement.moves_at_most=1", "--set", "placement.look_ahead=3"]
    rows = follow(scene, out, *words)
    for k in range(5):
        plan = plan_of(os.path.join(out, f"steps/{k:04}"))
        planned = [sensor["position_m"] for sensor in plan["sensors"][:-1 if k >= 3 else -2]]
        seen = []
        for step in range(k, k + plan["look_ahead"]["steps"]):
            at = planned + ([[8, 4, 1]] if step < 3 else []) + [[3 + 2 * step, 6 + 0.1 * step, 2]]
            with open(poses, "w") as file:
                file.write("type,x_m,y_m,z_m\n" + "".join("node,{},{},{}\n".format(*x) for x in at))
            done = run("sense", scene, "--at", rows[step]["t_s"], "--sensors", poses, "--format", "json")
            seen.append(json.loads(done.stdout)["coverage"]["in_sample"])
        check(abs(sum(seen) / len(seen) - plan["look_ahead"]["value"]) < 1e-6, "mean of", k, seen, plan["look_ahead"])
        check(plan["look_ahead"]["value"] <= plan["bound"]["upper"] + 1e-12, "bound of", k, plan["bound"])
    goes_on(scene, out, words)
    steps_keep_the_rule(scene, out, words, 1, 0)


def refusals(scene):
    for words, text in (
            (["placement.method=greedy"], "moves_at_most is given, which needs method: best, spoq or exact"),
            (["placement.knowledge=unknown"], "moves_at_most is given, which needs knowledge: known"),
            (["placement.over=mean"], "moves_at_most is given, which needs over: null"),
            (["sensors.budget=3"], "moves of a number of sensors"),
            (["sensors.target=0.5", "placement.move_cost=0.1"], "does not weigh")):
        sets = [word for one in words for word in ("--set", one)]
        done = run("place", scene, "--set", "placement.moves_at_most=1", *sets, code=2)
        check(text in done.stderr and done.stderr.count("\n") == 1, words, done.stderr)


def says_early(folder, scene):
    """A search without the rule on moves that the time has cut says so."""
    out = os.path.join(folder, "limit")
    run("follow", scene, "--set", "placement.moves_at_most=1", "--time-limit", "1e-6", "-o", out)
    plan = plan_of(os.path.join(out, "steps/0002"))
    check(plan["free"]["cut_by"] == "time", "free", plan["free"])
    out = os.path.join(folder, "no-limit")
    run("follow", scene, "--set", "placement.moves_at_most=1", "-o", out)
    plan = plan_of(os.path.join(out, "steps/0002"))
    check(plan["free"]["cut_by"] is None, "free", plan["free"])


with tempfile.TemporaryDirectory() as folder:
    scene = os.path.join(folder, "scene.yaml")
    with open(scene, "w") as file:
        file.write(SCENE)
    moves_are_few(folder, scene)
    plans_look_ahead(folder, scene)
    fixed_sensors_ahead(folder)
    refusals(scene)
    says_early(folder, scene)
sys.exit(failures > 0)
