#!/usr/bin/env python3
"""Runs a chapter of doc/guide and compares it with what it shows.

    guide.py MURK LIBRARY CHAPTER.md     run and compare; exit 77: skipped
    guide.py --update MURK LIBRARY CHAPTER.md   write the present output into it
    guide.py --seed N MURK LIBRARY CHAPTER.md   run it with another seed: figures
                                         must hold within their errors
    guide.py --run MURK LIBRARY CHAPTER.md DIR  write its files and run its commands
                                         in DIR, without comparing
    guide.py --self-test                 wrong figures and texts are found

How a chapter is written (Markdown; all of it reads well without this program):

* A fenced block `console` has lines `$ COMMAND`, each followed by the expected
  output, errors and warnings included. A command that ends with a backslash goes
  on in the next line. A line `...` stands for any number of lines. All commands
  of a chapter run in bash in one folder that is empty at first, where `murk` is
  the program under test and $MURK_SCENES the folder scenes/.
* `<!-- file: NAME -->` before any other fenced block: the block is that file. It
  is written when its turn comes. There are no other blocks.
* `<!-- exit: N -->` before a console block: its last command ends with N, not 0.
* `<!-- photons: P % -->` before a console block: figures without an error of their
  own rest on photons. They may differ by P percent (fractions and percentages by
  P/100 and P), counts of photons by SIGMAS of their square root more, and another
  plan may be chosen: in the table of sensors and after the word "sensor" numbers
  are not compared, nor after "chi2" and "chance", of which the verdict is compared. Other whole numbers below 1000 are compared exactly.
* `<!-- needs: PATH ... -->`: without one of these files, a Python module written as
  python:NAME or a program of the library written as program:NAME, the chapter is
  skipped.
* `<!-- given: N ... -->`: numbers of the text that no block of the chapter shows,
  because they are definitions, or are reckoned from those shown.
* `![TEXT](NAME.png)`, and in the next line of text the command that makes it, in
  backticks, as tools/pictures --list has it.

What is compared: text exactly, but for the width of blanks and the place where a
long line is wrapped. Numbers exactly, with these exceptions: VALUE +- ERROR may
differ by SIGMAS of both errors together, and the error by a factor of 2; a line
that begins with "time" depends on the machine, as do the numbers of one that begins
with "memory"; `photons` as above.
Paths of photons may turn on the last bit of a sine, which differs between C
libraries, so that figures of Monte Carlo runs are not the same everywhere.

Numbers of the text itself (not of headings, links and code) must be roundings of
numbers that a block of the chapter shows, as they are or as percentages; whole
numbers up to SMALL are free. `murk help KEY` in the text must name a key, and
`murk COMMAND` a command. Links must lead to files that exist.
"""

import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PICTURES = ROOT / "tools" / "pictures"

# Differences of two independent runs, each with the stated error. One comparison
# in 5e8 is further off by chance; the guide has some hundreds.
SIGMAS = 6
SMALL = 12          # whole numbers of the text up to this need no source
SECONDS = 300       # for one command, on a machine that does much else
PICTURE_BYTES = 150_000
NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d+(?:\.\d+)?|\.\d+)(?:e[-+]?\d+)?(?![\w]|\.\d)")
SENSOR_ROW = re.compile(r"^\s*\d+ [a-z]\S* -?\d")
SEEDED = re.compile(r"^murk (place|trace|sense|render|study|fit)\b")


class Failed(Exception):
    """One line about the chapter."""


# ---- reading a chapter ----


class Block:
    """A fenced block: kind `console` or the name of a file."""

    def __init__(self, language, options, line, text):
        self.line, self.text = line, text
        self.file = options.get("file")
        self.exit = int(options.get("exit", 0))
        self.photons = float(options["photons"].rstrip(" %")) if "photons" in options else None
        if (self.file is None) == (language != "console"):
            raise Failed(f"line {line}: a block is console, or has <!-- file: NAME --> before it")

    def commands(self):
        """[command, first line of its output, one behind its last line]: by line of the text."""
        found, lines, i = [], self.text, 0
        while i < len(lines):
            if not lines[i].startswith("$ "):
                raise Failed(f"line {self.line + i + 1}: output without a command")
            words = lines[i][2:]
            while words.endswith("\\"):
                i += 1
                words = words[:-1].rstrip() + " " + lines[i].strip()
            i += 1
            begin = i
            while i < len(lines) and not lines[i].startswith("$ "):
                i += 1
            found.append((words, begin, i))
        return found


class Chapter:
    """Blocks in order, and the text between them, line by line (a block's lines are empty)."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        self.lines = self.path.read_text(encoding="utf-8").splitlines()
        self.blocks, self.text, self.needs, self.given = [], [], [], []
        options, i = {}, 0
        while i < len(self.lines):
            line = self.lines[i]
            comment = re.fullmatch(r"<!-- (\w+): (.*) -->", line)
            if comment:
                self.option(*comment.groups(), options)
                line = ""
            if line.startswith("```"):
                end = self.lines.index("```", i + 1)
                self.blocks.append(Block(line[3:], options, i + 1, self.lines[i + 1:end]))
                self.text += [""] * (end - i)
                options, i, line = {}, end, ""
            self.text.append(line)
            i += 1

    def option(self, name, value, options):
        if name == "needs":
            self.needs += value.split()
        elif name == "given":
            self.given += [float(n) for n in value.split()]
        elif name in ("file", "exit", "photons"):
            options[name] = value
        else:
            raise Failed(f"<!-- {name}: is no word of this program")


# ---- comparing ----


def plain(line):
    return re.sub(r"\s+", " ", line.rstrip())


def skeleton(line):
    return NUMBER.sub("#", plain(line))


def near(shown, got, tolerance):
    return abs(float(shown) - float(got)) <= tolerance


def number_agrees(shown, got, follows, line, photons):
    """True if a number without an error of its own agrees; `follows` is the text behind it."""
    if shown == got or line.startswith("memory "):
        return True
    if photons is None:
        return False
    if follows.startswith(" %"):
        return near(shown, got, photons)
    size, share = max(abs(float(shown)), abs(float(got))), photons / 100
    if not re.search(r"[.e]", shown + got):  # whole numbers: counts of photons
        is_count = size >= 1000 or follows.startswith((" surface", " volume"))
        return is_count and near(shown, got, share * size + SIGMAS * math.sqrt(size))
    return near(shown, got, share * max(size, 1 if size <= 1 else 0))


def line_agrees(shown, got, photons):
    shown, got = plain(shown), plain(got)
    if shown.startswith("time ") and got.startswith("time "):
        return True
    if skeleton(shown) != skeleton(got):
        return False
    if photons is not None and SENSOR_ROW.match(shown):
        return True
    a, b = list(NUMBER.finditer(shown)), list(NUMBER.finditer(got))
    k = 0
    while k < len(a):
        x, y = a[k].group(), b[k].group()
        behind = shown[a[k].end():]
        if behind.startswith(" +- ") and k + 1 < len(a):
            e, f = float(a[k + 1].group()), float(b[k + 1].group())
            step = 10.0 ** -len(x.partition(".")[2])  # of the last digit shown
            if not near(x, y, SIGMAS * math.hypot(e, f) + step) or not (e == f or e / 2 <= f <= 2 * e):
                return False
            k += 1
        elif photons is not None and re.search(r"\b(sensor|chi2|chi2 is|chance) $", shown[:a[k].start()]):
            pass
        elif not number_agrees(x, y, behind, shown, photons):
            return False
        k += 1
    return True


def unwrapped(lines):
    """Lines that go on from the one before, at column 12, joined to it."""
    out = []
    for line in lines:
        if re.match(r" {12}\S", line) and out and out[-1] != "...":
            out[-1] += " " + line.strip()
        else:
            out.append(line)
    return out


def matches(shown, got, agrees):
    """None, or the line of `shown` that has no counterpart in `got`, with the best that is left."""
    parts, at = [[]], 0
    for line in shown:
        if line == "...":
            parts.append([])
        else:
            parts[-1].append(line)
    for k, part in enumerate(parts):
        last = k == len(parts) - 1
        starts = [at] if k == 0 else range(at, len(got) - len(part) + 1)
        if last and k > 0:
            starts = [len(got) - len(part)] if len(got) - len(part) >= at else []
        for start in starts:
            if start + len(part) <= len(got) and all(
                    agrees(a, b) for a, b in zip(part, got[start:start + len(part)])):
                at = start + len(part)
                break
        else:
            return explain(part, got[at:], agrees)
    return None if at == len(got) or shown[-1:] == ["..."] else ("(end)", got[at])


def explain(part, got, agrees):
    for line in part:
        if not any(agrees(line, other) for other in got):
            alike = [g for g in got if skeleton(g) == skeleton(line)]
            begin = [g for g in got if plain(g)[:8] == plain(line)[:8]]
            return line, (alike or begin or got or ["(nothing)"])[0]
    return "\n".join(part), "these lines elsewhere, or more behind them: " + got[-1]


def check_output(shown, got, photons):
    """None, or a pair of lines that differ."""
    def agrees(a, b):
        return line_agrees(a, b, photons)
    if not shown and got:
        return "(nothing)", got[0]
    if matches(shown, got, agrees) is None:
        return None
    return matches(unwrapped(shown), unwrapped(got), agrees)


# ---- running ----


class Runner:
    def __init__(self, murk, library, folder, seed=None):
        self.folder, self.seed = pathlib.Path(folder), seed
        self.tools = tempfile.TemporaryDirectory()
        os.symlink(os.path.abspath(murk), os.path.join(self.tools.name, "murk"))
        os.symlink("/usr/bin/python3", os.path.join(self.tools.name, "python3"))
        self.environment = {
            **os.environ, "PATH": self.tools.name + ":" + os.environ["PATH"], "LC_ALL": "C.UTF-8",
            "MURK_SCENES": str(ROOT / "scenes"), "PYTHONPATH": str(ROOT / "python"),
            "MURK_LIBRARY": os.path.abspath(library), "MURK_HEADER": str(ROOT / "src" / "murk.h"),
            "PYTHONDONTWRITEBYTECODE": "1"}

    def write(self, block):
        path = self.folder / block.file
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("\n".join(block.text) + "\n", encoding="utf-8")

    def command(self, words):
        if self.seed is not None and "--light" not in words:
            words = SEEDED.sub(rf"\g<0> --seed {self.seed}", words)
        done = subprocess.run(["bash", "-c", words], cwd=self.folder, env=self.environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=SECONDS, check=False)
        return done.stdout.splitlines(), done.returncode

    def run(self, chapter, told):
        """Calls told(block, command, begin, end, lines, exit) for each command."""
        for block in chapter.blocks:
            if block.file is not None:
                self.write(block)
                continue
            commands = block.commands()
            for k, (words, begin, end) in enumerate(commands):
                lines, code = self.command(words)
                due = block.exit if k == len(commands) - 1 else 0
                if code != due:
                    raise Failed(f"line {block.line + begin}: {words}: exit {code}, not {due}:\n" + "\n".join(lines))
                told(block, words, begin, end, lines)


def run_and_compare(chapter, runner):
    failures = []

    def told(block, words, begin, end, lines):
        wrong = check_output(block.text[begin:end], lines, block.photons)
        if wrong:
            failures.append(f"line {block.line + begin}: {words}\n    shown   {wrong[0]}\n    printed {wrong[1]}")
    runner.run(chapter, told)
    return failures


def updated(shown, got):
    """The lines of `shown` with the numbers of `got`; all of `got` where nothing is left out."""
    if "..." not in shown:
        return got
    out, at = [], 0
    for line in shown:
        alike = [k for k in range(at, len(got)) if skeleton(got[k]) == skeleton(line)]
        if line != "..." and alike:
            at = alike[0] + 1
            line = got[alike[0]]
        out.append(line)
    return out


def update(chapter, runner):
    changes = []

    def told(block, _, begin, end, lines):
        changes.append((block.line + begin, block.line + end, updated(block.text[begin:end], lines)))
    runner.run(chapter, told)
    for begin, end, lines in reversed(changes):
        chapter.lines[begin:end] = lines
    chapter.path.write_text("\n".join(chapter.lines) + "\n", encoding="utf-8")


# ---- the text ----


def sources(chapter):
    """All numbers that the chapter shows in blocks, or states as given."""
    found = list(chapter.given)
    for block in chapter.blocks:
        for line in block.text:
            found += [abs(float(n)) for n in re.findall(r"(?:\d+(?:\.\d+)?|\.\d+)(?:e[-+]?\d+)?", line)]
    return found


def is_rounding(number, found):
    digits = len(number.partition(".")[2])
    half = 0.5000001 * 10.0 ** -digits
    return any(abs(abs(float(number)) - f) <= half for f in found)


def check_figures(chapter):
    failures, found = [], sources(chapter)
    for i, line in enumerate(chapter.text):
        if line.startswith("#"):
            continue
        line = re.sub(r"!?\[([^]]*)\]\([^)]*\)", r"\1", line)
        line = re.sub(r"`([^`]*)`", lambda m: m[1] if NUMBER.fullmatch(m[1]) else "", line)
        line = re.sub(r"^\d+\. ", "", line)
        for match in NUMBER.finditer(line):
            number = match.group().lstrip("+-")
            is_small = number.isdecimal() and int(number) <= SMALL
            is_share = line[match.end():].startswith((" %", " percent", " points", " cents"))
            shares = [100 * f for f in found] if is_share else []
            if not (is_small and not is_share) and not is_rounding(number, found + shares):
                failures.append(f"line {i + 1}: {number} is shown by no block of this chapter")
    return failures


def check_commands(chapter, runner):
    """`murk help KEY` names a key, `murk COMMAND` a command."""
    failures, known = [], set()
    for i, line in enumerate(chapter.text):
        for words in re.findall(r"`murk ([a-z][^`]*)`", line):
            asked = "help " + words.split()[1] if words.startswith("help ") else words.split()[0] + " --help"
            if "KEY" not in asked and asked not in known and runner.command("murk " + asked)[1] != 0:
                failures.append(f"line {i + 1}: murk {words}: no such key or command")
            known.add(asked)
    return failures


def pictures_made():
    lines = subprocess.run([sys.executable, str(PICTURES), "--list"], text=True, check=True,
                           capture_output=True).stdout.splitlines()
    return {tuple(line.split("\t")[:2]): line.split("\t")[2] for line in lines}


def check_pictures(chapter):
    failures, made = [], None
    for i, line in enumerate(chapter.text):
        for name in re.findall(r"!\[[^]]*\]\(([^)]*)\)", line):
            made = pictures_made() if made is None else made
            path = chapter.path.parent / name
            following = next((text for text in chapter.text[i + 1:] if text), "")
            command = made.get((chapter.path.name, name))
            if not path.exists():
                failures.append(f"line {i + 1}: there is no {name}")
            elif path.stat().st_size > PICTURE_BYTES:
                failures.append(f"line {i + 1}: {name} has more than {PICTURE_BYTES} bytes")
            if command is None:
                failures.append(f"line {i + 1}: tools/pictures does not make {name}")
            elif f"`{command}`" not in following:
                failures.append(f"line {i + 1}: below {name} does not stand `{command}`")
    return failures


def missing(chapter, murk):
    for need in chapter.needs:
        kind, _, name = need.partition(":")
        if kind == "python" and not os.path.exists("/usr/bin/python3"):
            return "there is no /usr/bin/python3"
        if kind == "python":
            asked = subprocess.run(["/usr/bin/python3", "-c", f"import {name}"], stderr=subprocess.DEVNULL, check=False)
            if asked.returncode != 0:
                return f"Debian's Python has no module {name}"
        elif kind == "program":
            if not list(pathlib.Path(murk).resolve().parent.glob(f"libmurk*/{name}")):
                return f"this build has no {name}"
        elif not os.path.exists(need):
            return f"there is no {need}"
    return None


def check(murk, library, path, seed=None):
    """The failures of a chapter, or None if it is skipped."""
    chapter = Chapter(path)
    lacking = missing(chapter, murk)
    if lacking:
        print(f"skipped: {lacking}")
        return None
    with tempfile.TemporaryDirectory() as folder:
        runner = Runner(murk, library, folder, seed)
        failures = check_figures(chapter) + check_pictures(chapter)
        failures += check_commands(chapter, runner)
        try:
            failures += run_and_compare(chapter, runner)
        except Failed as wrong:
            failures.append(str(wrong))
        return failures


# ---- this program itself ----

TRUE = """# A chapter
<!-- given: 3.912 -->
Coverage is 0.83, which is 83 %; the law has 3.912.
<!-- file: a.txt -->
```text
held out    0.8286 +- 0.0013 (one standard error)
photons     10000 emitted; stored: 14534 surface, and this line is so long that
            it is wrapped
sensors     type          x m
         1  node        4.250
time        3.1 s
```
<!-- photons: 3 % -->
```console
$ cat a.txt
held out 0.8289 +- 0.0014 (one standard error)
photons     10000 emitted; stored: 14700 surface, and this line is so long that it
            is wrapped
...
         1  node        7.750
time        99.1 s
$ sed -n 2,3p a.txt \\
    | head -1
photons     10000 emitted; stored: 14534 surface, and this line is so long that
```
<!-- exit: 3 -->
```console
$ exit 3
```
"""
WRONG = (  # what stands in TRUE, what in its place, what the failure speaks of
    ("0.8289 +-", "0.8136 +-", "0.8286"),                       # a figure, by 8 of both errors
    ("+- 0.0014 (one", "+- 0.0031 (one", "0.0013"),             # its error
    ("0.0014 (one", "0.0014 (two", "two standard error"),       # a text
    ("stored: 14700", "stored: 17500", "14534"),                # a figure without an error
    ("time        99.1 s\n", "", "behind them: time"),          # a line too few
    ("time        99.1 s\n", "         2  node        7.750\ntime        99.1 s\n", "2 node"),  # and too many
    ("is 0.83,", "is 0.84,", "0.84 is shown by no block"),
    ("83 %;", "82 %;", "82 is shown by no block"),
    ("$ exit 3", "$ exit 2", "exit 2, not 3"),
    ("# A chapter\n", "# A chapter\n![it](none.png)\n", "there is no none.png"),
)


def self_test():
    failures = 0
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "chapter.md"

        def result(text):
            path.write_text(text, encoding="utf-8")
            return check("/bin/false", "/bin/false", path)
        found = result(TRUE)
        if found:
            print("the true chapter fails:", *found, sep="\n")
            failures += 1
        for old, new, about in WRONG:
            assert TRUE.count(old) == 1, old
            found = result(TRUE.replace(old, new))
            if not any(about in plain(f) for f in found):
                print(f"{old!r} made {new!r}: not found; failures:", found)
                failures += 1
        result(TRUE.replace("0.8289 +-", "0.7 +-"))
        chapter = Chapter(path)
        with tempfile.TemporaryDirectory() as scratch:
            update(chapter, Runner("/bin/false", "/bin/false", scratch))
        if "held out    0.8286 +- 0.0013 (one" not in path.read_text(encoding="utf-8").partition("$ cat")[2]:
            print("update does not write what is printed")
            failures += 1
    print("ok" if failures == 0 else f"{failures} failures")
    return failures != 0


def main(words):
    if words == ["--self-test"]:
        return self_test()
    mode = words.pop(0) if words[:1] in (["--update"], ["--run"], ["--seed"]) else None
    seed = int(words.pop(0)) if mode == "--seed" else None
    if len(words) != (4 if mode == "--run" else 3):
        sys.exit(__doc__)
    try:
        if mode == "--run":
            Runner(words[0], words[1], words[3]).run(Chapter(words[2]), lambda *_: None)
            return 0
        if mode == "--update":
            with tempfile.TemporaryDirectory() as folder:
                update(Chapter(words[2]), Runner(words[0], words[1], folder))
            return 0
        failures = check(*words, seed)
    except Failed as wrong:
        failures = [str(wrong)]
    if failures is None:
        return 77
    for failure in failures:
        print(f"{words[2]}: {failure}")
    print(f"{len(failures)} failures" if failures else "ok")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
