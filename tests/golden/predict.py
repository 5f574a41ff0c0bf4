#!/usr/bin/env python3
"""murk fit without --free: readings are predicted at the values of the scene.
Rows are in the order of the file whatever their conditions and groups,
extinction and transmittance equal their formulas to rounding, and numbers read
back as the double that they were. Standard library only.
usage: predict.py MURK
"""

import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

SCENE = """\
murk: 1
bands_nm: [450, 550]
domain: {min_m: [0, 0, 0], max_m: [8, 4, 4]}
media:
  layer: {profile: {z_m: [0, 2, 4], extinction_per_m: [0.3, 0.1, 0.1]}, albedo: 0.8, phase: {hg: 0.5}}
  smoke: {extinction_per_m: [0.7, 0.2], albedo: 0.4, phase: isotropic}
regions: [{medium: layer}, {medium: smoke, box: {min_m: [4, 0, 0], max_m: [8, 4, 4]}}]
lights: [{type: point, position_m: [2, 2, 3], power_w: 10}]
photons: {emit: 2000}
sensors: {types: [{name: node, range_m: 4}], count: 1}
conditions:
  thick: {media.smoke.extinction_per_m: [1.4, 0.4]}
  none: {media.smoke.extinction_per_m: 0}
"""
COLUMNS = "kind condition x_m y_m z_m x2_m y2_m z2_m radius_m band_nm group gain unit value standard_error".split()
failures = 0


def check(holds, *what):
    global failures
    if not holds:
        failures += 1
        print("not so:", *what)


def point(condition, x, z, band, unit, want):
    return {"kind": "extinction", "condition": condition, "x_m": x, "y_m": 1, "z_m": z, "band_nm": band,
            "unit": unit, "value": 1, "standard_error": .1}, want


def beam(condition, x, x2, unit, depth, want):
    """Along x at a height of 2 m, where the layer has .1 / m."""
    row = {"kind": "transmittance", "condition": condition, "x_m": x, "y_m": 1, "z_m": 2, "x2_m": x2, "y2_m": 1,
           "z2_m": 2, "band_nm": 450, "unit": unit, "value": 1, "standard_error": .1}
    return row, want(math.exp(-depth))


def coverage(condition, group, x):
    return {"kind": "coverage", "condition": condition, "x_m": x, "y_m": 1, "z_m": 1, "group": group, "value": .5,
            "standard_error": .1}, None


ROWS = [
    point("thick", 5, 1, 450, "", .2 + 1.4),
    coverage("thick", "b", 1),
    beam("", 1, 7, "obscuration_percent", 6 * .1 + 3 * .7, lambda t: 100 * (1 - t)),
    point("", 5, 1, "", "1/m", .2 + .45),
    coverage("", "b", 1),
    point("none", 5, 3, 550, "visibility_m", 3.912 / .1),
    beam("thick", 1, 7, "optical_depth", 6 * .1 + 3 * 1.4, lambda t: -math.log(t)),
    coverage("thick", "b", 6),  # of the second row
    point("", 1, 1, 550, "db_per_km", 200 * 10 / math.log(10)),
    coverage("", "a", 2),
    point("", 5, 3, 450, "mor_m", 2.996 / .8),
    beam("none", 1, 7, "percent", .6, lambda t: 100 * t),
    point("", 5, 3, 550, "", .1 + .2),  # 0.30000000000000004, which needs all 17 digits
]


class Folder:
    def __init__(self, name):
        self.path = pathlib.Path(name)
        (self.path / "scene.yaml").write_text(SCENE)

    def write(self, name, rows):
        with open(self.path / name, "w") as file:
            out = csv.DictWriter(file, COLUMNS, restval="")
            out.writeheader()
            out.writerows(rows)

    def murk(self, *words):
        return subprocess.run([sys.argv[1], "fit", "scene.yaml", *words], cwd=self.path, capture_output=True, text=True)

    def predict(self, data, out, *words):
        done = self.murk("--data", data, "-o", out, *words)
        check(done.returncode == 0, done.stderr)
        check(sorted(p.name for p in (self.path / out).iterdir()) == ["fit.csv", "predict.json", "scene.resolved.yaml"],
              "files")
        with open(self.path / out / "fit.csv") as file:
            return list(csv.DictReader(file)), done.stdout

    def refused(self, part, *words):
        done = self.murk(*words)
        lines = [line for line in done.stderr.splitlines() if "note: " not in line]
        check(done.returncode == 2 and len(lines) == 1 and part in lines[0], words, done.stderr)


def order_and_values(folder):
    folder.write("data.csv", [row for row, _ in ROWS])
    got, printed = folder.predict("data.csv", "out")
    check("predicted   12 rows" in printed, printed)
    lines = [2 + i for i in range(len(ROWS)) if i != 7]
    check([int(row["line"]) for row in got] == lines, "order", [row["line"] for row in got])
    for row in got:
        given, want = ROWS[int(row["line"]) - 2]
        check((row["kind"], row["condition"]) == (given["kind"], given["condition"]), row)
        if want is not None:
            value = float(row["predicted"])
            check(abs(value - want) <= 1e-14 * want, row, value, want)
            check(float(row["photon_standard_error"]) == 0, row)
            check(abs(float(row["residual_in_standard_errors"]) - (1 - want) / .1) < 1e-9 * want, row)
    check(float(got[-1]["predicted"]) == .1 + .2, "all digits", got[-1])
    result = json.loads((folder.path / "out/predict.json").read_text())
    check(result["parameters"] == [] and result["data"]["rows"] == 12, result)
    return got


def as_by_values(folder, got):
    """Values of a finished fit that are those of the scene predict the same. Sightlines store
    the media that keys weigh in single precision."""
    key = "media.layer.albedo"
    (folder.path / "values.json").write_text(json.dumps({"parameters": [{"key": key, "value": .8}]}))
    again, _ = folder.predict("data.csv", "again", "--predict", "values.json")
    for a, b in zip(again, got, strict=True):
        check(abs(float(a["predicted"]) / float(b["predicted"]) - 1) < (1e-7 if a["kind"] == "coverage" else 1e-15), a, b)


def extinction_is_fitted(folder):
    """Planted values come back, and beams and points agree."""
    rows = [point("", 5, z, band, unit, want) for z, band, unit, want in (
        (1, 450, "", .2 + .9), (3, 450, "visibility_m", 3.912 / 1), (1, 550, "db_per_km", 500 * 10 / math.log(10)))]
    folder.write("points.csv", [{**row, "value": want, "standard_error": .01 * want} for row, want in rows])
    done = folder.murk("--data", "points.csv", "--free", "media.smoke.extinction_per_m.0,media.smoke.extinction_per_m.1",
                       "-o", "fitted")
    check(done.returncode == 0, done.stderr)
    found = json.loads((folder.path / "fitted/fit.json").read_text())["parameters"]
    for parameter, want in zip(found, (.9, .3), strict=True):
        check(abs(parameter["value"] - want) < 1e-6 and parameter["standard_error"] > 0, parameter)


def refusals(folder):
    folder.write("outside.csv", [point("", 9, 1, "", "", 0)[0]])
    folder.refused("outside.csv:2: x_m: the place [9, 1, 1] m is outside the domain", "--data", "outside.csv")
    folder.write("unit.csv", [point("", 5, 1, "", "fraction", 0)[0]])
    folder.refused("unit.csv:2: unit: fraction is no unit of such a reading", "--data", "unit.csv")
    folder.write("end.csv", [{**point("", 5, 1, "", "", 0)[0], "x2_m": 1}])
    folder.refused("end.csv:2: x2_m: 1, but a reading of extinction has none", "--data", "end.csv")
    for option in ("--loss", "--starts", "--traces", "--next"):
        value = "huber" if option == "--loss" else "2"
        folder.refused(f"{option}: is of a search", "--data", "data.csv", option, value)
    folder.refused("is no free key", "--data", "data.csv", "--bounds", "media.layer.albedo=.1:.9")
    folder.refused("a prediction has none", "--data", "data.csv", "--shard", "1/2", "-o", "part")


def mapping(folder):
    """Another file of measurements is another identity, with the same mapping."""
    (folder.path / "map.yaml").write_text("murk_readings: 1\nfile: log.csv\nreadings: [{kind: extinction, x_m: 5, y_m: 1, "
                                          "z_m: {column: cm, factor: 0.01}, value: {column: k}, standard_error: .1}]\n")
    identities = set()
    for height in (100, 100, 300):
        (folder.path / "log.csv").write_text(f"cm,k\n{height},1\n")
        got, _ = folder.predict("map.yaml", "mapped")
        check(math.isclose(float(got[0]["predicted"]), .45 + (.2 if height == 100 else .1), rel_tol=1e-14), got)
        identities.add(json.loads((folder.path / "mapped/predict.json").read_text())["identity"])
    check(len(identities) == 2, identities)
    before = (folder.path / "log.csv").read_bytes()
    (folder.path / "fit.csv").write_bytes(before)
    (folder.path / "own.yaml").write_text((folder.path / "map.yaml").read_text().replace("log.csv", "fit.csv"))
    folder.refused("fit.csv", "--data", "own.yaml", "-o", ".", "--force")
    check((folder.path / "fit.csv").read_bytes() == before, "the file of measurements is as it was")


with tempfile.TemporaryDirectory() as name:
    folder = Folder(name)
    as_by_values(folder, order_and_values(folder))
    extinction_is_fitted(folder)
    refusals(folder)
    mapping(folder)
sys.exit(failures > 0)
