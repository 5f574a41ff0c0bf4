#!/usr/bin/env python3
"""What murk render refuses: one line that names the option or place, exit 2 (1 where the run
failed), nothing written; and what it takes, however odd. Bounded time and memory.
usage: render.py MURK [SANITIZE]
"""

import os
import resource
import subprocess
import sys
import tempfile

SCENE = """murk: 1
bands_nm: [450, 550]
domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}
geometry: [{box: {min_m: [0, 0, 0], max_m: [4, 4, 3]}, material: wall}]
materials: {wall: {diffuse: 0.5}}
lights: [{type: sphere, center_m: [1, 3, 2.5], radius_m: 0.2, power_w: 50}]
photons: {emit: 100}
sensors: {types: [{name: node, range_m: 2.5}], count: 1}
cameras:
  - {name: gate, from_m: [1, 1, 1], to_m: [3, 3, 1], pixels: [8, 6], samples: 1}
  - {name: "../a/b", from_m: [1, 1, 1], to_m: [3, 3, 1], pixels: [8, 6], samples: 1}
"""
SENSORS = "type,x_m,y_m,z_m\nnode,1,1,1\nnode,3,3,1\n"
MEMORY = 2 << 30
failures = 0

S = ("--sensors", "s.csv")
F = ("--false-colour", "Z")
REFUSED = [
    ("--from-sensor: goes with --sensors FILE", "--from-sensor", "1"),
    ("--from-sensor: 0, must be", *S, "--from-sensor", "0"),
    ("--from-sensor: -1, must be", *S, "--from-sensor", "-1"),
    ("--from-sensor: 3, must be 1..2: s.csv has no more", *S, "--from-sensor", "3"),
    ("--pixels: 8, must be WIDTHxHEIGHT", "--pixels", "8"),
    ("--pixels: 0x8, must be", "--pixels", "0x8"),
    ("--pixels: 8x, must be", "--pixels", "8x"),
    ("--pixels: 8x6x4, must be", "--pixels", "8x6x4"),
    ("--pixels: -8x6, must be", "--pixels", "-8x6"),
    ("--pixels: 65536x65536, must be", "--pixels", "65536x65536"),
    ("--pixels: 18446744073709551617x1, must be", "--pixels", "18446744073709551617x1"),
    ("--samples: 0, must be", "--samples", "0"),
    ("--samples: 65537, must be", "--samples", "65537"),
    ("--exposure: goes with --png", "--exposure", "1"),
    ("--exposure: nan, must be a number of stops", "--png", "--exposure", "nan"),
    ("--exposure: 1e9, must be", "--png", "--exposure", "1e9"),
    ("--exposure: 1f, must be", "--png", "--exposure", "1f"),
    ("--png: takes no value", "--png=x"),
    ("--false-colour: heat is no channel", "--false-colour", "heat"),
    ("there are S0.450nm, error.450nm", "--false-colour", "heat"),
    ("--false-colour: depth is no channel of the picture, or one in several bands",
     "--false-colour", "depth"),
    ("--false-colour: depth.600nm is no channel", "--false-colour", "depth.600nm"),
    ("--false-colour: " + "x" * 48 + " is no", "--false-colour", "x" * 5000),
    ("--false-colour:  is no channel", "--false-colour", ""),
    ("--false-colour: coverage.count, which pictures have with --sensors",
     "--false-colour", "coverage.count"),
    ("--range: goes with --false-colour", "--range", "1:2"),
    ("--range: 2:1, must be LOW:HIGH", *F, "--range", "2:1"),
    ("--range: 1:1, must be", *F, "--range", "1:1"),
    ("--range: 1, must be", *F, "--range", "1"),
    ("--range: 1:, must be", *F, "--range", "1:"),
    ("--range: nan:1, must be", *F, "--range", "nan:1"),
    ("--range: 0:inf, must be", *F, "--range", "0:inf"),
    ("--range: 0:1, must be above 0 with --scale log", *F, "--range", "0:1", "--scale", "log"),
    ("--scale: goes with --false-colour", "--scale", "log"),
    ("--scale: cubic, must be linear | log", *F, "--scale", "cubic"),
    ("-o: x.png: the image is OpenEXR", "-o", "x.png"),
    ("nothing.csv", "--sensors", "nothing.csv"),
    ("bad.csv:2", "--sensors", "bad.csv"),
    ("cameras: the scene has none", *S, "--set", "cameras=[]"),
    ("gete is no camera of the scene", *S, "--from-sensor", "1", "--camera", "gete"),
    ("from_m is [9, 1, 1] m, must be within the domain, [0, 0, 0]..[4, 4, 3] m",
     "--set", "cameras.0.from_m=[9, 1, 1]"),
    ("fisheye, must be perspective, equirectangular",
     "--set", "cameras.0.type=fisheye"),
    ("cameras.0: misses width_m", "--set",
     "cameras=[{name: a, type: orthographic, from_m: [1, 1, 1], to_m: [3, 3, 1]}]"),
    ("cameras.0.width_m: 0, must be more than 0", "--set",
     "cameras=[{name: a, type: orthographic, from_m: [1, 1, 1], to_m: [3, 3, 1], width_m: 0}]"),
    ("cameras.0.width_m: -2, must be more than 0", "--set",
     "cameras=[{name: a, type: orthographic, from_m: [1, 1, 1], to_m: [3, 3, 1], width_m: -2}]"),
    ("cameras.0.width_m=3: not a key of a camera (perspective)",
     "--set", "cameras.0.width_m=3"),
    ("normal is [0, 0, 0], must have a length",
     "--set", "cameras.0.clip={point_m: [1, 1, 1], normal: [0, 0, 0]}"),
    ("misses normal, must be [x, y, z]",
     "--set", "cameras.0.clip={point_m: [1, 1, 1]}"),
    ("cameras.0.vfov_deg: not a key of a camera (equirectangular)",
     "--set", "cameras=[{name: a, type: equirectangular, from_m: [1, 1, 1], vfov_deg: 45}]"),
    # what the image's format does not take: two channels of one name
    ("bands_nm: bands 2 and 3 are at 550.00001 and 550.00002 nm, must differ within 7 digits",
     "--set", "bands_nm=[450, 550.00001, 550.00002]"),
]
TAKEN = [
    ("--set", "bands_nm=[550.0001, 550.0002]"),
    ("--png", "--exposure", "-100"),
    ("--png", "--exposure", "100"),
    (*F, "--range=-1e308:1e308"),
    (*F, "--range", "1e-300:1e300", "--scale", "log"),
    (*F, "--range", "1:1.0000000001"),
    ("--false-colour", "error.450nm", "--pixels", "1x1"),
    ("--false-colour", "P.X", "--pixels", "1x40", "--png"),
    ("--false-colour", "volume.550nm", "--pixels", "3000x1"),
    (*S, "--false-colour", "coverage.count", "--pixels", "1x1"),
    (*S, "--from-sensor", "2", "--false-colour", "coverage.clarity", "--pixels", "5x3"),
    ("--camera", "../a/b", "--png"),
    ("--set", "lights.0.power_w=0", "--png", "--false-colour", "radiance.450nm"),
    ("--set", "cameras=[{name: a, type: equirectangular, from_m: [1, 1, 1], pixels: [1, 1]}]"),
]


def check(holds, *what):
    global failures
    if not holds:
        failures += 1
        print("not so:", *what)


def main(murk, is_sanitized):
    def limit():
        if not is_sanitized:
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))

    with tempfile.TemporaryDirectory() as folder:
        inputs = {"scene.yaml": SCENE, "s.csv": SENSORS,
                  "bad.csv": "type,x_m,y_m,z_m\nnode,9,1,1\n",
                  "edges.yaml": SCENE.replace("bands_nm: [450, 550]",
                                              "band_edges_nm: [550, 550.00001, 550.00002]"),
                  "none.yaml": "\n".join(x for x in SCENE.split("\n") if "sensors" not in x)}

        def run(*arguments, scene="scene.yaml"):
            for name, text in inputs.items():
                with open(os.path.join(folder, name), "w", encoding="ascii") as file:
                    file.write(text)
            done = subprocess.run([murk, "render", scene, *arguments], cwd=folder, text=True,
                                  capture_output=True, check=False, timeout=60, preexec_fn=limit)
            made = sorted(set(os.listdir(folder)) - set(inputs))
            for name in made:
                os.unlink(os.path.join(folder, name))
            return done, made

        for part, *arguments in REFUSED:
            done, made = run(*arguments)
            check(done.returncode == 2, arguments, "exit", done.returncode, done.stderr)
            check(done.stderr.count("\n") == 1 and part in done.stderr,
                  "one line with", part, "not", done.stderr)
            check(not made, arguments, "made", made)
        for arguments in TAKEN:
            done, made = run("--method", "path", *arguments)
            check(done.returncode == 0 and "warning" not in done.stderr, arguments, "exit", done.returncode,
                  done.stderr)
            want = 1 + ("--png" in arguments) + ("--false-colour" in arguments)
            check(len(made) == want, arguments, "made", made)

        # kernels of a handful of records; a map that is empty, as there is no medium, is none
        done, made = run("--emit", "20", "--quiet")
        check(done.returncode == 0 and not done.stderr, done.stderr)
        done, made = run("--emit", "20")
        check(done.returncode == 0 and "murk: warning: photons: " in done.stderr
              and " in the surface map" in done.stderr and "fewer than 25: " in done.stderr
              and done.stderr.count("warning") == 1, done.stderr)
        done, made = run("--emit", "2000")
        check(done.returncode == 0 and "warning" not in done.stderr, done.stderr)

        done, made = run(*S, scene="none.yaml")
        check(done.returncode == 2 and "sensors: the scene has none" in done.stderr, done.stderr)
        done, made = run(scene="edges.yaml")
        check(done.returncode == 2 and "band_edges_nm: bands 1 and 2 are at 550.000005 and" in done.stderr
              and done.stderr.count("\n") == 1 and not made, done.stderr, made)
        # more than the memory there is: refused before anything is traced
        if not is_sanitized:
            done, made = run("--pixels", "8192x8192")
            check(done.returncode == 1 and "the picture takes 5.65 GB" in done.stderr, done.stderr)
            check(not made, "made", made)
        # a folder that cannot be written, a PNG whose place is taken by a folder: seen before
        # any work, as these photons would take hours
        done, made = run("--emit", "4e9", "-o", "none/x.exr")
        check(done.returncode == 1 and done.stderr.count("\n") == 1, done.returncode, done.stderr)
        os.mkdir(os.path.join(folder, "x.png"))
        inputs_and = subprocess.run(
            [murk, "render", "scene.yaml", "--emit", "4e9", "-o", "x.exr", "--png"], cwd=folder,
            text=True, capture_output=True, check=False, timeout=60)
        check(inputs_and.returncode != 0 and "x.png" in inputs_and.stderr, inputs_and.stderr)
        check(not os.path.exists(os.path.join(folder, "x.exr")), "an image without its PNG")


if __name__ == "__main__":
    main(os.path.abspath(sys.argv[1]), len(sys.argv) > 2 and sys.argv[2] != "")
    sys.exit(failures != 0)
