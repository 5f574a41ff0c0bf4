#!/usr/bin/env python3
"""Places by longitude and latitude: scenes/valley.yaml with its ground, its
candidates and the exports for maps, from outside; studies and fits on it. The
fit is within 4 of its standard errors; the seed is fixed. Standard library only.
usage: terrain.py MURK
"""

import csv
import json
import pathlib
import re
import struct
import subprocess
import sys
import tempfile

murk = pathlib.Path(sys.argv[1]).resolve()
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from sightlines import check, finish  # noqa: E402


def run(*words):
    return subprocess.run([murk, *words], text=True, capture_output=True)


def rows(path):
    with open(path) as table:
        return list(csv.DictReader(line for line in table if line[0] != "#"))


SCENE = "scenes/valley.yaml"
KEYS = ["--set", "photons.emit=3000"]


def plan(folder):
    """The plan with exports: places are those of the table, bytes of other files do not change."""
    plain, out, again = folder / "plain", folder / "out", folder / "again"
    check(run("place", SCENE, *KEYS, "-o", plain).returncode == 0, "place")
    check(run("place", SCENE, *KEYS, "-o", out, "--export", "geojson,geo-csv").returncode == 0, "place with exports")
    check(sorted(p.name for p in out.iterdir() if not (plain / p.name).exists()) ==
          ["sensors.geojson", "sensors_geo.csv"], "two files more")
    for name in ("sensors.csv", "coverage.csv", "plan.ply", "light.murk"):
        check((plain / name).read_bytes() == (out / name).read_bytes(), name)
    # the masts of the table come back to 1e-9 degrees, 0.1 mm
    masts = [(float(r["longitude_deg"]), float(r["latitude_deg"])) for r in rows("scenes/terrain/masts.csv")]
    geo, places = rows(out / "sensors_geo.csv"), rows(out / "sensors.csv")
    check(len(geo) == len(places) == 3, "three sensors")
    features = json.loads((out / "sensors.geojson").read_text())
    check(features["type"] == "FeatureCollection" and len(features["features"]) == 3, "features")
    sensors = json.loads((out / "plan.json").read_text())["sensors"]
    for row, place, feature, sensor in zip(geo, places, features["features"], sensors):
        at = (float(row["longitude_deg"]), float(row["latitude_deg"]))
        check(min(max(abs(at[0] - m[0]), abs(at[1] - m[1])) for m in masts) < 2e-9, f"{at} is no mast")
        check(all(row[key] == place[key] for key in place), f"{row} {place}")
        check(float(row["height_m"]) == float(row["z_m"]), "altitude 0")
        check(feature["type"] == "Feature" and feature["geometry"]["type"] == "Point", "a point")
        check(feature["geometry"]["coordinates"] == [*at, float(row["height_m"])], f"{feature}")
        check(feature["properties"] == sensor, f"{feature} {sensor}")
    # the resolved scene has the site, and gives the same
    resolved = (out / "scene.resolved.yaml").read_text()
    check("latitude_deg: 47.6014087" in resolved and "longitude_deg: 9" in resolved, "site")
    check(run("place", out / "scene.resolved.yaml", "-o", again).returncode == 0, "the resolved scene")
    check((again / "sensors.csv").read_bytes() == (out / "sensors.csv").read_bytes(), "the same plan")
    return out


def other_tables(folder, out):
    """Sensors by longitude, latitude and z; a site 10 m higher."""
    wanted = json.loads((out / "plan.json").read_text())["sensors"]
    table = folder / "sensors.csv"
    with open(table, "w") as to:
        print("type,longitude_deg,latitude_deg,z_m,heading_deg,tilt_deg", file=to)
        for row in rows(out / "sensors_geo.csv"):
            print(*(row[key] for key in ("type", "longitude_deg", "latitude_deg", "z_m", "heading_deg", "tilt_deg")),
                  sep=",", file=to)
    done = run("sense", SCENE, *KEYS, "--sensors", table, "-o", folder / "sense", "--export", "geo-csv")
    check(done.returncode == 0, done.stderr)
    for sensor, row in zip(wanted, rows(folder / "sense" / "sensors_geo.csv"), strict=True):
        for i, key in enumerate(("x_m", "y_m", "z_m")):
            check(abs(float(row[key]) - sensor["position_m"][i]) < 1e-3, f"{row} {sensor}")
    # above the ground of a site at 10 m all heights are 10 m less
    done = run("place", SCENE, *KEYS, "--set", "site.altitude_m=10", "--set", "domain.min_m=[-298, -238, 380]",
               "-o", folder / "high", "--export", "geo-csv")
    check(done.returncode == 0, done.stderr)
    heights = {row["longitude_deg"] + row["latitude_deg"]: row for row in rows(out / "sensors_geo.csv")}
    for row in rows(folder / "high" / "sensors_geo.csv"):
        check(abs(float(row["height_m"]) - float(row["z_m"]) - 10) < 1e-9, f"{row}")
        same = heights.get(row["longitude_deg"] + row["latitude_deg"])
        check(same is None or abs(float(same["z_m"]) - float(row["z_m"]) - 10) < 1e-3, f"{row} {same}")
    # targets above the ground
    targets = folder / "targets.csv"
    targets.write_text("longitude_deg,latitude_deg,above_ground_m\n9.0003,47.6012,1.5\n8.999,47.602,1.5\n")
    done = run("place", SCENE, *KEYS, "--set", f"placement.targets={{points: {targets}}}", "-o", folder / "targets")
    check(done.returncode == 0 and json.loads((folder / "targets" / "plan.json").read_text())["targets"]["points"] == 2,
          done.stderr)


def refused(folder):
    table, bare = folder / "bad.csv", folder / "bare.yaml"
    bare.write_text("murk: 1\nbands_nm: [550]\ndomain: {min_m: [-9, -9, 0], max_m: [9, 9, 9]}\n"
                    "lights: [{type: point, position_m: [0, 0, 5], power_w: 1}]\n"
                    "sensors: {types: [{name: n, range_m: 5}], candidates: {points: bad.csv}, count: 1}\n")
    cases = [
        (bare, "longitude_deg,latitude_deg,z_m\n9,47,1\n", [], "site.longitude_deg and site.latitude_deg"),
        (bare, "longitude_deg,z_m\n9,1\n", [], "misses column latitude_deg,"),
        (bare, "latitude_deg,z_m\n9,1\n", [], "misses column longitude_deg,"),
        (bare, "x_m,longitude_deg,latitude_deg,z_m\n9,1,1,1\n", [], "misses column y_m,"),
        (bare, "longitude_deg,latitude_deg\n9,47\n", ["--set", "site={latitude_deg: 47, longitude_deg: 9}"],
         "misses column z_m, must have x_m, y_m and z_m, or longitude_deg and latitude_deg in place of x_m and y_m, or above_ground_m"),
        (bare, "longitude_deg,latitude_deg,z_m\n9,47,\n", ["--set", "site={latitude_deg: 47, longitude_deg: 9}"], "bad.csv:2"),
        (bare, "x_m,y_m\n1,1\n", [], "above_ground_m in place of z_m"),
        (bare, "x_m,y_m,above_ground_m\n1,1,1\n", [], "above_ground_m at x_m = 1, y_m = 1, where the domain has no ground"),
        (bare, "longitude_deg,latitude_deg,above_ground_m\n9.00001,47,1\n", ["--set", "site={latitude_deg: 47, longitude_deg: 9}"],
         "bad.csv:2: above_ground_m at longitude_deg = 9.00001, latitude_deg = 47, where"),
        (bare, "longitude_deg,latitude_deg,z_m\n9,47,1\n", ["--set", "site={latitude_deg: -47, longitude_deg: 9}"],
         "must be within 2000 km of the site"),
        (bare, "x_m,y_m,z_m\n1,1,1\n", ["--export", "geojson"], "need a place on the earth"),
        (SCENE, "", ["--set", "site.latitude_deg=47"], "or none of them"),
        (SCENE, "", ["--set", "site.latitude_deg=10", "--set", "site.longitude_deg=9"], "must be within 2000 km of the site"),
        (SCENE, "", ["--set", "geometry.0.geotiff.band=2"], "band is 2, must be 1..1"),
        (SCENE, "", ["--set", "geometry.0.geotiff.within_m=[5, 0, 1, 9]"], "x0 < x1"),
        (SCENE, "", ["--set", "geometry.0.geotiff.error_m=-1"], "0..10000 m"),
        (SCENE, "", ["--set", "geometry.0.scale=2"], "scale"),
        (SCENE, "", ["--set", "geometry.0.rotate_deg=[0, 0, 9]"], "rotate_deg"),
        (SCENE, "", ["--set", "geometry.0.translate_m=[0, 0, 9]"], "translate_m"),
        (SCENE, "", ["--set", "geometry.0.geotiff=scenes/terrain/masts.csv"], "is no GeoTIFF file that can be read")]
    for scene, text, words, wanted in cases:
        table.write_text(text)
        done = run("place", scene, *words, "-o", folder / "refused")
        lines = [line for line in done.stderr.splitlines() if "warning" not in line]
        check(done.returncode == 2 and len(lines) == 1 and wanted in lines[0], f"{words} {wanted}: {done.stderr}")
    # sensors have heights of their own
    for columns in ("type,longitude_deg,latitude_deg,heading_deg,tilt_deg", "type,longitude_deg,latitude_deg,above_ground_m,heading_deg"):
        table.write_text(columns + "\nmast,9,47.6,2,3\n")
        done = run("sense", SCENE, *KEYS, "--sensors", table, "-o", folder / "refused")
        check(done.returncode == 2 and "misses column z_m, must have" in done.stderr and done.stderr.count("murk: ") == 1, done.stderr)
    check(not (folder / "refused").exists(), "nothing written")
    done = run("trace", SCENE, *KEYS, "-o", folder / "refused", "--export", "geojson")
    check(done.returncode == 2 and "of sensors" in done.stderr, done.stderr)


def ground():
    """What check says, by JSON; a plain path is short for a map."""
    done = run("check", SCENE, *KEYS, "--format", "json")
    g = json.loads(done.stdout)["ground"]
    check(len(g) == 1 and g[0]["columns"] == 100 and g[0]["rows"] == 80, f"{g}")
    check(g[0]["missing"] == 40 and g[0]["uncovered"] == 0, f"{g}")
    check(0.4 < g[0]["error_m"] <= 0.5 and 1000 < g[0]["triangles"] < 5000, f"{g}")
    check(abs(g[0]["spacing_m"][0] - 6 / 0.9996) < 1e-3, f"{g}")  # the scale of UTM at its meridian
    short = run("check", SCENE, *KEYS, "--set", "geometry.0.geotiff=scenes/terrain/valley.tif", "--format", "json")
    check(json.loads(short.stdout)["ground"][0]["triangles"] == g[0]["triangles"], "a plain path")


def site_of(folder, *words):
    """The site of a scene, as its resolved form has it."""
    done = run("trace", SCENE, "--set", "photons.emit=100", *words, "-o", folder / "site")
    check(done.returncode == 0, f"{words} {done.stderr}")
    text = (folder / "site" / "scene.resolved.yaml").read_text() if done.returncode == 0 else ""
    return dict(re.findall(r"(l[a-z]*itude_deg|altitude_m): ([-.0-9]+)", text)), done.stderr


def sites(folder):
    """One site for conditions with other files; what epw, band and the short form do to it."""
    moved = folder / "moved.tif"
    tif = pathlib.Path("scenes/terrain/valley.tif").read_bytes()
    west = struct.pack("<d", 499700.0)
    check(tif.count(west) == 1, "the western border")
    moved.write_bytes(tif.replace(west, struct.pack("<d", 499700.0 + 6000)))
    # ground 6 km away is outside of the domain, not about a site of its own
    scene = folder / "moves.yaml"
    text = pathlib.Path(SCENE).read_text().replace("terrain/", str(pathlib.Path("scenes/terrain").resolve()) + "/")
    scene.write_text(text + f"conditions: {{moved: {{geometry.0.geotiff.file: {moved}}}}}\n")
    done = run("place", scene, *KEYS, "--set", "placement.over=mean", "-o", folder / "moves")
    check(done.returncode != 0 and "no ground" in done.stderr, done.stderr)
    # the place of the ground, and not the altitude of the weather station, which is far away
    site, told = site_of(folder, "--set", "weather={epw: scenes/weather/june.epw}", "--set",
                         "site.time=2025-06-03T10:30:00Z", "--set", "lights=[{type: sun}]")
    check(site == {"latitude_deg": "47.6014087", "longitude_deg": site.get("longitude_deg"), "altitude_m": "0"}, f"{site}")
    check("is not where" in told, told)
    # keys below the short form
    for words in (["--set", "geometry.0.geotiff=scenes/terrain/valley.tif"],):
        done = run("check", SCENE, *KEYS, *words, "--set", "geometry.0.geotiff.error_m=3", "--format", "json")
        check(done.returncode == 0 and 1 < json.loads(done.stdout)["ground"][0]["error_m"] <= 3, done.stderr)
    # a site without lights of the sky is of use to sensors
    done = run("check", SCENE, *KEYS, "--set", "geometry=[]", "--set", "lights=[{type: point, position_m: [0, 0, 450], power_w: 1}]",
               "--set", "sensors.candidates={points: [[0, 0, 450]]}", "--set", "sensors.count=1",
               "--set", "site={latitude_deg: 47, longitude_deg: 9}")
    check(done.returncode == 0 and "site" not in done.stderr, done.stderr)


def study(folder, out):
    """Rows of a study with other ground are runs of their own: candidates stand 4 m above the ground of the row."""
    text = pathlib.Path(SCENE).read_text().replace("terrain/", str(pathlib.Path("scenes/terrain").resolve()) + "/")
    (folder / "valley.yaml").write_text(text.replace("emit: 30000", "emit: 3000"))
    (folder / "study.yaml").write_text("murk_study: 1\nbase: valley.yaml\naxes: {geometry.0.geotiff.error_m: [0.5, 12]}\n"
                                       "outputs: [coverage_best]\n")
    done = run("study", folder / "study.yaml", "-o", folder / "study", "--quiet")
    check(done.returncode == 0, done.stderr)
    table = rows(folder / "study" / "table.csv") if done.returncode == 0 else []
    done = run("place", SCENE, *KEYS, "--set", "geometry.0.geotiff.error_m=12", "-o", folder / "coarse")
    check(done.returncode == 0 and len(table) == 2, f"{table} {done.stderr}")
    plans = [json.loads((path / "plan.json").read_text()) for path in (out, folder / "coarse")]
    for row, placed in zip(table, plans):
        check(float(row["coverage_best"]) == placed["coverage"]["held_out"], f"{row} {placed['coverage']}")
    check(table and table[0]["coverage_best"] != table[1]["coverage_best"], "the ground of the rows differs")


def fit(folder):
    """Coverage on ground from a file: predicted as murk place has it for sensors 4 m above that ground, and a planted
    extinction comes back from it."""
    text = (folder / "valley.yaml").read_text().replace("outside: continued", "outside: empty")
    text = re.sub(r"fog: {profile.*}\n", "fog: {extinction_per_m: 0.004, albedo: 0.99, phase: {hg: 0.8}}\n", text)
    (folder / "even.yaml").write_text(text)
    done = run("place", folder / "even.yaml", "-o", folder / "even", "--quiet")
    check(done.returncode == 0, done.stderr)
    wanted = json.loads((folder / "even" / "plan.json").read_text())["coverage"]["in_sample"]
    keys = ("x_m", "y_m", "z_m", "heading_deg", "tilt_deg")
    with open(folder / "readings.csv", "w") as to:
        print("kind,sensor,group,value,standard_error", *keys, sep=",", file=to)
        for row in rows(folder / "even" / "sensors.csv"):
            print("coverage", row["type"], "g", wanted, 0.001, *(row[key] for key in keys), sep=",", file=to)
    done = run("fit", folder / "even.yaml", "--data", folder / "readings.csv", "-o", folder / "predicted")
    check(done.returncode == 0, done.stderr)
    got = float(rows(folder / "predicted" / "fit.csv")[0]["predicted"])
    check(abs(got - wanted) < 1e-6, f"{got} {wanted}")
    # without ground the light is another
    done = run("fit", folder / "even.yaml", "--data", folder / "readings.csv", "-o", folder / "bare", "--set", "geometry=[]",
               "--set", "site={latitude_deg: 47.6014, longitude_deg: 9, time: 2026-10-10T07:30:00Z}",
               "--set", "sensors.candidates={points: [[0, 0, 450]]}")
    check(done.returncode == 0 and abs(float(rows(folder / "bare" / "fit.csv")[0]["predicted"]) - wanted) > 0.02, done.stderr)
    # a fit re-weights light that was traced at another extinction
    done = run("fit", folder / "even.yaml", "--data", folder / "readings.csv", "--free", "media.fog.extinction_per_m",
               "--set", "media.fog.extinction_per_m=0.005", "-o", folder / "fitted")
    check(done.returncode == 0, done.stderr)
    (found,) = json.loads((folder / "fitted" / "fit.json").read_text())["parameters"]
    check(abs(found["value"] - 0.004) < 4 * found["standard_error"] < 0.0012, f"{found}")


def main():
    done = run("check", SCENE, *KEYS)
    if "install the package murk-gdal" in done.stderr:
        print("skipped: murk-gdal is not there")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        out = plan(folder)
        other_tables(folder, out)
        refused(folder)
        sites(folder)
        study(folder, out)
        fit(folder)
        # what the tool writes is what lies in the repository
        subprocess.run(["tools/make_terrain", folder / "terrain"], check=True)
        for path in sorted((folder / "terrain").iterdir()):
            check(path.read_bytes() == (pathlib.Path("scenes/terrain") / path.name).read_bytes(), f"{path.name}")
    ground()
    sys.exit(finish())


main()
