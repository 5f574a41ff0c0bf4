#!/usr/bin/env python3
"""Result folders that went wrong in one place: every JSON and CSV of folders of
each kind, cut short, with a value of another kind, a number beyond measure, a
part that is missing or there twice, bytes that are no text. The report gives a
page or one line, never a crash, and in bounded time and memory. Standard
library only; what is changed is a function of the seed.
usage: report_fuzz.py MURK [SANITIZE] [nightly] [SEED]
"""

import json
import os
import random
import resource
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import browser  # noqa: E402
import pages  # noqa: E402

MEMORY = 1 << 30
TIMES, TIMES_NIGHTLY = 4, 80  # of each file; others than JSON and CSV a quarter
failures = 0

SCENE = """\
murk: 1
bands_nm: [450, 550]
domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}
geometry: [{box: {min_m: [0.1, 0.1, 0.1], max_m: [3.9, 3.9, 2.9]}}]
media: {fog: {extinction_per_m: 0.3, albedo: 0.9, phase: {hg: 0.8}}}
regions: [{medium: fog}]
lights: [{type: point, position_m: [2, 2, 2.5], power_w: 10}]
photons: {emit: 300}
tallies:
  - {name: up, type: plane, point_m: [0, 0, 1], normal: [0, 0, 1], bins: [3, 2]}
  - {name: grid, type: grid, min_m: [0, 0, 0], max_m: [4, 4, 3], size: [3, 3, 3]}
sensors:
  types: [{name: node, range_m: 2.2}]
  candidates: {grid: {min_m: [0.5, 0.5, 0.5], max_m: [3.5, 3.5, 2.5], size: [3, 3, 2]}}
  count: 2
placement: {jitter_m: 0.1, restarts: 2}
conditions: {clear: {}, fog: {media.fog.extinction_per_m: 1}}
"""
DATA = """\
kind,x_m,y_m,z_m,radius_m,unit,value,standard_error,use
fluence,0.8,0.8,2.5,0.3,W/m2,0.5,0.05,fit
fluence,3,1,2.5,0.3,W/m2,0.4,0.04,fit
fluence,1,3,1,0.3,W/m2,0.3,0.03,hold_out
"""
VALUES = (None, True, "", "x", "1e999", "nan", "<script>", "\u00e4\ud7ff", -1, 0, 1e308, -1e308,
          5e-324, 1e15, 123456789012345678901234567890, [], {}, [[]], [None], {"a": 1},
          [1] * 300, {"total": "x", "bands": [None, {}]}, "y" * 5000)


def check(holds, *what):
    global failures
    if not holds:
        failures += 1
        print("not so:", *what)


def places(value, path=()):
    """Every place in a JSON value."""
    yield path
    items = value.items() if isinstance(value, dict) else \
        enumerate(value) if isinstance(value, list) else ()
    for key, inner in items:
        yield from places(inner, path + (key,))


def change_json(text, dice):
    value = json.loads(text)
    path = dice.choice([p for p in places(value) if p and p[0] != "murk"])
    at = value
    for key in path[:-1]:
        at = at[key]
    how = dice.randrange(5)
    if how == 0 and isinstance(at, dict):
        del at[path[-1]]
    elif how == 1 and isinstance(at, list):
        at[path[-1]:path[-1]] = [at[path[-1]]] * dice.choice((1, 70))
    elif how == 2 and isinstance(at, list):
        del at[path[-1]]
    else:
        at[path[-1]] = dice.choice(VALUES)
    return json.dumps(value, indent=1).encode()


def change_csv(text, dice):
    lines = [line.split(",") for line in text.splitlines()]
    row = dice.randrange(len(lines))
    how = dice.randrange(4)
    if how == 0:
        del lines[row]
    elif how == 1:
        lines.append(lines[row])
    else:
        column = dice.randrange(len(lines[row]))
        lines[row][column] = str(dice.choice(VALUES[:15])).replace(",", ";")
    return "\n".join(",".join(line) for line in lines).encode() + b"\n"


def change_bytes(data, dice):
    how = dice.randrange(3)
    at = dice.randrange(len(data))
    if how == 0:
        return data[:at]
    if how == 1:
        return data[:at] + bytes([dice.randrange(256)]) + data[at + 1:]
    return data[:at] + data[at:at + 50] * 3 + data[at + 50:]


def change(name, data, dice):
    if dice.random() < 0.3 or not name.endswith((".json", ".csv")):
        return change_bytes(data, dice)
    return (change_json if name.endswith(".json") else change_csv)(data.decode(), dice)


def make_folders(murk, folder):
    """One folder of each kind of result; their names."""
    def write(name, text):
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(text)

    write("scene.yaml", SCENE)
    write("data.csv", DATA)
    write("study.yaml", "murk_study: 1\nbase: scene.yaml\naxes:\n  lights.0.power_w: [1, 2]\n"
          "  media.fog.extinction_per_m: [0.1, 3]\noutputs: [density, coverage_best, "
          "coverage_one_mean]\n")
    write("cover.csv", "1,0,1\n0,1,1\n1,1,0\n")
    explore = ["--set", "placement.knowledge=explore", "--set", "placement.start_m=[0.5, 0.5, 0.5]"]
    for arguments in (
            ["place", "scene.yaml", "--repeat", "2", "-o", "place"],
            ["place", "scene.yaml", "--set", "placement.over=mean", "-o", "over"],
            ["place", "scene.yaml", *explore, "-o", "explore"],
            ["place", "--matrix", "cover.csv", "--count", "2", "-o", "matrix"],
            ["trace", "scene.yaml", "-o", "trace"],
            ["study", "study.yaml", "-o", "study"],
            ["follow", "scene.yaml", "--set", "timeline={times_s: [0, 1, 2], tracks: [{key: lights.0.power_w, keyframes: "
             "[{t_s: 0, value: 1}, {t_s: 2, value: 3}]}]}", "-o", "follow"],
            ["fit", "scene.yaml", "--data", "data.csv", "--traces", "1", "--free",
             "lights.0.power_w,media.fog.albedo", "-o", "fit"]):
        done = subprocess.run([murk, *arguments, "--quiet"], cwd=folder, text=True,
                              capture_output=True, check=False)
        check(done.returncode == 0, arguments, done.stderr)
    shutil.rmtree(os.path.join(folder, "study", "rows"), ignore_errors=True)
    return "place", "over", "explore", "matrix", "trace", "study", "follow", "fit"


def files_of(folder):
    """Files of a folder, and those of one step that a page reads."""
    step = os.path.join("steps", "0001")
    there = [name for name in os.listdir(folder) if os.path.isfile(os.path.join(folder, name))]
    if os.path.isdir(os.path.join(folder, step)):
        there += [os.path.join(step, name) for name in ("plan.json", "plan.ply", "scene.resolved.yaml")]
    return sorted(there)


def main(murk, is_sanitized, seed, times):
    dice = random.Random(seed)

    def limit():
        if not is_sanitized:
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))

    with tempfile.TemporaryDirectory() as folder:
        page = os.path.join(folder, "page.html")
        counts = {0: 0, 2: 0}
        for kind in make_folders(murk, folder):
            for name in files_of(os.path.join(folder, kind)):
                path = os.path.join(folder, kind, name)
                if name == "light.murk" or name.startswith("light-"):
                    continue
                with open(path, "rb") as file:
                    data = file.read()
                for turn in range(times if name.endswith((".json", ".csv")) else (times + 3) // 4):
                    with open(path, "wb") as file:
                        file.write(change(name, data, dice))
                    done = subprocess.run([murk, "report", kind, "-o", page, "--quiet"],
                                          cwd=folder, capture_output=True, check=False,
                                          timeout=120, preexec_fn=limit)
                    what = f"{kind}/{name}, seed {seed}, change {turn}:"
                    counts[done.returncode] = counts.get(done.returncode, 0) + 1
                    check(done.returncode in (0, 2), what, "exit", done.returncode,
                          done.stderr.decode(errors="replace")[-3000:])
                    check(done.stderr.count(b"\n") == (done.returncode == 2), what, done.stderr)
                    check(os.path.exists(page) == (done.returncode == 0), what, "page or line")
                    if os.path.exists(page):
                        with open(page, encoding="utf-8") as file:
                            text = file.read()
                        check(len(text) < 3_000_000, what, len(text), "characters")
                        check(text.rstrip().endswith("</html>"), what, "the page has no end")
                        check(text.count("<script>") <= 1, what, "a name became a tag")
                        if name.endswith((".json", ".csv")) and browser.program():
                            pages.drawn(page)
                            check(pages.failed == [], what, "as it is drawn")
                            pages.failed.clear()
                        os.unlink(page)
                with open(path, "wb") as file:
                    file.write(data)
        print(f"{counts[0]} pages, {counts[2]} refused; failures:", failures)
        check(counts[0] > counts[2] > 0, "nothing was tried")
    return failures != 0


if __name__ == "__main__":
    WORDS = [word for word in sys.argv[2:] if word]
    SEEDS = [int(word) for word in WORDS if word.isdigit()]
    sys.exit(main(os.path.abspath(sys.argv[1]),
                  any(word != "nightly" and not word.isdigit() for word in WORDS),
                  SEEDS[0] if SEEDS else 1, TIMES_NIGHTLY if "nightly" in WORDS else TIMES))
