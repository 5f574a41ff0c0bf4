"""murk-mpi: result files do not depend on ranks and threads, and failures of ranks end all.

    ranks.py MURK MURK_MPI MPIRUN [nightly]

Each command runs once as the plain program and then in several ranks; every result file has the same bytes (JSON: all
values but `run`). Faults: wrong input, a full disk, killed ranks in each phase, signals to mpirun: the exit code is not
0, murk prints one line at most, old results stay as they are, and no process is left. More ranks than processors are
started, so all runs are small; `nightly` runs larger ones in more combinations.
"""
import glob
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time

MURK, MURK_MPI, MPIRUN = sys.argv[1:4]
sys.path.append(os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "same"))
from repeat_shards import SMALL, scene_in  # noqa: E402
from run_files import files, files_of_steps  # noqa: E402

IS_NIGHTLY = "nightly" in sys.argv[4:]
SIZE = 10 if IS_NIGHTLY else 1  # factor of the numbers of photons
TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
# Containers run tests as root, and on fewer processors than ranks.
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_mpi_yield_when_idle": "1"}
END_S = 20  # until the processes of a run that has ended are gone; mpirun itself waits some seconds
RUN_S = 600
WRITTEN = 600000  # photons whose light takes some seconds to trace, and some time to write

# (ranks, threads of each)
ALL = [(1, 2), (2, 1), (2, 2), (3, 1), (4, 1), (5, 1), (8, 1)]
SOME = ALL if IS_NIGHTLY else [(3, 1), (2, 2)]
ONE = ALL if IS_NIGHTLY else [(3, 1)]

ROOM = """murk: 1
bands_nm: [500, 600]
seed: 3
domain: {min_m: [0, 0, 0], max_m: [6, 4, 3]}
geometry:
  - {rect: {corner_m: [0.1, 0.1, 0.1], edge1_m: [5.8, 0, 0], edge2_m: [0, 3.8, 0]}, material: wall}
  - {rect: {corner_m: [3, 0.1, 0.1], edge1_m: [0, 2, 0], edge2_m: [0, 0, 2]}, material: wall}
materials: {wall: {diffuse: 0.5}}
media: {fog: {extinction_per_m: 0.4, albedo: 0.9, phase: {hg: 0.7}}}
regions: [{medium: fog}]
lights:
  - {type: point, position_m: [1, 1, 2.5], power_w: [6, 2]}
  - {type: point, position_m: [5, 3, 2], power_w: [0, 2]}
tallies:
  - {name: plane, type: plane, point_m: [0, 0, 1.5], normal: [0, 0, 1], angle_bins: 3}
  - {name: ball, type: sphere, center_m: [2, 2, 1], radius_m: 0.5}
  - {name: grid, type: grid, min_m: [0, 0, 0], max_m: [6, 4, 3], size: [6, 4, 3]}
photons: {store: 9000}
sensors:
  types: [{name: node, range_m: 4}]
  candidates: {grid: {min_m: [0.5, 0.5, 0.5], max_m: [5.5, 3.5, 2.5], size: [6, 4, 3]}}
  count: 3
conditions:
  thin: {media.fog.extinction_per_m: 0.1}
  thick: {media.fog.extinction_per_m: 0.8}
cameras: [{name: c, from_m: [0.5, 0.5, 1.7], to_m: [5, 3, 1], vfov_deg: 60, pixels: [40, 26], samples: 4}]
"""
STUDY = """murk_study: 1
base: room.yaml
axes:
  media.fog.extinction_per_m: [0.2, 0.4]
  photons.emit: [3000, 1] # 1 is refused
outputs: [density, coverage_best]
"""
failures = 0


def check(holds, *what):
    global failures
    if not holds:
        failures += 1
        print("failed:", *what, flush=True)


# ---- the same results ----

def command(ranks, *words):
    return [MPIRUN, "-q", "-n", str(ranks), MURK_MPI, *words]


def run(words):
    return subprocess.run(words, cwd=TOP, env=ENVIRONMENT, capture_output=True, text=True, timeout=RUN_S, check=False)


def done(words, code=0):
    ran = run(words)
    check(ran.returncode == code, " ".join(words), ran.returncode, ran.stderr)
    return ran


def same(folder, name, words, splits, out="out", code=0):
    """The results of the plain program, and of ranks x threads. out: the name of the folder, or of the file, to
    write; code: the exit code."""
    whole = os.path.join(folder, name, "plain")
    os.makedirs(whole)
    begin = time.time()
    alone = done([MURK, *words, "-j", "2", "-q", "-o", os.path.join(whole, out)], code)
    kept = files(whole)
    check(kept, name, "writes nothing")
    for ranks, threads in splits:
        split = os.path.join(folder, name, f"{ranks}x{threads}")
        os.makedirs(split)
        ran = done(command(ranks, *words, "-j", str(threads), "-q", "-o", os.path.join(split, out)), code)
        got = files(split)
        check(sorted(got) == sorted(kept), name, ranks, threads, sorted(got), sorted(kept))
        differ = [path for path in kept if got.get(path) != kept[path]]
        check(not differ, f"{name}, {ranks} ranks, {threads} threads: these differ: {differ}")
        check(ran.stderr.replace(split, "") == alone.stderr.replace(whole, ""), name, ran.stderr, alone.stderr)
    print(f"{name}: {len(kept)} files, {len(splits)} splits, {time.time() - begin:.0f} s", flush=True)


def results_are_the_same(folder, room, study):
    def emit(n):
        return ["--emit", str(n * SIZE)]

    def place(value):
        return ["--set", f"placement={{{value}}}"]

    same(folder, "trace by store", ["trace", room, "--store", str(40000 * SIZE), "--export", "photons,surfaces"], ALL)
    same(folder, "trace by emit", ["trace", room, *emit(9500)], SOME)
    same(folder, "trace of a grid", ["trace", "scenes/smoke-hall.yaml", *emit(4500)], ONE)
    same(folder, "place best", ["place", room, *emit(1500)], ALL)
    same(folder, "place with exports", ["place", room, "--export", "matrix,lp,fields"], ONE)
    same(folder, "place unknown", ["place", room, *place("knowledge: unknown")], SOME)
    same(folder, "place unknown without memory", ["place", room, *place("knowledge: unknown, memory_mb: 0, restarts: 2")], ONE)
    same(folder, "place greedy", ["place", room, *place("method: greedy")], ONE)
    same(folder, "place spoq", ["place", room, *place("method: spoq, restarts: 3")], ONE)
    same(folder, "place exact", ["place", room, *emit(1500), *place("method: exact"), "--count", "2"], ONE)
    same(folder, "place at least two", ["place", room, *place("at_least: 2")], ONE)
    same(folder, "place by memory", ["place", room, *place("memory_mb: 0")], ONE)
    for over in ("mean", "worst", "regret"):
        same(folder, f"place over {over}", ["place", room, *emit(3000), *place(f"over: {over}")], ONE)
    same(folder, "place the target", ["place", room, *place("detection: independent"), "--target", "0.5"], ONE)
    same(folder, "place in a flat", ["place", "scenes/paper-room.yaml", "--store", str(1500 * SIZE)], ONE)
    # Pairs of candidates and photons enough for ranks to keep their own rows.
    many = ["place", room, *emit(2400), "--set", "sensors.candidates.grid.size=[30, 24, 15]"]
    same(folder, "many: best", [*many], SOME)
    for name, value in (("greedy", "method: greedy"), ("spoq", "method: spoq, restarts: 2"),
                        ("at least two", "at_least: 2"), ("by memory", "memory_mb: 20"), ("worst", "over: worst, "
                        "method: greedy")):
        same(folder, f"many: {name}", [*many, *place(value)], ONE)
    same(folder, "many: compared in pairs", ["place", room, *emit(4000), "--set",
                                             "sensors.candidates.grid.size=[24, 20, 12]"], ONE)
    same(folder, "many: the target", [*many, *place("detection: independent, method: greedy"), "--target", "0.3"], ONE)
    same(folder, "place repeated", ["place", room, *emit(3000), "--repeat", "4"], SOME)
    # Seed 11 misses the target.
    seed = ["--target", "0.59", "--seed", "9", "--repeat", "5"]
    same(folder, "place with a seed that fails", ["place", scene_in(folder, SMALL), *seed], SOME, code=2)
    parts = [os.path.join(folder, f"part-{k}") for k in (1, 3)]
    for part in parts:
        done([MURK, "trace", room, *emit(9500), "--shard", f"{part[-1]}/3", "-q", "-o", part])
    same(folder, "merge of two parts of three", ["merge", *parts], SOME)
    same(folder, "render by maps", ["render", room, *emit(5000)], SOME, "c.exr")
    same(folder, "render by paths", ["render", room, "--method", "path"], SOME, "c.exr")
    same(folder, "study", ["study", study], ONE, code=1)
    same(folder, "fit", ["fit", "scenes/calibrate-fog.yaml", "--data", "scenes/calibrate/fog.csv", *emit(3000),
                         "--starts", "4", "--free", "media.fog.extinction_per_m"], SOME)
    # Contributions enough for ranks to divide their evaluation; as many photons as records need; a world that moves.
    one = ["--starts", "1"]
    same(folder, "fit to coverage", ["fit", "scenes/calibrate-coverage.yaml", "--data", "scenes/calibrate/coverage.csv",
                                     "--free", "media.fog.visibility_m", *emit(12000), *one], SOME)
    same(folder, "fit by store", ["fit", "scenes/calibrate-coverage.yaml", "--data", "scenes/calibrate/coverage.csv",
                                  "--free", "media.fog.visibility_m", "--store", str(20000 * SIZE), *one], ONE)
    same(folder, "fit to receivers", ["fit", "scenes/calibrate-fog.yaml", "--data", "scenes/calibrate/fog.csv",
                                      *emit(100000), "--free", "media.fog.extinction_per_m", *one], ONE)
    same(folder, "fit of a place", ["fit", "scenes/calibrate-fog.yaml", "--data", "scenes/calibrate/fog.csv",
                                    *emit(3000), "--free", "lights.0.origin_m.1", *one], ONE)


# Steps of which one fails, and of which one is dark.
TIMELINE = """\
timeline:
  from_s: 0
  to_s: 80
  every_s: 10
  tracks:
    - {key: geometry.1.rect.corner_m, keyframes: [{t_s: 0, value: [3, 0.1, 0.1]}, {t_s: 80, value: [2, 0.1, 0.1]}]}
    - {key: lights.0.power_w, between: hold, keyframes: [{t_s: 0, value: [6, 2]}, {t_s: 40, value: [0, 0]}]}
    - {key: lights.1.power_w, between: hold, keyframes: [{t_s: 0, value: [0, 2]}, {t_s: 50, value: [0, 0]},
                                                         {t_s: 60, value: [0, 2]}]}
    - {key: media.fog.albedo, between: hold, keyframes: [{t_s: 0, value: 0.9}, {t_s: 70, value: 3}, {t_s: 80, value: 0.9}]}
    - {sensor: 1, fails_at_s: 60}
    - {sensor: 2, keyframes: [{t_s: 0, offset_m: [0, 0, 0]}, {t_s: 80, offset_m: [0.2, 0.1, 0]}]}
"""
START = "type,x_m,y_m,z_m\nnode,0.5,0.5,0.5\nnode,5.5,3.5,2.5\nnode,2.5,1.5,0.5\n"


def write_timeline(folder):
    """A scene with a timeline, and a plan to start from."""
    scene, start = os.path.join(folder, "steps.yaml"), os.path.join(folder, "start.csv")
    with open(scene, "w", encoding="utf-8") as file:
        file.write(ROOM[:ROOM.index("conditions:")] + ROOM[ROOM.index("cameras:"):] + TIMELINE)
    with open(start, "w", encoding="utf-8") as file:
        file.write(START)
    return scene, start


def steps_are_the_same(folder):
    """murk follow: steps that are dealt to ranks, and steps that rank 0 makes alone. All runs write to the same folder,
    whose path is in the scenes of steps."""
    scene, start = write_timeline(folder)
    out, whole = os.path.join(folder, "follow"), os.path.join(folder, "follow-plain")
    emit = ["--emit", str(1500 * SIZE)]
    own = ["--set", "timeline.search_from=start_plan"]
    for name, words, splits in (("with a start", [*own, "--start", start], [(2, 1), (3, 1)]),
                                ("greedy", ["--set", "placement.method=greedy", "--export", "light"], [(3, 2)]),
                                ("one after the other", [], [(2, 1)])):
        words = ["follow", scene, *emit, *words, "-o", out]
        done([MURK, *words, "-j", "2"], 1)
        shutil.rmtree(whole, ignore_errors=True)
        os.rename(out, whole)
        kept = files_of_steps(whole)
        check(sum(path.endswith("plan.json") for path in kept) == 8, name, sorted(kept))
        for ranks, threads in splits:
            ran = done(command(ranks, *words, "-j", str(threads)), 1)
            got = files_of_steps(out)
            differ = sorted(path for path in {**kept, **got} if kept.get(path) != got.get(path))
            check(not differ, f"follow {name}, {ranks} ranks: these differ: {differ}")
            check("1 of 9 steps failed" in ran.stderr, name, ran.stderr)
            check(("rank 0 makes the steps alone" in ran.stderr) == (name == "one after the other"), name, ran.stderr)
            if (ranks, threads) != splits[-1]:
                shutil.rmtree(out)
        if name == "with a start":
            goes_on_after_a_kill(out, words, kept)
        shutil.rmtree(out)
    # Ranks that see another file at the path of the start.
    words = [MPIRUN, "-q"]
    for k in (1, 2):
        at = os.path.join(folder, f"start-{k}")
        os.mkdir(at)
        with open(os.path.join(at, "start.csv"), "w", encoding="utf-8") as file:
            file.write(START.replace("2.5,1.5,0.5", f"2.5,1.5,{k}.5"))
        words += ["-n", "1", "--wdir", at, MURK_MPI, "follow", scene, *own, "--start", "start.csv", "-o", out, ":"]
    ran = run(words[:-1])
    check_ended("other starts", out, ran.returncode, ran.stderr)
    check("rank 1 has another file that the scene names than rank 0" in ran.stderr, ran.stderr)


def goes_on_after_a_kill(out, words, kept):
    """A rank is killed when the first step is there; the steps that are done stay, and the same command goes on."""
    shutil.rmtree(out)
    with tempfile.TemporaryFile() as told:
        process = subprocess.Popen(command(3, *words, "-j", "1", "-q"), cwd=TOP, env=ENVIRONMENT, stdout=told, stderr=told)
        end = time.time() + RUN_S / 4
        while not glob.glob(os.path.join(out, "steps/*/plan.json")) and process.poll() is None and time.time() < end:
            time.sleep(0.005)
        rank = dict(processes(out)).get(1)
        if rank:
            os.kill(rank, signal.SIGKILL)
        code = process.wait(timeout=RUN_S)
        check_ended("follow, rank 1 killed", out, code, os.pread(told.fileno(), 1 << 20, 0).decode())
    check(not rank or not os.path.exists(os.path.join(out, "follow.json")), "tables of a run that was killed")
    done(command(2, *words, "-j", "1"), 1)
    got = files_of_steps(out)
    differ = sorted(path for path in {**kept, **got} if kept.get(path) != got.get(path))
    check(not differ, "follow after a kill: these differ:", differ)


def another_seed_differs(folder, room):
    """A comparison that finds no difference of seeds would find none of ranks."""
    out = os.path.join(folder, "seed")
    for seed in "1", "2":
        done(command(2, "trace", room, "-q", "-j", "1", "--emit", "2000", "--seed", seed, "-o", os.path.join(out, seed)))
    one, two = (files(os.path.join(out, seed)) for seed in "12")
    check(sorted(one) == sorted(two) and one["light.murk"] != two["light.murk"], "seeds give the same light")


# ---- faults ----

def processes(path):
    """The processes of ranks that write to this path: (number of the rank, process)."""
    found = []
    for name in glob.glob("/proc/[0-9]*"):
        try:
            with open(os.path.join(name, "cmdline"), "rb") as file:
                words = file.read().decode().split("\0")
            with open(os.path.join(name, "environ"), "rb") as file:
                environ = dict(pair.split("=", 1) for pair in file.read().decode().split("\0") if "=" in pair)
        except (OSError, UnicodeDecodeError):
            continue
        if words[0] == MURK_MPI and path in words and "OMPI_COMM_WORLD_RANK" in environ:
            found.append((int(environ["OMPI_COMM_WORLD_RANK"]), int(os.path.basename(name))))
    return sorted(found)


def check_ended(what, path, code, told, codes=None):
    """The exit code, one line of murk at most, and no process."""
    check(code != 0 and (codes is None or code in codes), what, "exit", code, told)
    lines = [line for line in told.splitlines() if line.startswith("murk")]
    check(len(lines) <= 1, what, "more than one line:", told)
    end = time.time() + END_S
    while processes(path) and time.time() < end:
        time.sleep(0.1)
    left = processes(path)
    check(not left, what, "processes are left:", left)
    for _, process in left:
        os.kill(process, signal.SIGKILL)


def listing(folder):
    """Names and bytes of all files but staged ones, which the next run removes."""
    found = {}
    for at, folders, names in os.walk(folder):
        folders[:] = [name for name in folders if "staged" not in name]
        for name in names:
            if "staged" not in name:
                with open(os.path.join(at, name), "rb") as file:
                    found[os.path.relpath(os.path.join(at, name), folder)] = file.read()
    return found


def refused(folder, room):
    """Input that is refused: the exit code of the plain program, and its line, once."""
    taken = os.path.join(folder, "taken")
    with open(taken, "w", encoding="utf-8") as file:
        file.write("a file")
    for words in (["trace", room, "--nonsense"], ["trace", os.path.join(folder, "nowhere.yaml")],
                  ["trace", room, "--emit", "1000", "-o", os.path.join(taken, "folder")],
                  ["place", room, "--count", "9999"], ["trace", room, "--set", "photons.emit=1"]):
        alone = run([MURK, *words])
        ran = run(command(3, *words))
        check(alone.returncode > 0 and ran.returncode == alone.returncode, words, ran.returncode, alone.returncode)
        check(ran.stderr == alone.stderr, words, ran.stderr, alone.stderr)


def mixed(folder, room):
    """Ranks with other options, or with another scene at the same path, are told in one line, and --shard is refused."""
    others = [MPIRUN, "-q", "-n", "2", MURK_MPI, "trace", room, "--emit", "3000", ":",
              "-n", "1", MURK_MPI, "trace", room, "--emit", "4000"]
    ran = run(others)
    check_ended("other options", room, ran.returncode, ran.stderr)
    check("rank 2 has another build of murk, or other options, than rank 0" in ran.stderr, ran.stderr)
    words = [MPIRUN, "-q"]
    for seed in "3", "4":
        at = os.path.join(folder, f"scene-{seed}")
        os.mkdir(at)
        with open(os.path.join(at, "room.yaml"), "w", encoding="ascii") as file:
            file.write(ROOM.replace("seed: 3", f"seed: {seed}"))
        words += ["-n", "1", "--wdir", at, MURK_MPI, "trace", "room.yaml", ":"]
    ran = run(words[:-1])
    check_ended("other scenes", "room.yaml", ran.returncode, ran.stderr)
    check("rank 1 has another scene than rank 0" in ran.stderr, ran.stderr)
    ran = run(command(3, "trace", room, "--shard", "1/2", "-o", os.path.join(folder, "shard")))
    check_ended("--shard", room, ran.returncode, ran.stderr, [2])
    check("--shard: not with several ranks" in ran.stderr, ran.stderr)
    check(not os.path.exists(os.path.join(folder, "shard")), "a refused part is begun")


def full_disk(folder, room):
    """A limit on the size of files stops rank 0, which writes; old results stay."""
    out = os.path.join(folder, "full")
    done([MURK, "trace", room, "--emit", "1500", "-q", "-o", out])
    before = listing(out)
    # Shared memory of MPI would be limited, too: ranks talk by TCP; and so would be shared records: a tally is large.
    words = [MPIRUN, "-q", "--mca", "btl", "self,tcp", "-n", "3", "sh", "-c", 'ulimit -f 64; exec "$@"', "sh", MURK_MPI,
             "trace", room, "--set", "photons={emit: 1500, maps: none}", "--set", "tallies=[{name: grid, type: grid, "
             "min_m: [0, 0, 0], max_m: [6, 4, 3], size: [60, 40, 30]}]", "-j", "1", "-q", "-o", out]
    ran = run(words)
    check_ended("full disk", out, ran.returncode, ran.stderr, [1])
    check("cannot write" in ran.stderr, ran.stderr)
    check(listing(out) == before, "full disk: old results have changed")


class Long:
    """A run of three ranks over old results, with lines of progress."""

    def __init__(self, out, words):
        self.out = out
        self.before = listing(out)
        words = command(3, *words, "-j", "1", "--progress", "always", "-o", out)
        # A file takes what is printed, so that no process waits for a reader.
        self.told = tempfile.TemporaryFile()
        self.process = subprocess.Popen(words, cwd=TOP, env=ENVIRONMENT, stdout=subprocess.DEVNULL, stderr=self.told)

    def text(self):
        return os.pread(self.told.fileno(), 1 << 20, 0).decode()

    def wait_until(self, is_there):
        end = time.time() + RUN_S / 4
        while not is_there() and self.process.poll() is None and time.time() < end:
            time.sleep(0.005)
        return is_there()

    def send(self, rank, number):
        """Sends a signal to a rank, or to mpirun (None)."""
        process = self.process.pid if rank is None else dict(processes(self.out)).get(rank)
        check(process, "no such rank", rank)
        if process:
            os.kill(process, number)

    def end(self, what, may_write=False):
        code = self.process.wait(timeout=RUN_S)
        told = "\n".join(line for line in self.text().splitlines() if "%" not in line and " candidates" not in line)
        check_ended(what, self.out, code, told)
        after = listing(self.out)
        if may_write: # a file is old or whole, never in between
            check(sorted(after) == sorted(self.before), what, sorted(after), sorted(self.before))
        else:
            check(after == self.before, what, "old results have changed:",
                  [name for name in after if after[name] != self.before.get(name)])
        self.told.close()


def phase(run_of, name):
    return lambda: f"murk: {name}: " in run_of.text()


def dying_ranks(folder, room):
    out = os.path.join(folder, "dying")
    done([MURK, "place", room, "--emit", "1500", "-q", "-o", out])
    trace = ["trace", room, "--emit", "4e9", "--set", "photons.maps=none"]
    sense = ["place", "scenes/paper-room.yaml", "--emit", "100000", "--force", "--set",
             "sensors.candidates.grid.size=[40,40,20]"]
    search = ["place", room, "--emit", "5000", "--count", "14", "--set", "placement={detection: independent, "
              "nodes: 1e15}"]
    divided = ["place", room, "--emit", "3000", "--count", "8", "--set", "sensors.candidates.grid.size=[30, 24, 15]",
               "--set", "placement={nodes: 1e15}"]
    for words, name, rank, number in ((trace, "trace", 1, signal.SIGKILL), (trace, "trace", 0, signal.SIGKILL),
                                      (sense, "sense", 2, signal.SIGKILL), (search, "place", 1, signal.SIGKILL),
                                      (search, "place", 0, signal.SIGKILL), (trace, "trace", None, signal.SIGINT),
                                      (sense, "sense", None, signal.SIGTERM), (search, "place", None, signal.SIGINT),
                                      (divided, "place", 1, signal.SIGKILL), (divided, "place", None, signal.SIGINT),
                                      (trace, "trace", 1, signal.SIGTERM), (trace, "trace", 0, signal.SIGINT)):
        what = f"{number.name} in {name}, rank {rank}"
        long = Long(out, words)
        check(long.wait_until(phase(long, name)), what, "no such phase:", long.text())
        long.send(rank, number)
        long.end(what)


def killed_while_files_are_written(folder, room):
    """Rank 0 and another rank are killed as soon as a staged file is there. The next run removes what is left."""
    out = os.path.join(folder, "writing")
    done([MURK, "trace", room, "--emit", "1500", "-q", "-o", out])
    for rank in 0, 1:
        long = Long(out, ["trace", room, "--emit", str(WRITTEN)])
        # Files are written in less time than processes are looked up.
        check(long.wait_until(lambda: rank in dict(processes(out))), "no such rank", long.text())
        process = dict(processes(out))[rank]
        check(long.wait_until(lambda: glob.glob(os.path.join(out, ".murk.staged*"))), "no staged file")
        os.kill(process, signal.SIGKILL)
        long.end(f"rank {rank} killed while files are written", may_write=True)
    done(command(2, "trace", room, "--emit", "1500", "-q", "-j", "1", "-o", out))
    check(sorted(os.listdir(out)) == sorted(listing(out)), "staged files are left", os.listdir(out))


def resumed(folder, room):
    """A trace whose rank was killed goes on from its checkpoint, in another number of ranks, to the same files."""
    out, whole = os.path.join(folder, "resumed"), os.path.join(folder, "undisturbed")
    os.mkdir(out)
    checkpoint = os.path.join(out, "checkpoint.part")
    words = ["trace", room, "--emit", str(16 * WRITTEN)]  # far longer than the second before the first checkpoint
    long = Long(out, [*words, "--checkpoint", "1"])
    check(long.wait_until(lambda: os.path.exists(checkpoint)), "no checkpoint", long.text())
    long.send(1, signal.SIGKILL)
    long.before = {"checkpoint.part": b""}
    long.end("rank 1 killed after a checkpoint", may_write=True)
    done([MURK, *words, "-q", "-o", whole])
    ran = done(command(2, *words, "-j", "1", "-o", out))
    check("photons of an earlier run go on from here" in ran.stderr, ran.stderr)
    check(files(out) == files(whole), "a resumed run has other files")


def main():
    with tempfile.TemporaryDirectory() as folder:
        room, study = (os.path.join(folder, name) for name in ("room.yaml", "study.yaml"))
        for path, text in ((room, ROOM), (study, STUDY)):
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
        for part in (lambda: results_are_the_same(folder, room, study), lambda: steps_are_the_same(folder),
                     lambda: another_seed_differs(folder, room),
                     lambda: refused(folder, room), lambda: mixed(folder, room), lambda: full_disk(folder, room),
                     lambda: dying_ranks(folder, room), lambda: killed_while_files_are_written(folder, room),
                     lambda: resumed(folder, room)):
            begin = time.time()
            part()
            print(f"{time.time() - begin:.0f} s", flush=True)
    print("ranks:", f"{failures} failures" if failures else "all as it should be")
    return failures > 0


if not shutil.which(MPIRUN):
    print("skipped: no", MPIRUN)
    sys.exit(77)
sys.exit(main())
