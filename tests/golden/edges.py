#!/usr/bin/env python3
"""The program at the edges of its surroundings: names with terminal control
characters, a reader that leaves, threads that cannot be started, folders that
may not be written into, file names that look like options. Standard library
only.
usage: edges.py MURK [FEW_THREADS.so]
"""

import json
import os
import pwd
import subprocess
import sys
import tempfile

MURK = os.path.abspath(sys.argv[1])
FEW_THREADS = os.path.abspath(sys.argv[2]) if len(sys.argv) > 2 else None
failures = 0
# ESC, a line feed, and CSI as one character of Latin-1
NASTY = "no\033[31mde\nplan 9\u009b2J"
YAML_NASTY = '"no\\e[31mde\\nplan 9\\x9b2J"'
SHOWN = r"no\x1b[31mde\nplan 9\xc2\x9b2J"
SCENE = """\
murk: 1
domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}
geometry: [{box: {min_m: [0.1, 0.1, 0.1], max_m: [3.9, 3.9, 2.9]}}]
lights: [{type: point, position_m: [2, 2, 2.5], power_w: 10}]
photons: {emit: 1000}
sensors:
  types: [{name: NASTY, range_m: 3}]
  candidates: {grid: {min_m: [0.5, 0.5, 0.5], max_m: [3.5, 3.5, 2.5], size: [4, 4, 3]}}
  count: 2
"""
# droplets at so many wavelengths that several threads solve them
FOG = """\
murk: 1
bands_nm: [400, 450, 500, 550, 600, 650, 700, 750]
domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}
media: {fog: {preset: fog/radiation, visibility_m: 80}}
regions: [{medium: fog}]
lights: [{type: point, position_m: [2, 2, 2.5], power_w: 10}]
photons: {emit: 10}
"""


def check(holds, *text):
    global failures
    if not holds:
        print("edges.py:", *text)
        failures += 1


def run(*words, **more):
    return subprocess.run([MURK, *words], capture_output=True, **more)


def controls(sent):
    """Bytes that a terminal acts on, but for the ends of lines."""
    text = sent.decode("utf-8", "surrogateescape")
    return [c for c in text if c != "\n" and (ord(c) < 32 or 127 <= ord(c) < 160 or ord(c) > 0xd7ff)]


def check_names(scene):
    for words in (["check", scene], ["place", scene], ["check", scene, "--format", "json"],
                  ["place", scene, "--format", "json"], ["check", NASTY], [NASTY],
                  ["check", scene, "--set", f"{NASTY}=1"], ["check", scene, "--" + NASTY],
                  ["check", scene, "--set", f"sensors.types.0.{NASTY}=1"],
                  ["check", scene, "--seed", NASTY], ["media", NASTY],
                  ["check", b"\xff\xfe\x1b]0;"], ["report", NASTY]):
        done = run(*words, cwd=os.path.dirname(scene))
        check(not controls(done.stdout + done.stderr), words, "sends", done.stdout + done.stderr)
        check(done.returncode == 0 or done.stderr.count(b"\n") == 1, words, done.stderr)
        if "json" in words:
            types = [kind["type"] for kind in json.loads(done.stdout).get("sensors", [])]
            check(set(types) == {NASTY}, words, "names of types:", types)
        elif words[0] in ("check", "place") and done.returncode == 0:
            check(SHOWN in done.stdout.decode(), words, "does not show the name:", done.stdout)


def check_keys(folder):
    """Keys of a file and of --set are shown with the same escapes as all else."""
    path = os.path.join(folder, "keys.yaml")
    for text in (f"murk: 1\n{YAML_NASTY}: 3\n", SCENE.replace("murk: 1", "murk: 1\nmaterials: {default: {%s: 1}}" % YAML_NASTY),
                 SCENE.replace("count: 2", f"count: 2\n  {YAML_NASTY}: 1")):
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        done = run("check", path)
        check(SHOWN in done.stderr.decode() and done.returncode == 2, text, "says", done.stderr)
    with open(path, "w", encoding="utf-8") as file:
        file.write(SCENE.replace("NASTY", "node"))
    for key in (NASTY, f"sensors.types.0.{NASTY}", f"lights.{NASTY}.power_w"):
        done = run("check", path, "--set", f"{key}=1")
        reason = done.stderr.decode().split("=1: ", 1)[-1]
        check(SHOWN in reason and done.returncode == 2, key, "says", done.stderr)


def check_closed_output(scene):
    """What is asked for is written, and nothing is said."""
    for words in (["check", scene, "--format", "json"], ["check", scene], ["--help"]):
        reading, writing = os.pipe()
        os.close(reading)
        done = subprocess.run([MURK, *words], stdout=writing, stderr=subprocess.PIPE)
        os.close(writing)
        check(done.returncode == 141 and done.stderr == b"", words, done.returncode, done.stderr)
    if os.path.exists("/dev/full"):
        with open("/dev/full", "w") as full:
            done = subprocess.run([MURK, "check", scene], stdout=full, stderr=subprocess.PIPE)
        check(done.returncode == 1 and b"cannot write to standard output" in done.stderr, done)


def check_end_of_options(folder):
    name = "-q"
    with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
        file.write(SCENE.replace("NASTY", "node"))
    done = run("check", "--", name, cwd=folder)
    check(done.returncode == 0 and b"scene" in done.stdout, "-- -q:", done)
    done = run("check", "--", "--format", cwd=folder)
    check(done.returncode == 2 and b"--format: cannot read" in done.stderr, "-- --format:", done)
    done = run("trace", "-o", "--", name, cwd=folder)  # a value of -o
    check(b"one scene" not in done.stderr and b"no scene" in done.stderr, "-o --:", done)


def check_folders(scene, folder):
    """As a user who may not write there: root may write anywhere."""
    nobody = pwd.getpwnam("nobody").pw_uid if os.getuid() == 0 else None
    closed = os.path.join(folder, "closed")
    os.mkdir(closed, 0o555)
    os.chmod(folder, 0o755)
    for out in (closed + "/a/b", closed + "/a"):
        done = run("trace", scene, "-o", out, user=nobody)
        want = f"murk: {out}: cannot make the folder: {closed} may not be written into: "
        check(done.returncode == 1 and done.stderr.decode().startswith(want), done)
    done = run("trace", scene, "-o", closed, user=nobody)
    check(b": cannot write into the folder: Permission" in done.stderr, done)
    picture = closed + "/x.exr"
    done = run("render", "scenes/paper-room.yaml", "--method", "path", "--samples", "1",
               "--pixels", "4x3", "-o", picture, user=nobody)
    check(f"{closed} may not be written into: " in done.stderr.decode(), done)
    done = run("trace", scene, "-o", scene + "/x")
    check(b"Not a directory" in done.stderr, done)


def threads_asked(folder, *words):
    path = os.path.join(folder, "asked")
    done = run(*words, env=dict(os.environ, LD_PRELOAD=FEW_THREADS, THREADS_ASKED=path))
    check(done.returncode == 0, words, done.stderr)
    with open(path, encoding="utf-8") as file:
        return int(file.read())


def check_threads(folder):
    """However many the machine gives: done, or one line and exit 1."""
    scene = os.path.join(folder, "fog.yaml")
    with open(scene, "w", encoding="utf-8") as file:
        file.write(FOG)
    of_libraries = threads_asked(folder, "--version")
    # reading the preset is work, too: --threads 1 starts no thread for it
    check(threads_asked(folder, "check", scene, "-j", "1") == of_libraries, "-j 1 starts threads")
    check(threads_asked(folder, "check", scene, "-j", "2") > of_libraries, "-j 2 starts none")
    said = set()
    for few in sorted({0, 1, of_libraries - 1, of_libraries, of_libraries + 1, of_libraries + 2,
                       of_libraries + 3, 1000}):
        done = run("check", scene, "-j", "4",
                   env=dict(os.environ, LD_PRELOAD=FEW_THREADS, FEW_THREADS=str(few)))
        lines = done.stderr.decode().splitlines()
        if few >= of_libraries + 3:
            check(done.returncode == 0 and not lines, few, "threads:", done)
        else:
            check(done.returncode == 1 and len(lines) == 1, few, "threads:", done)
            check("Resource temporarily unavailable" in lines[0], lines)
            said.add(lines[0].split(":")[1].split(",")[0])
    check("threads cannot be started" and " cannot start 4 threads" in said, said)


os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
with tempfile.TemporaryDirectory() as temporary:
    path = os.path.join(temporary, "s.yaml")
    with open(path, "w", encoding="utf-8") as file:
        file.write(SCENE.replace("NASTY", YAML_NASTY))
    check_names(path)
    check_keys(temporary)
    check_closed_output(path)
    check_end_of_options(temporary)
    check_folders(path, temporary)
    if FEW_THREADS:
        check_threads(temporary)
print("as it should be" if failures == 0 else f"{failures} failures")
sys.exit(failures != 0)
