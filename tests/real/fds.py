#!/usr/bin/env python3
"""The reader of FDS files against values read by another reader
(../shared/data/frontier/fds): all values of frames bit for bit, optical depths
along lines inside of a mesh, and lines through joined meshes against a sum of
the parts. Standard library only.
usage: fds.py FDS_VALUES MURK
"""

import csv
import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import zipfile

DATA = pathlib.Path("../shared/data/frontier/fds")

values, murk = (pathlib.Path(name).resolve() for name in sys.argv[1:3])
failures = checks = 0


def check(holds, text):
    global failures, checks
    checks += 1
    if not holds:
        failures += 1
        if failures < 20:
            print("not so:", text)


def single(text):
    """A number in single precision, as the files have it."""
    return struct.unpack("<f", struct.pack("<f", float(text)))[0]


def rows(name):
    with open(DATA / "reference" / name) as lines:
        return list(csv.DictReader(line for line in lines if line[0] != "#"))


def ask(folder, questions):
    answer = subprocess.run([values], input="\n".join(questions) + "\n", text=True, cwd=folder, stdout=subprocess.PIPE)
    check(answer.returncode == 0, "all frames are read")
    return [line.split() for line in answer.stdout.splitlines()]


def compare_values(folder, run):
    """Single values, and number, minimum, maximum and sum of the values of frames."""
    table = rows(f"{run}_values.csv")
    asked = [" ".join(row[key] for key in ("file", "frame", "i", "j", "k")) for row in table]
    for row, got in zip(table, ask(folder, asked), strict=True):
        check(single(got[1]) == single(row["value"]) and math.isclose(float(got[0]), float(row["time_s"]), rel_tol=1e-6), f"{row} is {got}")
    table = rows(f"{run}_frames.csv")
    for row, got in zip(table, ask(folder, [f"{row['file']} {row['frame']}" for row in table]), strict=True):
        count = int(row["nx"]) * int(row["ny"]) * int(row["nz"])
        check(int(got[1]) == count and single(got[2]) == single(row["min"]) and single(got[3]) == single(row["max"])
              and math.isclose(float(got[4]), float(row["sum"]), rel_tol=1e-11), f"{row} is {got}")
    return len(table)


SCENE = """murk: 1
bands_nm: [633]
domain: {min_m: [-2, -2, -1], max_m: [2, 2, 3], sides: open}
media:
  smoke: {albedo: 0, fds: %s, time_s: %s, mesh: %s}
regions:
  - {medium: smoke}
lights:
  - {type: point, position_m: [0, 0, 1.9], power_w: 1}
"""


def readings(folder, lines, time_s, mesh="all", unit="optical_depth"):
    """Transmittance along lines (six coordinates each), in a unit."""
    scene, data, out = (folder / name for name in ("scene.yaml", "lines.csv", "out"))
    scene.write_text(SCENE % (folder / "hfg_slice.smv", time_s, mesh))
    with open(data, "w") as to:
        print("kind,x_m,y_m,z_m,x2_m,y2_m,z2_m,unit,value,standard_error", file=to)
        for line in lines:
            print("transmittance," + ",".join(repr(x) for x in line) + f",{unit},.5,.1", file=to)
    done = subprocess.run([murk, "fit", scene, "--data", data, "-o", out, "--force", "--quiet"])
    check(done.returncode == 0, "lines are predicted")
    with open(out / "fit.csv") as table:
        return [float(row["predicted"]) for row in csv.DictReader(table)]


def compare_depths(folder):
    table = rows("hfg_slice_sightline_tau.csv")
    largest = 0
    for mesh, time_s in sorted({(row["mesh"], row["time_s"]) for row in table}):
        own = [row for row in table if (row["mesh"], row["time_s"]) == (mesh, time_s)]
        lines = [[float(row[key]) for key in ("x0", "y0", "z0", "x1", "y1", "z1")] for row in own]
        for chosen in ("all", f"[{mesh}]"):
            for row, got in zip(own, readings(folder, lines, time_s, chosen), strict=True):
                want = float(row["tau"])
                largest = max(largest, abs(got - want) / max(want, 1e-3))
                check(abs(got - want) <= 1e-6 * max(want, 1e-3), f"{row} is {got}")
        # a beam detector of FDS: total obscuration, from the same cells
        for row, got in zip(own, readings(folder, lines, time_s, f"[{mesh}]", "obscuration_percent"), strict=True):
            want = 100 * (1 - math.exp(-float(row["tau"])))
            check(abs(got - want) <= 1e-5 * max(want, .1), f"{row} is obscured by {got}, FDS has {want}")
    return len(table), largest


def compare_joined(folder):
    """Lines through several meshes are the sums of their parts in each mesh."""
    lines = []
    for i in range(100):
        turn, height = 2.4 * i, .2 + .016 * i
        lines.append([-.95 + .01 * (i % 7), .9 * math.cos(turn), height, .95, .9 * math.sin(turn), height + .1])
    whole = readings(folder, lines, 6.45626)
    sums = [0.0] * len(lines)
    for mesh in (1, 2, 3, 4):
        for i, tau in enumerate(readings(folder, lines, 6.45626, [mesh])):
            sums[i] += tau
    for line, a, b in zip(lines, whole, sums, strict=True):
        check(abs(a - b) <= 1e-6 * max(b, 1e-3), f"{line}: {a}, the parts have {b}")
    check(sum(tau > .05 for tau in whole) > 20, "some lines meet smoke")


if not DATA.is_dir():
    print(f"skipped: {DATA} is not there")
    sys.exit(77)
with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    for run in ("hfg_slice", "stretched_mesh"):
        archive = DATA / (run + ("_example.zip" if run == "stretched_mesh" else ".zip"))
        with zipfile.ZipFile(archive) as files:
            files.extractall(folder)
        check(compare_values(folder, run) > 10, f"frames of {run}")
    count, largest = compare_depths(folder)
    check(count > 10, "there are lines")
    compare_joined(folder)
print(f"{checks} checks, {failures} not so; optical depths within {largest:.2g}")
sys.exit(failures > 0)
