#!/usr/bin/env python3
"""The report page in headless Chromium: nothing is said on the console, nothing
is asked for but the file, the view in space is not blank, its switches, keys,
list and picking work, and without scripts the page is all there but the view.
Skipped where there is no Chromium.
usage: report_page.py MURK [PICTURE.png]
"""

import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import browser  # noqa: E402

# Pixels of the view that are not its ground, and a checksum of them all.
LOOK = """(() => {
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
failures = 0


def check(holds, *what):
    global failures
    if not holds:
        failures += 1
        print("not so:", *what)


def check_view(page, path, picture):
    page.open(path)
    page.value("document.getElementById('view').scrollIntoView()")
    check(page.value("document.getElementById('view').dataset.state") == "drawn", "not drawn")
    share, first = page.value(LOOK)
    check(0.02 < share < 0.98, "of the view's pixels show something:", share)
    for part in ("surfaces", "surface-photons", "volume-photons", "sensors", "ranges", "media"):
        before = page.value(LOOK)[1]
        page.value(FLIP % part)
        check(page.value(LOOK)[1] != before, "the switch changes nothing:", part)
        page.value(FLIP % part)
        check(page.value(LOOK)[1] == before, "the switch does not come back:", part)
    # the list
    said = "document.getElementById('view-picked').textContent"
    page.value("(() => { const list = document.getElementById('view-sensor');"
               "list.value = '1'; list.dispatchEvent(new Event('change')); })()")
    check("Sensor 2 (" in page.value(said), page.value(said))
    # a click where sensor 1 is drawn: alone in view, its disc is all there is
    for part in ("surfaces", "surface-photons", "volume-photons", "ranges", "media"):
        if page.value(f"document.querySelector('#view input[value=\"{part}\"]').checked"):
            page.value(FLIP % part)
    spot = page.value("""(() => {
      const canvas = document.getElementById("view-canvas"), box = canvas.getBoundingClientRect();
      const gl = canvas.getContext("webgl2"), w = gl.drawingBufferWidth, h = gl.drawingBufferHeight;
      const p = new Uint8Array(4 * w * h);
      gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, p);
      // well inside a disc: its neighbours are as bright
      for (let y = 4; y < h - 4; ++y) for (let x = 4; x < w - 4; ++x) {
        const bright = (a, b) => p[4 * (b * w + a)] > 200 && p[4 * (b * w + a) + 2] < 60;
        if (bright(x, y) && bright(x - 3, y) && bright(x + 3, y) && bright(x, y + 3) && bright(x, y - 3))
          return [box.left + x * box.width / w, box.top + (h - y) * box.height / h];
      }
      return null; })()""")
    check(spot is not None, "no sensor is drawn")
    if spot:
        page.click(*spot)
        text = page.value(said)
        check("Sensor " in text and "Sensor 2 (" not in text, "picked:", text)
    page.click(*page.value("(() => { const b = document.getElementById('view-canvas')"
                           ".getBoundingClientRect(); return [b.left + 3, b.top + 3]; })()"))
    check(page.value(said).startswith("Pick a sensor"), "picked nothing, but", page.value(said))
    # keys and buttons turn it
    page.value("document.getElementById('view-canvas').focus()")
    before = page.value(LOOK)[1]
    page.key("ArrowLeft")
    check(page.value(LOOK)[1] != before, "the arrow key turns nothing")
    page.value("document.querySelector('#view button[value=\"above\"]').click()")
    check(page.value(LOOK)[1] != before, "the button turns nothing")
    page.value("document.querySelector('#view button[value=\"corner\"]').click()")
    for part in ("surfaces", "surface-photons", "volume-photons", "ranges", "media"):
        page.value(FLIP % part)
    check(page.said == [], "said:", page.said)
    check(page.asked == ["file://" + path], "asked for:", page.asked)
    if picture:
        page.value("document.getElementById('where').scrollIntoView()")
        page.picture(picture)


def check_policy(page):
    """What a script that is not the page's own would meet."""
    ran = page.value("""(() => { const s = document.createElement("script");
      s.textContent = "window.intruder = 1"; document.body.append(s);
      return window.intruder === 1; })()""")
    check(not ran, "another script runs")
    loaded = page.value("""new Promise((done) => { const i = new Image();
      i.onload = () => done(true); i.onerror = () => done(false); i.src = "other.png"; })""")
    check(not loaded, "an image is loaded")


def main(murk, picture):
    if not browser.program():
        print("skipped: no chromium")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        folder = os.path.realpath(folder)
        scene = os.path.abspath("scenes/smoke-hall.yaml")
        for command in (["place", scene, "-o", folder, "--emit", "8000", "--count", "3", "--quiet",
                         "--set", "placement.method=greedy"], ["report", folder, "--quiet"]):
            subprocess.run([murk, *command], check=True)
        path = os.path.join(folder, "report.html")
        page = browser.Browser()
        try:
            check_view(page, path, picture)
            check_policy(page)
        finally:
            page.end()
        page = browser.Browser(without_scripts=True)
        try:
            page.open(path)
            tree = str(page.call("Accessibility.getFullAXTree"))
            for text in ("The placement", "Coverage curve", "The sensors", "From above",
                         "murk place"):
                check(text in tree, "without scripts it lacks:", text)
            check("from a corner" not in tree, "switches without scripts")
            check(page.said == [], "said:", page.said)
        finally:
            page.end()
    print("failures:", failures)
    return failures != 0


if __name__ == "__main__":
    sys.exit(main(os.path.abspath(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else ""))
