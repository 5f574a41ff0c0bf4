"""tools/bench without a run: help, names, wrong usage, the comparison of two runs with known verdicts, and the
arithmetic of ratios and exponents."""
import importlib.machinery
import importlib.util
import json
import os
import random
import subprocess
import sys
import tempfile

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BENCH = os.path.join(TOP, "tools", "bench")
loader = importlib.machinery.SourceFileLoader("bench", BENCH)
bench = importlib.util.module_from_spec(importlib.util.spec_from_loader("bench", loader))
loader.exec_module(bench)


def run(*words):
    return subprocess.run([sys.executable, "-B", BENCH, *words], capture_output=True, text=True)


def check(is_true, what):
    if not is_true:
        sys.exit(f"tests/tools/bench.py: {what}")


def row(case, ratios, clock_ratios, **more):
    """The line of a row with these ratios, as the tool makes it."""
    n = len(ratios)
    raw = {"case": case, "threads": 1, "unit": "photons/s", "reference": "loop", "work": 1, "reference_work": 1,
           "clock_s": [1] * n, "cpu_s": [1] * n, "reference_clock_s": clock_ratios, "reference_cpu_s": ratios}
    return bench.finished(dict(raw, more=more))


def line(case, low, middle, high, **more):
    ratios = [middle, high, low, (middle + high) / 2, (low + middle) / 2]
    return row(case, ratios, [0.01, middle, 9 * high, 0.01, 9 * high], **more)


def compared(old, new):
    with tempfile.TemporaryDirectory() as folder:
        paths = []
        for name, lines in (("old.json", old), ("new.json", new)):
            paths.append(os.path.join(folder, name))
            with open(paths[-1], "w", encoding="utf-8") as file:
                file.write("\n".join(map(json.dumps, lines)) + "\n")
        done = run("--compare", paths[0], "--with", paths[1])
    verdicts = {row.split(" | ")[0]: row.split(" | ")[-1]
                for row in done.stdout.splitlines() if " | cpu | " in row}
    return done.returncode, verdicts, done.stdout


# Help, names, and wrong usage.
done = run("--help")
check(done.returncode == 0 and "--compare OLD" in done.stdout and "Exit 1" in done.stdout, "help")
names = run("--list").stdout.split()
check({"b1", "maps", "place", "kd-query", "march", "render"} <= set(names), f"names {names}")
done = run("b1", "nothing")
check(done.returncode == 2 and "unknown case nothing" in done.stderr and "b1" in done.stderr, "unknown case")
check(run("--with", "x").returncode == 2, "--with alone")
check(run("--compare", "/nowhere").returncode == 1, "no such file")

# Worse beyond the spread, better, within the spread, and apart by less than two equal programs are.
old = [line("slow", .9, 1, 1.1), line("fast", .9, 1, 1.1), line("same", .9, 1, 1.1), line("near", .999, 1, 1.001),
       line("gone", 1, 1, 1), {"case": "endless", "threads": 1, "reference": "loop", "note": "did not end"}]
new = [line("slow", .7, .8, .85), line("fast", 1.4, 1.5, 1.6), line("same", .7, .88, .95), line("near", .96, .97, .98)]
code, verdicts, text = compared(old, new)
check(code == 1, "exit 1 when a ratio got worse")
check(verdicts == {"slow": "worse", "fast": "better", "same": "within the spread", "near": "within the spread"}, text)
check("8 ratios compared, 1 worse, 2 of the old run" in text, text)

# Noise is not worse, a real slowdown is, and one slow repeat of five does not hide that.
draw = random.Random(18)


def noisy(case, middle, with_outlier):
    ratios = [middle * draw.lognormvariate(0, .04) for _ in range(5)]
    ratios[0] *= 1.8 if with_outlier else 1
    return row(case, ratios, ratios)


names = [f"c{i}" for i in range(1000)]
for with_outlier in (False, True):
    before = [noisy(name, 1, False) for name in names]
    code, verdicts, text = compared(before, [noisy(name, 1, with_outlier) for name in names])
    check(list(verdicts.values()).count("worse") <= 6, "noise of 4 % is worse: " + text[-60:])
    code, verdicts, text = compared(before, [noisy(name, .75, with_outlier) for name in names])
    check(code == 1 and list(verdicts.values()).count("worse") >= 990, "not seen to be slower: " + text[-60:])

# Runs without a common ratio do not pass; a plan that covers less is worse however fast it was found.
code, _, text = compared(old[:1], new[1:2])
check(code == 1 and text.startswith("0 ratios compared"), text)
code, _, text = compared([line("p", .9, 1, 1.1, coverage=.9)], [line("p", 1.9, 2, 2.1, coverage=.8)])
check(code == 1 and "covers 0.8 instead of 0.9 | worse" in text, text)
check(compared([line("p", .9, 1, 1.1, coverage=.9)], [line("p", .9, 1, 1.1, coverage=.9)])[0] == 0, "same plan")

# A row that runs no more to its end is worse; a single run needs a larger change.
code, verdicts, text = compared(old[:1], [{"case": "slow", "threads": 1, "reference": "loop", "note": "did not end"}])
check(code == 1 and verdicts == {"slow": "worse"}, text)
once = [row("once", [1], [1])]
check(compared(once, [row("once", [.85], [.85])])[0] == 0, "a change of 15 % in single runs")
check(compared(once, [row("once", [.7], [.7])])[0] == 1, "a change of 30 % in single runs")
code, _, text = compared(old, new[1:])
check(code == 0 and ", 0 worse" in text, text)

# A rate: work / time, so twice the time at the same work is half the ratio; a time: less is better.
raw = {"case": "c", "threads": 2, "unit": "u/s", "reference": "r", "work": 10, "reference_work": 20,
       "clock_s": [2, 2, 2.5], "cpu_s": [4, 4, 4], "reference_clock_s": [1, 1, 1], "reference_cpu_s": [2, 1, 4]}
made = bench.finished(raw)
check(made["clock"] == {"value": 5, "reference_value": 20, "ratio": .25, "ratio_low": .2, "ratio_high": .25,
                        "ratios": [.2, .25, .25]}, made)
check((made["cpu"]["ratio"], made["cpu"]["ratio_low"], made["cpu"]["ratio_high"]) == (.25, .125, .5), made)
check(bench.finished(dict(raw, work=0, reference_work=0))["clock"]["ratio"] == .5, "ratio of times")

# Exponents: a power law exactly, and a kink with its error.
slope, error = bench.exponent([1e4, 1e5, 1e6], [2e-3, 2e-2 * 10**.5, 2])
check(abs(slope - 1.5) < 1e-12 and error < 1e-12, (slope, error))
slope, error = bench.exponent([1, 10, 100], [1, 1, 100])
check(abs(slope - 1) < 1e-12 and abs(error - 3**-.5) < 1e-12, (slope, error))

# Shares that differ by more than chance are refused, others are not.
bench.disagree("alike", 500, 1000, 520, 1000)
try:
    bench.disagree("apart", 500, 1000, 700, 1000)
    check(False, "apart was not refused")
except bench.Failed:
    pass
