#!/usr/bin/env python3
"""Smoke of fire simulations in the commands: fit predicts the coverage that sense
measures, times of a run cannot be searched, rows of a study know data files that
have changed, unstructured geometry is there, --report writes the page, and delta tracking and a box around the
meshes give the same light. Standard library only.
usage: fds.py MURK
"""

import csv
import json
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile

murk = pathlib.Path(sys.argv[1]).resolve()
SCENE = """murk: 1
bands_nm: [633]
domain: {min_m: [-0.1, -0.1, -0.1], max_m: [24.1, 12.1, 9.1], sides: open}
geometry: [{fds: fire.smv, material: wall}]
materials: {wall: {diffuse: 0.5}}
media:
  smoke: {preset: smoke/flaming, fds: fire.smv, time_s: 30}
regions: [{medium: smoke}]
lights: [{type: sphere, center_m: [10, 6, 5], radius_m: 0.2, power_w: 100}]
photons: {emit: 4000}
sensors:
  types: [{name: node, range_m: 12}]
  candidates: {grid: {min_m: [4, 3, 1.5], max_m: [20, 9, 7.5], size: [3, 2, 2]}}
  count: 1
"""
failures = 0


def check(holds, *text):
    global failures
    if not holds:
        failures += 1
        print("not so:", *text)


def run(folder, *words, status=0):
    done = subprocess.run([murk, *words], cwd=folder, capture_output=True, text=True)
    check(done.returncode == status, words, done.returncode, done.stderr)
    return done


def absorbed(folder, *words):
    """Power absorbed by the smoke."""
    run(folder, "trace", "scene.yaml", "--quiet", "-o", "light", "--force", *words)
    return json.loads((folder / "light/ledger.json").read_text())["absorbed_media_w"]["total"]


def record(kind, *values):
    data = struct.pack(f"<{len(values)}{kind}", *values)
    return struct.pack("<i", len(data)) + data + struct.pack("<i", len(data))


def check_geom(folder):
    """A plate of two triangles just above a small lamp, by a .ge file; a study knows when it changes."""
    def write(z):
        x, y = (0, 24), (0, 12)
        (folder / "plate.ge").write_bytes(b"".join((
            record("i", 1), record("i", 2), record("i", 0, 0, 1), record("f", 0), record("i", 4, 2, 0),
            record("f", x[0], y[0], z, x[1], y[0], z, x[0], y[1], z, x[1], y[1], z), record("i", 1, 2, 3, 4, 3, 2),
            record("i", surfaces, surfaces), record("f", *[0] * 12))))
    smv = (folder / "fire.smv").read_text()
    surfaces = smv.splitlines().count("SURFACE")
    write(5.25)
    (folder / "fire.smv").write_text(smv + "\nSURFACE\n PLATE\n 20. 1.\n 0 1. 1. .5 .5 .5 1.\n null\n"
                                     "\nGEOM      1\n plate.ge\n RECTANGULAR 0 0 0 0\n")
    words = ("--set", "media.smoke.time_s=0", "--set", "materials={PLATE: {diffuse: 0}, wall: {diffuse: 0.5}}",
             "--set", "geometry=[{fds: fire.smv}]", "--set", "lights.0.center_m=[10, 6, 5]")
    run(folder, "trace", "scene.yaml", "--quiet", "-o", "plate", *words)
    ledger = json.loads((folder / "plate/ledger.json").read_text())
    share = ledger["absorbed_by_material_w"]["PLATE"]["total"] / 100
    check(0.4 < share < 0.75, "the plate absorbs", share)
    (folder / "plates.yaml").write_text("murk_study: 1\nbase: scene.yaml\naxes: {media.smoke.time_s: [0]}\noutputs: [density]\n")
    for z, kept in ((5.25, 0), (5.25, 1), (5.3, 0)):
        write(z)
        said = " ".join(run(folder, "study", "plates.yaml", "-o", "plates").stdout.split())
        check(f"of which {kept} kept from before" in said, z, said)
    (folder / "plate.ge").unlink()
    refused = run(folder, "trace", "scene.yaml", status=2)
    check(refused.stderr.count("\n") == 1 and "plate.ge: No such file" in refused.stderr, refused.stderr)


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    for file in pathlib.Path("scenes/fds").iterdir():
        # a run whose .smv file has another name than its data
        shutil.copy(file, folder / ("fire.smv" if file.suffix == ".smv" else file.name))
    (folder / "scene.yaml").write_text(SCENE)
    # coverage by fit and by sense
    place = "18,6,6.5"
    (folder / "cover.csv").write_text("kind,sensor,x_m,y_m,z_m,heading_deg,tilt_deg,unit,value,standard_error\n"
                                      f"coverage,node,{place},0,0,fraction,.1,.1\n")
    (folder / "node.csv").write_text(f"type,x_m,y_m,z_m,heading_deg,tilt_deg\nnode,{place},0,0\n")
    run(folder, "fit", "scene.yaml", "--quiet", "--data", "cover.csv", "-o", "fit")
    run(folder, "sense", "scene.yaml", "--quiet", "--sensors", "node.csv", "-o", "sense", "--report")
    with open(folder / "fit/fit.csv") as table:
        predicted = float(next(csv.DictReader(table))["predicted"])
    sensed = json.loads((folder / "sense/coverage.json").read_text())["coverage"]["in_sample"]
    check(abs(predicted / sensed - 1) < 1e-5 and 0 < sensed < 1, "coverage", predicted, sensed)
    check((folder / "sense/report.html").stat().st_size > 10000, "--report writes a page")
    refused = run(folder, "fit", "scene.yaml", "--data", "cover.csv", "--free", "media.smoke.time_s", status=2)
    check(refused.stderr.count("\n") == 1 and "time_s" in refused.stderr, "a time is free:", refused.stderr)
    refused = run(folder, "check", "scene.yaml", "--set", "media.smoke.mesh=[1, 1]", status=2)
    check("mesh 1 is there twice" in refused.stderr, refused.stderr)
    refused = run(folder, "place", "scene.yaml", "--report", status=2)
    check("needs -o DIR" in refused.stderr, refused.stderr)
    # the same light by delta tracking, which marches here, and in a box around the meshes
    plain = absorbed(folder)
    check(plain > 10, "smoke absorbs", plain)
    for words in (["--set", "flight=delta"],
                  ["--set", "regions.0.box={min_m: [-1, -1, -1], max_m: [25, 13, 10]}"]):
        check(abs(absorbed(folder, *words) / plain - 1) < 1e-9, words)
    check(abs(absorbed(folder, "--set", "media.smoke.time_s=60") / plain - 1) > 0.02, "another time, another light")
    # a data file changes: rows of a study
    (folder / "study.yaml").write_text("murk_study: 1\nbase: scene.yaml\naxes: {media.smoke.time_s: [30, 40]}\n"
                                       "outputs: [density]\n")
    for change, kept in ((False, 0), (False, 2), (True, 0)):
        if change:
            data = bytearray((folder / "atrium_2_1.s3d").read_bytes())
            data[-40] ^= 1
            (folder / "atrium_2_1.s3d").write_bytes(data)
        said = " ".join(run(folder, "study", "study.yaml", "-o", "study").stdout.split())
        check(f"of which {kept} kept from before" in said, change, said)
    # triangles of GEOM beside the walls: a plate above the lamp takes half of the light; it has its own material
    check_geom(folder)
sys.exit(failures > 0)
