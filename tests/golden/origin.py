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
import re
import struct
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import browser  # noqa: E402
import from_outside  # noqa: E402
import pages  # noqa: E402
from from_outside import check  # noqa: E402

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


def numbers(text):
    return [float(n) for n in re.findall(r"-?[0-9][0-9.]*(?:e[-+][0-9]+)?", text)]


def check_messages(far):
    """Each names a position of the user's, and none that counts from the origin."""
    x, y, z = far.offset
    outside = "[%r, %r, %r]" % (x + 100, y + 4, z + 1)
    data = "kind,x_m,y_m,z_m,x2_m,y2_m,z2_m,unit,value,standard_error\n" \
           "transmittance,%r,%r,%r,%r,%r,%r,fraction,0.5,0.01\n"
    with open(far.path("across.csv"), "w", encoding="utf-8") as file:
        file.write(data % (x + 2, y + 2.75, z + 1, x + 6, y + 2.75, z + 1))
    fit = ["fit", "room.yaml", "--data", "across.csv", "--free", "media.fog.extinction_per_m"]
    commands = {
            "lamp": ["check", "room.yaml", "--set", "lights.0.center_m=" + outside],
            "tally": ["check", "room.yaml", "--set", "tallies.1.center_m=" + outside],
            "fixed": ["check", "room.yaml", "--set", "sensors.fixed=[{type: node, position_m: %s}]" % outside],
            "start": ["place", "room.yaml", "--set", "placement.knowledge=explore",
                      "--set", "placement.start_m=" + outside],
            "candidate": ["check", "room.yaml", "--set", "sensors.candidates.grid.max_m=" + outside],
            "listed": ["check", "room.yaml", "--set", "sensors.candidates.points=[%s]" % outside],
            "interest": ["check", "room.yaml", "--set", "placement.interest.0.box={min_m: %s, max_m: "
                         "[%r, %r, %r]}" % (outside, x + 101, y + 5, z + 2)],
            "camera": ["render", "room.yaml", "--set", "cameras.0.from_m=" + outside],
            "region": ["check", "room.yaml", "--set", "regions.2.box={min_m: %s, max_m: [%r, %r, %r]}" % (
                outside, x + 101, y + 5, z + 2)],
            "segment": fit}
    for what, words in commands.items():
        done = far.run(*words, want=0 if what == "region" else 2)
        # what is said, without the option that it is said of
        text = " ".join(line.rsplit(": ", 1)[-1] if what != "region" else line.split("the region fills ")[-1]
                        for line in done.stderr.splitlines() if "note:" not in line)
        said = re.findall(r"\[([^][]*)\]", text)
        check(said, what, "names no position:", done.stderr)
        for position in said:
            off = [abs(a - b) for a, b in zip(numbers(position), far.offset)]
            check(len(off) == 3 and max(off) <= 110, what, "counts from the origin:", done.stderr)
        check("count from" not in done.stderr, what, done.stderr)


def section(path, wanted):
    """Of light.murk; None where it has no such section."""
    with open(path, "rb") as file:
        data = file.read()
    count, = struct.unpack_from("<I", data, 20)
    at = 64 + 48 * count
    for i in range(count):
        name, size = struct.unpack_from("<16sQ", data, 64 + 48 * i)
        if name.rstrip(b"\0").decode() == wanted:
            return data[at:at + size]
        at += size
    return None


CONDITIONS = """conditions: {clear: {}, haze: {media.fog.extinction_per_m: 0.3}, fog: {media.fog.extinction_per_m: 0.6},
  smoke: {media.fog.albedo: 0.5}}
placement: {over: regret, method: greedy}
"""


def check_tables(far):
    """Tables of a plan over conditions, and of sensors at surveyed coordinates, have a
    row a line within 80 columns."""
    with open(far.path("room.yaml"), encoding="utf-8") as file:
        text = [line for line in file if not line.startswith("placement:")]
    with open(far.path("four.yaml"), "w", encoding="utf-8") as file:
        file.write("".join(text) + CONDITIONS)
    for scene in ("four.yaml", "room.yaml"):
        turned = ["--set", "sensors.types=[{name: camera, range_m: 12, view: {cone_deg: 90}, headings: 4}]"]
        for more in ([], turned):
            printed = far.run("place", scene, *more).stdout.splitlines()
            check(max(len(line) for line in printed) <= 80, scene, "has long lines")
            first = [line.split()[:1] for line in printed].index(["sensors"])
            rows = [line.split() for line in printed[first + 1:first + 4]]
            places = [[float(v) for v in row[2:5]] for row in rows]
            check([row[0] for row in rows] == ["1", "2", "3"] and near(
                [[o + 5, p + 4, q + 2] for o, p, q in [far.offset]] * 3, places, 10), printed[first:first + 5])
            check(all(len(row) == 9 for row in rows), rows)
    printed = far.run("place", "four.yaml").stdout.splitlines()
    rows = {}
    for line in printed:
        if line.startswith("            ") and line.split()[0] in ("clear", "haze", "fog", "smoke"):
            rows.setdefault(line.split()[0], []).append(len(re.findall(r"[0-9][.0-9]*", line)))
    check(len(rows) == 4 and all(v[:2] == [4, 3] for v in rows.values()), "conditions:", rows)
    # as many numbers in all blocks of the regret: a coverage and a loss each, mean and worst
    check(all(sum(v[2:]) == 2 * 4 + 2 for v in rows.values()), "regret:", rows)


def check_files(far, home):
    """What single precision cannot hold counts from an origin that the file states;
    the page says the scene's own coordinates."""
    view = json.loads(re.search(r'id="view-data"[^>]*>(.*?)</script>', far.text("page.html"), re.S).group(1))
    origin = struct.unpack("<3d", section(far.path("out", "light.murk"), "origin_m"))
    check(list(origin) == view["origin"], origin, view["origin"])
    check(section(home.path("out", "light.murk"), "origin_m") is None, "an origin of 0 is written")
    lamp = [a + b for a, b in zip(view["lamps"][0]["place"], view["origin"])]
    check(near([lamp], [[a + b for a, b in zip((5, 4, 3), far.offset)]]), lamp, view["origin"])
    with open(far.path("eye.exr"), "rb") as file:
        head = file.read(20000).split(b"murkOrigin\0string\0", 1)[1]
    size, = struct.unpack_from("<i", head)
    check(tuple(numbers(head[4:4 + size].decode()[:-2])) == origin, head[4:4 + size])
    eye = [a + b for a, b in zip((1, 4, 2), far.offset)]
    with open(far.path("eye.exr"), "rb") as file:
        head = file.read(20000).split(b"murkFrom\0string\0", 1)[1]
    size, = struct.unpack_from("<i", head)
    check(near([numbers(head[4:4 + size].decode()[:-2])], [eye]), head[4:4 + size])
    # the grid of a tally, drawn with axes
    if not browser.program():
        return
    page = pages.drawn(far.path("page.html"))
    drawn = re.findall(r"Fluence rate cells[^<]* at [xyz] = ([-0-9.e+]+) m", page)
    check(drawn and all(any(abs(float(v) - o) <= 10 for o in far.offset) for v in drawn), drawn)
    ticks = [t.replace("\u2212", "-") for t in re.findall(r"<text[^>]*>([^<]*)</text>", page)]
    check(any(t.isdigit() and 0 <= float(t) - far.offset[0] <= 10 for t in ticks), "no tick in x:", ticks[:50])


def check_light_of_other_sensors(far):
    """Without a domain, where a mesh is all there is, sensors have a say in the
    origin: light whose positions count from another one is not taken."""
    x, y, z = far.offset
    corners = [(x + a, y + b, z) for a, b in ((0, 0), (40, 0), (40, 40), (0, 40))]
    with open(far.path("floor.obj"), "w", encoding="utf-8") as file:
        file.write("".join("v %r %r %r\n" % c for c in corners) + "f 1 2 3\nf 1 3 4\nv %r %r %r\nf 1 2 5\n" % (
            x, y, z + 10))
    with open(far.path("floor.yaml"), "w", encoding="utf-8") as file:
        file.write("murk: 1\ngeometry: [{file: floor.obj}]\nphotons: {emit: 100}\n"
                   "lights: [{type: point, position_m: [%r, %r, %r], power_w: 1}]\n"
                   "sensors: {types: [{name: node, range_m: 9}], count: 1, candidates: {grid: "
                   "{min_m: [%r, %r, %r], max_m: [%r, %r, %r], size: [2, 2, 2]}}}\n" % (
                       x + 1, y + 2, z + 3, x + 1, y + 1, z + 1, x + 3, y + 3, z + 4))
    far.run("trace", "floor.yaml", "-o", "floor")
    sense = ["place", "floor.yaml", "--light", "floor/light.murk"]
    far.run(*sense)
    done = far.run(*sense, "--set", "sensors.candidates.grid.max_m=[%r, %r, %r]" % (x + 35, y + 35, z + 4), want=2)
    check("its positions count from" in done.stderr, done.stderr)


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


def near(one, other, within=1e-3):
    return all(abs(a - b) <= within for p, q in zip(one, other) for a, b in zip(p, q))


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
        survey.run("render", "room.yaml", "--light", "out/light.murk", "-o", "eye.exr")
        survey.run("report", "out", "-o", "page.html")
        check_files(survey, home)
        check_light_of_other_sensors(survey)
        check_tables(survey)
        check_messages(survey)
        check_messages(far)
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
