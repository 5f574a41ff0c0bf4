"""tools/bench without a run: help, names, wrong usage, the comparison of two runs with known verdicts, and the
arithmetic of ratios and exponents."""
import importlib.machinery
import importlib.util
import json
import os
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


def line(case, low, middle, high, **more):
    times = {"value": middle, "reference_value": 1., "ratio": middle, "ratio_low": low, "ratio_high": high}
    return {"case": case, "threads": 1, "unit": "photons/s", "reference": "loop", "repeats": 5, "cpu": times,
            "clock": dict(times, ratio_low=0, ratio_high=9 * high), **more}


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
new = [line("slow", .7, .8, .85), line("fast", 1.4, 1.5, 1.6), line("same", .7, .8, .95), line("near", .96, .97, .98)]
code, verdicts, text = compared(old, new)
check(code == 1, "exit 1 when a ratio got worse")
check(verdicts == {"slow": "worse", "fast": "better", "same": "within the spread", "near": "within the spread"}, text)
check("8 ratios compared, 1 worse, 2 of the old run" in text, text)

# A row that runs no more to its end is worse; a single run needs a larger change.
code, verdicts, text = compared(old[:1], [{"case": "slow", "threads": 1, "reference": "loop", "note": "did not end"}])
check(code == 1 and verdicts == {"slow": "worse"}, text)
once = [line("once", 1, 1, 1, repeats=1)]
check(compared(once, [line("once", .85, .85, .85, repeats=1)])[0] == 0, "a change of 15 % in single runs")
check(compared(once, [line("once", .7, .7, .7, repeats=1)])[0] == 1, "a change of 30 % in single runs")
code, _, text = compared(old, new[1:])
check(code == 0 and ", 0 worse" in text, text)

# A rate: work / time, so twice the time at the same work is half the ratio; a time: less is better.
raw = {"case": "c", "threads": 2, "unit": "u/s", "reference": "r", "work": 10, "reference_work": 20,
       "clock_s": [2, 2, 2.5], "cpu_s": [4, 4, 4], "reference_clock_s": [1, 1, 1], "reference_cpu_s": [2, 1, 4]}
made = bench.finished(raw)
check(made["clock"] == {"value": 5, "reference_value": 20, "ratio": .25, "ratio_low": .2, "ratio_high": .25}, made)
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
