"""For tests of murk from outside: two scenes, what runs the program and reads
its results, and how tests say what is wrong. Standard library only.
"""

import csv
import json
import math
import os
import subprocess
import sys
import tempfile

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


def sigmas(one, one_error, other, other_error):
    return abs(one - other) / math.hypot(one_error, other_error)


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

    def call(self, *words):
        """A finished run, with what it printed."""
        done = subprocess.run([self.program, *words], capture_output=True, text=True, timeout=60)
        check(done.returncode == 0, words, "ends with", done.returncode, done.stderr)
        return done

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


# ---- what holds between numbers ----

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
    remaining = [w["held_out" if held else "in_sample"] for w in drop["without"]]
    have = result["coverage"]["held_out"] if held else total
    near(drop["worst_loss"], have - min(remaining), 1e-12, where, "worst loss")
    near(drop["mean_loss"], have - sum(remaining) / len(remaining), 1e-12, where, "mean loss")
    check(remaining[drop["worst_sensor"] - 1] == min(remaining), where, drop)

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


def main(tests):
    """Runs the tests, each on a Murk; the exit status."""
    with tempfile.TemporaryDirectory() as folder:
        murk = Murk(os.path.abspath(sys.argv[1]), folder)
        for test in tests:
            test(murk)
    print("all is as described" if not failures else f"{failures} failed")
    return failures != 0
