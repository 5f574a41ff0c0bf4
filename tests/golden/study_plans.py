#!/usr/bin/env python3
"""One plan for all rows of a study: the same that `murk place` finds over
conditions that are like the rows, and what it is worth in each of them is what
`murk sense` says. Standard library only; nothing here is left to chance.
usage: study_plans.py MURK
"""

import math
import os
import shutil
import signal
import subprocess
import sys
import time

import study
from study import Folder, check, near, number, without_run

BOTH = "outputs: [coverage_best, coverage_one_mean, coverage_one_worst]\n"
AIRS = ["0.1", "0.6", "2"]
TURBID = "axes: {media.fog.extinction_per_m: [0.1, 0.6, 2]}\n"


def places(sensors):
    return sorted((s["type"], *s["position_m"]) for s in sensors)


def conditions(f):
    """The rows of TURBID as conditions of a scene."""
    with open(f.at("scene.yaml"), encoding="utf-8") as file:
        scene = file.read().splitlines()
    named = ", ".join("air%d: {media.fog.extinction_per_m: %s}" % (i, a)
                      for i, a in enumerate(AIRS))
    scene = [line for line in scene if not line.startswith("conditions:")]
    f.write("over.yaml", "\n".join(scene + ["conditions: {%s}" % named]) + "\n")


def test_as_place_over_conditions(f):
    conditions(f)
    f.study(TURBID + BOTH, "turbid")
    data = f.json("turbid/study.json")
    for over in ["mean", "worst"]:
        f.run("place", "over.yaml", "-o", "over", "--set", "placement.over=" + over)
        plan = f.json("over/plan.json")
        check(places(data["plans"][over]["sensors"]) == places(plan["sensors"]), over,
              data["plans"][over], plan["sensors"])
    check(places(data["plans"]["mean"]["sensors"]) != places(data["plans"]["worst"]["sensors"]),
          "the two plans differ here")
    for over in ["mean", "worst"]:
        plan, name = data["plans"][over], "coverage_one_" + over
        values = [number(row, name) for row in f.table("turbid")]
        near(plan["mean"]["value"], sum(v for v, _ in values) / 3, 1e-12)
        near(plan["mean"]["standard_error"], sum(e for _, e in values) / 3, 1e-12)
        check((plan["worst"]["value"], plan["worst"]["standard_error"]) == min(values), plan)
        check(plan["worst_row"] == 1 + values.index(min(values)), plan)
        check(plan["chosen_for_rows"] == [1, 2, 3] and plan["failed"] is None, plan)
        check(plan["in_sample"] <= plan["upper_bound"], plan)


def test_values_are_those_of_sense(f):
    """Without held-out light every number is of the light that chose: no plan beats another at
    what it was proven best for."""
    hold = ["--set", "placement.hold_out=false"]
    f.study(TURBID + BOTH, "seen", *hold)
    data, table = f.json("seen/study.json"), f.table("seen")
    for over in ["mean", "worst"]:
        f.write("one.csv", "type,x_m,y_m,z_m\n" + "".join(
            "%s,%r,%r,%r\n" % (s["type"], *s["position_m"])
            for s in data["plans"][over]["sensors"]))
        for row, air in zip(table, AIRS):
            f.run("sense", "scene.yaml", "--sensors", "one.csv", "-o", "sense", "--set",
                  "media.fog.extinction_per_m=" + air)
            sense = f.json("sense/coverage.json")["coverage"]
            check(number(row, "coverage_one_" + over) ==
                  (sense["in_sample"], sense["standard_error"]), over, air)
            check(number(row, "coverage_one_" + over)[0] <= number(row, "coverage_best")[0],
                  "best for the row", row)
    mean, worst = data["plans"]["mean"], data["plans"]["worst"]
    check(mean["mean"]["value"] >= worst["mean"]["value"], "best mean", mean, worst)
    check(worst["worst"]["value"] > mean["worst"]["value"], "best worst", mean, worst)
    near(mean["in_sample"], mean["mean"]["value"], 1e-6)
    near(worst["in_sample"], worst["worst"]["value"], 1e-6)
    # one row: its own best plan
    f.study("axes: {}\n" + BOTH, "single", *hold)
    row = f.table("single")[0]
    check(row["coverage_one_mean"] == row["coverage_best"] == row["coverage_one_worst"], row)


def test_dark_and_failed_rows(f):
    """They have no say; scaled light chooses as well."""
    axes = ("axes: {lamp: {on: {}, off: {lights.0.power_w: 0, lights.1.power_w: 0}}, "
            "media.fog.albedo: [0.9, %s0.5]}\n")
    f.study(axes % "" + BOTH, "dark")
    data, table = f.json("dark/study.json"), f.table("dark")
    check([r["coverage_one_mean"] == "" for r in table] == [False, False, True, True], table)
    check(data["plans"]["mean"]["chosen_for_rows"] == [1, 2], data["plans"])
    f.study(axes % "7, " + BOTH, "some", want=1)
    some = f.json("some/study.json")
    check(places(some["plans"]["worst"]["sensors"]) == places(data["plans"]["worst"]["sensors"]),
          "without the failed ones")
    check(f.table("some")[1]["coverage_one_mean"] == "", "a failed row")
    f.study("axes: {lights.0.power_w: [0]}\n" + BOTH, "night", "--set", "lights.1.power_w=0")
    night = f.json("night/study.json")
    check(night["plans"]["mean"]["sensors"] == [] and night["plans"]["mean"]["failed"] is None
          and night["plans"]["mean"]["mean"]["value"] is None, night["plans"])


def test_many_rows(f):
    """More rows than have a say: all are measured."""
    f.study("axes: {photons.emit: [200], media.fog.albedo: {from: 0.1, to: 0.9, steps: 70}}\n"
            "outputs: [coverage_one_mean, coverage_one_worst]\n", "many")
    plan = f.json("many/study.json")["plans"]["worst"]
    by = plan["chosen_for_rows"]
    check(len(by) == 64 and by == sorted(set(by)) and by[0] <= 2 and by[-1] >= 69, by)
    values = [number(row, "coverage_one_worst") for row in f.table("many")]
    check(len(values) == 70 and min(values)[0] == plan["worst"]["value"], plan["worst"])


def test_threads_and_resume(f):
    text = "axes: {media.fog.albedo: [0.9, 0.6], lights.0.power_w: [10, 2]}\n" + BOTH
    wanted = None
    for threads in ["1", "2", "5"]:
        f.study(text, "threads" + threads, "--threads", threads)
        got = (f.bytes(f"threads{threads}/table.csv"),
               without_run(f.json(f"threads{threads}/study.json")))
        check(wanted is None or got == wanted, "threads", threads)
        wanted = got
    f.study(text, "threads5")
    check(f.json("threads5/study.json")["run"]["lights_traced"] == 0, "nothing to trace")
    check(f.bytes("threads5/table.csv") == wanted[0], "the same table from what is kept")
    # killed once the first plan is kept, or a row's values are: 4 rows, 2 plans, 4 values
    f.write("kill.yaml", "murk_study: 1\nbase: scene.yaml\n" + text)
    for rows in [4, 5, 7]:
        out = f"killed{rows}"
        with subprocess.Popen([f.murk, "study", "kill.yaml", "-o", out], cwd=f.path,
                              stderr=subprocess.PIPE, stdout=subprocess.PIPE) as process:
            until = time.monotonic() + 60
            while time.monotonic() < until and process.poll() is None:
                if os.path.isdir(f.at(out + "/rows")) and len(
                        [n for n in os.listdir(f.at(out + "/rows")) if n.endswith(".yaml")]) >= rows:
                    break
                time.sleep(0.001)
            process.send_signal(signal.SIGKILL)
            process.communicate()
        f.study(text, out)
        check(f.bytes(out + "/table.csv") == wanted[0], "after a kill", rows)
        check(f.json(out + "/study.json")["run"]["rows_kept"] == 4, "rows are kept", rows)


def test_what_cannot_be(f):
    done = f.study("axes: {sensors.count: [1, 2]}\noutputs: [coverage_one_mean]\n", "no", want=2)
    check("row 2 differ from those of row 1" in done.stderr, done.stderr)
    done = f.study("axes: {}\noutputs: [coverage_one_worst]\n", "no", "--set",
                   "placement.knowledge=unknown", want=2)
    check("knowledge must be known" in done.stderr, done.stderr)
    f.study(TURBID + "outputs: [coverage_one_mean]\n", "unknown", "--set",
            "placement.knowledge=unknown", "--set", "placement.method=greedy")
    check(len(f.json("unknown/study.json")["plans"]["mean"]["sensors"]) == 2, "unknown")
    # a target that one row cannot meet: the rows stay as they are
    done = f.study(TURBID + "outputs: [density, coverage_one_worst]\n", "target", "--set",
                   "sensors.target=0.999", "--set", "sensors.candidates.grid.size=[2, 2, 1]",
                   want=1)
    check("cannot be reached" in done.stderr, done.stderr)
    table = f.table("target")
    check(all(r["density"] and not r["coverage_one_worst"] and not r["failed"] for r in table),
          table)
    check("cannot be reached" in f.json("target/study.json")["plans"]["worst"]["failed"], "why")
    check(math.isfinite(number(f.table("unknown")[0], "coverage_one_mean")[1]), "an error")


def main():
    f = Folder(os.path.abspath(sys.argv[1]))
    try:
        for test in [test_as_place_over_conditions, test_values_are_those_of_sense,
                     test_dark_and_failed_rows, test_many_rows, test_threads_and_resume,
                     test_what_cannot_be]:
            begun = time.monotonic()
            test(f)
            print(f"{test.__name__}: {time.monotonic() - begun:.1f} s")
    finally:
        shutil.rmtree(f.path)
    sys.exit(study.failures != 0)


main()
