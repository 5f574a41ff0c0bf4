"""The Python module against the program, from outside: equal results, arrays without copies, exceptions with their
place, cancelling, no leaks.

    python.py MURK LIBRARY
"""
import ctypes
import gc
import inspect
import io
import json
import os
import pickle
import re
import signal
import subprocess
import sys
import tempfile
import warnings
import threading
import time

from python_module import ROOM, allocated_bytes, check, done, murk, program

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "same"))
from recorded import exr_data

# ---- updates ----


def updates():
    """A box moves: light, coverage and plan that are updated equal those of a scene with the box there."""
    room = {**ROOM, "geometry": [*ROOM["geometry"],
                                 {"name": "crate", "box": {"min_m": [0, 0, 0], "max_m": [0.5, 0.5, 0.5]},
                                  "translate_m": [1, 1, 0.1]}]}
    number = len(room["geometry"]) - 1
    world = murk.Scene(room).world()
    light = world.trace()
    plan = light.place()
    seen = light.sense(plan.sensors)
    for place in ([1.3, 1, 0.1], [1.6, 1, 0.1], [1.6, 1.2, 0.1], [1.6, 1.2, 0.1]):
        before = plan.sensors
        world = world.move("crate", place)
        light = light.update(world)
        seen, plan = seen.update(light), plan.update(light)
        with tempfile.TemporaryDirectory() as folder:
            start = os.path.join(folder, "start.json")
            with open(start, "w", encoding="utf-8") as file:
                json.dump({"sensors": before}, file)
            fresh = murk.Scene(room)
            fresh[f"geometry.{number}.translate_m"] = place
            fresh["placement.start_plan"] = start
            other = fresh.trace()
            there = other.place()
        for records in ("surface", "volume"):
            check(numpy.array_equal(getattr(light, records), getattr(other, records)), f"{records} records at {place}")
        ledgers = [{**of.ledger, "scene_sha256": ""} for of in (light, other)]  # of the text, which says it otherwise
        check(ledgers[0] == ledgers[1], f"the ledger at {place}")
        check(seen.coverage == other.sense(seen.sensors).coverage, f"coverage at {place}")
        for field in ("sensors", "coverage", "bound", "placement"):
            check(getattr(plan, field) == getattr(there, field), f"{field} of the plan at {place}")
    for wrong, moved in (("no such item", lambda: world.move("table", [0, 0, 0])),
                         ("not finite", lambda: world.move(number, [numpy.nan, 0, 0]))):
        try:
            moved()
            check(False, f"{wrong} is refused")
        except murk.Error as error:
            check(len(str(error).splitlines()) == 1, f"{wrong}: {error}")


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
    # the events of a photon
    replay = subprocess.run([program, "replay", scene_file, "--photon", "7", "--format", "json"], check=True,
                            capture_output=True, text=True).stdout
    check(scene.world().replay(7).events == json.loads(replay)["events"], "the events of a photon")
    # a look over the world, with its picture
    sheet = os.path.join(folder, "sheet.png")
    told = json.loads(subprocess.run([program, "check", scene_file, "--picture", sheet, "--format", "json"], check=True,
                                     capture_output=True, text=True).stdout)
    looked = scene.world().check(sheet)
    others = ("run", "files", "identity")  # of the command line, also in the file
    check({k: v for k, v in looked.items() if k not in others} == {k: v for k, v in told.items() if k not in others},
          "a look over the world")
    looked = scene.world().check(sheet, pixels=(800, 600), cut_m=told["picture"]["cut_m"])
    check(looked.picture.cut_m == told["picture"]["cut_m"] and looked.picture.sections != told["picture"]["sections"],
          "the planes and the size of a picture")
    check(scene.world().check(ranks=4).ranks["count"] == 4 and "ranks" not in looked, "the forecast for ranks")
    # light that the program wrote, and sensors that it chose
    light = scene.world().read_light(os.path.join(by_program, "light.murk"))
    check(light.sense(os.path.join(by_program, "plan.json")).coverage["in_sample"] ==
          first["coverage"]["in_sample"], "coverage of the program's plan on the program's light")
    seen = light.sense(plan.sensors)
    seen.save(os.path.join(folder, "seen"), exports=["photons"])
    check({"coverage.json", "coverage.csv"} <= set(os.listdir(os.path.join(folder, "seen"))), "files of a coverage")
    parts = [os.path.join(folder, f"{number}.part") for number in (1, 2)]
    for number, path in enumerate(parts, 1):
        plan.repeat_part(3, number, 2, path)
    check(plan.merge_repeat(3, parts[::-1]) == plan.repeat(3), "other seeds in parts")
    check(plan.repeat(2)["runs"] and plan.result["repeat"], "a plan with another seed")
    page = os.path.join(folder, "page.html")
    check(plan.report(page) == page and os.path.getsize(page) > 100000, "a page")
    return plan


def options_of_a_fit(room, data, key):
    """Bounds between the start and the value of the free fit, which lies between 2.7 and 3.5; losses."""
    for start, bounds, limit in ((2.5, (None, 2.7), 2.7), (4, (3.5, None), 3.5)):
        scene = murk.Scene(file=room, **{key: start})
        free, bound = scene.fit(data, [key]).parameters[0], scene.fit(data, [key], bounds={key: bounds}).parameters[0]
        check(2.7 < free.value < 3.5 and not free.at_bound, f"a fit without bounds: {free}")
        check(bound.value == limit and bound.at_bound, f"a fit with the bounds {bounds}: {bound}")
    chi2 = [murk.Scene(file=room).fit(data, [key], loss=loss).chi2 for loss in (None, "none", "huber:0.1", "cauchy")]
    check(chi2[0] == chi2[1] and len(set(chi2)) == 3, f"losses: {chi2}")
    for options, place, named, part in (({"loss": "hubber"}, "loss", "", "hubber, must be none, huber or cauchy"),
                                        ({"loss": "huber:-1"}, "loss", "", "huber:-1, must be"),
                                        ({"bounds": {key: (2, 1)}}, f"bounds {key}=2:1", key, "2 to 1"),
                                        ({"bounds": {"media.fog.albedo": (0, 1)}}, "bounds media.fog.albedo=0:1",
                                         "media.fog.albedo", "no free key")):
        try:
            murk.Scene(file=room).fit(data, [key], **options)
        except murk.Error as error:
            check((error.where, error.key) == (place, named) and part in error.text, f"{options}: {error}")
        else:
            check(False, f"{options} is refused")


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
    parts = [os.path.join(folder, f"part-{k}") for k in (1, 2)]
    for k, part in enumerate(parts):
        shard = murk.study(study, folder=part, shard=(k + 1, 2))
        check(len(shard.rows) == 1, "rows of a part")
    merged = murk.study(study, parts=parts[::-1])
    check(merged["rows"] == by_python["rows"] and merged.result.run.rows_kept == 2, "rows of parts")
    for wrong in ({"folder": parts[0], "shard": (3, 2)}, {"shard": (1, 2)}, {"parts": [folder]},
                  {"parts": parts, "keys": {"seed": 7}}, {"folder": parts[0], "shard": (1, 2), "parts": parts}):
        try:
            murk.study(study, **wrong)
        except murk.Error:
            continue
        check(False, f"{wrong} is refused")
    try:
        shard.save(os.path.join(folder, "part-saved"))
    except murk.Error as error:
        check("a part has no results" in error.text, f"{error}")
    for name in ("study.json", "table.csv"):
        by_python.save(os.path.join(folder, "saved"))
        check(os.path.getsize(os.path.join(folder, "saved", name)) > 0, f"{name} is written")
    page = os.path.join(folder, "study.html")
    check(by_python.report(page) == page and os.path.getsize(page) > 100000, "a page of a study")
    check(by_python["rows"][0]["values"] != by_python["rows"][1]["values"], "rows differ")
    fit = os.path.join(folder, "fit")
    key = "media.fog.extinction_per_m"
    subprocess.run([program, "fit", room, "--data", data, "--free", key, "-o", fit, "--quiet"], check=True)
    theirs = without_run(os.path.join(fit, "fit.json"))
    mine = murk.Scene(file=room).fit(data, [key])
    check(mine["parameters"] == theirs["parameters"] and mine["chi2"] == theirs["chi2"], "a fit of a scene file")
    mine.save(os.path.join(folder, "saved-fit"))
    predicted = murk.Scene(file=room).fit(data)
    predicted.save(os.path.join(folder, "predicted"))
    check(predicted.parameters == [] and predicted.data.rows == 2 and
          os.path.exists(os.path.join(folder, "predicted", "predict.json")), "a prediction at the values of a scene")
    check(without_run(os.path.join(folder, "saved-fit", "fit.json"))["parameters"] == theirs["parameters"], "a saved fit")
    found = murk.read_keys(os.path.join(folder, "saved-fit", "calibrated.yaml"))
    check(abs(found[key] / mine.parameters[0].value - 1) < 1e-4, "the keys that a fit has found")
    check(murk.Scene(file=room, **found)[key] == found[key], "a scene takes them")
    words = os.path.join(folder, "words.yaml")
    with open(words, "w", encoding="utf-8") as file:
        file.write("a.b: 5\nc: -1.5e3\nd: true\ne: sphere\nf: 1_000\n# Does it fit? Not.\n")
    check(murk.read_keys(words) == {"a.b": 5, "c": -1500.0, "d": True, "e": "sphere", "f": "1_000"}, "values of keys")
    options_of_a_fit(room, data, key)
    told = murk.Scene(file=room).fit(data, predict=os.path.join(folder, "saved-fit", "fit.json"))
    told.save(os.path.join(folder, "predicted"))
    check(os.path.exists(os.path.join(folder, "predicted", "fit.csv")), "predicted readings")
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
    # in clear air each record that a sensor sees has the whole clarity
    clear = {**ROOM, "media": {}, "regions": []}
    seen = murk.Scene(clear).sense([{"type": "node", "position_m": [5, 5, 2]}])
    check(set(numpy.unique(seen.matrix)) == {0, 65535}, "a matrix in clear air")
    # views outlive the names of all that they come from
    sum_w = float(volume["power_w"].sum())
    del light, surface, tally, floor, direction
    check(float(volume["power_w"].sum()) == sum_w, "a view keeps the light")


def png_data(image):
    """The compressed pixels of a PNG file, without its texts, which name the run."""
    at, data = 8, []
    while at < len(image):
        size = int.from_bytes(image[at:at + 4], "big")
        data += [image[at + 8:at + 8 + size]] if image[at + 4:at + 8] == b"IDAT" else []
        at += size + 12
    check(data, "a PNG file has pixels")
    return b"".join(data)


def pictures(folder):
    camera = {"name": "gate", "from_m": [1, 1, 2], "to_m": [5, 5, 1], "pixels": [24, 16], "samples": 4}
    room = {**ROOM, "cameras": [camera, {**camera, "name": "far", "from_m": [9, 9, 3]}]}
    light = murk.Scene(room).trace()
    picture = light.render()
    check(picture.radiance.shape == (1, 16, 24) and picture.rgb.shape == (3, 16, 24), "shapes of a picture")
    check((picture.radiance > 0).all() and (picture.errors > 0).all(), "fog shines everywhere")
    check(not picture.array("radiance.0").flags.owndata, "a channel is a view")
    check((light.render("far").radiance != picture.radiance).any(), "another camera")
    for make, part in ((lambda: light.render("gaet"), "gaet"), (lambda: light.render(method="rays"), "rays"),
                       (lambda: picture.array("radiance.7"), "radiance.7"),
                       (lambda: picture.save("/nowhere/p.exr"), "/nowhere"),
                       (lambda: picture.save(scale="square"), "square"), (lambda: light.render(from_sensor=1), "sensor")):
        try:
            make()
        except murk.Error as error:
            check(part in str(error), str(error))
        else:
            check(False, f"no error about {part}")
    # the pixels of the program, to the bit
    scene_file = os.path.join(folder, "room.yaml")
    with open(scene_file, "w", encoding="utf-8") as file:
        json.dump({"murk": 1, **room}, file)
    same = murk.Scene(file=scene_file).trace()
    for method, of_program in (("maps", "maps"), ("paths", "path"), ("maps-only", "maps-only")):
        mine, theirs = (os.path.join(folder, f"{method}-{who}.exr") for who in ("python", "program"))
        saved = same.render("far", method).save(mine, png=True, exposure_stops=2)
        run = subprocess.run([program, "render", scene_file, "--camera", "far", "--method", of_program, "-o", theirs,
                              "--png", "--exposure", "2", "--format", "json"], check=True, capture_output=True, text=True)
        told = json.loads(run.stdout)
        check(saved.mean_radiance == told["mean_radiance"] and saved.png.image == mine[:-3] + "png", "fields of a picture")
        with open(mine[:-3] + "png", "rb") as a, open(theirs[:-3] + "png", "rb") as b:
            check(png_data(a.read()) == png_data(b.read()), "the picture for the eye is the program's")
        with open(mine, "rb") as a, open(theirs, "rb") as b:
            check(exr_data(a.read()) == exr_data(b.read()), f"the picture by {method} is the program's")
    # channels of sensors, the view of one, sizes; no light for paths
    sensors = [{"type": "node", "position_m": [5, 5, 2]}]
    seen = light.render(sensors=sensors, pixels=(32, 8), samples=2)
    count = seen.array("coverage.count")
    check(seen.radiance.shape == (1, 8, 32) and set(numpy.unique(count[count >= 0])) == {0, 1},
          "coverage of a sensor in a picture")
    check(light.render(sensors=sensors, from_sensor=1).distance_m.shape[1] == 640, "the view of a sensor")
    dark = murk.Scene(room).render("far", "paths")
    check((dark.radiance == light.render("far", "paths").radiance).all(), "paths need no light")
    path = os.path.join(folder, "p.exr")
    picture.save(path)
    picture.save(path)  # an own image is replaced
    with open(path, "rb") as file:
        check(file.read(4) == b"\x76\x2f\x31\x01", "an OpenEXR file")
    with open(path, "wb") as file:
        file.write(b"of the user")
    try:
        picture.save(path)
    except murk.Error:
        with open(path, "rb") as file:
            check(file.read() == b"of the user", "a file of the user stays")
    else:
        check(False, "a file of the user is not replaced")
    check(picture.save(path, replace=True).image == path, "a file of the user is replaced if asked")


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
    light = scene.trace()
    check(light.tally("end").values.flat[0] == 0, "a mesh stops the beam")
    # a page shows the arrays of its scene, again and again, and says that no command line has them
    with tempfile.TemporaryDirectory() as folder:
        page = os.path.join(folder, "page.html")
        for _ in range(2):
            light.report(page)
        with open(page, encoding="utf-8") as file:
            text = file.read()
        check("cannot be read again" not in text and "Light.report() of a program in Python" in text, "a page of arrays")
        check("Files of the folder" not in text and "murk trace" not in text, "no command makes it again")
        # another world has another grid under the same name: each page shows that of its own
        scene.add_grid("smoke", numpy.full((20, 4, 4), 0.5), cell_m=0.5, origin_m=(0.25, -0.75, -0.75))
        thicker = scene.trace()
        most_per_m = []
        for one in (light, thicker, light):
            one.report(page)
            with open(page, encoding="utf-8") as file:
                most_per_m += re.findall(r'"most_per_m":([\d.]+)', file.read())
        check(most_per_m == ["0.25", "0.5", "0.25"], f"the extinctions on pages of two grids: {most_per_m}")
        # results may be saved again after a page was made of them
        light.save(os.path.join(folder, "out"))
        with open(murk.report(os.path.join(folder, "out")), encoding="utf-8") as file:
            check("that program alone makes the results again" in file.read(), "a folder of results of arrays")
        other = murk.Scene({**beam, "seed": 2, "media": {"smoke": {"extinction_per_m": 1, "albedo": 0}}}).trace()
        other.save(os.path.join(folder, "out"))


def examples_of_arrays():
    """The examples in the docstrings of the methods that add arrays, run as they stand."""
    places = numpy.linspace(2, 8, 4)
    for method, is_used in (("add_mesh", lambda scene: len(scene.trace().surface) > 0),
                            ("add_grid", lambda scene: scene.world().bands_nm.size == 1),
                            ("add_table", lambda scene: scene.place().result["candidates"]["asked"] == len(places))):
        scene = murk.Scene(ROOM, media={"smoke": {"extinction_per_m": 1, "albedo": 0.9}}, regions=[{"medium": "smoke"}])
        example = inspect.getdoc(getattr(murk.Scene, method)).split("Example: ")[1]
        codes = re.findall("`([^`]+)`", example)
        check(len(codes) == 2, f"the example of {method} adds an array and names it: {codes}")
        names = {"scene": scene, "density": numpy.ones((4, 4, 4)), "x": places, "y": places, "z": 0 * places + 2}
        for code in codes:
            exec(code, names)  # noqa: S102
        check(is_used(scene), f"the example of {method}")


def warnings_of_calls():
    """A warning is given at the line of the user; as an error, it leaves the next call alone."""
    escaping = ROOM  # four fifths of its light leave through the sides
    with warnings.catch_warnings(record=True) as heard:
        warnings.simplefilter("always")
        murk.Scene(escaping).world().check()
    check(heard and all(os.path.samefile(one.filename, __file__) for one in heard), "the line of a warning")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            murk.Scene(escaping).world().check()
        except UserWarning:
            pass
        else:
            check(False, "no warning as an error")
        try:
            murk.Scene({**escaping, "seed": -1}).world()
        except murk.Error as error:
            check("seed" in str(error), "an error of the call itself")
    check(len(murk.Scene(ROOM).trace().volume) > 0, "a call after warnings that were errors")


# ---- threads, cancelling, leaks ----


class Heartbeat:
    """A thread that wakes every 10 ms. `longest_s` is the longest time between two awakenings."""

    def __enter__(self):
        self.longest_s, self.is_over = 0, threading.Event()
        self.thread = threading.Thread(target=self.beat)
        self.thread.start()
        return self

    def beat(self):
        before = time.monotonic()
        while not self.is_over.wait(0.01):
            now = time.monotonic()
            self.longest_s, before = max(self.longest_s, now - before), now

    def __exit__(self, *_):
        self.is_over.set()
        self.thread.join()


def holds_the_lock(work):
    """(share, seconds): the longest pause of another thread while work() runs, as a share of the time of work().
    A call that holds the interpreter's lock makes it 1; else it is the latency of the scheduler over that time."""
    with Heartbeat() as heart:
        begun = time.monotonic()
        work()
        seconds = time.monotonic() - begun
    return heart.longest_s / seconds, seconds


def interpreter_is_free():
    """Another thread runs during long calls. The limit lies halfway between a call that holds the lock all the time
    (1) and one that never does (0); calls are long enough that half of them is far more than a time slice."""
    for name in ("trace", "sense", "place"):
        photons, seconds = 100000, 0
        while seconds < 0.2 and photons < 10000000: # as many photons as make the call long on this machine
            photons *= 2
            world = murk.Scene({**ROOM, "photons": {"emit": photons, "max_stored": 100000000}}).world()
            light = None if name == "trace" else world.trace()
            share, seconds = holds_the_lock(
                {"trace": world.trace,
                 "sense": lambda light=light: light.sense([{"type": "node", "position_m": [5, 5, 2]}] * 10).matrix,
                 "place": lambda light=light: light.place()}[name])
        check(seconds >= 0.2, f"{name} is a long call: {seconds:.2f} s with {photons} photons")
        check(share < 0.5, f"{name} releases the lock: a pause of {share:.2f} of {seconds:.2f} s")
    # a call that holds the lock is found out
    microseconds = 1000000
    share, _ = holds_the_lock(lambda: ctypes.PyDLL(None).usleep(microseconds - 1))
    check(share > 0.5, f"a call that holds the lock makes a pause of {share:.2f}")


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


# ---- batches ----

FIELDS = ("position_m", "power_w", "emitted", "band", "light", "material", "direction", "normal", "event_class")


def sorted_rows(columns):
    """Records by their bytes, in an order that does not depend on that of the records."""
    n = len(columns[0])
    return numpy.sort(numpy.hstack([numpy.ascontiguousarray(c).view(numpy.uint8).reshape(n, -1) for c in columns])
                      .view(f"S{sum(c.itemsize * c[0].size for c in columns)}").ravel())


def streamed(keys, what):
    """The records of all batches together are those of the light, to the bit."""
    scene = murk.Scene({**ROOM, **keys})
    received, numbers = {"surface": [], "volume": []}, []

    def receive(batch):
        numbers.append((batch.number, *batch.photons))
        for name, kept in received.items():
            records = getattr(batch, name)
            check(records is getattr(batch, name), "records are copied once")
            check((numpy.diff(records["emitted"].astype(int)) >= 0).all(), f"the order of photons, {what}")
            check(all((batch.array(name, f) == records[f]).all() for f in records.dtype.names), "array() and records")
            kept.append([records[f] if f in records.dtype.names else batch.array(name, f) for f in FIELDS])

    light = scene.trace(each_batch=receive)
    check([n for n, _, _ in numbers] == list(range(len(numbers))) and len(numbers) > 10, f"the order of batches, {what}")
    check(numbers[0][1] == 0 and all(b[1] == a[2] + 1 for a, b in zip(numbers, numbers[1:])), f"no gaps, {what}")
    check(numbers[-1][2] + 1 == light.ledger.photons_emitted, f"all photons, {what}")
    plain = scene.trace()
    for name, kept in received.items():
        columns = [numpy.concatenate([one[k] for one in kept]) for k in range(len(FIELDS))]
        if "store" in keys.get("photons", {}):
            packet_w = numpy.array([[light.packet_w(i, 0)] for i in range(len(scene["lights"]))])
            columns[1] = (columns[1] * packet_w[columns[4], columns[3]]).astype(numpy.float32)
        for other in (light, plain):
            stored = [other.array(name, f) for f in FIELDS]
            check(all(a.dtype == b.dtype and a.shape == b.shape for a, b in zip(columns, stored)), f"types, {what}")
            check(len(columns[0]) > 100 and (sorted_rows(columns) == sorted_rows(stored)).all(),
                  f"the {name} map of batches, {what}")


def raised(kind, world, receive):
    try:
        world.trace(receive)
    except kind as error:
        return error
    check(False, f"{kind.__name__} is raised")


def batches():
    streamed({}, "photons.emit")
    streamed({"photons": {"store": 30000}, "lights": ROOM["lights"] + [{**ROOM["lights"][0], "power_w": 3}]},
             "photons.store")
    far = [400000.0, 5600000.0, 0.0]
    moved = murk.Scene({**{key: ROOM[key] for key in ("bands_nm", "media", "regions", "photons")},
                        "domain": {"min_m": far, "max_m": [far[0] + 10, far[1] + 10, 5]},
                        "geometry": [{"rect": {"corner_m": far, "edge1_m": [10, 0, 0], "edge2_m": [0, 10, 0]}}],
                        "lights": [{**ROOM["lights"][0], "center_m": [far[0] + 5, far[1] + 5, 4]}]})
    places = []
    light = moved.trace(each_batch=lambda batch: places.append(batch.volume["position_m"]))
    places = numpy.concatenate(places)
    check(places.dtype == numpy.float64 and (numpy.sort(places, 0) ==
                                             numpy.sort(light.array("volume", "position_m"), 0)).all(), "far from 0")
    # False cancels, of Python or NumPy; no other value does
    world = murk.Scene(ROOM).world()
    seen = []
    for answer in (False, numpy.bool_(False)):
        seen.clear()
        error = raised(murk.Interrupted, world, lambda batch: (seen.append(batch), batch.number < 3 or answer)[1])
        check(len(seen) == 4 and "batch 3" in str(error), f"{len(seen)} batches: {error}")
    for answer in (None, 0, "", True):
        check(len(world.trace(lambda batch: answer).volume) > 0, f"{answer!r} does not cancel")
    # the arrays of a batch stay valid, the batch does not
    kept = []
    raised(murk.Interrupted, world,
           lambda batch: kept.append((batch, batch.volume, batch.array("volume", "direction"))) or False)
    batch, records, directions = kept[0]
    check(batch.volume is records and records["power_w"].min() > 0, "arrays are the caller's")
    check(numpy.allclose(numpy.linalg.norm(directions, axis=1), 1, atol=1e-4), "unit vectors")
    for late in (lambda: batch.surface, lambda: batch.array("volume", "band"), lambda: batch.array("air", "band")):
        try:
            late()
        except murk.Error as error:
            check("until" in str(error) or error.where == "argument map", str(error))
        else:
            check(False, "a batch that is over raises Error")
    check("no_such" in str(raised(murk.Error, world, lambda batch: batch.array("volume", "no_such"))), "a wrong field")
    # an exception arrives as it is, from the main thread and from another one, and the next trace works
    thrown = LookupError("enough")

    def throw(batch):
        if batch.number == 2:
            raise thrown

    check(raised(LookupError, world, throw) is thrown, "the exception of the function")
    check(raised(SystemExit, world, lambda batch: sys.exit(3)).code == 3, "SystemExit")
    found = []
    thread = threading.Thread(target=lambda: found.append(raised(LookupError, world, throw)))
    thread.start()
    thread.join()
    check(found == [thrown], "in another thread")
    check(len(world.trace(lambda batch: None).volume) == len(world.trace().volume), "the next trace")
    # Ctrl-C, cancel() in the function, and other threads of Python meanwhile
    long = murk.Scene({**ROOM, "photons": {"emit": 4000000000, "maps": "none"}}).world()
    threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
    begun = time.monotonic()
    raised(KeyboardInterrupt, long, lambda batch: None)
    check(time.monotonic() - begun < 60, "the trace stops soon")
    raised(murk.Interrupted, long, lambda batch: long.context.cancel())
    share, seconds = holds_the_lock(lambda: raised(murk.Interrupted, long,
                                                   lambda batch, end=time.monotonic() + 1: time.monotonic() < end))
    check(share < 0.5, f"the lock is released: a pause of {share:.2f} of {seconds:.2f} s")


def progress_and_log():
    seen, heard = [], []
    context = murk.Context(threads=1, progress=lambda *state: seen.append(state), log=lambda *m: heard.append(m))
    murk.Scene(ROOM, context=context).place()
    check(seen and all(len(state) == 5 for state in seen), "progress")
    check(heard and all(is_warning and text for is_warning, _, text in heard), f"warnings: {heard}")
    murk.Scene({**ROOM, "lights": [{**ROOM["lights"][0], "power_w": 0}]}, context=context).world()
    check(any(not is_warning and "dark" in text for is_warning, _, text in heard), f"a note of the dark: {heard}")
    # the line on standard error: redrawn on a terminal and in a notebook, elsewhere a line for each finished step
    for name, module, is_terminal in (("a terminal", "io", True), ("a notebook", "ipykernel.iostream", False),
                                      ("a file", "io", False)):
        kind = type("OutStream", (io.StringIO,), {"isatty": lambda self, is_so=is_terminal: is_so})
        kind.__module__ = module
        before, sys.stderr = sys.stderr, kind()
        try:
            murk.Scene(ROOM, context=murk.Context(progress=True)).place()
            shown = sys.stderr.getvalue()
        finally:
            sys.stderr = before
        check(("\r" in shown) == (name != "a file") and "trace        100 %" in shown, f"progress in {name}: {shown!r}")
        check(shown.endswith("\n") and "\n\n" not in shown, f"the last line has an end in {name}: {shown!r}")
    # an exception of a callback stops the work and is raised

    def stop(step, *_):
        if step == "trace":
            raise LookupError("enough")

    context = murk.Context(progress=stop)
    world = murk.Scene({**ROOM, "photons": {"emit": 4000000000, "maps": "none"}}, context=context).world()
    for _ in range(2):
        try:
            world.trace()
        except LookupError as error:
            check(str(error) == "enough", "the exception of the callback")
        else:
            check(False, "the exception of a callback is raised")
    # cancel() from another thread
    context = murk.Context()
    world = murk.Scene({**ROOM, "photons": {"emit": 4000000000, "maps": "none"}}, context=context).world()
    threading.Timer(0.3, context.cancel).start()
    try:
        world.trace()
    except murk.Interrupted as error:
        check(error.code == "MURK_INTERRUPTED", error.code)
    else:
        check(False, "Interrupted is raised")


def pickles():
    """Results keep their values through pickle, without the library."""
    scene = murk.Scene(ROOM, cameras=[{"name": "gate", "from_m": [1, 1, 2], "to_m": [5, 5, 1], "pixels": [12, 8]}])
    scene["media.fog"] = {"vdb": "memory:fog", "extinction_per_m": 1, "albedo": 0.9, "phase": {"hg": 0.7}}
    scene.add_grid("fog", numpy.random.default_rng(1).random((5, 5, 5)), cell_m=2, origin_m=(1, 1, 1))
    light = scene.trace()
    light.volume[:3].copy()
    copy = pickle.loads(pickle.dumps(light))
    for name in ("surface", "volume"):
        check((getattr(copy, name) == getattr(light, name)).all(), f"records of the {name} map")
        for field in ("position_m", "direction", "normal", "event_class", "power_w"):
            check((copy.array(name, field) == light.array(name, field)).all(), field)
    check(copy.ledger == light.ledger and list(copy.tallies) == ["box", "floor"], "ledger and tallies")
    check((copy.tally("box").values == light.tally("box").values).all(), "values of a tally")
    picture, plan = light.render(), light.place()
    seen = light.sense(plan.sensors)
    again = pickle.loads(pickle.dumps([picture, plan, seen]))
    check((again[0].radiance == picture.radiance).all() and (again[0].rgb == picture.rgb).all(), "a picture")
    check(again[1].result == plan.result and again[1].coverage == plan.coverage, "a plan")
    check(again[2].coverage.in_sample == seen.coverage.in_sample, "a coverage")
    check(pickle.loads(pickle.dumps(copy)).ledger == light.ledger, "a pickle of a pickle")
    for work in (copy.place, copy.render, lambda: copy.save("x"), lambda: again[0].save("x"), lambda: again[1].save("x"),
                 lambda: copy.tally("boxes"), lambda: again[2].matrix):
        try:
            work()
        except murk.Error as error:
            check("pickled" in str(error), str(error))
        else:
            check(False, "a pickled result says that it has values alone")
    # scenes: keys and arrays travel
    twin = pickle.loads(pickle.dumps(scene))
    check((twin.trace().volume == light.volume).all(), "light of a pickled scene")


def keys():
    """Scenes from Python values."""
    scene = murk.Scene({**ROOM, "seed": numpy.int64(3)}, **{"photons.emit": numpy.float64(1000)})
    scene["lights.0.center_m"] = numpy.array([5, 5, 3.5])
    check(scene["lights.0.center_m"] == [5, 5, 3.5] and scene["seed"] == 3, "NumPy values as keys")
    check(scene["photons.emit"] == 1000 and "media.fog" in scene and "media.smoke" not in scene, "keys")
    scene["geometry.0.name"] = "walls"
    check(scene["geometry.walls.name"] == "walls" and "geometry.floor" not in scene, "items by their names")
    # the scene is resolved once for an answer, and once for the names of tallies of a world
    call_in, calls = murk._scene.call_in, []
    murk._scene.call_in = lambda *arguments: (calls.append(arguments[1]), call_in(*arguments))
    check("media.fog" in scene and len(calls) == 1, f"calls of `in`: {calls}")
    check(scene.world().tallies == ["box", "floor"] and len(calls) == 2, f"calls of world(): {calls}")
    murk._scene.call_in = call_in
    try:
        found = "media.smoke" in murk.Scene({**ROOM, "seed": -1})
    except murk.Error as error:
        check(error.key == "seed", str(error))
    else:
        check(False, f"`in` raises the error of a wrong scene, and is not {found}")
    plan = scene.place()
    check(plan.coverage.held_out == plan["coverage"]["held_out"] == plan.result.get_path("coverage.held_out"),
          "fields by attribute, item and path")
    dotted = murk.Result({"a": murk.Result({"b.001": murk.Result(total=1), "b": [2, murk.Result(total=3)], "": 4}),
                          "a.b": 5})
    for path, value in (("a.b.001.total", 1), ("a.b.0", 2), ("a.b.1.total", 3), ("a.", 4), ("a.b", 5)):
        check(dotted.get_path(path) == value, f"{path}: the longest name that leads to a value")
    for path, kind in (("a.b.2", IndexError), ("a.b.001.none", KeyError), ("a.c", KeyError), ("a.b.x", KeyError),
                       ("a.b.0.x", KeyError)):
        try:
            dotted.get_path(path)
        except kind:
            continue
        check(False, f"{path}: raises {kind.__name__}")
    try:
        plan.colour
    except AttributeError as error:
        check("colour" in str(error) and "sensors" in str(error), str(error))
    # a grid in place: the same light, and the array is the caller's
    values = numpy.asfortranarray(numpy.random.default_rng(1).random((5, 5, 5)), dtype=numpy.float32)
    lights = []
    for copy in (True, False):
        scene = murk.Scene(ROOM)
        scene["media.fog"] = {"vdb": "memory:fog", "extinction_per_m": 1, "albedo": 0.9}
        scene.add_grid("fog", values, cell_m=2, origin_m=(1, 1, 1), copy=copy)
        lights.append(scene.trace().volume.copy())
    check((lights[0] == lights[1]).all(), "a grid in place is the same grid")
    rows = murk.Scene(ROOM).study({"media.fog.extinction_per_m": numpy.array([0.1, 0.3])}, ["density"]).rows
    check(len(rows) == 2 and rows[0]["values"] != rows[1]["values"], "a study of a scene")


def leaks():
    """1000 scenes, 100 worlds with light, plans and coverages, and no more memory. A scene that is not freed leaves at
    least its text; half of that is the limit, the mean over the scenes."""
    limit = len(json.dumps(ROOM)) / 2

    def scene_alone():
        scene = murk.Scene(ROOM)
        scene.add_grid("unused", numpy.zeros((16, 16, 16)))
        scene.add_mesh("unused", [[0, 0, 0], [0, 1, 0], [1, 0, 0]], [[0, 1, 2]])
        scene.check()
        try:
            scene["photons.emit"] = "x"
            scene.check()
        except murk.Error:
            pass

    def all_of_it():
        light = murk.Scene({**ROOM, "photons": {"emit": 200, "max_stored": 1000}}).trace(lambda batch: batch.volume)
        light.array("volume", "direction")
        light.tally("box")
        light.place()
        light.sense([{"type": "node", "position_m": [5, 5, 2]}]).matrix

    for work, n in ((scene_alone, 1000), (all_of_it, 100)):
        for _ in range(n // 10):
            work()
        gc.collect()
        before = allocated_bytes()
        for _ in range(n):
            work()
        gc.collect()
        left = (allocated_bytes() - before) / n
        check(left < limit, f"{work.__name__} leaves {left:.0f} bytes, at most {limit:.0f}")


def closed_library():
    """A library that its last user has closed stays loaded, for the sake of threads of Embree, which outlive all calls:
    the interpreter closes it at its end."""
    still = ("import _ctypes, ctypes, os, sys\n"
             "handle = ctypes.CDLL(sys.argv[1])._handle\n"
             "_ctypes.dlclose(handle)\n"
             "ctypes.CDLL(sys.argv[1], mode=os.RTLD_NOLOAD)\n")  # raises OSError if it is not loaded
    run = subprocess.run([sys.executable, "-c", still, os.environ["MURK_LIBRARY"]], capture_output=True, text=True)
    check(run.returncode == 0, f"a closed library is loaded: {run.stderr}")


def main():
    closed_library()
    with tempfile.TemporaryDirectory() as folder:
        program_agrees(folder)
        study_and_fit_agree(folder)
        pictures(folder)
    arrays()
    grids_and_meshes()
    warnings_of_calls()
    examples_of_arrays()
    keys()
    interpreter_is_free()
    interrupt()
    batches()
    updates()
    progress_and_log()
    pickles()
    leaks()
    done()


main()
