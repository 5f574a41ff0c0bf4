#!/usr/bin/env python3
"""Plans over conditions from outside: coverage in each condition computed again
in plain Python from its light.murk; mean, worst and regret from these; what
each condition's own files give. Standard library only.
usage: conditions.py MURK
"""

import math
import os
import sys
import tempfile

import light_file
import result_kinds as kinds
import from_outside
from from_outside import EXTINCTION_PER_M, RANGE_M, ROOM, check, near

PHOTONS = 3000  # of ROOM
THICK = [0.9, 1.4]

SCENE = ROOM + f"""\
conditions:
  as-it-is: {{}}
  thick: {{media.fog.extinction_per_m: {THICK}}}
  dim: {{'lights.0': {{type: point, position_m: [0.5, 0.5, 0.5], power_w: [1, 1]}}}}
placement: {{condition_weights: {{thick: 2}}}}
"""
EXTINCTION = {"as-it-is": EXTINCTION_PER_M, "thick": THICK, "dim": EXTINCTION_PER_M}
WEIGHT = {"as-it-is": 1, "thick": 2, "dim": 1}
NAMES = list(EXTINCTION)

CONDITION = {
    "name": kinds.one_of(*NAMES), "weight": kinds.number(0),
    "photons": {"emitted": kinds.count, "surface": kinds.count, "volume": kinds.count},
    "in_sample": kinds.fraction, "in_sample_standard_error": kinds.number(0),
    "held_out": kinds.fraction, "held_out_standard_error": kinds.number(0),
}
ROW = {
    "made_for": kinds.one_of("mean", "worst", *NAMES), "positions_m": (kinds.point,),
    "coverage": [kinds.fraction] * 3, "standard_error": [kinds.number(0)] * 3,
    "regret": [kinds.number(-1, 1)] * 3, "mean": kinds.fraction, "worst": kinds.fraction,
}


def mean_of(values):
    return sum(WEIGHT[n] * v for n, v in zip(NAMES, values)) / sum(WEIGHT.values())


def check_regret(murk, folder, plan):
    table = plan["regret"]
    from_outside.fits(table, {"held_out": kinds.flag, "plans": [ROW] * 5}, "regret")
    own = {row["made_for"]: row["coverage"][i] for i, row in enumerate(table["plans"][:3])}
    check(list(own) == NAMES, "plans made for", list(own))
    for row in table["plans"]:
        for name, coverage, regret in zip(NAMES, row["coverage"], row["regret"]):
            near(regret, own[name] - coverage, 1e-12, row["made_for"], "regret in", name)
        near(row["mean"], mean_of(row["coverage"]), 1e-12, row["made_for"], "mean")
        check(row["worst"] == min(row["coverage"]), row["made_for"], "worst", row["worst"])
    rows = murk.rows("made_for,used_in,in_sample,in_sample_standard_error,held_out,"
                     "held_out_standard_error,regret", folder, "regret.csv")
    check([r[:2] for r in rows] == [[row["made_for"], name] for row in table["plans"]
                                    for name in NAMES], "rows of regret.csv")
    flat = [v for row in table["plans"] for v in row["coverage"]]
    for line, coverage in zip(rows, flat):
        near(float(line[4]), coverage, 1e-8, "regret.csv", line)
    return rows


def check_conditions(murk, folder, scene, plan):
    where = [s["position_m"] for s in plan["sensors"]]
    check([c["name"] for c in plan["conditions"]] == NAMES, "conditions' names")
    for condition in plan["conditions"]:
        name = condition["name"]
        from_outside.fits(condition, CONDITION, name)
        check(condition["weight"] == WEIGHT[name], name, "weighs", condition["weight"])
        light = murk.path(folder, f"light-{name}.murk")
        again = light_file.coverage(light_file.sections(light), PHOTONS, where, RANGE_M,
                                    EXTINCTION[name])
        near(condition["in_sample"], again["in_sample"], 1e-5, name, "in sample")
        near(condition["in_sample_standard_error"] / again["standard_error"], 1, 1e-4, name,
             "error")
        off = from_outside.sigmas(condition["held_out"], condition["held_out_standard_error"],
                             condition["in_sample"], condition["in_sample_standard_error"])
        check(off <= from_outside.SIGMA_LIMIT, name, "held out is", off, "sigma off")
        # its own scene file is a scene, with just that light
        sensed = murk.run("sense", murk.path(folder, f"scene-{name}.yaml"), "--light", light,
                          "--sensors", murk.path(folder, "sensors.csv"))
        check(sensed["coverage"]["in_sample"] == condition["in_sample"], name, "sensed")
        ledger = murk.read(folder, f"ledger-{name}.json")
        check(ledger["photons_emitted"] == condition["photons"]["emitted"], name, "ledger")
        check(os.path.exists(murk.path(folder, f"plan-{name}.ply")), name, "has no plan.ply")
    check(len({c["in_sample"] for c in plan["conditions"]}) == 3, "conditions are alike")


def check_sums(plan, over):
    inside = [c["in_sample"] for c in plan["conditions"]]
    held = [c["held_out"] for c in plan["conditions"]]
    errors = [c["held_out_standard_error"] for c in plan["conditions"]]
    worst = NAMES[inside.index(min(inside))]
    check(plan["over"] == over and plan["worst_condition"] == worst, "worst is", worst)
    coverage, bound = plan["coverage"], plan["bound"]
    # whole-number weights of the joint problem are rounded, each by 2^-20 of a
    # mean photon at most; what is printed of it comes from it alone
    rounding = 2.0 ** -20
    check(bound["upper"] >= coverage["in_sample"], "upper", bound["upper"])
    check(plan["curve"][-1]["coverage"] == coverage["in_sample"], "end of the curve")
    check(plan["curve"][-1]["upper"] == bound["upper"], "end of the curve's bounds")
    for point in plan["curve"]:
        check(point["upper"] >= point["coverage"], "upper of", point["count"])
    near(bound["gap"], 1 - coverage["in_sample"] / bound["upper"], 1e-12, "gap")
    if over == "mean":
        near(coverage["in_sample"], mean_of(inside), rounding, "mean in sample")
        near(coverage["held_out"], mean_of(held), 1e-12, "mean held out")
        share = [WEIGHT[n] / sum(WEIGHT.values()) for n in NAMES]
        near(coverage["held_out_standard_error"],
             math.sqrt(sum((s * e) ** 2 for s, e in zip(share, errors))), 1e-12, "mean's error")
    else:
        near(coverage["in_sample"], min(inside), rounding, "least in sample")
        check(coverage["held_out"] == min(held), "least held out")
        check(bound["guarantee"] == "none", "guarantee", bound["guarantee"])


def main(program):
    with tempfile.TemporaryDirectory() as folder:
        murk = from_outside.Murk(program, folder)
        scene = murk.write("room.yaml", SCENE)
        plans, tables = {}, {}
        for over in ("mean", "worst"):
            plan = murk.run("place", scene, "--set", f"placement.over={over}", "-o",
                            murk.path(over))
            from_outside.fits(plan, kinds.PLAN, over)
            if over == "mean":  # of one condition, a map may be empty
                from_outside.check_sensors(plan, over)
            check_conditions(murk, over, scene, plan)
            check_sums(plan, over)
            tables[over] = check_regret(murk, over, plan)
            plans[over] = plan
        # one table, but for branch and bound, which small problems end anyway
        check(tables["mean"] == tables["worst"], "the tables of mean and worst differ")
        rows = plans["mean"]["regret"]["plans"]
        check(rows[3]["made_for"] == "mean" and rows[4]["made_for"] == "worst", "last plans")
        inside = {over: [c["in_sample"] for c in plans[over]["conditions"]] for over in plans}
        check(min(inside["worst"]) >= min(inside["mean"]) - 1e-12, "worst is not better at worst")
        check(mean_of(inside["mean"]) >= mean_of(inside["worst"]) - 1e-5, "nor mean in the mean")
        # the scene's own resolved file leads to the same plan
        again = murk.run("place", murk.path("worst", "scene.resolved.yaml"))
        check(again["sensors"] == plans["worst"]["sensors"], "the resolved scene leads elsewhere")
    print("all conditions are as described" if not from_outside.failures
          else f"{from_outside.failures} failed")
    return from_outside.failures != 0


if __name__ == "__main__":
    sys.exit(main(os.path.abspath(sys.argv[1])))
