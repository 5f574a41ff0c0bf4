"""tools/mutate: the seed decides, every room can be drawn, what it writes compiles, and the switch
turns on exactly one wrong change."""
import importlib.machinery
import importlib.util
import os
import subprocess
import sys
import tempfile

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
loader = importlib.machinery.SourceFileLoader("mutate", os.path.join(TOP, "tools", "mutate"))
sys.dont_write_bytecode = True
spec = importlib.util.spec_from_loader("mutate", loader)
mutate = importlib.util.module_from_spec(spec)
loader.exec_module(mutate)

SAMPLE = """/* a comment with 7 + 8 and (an open bracket */
#include <stdio.h>
#include <stdlib.h>
#define SCALE 3
struct pair { int first; double second[2]; };
static const int table[2] = {1, 2 + 3};

static double area(double wide, double high)
{
    const double edge = 0.5;
    double unused[7][9];
    return wide * (high + edge) - (double)table[1];
}

int main(int argc, char **argv)
{
    struct pair p = {.first = argc, .second = {1.5, 2}};
    int count = 0;
    for (int i = 0; i < 10; ++i) {
        if (i % 2 == 0 &&
            i > argc) {
            count += i - p.first;
        }
    }
    p.second[1] = area(p.second[0], -p.second[1]);
    printf("%d %.6f %s\\n", count, p.second[1] * SCALE, argv[0] ? "+" : "-");
    return 0;
}
"""

failures = 0


def check(good, text):
    global failures
    if not good:
        failures += 1
        print("failed:", text)


def output_of(program, number):
    run = subprocess.run([program], env={"MURK_MUTANT": str(number)}, capture_output=True, text=True)
    return run.returncode, run.stdout


def sample_is_switched():
    places = [p for p in mutate.places_of("src/base/sample.c", SAMPLE)]
    kinds = {p.kind for p in places}
    check(kinds == {"constant", "index", "sign", "bound", "branch", "branches swapped", "term dropped",
                    "factor dropped"}, f"all kinds of change are found in the sample, not only {sorted(kinds)}")
    check(not any("table[2]" in p.right or p.right in ("7", "9") or "7 + 8" in p.right or "SCALE 3" in p.right for p in places),
          "nothing is changed in tables that the compiler sets up, sizes of arrays, comments and macros")
    with tempfile.TemporaryDirectory() as folder:
        noticed = 0
        for file, text in (("switch.h", mutate.SWITCH_H), ("switch.c", mutate.SWITCH_C)):
            with open(os.path.join(folder, file), "w", encoding="utf-8") as f:
                f.write(text)
        right = None
        for place in places:
            place.number = 1
            source, program = os.path.join(folder, "sample.c"), os.path.join(folder, "sample")
            with open(source, "w", encoding="utf-8") as f:
                f.write(mutate.rewritten(SAMPLE, [place]))
            made = subprocess.run(["cc", "-w", "-include", os.path.join(folder, "switch.h"), source,
                                   os.path.join(folder, "switch.c"), "-o", program], capture_output=True, text=True)
            check(made.returncode == 0, f"{place.label()} compiles: {made.stderr}")
            off = output_of(program, 0)
            right = right or off
            check(off == right, f"{place.label()}: switched off it changes nothing")
            noticed += output_of(program, 1) != right
        # -argv[0]- and count's first mutants apart, every change of the sample shows
        check(noticed >= .8 * len(places), f"{noticed} of {len(places)} changes show in what the sample prints")


def seed_decides():
    files = sorted(n for n in subprocess.run(["git", "ls-files", "src"], cwd=TOP, capture_output=True, text=True,
                                             check=True).stdout.split() if n.endswith(".c") and n.count("/") == 2)
    texts = {f: open(os.path.join(TOP, f), encoding="utf-8").read() for f in files}

    def labels(seed, count, rooms):
        return [p.label() for p in mutate.choose(files, seed, count, rooms, texts)]

    # A room that is one short file, such as that of a program's main(), has too few places to be drawn for certain.
    lines = {}
    for f in files:
        lines[f.split("/")[1]] = lines.get(f.split("/")[1], 0) + texts[f].count("\n")
    rooms = {room for room in lines if lines[room] > 100}
    first = mutate.choose(files, 5, 400, set(), texts)
    # A draw misses a room of 1000 lines once in some 50 times; four draws together miss none.
    drawn = {p.room for seed in (5, 6, 7, 8) for p in mutate.choose(files, seed, 400, set(), texts)}
    check(drawn >= rooms, "4 times 400 mutants lie in all rooms")
    check(len(first) == 400, "as many as asked for")
    check(labels(5, 30, {"medium"}) == labels(5, 30, {"medium"}), "a seed gives the same mutants again")
    check(labels(5, 30, {"medium"}) != labels(6, 30, {"medium"}), "another seed gives others")
    for place in first:
        check(texts[place.file][place.begin:place.end] == place.right_text, "a place is what the file says there")
        lines = mutate.rewritten(texts[place.file], [place]).count("\n")
        check(lines <= texts[place.file].count("\n"), "lines keep their numbers")


if not os.path.isdir(os.path.join(TOP, ".git")) and not os.path.isfile(os.path.join(TOP, ".git")):
    print("skipped: no git checkout")
    sys.exit(77)
sample_is_switched()
seed_decides()
print("mutate:", "all as it should be" if not failures else f"{failures} failures")
sys.exit(1 if failures else 0)
