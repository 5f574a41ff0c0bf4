"""The most common mistakes, each of which raises murk.Error: with the key of the scene, with file, line and column
where a file is read, with a text of its own that says what is wrong, and without a word of the command line.

    python_errors.py MURK LIBRARY
"""
import json
import os
import pickle
import tempfile

from python_module import ROOM, check, done, murk

import numpy

# Changes of a room that is right, the key that is blamed and a part of the text.
SCENES = [
    ({"murk": 2}, "murk", "2"),
    ({"photon": {"emit": 1}}, "photon", "did you mean photons"),
    ({"photons": {"emit": -1}}, "photons.emit", "-1"),
    ({"photons": {"emit": "many"}}, "photons.emit", "many"),
    ({"photons": {"emit": 10, "store": 10}}, "photons", ""),
    ({"bands_nm": []}, "bands_nm", ""),
    ({"bands_nm": [-10]}, "bands_nm.0", "-10"),
    ({"bands_nm": list(range(400, 420))}, "bands_nm", ""),
    ({"lights": []}, "lights", "at least one"),
    ({"lights": [{"type": "lamp"}]}, "lights.0.type", "lamp"),
    ({"lights": [{"type": "point", "position_m": [1, 1], "power_w": 1}]}, "lights.0.position_m", ""),
    ({"lights": [{"type": "point", "position_m": [1, 1, 1], "power_w": -3}]}, "lights.0.power_w", "-3"),
    ({"lights": [{"type": "point", "position_m": [1, 1, 1]}]}, "lights.0", "power_w"),
    ({"media": {"fog": {"albedo": 1.5, "extinction_per_m": 1}}}, "media.fog.albedo", "1.5"),
    ({"media": {"fog": {"preset": "fog/thick"}}}, "media.fog.preset", "fog/thick"),
    ({"media": {"fog": {"extinction_per_m": 1, "albedo": 1, "phase": {"hg": 2}}}}, "media.fog.phase.hg", "2"),
    ({"media": {"fog": {"extinction": 1, "albedo": 1}}}, "media.fog.extinction", "did you mean extinction_per_m"),
    ({"regions": [{"medium": "smoke"}]}, "regions.0.medium", "smoke"),
    ({"materials": {"default": {"diffuse": 0.8, "specular": 0.8}}}, "materials.default", ""),
    ({"geometry": [{"rect": {"corner_m": [0, 0, 0], "edge1_m": [1, 0, 0]}}]}, "geometry.0.rect", "edge2_m"),
    ({"sensors": {**ROOM["sensors"], "count": 0}}, "sensors.count", "0"),
    ({"sensors": {**ROOM["sensors"], "types": []}}, "sensors.types", ""),
    ({"placement": {"method": "fastest"}}, "placement.method", "fastest"),
    ({"domain": {"min_m": [0, 0, 0], "max_m": [0, 1, 1]}}, "domain", ""),
    ({"site": {"time": "yesterday"}}, "site.time", "yesterday"),
    ({"tallies": [{"name": "a", "type": "cube"}]}, "tallies.0.type", "cube"),
]
NODE = {"type": "node", "position_m": [5, 5, 2]}


def room(**keys):
    return murk.Scene({**ROOM, **keys})


def study_with_an_array():
    scene = room()
    scene.add_mesh("hall", [[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    return scene.study({"seed": [1, 2]}, ["density"])


# Calls, and the file, key and part of the text of the error.
CALLS = [
    (lambda: murk.Scene("murk: [1"), "scene", "", ""),
    (lambda: murk.Scene("").check(), "scene", "", ""),
    (lambda: murk.Scene("murk: 1").check(), "scene", "", "lights"),
    (lambda: murk.Scene(ROOM, file="room.yaml"), "", "", "one of"),
    (lambda: murk.Scene(file="/nowhere/room.yaml"), "/nowhere/room.yaml", "", "/nowhere/room.yaml"),
    (lambda: room(geometry=[{"file": "/nowhere/hall.obj"}]).world(), "", "geometry.0", "/nowhere/hall.obj"),
    (lambda: room(geometry=[{"file": "memory:hall"}]).world(), "", "geometry.0", "was added"),
    (lambda: room(media={"fog": {"vdb": "/nowhere/x.vdb", "extinction_per_m": 1, "albedo": 0}}).world(), "", "media.fog",
     "/nowhere/x.vdb"),
    (lambda: room().__setitem__("sensors.cuont", 3), "", "sensors.cuont", "count"),
    (lambda: room().__setitem__("sensors.count", float("nan")), "", "sensors.count", "nan"),
    (lambda: room().__setitem__("sensors.count", object()), "", "sensors.count", "object"),
    (lambda: room()["media.smoke"], "", "media.smoke", "smoke"),
    (lambda: room().trace().tally("boxes"), "", "", "boxes"),
    (lambda: room().trace().array("volume", "colour"), "", "", "colour"),
    (lambda: room().trace().array("walls", "power_w"), "", "", "walls"),
    (lambda: room().trace().sense([{**NODE, "position_m": [50, 0, 0]}]), "", "", "domain"),
    (lambda: room().trace().sense([{**NODE, "type": "eye"}]), "", "", "eye"),
    (lambda: room().trace().sense([{**NODE, "type": "cam"}]), "", "", "heading_deg"),
    (lambda: room().trace().sense([]), "", "", ""),
    (lambda: room().trace().sense("/nowhere/plan.json"), "/nowhere/plan.json", "", ""),
    (lambda: room().render(), "", "", "camera"),
    (lambda: room().render(method="rays"), "", "", "rays"),
    (lambda: room().world().read_light("/nowhere/light.murk"), "/nowhere/light.murk", "", ""),
    (lambda: room().trace().save("/dev/null/deep"), "/dev/null/deep", "", ""),
    (lambda: room().fit("/nowhere/data.csv", ["media.fog.albedo"]), "/nowhere/data.csv", "", ""),
    (lambda: murk.study("/nowhere/study.yaml"), "/nowhere/study.yaml", "", ""),
    (lambda: murk.report("/nowhere"), "/nowhere", "", ""),
    (lambda: room(timeline={"times_s": [0, 1]}, placement={"moves_at_most": 1}).follow(exports=["lp"]), "", "placement",
     "moves_at_most is given, which the export lp does not take"),
    (lambda: room().add_grid("x", numpy.full((2, 2, 2), -1.0)), "x", "", "-1"),
    (lambda: room().add_grid("x", numpy.ones((2, 2, 2)), 0), "x", "", "index_to_world: is singular"),
    (lambda: room().add_grid("x", numpy.zeros((2, 2))), "", "", "dimensions"),
    (lambda: room().add_grid("x", numpy.zeros((2, 2, 2)), copy=False), "", "", "float32"),
    (lambda: room().add_mesh("x", [[0, 0, 0]], [[0, 0, 1]]), "x", "", "triangles"),
    (lambda: room().add_mesh("x", [[0, 0, float("nan")]], [[0, 0, 0]]), "x", "", "vertices_m"),
    (lambda: room().add_mesh("x", [[0, 0, 0]], [[0, 0, -1]]), "", "", "whole numbers"),
    (lambda: room().add_table("x", x_m=[1, 2], y_m=[1]), "", "", "equal length"),
    (study_with_an_array, "", "", "memory:hall: was added to the scene as an array"),
]
texts = {}


def raised(work, name):
    """The error of a call, which also survives pickling."""
    try:
        work()
    except murk.Error as error:
        shown = f"{name}: {error} (file {error.file!r}, line {error.line}, key {error.key!r})"
        check(error.code.startswith("MURK_") and error.text, shown)
        check("--" not in str(error), f"no option of the command line: {shown}")
        copy = pickle.loads(pickle.dumps(error))
        check((str(copy), copy.key, copy.line) == (str(error), error.key, error.line), "an error can be pickled")
        return error, shown
    check(False, f"{name} raises murk.Error")
    return None


def main():
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "room.yaml")
        for number, (change, key, part) in enumerate(SCENES):
            # From a dict: the key is the place.
            error, shown = raised(murk.Scene({**ROOM, **change}).check, f"scene {number}")
            check(error.key == key and part in error.text, shown)
            check((error.file, error.line) == ("", 0), shown)
            # From a file: the line that has the key, or the item of a list.
            with open(path, "w", encoding="utf-8") as file:
                json.dump({"murk": 1, **ROOM, **change}, file, indent=1)
            with open(path, encoding="utf-8") as file:
                lines = file.read().split("\n")
            of_file, shown = raised(murk.Scene(file=path).check, f"file {number}")
            check((of_file.file, of_file.key, of_file.text) == (path, key, error.text), shown)
            name = [word for word in key.split(".") if not word.isdigit()][-1]
            near = "\n".join(lines[max(0, of_file.line - 2):of_file.line])
            check(of_file.line > 0 and of_file.column > 0 and f'"{name}"' in near, f"{shown}: {near}")
            texts[error.text] = number
    for number, (work, file, key, part) in enumerate(CALLS):
        error, shown = raised(work, f"call {number}")
        check(error.file == file and error.key == key and part in str(error), shown)
        texts[str(error)] = number
    check(len(texts) == len(SCENES) + len(CALLS) and len(texts) >= 30, f"{len(texts)} errors with a text of their own")
    # an inner place of a text
    error, shown = raised(murk.Scene("murk: 1\nlights:\n  - {type: point, position_m: [0, 0, 0], power_w: x}\n").check, "x")
    check((error.file, error.line, error.column, error.key) == ("scene", 3, 51, "lights.0.power_w"), shown)
    done()


main()
