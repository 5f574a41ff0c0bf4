#!/usr/bin/env python3
"""murk follow from outside: each step equals what murk place makes of the scene at that time (--at) from the same
start, its light that of murk trace, for any number of threads; the tables say what the plans say; a run that was
stopped goes on to the same tables; a step whose scene is wrong is a row that says so. Standard library only.
usage: follow.py MURK [scenes]   (scenes: those of the tree alone)
"""

import csv
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time

MURK = os.path.abspath(sys.argv[1])
failures = 0

SCENE = """murk: 1
domain: {min_m: [0, 0, 0], max_m: [12, 8, 4]}
timeline:
  from_s: 0
  to_s: 12
  every_s: 3
  tracks:
    - {geometry: load, lights: [1], keyframes: [{t_s: 0, translate_m: [2, 4, 1]}, {t_s: 12, translate_m: [10, 4, 1]}]}
    - {key: media.fog.extinction_per_m, keyframes: [{t_s: 3, value: 0.05}, {t_s: 9, value: 0.3}]}
    - {key: lights.0.power_w, between: hold, keyframes: [{t_s: 0, value: 20}, {t_s: 6, value: 0}]}
    - {sensor: 1, fails_at_s: 9}
geometry:
  - {box: {min_m: [0, 0, 0], max_m: [12, 8, 4]}}
  - {name: load, box: {min_m: [-1, -1, -1], max_m: [1, 1, 1]}, translate_m: [2, 4, 1]}
media: {fog: {extinction_per_m: 0.05, albedo: 0.9}}
regions: [{medium: fog}]
lights:
  - {type: point, position_m: [6, 4, 3.8], power_w: 20}
  - {type: point, position_m: [2, 4, 2.5], power_w: 5}
photons: {emit: 1500}
sensors:
  types: [{name: node, range_m: 6}, {name: eye, range_m: 8, view: {cone_deg: 100}, headings: 7}]
  fixed: [{type: node, position_m: [11, 7, 3]}]
  candidates: {grid: {min_m: [1, 1, 1], max_m: [11, 7, 3], size: [6, 4, 2]}}
  count: 4
"""


def check(holds, *text):
    global failures
    if not holds:
        print("follow.py:", *text)
        failures += 1


def run(*words, code=0):
    done = subprocess.run([MURK, *words], capture_output=True, text=True)
    check(done.returncode == code, words, "ends with", done.returncode, done.stderr)
    return done


def bytes_of(*path):
    with open(os.path.join(*path), "rb") as file:
        return file.read()


def plan_of(folder):
    plan = json.loads(bytes_of(folder, "plan.json"))
    for key in ("run", "files"):  # files: the light is written in one of both only
        plan.pop(key)
    return plan


def table(*path):
    with open(os.path.join(*path), newline="") as file:
        return list(csv.DictReader(file))


def without_seconds(*path):
    return [{key: value for key, value in row.items() if key != "seconds"} for row in table(*path)]


def steps_are_plans(folder, scene, method):
    """Each step against murk place and murk trace."""
    out = os.path.join(folder, method)
    words = ["--set", f"placement.method={method}"]
    run("follow", scene, "-o", out, "--export", "light", *words)
    rows = table(out, "follow.csv")
    check([float(row["t_s"]) for row in rows] == [0, 3, 6, 9, 12], "times", rows)
    # The load moves from the first step to the second; then the fog changes, and with it every sightline.
    kept = [int(row["pairs_kept"]) for row in rows]
    check(kept[1] > 50000 and kept[0] == kept[2] == kept[3] == 0, "pairs_kept", kept)
    for k, row in enumerate(rows):
        step, alone, light = (os.path.join(folder, name) for name in (f"{method}/steps/{k:04}", "alone", "light"))
        start = os.path.join(step, "start.csv")
        check(os.path.exists(start) == (method != "greedy" and k > 0), "start.csv", method, k)
        begin = ["--start", start] if os.path.exists(start) else []
        run("place", scene, "--at", row["t_s"], "-o", alone, "--force", *words, *begin)
        ours, fresh = plan_of(step), plan_of(alone)
        if begin:
            check(ours["placement"]["started_from"] == len(table(start)), "started_from", k)
        check(ours == fresh, method, "plan of step", k)
        for name in ("sensors.csv", "coverage.csv", "plan.ply"):
            check(bytes_of(step, name) == bytes_of(alone, name), method, name, "of step", k)
        run("trace", scene, "--at", row["t_s"], "-o", light, "--force")
        check(bytes_of(step, "light.murk") == bytes_of(light, "light.murk"), method, "light of step", k)
        check(float(row["coverage"]) == ours["coverage"]["held_out"], "coverage of step", k)
        check(float(row["upper"]) == ours["bound"]["upper"], "bound of step", k)
        traced = json.loads(bytes_of(alone, "ledger.json"))["photons_emitted"]
        check(int(row["photons_traced"]) + int(row["photons_kept"]) == traced, "photons of step", k)
        shutil.rmtree(alone), shutil.rmtree(light)
    return out


def moves_are_differences(out):
    """moves.csv, applied to the plan of a step, gives the plan of the next."""
    rows, moves = table(out, "follow.csv"), table(out, "moves.csv")
    sensors = {}
    for k, row in enumerate(rows):
        for move in (move for move in moves if int(move["step"]) == k):
            to = tuple(float(move[f"to_{axis}_m"]) for axis in "xyz") if move["to_x_m"] else None
            was = tuple(float(move[f"from_{axis}_m"]) for axis in "xyz") if move["from_x_m"] else None
            check((sensors.get(move["sensor"]) or (None, None))[0] == was, "sensor", move["sensor"], "was at", was)
            check((to is None) == (move["change"] in ("removed", "failed")), "change", move)
            sensors.pop(move["sensor"], None)
            if to:
                sensors[move["sensor"]] = (to, move["heading_deg"])
        plan = sorted((tuple(float(sensor[f"{axis}_m"]) for axis in "xyz"), sensor["heading_deg"])
                      for sensor in table(out, f"steps/{k:04}", "sensors.csv"))
        planned = [sensor for sensor in plan if sensor[0] != (11, 7, 3)]  # without the fixed one
        close = len(planned) == len(sensors) and all(
            a[0] == b[0] and (a[1] == b[1] or abs(float(a[1]) - float(b[1])) < 1e-9)
            for a, b in zip(sorted(sensors.values()), planned))
        check(close, "sensors of step", k, sensors, planned)
        check(int(row["moved"]) == sum(move["step"] == str(k) and move["change"] in ("added", "moved") for move in moves),
              "moved of step", k, row["moved"])
        count = 4 if float(row["t_s"]) < 9 else 3
        check(len(plan) == count, "sensors at step", k, "are", len(plan))
    failed = [move for move in moves if move["change"] == "failed"]
    check(len(failed) == 1 and failed[0]["sensor"] == "1" and failed[0]["step"] == "3", "failed", failed)


def goes_on(folder, scene, whole):
    """Steps that are done are kept; what is missing, cut or of another scene is made."""
    words = ["--set", "placement.method=best", "--export", "light"]
    out = os.path.join(folder, "again")
    shutil.copytree(whole, out)
    stamp = os.stat(os.path.join(out, "steps/0001/plan.json")).st_mtime_ns
    for name in ("follow.csv", "moves.csv", "follow.json", "scene.resolved.yaml"):
        os.remove(os.path.join(out, name))
    shutil.rmtree(os.path.join(out, "steps/0003"))
    os.remove(os.path.join(out, "steps/0004/light.murk"))
    run("follow", scene, "-o", out, *words)
    check(os.stat(os.path.join(out, "steps/0001/plan.json")).st_mtime_ns == stamp, "step 1 was made again")
    check(without_seconds(out, "follow.csv") == without_seconds(whole, "follow.csv"), "follow.csv after a stop")
    check(bytes_of(out, "moves.csv") == bytes_of(whole, "moves.csv"), "moves.csv after a stop")
    check(bytes_of(out, "steps/0003/light.murk") == bytes_of(whole, "steps/0003/light.murk"), "light after a stop")
    check(os.path.exists(os.path.join(out, "steps/0004/light.murk")), "the export that was missing")
    killed = os.path.join(folder, "killed")
    running = subprocess.Popen([MURK, "follow", scene, "-o", killed, *words], stdout=subprocess.DEVNULL)
    while running.poll() is None and not os.path.exists(os.path.join(killed, "steps/0001/plan.json")):
        time.sleep(0.005)
    running.kill()
    running.wait()
    run("follow", scene, "-o", killed, *words)
    check(without_seconds(killed, "follow.csv") == without_seconds(whole, "follow.csv"), "follow.csv after kill -9")
    check(bytes_of(killed, "moves.csv") == bytes_of(whole, "moves.csv"), "moves.csv after kill -9")
    for threads in ("5",):
        other = os.path.join(folder, "threads" + threads)
        run("follow", scene, "-o", other, "-j", threads, *words)
        check(without_seconds(other, "follow.csv") == without_seconds(whole, "follow.csv"), threads, "threads")
        check(bytes_of(other, "moves.csv") == bytes_of(whole, "moves.csv"), threads, "threads")
    # A step with a damaged file is made again, over which --force decides; one with a changed figure, too.
    with open(os.path.join(out, "steps/0001/coverage.csv"), "w"):
        pass
    plan = os.path.join(out, "steps/0002/plan.json")
    with open(plan) as file:
        text = file.read()
    with open(plan, "w") as file:
        file.write(text.replace('"held_out": ', '"held_out": 0.', 1))
    done = run("follow", scene, "-o", out, *words, code=2)
    check("coverage.csv: not written by murk, or edited since" in done.stderr, done.stderr)
    done = run("follow", scene, "-o", out, "--force", *words)
    check("of which 3 kept from before" in done.stdout, done.stdout)
    check(without_seconds(out, "follow.csv") == without_seconds(whole, "follow.csv"), "follow.csv after damage")
    run("follow", scene, "-o", out, *words, "--seed", "2")
    check(without_seconds(out, "follow.csv") != without_seconds(whole, "follow.csv"), "another seed, the same table")


def what_stays(folder):
    """A lamp goes out and a box moves near the middle of the room, under a beam in a side of the cells of paths, while
    other photons stay: columns, ledgers and a run that goes on after a stop."""
    scene = os.path.join(folder, "stays.yaml")
    with open(scene, "w") as file:
        file.write("""murk: 1
domain: {min_m: [0, 0, 0], max_m: [16, 16, 16]}
timeline:
  times_s: [0, 1, 2, 3, 4, 5]
  tracks:
    - {geometry: load, keyframes: [{t_s: 0, translate_m: [3, 3, 5.5]}, {t_s: 3, translate_m: [3.6, 3.3, 5.5]},
                                   {t_s: 5, translate_m: [8.3, 8.4, 5.5]}]}
    - {key: lights.1.power_w, between: hold, keyframes: [{t_s: 0, value: 5}, {t_s: 1, value: 0}, {t_s: 4, value: 5}]}
geometry:
  - {rect: {corner_m: [0.1, 0.1, 0.2], edge1_m: [15.8, 0, 0], edge2_m: [0, 15.8, 0]}}
  - {name: load, box: {min_m: [-1, -1, -0.2], max_m: [1, 1, 0.2]}, translate_m: [3, 3, 5.5]}
lights:
  - {type: beam, origin_m: [8, 8, 15], direction: [0, 0, -1], radius_m: 0, divergence_deg: 0, power_w: 20}
  - {type: point, position_m: [12, 4, 12], power_w: 5}
photons: {emit: 2000}
sensors:
  types: [{name: node, range_m: 20}]
  candidates: {grid: {min_m: [1, 1, 1], max_m: [15, 15, 15], size: [4, 4, 3]}}
  count: 2
placement: {weights: {surface: 1, volume: 1}, method: greedy}
""")
    whole = os.path.join(folder, "stays")
    run("follow", scene, "-o", whole)
    rows = table(whole, "follow.csv")
    for k, row in enumerate(rows):
        step, light = os.path.join(whole, f"steps/{k:04}"), os.path.join(folder, "light")
        run("trace", scene, "--at", row["t_s"], "-o", light, "--force")
        ours, fresh = (json.loads(bytes_of(of, "ledger.json")) for of in (step, light))
        for key in ("photons_emitted", "absorbed_by_material_w", "escaped_w", "collisions"):
            check(ours[key] == fresh[key], "ledger of step", k, key, ours[key], fresh[key])
        check(int(row["photons_traced"]) + int(row["photons_kept"]) == ours["photons_emitted"], "photons of step", k, row)
    check(sum(int(row["photons_kept"]) for row in rows) > 2000, "photons_kept", rows)
    for memory in ((), ("--set", "placement.memory_mb=0.02"), ("--set", "placement.knowledge=unknown")):
        out = os.path.join(folder, "stays-again")
        run("follow", scene, "-o", out, *memory)
        rows = without_seconds(out, "follow.csv")
        for missing in (2, 4):
            shutil.rmtree(os.path.join(out, f"steps/{missing:04}"))
        run("follow", scene, "-o", out, *memory)
        check(without_seconds(out, "follow.csv") == rows, "follow.csv after a stop with", memory)
        shutil.rmtree(out)


def real_scenes(folder):
    """The scenes of the tree with a timeline: steps equal the plans of their times."""
    root = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../scenes")
    for name, words in (("crossing", ("--emit", "3000", "--set", "timeline.every_s=5400")),
                        ("tide", ("--emit", "3000", "--set", "timeline.every_s=10800")),
                        ("crane-hall", ("--emit", "2000", "--set", "timeline.every_s=20")),
                        ("rising-smoke", ("--emit", "2000", "--set", "timeline.every_s=5"))):
        scene, out, alone = os.path.join(root, name + ".yaml"), os.path.join(folder, name), os.path.join(folder, "one")
        run("follow", scene, "-o", out, *words)
        rows = table(out, "follow.csv")
        check(len(rows) == 3 and all(row["failed"] == "" for row in rows), name, rows)
        step = os.path.join(out, "steps/0002")
        run("place", scene, "--at", rows[2]["t_s"], "--start", os.path.join(step, "start.csv"), "-o", alone, "--force",
            *words)
        check(plan_of(step) == plan_of(alone), name, "plan of step 2")
        check(bytes_of(step, "coverage.csv") == bytes_of(alone, "coverage.csv"), name, "coverage of step 2")


def wrong_steps_say_so(folder, scene):
    """A step whose scene is wrong at its time."""
    out = os.path.join(folder, "wrong")
    track = ("timeline.tracks=[{key: media.fog.albedo, keyframes: [{t_s: 0, value: 0.5}, {t_s: 12, value: 1.7}]}]")
    done = run("follow", scene, "-o", out, "--set", track, "--set", "placement.method=greedy", "--report", code=1)
    with open(os.path.join(out, "report.html"), encoding="utf-8") as file:
        check("1.1, must be 0..1" in file.read(), "the page tells of wrong steps")
    rows = table(out, "follow.csv")
    check([bool(row["failed"]) for row in rows] == [False, False, True, True, True], "wrong steps", rows)
    check("albedo" in rows[2]["failed"] and "1.1" in rows[2]["failed"], rows[2]["failed"])
    check(rows[2]["coverage"] == "" and rows[2]["upper"] == "", "a plan of a wrong step", rows[2])
    check("3 of 5 steps failed" in done.stderr, done.stderr)
    refused = [(["--set", "timeline.tracks=[{geometry: lode, keyframes: [{t_s: 0, translate_m: [0, 0, 0]}]}]"],
                "geometry: lode is no name"),
               (["--set", "timeline.times_s=[3, 2]"], "must rise"),
               (["--set", "timeline.times_s=[3, 3]"], "must rise"),
               (["--set", "timeline.tracks=[{key: lights, keyframes: [{t_s: 0, value: [{type: point, position_m: [6, 4, 3], "
                 "power_w: 1}]}, {t_s: 9, value: []}]}]"], "must have as many at all times"),
               (["--set", "timeline.tracks=[{medium: fog, frames: none.##.vdb, every_s: 1}]"], "no file matches none.##.vdb"),
               (["--set", "placement.over=mean", "--set", "conditions={a: {}}"], "does not follow a timeline"),
               (["--set", "placement.knowledge=explore", "--set", "placement.start_m=[1, 1, 1]"], "knowledge: explore"),
               (["--set", "timeline.tracks=[{key: sensors.types, keyframes: [{t_s: 0, value: 1}]}]"], "at all times"),
               (["--export", "smoke"], "is not an export")]
    for words, text in refused:
        done = run("follow", scene, *words, code=2)
        check(text in done.stderr and done.stderr.count("\n") == 1, words, done.stderr)
    with open(os.path.join(folder, "still.yaml"), "w") as file:
        file.write(SCENE[:SCENE.index("timeline")] + SCENE[SCENE.index("geometry:\n"):])
    done = run("follow", os.path.join(folder, "still.yaml"), code=2)
    check("has no timeline" in done.stderr, done.stderr)


def check_foresees_wrong_steps(scene):
    """murk check names key, time, value and limit of values that a later step refuses, in one line a key."""
    wrong = (("{key: media.fog.albedo, keyframes: [{t_s: 0, value: 0.5}, {t_s: 6, value: 1.1}, {t_s: 9, value: 0.5}]}",
              "is wrong at 6 s: media.fog.albedo: 1.1, must be 0..1"),
             ("{key: media.fog.extinction_per_m, keyframes: [{t_s: 6, value: 1}, {t_s: 7, value: -2}]}",
              "is wrong at 9 s: media.fog.extinction_per_m: -2, must be 0..1e9 1/m"),
             ("{key: lights.0.position_m, keyframes: [{t_s: 0, value: [6, 4, 3]}, {t_s: 12, value: [6, 4, 5]}]}",
              "is wrong at 9 s: lights.0: the lamp at [6, 4, 4.5] m is outside the domain [0, 0, 0] .. [12, 8, 4] m"),
             ("{sensor: 0, keyframes: [{t_s: 0, position_m: [11, 7, 3]}, {t_s: 12, position_m: [15, 7, 3]}]}",
              "is wrong at 6 s: sensors.fixed.0: position_m: [13, 7, 3] m lies outside the domain"),
             ("{geometry: load, lights: [1], keyframes: [{t_s: 0, translate_m: [2, 4, 1]}, {t_s: 3, translate_m: [2, 4, 2]}, "
              "{t_s: 4, translate_m: [2, 40, 1]}]}",
              "is wrong at 6 s: lights.1: the lamp at [2, 40, 2.5] m is outside the domain"))
    for track, text in wrong:
        words = ["--set", f"timeline.tracks=[{track}]"]
        said = run("check", scene, *words).stderr
        check(said.count("is wrong at") == 1 and f"{scene}:3:1: timeline: {text}" in " ".join(said.split()), track, said)
        t_s = text.split()[3]
        check(text.split(" s: ")[1] in run("place", scene, *words, "--at", t_s, code=2).stderr, track, "at", t_s)
    # Between two steps, and before the first, no step has the value; two keys are two lines.
    for track, lines in (("{key: media.fog.albedo, keyframes: [{t_s: 3, value: 1}, {t_s: 4, value: 2}, {t_s: 5, value: 1}]}", 0),
                         ("{key: media.fog.albedo, keyframes: [{t_s: -3, value: 2}, {t_s: 0, value: 1}]}", 0),
                         ("{key: media.fog.albedo, keyframes: [{t_s: 3, value: 1}, {t_s: 6, value: 2}, {t_s: 9, value: 1}]}, "
                          "{key: lights.0.power_w, keyframes: [{t_s: 6, value: 1}, {t_s: 9, value: -1}]}", 2)):
        said = run("check", scene, "--set", f"timeline.tracks=[{track}]").stderr
        check(said.count("is wrong at") == lines, track, said)
    said = run("check", scene).stderr
    check("is wrong at" not in said, "a good scene", said)


def keys_in_vain(folder, scene):
    """nodes act at the first step, unless that begins at a plan, too; a rule on moves acts at all others."""
    out, plan = os.path.join(folder, "vain"), os.path.join(folder, "vain-plan")
    words = ["--set", "timeline.times_s=[0, 3]", "--set", "placement.nodes=7", "--set", "placement.moves_at_most=1"]
    said = run("follow", scene, "-o", out, *words).stderr
    check("no effect" not in said, "keys that have an effect", said)
    run("place", scene, "-o", plan)
    start = ["--start", os.path.join(plan, "plan.json")]
    for command in (["follow", scene, "-o", out], ["place", scene, "--at", "3", "-o", out + "3"]):
        said = run(*command, *words, *start, "--force").stderr
        check(said.count("no effect") == 1 and "placement.nodes=7: has no effect with method: best beside start_plan" in said,
              "nodes beside a start plan", command, said)


def frames_that_do_not_fit(folder, scene):
    """A frame that is missing, one of other voxels, which stands alone but does not mix with others, and one that is no
    grid: a row that says so, and the steps after it go on."""
    casts, out = os.path.join(folder, "cast.csv"), os.path.join(folder, "frames")
    with open(casts, "w") as file:
        file.write("height_m,extinction_per_m\n0,0.4\n4,0.1\n")
    for number, voxel in (("01", "1"), ("02", "0.25"), ("04", "1")):
        run("media", "--profile", casts, "-o", os.path.join(folder, f"cast.{number}.vdb"), "--voxel", voxel)
    words = ["--set", f"media.fog={{vdb: {folder}/cast.##.vdb, extinction_per_m: 1, albedo: 0.9}}", "--set",
             "placement.method=greedy"]
    track = "timeline.tracks=[{medium: fog, every_s: EVERY, between: BETWEEN}]"
    text = {"missing": "frame 3 of ", "voxels": "cast.02.vdb: grid density has voxels", "after": "is not there; there are 1..2, 4"}
    for between, every, want in (("nearest", "3", ("", "", "missing", "", "after")),
                                 ("linear", "6", ("", "voxels", "", "missing", "missing"))):
        run("follow", scene, "-o", out, *words, "--set", track.replace("EVERY", every).replace("BETWEEN", between), code=1)
        for row, why in zip(table(out, "follow.csv"), want):
            check(text[why] in row["failed"] if why else row["failed"] == "" and row["coverage"], between, why, row)
        shutil.rmtree(out)
    with open(os.path.join(folder, "cast.02.vdb"), "w") as file:
        file.write("no grid")
    run("follow", scene, "-o", out, *words, "--set", track.replace("EVERY", "3").replace("BETWEEN", "hold"), code=1)
    why = [row["failed"] for row in table(out, "follow.csv")]
    check("cast.02.vdb: is not an OpenVDB file" in why[1] and why[0] == why[3] == "", "no grid", why)


def things_that_swallow_others(folder, scene):
    """A box that moves over the only lamp leaves no light that a candidate could see; over a fixed sensor, a sensor that
    sees nothing; over planned sensors, sensors that move."""
    out = os.path.join(folder, "swallowed")
    track = ("timeline.tracks=[{geometry: load, keyframes: [{t_s: 0, translate_m: [2, 4, 1]}, {t_s: 12, translate_m: [X, 4, 1]}]}]")
    words = ["--set", "placement.method=best", "--set", "lights=[{type: point, position_m: [8, 4, 1], power_w: 5}]"]
    run("follow", scene, "-o", out, "--set", track.replace("X", "8"), *words, code=1)
    rows = table(out, "follow.csv")
    check([bool(row["failed"]) for row in rows] == [False, False, False, False, True], "the lamp", rows)
    check("out of reach of any light" in rows[4]["failed"], "the lamp", rows[4]["failed"])
    shutil.rmtree(out)
    words = ["--set", track.replace("X", "11"), "--set", "sensors.fixed.0.position_m=[10.5, 4, 1]"]
    done = run("follow", scene, "-o", out, "--set", "sensors.count=5", "--set", "placement.method=best", *words)
    warning = "sensors.fixed.0: a fixed sensor stands at [10.5, 4, 1] m, from where no open way to any light was found"
    check(warning in done.stderr, done.stderr)
    for t, is_warned in (("0", False), ("12", True)):
        done = run("check", scene, "--at", t, *words)
        check((warning in done.stderr) == is_warned, "check --at", t, done.stderr)
    covers = [next(sensor["covers"] for sensor in plan_of(os.path.join(out, f"steps/{k:04}"))["sensors"]
                   if sensor["position_m"] == [10.5, 4, 1]) for k in range(5)]
    check(covers[0] > 0 and covers[4] == 0, "a fixed sensor in the box", covers)
    for k in range(5):  # the box is 2 m wide, its middle at 2 + 9/4 k
        inside = [sensor for sensor in table(out, f"steps/{k:04}", "sensors.csv")
                  if abs(float(sensor["x_m"]) - 2 - 2.25 * k) < 1 and abs(float(sensor["y_m"]) - 4) < 1
                  and abs(float(sensor["z_m"]) - 1) < 1 and sensor["x_m"] != "10.5"]
        check(inside == [], "sensors in the box at step", k, inside)


def shorter_timelines(folder, scene, whole):
    """Steps beyond a shorter timeline stay in the folder, no table has them, and the longer timeline takes them again."""
    words, out = ["--set", "placement.method=best", "--export", "light"], os.path.join(folder, "shorter")
    shutil.copytree(whole, out)
    stamp = os.stat(os.path.join(out, "steps/0004/plan.json")).st_mtime_ns
    done = run("follow", scene, "-o", out, "--set", "timeline.to_s=6", *words)
    check("steps/0003/plan.json: is of an earlier run, as are later steps: this timeline has 3" in done.stderr, done.stderr)
    check(len(table(out, "follow.csv")) == 3 and json.loads(bytes_of(out, "follow.json"))["steps_done"] == 3, "shorter tables")
    run("follow", scene, "-o", out, *words)
    check(os.stat(os.path.join(out, "steps/0004/plan.json")).st_mtime_ns == stamp, "step 4 was made again")
    check(without_seconds(out, "follow.csv") == without_seconds(whole, "follow.csv"), "follow.csv after a shorter one")


def dark_steps_keep_the_sensors(folder, scene):
    """A step without light has no plan of its own; the next one begins at the sensors before it."""
    out = os.path.join(folder, "dark")
    lamps = ", ".join(f"{{key: lights.{i}.power_w, between: hold, keyframes: [{{t_s: 0, value: 9}}, {{t_s: 3, value: 0}}, "
                      "{t_s: 6, value: 9}]}" for i in range(2))
    run("follow", scene, "-o", out, "--set", f"timeline.tracks=[{lamps}]", "--set", "placement.method=best")
    rows, moves = table(out, "follow.csv"), table(out, "moves.csv")
    check(rows[1]["coverage"] == "" and not rows[1]["failed"] and rows[1]["photons_traced"] == "0", "a dark step", rows[1])
    check([row["moved"] for row in rows] == ["3", "0", "0", "0", "0"], "moved in the dark", rows)
    check(len(moves) == 3, "moves in the dark", moves)


def a_start_of_ones_own(folder, scene, whole):
    """placement.start_plan is where the first step begins."""
    start, out = os.path.join(folder, "mine.csv"), os.path.join(folder, "own")
    shutil.copy(os.path.join(whole, "steps/0004/sensors.csv"), start)
    run("follow", scene, "-o", out, "--set", f"placement.start_plan={start}", "--set", "timeline.to_s=3")
    check("started_from" in plan_of(os.path.join(out, "steps/0000"))["placement"], "a start of one's own")
    check(not os.path.exists(os.path.join(out, "steps/0000/start.csv")), "start.csv of step 0")
    done = run("follow", scene, "-o", out, "--start", os.path.join(folder, "none.csv"), code=2)
    check("none.csv: cannot read" in done.stderr, done.stderr)
    # number 0 is that of the fixed sensor
    done = run("follow", scene, "-o", out, "--set", "timeline={times_s: [0, 1], tracks: [{sensor: 1, fails_at_s: 0}]}")
    check("no sensor has the number 1 when it fails, at 0 s" in done.stderr, done.stderr)


def names_of_any_kind(folder, scene):
    """Folders and files whose names are numbers, lists or comments in YAML, or begin with a blank."""
    words = ["--set", "timeline.times_s=[0, 6]", "--set", "placement.method=best", "--emit", "300"]
    here = os.getcwd()
    os.chdir(folder)
    run("follow", scene, "-o", "plain", *words)
    for name in ("run #1", "[x]", "a: b", " lead", '"q', "*z", "12", "null"):
        run("follow", scene, "-o", name, *words)
        check(without_seconds(name, "follow.csv") == without_seconds("plain", "follow.csv"), "follow.csv in", name)
        shutil.copy("plain/steps/0000/sensors.csv", name + ".csv")
        run("place", scene, "--emit", "300", "--start", name + ".csv")
    os.chdir(here)


def prints_without_a_folder(scene, whole):
    done = run("follow", scene, "--set", "placement.method=best", "--format", "json")
    steps = json.loads(done.stdout)["steps"]
    rows = table(whole, "follow.csv")
    check([step["coverage"] for step in steps] == [float(row["coverage"]) for row in rows], "without a folder")


def viewers(folder, scene):
    out = os.path.join(folder, "views")
    run("follow", scene, "-o", out, "--set", "placement.method=greedy", "--set", "timeline.times_s=[0, 6]", "--export",
        "surfaces")
    text = bytes_of(out, "follow.pvd").decode()
    for k, t in enumerate(("0", "6")):
        check(f'timestep="{t}" part="0" file="steps/000{k}/surfaces.vtp"' in text, "follow.pvd", text)
        check(os.path.exists(os.path.join(out, f"steps/000{k}/surfaces.vtp")), "surfaces of step", k)


with tempfile.TemporaryDirectory(prefix="murk-follow-") as top:
    path = os.path.join(top, "room.yaml")
    with open(path, "w") as file:
        file.write(SCENE)
    if sys.argv[2:] == ["scenes"]:
        real_scenes(top)
        sys.exit(1 if failures else 0)
    steps_are_plans(top, path, "greedy")
    made = steps_are_plans(top, path, "best")
    moves_are_differences(made)
    goes_on(top, path, made)
    wrong_steps_say_so(top, path)
    check_foresees_wrong_steps(path)
    keys_in_vain(top, path)
    frames_that_do_not_fit(top, path)
    things_that_swallow_others(top, path)
    shorter_timelines(top, path, made)
    dark_steps_keep_the_sensors(top, path)
    a_start_of_ones_own(top, path, made)
    names_of_any_kind(top, path)
    prints_without_a_folder(path, made)
    viewers(top, path)
    what_stays(top)
sys.exit(1 if failures else 0)
