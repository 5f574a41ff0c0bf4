#!/usr/bin/env python3
"""What a coverage is of, from outside: the weights of both maps, a map whose
share rests on few photons, targets that are called targets, and one photon,
whose error is not known. Standard library only.
usage: weights.py MURK
"""

import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import browser  # noqa: E402
import from_outside  # noqa: E402
import pages  # noqa: E402
from from_outside import check, near  # noqa: E402

# A room and a faint plume in it: some ten of 40,000 records lie in the plume.
PLUME = """\
murk: 1
domain: {min_m: [0, 0, 0], max_m: [10, 10, 4]}
geometry: [{box: {min_m: [0.1, 0.1, 0.1], max_m: [9.9, 9.9, 3.9]}}]
media: {plume: {extinction_per_m: 0.02, albedo: 0.9}}
regions: [{medium: plume, box: {min_m: [7, 7, 1], max_m: [8, 8, 2]}}]
lights: [{type: point, position_m: [5, 5, 3], power_w: 10}]
photons: {emit: 40000}
sensors:
  types: [{name: node, range_m: 5}]
  candidates: {grid: {min_m: [1, 1, 1], max_m: [9, 9, 3], size: [4, 4, 2]}}
  count: 2
"""
TARGETS = "placement.targets={surfaces: {points: 400}, volume: {points: 300}}"
WARNING = re.compile(r"weights: (?:the|some) .* photons .*in media.* stand for 50 % of the "
                     r"coverage.*\{surface: 1, volume: 1\}", re.S)


def speak(murk, *words):
    """Standard output and error of the command."""
    done = subprocess.run([murk.program, *words], capture_output=True, text=True, timeout=60)
    check(done.returncode == 0, words, done.stderr)
    return " ".join(done.stdout.split()), done.stderr


def page(murk, folder):
    """The words of the report's page."""
    speak(murk, "report", folder)
    path = os.path.join(folder, "report.html")
    with open(path, encoding="utf-8") as file:
        text = pages.drawn(path) if browser.program() else pages.without_script(file.read())
    return re.sub(r"\s+", " ", re.sub("<[^>]*>", " ", text))


def is_sum(plan, *words):
    """Coverage is that of the maps by the weights that are said to be used."""
    of, used = plan["coverage"], plan["weights_used"]
    near(used["surface"] + used["volume"], 1, 1e-12, *words)
    near(of["in_sample"], used["surface"] * of["surface"] + used["volume"] * of["volume"],
         1e-9, *words)


def test_thin_map(murk, scene):
    folder = murk.path("plume")
    out, err = speak(murk, "place", scene, "-o", folder)
    plan = murk.read("plume", "plan.json")
    thin, stored = plan["thin_map"], plan["photons"]
    check(thin["map"] == "volume" and thin["photons"] == stored["volume"] < 100, thin)
    check(plan["weights_used"] == {"surface": .5, "volume": .5}, plan["weights_used"])
    # 11 of 40,000 records have more than a tenth of the variance
    check(thin["weight"] == .5 and .1 < thin["variance_share"] < 1, thin)
    # half of the volume fraction's own error, were the maps independent
    near(thin["standard_error"] / plan["coverage"]["volume_standard_error"], .5, .05, thin)
    is_sum(plan, "balanced")
    check(WARNING.search(err), "place warns:", err)
    check("balanced: coverage is the mean" in out, out)
    said = page(murk, folder)
    rests = f"the {stored['volume']} photons stored in media stand for 50 % of the coverage"
    for where, text in (("the page", said), ("the terminal", re.sub(r"\s+", " ", out))):
        check(f"what is seen of {stored['surface']} surface photons and of {stored['volume']} volume photons"
              in text, where, "lacks what the share is of")
        check(f"few photons: {rests}" in text, where, "lacks the thin map")
    _, err = speak(murk, "check", scene)
    check(WARNING.search(err), "check warns:", err)
    found = murk.run("sense", scene, "--sensors", murk.path("plume", "sensors.csv"))
    check(found["thin_map"] == thin, "sense:", found["thin_map"])


def test_plain_count(murk, scene):
    weights = "placement.weights={surface: 1, volume: 1}"
    _, err = speak(murk, "place", scene, "--set", weights, "-o", murk.path("plain"))
    plan = murk.read("plain", "plan.json")
    stored = plan["photons"]
    near(plan["weights_used"]["volume"],
         stored["volume"] / (stored["surface"] + stored["volume"]), 1e-6, "plain count")
    is_sum(plan, "plain count")
    check(plan["thin_map"] is None and "weights:" not in err, err)
    # both maps with photons enough
    plan = murk.run("place", scene, "--set", "media.plume.extinction_per_m=3")
    check(plan["photons"]["volume"] > 1000 and plan["thin_map"] is None, plan["thin_map"])


def test_targets(murk, scene):
    folder = murk.path("targets")
    out, _ = speak(murk, "place", scene, "--set", TARGETS, "-o", folder)
    check("surface targets" in out and "sample of targets" in out, out)
    said = page(murk, folder)
    drawn = ("targets on sides of surfaces 400", "target that none sees", "targets in the volume")
    for words in ("surface targets", "volume targets", "this sample of targets",
                  *(drawn if browser.program() else ())):
        check(words in said, "the page lacks:", words)
    for words in ("surface photons", "sample of photons", "stored photons are drawn", "photon that none sees",
                  "photons stored on surfaces"):
        check(words not in said, "the page has:", words)


def test_one_photon(murk, scene):
    out, _ = speak(murk, "place", scene, "--emit", "1", "-o", murk.path("one"))
    check("nan" not in out, out)
    plan = murk.read("one", "plan.json")
    check(plan["coverage"]["held_out_standard_error"] is None, plan["coverage"])
    check("error not known: one photon alone" in out or "that map is empty" in out, out)


def main():
    with tempfile.TemporaryDirectory() as folder:
        murk = from_outside.Murk(os.path.abspath(sys.argv[1]), folder)
        scene = murk.write("plume.yaml", PLUME)
        test_thin_map(murk, scene)
        test_plain_count(murk, scene)
        test_targets(murk, scene)
        test_one_photon(murk, scene)
    print("coverage says what it is of" if not from_outside.failures
          else f"{from_outside.failures} failed")
    return pages.failed != [] or from_outside.failures != 0


if __name__ == "__main__":
    sys.exit(main())
