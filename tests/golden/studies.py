#!/usr/bin/env python3
"""The example studies with few photons: all rows come out, and light goes the
way that it must by factors that no noise reaches. Standard library only.
usage: studies.py MURK
"""

import csv
import os
import subprocess
import sys
import tempfile

failures = 0


def check(holds, *what):
    global failures
    if not holds:
        failures += 1
        print("not so:", *what)


def rows_of(murk, name, count):
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            [murk, "study", f"scenes/studies/{name}.yaml", "-o", folder,
             "--emit", "200", "--set", "placement.method=greedy"],
            capture_output=True, text=True, check=False)
        check(done.returncode == 0, name, "exit", done.returncode, done.stderr)
        path = os.path.join(folder, "table.csv")
        if not os.path.exists(path):
            return {}
        with open(path, encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
    check(len(rows) == count, name, "rows", len(rows))
    axes = list(rows[0])[:list(rows[0]).index("density")]
    for row in rows:
        check(row["failed"] == "", name, row["failed"])
        for key, text in row.items():
            if key.startswith("coverage") and text:
                check(0 <= float(text) <= 1, name, key, text)
    return {tuple(row[a] for a in axes): row for row in rows}


def number(rows, key, column="density"):
    row = rows.get(key)
    check(row is not None, "no row", key)
    return float(row[column]) if row else float("nan")


def main():
    murk = sys.argv[1]
    fog = rows_of(murk, "fog-yard", 10)
    for visibility in ("30", "10000"):
        day, night = (number(fog, (visibility, clock))
                      for clock in ("08:30", "22:00"))
        check(day > 50 * night, "day", day, "night", night)
    clear, dense = (number(fog, (v, "08:30"), "coverage_fixed")
                    for v in ("10000", "30"))
    check(clear > 2 * dense, "clear", clear, "dense", dense)

    rain = rows_of(murk, "rain-street", 16)
    for rate in ("0.5", "100"):
        check(number(rain, (rate, "12:00")) >
              100 * number(rain, (rate, "21:00")), "noon and night", rate)

    sea = rows_of(murk, "harbour", 20)
    check(number(sea, ("water/clear-ocean", "0", "1"), "at_4m_forward") >
          2 * number(sea, ("water/harbour", "0", "1"), "at_4m_forward"),
          "clear and turbid water at 4 m")

    hours = rows_of(murk, "day-night", 48)
    for date in ("2026-06-21", "2026-12-21"):
        check(number(hours, (date, "12:00:00")) >
              1e5 * number(hours, (date, "01:00:00")), "noon and night", date)
    lamps = number(hours, ("2026-12-21", "19:00:00"))
    check(1e3 * number(hours, ("2026-12-21", "23:00:00")) < lamps,
          "lamps after 22 o'clock", lamps)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
