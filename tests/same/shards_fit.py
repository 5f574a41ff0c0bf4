"""Parts of a fit (--shard K/N), merged by murk merge, give every file of a single run (JSON: all values) but `run`: for 1,
2, 3 and 5 parts, in any order, repeated, missing, with several numbers of threads, with starts that trace light of their
own, restarts and proposals. Parts that do not belong together are refused in one line, and nothing is written then.

    shards_fit.py MURK
"""
import json
import os
import shutil
import sys
import tempfile

import shards
from shards import TOP, check, done, murk, refused, same

COVERAGE = ["scenes/calibrate-coverage.yaml", "--data", "scenes/calibrate/coverage.csv", "--free", "media.fog.visibility_m",
            "--emit", "500"]
FOG = ["scenes/calibrate-fog.yaml", "--data", "scenes/calibrate/fog.csv", "--emit", "3000", "--free",
       "media.fog.extinction_per_m,media.fog.phase.hg"]
RUNS = [
    # the readings refuse the model, so that restarts are run
    [*COVERAGE, "--set", "placement.detection=independent"],
    [*FOG, "--next", "2", "--starts", "3"],
]
def fields_of(folder):
    with open(os.path.join(folder, "fit.json"), encoding="utf-8") as file:
        return json.load(file)


def part(folder, k, n, run):
    path = os.path.join(folder, f"part-{k}-of-{n}")
    done("fit", *run, "--shard", f"{k}/{n}", "-o", path, "-q", "-j", str(1 + k % 3))
    return path


def parts_are_the_run(folder, run, counts):
    whole = os.path.join(folder, "whole")
    done("fit", *run, "-o", whole, "-q")
    for n in counts:
        parts = [part(folder, k, n, run) for k in range(1, n + 1)]
        merged = os.path.join(folder, f"merged-{n}")
        ran = done("merge", *reversed(parts), parts[0], "-o", merged, "-q")
        check("missing" not in ran.stderr, f"{n} parts: {ran.stderr}")
        same(whole, merged, f"{run} of {n} parts")
        if n > 2:
            shutil.rmtree(merged)
            ran = done("merge", *parts[:1], *parts[2:], "-o", merged, "-j", "1")
            check(f"1 of {n} parts are missing (2)" in ran.stderr, f"the missing part is named: {ran.stderr}")
            same(whole, merged, f"{run} of {n} parts without the second")
    return fields_of(whole)


def replaced(path, old, new):
    with open(path, encoding="utf-8") as file:
        text = file.read()
    check(old in text, f"{old} in {path}")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text.replace(old, new))


def others_are_refused(folder):
    first, second = (part(folder, k, 2, COVERAGE) for k in (1, 2))
    other = os.path.join(folder, "other")
    os.mkdir(other)
    refused(folder, [first, part(other, 2, 2, [*COVERAGE, "--bounds", "media.fog.visibility_m=10:90"])],
            'its command has "--bounds" where that of', first)
    refused(folder, [first, part(folder, 2, 3, COVERAGE)], "part 2 of 3, other parts are of 2")
    # scene and readings that were edited in between
    scene, data = os.path.join(folder, "edited.yaml"), os.path.join(folder, "edited.csv")
    shutil.copy(os.path.join(TOP, COVERAGE[0]), scene)
    shutil.copy(os.path.join(TOP, COVERAGE[2]), data)
    os.mkdir(os.path.join(folder, "old"))
    old = part(os.path.join(folder, "old"), 1, 1, [scene, "--data", data, *COVERAGE[3:]])
    with open(data, "a", encoding="utf-8") as file:
        file.write("# one line more\n")
    refused(folder, [old], "made for other readings", data)
    shutil.copy(os.path.join(TOP, COVERAGE[2]), data)
    replaced(scene, "seed: 1", "seed: 2")
    refused(folder, [old], "made for another scene", "seed: 1", "seed: 2")
    # damaged and missing files, that of another start
    spoilt = os.path.join(folder, "spoilt")
    shutil.copytree(second, spoilt)
    name = os.path.join(spoilt, "starts.part")
    with open(name, "r+b") as file:
        file.truncate(os.path.getsize(name) - 8)
    refused(folder, [first, spoilt], name)
    shutil.copy(os.path.join(second, "starts.part"), name)
    with open(name, "r+b") as file:
        file.seek(-8, os.SEEK_END)
        file.write(b"\0" * 8)
    refused(folder, [first, spoilt], name)
    os.remove(name)
    refused(folder, [first, spoilt], name)


def wrong_options(folder):
    fit = os.path.join(folder, "fit.json")
    for words, text in (([*COVERAGE, "--starts", "1"], "--shard: divides the searches of a fit, and --starts 1"),
                        ([*COVERAGE[:3], "--predict", fit], "--shard: divides the searches of a fit, and --predict")):
        out = os.path.join(folder, "no")
        ran = murk("fit", *words, "--shard", "1/2", "-o", out)
        check(ran.returncode == 2 and text in ran.stderr, f"{words}: {ran.stderr}")
        check(len(ran.stderr.splitlines()) == 1 and not os.path.exists(out), f"{words} writes nothing")


with tempfile.TemporaryDirectory() as top:
    found = []
    for i, each in enumerate(RUNS):
        os.mkdir(os.path.join(top, str(i)))
        found.append(parts_are_the_run(os.path.join(top, str(i)), each, (1, 2, 3, 5) if i == 0 else (2, 3)))
    # teeth: there were restarts, and starts that traced light and that did not
    starts = found[0]["starts"]
    check(len(starts) > 4, f"{len(starts)} starts, of which none is a restart")
    check({start["traces"] > 0 for start in starts[1:]} == {True, False}, "starts with and without light of their own")
    others = os.path.join(top, "others")
    os.mkdir(others)
    others_are_refused(others)
    wrong_options(others)
print("shards of a fit:", f"{shards.failures} failures" if shards.failures else "all as it should be")
sys.exit(shards.failures > 0)
