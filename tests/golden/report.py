#!/usr/bin/env python3
"""The report of a result folder from outside: one HTML file that is well
formed, loads nothing, allows its own style and script alone, shows the numbers
of the results, and takes names for what they are: text. Standard library only.
usage: report.py MURK
"""

import array
import base64
import csv
import html
import json
import math
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import browser  # noqa: E402
import pages  # noqa: E402
from pages import Plot, check, commands, drawn, number, read, table  # noqa: E402

EVIL = "<img src=x onerror=alert(1)>&\"'"

SCENE = """\
murk: 1
bands_nm: [550]
domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}
geometry:
  - {box: {min_m: [0.1, 0.1, 0.1], max_m: [3.9, 3.9, 2.9]}, material: "EVIL"}
  - {box: {min_m: [1.5, 1.5, 0.1], max_m: [2.5, 2.5, 1.6]}}
  - {sphere: {center_m: [3, 3, 1], radius_m: 0.3}}
materials: {"EVIL": {diffuse: 0.6}, unmet: {diffuse: 0.5}}
media: {"EVIL fog": {extinction_per_m: 0.3, albedo: 0.9, phase: {hg: 0.8}}}
regions: [{medium: "EVIL fog"}]
lights: [{type: point, position_m: [2, 2, 2.5], power_w: 10}]
photons: {emit: 3000}
sensors:
  types:
    - {name: "EVIL", range_m: 2.2}
    - {name: camera, range_m: 3, view: {hfov_deg: 60, vfov_deg: 40}, headings: 4}
  candidates: {grid: {min_m: [0.5, 0.5, 0.5], max_m: [3.5, 3.5, 2.5], size: [3, 3, 2]}}
  count: 3
""".replace("EVIL", EVIL.replace('"', '\\"'))


TALLIES = """\
tallies:
  - {name: ball, type: sphere, center_m: [1, 3, 1], radius_m: 0.4, hemispheres: true}
  - {name: strip, type: plane, point_m: [0, 0, 2], normal: [0, 0, 1], bins: [5, 1]}
  - {name: floor, type: plane, point_m: [0, 0, 1], normal: [0, 0, 1], bins: [4, 3]}
  - {name: grid, type: grid, min_m: [0, 0, 0], max_m: [4, 4, 3], size: [5, 5, 5]}
"""


def block(text, name):
    return re.search(f'<script type="[a-z/]*" id="{name}">([^<]*)</script>', text).group(1)


def photons_of(path):
    """x, y, z, seen_by, sensors of plan.ply's photons."""
    with open(path, "rb") as file:
        head, body = file.read().split(b"end_header\n", 1)
    n = int(re.search(rb"element vertex (\d+)", head).group(1))
    rows = struct.iter_unpack("<3f4BHfI", body[:26 * n])
    return [(*row[:3], row[7], row[9]) for row in rows if row[6] in (1, 2)]


def view_data(path):
    with open(path, encoding="utf-8") as file:
        text = file.read()
    return json.loads(block(text, "view-data")), text


def check_sections(data):
    """Lines of both drawings: the outlines that the planes cut out of two boxes and a ball of SCENE."""
    check([one["axis"] for one in data["sections"]] == [2, 1], "sections", data["sections"])
    for one in data["sections"]:
        at, ends = one["at_m"], array.array("f", base64.b64decode(one["lines"]))
        check(one["count"] == one["asked"] == len(ends) // 4, "lines", one["count"], one["asked"], len(ends))
        is_level = one["axis"] == 2
        want = 4 * 3.8 if is_level else 2 * (3.8 + 2.8)
        if .1 < at <= 1.6 if is_level else 1.5 <= at < 2.5:
            want += 4 if is_level else 2 * (1 + 1.5)
        from_middle = at - (1 if is_level else 3)
        if abs(from_middle) < .3:
            want += 2 * 48 * math.sin(math.pi / 48) * math.sqrt(.3 ** 2 - from_middle ** 2)
        got = sum(math.dist(ends[i:i + 2], ends[i + 2:i + 4]) for i in range(0, len(ends), 4))
        check(abs(got - want) < 1e-4, "lines are long", got, "want", want, "at", at)
        check(min(ends) > .0999 and max(ends) < 3.9001, "lines beyond the box", min(ends), max(ends))


def picture(width, height, size=0):
    """A grey PNG that says which camera it is of, with `size` bytes more."""
    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))
    rows = (b"\0" + b"\x80" * width) * height
    return (b"\x89PNG\r\n\x1a\n" +
            chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)) +
            chunk(b"iTXt", b"murkCamera\0\0\0\0\0" + EVIL.encode()) +
            chunk(b"iTXt", b"murkChannel\0\0\0\0\0S0.550nm") +
            chunk(b"iTXt", b"murkCommand\0\0\0\0\0murk render 'a <b>.yaml' --png") +
            chunk(b"iTXt", b"murkColours\0\0\0\0\0viridis, linear, 1 to 2") +
            chunk(b"zzZz", b"x" * size) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def in_short(path):
    """The lines of the page's summary, without marks."""
    with open(path, encoding="utf-8") as file:
        (items,) = re.findall('<dl class="facts lines">(.*?)</dl>', file.read(), re.S)
    return html.unescape(re.sub("<[^>]*>", " ", items)).splitlines()


def check_summary(printed, path):
    """The page has the terminal's summary: the same words in the same order, up to the times, and the columns
    of its tables."""
    printed, lines = re.split("^time ", printed, flags=re.M)[0], in_short(path)
    check(len(printed) > 100 and printed.split() == " ".join(lines).split(), path, "sums up", lines, "not", printed)
    for row in re.findall(r"^ *\d+  .*", printed, flags=re.M):
        check(any(line.strip().startswith(row.strip()) for line in lines), path, "lacks the row", row)


def check_prediction(run, at, scene):
    """Of the scene's values and of a fit's: residuals, measured against predicted in both units, and the table."""
    for out, options in (("predicted", []), ("predicted-by", ["--predict", "fit/fit.json"])):
        summary = run("fit", scene, "--data", "data.csv", "-o", out, "--emit", "2000", "--report", *options)
        check_summary(summary.split(out + "/report.html")[0], at(out + "/report.html"))
        page, text = read(at(out + "/report.html")), drawn(at(out + "/report.html"))
        check("The prediction" in page.text and "The calibration" not in page.text, "headings of", out)
        check(("The values of the fit" in page.text) == bool(options), "values of", out)
        check(page.tags.count("svg") == 3, page.tags.count("svg"), "plots of", out)
        rows = table(at(out + "/fit.csv"))
        plot = Plot(text, "Residuals (measured less predicted)")
        for series, use in enumerate(("fit", "hold_out")):
            of_use = [(k + 1, r) for k, r in enumerate(rows) if r["use"] == use]
            check(len(of_use) == len(plot.marks(series)) > 0, "residuals of", use, "in", out)
            for mark, (k, row) in zip(plot.marks(series), of_use):
                plot.is_at(mark, k, float(row["residual_in_standard_errors"]), row)
        plot = Plot(text, "Measured against predicted")
        for mark, row in zip(plot.marks(0), rows):
            plot.is_at(mark, float(row["predicted"]), float(row["value"]), row)
        readings = view_data(at(out + "/report.html"))[0]["readings"]
        check([r["place"] for r in readings] == [[.8, .8, 2.5], [3, 1, 2.5], [1, 3, 1], [1, 1, 2]], "readings of", out)
    run("fit", scene, "--data", "data.csv", "-o", "predicted", "--emit", "2000", "--free", "lights.0.power_w", "--traces", "1")
    run("report", "predicted", "--quiet")
    check(drawn(at("predicted/report.html")).count(">Residuals (measured") == 1, "readings of two runs are shown once")


def main(murk):
    if not browser.program():
        print("skipped: no chromium")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        def at(name):
            return os.path.join(folder, name)

        def whole(name):
            return os.path.join(os.path.realpath(folder), name)

        def write(name, text):
            with open(at(name), "w", encoding="utf-8") as file:
                file.write(text)

        def run(*arguments):
            done = subprocess.run([murk, *arguments], cwd=folder, text=True,
                                  capture_output=True, check=False)
            check(done.returncode == 0, arguments, done.stderr)
            return done.stdout

        def paste(text):
            """The commands in a shell that finds murk, from anywhere."""
            os.symlink(murk, at("bin/murk"))
            done = subprocess.run(["bash", "-euc", text], cwd="/", text=True, check=False,
                                  capture_output=True, env={"PATH": at("bin") + ":/usr/bin:/bin"})
            os.unlink(at("bin/murk"))
            check(done.returncode == 0, text, done.stderr)

        def facts(name):
            """A JSON but for `run`."""
            with open(at(name), encoding="utf-8") as file:
                value = json.load(file)
            check("-o" not in value["run"]["command"].split(), value["run"])
            check(value["run"]["folder"] == os.path.realpath(folder), value["run"])
            del value["run"]
            return value

        def make_again(out, name, blocks=1):
            """What the page says to type makes the same JSON."""
            run("report", out, "--quiet")
            found = commands(at(out + "/report.html"))
            check(len(found) == blocks, out, found)
            for text in found[:1]:
                paste(text)
                check(facts("again/" + name) == facts(out + "/" + name), out, "is not the same:", text)
                check(os.path.exists(at("again/report.html")), "no report again")
            shutil.rmtree(at("again"), ignore_errors=True)

        os.mkdir(at("bin"))
        write("it's <b>.yaml", SCENE)
        scene = "it's <b>.yaml"
        summary = run("place", scene, "-o", "plan")
        printed = json.loads(run("report", "plan", "--format", "json"))
        check_summary(summary, at("plan/report.html"))
        check(printed["report"] == "plan/report.html", printed)
        check(printed["bytes"] == os.path.getsize(at("plan/report.html")), printed)
        page = read(at("plan/report.html"))
        with open(at("plan/plan.json"), encoding="utf-8") as file:
            plan = json.load(file)
        coverage = plan["coverage"]
        for key in ("in_sample", "held_out", "ceiling"):
            check(f"{100 * coverage[key]:.2f}" in page.text, key, "is not shown")
        for key, name in (("surface", "of light on surfaces"),
                          ("volume", "of light scattered in media")):
            error = 100 * coverage[key + "_standard_error"]
            shown = re.search(name + r"\s*([\d.]+) ± ([\d.]+) %", page.text)
            check(error > 0 and shown and abs(float(shown[2]) - error) < 0.06 * error, name, shown)
        check(f"{100 * plan['bound']['upper']:.2f}" in page.text, "no bound")
        for sensor in plan["sensors"]:
            check(f"{100 * sensor['covers']:.2f} %" in page.text, "a sensor's share")
        check(EVIL in page.text, "the type's name")
        check(f"of that by {EVIL} fog" in page.text, "the medium's name")
        with open(at("plan/ledger.json"), encoding="utf-8") as file:
            check(json.load(file)["absorbed_by_material_w"]["unmet"]["total"] == 0, "met")
        check("of that by default" in page.text and "by unmet" not in page.text, "what is unmet")
        check(plan["scene_sha256"] in page.text and plan["murk"]["commit"] in page.text,
              "no provenance")
        resolved = commands(at("plan/report.html"))[1]
        check(f"murk place {whole('plan')}/scene.resolved.yaml -o again" in page.text, "no command")
        check("murk place 'it'\\''s <b>.yaml' -o again" in page.text, "not as typed")
        # curve, samples, shares, seen by, losses, two drawings, light
        check(page.tags.count("svg") == 8, page.tags.count("svg"), "plots, want 8")
        check(page.tags.count("table") >= 5, "tables")
        photons = plan["photons"]["surface"] + plan["photons"]["volume"]
        check(printed["photons"] == photons == printed["photons_shown"], printed)

        # the view's data: places within half a step of the photons' own, all
        # of them, in order; triangles of both boxes, one sphere, names as text
        with open(at("plan/report.html"), encoding="utf-8") as file:
            text = file.read()
        data = json.loads(block(text, "view-data"))
        check_sections(data)
        places = array.array("H", base64.b64decode(block(text, "photon-places-0")))
        seen = base64.b64decode(block(text, "photon-seen-0"))
        (state,) = data["states"]
        who = base64.b64decode(block(text, "photon-sensors-0"))
        want = photons_of(at("plan/plan.ply"))
        check(len(want) == photons == len(seen) == len(places) // 3 == state["photons"],
              "photons in the view")
        low, high = state["low"], state["high"]
        far = max(abs(low[k] + (high[k] - low[k]) * places[3 * i + k] / 65535 - want[i][k])
                  for i in range(photons) for k in range(3))
        check(far <= .5001 * max(h - l for l, h in zip(low, high)) / 65535, "places off by", far)
        check(list(seen) == [w[3] for w in want], "seen by")
        check(state["bit_bytes"] == 1 and list(who) == [w[4] for w in want], "by whom")
        check(all(bin(w[4]).count("1") == w[3] for w in want), "as many as see it")
        check(state["surface_photons"] == plan["photons"]["surface"], "photons on surfaces")
        check(len(base64.b64decode(block(text, "mesh-corners-0"))) == 24 * 6, "triangles")
        check(data["balls"] == [{"center": [3, 3, 1], "radius": 0.3}] or
              abs(data["balls"][0]["radius"] - 0.3) < 1e-6, data["balls"])
        check([s["type"] for s in state["sensors"]] == [s["type"] for s in plan["sensors"]],
              "names in the view")
        for shown, sensor in zip(state["sensors"], plan["sensors"]):
            check(shown["place"] == sensor["position_m"], shown)
            check(sensor["heading_deg"] is None or
                  all(abs(a - b) < 1e-9 for a, b in zip(shown["axis"], sensor["axis"])), shown)
        cells = base64.b64decode(block(text, "media-cells-0"))
        check(data["lamps"][0]["place"] == [2, 2, 2.5] and data["north"] == [0, 1, 0], "lamps")
        check(len(cells) == math.prod(data["media"][0]["size"]) and set(cells) == {255}, "even fog")

        # plots, read back: the curve, and both samples with their intervals
        text = drawn(at("plan/report.html"))
        plot = Plot(text, "Coverage by number of sensors")
        for mark, bound, step in zip(plot.marks(0), plot.marks(1), plan["curve"]):
            plot.is_at(mark, step["count"], step["coverage"], "the curve")
            plot.is_at(bound, step["count"], step["upper"], "its bound")
        check(len(plot.marks(0)) == len(plan["curve"]) > 2, "points of the curve")
        plot = Plot(text, "In sample against held out")
        for series, key in enumerate(("in_sample", "held_out")):
            value, error = coverage[key], coverage[key + "_standard_error"]
            plot.is_at(plot.marks(series)[0], None, value, key)
            for end, sign in zip(plot.whiskers(series)[0], (-1, 1)):
                plot.is_at((0, end), None, value + sign * 1.96 * error, key + "'s interval")
        for losses in plan["robustness"]["drop_one"]["without"]:
            check(f"{100 * (coverage['held_out'] - losses['held_out']):.2f} %" in page.text, losses)
        for share in plan["seen_by_at_least"]:
            check(f"{100 * share:.2f} %" in page.text, "seen by at least")

        # pictures that lie beside it, but what is none or too large
        small = picture(40, 30)
        for name, content in (("a.png", small), ("b.png", b"GIF89a" * 9), ("c.exr", b"x"),
                              ("d.png", picture(9000, 1)), ("e.png", picture(7, 7, 800000)),
                              ("f.png", small[:40]), ("g.png", small[:20])):
            with open(at("plan/" + name), "wb") as file:
                file.write(content)
        os.mkfifo(at("plan/h.png"))
        write("plan/notes.html.txt", "of mine")
        os.symlink("/dev/zero", at("plan/i.png"))
        run("report", "plan", "-o", "pictures.html", "--quiet")
        page = read(at("pictures.html"), [small, small[:40]])
        check(f"40 x 30 pixels, camera {EVIL}" in page.text, "no caption")
        check(", channel S0.550nm, colours viridis, linear, 1 to 2. Made by murk render "
              "'a <b>.yaml' --png" in page.text, "no colours, or no command")
        check("e.png (7 x 7 pixels, 0.80 MB) is too large" in page.text, "the large one")
        check("Radiances with their errors are in c.exr" in page.text, "the EXR's name")
        check("notes.html.txt" in page.text, "a file whose name has .html in it")
        os.unlink(at("plan/notes.html.txt"))
        for name in "abdefghi":
            os.unlink(at(f"plan/{name}.png"))
        os.unlink(at("plan/c.exr"))

        # from the scene beside it: the same plan
        paste(f"cd {folder}\n" + resolved)
        with open(at("again/plan.json"), encoding="utf-8") as file:
            again = json.load(file)
        check(again["coverage"] == coverage and again["sensors"] == plan["sensors"],
              "the command of the page gives another plan")
        shutil.rmtree(at("again"))

        # the same bytes again, and in the file that is named
        run("report", "plan", "-o", "named.html", "--quiet")
        with open(at("named.html"), "rb") as a, open(at("plan/report.html"), "rb") as b:
            want = a.read()
            check(want == b.read(), "two reports of one folder differ")
        check(b"Results of the folder plan." in want, "the folder's name")
        os.unlink(at("plan/report.html"))

        # and from inside of it
        subprocess.run([murk, "report", ".", "-q"], cwd=at("plan"), check=True)
        with open(at("plan/report.html"), "rb") as file:
            check(file.read() == want, "the page of . differs")

        summary = run("sense", scene, "--sensors", "plan/plan.json", "-o", "seen")
        run("report", "seen")
        check_summary(summary, at("seen/report.html"))
        page = read(at("seen/report.html"))
        check(f"murk sense {whole('seen')}/scene.resolved.yaml --sensors {whole('seen')}/coverage.json"
              in page.text,
              "no command of sense")
        run("sense", "seen/scene.resolved.yaml", "--sensors", "seen/coverage.json", "--quiet")
        data, text = view_data(at("seen/report.html"))
        want = photons_of(at("seen/coverage.ply"))
        check(want == photons_of(at("plan/plan.ply")), "the same sensors see otherwise")
        check(base64.b64decode(block(text, "photon-sensors-0")) == bytes(w[4] for w in want),
              "by whom, of sense")

        summary = run("trace", scene, "-o", "light")
        run("report", "light")
        check_summary(summary, at("light/report.html"))
        check(f"murk trace {whole('light')}/scene.resolved.yaml -o again" in read(at("light/report.html")).text,
              "no command of trace")
        (state,) = view_data(at("light/report.html"))[0]["states"]
        check(state["stored"] == state["photons"] == photons and state["sensors"] == [],
              "photons of light.murk")

        write("study.yaml", 'murk_study: 1\nbase: "it\'s <b>.yaml"\naxes:\n'
              "  lights.0.power_w: [1, 2, 4]\n  photons.emit: [500, 1000]\n"
              "outputs: [density, coverage_best]\n")
        summary = run("study", "study.yaml", "-o", "study")
        run("report", "study")
        check_summary(summary, at("study/report.html"))
        page = read(at("study/report.html"))
        check(page.tags.count("svg") == 4, page.tags.count("svg"), "want 2 plots, 2 drawings")
        check("photons.emit 500" in page.text, "no line's name")
        text = drawn(at("study/report.html"))
        check(text.count('class="band') == 4, "bands: two lines in two plots")
        rows = table(at("study/table.csv"))
        for output in ("density", "coverage_best"):
            plot = Plot(text, output + ", with 95 % intervals")
            for series, emitted in enumerate(("500", "1000")):
                line = [r for r in rows if r["photons.emit"] == emitted]
                check(len(plot.marks(series)) == len(line) == 3, "points of a line")
                for mark, row in zip(plot.marks(series), line):
                    plot.is_at(mark, float(row["lights.0.power_w"]), float(row[output]),
                               f"{output} of {row}")

        data = view_data(at("study/report.html"))[0]
        check([s["name"] for s in data["states"]] == ["the plan of every row"], data["states"])
        check("mesh" in data and os.path.exists(at("study/scene.resolved.yaml")), "the base scene")
        run("check", "study/scene.resolved.yaml")
        write("more.yaml", 'murk_study: 1\nbase: "it\'s <b>.yaml"\naxes: {sensors.count: [1, 2]}\n'
              "outputs: [coverage_best]\n")
        run("study", "more.yaml", "-o", "more", "--quiet")
        run("report", "more")
        with open(at("more/study.json"), encoding="utf-8") as file:
            study = json.load(file)
        states = view_data(at("more/report.html"))[0]["states"]
        check([s["name"] for s in states] ==
              ["row 1: sensors.count 1", "row 2: sensors.count 2"], states)
        for shown, row in zip(states, study["rows"]):
            check([s["place"] for s in shown["sensors"]] ==
                  [s["position_m"] for s in row["sensors"]], shown["name"])

        # steps of a timeline: a lamp is dimmed, the fog grows thicker, a box moves
        write("steps.yaml", SCENE + "timeline: {from_s: 0, to_s: 6, every_s: 2, tracks: [\n"
              "  {key: lights.0.power_w, keyframes: [{t_s: 0, value: 10}, {t_s: 6, value: 1}]},\n"
              f"  {{key: {json.dumps(f'media.{EVIL} fog.extinction_per_m')}, keyframes: [{{t_s: 0, value: 0.3}}, {{t_s: 4, value: 2}}]}},\n"
              "  {geometry: 1, keyframes: [{t_s: 0, translate_m: [0, 0, 0]}, {t_s: 6, translate_m: [1, 0, 0]}]}]}\n")
        summary = run("follow", "steps.yaml", "-o", "steps", "--set", "placement.method=greedy")
        run("report", "steps")
        check_summary(summary[summary.index("steps  "):], at("steps/report.html"))  # without the rows
        page = read(at("steps/report.html"))
        check(page.tags.count("svg") == 4 + 2 + 4, page.tags.count("svg"), "want 4 plots, 2 drawings, 4 steps")
        rows, data = table(at("steps/follow.csv")), view_data(at("steps/report.html"))[0]
        check([s["name"] for s in data["states"]] == [f"step {k}: {2 * k} s" for k in range(4)], data["states"])
        check(len({s["media"] for s in data["states"]}) > 1, "the same fog at all steps")
        text = drawn(at("steps/report.html"))
        plot = Plot(text, "Coverage of the plan of each step, with its 95 % interval, and the bound of its sample")
        work = Plot(text, "Share of the work that each step took over from the step before")
        for k, row in enumerate(rows):
            with open(at(f"steps/steps/{k:04}/plan.json"), encoding="utf-8") as file:
                plan = json.load(file)
            state = data["states"][k]
            check([s["place"] for s in state["sensors"]] == [s["position_m"] for s in plan["sensors"]], state["name"])
            check(state["stored"] == len(photons_of(at(f"steps/steps/{k:04}/plan.ply"))), "photons of", state["name"])
            plot.is_at(plot.marks(0)[k], float(row["t_s"]), float(row["coverage"]), f"coverage of {row}")
            plot.is_at(plot.marks(1)[k], float(row["t_s"]), float(row["upper"]), f"bound of {row}")
            both = [int(row[name]) for name in ("photons_kept", "photons_traced")]
            work.is_at(work.marks(0)[k], float(row["t_s"]), both[0] / sum(both), f"photons taken over of {row}")
            check(f"{100 * float(row['coverage']):.2f} ±" in page.text, "coverage of", row)
        check("Steps that failed" not in page.text, "a step that failed")
        found = commands(at("steps/report.html"))
        check(len(found) == 2 and "murk follow" in found[1], found)
        paste(found[0])
        check([row["coverage"] for row in table(at("again/follow.csv"))] == [row["coverage"] for row in rows],
              "is not the same:", found[0])
        shutil.rmtree(at("again"))
        # without the folders of some steps, and with one that failed
        shutil.rmtree(at("steps/steps/0001"))
        with open(at("steps/follow.json"), encoding="utf-8") as file:
            follow = json.load(file)
        follow["steps"][2].update({"failed": EVIL, "coverage": None, "upper": None})
        write("steps/follow.json", json.dumps(follow))
        run("report", "steps")
        data, page = view_data(at("steps/report.html"))[0], read(at("steps/report.html"))
        check([s["name"] for s in data["states"]] == ["step 0: 0 s", "step 3: 6 s"], data["states"])
        check("Steps that failed" in page.text and EVIL in page.text, "the step that failed")

        # 40 rows, more than the page has states for: the last plan may differ from all others, or be equal
        os.mkdir(at("long"))
        write("long/table.csv", "a\n" + "".join(f"{n}\n" for n in range(40)))
        for last, names, asked in ((2, [f"row {n + 1}: a {n}" for n in range(32)], 40), (1, ["the plan of every row"], 1)):
            places = [[1, 1, 1]] * 39 + [[1, 1, last]]
            write("long/study.json", json.dumps({
                "murk": study["murk"], "axes": [{"key": "a"}], "rows": [
                    {"row": n + 1, "axes": {"a": n}, "sensors": [{"type": "node", "position_m": place}]}
                    for n, place in enumerate(places)]}))
            run("report", "long", "--force")
            data = view_data(at("long/report.html"))[0]
            check([s["name"] for s in data["states"]] == names and data["states_asked"] == asked, data["states"])

        write("data.csv",
              "kind,x_m,y_m,z_m,x2_m,y2_m,z2_m,radius_m,unit,value,standard_error,use\n"
              "fluence,0.8,0.8,2.5,,,,0.3,W/m2,0.5,0.05,fit\n"
              "fluence,3,1,2.5,,,,0.3,W/m2,0.4,0.04,fit\n"
              "fluence,1,3,1,,,,0.3,W/m2,0.3,0.03,hold_out\n"
              "transmittance,1,1,2,1,3,2,,fraction,0.5,0.05,fit\n")
        summary = run("fit", scene, "--data", "data.csv", "--free", "lights.0.power_w", "-o", "fit",
                      "--traces", "1", "--emit", "2000")
        run("report", "fit")
        check_summary(summary, at("fit/report.html"))
        page = read(at("fit/report.html"))
        check("--free lights.0.power_w" in page.text, "no command of fit")
        check("'it'\\''s <b>.yaml'" in page.text, "the scene is not quoted for a shell")
        # the value's interval, residuals, measured against predicted in each unit
        check("held out" in page.text and page.tags.count("svg") == 4, page.tags.count("svg"))
        readings = view_data(at("fit/report.html"))[0]["readings"]
        check([(r["place"], r["to"]) for r in readings] ==
              [([0.8, 0.8, 2.5],) * 2, ([3, 1, 2.5],) * 2, ([1, 3, 1],) * 2,
               ([1, 1, 2], [1, 3, 2])], readings)
        check([r["held_out"] for r in readings] == [False, False, True, False], "held out")
        with open(at("fit/fit.csv"), encoding="utf-8") as file:
            residuals = [float(r["residual_in_standard_errors"]) for r in csv.DictReader(file)]
        check(all(abs(r["residual"] - want) < 1e-12 for r, want in zip(readings, residuals)),
              "residuals in the view")

        fit_of = json.loads(open(at("fit/fit.json"), encoding="utf-8").read())
        value = fit_of["parameters"][0]
        text = drawn(at("fit/report.html"))
        plot = Plot(text, "How well each value is known")
        for end, bound in zip(plot.whiskers(0)[0], ("lower", "upper")):
            plot.is_at((0, end), None, value[bound] / value["value"] - 1, bound)
        plot = Plot(text, "Residuals (measured less predicted)")
        rows = table(at("fit/fit.csv"))
        for series, use in enumerate(("fit", "hold_out")):
            of_use = [(k + 1, r) for k, r in enumerate(rows) if r["use"] == use]
            check(len(of_use) == len(plot.marks(series)) > 0, "residuals of", use)
            for mark, (k, row) in zip(plot.marks(series), of_use):
                plot.is_at(mark, k, float(row["residual_in_standard_errors"]), row)
        plot = Plot(text, "Measured against predicted")
        for mark, row in zip(plot.marks(0), rows):
            plot.is_at(mark, float(row["predicted"]), float(row["value"]), row)

        check_prediction(run, at, scene)

        # tallies: a line, a map, single values, slices through a grid; light by band
        write("tallies.yaml", SCENE.replace("[550]", "[450, 550]") + TALLIES)
        run("trace", "tallies.yaml", "-o", "tallies", "--quiet")
        run("report", "tallies")
        page = read(at("tallies/report.html"))
        text = drawn(at("tallies/report.html"))
        rows = table(at("tallies/tallies.csv"))
        for row in (r for r in rows if r["tally"] == "ball"):
            check(re.search(rf"ball{row['direction']}{row['band_nm']} nm[\d.(]*", page.text), row)
        plot = Plot(text, "Tally strip")
        for series, (direction, band) in enumerate((w, b) for w in ("forward", "backward")
                                                   for b in ("450", "550")):
            line = [r for r in rows if (r["tally"], r["direction"], r["band_nm"]) ==
                    ("strip", direction, band)]
            check(len(plot.marks(series)) == len(line) == 5, "bins of the strip")
            for mark, row in zip(plot.marks(series), line):
                plot.is_at(mark, (int(row["bin_i"]) + 0.5) * 0.8, float(row["value"]), row)
        for direction in ("forward", "backward"):
            bins = {}
            for row in rows:
                if row["tally"] == "floor" and row["direction"] == direction:
                    bins.setdefault((row["bin_i"], row["bin_j"]), []).append(float(row["value"]))
            brightest = max(bins, key=lambda k: sum(bins[k]))
            brightest_m = [(int(i) + 0.5) * 4 / n for i, n in zip(brightest, (4, 3))]
            said = re.search(rf"Tally floor, {direction}, all bands and angles: 4 x 3 cells; from "
                             r"([\d.·⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+) to ([\d.·⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+) W a bin, which is at "
                             r"([\d.]+), ([\d.]+)\.", page.text)
            check(said, "no map of", direction)
            if said:
                for text_of, want in zip(said.groups(), (min(map(sum, bins.values())),
                                                         max(map(sum, bins.values())), *brightest_m)):
                    check(abs(number(text_of) - want) <= 1e-4 * want, direction, said[0], want)
        for axis in ("z = 1.5 m", "y = 2 m", "x = 2 m"):
            check(f"Fluence rate grid at 450 nm at {axis}: " in page.text, "no slice", axis)
        with open(at("tallies/ledger.json"), encoding="utf-8") as file:
            ledger = json.load(file)
        for key in ("absorbed_surfaces_w", "absorbed_media_w", "escaped_w"):
            check(f"{ledger[key]['total']:.5g}" in page.text, key)
            for watts in ledger[key]["bands"]:
                check(f"{watts:.5g}" in page.text, key, "by band")

        # over conditions, with other seeds, exploring
        summary = run("place", scene, "-o", "over", "--set", "placement.over=worst", "--set",
                      "conditions={bright: {}, dim: {lights.0.power_w: 1}}", "--repeat", "1")
        run("report", "over")
        check_summary(summary, at("over/report.html"))
        page = read(at("over/report.html"))
        with open(at("over/plan.json"), encoding="utf-8") as file:
            plan = json.load(file)
        for made in plan["regret"]["plans"]:
            for value, error in zip(made["coverage"], made["standard_error"]):
                check(f"{100 * value:.2f} ± {100 * error:.2f} %" in page.text, "regret", made["made_for"])
        run("place", scene, "-o", "explore", "--quiet", "--set", "placement.knowledge=explore",
            "--set", "placement.start_m=[0.5, 0.5, 0.5]", "--set", "placement.jitter_m=0.2")
        run("report", "explore")
        page = read(at("explore/report.html"))
        with open(at("explore/plan.json"), encoding="utf-8") as file:
            plan = json.load(file)
        plot = Plot(drawn(at("explore/report.html")), "Coverage along the way that was gone")
        steps = plan["explore"]["steps"]
        check(len(plot.marks(0)) == len(steps) + 1, "steps")
        for mark, step in zip(plot.marks(0)[1:], steps):
            plot.is_at(mark, step["path_m"], step["coverage"], step)
        jitter = plan["robustness"]["jitter"]
        for key in ("as_planned", "mean", "quantile_5"):
            check(f"{100 * jitter[key]:.2f}" in page.text, "jitter", key)

        # what is printed, pasted, makes the same: options of each kind
        run("place", scene, "-o", "two", "-j2", "--quiet", "--set", "placement.restarts=7",
            "--count", "2", "--seed=5", "--repeat", "2", "--progress=never")
        with open(at("two/plan.json"), encoding="utf-8") as file:
            repeat = json.load(file)["repeat"]
        run("report", "two")
        plot = Plot(drawn(at("two/report.html")), "The whole job with other seeds")
        for k, row in enumerate(table(at("two/repeat.csv"))):
            for series, key in enumerate(("held_out", "in_sample", "plan", "upper")):
                plot.is_at(plot.marks(series)[k], int(row["seed"]) + 0.08 * (series - 1.5),
                           float(row[key]), f"{key} of seed {row['seed']}")
        check(f"{100 * repeat['gap']['upper']:.2f} %" in
              read(at("two/report.html")).text, "no gap of the seeds")
        make_again("two", "plan.json", 2)
        run("sense", scene, "--sensors", "two/plan.json", "--emit", "900", "-o", "sensed", "--quiet")
        make_again("sensed", "coverage.json", 2)
        run("trace", scene, "-otraced", "--store", "500", "--quiet")
        make_again("traced", "ledger.json", 2)
        run("study", "study.yaml", "--seed", "9", "--set", "lights.0.position_m=[2, 2, 2.4]",
            "-o", "swept", "--quiet")
        make_again("swept", "study.json")
        run("fit", scene, "--data", "data.csv", "--free", "lights.0.power_w", "-o", "fitted",
            "--traces", "1", "--quiet", "--emit", "2000", "--loss", "huber:2", "--starts", "2",
            "--bounds", "lights.0.power_w=1:90")
        make_again("fitted", "fit.json")
    print("failures:", len(pages.failed))
    return len(pages.failed) > 0


if __name__ == "__main__":
    sys.exit(main(os.path.abspath(sys.argv[1])))
