#!/usr/bin/env python3
"""`identity` in the main JSON says whether two results follow from the same
input: it is the same in any folder, by any way of naming the scene, and another
one as soon as a file that the scene names has other contents. `files` lists
names, not paths. Standard library only.
usage: identity.py MURK
"""

import json
import os
import subprocess
import sys
import tempfile

import from_outside
from from_outside import check

MESH = "v 1 1 1\nv 2 1 1\nv 2 2 %s\nf 1 2 3\n"
SCENE = """\
murk: 1
bands_nm: [550]
domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}
geometry: [{file: mesh/tri.obj}]
media: {fog: {extinction_per_m: 0.3, albedo: 0.9, phase: {hg: 0.6}}}
regions: [{medium: fog}]
lights: [{type: point, position_m: [2, 2, 2.5], power_w: 10}]
photons: {emit: 300}
conditions:
  calm: {}
  windy: {media.fog.phase: {table: turns.csv}}
sensors:
  types: [{name: node, range_m: 3}]
  candidates: {points: sites.csv}
  count: 1
placement: {over: mean}
cameras: [{name: eye, from_m: [3, 3, 2], to_m: [1, 1, 1], pixels: [4, 3], samples: 1}]
"""
FILES = {"scene.yaml": SCENE, "mesh/tri.obj": MESH % 1.5,
         "turns.csv": "angle_deg,phase_per_sr\n1,9\n90,0.1\n180,0.05\n",
         "sites.csv": "x_m,y_m,z_m\n1,3,1\n3,3,1\n3,1,2\n",
         "profile.csv": "z_m,extinction_per_m\n0,0.2\n1,0.1\n",
         "study.yaml": "{murk_study: 1, base: scene.yaml, mode: grid,\n"
                       " outputs: [density, fluence_vdb], axes: {condition: [calm], seed: [1, 2]}}\n"}
CHANGES = {"mesh/tri.obj": MESH % 1.75, "turns.csv": FILES["turns.csv"].replace("9", "8"),
           "sites.csv": FILES["sites.csv"] + "1,1,2\n"}


class Machine:
    """A folder with the scene, and whether its commands name files from the root
    (as if on another machine) or from within the folder."""

    def __init__(self, program, folder, is_absolute):
        self.program, self.folder, self.is_absolute = program, folder, is_absolute
        for name, text in FILES.items():
            self.write(name, text)

    def path(self, name):
        return os.path.join(self.folder, name) if self.is_absolute else name

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)

    def run(self, *words):
        words = [self.path(w[1:]) if w.startswith("@") else w for w in words]
        done = subprocess.run([self.program, *words, "--format", "json"], capture_output=True, text=True,
                              cwd="/" if self.is_absolute else self.folder, timeout=60, check=False)
        check(done.returncode == 0, words, done.stderr)
        return json.loads(done.stdout)

    def results(self):
        """Of each command: its identity, and the names under `files`."""
        found = {}
        for name, words in COMMANDS.items():
            result = self.run(*words)
            found[name] = result["identity"], sorted(result.get("files", {}))
        return found


COMMANDS = {
    "check": ["check", "@scene.yaml"],
    "trace": ["trace", "@scene.yaml", "-o", "@trace"],
    "place": ["place", "@scene.yaml", "-o", "@place"],
    "render": ["render", "@scene.yaml", "--method", "path", "-o", "@eye.exr"],
    "study": ["study", "@study.yaml", "-o", "@study"],
    "media": ["media", "--profile", "@profile.csv", "-o", "@grid.vdb"],
    "report": ["report", "@place"],
}


def main():
    with tempfile.TemporaryDirectory() as top:
        program = os.path.abspath(sys.argv[1])
        here = Machine(program, os.path.join(top, "here"), False)
        there = Machine(program, os.path.join(top, "there", "deep"), True)
        one, other = here.results(), there.results()
        for name in COMMANDS:
            check(one[name] == other[name], name, "in two folders:", one[name], other[name])
            check(not any("/" in file for file in one[name][1] + other[name][1]), name, one[name])
        check(one["render"][1] == ["eye.exr"], one["render"])
        check(one["media"][1] == ["grid.vdb"], one["media"])
        check(one["report"][1] == ["report.html"], one["report"])
        check(len({identity for identity, _ in one.values()}) == len(one), "one of two commands:", one)
        for name, text in CHANGES.items():
            there.write(name, text)
            changed = there.run(*COMMANDS["place"][:2])["identity"]
            check(changed != other["place"][0], name, "may change unnoticed")
            there.write(name, FILES[name])
        there.write("mesh/tri.obj", CHANGES["mesh/tri.obj"])
        for name in ("check", "trace", "render", "study"):
            check(there.run(*COMMANDS[name])["identity"] != other[name][0], name, "of another mesh")
        there.write("mesh/tri.obj", FILES["mesh/tri.obj"])
        check(there.run(*COMMANDS["place"])["identity"] == other["place"][0], "the mesh as it was")
        again = there.run(*COMMANDS["place"], "--seed", "2")["identity"]
        check(again != other["place"][0], "another seed")
    return from_outside.failures != 0


if __name__ == "__main__":
    sys.exit(main())
