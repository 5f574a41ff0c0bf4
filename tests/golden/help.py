#!/usr/bin/env python3
"""murk help from outside: each row of the tables of keys in doc/reference is
listed with its meaning, every sixth is asked for and printed with its values and
its default, within 80 columns, and an unknown key is answered by a known one. Standard library only.
usage: help.py MURK
"""

import glob
import re
import subprocess
import sys

MURK = sys.argv[1]
failures = 0


def check(holds, *text):
    global failures
    if not holds:
        print("help.py:", *text)
        failures += 1


def run(*words):
    done = subprocess.run([MURK, "help", *words], capture_output=True, text=True)
    check(all(len(line) <= 80 for line in done.stdout.splitlines()), words, "is wider than 80 columns")
    return done


def link(found):
    """The plain text of a link: its own, or for "below" the part of the reference that it leads to."""
    text, part = found[1], found[2].partition("#")[2]
    if text != "below" or not part:
        return text
    return "the reference" if part.startswith("keys-of-") else 'the reference, "' + part.replace("-", " ") + '"'


def words_of(text):
    return " ".join(re.sub(r"\[([^][]*)\]\(([^)]*)\)", link, text).replace("`", "").split())


def tables():
    """The paths that each comment names, and the rows of the table below it."""
    text = ""
    for page in sorted(glob.glob("doc/reference/[a-z]*.md")):
        with open(page, encoding="utf-8") as file:
            text += file.read() + "\n"
    for comment in re.finditer(r"^<!-- keys of (.*) -->$", text, re.M):
        begin = text.index("| key | value | default | meaning |", comment.end())
        table = text[begin:].split("\n\n")[0].splitlines()[2:]
        yield comment[1].split(", "), [re.match(r"\| `(\w+)` \| (.*) \| (.*?) \| (.*) \|$", row)
                                       for row in table]


def check_entries():
    n = 0
    for paths, rows in tables():
        for path in paths:
            if path == "study":
                continue
            section = run(*([] if path == "scene" else [path]))
            said = words_of(section.stdout)
            check("](" not in section.stdout, path, "has a link")
            for i, row in enumerate(rows):
                n += 1
                check(row[1] in said, path, "does not list", row[1])
                if path != "scene":
                    check(words_of(row[4]) in said, path, "does not say", row[4])
                if i % 6 > 0:
                    continue
                key = row[1] if path == "scene" else f"{path}.{row[1]}"
                entry = run(key)
                words = words_of(entry.stdout)
                check(entry.returncode == 0, key, entry.stderr)
                for cell in (row[2], row[4]):
                    check(words_of(cell) in words, key, "has no", cell)
                if row[3].startswith("`"):
                    check("default " + row[3].strip("`") in words, key, "has no default", row[3])
    check(n > 230, n, "keys found")


def check_paths():
    same = [run(key).stdout for key in ("media.*.albedo", "media.fog.albedo", "media.albedo")]
    check(same[0] and len(set(same)) == 1, "items of media are not alike")
    check(run("lights.3.power_w").stdout == run("lights.*.power_w").stdout, "items of lights")
    check(run("place").stdout.startswith("usage: murk place "), "the help of a command")
    check("murk media --help" in run("media").stdout, "media is a command, too")
    check("required is this or one of metar, synop" in words_of(run("weather.epw").stdout), "the other keys of a group")
    lines = run().stdout.splitlines()
    check(lines[0].startswith("usage: murk ") and any(l.startswith("sensors ") for l in lines), lines)
    for key, says in (("sensors.cuont", "did you mean sensors.count?"),
                      ("media.fog.extinctoin_per_m", "did you mean media.fog.extinction_per_m?"),
                      ("aperture_m2", "did you mean sensors.types.*.aperture_m2?"),
                      ("sensors.count.each", "no such key; murk help lists"),
                      ("zzzzzz", "no such key; murk help lists")):
        done = run(key)
        check(done.returncode == 2 and not done.stdout, key, done.returncode, done.stdout)
        check(done.stderr.startswith(f"murk: {key}: ") and says in done.stderr, done.stderr)
    for more in (["--set", "seed=2"], ["--format", "json"]):
        done = run("seed", *more)
        check(done.returncode == 2 and "prints one text" in done.stderr, more, done.stderr)


check_entries()
check_paths()
print("ok" if failures == 0 else f"{failures} failures")
sys.exit(failures != 0)
