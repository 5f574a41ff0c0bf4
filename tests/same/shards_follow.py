"""Parts of murk follow (--shard K/N), merged by murk merge, give every file of a single run (JSON: all values) but `run`,
and but for the columns that say what was taken over from the step before and how long that took: for 1 to 5 parts, in any
order, repeated, missing, damaged, with steps that fail. Parts that do not belong together, and steps that depend on each
other, are refused in one line, and nothing is written then.

    shards_follow.py MURK
"""
import csv
import hashlib
import io
import json
import os
import shutil
import subprocess
import sys
import tempfile

import run_files

MURK = os.path.abspath(sys.argv[1])
# A box that moves, a lamp that gets weaker, two sensors that fail, and one that drifts.
SCENE = """\
murk: 1
domain: {min_m: [0, 0, 0], max_m: [8, 6, 3]}
timeline:
  from_s: 0
  to_s: 60
  every_s: 10
  search_from: start_plan
  tracks:
    - {geometry: load, keyframes: [{t_s: 0, translate_m: [2, 3, 1]}, {t_s: 60, translate_m: [6, 3, 1]}]}
    - {key: lights.0.power_w, between: hold, keyframes: [{t_s: 0, value: 20}, {t_s: 30, value: 10}]}
    - {key: media.fog.albedo, between: hold, keyframes: [{t_s: 0, value: 0.9}, {t_s: 50, value: 0.8}]}
    - {sensor: 1, fails_at_s: 30}
    - {sensor: 0, fails_at_s: 50}
    - {sensor: 2, keyframes: [{t_s: 0, offset_m: [0, 0, 0]}, {t_s: 60, offset_m: [0.4, 0.3, 0]}]}
geometry:
  - {box: {min_m: [0, 0, 0], max_m: [8, 6, 3]}}
  - {name: load, box: {min_m: [-0.5, -0.5, -0.5], max_m: [0.5, 0.5, 0.5]}, translate_m: [2, 3, 1]}
media: {fog: {extinction_per_m: 0.1, albedo: 0.9}}
regions: [{medium: fog}]
lights:
  - {type: point, position_m: [6, 4, 2.8], power_w: 20}
  - {type: point, position_m: [2, 2, 2], power_w: 5}
photons: {emit: 800}
sensors:
  types: [{name: node, range_m: 4}]
  candidates: {grid: {min_m: [1, 1, 1], max_m: [7, 5, 2.5], size: [5, 4, 2]}}
  count: 4
"""
START = "type,x_m,y_m,z_m\nnode,1,1,1\nnode,7,5,2.5\nnode,4,1,2.5\nnode,1,5,1\n"
failures = 0


def check(holds, *text):
    global failures
    if not holds:
        failures += 1
        print("failed:", *text)


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def same(a, b, what):
    """Both folders were written to the path `out`, since scene.resolved.yaml of a step names the path of its start."""
    ours, theirs = run_files.files_of_steps(a), run_files.files_of_steps(b)
    differ = sorted(path for path in {**ours, **theirs} if ours.get(path) != theirs.get(path))
    check(not differ, what, "these differ:", differ)


def murk(*words, want=0):
    ran = subprocess.run([MURK, *words], capture_output=True, text=True)
    check(ran.returncode == want, " ".join(words), "exit", ran.returncode, ran.stderr)
    return ran


def single(name, scene, *more, want=0):
    """A single run, which is written to the path `out` and then moved away."""
    shutil.rmtree("out", ignore_errors=True)
    murk("follow", scene, *more, "-o", "out", "-q", want=want)
    shutil.rmtree(name, ignore_errors=True)
    shutil.copytree("out", name)
    shutil.rmtree("out")


def part(k, n, scene, *more, name="part"):
    folder = f"{name}-{k}-of-{n}"
    murk("follow", scene, *more, "--shard", f"{k}/{n}", "-o", folder, "-q", "-j", str(1 + k % 2))
    return folder


def merge(parts, *more, want=0):
    shutil.rmtree("out", ignore_errors=True)
    return murk("merge", *parts, "-o", "out", *more, want=want)


def reused(ran):
    return int(ran.stdout.split("of which ")[1].split(" ")[0])


def parts_are_the_run(name, numbers, *words):
    whole = "whole-" + name
    single(whole, "scene.yaml", *words)
    for n in numbers:
        parts = [part(k, n, "scene.yaml", *words, name=name) for k in range(1, n + 1)]
        check(not os.path.exists(os.path.join(parts[0], "follow.csv")), "a part has no tables")
        ran = merge([*reversed(parts), parts[0]])
        check("missing" not in ran.stderr and reused(ran) == 7, n, "parts:", ran.stderr, ran.stdout)
        same(whole, "out", f"{name}: {n} parts")
    for folder in ("out", whole):
        start = os.path.join(folder, "steps/0003/start.csv")
        check(os.path.exists(start) == (name != "greedy"), start)


def other_rules(words, limit):
    """Parts of steps that look ahead, of which each has the light of two steps of another part, and of steps whose search
    has no time: the plans are those that stand."""
    parts_are_the_run("ahead", (3,), *words)
    with open("whole-ahead/steps/0002/plan.json", encoding="utf-8") as file:
        check(json.load(file)["look_ahead"]["steps"] == 3, "steps ahead of step 2")
    parts = [part(k, 2, "scene.yaml", *limit, name="limit") for k in (1, 2)]
    ran = merge(parts)
    with open("out/follow.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    check([row["cut_by"] for row in rows] == ["time"] * 7 and "ended the search of 7 steps" in ran.stdout, rows, ran.stdout)
    check(rows[0]["moves"] == "0", "moves of a plan that stands", rows[0])


def missing_and_damaged():
    parts = [f"best-{k}-of-3" for k in (1, 2, 3)]
    ran = merge([parts[0], parts[2]])
    check("1 of 3 parts are missing (2): their steps are made now" in ran.stderr, ran.stderr)
    check(reused(ran) == 5, "steps without the second part", ran.stdout)
    same("whole-best", "out", "without the second part")
    # A merge that was killed, and one into the folder of a part.
    for name in ("follow.json", "follow.csv", "moves.csv", "scene.resolved.yaml"):
        os.remove(os.path.join("out", name))
    shutil.rmtree("out/steps/0006")
    murk("merge", *parts, "-o", "out", "-q")
    same("whole-best", "out", "a merge that goes on")
    shutil.rmtree("out")
    shutil.copytree(parts[0], "into")
    murk("merge", "into", *parts[1:], "-o", "into")
    check(os.path.exists("into/follow.json") and len(os.listdir("into/steps")) == 7, "a merge into a part")
    # Damaged files: the step is made again, unless another copy of the part has it.
    for name, damage in (("plan.json", "cut"), ("plan.json", "changed"), ("ledger.json", "changed"),
                         ("sensors.csv", "changed"), ("coverage.csv", "removed"), ("plan.ply", "pipe")):
        shutil.rmtree("spoilt", ignore_errors=True)
        shutil.copytree(parts[1], "spoilt")
        path = f"spoilt/steps/0003/{name}"
        text = read(path) if damage in ("cut", "changed") else ""
        os.remove(path)
        if damage == "cut":
            write(path, text[:len(text) // 2])
        elif damage == "changed":
            write(path, text.replace("1", "2", 1))
        elif damage == "pipe":
            os.mkfifo(path)
        ran = merge([parts[0], "spoilt", parts[2]])
        check("the files of step 3 are damaged or missing" in ran.stderr and reused(ran) == 6, name, damage, ran.stderr)
        same("whole-best", "out", f"{name} {damage}")
        ran = merge([parts[0], "spoilt", parts[2], parts[1]])
        check("damaged" not in ran.stderr and reused(ran) == 7, name, damage, "and given again:", ran.stderr)
    # Without -o nothing is written, and the rows are those of the run.
    before = run_files.files(parts[0])
    ran = murk("merge", *parts, "--format", "json")
    check(run_files.files(parts[0]) == before, "a merge without -o writes")
    steps, rows = json.loads(ran.stdout)["steps"], list(csv.DictReader(io.StringIO(read("whole-best/follow.csv"))))
    check([(s["coverage"], s["moved"]) for s in steps] == [(float(r["coverage"]), int(r["moved"])) for r in rows], steps)
    # Also if a step is made that follows one of a part.
    ran = murk("merge", parts[0], parts[2], "--format", "json")
    check(json.loads(ran.stdout)["steps"] is not None and
          [s["coverage"] for s in json.loads(ran.stdout)["steps"]] == [float(r["coverage"]) for r in rows], ran.stderr)


def failing_steps():
    wrong = ["--set", "timeline.tracks=[{key: media.fog.albedo, keyframes: [{t_s: 0, value: 0.5}, {t_s: 60, value: 1.3}]}]"]
    single("some", "scene.yaml", *wrong, want=1)
    parts = [part(k, 2, "scene.yaml", *wrong, name="failing") for k in (1, 2)]
    ran = merge(parts, "-q", want=1)
    check("3 of 7 steps failed" in ran.stderr, ran.stderr)
    same("some", "out", "steps that fail")


def refused(parts, *mentions, want=2):
    ran = merge(parts, want=want)
    lines = [line for line in ran.stderr.splitlines() if "warning" not in line and "note" not in line]
    check(len(lines) == 1, "one line:", ran.stderr)
    for text in mentions:
        check(text in ran.stderr, text, "in", ran.stderr)
    check(not os.path.exists("out"), "merge", parts, "writes nothing")


def others_are_refused():
    first, second = "best-1-of-2", "best-2-of-2"
    seed = part(2, 2, "scene.yaml", "--start", "start.csv", "--seed", "9", name="seed")
    refused([first, seed], 'its command has "--seed" where that of', first)
    refused([first, "best-2-of-3"], "part 2 of 3, other parts are of 2")
    scene, start = read("scene.yaml"), read("start.csv")
    write("scene.yaml", scene + "# a comment\n")
    merge([first, second], "-q")
    write("scene.yaml", scene.replace("extinction_per_m: 0.1", "extinction_per_m: 0.2"))
    refused([first], "made for another scene", "extinction_per_m: 0.1")
    write("scene.yaml", scene)
    write("start.csv", start.replace("4,1", "4,2"))
    refused([first], "made for another file that the scene names")
    write("start.csv", start)
    # A track of the part that has changed is in the text of the scene, too.
    write("scene.yaml", scene.replace("fails_at_s: 30", "fails_at_s: 20"))
    refused([first], "made for another scene")
    write("scene.yaml", scene)
    # The same part with another result, whole in itself; a step that begins elsewhere.
    shutil.copytree("best-1-of-2", "again")
    for path, text in (("steps/0001/sensors.csv", "steps"), ("steps/0000/start.csv", "start")):
        shutil.rmtree("again")
        shutil.copytree(first, "again")
        step, name = os.path.split(os.path.join("again", path))
        old = run_files.content(os.path.join(step, name))
        write(os.path.join(step, name), read(os.path.join(step, name)).replace("node,1,", "node,7,", 1))
        new = run_files.content(os.path.join(step, name))
        check(old != new, path, "has changed")
        seal(step, old, new)
        if text == "steps":
            refused([first, "again"], "part 1 of 2 again, and step 1 other than in " + first)
        else:
            refused(["again"], "start.csv", "has other sensors than those at which this step begins")
    # A part of another command, no part, and parts of parts.
    murk("trace", "scene.yaml", "--shard", "1/2", "-o", "light", "-q")
    refused([first, "light"], "its command has")
    shutil.copytree(first, "hostile")
    whole = open("hostile/follow.part", "rb").read()
    for data in (b"", b"\0" * 100, whole[:-1], whole[:200] + b"x" + whole[201:]):
        with open("hostile/follow.part", "wb") as file:
            file.write(data)
        refused(["hostile"], "follow.part")
    os.remove("hostile/follow.part")
    refused(["hostile"], "follow.part")


def seal(step, old, new):
    """Puts the checksum of the new bytes into plan.json, and the checksum of plan.json into itself."""
    path = os.path.join(step, "plan.json")
    text = read(path).replace(hashlib.sha256(old).hexdigest(), hashlib.sha256(new).hexdigest())
    head = text[:text.index('\n  "run": {')]
    was = json.loads(text)["run"]["checksum"]
    write(path, text.replace(was, hashlib.sha256(head.encode()).hexdigest()))


def what_is_not_dealt():
    ran = murk("follow", "scene.yaml", "--set", "timeline.search_from=before", "--shard", "1/2", "-o", "no", want=2)
    check(ran.stderr.count("\n") == 1 and "--shard: each step begins at the plan of the step before" in ran.stderr and
          "timeline.search_from must be start_plan" in ran.stderr, ran.stderr)
    check(not os.path.exists("no"), "a refused part leaves a folder")
    ran = murk("follow", "scene.yaml", "--shard", "1/2", want=2)
    check("needs a folder" in ran.stderr, ran.stderr)
    # More parts than steps; files of the user stay; a part that goes on.
    parts = [part(k, 9, "scene.yaml", "--set", "placement.method=greedy", name="many") for k in range(1, 10)]
    check(sum(os.path.isdir(os.path.join(name, "steps")) for name in parts) == 7, "parts with steps")
    merge(parts, "-q")
    same("whole-greedy", "out", "more parts than steps")
    os.mkdir("mine")
    write("mine/follow.part", "of mine")
    ran = murk("follow", "scene.yaml", "--shard", "1/4", "-o", "mine", want=2)
    check("follow.part" in ran.stderr and read("mine/follow.part") == "of mine", ran.stderr)
    ran = murk("follow", "scene.yaml", "--set", "placement.method=greedy", "--shard", "2/9", "-o", "many-2-of-9")
    check("part        2 of 9, in many-2-of-9" in ran.stdout and "steps       1 of 7" in ran.stdout, ran.stdout)


with tempfile.TemporaryDirectory() as top:
    os.chdir(top)
    write("scene.yaml", SCENE)
    write("start.csv", START)
    parts_are_the_run("greedy", (1, 4), "--set", "placement.method=greedy")
    parts_are_the_run("best", (2, 3, 5), "--start", "start.csv")
    rules = ("--start", "start.csv", "--set", "placement.moves_at_most=1")
    other_rules((*rules, "--set", "placement.look_ahead=3"), (*rules, "--time-limit", "1e-6"))
    missing_and_damaged()
    failing_steps()
    others_are_refused()
    what_is_not_dealt()
    os.chdir("/")
print("shards of murk follow:", f"{failures} failures" if failures else "all as it should be")
sys.exit(failures > 0)
