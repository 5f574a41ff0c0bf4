#!/usr/bin/env python3
"""What a terminal shows: one progress line that fits its window and is wiped,
few whole lines elsewhere, summaries that fit a screen, and one line with the
right exit code for what a newcomer gets wrong. Standard library only.
usage: terminal.py MURK
"""

import fcntl
import functools
import glob
import json
import os
import pty
import re
import struct
import subprocess
import sys
import tempfile
import termios

MURK = os.path.abspath(sys.argv[1])
ROWS, COLUMNS = 40, 80
try:
    os.close(os.open("/dev/ptmx", os.O_RDWR))
except OSError as why:
    print("skipped: no pseudo-terminal here:", why)
    sys.exit(77)
failures = 0
SCENE = """\
murk: 1
domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}
geometry: [{box: {min_m: [0, 0, 0], max_m: [4, 4, 3]}}]
materials: {default: {diffuse: 0.9}}
media: {fog: {extinction_per_m: 0.3, albedo: 1, phase: {hg: 0.8}}}
regions: [{medium: fog}]
lights: [{type: point, position_m: [2, 2, 2], power_w: 10}]
photons: {emit: 1000, maps: none}
"""
SENSORS = """\
sensors:
  types: [{name: node, range_m: 2}]
  candidates: {grid: {min_m: [.2, .2, .2], max_m: [3.8, 3.8, 2.8], spacing_m: .7}}
  count: 30
placement:
  method: greedy
  interest: [{name: middle of it, box: {min_m: [1, 1, 1], max_m: [3, 3, 2]}, weight: 2}]
"""


def check(holds, *text):
    global failures
    if not holds:
        print("terminal.py:", *text)
        failures += 1


def run(*words, **more):
    return subprocess.run([MURK, *words], capture_output=True, text=True, **more)


def on_terminal(words, columns, terminal="xterm", **environment):
    """All that a terminal of so many columns is sent."""
    pid, fd = pty.fork()
    if pid == 0:
        # wait for the window's size, then be the program
        os.read(0, 1)
        environ = dict(os.environ, TERM=terminal, **environment)
        os.execve(MURK, [MURK, *words], environ)
    fcntl.ioctl(fd, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    os.write(fd, b"\n")
    sent = b""
    while True:
        try:
            piece = os.read(fd, 65536)
        except OSError:  # how a terminal's end reads
            break
        if not piece:
            break
        sent += piece
    status = os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])
    check(status == 0, words, "ends with", status)
    return sent.decode("utf-8", "replace").replace("\r\n", "\n")


@functools.lru_cache(maxsize=None)
def photons_a_second(scene):
    """That a processor traces here, without the start of the program."""
    def user_s(photons):
        times_s = [] # beside other work a processor's second is worth less
        for _ in range(3):
            before = os.times().children_user
            run("trace", scene, "-j1", "--emit", str(photons))
            times_s.append(os.times().children_user - before)
        return min(times_s)

    start_s = user_s(1000)
    photons = 20000
    while (traced_s := user_s(photons) - start_s) < 0.2:
        photons *= 2
    return photons / traced_s


def photons_for(seconds, scene):
    """So many that tracing takes a processor here about that long, and the
    clock no less, whatever runs beside it."""
    return str(int(photons_a_second(scene) * seconds))


def check_progress(scene):
    words = ["trace", scene, "-j1", "--emit", photons_for(2, scene)]
    sent = on_terminal(words, 46)
    lines = [l for l in re.findall(r"\r([^\r\n\033]+)\033\[K", sent)]
    check(len(lines) >= 3, len(lines), "progress lines in a second or more")
    check(max(map(len, lines), default=0) <= 45, "a line wider than its window:", lines[:1])
    check(all(re.search(r"trace +\d+ %  .* photons", l) for l in lines), lines[:1])
    check(any(re.search(r"\d+ s, \d+ s left", l) for l in on_terminal(words, 100).split("\r")),
          "no elapsed and remaining time")
    check(len({l.split("%")[0] for l in lines}) >= 3, "the percentage stands still:", lines)
    shown = sent.split("\r\033[K")[-1]
    check(shown.lstrip("\n").startswith("photons "), "not wiped:", repr(sent[-300:]))
    check("\033" not in shown, "escapes in the summary")
    check("m" not in re.findall(r"\033\[[0-9;]*([A-Za-z])", sent), "colours")
    dumb = on_terminal([*words[:-1], "1000"], 80, terminal="dumb")
    check("\033" not in dumb and "\r" not in dumb, "escapes on a dumb terminal")


def check_study(scene, folder):
    """Where a study is, is said once: by its own count, or before its rows' steps."""
    study = os.path.join(folder, "study.yaml")
    with open(study, "w", encoding="utf-8") as file:
        file.write(f"murk_study: 1\nbase: {scene}\naxes: {{seed: [1, 2]}}\noutputs: [density]\n")
    sent = on_terminal(["study", study, "-j1", "--emit", photons_for(1.5, scene)], 80)
    lines = re.findall(r"\r([^\r\n\033]+)\033\[K", sent)
    own = [l for l in lines if "study " in l]
    check(any(re.match("2/2 trace ", l) for l in lines), "no step of a row:", lines)
    check(own and all(re.match(r"study .* [012] of 2 rows", l) and l.count("left") <= 1 for l in own),
          "a study's own line:", own)


def check_plain(scene):
    words = ["trace", scene, "-j1", "--emit", photons_for(4, scene)]
    always = run(*words, "--progress", "always")
    lines = always.stderr.splitlines()
    check(2 <= len(lines) <= 12, "whole lines:", lines)
    check(all(re.fullmatch(r"murk: trace: .*\d s.*", l) for l in lines), lines)
    check("\r" not in always.stderr and "\033" not in always.stderr, "escapes in a file")
    check(lines and "100 %" in lines[-1], "the last line:", lines[-1:])
    short = ["trace", scene, "--emit", "1000"]
    check(run(*short).stderr == "", "progress where nobody sees it")
    check(run(*short, "-q", "--progress", "always").stdout == "", "--quiet speaks")


def check_summary(scene, folder):
    out = os.path.join(folder, "out")
    place = ["place", scene, "--emit", "200", "--set", "photons.maps=both"]
    for words in ([*place], [*place, "-o", out], ["sense", scene, "--sensors", out + "/sensors.csv",
                  "--set", "photons.maps=both"], ["check", scene], ["trace", scene],
                  ["render", scene, "--method", "path", "--pixels", "4x3", "-o", out + "/x.exr",
                   "--set", "cameras=[{name: a, from_m: [1, 1, 1], to_m: [2, 2, 1], samples: 2}]"]):
        done = run(*words)
        lines = done.stdout.splitlines()
        check(done.returncode == 0, words, done.stderr)
        check(4 <= len(lines) <= ROWS, words[0], "takes", len(lines), "lines")
        check(max(map(len, lines), default=0) <= COLUMNS + len(folder), words[0], "is",
              max(map(len, lines), default=0), "columns wide")
        check("\033" not in done.stdout, "escapes in a summary")
        if words[0] != "check":
            text = " ".join(done.stdout.split())
            check(re.search(r"time \d+\.\d\d s.*; memory [\d.]+ GB", text), words[0], "time, memory")
            check("\nfiles  " in done.stdout, words[0], "says no files")
        if words[0] in ("place", "sense"):
            check("coverage " in done.stdout and "+-" in done.stdout, words[0], "coverage")
            check("... and 18 more" in done.stdout, words[0], "does not shorten the sensors")
        if words == place:
            check("-o DIR writes" in done.stdout, "where the files would be")
            check("\nbound  " in done.stdout and "\nheld out  " in done.stdout, "bound, held out")
        as_json = run(*words, "--format", "json")
        try:
            json.loads(as_json.stdout)
        except ValueError as why:
            check(False, words[0], "--format json:", why)
        check(run(*words, "--quiet").stdout == "", words[0], "--quiet speaks")


def check_one(scene, folder):
    """One of a kind is not in the plural, and one sample tells no error."""
    render = ["render", scene, "--method", "path", "-o", folder + "/one.exr", "--camera", "all",
              "--set", "cameras=[{name: all, from_m: [1, 1, 1], to_m: [2, 2, 1], pixels: [4, 3]}]"]
    for samples in (1, 2):
        done = run(*render, "--samples", str(samples)).stdout
        check(f" {samples} sample{'s' * (samples > 1)};" in done, done)
        check("inf" not in done and ("+-" in done) == (samples > 1), "an error of", samples, done)
    done = run("check", scene, "--set", "sensors.types.0.view={hfov_deg: 60, vfov_deg: 40}",
               "--set", "sensors.types.0.headings=1").stdout
    check(", 1 heading, 1 tilt," in done, done)


def check_width():
    """Tables and long lines of the examples."""
    for words in (*(["check", scene] for scene in sorted(glob.glob("scenes/*.yaml"))),
                  ["media"], ["media", "fog/radiation"],
                  ["replay", "scenes/smoke-hall.yaml", "--photon", "1"],
                  ["study", "scenes/studies/fog-yard.yaml", "--emit", "50",
                   "--set", "placement.method=greedy"]):
        done = run(*words)
        if "install the package murk-gdal" in done.stderr:  # a build without the reader of valley.yaml
            continue
        wide = [l for l in done.stdout.splitlines() if len(l) > COLUMNS or l.endswith(" ")]
        check(done.returncode == 0 and not wide, words, wide[:2], done.stderr[:200])


def check_newcomer(scene, folder):
    empty = os.path.join(folder, "empty")
    os.mkdir(empty)
    for code, says, words in (
            (2, "no command; try murk --help", []),
            (2, "did you mean place?", ["plcae", scene]),
            (2, "as in murk check", [scene]),
            (2, "there are check, trace", ["zzzzzz"]),
            (2, "did you mean --emit?", ["trace", scene, "--emti", "3"]),
            (2, "(murk trace --help)", ["trace", scene, "--zzzzzz"]),
            (2, "no scene; usage", ["trace"]),
            (2, "no study; usage", ["study"]),
            (2, "one scene at a time", ["trace", scene, scene]),
            (2, "one folder at a time", ["report", "a", "b"]),
            (2, "No such file", ["trace", os.path.join(folder, "none.yaml")]),
            (2, "a folder, must be a regular file", ["trace", empty]),
            (1, "not a folder", ["trace", scene, "-o", scene]),
            (2, "is a study, must be a scene", ["trace", "scenes/studies/fog-yard.yaml"]),
            (2, "no results here", ["report", empty]),
            (2, "needs --sensors FILE", ["sense", scene]),
            (2, "needs --data FILE", ["fit", scene]),
            (2, "did you mean fog/kruse?", ["media", "fog/krus"])):
        done = run(*words)
        check(done.returncode == code, words, "ends with", done.returncode, "not", code)
        check(done.stderr.count("\n") == 1 and done.stderr.startswith("murk: "), done.stderr)
        check(says in done.stderr, words, "says", done.stderr)
        check(done.stdout == "", words, "prints", done.stdout)
    for words in (["--help"], ["help"], ["help", "place"], ["place", "--help"], ["render", "--help"],
                  ["fit", "--help"]):
        done = run(*words)
        lines = done.stdout.splitlines()
        check(done.returncode == 0 and done.stdout.startswith("usage: murk "), words)
        check(all(len(l) <= COLUMNS for l in lines), words, "too wide")
    check(len(run("--help").stdout.splitlines()) <= ROWS + 5, "murk --help is long")


with tempfile.TemporaryDirectory() as temporary:
    path = os.path.join(temporary, "box.yaml")
    with open(path, "w", encoding="utf-8") as file:
        file.write(SCENE + SENSORS)
    check_progress(path)
    check_study(path, temporary)
    check_plain(path)
    check_summary(path, temporary)
    check_one(path, temporary)
    check_width()
    check_newcomer(path, temporary)
print("fits" if failures == 0 else f"{failures} failures")
sys.exit(failures != 0)
