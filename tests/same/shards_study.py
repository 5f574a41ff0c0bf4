"""Parts of a study (--shard K/N), merged by murk merge, give every file of a single run (JSON: all values) but `run`, the
stored rows and grids included: for 1 to 7 parts, in any order, repeated, missing, damaged, with rows that fail, and with
plans for all rows. Parts that do not belong together are refused in one line, and nothing is written then.

    shards_study.py MURK
"""
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import shards
from shards import MURK, check, same

SCENE = """\
murk: 1
domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}
geometry: [{box: {min_m: [0.1, 0.1, 0.1], max_m: [3.9, 3.9, 2.9]}}]
media: {fog: {extinction_per_m: 0.3, albedo: 0.9, phase: {hg: 0.8}}}
regions: [{medium: fog}]
lights:
  - {type: point, position_m: [2, 2, 2.5], power_w: 10}
  - {type: point, position_m: [3.5, 3.5, 0.5], power_w: 4}
photons: {emit: 500}
sensors:
  types: [{name: node, range_m: 2.2}]
  candidates: {grid: {min_m: [0.5, 0.5, 0.5], max_m: [3.5, 3.5, 2.5], size: [3, 3, 2]}}
  count: 2
"""
# Four groups of rows that share light, one of which is dark in places; plans for all rows, and grids.
PLANS = """\
murk_study: 1
base: scene.yaml
axes: {media.fog.albedo: [0.9, 0.7, 0.5, 0.3], lights.0.power_w: [10, 1, 0]}
outputs: [density, coverage_best, coverage_one_mean, coverage_one_worst, fluence_vdb]
fluence_size: [4, 4, 3]
"""
# Rows whose scene cannot be read (albedo 7), and rows that fail when they are run (no sensor type of the plan).
FAILING = """\
murk_study: 1
base: scene.yaml
plan: plan.csv
axes: {media.fog.albedo: [0.9, 7, 0.5], sensors.types.0.name: [node, other]}
outputs: [density, coverage_fixed]
"""
def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def murk(*words, want=0):
    ran = subprocess.run([MURK, *words], capture_output=True, text=True)
    check(ran.returncode == want, f"{' '.join(words)}: exit {ran.returncode}, {ran.stderr}")
    return ran


def part(k, n, study, *more, name="part"):
    folder = f"{name}-{k}-of-{n}"
    murk("study", study, *more, "--shard", f"{k}/{n}", "-o", folder, "-q", "-j", str(1 + k % 2))
    return folder


def merge(parts, *more, want=0):
    shutil.rmtree("merged", ignore_errors=True)
    return murk("merge", *parts, "-o", "merged", *more, want=want)


def traced():
    with open("merged/study.json", encoding="utf-8") as file:
        run = json.load(file)["run"]
    return run["lights_traced"], run["rows_kept"]


def parts_are_the_run():
    murk("study", "plans.yaml", "-o", "whole", "-q")
    for n in (1, 2, 3, 5, 7):
        parts = [part(k, n, "plans.yaml") for k in range(1, n + 1)]
        ran = merge([*reversed(parts), parts[0]])
        check("missing" not in ran.stderr, f"{n} parts: {ran.stderr}")
        check(traced() == (0, 12), f"all rows of {n} parts are taken over: {traced()}")
        same("whole", "merged", f"{n} parts")
        if n == 3:
            ran = merge([parts[0], parts[2]])
            check("1 of 3 parts are missing (2): their rows are run now" in ran.stderr, ran.stderr)
            check(traced() == (1, 9), f"rows without the second part: {traced()}")
            same("whole", "merged", "without the second part")
            # A merge that was killed, and one into the folder of a part.
            for file in ("study.json", "table.csv", "scene.resolved.yaml", "fluence_0001.vdb"):
                os.remove(os.path.join("merged", file))
            murk("merge", *parts, "-o", "merged", "-q")
            same("whole", "merged", "a merge that goes on")
            shutil.copytree(parts[0], "into")
            murk("merge", "into", *parts[1:], "-o", "into", "-q")
            for file in ("part.txt", "study.part"):
                os.remove(os.path.join("into", file))
            same("whole", "into", "a merge into the folder of a part")


def damaged_rows_are_run_again():
    first, second, third = (f"part-{k}-of-3" for k in (1, 2, 3))
    for damage in ("truncated", "changed", "removed", "grid"):
        shutil.rmtree("spoilt", ignore_errors=True)
        shutil.copytree(second, "spoilt")
        row = os.path.join("spoilt/rows", sorted(os.listdir("spoilt/rows"))[0])
        if damage == "grid":
            row = os.path.join("spoilt", sorted(name for name in os.listdir("spoilt") if name.endswith(".vdb"))[0])
        if damage == "removed":
            os.remove(row)
        elif damage == "changed":  # a valid row with another number
            write(row, read(row).replace("emitted: ", "emitted: 1"))
        else:
            with open(row, "r+b") as file:
                file.truncate(os.path.getsize(row) // 2)
        ran = merge([first, "spoilt", third])
        check("spoilt: the files of row" in ran.stderr and traced() == (1, 11), f"{damage}: {ran.stderr}")
        same("whole", "merged", f"a row that is {damage}")
        # The same part once more, undamaged: nothing is left to run.
        ran = merge([first, "spoilt", third, second])
        check("damaged" not in ran.stderr and traced() == (0, 12), f"{damage}, and given again: {ran.stderr}")
        same("whole", "merged", f"a row that is {damage}, and given again")


def failing_rows():
    murk("study", "failing.yaml", "-o", "some", "-q", want=1)
    parts = [part(k, 2, "failing.yaml", name="failing") for k in (1, 2)]
    ran = merge(parts, "-q", want=1)
    check("4 of 6 rows failed" in ran.stderr, ran.stderr)
    check(traced()[1] == 2, f"rows that failed are tried again: {traced()}")
    same("some", "merged", "rows that fail")
    # Without -o the same is printed as by the run itself, but for times and what was kept.
    printed = [murk(*words, want=1).stdout.split("\nrows ")[0] for words in
               (["merge", *parts], ["study", "failing.yaml"])]
    check(printed[0] == printed[1], "printed by merge and by study")
    write("dark.yaml", PLANS.replace("fluence_vdb", "stored").replace("fluence_size: [4, 4, 3]\n", ""))
    first = part(1, 2, "dark.yaml", name="dark")
    murk("merge", first)
    check(sorted(os.listdir(first)) == ["part.txt", "rows", "study.part"], "a merge without -o writes nothing")


def refused(parts, *mentions, want=2):
    ran = merge(parts, want=want)
    lines = [line for line in ran.stderr.splitlines() if "warning" not in line and "note" not in line]
    check(len(lines) == 1, f"one line: {ran.stderr}")
    for text in mentions:
        check(text in ran.stderr, f"{text} in {ran.stderr}")
    check(not os.path.exists("merged"), f"merge {parts} writes nothing")


def others_are_refused():
    study, scene = read("failing.yaml"), read("scene.yaml")
    first = "failing-1-of-2"
    seed = part(2, 2, "failing.yaml", "--seed", "9", name="seed")
    refused([first, seed], 'its command has "--seed" where that of', first)
    refused([first, part(2, 3, "failing.yaml", name="failing")], "part 2 of 3, other parts are of 2")
    # A comment is no difference. Other values, another number of rows, another scene, another file are.
    write("failing.yaml", study + "# a comment\n")
    merge([first, "failing-2-of-2"], "-q", want=1)
    shutil.rmtree("merged")
    write("failing.yaml", study.replace("0.9", "0.8"))
    refused([first], "made for another row 1 of the study: the study file has changed")
    write("failing.yaml", study.replace("0.9", "0.8, 0.9"))
    refused([first], "made for a study of 6 rows, this one has 8")
    write("failing.yaml", study)
    write("scene.yaml", scene.replace("extinction_per_m: 0.3", "extinction_per_m: 0.4"))
    refused([first], "made for another row 1 of the study: the scene has changed")
    write("scene.yaml", scene)
    plan = read("plan.csv")
    write("plan.csv", plan.replace("1.5", "1.6"))
    refused([first], "made for another row 1 of the study: an option, or a file")
    write("plan.csv", plan)
    # The same part with another result.
    shutil.copytree(first, "again")
    line = next(line for line in read("again/study.part").splitlines()[6:] if not line.endswith("-"))
    write("again/study.part", read("again/study.part").replace(line, line[:-1] + ("0" if line[-1] != "0" else "1")))
    refused([first, "again"], "part 1 of 2 again, and row 1 other than in " + first)
    # A part of another command.
    murk("trace", "scene.yaml", "--shard", "1/2", "-o", "light", "-q")
    refused([first, "light"], "its command has")


def hostile_parts_are_refused():
    good = "failing-1-of-2"
    lines = read(good + "/study.part").split("\n")
    row = next(i for i, line in enumerate(lines) if i > 5 and not line.endswith("-"))
    other = 6 + 4  # row 5, of the second group

    def changed(i, line):
        return "\n".join(line if k == i else old for k, old in enumerate(lines))

    cases = {
        "": "the mark", "\0\n" * 20: "the mark", changed(0, "murk part of a study 2"): "the mark",
        changed(1, "version 9.0"): "made by murk 9.0", changed(1, "x"): "made by murk ?",
        changed(4, "part 0/2"): "the number of the part", changed(4, "part 3/2"): "the number of the part",
        changed(4, "part 1/99999999999"): "the number of the part", changed(4, "part 1/-2"): "the number of the part",
        changed(4, "part 1" * 99): "the number of the part", changed(5, "rows x"): "the number of the part or of rows",
        changed(5, "rows 18446744073709551615"): "rows, this one has 6", "\n".join(lines[:8]): "lines of rows",
        "\n".join(lines + ["more", ""]): "more lines than rows", changed(row, "x"): "lines of rows",
        changed(row, "x y"): "another row 1", changed(row, lines[row] + "0"): "rows of other parts",
        changed(row, lines[row][:70]): "rows of other parts",
        changed(other, lines[other][:-1] + 32 * "0"): "rows of other parts",
        "x" * 2000000: "must be at most",
    }
    shutil.copytree(good, "hostile")
    for text, mention in cases.items():
        write("hostile/study.part", text)
        refused(["hostile"], "hostile/study.part", mention)
    # A row of the right name and sum that is no row, or is a pipe or a folder, is run again.
    sums = [line.split(" ")[0] for line in lines[6:] if not line.endswith("-") and line]
    write("hostile/study.part", "\n".join(lines))
    path = f"hostile/rows/{sums[0][:32]}.yaml"
    for make in (os.mkfifo, os.mkdir):
        shutil.rmtree(path) if os.path.isdir(path) else os.remove(path)
        make(path)
        check("the files of row 1 are damaged" in merge(["hostile"], want=1).stderr, "a row that is no file")
    os.remove("hostile/study.part")
    refused(["hostile"], "hostile/study.part")


def files_of_others_stay():
    os.mkdir("mine")
    for name in ("part.txt", "study.part", "fluence_0001.vdb"):
        path = os.path.join("mine", name)
        write(path, "of mine")
        ran = murk("study", "plans.yaml", "--shard", "1/4", "-o", "mine", want=2)
        check(name in ran.stderr, f"{name} is not replaced: {ran.stderr}")
        check(read(path) == "of mine", f"{name} stays")
        os.remove(path)
    check("needs a folder" in murk("study", "plans.yaml", "--shard", "1/4", want=2).stderr, "a part without a folder")
    # A part that goes on, and a part that is run again.
    ran = murk("study", "plans.yaml", "--shard", "1/4", "-o", "mine")
    check("rows        3 of 12, of which 0 kept from before and 0 failed" in ran.stdout, ran.stdout)
    check("part        1 of 4, in mine" in ran.stdout, ran.stdout)
    os.remove("mine/part.txt")
    os.remove("mine/rows/" + sorted(os.listdir("mine/rows"))[0])
    ran = murk("study", "plans.yaml", "--shard", "1/4", "-o", "mine")
    check("rows        3 of 12, of which 2 kept from before and 0 failed" in ran.stdout, ran.stdout)
    # The rows of another division of the study that lie in the folder are no rows of the part.
    murk("study", "plans.yaml", "--shard", "2/2", "-o", "mine", "-q")
    merge(["mine", "part-1-of-2"], "-q")
    same("whole", "merged", "a folder with rows of two divisions")


def an_interrupt_keeps_rows():
    write("long.yaml", PLANS.replace("[0.9, 0.7, 0.5, 0.3]", "[0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2]"))
    words = [MURK, "study", "long.yaml", "--emit", "40000", "--shard", "1/2", "-o", "cut", "-q", "-j", "1"]
    ran = subprocess.Popen(words, stderr=subprocess.PIPE, text=True)
    for _ in range(3000):
        if ran.poll() is not None or (os.path.isdir("cut/rows") and os.listdir("cut/rows")):
            break
        time.sleep(.01)
    ran.send_signal(signal.SIGINT)
    said = ran.communicate()[1]
    check(ran.returncode == 130, f"an interrupt: exit {ran.returncode}, {said}")
    kept = [name for name in os.listdir("cut/rows") if name.endswith(".yaml")]
    check(kept and sorted(os.listdir("cut"))[-1] == "rows" and not os.path.exists("cut/part.txt"),
          f"rows are kept, and there is no part: {os.listdir('cut')}")
    ran = murk(*words[1:-3], "-j", "2")
    check(f"of which {len(kept)} kept" in ran.stdout or len(kept) > 12, f"the part goes on: {ran.stdout}")


with tempfile.TemporaryDirectory() as top:
    os.chdir(top)
    write("scene.yaml", SCENE)
    write("plan.csv", "type,x_m,y_m,z_m\nnode,2.5,2.5,1.5\n")
    write("plans.yaml", PLANS)
    write("failing.yaml", FAILING)
    parts_are_the_run()
    damaged_rows_are_run_again()
    failing_rows()
    others_are_refused()
    hostile_parts_are_refused()
    files_of_others_stay()
    an_interrupt_keeps_rows()
    os.chdir("/")
print("shards of a study:", f"{shards.failures} failures" if shards.failures else "all as it should be")
sys.exit(shards.failures > 0)
