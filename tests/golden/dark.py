#!/usr/bin/env python3
"""Scenes without light, from outside: every result file of trace, place and
sense, light.murk used again, and conditions of which one is dark. What there is
nothing to say of is null, what there is none of is 0. Standard library only.
usage: dark.py MURK
"""

import os
import subprocess
import sys
import tempfile

import from_outside
from from_outside import ROOM, check

DARK = ROOM.replace("power_w: [10, 3]", "power_w: 0") + """\
  fixed: [{type: node, position_m: [1, 1, 1]}]
tallies:
  - {name: up, type: plane, point_m: [0, 0, 1], normal: [0, 0, 1], bins: [2, 1]}
  - {name: lit, type: grid, min_m: [0, 0, 0], max_m: [4, 4, 3], size: [4, 4, 3]}
"""

# No sun: it stands below the horizon, and shines into a periodic domain.
NIGHT = """\
murk: 1
band_edges_nm: [400, 550, 700]
site: {latitude_deg: 52, longitude_deg: 5, time: 2026-01-15T23:00:00Z}
domain: {min_m: [0, 0, 0], max_m: [4, 4, 3], sides: periodic}
geometry: [{rect: {corner_m: [0, 0, 0.1], edge1_m: [4, 0, 0], edge2_m: [0, 4, 0]}}]
lights:
  - {type: sun}
  - {type: point, position_m: [2, 2, 2], power_w: 5, schedule: [[06:00, 22:00]]}
"""

NOTE = "it is dark"


class Quiet(from_outside.Murk):
    """Also keeps what was said on standard error."""

    def run(self, *words):
        done = subprocess.run([self.program, *words, "--format", "json"],
                              capture_output=True, text=True, timeout=60)
        self.said = done.stderr
        if done.returncode != 0:
            sys.exit(f"murk {' '.join(words)}: exit {done.returncode}\n{done.stderr}")
        return from_outside.parse(done.stdout)


def check_ledger(ledger):
    for name in ("emitted_w", "absorbed_surfaces_w", "absorbed_media_w", "escaped_w",
                 "lost_w"):
        check(ledger[name] == {"total": 0, "bands": [0, 0]}, name, ledger[name])
    check(ledger["photons_emitted"] == 0 and ledger["collisions"] == 0, ledger)
    check(ledger["imbalance_quanta"] == 0, ledger)


def check_nothing_seen(coverage):
    check(all(value is None for value in coverage.values()), "coverage", coverage)


def test_trace(murk, scene):
    check_ledger(murk.run("trace", scene, "-o", murk.path("t")))
    check(murk.said.count(NOTE) == 1, "noted:", murk.said)
    rows = murk.rows("tally,band_nm,bin_i,bin_j,bin_k,direction,value,standard_error,unit",
                     "t", "tallies.csv")
    check(len(rows) == 8, len(rows), "rows of tallies")
    check(all(float(row[6]) == 0 and float(row[7]) == 0 for row in rows), rows)
    check(os.path.exists(murk.path("t", "lit.vdb")), "no grid")
    store = murk.run("trace", scene, "--store", "100")
    check(store["photons_emitted"] == 0, "store", store)


def test_place(murk, scene):
    plan = murk.run("place", scene, "-o", murk.path("p"))
    check(plan["photons"] == {"emitted": 0, "surface": 0, "volume": 0}, plan["photons"])
    check_nothing_seen(plan["coverage"])
    check(plan["seen_by_at_least"] == [None], plan["seen_by_at_least"])
    fixed = plan["sensors"]
    check(len(fixed) == 1 and fixed[0]["position_m"] == [1, 1, 1], fixed)
    check(fixed[0]["covers"] is None and fixed[0]["only_it_covers"] is None, fixed)
    check(plan["bound"]["upper"] is None and plan["bound"]["gap"] is None and
          plan["bound"]["proven_optimal"] is False, plan["bound"])
    check(plan["curve"] == [], plan["curve"])
    check(plan["candidates"]["usable"] > 0, plan["candidates"])
    rows = murk.rows("sensor,type,x_m,y_m,z_m,covers,only_it_covers", "p", "coverage.csv")
    check(rows == [["1", "node", "1", "1", "1", "", ""]], rows)
    check_ledger(murk.read("p", "ledger.json"))
    # the light is found again, and that of another scene is not taken
    again = murk.run("place", scene, "--light", murk.path("p", "light.murk"))
    check(again["sensors"] == fixed, "again", again["sensors"])
    lit = subprocess.run([murk.program, "place", scene, "--set", "lights.0.power_w=1",
                          "--light", murk.path("p", "light.murk")],
                         capture_output=True, text=True, timeout=60)
    check(lit.returncode == 2, "a lit scene takes the dark one's light", lit.stderr)
    for words in (["--set", "placement.knowledge=unknown"],
                  ["--set", "placement.knowledge=explore"],
                  ["--set", "placement.detection=power"], ["--target", "0.9"],
                  ["--set", "placement.jitter_m=0.1"], ["--repeat", "3"],
                  ["--export", "matrix", "-o", murk.path("e")],
                  ["--set", "placement.interest=[{name: low, weight: 3, box: "
                   "{min_m: [0, 0, 0], max_m: [4, 4, 1]}}]"]):
        other = murk.run("place", scene, *words)
        check(other["coverage"]["in_sample"] is None, words, other["coverage"])
    strict = murk.run("place", scene, "--target", "0.9", "--set", "placement.at_least=2")
    check(strict["target"]["reached"] is None, "at_least", strict["target"])
    # targets need no light
    seen = murk.run("place", scene, "--set", "placement.targets={surfaces: {points: 500}}")
    check(seen["coverage"]["in_sample"] > 0, "targets", seen["coverage"])


def test_sense(murk, scene):
    found = murk.run("sense", scene, "--sensors", murk.path("p", "sensors.csv"),
                     "-o", murk.path("s"))
    check_nothing_seen(found["coverage"])
    check(len(found["sensors"]) == 1 and found["sensors"][0]["covers"] is None, found)
    check(found["seen_by_at_least"] == [None], found["seen_by_at_least"])
    # without a fixed sensor the plan of a dark scene is empty, and can be measured
    bare = ("--set", "sensors.fixed=[]")
    plan = murk.run("place", scene, *bare, "-o", murk.path("bare"))
    check(plan["sensors"] == [], "bare", plan["sensors"])
    for name in ("plan.json", "sensors.csv"):
        given = murk.path("bare", name)
        found = murk.run("sense", scene, *bare, "--sensors", given, "-o", murk.path("s"))
        check_nothing_seen(found["coverage"])
        check(found["sensors"] == [] and found["seen_by_at_least"] == [], name, found)
        check(murk.said.count(NOTE) == 1, "noted:", murk.said)
        lit = subprocess.run([murk.program, "sense", scene, "--set", "lights.0.power_w=1",
                              "--sensors", given], capture_output=True, text=True, timeout=60)
        check(lit.returncode == 2 and "1..1000000" in lit.stderr, "lit", lit.stderr)


def test_check(murk, scene):
    found = murk.run("check", scene)
    check(found["lights"]["power_w"] == 0, found["lights"])
    check(found["forecast"]["emitted"] == 0 and found["forecast"]["surface"] == 0,
          found["forecast"])
    check(NOTE in murk.said, "check says", murk.said)


def test_night(murk):
    scene = murk.write("night.yaml", NIGHT)
    check_ledger(murk.run("trace", scene))
    check("below the horizon" in murk.said and NOTE in murk.said, murk.said)
    day = murk.run("trace", scene, "--set", "site.time=2026-06-21T12:00:00Z")
    check(day["emitted_w"]["total"] > 1000, "by day", day["emitted_w"])
    # what check says of the sun is in the scene's units, and adds up with them
    noon = ["--set", "site.time=2026-06-21T12:00:00Z", "--set", "lights.1.power_w=0",
            "--set"]
    watts = murk.run("check", scene, *noon, "units=radiometric")["lights"]
    lumens = murk.run("check", scene, *noon, "units=photometric")["lights"]
    sun = lumens["sky"][0]
    check(watts["sky"][0]["irradiance"] == sun["irradiance_w_per_m2"] and
          watts["sky"][0]["unit"] == "W/m2", watts["sky"][0])
    check(sun["unit"] == "lux" and 60e3 < sun["irradiance"] < 120e3, sun)
    check("power_lm" not in watts and
          abs(lumens["power_lm"] / sun["irradiance"] /
              (watts["power_w"] / sun["irradiance_w_per_m2"]) - 1) < 1e-9, lumens)


def test_conditions(murk):
    scene = murk.write("over.yaml", ROOM + "conditions: {night: {lights.0.power_w: 0}, "
                       "fog: {media.fog.extinction_per_m: 1}, day: {}}\n")
    two = ROOM + ("conditions: {fog: {media.fog.extinction_per_m: 1}, day: {}}\n")
    for over in ("mean", "worst"):
        ask = ("--set", f"placement.over={over}")
        plan = murk.run("place", scene, *ask, "-o", murk.path("o"))
        names = [c["name"] for c in plan["conditions"]]
        check(names == ["fog", "day", "night"], names)
        noted = [line for line in murk.said.splitlines() if NOTE in line]
        check(len(noted) == 1 and "over.yaml" in noted[0] and
              ": conditions.night: " in noted[0], "noted:", murk.said)
        night = plan["conditions"][2]
        check(night["photons"]["emitted"] == 0 and night["in_sample"] is None and
              night["held_out"] is None and night["surface"] is None, night)
        check(all(len(p["coverage"]) == 2 for p in plan["regret"]["plans"]), plan["regret"])
        same = murk.run("place", murk.write("two.yaml", two), *ask)
        for part in ("sensors", "coverage", "bound"):
            check(plan[part] == same[part], over, part, "is not that of the lit ones")
        check_ledger(murk.read("o", "ledger-night.json"))
    rows = murk.rows("made_for,used_in,in_sample,in_sample_standard_error,held_out,"
                     "held_out_standard_error,regret", "o", "regret.csv")
    check(all(row[1] != "night" for row in rows), rows)
    none = murk.run("place", scene, *ask, "--set", "lights.0.power_w=0")
    check_nothing_seen(none["coverage"])
    check(none["worst_condition"] is None and none["over"] == "worst", none)
    check(none["regret"]["plans"] == [], none["regret"])


def main():
    with tempfile.TemporaryDirectory() as folder:
        murk = Quiet(os.path.abspath(sys.argv[1]), folder)
        scene = murk.write("dark.yaml", DARK)
        test_trace(murk, scene)
        test_place(murk, scene)
        test_sense(murk, scene)
        test_check(murk, scene)
        test_night(murk)
        test_conditions(murk)
    print("all that is dark is as described" if not from_outside.failures
          else f"{from_outside.failures} failed")
    return from_outside.failures != 0


if __name__ == "__main__":
    sys.exit(main())
