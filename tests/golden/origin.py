#!/usr/bin/env python3
"""A scene at surveyed coordinates gives the answer that it gives at the
origin, in its own coordinates: the same usable candidates, the same plan to
1 mm, coverage within its error, and the same bits where the offset and all
sums are exact. Tables of points and sensors are read, and results written, in
the coordinates of the scene. Standard library only.
usage: origin.py MURK
"""

import json
import os
import struct
import subprocess
import sys
import tempfile

import from_outside
from from_outside import check

# Exact: multiples of the origin's grid (32 m for a room of 10 m), and all
# coordinates of the room are short binary fractions.
EXACT = [(524288, 5505024, 4096), (500000, 5500000, 0), (1e8, -1e8, 0)]
ROUNDED = [(512345.678, 5543210.987, 12.34), (1e5 + .1, 1e6 + .2, -1e4)]


def room(offset, domain=True):
    x, y, z = offset

    def p(a, b, c):
        return "[%r, %r, %r]" % (a + x, b + y, c + z)
    box = "{min_m: %s, max_m: %s}"
    whole = box % (p(0, 0, 0), p(10, 8, 4))
    # A wall that lies in a side of the domain is in it or not as rounding goes.
    around = box % (p(-.25, -.25, -.25), p(10.25, 8.25, 4.25))
    return f"""\
murk: 1
{"domain: " + around if domain else ""}
materials: {{wall: {{diffuse: 0.6}}, default: {{diffuse: 0.3}}}}
geometry:
  - {{box: {whole}, material: wall}}
  - {{box: {box % (p(3, 2, 0), p(4.5, 3.5, 2))}}}
  - {{file: crate.obj}}
  - {{sphere: {{center_m: [7, 5, 1], radius_m: 0.75}}, translate_m: {p(0, 0, 0)}}}
media:
  fog: {{extinction_per_m: 0.1, albedo: 0.9, phase: {{hg: 0.8}}}}
  layer: {{profile: {{z_m: [{z!r}, {z + 2!r}, {z + 4!r}], extinction_per_m: [0.2, 0.1, 0]}}, albedo: 0.9}}
regions:
  - {{medium: fog, below_z_m: {z + 3.5!r}}}
  - {{medium: layer}}
  - {{medium: layer, box: {box % (p(5, 5, 0), p(6, 7, 3))}}}
lights:
  - {{type: sphere, center_m: {p(5, 4, 3)}, radius_m: 0.125, power_w: 10}}
  - {{type: rect, corner_m: {p(8, 1, 3.5)}, edge1_m: [0, 1, 0], edge2_m: [1, 0, 0], power_w: 5}}
photons: {{emit: 2000}}
tallies:
  - {{name: up, type: plane, point_m: {p(0, 0, 2.5)}, normal: [0, 0, 1]}}
  - {{name: ball, type: sphere, center_m: {p(2, 6, 1)}, radius_m: 0.5}}
  - {{name: cells, type: grid, min_m: {p(0, 0, 0)}, max_m: {p(10, 8, 4)}, size: [5, 4, 2]}}
sensors:
  types: [{{name: node, range_m: 12}}]
  candidates:
    grid: {{min_m: {p(0.5, 0.5, 0.5)}, max_m: {p(9.5, 7.5, 3.5)}, size: [7, 5, 3]}}
    points: listed.csv
    clearance_m: 0.1
    avoid: [{{box: {box % (p(0, 0, 0), p(2, 2, 4))}}}]
    mount: {{surfaces: [wall], spacing_m: 2, offset_m: 0.25, z_m: [{z + 1!r}, {z + 3!r}]}}
  count: 3
placement: {{method: greedy, interest: [{{name: corner, weight: 3, box: {box % (p(6, 4, 0), p(10, 8, 4))}}}]}}
cameras: [{{name: eye, from_m: {p(1, 4, 2)}, to_m: {p(9, 4, 1)}, pixels: [8, 6], samples: 2}}]
"""


def crate(offset):
    """A table with a file of its own: two faces, as OBJ and as STL."""
    at = [[a + b for a, b in zip(corner, offset)]
          for corner in ((3.25, 5, 1), (4.75, 5, 1), (4.75, 6.5, 1), (3.25, 6.5, 1.5))]
    faces = ((0, 1, 2), (0, 2, 3))
    obj = "".join("v %r %r %r\n" % tuple(v) for v in at)
    obj += "".join("f %d %d %d\n" % tuple(i + 1 for i in f) for f in faces)
    stl = "solid a\n"
    for f in faces:
        stl += "facet normal 0 0 1\nouter loop\n"
        stl += "".join("vertex %r %r %r\n" % tuple(at[i]) for i in f) + "endloop\nendfacet\n"
    return {"crate.obj": obj, "crate.stl": stl + "endsolid a\n"}


class Place:
    """One run of the room at an offset, in a folder of its own."""

    def __init__(self, murk, top, name, offset, domain=True):
        self.murk, self.offset = murk, offset
        self.folder = os.path.join(top, name)
        os.mkdir(self.folder)
        with open(self.path("room.yaml"), "w", encoding="utf-8") as file:
            file.write(room(offset, domain))
        with open(self.path("listed.csv"), "w", encoding="utf-8") as file:
            file.write("x_m,y_m,z_m\n%r,%r,%r\n" % tuple(
                a + b for a, b in zip((8.25, 6.5, 1.25), offset)))
        for name, text in crate(offset).items():
            with open(self.path(name), "w", encoding="utf-8") as file:
                file.write(text)
        self.run("place", "room.yaml", "-o", "out")
        self.plan = self.json("out", "plan.json")

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def run(self, *args, want=0):
        done = subprocess.run([self.murk, *args], cwd=self.folder, timeout=120,
                              capture_output=True, text=True, check=False)
        check(done.returncode == want, args, self.offset, done.stderr)
        return done

    def variant(self, old, new):
        """The room with a piece of its text replaced, as variant.yaml."""
        text = self.text("room.yaml")
        check(old in text, old)
        with open(self.path("variant.yaml"), "w", encoding="utf-8") as file:
            file.write(text.replace(old, new))
        return "variant.yaml"

    def json(self, *names):
        with open(self.path(*names), encoding="utf-8") as file:
            return json.load(file)

    def text(self, *names):
        with open(self.path(*names), encoding="utf-8") as file:
            return file.read()

    def places(self, sensors):
        """Of sensors, counted from the offset."""
        return [[a - b for a, b in zip(s["position_m"], self.offset)] for s in sensors]

    def figures(self):
        """What a plan says beside positions, names and times."""
        keep = ["photons", "candidates", "coverage", "seen_by_at_least", "bound", "curve",
                "placement", "interest"]
        return {key: self.plan.get(key) for key in keep}


def near(one, other):
    return all(abs(a - b) <= 1e-3 for p, q in zip(one, other) for a, b in zip(p, q))


def first_vertex(place):
    """Of plan.ply: its first sensor, in doubles where the scene is far."""
    with open(place.path("out", "plan.ply"), "rb") as file:
        data = file.read()
    head, body = data.split(b"\nend_header\n", 1)
    form = "<3d" if b"property double x" in head else "<3f"
    return struct.unpack_from(form, body)


def main():
    with tempfile.TemporaryDirectory() as top:
        murk = os.path.abspath(sys.argv[1])
        home = Place(murk, top, "home", (0, 0, 0))
        places = home.places(home.plan["sensors"])
        check(home.plan["candidates"]["usable"] > 100, home.plan["candidates"])
        survey = home
        for i, offset in enumerate(EXACT + ROUNDED):
            far = Place(murk, top, "far%d" % i, offset)
            check(near(places, far.places(far.plan["sensors"])), offset)
            vertex = [a - b for a, b in zip(first_vertex(far), offset)]
            check(near([vertex], places[:1]), offset, vertex)
            survey = far if i == 1 else survey
            if offset in EXACT:
                check(far.figures() == home.figures(), offset)
                check(far.text("out", "tallies.csv") == home.text("out", "tallies.csv"), offset)
                ledgers = [p.json("out", "ledger.json")["absorbed_surfaces_w"] for p in (far, home)]
                check(ledgers[0] == ledgers[1], offset, ledgers)
                continue
            check(far.plan["candidates"] == home.plan["candidates"], offset,
                  far.plan["candidates"])
            here, there = home.plan["coverage"], far.plan["coverage"]
            check(abs(here["held_out"] - there["held_out"]) <= there["held_out_standard_error"],
                  offset, here, there)
        # What was written is read again: sensors by table and by plan.
        for which in ("sensors.csv", "plan.json"):
            far.run("sense", "room.yaml", "--light", "out/light.murk", "--sensors",
                    "out/" + which, "-o", "again")
            again = far.json("again", "coverage.json")
            check(abs(again["coverage"]["in_sample"] - far.plan["coverage"]["in_sample"]) < 1e-12,
                  which)
        far.run("render", "room.yaml", "--light", "out/light.murk", "-o", "eye.exr")
        far.run("report", "out", "-o", "page.html")
        check("warning" not in far.run("check", "room.yaml").stderr)
        # Grids that were written lie where the scene has them; bounds are those
        # of lit cells, and beyond the walls there are none.
        with open(survey.path("study.yaml"), "w", encoding="utf-8") as file:
            file.write("{murk_study: 1, base: room.yaml, mode: grid, outputs: [fluence_vdb],\n"
                       " axes: {photons.emit: [300]}}\n")
        survey.run("study", "study.yaml", "-o", "study")
        for grid, low in (("out/cells.vdb", 0), ("study/fluence_0001.vdb", -.25)):
            with open(survey.path("probe.yaml"), "w", encoding="utf-8") as file:
                file.write("murk: 1\nmedia: {m: {vdb: %s, grid: fluence_550nm, "
                           "extinction_per_m: 1, albedo: 0}}\nregions: [{medium: m}]\n"
                           "lights: [{type: point, position_m: [%r, %r, 2], power_w: 1}]\n"
                           % (grid, survey.offset[0] + 1, survey.offset[1] + 1))
            found = json.loads(survey.run("check", "probe.yaml", "--format", "json").stdout)
            corner = found["regions"][0]["bounds"]["min_m"]
            check(all(low - 1e-6 <= a - b <= 1e-6 for a, b in zip(corner, survey.offset)),
                  grid, corner)
        # STL is read in single precision: half a metre here, which is refused
        # where it is more than the clearance, and told where it is not.
        stl = survey.variant("crate.obj", "crate.stl")
        check("more than clearance_m, 0.1 m" in survey.run("check", stl, want=2).stderr)
        check("step at its coordinates" in
              survey.run("check", stl, "--set", "sensors.candidates.clearance_m=0").stderr)
        home.run("check", home.variant("crate.obj", "crate.stl"))
        # Where a far surface takes the precision, no other reason is given.
        lost = home.variant("  - {file: crate.obj}", "  - {rect: {corner_m: [-1e8, -1e8, 0], "
                            "edge1_m: [2e8, 0, 0], edge2_m: [0, 2e8, 0]}}")
        check("surfaces are known to" in
              home.run("place", lost, "--set", "sensors.candidates.mount=free", want=2).stderr)
        # Without a domain the origin follows from what the scene states.
        home = Place(murk, top, "home_free", (0, 0, 0), domain=False)
        far = Place(murk, top, "far_free", EXACT[1], domain=False)
        check(far.plan["candidates"]["usable"] == home.plan["candidates"]["usable"])
        check(near(home.places(home.plan["sensors"]), far.places(far.plan["sensors"])))
    return from_outside.failures != 0


if __name__ == "__main__":
    sys.exit(main())
