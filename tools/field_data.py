"""Field measurements, read from the files of those who made them, as what
`murk fit` takes: a scene and rows of its --data CSV. Of tools/read_field and
tools/validate_fit.

A source is a function that returns a Field: text of a scene, rows, and notes
of what was left out. What cannot be right raises FieldError with file and
line. A reading that is missing (empty, NA, NaN) is left out, never guessed.
"""

import csv
import dataclasses
import math
import pathlib

COLUMNS = ("kind", "condition", "x_m", "y_m", "z_m", "x2_m", "y2_m", "z2_m",
           "radius_m", "acceptance_deg", "gain", "unit", "value",
           "standard_error", "use")
CONDITIONS_MAX = 16   # of a scene
MISSING = ("", "na", "nan")


class FieldError(Exception):
    """One line: file, line, what was found, what is allowed."""


@dataclasses.dataclass
class Field:
    scene: str
    rows: list       # of dicts by COLUMNS
    notes: list      # lines for people
    free: tuple      # keys to fit, and their bounds
    bounds: tuple

    def write(self, folder):
        """Makes FOLDER/scene.yaml and FOLDER/data.csv."""
        folder = pathlib.Path(folder)
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "scene.yaml").write_text(self.scene)
        with open(folder / "data.csv", "w", newline="") as out:
            writer = csv.DictWriter(out, COLUMNS, restval="",
                                    lineterminator="\n")
            writer.writeheader()
            writer.writerows(self.rows)


def number(text, place, low=-math.inf, high=math.inf):
    """A finite number within a range; None where it is missing."""
    text = (text or "").strip()
    if text.lower() in MISSING:
        return None
    try:
        value = float(text)
    except ValueError:
        raise FieldError(f"{place}: is {text!r}, must be a number") from None
    if not low <= value <= high:
        raise FieldError(f"{place}: is {text}, must be {low:g}..{high:g}")
    return value


def needed(text, place, low=-math.inf, high=math.inf):
    value = number(text, place, low, high)
    if value is None:
        raise FieldError(f"{place}: is missing, must be a number")
    return value


def table(path, columns):
    """(line, {column: text}) of each row below the header; `#` lines are
    remarks. All `columns` must be there, once."""
    try:
        text = pathlib.Path(path).read_text(encoding="utf-8-sig")
    except OSError as error:
        raise FieldError(f"{path}: {error.strerror}") from None
    except UnicodeDecodeError:
        raise FieldError(f"{path}: is no text in UTF-8") from None
    if "\0" in text:
        raise FieldError(f"{path}: is no table: holds a zero byte")
    lines = [(i, line) for i, line in enumerate(text.splitlines(), 1)
             if line.strip() and not line.startswith("#")]
    if not lines:
        raise FieldError(f"{path}: is empty")
    header = [name.strip() for name in next(csv.reader([lines[0][1]]))]
    for name in columns:
        if header.count(name) != 1:
            raise FieldError(f"{path}:{lines[0][0]}: column {name} is there "
                             f"{header.count(name)} times, must be once")
    rows = []
    for i, line in lines[1:]:
        cells = next(csv.reader([line]))
        if len(cells) != len(header):
            raise FieldError(f"{path}:{i}: {len(cells)} cells, must be "
                             f"{len(header)} as in the header")
        rows.append((i, dict(zip(header, cells))))
    if not rows:
        raise FieldError(f"{path}: has no rows below its header")
    return rows


def few_conditions(names, what):
    if not 1 <= len(names) <= CONDITIONS_MAX:
        raise FieldError(f"{len(names)} {what}, must be 1..{CONDITIONS_MAX}: "
                         "each is a condition of the scene")


def conditions(names):
    return "conditions: {" + ", ".join(f"{name}: {{}}" for name in names) + "}"


# ---- smoke in a compartment, by light beams ----

SMOKE_BEAMS = ("LT_Fwd", "LT_Mid", "LT_Aft", "LT_High", "LT_Med", "LT_Low")
SMOKE_ERROR = 1.0        # % per metre: zeros of these beams wander by that
SMOKE_LENGTH_OFF_M = .01

SMOKE_SCENE = """\
# Smoke of a fire in the cargo compartment of a Boeing 707, by six light beams.
# It begins at a height and thickens evenly up to the ceiling: the layer's foot
# and its extinction under the ceiling are what is looked for, time by time.
# Beams say nothing of albedo or phase function: any would do.
murk: 1
domain: {min_m: [-1.59, 0, 0], max_m: [1.59, 6.73, 1.37]}
media:
  smoke:
    profile: {z_m: [0.6, 1.37], extinction_per_m: [0, 1]}
    albedo: 0.2
    phase: {hg: 0.6}
regions: [{medium: smoke}]
lights: [{type: point, position_m: [0, 0.5, 0.1], power_w: 1}]
"""


def smoke_beams(path):
    """{name: ((x1, y1, z1), (x2, y2, z2))} [m]."""
    ends = ("x1", "y1", "z1", "x2", "y2", "z2")
    beams = {}
    for line, row in table(path, ("id", *ends, "length_m")):
        place = f"{path}:{line}: {row['id']}"
        v = [needed(row[c], f"{place}: {c}", -1e3, 1e3) for c in ends]
        length = needed(row["length_m"], f"{place}: length_m", 1e-3, 1e3)
        if abs(math.dist(v[:3], v[3:]) - length) > SMOKE_LENGTH_OFF_M:
            raise FieldError(f"{place}: length_m is {length:g}, its ends are "
                             f"{math.dist(v[:3], v[3:]):.4g} m apart")
        if row["id"] in beams:
            raise FieldError(f"{place}: is there twice")
        beams[row["id"]] = (tuple(v[:3]), tuple(v[3:]))
    return beams


def smoke_readings(path, names):
    """{time [s]: {beam: transmission [% per m]}}: 100 is clear. Beams that are
    missing at a time are not in it."""
    rows = table(path, ("Time", *names))
    line, units = rows[0]
    for name in names:
        if units[name].strip() != "%/m":
            raise FieldError(f"{path}:{line}: {name} is in "
                             f"{units[name].strip()!r}, must be %/m")
    by_time = {}
    for line, row in rows[1:]:
        t = needed(row["Time"], f"{path}:{line}: Time", 0, 1e6)
        if t in by_time:
            raise FieldError(f"{path}:{line}: Time {t:g} s is there twice")
        read = {n: number(row[n], f"{path}:{line}: {n}", -10, 110)
                for n in names}
        by_time[t] = {n: v for n, v in read.items() if v is not None}
    if not by_time:
        raise FieldError(f"{path}: has no readings below its units")
    first = by_time[min(by_time)]
    if first and sum(first.values()) / len(first) < 50:
        raise FieldError(f"{path}: reads {min(first.values()):g} %/m at first, "
                         "before there is smoke: that is obscuration, and "
                         "transmission is what is read here")
    return by_time


def smoke(readings, geometry, times, held_out=None):
    """The six beams of the FAA's tests at these times [s], each a condition;
    beam `held_out` is not for fitting."""
    beams = smoke_beams(geometry)
    for name in SMOKE_BEAMS:
        if name not in beams:
            raise FieldError(f"{geometry}: misses beam {name}")
    if held_out is not None and held_out not in SMOKE_BEAMS:
        raise FieldError(f"beam {held_out} is none of {', '.join(SMOKE_BEAMS)}")
    by_time = smoke_readings(readings, SMOKE_BEAMS)
    few_conditions(times, "times")
    rows, notes = [], []
    for t in times:
        if t not in by_time:
            raise FieldError(f"{readings}: has no time {t:g} s, has "
                             f"{min(by_time):g}..{max(by_time):g} s")
        for name in SMOKE_BEAMS:
            if name not in by_time[t]:
                notes.append(f"{name} is missing at {t:g} s: left out")
                continue
            (x1, y1, z1), (x2, y2, z2) = beams[name]
            rows.append({
                "kind": "transmittance", "condition": f"t{t:03g}",
                "x_m": x1, "y_m": y1, "z_m": z1,
                "x2_m": x2, "y2_m": y2, "z2_m": z2,
                "unit": "transmission_percent_per_m",
                "value": by_time[t][name], "standard_error": SMOKE_ERROR,
                "use": "hold_out" if name == held_out else "fit"})
    scene = SMOKE_SCENE + conditions([f"t{t:03g}" for t in times]) + "\n"
    return Field(scene, rows, notes,
                 ("media.smoke.profile.z_m.0@each",
                  "media.smoke.profile.extinction_per_m.1@each"),
                 ("media.smoke.profile.z_m.0=0:1.25",
                  "media.smoke.profile.extinction_per_m.1=0.0001:10"))


# ---- light against depth in coastal water ----

WATER_ERROR = .05        # of the reading: errors are in proportion to it

WATER_SCENE = """\
# Water in which light was measured against depth. A ray straight down through
# an extinction of k stands for daylight's diffuse attenuation, which is not
# the extinction of a beam; what is under the surface is free (gain).
murk: 1
domain: {{min_m: [-1, -1, -{depth:g}], max_m: [1, 1, 0]}}
media: {{water: {{extinction_per_m: 0.5, albedo: 0.5}}}}
regions: [{{medium: water}}]
lights: [{{type: point, position_m: [0.5, 0.5, -0.01], power_w: 1}}]
"""


def water_casts(path):
    """{(site, date): [(depth [m], percent of the light above)]}, and notes."""
    casts, notes = {}, []
    for line, row in table(path, ("site", "dt", "depth", "irr_pct")):
        place = f"{path}:{line}"
        depth = number(row["depth"], f"{place}: depth", 0, 1e3)
        percent = number(row["irr_pct"], f"{place}: irr_pct", -1e3, 1e3)
        if depth is None or percent is None or not percent > 0:
            notes.append(f"{place}: depth {row['depth']!r}, irr_pct "
                         f"{row['irr_pct']!r}: left out")
            continue
        casts.setdefault((row["site"], row["dt"]), []).append((depth, percent))
    return casts, notes


def cast_name(cast):
    return "".join(c if c.isascii() and c.isalnum() else "-"
                   for c in "_".join(cast))


def water(path, wanted, casts=None):
    """These casts (site, date), each a condition with its own free gain.
    `casts`: of water_casts(), where they have been read."""
    read, notes = casts or water_casts(path)
    few_conditions(wanted, "casts")
    rows, deepest = [], 0
    for cast in wanted:
        if cast not in read:
            raise FieldError(f"{path}: has no cast {' '.join(cast)}")
        points = [(d, p) for d, p in read[cast] if d > 0]
        if len({d for d, _ in points}) < 2:
            raise FieldError(f"{path}: cast {' '.join(cast)} has readings at "
                             f"{len({d for d, _ in points})} depths, must be 2 "
                             "or more")
        name = cast_name(cast)
        for depth, percent in points:
            deepest = max(deepest, depth)
            rows.append({
                "kind": "transmittance", "condition": name,
                "x_m": 0, "y_m": 0, "z_m": 0,
                "x2_m": 0, "y2_m": 0, "z2_m": -depth,
                "gain": name, "unit": "percent", "value": percent,
                "standard_error": float(f"{WATER_ERROR * percent:.6g}"),
                "use": "fit"})
    names = [cast_name(cast) for cast in wanted]
    scene = (WATER_SCENE.format(depth=math.ceil(deepest) + 1)
             + conditions(names) + "\n")
    return Field(scene, rows, notes,
                 ("media.water.extinction_per_m@each",
                  *(f"gain.{name}" for name in names)),
                 ("media.water.extinction_per_m=0.001:20",))


# ---- scalar irradiance and beam attenuation in the open sea ----

SEA_BAND_NM = (526.5, 536.5)
SEA_ERROR = .05          # of the reading
SEA_BEAM_MIN = .01       # likewise, at least
SEA_DEPTHS_M = (4, 40)   # boat and waves above, weather within a cast below
SEA_STEP_M = 4
SEA_RADIUS_M = 1.4       # much less than 1 / K: the mean over it is 1 % high
SEA_PATH_M = .25         # of the transmissometer; extinction needs no more

SEA_SCENE = """\
# Open sea by day: scalar irradiance near 532 nm against depth, its unit
# unknown, and beam attenuation by an instrument that takes some of the light
# scattered forward for light not scattered at all.
murk: 1
band_edges_nm: [{low:g}, {high:g}]
domain: {{min_m: [-1.5, -1.5, -60], max_m: [1.5, 1.5, 1], sides: periodic}}
site: {{latitude_deg: {latitude:g}, longitude_deg: {longitude:g}, time: {time}}}
media:
  sea:
    extinction_per_m: {c:.4g}
    albedo: 0.7
    phase: {{fournier_forand: [1.10, 3.5835]}}
regions: [{{medium: sea, below_z_m: 0, ior: 1.34}}]
lights: [{{type: sun}}, {{type: sky}}]
photons: {{emit: 300000, maps: none}}
"""


def sea_station(path, station):
    """What is known of a station, and [(depth, E0, c)] with None for what is
    missing."""
    columns = ("station", "utc", "lat[deg]", "lon[deg]", "depth[m]",
               "E0_531[file units]", "c532[1/m]")
    known, points = None, []
    for line, row in table(path, columns):
        if row["station"] != station:
            continue
        place = f"{path}:{line}"
        known = known or {
            "latitude": needed(row["lat[deg]"], f"{place}: lat", -90, 90),
            "longitude": needed(row["lon[deg]"], f"{place}: lon", -180, 180),
            "time": row["utc"].strip() + "Z"}
        points.append(
            (needed(row["depth[m]"], f"{place}: depth", 0, 1e4),
             number(row["E0_531[file units]"], f"{place}: E0", 0, 1e9),
             number(row["c532[1/m]"], f"{place}: c532", 0, 1e3)))
    if not known:
        raise FieldError(f"{path}: has no station {station}")
    return known, points


def sea(path, station, acceptance_deg=None, with_beam=True):
    """A station's light against depth; and, if with_beam, the mean of its beam
    attenuation over these depths, as seen with that acceptance, to 1 % or its
    scatter."""
    known, points = sea_station(path, station)
    low, high = SEA_DEPTHS_M
    within = [p for p in points if low <= p[0] <= high]
    light = [(d, e) for d, e, _ in within
             if e and e > 0 and math.isclose(d % SEA_STEP_M, 0)]
    beam = [c for *_, c in within if c and c > 0]
    if len(light) < 3 or not beam:
        raise FieldError(f"{path}: station {station} has light at "
                         f"{len(light)} depths from {low:g} to {high:g} m and "
                         f"attenuation at {len(beam)}, must be 3 and 1 or more")
    notes = [f"{len(within) - len(light)} depths left out: between steps of "
             f"{SEA_STEP_M} m, or without a reading"]
    c = sum(beam) / len(beam)
    rows = [{"kind": "fluence", "x_m": 0, "y_m": 0, "z_m": -d,
             "radius_m": SEA_RADIUS_M, "gain": "e0", "unit": "relative",
             "value": e, "standard_error": float(f"{SEA_ERROR * e:.6g}"),
             "use": "fit"}
            for d, e in light]
    if with_beam:
        spread = math.sqrt(sum((x - c) ** 2 for x in beam) / len(beam))
        error = max(spread / math.sqrt(len(beam)), SEA_BEAM_MIN * c)
        z = -(low + high) / 2
        rows.append({"kind": "transmittance", "x_m": 0, "y_m": 0, "z_m": z,
                     "x2_m": SEA_PATH_M, "y2_m": 0, "z2_m": z,
                     "acceptance_deg": "" if acceptance_deg is None
                     else acceptance_deg,
                     "unit": "extinction_per_m", "value": float(f"{c:.6g}"),
                     "standard_error": float(f"{error:.4g}"), "use": "fit"})
    scene = SEA_SCENE.format(low=SEA_BAND_NM[0], high=SEA_BAND_NM[1], c=c,
                             **known)
    return Field(scene, rows, notes,
                 ("media.sea.extinction_per_m", "media.sea.albedo", "gain.e0"),
                 ("media.sea.extinction_per_m=0.02:5",
                  "media.sea.albedo=0.05:0.995"))
