#!/usr/bin/env python3
"""The reader of NetCDF files: optical depths of columns against values read by
another reader (../shared/data/frontier/netcdf), and files written here with
packed values, missing values, falling and exchanged axes, kilometres, bounds of
cells and several times, against sums made here; effective radii as murk check
tells them, and the droplets that follow from them. Standard library only.
usage: netcdf.py MURK
"""

import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "tests/support")]
from netcdf_file import write_classic  # noqa: E402
from sightlines import check, finish, predicted  # noqa: E402

DATA = pathlib.Path("../shared/data/frontier/netcdf")

murk = pathlib.Path(sys.argv[1]).resolve()

SCENE = """murk: 1
bands_nm: [550]
domain: {min_m: [-2e4, -2e4, -2e4], max_m: [2e4, 2e4, 2e4], sides: open}
media:
  cloud: {%s}
regions:
  - {medium: cloud}
lights:
  - {type: point, position_m: [0, 0, 1.9e4], power_w: 1}
"""


def depths(folder, keys, lines):
    """Optical depths along lines (six coordinates each), or the error."""
    got = predicted(murk, folder, SCENE % keys, lines, "fraction")
    return got if isinstance(got, str) else [-math.log(value) for value in got]


# ---- the reference ----

def compare_reference(folder, file, name):
    with open(DATA / file) as lines:
        rows = list(csv.DictReader(line for line in lines if line[0] != "#"))
    for rule in ("cells", "trapezoid"):
        for frame in sorted({row["frame"] for row in rows if row["what"] == "column"}):
            own = [row for row in rows if row["what"] == "column" and row["variable"] == f"tau_{rule}"
                   and row["frame"] == frame]
            # middles of the columns: x = 10 + 20 i, y likewise
            lines = [[10 + 20.0 * int(row["i"]) + 1e-3, 10 + 20.0 * int(row["j"]) + 1e-3, -10.0,
                      10 + 20.0 * int(row["i"]) + 1e-3, 10 + 20.0 * int(row["j"]) + 1e-3, 5000.0] for row in own]
            if rule == "trapezoid":
                for line in lines:
                    line[0] -= 1e-3
                    line[1] -= 1e-3
                    line[3] -= 1e-3
                    line[4] -= 1e-3
            got = depths(folder, f"netcdf: {(DATA / name).resolve()}, albedo: 1, time_s: {times(name)[int(frame)]}, "
                         f"interpolation: {'nearest' if rule == 'cells' else 'linear'}", lines)
            for row, tau in zip(own, got, strict=True):
                want = float(row["value"])
                check(abs(tau - want) <= 1e-6 * max(want, 1e-3), f"{name} {row}: {tau}")


def times(name):
    """The times of a file's frames after the first, which murk itself tells when a time is out of range."""
    return TIMES[name]


TIMES = {"rico32x37x26.nc": [0], "rico32x37x26_3frames_classic.nc": [0, 60, 120]}


# ---- files of our own ----

X, Y, Z = [0.0, 100.0, 250.0], [0.5, 0.2], [100.0, 300.0, 400.0, 1000.0]  # m, km and falling, m


def water(i, j, k, frame):
    return (i + 2 * j + 3 * k + 1 + 5 * frame) / 100 if k else 0.0


def own_files(folder):
    """One field as a plain file and, exchanged and packed, as another."""
    plain = {
        "x": (["x"], "d", {"units": "m"}, X), "y": (["y"], "d", {"units": "km"}, Y),
        "z": (["z"], "d", {"units": "m", "axis": "Z"}, Z),
        "time": (["time"], "d", {"units": "minutes since 2000-01-01"}, [10, 11, 13]),
        "lwc": (["time", "z", "y", "x"], "f", {"units": "g m-3", "_FillValue": ("f", -999.0)},
                [-999.0 if (i, j, k) == (2, 1, 3) else water(i, j, k, t)
                 for t in range(3) for k in range(4) for j in range(2) for i in range(3)])}
    write_classic(folder / "plain.nc", {"time": 0, "x": 3, "y": 2, "z": 4}, plain)
    back = dict(plain)  # times that fall
    back["time"] = (["time"], "d", {"units": "minutes since 2000-01-01"}, [13, 11, 10])
    values = plain["lwc"][3]
    back["lwc"] = (*plain["lwc"][:3], values[48:] + values[24:48] + values[:24])
    write_classic(folder / "back.nc", {"time": 0, "x": 3, "y": 2, "z": 4}, back)
    packed = {
        "e": (["e"], "d", {"units": "m", "axis": "X", "bounds": "e_bounds"}, X),
        "e_bounds": (["e", "two"], "d", {}, [50, -50, 175, 50, 325, 175]), "n": (["n"], "d", {"units": "km", "axis": "Y"}, Y),
        "up": (["up"], "d", {"units": "m", "standard_name": "height", "bounds": "up_bounds"}, Z[::-1]),
        "up_bounds": (["up", "two"], "d", {}, [1300, 700, 700, 350, 350, 200, 200, 0]),
        "liquid": (["e", "n", "up"], "h", {"units": "kg m-3", "scale_factor": ("d", 1e-5), "add_offset": ("d", 0.0),
                                           "missing_value": ("h", -1), "valid_range": ("h", 0, 32000)},
                   [-1 if (i, j, k) == (2, 1, 3) else round(100 * water(i, j, k, 0))
                    for i in range(3) for j in range(2) for k in (3, 2, 1, 0)])}
    write_classic(folder / "packed.nc", {"e": 3, "n": 2, "up": 4, "two": 2}, packed)


def column(i, j, weight, radius_um):
    """Optical depth of a column: cells from middle to middle."""
    edges = [0, 200, 350, 700, 1300]
    total = 0
    for k in range(4):
        values = [0 if (i, j, k) == (2, 1, 3) else water(i, j, k, t) for t in range(3)]
        value = (1 - weight) * values[0] + weight * values[1]
        total += 1.5 * value / radius_um * (edges[k + 1] - edges[k])
    return total


def compare_own(folder):
    own_files(folder)
    places = [(i, j) for i in range(3) for j in range(2)]
    lines = [[X[i] + 1, 1000 * Y[j] + 1, -100.0, X[i] + 1, 1000 * Y[j] + 1, 5000.0] for i, j in places]
    keys = "albedo: 1, effective_radius_um: 10, "
    for file, name, weight, time_s in (("plain.nc", "lwc", 0, 0), ("plain.nc", "lwc", 0.25, 15),
                                       ("plain.nc", "lwc", 1, 60), ("packed.nc", "liquid", 0, 0),
                                       ("back.nc", "lwc", 0, 0), ("back.nc", "lwc", 0.25, 15)):
        got = depths(folder, keys + f"netcdf: {folder / file}, liquid_water: {name}, time_s: {time_s}", lines)
        if isinstance(got, str):
            check(False, got)
            continue
        for (i, j), tau in zip(places, got, strict=True):
            want = column(i, j, weight, 10)
            check(abs(tau - want) <= 2e-6 * max(want, 1e-2), f"{file} at {time_s} s, column {i} {j}: {tau}, {want}")
    # depths, packed coordinates, a default fill value and a valid range, of bytes that say no more
    write_classic(folder / "deep.nc", {"x": 2, "y": 2, "depth": 3}, {
        "x": (["x"], "h", {"units": "m", "scale_factor": ("d", 100.0), "add_offset": ("d", 50.0)}, [0, 1]),
        "y": (["y"], "d", {"units": "m"}, [0.0, 10.0]),
        "depth": (["depth"], "d", {"units": "m", "positive": "down", "axis": "Z"}, [1.0, 3.0, 5.0]),
        "mud": (["depth", "y", "x"], "h", {"units": "g m-3", "scale_factor": ("d", 0.01), "valid_max": ("h", 50)},
                [10, 20, 10, 20, 30, -32767, 30, 40, 60, 40, 10, 10])})
    # columns: cells of 2 m from the surface down to 6 m
    got = depths(folder, f"albedo: 1, netcdf: {folder / 'deep.nc'}, variable: mud",
                 [[x, y, -7.0, x, y, 1.0] for y in (1.0, 9.0) for x in (51.0, 149.0)]
                 + [[51.0, 1.0, -1.9, 51.0, 1.0, -0.1]])
    for tau, want in zip(got, [2 * .1 + 2 * .3, 2 * .2 + 2 * .4, 2 * .1 + 2 * .3 + 2 * .1, 2 * .2 + 2 * .4 + 2 * .1,
                               1.8 * .1], strict=True):
        check(abs(tau - want) <= 2e-6, f"deep: {tau}, {want}")
    # a field that has one axis twice is none
    write_classic(folder / "twice.nc", {"x": 3, "y": 3, "z": 3}, {
        name: ([name], "d", {"units": "m"}, [0.0, 1.0, 2.0]) for name in "xyz"} | {
        "lwc": (["z", "y", "x"], "f", {"units": "g m-3"}, [1.0] * 27),
        "reff": (["z", "z", "y"], "f", {"units": "um"}, [10.0] * 27)})
    got = depths(folder, f"albedo: 1, netcdf: {folder / 'twice.nc'}, liquid_water: lwc, effective_radius: reff", lines[:1])
    check(isinstance(got, str) and "reff: must have the axes" in got, f"twice: {got}")
    # any variable by a factor: a tenth of the water
    got = depths(folder, f"albedo: 1, netcdf: {folder / 'plain.nc'}, variable: lwc, per_unit: 0.015", lines)
    for (i, j), tau in zip(places, got, strict=True):
        check(abs(tau - column(i, j, 0, 100)) <= 2e-6, f"factor, column {i} {j}")
    refused = [("time_s: 200, liquid_water: lwc", "must be 0 to 180 s"), ("liquid_water: ice", "fields in it: lwc"),
               ("", "has no variable mass_concentration")]
    for more, problem in refused:
        got = depths(folder, keys + f"netcdf: {folder / 'plain.nc'}, {more}", lines[:1])
        check(isinstance(got, str) and problem in got and got.count("\n") == 1, f"{more}: {got}")
    # cut off anywhere: an error of one line, or a warning's values
    whole = (folder / "plain.nc").read_bytes()
    for part in range(0, len(whole) - 200, len(whole) // 12):
        (folder / "cut.nc").write_bytes(whole[:part])
        got = depths(folder, keys + f"netcdf: {folder / 'cut.nc'}, liquid_water: lwc", lines[:1])
        check(isinstance(got, str) and got.count("\n") == 1 and "cut.nc" in got, f"cut at {part}: {got}")


def compare_radii(folder):
    """murk check tells range and mean of the effective radii, by extinction and volume, where there is cloud."""
    def radius(i, j, k, frame):
        return (5 + i + 2 * j + 0.5 * k + frame) * 1e-6
    plain = {
        "x": (["x"], "d", {"units": "m"}, X), "y": (["y"], "d", {"units": "km"}, Y),
        "z": (["z"], "d", {"units": "m", "axis": "Z"}, Z),
        "time": (["time"], "d", {"units": "seconds since 2000-01-01"}, [0, 60, 180])}
    order = [(i, j, k, t) for t in range(3) for k in range(4) for j in range(2) for i in range(3)]
    for name, unit, law in (("lwc", "g m-3", water), ("reff", "m", radius)):
        plain[name] = (["time", "z", "y", "x"], "d", {"units": unit}, [law(*place) for place in order])
    write_classic(folder / "radii.nc", {"time": 0, "x": 3, "y": 2, "z": 4}, plain)
    lengths = {"nearest": ([100, 125, 150], [300, 300], [200, 150, 350, 600]),
               "linear": ([50, 125, 75], [150, 150], [100, 150, 350, 300])}
    for rule, (x, y, z) in lengths.items():
        for time_s, parts in ((0, {0: 1}), (15, {0: .75, 1: .25}), (180, {2: 1})):
            sums, radii = [0, 0], []
            for i, j, k, t in order:
                um = 1e6 * radius(i, j, k, t)
                if t in parts and water(i, j, k, t) > 0:
                    weight = parts[t] * 1.5 * water(i, j, k, t) / um * x[i] * y[j] * z[k]
                    sums = [sums[0] + weight, sums[1] + weight * um]
                    radii.append(um)
            scene = folder / "radii.yaml"
            scene.write_text(SCENE % (f"albedo: 1, netcdf: {folder / 'radii.nc'}, liquid_water: lwc, effective_radius: reff, "
                                      f"time_s: {time_s}, interpolation: {rule}"))
            said = " ".join(subprocess.run([murk, "check", scene], text=True, capture_output=True).stdout.split())
            when = "; between two times from 1 of 3" if len(parts) > 1 else f"; time {max(parts) + 1} of 3"
            want = f"3 L / (2 r), r {min(radii):.3g}..{max(radii):.3g} um, by extinction {sums[1] / sums[0]:.4g} um in the mean{when}"
            check(want in said, f"{rule} at {time_s} s: {want} not in {said}")


def extinction_of(preset, word, value):
    """By murk media, which evaluates the preset at that value."""
    done = subprocess.run([murk, "media", preset, "--set", f"{word}={value}", "--set", "bands_nm=[550]", "--format", "json"],
                          text=True, capture_output=True)
    return json.loads(done.stdout)["bands"][0]["extinction_per_m"]


def compare_word(folder):
    """A variable that is the amount of a word of a preset: optical depths of a column are those of the preset at each
    value, which the law between its points meets within 1e-3; proportional extinction would be off by tens of percent."""
    chlorophyll = [.02, .173, .5, 2.9, 11.7]
    write_classic(folder / "sea.nc", {"x": 2, "y": 2, "z": 5}, {
        "x": (["x"], "d", {"units": "m"}, [5, 15]), "y": (["y"], "d", {"units": "m"}, [5, 15]),
        "z": (["z"], "d", {"units": "m", "axis": "Z"}, [-45, -35, -25, -15, -5]),
        "chl": (["z", "y", "x"], "d", {"units": "kg m-3"}, [c * 1e-6 for c in chlorophyll for _ in range(4)])})
    keys = (f"preset: water/case-1, netcdf: {folder / 'sea.nc'}, variable: chl, per_unit: 1e6, "
            "word: chlorophyll_mg_per_m3, chlorophyll_mg_per_m3: 1")
    got = depths(folder, keys, [(5, 5, -50 + 10 * k, 5, 5, -40 + 10 * k) for k in range(5)])
    check(not isinstance(got, str), got)
    off = 0
    for tau, value in zip(got, chlorophyll, strict=True):
        want = 10 * extinction_of("water/case-1", "chlorophyll_mg_per_m3", value)
        check(abs(tau - want) <= 1e-3 * want, f"word at {value}: {tau}, {want}")
        off = max(off, abs(value * 10 * extinction_of("water/case-1", "chlorophyll_mg_per_m3", 1) / want - 1))
    check(off > .3, f"a proportional law is off by {off}")
    refused = [(keys.replace("variable: chl, ", ""), "misses variable"),
               (keys.replace("word: chlorophyll_mg_per_m3", "word: soot_g_per_m3"), "is no word of this preset")]
    for more, problem in refused:
        got = depths(folder, more, [(5, 5, -50, 5, 5, 0)])
        check(isinstance(got, str) and problem in got and got.count("\n") == 1, f"{more}: {got}")


def compare_models(folder):
    """What files of models have: times that count from a year far away, a dimension of an ensemble, rounding below 0,
    unsigned numbers in types that have a sign, and units as programs write them."""
    def column_of(file, keys):
        got = depths(folder, f"albedo: 1, netcdf: {file}, {keys}", [(5, 5, -50, 5, 5, 50)])
        return got if isinstance(got, str) else got[0]

    def write(file, values, unit="g m-3", kind="d", times=None, more=None, extra=None):
        """A column of two cells of 10 m, from -10 m on."""
        dimensions = {"x": 2, "y": 2, "z": 2}
        own = ["z", "y", "x"]
        axes = {"x": (["x"], "d", {"units": "m"}, [5, 15]), "y": (["y"], "d", {"units": "m"}, [5, 15]),
                "z": (["z"], "d", {"units": "m", "axis": "Z"}, [-5, 5])}
        for name, length in (extra or {}).items():
            dimensions[name] = length
            own.insert(0, name)
        if times:
            dimensions["time"] = len(times[1])
            axes["time"] = (["time"], "d", {"units": times[0]}, times[1])
            own.insert(0, "time")
        axes["lwc"] = (own, kind, {"units": unit, **(more or {})}, [v for v in values for _ in range(4)])
        write_classic(folder / file, dimensions, axes)
        return folder / file

    # three times, of water .1, .2 and .4: 3 L / (2 r) along 20 m is 3 L for a radius of 10 um
    keys = "liquid_water: lwc, effective_radius_um: 10"
    for unit, step, far in (("seconds since 1970-01-01", 1, 1.7e9), ("days since 1970-01-01", .86 / 86400, 20000.0),
                            ("hours since 0001-01-01", 30 / 3600, 17.7e6), ("seconds since 2000-01-01", 1, 0)):
        file = write("times.nc", [.1, .1, .2, .2, .4, .4], times=(unit, [far + k * step for k in range(3)]))
        second = {"s": 1, "d": 86400, "h": 3600}[unit[0]] * step
        for at, want in ((0, .1), (.5, .15), (1, .2), (1.75, .35), (2, .4)):
            got = column_of(file, f"{keys}, time_s: {at * second!r}")
            # the rounding of times of 1e9 s, and of days
            check(not isinstance(got, str) and abs(got / (3 * want) - 1) <= 1e-5, f"{unit}, {at} of a step: {got}")
    for unit, factor in (("g m-3 ", 1), ("g m^-3", 1), ("kg m**-3", 1000), (" mg/m3", .001)):
        got = column_of(write("unit.nc", [.1, .1], unit=unit), keys)
        check(not isinstance(got, str) and abs(got / (.3 * factor) - 1) <= 1e-6, f"unit {unit}: {got}")
    got = column_of(write("ratio.nc", [1e-4, 1e-4], unit="kg kg-1"), keys)
    check(isinstance(got, str) and 'has the unit "kg kg-1", must be g m-3' in got, f"mixing ratio: {got}")
    got = column_of(write("member.nc", [.1, .1], extra={"member": 1}), keys)
    check(not isinstance(got, str) and abs(got / .3 - 1) <= 1e-6, f"one member: {got}")
    got = column_of(write("members.nc", [.1] * 4, extra={"member": 2}), keys)
    check(isinstance(got, str) and "member" in got and got.count("\n") == 1, f"two members: {got}")
    # a small negative value is 0 with a warning, a large one an error
    got = column_of(write("noise.nc", [-1e-7, .1]), keys)
    check(not isinstance(got, str) and abs(got / .15 - 1) <= 1e-6, f"noise: {got}")
    done = run_scene(folder, "check", f"albedo: 1, netcdf: {folder / 'noise.nc'}, {keys}")
    check("4 values are slightly below 0 and count as 0" in done.stderr, done.stderr)
    got = column_of(write("negative.nc", [-1e-4, .1]), keys)
    check(isinstance(got, str) and "must be 0 or more" in got, f"negative: {got}")
    # bytes of 0..255, of which 255 is missing
    got = column_of(write("bytes.nc", [-56, -1], kind="b", more={
        "_Unsigned": "true", "scale_factor": ("d", .001), "_FillValue": ("b", -1)}), keys)
    check(not isinstance(got, str) and abs(got / (1.5 * .2) - 1) <= 1e-6, f"unsigned bytes: {got}")
    # a word may have values below 0
    cold = write("cold.nc", [-2.0, 10.0], unit="degC")
    got = column_of(cold, "preset: water/case-1, variable: lwc, word: temperature_c, chlorophyll_mg_per_m3: 1")
    check(not isinstance(got, str) and got > 0, f"temperature: {got}")


# ---- droplets whose albedo and phase function follow from the file ----

def write_droplets(file, rows):
    """Layers of 100 m, one for each pair of liquid water content [g/m3] and effective radius [um]."""
    write_classic(file, {"x": 2, "y": 2, "z": len(rows)}, {
        "x": (["x"], "d", {"units": "m"}, [50, 150]), "y": (["y"], "d", {"units": "m"}, [50, 150]),
        "z": (["z"], "d", {"units": "m", "axis": "Z"}, [50 + 100 * k for k in range(len(rows))]),
        "lwc": (["z", "y", "x"], "d", {"units": "g m-3"}, [water for water, _ in rows for _ in range(4)]),
        "reff": (["z", "y", "x"], "d", {"units": "um"}, [um for _, um in rows for _ in range(4)])})


BANDS = "bands_nm: [450, 1600]\n"
NAMES = "liquid_water: lwc, effective_radius: reff"


def run_scene(folder, command, keys, *more, bands=BANDS):
    (folder / "drops.yaml").write_text((SCENE % keys).replace("bands_nm: [550]\n", bands))
    return subprocess.run([murk, command, folder / "drops.yaml", *more], text=True, capture_output=True)


def medium_of(folder, keys, **more):
    """The medium as murk check tells it, or the error."""
    done = run_scene(folder, "check", keys, "--format", "json", **more)
    return json.loads(done.stdout)["media"][0] if done.returncode == 0 else done.stderr


def preset_of(folder, file, radius_um, variance, **more):
    """The medium with the preset of these droplets (Hansen and Travis 1974)."""
    return medium_of(folder, f"netcdf: {file}, {NAMES}, preset: cloud/droplets, "
                             f"droplet_shape: [{1 / variance - 3!r}, {1 / (radius_um * variance)!r}, 1]", **more)


def is_like(a, b, tolerance):
    """The same albedo and phase function in each band; 1 - albedo grows with the radius."""
    numbers = [[*medium["albedo"], *(phase[key] for phase in medium["phase"] for key in ("mean_cosine", "backward", "integral"))]
               for medium in (a, b)]
    return all(abs(x - y) <= tolerance * abs(y) for x, y in zip(*numbers, strict=True))


def compare_droplets(folder):
    """Albedo and phase function are those of the preset of the mean radius by extinction."""
    one, two = folder / "one.nc", folder / "two.nc"
    write_droplets(one, [(.3, 8.0), (0, 30.0), (.1, 8.0)])
    write_droplets(two, [(.3, 6.0), (0, 30.0), (.2, 16.0)])
    mean = (.3 / 6 * 6 + .2 / 16 * 16) / (.3 / 6 + .2 / 16)  # 8; by volume it would be 10, without weights 11
    for bands in (BANDS, "band_edges_nm: [600, 700, 2100]\n"):
        for file, keys, radius_um, variance in (
                (one, NAMES, 8, .1), (one, NAMES + ", effective_variance: 0.2", 8, .2), (two, NAMES, mean, .1),
                (two, "liquid_water: lwc, effective_radius_um: 9.5", 9.5, .1)):
            got = medium_of(folder, f"netcdf: {file}, {keys}", bands=bands)
            if isinstance(got, str):
                check(False, got)
                continue
            check(abs(got["effective_radius_um"] - radius_um) <= 1e-12 * radius_um and got["effective_variance"] == variance,
                  f"{keys}: {got}")
            want = preset_of(folder, file, radius_um, variance, bands=bands)
            check(is_like(got, want, 1e-11), f"{file.name}, {keys}: {got}, {want}")
            # another radius or variance is found; evaluating droplets takes half a second
            for wrong in ((1.001 * radius_um, variance), (radius_um, 1.001 * variance)) if file is two else ():
                check(not is_like(got, preset_of(folder, file, *wrong, bands=bands), 1e-11), f"{wrong} is like {radius_um}")
    # what is told on the terminal
    said = " ".join(run_scene(folder, "check", f"netcdf: {two}, {NAMES}").stdout.split())
    check("albedo 1 of droplets, r 8 um, variance 0.1; lwc" in said, said)
    # given albedos and presets count, and optical depths do not depend on the droplets
    plain = medium_of(folder, f"netcdf: {two}, {NAMES}, albedo: 0.9")
    check(plain["albedo"] == [.9, .9] and plain["mean_cosine"] == [0, 0] and "effective_radius_um" not in plain, f"{plain}")
    lines = [[50.0, 50.0, -10.0, 50.0, 50.0, 500.0]]
    check(depths(folder, f"netcdf: {two}, {NAMES}", lines) == depths(folder, f"netcdf: {two}, {NAMES}, albedo: 1", lines),
          "optical depths")
    # a file without droplets
    write_droplets(folder / "none.nc", [(0, 8.0), (0, 9.0)])
    none = medium_of(folder, f"netcdf: {folder / 'none.nc'}, {NAMES}")
    check(none["albedo"] == [1, 1] and none["mean_cosine"] == [0, 0] and none["effective_radius_um"] == 0, f"{none}")
    # refused, in one line
    write_droplets(folder / "rain.nc", [(.3, 400.0), (.1, 400.0)])
    for keys, bands, problem in (
            (f"netcdf: {folder / 'rain.nc'}, {NAMES}", BANDS, "radius of 400, must be 0.05..50 um; or give albedo and phase"),
            (f"netcdf: {one}, {NAMES}", "bands_nm: [2600]\n", "must be within 300..2500 nm for cloud/droplets"),
            (f"netcdf: {one}, {NAMES}, effective_variance: 0.5", BANDS, "must be 0.025..0.33"),
            (f"netcdf: {one}, {NAMES}, albedo: 1, effective_variance: 0.1", BANDS, "not a key of a medium (NetCDF file)"),
            (f"netcdf: {one}, {NAMES}, phase: isotropic", BANDS, "misses albedo"),
            (f"netcdf: {one}, variable: lwc", BANDS, "misses albedo")):
        got = medium_of(folder, keys, bands=bands)
        check(isinstance(got, str) and problem in got and got.count("\n") == 1, f"{keys}: {got}")


def compare_light(folder):
    """Stored light is that of its droplets: a file with the same extinctions and other radii does not take it over."""
    a, b, out = folder / "a" / "drops.nc", folder / "b" / "drops.nc", folder / "light"
    for file, factor in ((a, 1), (b, 2)):
        file.parent.mkdir()
        write_droplets(file, [(.25 * factor, 8.0 * factor), (.5 * factor, 8.0 * factor)])
    keys = [f"netcdf: {file}, {NAMES}" for file in (a, b)]
    run_scene(folder, "trace", keys[0], "-o", out, "--quiet", *SET)
    for given, problem in ((keys[0], ""), (keys[1], 'made for another light: it has "droplets of cloud, r in um: 8'),
                           (keys[0] + ", effective_variance: 0.2", "made for another light")):
        done = run_scene(folder, "place", given, "-o", folder / "plan", "--force", "--quiet", "--light", out / "light.murk",
                         *SET, "--set", SENSORS)
        check(problem in done.stderr and (done.returncode == 0) == (problem == ""), f"{given}: {done.stderr}")


SET = ["--set", "photons.emit=1000", "--set", "lights.0.position_m=[100, 100, 150]"]
SENSORS = ("sensors={types: [{name: s, range_m: 5000, view: {cone_deg: 60}}], count: 1, "
           "candidates: {grid: {min_m: [0, 0, 900], max_m: [100, 100, 1000], size: [2, 2, 2]}}}")


# ---- axes of longitude and latitude ----

def transverse_mercator(latitude, longitude, site):
    """x and y [m] on WGS84 with scale 1 about a site, by the series of Snyder 1987 (USGS professional paper 1395,
    doi:10.3133/pp1395, eqs. 3-21 and 8-9 to 8-10), which murk does not use; within 1 mm some degrees from the site."""
    a, f = 6378137.0, 1 / 298.257223563
    e2 = f * (2 - f)

    def arc(p):
        return a * ((1 - e2 / 4 - 3 * e2**2 / 64 - 5 * e2**3 / 256) * p
                    - (3 * e2 / 8 + 3 * e2**2 / 32 + 45 * e2**3 / 1024) * math.sin(2 * p)
                    + (15 * e2**2 / 256 + 45 * e2**3 / 1024) * math.sin(4 * p) - 35 * e2**3 / 3072 * math.sin(6 * p))
    p = math.radians(latitude)
    e2p, n = e2 / (1 - e2), a / math.sqrt(1 - e2 * math.sin(p)**2)
    t, c = math.tan(p)**2, e2 / (1 - e2) * math.cos(p)**2
    w = math.radians(math.remainder(longitude - site[1], 360)) * math.cos(p)
    x = n * (w + (1 - t + c) * w**3 / 6 + (5 - 18 * t + t * t + 72 * c - 58 * e2p) * w**5 / 120)
    y = arc(p) - arc(math.radians(site[0])) + n * math.tan(p) * (
        w**2 / 2 + (5 - t + 9 * c + 4 * c * c) * w**4 / 24 + (61 - 58 * t + t * t + 600 * c - 330 * e2p) * w**6 / 720)
    return x, y


def placed(longitudes, latitudes, site):
    """x of the meridians and y of the parallels, the middles of their ranges, and the largest distance of a crossing."""
    at = [[transverse_mercator(lat, lon, site) for lon in longitudes] for lat in latitudes]
    x = [(min(column) + max(column)) / 2 for column in zip(*([p[0] for p in row] for row in at))]
    y = [(min(p[1] for p in row) + max(p[1] for p in row)) / 2 for row in at]
    return x, y, max(math.dist(p, (x[i], y[j])) for j, row in enumerate(at) for i, p in enumerate(row))


def edges_of(middles):
    inner = [(a + b) / 2 for a, b in zip(middles, middles[1:])]
    return [2 * middles[0] - inner[0], *inner, 2 * middles[-1] - inner[-1]]


def mud(i, j):
    return (1 + (3 * i + 5 * j) % 8) / 64  # exact in single precision


def write_degrees(file, longitudes, latitudes, values, **more):
    """values: by the order of the file's axes, latitude outside; two layers alike. below: the cells of middles begin so
    far below them and are .5 wide."""
    bounds = {}
    if "below" in more:
        for name, middles in (("lon", longitudes), ("lat", latitudes)):
            bounds[name + "_bounds"] = ([name, "two"], "d", {}, [m - more["below"] + add for m in middles for add in (0, .5)])
    own = {name: {"bounds": name + "_bounds"} if bounds else {} for name in ("lon", "lat")}
    write_classic(file, {"lev": 2, "lat": len(latitudes), "lon": len(longitudes), "two": 2}, bounds | {
        "lon": (["lon"], "d", {"units": more.get("unit", "degrees_east")} | own["lon"], longitudes),
        "lat": (["lat"], "d", {"units": "degrees_north"} | own["lat"], latitudes),
        "lev": (["lev"], "d", {"units": "m", "axis": "Z", "standard_name": more.get("level", "height")}, [100.0, 300.0]),
        "mud": (["lev", "lat", "lon"], "f", {"units": "g m-3"}, values * 2)})


def at_site(site, keys, more=""):
    """The scene of murk check and of lines through the field."""
    place = f"site: {{latitude_deg: {site[0]}, longitude_deg: {site[1]}{more}}}\n" if site else ""
    return SCENE.replace("media:", place + "media:") % f"{keys}, variable: mud, albedo: 1"


def compare_degrees(folder):
    """Lines along x, y and z through fields on longitudes and latitudes, against the series of Snyder. Steps of .02
    degrees are 1.3 by 2.2 km; the cells of the file are those of x and y within some metres, which murk check tells."""
    file = folder / "degrees.nc"
    step = .02
    for site, start, is_wrapped, is_falling in (
            ((52.13, 5.27), 5.19, False, False), ((52.13, 5.27), 365.19, False, True), ((-33.4, 179.99), 179.91, True, True),
            ((-33.4, -179.95), 179.97, False, False), ((0.03, 0.01), 359.93, True, False)):
        longitudes = [start + step * i for i in range(9)]
        latitudes = [math.floor(site[0] / step) * step + step * (j - 3) for j in range(8)]
        stored = [math.remainder(lon, 360) if is_wrapped and start < 200 else lon % 360 if is_wrapped else lon for lon in longitudes]
        rows = list(range(8))[::-1] if is_falling else list(range(8))
        write_degrees(file, stored, [latitudes[j] for j in rows], [mud(i, j) for j in rows for i in range(9)])
        for rule in ("nearest", "linear"):
            lines_at = longitudes if rule == "linear" else edges_of(longitudes)
            x, y, off = placed(lines_at, latitudes if rule == "linear" else edges_of(latitudes), site)
            middle = [(a + b) / 2 for a, b in zip(y, y[1:])], [(a + b) / 2 for a, b in zip(x, x[1:])]
            lines, want = [], []
            for j in (1, 5):
                # along x through row j, between edges of the file and across a part of the outermost cells
                lines.append([x[0] + 200, middle[0][j], 200.0, x[-1] - 300, middle[0][j], 200.0])
                lines.append([middle[1][j], y[0] + 200, 200.0, middle[1][j], y[-1] - 300, 200.0])
                if rule == "nearest":
                    clip = [x[0] + 200, *x[1:-1], x[-1] - 300]
                    want.append(sum(mud(i, j) * (b - a) for i, (a, b) in enumerate(zip(clip, clip[1:]))))
                    clip = [y[0] + 200, *y[1:-1], y[-1] - 300]
                    want.append(sum(mud(j, k) * (b - a) for k, (a, b) in enumerate(zip(clip, clip[1:]))))
                else:
                    for axis, grid in ((0, x), (1, y)):
                        value = [(mud(i, j) + mud(i, j + 1)) / 2 if axis == 0 else (mud(j, i) + mud(j + 1, i)) / 2
                                 for i in range(len(grid))]
                        total = 0
                        for a, b, va, vb in zip(grid, grid[1:], value, value[1:]):
                            low, high = max(a, grid[0] + 200), min(b, grid[-1] - 300)
                            mean = va + (vb - va) * ((low + high) / 2 - a) / (b - a)
                            total += mean * (high - low)
                        want.append(total)
            keys = f"netcdf: {file}, interpolation: {rule}, per_unit: 0.002"
            got = predicted(murk, folder, at_site(site, keys), lines, "fraction")
            if isinstance(got, str):
                check(False, f"{site}: {got}")
                continue
            for value, sum_of in zip(got, want, strict=True):
                tau = -math.log(value)
                check(abs(tau / .002 - sum_of) <= 1e-6 * sum_of, f"{site}, {rule}: {tau / .002}, {sum_of}")
            said = told(folder, at_site(site, keys))
            check(f"degrees as x and y within {off:.3g} m" in said, f"{site}, {rule}: {off:.3g} m not in {said}")
    compare_globe(folder)
    compare_cuts(folder)
    refuse_degrees(folder)


def told(folder, scene):
    (folder / "told.yaml").write_text(scene)
    done = subprocess.run([murk, "check", folder / "told.yaml"], text=True, capture_output=True)
    return " ".join((done.stdout + done.stderr).split())


def compare_globe(folder):
    """A file of the whole earth from 0 degrees on, which within_m cuts out across its first longitude, and one that
    repeats it; every cell counts once, in its place, also if bounds put its middle elsewhere."""
    file, site = folder / "globe.nc", (10.2, -0.2)
    for count, below in ((720, None), (721, None), (720, .2)):
        longitudes, latitudes = [.5 * i for i in range(count)], [9 + .5 * j for j in range(5)]
        write_degrees(file, longitudes, latitudes, [mud(i % 720, j) for j in range(5) for i in range(count)],
                      **({"below": below} if below else {}))
        keys = f"netcdf: {file}, per_unit: 0.00002, within_m: [-15e3, -15e3, 15e3, 15e3]"
        numbers = [-2, -1, 0, 1]  # the box lies between -.5 and 0 degrees; one more on each side
        edges = [edges_of([.5 * i for i in numbers]), edges_of(latitudes[1:])]  # rows likewise
        if below:
            edges = [[edge + .25 - below for edge in along] for along in edges]
        x, y, _ = placed(*edges, site)
        for low, high in ((-2e4, 2e4), (-2e4, 0), (0, 2e4)):
            got = predicted(murk, folder, at_site(site, keys), [[low, 100.0, 200.0, high, 100.0, 200.0]], "fraction")
            want = sum(mud(i % 720, 2) * max(0, min(b, high) - max(a, low)) for i, a, b in zip(numbers, x, x[1:]))
            check(not isinstance(got, str) and abs(-math.log(got[0]) / 2e-5 - want) <= 2e-6 * want, f"globe of {count}, {below}: {got}, {want}")
        # along a meridian, from row to row
        got = predicted(murk, folder, at_site(site, keys), [[100.0, -2e4, 200.0, 100.0, 2e4, 200.0]], "fraction")
        want = sum(mud(0, j) * max(0, min(b, 2e4) - max(a, -2e4)) for j, a, b in zip(range(1, 5), y, y[1:]))
        check(not isinstance(got, str) and abs(-math.log(got[0]) / 2e-5 - want) <= 2e-6 * want, f"rows of {count}, {below}: {got}, {want}")


def compare_cuts(folder):
    """within_m of a file in metres: the cells of the box and one more on each side."""
    file = folder / "metres.nc"
    write_classic(file, {"z": 2, "y": 9, "x": 10}, {
        "x": (["x"], "d", {"units": "m"}, [100.0 * i for i in range(10)][::-1]),
        "y": (["y"], "d", {"units": "m"}, [100.0 * j for j in range(9)]), "z": (["z"], "d", {"units": "m"}, [100.0, 300.0]),
        "mud": (["z", "y", "x"], "f", {"units": "g m-3"}, [mud(i, j) for _ in range(2) for j in range(9) for i in range(9, -1, -1)])})
    for rule, first, last in (("nearest", 2, 7), ("linear", 2, 7)):
        keys = f"netcdf: {file}, per_unit: 0.02, interpolation: {rule}, within_m: [320, 310, 580, 590]"
        got = predicted(murk, folder, at_site(None, keys), [[-1e3, 400.0, 200.0, 2e3, 400.0, 200.0],
                                                            [400.0, -1e3, 200.0, 400.0, 2e3, 200.0]], "fraction")
        want = [sum(mud(i, 4) for i in range(first, last + 1)), sum(mud(4, j) for j in range(first, last + 1))]
        if rule == "linear":
            want = [want[0] - (mud(first, 4) + mud(last, 4)) / 2, want[1] - (mud(4, first) + mud(4, last)) / 2]
        for value, total in zip(got, want, strict=True):
            check(abs(-math.log(value) / 2 - total) <= 1e-6 * total, f"cut, {rule}: {-math.log(value) / 2}, {total}")
    said = told(folder, at_site(None, f"netcdf: {file}, within_m: [1000, 0, 1100, 100]"))
    check("has no values inside of within_m" in said, said)


def refuse_degrees(folder):
    """One line that says what to do; heights above the sea count from the site's altitude."""
    file, site = folder / "refused.nc", (52.0, 5.0)
    longitudes, latitudes = [4 + .1 * i for i in range(21)], [51 + .1 * j for j in range(21)]
    write_degrees(file, longitudes, latitudes, [mud(i, j) for j in range(21) for i in range(21)])
    keys = f"netcdf: {file}"
    for scene, problem in (
            (at_site(None, keys), "needs site.latitude_deg and site.longitude_deg; the middle of the file is at latitude 52, longitude 5"),
            (at_site(site, keys).replace("murk: 1\n", "murk: 1\nnorth: [0.1, 1, 0]\n"), "needs north: [0, 1, 0]"),
            (at_site((10, 5), keys), "within 2000 km of the site: within_m must cut out a part"),
            (at_site((60, 20), keys), "must be at most half a cell"),
            (at_site(site, keys + ", within_m: [3e5, 0, 4e5, 1e4]"), "has no values inside of within_m"),
            (at_site(site, keys + ", within_m: [-3e7, 0, 4e5, 1e4]"), "must be within 2e+06 m of the site"),
            (at_site(site, keys + ", within_m: [3, 0, 3, 1]"), "with x0 < x1 and y0 < y1")):
        said = told(folder, scene)
        check(problem in said and said.count("murk: ") == 1, f"{problem} not in {said}")
    # half a cell: the error grows with the square of the box
    x, y, off = placed(edges_of(longitudes), edges_of(latitudes), site)
    half = min(b - a for grid in (x, y) for a, b in zip(grid, grid[1:])) / 2
    said = told(folder, at_site(site, keys))
    check((f"differ by {off:.3g} m from axes of x and y, must be at most half a cell, {half:.3g} m" in said) == (off > half)
          and (f"within {off:.3g} m" in said) == (off <= half), f"{off} {half} {said}")
    # other axes
    write_degrees(file, longitudes, latitudes, [0.0] * 441, unit="degrees")
    said = told(folder, at_site(site, keys))
    check('lon has the unit "degrees", must be m, km, or degrees_east' in said or "none of the axes" in said, said)
    write_classic(file, {"z": 2, "y": 2, "x": 2}, {
        "z": (["z"], "d", {"units": "m"}, [1.0, 2.0]), "lon": (["y", "x"], "d", {"units": "degrees_east"}, [5.0, 5.1, 5.0, 5.1]),
        "mud": (["z", "y", "x"], "f", {"units": "g m-3", "coordinates": "lon lat"}, [1.0] * 8)})
    check("y: dimension of a curvilinear grid" in told(folder, at_site(site, keys)), told(folder, at_site(site, keys)))
    # altitudes count from the sea, heights from z = 0
    for level, low in (("altitude", -170), ("height", 0)):
        write_degrees(file, longitudes[9:12], latitudes[9:12], [.25] * 9, level=level)
        got = predicted(murk, folder, at_site(site, keys + ", per_unit: 0.01", ", altitude_m: 170"),
                        [[100.0, 100.0, -500.0, 100.0, 100.0, low + 100.0]], "fraction")
        check(not isinstance(got, str) and abs(-math.log(got[0]) - .25) <= 1e-6, f"{level}: {got}")


if not (murk.parent / "libmurk0" / "murk-netcdf").exists():
    print("skipped: this build has no murk-netcdf")
    sys.exit(77)
with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    subprocess.run([sys.executable, "tools/make_cloud", folder / "cumulus.nc"], check=True)
    check((folder / "cumulus.nc").read_bytes() == pathlib.Path("scenes/clouds/cumulus.nc").read_bytes(), "tools/make_cloud")
    compare_own(folder)
    compare_radii(folder)
    compare_word(folder)
    compare_models(folder)
    compare_droplets(folder)
    compare_light(folder)
    compare_degrees(folder)
    if DATA.is_dir():
        compare_reference(folder, "rico32x37x26_reference.csv", "rico32x37x26.nc")
        compare_reference(folder, "rico32x37x26_3frames_reference.csv", "rico32x37x26_3frames_classic.nc")
    else:
        print(f"without {DATA}, which is not there")
sys.exit(finish())
