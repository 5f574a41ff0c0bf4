"""What --export photons and surfaces write for viewers, read as their headers say, against
light.murk, plan.ply and numbers found anew.

usage: viewers.py MURK
"""

import json
import math
import os
import sys
import tempfile

import light_file
from crate import BANDS, SCENE, depth_between, grown, shares, visible_from, write_scene
from exchange import Failed, Murk, check, is_near
from ply import SIZES, check_triangles, cross, dot, place_of, read_ply, sub
from vtk_file import read_vtk

SIZES["uint"] = "I"
DIFFUSE = (0.5, 0.7)
GREY = (110, 110, 110)


def facts_of(path):
    with open(path, "rb") as file:
        head = file.read(4000).split(b"end_header")[0].decode()
    return dict(line.split(" ", 2)[1:] for line in head.splitlines()
                if line.startswith("comment ") and line.count(" ") > 1)


def check_facts(murk, folder, name):
    """The comments, and the same in the .vtp."""
    facts = facts_of(murk.path(folder, name + ".ply"))
    _, texts, _ = read_vtk(murk.path(folder, name + ".vtp"), "PolyData")
    for key in ("scene", "scene_sha256", "seed", "murk_version", "murk_commit", "materials"):
        check(facts[key] == texts[key], key, facts, texts)
    check(facts["seed"] == "7" and facts["materials"] == "0: default", facts)
    return facts


# ---- photons ----

def test_photons(murk):
    """Every record of light.murk, in its order; both files alike."""
    out = murk.path("light")
    murk.run("trace", write_scene(murk), "-q", "-o", out, "--export", "photons")
    facts = check_facts(murk, "light", "photons")
    check(facts["bands"] == "0: 450 nm, 1: 650 nm" and facts["media"] == "0: fog, 1: mist", facts)
    (vertices,) = read_ply(murk.path("light", "photons.ply")).values()
    _, _, arrays = read_vtk(murk.path("light", "photons.vtp"), "PolyData")
    found = light_file.sections(murk.path("light", "light.murk"))
    stored = [record for name in ("surface", "volume")
              for record in light_file.records(found[name])]
    check(len(vertices) == len(stored) > 4000, len(vertices), len(stored))
    check(arrays["connectivity"] == tuple(range(len(stored))) and
          arrays["offsets"] == (len(stored),), "one cell of all points")
    kinds, colors = set(), {}
    for i, (vertex, record) in enumerate(zip(vertices, stored)):
        at, power_w, emitted, band, normal, travel, kind = record
        check(tuple(place_of(vertex)) == at == arrays["place"][i], i, vertex, record)
        check(vertex["power_w"] == power_w and vertex["emitted"] == emitted and
              vertex["band"] == band and vertex["kind"] == kind // 4 and
              vertex["event"] == kind % 4, vertex, record)
        facing = light_file.unpack_direction(normal) if kind < 4 else (0, 0, 0)
        for keys, want, name in ((("nx", "ny", "nz"), facing, "normal"),
                                 (("dx", "dy", "dz"), light_file.unpack_direction(travel),
                                  "direction")):
            have = tuple(vertex[key] for key in keys)
            check(math.dist(have, want) < 1e-6 and have == arrays[name][i], name, have, want)
        for key in ("power_w", "emitted", "band", "light", "material", "kind", "event"):
            check(vertex[key] == arrays[key][i], key, i)
        if kind >= 4:
            check(vertex["material"] == 0 or vertex["material"] == 1, vertex)
        else:
            check(dot(facing, [vertex[k] for k in ("dx", "dy", "dz")]) < 1e-3, "faces", vertex)
        color = tuple(vertex[key] for key in ("red", "green", "blue"))
        check(color == arrays["color"][i], "color", i)
        check(colors.setdefault(band, color) == color, "a band has one colour", vertex)
        kinds.add(kind)
    check(kinds == {0, 2, 4, 6}, kinds)
    blue, red = colors[0], colors[1]
    check(blue[2] == 255 > blue[0] and red[0] == 255 > red[2], colors)
    check_colors_of_one_band(murk)


def check_colors_of_one_band(murk):
    """By kind and event."""
    text = SCENE.replace("bands_nm: [450, 650]", "bands_nm: [450]")
    for pair in ("[0.5, 0.7]", "[0.2, 0.1]", "[0.5, 0.9]"):
        text = text.replace(pair, "0.5")
    murk.run("trace", write_scene(murk, text, "one.yaml"), "-q", "-o", murk.path("one"),
             "--export", "photons")
    (vertices,) = read_ply(murk.path("one", "photons.ply")).values()
    colors = {}
    for v in vertices:
        color = v["red"], v["green"], v["blue"]
        check(colors.setdefault((v["kind"], v["event"]), color) == color, v)
    check(len(set(colors.values())) == 4, colors)


def test_no_photons(murk):
    """Files without a record are whole files."""
    murk.run("trace", write_scene(murk), "-q", "-o", murk.path("none"), "--export",
             "photons,surfaces", "--set", "photons.maps=none")
    (vertices,) = read_ply(murk.path("none", "photons.ply")).values()
    check(vertices == [], vertices[:1])
    _, _, arrays = read_vtk(murk.path("none", "photons.vtp"), "PolyData")
    check(arrays["place"] == [] and arrays["offsets"] == (), arrays)
    for face in read_ply(murk.path("none", "surfaces.ply"))["face"]:
        check(face["irradiance"] == 0 and (face["red"], face["green"], face["blue"]) == GREY, face)


# ---- surfaces ----

def shape_of(corners):
    a, b, c = corners
    normal = cross(sub(b, a), sub(c, a))
    length = math.hypot(*normal)
    return [x / length for x in normal], length / 2


def holds(corners, normal, at):
    if abs(dot(normal, sub(at, corners[0]))) > 1e-5:
        return False
    return all(dot(cross(normal, sub(corners[(k + 1) % 3], corners[k])),
                   sub(at, corners[k])) >= 0 for k in range(3))


def estimate(photons, emitted):
    """Sum of power / diffuse, and its error by emitted photon."""
    by_path = {}
    for p in photons:
        by_path[p["emitted"]] = by_path.get(p["emitted"], 0) + p["power_w"] / DIFFUSE[p["band"]]
    total, squares = sum(by_path.values()), sum(x * x for x in by_path.values())
    return total, math.sqrt(emitted / (emitted - 1) * (squares - total ** 2 / emitted))


def check_piece(face, corners, photons, seen, emitted):
    """One face against the photons on it and their clarities."""
    normal, area = shape_of(corners)
    mine = [i for i, p in enumerate(photons) if holds(corners, normal, place_of(p))]
    check(face["photons"] == len(mine), "photons", face, len(mine))
    total, error = estimate([photons[i] for i in mine], emitted)
    check(math.isclose(face["irradiance"], total / area, rel_tol=1e-5), face, total / area)
    check(math.isclose(face["irradiance_error"], error / area, rel_tol=1e-4), face, error / area)
    if not mine:
        check(math.isnan(face["coverage"]), face)
        return 0
    weight = [photons[i]["power_w"] for i in mine]
    want = sum(w * seen[i]["quality"] for w, i in zip(weight, mine)) / sum(weight)
    check(abs(face["coverage"] - want) < 1e-5, "coverage", face, want)
    return len(mine)


def check_middle(face, corners, sensors):
    """Who sees the middle; None where that is too close to call."""
    normal, _ = shape_of(corners)
    at = [sum(c[k] for c in corners) / 3 for k in range(3)]
    for side in (1, -1):
        off = [x + side * 1e-3 * n for x, n in zip(at, normal)]
        low, high = grown(((0, 0, 0), (8, 6, 3)), -1e-4)
        if all(a < x < b for a, x, b in zip(low, off, high)) and \
                not shares(off, [x + 1e-9 for x in off], ((3, 2, 0), (4, 4, 2))):
            break
    else:
        return None  # the crate's foot lies in the floor
    open_to = visible_from(off, sensors)
    if open_to is None:
        return None
    check(face["sensors"] == len(open_to), face, at, open_to)
    clearest = max((math.exp(-depth_between(off, s, band)) for s in open_to
                    for band in range(len(BANDS))), default=0)
    # a millimetre off, in at most 1/m
    check(abs(face["clarity"] - clearest) < 1.1e-3, face, clearest)
    return face["sensors"]


def check_vtp(path, ply):
    """The same faces; what faces have is data of cells."""
    piece, _, arrays = read_vtk(path, "PolyData")
    n = len(ply["face"])
    check(piece.find("Piece").attrib["NumberOfPolys"] == str(n), piece.find("Piece").attrib)
    check(arrays["connectivity"] == tuple(range(3 * n)) and
          arrays["offsets"] == tuple(range(3, 3 * n + 1, 3)), "triangles")
    check([tuple(place_of(v)) for v in ply["vertex"]] == arrays["place"], "corners")
    for i, face in enumerate(ply["face"]):
        check(face["vertex_indices"] == [3 * i, 3 * i + 1, 3 * i + 2], face)
        color = tuple(face[key] for key in ("red", "green", "blue"))
        check(color == arrays["color"][i], "color", i)
        for corner in ply["vertex"][3 * i:3 * i + 3]:
            check(tuple(corner[key] for key in ("red", "green", "blue")) == color, corner)
        for key in set(face) - {"vertex_indices", "red", "green", "blue"}:
            have = arrays[key][i]
            check(have == face[key] or math.isnan(have) and math.isnan(face[key]), key, i)


def test_surfaces(murk):
    plan, _ = murk.place("plan", write_scene(murk), "--export", "photons,surfaces", "--voxel",
                         "1")
    facts = check_facts(murk, "plan", "surfaces")
    check(facts["photons_on_no_piece"] == "0", facts)
    ply = read_ply(murk.path("plan", "surfaces.ply"))
    (photons,) = read_ply(murk.path("plan", "photons.ply")).values()
    photons = [p for p in photons if p["kind"] == 0]
    seen = [v for v in read_ply(murk.path("plan", "plan.ply"))["vertex"] if v["kind"] == 1]
    check(len(seen) == len(photons), len(seen), len(photons))
    sensors = [s["position_m"] for s in plan["sensors"]]
    faces, met, counts = ply["face"], 0, {}
    area = arriving = covered = weight = 0
    for i, face in enumerate(faces):
        corners = [place_of(v) for v in ply["vertex"][3 * i:3 * i + 3]]
        check(max(math.dist(corners[k - 1], corners[k]) for k in range(3)) < 1 + 1e-5, corners)
        if i % 7 == 0 and not all(c[2] == 0 for c in corners):  # there the crate's foot lies too
            met += check_piece(face, corners, photons, seen, plan["photons"]["emitted"]) > 0
        n = check_middle(face, corners, sensors)
        counts[n] = counts.get(n, 0) + 1
        area += shape_of(corners)[1]
        arriving += face["irradiance"] * shape_of(corners)[1]
        if face["photons"]:
            check((face["red"], face["green"], face["blue"]) != GREY, face)
            covered += face["coverage"] * face["photons"]
            weight += face["photons"]
    check(met > 20 and min(counts[n] for n in (0, 1, 2)) > 10 and counts.get(None, 0) < 40, met,
          counts)
    check(is_near(area, 2 * (48 + 24 + 18) + 2 * (2 + 2 + 4), 1e-5), area)
    check(sum(f["photons"] for f in faces) == len(photons), "all photons lie on faces")
    check(is_near(arriving, estimate(photons, plan["photons"]["emitted"])[0], 1e-5), arriving)
    # packets differ in power by less than a part in a thousand
    check(abs(covered / weight - plan["coverage"]["surface"]) < 1e-3, covered / weight)
    check_vtp(murk.path("plan", "surfaces.vtp"), ply)
    check_triangles(murk, "plan/surfaces.ply", len(faces))


def test_other_sights(murk):
    """Without sensors; of targets, which photons' irradiance has nothing to do with."""
    scene = write_scene(murk)
    murk.run("trace", scene, "-q", "-o", murk.path("light"), "--export", "surfaces", "--voxel",
             "2")
    plain = read_ply(murk.path("light", "surfaces.ply"))
    check("coverage" not in plain["face"][0] and "sensors" not in plain["face"][0], plain["face"][0])
    check_vtp(murk.path("light", "surfaces.vtp"), plain)
    lit = [f for f in plain["face"] if f["photons"]]
    brightest, darkest = (choose(lit, key=lambda f: f["irradiance"]) for choose in (max, min))
    check(brightest["green"] > darkest["green"] + 50, brightest, darkest)
    with open(murk.path("sensors.csv"), "w") as file:
        file.write("type,x_m,y_m,z_m\nnode,1.1,1.1,1.1\nnode,7.1,5.1,2.1\n")
    murk.run("sense", scene, "--sensors", murk.path("sensors.csv"), "-q", "-o",
             murk.path("sensed"), "--export", "surfaces", "--voxel", "2", "--set",
             "placement.targets={surfaces: {points: 4000}}")
    sensed = read_ply(murk.path("sensed", "surfaces.ply"))["face"]
    with open(murk.path("sensed", "coverage.json")) as file:
        want = json.load(file)["coverage"]["surface"]
    corners = [place_of(v) for v in plain["vertex"]]
    areas = [shape_of(corners[3 * i:3 * i + 3])[1] for i in range(len(sensed))]
    free = [(f, a) for f, a in zip(sensed, areas) if not math.isnan(f["coverage"])]
    have = sum(f["coverage"] * a for f, a in free) / sum(a for _, a in free)
    check(abs(have - want) < 0.03, "coverage of targets", have, want)  # of 4000 points
    for one, two in zip(plain["face"], sensed):
        check(one["irradiance"] == two["irradiance"], one, two)


def test_bad_options(murk):
    scene, out = write_scene(murk), ("-q", "-o", murk.path("bad"))
    for word, said in (("1e-4", "must be at most 10000000"), ("0", "must be more than 0"),
                       ("soup", "must be more than 0")):
        done = murk.run("trace", scene, *out, "--export", "surfaces", "--voxel", word, code=2)
        check(said in done.stderr and done.stderr.count("\n") == 1, done.stderr)
    check(not os.path.exists(murk.path("bad")), "a run that is refused makes a folder")
    os.makedirs(murk.path("taken", "photons.vtp"))
    plan, said = murk.place("taken", scene, "--export", "photons,surfaces", code=1)
    check("photons.vtp: cannot write: not a regular file" in said and said.count("\n") == 1, said)
    check(len(plan["sensors"]) == 3 and os.path.exists(murk.path("taken", "surfaces.vtp")), plan)


def main():
    program = sys.argv[1]
    for test in (test_photons, test_no_photons, test_surfaces, test_other_sights,
                 test_bad_options):
        with tempfile.TemporaryDirectory() as folder:
            try:
                test(Murk(program, folder))
            except Failed as failed:
                print("%s: %s" % (test.__name__, failed))
                return 1
    print("photons and surfaces are what they say")
    return 0


if __name__ == "__main__":
    sys.exit(main())
