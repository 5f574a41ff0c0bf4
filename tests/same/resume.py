"""Kills a trace twice, each time after a checkpoint, runs the same command again, and compares the files with those of
an undisturbed run: emit and store, tallies, other numbers of threads. Checkpoints of another scene, damaged ones and
files that murk did not write.

    resume.py MURK"""
import os
import signal
import subprocess
import sys
import tempfile
import time

from run_files import differences

MURK = os.path.abspath(sys.argv[1])
TALLIES = ("tallies=[{name: ball, type: sphere, center_m: [15, 9, 3], radius_m: 1.5},"
           " {name: grid, type: grid, size: [6, 6, 3], min_m: [2, 2, 0], max_m: [28, 16, 6]}]")
SCENE = ["scenes/smoke-hall.yaml", "--set", TALLIES]


def run(*words):
    return subprocess.run([MURK, "trace", *words], capture_output=True, text=True)


def must(done, code, text):
    if done.returncode != code or text not in done.stderr:
        sys.exit(f"exit {done.returncode}, must be {code}, and say \"{text}\":\n{done.stderr}")


def compare(folder, whole):
    differ = differences(folder, whole)
    if differ:
        sys.exit(f"{folder}: other files than those of an undisturbed run: {differ}")


def written(path):
    """What tells one checkpoint from the next; None: there is none."""
    return os.stat(path).st_ino if os.path.exists(path) else None


def kill_after_checkpoint(folder, words):
    """Kills a run as soon as it has written a checkpoint, which is not the one of an earlier run."""
    checkpoint = os.path.join(folder, "checkpoint.part")
    before = written(checkpoint)
    process = subprocess.Popen([MURK, "trace", *words, "--checkpoint", "1", "-o", folder, "-q"])
    while written(checkpoint) == before:
        if process.poll() is not None:
            sys.exit(f"the run ended without a checkpoint: {words}")
        time.sleep(.01)
    process.send_signal(signal.SIGKILL)
    process.wait()
    with open(checkpoint, "rb") as file:
        return file.read()


def main():
    with tempfile.TemporaryDirectory() as top:
        whole, cut = os.path.join(top, "whole"), os.path.join(top, "cut")
        for k, number in enumerate((["--emit", "2500000"], ["--store", "2000000"])):
            words = [*SCENE, *number]
            must(run(*words, "-j", "2", "-q", "-o", f"{whole}{k}"), 0, "")
            first = kill_after_checkpoint(f"{cut}{k}", [*words, "-j", "1"])
            content = kill_after_checkpoint(f"{cut}{k}", [*words, "-j", "1"])
            if len(content) <= len(first):
                sys.exit("the second checkpoint has no more photons than the first")
            must(run(*words, "-j", "3", "-o", f"{cut}{k}"), 0, "photons of an earlier run go on from here")
            compare(f"{cut}{k}", f"{whole}{k}")
        # A checkpoint of another scene, and a damaged one: not used, with a warning, and removed at the end.
        checkpoint = os.path.join(top, "other", "checkpoint.part")
        os.mkdir(os.path.dirname(checkpoint))
        small = [*SCENE, "--emit", "2000"]
        must(run(*small, "-q", "-o", f"{whole}-small"), 0, "")
        for text in (content, content[:len(content) // 2], content[:-1] + bytes([content[-1] ^ 1])):
            with open(checkpoint, "wb") as file:
                file.write(text)
            must(run(*small, "-o", os.path.dirname(checkpoint)), 0, "this checkpoint is not used")
            compare(os.path.dirname(checkpoint), f"{whole}-small")
        # A file that murk did not write.
        with open(checkpoint, "w", encoding="ascii") as file:
            file.write("mine")
        must(run(*small, "-o", os.path.dirname(checkpoint)), 2, "checkpoint.part")
        with open(checkpoint, encoding="ascii") as file:
            if file.read() != "mine":
                sys.exit("a file that murk did not write was changed")
        must(run(*small, "--force", "-q", "-o", os.path.dirname(checkpoint)), 0, "")
        compare(os.path.dirname(checkpoint), f"{whole}-small")


main()
