"""murk check --picture: plan and sections of a scene, pixel by pixel at known places.

usage: section.py MURK

A room with a crate, a pillar, a pane, fog in a corner, a lamp, candidates and a fixed sensor.
"""
import json
import os
import subprocess
import sys
import tempfile

from exchange import Failed, check
from pictures import read_png



def scene(x=0):
    """The room, with its corner at x."""
    return json.dumps({
        "murk": 1,
        "domain": {"min_m": [x - .5, -.5, -.5], "max_m": [x + 8.5, 6.5, 3.5]},
        "geometry": [{"box": {"min_m": [x, 0, 0], "max_m": [x + 8, 6, 3]}},
                     {"box": {"min_m": [x + 1, 1, 0], "max_m": [x + 2, 2, 1]}},
                     {"box": {"min_m": [x + 5, 4, 0], "max_m": [x + 6, 5, 2]}},
                     {"rect": {"corner_m": [x + 4.4, 0, 0], "edge1_m": [0, 2, 0], "edge2_m": [0, 0, 2]},
                      "material": "pane"},
                     {"sphere": {"center_m": [x + 3, 4.5, 1.5], "radius_m": .5}}],
        "materials": {"default": {"diffuse": .5}, "pane": {"transmit": .9}},
        "media": {"fog": {"extinction_per_m": .2, "albedo": .9}},
        "regions": [{"medium": "fog", "box": {"min_m": [x + 6, 0, 0], "max_m": [x + 8, 2, 2]}}],
        "lights": [{"type": "point", "position_m": [x + 2.2, 3.3, 2.5], "power_w": 10}],
        "photons": {"emit": 300},
        "sensors": {"types": [{"name": "node", "range_m": 4}], "count": 1,
                    "candidates": {"grid": {"min_m": [x + .5, .5, 1.2], "max_m": [x + 7.5, 5.5, 2.2], "size": [5, 3, 2]}},
                    "fixed": [{"type": "node", "position_m": [x + 7, 3.7, 2]}]}})


murk = os.path.abspath(sys.argv[1])
folder = tempfile.TemporaryDirectory(prefix="murk-section-")


def path(name):
    return os.path.join(folder.name, name)


def run(*line):
    return subprocess.run([murk, "check", *line], cwd=folder.name, capture_output=True, text=True, timeout=120, check=False)


class Picture:
    """What --picture draws of a scene, and where."""

    def __init__(self, text, *options, name="a.png"):
        with open(path("scene.json"), "w", encoding="utf-8") as file:
            file.write(text)
        done = run("scene.json", "--format", "json", "--picture", name, *options)
        check(done.returncode == 0, options, "ended with", done.returncode, done.stderr)
        self.said = json.loads(done.stdout)["picture"]
        self.width, self.height, self.rows, self.texts = read_png(path(name))
        self.view = {one["section"]: one for one in self.said["sections"]}

    def place(self, view, right, up):
        v = self.view[view]
        return (v["left"] + (right - v["low_m"][0]) * v["pixels_per_m"],
                v["top"] + v["height"] - (up - v["low_m"][1]) * v["pixels_per_m"])

    def at(self, view, right, up):
        x, y = self.place(view, right, up)
        return self.rows[int(y)][int(x)]

    def darkest(self, view, right, up):
        """The darkest pixel within one of the place."""
        x, y = self.place(view, right, up)
        return min((self.rows[int(y) + j][int(x) + i] for i in (-1, 0, 1) for j in (-1, 0, 1)), key=sum)

    def is_wall(self, view, right, up):
        return max(self.darkest(view, right, up)) < 90

    def is_grey(self, view, right, up):
        pixel = self.at(view, right, up)
        return max(pixel) - min(pixel) < 3 and 190 < pixel[0] < 254


def room(p, x):
    """The places of a room whose corner is at x."""
    check(p.said["cut_m"] == [x + 4, 3, 1.5], "cuts at", p.said["cut_m"])
    # the plan at 1.5 m: walls, the pillar and the ball are cut, the crate of 1 m is seen from above
    for right, up in ((0, 2.7), (8, 3.3), (3.3, 0), (5.3, 6), (5, 4.3), (6, 4.6), (5.4, 5), (3.5, 4.5), (3, 4)):
        check(p.is_wall("plan", x + right, up), "no wall of the plan at", right, up)
    for right, up in ((1.5, 1.2), (3, 3.2), (.7, 4)):
        check(p.is_grey("plan", x + right, up), "no surface beyond the plan at", right, up, p.at("plan", x + right, up))
    check(p.at("plan", x + 1.5, 1.2)[0] > p.at("plan", x + 3, 3.2)[0], "the floor is as near as the crate")
    check(p.at("plan", x - .3, 3.2) == (255, 255, 255), "something is outside of the room")
    pane = p.darkest("plan", x + 4.4, 1.1)
    check(pane[2] > 150 and pane[0] < 90, "the pane is", pane)
    fog = p.at("plan", x + 6.8, 1.2)
    check(fog[2] > fog[0] + 10, "the fog is", fog)
    lamp = p.at("plan", x + 2.2, 3.3)
    check(lamp[0] > 240 and lamp[2] < 30, "the lamp is", lamp)
    sensor = p.at("plan", x + 7, 3.7)
    check(sensor[0] > 180 and sensor[1] < 70, "the fixed sensor is", sensor)
    site = p.at("plan", x + .5, 5.5)
    check(site[0] < 110 and site[1] > site[0] + 30, "the candidate is", site)
    # the front section at y = 3: floor, ceiling and side walls; beyond it the pillar, not the crate before it
    for right, up in ((0, 1), (8, .7), (2.3, 0), (2.3, 3)):
        check(p.is_wall("front", x + right, up), "no wall of the front section at", right, up)
    check(p.is_grey("front", x + 5.5, .8), "no pillar beyond the front section")
    check(p.at("front", x + 5.5, .8)[0] > p.at("front", x + 1.5, .8)[0], "the wall is as near as the pillar")
    check(p.at("front", x + 1.5, .8) == p.at("front", x + .7, .8), "the crate is seen from behind")
    # the side section at x = 4 looks to smaller x
    for right, up in ((0, 2.5), (6, .7), (2.5, 0), (2.5, 3)):
        check(p.is_wall("side", right, up), "no wall of the side section at", right, up)
    check(p.is_grey("side", 4.5, 1.7) and p.at("side", 4.5, 1.7)[0] > p.at("side", 5.6, 1.7)[0], "no ball beyond")


def views():
    p = Picture(scene())
    room(p, 0)
    v = p.view
    check(v["plan"]["left"] == v["front"]["left"] and v["plan"]["low_m"][0] == v["front"]["low_m"][0], "x is not shared")
    check(v["front"]["top"] == v["side"]["top"] and v["front"]["low_m"][1] == v["side"]["low_m"][1], "z is not shared")
    check(len({one["pixels_per_m"] for one in v.values()}) == 1, "the scales differ")
    for one in v.values():
        check(one["left"] > 40 and one["left"] + one["width"] < p.width - 20, "a view is cropped", one)
        check(one["top"] > 40 and one["top"] + one["height"] < p.height - 20, "a view is cropped", one)
    check(p.width == 1600, "the sheet is wide", p.width)
    margin = [pixel for row in p.rows[:8] + p.rows[-3:] for pixel in row] + [row[i] for row in p.rows for i in (0, -1)]
    check(set(margin) == {(255, 255, 255)}, "something is cropped at the margin")
    legend = [row[x] for row in p.rows[60:v["side"]["top"] - 60] for x in range(v["side"]["left"], p.width)]
    check(sum(max(pixel) < 90 for pixel in legend) > 2000, "the legend is empty")
    check(p.texts["murkScene"] == "scene.json" and "--picture" not in p.texts["murkCommand"], p.texts)


def options():
    p = Picture(scene(), "--cut", "5.5,1.5,.5", "--pixels", "1000x900", name="b.png")
    check((p.width, p.height) == (1000, 900), "the sheet is", p.width, p.height)
    check(p.said["cut_m"] == [5.5, 1.5, .5], "cuts at", p.said["cut_m"])
    check(p.is_wall("plan", 1, 1.4) and p.is_wall("front", 1, .4) and p.is_wall("side", 4, .4), "the crate is not cut")
    # far from 0 the picture has the same places
    small = ("--pixels", "900x700")
    room(Picture(scene(500000), *small, name="c.png"), 500000)
    with open(path("c.png"), "rb") as file:
        before = file.read()
    Picture(scene(500000), *small, "--threads", "3", name="c.png")
    with open(path("c.png"), "rb") as file:
        check(file.read() == before, "another number of threads gives another picture")
    # nothing but a light; a domain much larger than what is in it
    Picture(json.dumps({"murk": 1, "domain": {"min_m": [0, 0, 0], "max_m": [3, 2, 2]},
                        "lights": [{"type": "point", "position_m": [1, 1, 1], "power_w": 1}]}), *small, name="d.png")
    text = json.loads(scene())
    text["domain"] = {"min_m": [-20000, -20000, -1], "max_m": [20000, 20000, 9000]}
    p = Picture(json.dumps(text), *small, name="e.png")
    check(p.view["plan"]["pixels_per_m"] > 25, "things are specks", p.view["plan"])
    check(p.is_wall("plan", 0, 2.7), "no wall in a large domain")
    # a region of interest: a dashed line through (3, 2.9), which is bare without the region
    def purple(p):
        x, y = p.place("plan", 3, 2.9)
        return any(pixel[1] + 40 < min(pixel[0], pixel[2]) for row in p.rows[int(y) - 30:int(y) + 30]
                   for pixel in row[int(x) - 2:int(x) + 3])
    text = json.loads(scene())
    check(not purple(Picture(json.dumps(text), "--cut", "4,1,1.5", name="g.png")), "a line of interest that is not there")
    text["placement"] = {"interest": [{"name": "part", "box": {"min_m": [3, 2, 1], "max_m": [4.2, 3.8, 2]}}]}
    check(purple(Picture(json.dumps(text), "--cut", "4,1,1.5", name="h.png")), "the region of interest is not drawn")


def refusals():
    Picture(scene(), "--pixels", "640x480")
    with open(path("mine.png"), "w", encoding="utf-8") as file:
        file.write("my own")
    os.link(path("scene.json"), path("linked.png"))
    for line, words in (
            (("--picture", "mine.png"), "not written by murk"),
            (("--picture", "linked.png"), "is read by this run"),
            (("--picture", "linked.png", "--force"), "is read by this run"),
            (("--picture", "a.svg"), "must be the name of a file that ends in .png"),
            (("--picture", "f.png", "--cut", "1,2"), "must be X,Y,Z"),
            (("--picture", "f.png", "--cut", "1,2,3,4"), "must be X,Y,Z"),
            (("--picture", "f.png", "--cut", "1,2,nan"), "must be X,Y,Z"),
            (("--picture", "f.png", "--cut", "1,2,77"), "z is 77 m, must be within the domain"),
            (("--picture", "f.png", "--pixels", "100x100"), "must be 640x480 or more"),
            (("--cut", "1,2,1"), "goes with --picture only")):
        done = run("scene.json", *line)
        check(done.returncode == 2 and words in done.stderr and done.stderr.count("\n") == 1, line, done.returncode, done.stderr)
        check(not os.path.exists(path("f.png")), line, "wrote a picture")
    done = run("scene.json", "--picture", "none/f.png")
    check((done.returncode, done.stderr) == (1, "murk: none/f.png: cannot write: No such file or directory\n"),
          "a folder that is not there", done.returncode, done.stderr)
    with open(path("mine.png"), encoding="utf-8") as file:
        check(file.read() == "my own", "a file of the user's was changed")
    check(run("scene.json", "--picture", "mine.png", "--force", "-q").returncode == 0, "--force")
    # candidates that are all unusable are refused, and the picture that shows why is there
    done = run("scene.json", "--picture", "why.png", "--set", "sensors.candidates.clearance_m=3")
    check(done.returncode == 2 and "is usable" in done.stderr, "candidates of no use", done.returncode, done.stderr)
    check(read_png(path("why.png"))[0] == 1600, "no picture of candidates that are not usable")
    check(run("scene.json", "--picture", "a.png", "-q").returncode == 0, "murk's own picture")


try:
    views()
    options()
    refusals()
except Failed as failed:
    print(failed)
    sys.exit(1)
