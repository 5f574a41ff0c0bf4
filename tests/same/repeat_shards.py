"""Parts of the seeds of murk place --repeat (--shard K/M), merged by murk merge, give every file of a single run (JSON:
all values) but `run`: for 1 to 7 parts, in any order, repeated, missing, over conditions, in the dark. Parts that do not
belong together are refused in one line, and nothing is written then.

    repeat_shards.py MURK
"""
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import shards
from run_files import content
from shards import MURK, TOP, check, done, murk, refused, same

ROOM = ["scenes/paper-room.yaml", "--emit", "1000", "--count", "2"]
SMALL = """murk: 1
domain: {min_m: [0, 0, 0], max_m: [3, 2, 1]}
media: {fog: {extinction_per_m: 1, albedo: 0.9}}
regions: [{medium: fog}]
lights: [{type: point, position_m: [1, 1, 0.5], power_w: 6}]
sensors: {types: [{name: node, range_m: 2}], candidates: {points: places.csv}, count: 2}
photons: {emit: 2000}
"""
CONDITIONS = "conditions: {clear: {}, thick: {media.fog.extinction_per_m: 3}}\nplacement: {over: worst}\n"


def part(folder, k, n, run):
    path = os.path.join(folder, f"part-{k}-of-{n}")
    done("place", *run, "--shard", f"{k}/{n}", "-o", path, "-q", "-j", str(1 + k % 2))
    return path


def write(folder, name, text):
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def scene_in(folder, text):
    write(folder, "places.csv", "x_m,y_m,z_m\n1.5,1,0.5\n0.5,0.5,0.5\n2.5,1,0.2\n0.3,1.7,0.8\n")
    return write(folder, "small.yaml", text)


def parts_are_the_run(folder, run, counts):
    os.makedirs(folder, exist_ok=True)
    whole = os.path.join(folder, "whole")
    done("place", *run, "-o", whole, "-q")
    for n in counts:
        parts = [part(folder, k, n, run) for k in range(1, n + 1)]
        check(sorted(os.listdir(parts[0])) == ["part.txt", "repeat.part"], f"files of a part: {os.listdir(parts[0])}")
        merged = os.path.join(folder, f"merged-{n}")
        ran = done("merge", *reversed(parts), parts[0], "-o", merged, "-q")
        check("missing" not in ran.stderr, f"{n} parts: {ran.stderr}")
        same(whole, merged, f"{run} of {n} parts")
        if n > 2:
            shutil.rmtree(merged)
            ran = done("merge", *parts[:1], *parts[2:], "-o", merged, "-j", "1")
            check(f"1 of {n} parts are missing (2): their seeds are run now" in " ".join(ran.stderr.split()),
                  f"the missing part is named: {ran.stderr}")
            same(whole, merged, f"{run} of {n} parts without the second")
    # Without -o the same is printed as by the run itself, but for the times.
    printed = [done(*words).stdout.split("\ntime ")[0] for words in (["merge", *parts], ["place", *run])]
    check(printed[0] == printed[1] and "repeat  " in printed[0], f"printed by merge: {printed}")


def a_seed_that_fails_ends_the_merge(folder):
    """Seed 11 cannot reach the target: the part of it is not written, and merge ends as the single run does."""
    run = [scene_in(folder, SMALL), "--target", "0.59", "--seed", "9", "--repeat", "5"]
    whole, merged, lost = (os.path.join(folder, name) for name in ("whole", "merged", "lost"))
    first = part(folder, 1, 2, run)
    ran = [murk("place", *run, "-o", whole, "-q"), murk("place", *run, "--shard", "2/2", "-o", lost),
           murk("merge", first, "-o", merged, "-q")]
    check([each.returncode for each in ran] == [2, 2, 2], f"exits: {ran}")
    check(all("seed 11: target 0.59 cannot be reached" in each.stderr for each in ran), f"seed 11: {ran}")
    check(os.listdir(lost) == [], f"no part: {os.listdir(lost)}")
    with open(os.path.join(whole, "repeat.csv"), encoding="utf-8") as file:
        check(len(file.readlines()) == 3, "a head and two seeds")
    same(whole, merged, "up to the seed that fails")


def nothing_is_repeated_in_the_dark(folder):
    run = [scene_in(folder, SMALL.replace("power_w: 6", "power_w: 0")), "--repeat", "3"]
    whole, merged = os.path.join(folder, "whole"), os.path.join(folder, "merged")
    done("place", *run, "-o", whole, "-q")
    ran = done("merge", part(folder, 2, 2, run), "-o", merged)
    check("it is dark" in ran.stderr and "missing" not in ran.stderr, f"dark: {ran.stderr}")
    same(whole, merged, "in the dark")


def others_are_refused(folder, scene):
    run = [scene, "--repeat", "4"]
    first, second = (part(folder, k, 2, run) for k in (1, 2))
    seed = part(os.path.join(folder, "seed"), 2, 2, [*run, "--seed", "9"])
    refused(folder, [first, seed], 'its command has "--seed" where that of', first)
    more = part(os.path.join(folder, "more"), 2, 2, [scene, "--repeat", "5"])
    refused(folder, [first, more], 'its command has "5" where that of', 'has "4"')
    refused(folder, [first, part(folder, 2, 3, run)], "part 2 of 3, other parts are of 2")
    light = os.path.join(folder, "light")
    done("trace", scene, "--shard", "1/2", "-o", light, "-q")
    refused(folder, [first, light], 'its command has "trace" where that of')
    # a scene, and a file that the scene names, that were edited in between
    for path, old, new, mentions in (
            (scene, "range_m: 2", "range_m: 1", ("made for another scene", "range_m: 2", "range_m: 1")),
            (os.path.join(folder, "places.csv"), "1.5", "1.6", ("made for another file that the scene names",))):
        with open(path, encoding="utf-8") as file:
            text = file.read()
        write(folder, path, text.replace(old, new))
        refused(folder, [first, second], *mentions)
        write(folder, path, text)
    # damaged files, a file that is missing, a file of something else
    spoilt = os.path.join(folder, "spoilt")
    shutil.copytree(second, spoilt)
    path = os.path.join(spoilt, "repeat.part")
    with open(path, "rb") as file:
        data = file.read()
    for bytes_ in (data[:len(data) // 2], data[:-3], data[:-9] + b"x" + data[-8:], b"garbage\n" * 100, b""):
        with open(path, "wb") as file:
            file.write(bytes_)
        refused(folder, [first, spoilt], path)
    shutil.copy(os.path.join(light, "light.part"), path)
    refused(folder, [first, spoilt], path, "no part of repeated placements")
    os.remove(path)
    refused(folder, [first, spoilt], path)


def hostile_parts_are_refused(folder, scene):
    hostile = part(folder, 1, 1, [scene, "--repeat", "2"])
    with open(os.path.join(hostile, "part.txt"), encoding="utf-8") as file:
        head = "".join(file.readlines()[:3])
    for words in (["place", scene], ["place", scene, "--repeat", "1"], ["place", scene, "--repeat", "20000"],
                  ["place", "--matrix", "m.csv", "--count", "1"], ["place", scene, "--repeat", "3"]):
        write(hostile, "part.txt", head + "".join(f"word {word}\n" for word in words))
        refused(folder, [hostile])


def wrong_options(folder):
    out = os.path.join(folder, "no")
    for words in (ROOM, [*ROOM, "--repeat", "1"], ["--matrix", "m.csv", "--count", "2"]):
        ran = murk("place", *words, "--shard", "1/2", "-o", out)
        check(ran.returncode == 2 and "murk: --shard: divides the seeds of --repeat N" in ran.stderr and
              len(ran.stderr.splitlines()) < 3 and not os.path.exists(out), f"{words}: {ran.stderr}")


def files_of_others_stay(folder):
    mine = os.path.join(folder, "mine")
    path = write(mine, "repeat.part", "of mine")
    ran = murk("place", *ROOM, "--repeat", "2", "--shard", "1/1", "-o", mine)
    check(ran.returncode == 2 and path in ran.stderr, f"repeat.part is not replaced: {ran.stderr}")
    check(content(path) == b"of mine", "repeat.part stays")


def an_interrupted_part_has_no_part_txt(folder):
    run = [*ROOM, "--repeat", "300"]
    out = part(folder, 1, 1, [*ROOM, "--repeat", "2"])
    ran = subprocess.Popen([MURK, "place", *run, "--shard", "1/1", "-o", out, "--progress", "always"], cwd=TOP,
                           stderr=subprocess.PIPE, text=True)
    begun = time.monotonic()
    for line in ran.stderr:
        if line.startswith("murk: repeat: ") or time.monotonic() > begun + 60:
            break
    ran.send_signal(signal.SIGINT)
    ran.communicate(timeout=60)
    check(ran.returncode == 130, f"interrupted: {ran.returncode}")
    check(os.listdir(out) == ["repeat.part"], f"after the interrupt: {os.listdir(out)}")


def main():
    with tempfile.TemporaryDirectory() as top:
        def folder(name):
            return os.path.join(top, name)

        parts_are_the_run(folder("small"), [scene_in(folder("small"), SMALL), "--repeat", "9"], (1, 2, 3, 5, 7))
        parts_are_the_run(folder("over"), [scene_in(folder("over"), SMALL + CONDITIONS), "--repeat", "5"], (3, 7))
        parts_are_the_run(folder("target"), [*ROOM[:-2], "--target", "0.5", "--repeat", "4"], (3,))
        a_seed_that_fails_ends_the_merge(folder("fails"))
        nothing_is_repeated_in_the_dark(folder("dark"))
        scene = scene_in(folder("others"), SMALL)
        others_are_refused(folder("others"), scene)
        hostile_parts_are_refused(folder("hostile"), scene)
        files_of_others_stay(top)
        an_interrupted_part_has_no_part_txt(top)
        wrong_options(top)
    print("shards of seeds:", f"{shards.failures} failures" if shards.failures else "all as it should be")
    sys.exit(shards.failures > 0)


if __name__ == "__main__":
    main()
