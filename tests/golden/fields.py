"""What --export fields writes, read by OpenVDB's own Python module (Debian python3-openvdb),
against numbers found anew. fields.sh finds a python3 that has it.

usage: fields.py MURK
"""

import json
import math
import os
import resource
import signal
import subprocess
import sys
import tempfile

from crate import (BANDS, CLEAR, FOG, MIST, POOL, SCENE, depth_between, visible_from, write_scene)
from exchange import Failed, Murk, check, is_near
from vtk_file import read_vtk

try:
    import pyopenvdb as vdb
except ImportError:  # newer packages
    import openvdb as vdb

# ---- the files ----

def read_vdb(path):
    grids, file = vdb.readAll(path)
    names = [grid.name for grid in vdb.readAllGridMetadata(path)]
    check(len(names) == len(grids), names)
    return {grid.name: grid for grid in grids}


def read_vti(path):
    """Size, origin and spacing, texts and arrays."""
    image, texts, arrays = read_vtk(path, "ImageData")
    size = [int(x) for x in image.attrib["WholeExtent"].split()][1::2]
    for name, values in arrays.items():
        check(len(values) == math.prod(size), name, len(values))
    place = [[float(x) for x in image.attrib[key].split()] for key in ("Origin", "Spacing")]
    return size, place, texts, arrays


def voxels(size):
    return [(i, j, k) for k in range(size[2]) for j in range(size[1]) for i in range(size[0])]


def check_grid(grid, unit, band, box, size):
    check(grid.gridClass == "fog volume" and grid.background == 0, grid.name, grid.gridClass)
    facts = grid.metadata
    check(facts["unit"] == unit and facts["band_nm"] == band, grid.name, facts)
    for key in ("quantity", "scene", "scene_sha256", "murk_version", "murk_commit"):
        check(facts[key], grid.name, "has no", key)
    check(facts["seed"] == "7" and len(facts["scene_sha256"]) == 64, facts)
    for index, share in (((0, 0, 0), 0.5), ([n - 1 for n in size], None)):
        want = [low + (high - low) * (share / n if share else 1 - 0.5 / n)
                for low, high, n in zip(*box, size)]
        check(math.dist(grid.transform.indexToWorld(index), want) < 1e-9, grid.name, index)


def check_density(grids, first):
    """Blender's grid: the first one's values above 0, times a factor."""
    shown, of = grids["density"], grids[first]
    check(shown.metadata["of"] == first, shown.metadata)
    factor = float(shown.metadata["factor"])
    a, b = shown.getConstAccessor(), of.getConstAccessor()
    lit = 0
    for value in of.iterOnValues():
        ijk = value.min
        want = max(0, b.getValue(ijk)) * factor
        check(is_near(a.getValue(ijk), want, 1e-6) if want else a.getValue(ijk) == 0, ijk, want)
        lit += want > 0
    check(lit > 10, "nothing to show", first)


# ---- tests ----

def test_coverage_and_depth(murk):
    size = (16, 12, 6)
    plan, _ = murk.place("plan", write_scene(murk), "--export", "fields", "--voxel", "0.5")
    sensors = [s["position_m"] for s in plan["sensors"]]
    coverage = read_vdb(murk.path("plan", "coverage.vdb"))
    depth = read_vdb(murk.path("plan", "optical_depth.vdb"))
    extinction = read_vdb(murk.path("plan", "extinction.vdb"))
    check(sorted(coverage) == ["coverage_450nm", "coverage_650nm", "density", "sensors_450nm",
                               "sensors_650nm"], sorted(coverage))
    check_density(coverage, "coverage_450nm")
    check_density(depth, "optical_depth_450nm")
    check_density(extinction, "extinction_450nm")
    check(extinction["density"].metadata["factor"] == "1", "an extinction is a density")
    _, place, texts, arrays = read_vti(murk.path("plan", "fields.vti"))
    check(place == [[0, 0, 0], [0.5, 0.5, 0.5]] and texts["seed"] == "7", place, texts)
    box = ((0, 0, 0), (8, 6, 3))
    judged = seen = unseen = none = 0
    for band, nm in enumerate(BANDS):
        names = ["%s_%dnm" % (name, nm)
                 for name in ("coverage", "sensors", "optical_depth", "extinction")]
        grids = [coverage[names[0]], coverage[names[1]], depth[names[2]], extinction[names[3]]]
        read = [grid.getConstAccessor() for grid in grids]
        for grid, unit in zip(grids, ("1", "1", "1", "1/m")):
            check_grid(grid, unit, str(nm), box, size)
        for n, ijk in enumerate(voxels(size)):
            at = [0.25 + 0.5 * x for x in ijk]
            have = [grid.getValue(ijk) for grid in read]
            for name, value in zip(names, have):
                check(arrays[name][n] == value, name, ijk, "is another in fields.vti")
            inside = all(low <= x < high for x, low, high in zip(at, *POOL))
            check(is_near(have[3], FOG[band] + (MIST[band] if inside else 0), 1e-6), at, have[3])
            open_to = visible_from(at, sensors)
            if open_to is None:
                continue
            judged += 1
            tau = min((depth_between(at, s, band) for s in open_to), default=None)
            if tau is None:
                none += 1
                check(have[:3] == [0, 0, -1], at, have)
                continue
            check(abs(have[2] - tau) < 1e-5, at, have[2], tau)
            check(abs(have[0] - math.exp(-tau)) < 0.6 / CLEAR, at, have[0], math.exp(-tau))
            check(have[1] == len(open_to), at, have[1], len(open_to))
            seen += have[1] > 1
            unseen += have[1] == 1
    check(judged > 0.95 * 2 * math.prod(size), "judged", judged)
    check(seen > 100 and unseen > 100 and none > 50, seen, unseen, none)
    check_targets(murk, coverage)


def check_targets(murk, coverage):
    """murk sense of a target in a voxel's middle says what the field says there."""
    for ijk in ((3, 4, 2), (9, 9, 4), (12, 3, 5)):
        with open(murk.path("points.csv"), "w") as file:
            file.write("x_m,y_m,z_m\n%s\n" % ",".join(str(0.25 + 0.5 * x) for x in ijk))
        for nm in BANDS:
            done = murk.run("sense", murk.path("scene.yaml"), "--sensors",
                            murk.path("plan", "plan.json"), "--format", "json", "--set",
                            "placement.targets={points: %s, band_nm: %d}" %
                            (murk.path("points.csv"), nm))
            want = json.loads(done.stdout)["coverage"]["in_sample"]
            have = coverage["coverage_%dnm" % nm].getConstAccessor().getValue(ijk)
            check(abs(have - want) < 1e-7, "target", ijk, have, want)


def test_shares_that_add_up(murk):
    """Of independent chances and of redundancy, from the same sensors."""
    scene = write_scene(murk)
    murk.place("one", scene)
    values = {}
    for mode in ("detection=weighted", "detection=independent", "redundancy=2"):
        out = murk.path("mode")
        murk.run("sense", scene, "--sensors", murk.path("one", "plan.json"), "-q", "-o", out,
                 "--export", "fields", "--voxel", "1", "--set", "placement." + mode)
        grids = read_vdb(murk.path("mode", "coverage.vdb"))
        check(("clarity_450nm" in grids) == (mode != "detection=weighted"), mode, sorted(grids))
        values[mode] = {name: [grid.getConstAccessor().getValue(ijk)
                               for ijk in voxels((8, 6, 3))] for name, grid in grids.items()}
    plain = values["detection=weighted"]["coverage_450nm"]
    for mode in ("detection=independent", "redundancy=2"):
        check(values[mode]["clarity_450nm"] == plain, mode)
    chances, twice = (values[m]["coverage_450nm"] for m in ("detection=independent",
                                                            "redundancy=2"))
    for one, many, two, n in zip(plain, chances, twice, values["redundancy=2"]["sensors_450nm"]):
        check(one - 1.5 / CLEAR <= many <= 1 and one / 2 <= two + 1e-7 <= one + 2e-7, one, many,
              two)
        if n == 1:
            check(abs(many - one) < 1.5 / CLEAR and abs(two - one / 2) < 1e-6, one, many, two)
        if n > 1:
            check(many > one and two > one / 2, one, many, two)


def test_photon_density(murk):
    """Fluence rate over h c / wavelength; errors likewise; the sum adds in squares."""
    out = murk.path("light")
    murk.run("trace", write_scene(murk), "-q", "-o", out, "--export", "fields", "--voxel", "1")
    check(not os.path.exists(murk.path("light", "coverage.vdb")), "coverage without sensors")
    fluence, error = (read_vdb(os.path.join(out, name))
                      for name in ("box.vdb", "box_error.vdb"))
    photons = read_vdb(os.path.join(out, "box_photons.vdb"))
    box, size = ((1, 1, 1), (7, 5, 2)), (6, 4, 2)
    kinds = ("photon_density", "photon_density_error")
    check(sorted(photons) == sorted(["density", *kinds] + ["%s_%dnm" % (kind, nm)
                                                           for kind in kinds for nm in BANDS]),
          sorted(photons))
    check_density(photons, "photon_density")
    _, place, _, arrays = read_vti(os.path.join(out, "box.vti"))
    check(place == [[1, 1, 1], [1, 1, 0.5]], place)
    per_j = {nm: nm * 1e-9 / (6.62607015e-34 * 299792458) for nm in BANDS}
    lit = 0
    for nm in BANDS:
        check_grid(fluence["fluence_%dnm" % nm], "W/m2", str(nm), box, size)
        check_grid(photons["photon_density_%dnm" % nm], "1/s/m2", str(nm), box, size)
    check_grid(photons["photon_density"], "1/s/m2", "all", box, size)
    for n, ijk in enumerate(voxels(size)):
        total = square = 0
        for nm in BANDS:
            for source, kind in ((fluence, kinds[0]), (error, kinds[1])):
                watts = source["fluence_%dnm" % nm].getConstAccessor().getValue(ijk)
                name = "%s_%dnm" % (kind, nm)
                have = photons[name].getConstAccessor().getValue(ijk)
                check(is_near(have, watts * per_j[nm], 1e-6), ijk, name, have, watts)
                check(arrays[name][n] == have, name, ijk)
                total, square = (total + have, square) if kind == kinds[0] else \
                    (total, square + have ** 2)
                lit += have > 0
        check(is_near(photons[kinds[0]].getConstAccessor().getValue(ijk), total, 1e-6), ijk)
        check(is_near(photons[kinds[1]].getConstAccessor().getValue(ijk), math.sqrt(square),
                      1e-6), ijk)
        check(arrays["fluence_650nm"][n] ==
              fluence["fluence_650nm"].getConstAccessor().getValue(ijk), "fluence", ijk)
    check(lit == 4 * (math.prod(size) - 4), "lit, but for the crate", lit)


def test_the_usual_size(murk):
    """Cubes of some 100,000 voxels that fill the domain; a medium reads its extinction."""
    plan = write_scene(murk)
    murk.run("trace", plan, "-q", "-o", murk.path("usual"), "--export", "fields")
    grid = read_vdb(murk.path("usual", "extinction.vdb"))["extinction_450nm"]
    size = [n + 1 for n in grid.evalActiveVoxelBoundingBox()[1]]
    edge = grid.transform.voxelSize()
    check(80000 < math.prod(size) <= 100000, size)
    check(max(edge) < 1.1 * min(edge), edge)
    for n, e, all_m in zip(size, edge, (8, 6, 3)):
        check(is_near(n * e, all_m, 1e-12), n, e)
    text = SCENE.replace("  fog: {extinction_per_m: [0.2, 0.1], albedo: 0.9}",
                         "  fog: {vdb: usual/extinction.vdb, extinction_per_m: 1, albedo: 0.9}")
    done = murk.run("check", write_scene(murk, text, "again.yaml"), "--format", "json")
    (fact,) = [m for m in json.loads(done.stdout)["media"] if m["name"] == "fog"]
    check(is_near(fact["grid"]["maximum"], 0.7, 1e-6), fact)


def fails(murk, code, words, *arguments):
    done = murk.run(*arguments, code=code)
    check(words in done.stderr and done.stderr.count("\n") == 1, arguments, done.stderr)


def test_bad_options(murk):
    scene, out = write_scene(murk), ("-q", "-o", murk.path("bad"))
    sensors = murk.path("sensors.csv")
    with open(sensors, "w") as file:
        file.write("type,x_m,y_m,z_m\nnode,1.1,1.1,1.1\n")
    ask = ("--export", "fields")
    fails(murk, 2, "\"smoke\" is not an export; allowed are matrix, or-library, lp, fields, photons, surfaces, light, geojson and geo-csv", "trace", scene,
          *out, "--export", "fields,smoke")
    fails(murk, 2, "needs a folder", "trace", scene, "-q", *ask)
    fails(murk, 2, "are of murk place", "sense", scene, "--sensors", sensors, *out, "--export",
          "fields,lp")
    with open(murk.path("m.csv"), "w") as file:
        file.write("1,0\n0,1\n")
    fails(murk, 2, "are of a scene", "place", "--matrix", murk.path("m.csv"), "--count", "1", *out,
          *ask)
    fails(murk, 2, "placement.over must be null", "place", scene, *out, *ask, "--set",
          "placement.over=worst", "--set", "conditions={clear: {}, thick: "
          "{media.fog.extinction_per_m: 1}}")
    for word in ("0", "-1", "nan", "inf", "1e300", "soup", ""):
        fails(murk, 2, "must be more than 0", "trace", scene, *out, *ask, "--voxel=" + word)
    for word in ("0.01", "1e-9", "1e-300"):
        fails(murk, 2, "must be at most 10000000", "trace", scene, *out, *ask, "--voxel", word)
    fails(murk, 2, "which are not asked for", "trace", scene, *out, "--voxel", "1")
    for name in ("coverage", "fields", "extinction", "optical_depth"):
        fails(murk, 2, "which a file of the export fields has", "trace", scene, *out, *ask, "--set",
              "tallies.0.name=" + name)
    check(not os.path.exists(murk.path("bad")), "a run that is refused makes a folder")


def test_what_cannot_be_written_costs_no_plan(murk):
    """A name that is taken, then a disk without room for large files."""
    scene = write_scene(murk)
    os.makedirs(murk.path("taken", "coverage.vdb"))
    plan, said = murk.place("taken", scene, "--export", "fields", "--voxel", "1", code=1)
    check("coverage.vdb: cannot write: not a regular file" in said and said.count("\n") == 1, said)
    check(len(plan["sensors"]) == 3, plan)
    check(read_vdb(murk.path("taken", "optical_depth.vdb")), "the others are written")

    def small():
        resource.setrlimit(resource.RLIMIT_FSIZE, (600000, 600000))

    out = murk.path("full")
    done = subprocess.run([murk.program, "place", scene, "-q", "-o", out, "--export", "fields"],
                          capture_output=True, text=True, preexec_fn=small, restore_signals=False)
    check(done.returncode == 1 and "cannot write: " in done.stderr and
          done.stderr.count("\n") == 1, done.returncode, done.stderr)
    names = os.listdir(out)
    check("plan.json" in names and "light.murk" in names and "extinction.vdb" in names, names)
    check("fields.vti" not in names and not [n for n in names if "staged" in n], names)


def test_an_interrupt_costs_no_plan(murk):
    """While fields are worked on, which --progress tells: some ten seconds on one thread."""
    out = murk.path("stopped")
    run = subprocess.Popen([murk.program, "place", write_scene(murk), "-o", out, "--export",
                            "fields", "--voxel", "0.034", "--threads", "1", "--progress", "always"],
                           stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    for line in run.stderr:
        if "fields" in line:
            run.send_signal(signal.SIGINT)
            break
    said = run.stderr.read()
    check(run.wait() == 130 and "interrupted" in said, run.returncode, said)
    names = os.listdir(out)
    check("plan.json" in names and "coverage.vdb" not in names and
          not [n for n in names if "staged" in n], names)


def main():
    program = sys.argv[1]
    for test in (test_coverage_and_depth, test_shares_that_add_up, test_photon_density,
                 test_the_usual_size, test_bad_options,
                 test_what_cannot_be_written_costs_no_plan, test_an_interrupt_costs_no_plan):
        with tempfile.TemporaryDirectory() as folder:
            try:
                test(Murk(program, folder))
            except Failed as failed:
                print("%s: %s" % (test.__name__, failed))
                return 1
    print("fields are what they say")
    return 0


if __name__ == "__main__":
    sys.exit(main())
