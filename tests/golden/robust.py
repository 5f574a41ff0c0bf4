#!/usr/bin/env python3
"""How robust plans are said to be, from outside: sensors that stand a little off,
and plans of other seeds. Standard library only.
usage: robust.py MURK
"""

import math
import os
import sys

import result_kinds as kinds
from from_outside import OPEN, check, fits, main, near


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
    separate = [over("mean", "a: {}, " + thick, "--set",
                     f"placement.condition_weights={{{other}: 0}}", *fixed) for other in "ba"]
    near(both["mean"], (separate[0]["mean"] + separate[1]["mean"]) / 2, 1e-12, "mean over two")
    near(worst["mean"], min(a["mean"] for a in separate), 1e-12, "worst of two")
    check(abs(separate[0]["mean"] - separate[1]["mean"]) > 0.1, "no teeth", separate)


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
    of_command = ("repeat", "identity", "files", "run")
    check({k: v for k, v in plan.items() if k not in of_command} ==
          {k: v for k, v in alone[0].items() if k not in of_command}, "repeating changes the plan")
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
        there = murk.run("sense", os.path.join(folder, "scene.resolved.yaml"), "--sensors",
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


if __name__ == "__main__":
    sys.exit(main([test_jitter, test_repeat]))
