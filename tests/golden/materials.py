#!/usr/bin/env python3
"""Names of materials in mesh files: what they got is listed with its area, what
met nothing is warned of, blanks that the importer strips do not count; and the
warning of light that escapes from a room. Standard library only.
usage: materials.py MURK
"""

import math
import sys

from from_outside import check, main, near, parse

# The floor of a room in two halves, a wall, a pane, and a fifth name.
MTL = """\
newmtl wall paint
newmtl   Floor_1\x20\x20
newmtl glass
newmtl unused
"""
OBJ = """\
mtllib room.mtl
v 1 1 1
v 3 1 1
v 3 3 1
v 1 3 1
v 1 3 2
usemtl wall paint
f 1 2 3
usemtl   Floor_1\x20\x20
f 1 3 4
usemtl glass
f 1 4 5
usemtl nowhere
f 2 3 4
"""
SCENE = """\
murk: 1
domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}
geometry: [{file: room.obj, scale: 1}, {rect: {corner_m: [0, 0, 0.1], edge1_m: [1, 0, 0], edge2_m: [0, 1, 0]}}]
materials: MATERIALS
lights: [{type: point, position_m: [2, 2, 2.5], power_w: 10}]
photons: {emit: 1000}
"""
ESCAPES = "of the lamps' light escapes"


def scene(murk, materials):
    for name, text in (("room.obj", OBJ), ("room.mtl", MTL)):
        murk.write(name, text)
    return murk.write("s.yaml", SCENE.replace("MATERIALS", materials))


def check_names(murk):
    path = scene(murk, '{" wall paint": {diffuse: 0.1}, "Floor_1 ": {diffuse: 0.2}, '
                       "gloss: {diffuse: 0.3}, GLASS: {diffuse: 0.4}}")
    done = murk.call("check", path, "--format", "json")
    found = parse(done.stdout)["mesh_materials"]
    want = {"wall paint": (2, " wall paint"), "Floor_1": (2, "Floor_1 "),
            "glass": (1, "GLASS"), "nowhere": (2, "default")}
    check({m["name"] for m in found} == set(want), "names:", found)
    for m in found:
        area, material = want.get(m["name"], (math.nan, ""))
        near(m["area_m2"], area, 1e-6, m["name"], "has an area of")
        check(m["material"] == material, m["name"], "got", m["material"])
        check(m["geometry"] == 0 and m["file"].endswith("room.obj"), m)
    warned = done.stderr.splitlines()
    check(len(warned) == 3, warned)
    check('geometry.0: "nowhere": no entry of materials has this name, so 2 m2' in done.stderr, warned)
    check("materials.gloss: no surface is of this material" in done.stderr, warned)
    check(ESCAPES in done.stderr, warned)
    text = " ".join(murk.call("check", path).stdout.split())
    check("wall paint of geometry 0, 2 m2: material wall paint" in text, text)
    check("nowhere of geometry 0, 2 m2: material default, as no entry has this name" in text, text)


def check_scale(murk):
    """Areas are the world's, and a geometry's own material comes first."""
    path = scene(murk, "{all: {diffuse: 0.5}}")
    done = murk.call("check", path, "--format", "json", "--set", "geometry.0.material=all",
                     "--set", "geometry.0.scale=1.5", "--set", "geometry.0.rotate_deg=[30, 40, 50]")
    for m in parse(done.stdout)["mesh_materials"]:
        near(m["area_m2"], 2.25 * (1 if m["name"] == "glass" else 2), 1e-5, m["name"], "scaled")
        check(m["material"] == "all", m)
    check("no entry" not in done.stderr and "no surface is of" not in done.stderr, done.stderr)


def check_escape(murk):
    """Of a closed room nothing is said, nor under a sky; with a wall missing it is."""
    walls = "[{box: {min_m: [0.1, 0.1, 0.1], max_m: [3.9, 3.9, 2.9]}}]"
    path = scene(murk, "{}")
    sky = "{type: directional, direction: [0, 0, -1], irradiance_w_per_m2: 1}"
    lamp = "{type: point, position_m: [2, 2, 2.5], power_w: 10}"
    for words, is_warned in (([f"geometry={walls}"], False), (["geometry=[]"], False),
                             ([f"geometry={walls}", "materials.default.diffuse=0.5",
                               f"lights=[{lamp}, {sky}]"], False),
                             (["geometry.0.material=default", f"lights=[{lamp}, {sky}]"], False),
                             (["geometry.0.material=default"], True)):
        overrides = [word for one in words for word in ("--set", one)]
        for command in ("check", "trace"):
            done = murk.call(command, path, *overrides)
            check((ESCAPES in done.stderr) == is_warned, command, words, done.stderr)
            check(done.stderr.count(ESCAPES) == is_warned, command, "says it once")


if __name__ == "__main__":
    sys.exit(main([check_names, check_scale, check_escape]))
