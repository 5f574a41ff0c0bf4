#!/usr/bin/env python3
"""tools/html: every document, key table and man page has a page with a title of
its own, a navigation and working links, and pictures come along. A wrong link and
a wrong anchor planted in a page are found. Skipped without the generator.
Standard library only.
usage: html.py MAN-FOLDER
"""

import glob
import os
import re
import subprocess
import sys
import tempfile

failures = 0


def check(holds, *text):
    global failures
    if not holds:
        print("html.py:", *text)
        failures += 1


def run(*words):
    return subprocess.run([sys.executable, "-B", *words], capture_output=True, text=True)


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def check_pages(folder):
    pages = {os.path.relpath(path, folder): text_of(path)
             for path in glob.glob(os.path.join(folder, "**", "*.html"), recursive=True)}
    # every document and man page has a page
    for source in glob.glob("doc/**/*.md", recursive=True):
        if not source.startswith("doc/man/"):
            page = source.replace("README.md", "index.md")[:-3] + ".html"
            check(page in pages, "no page of", source)
    for source in glob.glob(os.path.join(sys.argv[1], "man?", "*")):
        page = pages.get(f"man/{os.path.basename(source)}.html", "")
        check('id="DESCRIPTION"' in page, "no page of", source)
    # titles, navigation, pictures, anchors
    titles = [re.search(r"<title>(.+)</title>", text)[1] for text in pages.values()]
    check(len(set(titles)) == len(titles) > 40, sorted(titles))
    for page, text in pages.items():
        check(text.count('class="here"') == 1, page, "is not once in the navigation")
    check(os.path.getsize(os.path.join(folder, "doc", "smoke-hall.png")) > 10000, "no picture")
    check('id="keys-of-sensorstypes"' in pages["doc/reference/sensors.html"], "no anchor of a table")
    check('<a href="../../man/murk-scene.5.html">murk-scene(5)</a>' in pages["doc/reference/index.html"],
          "names of man pages are no links")


def check_planted(folder):
    path = os.path.join(folder, "doc", "reference", "index.html")
    text = text_of(path)
    for wrong, says in (("sensor.html", "no such file"), ("sensors.html#keys-of-sensor", "no such anchor")):
        with open(path, "w", encoding="utf-8") as file:
            file.write(text.replace('href="sensors.html"', f'href="{wrong}"'))
        done = run("tools/check_links", "--html", folder)
        check(done.returncode == 1 and f"{wrong}: {says}" in done.stdout, wrong, "is not found:", done.stdout)


with tempfile.TemporaryDirectory() as parent:
    made = os.path.join(parent, "html")
    for _ in range(2):  # the second time over the first
        done = run("tools/html", made, "--man", sys.argv[1])
        if done.returncode == 77:
            print(done.stdout.strip())
            sys.exit(77)
        check(done.returncode == 0, done.stdout, done.stderr)
    if failures == 0:
        check_pages(made)
        check_planted(made)
print("ok" if failures == 0 else f"{failures} failures")
sys.exit(failures != 0)
