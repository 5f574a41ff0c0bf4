#!/usr/bin/env python3
"""Every result file from outside: its fields, types and ranges; what must hold
between its values; coverage and its error computed again in Python; the events
of photons against the ledger. Standard library only.
usage: results.py MURK
"""

import hashlib
import math
import os
import subprocess
import sys

import light_file
import result_kinds as kinds
from from_outside import (EXTINCTION_PER_M, OPEN, RANGE_M, ROOM, SIGMA_LIMIT, check, check_plan,
                          check_robust, check_sensors, fits, main, near, sigmas)


# ---- the files ----

def of_command(result):
    """Takes out what says of which command it is a result; the keys that there were."""
    return {key for key in ("identity", "files", "run") if result.pop(key, None) is not None}


def check_ledger(ledger, power_w, where):
    emitted = ledger["emitted_w"]
    for name in ("emitted_w",) + kinds.COLUMNS:
        near(sum(ledger[name]["bands"]), ledger[name]["total"],
             1e-9 * emitted["total"], where, name, "by band")
    for band, want_w in enumerate(power_w):
        near(emitted["bands"][band], want_w, 1e-9 * want_w, where, "power of band", band)
        ended = sum(ledger[name]["bands"][band] for name in kinds.COLUMNS)
        near(ended, want_w, 1e-9 * want_w, where, "balance of band", band)
    ended = sum(ledger[name]["total"] for name in kinds.COLUMNS)
    near(ended, emitted["total"], 1e-9 * emitted["total"], where, "balance")


def check_sensors_csv(murk, folder, sensors):
    rows = murk.rows("type,x_m,y_m,z_m,heading_deg,tilt_deg", folder, "sensors.csv")
    check([(r[0], [float(v) for v in r[1:4]], r[4:]) for r in rows] ==
          [(s["type"], s["position_m"], ["", ""]) for s in sensors],
          "sensors.csv is not the plan's:", rows)


def check_coverage_csv(murk, folder, sensors):
    rows = murk.rows("sensor,type,x_m,y_m,z_m,covers,only_it_covers", folder,
                     "coverage.csv")
    check([(int(r[0]), r[1], [float(v) for v in r[2:5]]) for r in rows] ==
          [(i + 1, s["type"], s["position_m"]) for i, s in enumerate(sensors)],
          "coverage.csv is not the plan's:", rows)
    for row, sensor in zip(rows, sensors):
        near(float(row[5]), sensor["covers"], 1e-15, "coverage.csv covers")
        near(float(row[6]), sensor["only_it_covers"], 1e-15, "coverage.csv only it")


def test_files(murk):
    scene = murk.write("open.yaml", OPEN)
    found = murk.run("check", scene)
    fits(found, kinds.CHECK, "check")
    check(found["surfaces"]["triangles"] == 4, "triangles of two rects")
    near(found["surfaces"]["area_m2"], 16 + 6, 1e-5, "area")
    check([m["name"] for m in found["media"]] == ["fog"], found["media"])
    check(found["media"][0]["extinction_per_m"] == [0.4, 0.7], found["media"])
    check(found["candidates"]["asked"] == found["candidates"]["usable"] == 48,
          found["candidates"])

    # The same run shared by ranks: photons and rows are divided, memory is not,
    # and a rank receives what the others have computed.
    forecast = found["forecast"]
    matrix = forecast["matrix_bytes_at_most"]
    check("ranks" not in found, "ranks without --ranks")
    for count in (1, 3):
        shared = murk.run("check", scene, "--ranks", str(count), "-j", "2")
        check(shared["forecast"] == forecast, "the forecast with --ranks", shared["forecast"])
        ranks, others = shared["ranks"], (count - 1) / count
        check((ranks["count"], ranks["threads"]) == (count, 2), ranks)
        near(ranks["photons"], forecast["emitted"] / count, 1e-9, "photons of a rank")
        near(ranks["rows"], 48 / count, 1e-9, "rows of a rank")
        check(ranks["trace_s"] > 0, "trace_s of a rank")
        for name in ("memory_bytes", "scratch_bytes_at_most"):
            check(ranks[name] == forecast[name], name, "of a rank")
        check(ranks["rows_bytes_at_most"] == matrix, "rows that a rank holds")
        near(ranks["received_rows_bytes_at_most"], others * matrix, 1e-6 * matrix, "rows that a rank receives")
        records = forecast["surface"] + forecast["volume"]
        near(ranks["received_records_bytes"], others * 32 * records, 1e-6 * records, "records that a rank receives")
    unknown = murk.run("check", scene, "--ranks", "3", "--set", "placement.knowledge=unknown")["ranks"]
    near(unknown["rows"], 16, 1e-9, "rows of a rank when unknown")
    near(unknown["received_rows_bytes_at_most"], matrix * 2 / 3, 1e-6 * matrix, "rows that are remembered")

    plan = murk.run("place", scene, "-o", murk.path("plan"))
    fits(plan, kinds.PLAN, "plan.json")
    check(plan == murk.read("plan", "plan.json"), "plan.json is not what was printed")
    with open(scene, "rb") as file:
        digest = hashlib.sha256(file.read()).hexdigest()
    check(plan["scene_sha256"] == digest, "scene_sha256", plan["scene_sha256"])
    check(plan["seed"] == 3 and plan["photons"]["emitted"] == 4000, plan["photons"])
    check_sensors(plan, "plan.json")
    check_plan(plan, "plan.json")
    check_robust(plan, "plan.json")
    check_sensors_csv(murk, "plan", plan["sensors"])
    check_coverage_csv(murk, "plan", plan["sensors"])

    ledger = murk.read("plan", "ledger.json")
    fits(ledger, kinds.LEDGER, "ledger.json")
    check_ledger(ledger, [10, 6], "ledger.json")
    for name in kinds.COLUMNS[:3]:
        check(min(ledger[name]["bands"]) > 0, "nothing is", name)
    check(ledger["photons_emitted"] == 4000, ledger["photons_emitted"])
    check(ledger["collisions"] > plan["photons"]["volume"], ledger["collisions"])

    traced = murk.run("trace", scene, "-o", murk.path("trace"))
    check(of_command(traced) == {"identity", "files", "run"}, traced)
    check(of_command(ledger) == {"identity", "run"}, ledger)
    check(traced == ledger, "trace's ledger is not place's")
    with open(murk.path("trace", "light.murk"), "rb") as one, \
            open(murk.path("plan", "light.murk"), "rb") as other:
        check(one.read() == other.read(), "trace's light is not place's")

    result = murk.run("sense", scene, "--sensors", murk.path("plan", "sensors.csv"),
                      "--light", murk.path("plan", "light.murk"), "-o",
                      murk.path("sense"))
    fits(result, kinds.COVERAGE, "coverage.json")
    check(result == murk.read("sense", "coverage.json"),
          "coverage.json is not what was printed")
    check_sensors(result, "coverage.json")
    check_robust(result, "coverage.json")
    check(result["sensors"] == plan["sensors"], "sense sees other sensors")
    check(result["seen_by_at_least"] == plan["seen_by_at_least"], "sense sees else")
    check_coverage_csv(murk, "sense", plan["sensors"])


# ---- tallies ----

SIDES = [(axis, side) for axis in range(3) for side in (0, 1)]


def side_plane(axis, side):
    point, normal = [0, 0, 0], [0, 0, 0]
    point[axis], normal[axis] = side * [4, 4, 3][axis], 2 * side - 1
    return f"  - {{name: side-{axis}{side}, type: plane, point_m: {point}, normal: {normal}}}\n"


TALLIES = OPEN.replace("photons:", "tallies:\n" + "".join(
    side_plane(*side) for side in SIDES) + """\
  - {name: floor, type: plane, point_m: [1, 1, 0.1], normal: [0, 0, -1]}
  - {name: tiles, type: plane, point_m: [1, 1, 0.1], normal: [0, 0, -3], bins: [3, 2], angle_bins: 4}
  - {name: probe, type: sphere, center_m: [1, 1, 1], radius_m: 0.5}
  - {name: halves, type: sphere, center_m: [1, 1, 1], radius_m: 0.5, hemispheres: true}
  - {name: fluence, type: grid, min_m: [0, 0, 0], max_m: [4, 2, 3], size: [8, 2, 6]}
  - {name: one-cell, type: grid, min_m: [0, 0, 0], max_m: [4, 2, 3], size: [1, 1, 1]}
photons:""")
HEADER = "tally,band_nm,bin_i,bin_j,bin_k,direction,value,standard_error,unit"


HALVES = """\
murk: 1
bands_nm: [550]
domain: {min_m: [0, 0, 0], max_m: [2, 2, 2]}
lights:
  - {type: beam, origin_m: [1, 1, 0.1], direction: [0, 0, 1], power_w: 1}
  - {type: beam, origin_m: [1, 1, 1.9], direction: [0, 0, -1], power_w: 3}
tallies: [{name: halves, type: sphere, center_m: [1, 1, 1], radius_m: 0.5, hemispheres: true}]
photons: {emit: 400, maps: none}
"""


def test_hemispheres(murk):
    """A beam of 1 W upwards and one of 3 W downwards, through the middle of a
    sphere of 0.5 m: the power times a path of 1 m over the volume, pi / 6 m3."""
    murk.run("trace", murk.write("halves.yaml", HALVES), "-o", murk.path("halves"))
    found = {row[5]: float(row[6]) for row in murk.rows(HEADER, "halves", "tallies.csv")}
    check(set(found) == {"up", "down"}, found)
    near(found["up"], 6 / math.pi, 1e-6, "1 W of travel upwards")
    near(found["down"], 18 / math.pi, 1e-6, "3 W of travel downwards")


def read_grid(murk, name, grid):
    """What murk itself finds in a grid of a .vdb."""
    scene = murk.write("grid.yaml", f"""\
murk: 1
domain: {{min_m: [0, 0, 0], max_m: [4, 4, 3]}}
media: {{m: {{vdb: {murk.path("tallies", name)}, grid: {grid}, extinction_per_m: 1, albedo: 1}}}}
regions: [{{medium: m}}]
lights: [{{type: point, position_m: [1, 1, 1], power_w: 1}}]
""")
    found = murk.run("check", scene)
    return found["media"][0]["grid"], found["regions"][0]["bounds"]


def test_tallies(murk):
    scene = murk.write("tallies.yaml", TALLIES)
    asked = {t["name"]: t["cells"] for t in murk.run("check", scene)["tallies"]}
    check(asked["tiles"] == 48 and asked["halves"] == 2 and asked["fluence"] == 96, asked)
    ledger = murk.run("trace", scene, "-o", murk.path("tallies"))
    fits(ledger, kinds.LEDGER, "ledger.json")
    check_ledger(ledger, [10, 6], "ledger.json")
    value, error = {}, {}
    for tally, band, i, j, k, direction, watts, its_error, unit in murk.rows(
            HEADER, "tallies", "tallies.csv"):
        key = tally, float(band), direction, int(i), int(j), int(k)
        check(key not in value, "tallies.csv has twice", key)
        value[key], error[key] = float(watts), float(its_error)
        kind = {"probe": "W/m2", "halves": "W/m2"}.get(tally, "W")
        check(unit == kind and 0 <= error[key] <= 1.001 * value[key] + 1e-30, key, unit)
    check(len(value) == 2 * (7 * 2 + 48 + 1 + 2), "tallies.csv has rows:", len(value))

    def total(tally, band, direction):
        return sum(v for key, v in value.items() if key[:3] == (tally, band, direction))

    for number, band in enumerate((450, 650)):
        out = sum(total(f"side-{axis}{side}", band, "forward") for axis, side in SIDES)
        near(out, ledger["escaped_w"]["bands"][number], 1e-9, "escaped by planes")
        back = sum(total(f"side-{axis}{side}", band, "backward") for axis, side in SIDES)
        check(back == 0, "light from outside", back)
        stays = total("floor", band, "forward") - total("floor", band, "backward")
        near(stays, ledger["absorbed_by_material_w"]["floor"]["bands"][number], 1e-9,
             "the floor keeps")
        for direction in ("forward", "backward"):
            near(total("tiles", band, direction), total("floor", band, direction), 1e-9,
                 "all bins", direction)
        near(total("halves", band, "up") + total("halves", band, "down"),
             total("probe", band, ""), 1e-9, "both hemispheres")
        for kind, account in (("material", "surfaces"), ("medium", "media")):
            near(sum(part["bands"][number]
                     for part in ledger[f"absorbed_by_{kind}_w"].values()),
                 ledger[f"absorbed_{account}_w"]["bands"][number], 1e-9, "by", kind)
        for file in ("", "_error"):
            grid, bounds = read_grid(murk, f"fluence{file}.vdb", f"fluence_{band}nm")
            check(grid["voxel_m"] == [0.5, 1, 0.5], grid["voxel_m"])
            check(bounds == {"min_m": [0, 0, 0], "max_m": [4, 2, 3]}, bounds)
            if not file:
                whole, _ = read_grid(murk, "one-cell.vdb", f"fluence_{band}nm")
                near(grid["sum"] / 96, whole["sum"], 1e-6 * whole["sum"], "mean fluence")
                check(total("probe", band, "") < grid["maximum"], grid)
    check(set(ledger["absorbed_by_material_w"]) == {"default", "floor", "pane"},
          ledger["absorbed_by_material_w"])

    # light from a file is not measured, and tallies do not count for it
    without = murk.write("open.yaml", OPEN)
    again = murk.run("place", scene, "--light", murk.path("tallies", "light.murk"),
                     "-o", murk.path("again"))
    murk.run("place", without, "--light", murk.path("tallies", "light.murk"))
    check(not os.path.exists(murk.path("again", "tallies.csv")), "tallies of a file")
    stored = murk.read("again", "ledger.json")
    of_command(stored), of_command(ledger)
    check(stored == ledger and again["photons"]["emitted"] == 4000, "ledger of a file")


PHOTON_J = 1.98644586e-25 / 1e-9  # hc over a nanometre
# of a watt at 450 and 650 nm: V of the CIE 1924 observer, photons, umol
PER_WATT = {"photometric": ("lm", "lux", "lm", (683 * 0.038, 683 * 0.107)),
            "photons": ("1/s", "1/s/m2", "photons_per_s",
                        (450 / PHOTON_J, 650 / PHOTON_J)),
            "par": ("umol/s", "umol/s/m2", "umol_per_s",
                    (450 / PHOTON_J / 6.02214076e17, 650 / PHOTON_J / 6.02214076e17))}


def test_units(murk):
    """The same light, read otherwise: each row is the radiometric one times what a
    watt of its band is, and the light's file is the same."""
    scene = murk.path("tallies.yaml")
    watts = list(murk.rows(HEADER, "tallies", "tallies.csv"))
    in_watts = murk.read("tallies", "ledger.json")
    for units, (power, irradiance, suffix, factors) in PER_WATT.items():
        ledger = murk.run("trace", scene, "--set", f"units={units}", "-o", murk.path(units))
        rows = list(murk.rows(HEADER, units, "tallies.csv"))
        check(len(rows) == len(watts), "rows of", units)
        for old, new in zip(watts, rows):
            factor = factors[[450, 650].index(float(old[1]))]
            check(old[:6] == new[:6], "row", new)
            check(new[8] == {"W": power, "W/m2": irradiance}[old[8]], "unit", new)
            for column in (6, 7):
                want = float(old[column]) * factor
                near(float(new[column]), want, 2e-5 * want, units, "column", column)
        emitted = ledger.pop(f"emitted_{suffix}")
        near(emitted["total"], sum(emitted["bands"]), 1e-9 * emitted["total"], units)
        for number, factor in enumerate(factors):
            want = in_watts["emitted_w"]["bands"][number] * factor
            near(emitted["bands"][number], want, 2e-6 * want, "emitted,", units)
        check(ledger["emitted_w"] == in_watts["emitted_w"], "watts stay watts")
        murk.run("place", scene, "--set", f"units={units}", "--light",
                 murk.path("tallies", "light.murk"))


# ---- coverage, again ----

def off_by(result, again):
    """The largest difference of any number of the coverage."""
    pairs = [(result["coverage"][name], again[name]) for name in
             ("in_sample", "surface", "volume", "sum_of_views", "standard_error")]
    for name in ("covers", "only_it_covers"):
        pairs += zip([s[name] for s in result["sensors"]], again[name])
    pairs += zip(result["seen_by_at_least"], again["seen_by_at_least"])
    return max(abs(a - b) for a, b in pairs)


TABLE = [(0.5, 200), (2, 30), (10, 1.5), (60, 0.02), (120, 0.004), (180, 0.006)]


def mean_cosine(rows):
    """Of the table, by trapezoids of what lies between its rows in logs."""
    first, last = (math.log(rows[i][1]) for i in (0, 1))
    power = (last - first) / math.log(rows[1][0] / rows[0][0])
    rows = [(1e-12, rows[0][1] * (1e-12 / rows[0][0]) ** power)] + rows
    whole = turned = 0
    for (a, p), (b, q) in zip(rows, rows[1:]):
        steps = 5000
        power = math.log(q / p) / math.log(b / a)
        angles = [a * (b / a) ** (i / steps) for i in range(steps + 1)]
        shares = [p * (x / a) ** power * math.sin(math.radians(x)) for x in angles]
        for x, y, f, g in zip(angles, angles[1:], shares, shares[1:]):
            whole += (f + g) * (y - x)
            turned += (f * math.cos(math.radians(x)) + g * math.cos(math.radians(y))) * (y - x)
    return turned / whole


def test_phases(murk):
    """A phase function for each band; light belongs to its table's bytes."""
    def write_table(rows):
        murk.write("turns.csv", "angle_deg,phase_per_sr\n" +
                   "".join(f"{a},{p}\n" for a, p in rows))

    write_table(TABLE)
    scene = murk.write("phases.yaml",
                       OPEN.replace("{hg: 0.7}", "[{two_hg: [0.9, -0.5, 0.75]}, {table: turns.csv}]"))
    medium = murk.run("check", scene)["media"][0]
    check([p["kind"] for p in medium["phase"]] == ["two_hg", "table"], medium)
    near(medium["mean_cosine"][0], 0.55, 1e-12, "mean cosine of two_hg")
    near(medium["mean_cosine"][1], mean_cosine(TABLE), 1e-5, "mean cosine of the table")
    changed = TABLE[:2] + [(10, 1.6)] + TABLE[3:]
    check(abs(mean_cosine(changed) - medium["mean_cosine"][1]) > 1e-3, "no teeth")

    plan = murk.run("place", scene, "-o", murk.path("turned"))
    light = murk.path("turned", "light.murk")
    again = murk.run("place", murk.path("turned", "scene.resolved.yaml"), "--light", light)
    check(again["coverage"] == plan["coverage"], "light used again", again["coverage"])
    write_table(changed)
    done = subprocess.run([murk.program, "place", scene, "--light", light],
                          capture_output=True, text=True, timeout=60)
    check(done.returncode == 2 and "checksum" in done.stderr,
          "light of another table:", done.returncode, done.stderr)


def test_coverage(murk):
    scene = murk.write("room.yaml", ROOM)
    plan = murk.run("place", scene, "-o", murk.path("room"))
    plan_file = murk.path("room", "plan.json")
    light = murk.path("room", "light.murk")
    result = murk.run("sense", scene, "--sensors", plan_file, "--light", light)
    found = light_file.sections(light)
    where = [s["position_m"] for s in plan["sensors"]]
    again = light_file.coverage(found, 3000, where, RANGE_M, EXTINCTION_PER_M)
    near(plan["coverage"]["in_sample"], again["in_sample"], 1e-5, "in_sample again")
    near(result["coverage"]["standard_error"] / again["standard_error"], 1, 1e-4,
         "standard error again")
    check(off_by(result, again) <= 1e-5, "coverage again is off by", off_by(result, again))

    # teeth: 2 % more fog
    wrong = light_file.coverage(found, 3000, where, RANGE_M,
                                [1.02 * e for e in EXTINCTION_PER_M])
    check(abs(wrong["in_sample"] - plan["coverage"]["in_sample"]) > 100 * 1e-5,
          "2 % of extinction would go unnoticed:", wrong["in_sample"])
    check(abs(wrong["standard_error"] / result["coverage"]["standard_error"] - 1) > 1e-3,
          "2 % of extinction leaves the error as it is")

    # a 20 times larger map under another seed: independent of both of the plan's
    large = ("sense", scene, "--sensors", plan_file, "--emit", "60000", "--seed", "2")
    truth = murk.run(*large)["coverage"]
    held = (plan["coverage"]["held_out"], plan["coverage"]["held_out_standard_error"])
    off = sigmas(*held, truth["in_sample"], truth["standard_error"])
    check(off <= SIGMA_LIMIT, "held out is", off, "sigma off a large map's")
    denser = murk.run(*large, "--set", "media.fog.extinction_per_m=[0.36, 0.72]")["coverage"]
    off = sigmas(*held, denser["in_sample"], denser["standard_error"])
    check(off > SIGMA_LIMIT, "20 % more fog is only", off, "sigma off")


# Three ways of looking, by angles: this file's own reading of what they mean.
TYPES = ("sensors.types=[{name: node, range_m: 2.2, least_range_m: 0.7}, "
         "{name: cam, range_m: 2.2, view: {hfov_deg: 70, vfov_deg: 40}, arrival: toward}, "
         "{name: cone, range_m: 2.2, view: {cone_deg: 100}, bands: [650]}]")
POSES = [("node", (1, 1, 1), None, None), ("cam", (3.5, 3, 1.5), 240, -10),
         ("cone", (2, 0.5, 2.2), 20, -35)]


def is_ahead(offset, heading, tilt, hfov, vfov):
    """In a picture of such angles: turned to look north, then level."""
    h, t = math.radians(heading), math.radians(tilt)
    right = offset[0] * math.cos(h) - offset[1] * math.sin(h)
    north = offset[0] * math.sin(h) + offset[1] * math.cos(h)
    ahead = north * math.cos(t) + offset[2] * math.sin(t)
    up = offset[2] * math.cos(t) - north * math.sin(t)
    return (ahead > 0 and abs(math.degrees(math.atan2(right, ahead))) <= hfov / 2 and
            abs(math.degrees(math.atan2(up, ahead))) <= vfov / 2)


def axis_of(heading, tilt):
    h, t = math.radians(heading), math.radians(tilt)
    return math.sin(h) * math.cos(t), math.cos(h) * math.cos(t), math.sin(t)


def takers(turn=0):
    """What each of POSES takes up, all turned by so many degrees."""
    def node(_, __, offset):
        return light_file.dot(offset, offset) >= 0.7 ** 2

    def cam(_, travel, offset):
        heading, tilt = POSES[1][2] + turn, POSES[1][3]
        return (is_ahead(offset, heading, tilt, 70, 40) and
                light_file.dot(travel, axis_of(heading, tilt)) < 0)

    def cone(band, _, offset):
        length = math.sqrt(light_file.dot(offset, offset))
        along = light_file.dot(offset, axis_of(POSES[2][2] + turn, POSES[2][3])) / length
        return band == 1 and math.degrees(math.acos(max(-1, min(1, along)))) <= 50

    return [node, cam, cone]


def test_fields_of_view(murk):
    scene = murk.write("views.yaml", ROOM)
    rows = "".join("%s,%g,%g,%g,%s,%s\n" %
                   (name, *at, "" if heading is None else heading, "" if tilt is None else tilt)
                   for name, at, heading, tilt in POSES)
    given = murk.write("views.csv", "type,x_m,y_m,z_m,heading_deg,tilt_deg\n" + rows)
    result = murk.run("sense", scene, "--set", TYPES, "--sensors", given, "-o", murk.path("views"))
    check([(s["heading_deg"], s["tilt_deg"]) for s in result["sensors"]] ==
          [pose[2:] for pose in POSES], result["sensors"])
    found = light_file.sections(murk.path("views", "light.murk"))
    where = [pose[1] for pose in POSES]
    again = light_file.coverage(found, 3000, where, RANGE_M, EXTINCTION_PER_M, takers())
    check(off_by(result, again) <= 1e-5, "views again are off by", off_by(result, again))
    check(min(again["covers"]) > 0.005, "a view of nothing", again["covers"])
    # teeth: turned by a degree, and all of it in view
    for wrong in (takers(1), None):
        other = light_file.coverage(found, 3000, where, RANGE_M, EXTINCTION_PER_M, wrong)
        check(off_by(result, other) > 100 * 1e-5, "would go unnoticed:", off_by(result, other))


# ---- photon by photon ----

def check_path(events, where):
    """One photon's events follow from each other."""
    check([e["number"] for e in events] == list(range(len(events))), where, "numbers")
    check(events[0]["kind"] == "emitted" and
          all(e["kind"] != "emitted" for e in events[1:]), where, "emitted once")
    for before, event in zip(events, events[1:]):
        step = math.dist(before["position_m"], event["position_m"])
        # a step off a surface is far below a micrometre here
        near(event["path_m"], step, 1e-5, where, "path", event["number"])
        check(event["direction_in"] == before["direction_out"], where, "direction")
        near(math.hypot(*event["direction_in"]), 1, 1e-12, where, "unit direction")
    last = events[-1]
    ended = [e for e in events if e["kind"] in ("escaped", "lost") or
             e.get("outcome") == "absorbed"]
    check(ended == [last], where, "must end once, at its end")


def test_replay(murk):
    """40 photons of one lamp and band carry the same power: their ends, counted,
    are the ledger, and their reflections and scatterings the maps."""
    scene = murk.path("open.yaml")
    only = ("--emit", "40", "--set", "bands_nm=[550]",
            "--set", "materials.floor.diffuse=0.6",
            "--set", "media.fog.extinction_per_m=0.5",
            "--set", "media.fog.albedo=0.9", "--set", "lights.0.power_w=10",
            "--set", "lights.0.position_m=[1, 2, 0.8]")
    ledger = murk.run("trace", scene, *only, "-o", murk.path("few"))
    stored = light_file.sections(murk.path("few", "light.murk"))
    ends = dict.fromkeys(kinds.COLUMNS, 0)
    expected = {"surface": 0, "volume": 0}
    collisions = 0
    for photon in range(40):
        replay = murk.run("replay", scene, *only, "--photon", str(photon))
        if photon == 0:
            fits(replay, kinds.REPLAY, "replay")
        events = replay["events"]
        check(replay["photon"] == photon, "replay of", replay["photon"])
        check_path(events, f"photon {photon}")
        collisions += sum(e["kind"] == "medium" for e in events)
        expected["volume"] += sum(e.get("outcome") == "scattered" for e in events)
        expected["surface"] += sum(e.get("outcome") == "reflected" for e in events)
        kind = events[-1]["kind"]
        ends[{"surface": "absorbed_surfaces_w", "medium": "absorbed_media_w",
              "escaped": "escaped_w", "lost": "lost_w"}[kind]] += 1
    for name, photons in ends.items():
        near(ledger[name]["total"], photons * 10 / 40, 1e-9, "replayed", name)
    check(ledger["collisions"] == collisions, "collisions", collisions)
    for name, records in expected.items():
        check(len(stored[name]) == 32 * records, "stored in", name, records)
    check(min(expected.values()) > 5 and len(set(ends.values())) > 2,
          "too few of a kind:", expected, ends)


if __name__ == "__main__":
    sys.exit(main([test_files, test_tallies, test_hemispheres, test_units, test_coverage, test_fields_of_view, test_replay, test_phases]))
