#!/usr/bin/env python3
"""Folders that are no results, or broken ones: one line, exit 2, no page; and
files that only lack in part: a page that says so. Bounded time and memory.
usage: report.py MURK [SANITIZE]
"""

import json
import os
import resource
import signal
import struct
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import browser  # noqa: E402
import pages  # noqa: E402

MAJOR, MINOR, PATCH = pages.VERSION
RELEASE = f"{MAJOR}.{MINOR}"
PLAN = {"murk": {"version": f"{RELEASE}.{PATCH}"}, "scene": "a.yaml", "seed": 1,
        "sensors": [{"type": "node", "position_m": [1, 2, 3]}],
        "coverage": {"in_sample": 0.5}}
PLY = ("ply\nformat binary_little_endian 1.0\ncomment x\nelement vertex %d\n"
       "property float x\nproperty float y\nproperty float z\n"
       "property uchar red\nproperty uchar green\nproperty uchar blue\n"
       "property uchar kind\nproperty ushort seen_by\nproperty float quality\n"
       "property uint sensors\n"
       "element face 0\nproperty list uchar int vertex_indices\nend_header\n")
GRID = ("murk: 1\ndomain: {min_m: [0, 0, 0], max_m: [1, 1, 1]}\nlights: [{type: point, "
        "position_m: [0.5, 0.5, 0.5], power_w: 1}]\ntallies: [{name: inside, type: grid, min_m: "
        "[0, 0, 0], max_m: [1, 1, 1], size: [2, 2, 2]}]\n")
PATH = (b"ply\nformat binary_little_endian 1.0\ncomment murk path: x\nelement vertex %d\n"
        b"property float x\nproperty float y\nproperty float z\n"
        b"property uchar red\nproperty uchar green\nproperty uchar blue\n"
        b"property uchar kind\nproperty ushort step\nend_header\n")
MEMORY = 1 << 30
failures = 0


def check(holds, *what):
    global failures
    if not holds:
        failures += 1
        print("not so:", *what)


def photon(x, kind=1, seen=0):
    return struct.pack("<3f3BBHfI", x, 0, 0, 0, 0, 0, kind, seen, 1, 2**32 - 1)


def hears_interrupts(started):
    """Whether it has a handler of SIGINT; or has ended."""
    with open(f"/proc/{started.pid}/status", encoding="utf-8") as file:
        caught = [line.split()[1] for line in file if line.startswith("SigCgt")]
    return started.poll() is not None or (caught and int(caught[0], 16) & 1 << signal.SIGINT - 1)


def check_interrupt(murk, folder):
    """Ctrl-C leaves a whole page or none, whenever it comes."""
    with open(os.path.join(folder, "plan.json"), "w") as file:
        json.dump(PLAN, file)
    with open(os.path.join(folder, "scene.yaml"), "w") as file:
        # many boxes, so that it takes a while
        file.write(GRID + "media: {fog: {extinction_per_m: 1}}\nregions: [{medium: fog}]\n"
                   "geometry:\n" + "".join(
                       f"  - {{box: {{min_m: [0, 0, {k / 6e3}], max_m: [1, 1, {(k + 1) / 6e3}]}}}}\n"
                       for k in range(3000)))
    page, codes = os.path.join(folder, "report.html"), []
    subprocess.run([murk, "report", "-q", folder], check=True, timeout=60)
    with open(page, "rb") as file:
        whole = file.read()
    for k in range(20):
        if os.path.exists(page):
            os.unlink(page)
        started = subprocess.Popen([murk, "report", "-q", folder], stderr=subprocess.DEVNULL)
        while not hears_interrupts(started):
            pass
        time.sleep(k * 2e-3)
        started.send_signal(signal.SIGINT)
        codes.append(started.wait(timeout=60))
        if os.path.exists(page):
            with open(page, "rb") as file:
                check(codes[-1] == 0 and file.read() == whole, "a part of a page", codes[-1])
        else:
            check(codes[-1] == 130, "no page, and exit", codes[-1])
    check(130 in codes, "never interrupted:", codes)
    for name in os.listdir(folder):
        os.unlink(os.path.join(folder, name))


def main(murk, is_sanitized):
    if not browser.program():
        print("skipped: no chromium")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        def write(name, content):
            mode = "wb" if isinstance(content, bytes) else "w"
            with open(os.path.join(folder, name), mode) as file:
                file.write(content)

        def limit():
            if not is_sanitized:
                resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))

        def run(want, part, *arguments):
            """murk report, on what was written; then all is removed."""
            done = subprocess.run([murk, "report", *(arguments or ["."])], cwd=folder,
                                  text=True, capture_output=True, check=False,
                                  timeout=60, preexec_fn=limit)
            check(done.returncode == want, part, "exit", done.returncode, done.stderr)
            if want:
                check(done.stderr.count("\n") == 1 and part in done.stderr,
                      "one line with", part, "not", done.stderr)
            page = os.path.join(folder, "report.html")
            check(os.path.exists(page) == (want == 0), part, "a page or none")
            check(want == 0 or not [n for n in os.listdir(folder) if "html" in n], "a part of a page")
            text = ""
            if os.path.exists(page):
                with open(page, encoding="utf-8") as file:
                    text = file.read()
                check(len(text) < 3_000_000, part, "size", len(text))
                text = pages.without_script(text) + pages.drawn(page)
                check(part in text, "in the page:", part)
            for name in os.listdir(folder):
                os.unlink(os.path.join(folder, name))
            return text

        def plan(**changes):
            write("plan.json", json.dumps({**PLAN, **changes}))

        run(2, "no results here")
        run(2, "no such folder", "nowhere")
        run(2, "no folder; usage", "--quiet")
        plan()
        run(2, "no --set and no --seed", ".", "--seed", "3")
        plan(murk={"version": "0.0.9"})
        run(2, f"0.0.9, must be {RELEASE}: results of another version")
        plan(murk={"version": f"{RELEASE}0.0"})
        run(2, f"{RELEASE}0.0, must be {RELEASE}")
        plan(murk={"version": f"{MAJOR}.{MINOR + 1}.0"})
        run(2, f"plan.json:1:22: murk.version: {MAJOR}.{MINOR + 1}.0, must be {RELEASE}")
        plan(murk={"version": f"{MAJOR + 1}"})
        run(2, f"{MAJOR + 1}, must be {RELEASE}")
        plan(murk={})
        run(2, "murk.version is missing")
        write("plan.json", '{"murk": {"version": "0.0.0"')
        run(2, "plan.json:2:1: not YAML")
        write("plan.json", "[" * 100000)
        run(2, "plan.json")
        write("plan.json", b"\x00\xff\xfe")
        run(2, "plan.json")
        write("plan.json", "")
        run(2, "plan.json")
        write("plan.json", "[1, 2]")
        run(2, "murk.version is missing")
        write("study.json", json.dumps({"murk": PLAN["murk"], "axes": [{"key": "a"}]}))
        write("table.csv", "a,b\n1\n")
        run(2, "table.csv:2")
        write("study.json", json.dumps({"murk": PLAN["murk"], "axes": []}))
        run(0, "no table.csv")
        write("study.json", json.dumps({"murk": PLAN["murk"],
                                        "axes": [{"key": "a"}] * 99, "rows": "x"}))
        write("table.csv", "a,b,b_standard_error\n1e999,nan,x\n,,\n2,1e300,1e300\n")
        run(0, "The study")

        # what is no file, or cannot be written
        os.symlink("/dev/zero", os.path.join(folder, "plan.json"))
        run(2, "no results here")
        os.mkfifo(os.path.join(folder, "plan.json"))
        run(2, "no results here")
        plan()
        run(1, "cannot write", ".", "-o", "nowhere/report.html")
        plan()
        run(1, "cannot write", ".", "-o", "/dev/full")
        plan()
        run(1, "cannot write", ".", "-o", folder)

        # more files than are named
        plan()
        for k in range(210):
            write(f"{k}.exr", "")
            write(f"{k}.png", b"\x89PNG\r\n\x1a\n" +
                  struct.pack(">I4sIIBBBBBI", 13, b"IHDR", 1, 1, 8, 0, 0, 0, 0, 0))
        text = run(0, "And 202 more PNG files.")
        check(" and 170 more.</p>" in text, "EXR files without a word")
        check("The first 200 of 421 rows; all are in the folder" in text, "rows without a word")

        # values of other kinds than a plan has, or beyond all measure
        for value in (None, "x", [], {}, -1e308, [[[]]], "<script>"):
            plan(sensors=value, coverage=value, curve=value, bound=value,
                 robustness=value, candidates=value, conditions=value,
                 regions_of_interest=value, seen_by_at_least=value, photons=value)
            run(0, "The placement")
            plan(sensors=[value], curve=[value, {"count": value, "coverage": 1}],
                 conditions=[value], seen_by_at_least=[value],
                 robustness={"drop_one": {"without": [value]}})
            run(0, "The placement")
        plan(sensors=[{"position_m": [1e300, -1e300, 0], "covers": 1e300}] * 2,
             curve=[{"count": 1e300, "coverage": -1e300, "upper": 1e300}] * 2)
        run(0, "The placement")
        plan(sensors=[{"type": "node", "position_m": [k, 1, 1]} for k in range(20000)])
        run(0, "The first 200 of 20000 rows")

        # summaries that are none, and whose text would be markup
        for value in (None, "x", [], {}, [{}, []], 3):
            plan(run={"summary": value})
            run(0, "plan.json holds no summary of its run")
        plan(run={"summary": ["<b>bold     <i>x", {}, "  more", "", 5, "y" * 90000, "a  " * 3000]})
        text = run(0, "&lt;b&gt;bold     &lt;i&gt;x\n  more")
        check("<b>bold" not in text and "<i>x" not in text, "a line is a tag")

        # tables beside the JSON that are not what they should be
        ledger = json.dumps({"murk": PLAN["murk"]})
        for rows in ("top,550,0,0,0,forward,1,0,W\n" * 2, "top,550,9,0,0,forward,1,0,W\n",
                     "top,nan,0,0,0,forward,1,0,W\n", "top,550,-1,0,0,forward,1,0,W\n",
                     "top,550,1e9,1e9,1e9,forward,1,0,W\n", "top,550,0.5,0,0,,1e999,x,W\n",
                     "".join(f"top,{n},0,0,0,forward,1,0,W\n" for n in range(400, 420)),
                     "".join(f"<b>,550,{n},0,0,<i>,1e308,1e308,<u>\n" for n in range(5000))):
            write("ledger.json", ledger)
            write("tallies.csv", "tally,band_nm,bin_i,bin_j,bin_k,direction,value,"
                  "standard_error,unit\n" + rows)
            text = run(0, "Tallies")
            check("<b>" not in text and "<i>" not in text, "a name is a tag")
        write("ledger.json", ledger)
        write("tallies.csv", "a\nb\n")
        run(0, "Tallies")
        write("ledger.json", ledger)
        write("tallies.csv", "")
        run(2, "tallies.csv")
        write("ledger.json", ledger)
        write("tallies.csv", "tally\n")
        write("scene.yaml", GRID)
        write("inside.vdb", b"\x20\x42\x44\x56" * 100)
        run(0, "It cannot be shown: inside:")

        # photons
        for content, part in ((b"ply\n", "not a plan.ply"),
                              ((PLY % 3).encode() + photon(1), "cut short: 1 of 3"),
                              ((PLY % 10**18).encode() + photon(1), "cut short"),
                              (b"\x00" * 4000, "not a plan.ply")):
            plan()
            write("plan.ply", content)
            run(0, part)
        plan()
        write("plan.ply", (PLY % 3).encode() + photon(float("nan")) + photon(float("inf")) +
              photon(2))
        run(0, "1 of the 1 stored photons")
        plan()
        write("plan.ply", (PLY % 250000).encode() +
              b"".join(photon(k * 1e-3, 1 + k % 2, k % 3) for k in range(250000)))
        run(0, "Of 250000 stored photons 100000 are here")
        # far places, light.murk, path.ply, fit.csv
        plan()
        write("plan.ply", (PLY % 2).encode() + photon(1e30) + photon(-3))
        run(0, "1 of the 1 stored photons")
        for content in (b"", b"murk", b"\x00" * 100000):
            write("ledger.json", json.dumps({"murk": PLAN["murk"]}))
            write("light.murk", content)
            run(0, "light.murk cannot be read, so photons are not shown")
        for content in (b"", (PLY % 3).encode(), PATH % 10**15, PATH % 5 + b"\x00" * 17,
                        PATH % 2 + struct.pack("<3f3BBH", *[float("nan")] * 3, 0, 0, 0, 0, 1)):
            plan()
            write("path.ply", content)
            run(0, "The path is not shown")
        for content in ("", "a,b\n1\n", "x_m,y_m,z_m\n1,2\n"):
            write("fit.json", json.dumps({"murk": PLAN["murk"]}))
            write("fit.csv", content)
            run(2, "fit.csv")
        write("fit.json", json.dumps({"murk": PLAN["murk"]}))
        write("fit.csv", "x_m,y_m,z_m,kind,unit,residual_in_standard_errors,value\n"
              "1,2,3,<b>,&,x,1e999\n,,,a,b,1,2\n1e300,0,0,a,b,1,2\n")
        text = run(0, "\"kind\":\"\\u003cb>\"")
        check(text.count('"residual"') == 1, "readings without a place")
        plan(conditions=[{"name": "../" * 50}, {"name": "x"}, {"name": "<i>"}, {}])
        run(0, "&lt;i&gt;")
        # files of one run, and of two
        ledger = {"murk": PLAN["murk"], "seed": 1, "run": {"command": "murk place a"}}
        for change, is_one in (({}, True), ({"seed": 2}, False), ({"scene_sha256": "b"}, False),
                               ({"run": {"command": "murk trace a"}}, False)):
            plan(scene_sha256="a", run={"command": "murk place a"})
            write("scene.yaml", GRID)
            write("ledger.json", json.dumps({**ledger, **change}))
            text = run(0, "How plan.json was made")
            for part, is_there in (("files of several runs", not is_one),
                                   ("How ledger.json was made", not is_one),
                                   ("scene.yaml -o again", is_one)):
                check((part in text) == is_there, change, part)

        check_interrupt(murk, folder)
        plan()
        write("scene.yaml", "murk: 1\nnonsense: 3\n")
        run(0, "surfaces, ranges and media are not shown (")
        plan()
        run(0, "surfaces, ranges and media are not shown (it is not there)")
    print("failures:", failures + len(pages.failed))
    return failures + len(pages.failed) > 0


if __name__ == "__main__":
    sys.exit(main(os.path.abspath(sys.argv[1]), len(sys.argv) > 2 and sys.argv[2] != ""))
