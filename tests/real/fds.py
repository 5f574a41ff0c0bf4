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

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from sightlines import check, finish, predicted  # noqa: E402

DATA = pathlib.Path("../shared/data/frontier/fds")

values, murk = (pathlib.Path(name).resolve() for name in sys.argv[1:3])


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
    got = predicted(murk, folder, SCENE % (folder / "hfg_slice.smv", time_s, mesh), lines, unit)
    check(not isinstance(got, str), got)
    return got


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


def read_bytes(path, frame):
    """The bytes of a frame of a .s3d file, decoded here, with the numbers of nodes along x, y and z."""
    data = path.read_bytes()
    _, _, x0, x1, y0, y1, z0, z1 = struct.unpack_from("<8i", data, 4)
    at = 40
    for number in range(frame + 1):
        coded = struct.unpack_from("<2i", data, at + 16)[1]
        start = at + 12 + 16 + 4
        if number == frame:
            code, out, k = data[start:start + coded], bytearray(), 0
            while k < len(code):
                out += bytes([code[k + 1]]) * code[k + 2] if code[k] == 255 else code[k:k + 1]
                k += 3 if code[k] == 255 else 1
            return out, (x1 - x0 + 1, y1 - y0 + 1, z1 - z0 + 1)
        at = start + coded + 4
    raise ValueError("no such frame")


def exact_depth(fields, line):
    """The optical depth of a line: the meshes of the run have cells of .1 m, so it is cut at all multiples of .1 m and
    summed by two points of Gauss in each part, which is exact for the cubic there."""
    a, b = line[:3], line[3:]
    d = [q - p for p, q in zip(a, b)]
    cuts = {0.0, 1.0}
    for axis in range(3):
        if d[axis]:
            cuts |= {t for t in ((.1 * k - a[axis]) / d[axis] for k in range(-10, 31)) if 0 < t < 1}
    cuts = sorted(cuts)
    total = 0
    for low, high in zip(cuts, cuts[1:]):
        for side in (-1, 1):
            t = (low + high) / 2 + side * (high - low) / 2 / math.sqrt(3)
            total += (high - low) / 2 * value_at(fields, [p + t * q for p, q in zip(a, d)])
    return total * math.dist(a, b)


def value_at(fields, p):
    for first, (values, n) in fields.items():
        cell = [(p[axis] - first[axis]) / .1 for axis in range(3)]
        if all(0 <= c < m - 1 for c, m in zip(cell, n)):
            low = [int(c) for c in cell]
            total = 0
            for corner in range(8):
                up = [corner >> axis & 1 for axis in range(3)]
                i, j, k = (q + u for q, u in zip(low, up))
                weight = math.prod(c - q if u else 1 - c + q for c, q, u in zip(cell, low, up))
                byte = values[(k * n[1] + j) * n[0] + i]
                total -= weight * math.log(1 - byte / 254) / .1
            return total
    return 0


def compare_joined(folder):
    """100 lines through several meshes against sums made here."""
    corners = [(-1.0, -1.0, 0.0), (0.0, -1.0, 0.0), (-1.0, 0.0, 0.0), (0.0, 0.0, 0.0)]
    fields = {corner: read_bytes(folder / f"hfg_slice_{mesh}_1.s3d", 200) for mesh, corner in enumerate(corners, 1)}
    lines = []
    for i in range(100):
        turn, height = 2.4 * i, .2 + .016 * i
        lines.append([-.95 + .01 * (i % 7), .9 * math.cos(turn), height, .95, .9 * math.sin(turn), height + .1])
    got = readings(folder, lines, 6.45626)
    for line, tau in zip(lines, got, strict=True):
        want = exact_depth(fields, line)
        check(abs(tau - want) <= 1e-6 * max(want, 1e-3), f"{line}: {tau}, by the bytes {want}")
    check(sum(tau > .05 for tau in got) > 20, "some lines meet smoke")


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
sys.exit(finish(f"; optical depths within {largest:.2g}"))
