"""Parts of a trace (--shard K/N), merged by murk merge, give every file of a single run (JSON: all values) but `run`: for
1 to 7 parts, in any order, repeated, missing, with several numbers of threads. Parts that do not belong together are
refused in one line, and nothing is written then.

    shards.py MURK
"""
import os
import shutil
import subprocess
import sys
import tempfile

from run_files import differences

MURK = sys.argv[1]
TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
RUNS = [
    # photons.store, volume and surface records, exports
    ["scenes/smoke-hall.yaml", "--store", "30000", "--export", "photons"],
    # photons.emit, planes and a grid
    ["scenes/slab.yaml", "--emit", "9500"],
    # fewer batches than parts
    ["scenes/paper-room.yaml", "--emit", "1500", "--seed", "5"],
]
failures = 0


def check(holds, text):
    global failures
    if not holds:
        failures += 1
        print("failed:", text)


def murk(*words):
    return subprocess.run([MURK, *words], cwd=TOP, capture_output=True, text=True)


def done(*words):
    ran = murk(*words)
    check(ran.returncode == 0, f"{' '.join(words)}: {ran.stderr}")
    return ran


def same(a, b, what):
    differ = differences(a, b)
    check(not differ, f"{what}: these differ: {differ}")


def part(folder, k, n, run):
    path = os.path.join(folder, f"part-{k}-of-{n}")
    done("trace", *run, "--shard", f"{k}/{n}", "-o", path, "-q", "-j", str(1 + k % 3))
    return path


def parts_are_the_run(folder, run):
    whole = os.path.join(folder, "whole")
    done("trace", *run, "-o", whole, "-q")
    for n in (1, 2, 3, 5, 7):
        parts = [part(folder, k, n, run) for k in range(1, n + 1)]
        merged = os.path.join(folder, f"merged-{n}")
        ran = done("merge", *reversed(parts), parts[0], "-o", merged, "-q")
        check(ran.stderr == "" or "missing" not in ran.stderr, f"{n} parts: {ran.stderr}")
        same(whole, merged, f"{run} of {n} parts")
        if n > 2:
            shutil.rmtree(merged)
            ran = done("merge", *parts[:1], *parts[2:], "-o", merged, "-j", "1")
            check(f"1 of {n} parts are missing (2)" in ran.stderr, f"the missing part is named: {ran.stderr}")
            same(whole, merged, f"{run} of {n} parts without the second")
    # Without -o the same is printed as by the run itself, but for the times.
    if "--export" not in run:
        printed = [done(*words).stdout.split("\ntime ")[0] for words in (["merge", *parts], ["trace", *run])]
        check(printed[0] == printed[1], "printed by merge and by trace")


def refused(folder, words, *mentions):
    out = os.path.join(folder, "refused")
    ran = murk("merge", *words, "-o", out)
    check(ran.returncode == 2, f"merge {words}: exit {ran.returncode}")
    lines = [line for line in ran.stderr.splitlines() if "warning" not in line and "note" not in line]
    check(len(lines) == 1, f"one line: {ran.stderr}")
    for text in mentions:
        check(text in ran.stderr, f"{text} in {ran.stderr}")
    check(not os.path.exists(out), f"merge {words} writes nothing")


def others_are_refused(folder):
    run = ["scenes/slab.yaml", "--emit", "3000"]
    first, second = (part(folder, k, 2, run) for k in (1, 2))
    seed = part(os.path.join(folder, "seed"), 2, 2, [*run, "--seed", "9"])
    refused(folder, [first, seed], 'its command has "--seed" where that of', first)
    refused(folder, [first, part(folder, 2, 3, run)], "part 2 of 3, other parts are of 2")
    refused(folder, [first, "scenes"], "scenes/part.txt")
    # a scene that was edited in between
    scene = os.path.join(folder, "edited.yaml")
    shutil.copy(os.path.join(TOP, "scenes/slab.yaml"), scene)
    old = part(os.path.join(folder, "old"), 1, 1, [scene, "--emit", "3000"])
    with open(scene, encoding="utf-8") as file:
        text = file.read()
    with open(scene, "w", encoding="utf-8") as file:
        file.write(text.replace("angle_bins: 10", "angle_bins: 5"))
    refused(folder, [old], "made for another scene", "angle_bins: 10", "angle_bins: 5")
    # another version, a damaged file, a file that is missing, another result under the same number
    spoilt = os.path.join(folder, "spoilt")
    shutil.copytree(second, spoilt)
    with open(os.path.join(spoilt, "part.txt"), "r+", encoding="utf-8") as file:
        text = file.read().replace("version 0", "version 9")
        file.seek(0)
        file.write(text)
    refused(folder, [first, spoilt], "made by murk 9.")
    shutil.copy(os.path.join(second, "part.txt"), spoilt)
    with open(os.path.join(spoilt, "light.part"), "r+b") as file:
        file.truncate(os.path.getsize(os.path.join(spoilt, "light.part")) // 2)
    refused(folder, [first, spoilt], os.path.join(spoilt, "light.part"))
    os.remove(os.path.join(spoilt, "light.part"))
    refused(folder, [first, spoilt], os.path.join(spoilt, "light.part"))


def hostile_parts_are_refused(folder):
    good = part(folder, 1, 1, ["scenes/slab.yaml", "--emit", "2000"])
    with open(os.path.join(good, "part.txt"), encoding="utf-8") as file:
        head = "".join(file.readlines()[:3])
    hostile = os.path.join(folder, "hostile")
    shutil.copytree(good, hostile)
    for words in (["--version"], ["--help"], ["trace", "--man"], ["place", "scenes/slab.yaml"], ["--completion", "bash"],
                  ["trace", "scenes/slab.yaml", "--shard", "1/1", "-o", "x"], ["merge", good], []):
        with open(os.path.join(hostile, "part.txt"), "w", encoding="utf-8") as file:
            file.write(head + "".join(f"word {word}\n" for word in words))
        refused(folder, [hostile])
    # "--" among the words, and a line break, which is refused before anything is traced
    dashes = os.path.join(folder, "dashes")
    done("trace", "--emit", "2000", "--shard", "1/1", "-o", dashes, "-q", "--", "scenes/slab.yaml")
    done("merge", dashes, "-o", os.path.join(folder, "from-dashes"), "-q")
    ran = murk("trace", "scenes/slab.yaml", "--set", "title=a\nb", "--shard", "1/1", "-o", os.path.join(folder, "no"))
    check(ran.returncode == 2 and not os.path.exists(os.path.join(folder, "no")), f"a line break: {ran.stderr}")


def files_of_others_stay(folder):
    run = ["trace", "scenes/slab.yaml", "--emit", "1000", "--shard", "1/2", "-o"]
    mine = os.path.join(folder, "mine")
    os.mkdir(mine)
    for name in ("part.txt", "light.part"):
        path = os.path.join(mine, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write("of mine")
        ran = murk(*run, mine)
        check(ran.returncode == 2 and name in ran.stderr, f"{name} is not replaced: {ran.stderr}")
        with open(path, encoding="utf-8") as file:
            check(file.read() == "of mine", f"{name} stays")
        os.remove(path)
    done(*run, mine)
    done(*run, mine)  # a part that is traced again replaces the old one


def wrong_options():
    for words, text in ((["--shard", "3/2", "-o", "x"], "--shard: 3/2, must be K/N"),
                        (["--shard", "0/2", "-o", "x"], "--shard: 0/2, must be K/N"),
                        (["--shard", "2", "-o", "x"], "--shard: 2, must be K/N"),
                        (["--shard", "1/2"], "needs a folder")):
        ran = murk("trace", "scenes/slab.yaml", *words)
        check(ran.returncode == 2 and text in ran.stderr, f"{words}: {ran.stderr}")
    ran = murk("merge")
    check(ran.returncode == 2 and "no folder" in ran.stderr, f"merge of nothing: {ran.stderr}")


def main():
    with tempfile.TemporaryDirectory() as top:
        for i, each in enumerate(RUNS):
            os.mkdir(os.path.join(top, str(i)))
            parts_are_the_run(os.path.join(top, str(i)), each)
        others = os.path.join(top, "others")
        for name in ("", "seed", "old"):
            os.mkdir(os.path.join(others, name))
        others_are_refused(others)
        files_of_others_stay(others)
        hostile_parts_are_refused(others)
        wrong_options()
    print("shards:", f"{failures} failures" if failures else "all as it should be")
    sys.exit(failures > 0)


if __name__ == "__main__":
    main()
