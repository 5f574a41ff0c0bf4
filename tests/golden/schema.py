#!/usr/bin/env python3
"""murk schema from outside: the JSON Schema is one of draft-07, accepts every
scene and study of scenes/ and a scene as murk resolves it, refuses wrong scenes
that murk check refuses, and describes every key. Needs python3-jsonschema and
python3-yaml, else the test is skipped.
usage: schema.py MURK
"""

import copy
import glob
import json
import os
import re
import subprocess
import sys
import tempfile

try:
    import jsonschema
    import yaml
except ImportError as error:
    print("skipped:", error)
    sys.exit(77)

MURK = sys.argv[1]
failures = 0


def check(holds, *text):
    global failures
    if not holds:
        print("schema.py:", *text)
        failures += 1


class Loader(yaml.SafeLoader):
    """Scalars as in YAML 1.2, which murk and the YAML extension of VS Code read: 1e6 is a number,
    06:30 and 2026-06-21 are texts."""


Loader.yaml_implicit_resolvers = {}
for tag, pattern, first in (
        ("bool", r"(?:true|false)$", "tf"),
        ("null", r"(?:null|~|)$", ["n", "~", ""]),
        ("int", r"[-+]?[0-9]+$", "-+0123456789"),
        ("float", r"[-+]?(?:\.[0-9]+|[0-9]+(?:\.[0-9]*)?)(?:[eE][-+]?[0-9]+)?$", "-+.0123456789")):
    Loader.add_implicit_resolver("tag:yaml.org,2002:" + tag, re.compile(pattern), list(first))
Loader.add_constructor("tag:yaml.org,2002:float", lambda loader, node: float(node.value))


def load(text):
    """A tree as JSON has it: names are texts."""
    return json.loads(json.dumps(yaml.load(text, Loader)))


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


SCENE = """
murk: 1
band_edges_nm: [400, 500, 600]
site: {latitude_deg: 52, longitude_deg: 5, time: 2026-06-21T12:00:00Z}
domain: {min_m: [0, 0, 0], max_m: [9, 9, 3]}
materials: {wall: {diffuse: [0.5, 0.4]}}
geometry: [{box: {min_m: [0, 0, 0], max_m: [1, 1, 1]}, material: wall}]
media:
  fog: {extinction_per_m: 1e-1, albedo: 0.9, phase: [rayleigh, {hg: 0.8}]}
  haze: {preset: fog/kruse, visibility_m: 200}
  layer: {profile: {z_m: [0, 3], extinction_per_m: [0.1, [0.2, 0.1]]}, albedo: 1}
regions: [{medium: fog}, {medium: haze, below_z_m: 1}, {medium: layer, box: {min_m: [0, 0, 0], max_m: [9, 9, 3]}}]
lights:
  - {type: point, position_m: [5, 5, 2], power_w: 10, schedule: [[18:00, 06:00]]}
  - {type: sun, cover: clear}
photons: {emit: 1e3}
tallies: [{name: floor, type: plane, point_m: [0, 0, 0.5], normal: [0, 0, -1]}]
sensors:
  types: [{name: node, range_m: 8}, {name: camera, range_m: 8, view: {cone_deg: 60}, headings: 4}]
  candidates: {grid: {min_m: [2, 2, 1], max_m: [8, 8, 2], spacing_m: 2}, points: [[5, 5, 1]], mount: free}
  count: 2
conditions: {night: {lights.0.power_w: 5}}
placement: {over: null, interest: [{name: low, box: {min_m: [0, 0, 0], max_m: [9, 9, 1]}}]}
cameras: [{name: all, type: equirectangular, from_m: [5, 5, 1]}]
"""

# A change of the scene by the path of a key, and its value; DELETE takes the key away.
DELETE = object()
WRONG = [
    ("murk", 2), ("murk", DELETE), ("lights", DELETE), ("lights", []), ("sed", 1), ("seed", -1),
    ("seed", 1.5), ("seed", "one"), ("bands_nm", [550]), ("band_edges_nm", [400]),
    ("flight", "walk"), ("units", "lux"), ("domain.min_m", [0, 0]), ("domain.min_m", DELETE),
    ("domain.max_m", [0, 0, 2e9]), ("domain.sides", True), ("materials.wall.diffuse", 1.5),
    ("materials.wall.difuse", 0.5), ("geometry.0.box", DELETE), ("geometry.0.unit_m", 1),
    ("geometry.0.sphere", {"center_m": [0, 0, 0], "radius_m": 1}), ("media", []),
    ("media.fog.extinction_per_m", DELETE), ("media.fog.extinction_per_m", -1),
    ("media.fog.albedo", "high"), ("media.fog.visibility_m", 50), ("media.fog.phase", "forward"),
    ("media.fog.phase.1", {"hg": 1}), ("media.fog.phase.1", {"hg": 0.1, "table": "a.csv"}),
    ("media.haze.preset", DELETE), ("media.haze.mor_m", 100), ("media.layer.albedo", DELETE),
    ("media.layer.profile.z_m", []), ("media.fog", {}), ("regions.0.medium", DELETE),
    ("regions.0.wind_m_per_s", 3), ("regions.1.box", {"min_m": [0, 0, 0], "max_m": [1, 1, 1]}),
    ("lights.0.type", "lamp"), ("lights.0.type", DELETE), ("lights.0.power_w", DELETE),
    ("lights.0.radius_m", 1), ("lights.0.schedule", "sometimes"), ("lights.1.power_w", 3),
    ("lights.1.linke_turbidity", 0.5), ("photons.store", 100), ("photons.emit", 0),
    ("tallies.0.normal", DELETE), ("tallies.0.size", [1, 1, 1]), ("sensors.types", []),
    ("sensors.types.0.range_m", 0), ("sensors.types.0.headings", 4), ("sensors.target", 0.5),
    ("sensors.types.1.view", {"cone_deg": 60, "hfov_deg": 50}), ("sensors.types.1.view", {}),
    ("sensors.types.1.view", {"hfov_deg": 50}), ("sensors.candidates.grid.size", [2, 2, 2]),
    ("sensors.candidates.points", [[1, 2]]), ("sensors.one_per_site", 1), ("placement.method", "fast"),
    ("placement.weights", {"surface": 1}), ("placement.interest.0.scale", 2), ("cameras.0.name", DELETE),
    ("cameras.0.vfov_deg", 40), ("cameras.0.pixels", [640]), ("conditions", [])]


def changed(scene, path, value):
    scene = copy.deepcopy(scene)
    *parts, last = [int(p) if p.isdigit() else p for p in path.split(".")]
    at = scene
    for part in parts:
        at = at[part]
    if value is DELETE:
        del at[last]
    else:
        at[last] = value
    return scene


def run(*words):
    return subprocess.run([MURK, *words], capture_output=True, text=True)


def properties(schema):
    """Every object's properties, at any depth."""
    for key, value in schema.items() if isinstance(schema, dict) else enumerate(schema):
        if key == "properties" and schema.get("additionalProperties") is False:
            yield from value.items()
        if isinstance(value, (dict, list)):
            yield from properties(value)


printed = run("schema")
check(printed.returncode == 0 and not printed.stderr, printed.stderr)
schema = json.loads(printed.stdout)
jsonschema.Draft7Validator.check_schema(schema)
validator = jsonschema.Draft7Validator(schema)


def fault(tree):
    return next((f"{list(e.absolute_path)}: {e.message[:200]}" for e in validator.iter_errors(tree)), None)


def check_right():
    paths = sorted(glob.glob("scenes/*.yaml") + glob.glob("scenes/studies/*.yaml") +
                   glob.glob("scenes/start/*.yaml"))
    check(len(paths) > 12, len(paths), "scenes")
    for path in paths:
        found = fault(load(text_of(path)))
        check(not found, path, "is refused:", found)
    with tempfile.TemporaryDirectory() as folder:
        for name in ("smoke-hall", "slab"):
            out = os.path.join(folder, name)
            done = run("trace", f"scenes/{name}.yaml", "--emit", "50", "-q", "-o", out)
            check(done.returncode == 0, done.stderr)
            found = fault(load(text_of(os.path.join(out, "scene.resolved.yaml"))))
            check(not found, name, "as resolved is refused:", found)


def check_wrong():
    scene = load(SCENE)
    check(not fault(scene), "the scene is refused:", fault(scene))
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "scene.yaml")

        def says(tree):
            with open(path, "w", encoding="utf-8") as file:
                json.dump(tree, file) # JSON is YAML
            return run("check", path)

        done = says(scene)
        check(done.returncode == 0, "murk refuses the scene:", done.stderr)
        for i, (key, value) in enumerate(WRONG):
            wrong = changed(scene, key, value)
            shown = "left out" if value is DELETE else value
            check(fault(wrong), key, shown, "is accepted")
            if i % 4 == 0: # that murk refuses them, too, is for other tests
                check(says(wrong).returncode == 2, key, shown, "is accepted by murk")
    check(fault({"murk_study": 1, "base": "a.yaml", "axis": {}}), "a wrong study is accepted")
    check(fault([]) and fault("murk"), "a list or a text is accepted")


def check_descriptions():
    n = 0
    for name, value in properties(schema):
        n += 1
        meaning, _, values = value.get("description", "").partition("\n\nValue: ")
        check(meaning and values, name, "has no description")
    check(n > 250, n, "properties")
    count = schema["else"]["properties"]["sensors"]["properties"]["count"]
    check(count["minimum"] == 1 and count["maximum"] == 1000000 and "sensors" in count["description"] and
          "Number of sensors to place." in count["description"], count)


check_right()
check_wrong()
check_descriptions()
for words in (["a.yaml"], ["--set", "seed=2"]):
    check(run("schema", *words).returncode == 2, "murk schema", words)
print("ok" if failures == 0 else f"{failures} failures")
sys.exit(failures != 0)
