#!/usr/bin/env python3
"""Studies from outside: the table and study.json, what holds between them and
the runs that they stand for; light that is traced once; what a kill leaves, and
how the study goes on from there. Standard library only.

Of the statistical checks there are some 40, each within 5.5 standard errors of
its own difference: one in a million runs with other seeds would cry wolf; the
seed is fixed.
usage: study.py MURK
"""

import csv
import json
import math
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time

SIGMA_LIMIT = 5.5
failures = 0

SCENE = """\
murk: 1
bands_nm: [450, 650]
domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}
geometry:
  - {box: {min_m: [0.1, 0.1, 0.1], max_m: [3.9, 3.9, 2.9]}}
  - {box: {min_m: [0.5, 0.5, 0.1], max_m: [1.5, 1.5, 1.6]}}
media: {fog: {extinction_per_m: [0.3, 0.6], albedo: 0.9, phase: {hg: 0.8}}}
regions: [{medium: fog}]
lights:
  - {type: point, position_m: [2, 2, 2.5], power_w: [10, 3]}
  - {type: point, position_m: [3.5, 3.5, 0.5], power_w: 4}
photons: {emit: 3000}
tallies:
  - {name: floor, type: plane, point_m: [2, 2, 0.5], normal: [0, 0, -1], bins: [4, 4]}
  - {name: probe, type: sphere, center_m: [2, 3, 1], radius_m: 0.4}
sensors:
  types: [{name: node, range_m: 2.2}]
  candidates: {grid: {min_m: [0.5, 0.5, 0.5], max_m: [3.5, 3.5, 2.5], size: [4, 4, 3]}}
  count: 2
placement:
  interest:
    - {name: desk, box: {min_m: [2, 2, 0.5], max_m: [3, 3, 1.5]}, weight: 1}
    - {name: ball, sphere: {center_m: [3, 1, 1], radius_m: 0.5}, weight: 1}
conditions: {thin: {media.fog.extinction_per_m: 0.1}}
"""
PLAN = "type,x_m,y_m,z_m\nnode,2.5,2.5,1.5\n"
H_C = 1.98644586e-25
# A room whose roof is open above y < 2, and two windows in that roof.
WALLS = "".join("  - {rect: {corner_m: %s, edge1_m: %s, edge2_m: %s}}\n" % sheet for sheet in [
    ("[0, 0, 0.1]", "[4, 0, 0]", "[0, 4, 0]"), ("[0, 2, 2.9]", "[4, 0, 0]", "[0, 2, 0]"),
    ("[0.1, 0, 0]", "[0, 4, 0]", "[0, 0, 3]"), ("[3.9, 0, 0]", "[0, 4, 0]", "[0, 0, 3]"),
    ("[0, 0.1, 0]", "[4, 0, 0]", "[0, 0, 3]"), ("[0, 3.9, 0]", "[4, 0, 0]", "[0, 0, 3]")])
WINDOWS = ["[{corner_m: [0.2, 0.2, 2.9], edge1_m: [0, 1.7, 0], edge2_m: [1.7, 0, 0]}]",
           "[{corner_m: [2.5, 0.5, 2.9], edge1_m: [0, 1, 0], edge2_m: [1, 0, 0]}]"]


def check(holds, *what):
    global failures
    if not holds:
        failures += 1
        print("not so:", *what)


def within(a, b, error, *what):
    check(abs(a - b) <= SIGMA_LIMIT * error, *what, a, "and", b, "+-", error)


class Folder:
    def __init__(self, murk):
        self.murk = murk
        self.path = tempfile.mkdtemp()
        self.write("scene.yaml", SCENE)
        self.write("plan.csv", PLAN)

    def at(self, name):
        return os.path.join(self.path, name)

    def write(self, name, text):
        with open(self.at(name), "w", encoding="utf-8") as file:
            file.write(text)

    def run(self, *arguments, want=0):
        done = subprocess.run([self.murk, *arguments], cwd=self.path, text=True,
                              capture_output=True, check=False)
        check(done.returncode == want, arguments, "ended with", done.returncode,
              done.stderr)
        return done

    def study(self, text, out, *options, want=0, name="study.yaml"):
        self.write(name, "murk_study: 1\nbase: scene.yaml\n" + text)
        return self.run("study", name, "-o", out, *options, want=want)

    def table(self, out):
        with open(self.at(out + "/table.csv"), encoding="utf-8", newline="") as file:
            rows = list(csv.reader(file))
        check(rows[0][-1] == "failed", "last column", rows[0])
        for row in rows:
            check(len(row) == len(rows[0]), "cells of", row)
        return [dict(zip(rows[0], row)) for row in rows[1:]]

    def json(self, name):
        with open(self.at(name), encoding="utf-8") as file:
            return json.load(file)

    def bytes(self, name):
        with open(self.at(name), "rb") as file:
            return file.read()


def number(row, name):
    value, error = float(row[name]), float(row[name + "_standard_error"])
    return value, error


def without_run(data):
    return {key: value for key, value in data.items() if key != "run"}


def test_a_row_is_a_run(f):
    """One light for each row: its numbers are those of `murk place` and `sense`."""
    f.study("plan: plan.csv\naxes: {media.fog.albedo: [0.9, 0.5]}\n"
            "outputs: [density, coverage_fixed, coverage_best, stored, floor, probe]\n", "single")
    table = f.table("single")
    check(len(table) == 2, "rows of", table)
    for row, albedo in zip(table, ["0.9", "0.5"]):
        check(row["media.fog.albedo"] == albedo and row["failed"] == "", row)
        f.run("place", "scene.yaml", "-o", "place", "--set", "media.fog.albedo=" + albedo)
        plan = f.json("place/plan.json")
        best = number(row, "coverage_best")
        check(best == (plan["coverage"]["held_out"], plan["coverage"]["held_out_standard_error"]),
              "coverage_best", best, plan["coverage"])
        check(int(row["stored_surface"]) == plan["photons"]["surface"], row)
        check(int(row["stored_volume"]) == plan["photons"]["volume"], row)
        f.run("sense", "scene.yaml", "--sensors", "plan.csv", "-o", "sense", "--set",
              "media.fog.albedo=" + albedo)
        sense = f.json("sense/coverage.json")["coverage"]
        fixed = number(row, "coverage_fixed")
        check(fixed == (sense["in_sample"], sense["standard_error"]), fixed, sense)
        with open(f.at("place/tallies.csv"), encoding="utf-8", newline="") as file:
            tallies = list(csv.DictReader(file))
        for band in ["450", "650"]:
            power = {"forward": 0, "backward": 0}
            for t in tallies:
                if t["tally"] == "floor" and t["band_nm"] == band:
                    power[t["direction"]] += float(t["value"])
                if t["tally"] == "probe" and t["band_nm"] == band:
                    near(float(row["probe_" + band + "nm"]), float(t["value"]), 1e-9)
            for direction, watts in power.items():
                near(float(row["floor_" + direction + "_" + band + "nm"]), watts / 16, 1e-8)
    rows = f.json("single/study.json")["rows"]
    check([len(r["sensors"]) for r in rows] == [2, 2], "sensors")


def near(a, b, share):
    check(abs(a - b) <= share * abs(b), a, "is not", b)


def test_density(f):
    """The mean fluence rate of a grid tally, over the free share of the volume, in photons."""
    f.study("axes: {}\n", "density")
    row = f.table("density")[0]
    check(set(row) >= {"density", "density_450nm", "density_desk", "density_ball_650nm"}, row)
    f.write("grid.yaml", SCENE.replace(
        "tallies:", "tallies:\n  - {name: desk, type: grid, min_m: [2, 2, 0.5], max_m: [3, 3, 1.5],"
        " size: [1, 1, 1]}\n  - {name: all, type: sphere, center_m: [3, 1, 1], radius_m: 0.5}"))
    f.run("trace", "grid.yaml", "-o", "grid")
    with open(f.at("grid/tallies.csv"), encoding="utf-8", newline="") as file:
        ball = {t["band_nm"]: float(t["value"]) for t in csv.DictReader(file)
                if t["tally"] == "all"}
    total = 0
    for band, watts in ball.items():
        photons = watts * float(band) * 1e-9 / H_C
        near(float(row["density_ball_" + band + "nm"]), photons, 1e-6)
        total += photons
    near(float(row["density_ball"]), total, 1e-6)
    # the domain: the room is 3.8 x 3.8 x 2.8 less the crate, of 4 x 4 x 3
    free = (3.8 * 3.8 * 2.8 - 1.5) / 48
    values = f.json("density/study.json")["rows"][0]["values"]
    check(values["density"]["unit"] == "1/s/m2", values["density"])
    f.write("open.yaml", SCENE.replace(
        "tallies:", "tallies:\n  - {name: all, type: plane, point_m: [2, 2, 1.5],"
        " normal: [0, 0, 1]}"))
    f.write("whole.yaml", SCENE.replace("tallies:", "tallies:\n  - {name: whole, type: grid, "
            "min_m: [0, 0, 0], max_m: [4, 4, 3], size: [1, 1, 1]}"))
    f.write("whole-study.yaml", "murk_study: 1\nbase: whole.yaml\naxes: {}\n"
            "outputs: [density, whole]\nunits: radiometric\n")
    f.run("study", "whole-study.yaml", "-o", "whole")
    row = f.table("whole")[0]
    density, error = number(row, "density")
    mean, mean_error = number(row, "whole")
    # the free share's own error is what the two errors differ by
    share_error = density * math.sqrt(max((error / density) ** 2 - (mean_error / mean) ** 2, 0))
    within(density, mean / free, share_error, "density over the free share")
    check(0 < share_error < 0.01 * density, "the free share's error", share_error)
    check(abs(density - mean) > SIGMA_LIMIT * share_error, "the whole volume is not free")


def test_light_that_scales(f):
    """Lamps that differ in power are traced once; each row is within error of a run of its own."""
    axes = ("axes:\n  lights.0.power_w: [[10, 3], 0.5, 0]\n  lights.1.schedule: [always, never]\n"
            "outputs: [density, coverage_best, coverage_fixed, stored, probe]\nplan: plan.csv\n")
    f.study(axes, "scaled", "--emit", "15000")
    table, data = f.table("scaled"), f.json("scaled/study.json")
    check([(light["rows"], light["scaled_lights"]) for light in data["lights"]]
          == [([1, 2, 3, 4, 5, 6], 6)], data["lights"])
    check(data["run"]["lights_traced"] == 1, data["run"])
    k = 0
    for power in ["[10, 3]", "0.5", "0"]:
        for schedule in ["always", "never"]:
            row = table[k]
            k += 1
            if (power, schedule) == ("0", "never"):
                check(row["density"] == "0" and row["density_standard_error"] == "0", row)
                check(row["coverage_best"] == "" and row["coverage_fixed"] == "", row)
                check(row["failed"] == "" and row["stored_volume"] == "0", row)
                continue
            f.study("axes: {}\nplan: plan.csv\noutputs: [density, coverage_best, coverage_fixed,"
                    " probe]\n", "fresh", "--emit", "15000", "--set", "lights.0.power_w=" + power, "--set",
                    "lights.1.schedule=" + schedule, "--seed", "7", name="fresh.yaml")
            fresh = f.table("fresh")[0]
            for name in ["density", "density_450nm", "density_650nm", "density_ball",
                         "coverage_fixed", "probe"]:
                a, a_error = number(row, name)
                b, b_error = number(fresh, name)
                within(a, b, math.hypot(a_error, b_error), power, schedule, name)
                check(a_error < 2 * b_error, "as many photons as a run of its own", name, a_error,
                      b_error)
            # teeth: scaled by 15 % too much it would not get through
            a, a_error = number(row, "density")
            b, b_error = number(fresh, "density")
            check(abs(1.15 * a - b) > SIGMA_LIMIT * math.hypot(a_error, b_error), "15 %", a, b,
                  a_error, b_error)
            # plans are chosen on noise: the better one can be better by that
            a, a_error = number(row, "coverage_best")
            b, b_error = number(fresh, "coverage_best")
            check(abs(a - b) < SIGMA_LIMIT * math.hypot(a_error, b_error) + 0.02, "best", a, b)


def test_light_through_windows(f):
    """Rows under distant light that enters through portals are within error of runs of their own,
    whether the power of the light varies or the portals."""
    room = SCENE.replace("  - {box: {min_m: [0.1, 0.1, 0.1], max_m: [3.9, 3.9, 2.9]}}\n", WALLS)
    begin, end = room.index("lights:"), room.index("photons:")
    f.write("windows.yaml", room[:begin] + "lights:\n  - {type: directional, direction: "
            "[0.2, 0.3, -1], irradiance_w_per_m2: [4, 2], aim: " + WINDOWS[0] + "}\n" + room[end:])
    head = "murk_study: 1\nbase: windows.yaml\noutputs: [density]\n"
    for axis, values in [("lights.0.irradiance_w_per_m2", ["[4, 2]", "[1, 2]"]),
                         ("lights.0.aim", WINDOWS)]:
        f.write("panes.yaml", head + "axes: {" + axis + ": [" + ", ".join(values) + "]}\n")
        f.run("study", "panes.yaml", "-o", "panes", "--emit", "15000", "--force")
        table = f.table("panes")
        for row, value in zip(table, values):
            f.write("pane.yaml", head + "axes: {}\n")
            f.run("study", "pane.yaml", "-o", "pane", "--emit", "15000", "--seed", "7", "--set",
                  axis + "=" + value, "--force")
            a, a_error = number(row, "density")
            b, b_error = number(f.table("pane")[0], "density")
            within(a, b, math.hypot(a_error, b_error), axis, value)
            # teeth: light of another row, or of no portals, is 30 % away
            check(0.3 * b > SIGMA_LIMIT * math.hypot(a_error, b_error), "errors of", axis, b_error)
        first, second = (float(row["density"]) for row in table)
        check(abs(first - second) > 0.3 * max(first, second), "rows alike", axis, first, second)


def test_units(f):
    """Where light only scales, a band's value in another unit is the same for all rows."""
    axes = "axes: {lights.0.power_w: [[10, 3], 0.5, 0]}\n"
    found = {}
    for units in ["radiometric", "photons", "photometric", "par"]:
        f.study(axes + "units: %s\noutputs: [density, floor]\n" % units, "units")
        found[units] = f.table("units")
        check([r["failed"] for r in found[units]] == [""] * 3, units)
    for name in ["density", "density_ball", "floor_backward"]:
        for row in range(3):
            for band in ["450", "650"]:
                watts, error = number(found["radiometric"][row], f"{name}_{band}nm")
                per_watt = float(band) * 1e-9 / H_C
                for units, factor in {"photons": per_watt, "par": per_watt / 6.02214076e17}.items():
                    near(number(found[units][row], f"{name}_{band}nm")[0], watts * factor, 1e-6)
                    near(number(found[units][row], f"{name}_{band}nm")[1], error * factor, 1e-6)
                lux = number(found["photometric"][row], f"{name}_{band}nm")[0] / watts
                # CIE 1924 luminous efficiency at these lines
                near(lux, 683.002 * {"450": 0.038, "650": 0.107}[band], 1e-3)


def test_dark_rows_with_targets(f):
    """Targets need no light: what covers them is what `place` says in the dark."""
    dark = ["--set", "lights.1.power_w=0", "--set", "placement.targets={volume: {points: 300}}"]
    f.study("axes: {lights.0.power_w: [5, 0]}\nplan: plan.csv\n"
            "outputs: [density, coverage_fixed, coverage_best]\n", "targets", *dark)
    table = f.table("targets")
    check(table[1]["density"] == "0", table[1])
    f.run("place", "scene.yaml", "-o", "place", *dark, "--set", "lights.0.power_w=0")
    plan = f.json("place/plan.json")["coverage"]
    check(number(table[1], "coverage_best") ==
          (plan["held_out"], plan["held_out_standard_error"]), table[1], plan)
    note = f.json("targets/study.json")["rows"][1]["note"]
    check("coverage is of the targets" in note and "null" not in note, note)


def test_threads(f):
    text = ("axes: {lights.0.power_w: [10, 2], media.fog.albedo: [0.9, 0.6]}\nplan: plan.csv\n"
            "outputs: [density, coverage_best, coverage_fixed, stored, probe, floor]\n")
    wanted = None
    for threads in ["1", "2", "5"]:
        f.study(text, "threads" + threads, "--threads", threads)
        got = (f.bytes(f"threads{threads}/table.csv"),
               without_run(f.json(f"threads{threads}/study.json")))
        check(wanted is None or got == wanted, "threads", threads)
        wanted = got
    names = sorted(os.listdir(f.at("threads1/rows")))
    check(names == sorted(os.listdir(f.at("threads5/rows"))) and len(names) == 4, names)
    for name in names:
        check(f.bytes("threads1/rows/" + name) == f.bytes("threads5/rows/" + name), name)


def test_axes(f):
    f.study("axes:\n  condition: [thin]\n  room: {bright: {lights.0.power_w: 20, "
            "lights.1.power_w: 20}, dim: {}}\n  seed: {from: 1, to: 3, steps: 2}\n"
            "outputs: [stored]\n", "axes")
    table = f.table("axes")
    check([(r["condition"], r["room"], r["seed"]) for r in table]
          == [("thin", "bright", "1"), ("thin", "bright", "3"), ("thin", "dim", "1"),
              ("thin", "dim", "3")], table)
    check(list(table[0])[:3] == ["condition", "room", "seed"], "axes come first")
    f.run("trace", "scene.yaml", "-o", "thin", "--set", "media.fog.extinction_per_m=0.1",
          "--seed", "3")
    ledger = f.json("thin/ledger.json")
    check(ledger["photons_emitted"] == 3000, ledger)
    f.study("axes: {seed: [1, 2, 3], photons.emit: [100, 200, 300]}\nmode: paired\n"
            "outputs: [stored]\n", "paired")
    check([(r["seed"], r["photons.emit"]) for r in f.table("paired")]
          == [("1", "100"), ("2", "200"), ("3", "300")], "paired")
    check([r["photons_emitted"] for r in f.json("paired/study.json")["rows"]] == [100, 200, 300],
          "photons of each row")
    f.study("axes: {media.fog.extinction_per_m: {from: 0.01, to: 1, steps: 3, spacing: log}}\n"
            "outputs: [stored]\n", "log")
    check([r["media.fog.extinction_per_m"] for r in f.table("log")] == ["0.01", "0.1", "1"], "log")
    f.study("axes: {media.fog.albedo: {from: 0.1, to: 0.9, steps: 9}, "
            "seed: {from: 1, to: 49, steps: 9}, photons.emit: {from: 100, to: 900, steps: 9}}\n"
            "mode: paired\noutputs: [stored]\n", "steps")
    check([(r["media.fog.albedo"], r["seed"], r["photons.emit"]) for r in f.table("steps")]
          == [(str(i / 10), str(6 * i - 5), str(100 * i)) for i in range(1, 10)], "whole steps")


def test_notes(f):
    """Each is told once, whatever its numbers; study.json has them all."""
    done = f.study("axes: {lights.0.schedule: [never], seed: [1, 2, 3]}\noutputs: [stored]\n",
                   "notes", "--set", "lights.1.power_w=0")
    check(done.stderr.count("dark: no light shines") == 1, done.stderr)
    notes = [r["note"] for r in f.json("notes/study.json")["rows"]]
    check(all("dark: no light shines" in n for n in notes) and len(notes) == 3, notes)


def test_failed_rows(f):
    """Each in its own way; the others are as they would be without them."""
    text = "axes: {media.fog.albedo: [0.9, %s0.6]}\noutputs: [density]\n"
    f.study(text % "", "whole")
    done = f.study(text % "7, ", "failed", "--report", want=1)
    page = f.bytes("failed/report.html").decode() if os.path.exists(f.at("failed/report.html")) else ""
    check(page.count("media.fog.albedo: 7, must be 0..1") >= 2, "the page tells of the failed row in its data and table")
    table = f.table("failed")
    check([bool(r["failed"]) for r in table] == [False, True, False], table)
    check("media.fog.albedo: 7, must be 0..1" in table[1]["failed"], table[1])
    check(table[1]["density"] == "", table[1])
    check(len(done.stderr.splitlines()) == 2, done.stderr)
    check(all(f"<td>{r['density']}</td>" in page for r in table), "the page has the others")
    check([r["density"] for r in table if not r["failed"]]
          == [r["density"] for r in f.table("whole")], "the others")
    # found when it runs: more sensors than candidates
    f.study("axes: {sensors.count: [1, 1000, 2]}\noutputs: [density, coverage_best]\n", "late",
            want=1)
    table = f.table("late")
    check([bool(r["failed"]) for r in table] == [False, True, False], table)
    check("1000" in table[1]["failed"], table[1]["failed"])
    check(f.json("late/study.json")["rows_failed"] == 1, "rows_failed")
    # all at once: nothing is written
    f.study("axes: {media.fog.albedo: [7, 8]}\n", "nothing", "--report", want=2)
    check(not os.path.exists(f.at("nothing")), "nothing is written")


SLOW = ("axes: {media.fog.albedo: {from: 0.5, to: 0.9, steps: 6}}\n"
        "outputs: [density, coverage_fixed]\nplan: plan.csv\n")


def stop(f, out, how, rows):
    """Starts the slow study and stops it once so many rows are kept."""
    f.write("slow.yaml", "murk_study: 1\nbase: scene.yaml\n" + SLOW)
    with subprocess.Popen([f.murk, "study", "slow.yaml", "-o", out, "--emit", "60000"],
                          cwd=f.path, stderr=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        until = time.monotonic() + 60
        while time.monotonic() < until and process.poll() is None:
            folder = f.at(out + "/rows")
            names = [n for n in os.listdir(folder)] if os.path.isdir(folder) else []
            if len([n for n in names if n.endswith(".yaml")]) >= rows:
                break
            time.sleep(0.005)
        process.send_signal(how)
        process.communicate()
        return process.returncode


def test_resume(f):
    f.study(SLOW, "straight", "--emit", "60000")
    code = stop(f, "killed", signal.SIGKILL, 2)
    check(code == -signal.SIGKILL, "it was still at work", code)
    check(not os.path.exists(f.at("killed/table.csv")), "no half result")
    before = {n: f.bytes("killed/rows/" + n) for n in os.listdir(f.at("killed/rows"))}
    times = {n: os.stat(f.at("killed/rows/" + n)).st_mtime_ns for n in before}
    f.study(SLOW, "killed", "--emit", "60000")
    run = f.json("killed/study.json")["run"]
    check(2 <= run["rows_kept"] < 6 and run["lights_traced"] == 6 - run["rows_kept"], run)
    check(all(os.stat(f.at("killed/rows/" + n)).st_mtime_ns == t for n, t in times.items()
              if n.endswith(".yaml")), "kept rows are not made anew")
    check(f.bytes("killed/table.csv") == f.bytes("straight/table.csv"), "the same table")
    check(without_run(f.json("killed/study.json")) == without_run(f.json("straight/study.json")),
          "the same study.json")
    # all is there: nothing is traced
    f.study(SLOW, "killed", "--emit", "60000")
    check(f.json("killed/study.json")["run"]["lights_traced"] == 0, "nothing to trace")
    # another scene, and it is
    f.study(SLOW, "killed", "--emit", "60001")
    check(f.json("killed/study.json")["run"]["rows_kept"] == 0, "another scene")
    # a kept file that is broken is no row
    f.study(SLOW, "straight", "--emit", "60000")
    name = sorted(os.listdir(f.at("straight/rows")))[0]
    table = f.bytes("straight/table.csv")
    f.write("straight/rows/" + name, "failed: [\n")
    f.study(SLOW, "straight", "--emit", "60000")
    check(f.json("straight/study.json")["run"]["rows_kept"] == 5, "a broken file")
    check(f.bytes("straight/table.csv") == table, "the same table again")


def test_interrupt(f):
    code = stop(f, "stopped", signal.SIGINT, 1)
    check(code == 130, "exit code", code)
    table = f.table("stopped")
    check(1 <= len(table) < 6, "rows done", len(table))
    data = f.json("stopped/study.json")
    check(data["interrupted"] and data["rows_done"] == len(table), data["rows_done"])


def test_schema(f):
    data = f.json("single/study.json")
    for key, kind in {"murk": dict, "study": str, "study_sha256": str, "scene": str,
                      "scene_sha256": str, "seed": int, "mode": str, "axes": list, "rows": list,
                      "lights": list, "rows_asked": int, "rows_done": int, "rows_failed": int,
                      "interrupted": bool, "run": dict}.items():
        check(isinstance(data.get(key), kind), key, data.get(key))
    check(list(data)[-1] == "run", "run comes last")
    for row in data["rows"]:
        check(set(row) == {"row", "axes", "values", "sensors", "photons_emitted", "light", "note",
                           "failed"}, row)
        for name, value in row["values"].items():
            check(set(value) == {"value", "standard_error", "unit"}, name)
    done = f.run("study", "study.yaml", "--format", "json")
    check(json.loads(done.stdout)["mode"] in ["grid", "paired"], "--format json")


def check_grid(path, row):
    """The mean over a grid is that of the whole domain; skipped without OpenVDB's module."""
    done = subprocess.run(
        ["/usr/bin/python3", "-c", "import sys, pyopenvdb as v\nfor g in v.readAll(sys.argv[1])[0]:"
         "\n    x = [i['value'] for i in g.citerOnValues() for _ in range(i['count'])]"
         "\n    print(g.name, len(x), sum(x) / len(x))", path],
        text=True, capture_output=True, check=False)
    if "ModuleNotFoundError" in done.stderr:
        return
    lines = [line.split() for line in done.stdout.splitlines()]
    check([line[0] for line in lines] == ["fluence_450nm", "fluence_650nm"], done)
    for name, n, mean in lines:
        check(n == "48", name, n)
        near(float(mean), float(row[name.replace("fluence", "whole")]), 1e-5)


def test_fluence(f):
    text = "axes: {lights.0.power_w: [10, 0]}\noutputs: [fluence_vdb]\nfluence_size: [4, 4, 3]\n"
    f.study(text, "fluence")
    names = sorted(n for n in os.listdir(f.at("fluence")) if n.endswith(".vdb"))
    check(names == ["fluence_0001.vdb", "fluence_0002.vdb"], names)
    os.remove(f.at("fluence/fluence_0002.vdb"))
    f.study(text, "fluence")
    check(os.path.exists(f.at("fluence/fluence_0002.vdb")), "a lost grid is made anew")
    check(f.json("fluence/study.json")["run"]["rows_kept"] == 1, "the other row is kept")
    # the same rows elsewhere: files are of the rows that have their numbers
    f.study(text.replace("[10, 0]", "[0, 10]"), "fluence")
    f.study("axes: {lights.0.power_w: [10, 0]}\noutputs: [fluence_vdb, whole]\nunits: radiometric"
            "\nfluence_size: [4, 4, 3]\n", "grid", "--set", "tallies.0={name: whole, type: grid, "
            "min_m: [0, 0, 0], max_m: [4, 4, 3], size: [1, 1, 1]}", "--set", "tallies.1.name=ball")
    for out, order in ("fluence", [1, 0]), ("grid", [0, 1]):
        for row in range(2):
            check_grid(f.at(f"{out}/fluence_000{row + 1}.vdb"), f.table("grid")[order[row]])


def main():
    f = Folder(os.path.abspath(sys.argv[1]))
    try:
        for test in [test_a_row_is_a_run, test_schema, test_density, test_light_that_scales,
                     test_light_through_windows,
                     test_units, test_dark_rows_with_targets, test_threads, test_axes, test_notes, test_failed_rows, test_resume, test_interrupt,
                     test_fluence]:
            begun = time.monotonic()
            test(f)
            print(f"{test.__name__}: {time.monotonic() - begun:.1f} s")
    finally:
        shutil.rmtree(f.path)
    sys.exit(failures != 0)


if __name__ == "__main__":
    main()
