"""The Python module against the program, from outside: equal results, arrays without copies, exceptions with their
place, cancelling, no leaks.

    python.py MURK LIBRARY
"""
import json
import os
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import time

program, library = sys.argv[1:3]
top = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
os.environ["MURK_LIBRARY"], os.environ["MURK_HEADER"] = library, os.path.join(top, "src/murk.h")
sys.path.insert(0, os.path.join(top, "python"))
try:
    import numpy

    import murk
except ModuleNotFoundError as missing:
    print(f"skipped: no {missing.name}")
    sys.exit(77)

ROOM = {
    "bands_nm": [532], "domain": {"min_m": [0, 0, 0], "max_m": [10, 10, 5]},
    "geometry": [{"rect": {"corner_m": [0, 0, 0], "edge1_m": [10, 0, 0], "edge2_m": [0, 10, 0]}}],
    "media": {"fog": {"extinction_per_m": 0.2, "albedo": 0.9, "phase": {"hg": 0.7}}},
    "regions": [{"medium": "fog"}],
    "lights": [{"type": "sphere", "center_m": [5, 5, 4], "radius_m": 0.1, "power_w": 10}],
    "photons": {"emit": 20000},
    "sensors": {"types": [{"name": "node", "range_m": 6}, {"name": "cam", "range_m": 9, "view": {"cone_deg": 90},
                                                           "headings": 4, "tilts_deg": [-30]}],
                "candidates": {"grid": {"min_m": [1, 1, 1], "max_m": [9, 9, 4], "size": [5, 5, 2]}}, "count": 2},
    "tallies": [{"name": "box", "type": "grid", "min_m": [0, 0, 0], "max_m": [10, 10, 5], "size": [4, 3, 2]},
                {"name": "floor", "type": "plane", "point_m": [0, 0, 0.1], "normal": [0, 0, -1], "bins": [3, 2]}],
}
checks = 0


def check(condition, what):
    global checks
    checks += 1
    if not condition:
        print(f"not so: {what}")
        sys.exit(1)


def resident_mb():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGESIZE") / 1e6


# ---- the program's results ----


def without_run(path):
    with open(path, encoding="utf-8") as file:
        text = json.load(file)
    for key in ("murk", "run", "files", "identity", "scene", "scene_sha256"):
        text.pop(key, None)
    return text


def program_agrees(folder):
    scene_file = os.path.join(folder, "room.yaml")
    with open(scene_file, "w", encoding="utf-8") as file:
        json.dump({"murk": 1, **ROOM}, file)
    by_program, by_python = os.path.join(folder, "program"), os.path.join(folder, "python")
    subprocess.run([program, "place", scene_file, "-o", by_program, "--quiet"], check=True)
    scene = murk.Scene(file=scene_file)
    plan = scene.place()
    plan.save(by_python)
    with open(os.path.join(by_program, "plan.json"), encoding="utf-8") as a, \
            open(os.path.join(by_python, "plan.json"), encoding="utf-8") as b:
        first, second = json.load(a), json.load(b)
    check(first["identity"] == second["identity"], "the same scene has the same identity")
    check(first["files"] == second["files"] and first["files"], "all files have the same bytes")
    mine = {k: v for k, v in plan.result.items() if k not in ("murk", "scene", "scene_sha256")}
    check(mine == without_run(os.path.join(by_program, "plan.json")), "the fields of the plan are those of plan.json")
    check(plan.sensors == first["sensors"] and plan.coverage == first["coverage"], "sensors and coverage")
    # light that the program wrote, and sensors that it chose
    light = scene.world().read_light(os.path.join(by_program, "light.murk"))
    check(light.sense(os.path.join(by_program, "plan.json")).coverage["in_sample"] ==
          first["coverage"]["in_sample"], "coverage of the program's plan on the program's light")
    page = os.path.join(folder, "page.html")
    check(plan.report(page) == page and os.path.getsize(page) > 100000, "a page")
    return plan


def study_and_fit_agree(folder):
    room, study, data = (os.path.join(folder, name) for name in ("room.yaml", "study.yaml", "data.csv"))
    with open(study, "w", encoding="utf-8") as file:
        file.write("murk_study: 1\nbase: room.yaml\naxes: {media.fog.extinction_per_m: [0.1, 0.3]}\n"
                   "outputs: [density, coverage_best]\n")
    with open(data, "w", encoding="utf-8") as file:
        file.write("kind,x_m,y_m,z_m,radius_m,band_nm,unit,value,standard_error\n"
                   "fluence,3,5,2,0.5,532,W/m2,0.05,0.002\nfluence,8,5,2,0.5,532,W/m2,0.02,0.001\n")
    rows = os.path.join(folder, "rows")
    subprocess.run([program, "study", study, "-o", rows, "--quiet"], check=True)
    by_python = murk.study(study)
    check(by_python["rows"] == without_run(os.path.join(rows, "study.json"))["rows"], "rows of a study")
    check(by_python["rows"][0]["values"] != by_python["rows"][1]["values"], "rows differ")
    fit = os.path.join(folder, "fit")
    key = "media.fog.extinction_per_m"
    subprocess.run([program, "fit", room, "--data", data, "--free", key, "-o", fit, "--quiet"], check=True)
    theirs = without_run(os.path.join(fit, "fit.json"))
    mine = murk.Scene(file=room).fit(data, [key])
    check(mine["parameters"] == theirs["parameters"] and mine["chi2"] == theirs["chi2"], "a fit of a scene file")
    by_text = murk.Scene(ROOM).fit(data, [key])
    check(by_text["parameters"] == theirs["parameters"], "a fit of a scene from a dict")


# ---- arrays ----


def arrays():
    light = murk.Scene(ROOM).trace()
    surface, volume = light.surface, light.volume
    check(len(surface) > 1000 and len(volume) > 1000, "records")
    check(surface.dtype["position_m"].shape == (3,) and surface.dtype.itemsize == 32, "the records themselves")
    check(not surface.flags.writeable and not surface.flags.owndata, "a view that cannot be written")
    check(abs(float(volume["position_m"][:, 2].max())) <= 5, "positions in the domain")
    direction = light.array("volume", "direction")
    check(abs(numpy.linalg.norm(direction, axis=1) - 1).max() < 1e-4, "unit directions")
    check(light.array("volume", "direction").ctypes.data == direction.ctypes.data, "unpacked once")
    check((light.array("surface", "normal")[:, 2] > 0.99).all(), "normals of the floor face the light")
    check(set(numpy.unique(light.array("surface", "event_class"))) <= {0, 1, 2}, "event classes")
    tally = light.tallies["box"]
    check(tally.values.shape == (1, 4, 3, 2) and tally.errors.shape == tally.values.shape, "shape of a grid")
    check((tally.values > 0).all() and (tally.errors < tally.values).all(), "values of a grid")
    check(tally.values[0, 1, 1, 1] > tally.values[0, 0, 0, 0], "brighter near the lamp than in the corner")
    floor = light.tallies["floor"]
    check(floor.values.shape == (1, 3, 2, 1, 2), "shape of a plane: band, bins, angle bins, directions")
    check(floor.values[0, :, :, 0, 0].sum() > floor.values[0, :, :, 0, 1].sum(), "more light down than up")
    check(abs(light.ledger["emitted_w"]["total"] - 10) < 1e-9 and light.ledger["imbalance_quanta"] == 0, "energy")
    # views outlive the names of all that they come from
    sum_w = float(volume["power_w"].sum())
    del light, surface, tally, floor, direction
    check(float(volume["power_w"].sum()) == sum_w, "a view keeps the light")


def pictures():
    camera = {"name": "gate", "from_m": [1, 1, 2], "to_m": [5, 5, 1], "pixels": [24, 16], "samples": 4}
    light = murk.Scene({**ROOM, "cameras": [camera, {**camera, "name": "far", "from_m": [9, 9, 3]}]}).trace()
    picture = light.render()
    check(picture.radiance.shape == (1, 16, 24) and picture.rgb.shape == (3, 16, 24), "shapes of a picture")
    check((picture.radiance > 0).all() and (picture.errors > 0).all(), "fog shines everywhere")
    check(not picture.array("radiance.0").flags.owndata, "a channel is a view")
    check((light.render("far").radiance != picture.radiance).any(), "another camera")
    paths = light.render(method="paths")
    off = (paths.radiance.mean() - picture.radiance.mean()) / picture.radiance.mean()
    check(abs(off) < 0.3, f"maps and paths agree in the mean: {off:+.2f}")
    for make, part in ((lambda: light.render("gaet"), "gaet"), (lambda: light.render(method="rays"), "rays"),
                       (lambda: picture.array("radiance.7"), "radiance.7"),
                       (lambda: picture.write("/nowhere/p.exr"), "/nowhere")):
        try:
            make()
        except murk.Error as error:
            check(part in str(error), str(error))
        else:
            check(False, f"no error about {part}")
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "p.exr")
        picture.write(path)
        picture.write(path)  # an own image is replaced
        with open(path, "rb") as file:
            check(file.read(4) == b"\x76\x2f\x31\x01", "an OpenEXR file")
        with open(path, "wb") as file:
            file.write(b"of the user")
        try:
            picture.write(path)
        except murk.Error:
            with open(path, "rb") as file:
                check(file.read() == b"of the user", "a file of the user stays")
        else:
            check(False, "a file of the user is not replaced")


def grids_and_meshes():
    """A grid of one value everywhere is a medium of one value: exp(-tau) of a beam."""
    beam = {"bands_nm": [532], "domain": {"min_m": [0, -1, -1], "max_m": [10, 1, 1]},
            "media": {"smoke": {"vdb": "memory:smoke", "extinction_per_m": 1, "albedo": 0}},
            "regions": [{"medium": "smoke"}],
            "lights": [{"type": "beam", "origin_m": [0.5, 0, 0], "direction": [1, 0, 0], "power_w": 1}],
            "photons": {"emit": 200000, "maps": "none"},
            "tallies": [{"name": "end", "type": "plane", "point_m": [8.5, 0, 0], "normal": [1, 0, 0]}]}
    scene = murk.Scene(beam)
    scene.add_grid("smoke", numpy.full((20, 4, 4), 0.25), cell_m=0.5, origin_m=(0.25, -0.75, -0.75))
    end = scene.trace().tally("end")
    value, error = end.values.flat[0], end.errors.flat[0]
    check(abs(value - numpy.exp(-0.25 * 8)) < 5 * error, f"transmittance of a grid: {value} +- {error}")
    check(abs(value - numpy.exp(-0.25 * 8 * 1.05)) > 5 * error, "5 % more extinction is refused")
    # a slice of a larger array, in another type, is the same grid
    large = numpy.zeros((40, 4, 8), numpy.float64)
    large[::2, :, ::2] = 0.25
    scene.add_grid("smoke", large[::2, :, ::2], cell_m=0.5, origin_m=(0.25, -0.75, -0.75))
    check(scene.trace().tally("end").values.flat[0] == value, "a strided grid of doubles")
    # a wall in the way: two triangles
    scene["geometry"] = [{"file": "memory:wall", "material": "black"}]
    scene["materials"] = {"default": {"diffuse": 0}, "black": {"diffuse": 0}}
    scene.add_mesh("wall", [[5, -1, -1], [5, 1, -1], [5, 1, 1], [5, -1, 1]], [[0, 1, 2], [0, 2, 3]])
    check(scene.trace().tally("end").values.flat[0] == 0, "a mesh stops the beam")


# ---- errors ----


def errors():
    """The most common mistakes: each raises Error, with the key or a text that says what is wrong."""
    room = lambda **keys: murk.Scene({**ROOM, **keys}).check()
    cases = [
        (lambda: murk.Scene("murk: [1").check(), "", ""),
        (lambda: murk.Scene("").check(), "", ""),
        (lambda: murk.Scene("murk: 1").check(), "", "lights"),
        (lambda: room(murk=2), "murk", "2"),
        (lambda: murk.Scene(file="/nowhere/room.yaml"), "", "/nowhere/room.yaml"),
        (lambda: room(photon={"emit": 1}), "photon", "did you mean photons"),
        (lambda: room(photons={"emit": -1}), "photons.emit", "-1"),
        (lambda: room(photons={"emit": "many"}), "photons.emit", "many"),
        (lambda: room(photons={"emit": 10, "store": 10}), "photons", ""),
        (lambda: room(bands_nm=[]), "bands_nm", ""),
        (lambda: room(bands_nm=[-10]), "bands_nm", "-10"),
        (lambda: room(bands_nm=list(range(400, 420))), "bands_nm", ""),
        (lambda: room(lights=[]), "lights", ""),
        (lambda: room(lights=[{"type": "lamp"}]), "lights.0.type", "lamp"),
        (lambda: room(lights=[{"type": "point", "position_m": [1, 1], "power_w": 1}]), "lights.0.position_m", ""),
        (lambda: room(lights=[{"type": "point", "position_m": [1, 1, 1], "power_w": -3}]), "lights.0.power_w", "-3"),
        (lambda: room(media={"fog": {"albedo": 1.5, "extinction_per_m": 1}}), "media.fog.albedo", "1.5"),
        (lambda: room(media={"fog": {"preset": "fog/thick"}}), "media.fog.preset", ""),
        (lambda: room(media={"fog": {"extinction_per_m": 1, "albedo": 1, "phase": {"hg": 2}}}), "media.fog.phase.hg", "2"),
        (lambda: room(regions=[{"medium": "smoke"}]), "regions.0.medium", "smoke"),
        (lambda: room(materials={"default": {"diffuse": 0.8, "specular": 0.8}}), "materials.default", ""),
        (lambda: room(sensors={**ROOM["sensors"], "count": 0}), "sensors.count", "0"),
        (lambda: room(sensors={**ROOM["sensors"], "types": []}), "sensors.types", ""),
        (lambda: room(placement={"method": "fastest"}), "placement.method", "fastest"),
        (lambda: room(domain={"min_m": [0, 0, 0], "max_m": [0, 1, 1]}), "domain", ""),
        (lambda: room(site={"time": "yesterday"}), "site.time", "yesterday"),
        (lambda: murk.Scene({**ROOM, "geometry": [{"file": "/nowhere/hall.obj"}]}).world(), "", "/nowhere/hall.obj"),
        (lambda: murk.Scene({**ROOM, "geometry": [{"file": "memory:hall"}]}).world(), "", "was added"),
        (lambda: murk.Scene({**ROOM, "media": {"fog": {"vdb": "/nowhere/x.vdb", "extinction_per_m": 1, "albedo": 0}}}).world(), "",
         "/nowhere/x.vdb"),
        (lambda: murk.Scene(ROOM).__setitem__("sensors.cuont", 3) or murk.Scene(ROOM)["sensors.cuont"], "", ""),
        (lambda: murk.Scene(ROOM)["media.smoke"], "", ""),
        (lambda: murk.Scene(ROOM).trace().tally("boxes"), "", "boxes"),
        (lambda: murk.Scene(ROOM).trace().array("volume", "colour"), "", "colour"),
        (lambda: murk.Scene(ROOM).trace().sense([{"type": "node", "position_m": [50, 0, 0]}]), "", "domain"),
        (lambda: murk.Scene(ROOM).trace().sense([{"type": "eye", "position_m": [5, 0, 0]}]), "", "eye"),
        (lambda: murk.Scene(ROOM).trace().sense([{"type": "cam", "position_m": [5, 5, 2]}]), "", "heading_deg"),
        (lambda: murk.Scene(ROOM).world().read_light("/nowhere/light.murk"), "", "/nowhere/light.murk"),
        (lambda: murk.Scene(ROOM).add_grid("x", numpy.full((2, 2, 2), -1.0)), "", "-1"),
        (lambda: murk.Scene(ROOM).add_grid("x", numpy.zeros((2, 2))), "", "dimensions"),
        (lambda: murk.Scene(ROOM).add_mesh("x", [[0, 0, 0]], [[0, 0, 1]]), "", "triangles"),
    ]
    for number, (make, key, part) in enumerate(cases):
        try:
            make()
        except murk.Error as error:
            where = f"error {number}: {error} (key {error.key!r})"
            check(error.code.startswith("MURK_") and error.text, where)
            check(error.key == key or not key or error.key.startswith(key), where)
            check(part in str(error), where)
            check("--" not in str(error), f"no option of the command line: {where}")
            copy = pickle.loads(pickle.dumps(error))
            check((str(copy), copy.key, copy.line) == (str(error), error.key, error.line), "an error can be pickled")
        else:
            check(False, f"error {number} is raised")


def places():
    try:
        murk.Scene("murk: 1\nlights:\n  - {type: point, position_m: [0, 0, 0], power_w: x}\n").check()
    except murk.Error as error:
        check((error.file, error.line, error.column) == ("scene", 3, 51), f"{error.file} {error.line} {error.column}")
        check(error.key == "lights.0.power_w", error.key)
    else:
        check(False, "a wrong power is refused")


# ---- threads, cancelling, leaks ----


def interpreter_is_free():
    """Another thread counts while light is traced."""
    count, stop = [0], threading.Event()

    def counting():
        while not stop.is_set():
            count[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=counting)
    world = murk.Scene({**ROOM, "photons": {"emit": 400000, "maps": "none"}}).world()
    thread.start()
    before, begun = count[0], time.monotonic()
    world.trace()
    counted, seconds = count[0] - before, time.monotonic() - begun
    stop.set()
    thread.join()
    check(seconds < 0.1 or counted > 20 * seconds, f"{counted} counts in {seconds:.2f} s")


def interrupt():
    """Ctrl-C stops a trace that would take hours, and the next call works."""
    world = murk.Scene({**ROOM, "photons": {"emit": 4000000000, "maps": "none"}}).world()
    threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
    begun = time.monotonic()
    try:
        world.trace()
    except KeyboardInterrupt:
        check(time.monotonic() - begun < 60, "the trace stops soon")
    else:
        check(False, "KeyboardInterrupt is raised")
    check(len(murk.Scene(ROOM).trace().volume) > 0, "the next trace works")


def progress_and_log():
    seen, heard = [], []
    context = murk.Context(threads=1, progress=lambda *state: seen.append(state), log=lambda *m: heard.append(m))
    murk.Scene(ROOM, context=context).place()
    check(seen and all(len(state) == 5 for state in seen), "progress")
    check(heard and all(is_warning and text for is_warning, _, text in heard), f"warnings: {heard}")
    murk.Scene({**ROOM, "lights": [{**ROOM["lights"][0], "power_w": 0}]}, context=context).world()
    check(any(not is_warning and "dark" in text for is_warning, _, text in heard), f"a note of the dark: {heard}")


def leaks(scenes):
    for _ in range(50):
        murk.Scene(ROOM).check()
    before = resident_mb()
    for _ in range(scenes):
        scene = murk.Scene(ROOM)
        scene.add_grid("unused", numpy.zeros((16, 16, 16)))
        scene.check()
        try:
            scene["photons.emit"] = "x"
            scene.check()
        except murk.Error:
            pass
    grown = resident_mb() - before
    check(grown < 8, f"{scenes} scenes leave {grown:.1f} MB")


def main():
    with tempfile.TemporaryDirectory() as folder:
        plan = program_agrees(folder)
        study_and_fit_agree(folder)
    check(pickle.loads(pickle.dumps(plan)) == plan.result, "a plan pickles as its fields")
    arrays()
    pictures()
    grids_and_meshes()
    errors()
    places()
    interpreter_is_free()
    interrupt()
    progress_and_log()
    leaks(1000)
    print(f"{checks} checks")


main()
