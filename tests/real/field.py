#!/usr/bin/env python3
"""The readers of field data on the real files: every reading that is asked for
is there, in the right unit, and of the casts in water a line through the
logarithms is the published attenuation, so rows and columns are the right ones.
Standard library only.
usage: field.py
"""

import csv
import math
import pathlib
import sys

sys.path.insert(0, "tools")
import field_data  # noqa: E402

DATA = pathlib.Path("../shared/data/field")
SEA = pathlib.Path("../shared/physics/field_alomex15_profiles.csv")

failures = checks = 0


def check(holds, text):
    global failures, checks
    checks += 1
    if not holds:
        print("not so:", text)
        failures += 1


def smoke():
    beams = DATA / "smoke/FAA_B707_beam_geometry.csv"
    for fire in (1, 2):
        file = DATA / f"smoke/TestCase{fire}_FAA_EXPDATA.csv"
        value = {}
        for first in (10, 160):
            times = [float(first + 10 * i) for i in range(15)]
            field = field_data.smoke(file, beams, times, "LT_Low")
            check(len(field.rows) == 90 and not field.notes, f"fire {fire}")
            value.update({(row["condition"], row["y_m"], row["z_m"]):
                          row["value"] for row in field.rows})
        # as the file has them, read by eye
        want = {("t060", 2.95, 1.3): (44.26, 53.50),
                ("t300", 4.90, .33): (82.49, 33.96),
                ("t300", 1.73, 1.3): (26.10, 46.43)}
        for key, values in want.items():
            check(value[key] == values[fire - 1], f"fire {fire}: {key}")


def slope(points):
    """Minus the slope of the logarithm by least squares."""
    x = [d for d, _ in points]
    y = [math.log(v) for _, v in points]
    mean = sum(x) / len(x)
    return -(sum((a - mean) * b for a, b in zip(x, y))
             / sum((a - mean) ** 2 for a in x))


def water():
    folder = DATA / "water/maine_dep"
    casts, notes = field_data.water_casts(folder / "dep_irradiance_data.csv")
    with open(folder / "light_extinction_data.csv", newline="") as file:
        published = list(csv.DictReader(file))
    check(len(published) == 292 and not notes, "292 casts, no gaps")
    for row in published:
        cast = (row["site"], row["sample_date"])
        points = casts[cast]
        check(len(points) == int(row["k_n"]), f"{cast}: {len(points)} readings")
        check(math.isclose(slope(points), float(row["k_est"]), rel_tol=1e-9),
              f"{cast}: k {slope(points)}, published {row['k_est']}")


def sea():
    stations = {row["station"] for _, row in
                field_data.table(SEA, ("station",))}
    check(len(stations) == 15, "15 stations")
    for station in sorted(stations):
        field = field_data.sea(SEA, station, 1.2)
        check(len(field.rows) >= 9, f"{station}: {len(field.rows)} rows")


def main():
    for file in (DATA, SEA):
        if not file.exists():
            print(f"skipped: no {file}")
            return 77
    smoke()
    water()
    sea()
    print(f"{checks} checks, {failures} failed")
    return failures != 0


if __name__ == "__main__":
    sys.exit(main())
