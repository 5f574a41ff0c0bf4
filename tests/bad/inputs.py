"""No command writes over what it or its scene reads, nor over a file of the user's.

usage: inputs.py MURK

Each case of a command that would do so ends with 2, one line, and every file of the folder as it was.
Then the rules: what murk wrote may be written again, what was edited may not without --force; an input
that would be written with the same bytes stays; a run that is killed leaves nothing for ever.
"""
import hashlib
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

SCENE = """\
# a comment of the user's
murk: 1
seed: 7
domain: {min_m: [0, 0, 0], max_m: [8, 6, 3]}
geometry: [{box: {min_m: [0, 0, 0], max_m: [8, 6, 3]}}]
materials: {default: {diffuse: 0.5}}
media: {fog: {extinction_per_m: 0.2, albedo: 0.9}}
regions: [{medium: fog}]
lights: [{type: point, position_m: [1, 1, 2.5], power_w: 10}]
photons: {emit: 300}
sensors:
  types: [{name: node, range_m: 4}]
  candidates: {grid: {min_m: [1.1, 1.1, 1.1], max_m: [7.1, 5.1, 2.1], size: [4, 3, 2]}}
  count: 2
cameras: [{name: c, from_m: [1, 3, 1.5], to_m: [7, 3, 1.5], pixels: [4, 3], vfov_deg: 60}]
"""
SENSORS = "type,x_m,y_m,z_m\nnode,2.1,2.1,1.1\nnode,5.1,3.1,1.1\n"
DATA = ("kind,x_m,y_m,z_m,x2_m,y2_m,z2_m,value,standard_error\n"
        "transmittance,1,1,1,5,1,1,0.45,0.01\ntransmittance,1,2,1,3,2,1,0.68,0.01\n")
PROFILE = "depth_m,c_per_m\n0,0.3\n1,0.4\n2,0.5\n"
STUDY = '{"murk_study": 1, "base": "%s", "axes": {"media.fog.extinction_per_m": [0.1, 0.2]}, "outputs": ["density"%s]}\n'
OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
MATRIX = "1,0,1\n0,1,1\n1,1,0\n"

murk = os.path.abspath(sys.argv[1])
failures = 0


def check(holds, *what):
    global failures
    if not holds:
        failures += 1
        print("FAILED:", *what)


def state(folder):
    """Every entry below the folder: kind, target of a link, and bytes."""
    found = {}
    for top, folders, files in os.walk(folder):
        for name in folders + files:
            path = os.path.join(top, name)
            if os.path.islink(path):
                found[path] = os.readlink(path)
            elif os.path.isfile(path):
                with open(path, "rb") as file:
                    found[path] = file.read()
            else:
                found[path] = None
    return found


class Place:
    """A folder with what users write by hand."""

    def __init__(self, **files):
        self.at = tempfile.mkdtemp(prefix="murk-inputs-")
        for name, text in {"scene.yaml": SCENE, **files}.items():
            self.write(name, text)

    def path(self, *names):
        return os.path.join(self.at, *names)

    def write(self, name, text):
        os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)

    def read(self, *names):
        with open(self.path(*names), "rb") as file:
            return file.read()

    def run(self, line, quiet=True):
        return subprocess.run([murk, *line.split(), *(["-q"] if quiet else [])], cwd=self.at,
                              capture_output=True, text=True, timeout=120, check=False)

    def well(self, line):
        done = self.run(line)
        check(done.returncode == 0, line, "ended with", done.returncode, done.stderr)
        return done

    def refused(self, line, *words):
        before = state(self.at)
        done = self.run(line)
        check(done.returncode == 2, line, "ended with", done.returncode, done.stderr)
        check(done.stderr.count("\n") == 1, line, "said", done.stderr)
        for word in words:
            check(word in done.stderr, line, "does not say", word, "but", done.stderr)
        after = state(self.at)
        check(before == after, line, "changed", [p for p in {**before, **after}
                                                 if before.get(p, 0) != after.get(p, 0)])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.at)


READ, THEIRS = "is read by this run", "not written by murk"
FREE = "--free media.fog.extinction_per_m"


def resolved_scene():
    """The user's scene.yaml stays, whatever is written beside it."""
    for line in ("trace scene.yaml -o .", "place scene.yaml -o .",
                 "sense scene.yaml --sensors given.csv -o .", "fit scene.yaml --data data.csv " + FREE + " -o ."):
        with Place(**{"given.csv": SENSORS, "data.csv": DATA}) as p:
            p.well(line)
            check(p.read("scene.yaml").decode() == SCENE, line, "changed scene.yaml")
            check(os.path.exists(p.path("scene.resolved.yaml")), line, "wrote no scene.resolved.yaml")
    with Place() as p:  # its folder under a name of the older versions is read, too
        p.well("place scene.yaml -o out")
        os.rename(p.path("out", "scene.resolved.yaml"), p.path("out", "scene.yaml"))
        p.well("report out")
        p.well("place out/scene.yaml -o out")


def inputs():
    """Whatever is read is not written over, by any path, symbolic or hard link."""
    with Place(**{"fit.csv": DATA, "coverage.csv": SENSORS, "p.csv": PROFILE, "light.obj": OBJ,
                  "m/plan.json": MATRIX, "@set": "media.fog.albedo: 0.8\n"}) as p:
        for also in ("", " --force"):
            p.refused("fit scene.yaml --data fit.csv " + FREE + " -o ." + also, "fit.csv", READ)
            p.refused("sense scene.yaml --sensors coverage.csv -o ." + also, "coverage.csv", READ)
            p.refused("media --profile p.csv -o p.csv" + also, "p.csv", READ)
            p.refused("render scene.yaml --method path --samples 2 -o scene.yaml" + also, "scene.yaml", READ)
            p.refused("place --matrix m/plan.json --count 1 -o m" + also, "plan.json", READ)
    with Place(**{"st/scene.yaml": SCENE, "st/study.json": STUDY % ("scene.yaml", "")}) as p:
        p.refused("study st/study.json -o st", "study.json", READ)
        p.write("st/table.csv", SENSORS)
        p.write("st/study.json", STUDY.replace('"outputs"', '"plan": "table.csv", "outputs"')
                % ("scene.yaml", ', "coverage_fixed"'))
        os.rename(p.path("st", "study.json"), p.path("st", "my.json"))
        p.refused("study st/my.json -o st", "table.csv", READ)
        p.write("st/my.json", STUDY % ("scene.resolved.yaml", ""))
        os.rename(p.path("st", "scene.yaml"), p.path("st", "scene.resolved.yaml"))
        p.refused("study st/my.json -o st --force", "scene.resolved.yaml", READ)
    with Place() as p:
        p.well("trace scene.yaml -o .")
        p.refused("report . -o ledger.json", "ledger.json", READ)
        p.refused("report . -o ledger.json --force", "ledger.json", READ)
        p.well("place scene.yaml -o .")
        p.refused("report . -o plan.json", "plan.json", READ)
        p.refused("report . -o light.murk", "light.murk")
    with Place(**{"values.yaml": "media.fog.albedo: 0.8\n", "here/x": ""}) as p:
        links = (("s", "scene.yaml", "trace scene.yaml -o s", "ledger.json"),
                 ("v", "values.yaml", "trace scene.yaml --set @values.yaml -o v", "light.murk"))
        for make in (os.symlink, os.link):
            for folder, of, line, name in links:
                os.makedirs(p.path(folder))
                make(p.path(of), p.path(folder, name))
                p.refused(line + " --force", name, READ)
                shutil.rmtree(p.path(folder))
        os.symlink(p.at, p.path("here", "there"))  # and where the folder is a link
        p.write("fit.csv", DATA)
        p.refused("fit scene.yaml --data fit.csv " + FREE + " -o here/there --force", "fit.csv", READ)
        p.refused("render scene.yaml --method path --samples 2 --force -o here/there/scene.yaml", READ)
    # what the scene names, and what these files name
    with Place(**{"a.obj": "mtllib surfaces.ply\n" + OBJ, "surfaces.ply": "newmtl x\n", "plan.ply": OBJ,
                  "sites.csv": "x_m,y_m,z_m\n2,2,1\n5,3,1\n4,4,1\n"}) as p:
        with open(p.path("scene.yaml"), encoding="utf-8") as file:
            text = file.read()
        p.write("mesh.yaml", text.replace("geometry: [", "geometry: [{file: a.obj}, "))
        p.refused("trace mesh.yaml --export surfaces -o . --force", "surfaces.ply", READ)
        os.rename(p.path("sites.csv"), p.path("sensors.csv"))
        p.write("sites.yaml", text.replace(
            "{grid: {min_m: [1.1, 1.1, 1.1], max_m: [7.1, 5.1, 2.1], size: [4, 3, 2]}}",
            "{points: sensors.csv}"))
        p.refused("place sites.yaml -o . --force", "sensors.csv", READ)


def same_bytes():
    """An input of murk's own that would be written with the same bytes stays."""
    with Place() as p:
        p.well("place scene.yaml -o out")
        before = os.stat(p.path("out", "light.murk"))
        plan = p.read("out", "sensors.csv")
        p.well("place scene.yaml --light out/light.murk -o out")
        after = os.stat(p.path("out", "light.murk"))
        check((before.st_ino, before.st_mtime_ns) == (after.st_ino, after.st_mtime_ns), "light.murk was replaced")
        check(p.read("out", "sensors.csv") == plan, "another plan")
        p.well("sense scene.yaml --sensors out/sensors.csv -o out")
        check(p.read("out", "sensors.csv") == plan, "sense changed sensors.csv")
        p.well("place out/scene.resolved.yaml -o out")
        p.refused("place out/scene.resolved.yaml --set media.fog.albedo=.5 -o out", "scene.resolved.yaml", READ)


def frames():
    """Between two frames of a sequence of grids, the next one is read, too."""
    sequence = SCENE.replace("{extinction_per_m: 0.2,", '{vdb: "f#.vdb", frame: 1.5, extinction_per_m: 0.2,')
    tally = "tallies: [{name: f2, type: grid, min_m: [1, 1, 1], max_m: [3, 3, 2], size: [2, 2, 1]}]\n"
    with Place(**{"scene.yaml": sequence + tally, "p.csv": PROFILE}) as p:
        for name in ("f1.vdb", "f2.vdb"):
            p.well("media --profile p.csv -o " + name)
        p.refused("trace scene.yaml -o .", "f2.vdb", READ)
        p.refused("trace scene.yaml -o . --force", "f2.vdb", READ)
        p.well("trace scene.yaml --set media.fog.frame=1 -o . --force")  # f2.vdb is not read


def owners():
    """What murk wrote may be written again; what was edited, or is another's, may not."""
    with Place(**{"out/sensors.csv": SENSORS}) as p:
        p.refused("place scene.yaml -o out", "sensors.csv", THEIRS, "--force")
        p.well("place scene.yaml -o out --force")
        p.well("place scene.yaml -o out --seed 8")
        p.write("out/coverage.csv", SENSORS)
        p.refused("place scene.yaml -o out", "coverage.csv", THEIRS)
        p.well("place scene.yaml -o out --force")
        text = p.read("out", "plan.json").decode()
        p.write("out/plan.json", text.replace('"seed": 7', '"seed": 9'))
        p.refused("place scene.yaml -o out", "plan.json", THEIRS)
        p.write("out/plan.json", text)
        p.well("place scene.yaml -o out")
        os.unlink(p.path("out", "plan.ply"))  # another's link
        os.symlink("nowhere", p.path("out", "plan.ply"))
        p.refused("place scene.yaml -o out", "plan.ply", THEIRS)
    # before the work begins, which would take hours here: the files of --export, too
    grid = "tallies: [{name: cells, type: grid, min_m: [1, 1, 1], max_m: [3, 3, 2], size: [2, 2, 1]}]\n"
    for name in ("cells.vdb", "cells_error.vdb", "cells_photons.vdb", "cells.vti", "fields.vti"):
        with Place(**{"grid.yaml": SCENE + grid, "out/" + name: "my own"}) as p:
            p.refused("trace grid.yaml --emit 4000000000 --export fields -o out", name, THEIRS)
    over = "conditions: {thin: {media.fog.extinction_per_m: 0.1}, dense: {media.fog.extinction_per_m: 0.4}}\n"
    with Place(**{"over.yaml": SCENE + over, "out/scene-thin.yaml": SCENE}) as p:
        p.refused("place over.yaml --set placement.over=mean -o out", "scene-thin.yaml", THEIRS)
        os.unlink(p.path("out", "scene-thin.yaml"))
        p.well("place over.yaml --set placement.over=mean -o out")
        p.well("place over.yaml --set placement.over=worst -o out")
    with Place() as p:  # of a version that wrote no identity: murk's as a whole
        p.well("trace scene.yaml -o out")
        main = json.loads(p.read("out", "ledger.json"))
        for key in ("identity", "files"):
            del main[key]
        del main["run"]["checksum"]
        p.write("out/ledger.json", json.dumps(main))
        p.write("out/light.murk", "any")
        p.well("trace scene.yaml -o out")
        p.write("out/ledger.json", "{}")
        p.refused("trace scene.yaml -o out", THEIRS)
    # files that stand alone say in themselves who wrote them
    with Place(**{"p.csv": PROFILE, "mine.exr": "x", "mine.png": "x", "mine.html": "x", "mine.vdb": "x"}) as p:
        p.well("trace scene.yaml -o out")
        picture = "render scene.yaml --method path --samples 2 --png -o "
        for line, name in ((picture + "mine.exr", "mine.exr"), (picture + "other.exr", "other.png"),
                           ("report out -o mine.html", "mine.html"),
                           ("media --profile p.csv -o mine.vdb", "mine.vdb")):
            p.write("other.png", "x")
            p.refused(line, name, THEIRS)
            p.well(line + " --force")
            p.well(line)
    with Place(**{"study.yaml": STUDY % ("scene.yaml", ', "fluence_vdb"'), "st/fluence_0002.vdb": "x"}) as p:
        done = p.run("study study.yaml -o st")
        check(done.returncode == 2 and "fluence_0002.vdb" in done.stderr, "a grid of another's:", done.stderr)
        check(p.read("st", "fluence_0002.vdb") == b"x", "a grid of another's was replaced")
        p.well("study study.yaml -o st --force")
        p.well("study study.yaml -o st")
        listed = json.loads(p.read("st", "study.json"))["files"]
        check(sorted(listed) == ["fluence_0001.vdb", "fluence_0002.vdb", "scene.resolved.yaml", "table.csv"], listed)
        os.unlink(p.path("st", "study.json"))  # as a study that was stopped leaves it
        os.unlink(p.path("st", "table.csv"))
        os.unlink(p.path("st", "scene.resolved.yaml"))
        shutil.rmtree(p.path("st", "rows"))
        p.well("study study.yaml -o st")


def says_whose():
    """The main JSON has identity and files; a folder of two runs is named."""
    with Place() as p:
        p.well("place scene.yaml -o a -j1")
        p.well("place scene.yaml -o b -j2 --light a/light.murk")
        p.well("place scene.yaml -o c --seed 8")
        of = {name: json.loads(p.read(name, "plan.json")) for name in "abc"}
        for name, plan in of.items():
            check(plan["identity"] == json.loads(p.read(name, "ledger.json"))["identity"], "two identities in", name)
            check(sorted(list(plan["files"]) + ["plan.json", "ledger.json"]) == sorted(os.listdir(p.path(name))), plan["files"])
            for file, sum_ in plan["files"].items():
                check(hashlib.sha256(p.read(name, file)).hexdigest() == sum_, name, file)
        check(of["a"]["identity"] == of["b"]["identity"] != of["c"]["identity"], "identity")
        shutil.copy(p.path("c", "light.murk"), p.path("a", "light.murk"))
        done = p.run("report a", quiet=False)
        check(done.returncode == 0 and "light.murk" in done.stderr, "report is silent:", done.stderr)
        check("Not as the run of this page wrote them: light.murk." in p.read("a", "report.html").decode(), "page is silent")
        done = p.run("place scene.yaml --seed 8 --light a/light.murk", quiet=False)
        check(done.returncode == 0 and "of another run" in done.stderr, "--light is silent:", done.stderr)
        # whatever file is another run's, report and tools/view name it
        whole = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tools", "viewers", "whole.py")
        p.well("place scene.yaml -o a --force")
        for file in sorted(set(os.listdir(p.path("c"))) - {"plan.json", "report.html"}):
            if p.read("a", file) == p.read("c", file):
                continue
            shutil.copytree(p.path("a"), p.path("mixed"))
            shutil.copy(p.path("c", file), p.path("mixed", file))
            done = p.run("report mixed", quiet=False)
            check(file in done.stderr, "report is silent on", file, done.stderr)
            seen = subprocess.run([sys.executable, "-B", whole, p.path("mixed")], capture_output=True, text=True)
            check(seen.returncode == 1 and seen.stdout.startswith(file + ":"), "tools/view is silent on", file, seen.stdout)
            shutil.rmtree(p.path("mixed"))
        for line in ("place", "sense --sensors a/sensors.csv", "render --pixels 4x3 -o x.exr"):
            shutil.copy(p.path("c", "light.murk"), p.path("a", "light.murk"))
            done = p.run(line + " scene.yaml --seed 8 --light a/light.murk", quiet=False)
            check(done.returncode == 0 and "of another run" in done.stderr, line, "--light is silent:", done.stderr)
        seen = subprocess.run([sys.executable, "-B", whole, p.path("c")], capture_output=True, text=True)
        check(seen.returncode == 0 and not seen.stdout, "a whole folder:", seen.stdout)
        done = p.run("report c", quiet=False)
        check(done.returncode == 0 and not done.stderr, "report of a whole folder:", done.stderr)


def earlier_runs():
    """A file that a later run does not write again stays murk's, and is named as of an earlier run."""
    tally = "--set tallies=[{'name':'p','type':'sphere','center_m':[2,4,1],'radius_m':.3}]"
    with Place() as p:
        for first, second, file in ((f"trace scene.yaml {tally} -o out", "trace scene.yaml --seed 9 -o out", "tallies.csv"),
                                    ("place scene.yaml --export photons -o out", "place scene.yaml -o out", "photons.ply"),
                                    ("place scene.yaml --repeat 2 -o out", "place scene.yaml -o out", "repeat.csv")):
            main = "ledger.json" if first.startswith("trace") else "plan.json"
            p.well(first)
            p.well(second)
            check(file in json.loads(p.read("out", main))["run"].get("earlier", {}), file, "is not listed as earlier")
            check(file in p.run("report out", quiet=False).stderr, "report is silent on", file)
            p.well(second)  # the list goes on from run to run
            p.well(first)
            check("earlier" not in json.loads(p.read("out", main))["run"] or
                  file not in json.loads(p.read("out", main))["run"]["earlier"], file, "is of this run")
            p.well(second)
            p.write("out/" + file, "mine\n")
            check(p.run(first).returncode == 2 and p.read("out", file) == b"mine\n", "an edited", file, "is replaced")
            os.remove(p.path("out", file))
        # results beside others: what another main JSON lists is no earlier run's
        p.write("s.csv", SENSORS)
        p.well("sense scene.yaml --sensors s.csv -o out")
        check("earlier" not in json.loads(p.read("out", "coverage.json"))["run"], "sense beside place")
        # a JSON that is not murk's, or of an older version, gives away nothing of a newer run
        p.write("out/predict.json", '{"murk": {"version": "0.1.0"}}')
        p.write("out/sensors.csv", "mine\n")
        check(p.run("place scene.yaml -o out").returncode == 2, "an old JSON gives away an edited file")


def every_command():
    """The JSON that each command prints has identity and files, the same for any typing."""
    with Place(**{"data.csv": DATA, "sensors.csv": SENSORS, "p.csv": PROFILE,
                  "study.yaml": STUDY % ("scene.yaml", "")}) as p:
        p.well("trace scene.yaml -o out")
        for line in ("check scene.yaml", "trace scene.yaml", "place scene.yaml", "sense scene.yaml --sensors sensors.csv",
                     "render scene.yaml --method path --samples 2 -o x.exr", "study study.yaml",
                     "fit scene.yaml --data data.csv " + FREE, "report out", "replay scene.yaml --photon 3", "media",
                     "media fog/kruse", "media --profile p.csv -o p.vdb"):
            found = [json.loads(p.well(line + " --format json" + also).stdout) for also in ("", " -j1")]
            check(len(found[0]["identity"]) == 64 and isinstance(found[0]["files"], dict), line)
            check(found[0]["identity"] == found[1]["identity"], line, "has two identities")
        one, two = (json.loads(p.well("trace scene.yaml --format json" + also).stdout)["identity"]
                    for also in (" --set seed=7", " --seed 8"))
        check(one != two, "two seeds with one identity")


def killed(times):
    """Wherever a run is killed, nothing of it stays for ever, and the next one runs."""
    with Place() as p:
        line = "place scene.yaml --emit 3000 -q -o out --seed "
        begun = time.monotonic()
        p.well(line + "1")
        took = time.monotonic() - begun
        dice = random.Random(1)
        for i in range(times):
            run = subprocess.Popen([murk, *(line + str(i)).split()], cwd=p.at, stderr=subprocess.DEVNULL)
            time.sleep(took * (.3 + .7 * dice.random()))
            run.send_signal(signal.SIGKILL)
            run.wait()
        p.write("out/.light.murk.staged.999999999", "of an older version")
        p.well(line + "7")
        left = [n for n in os.listdir(p.path("out")) if n.startswith(".")]
        check(not left, "left behind:", left)
        for file, sum_ in json.loads(p.read("out", "plan.json"))["files"].items():
            check(hashlib.sha256(p.read("out", file)).hexdigest() == sum_, "after kills:", file)


resolved_scene()
inputs()
same_bytes()
frames()
owners()
says_whose()
earlier_runs()
every_command()
killed(12)
print("inputs:", failures, "failures" if failures else "no failure")
sys.exit(failures > 0)
