#!/usr/bin/env python3
"""Files of AERONET and SeaBASS, through mappings of murk fit, against values
that another reader found (../shared/data/frontier/field). Standard library only.
usage: readings.py MURK
"""

import csv
import math
import pathlib
import subprocess
import sys
import tempfile

DATA = pathlib.Path("../shared/data/frontier/field").resolve()
NM = (340, 380, 440, 500, 675, 870, 1020)
SCENE = """\
murk: 1
bands_nm: [340, 380, 440, 500, 675, 870, 1020]
domain: {min_m: [0, 0, -100], max_m: [9, 9, 9000]}
media: {haze: {extinction_per_m: 1e-5, albedo: 0.9}}
regions: [{medium: haze}]
lights: [{type: point, position_m: [1, 1, 1], power_w: 1}]
"""
AERONET = """\
murk_readings: 1
file: %s
format: aeronet
readings: [{aod_nm: [%s], x_m: 5, y_m: 5, z_m: 0, z2_m: 9000%s}]
"""
SEABASS = """\
murk_readings: 1
file: %s
format: seabass
readings:
  - {kind: extinction, x_m: 5, y_m: 5, z_m: {column: depth, units: m, factor: -1}, standard_error: 1,
     group: {column: time}, value: {column: Wt, units: degreesC}}
  - {kind: extinction, x_m: 5, y_m: 5, z_m: {column: depth, factor: -1}, standard_error: 1, value: {column: sal}}
"""
failures = checks = 0


def check(holds, *what):
    global failures, checks
    checks += 1
    if not holds:
        failures += 1
        print("not so:", *what)


def reference(name):
    with open(DATA / name) as lines:
        return list(csv.DictReader(line for line in lines if line[0] != "#"))


def readings(folder, mapping):
    (folder / "scene.yaml").write_text(SCENE)
    (folder / "map.yaml").write_text(mapping)
    done = subprocess.run([sys.argv[1], "fit", "scene.yaml", "--data", "map.yaml", "-o", "out"], cwd=folder,
                          capture_output=True, text=True)
    check(done.returncode == 0, done.stderr)
    with open(folder / "out/fit.csv") as file:
        return list(csv.DictReader(file)), done.stderr


def aeronet(folder):
    path = DATA / "aeronet_mauna_loa_aod15_first200.txt"
    rows, _ = readings(folder, AERONET % (path, ", ".join(map(str, NM)), ""))
    means, _ = readings(folder, AERONET % (path, ", ".join(map(str, NM)), ", average: true"))
    check(len(rows) == 200 * len(NM) and len(means) == len(NM), len(rows), len(means))
    first = int(rows[0]["line"])
    by_name = {f"AOD_{nm}nm": [float(row["value"]) for row in rows if row["band_nm"] == str(nm)] for nm in NM}
    mean = {f"AOD_{row['band_nm']}nm": float(row["value"]) for row in means}
    compared = 0
    for row in reference("aeronet_first200_reference.csv"):
        values = by_name.get(row["quantity"])
        if not values:
            continue
        compared += 1
        want = float(row["value"])
        if row["what"] == "value":
            # rows of the reference count from 1
            got = [float(r["value"]) for r in rows if int(r["line"]) == first + int(row["row"]) - 1
                   and f"AOD_{r['band_nm']}nm" == row["quantity"]]
            check(got == [want], row, got)
        elif row["what"] == "mean":
            check(math.isclose(mean[row["quantity"]], want, abs_tol=5e-9), row, mean)
        elif row["what"] in ("min", "max"):
            check({"min": min, "max": max}[row["what"]](values) == want, row)
        elif row["what"] == "n":
            check(len(values) == want, row)
    check(compared > 100, "values were compared", compared)
    for row in rows:
        check(float(row["standard_error"]) == (.02 if float(row["band_nm"]) < 440 else .01), row)


def seabass(folder):
    rows, said = readings(folder, SEABASS % (DATA / "bats92_head.sb"))
    want = {row["what"]: row["value"] for row in reference("bats92_head_reference.csv")}
    check(len(rows) == int(want["rows"]), rows)
    check("4 readings are left out" in said, said)  # sal_all is missing
    check(float(rows[2]["z_m"]) == -float(want["depth_row3_m"]), rows[2])
    check(float(rows[3]["value"]) == float(want["Wt_row4_degC"]), rows[3])
    check(rows[0]["group"] == want["time_row1"][11:19] == "16:30:00", rows[0])


if not DATA.is_dir():
    print(f"skipped: {DATA} is not there")
    sys.exit(77)
for case in (aeronet, seabass):
    with tempfile.TemporaryDirectory() as name:
        case(pathlib.Path(name))
print(f"{checks} checks, {failures} not so")
sys.exit(failures > 0)
