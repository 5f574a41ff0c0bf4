"""What tests of readers of fields share: checks that are counted, and the transmittance along lines through a
scene, as murk fit predicts it. Standard library only."""

import csv
import subprocess

failures = checks = 0


def check(holds, text):
    global failures, checks
    checks += 1
    if not holds:
        failures += 1
        if failures < 20:
            print("not so:", text)


def predicted(murk, folder, scene, lines, unit):
    """The transmittance along lines (six coordinates each) in a unit, or the error as a text."""
    path, data, out = (folder / name for name in ("scene.yaml", "lines.csv", "out"))
    path.write_text(scene)
    with open(data, "w") as to:
        print("kind,x_m,y_m,z_m,x2_m,y2_m,z2_m,unit,value,standard_error", file=to)
        for line in lines:
            print("transmittance," + ",".join(repr(x) for x in line) + f",{unit},.5,.1", file=to)
    done = subprocess.run([murk, "fit", path, "--data", data, "-o", out, "--force", "--quiet"], text=True, stderr=subprocess.PIPE)
    if done.returncode != 0:
        return done.stderr
    with open(out / "fit.csv") as table:
        return [float(row["predicted"]) for row in csv.DictReader(table)]


def finish(more=""):
    """The last line of a test, and its exit status."""
    print(f"{checks} checks, {failures} not so{more}")
    return failures > 0
