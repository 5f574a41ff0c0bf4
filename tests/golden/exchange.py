"""What murk place writes for other programs, read by others.

usage: exchange.py files MURK   matrix.csv, matrix.txt, candidates.csv
       exchange.py cbc MURK     problem.lp, solved by cbc (Debian coinor-cbc);
                                skipped where it is missing
"""

import csv
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

SCENE = """
murk: 1
domain: {min_m: [0, 0, 0], max_m: [8, 6, 3]}
geometry:
  - {box: {min_m: [0.1, 0.1, 0.1], max_m: [7.9, 5.9, 2.9]}}
  - {box: {min_m: [3, 0.2, 0.2], max_m: [3.4, 4, 2.8]}}
media: {fog: {extinction_per_m: EXTINCTION, albedo: 0.9}}
regions: [{medium: fog}]
lights:
  - {type: point, position_m: [1.5, 2, 2.5], power_w: 10}
  - {type: point, position_m: [6, 3, 2.5], power_w: 7}
photons: {store: 400}
sensors:
  types: [{name: node, range_m: 3}]
  candidates: {grid: {min_m: [0.6, 0.6, 0.6], max_m: [7.4, 5.4, 2.4], size: [7, 5, 2]}}
  count: 3
"""


class Failed(Exception):
    pass


def check(holds, *words):
    if not holds:
        raise Failed(" ".join(str(word) for word in words))


def is_near(a, b, relative):
    return math.isclose(a, b, rel_tol=relative, abs_tol=0)


class Murk:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def run(self, *arguments, code=0):
        done = subprocess.run([self.program, *arguments], capture_output=True, text=True)
        check(done.returncode == code, arguments, "ends with", done.returncode, done.stderr)
        return done

    def scene(self, extinction):
        path = self.path("scene-%g.yaml" % extinction)
        with open(path, "w") as file:
            file.write(SCENE.replace("EXTINCTION", str(extinction)))
        return path

    def place(self, name, *arguments, code=0):
        """The plan, and what was said on standard error."""
        folder = self.path(name)
        done = self.run("place", *arguments, "-q", "-o", folder, code=code)
        with open(os.path.join(folder, "plan.json")) as file:
            return json.load(file), done.stderr


# ---- the matrix ----

def places(murk, name, plan):
    """Where a plan over matrix columns puts its sensors."""
    with open(murk.path(name, "candidates.csv"), newline="") as file:
        at = {int(row["column"]): [float(row[k]) for k in ("x_m", "y_m", "z_m")]
              for row in csv.DictReader(file)}
    return [at[sensor["column"]] for sensor in plan["sensors"]]


def check_same_plan(murk, name, plan, again):
    have, want = places(murk, name, again), [s["position_m"] for s in plan["sensors"]]
    check(len(have) == len(want) and
          all(math.dist(a, b) < 1e-12 for a, b in zip(have, want)),
          "another plan over the matrix:", again["sensors"], plan["sensors"])
    for key in ("in_sample", "ceiling", "sum_of_views"):
        check(is_near(plan["coverage"][key], again["coverage"][key], 1e-12),
              key, plan["coverage"], again["coverage"])
    check(is_near(plan["bound"]["upper"], again["bound"]["upper"], 1e-12), "upper")
    for key in ("covers", "only_it_covers"):
        for one, two in zip(plan["sensors"], again["sensors"]):
            check(math.isclose(one[key], two[key], abs_tol=1e-12), key, one, two)


def test_the_matrix_gives_the_same_plan(murk):
    clear = murk.scene(0)
    plan, _ = murk.place("clear", clear, "--export", "or-library,matrix")
    for file in ("matrix.csv", "matrix.txt"):
        again, _ = murk.place("again", "--matrix", murk.path("clear", file), "--count", "3")
        check_same_plan(murk, "clear", plan, again)
    two, _ = murk.place("two", "--matrix", murk.path("clear", "matrix.csv"), "--count", "2")
    check(two["coverage"]["in_sample"] < plan["coverage"]["in_sample"], "two as good as three")

    plan, _ = murk.place("fog", murk.scene(0.4), "--export", "matrix")
    again, _ = murk.place("again", "--matrix", murk.path("fog", "matrix.csv"), "--count", "3")
    check_same_plan(murk, "fog", plan, again)
    check(not os.path.exists(murk.path("fog", "matrix.txt")), "a file that nobody asked for")

    worth = {plan["coverage"]["in_sample"]}
    for mode in ("placement.redundancy=2", "placement.detection=independent"):
        plan, _ = murk.place("mode", murk.scene(0.4), "--set", mode, "--export", "matrix")
        again, _ = murk.place("again", "--matrix", murk.path("mode", "matrix.csv"), "--count", "3",
                              "--set", mode)
        check_same_plan(murk, "mode", plan, again)
        for key in ("detection", "redundancy"):
            check(plan["placement"][key] == again["placement"][key], mode, key)
        worth.add(plan["coverage"]["in_sample"])
    check(len(worth) == 3, "modes that change nothing:", worth)


def test_what_cannot_be_written_costs_no_plan(murk):
    plan, said = murk.place("dim", murk.scene(0.4), "--export", "or-library,lp", code=1)
    check("matrix.txt: OR-Library's text holds 0 and 1 only" in said, said)
    check(said.count("\n") == 1, said)
    check(len(plan["sensors"]) == 3, plan["sensors"])
    check(os.path.exists(murk.path("dim", "problem.lp")), "no problem.lp")
    left = [n for n in os.listdir(murk.path("dim")) if "staged" in n or n == "matrix.txt"]
    check(not left, left)


# ---- cbc ----

def solve(path):
    """The optimum that cbc proves."""
    done = subprocess.run(["cbc", path, "solve"], capture_output=True, text=True)
    check("Optimal solution found" in done.stdout, path, done.stdout[-2000:])
    return float(re.search(r"^Objective value: +(\S+)$", done.stdout, re.MULTILINE).group(1))


def test_cbc_agrees(murk):
    for extinction in (0, 0.4):
        scene = murk.scene(extinction)
        plan, _ = murk.place("lp", scene, "--export", "lp,matrix")
        check(plan["bound"]["proven_optimal"], "not proven")
        again, _ = murk.place("again", "--matrix", murk.path("lp", "matrix.csv"),
                              "--count", "3", "--export", "lp")
        for name in ("lp", "again"):
            best = solve(murk.path(name, "problem.lp"))
            check(is_near(best, again["matrix"]["covered"], 1e-6), extinction, name,
                  "cbc covers", best, "murk", again["matrix"])
        # one sensor less is another problem
        fewer, _ = murk.place("fewer", scene, "--count", "2", "--export", "lp")
        check(solve(murk.path("fewer", "problem.lp")) < best * 0.999, "two cover as much")
        # the fewest for what three cover, and for a little more
        share = plan["coverage"]["in_sample"]
        for target, count in ((share, 3), (share + 1e-4, 4)):
            plan, _ = murk.place("target", scene, "--target", repr(target), "--export", "lp")
            check(len(plan["sensors"]) == count and plan["target"]["fewest_possible"] == count,
                  target, len(plan["sensors"]), plan["target"])
            check(round(solve(murk.path("target", "problem.lp"))) == count, "cbc takes another count")


TYPES = ("sensors.types=[{name: node, range_m: 2, cost: 1, max_count: 2}, "
         "{name: cam, range_m: 5, cost: 2.5, view: {cone_deg: 100}, headings: 4, "
         "least_count: 1}]")


def whole_weight(path):
    """That of all rows, from the file's first line."""
    with open(path) as file:
        return float(re.search(r"rows of weight (\S+),", file.readline()).group(1))


def test_cbc_agrees_under_rules(murk):
    rules = {
        "budget": ["--budget", "3.5"],
        "counts": ["--count", "5"],
        "one a site": ["--count", "5", "--set", "sensors.one_per_site=true"],
        "spacing": ["--count", "4", "--set", "sensors.candidates.spacing_m=3.1"],
        "redundancy": ["--count", "4", "--set", "placement.redundancy=2"],
        "threshold": ["--count", "2", "--set",
                      "placement={redundancy: 2, detection: threshold, threshold: 0.6}"],
        "fixed": ["--budget", "5", "--set", "sensors.fixed=[{type: node, position_m: [1, 1, 1]}]"],
    }
    seen = set()
    for name, asked in rules.items():
        plan, _ = murk.place("rules", murk.scene(0.4), "--store", "80", "--set", TYPES, "--set",
                             "sensors.candidates.grid.size=[4, 3, 1]", *asked, "--export", "lp")
        check(plan["bound"]["proven_optimal"], name, "not proven", plan["bound"])
        problem = murk.path("rules", "problem.lp")
        best = solve(problem) / whole_weight(problem)
        check(is_near(best, plan["coverage"]["in_sample"], 1e-6), name, "cbc covers", best,
              "murk", plan["coverage"])
        seen.add(round(best, 9))
        if "budget" in plan:
            check(plan["budget"]["spent"] <= plan["budget"]["asked"], plan["budget"])
    check(len(seen) == len(rules), "rules that change nothing:", seen)


def test_cbc_agrees_on_costs(murk):
    """OR-Library's costs as a budget."""
    path = murk.path("costs.txt")
    columns = [(3, (1, 2, 3, 4)), (1, (1, 2)), (1, (3, 5)), (2, (4, 5, 6)), (1.5, (6, 7))]
    with open(path, "w") as file:
        file.write("7 5\n%s\n" % " ".join(str(cost) for cost, _ in columns))
        for row in range(1, 8):
            by = [j + 1 for j, (_, rows) in enumerate(columns) if row in rows]
            file.write("%d\n%s\n" % (len(by), " ".join(map(str, by))))
    for budget, covered in (("1", 2), ("2", 4), ("3.5", 6), ("5", 6), ("5.5", 7)):
        plan, _ = murk.place("costs", "--matrix", path, "--budget", budget, "--export", "lp")
        check(plan["matrix"]["covered"] == covered, budget, plan["matrix"])
        check(plan["budget"]["spent"] <= float(budget), plan["budget"])
        check(is_near(solve(murk.path("costs", "problem.lp")), covered, 1e-9), budget)


def main():
    what, program = sys.argv[1:3]
    if what == "cbc" and not shutil.which("cbc"):
        print("skipped: no cbc (Debian coinor-cbc)")
        return 77
    tests = {"files": (test_the_matrix_gives_the_same_plan,
                       test_what_cannot_be_written_costs_no_plan),
             "cbc": (test_cbc_agrees, test_cbc_agrees_under_rules,
                     test_cbc_agrees_on_costs)}[what]
    for test in tests:
        with tempfile.TemporaryDirectory() as folder:
            try:
                test(Murk(program, folder))
            except Failed as failed:
                print("%s: %s" % (test.__name__, failed))
                return 1
    print("others read what murk writes")
    return 0


if __name__ == "__main__":
    sys.exit(main())
