#!/usr/bin/env python3
"""murk follow from outside, about the sensors of the plan before: planned sensors that drift, stay where they have
drifted to or are moved back; that drift away; that fail, with numbers that exist or not; and a limit on the time of
the search, which never makes a plan worse than the sensors that stand. Standard library only.
usage: follow_sensors.py MURK
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

# The pillar is a closed box between the candidates.
SCENE = """murk: 1
domain: {min_m: [0, 0, 0], max_m: [12, 8, 4]}
timeline: {from_s: 0, to_s: 12, every_s: 3, tracks: TRACKS}
geometry:
  - {box: {min_m: [0, 0, 0], max_m: [12, 8, 4]}}
  - {name: pillar, box: {min_m: [5.5, 3.5, 0.5], max_m: [6.5, 4.5, 3.5]}}
media: {fog: {extinction_per_m: 0.1, albedo: 0.9}}
regions: [{medium: fog}]
lights:
  - {type: point, position_m: [3, 4, 3.8], power_w: 20}
  - {type: point, position_m: [10, 2, 2.5], power_w: 5}
photons: {emit: 1500}
sensors:
  types: [{name: node, range_m: 4}, {name: eye, range_m: 8, view: {cone_deg: 100}, headings: 7}]
  fixed: [{type: node, position_m: [11, 7, 3]}]
  candidates: {grid: {min_m: [1, 1, 1], max_m: [11, 7, 3], size: [6, 4, 2]}}
  count: 4
"""
DRIFT = ("{sensor: 1, keyframes: [{t_s: 0, offset_m: [5, 0, 0]}, {t_s: 12, offset_m: [5.4, 0.2, 0]}]}, "
         "{sensor: 2, between: hold, keyframes: [{t_s: 3, offset_m: [0, 0, 0], heading_offset_deg: 0}, "
         "{t_s: 6, offset_m: [0.1, 0, -0.1], heading_offset_deg: 20}]}")


def check(holds, *text):
    global failures
    if not holds:
        print("follow_sensors.py:", *text)
        failures += 1


def run(*words, code=0):
    done = subprocess.run([MURK, *words], capture_output=True, text=True, timeout=300)
    check(done.returncode == code, words, "ends with", done.returncode, done.stderr)
    return done


def bytes_of(*path):
    with open(os.path.join(*path), "rb") as file:
        return file.read()


def plan_of(*path):
    plan = json.loads(bytes_of(*path, "plan.json"))
    for key in ("run", "files"):
        plan.pop(key)
    return plan


def table(*path):
    with open(os.path.join(*path), newline="") as file:
        return [{key: value for key, value in row.items() if key != "seconds"} for row in csv.DictReader(file)]


def scene_of(folder, tracks, name="scene.yaml"):
    path = os.path.join(folder, name)
    with open(path, "w") as file:
        file.write(SCENE.replace("TRACKS", f"[{tracks}]"))
    return path


def place(row, part=""):
    return tuple(float(row[f"{part}{axis}_m"]) for axis in "xyz")


def near(a, b):
    return all(abs(x - y) < 1e-9 for x, y in zip(a, b))


def on_grid(at):
    return all(abs(x / 2 - 0.5 - round(x / 2 - 0.5)) < 1e-9 for x in at)


def drifting_sensors(folder):
    """A sensor drifts by the difference of the offsets of two steps, from wherever it stands."""
    scene, out, alone = scene_of(folder, DRIFT), os.path.join(folder, "drift"), os.path.join(folder, "alone")
    run("follow", scene, "-o", out)
    moves = table(out, "moves.csv")
    drifts = [(int(move["step"]), move) for move in moves if move["change"] == "drifted"]
    check([(k, move["sensor"]) for k, move in drifts] ==
          [(1, "1"), (2, "1"), (2, "2"), (3, "1"), (4, "1")], "drifts", drifts)
    for k, move in drifts:
        by = tuple(b - a for a, b in zip(place(move, "from_"), place(move, "to_")))
        check(near(by, (0.1, 0.05, 0) if move["sensor"] == "1" else (0.1, 0, -0.1)), "drift of step", k, by)
    # Each sensor is where the move before left it, and moves lead to candidates.
    at = {}
    stayed = moved = 0
    for move in moves:
        check(not move["from_x_m"] or near(at[move["sensor"]], place(move, "from_")), "from", move)
        check(move["change"] == "drifted" or on_grid(place(move, "to_")), "to", move)
        at[move["sensor"]] = place(move, "to_")
    for k in range(1, 5):
        step = os.path.join(out, f"steps/{k:04}")
        start, plan = table(step, "start.csv"), table(step, "sensors.csv")
        for sensor in start:
            check((sensor["drifted"] == "1") != on_grid(place(sensor)), "drifted of step", k, sensor)
            is_there = any(place(sensor) == place(other) for other in plan)
            stayed += sensor["drifted"] == "1" and is_there
            moved += sensor["drifted"] == "1" and not is_there
        run("place", scene, "--at", str(3 * k), "--start", os.path.join(step, "start.csv"), "-o", alone, "--force")
        check(plan_of(step) == plan_of(alone), "plan of step", k)
        check(bytes_of(step, "coverage.csv") == bytes_of(alone, "coverage.csv"), "coverage of step", k)
    check(stayed > 0 and moved > 0, stayed, "drifted sensors stayed,", moved, "were moved")
    turned = [move for _, move in drifts if move["sensor"] == "2" and move["heading_deg"]]
    before = [move for move in moves if move["sensor"] == "2" and move["heading_deg"]]
    for move in turned:
        was = float(before[before.index(move) - 1]["heading_deg"])
        check(abs((float(move["heading_deg"]) - was - 20 + 180) % 360 - 180) < 1e-6, "turned", was, move)
    # A stop, and other threads.
    whole = table(out, "follow.csv")
    for missing in (1, 3):
        again = os.path.join(folder, "again")
        shutil.copytree(out, again)
        shutil.rmtree(os.path.join(again, f"steps/{missing:04}"))
        run("follow", scene, "-o", again)
        check(table(again, "follow.csv") == whole, "follow.csv after a stop at", missing)
        check(bytes_of(again, "moves.csv") == bytes_of(out, "moves.csv"), "moves.csv after a stop at", missing)
        shutil.rmtree(again)
    for threads in ("1", "5"):
        other = os.path.join(folder, "threads" + threads)
        run("follow", scene, "-o", other, "-j", threads)
        check(table(other, "follow.csv") == whole, threads, "threads")
        check(bytes_of(other, "moves.csv") == bytes_of(out, "moves.csv"), threads, "threads")
        check(plan_of(other, "steps/0004") == plan_of(out, "steps/0004"), threads, "threads")


def drifting_away(folder):
    """Out of the domain, and into the pillar: one line, and another pose takes the place of the sensor."""
    first = plan_of(folder, "drift/steps/0000")["sensors"][0]["position_m"]
    into = [b - a for a, b in zip(first, (6, 4, 2))]
    for name, offset in (("out", [20, 0, 0]), ("into", into)):
        out = os.path.join(folder, name)
        scene = scene_of(folder, f"{{sensor: 1, between: hold, keyframes: [{{t_s: 0, offset_m: [0, 0, 0]}}, "
                         f"{{t_s: 6, offset_m: {offset}}}]}}", name + ".yaml")
        done = run("follow", scene, "-o", out)
        check(done.stderr.count("\n") == 1 and "sensor 1 has drifted to" in done.stderr, name, done.stderr)
        changes = [(move["step"], move["sensor"], move["change"]) for move in table(out, "moves.csv")]
        check(changes[3:] == [("2", "1", "drifted"), ("2", "1", "moved")] or
              changes[3:] == [("2", "1", "drifted"), ("2", "1", "removed"), ("2", "4", "added")], name, changes)
        for k in range(5):
            plan = table(out, f"steps/{k:04}", "sensors.csv")
            check(len(plan) == 4 and all(on_grid(place(sensor)) for sensor in plan), name, "step", k, plan)


def failing_numbers(folder):
    """A number that no sensor has: one line, and all sensors stay, with murk place, too."""
    out, alone = os.path.join(folder, "fails"), os.path.join(folder, "alone")
    scene = scene_of(folder, "{sensor: 2, fails_at_s: 3}, {sensor: 7, fails_at_s: 6}", "fails.yaml")
    done = run("follow", scene, "-o", out)
    check(done.stderr.count("\n") == 1 and "no sensor has the number 7 when it fails, at 6 s" in done.stderr, done.stderr)
    counts = [len(table(out, f"steps/{k:04}", "sensors.csv")) for k in range(5)]
    check(counts == [4, 3, 3, 3, 3], "sensors", counts)
    failed = [(move["step"], move["sensor"]) for move in table(out, "moves.csv") if move["change"] == "failed"]
    check(failed == [("1", "2")], "failed", failed)
    run("place", scene, "--at", "9", "-o", alone, "--force")
    check(len(table(alone, "sensors.csv")) == 3, "sensors of murk place", table(alone, "sensors.csv"))


def in_force(folder):
    """Steps that begin at the plan in force. A camera that has drifted to straight down turns up from there, in start.csv
    as in moves.csv; a fixed sensor that has failed before the first step is no planned one."""
    plan = os.path.join(folder, "plan.csv")
    with open(plan, "w") as file:
        file.write("type,x_m,y_m,z_m,heading_deg,tilt_deg\neye,3,3,1,0,-20\nnode,9,5,3,,\nnode,11,7,3,,\n")
    tracks = ("{sensor: 0, fails_at_s: -1}, {sensor: 1, keyframes: [{t_s: 0, tilt_offset_deg: 0}, "
              "{t_s: 3, tilt_offset_deg: -100}, {t_s: 6, tilt_offset_deg: -70}]}")
    scene, out = scene_of(folder, tracks, "force.yaml"), os.path.join(folder, "force")
    run("follow", scene, "--start", plan, "--set", "timeline.search_from=start_plan", "-o", out)
    starts = [table(out, f"steps/{k:04}/start.csv") for k in range(5)]
    check([len(start) for start in starts] == [2] * 5, "sensors in force", starts)
    check([round(float(start[0]["tilt_deg"]), 6) for start in starts] == [-20, -90, -60, -60, -60], "tilts", starts)
    moves = table(out, "moves.csv")
    check(not any(move["change"] == "failed" for move in moves), "failed before the first step", moves)
    drifted = {move["step"]: move for move in moves if move["change"] == "drifted"}
    for k, start in enumerate(starts):
        if str(k) in drifted and place(drifted[str(k)], "to_") == place(start[0]):
            check(abs(float(drifted[str(k)]["tilt_deg"]) - float(start[0]["tilt_deg"])) < 1e-9, "tilt of step", k)


def refusals(folder):
    for tracks, text in (("{sensor: 2, keyframes: [{t_s: 0, position_m: [1, 1, 1]}]}", "others have offset_m"),
                         ("{sensor: 0, keyframes: [{t_s: 0, offset_m: [1, 1, 1]}]}", "not offset_m"),
                         ("{sensor: 2, keyframes: [{t_s: 0, offset_m: [1, 1, 1]}]}, "
                          "{sensor: 2, keyframes: [{t_s: 0, tilt_offset_deg: 3}]}", "which an earlier track sets"),
                         ("{key: photons.emit, keyframes: [{t_s: 0, offset_m: [1, 1, 1]}]}", "is no key of the keyframes")):
        done = run("follow", scene_of(folder, tracks, "bad.yaml"), code=2)
        check(text in done.stderr and done.stderr.count("\n") == 1, tracks, done.stderr)


def a_limit_of_time(folder):
    """Steps that have no time to search have a plan, no worse than what stands, with a bound; a limit that is far
    changes nothing."""
    scene = scene_of(folder, DRIFT + ", {key: media.fog.extinction_per_m, keyframes: [{t_s: 0, value: 0.05}, "
                     "{t_s: 12, value: 0.5}]}", "limit.yaml")
    short, far, whole = (os.path.join(folder, name) for name in ("short", "far", "whole"))
    run("follow", scene, "-o", short, "--time-limit", "1e-6")
    run("follow", scene, "-o", far, "--time-limit", "1e6")
    run("follow", scene, "-o", whole)
    check(bytes_of(far, "moves.csv") == bytes_of(whole, "moves.csv"), "moves.csv with a limit that is far")
    check(table(far, "follow.csv") == table(whole, "follow.csv"), "follow.csv with a limit that is far")
    for k in range(5):
        plan, free, same = (plan_of(out, f"steps/{k:04}") for out in (short, whole, far))
        check(plan["placement"]["cut_by"] == "time" and same["placement"]["cut_by"] is None, "cut_by of step", k)
        for key in ("sensors", "coverage", "bound", "placement"):
            check(free[key] == same[key], key, "of step", k, "with a limit that is far")
        coverage = plan["coverage"]["in_sample"]
        check(plan["bound"]["upper"] >= max(coverage, free["coverage"]["in_sample"]) - 1e-12, "bound of step", k)
        start = os.path.join(short, f"steps/{k:04}/start.csv")
        if k > 0:
            stands = os.path.join(folder, "stands.csv")
            with open(stands, "w") as file:
                file.write(bytes_of(start).decode() + "node,11,7,3,,,0\n")  # the fixed one
            run("sense", scene, "--at", str(3 * k), "--sensors", stands, "-o", os.path.join(folder, "sense"), "--force")
            was = json.loads(bytes_of(folder, "sense", "coverage.json"))["coverage"]["in_sample"]
            check(coverage >= was - 1e-12, "step", k, "covers", coverage, "less than what stood", was)
    check([(row["cut_by"], row["sensors"]) for row in table(short, "follow.csv")] == [("time", "4")] * 5, "follow.csv")
    # Steps that the limit has cut are done.
    done = run("follow", scene, "-o", short, "--time-limit", "1e-6")
    check("5 kept from before" in done.stdout and "ended the search of 5 steps" in done.stdout, done.stdout)
    plan = json.loads(run("place", scene, "--time-limit", "1e-6", "--target", "0.5", "--format", "json").stdout)
    check(plan["coverage"]["in_sample"] >= 0.5 and plan["placement"]["cut_by"] == "time" and
          plan["target"]["fewest_possible"] <= len(plan["sensors"]), "target", plan["target"])
    matrix = os.path.join(folder, "matrix.csv")
    with open(matrix, "w") as file:
        file.write("1,1,0\n1,0,1\n0,1,1\n")
    plan = json.loads(run("place", "--matrix", matrix, "--count", "2", "--time-limit", "1e-6", "--format", "json").stdout)
    check(plan["placement"]["cut_by"] == "time", "a matrix", plan["placement"])


with tempfile.TemporaryDirectory(prefix="murk-follow-") as top:
    drifting_sensors(top)
    drifting_away(top)
    failing_numbers(top)
    in_force(top)
    refusals(top)
    a_limit_of_time(top)
sys.exit(1 if failures else 0)
