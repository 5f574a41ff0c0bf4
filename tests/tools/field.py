#!/usr/bin/env python3
"""tools/read_field, on files of our own in the shape of the real ones: what it
writes, what it leaves out and says so, and what it refuses with its line.
Standard library only.
usage: field.py MURK
"""

import csv
import pathlib
import subprocess
import sys
import tempfile

BEAMS = """\
# remarks
id,x1,y1,z1,x2,y2,z2,length_m
LT_Fwd,-1.5,1,1.3,1.5,1,1.3,3
LT_Mid,-1.5,3,1.3,1.5,3,1.3,3
LT_Aft,-1.5,5,1.3,1.5,5,1.3,3
LT_High,-1.5,4,1,1.5,4,1,3
LT_Med,-1.5,4,0.7,1.5,4,0.7,3
LT_Low,-1,4,0.3,1,4,0.3,2
"""
SMOKE = """\
Time,TC1,LT_Fwd,LT_Mid,LT_Aft,LT_High,LT_Med,LT_Low
s,Avg. K,%/m,%/m,%/m,%/m,%/m,%/m
0,0,100.1,99.9,100,100,100,99.7
10,1,80,70,NaN,95,100,100
20,2,50,40,45,60,90,
"""
CASTS = """\
site_name,site,dt,depth,irr_air,irr_water,irr_pct
Some Cove - SC1,SC1,2020-06-01,0.5,NA,1000,60
Some Cove - SC1,SC1,2020-06-01,1,NA,800,50
Some Cove - SC1,SC1,2020-06-01,2,NA,NA,NA
Some Cove - SC1,SC1,2020-06-01,3,NA,200,10
"Other, Bay",OB 2,2020-06-02,1,NA,0,0
"Other, Bay",OB 2,2020-06-02,2,NA,5,5
"""
SEA = """\
# remarks
station,utc,lat[deg],lon[deg],depth[m],E0_531[file units],n_E0,c532[1/m],c514[1/m],n_c,T[K]
A1,2015-11-02T13:00:00,36,1.5,2,2.0,9,0.3,0.3,9,290
A1,2015-11-02T13:00:00,36,1.5,4,1.6,9,0.2,0.2,9,290
A1,2015-11-02T13:00:00,36,1.5,8,1.0,9,0.2,0.2,9,290
A1,2015-11-02T13:00:00,36,1.5,10,0.8,9,,0.2,9,290
A1,2015-11-02T13:00:00,36,1.5,12,0.6,9,0.26,0.2,9,290
A1,2015-11-02T13:00:00,36,1.5,16,,0,0.2,0.2,9,290
B2,2015-11-03T13:00:00,36,1.5,4,1.6,9,0.2,0.2,9,290
"""

failures = checks = 0


def check(holds, text):
    global failures, checks
    checks += 1
    if not holds:
        print("not so:", text)
        failures += 1


def read_field(*arguments):
    return subprocess.run(["tools/read_field", *map(str, arguments)],
                          capture_output=True, text=True, timeout=60)


def rows_of(folder):
    with open(folder / "data.csv", newline="") as file:
        return list(csv.DictReader(file))


def reads_scene(murk, folder):
    run = subprocess.run([murk, "check", folder / "scene.yaml"],
                         capture_output=True, text=True, timeout=60)
    check(run.returncode == 0, f"murk check: {run.stderr}")


def smoke(murk, room):
    (room / "s.csv").write_text(SMOKE)
    (room / "b.csv").write_text(BEAMS)
    out = room / "smoke"
    run = read_field("smoke", room / "s.csv", room / "b.csv", "--at", "10,20",
                     "--hold-out", "LT_High", "-o", out)
    check(run.returncode == 0, run.stderr)
    check("LT_Aft is missing at 10 s" in run.stderr, run.stderr)
    check("LT_Low is missing at 20 s" in run.stderr, run.stderr)
    check("10 readings, 8 to fit" in run.stdout, run.stdout)
    rows = rows_of(out)
    check(len(rows) == 10, "all readings but two")
    check({r["kind"] for r in rows} == {"transmittance"}, "all are beams")
    check({r["unit"] for r in rows} == {"transmission_percent_per_m"}, "unit")
    check([r["use"] for r in rows].count("hold_out") == 2, "one beam held out")
    low = [r for r in rows if r["z_m"] == "0.3"]
    check(len(low) == 1 and low[0]["condition"] == "t010"
          and [float(low[0][c]) for c in ("x_m", "y_m", "x2_m", "y2_m", "z2_m",
                                          "value")]
          == [-1, 4, 1, 4, .3, 100], f"the low beam: {low}")
    reads_scene(murk, out)


def water(murk, room):
    (room / "w.csv").write_text(CASTS)
    out = room / "water"
    run = read_field("water", room / "w.csv", "--cast", "SC1,2020-06-01",
                     "-o", out)
    check(run.returncode == 0, run.stderr)
    check("w.csv:4: depth '2', irr_pct 'NA': left out" in run.stderr,
          run.stderr)
    check("w.csv:6: depth '1', irr_pct '0': left out" in run.stderr,
          run.stderr)
    rows = rows_of(out)
    check([(float(r["z_m"]), float(r["z2_m"]), float(r["value"]),
            float(r["standard_error"])) for r in rows]
          == [(0, -.5, 60, 3), (0, -1, 50, 2.5), (0, -3, 10, .5)], f"{rows}")
    check({r["gain"] for r in rows} == {"SC1-2020-06-01"}, "one gain")
    check({r["unit"] for r in rows} == {"percent"}, "unit")
    reads_scene(murk, out)


def sea(murk, room):
    (room / "a.csv").write_text(SEA)
    out = room / "sea"
    run = read_field("sea", room / "a.csv", "--station", "A1", "--acceptance",
                     "1.2", "-o", out)
    check(run.returncode == 0, run.stderr)
    rows = rows_of(out)
    check([(r["kind"], float(r["z_m"]), float(r["value"])) for r in rows]
          == [("fluence", -4, 1.6), ("fluence", -8, 1), ("fluence", -12, .6),
              ("transmittance", -22, .215)], f"{rows}")
    check(rows[3]["acceptance_deg"] == "1.2"
          and rows[3]["unit"] == "extinction_per_m", f"{rows[3]}")
    reads_scene(murk, out)
    run = read_field("sea", room / "a.csv", "--station", "A1", "--light-only",
                     "-o", out)
    check(run.returncode == 0 and len(rows_of(out)) == 3, run.stderr)


def refused(room, said, arguments, files):
    for name, text in files.items():
        (room / name).write_bytes(text if isinstance(text, bytes)
                                  else text.encode())
    out = room / "refused"
    run = read_field(*[room / a if str(a).endswith(".csv") else a
                       for a in arguments], "-o", out)
    check(run.returncode == 2, f"exit {run.returncode}: {run.stderr}")
    check(said in run.stderr and run.stderr.count("\n") == 1,
          f"{said!r} in {run.stderr!r}")
    check(not out.exists(), "nothing is written")


def refusals(room):
    at = ["smoke", "s.csv", "b.csv", "--at", "10"]

    def smoke_is(said, old, new, arguments=at):
        refused(room, said, arguments,
                {"s.csv": SMOKE.replace(old, new), "b.csv": BEAMS})

    def beams_are(said, old, new):
        refused(room, said, at, {"s.csv": SMOKE,
                                 "b.csv": BEAMS.replace(old, new)})

    smoke_is("s.csv:4: LT_Fwd: is 'x7', must be a number", "10,1,80",
             "10,1,x7")
    smoke_is("s.csv:4: LT_Fwd: is inf, must be -10..110", "10,1,80",
             "10,1,inf")
    smoke_is("s.csv:4: Time: is missing", "10,1,80", ",1,80")
    smoke_is("s.csv:5: Time 10 s is there twice", "20,2", "10,2")
    smoke_is("column LT_Mid is there 0 times", "LT_Mid", "LT_Middle")
    smoke_is("column LT_Mid is there 2 times", "TC1", "LT_Mid")
    smoke_is("s.csv:5: 7 cells, must be 8", "90,\n", "90\n")
    smoke_is("LT_Med is in '1/m', must be %/m", "%/m,%/m\n", "1/m,%/m\n")
    smoke_is("that is obscuration", "100.1,99.9,100,100,100,99.7",
             "0,0,0,0,0,0")
    smoke_is("s.csv: has no rows below its header", SMOKE, "Time," + ",".join(
        line.split(",")[0] for line in BEAMS.splitlines()[2:]) + "\n")
    smoke_is("s.csv: is empty", SMOKE, "\n")
    smoke_is("has no time 15 s, has 0..20 s", "", "",
             ["smoke", "s.csv", "b.csv", "--at", "15"])
    smoke_is("beam LT_X is none of", "", "", at + ["--hold-out", "LT_X"])
    smoke_is("17 times, must be 1..16", "", "",
             at[:-1] + [",".join(map(str, range(17)))])
    smoke_is("--at: is 'soon', must be a number", "", "", at[:-1] + ["soon"])
    beams_are("misses beam LT_Low", "LT_Low", "LT_Lower")
    beams_are("b.csv:8: LT_Low: length_m is 3, its ends are 2 m apart",
              ".3,2\n", ".3,3\n")
    beams_are("LT_Fwd: is there twice", "LT_Mid", "LT_Fwd")
    beams_are("LT_Fwd: x1: is missing",
              "LT_Fwd,-1.5", "LT_Fwd,nan")
    refused(room, "s.csv: is no text", at, {"s.csv": b"\xff\xfe\0", "b.csv":
                                            BEAMS})
    refused(room, "holds a zero byte", at, {"s.csv": b"Time\0\n", "b.csv":
                                            BEAMS})
    cast = ["water", "w.csv", "--cast", "SC1,2020-06-01"]
    refused(room, "has no cast SC1 2020-07-01", cast[:-1] + ["SC1,2020-07-01"],
            {"w.csv": CASTS})
    refused(room, "has no cast SC1\n", cast[:-1] + ["SC1"], {"w.csv": CASTS})
    refused(room, "readings at 1 depths, must be 2", cast[:-1]
            + ["OB 2,2020-06-02"], {"w.csv": CASTS})
    refused(room, "w.csv:2: depth: is -1, must be 0..1000", cast,
            {"w.csv": CASTS.replace("0.5,NA", "-1,NA")})
    station = ["sea", "a.csv", "--station", "A1"]
    refused(room, "has no station C3", station[:-1] + ["C3"], {"a.csv": SEA})
    refused(room, "light at 1 depths", station[:-1] + ["B2"], {"a.csv": SEA})
    refused(room, "a.csv:3: lat: is 96, must be -90..90", station,
            {"a.csv": SEA.replace("36,1.5,2,", "96,1.5,2,")})
    refused(room, "missing.csv: No such file", ["sea", "missing.csv",
                                                "--station", "A1"], {})


def main():
    with tempfile.TemporaryDirectory() as folder:
        room = pathlib.Path(folder)
        smoke(sys.argv[1], room)
        water(sys.argv[1], room)
        sea(sys.argv[1], room)
        refusals(room)
    print(f"{checks} checks, {failures} failed")
    return failures != 0


if __name__ == "__main__":
    sys.exit(main())
