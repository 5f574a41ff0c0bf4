#!/usr/bin/env python3
"""Plots of the report page as Chromium draws them: where ticks stand and what they say, gaps, whiskers, bars as long
as their values, fields of which each cell is drawn once. The results are made by hand. Skipped where there is no
Chromium.
usage: report_charts.py MURK
"""

import json
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import browser  # noqa: E402
import pages  # noqa: E402
from pages import Plot, check  # noqa: E402

VERSION = {"murk": {"version": ".".join(map(str, pages.VERSION))}}
TICKS = (  # the ends of an axis, and its ticks
    ("0", "1", "0.0 0.2 0.4 0.6 0.8 1.0"),
    ("-3", "3", "-3 -2 -1 0 1 2 3"),
    ("0.00012", "0.00031", "0.00015 0.00020 0.00025 0.00030"),
    ("0", "4e20", "0 10²⁰ 2·10²⁰ 3·10²⁰ 4·10²⁰"),
    ("00:00", "23:00", "00:00 03:00 06:00 09:00 12:00 15:00 18:00 21:00"),
    ("08:30", "10:00", "08:30 08:45 09:00 09:15 09:30 09:45 10:00"),
    ("30", "10000", "50 100 200 500 1000 2000 5000 10000"),
    ("1", "1e6", "1 10 100 1000 10000 10⁵ 10⁶"),
    ("110", "190", "120 140 160 180"),
)
GRID = """\
murk: 1
domain: {min_m: [0, 0, 0], max_m: [9, 9, 9]}
lights: [{type: point, position_m: [4.5, 4.5, 4.5], power_w: 1}]
photons: {emit: 150}
tallies: [{name: glow, type: grid, min_m: [0, 0, 0], max_m: [9, 9, 9], size: [9, 9, 9]}]
"""


class Folder:
    """A result folder that is written by hand, and its page."""

    def __init__(self, murk, top):
        self.murk, self.path = murk, os.path.join(top, "out")
        os.makedirs(self.path, exist_ok=True)

    def page(self, **files):
        for name in os.listdir(self.path):
            os.unlink(os.path.join(self.path, name))
        for name, content in files.items():
            name = re.sub("_(json|csv)$", r".\1", name)
            with open(os.path.join(self.path, name), "w", encoding="utf-8") as file:
                file.write(content if isinstance(content, str) else json.dumps({**VERSION, **content}))
        subprocess.run([self.murk, "report", self.path, "-q"], check=True)
        return pages.drawn(os.path.join(self.path, "report.html"))

    def study(self, rows, axis="a", output="y"):
        """Rows of the axis, the value and its error."""
        return self.page(study_json={"axes": [{"key": axis}], "rows": []}, table_csv="\n".join(
            [f"{axis},{output},{output}_standard_error"] + [",".join(row) for row in rows]) + "\n")

    def tally(self, size, value):
        """Of bins i, j, k: value(i, j, k)."""
        rows = [f"top,550,{i},{j},{k},,{value(i, j, k)},0,W" for k in range(size[2])
                for j in range(size[1]) for i in range(size[0])]
        return self.page(ledger_json={}, tallies_csv="\n".join(
            ["tally,band_nm,bin_i,bin_j,bin_k,direction,value,standard_error,unit"] + rows) + "\n")


def count(text, part):
    return len(re.findall(part, text))


def svg(text, title):
    return next((s for s in re.findall(r"<svg.*?</svg>", text, re.S) if f'aria-label="{title}' in s), "")


def cells_drawn(text):
    """Cells of all runs of a field: "M0 0.5h3"."""
    return sum(int(n) for n in re.findall(r"\.5h(\d+)", re.search(r"<g transform.*?</g>", text, re.S).group()))


def check_ticks(folder):
    for low, high, want in TICKS:
        plot = Plot(folder.study([(low, "1", "0.1"), (high, "2", "0.1")]), "y, with 95 % intervals")
        got = " ".join(text for _, text in plot.x)
        check(got == want, low, "to", high, "has ticks", got, "not", want)
    curve = [{"count": n, "coverage": n / 4, "upper": n / 4} for n in (1, 2, 3)]
    plot = Plot(folder.page(plan_json={"sensors": [], "curve": curve}), "Coverage by number")
    check([text for _, text in plot.x] == ["1", "2", "3"], "counts:", plot.x)
    check([text for _, text in plot.y] == ["0 %", "20 %", "40 %", "60 %"], "shares:", plot.y)


def check_lines(folder):
    """A gap breaks a line and its band."""
    text = folder.study([(str(x), y, str(1 / 1.96)) for x, y in enumerate(("1", "2", "", "4", "inf", "3"))], output="<a>")
    plot = svg(text, "&lt;a&gt;, with 95 % intervals")
    for part, want in (("line s0", 3), ("band s0", 3), ("point s0", 4)):
        check(count(plot, f'<path class="{part}"') == want, part, plot)
    check("whisker" not in plot, "whiskers of a line")
    check("&lt;a&gt;: 4 points, from 1 to 4" in plot, plot[:300])
    check("<title>&lt;a&gt;: 0, 1 (0 to 2)</title>" in plot, "no words of a point")
    # nothing is drawn of nothing, and a negative value has no place on an axis of powers of ten
    check(svg(folder.study([("1", "", ""), ("2", "nan", "")]), "y") == "", "a plot of nothing")


def check_whiskers(folder):
    """Points have whiskers where there is a range; names stand below."""
    conditions = [{"name": "fog", "in_sample": .6}]
    text = folder.page(plan_json={"sensors": [], "conditions": conditions, "coverage": {
        "in_sample": .5, "in_sample_standard_error": .1 / 1.96, "held_out": .4}})
    plot = svg(text, "In sample against held out")
    check(count(plot, "whisker") == 1 and count(plot, "<title>") == 3, plot)
    check(">fog</text>" in plot, "no name of the condition")
    check("<title>in sample: the plan, 50 % (40 % to 60 %)</title>" in plot, plot)


def check_bars(folder):
    sensors = [{"type": "one", "covers": .3, "only_it_covers": .2}, {"type": "two & more", "covers": .4, "only_it_covers": .4}]
    losses = [{"sensor": 1, "in_sample": .6}, {"sensor": 2, "in_sample": .3}, {"sensor": 3}]
    text = folder.page(plan_json={"sensors": sensors, "coverage": {"in_sample": .5},
                                  "robustness": {"drop_one": {"without": losses}}})
    plot = svg(text, "What each sensor covers")
    widths = [float(w) for w in re.findall(r'<rect class="bar[^>]* width="([\d.]+)"', plot)]
    check(len(widths) == 5, "three parts and the legend's two, not", widths)
    check(abs(widths[2] / widths[0] - 2) < 0.01, "the second is twice as long:", widths)
    check("two &amp; more" in plot and "30.00 %" in plot and "40.00 %" in plot, plot)
    plot = svg(text, "Coverage lost where one sensor fails")  # of either sign, and none
    check(count(plot, '<rect class="bar') == 2 and 'width="-' not in plot, plot)
    check("-10.00 %" in plot and "20.00 %" in plot and "–" in plot, plot)
    none = folder.page(plan_json={"sensors": [{}], "robustness": {"drop_one": {"without": [{}, {}]}}})
    check(svg(none, "Coverage lost") == "", "bars of nothing")


def check_fields(folder, murk, top):
    value = lambda i, j, k: (12 * j + i) ** 2 % 31 + 1
    check(cells_drawn(svg(folder.tally((12, 7, 1), value), "Tally top")) == 84, "cells")
    text = folder.tally((12, 7, 1), lambda i, j, k: "nan" if (i, j) == (5, 0) else value(i, j, k))
    check(cells_drawn(svg(text, "Tally top")) == 83, "cells, one not known")
    check(count(text, "1 of them blank: nothing there") == 2, "the blank cell is not told")
    # the middle of the largest cell, and lowest and highest colour
    text = folder.tally((3, 2, 1), lambda i, j, k: (0, 1, 2, 9, 4, 5)[3 * j + i])
    check(count(text, "from 0 to 9 W a bin, which is at 0, 1.") == 2, "where its largest value is")
    check('stroke="#440154" d="M0 0.5h1"' in text and 'stroke="#fde725" d="M0 1.5h1"' in text, "colours")
    # a row of cells is drawn low, a column of them as high as any field
    text = folder.tally((3, 1, 2), lambda i, j, k: i)
    check(cells_drawn(svg(text, "Tally top")) == 3 and "scale(143.33 -40)" in text, "a row")
    text = folder.tally((1, 3, 2), lambda i, j, k: j)
    check(cells_drawn(svg(text, "Tally top")) == 3 and "scale(430 -107.5)" in text, "a column")
    # by powers of ten, where cells without light have no colour
    with open(os.path.join(top, "grid.yaml"), "w", encoding="utf-8") as file:
        file.write(GRID)
    subprocess.run([murk, "trace", "grid.yaml", "-o", "glow", "-q"], cwd=top, check=True)
    subprocess.run([murk, "report", "glow", "-q"], cwd=top, check=True)
    plot = svg(pages.drawn(os.path.join(top, "glow", "report.html")), "Fluence rate glow at z")
    blank = re.search(r"81|9 x 9 cells, (\d+) of them blank", plot)
    check(blank and cells_drawn(plot) == 81 - int(blank.group(1)) < 81, "of powers of ten:", cells_drawn(plot))


def main(murk):
    if not browser.program():
        print("skipped: no chromium")
        return 77
    with tempfile.TemporaryDirectory() as top:
        folder = Folder(murk, top)
        check_ticks(folder)
        check_lines(folder)
        check_whiskers(folder)
        check_bars(folder)
        check_fields(folder, murk, top)
    print("failures:", len(pages.failed))
    return len(pages.failed) > 0


if __name__ == "__main__":
    sys.exit(main(os.path.abspath(sys.argv[1])))
