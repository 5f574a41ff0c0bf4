#!/usr/bin/env python3
"""Signals during the search of murk place: the first one ends the search with the plan so far, which is measured
and written; a second one ends the run, and nothing is written. Without signals the searches would take a minute and
more.
usage: interrupt.py MURK
"""

import json
import os
import random
import signal
import subprocess
import sys
import tempfile

TOLD = "murk: interrupted: the search ends with the best plan so far; a second interrupt ends the run\n"
ENDED = "murk: interrupted: plan and bound are those that the search had reached\n"
failures = 0


def check(holds, *what):
    global failures
    if not holds:
        failures += 1
        print("not so:", *what)


class Run:
    """murk place, which has got a signal since a line of progress of the search."""

    def __init__(self, murk, folder, arguments, number, *options):
        self.out = os.path.join(folder, "out")
        self.run = subprocess.Popen([murk, "place", *arguments, "--set", "placement.nodes=1e15", "--progress",
                                     "always", *options, "-o", self.out], stdout=subprocess.PIPE,
                                    stderr=subprocess.PIPE, text=True)
        for line in self.run.stderr:
            if line.startswith(("murk: place: ", "murk: prove: ")):
                self.run.send_signal(number)
                break
        else:
            check(False, "no search:", arguments)

    def end(self):
        """What it says afterwards, on standard output and as lines of standard error; and its exit code."""
        said, told = self.run.communicate(timeout=120)
        return said, told.splitlines(True), self.run.returncode

    def plan(self):
        with open(os.path.join(self.out, "plan.json"), encoding="utf-8") as file:
            return json.load(file)


def check_finished(run, sensors):
    """A whole plan, marked as interrupted."""
    said, told, code = run.end()
    check(code == 130, "exit", code, told)
    check(TOLD in told and told[-1] == ENDED, told)
    flat = " ".join(said.split())
    check("the search was interrupted: the plan and the bound are those reached so far" in flat, said)
    plan = run.plan()
    check(plan["placement"]["cut_by"] == "interrupt", plan["placement"])
    check(len(plan.get("sensors", plan.get("columns", []))) == sensors, plan)
    check(plan["coverage"]["in_sample"] <= plan["bound"]["upper"], plan["coverage"], plan["bound"])
    check(not [n for n in os.listdir(run.out) if "staged" in n], os.listdir(run.out))
    return plan


def main(murk):
    with tempfile.TemporaryDirectory() as folder:
        scene = os.path.join(folder, "room.yaml")
        with open(scene, "w", encoding="utf-8") as file:
            subprocess.run([murk, "init", "room"], check=True, stdout=file)
        # Views as chances make the searches long.
        long = [scene, "--emit", "4000", "--count", "14", "--set", "placement.detection=independent"]

        # Ctrl-C, and SIGTERM, with which schedulers announce the end
        plan = check_finished(Run(murk, folder, long, signal.SIGINT), 14)
        check(isinstance(plan["coverage"]["held_out"], float), plan["coverage"])
        check(os.path.exists(os.path.join(folder, "out", "sensors.csv")), "no sensors.csv")
        check_finished(Run(murk, folder, long, signal.SIGTERM), 14)

        # no other seeds
        plan = check_finished(Run(murk, folder, long, signal.SIGINT, "--repeat", "3"), 14)
        check("repeat" not in plan and not os.path.exists(os.path.join(folder, "out", "repeat.csv")), "repeated")

        # over conditions: the plans for comparison are cut, too
        over = ["--set", "conditions={thin: {}, thick: {media.fog.extinction_per_m: 0.5}}"]
        for word in "worst", "regret":
            plan = check_finished(Run(murk, folder, long + over, signal.SIGINT, "--set", "placement.over=" + word), 14)
            check(len(plan["conditions"]) == 2, plan["conditions"])

        # a second signal ends the run while the plan is measured, which the draws of jitter make long
        before = sorted(os.listdir(folder))
        for number in signal.SIGINT, signal.SIGTERM:
            run = Run(murk, folder, long, signal.SIGINT, "--set", "placement.jitter_m=0.1", "--set",
                      "placement.jitter_draws=1000000", "--force")
            run.out = os.path.join(folder, "out")
            was = run.plan()["identity"]
            for line in run.run.stderr:
                if line == TOLD:
                    run.run.send_signal(number)
                    break
            said, told, code = run.end()
            check(code == 130 and told[-1] == "murk: interrupted\n" and not said, code, told, said)
            check(run.plan()["identity"] == was and sorted(os.listdir(folder)) == before, "something was written")

        # a matrix
        table = os.path.join(folder, "matrix.csv")
        with open(table, "w", encoding="utf-8") as file:
            draw = random.Random(1)
            for _ in range(2000):
                file.write(",".join("1" if draw.random() < 0.05 else "0" for _ in range(300)) + "\n")
        os.rename(os.path.join(folder, "out"), os.path.join(folder, "before"))
        check_finished(Run(murk, folder, ["--matrix", table, "--count", "14"], signal.SIGINT), 14)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
