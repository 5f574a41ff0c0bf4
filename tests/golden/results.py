#!/usr/bin/env python3
"""Every result file from outside: its fields, types and ranges; what must hold
between its values; coverage and its error computed again in Python; the events
of photons against the ledger. Standard library only.
usage: results.py MURK
"""

import csv
import hashlib
import json
import math
import os
import subprocess
import sys
import tempfile

import light_file
import result_kinds as kinds

# A floor in fog, a glass pane on it, all sides open: light escapes. Two bands.
OPEN = """\
murk: 1
bands_nm: [450, 650]
seed: 3
domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}
geometry:
  - {rect: {corner_m: [0, 0, 0.1], edge1_m: [4, 0, 0], edge2_m: [0, 4, 0]}, material: floor}
  - {rect: {corner_m: [2, 0.5, 0.1], edge1_m: [0, 3, 0], edge2_m: [0, 0, 2]}, material: pane}
materials:
  floor: {diffuse: [0.6, 0.4]}
  pane: {specular: 0.1, transmit: 0.7}
media: {fog: {extinction_per_m: [0.4, 0.7], albedo: [0.9, 0.8], phase: {hg: 0.7}}}
regions: [{medium: fog}]
lights: [{type: point, position_m: [1, 2, 2.5], power_w: [10, 6]}]
photons: {emit: 4000}
sensors:
  types: [{name: node, range_m: 1.8}]
  candidates: {grid: {min_m: [0.5, 0.5, 0.5], max_m: [3.5, 3.5, 2.5], size: [4, 4, 3]}}
  count: 3
"""

# A closed room without furniture: every sightline in it is open.
EXTINCTION_PER_M = [0.3, 0.6]
RANGE_M = 2.2
ROOM = f"""\
murk: 1
bands_nm: [450, 650]
domain: {{min_m: [0, 0, 0], max_m: [4, 4, 3]}}
geometry: [{{box: {{min_m: [0.1, 0.1, 0.1], max_m: [3.9, 3.9, 2.9]}}}}]
media: {{fog: {{extinction_per_m: {EXTINCTION_PER_M}, albedo: 0.9, phase: {{hg: 0.8}}}}}}
regions: [{{medium: fog}}]
lights: [{{type: point, position_m: [2, 2, 2.5], power_w: [10, 3]}}]
photons: {{emit: 3000}}
sensors:
  types: [{{name: node, range_m: {RANGE_M}}}]
  candidates: {{grid: {{min_m: [0.5, 0.5, 0.5], max_m: [3.5, 3.5, 2.5], size: [4, 4, 3]}}}}
  count: 3
"""

SIGMA_LIMIT = 6
failures = 0


def check(is_so, *words):
    global failures
    if not is_so:
        failures += 1
        print("failed:", *words)


def near(got, want, within, *words):
    check(abs(got - want) <= within, *words, f"{got!r}, want {want!r} +- {within:g}")


def fits(value, kind, where):
    for complaint in kinds.complaints(value, kind, where):
        check(False, complaint)


# ---- running murk ----

def refuse(word):
    raise ValueError(f"{word} is not JSON")


def unique(pairs):
    names = [name for name, _ in pairs]
    assert len(set(names)) == len(names), f"a key twice among {names}"
    return dict(pairs)


def parse(document):
    value = json.loads(document, parse_constant=refuse, object_pairs_hook=unique)
    check(list(value)[-1] == "run", "`run` is not last in", list(value))
    return value


class Murk:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def write(self, name, content):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(content)
        return self.path(name)

    def run(self, *words):
        """The command's JSON from standard output."""
        done = subprocess.run([self.program, *words, "--format", "json"],
                              capture_output=True, text=True, timeout=60)
        if done.returncode != 0:
            sys.exit(f"murk {' '.join(words)}: exit {done.returncode}\n{done.stderr}")
        return parse(done.stdout)

    def read(self, *names):
        with open(self.path(*names), encoding="utf-8") as file:
            return parse(file.read())

    def rows(self, header, *names):
        with open(self.path(*names), newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
        check(rows[0] == header.split(","), names, "has the header", rows[0])
        check(all(len(row) == len(rows[0]) for row in rows), names, "is ragged")
        return rows[1:]


# ---- the files ----

def check_sensors(result, where):
    """What holds between the numbers of a plan or a measured placement."""
    coverage, sensors = result["coverage"], result["sensors"]
    seen, tiny = result["seen_by_at_least"], 1e-12
    covers = [s["covers"] for s in sensors]
    only = [s["only_it_covers"] for s in sensors]
    total = coverage["in_sample"]
    check(len(seen) == len(sensors), where, "seen_by_at_least for", len(seen))
    check(seen == sorted(seen, reverse=True), where, "seen_by_at_least", seen)
    check(all(c >= o for c, o in zip(covers, only)), where, covers, only)
    # seen at all counts whole, seen through fog only in part
    check(seen[0] >= total - tiny, where, "seen by any", seen[0], "under", total)
    check(sum(seen) >= sum(covers) - tiny, where, "views", sum(seen), sum(covers))
    check(max(covers) <= total + tiny, where, "one covers more than all", covers)
    check(sum(only) <= total + tiny, where, "only_it_covers adds up to", sum(only))
    near(coverage["sum_of_views"], sum(covers), 1e-9, where, "sum_of_views")
    near(total, (coverage["surface"] + coverage["volume"]) / 2, 1e-9, where,
         "balanced coverage")


def check_plan(plan, where):
    coverage, bound, curve = plan["coverage"], plan["bound"], plan["curve"]
    total, upper = coverage["in_sample"], bound["upper"]
    check(total <= coverage["ceiling"] <= 1, where, "ceiling", coverage["ceiling"])
    check(total <= upper <= 1, where, "upper", upper)
    near(bound["gap"], (upper - total) / upper, 1e-12, where, "gap")
    check(not bound["proven_optimal"] or bound["gap"] == 0, where, "optimal with a gap")
    check([p["count"] for p in curve] == list(range(1, len(plan["sensors"]) + 1)),
          where, "counts of the curve")
    values = [p["coverage"] for p in curve]
    check(all(a < b for a, b in zip(values, values[1:])), where, "curve", values)
    check(all(p["coverage"] <= p["upper"] <= 1 for p in curve), where, "curve's upper")
    near(values[-1], total, 1e-6, where, "end of the curve")
    near(curve[-1]["upper"], upper, 1e-6, where, "the curve's last bound")
    candidates = plan["candidates"]
    check(candidates["after_presolve"] <= candidates["poses"] and
          candidates["usable"] <= min(candidates["asked"], candidates["poses"]),
          where, candidates)
    dropped = [candidates[cause] for cause in
               ("duplicates", "forbidden", "too_close", "unreached")]
    check(candidates["usable"] + sum(dropped) == candidates["asked"], where, candidates)


def check_robust(result, where):
    """Loss of each sensor; the links against every pair, in a world whose only
    surface between sensors is a pane."""
    robust, sensors = result["robustness"], result["sensors"]
    drop, total = robust["drop_one"], result["coverage"]["in_sample"]
    for i, (without, sensor) in enumerate(zip(drop["without"], sensors)):
        check(without["sensor"] == i + 1, where, without)
        near(without["in_sample"], total - sensor["only_it_covers"], 1e-12, where,
             "without sensor", i + 1)
    held = result["coverage"]["held_out"] is not None
    kept = [w["held_out" if held else "in_sample"] for w in drop["without"]]
    have = result["coverage"]["held_out"] if held else total
    near(drop["worst_loss"], have - min(kept), 1e-12, where, "worst loss")
    near(drop["mean_loss"], have - sum(kept) / len(kept), 1e-12, where, "mean loss")
    check(kept[drop["worst_sensor"] - 1] == min(kept), where, drop)

    places = [s["position_m"] for s in sensors]
    joined, longest = {0}, 0
    while len(joined) < len(places):
        length, new = min((math.dist(places[i], places[j]), j) for i in joined
                          for j in range(len(places)) if j not in joined)
        joined.add(new)
        longest = max(longest, length)
    near(robust["link_range_m"], longest, 1e-12, where, "link range")
    near(robust["plain_link_range_m"], longest, 1e-12, where, "plain link range")
    near(max(link["length_m"] for link in robust["links"]), longest, 1e-12, where)
    check(robust["link_groups"] == 1 and len(robust["links"]) == len(places) - 1,
          where, robust["links"])


def test_jitter(murk):
    """A plan shaken a little does a little worse; not at all, just as well; the
    plan is the same."""
    scene = murk.write("open.yaml", OPEN)
    plan = murk.run("place", scene)
    check(plan["robustness"]["jitter"] is None, plan["robustness"]["jitter"])
    shaken = murk.run("place", scene, "--set", "placement.jitter_m=0.4",
                      "--set", "placement.jitter_draws=80")
    check(shaken["sensors"] == plan["sensors"], "jitter changes the plan")
    jitter = shaken["robustness"]["jitter"]
    check(jitter["draws"] == 80 and jitter["measured"] == "held_out", jitter)
    check(jitter["as_planned"] == plan["coverage"]["held_out"], jitter)
    check(0 < jitter["quantile_5_lower"] <= jitter["quantile_5"] <=
          jitter["quantile_5_upper"] < jitter["as_planned"], jitter)
    check(jitter["quantile_5"] < jitter["mean"] < jitter["as_planned"], jitter)
    check(jitter["mean_standard_error"] >= 0.5 * plan["coverage"]["held_out_standard_error"],
          jitter)
    shaken = murk.run("place", scene, "--set", "placement.jitter_deg=10",
                      "--set", "placement.hold_out=false")
    jitter = shaken["robustness"]["jitter"]  # turned, but seeing all round
    check(jitter["measured"] == "in_sample" and jitter["draws"] == 100, jitter)
    near(jitter["mean"], plan["coverage"]["in_sample"], 1e-12, "turned all round")

    # over conditions: of one, as without; of two, between them or the worse
    def over(kind, conditions, *more):
        shaken = murk.run("place", scene, "--set", "placement.jitter_m=0.4",
                          "--set", "placement.jitter_draws=80", "--set",
                          f"conditions={{{conditions}}}", "--set", f"placement.over={kind}",
                          *more)
        return shaken["robustness"]["jitter"]

    plain = murk.run("place", scene, "--set", "placement.jitter_m=0.4",
                     "--set", "placement.jitter_draws=80")["robustness"]["jitter"]
    for kind in ("mean", "worst"):
        check(over(kind, "one: {}") == plain, "jitter over one condition", kind)
    fixed = ["--set", "sensors.count=2", "--set", "sensors.fixed=[{type: node, position_m: "
             "[1.5, 2, 1.5]}, {type: node, position_m: [2.5, 2, 1.5]}]"]
    thick = "b: {media.fog.extinction_per_m: [2, 3]}"
    both = over("mean", "a: {}, " + thick, *fixed)
    worst = over("worst", "a: {}, " + thick, *fixed)
    apart = [over("mean", "a: {}, " + thick, "--set",
                  f"placement.condition_weights={{{other}: 0}}", *fixed) for other in "ba"]
    near(both["mean"], (apart[0]["mean"] + apart[1]["mean"]) / 2, 1e-12, "mean over two")
    near(worst["mean"], min(a["mean"] for a in apart), 1e-12, "worst of two")
    check(abs(apart[0]["mean"] - apart[1]["mean"]) > 0.1, "no teeth", apart)


def spread(values):
    values = sorted(values)
    half = len(values) // 2
    middle = values[half] if len(values) % 2 else (values[half - 1] + values[half]) / 2
    return {"median": middle, "minimum": values[0], "maximum": values[-1]}


REPEAT_COLUMNS = ("seed", "sensors", "in_sample", "held_out", "held_out_standard_error",
                  "upper", "proven_optimal", "plan", "plan_standard_error")
STUDENT_975 = {2: 4.302653, 3: 3.182446}


def test_repeat(murk):
    """Each run is the job of its seed by itself, the plan that of the first; what
    is said of all of them, computed again."""
    scene = murk.write("open.yaml", OPEN)
    alone = [murk.run("place", scene, "--seed", str(seed), "-o", murk.path(f"seed{seed}"))
             for seed in (3, 4, 5)]
    plan = murk.run("place", scene, "--repeat", "3", "-o", murk.path("repeat"))
    check(plan == murk.read("repeat", "plan.json"), "repeated plan.json is not the printed")
    fits(plan["repeat"], kinds.REPEAT, "repeat")
    repeat = plan["repeat"]
    check({k: v for k, v in plan.items() if k not in ("repeat", "run")} ==
          {k: v for k, v in alone[0].items() if k != "run"}, "repeating changes the plan")
    for name in ("light.murk", "sensors.csv", "coverage.csv", "plan.ply"):
        with open(murk.path("repeat", name), "rb") as one, \
                open(murk.path("seed3", name), "rb") as other:
            check(one.read() == other.read(), "repeating changes", name)

    rows = murk.rows(",".join(REPEAT_COLUMNS), "repeat", "repeat.csv")
    check([int(r[0]) for r in rows] == [3, 4, 5], "seeds", rows)
    for row, one in zip(rows, alone):
        coverage, bound = one["coverage"], one["bound"]
        check(int(row[1]) == len(one["sensors"]), row)
        for value, want in zip(row[2:6], (coverage["in_sample"], coverage["held_out"],
                                          coverage["held_out_standard_error"],
                                          bound["upper"])):
            near(float(value), want, 1e-15, "a run is not the job of its seed:", row)
        check(row[6] == str(bound["proven_optimal"]).lower(), row)
    check(rows[0][7:] == rows[0][3:5], "the first run's own second map", rows[0])
    for row, one in list(zip(rows, alone))[1:]:  # the plan in another seed's light
        folder = murk.path(f"seed{row[0]}")
        there = murk.run("sense", os.path.join(folder, "scene.yaml"), "--sensors",
                         murk.path("seed3", "sensors.csv"), "--light",
                         os.path.join(folder, "light.murk"))["coverage"]
        near(float(row[7]), there["in_sample"], 1e-15, "the plan under another seed")
        near(float(row[8]), there["standard_error"], 1e-15, "its error")

    for column, name in ((1, "sensors"), (2, "in_sample"), (3, "held_out"), (5, "upper")):
        for key, want in spread([float(r[column]) for r in rows]).items():
            near(repeat[name][key], want, 1e-12, "repeat", name, key)
    check(repeat["best_seed"] == max((float(r[3]), int(r[0])) for r in rows)[1], repeat)
    uppers, plans = [float(r[5]) for r in rows], [float(r[7]) for r in rows]
    near(repeat["upper"]["mean"], sum(uppers) / 3, 1e-12, "mean upper")
    near(repeat["plan"]["coverage"], sum(plans) / 3, 1e-12, "the plan's coverage")
    check_gap(repeat["gap"], [u - p for u, p in zip(uppers, plans)])

    aimed = murk.run("place", scene, "--repeat", "4", "--target", "0.5")
    check(aimed["repeat"]["gap"] is None and 0 <= aimed["repeat"]["target_met"] <= 4 and
          aimed["repeat"]["sensors"]["maximum"] >= aimed["target"]["fewest_possible"],
          aimed["repeat"])
    unseen = murk.run("place", scene, "--repeat", "2", "--set", "placement.hold_out=false")
    check(unseen["repeat"]["held_out"]["median"] is None and
          unseen["repeat"]["gap"]["runs"] == 1 and unseen["repeat"]["gap"]["lower"] is None,
          unseen["repeat"])
    explore = ["--set", "placement.knowledge=explore", "--set", "placement.start_m=[1.5,1.5,1.5]"]
    murk.run("place", scene, *explore, "--repeat", "2", "-o", murk.path("explored"))
    alone = murk.run("place", scene, *explore, "--seed", "4")
    row = murk.rows(",".join(REPEAT_COLUMNS), "explored", "repeat.csv")[1]
    near(float(row[2]), alone["coverage"]["in_sample"], 1e-15, "explored again")
    near(float(row[5]), alone["bound"]["upper"], 1e-15, "explored again, bound")
    for kind in ("mean", "worst"):
        over = ["--set", "conditions={a: {}, b: {media.fog.extinction_per_m: [1, 2]}}",
                "--set", f"placement.over={kind}"]
        first = murk.run("place", scene, *over, "--repeat", "2", "-o", murk.path(kind))
        alone = murk.run("place", scene, *over, "--seed", "4")
        row = murk.rows(",".join(REPEAT_COLUMNS), kind, "repeat.csv")[1]
        for value, want in zip(row[2:6], (alone["coverage"]["in_sample"],
                                          alone["coverage"]["held_out"],
                                          alone["coverage"]["held_out_standard_error"],
                                          alone["bound"]["upper"])):
            near(float(value), want, 1e-15, "a run over conditions:", kind, row)
        check((first["repeat"]["gap"] is None) == (kind == "worst"), first["repeat"])
        check(abs(float(row[7]) - first["coverage"]["held_out"]) < 0.1, kind, row)
    # light from a file is the first run's
    light = murk.run("place", scene, "--repeat", "3", "--light", murk.path("seed3", "light.murk"))
    check(light["repeat"] == repeat, "another repeat with the first run's light")


def check_gap(gap, differences):
    n = len(differences)
    mean = sum(differences) / n
    error = math.sqrt(sum((d - mean) ** 2 for d in differences) / (n * (n - 1)))
    near(gap["value"], mean, 1e-12, "gap")
    near(gap["lower"], mean - STUDENT_975[n - 1] * error, 1e-6 * error, "gap, lower")
    near(gap["upper"], mean + STUDENT_975[n - 1] * error, 1e-6 * error, "gap, upper")
    check(gap["runs"] == n and gap["confidence"] == 0.95, gap)


def check_ledger(ledger, power_w, where):
    emitted = ledger["emitted_w"]
    for name in ("emitted_w",) + kinds.COLUMNS:
        near(sum(ledger[name]["bands"]), ledger[name]["total"],
             1e-9 * emitted["total"], where, name, "by band")
    for band, want_w in enumerate(power_w):
        near(emitted["bands"][band], want_w, 1e-9 * want_w, where, "power of band", band)
        ended = sum(ledger[name]["bands"][band] for name in kinds.COLUMNS)
        near(ended, want_w, 1e-9 * want_w, where, "balance of band", band)
    ended = sum(ledger[name]["total"] for name in kinds.COLUMNS)
    near(ended, emitted["total"], 1e-9 * emitted["total"], where, "balance")


def check_sensors_csv(murk, folder, sensors):
    rows = murk.rows("type,x_m,y_m,z_m,heading_deg,tilt_deg", folder, "sensors.csv")
    check([(r[0], [float(v) for v in r[1:4]], r[4:]) for r in rows] ==
          [(s["type"], s["position_m"], ["", ""]) for s in sensors],
          "sensors.csv is not the plan's:", rows)


def check_coverage_csv(murk, folder, sensors):
    rows = murk.rows("sensor,type,x_m,y_m,z_m,covers,only_it_covers", folder,
                     "coverage.csv")
    check([(int(r[0]), r[1], [float(v) for v in r[2:5]]) for r in rows] ==
          [(i + 1, s["type"], s["position_m"]) for i, s in enumerate(sensors)],
          "coverage.csv is not the plan's:", rows)
    for row, sensor in zip(rows, sensors):
        near(float(row[5]), sensor["covers"], 1e-15, "coverage.csv covers")
        near(float(row[6]), sensor["only_it_covers"], 1e-15, "coverage.csv only it")


def test_files(murk):
    scene = murk.write("open.yaml", OPEN)
    found = murk.run("check", scene)
    fits(found, kinds.CHECK, "check")
    check(found["surfaces"]["triangles"] == 4, "triangles of two rects")
    near(found["surfaces"]["area_m2"], 16 + 6, 1e-5, "area")
    check([m["name"] for m in found["media"]] == ["fog"], found["media"])
    check(found["media"][0]["extinction_per_m"] == [0.4, 0.7], found["media"])
    check(found["candidates"]["asked"] == found["candidates"]["usable"] == 48,
          found["candidates"])

    plan = murk.run("place", scene, "-o", murk.path("plan"))
    fits(plan, kinds.PLAN, "plan.json")
    check(plan == murk.read("plan", "plan.json"), "plan.json is not what was printed")
    with open(scene, "rb") as file:
        digest = hashlib.sha256(file.read()).hexdigest()
    check(plan["scene_sha256"] == digest, "scene_sha256", plan["scene_sha256"])
    check(plan["seed"] == 3 and plan["photons"]["emitted"] == 4000, plan["photons"])
    check_sensors(plan, "plan.json")
    check_plan(plan, "plan.json")
    check_robust(plan, "plan.json")
    check_sensors_csv(murk, "plan", plan["sensors"])
    check_coverage_csv(murk, "plan", plan["sensors"])

    ledger = murk.read("plan", "ledger.json")
    fits(ledger, kinds.LEDGER, "ledger.json")
    check_ledger(ledger, [10, 6], "ledger.json")
    for name in kinds.COLUMNS[:3]:
        check(min(ledger[name]["bands"]) > 0, "nothing is", name)
    check(ledger["photons_emitted"] == 4000, ledger["photons_emitted"])
    check(ledger["collisions"] > plan["photons"]["volume"], ledger["collisions"])

    traced = murk.run("trace", scene, "-o", murk.path("trace"))
    ledger.pop("run"), traced.pop("run")
    check(traced == ledger, "trace's ledger is not place's")
    with open(murk.path("trace", "light.murk"), "rb") as one, \
            open(murk.path("plan", "light.murk"), "rb") as other:
        check(one.read() == other.read(), "trace's light is not place's")

    result = murk.run("sense", scene, "--sensors", murk.path("plan", "sensors.csv"),
                      "--light", murk.path("plan", "light.murk"), "-o",
                      murk.path("sense"))
    fits(result, kinds.COVERAGE, "coverage.json")
    check(result == murk.read("sense", "coverage.json"),
          "coverage.json is not what was printed")
    check_sensors(result, "coverage.json")
    check_robust(result, "coverage.json")
    check(result["sensors"] == plan["sensors"], "sense sees other sensors")
    check(result["seen_by_at_least"] == plan["seen_by_at_least"], "sense sees else")
    check_coverage_csv(murk, "sense", plan["sensors"])


# ---- tallies ----

SIDES = [(axis, side) for axis in range(3) for side in (0, 1)]


def side_plane(axis, side):
    point, normal = [0, 0, 0], [0, 0, 0]
    point[axis], normal[axis] = side * [4, 4, 3][axis], 2 * side - 1
    return f"  - {{name: side-{axis}{side}, type: plane, point_m: {point}, normal: {normal}}}\n"


TALLIES = OPEN.replace("photons:", "tallies:\n" + "".join(
    side_plane(*side) for side in SIDES) + """\
  - {name: floor, type: plane, point_m: [1, 1, 0.1], normal: [0, 0, -1]}
  - {name: tiles, type: plane, point_m: [1, 1, 0.1], normal: [0, 0, -3], bins: [3, 2], angle_bins: 4}
  - {name: probe, type: sphere, center_m: [1, 1, 1], radius_m: 0.5}
  - {name: halves, type: sphere, center_m: [1, 1, 1], radius_m: 0.5, hemispheres: true}
  - {name: fluence, type: grid, min_m: [0, 0, 0], max_m: [4, 2, 3], size: [8, 2, 6]}
  - {name: one-cell, type: grid, min_m: [0, 0, 0], max_m: [4, 2, 3], size: [1, 1, 1]}
photons:""")
HEADER = "tally,band_nm,bin_i,bin_j,bin_k,direction,value,standard_error,unit"


def read_grid(murk, name, grid):
    """What murk itself finds in a grid of a .vdb."""
    scene = murk.write("grid.yaml", f"""\
murk: 1
domain: {{min_m: [0, 0, 0], max_m: [4, 4, 3]}}
media: {{m: {{vdb: {murk.path("tallies", name)}, grid: {grid}, extinction_per_m: 1, albedo: 1}}}}
regions: [{{medium: m}}]
lights: [{{type: point, position_m: [1, 1, 1], power_w: 1}}]
""")
    found = murk.run("check", scene)
    return found["media"][0]["grid"], found["regions"][0]["bounds"]


def test_tallies(murk):
    scene = murk.write("tallies.yaml", TALLIES)
    asked = {t["name"]: t["cells"] for t in murk.run("check", scene)["tallies"]}
    check(asked["tiles"] == 48 and asked["halves"] == 2 and asked["fluence"] == 96, asked)
    ledger = murk.run("trace", scene, "-o", murk.path("tallies"))
    fits(ledger, kinds.LEDGER, "ledger.json")
    check_ledger(ledger, [10, 6], "ledger.json")
    value, error = {}, {}
    for tally, band, i, j, k, direction, watts, its_error, unit in murk.rows(
            HEADER, "tallies", "tallies.csv"):
        key = tally, float(band), direction, int(i), int(j), int(k)
        check(key not in value, "tallies.csv has twice", key)
        value[key], error[key] = float(watts), float(its_error)
        kind = {"probe": "W/m2", "halves": "W/m2"}.get(tally, "W")
        check(unit == kind and 0 <= error[key] <= 1.001 * value[key] + 1e-30, key, unit)
    check(len(value) == 2 * (7 * 2 + 48 + 1 + 2), "tallies.csv has rows:", len(value))

    def total(tally, band, direction):
        return sum(v for key, v in value.items() if key[:3] == (tally, band, direction))

    for number, band in enumerate((450, 650)):
        out = sum(total(f"side-{axis}{side}", band, "forward") for axis, side in SIDES)
        near(out, ledger["escaped_w"]["bands"][number], 1e-9, "escaped by planes")
        back = sum(total(f"side-{axis}{side}", band, "backward") for axis, side in SIDES)
        check(back == 0, "light from outside", back)
        stays = total("floor", band, "forward") - total("floor", band, "backward")
        near(stays, ledger["absorbed_by_material_w"]["floor"]["bands"][number], 1e-9,
             "the floor keeps")
        for direction in ("forward", "backward"):
            near(total("tiles", band, direction), total("floor", band, direction), 1e-9,
                 "all bins", direction)
        near(total("halves", band, "up") + total("halves", band, "down"),
             total("probe", band, ""), 1e-9, "both hemispheres")
        for kind, account in (("material", "surfaces"), ("medium", "media")):
            near(sum(part["bands"][number]
                     for part in ledger[f"absorbed_by_{kind}_w"].values()),
                 ledger[f"absorbed_{account}_w"]["bands"][number], 1e-9, "by", kind)
        for file in ("", "_error"):
            grid, bounds = read_grid(murk, f"fluence{file}.vdb", f"fluence_{band}nm")
            check(grid["voxel_m"] == [0.5, 1, 0.5], grid["voxel_m"])
            check(bounds == {"min_m": [0, 0, 0], "max_m": [4, 2, 3]}, bounds)
            if not file:
                whole, _ = read_grid(murk, "one-cell.vdb", f"fluence_{band}nm")
                near(grid["sum"] / 96, whole["sum"], 1e-6 * whole["sum"], "mean fluence")
                check(total("probe", band, "") < grid["maximum"], grid)
    check(set(ledger["absorbed_by_material_w"]) == {"default", "floor", "pane"},
          ledger["absorbed_by_material_w"])

    # light from a file is not measured, and tallies do not count for it
    without = murk.write("open.yaml", OPEN)
    again = murk.run("place", scene, "--light", murk.path("tallies", "light.murk"),
                     "-o", murk.path("again"))
    murk.run("place", without, "--light", murk.path("tallies", "light.murk"))
    check(not os.path.exists(murk.path("again", "tallies.csv")), "tallies of a file")
    kept = murk.read("again", "ledger.json")
    kept.pop("run"), ledger.pop("run")
    check(kept == ledger and again["photons"]["emitted"] == 4000, "ledger of a file")


PHOTON_J = 1.98644586e-25 / 1e-9  # hc over a nanometre
# of a watt at 450 and 650 nm: V of the CIE 1924 observer, photons, umol
PER_WATT = {"photometric": ("lm", "lux", "lm", (683 * 0.038, 683 * 0.107)),
            "photons": ("1/s", "1/s/m2", "photons_per_s",
                        (450 / PHOTON_J, 650 / PHOTON_J)),
            "par": ("umol/s", "umol/s/m2", "umol_per_s",
                    (450 / PHOTON_J / 6.02214076e17, 650 / PHOTON_J / 6.02214076e17))}


def test_units(murk):
    """The same light, read otherwise: each row is the radiometric one times what a
    watt of its band is, and the light's file is the same."""
    scene = murk.path("tallies.yaml")
    watts = list(murk.rows(HEADER, "tallies", "tallies.csv"))
    in_watts = murk.read("tallies", "ledger.json")
    for units, (power, irradiance, suffix, factors) in PER_WATT.items():
        ledger = murk.run("trace", scene, "--set", f"units={units}", "-o", murk.path(units))
        rows = list(murk.rows(HEADER, units, "tallies.csv"))
        check(len(rows) == len(watts), "rows of", units)
        for old, new in zip(watts, rows):
            factor = factors[[450, 650].index(float(old[1]))]
            check(old[:6] == new[:6], "row", new)
            check(new[8] == {"W": power, "W/m2": irradiance}[old[8]], "unit", new)
            for column in (6, 7):
                want = float(old[column]) * factor
                near(float(new[column]), want, 2e-5 * want, units, "column", column)
        emitted = ledger.pop(f"emitted_{suffix}")
        near(emitted["total"], sum(emitted["bands"]), 1e-9 * emitted["total"], units)
        for number, factor in enumerate(factors):
            want = in_watts["emitted_w"]["bands"][number] * factor
            near(emitted["bands"][number], want, 2e-6 * want, "emitted,", units)
        check(ledger["emitted_w"] == in_watts["emitted_w"], "watts stay watts")
        murk.run("place", scene, "--set", f"units={units}", "--light",
                 murk.path("tallies", "light.murk"))


# ---- coverage, again ----

def off_by(result, again):
    """The largest difference of any number of the coverage."""
    pairs = [(result["coverage"][name], again[name]) for name in
             ("in_sample", "surface", "volume", "sum_of_views", "standard_error")]
    for name in ("covers", "only_it_covers"):
        pairs += zip([s[name] for s in result["sensors"]], again[name])
    pairs += zip(result["seen_by_at_least"], again["seen_by_at_least"])
    return max(abs(a - b) for a, b in pairs)


def sigmas(one, one_error, other, other_error):
    return abs(one - other) / math.hypot(one_error, other_error)


TABLE = [(0.5, 200), (2, 30), (10, 1.5), (60, 0.02), (120, 0.004), (180, 0.006)]


def mean_cosine(rows):
    """Of the table, by trapezoids of what lies between its rows in logs."""
    first, last = (math.log(rows[i][1]) for i in (0, 1))
    power = (last - first) / math.log(rows[1][0] / rows[0][0])
    rows = [(1e-12, rows[0][1] * (1e-12 / rows[0][0]) ** power)] + rows
    whole = turned = 0
    for (a, p), (b, q) in zip(rows, rows[1:]):
        steps = 5000
        power = math.log(q / p) / math.log(b / a)
        angles = [a * (b / a) ** (i / steps) for i in range(steps + 1)]
        shares = [p * (x / a) ** power * math.sin(math.radians(x)) for x in angles]
        for x, y, f, g in zip(angles, angles[1:], shares, shares[1:]):
            whole += (f + g) * (y - x)
            turned += (f * math.cos(math.radians(x)) + g * math.cos(math.radians(y))) * (y - x)
    return turned / whole


def test_phases(murk):
    """A phase function for each band; light belongs to its table's bytes."""
    def write_table(rows):
        murk.write("turns.csv", "angle_deg,phase_per_sr\n" +
                   "".join(f"{a},{p}\n" for a, p in rows))

    write_table(TABLE)
    scene = murk.write("phases.yaml",
                       OPEN.replace("{hg: 0.7}", "[{two_hg: [0.9, -0.5, 0.75]}, {table: turns.csv}]"))
    medium = murk.run("check", scene)["media"][0]
    check([p["kind"] for p in medium["phase"]] == ["two_hg", "table"], medium)
    near(medium["mean_cosine"][0], 0.55, 1e-12, "mean cosine of two_hg")
    near(medium["mean_cosine"][1], mean_cosine(TABLE), 1e-5, "mean cosine of the table")
    changed = TABLE[:2] + [(10, 1.6)] + TABLE[3:]
    check(abs(mean_cosine(changed) - medium["mean_cosine"][1]) > 1e-3, "no teeth")

    plan = murk.run("place", scene, "-o", murk.path("turned"))
    light = murk.path("turned", "light.murk")
    again = murk.run("place", murk.path("turned", "scene.yaml"), "--light", light)
    check(again["coverage"] == plan["coverage"], "light used again", again["coverage"])
    write_table(changed)
    done = subprocess.run([murk.program, "place", scene, "--light", light],
                          capture_output=True, text=True, timeout=60)
    check(done.returncode == 2 and "checksum" in done.stderr,
          "light of another table:", done.returncode, done.stderr)


def test_coverage(murk):
    scene = murk.write("room.yaml", ROOM)
    plan = murk.run("place", scene, "-o", murk.path("room"))
    plan_file = murk.path("room", "plan.json")
    light = murk.path("room", "light.murk")
    result = murk.run("sense", scene, "--sensors", plan_file, "--light", light)
    found = light_file.sections(light)
    where = [s["position_m"] for s in plan["sensors"]]
    again = light_file.coverage(found, 3000, where, RANGE_M, EXTINCTION_PER_M)
    near(plan["coverage"]["in_sample"], again["in_sample"], 1e-5, "in_sample again")
    near(result["coverage"]["standard_error"] / again["standard_error"], 1, 1e-4,
         "standard error again")
    check(off_by(result, again) <= 1e-5, "coverage again is off by", off_by(result, again))

    # teeth: 2 % more fog
    wrong = light_file.coverage(found, 3000, where, RANGE_M,
                                [1.02 * e for e in EXTINCTION_PER_M])
    check(abs(wrong["in_sample"] - plan["coverage"]["in_sample"]) > 100 * 1e-5,
          "2 % of extinction would go unnoticed:", wrong["in_sample"])
    check(abs(wrong["standard_error"] / result["coverage"]["standard_error"] - 1) > 1e-3,
          "2 % of extinction leaves the error as it is")

    # a 20 times larger map under another seed: independent of both of the plan's
    large = ("sense", scene, "--sensors", plan_file, "--emit", "60000", "--seed", "2")
    truth = murk.run(*large)["coverage"]
    held = (plan["coverage"]["held_out"], plan["coverage"]["held_out_standard_error"])
    off = sigmas(*held, truth["in_sample"], truth["standard_error"])
    check(off <= SIGMA_LIMIT, "held out is", off, "sigma off a large map's")
    denser = murk.run(*large, "--set", "media.fog.extinction_per_m=[0.36, 0.72]")["coverage"]
    off = sigmas(*held, denser["in_sample"], denser["standard_error"])
    check(off > SIGMA_LIMIT, "20 % more fog is only", off, "sigma off")


# Three ways of looking, by angles: this file's own reading of what they mean.
TYPES = ("sensors.types=[{name: node, range_m: 2.2, least_range_m: 0.7}, "
         "{name: cam, range_m: 2.2, view: {hfov_deg: 70, vfov_deg: 40}, arrival: toward}, "
         "{name: cone, range_m: 2.2, view: {cone_deg: 100}, bands: [650]}]")
POSES = [("node", (1, 1, 1), None, None), ("cam", (3.5, 3, 1.5), 240, -10),
         ("cone", (2, 0.5, 2.2), 20, -35)]


def is_ahead(way, heading, tilt, hfov, vfov):
    """In a picture of such angles: turned to look north, then level."""
    h, t = math.radians(heading), math.radians(tilt)
    right = way[0] * math.cos(h) - way[1] * math.sin(h)
    north = way[0] * math.sin(h) + way[1] * math.cos(h)
    ahead = north * math.cos(t) + way[2] * math.sin(t)
    up = way[2] * math.cos(t) - north * math.sin(t)
    return (ahead > 0 and abs(math.degrees(math.atan2(right, ahead))) <= hfov / 2 and
            abs(math.degrees(math.atan2(up, ahead))) <= vfov / 2)


def axis_of(heading, tilt):
    h, t = math.radians(heading), math.radians(tilt)
    return math.sin(h) * math.cos(t), math.cos(h) * math.cos(t), math.sin(t)


def takers(turn=0):
    """What each of POSES takes up, all turned by so many degrees."""
    def node(_, __, way):
        return light_file.dot(way, way) >= 0.7 ** 2

    def cam(_, travel, way):
        heading, tilt = POSES[1][2] + turn, POSES[1][3]
        return (is_ahead(way, heading, tilt, 70, 40) and
                light_file.dot(travel, axis_of(heading, tilt)) < 0)

    def cone(band, _, way):
        length = math.sqrt(light_file.dot(way, way))
        along = light_file.dot(way, axis_of(POSES[2][2] + turn, POSES[2][3])) / length
        return band == 1 and math.degrees(math.acos(max(-1, min(1, along)))) <= 50

    return [node, cam, cone]


def test_views(murk):
    scene = murk.write("views.yaml", ROOM)
    rows = "".join("%s,%g,%g,%g,%s,%s\n" %
                   (name, *at, "" if heading is None else heading, "" if tilt is None else tilt)
                   for name, at, heading, tilt in POSES)
    given = murk.write("views.csv", "type,x_m,y_m,z_m,heading_deg,tilt_deg\n" + rows)
    result = murk.run("sense", scene, "--set", TYPES, "--sensors", given, "-o", murk.path("views"))
    check([(s["heading_deg"], s["tilt_deg"]) for s in result["sensors"]] ==
          [pose[2:] for pose in POSES], result["sensors"])
    found = light_file.sections(murk.path("views", "light.murk"))
    where = [pose[1] for pose in POSES]
    again = light_file.coverage(found, 3000, where, RANGE_M, EXTINCTION_PER_M, takers())
    check(off_by(result, again) <= 1e-5, "views again are off by", off_by(result, again))
    check(min(again["covers"]) > 0.005, "a view of nothing", again["covers"])
    # teeth: turned by a degree, and all of it in view
    for wrong in (takers(1), None):
        other = light_file.coverage(found, 3000, where, RANGE_M, EXTINCTION_PER_M, wrong)
        check(off_by(result, other) > 100 * 1e-5, "would go unnoticed:", off_by(result, other))


# ---- photon by photon ----

def check_path(events, where):
    """One photon's events follow from each other."""
    check([e["number"] for e in events] == list(range(len(events))), where, "numbers")
    check(events[0]["kind"] == "emitted" and
          all(e["kind"] != "emitted" for e in events[1:]), where, "emitted once")
    for before, event in zip(events, events[1:]):
        step = math.dist(before["position_m"], event["position_m"])
        # a step off a surface is far below a micrometre here
        near(event["path_m"], step, 1e-5, where, "path", event["number"])
        check(event["direction_in"] == before["direction_out"], where, "direction")
        near(math.hypot(*event["direction_in"]), 1, 1e-12, where, "unit direction")
    last = events[-1]
    ended = [e for e in events if e["kind"] in ("escaped", "lost") or
             e.get("outcome") == "absorbed"]
    check(ended == [last], where, "must end once, at its end")


def test_replay(murk):
    """40 photons of one lamp and band carry the same power: their ends, counted,
    are the ledger, and their reflections and scatterings the maps."""
    scene = murk.path("open.yaml")
    only = ("--emit", "40", "--set", "bands_nm=[550]",
            "--set", "materials.floor.diffuse=0.6",
            "--set", "media.fog.extinction_per_m=0.5",
            "--set", "media.fog.albedo=0.9", "--set", "lights.0.power_w=10",
            "--set", "lights.0.position_m=[1, 2, 0.8]")
    ledger = murk.run("trace", scene, *only, "-o", murk.path("few"))
    stored = light_file.sections(murk.path("few", "light.murk"))
    ends = dict.fromkeys(kinds.COLUMNS, 0)
    kept = {"surface": 0, "volume": 0}
    collisions = 0
    for photon in range(40):
        replay = murk.run("replay", scene, *only, "--photon", str(photon))
        if photon == 0:
            fits(replay, kinds.REPLAY, "replay")
        events = replay["events"]
        check(replay["photon"] == photon, "replay of", replay["photon"])
        check_path(events, f"photon {photon}")
        collisions += sum(e["kind"] == "medium" for e in events)
        kept["volume"] += sum(e.get("outcome") == "scattered" for e in events)
        kept["surface"] += sum(e.get("outcome") == "reflected" for e in events)
        kind = events[-1]["kind"]
        ends[{"surface": "absorbed_surfaces_w", "medium": "absorbed_media_w",
              "escaped": "escaped_w", "lost": "lost_w"}[kind]] += 1
    for name, photons in ends.items():
        near(ledger[name]["total"], photons * 10 / 40, 1e-9, "replayed", name)
    check(ledger["collisions"] == collisions, "collisions", collisions)
    for name, records in kept.items():
        check(len(stored[name]) == 32 * records, "stored in", name, records)
    check(min(kept.values()) > 5 and len(set(ends.values())) > 2,
          "too few of a kind:", kept, ends)


def main():
    with tempfile.TemporaryDirectory() as folder:
        murk = Murk(os.path.abspath(sys.argv[1]), folder)
        test_files(murk)
        test_tallies(murk)
        test_units(murk)
        test_coverage(murk)
        test_views(murk)
        test_replay(murk)
        test_phases(murk)
        test_jitter(murk)
        test_repeat(murk)
    print("all results are as described" if not failures else f"{failures} failed")
    return failures != 0


if __name__ == "__main__":
    sys.exit(main())
