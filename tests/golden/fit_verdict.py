#!/usr/bin/env python3
"""A fit says the same everywhere: the terminal, fit.json, calibrated.yaml and
the page agree on whether the model fits and on each value that the data do not
determine. A fit that chi-squared refuses says so before any value and exits 0.
Standard library only; beams alone, so no light is traced and nothing is random.
usage: fit_verdict.py MURK
"""

import html
import json
import pathlib
import re
import subprocess
import sys
import tempfile

SCENE = """\
murk: 1
bands_nm: [550]
domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}
media: {fog: {extinction_per_m: 0.3, albedo: 0.87654, phase: {hg: 0.6}}}
regions: [{medium: fog}]
lights: [{type: point, position_m: [2, 2, 2.5], power_w: 10}]
photons: {emit: 2000}
"""
HEAD = "kind,x_m,y_m,z_m,x2_m,y2_m,z2_m,unit,value,standard_error\n"
# two beams of 2 m that agree on an extinction of .34 per metre, and two that do not
AGREE = HEAD + "transmittance,1,1,1,3,1,1,fraction,0.5,0.01\ntransmittance,1,1,1,1,3,1,fraction,0.51,0.01\n"
DISAGREE = HEAD + "transmittance,1,1,1,3,1,1,fraction,0.5,0.01\ntransmittance,1,1,1,1,3,1,fraction,0.7,0.01\n"
# free: what the beams determine, and what no beam depends on; then a beam that
# no positive extinction can explain, so the fit ends at the bound asked for
KEYS = "media.fog.extinction_per_m,media.fog.albedo"
UNKNOWN = "not determined by these data"

failures = 0


def check(held, *what):
    global failures
    if not held:
        failures += 1
        print("not so:", *what)


def words(text):
    return " ".join(text.split())


def fit(folder, name, data, *more):
    """Terminal, fit.json, calibrated.yaml and the page's words of one fit, and the
    warnings where standard output has the JSON alone."""
    (folder / "scene.yaml").write_text(SCENE)
    (folder / f"{name}.csv").write_text(data)
    out = folder / name
    command = [sys.argv[1], "fit", folder / "scene.yaml", "--data", folder / f"{name}.csv", *more]
    done = subprocess.run([*command, "-o", out], capture_output=True, text=True)
    check(done.returncode == 0, name, "exit", done.returncode, done.stderr)
    report = subprocess.run([sys.argv[1], "report", out], capture_output=True, text=True)
    check(report.returncode == 0, name, "report", report.stderr)
    page = re.sub("<(script|style).*?</(script|style)>", " ", (out / "report.html").read_text(), flags=re.S)
    page = words(html.unescape(re.sub("<[^>]*>", " ", page)))
    as_json = subprocess.run([*command, "--format", "json"], capture_output=True, text=True)
    check(as_json.returncode == 0, name, "--format json: exit", as_json.returncode)
    return (words(done.stdout), json.loads((out / "fit.json").read_text()),
            (out / "calibrated.yaml").read_text(), page, words(as_json.stderr))


def check_same(name, terminal, found, calibrated, page):
    """The verdict and each value's status are the same words in all four."""
    for where, text in (("terminal", terminal), ("calibrated.yaml", calibrated), ("page", page)):
        check(found["verdict"] in words(text), name, where, "lacks the verdict", found["verdict"], text[:400])
    for parameter in found["parameters"]:
        key, status = parameter["key"], parameter["status"]
        known = parameter["standard_error"] is not None
        check((status == "determined") == known, name, parameter)
        check((status == "at its bound") == parameter["at_bound"], name, parameter)
        if not known:
            two = f"{key} = {parameter['value']:.2g} ({status})"
            check(two in terminal, name, "terminal lacks", two)
            check(two in page, name, "page lacks", two)
            check(f"# {key}: {status}" in calibrated, name, calibrated)
            digits = f"{parameter['value']:.5g}"
            check(len(digits) < 6 or digits not in page.split("Words on this page")[0],
                  name, "the page prints", digits)


with tempfile.TemporaryDirectory() as made:
    folder = pathlib.Path(made)

    *texts, warned = fit(folder, "agree", AGREE, "--free", "media.fog.extinction_per_m")
    check_same("agree", *texts)
    check(texts[1]["accepted"] is True, "agree: accepted")
    check(texts[1]["verdict"].startswith("Yes"), texts[1]["verdict"])
    check(warned == "", "agree: warned of", warned)

    *texts, warned = fit(folder, "unknown", AGREE + "transmittance,1,1,1,1,1,2,fraction,0.71,0.01\n", "--free", KEYS)
    check_same("unknown", *texts)
    check(texts[1]["accepted"] is True, "unknown: accepted")
    check([p["status"] for p in texts[1]["parameters"]] == ["determined", UNKNOWN], texts[1]["parameters"])
    check("do not determine media.fog.albedo" in texts[1]["verdict"], texts[1]["verdict"])

    *texts, warned = fit(folder, "bound", AGREE, "--free", "media.fog.extinction_per_m",
                        "--bounds", "media.fog.extinction_per_m=.2:.335")
    check_same("bound", *texts)
    check(texts[1]["parameters"][0]["status"] == "at its bound", texts[1]["parameters"])

    *texts, warned = fit(folder, "refused", DISAGREE, "--free", "media.fog.extinction_per_m")
    check_same("refused", *texts)
    terminal, found, calibrated, page = texts
    check(found["accepted"] is False and found["p_value"] < 1e-4, "refused:", found["p_value"])
    check(terminal.startswith("fit No: the data refuse this model"), terminal[:200])
    check(calibrated.index("No: the data refuse") < calibrated.index("extinction_per_m"), calibrated)
    check(page.index("No: the data refuse") < page.index("extinction_per_m ="), page[:600])
    check("No: the data refuse" in warned, "refused: no warning beside --format json:", warned)

    # whoever uses the values of a refused fit is told in one line, --quiet or not
    program = pathlib.Path(sys.argv[1]).resolve()
    uses = {"predict": ["fit", "scene.yaml", "--data", "refused.csv", "--predict", "FIT/fit.json"],
            "set": ["check", "scene.yaml", "--set", "@FIT/calibrated.yaml"],
            "fit": ["fit", "scene.yaml", "--data", "FIT.csv", "--free", "media.fog.extinction_per_m"]}
    for use, command in uses.items():
        for name, is_warned in (("agree", False), ("refused", True)):
            for more in ([], ["--quiet"], ["--format", "json"]):
                if use == "fit" and not more:
                    continue  # its summary says it, as above
                line = [word.replace("FIT", name) for word in command] + more
                done = subprocess.run([program, *line], cwd=folder, capture_output=True, text=True)
                check(done.returncode == 0, line, done.stderr)
                warnings = [text for text in done.stderr.splitlines() if "refuse" in text]
                check(len(warnings) == is_warned, line, "says", done.stderr)
                check(done.stdout == "" or "--quiet" not in more, line, done.stdout)

    fit_of_one = HEAD + "transmittance,1,1,1,3,1,1,fraction,0.5,0.01\n"
    *texts, warned = fit(folder, "one", fit_of_one, "--free", "media.fog.extinction_per_m")
    check_same("one", *texts)
    check(texts[1]["accepted"] is None and texts[1]["p_value"] is None, "one:", texts[1]["verdict"])

sys.exit(1 if failures else 0)
