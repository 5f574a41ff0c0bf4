"""What murk place writes for viewers, read as their headers say: plan.ply (sensors with the
marks that show where they look, photons with who sees them) and path.ply.

usage: ply.py MURK
"""

import csv
import json
import math
import re
import struct
import sys
import tempfile

from exchange import Failed, Murk, check

SIZES = {"float": "f", "uchar": "B", "ushort": "H", "int": "i", "uint": "I"}
TYPES = ("[{name: node, range_m: 3}, "
         "{name: cam, range_m: 3, view: {hfov_deg: 70, vfov_deg: 40}, headings: 6, "
         "tilts_deg: [-20], least_count: 1}, "
         "{name: spot, range_m: 4, view: {cone_deg: 50}, headings: 4, least_count: 1}, "
         "{name: wide, range_m: 2, view: {cone_deg: 230}, headings: 4, least_count: 1}]")
CONE_DEG = {"spot": 50, "wide": 230}
CONE_SIDES = 16


def read_ply(path):
    """Elements by name, each a list of dicts: nothing assumed but the header."""
    with open(path, "rb") as file:
        data = file.read()
    head, body = data.split(b"end_header\n", 1)
    lines = head.decode("ascii").splitlines()
    check(lines[:2] == ["ply", "format binary_little_endian 1.0"], lines[:2])
    elements = []
    for words in (line.split() for line in lines[2:]):
        if words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            elements[-1][2].append(words[1:])
    at, out = 0, {}
    for name, count, properties in elements:
        rows = []
        for _ in range(count):
            row = {}
            for words in properties:
                many = 1
                if words[0] == "list":
                    (many,) = struct.unpack_from("<" + SIZES[words[1]], body, at)
                    at += struct.calcsize("<" + SIZES[words[1]])
                kind = "<%d%s" % (many, SIZES[words[-2]])
                value = struct.unpack_from(kind, body, at)
                at += struct.calcsize(kind)
                row[words[-1]] = list(value) if words[0] == "list" else value[0]
            rows.append(row)
        out[name] = rows
    check(at == len(body), "the file has", len(body), "bytes, not", at)
    return out


def place_of(vertex):
    return [vertex[axis] for axis in "xyz"]


def sub(a, b):
    return [p - q for p, q in zip(a, b)]


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def check_solid(vertices, faces):
    """Closed, wound alike, normals out: each edge once each way, volume above 0."""
    edges = [(f[k], f[(k + 1) % 3]) for f in faces for k in range(3)]
    check(len(set(edges)) == len(edges), "an edge twice one way")
    check(all((b, a) in edges for a, b in edges), "an edge without its other side")
    origin = vertices[faces[0][0]]
    p = [[sub(vertices[i], origin) for i in f] for f in faces]
    volume = sum(dot(a, cross(b, c)) for a, b, c in p) / 6
    check(volume > 0, "volume", volume)


def check_mark(sensor, at, corners, octahedron_m):
    """Where the corners stand, by the sensor's pose in plan.json."""
    if sensor["heading_deg"] is None:
        check(len(corners) == 6, len(corners), "corners")
        for axis in range(3):
            mean = sum(c[axis] for c in corners) / 6
            check(abs(mean - at[axis]) < 1e-5, "mark", corners)
        return
    heading = math.radians(sensor["heading_deg"])
    axis = sensor["axis"]
    right = [math.cos(heading), -math.sin(heading), 0]
    up = cross(right, axis)
    check(math.dist(corners[0], at) < 1e-6, "the point is not at the sensor", corners[0])
    rim = [sub(c, at) for c in corners[1:]]
    for edge in rim:
        check(abs(math.hypot(*edge) / (4 * octahedron_m) - 1) < 1e-4, "length", edge)
    if sensor["type"] == "cam":
        h, v = (math.tan(math.radians(a / 2)) for a in (70, 40))
        for edge, (x, y) in zip(rim, ((-h, v), (h, v), (h, -v), (-h, -v)), strict=True):
            ahead = dot(edge, axis)
            check(abs(dot(edge, right) / ahead - x) < 1e-4, "right", edge)
            check(abs(dot(edge, up) / ahead - y) < 1e-4, "up", edge)
    else:
        check(len(rim) == CONE_SIDES, len(rim))
        half = math.radians(CONE_DEG[sensor["type"]] / 2)
        for edge in rim:
            check(abs(dot(edge, axis) / math.hypot(*edge) - math.cos(half)) < 1e-4, "cone", edge)


SHAPES = {"node": (6, 8), "cam": (5, 6), "spot": (17, 30), "wide": (17, 30)}


RANGE_M = {"node": 3, "cam": 3, "spot": 4, "wide": 2}
BITS = 32


def check_who(photon, sensors):
    """A bit a sensor, of the first 32: none that is out of range."""
    who = [k for k in range(BITS) if photon["sensors"] >> k & 1]
    beyond = max(0, len(sensors) - BITS)
    check(len(who) <= photon["seen_by"] <= len(who) + beyond, photon)
    for k in who:
        far = math.dist(place_of(photon), sensors[k]["position_m"])
        check(far < RANGE_M[sensors[k]["type"]] + 1e-3, "sensor", k, "sees", far, "m far")


def check_plan(murk, name):
    with open(murk.path(name, "plan.json")) as file:
        plan = json.load(file)
    ply = read_ply(murk.path(name, "plan.ply"))
    vertices, faces = ply["vertex"], [f["vertex_indices"] for f in ply["face"]]
    sensors = plan["sensors"]
    n = len(sensors)
    shapes = [SHAPES[sensor["type"]] for sensor in sensors]
    marks = sum(corners for corners, _ in shapes)
    check(len(faces) == sum(f for _, f in shapes), len(faces), "faces")
    surface, volume = plan["photons"]["surface"], plan["photons"]["volume"]
    check([v["kind"] for v in vertices] == [0] * n + [3] * marks + [1] * surface + [2] * volume,
          "kinds")
    places = [place_of(v) for v in vertices]
    size_m = math.dist((0, 0, 0), (8, 6, 3))
    corner, face = n, 0
    for k, (sensor, shape) in enumerate(zip(sensors, shapes)):
        check(math.dist(places[k], sensor["position_m"]) < 1e-6, places[k], sensor)
        check_mark(sensor, places[k], places[corner:corner + shape[0]], 0.005 * size_m)
        own = faces[face:face + shape[1]]
        check({i for f in own for i in f} == set(range(corner, corner + shape[0])), "corners", own)
        check_solid(places, own)
        corner, face = corner + shape[0], face + shape[1]
    photons = vertices[n + marks:]
    for photon in photons:
        check((photon["seen_by"] > 0) == (photon["quality"] > 0), photon)
        check_who(photon, sensors)
    by_map = [[p for p in photons if p["kind"] == kind] for kind in (1, 2)]
    for have, key in zip(by_map, ("surface", "volume")):
        if not have:
            continue
        # two lamps' packets differ a little in power, so not to the last digit
        mean = sum(p["quality"] for p in have) / len(have)
        check(abs(mean - plan["coverage"][key]) < 2e-3, key, mean, plan["coverage"])
    return plan, len(faces)


def check_triangles(murk, name, triangles):
    """Assimp, too, reads it."""
    with open(murk.path("ply.yaml"), "w") as file:
        file.write("murk: 1\ngeometry: [{file: %s}]\n"
                   "lights: [{type: point, position_m: [0.5, 0.5, 0.5], power_w: 1}]\n"
                   "photons: {emit: 10}\n" % name)
    text = json.dumps(json.loads(murk.run("check", murk.path("ply.yaml"), "--format",
                                          "json").stdout))
    check(re.search(r'"triangles": %d\b' % triangles, text), name, text[:2000])


def test_the_plan_as_points(murk):
    murk.place("points", murk.scene(0.4))
    plan, faces = check_plan(murk, "points")
    check(plan["photons"]["volume"] > 50 and plan["photons"]["surface"] > 50, plan["photons"])
    check_triangles(murk, "points/plan.ply", faces)


def test_marks_show_the_headings_of_sensors(murk):
    murk.place("views", murk.scene(0.4), "--count", "5", "--set", "sensors.types=" + TYPES,
               "--set", "placement.nodes=0")
    plan, faces = check_plan(murk, "views")
    check({"cam", "spot", "wide"} <= {s["type"] for s in plan["sensors"]}, plan["sensors"])
    check_triangles(murk, "views/plan.ply", faces)


def test_who_sees_a_photon_of_many(murk):
    """More sensors than bits, and than are looked at in one go."""
    murk.place("many", murk.scene(0.4), "--count", "36", "--set", "sensors.types=" + TYPES,
               "--set", "placement.method=greedy")
    plan, _ = check_plan(murk, "many")
    check(len(plan["sensors"]) == 36, len(plan["sensors"]))


def check_path(murk, name):
    with open(murk.path(name, "plan.json")) as file:
        explore = json.load(file)["explore"]
    ply = read_ply(murk.path(name, "path.ply"))
    steps = explore["steps"]
    stops = [v for v in ply["vertex"] if v["kind"] < 2]
    check(ply["vertex"][:len(stops)] == stops, "stops do not come first")
    check([[e["vertex1"], e["vertex2"]] for e in ply["edge"]] ==
          [[k, k + 1] for k in range(len(stops) - 1)], ply["edge"])
    places = [place_of(v) for v in stops]
    check(math.dist(places[0], explore["start_m"]) < 1e-6, places[0])
    # along the path every station comes in its turn, after as many metres as are told
    gone, at = 0, 0
    for number, step in enumerate(steps, 1):
        while math.dist(places[at], step["position_m"]) > 1e-6 or abs(gone - step["path_m"]) > 1e-4:
            check(at + 1 < len(places), "the path misses station", number)
            gone += math.dist(places[at], places[at + 1])
            at += 1
            check(stops[at]["step"] == number, stops[at], number)
        check(stops[at]["kind"] == 0, "not a station", stops[at])
    check(at + 1 == len(places), "the path goes on")
    check(abs(gone - explore["path_m"]) < 1e-4, gone, explore["path_m"])
    # the line about each leg: within its thickness
    corners = ply["vertex"][len(stops):]
    check(len(corners) == 6 * (len(stops) - 1) and len(ply["face"]) == len(corners), len(corners))
    for k, corner in enumerate(corners):
        end = places[k // 6 + k % 6 // 3]
        off = math.dist(place_of(corner), end) / (0.001 * math.dist((0, 0, 0), (8, 6, 3)))
        check(abs(off - 1) < 1e-2, "corner", corner, end)
    return explore, len(ply["face"])


def test_the_path_of_an_explorer(murk):
    murk.place("path", murk.scene(0.1), "--count", "6", "--set", "placement.knowledge=explore",
               "--set", "placement.start_m=[0.7, 0.7, 0.7]")
    explore, faces = check_path(murk, "path")
    check(len(explore["steps"]) == 6 and explore["path_m"] > 1, explore)
    check_triangles(murk, "path/path.ply", faces)
    with open(murk.path("path", "explore.csv")) as file:
        rows = list(csv.DictReader(file))
    check(len(rows) == 6, rows)
    for row, step in zip(rows, explore["steps"]):
        for key in ("sensor", "gain", "coverage", "path_m", "places_seen", "queries",
                    "shadow_rays"):
            check(math.isclose(float(row[key]), step[key], rel_tol=1e-8), key, row, step)
        at = [float(row[a + "_m"]) for a in "xyz"]
        check(math.dist(at, step["position_m"]) < 1e-12, row, step)


def main():
    program = sys.argv[1]
    for test in (test_the_plan_as_points, test_marks_show_the_headings_of_sensors,
                 test_who_sees_a_photon_of_many, test_the_path_of_an_explorer):
        with tempfile.TemporaryDirectory() as folder:
            try:
                test(Murk(program, folder))
            except Failed as failed:
                print("%s: %s" % (test.__name__, failed))
                return 1
    print("viewers read what murk writes")
    return 0


if __name__ == "__main__":
    sys.exit(main())
