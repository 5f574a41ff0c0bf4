#!/usr/bin/env python3
"""The report page in headless Chromium: nothing is said on the console, nothing
is asked for but the file, the view in space is not blank, its switches, keys,
lists, slider and picking work, as many photons are highlighted as the results
say, and without scripts the page has the summary, the tables of the CSV files and
the commands. Skipped where there is no Chromium.
usage: report_page.py MURK [PICTURE.png]
"""

import csv
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import browser  # noqa: E402

# Pixels of the view that are not its ground, and a checksum of them all.
LIT_PIXELS = """(() => {
  const gl = document.getElementById("view-canvas").getContext("webgl2");
  const w = gl.drawingBufferWidth, h = gl.drawingBufferHeight, p = new Uint8Array(4 * w * h);
  gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, p);
  let other = 0, sum = 0;
  for (let i = 0; i < p.length; i += 4) {
    other += Math.abs(p[i] - 16) + Math.abs(p[i + 1] - 20) + Math.abs(p[i + 2] - 27) > 12;
    sum = (31 * sum + p[i] + 7 * p[i + 1] + 13 * p[i + 2]) % 1000000007;
  }
  return [other / (w * h), sum];
})()"""
FLIP = """(() => { const box = document.querySelector('#view input[value="%s"]');
  box.click(); return box.checked; })()"""
SET = """(() => { const e = document.getElementById("%s"); e.value = "%s";
  e.dispatchEvent(new Event("%s")); })()"""
# The middle of a disc whose colour is such.
DISC = """(() => {
  const canvas = document.getElementById("view-canvas"), box = canvas.getBoundingClientRect();
  const gl = canvas.getContext("webgl2"), w = gl.drawingBufferWidth, h = gl.drawingBufferHeight;
  const p = new Uint8Array(4 * w * h);
  gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, p);
  const is = (x, y) => { const k = 4 * (y * w + x); return %s; };
  // well inside: its neighbours are alike. Upward, so that it is met before its label
  for (let y = 4; y < h - 4; ++y) for (let x = 4; x < w - 4; ++x) {
    if (is(x, y) && is(x - 3, y) && is(x + 3, y) && is(x, y + 3) && is(x, y - 3))
      return [box.left + x * box.width / w, box.top + (h - y) * box.height / h];
  }
  return null; })()"""
SAID = "document.getElementById('view-picked').textContent"
KEY = "document.getElementById('view-key').textContent"
IS_ON = "document.querySelector('#view input[value=\"%s\"]').checked"

# A clear room in two lights: what a sensor covers is its share of all photons.
ROOM = """\
murk: 1
bands_nm: [550]
domain: {min_m: [0, 0, 0], max_m: [6, 4, 3]}
geometry:
  - {box: {min_m: [0, 0, 0], max_m: [6, 4, 3]}}
  - {box: {min_m: [2.6, 0, 0], max_m: [3, 2.6, 3]}}
materials: {default: {diffuse: 0.5}}
lights: [{type: point, position_m: [1, 2, 2.5], power_w: 1}]
media: {fog: {extinction_per_m: 0.0, albedo: 0.9, phase: isotropic}}
regions: [{medium: fog, box: {min_m: [0, 0, 0], max_m: [6, 4, 1.5]}}]
photons: {emit: 3000}
sensors:
  types: [{name: "<b>node", range_m: 4}, {name: cam, range_m: 5, view: {hfov_deg: 60, vfov_deg: 40},
          headings: 4}]
  candidates: {grid: {min_m: [0.5, 0.5, 0.5], max_m: [5.5, 3.5, 2.5], size: [4, 3, 2]}}
  count: 3
placement: {method: greedy, weights: {surface: 1, volume: 1}, hold_out: false}
"""
READINGS = """\
kind,x_m,y_m,z_m,radius_m,unit,value,standard_error,use
fluence,1.2,1.2,2.2,0.3,W/m2,0.05,0.005,fit
fluence,4.5,1,1.5,0.3,W/m2,0.01,0.004,fit
fluence,1,3,1,0.3,W/m2,0.03,0.003,hold_out
"""
CONDITIONS = """\
conditions: {clear: {}, misty: {media.fog.extinction_per_m: 0.5}}
"""
failures = 0


def check(holds, *what):
    global failures
    if not holds:
        failures += 1
        print("not so:", *what)


def drawn(page):
    return page.value(LIT_PIXELS)[1]


def check_switches(page):
    share = page.value(LIT_PIXELS)[0]
    check(0.02 < share < 0.98, "of the view's pixels show something:", share)
    for part in ("surfaces", "surface-photons", "volume-photons", "sensors", "ranges", "lamps",
                 "axes", "cloud", "level"):
        before = drawn(page)
        page.value(FLIP % part)
        check(drawn(page) != before, "the switch changes nothing:", part)
        page.value(FLIP % part)
        check(drawn(page) == before, "the switch does not come back:", part)


def check_level(page):
    """The surface of one extinction: moving its slider shows it, and the
    larger the extinction, the less there is of it."""
    for part in ("surfaces", "surface-photons", "volume-photons", "sensors", "ranges", "lamps",
                 "axes", "cloud"):
        page.value(FLIP % part)
    check(page.value(LIT_PIXELS)[0] == 0, "switched off, something is left")
    shares, levels = [], []
    for value in (6, 30, 90):
        page.value(SET % ("view-level", value, "input"))
        shares.append(page.value(LIT_PIXELS)[0])
        levels.append(page.value("document.getElementById('view-level-said').textContent"))
    check(page.value(IS_ON % "level"), "the slider does not switch the surface on")
    check(shares[0] > shares[1] > shares[2] > 0, "of the pixels:", shares)
    check(all(" per m" in t for t in levels) and len(set(levels)) == 3, levels)
    before = drawn(page)
    page.value("document.getElementById('view-level').focus()")
    page.key("ArrowRight")
    check(drawn(page) != before, "the arrow key does not move the slider")
    page.value(FLIP % "level")
    for part in ("surfaces", "surface-photons", "volume-photons", "sensors", "ranges", "lamps",
                 "axes", "cloud"):
        page.value(FLIP % part)


def check_picking(page):
    page.value(SET % ("view-sensor", 1, "change"))
    check("Sensor 2 (" in page.value(SAID), page.value(SAID))
    # a click where a sensor is drawn: alone in view, its disc is all there is
    for part in ("surfaces", "surface-photons", "volume-photons", "ranges", "lamps", "axes",
                 "cloud"):
        page.value(FLIP % part)
    spot = page.value(DISC % "p[k] > 200 && p[k + 2] < 60")
    check(spot is not None, "no sensor is drawn")
    if spot:
        page.click(*spot)
        text = page.value(SAID)
        check("Sensor " in text and "Sensor 2 (" not in text, "picked:", text)
    page.click(*page.value("(() => { const b = document.getElementById('view-canvas')"
                           ".getBoundingClientRect(); return [b.left + 3, b.top + 3]; })()"))
    check(page.value(SAID).startswith("Pick a sensor"), "picked nothing, but", page.value(SAID))
    for part in ("surfaces", "surface-photons", "volume-photons", "ranges", "lamps", "axes",
                 "cloud"):
        page.value(FLIP % part)


def check_keys(page):
    page.value("document.getElementById('view-canvas').focus()")
    before = drawn(page)
    page.key("ArrowLeft")
    check(drawn(page) != before, "the arrow key turns nothing")
    page.key("+")
    page.key("n")
    check(page.value(SAID).startswith("Sensor 1 ("), "N picks", page.value(SAID))
    page.key("p")
    page.key("p")
    check(page.value(SAID).startswith("Sensor 3 ("), "P picks", page.value(SAID))
    page.key("Escape")
    check(page.value(SAID).startswith("Pick a sensor"), "Escape leaves", page.value(SAID))
    for button in ("above", "side", "nearer", "farther", "corner"):
        before = drawn(page)
        page.value(f"document.querySelector('#view button[value=\"{button}\"]').click()")
        check(drawn(page) != before, "the button turns nothing:", button)


def check_view(page, path, picture):
    page.open(path)
    page.value("document.getElementById('view').scrollIntoView()")
    check(page.value("document.getElementById('view').dataset.state") == "drawn", "not drawn")
    check_switches(page)
    check_level(page)
    check_picking(page)
    check_keys(page)
    check(page.said == [], "said:", page.said)
    check(page.asked == ["file://" + path], "asked for:", page.asked)
    if picture:
        page.value("document.getElementById('where').scrollIntoView()")
        page.picture(picture)


def number(pattern, text):
    found = re.search(pattern, text)
    check(found, pattern, "in", text)
    return int(found.group(1).replace(",", "")) if found else -1


def check_sights(page, folder):
    """What is highlighted of a picked sensor is what the results say it covers."""
    page.open(os.path.join(folder, "report.html"))
    with open(os.path.join(folder, "plan.json"), encoding="utf-8") as file:
        plan = json.load(file)
    photons = plan["photons"]["surface"] + plan["photons"]["volume"]
    check(plan["photons"]["volume"] == 0 and photons > 1000, plan["photons"])
    check("<b>node" in [sensor["type"] for sensor in plan["sensors"]], "no name with a tag in it")
    before = drawn(page)
    for k, sensor in enumerate(plan["sensors"]):
        page.value(SET % ("view-sensor", k, "change"))
        text = page.value(SAID)
        seen, alone = number(r"it sees ([\d,]+)", text), number(r"([\d,]+) of them alone", text)
        check(abs(seen / photons - sensor["covers"]) < 0.5 / photons, text, sensor["covers"])
        check(abs(alone / photons - sensor["only_it_covers"]) < 0.5 / photons, text, sensor)
        check(f"Sensor {k + 1} ({sensor['type']}) at " in text, text, sensor["type"])
        check(number(r"alone sees: ([\d,]+)", page.value(KEY)) == alone, page.value(KEY))
        check(drawn(page) != before, "picking changes no pixel")
        before = drawn(page)
    page.value(SET % ("view-sensor", -1, "change"))
    none = number(r"no sensor sees: ([\d,]+)", page.value(KEY))
    check(abs(1 - none / photons - plan["coverage"]["in_sample"]) < 0.5 / photons, none)


def check_conditions(page, folder):
    """Each condition has its own photons and media."""
    page.open(os.path.join(folder, "report.html"))
    names = page.value("[...document.querySelectorAll('#view-state option')].map((o) => o.textContent)")
    check(names == ["clear", "misty"], names)
    with open(os.path.join(folder, "plan.json"), encoding="utf-8") as file:
        conditions = json.load(file)["conditions"]
    pictures = set()
    for k, condition in enumerate(conditions):
        page.value(SET % ("view-state", k, "change"))
        counts = re.findall(r": ([\d,]+) \(", page.value(KEY))
        total = sum(int(c.replace(",", "")) for c in counts)
        want = condition["photons"]["surface"] + condition["photons"]["volume"]
        check(total == want, condition["name"], "has", want, "shown:", total)
        pictures.add(drawn(page))
    check(len(pictures) == 2, "the conditions look the same")
    check(page.said == [], "said:", page.said)


def check_readings(page, folder):
    """A fit's readings, by their residuals; a click tells one's numbers."""
    page.open(os.path.join(folder, "report.html"))
    page.value("document.getElementById('view-canvas').scrollIntoView()")
    for part in ("surfaces", "lamps", "axes"):
        page.value(FLIP % part)
    spot = page.value(DISC % "p[k] + p[k + 1] + p[k + 2] > 300")
    check(spot is not None, "no reading is drawn")
    if spot:
        page.click(*spot)
    text = page.value(SAID)
    with open(os.path.join(folder, "fit.csv"), encoding="utf-8") as file:
        rows = {int(row["line"]): row for row in csv.DictReader(file)}
    row = rows.get(number(r"Reading of line (\d+) ", text), {})
    off = float(row.get("residual_in_standard_errors", "nan"))
    check(f"measured {float(row.get('value', 'nan')):.5g} " in text, text)
    check(f"{abs(off):.5g} standard errors {'above' if off > 0 else 'below'}" in text, text, off)
    check(page.said == [], "said:", page.said)


def check_lost(page, folder):
    """Without WebGL, and when it is taken away, the page says so."""
    page.open(os.path.join(folder, "report.html"))
    page.value("""document.getElementById("view-canvas").getContext("webgl2")
      .getExtension("WEBGL_lose_context").loseContext()""")
    page.value("new Promise((done) => setTimeout(done, 200))")
    check("graphics were lost" in page.value(SAID), page.value(SAID))
    page.call("Page.addScriptToEvaluateOnNewDocument",
              source="HTMLCanvasElement.prototype.getContext = () => null;")
    page.open(os.path.join(folder, "report.html"))
    check("no WebGL" in page.value(SAID), page.value(SAID))
    check(page.value("document.getElementById('view-canvas').hidden"), "an empty view")


def check_policy(page, folder):
    """What a script that is not the page's own would meet. The image is there."""
    shutil.copy("doc/report.png", os.path.join(folder, "other.png"))
    ran = page.value("""(() => { const s = document.createElement("script");
      s.textContent = "window.intruder = 1"; document.body.append(s);
      return window.intruder === 1; })()""")
    check(not ran, "another script runs")
    loaded = page.value("""new Promise((done) => { const i = new Image();
      i.onload = () => done(true); i.onerror = () => done(false); i.src = "other.png"; })""")
    check(not loaded, "an image is loaded")


def check_plain(page, path):
    page.open(path)
    tree = str(page.call("Accessibility.getFullAXTree"))
    for text in ("In short", "all candidates: 0.", " of this sample of photons; guarantee: ", "sensors.csv", "heading_deg", "coverage.csv",
                 "How it was made", "murk place", "Files of the folder"):
        check(text in tree, "without scripts it lacks:", text)
    check("from a corner" not in tree, "switches without scripts")
    check(page.said == [], "said:", page.said)


def main(murk, picture):
    if not browser.program():
        print("skipped: no chromium")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        folder = os.path.realpath(folder)
        hall, room, over, fit = (os.path.join(folder, name)
                                 for name in ("hall", "room", "over", "fit"))
        for name, text in (("room.yaml", ROOM), ("over.yaml", ROOM + CONDITIONS),
                           ("data.csv", READINGS)):
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        for command in (["place", os.path.abspath("scenes/smoke-hall.yaml"), "-o", hall, "--emit",
                         "8000", "--count", "3", "--set", "placement.method=greedy"],
                        ["place", os.path.join(folder, "room.yaml"), "-o", room],
                        ["place", os.path.join(folder, "over.yaml"), "-o", over,
                         "--set", "placement.over=mean"],
                        ["fit", os.path.join(folder, "room.yaml"), "-o", fit, "--free",
                         "lights.0.power_w", "--data", os.path.join(folder, "data.csv"),
                         "--traces", "1"],
                        *(["report", made] for made in (hall, room, over, fit))):
            subprocess.run([murk, *command, "--quiet"], check=True)
        path = os.path.join(hall, "report.html")
        page = browser.Browser(*((1200, 900) if picture else (640, 480)))
        try:
            check_view(page, path, picture)
            check_sights(page, room)
            check_conditions(page, over)
            check_readings(page, fit)
            check_policy(page, fit)
            check_lost(page, room)
        finally:
            page.end()
        page = browser.Browser(without_scripts=True)
        try:
            check_plain(page, path)
        finally:
            page.end()
    print("failures:", failures)
    return failures != 0


if __name__ == "__main__":
    sys.exit(main(os.path.abspath(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else ""))
