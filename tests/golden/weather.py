#!/usr/bin/env python3
"""The weather of a scene in the commands: what check states of reports and years,
media and conditions by reports, hours of a year as rows of a study that share
light, the same numbers one by one, and refusals in one line. Standard library only.
usage: weather.py MURK
"""

import csv
import json
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile

murk = pathlib.Path(sys.argv[1]).resolve()
REPORTS = """murk: 1
bands_nm: [550]
domain: {min_m: [0, 0, 0], max_m: [50, 50, 10], sides: open}
weather: {metar: "EGHI 150650Z 06001KT 0500 R20/1000 FG VV/// 11/10 Q1003"}
lights: [{type: point, position_m: [25, 25, 5], power_w: 10}]
media: {air: {preset: weather}}
regions: [{medium: air}]
conditions:
  rain: {weather: {metar: "KEWR 111851Z VRB03G19KT 2SM TSRA BR OVC200 22/22 A2987 RMK P0013"}}
  snow: {weather: {synop: "AAXX 15061 10384 11/05 80302 10052 77344"}}
  given: {weather: {metar: "ESUT 112350Z AUTO 31015G26KT //// // M04/M06 Q1022"}, media.air.visibility_m: 3000}
photons: {emit: 1000}
sensors: {types: [{name: node, range_m: 60}], candidates: {points: [[5, 5, 5], [45, 45, 5]]}, count: 1}
placement: {over: mean}
"""
YARD = """murk: 1
band_edges_nm: [400, 700]
domain: {min_m: [0, 0, 0], max_m: [20, 20, 10], sides: open}
weather: {epw: june.epw}
site: {time: "2025-06-03T10:30:00+01:00"}
geometry:
  - {rect: {corner_m: [0, 0, 0], edge1_m: [20, 0, 0], edge2_m: [0, 20, 0]}}
  - {box: {min_m: [8, 12, 0], max_m: [12, 14, 6]}}
lights: [{type: daylight}]
photons: {emit: 40000, maps: none}
tallies: [{name: ground, type: plane, point_m: [10, 10, 0.01], normal: [0, 0, -1]}]
"""
STUDY = """murk_study: 1
base: yard.yaml
axes: {site.time: {hours_of: june.epw, first: 49, last: 72, step: 2}}
outputs: [ground, density]
"""
failures = 0


def check(holds, *text):
    global failures
    if not holds:
        failures += 1
        print("not so:", *text)


def run(folder, *words, status=0):
    done = subprocess.run([murk, *words], cwd=folder, capture_output=True, text=True)
    check(done.returncode == status, words, done.returncode, done.stderr)
    return done


def checked(folder, scene, *words):
    return json.loads(run(folder, "check", scene, "--format", "json", *words).stdout)


def near(got, want, tolerance=1e-3):
    return got is not None and abs(got - want) <= tolerance * abs(want)


def reports(folder):
    (folder / "fog.yaml").write_text(REPORTS)
    sky = checked(folder, "fog.yaml")
    weather = sky["weather"]
    check(weather["format"] == "METAR" and weather["visibility_m"] == 500 and weather["preset"] == "weather/fog", weather)
    check(weather["codes"] == "FG" and weather["direct_w_per_m2"] is None, weather)
    check(near(sky["media"][0]["extinction_per_m"][0], 2.99573 / 500), sky["media"][0])
    # conditions have their own report: extinction by visibility, as a range of 5 % contrast
    run(folder, "place", "fog.yaml", "-o", "out", "--quiet")
    for name, visibility_m, preset in (("rain", 3218.688, 3.912), ("snow", 500, None), ("given", 3000, 3.912)):
        own = checked(folder, f"out/scene-{name}.yaml", "--set", "placement={}")
        law = 3.91202 if name == "given" else 2.99573  # visibility_m is for 2 %
        check(near(own["media"][0]["extinction_per_m"][0], law / visibility_m), name, own["media"][0])
    check(checked(folder, "out/scene-snow.yaml", "--set", "placement={}")["weather"]["preset"] == "weather/snow")
    # heavy rain has more extinction than the visibility says: 1.2924 * 50^.6436 dB/km
    heavy = checked(folder, "fog.yaml", "--set", "conditions={}", "--set", "placement={}", "--set", "media.air.rain_mm_per_h=50",
                    "--set", 'weather={metar: "EGHI 150650Z 9999 11/10"}')
    check(near(heavy["media"][0]["extinction_per_m"][0], 1.2924 * 50 ** .6436 / 1000 / (10 * math.log10(math.e))), heavy["media"][0])
    # refusals
    for words, part in ((('weather={metar: "ESUT 112350Z AUTO //// 04/06"}',), "states no visibility"),
                        (('weather={metar: "ESUT 112350Z 11/2SM 04/06"}',), "that can be read (not known: 11/2SM)"),
                        (('weather={metar: "hello"}',), "weather report"),
                        (("lights=[{type: sun}]", "band_edges_nm=[400, 700]", 'site.time="2026-05-15T06:50:00Z"'),
                         "misses latitude_deg, must be here or in site (a METAR states none)"),
                        (('weather={metar: a, synop: b}',), "one of"),
                        (("weather={epw: nowhere.epw}",), "nowhere.epw")):
        sets = [w for word in words for w in ("--set", word)]
        text = run(folder, "check", "fog.yaml", "--set", "conditions={}", "--set", "placement={}", *sets, status=2).stderr
        check(part in text and text.count("\n") == 1, words, text)
    # light by a report of another time is warned of, air by one is not; day 31 may be of the month before
    sky = ("--set", "conditions={}", "--set", "placement={}", "--set", "lights=[{type: sky, irradiance_w_per_m2: 1}]", "--set", "regions=[]",
           "--set", "site.latitude_deg=51", "--set", "site.longitude_deg=-1")
    for time, metar, warns in (("2026-05-15T06:50:00Z", "EGHI 150650Z", False), ("2026-05-15T08:49:00+01:00", "EGHI 150650Z", False),
                               ("2026-05-15T07:51:00Z", "EGHI 150650Z", True), ("2026-05-16T06:50:00Z", "EGHI 150650Z", True),
                               ("2026-06-01T00:10:00Z", "EGHI 312350Z", False), ("2026-05-01T00:10:00Z", "EGHI 312350Z", True),
                               ("2026-12-31T23:50:00Z", "EGHI 010010Z", False)):
        text = run(folder, "check", "fog.yaml", *sky, "--set", f"site.time={time}", "--set", f'weather={{metar: "{metar} 9999 11/10"}}').stderr
        check(("not within an hour of the time of the scene" in text) == warns, time, metar, text)
    text = run(folder, "check", "fog.yaml", "--set", "site.time=2026-06-01T00:10:00Z").stderr
    check("an hour" not in text, text)
    plain = REPORTS.replace(REPORTS.split("\n")[3] + "\n", "").split("conditions:")[0]
    (folder / "plain.yaml").write_text(plain)
    check("has none" in run(folder, "check", "plain.yaml", status=2).stderr)


def hours(folder):
    shutil.copy("scenes/weather/june.epw", folder)
    (folder / "yard.yaml").write_text(YARD)
    (folder / "study.yaml").write_text(STUDY)
    sky = checked(folder, "yard.yaml")
    rows = (folder / "june.epw").read_text().splitlines()
    cells = rows[sky["weather"]["line"] - 1].split(",")
    check(cells[1:4] == ["6", "3", "11"] and sky["weather"]["direct_w_per_m2"] == float(cells[14]), cells, sky["weather"])
    text = " ".join(run(folder, "check", "yard.yaml").stdout.split())
    check("daylight: sun in" in text and " W/m2, sky in 145 patches" in text and " W/m2 in the bands" in text, text)
    run(folder, "study", "study.yaml", "-o", "parts", "--quiet")
    study = json.loads((folder / "parts/study.json").read_text())
    table = list(csv.DictReader(open(folder / "parts/table.csv")))
    check(len(table) == 12 and table[5]["site.time"] == "2025-06-03T10:30:00+01:00", table[5])
    # one row alone, with sun and sky as they are, has the same light but for shadows' edges
    compared = 0
    for row in table[3:10]:
        run(folder, "trace", "yard.yaml", "--quiet", "-o", "one", "--force", "--set", "lights=[{type: sun}, {type: sky}]",
            "--set", f"site.time={row['site.time']}")
        one = [t for t in csv.DictReader(open(folder / "one/tallies.csv")) if t["direction"] == "forward"][0]
        value, error = float(one["value"]) / 400, float(one["standard_error"]) / 400
        sigma = math.hypot(error, float(row["ground_forward_standard_error"]))
        # 2 % are the coarse shadow of a box; of 7 comparisons none lies beyond 5 sigma more
        check(abs(value - float(row["ground_forward"])) <= .02 * value + 5 * sigma, row["site.time"], value, row["ground_forward"], sigma)
        compared += value > 0
    check(compared == 7, compared)
    # a study goes on from its rows, and knows a file that has changed
    again = run(folder, "study", "study.yaml", "-o", "parts").stdout
    check("12 kept from before" in again, again)
    (folder / "june.epw").write_text("\n".join(rows).replace(",made_up,", ",changed,") + "\n")
    check("0 kept from before" in run(folder, "study", "study.yaml", "-o", "parts").stdout)
    # a day that the file lacks
    text = run(folder, "check", "yard.yaml", "--set", "site.time=2025-07-01T10:30:00+01:00", status=2).stderr
    check("has no row for 2025-07-01" in text, text)
    text = run(folder, "study", "study.yaml", "-o", "no", "--set", "photons.emit=10", "--set", "site.time=x", status=2).stderr
    check(text.count("\n") >= 1, text)


def level(folder):
    """Photons through a level plane in an empty domain: diffuse plus direct times the sine of the elevation."""
    (folder / "level.yaml").write_text(YARD.split("geometry:")[0].replace("[400, 700]", "[300, 4000]") + (
        "lights: [{type: sun}, {type: sky}]\nphotons: {emit: 400000, maps: none}\n"
        "tallies: [{name: level, type: plane, point_m: [10, 10, 5], normal: [0, 0, -1]}]\n"))
    compared = 0
    for hour in (6, 8, 10, 12, 15, 18):
        time = f"site.time=2025-06-02T{hour:02d}:30:00+01:00"
        sky = checked(folder, "level.yaml", "--set", time)
        weather, elevation_deg = sky["weather"], sky["lights"]["sky"][0]["elevation_deg"]
        want = weather["diffuse_w_per_m2"] + weather["direct_w_per_m2"] * math.sin(math.radians(elevation_deg))
        run(folder, "trace", "level.yaml", "--quiet", "-o", "level", "--force", "--set", time)
        tally = [t for t in csv.DictReader(open(folder / "level/tallies.csv")) if t["direction"] == "forward"][0]
        value, sigma = float(tally["value"]) / 400, float(tally["standard_error"]) / 400
        # 6 comparisons of 4 sigma: false alarm 4e-4; a factor of 1.03 fails
        check(abs(value - want) <= 4 * sigma, time, value, want, sigma)
        check(abs(value - 1.03 * want) > 4 * sigma, time, value, want, sigma)
        check(abs(want - weather["global_w_per_m2"]) <= .02 * want + 1, time, want, weather)
        compared += want > 50
    check(compared == 6, compared)


with tempfile.TemporaryDirectory() as name:
    reports(pathlib.Path(name))
    hours(pathlib.Path(name))
    level(pathlib.Path(name))
sys.exit(1 if failures else 0)
