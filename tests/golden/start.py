#!/usr/bin/env python3
"""murk init from outside: each scene to start from is what lies in scenes/start,
names no file, passes murk check without a warning, and is placed in seconds with
a coverage that is worth having and that more sensors increase; what the comments
tell to try next runs, too. Standard library only.
usage: start.py MURK
"""

import glob
import json
import os
import re
import subprocess
import sys
import tempfile
import time

MURK = os.path.abspath(sys.argv[1])
NAMES = ["room", "street", "harbour", "smoke"]
FEW = ["--set", "placement.restarts=2", "--set", "placement.nodes=100"]
SECONDS = 60 # of one placement, on a machine that does much else
failures = 0


def check(holds, *text):
    global failures
    if not holds:
        print("start.py:", *text)
        failures += 1


def run(*words, cwd=None):
    done = subprocess.run([MURK, *words], capture_output=True, text=True, cwd=cwd)
    check(done.returncode in (0, 2), words, done.returncode, done.stderr)
    return done


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def coverage(folder, name, *options):
    begin = time.monotonic()
    done = run("place", name + ".yaml", "--format", "json", *options, cwd=folder)
    check(done.returncode == 0, name, options, done.stderr)
    check(time.monotonic() - begin < SECONDS, name, "takes", time.monotonic() - begin, "s")
    found = json.loads(done.stdout)["coverage"]
    return found["held_out"], found["ceiling"]


def check_text(name, text):
    check(text == text_of(f"scenes/start/{name}.yaml"), name, "is not what lies in scenes/start")
    lines = text.splitlines()
    check(all(len(line) <= 100 for line in lines), name, "has long lines")
    check(sum(line.lstrip().startswith("#") for line in lines) > 20, name, "has few comments")
    check(not re.search(r"^[^#]*\.(obj|vdb|csv|ply|yaml)\b", text, re.M), name, "names a file")


def check_runs(folder, name):
    checked = run("check", name + ".yaml", cwd=folder)
    check(checked.returncode == 0 and not checked.stderr, name, checked.stderr)
    held_out, most = coverage(folder, name, "--emit", "2000", *FEW)
    check(0.1 < held_out < most <= 1, name, "covers", held_out, "of", most)
    more, _ = coverage(folder, name, "--emit", "2000", "--count", "8", *FEW)
    check(held_out < more < most, name, "covers", more, "with eight sensors,", held_out, "with fewer")


def check_comments(folder, name, text):
    """The commands of the comments, but those of results that are not there."""
    commands = re.findall(r"^#   murk (place|trace|check) \w+\.yaml ?(.*)$", text, re.M)
    check(len(commands) >= 4, name, "has few commands")
    for command, words in commands:
        options = re.split(r"  +", words)[0].split()
        less = [] if command == "check" else ["--emit", "500", "-q"]
        done = run(command, name + ".yaml", *options, *less, *(FEW if command == "place" else []), cwd=folder)
        check(done.returncode == 0 and not done.stderr, command, name, words, done.stderr)
    for key in re.findall(r"murk help ([a-z_.]+[a-z])$", text, re.M):
        check(run("help", key).returncode == 0, "murk help", key)


with tempfile.TemporaryDirectory() as temporary:
    check(sorted(NAMES) == sorted(os.path.basename(p)[:-5] for p in glob.glob("scenes/start/*.yaml")), "names")
    for scene in NAMES:
        written = run("init", scene).stdout
        with open(os.path.join(temporary, scene + ".yaml"), "w", encoding="utf-8") as out:
            out.write(written)
        check_text(scene, written)
        check_runs(temporary, scene)
        check_comments(temporary, scene, written)
    check(run("init").stdout == run("init", "room").stdout, "the default is no room")
    wrong = run("init", "hrabour")
    check(wrong.returncode == 2 and not wrong.stdout and "did you mean harbour?" in wrong.stderr, wrong.stderr)
    wrong = run("init", "--set", "seed=2")
    check(wrong.returncode == 2 and not wrong.stdout, wrong.stderr)
print("ok" if failures == 0 else f"{failures} failures")
sys.exit(failures != 0)
