#!/usr/bin/env python3
"""murk fit from outside, on the example calibrations with their planted readings
(doc/reference/examples.md): they find what was planted, the files hold what they should,
values agree between them, calibrated.yaml goes back into the scene, and the next
places are among its candidates. Standard library only.
usage: fit.py MURK

Eleven parameters within 4.5 standard errors, a chance of 8e-5 over all; seeds
are fixed, so a verdict repeats.
"""

import csv
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

SIGMA_MAX = 4.5

ROOT = pathlib.Path(__file__).resolve().parents[2]

PLANTED = {
    "fog": {"media.fog.extinction_per_m": .22, "media.fog.phase.hg": .87},
    "smoke": {"media.smoke.extinction_per_m": 3, "media.smoke.albedo": .6},
    "water": {"media.sea.extinction_per_m.0": .12, "media.sea.extinction_per_m.1": .14,
              "media.sea.extinction_per_m.2": .34, "media.sea.albedo.0": .8,
              "media.sea.albedo.1": .75, "media.sea.albedo.2": .3},
    "coverage": {"media.fog.visibility_m": 30},
}

checks = failures = 0


def check(held, *what):
    global checks, failures
    checks += 1
    if not held:
        failures += 1
        print("not so:", *what)


def run(*words):
    done = subprocess.run([sys.argv[1], *map(str, words)], capture_output=True, text=True,
                          cwd=ROOT, timeout=300)
    if done.returncode != 0:
        sys.exit(f"murk {' '.join(map(str, words))}: exit {done.returncode}\n{done.stderr}")
    return done.stdout


def table(path):
    with open(path) as file:
        return list(csv.DictReader(file))


def near(a, b, relative=1e-6):
    return math.isclose(a, b, rel_tol=relative, abs_tol=1e-12)


def check_parameters(name, fit):
    n = len(PLANTED[name])
    check(fit["converged"], name, "did not converge:", fit["why"])
    check([p["key"] for p in fit["parameters"]] == list(PLANTED[name]), name, "keys")
    for i, parameter in enumerate(fit["parameters"]):
        key, value, error = (parameter[k] for k in ("key", "value", "standard_error"))
        sigma = (value - PLANTED[name][key]) / error
        print(f"{name}: {key} = {value:.6g} +- {error:.2g}, planted {PLANTED[name][key]:g}: "
              f"{sigma:+.2f} standard errors")
        check(abs(sigma) <= SIGMA_MAX, name, key, value, error)
        check(error < .15 * value, name, key, "is hardly known:", value, error)
        check(parameter["lower"] < value < parameter["upper"], name, key, parameter)
        check(not parameter["at_bound"], name, key, "is at a bound")
        check(near(fit["covariance"][i][i], error * error), name, key, "covariance")
        for j in range(n):
            check(fit["covariance"][i][j] == fit["covariance"][j][i], name, "symmetry", i, j)
            check(abs(fit["correlation"][i][j]) <= 1 + 1e-12, name, "correlation", i, j)


def check_rows(name, fit, rows, data):
    readings = table(ROOT / data)
    groups = {r.get("group") or line for line, r in enumerate(readings, 2)}
    check(len(rows) == len(groups), name, len(rows), "rows of", len(groups))
    chi2 = 0
    for row in rows:  # of a group, its first line
        reading = readings[int(row["line"]) - 2]
        check(near(float(row["value"]), float(reading["value"])), name, row["line"])
        off = float(row["value"]) - float(row["predicted"])
        error = math.hypot(float(row["standard_error"]), float(row["photon_standard_error"]))
        check(near(float(row["residual_in_standard_errors"]), off / error, 1e-4), name, row)
        chi2 += (off / error) ** 2
    # rows share photons, so chi2 is not that of rows taken one by one
    check(.3 < chi2 / len(rows) < 3, name, "chi2", chi2)
    freedom = fit["degrees_of_freedom"]
    check(abs(fit["chi2"] - freedom) < 5 * math.sqrt(2 * freedom), name, fit["chi2"], freedom)


def calibrate(name, folder, *more):
    scene, data = f"scenes/calibrate-{name}.yaml", f"scenes/calibrate/{name}.csv"
    out = folder / name
    run("fit", scene, "--data", data, "--free", ",".join(PLANTED[name]), "--quiet", "-o", out,
        *more)
    fit = json.loads((out / "fit.json").read_text())
    rows = table(out / "fit.csv")
    check_parameters(name, fit)
    check_rows(name, fit, rows, data)
    return scene, data, out, fit, rows


def check_predicts(folder, case):
    """The same scene at the values that were found predicts nearly the same: by
    other light, as it is traced at these values."""
    scene, data, out, _, rows = case
    again = folder / "again"
    run("fit", scene, "--data", data, "--predict", out / "fit.json", "--quiet", "-o", again)
    for a, b in zip(rows, table(again / "fit.csv")):
        error = math.hypot(float(a["photon_standard_error"]), float(b["photon_standard_error"]))
        off = float(a["predicted"]) - float(b["predicted"])
        check(abs(off) <= SIGMA_MAX * error + 1e-9, "predicted again", a["line"], off, error)
    check(not (again / "fit.json").exists(), "--predict wrote a fit")


def check_is_taken(folder, case):
    """calibrated.yaml by --set: the resolved scene has the values."""
    scene, _, out, fit, _ = case
    run("trace", scene, "--set", f"@{out / 'calibrated.yaml'}", "--emit", 100, "--quiet", "-o",
        folder / "set")
    text = (folder / "set" / "scene.resolved.yaml").read_text()
    for parameter in fit["parameters"]:
        check(f"{parameter['value']:.6g}"[:6] in text, "not in the scene:", parameter)


def check_next(case):
    fit = case[3]
    places = fit["next"]["places"]
    check(len(places) == 2, "next:", places)
    gains = [place["gain"] for place in places]
    check(gains == sorted(gains, reverse=True) and gains[-1] > 0, "gains", gains)
    for was in fit["parameters"]:
        will = fit["next"]["standard_errors_with_all"][was["key"]]
        check(0 < will < was["standard_error"], "next:", was["key"], will)


def check_manual(case):
    """README.md prints what the program prints."""
    fit = case[3]
    text = " ".join((ROOT / "README.md").read_text().split())
    for p in fit["parameters"]:
        line = (f"{p['key']} = {p['value']:.6g} +- {p['standard_error']:.2g} "
                f"(95 %: {p['lower']:.4g} to {p['upper']:.4g})")
        check(line in text, "README.md has no:", line)
    check(f"It took {fit['traces']} traces of light" in text, "README.md: traces, now", fit["traces"])
    chi2 = fit["verdict"].split(" The search")[0]
    check(chi2 in text, "README.md has no:", chi2)


with tempfile.TemporaryDirectory() as made:
    folder = pathlib.Path(made)
    smoke = calibrate("smoke", folder)
    check_predicts(folder, smoke)
    check_is_taken(folder, smoke)
    calibrate("water", folder)
    calibrate("coverage", folder)
    fog = calibrate("fog", folder, "--next", 2)
    check_next(fog)
    check_manual(fog)
print(f"{checks} checks")
sys.exit(1 if failures or not checks else 0)
