"""Pictures of murk render as files: OpenEXR and PNG read in plain Python.

Where an all-round picture looks, its mean over the solid angle, the tone curve and the false
colours are worked out anew; coverage channels are held against murk sense onto the same points.

usage: pictures.py MURK
"""

import json
import math
import os
import re
import struct
import subprocess
import sys
import tempfile
import zlib

from exchange import Failed, check

SCENE = """murk: 1
bands_nm: [450, 550, 650]
seed: 3
north: [1, 0, 0]
domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}
geometry:
  - {box: {min_m: [0, 0, 0], max_m: [4, 4, 3]}, material: wall}
  - {box: {min_m: [2, 2, 0], max_m: [3, 3, 1]}, material: wall}
materials: {wall: {diffuse: [0.4, 0.5, 0.7]}}
media: {fog: {extinction_per_m: [0.3, 0.1, 0.2], albedo: 0.9}}
regions: [{medium: fog}]
lights: [{type: sphere, center_m: [1, 3, 2.5], radius_m: 0.2, power_w: 50}]
photons: {emit: 2000}
sensors:
  types:
    - {name: node, range_m: 2.5}
    - {name: eye, range_m: 4, view: {hfov_deg: 80, vfov_deg: 50}, headings: 4}
    - {name: red, range_m: 9, bands: [650]}
  count: 1
cameras:
  - {name: round, type: equirectangular, from_m: [1, 1, 1.5], pixels: [48, 24], samples: 3}
  - {name: gate, from_m: [0.5, 0.5, 1], to_m: [3, 3, 1], pixels: [40, 30], samples: 2}
"""
SENSORS = ("type,x_m,y_m,z_m,heading_deg,tilt_deg\nnode,1,3,1,,\neye,3.5,0.5,2,200,-20\n"
           "red,0.5,3.5,0.5,,\n")
FROM = (1, 1, 1.5)


# ---- files ----

def text_at(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode(), end + 1


def undo_zip(data, size):
    """OpenEXR's: differences of bytes whose even and odd ones are apart."""
    if len(data) < size:
        data = bytearray(zlib.decompress(data))
        for i in range(1, len(data)):
            data[i] = (data[i - 1] + data[i] - 128) & 255
        half = (len(data) + 1) // 2
        out = bytearray(len(data))
        out[0::2], out[1::2] = data[:half], data[half:]
        data = bytes(out)
    check(len(data) == size, "a block of", len(data), "bytes, not", size)
    return data


def read_exr(path):
    """(width, height, {channel: [value by rows]}, {attribute: bytes}): 32-bit floats, ZIP."""
    with open(path, "rb") as file:
        data = file.read()
    check(struct.unpack_from("<2i", data) == (20000630, 2), path, "is no plain OpenEXR file")
    at, header = 8, {}
    while data[at]:
        name, at = text_at(data, at)
        kind, at = text_at(data, at)
        (size,) = struct.unpack_from("<i", data, at)
        header[name] = data[at + 4:at + 4 + size]
        at += 4 + size
    at += 1
    check(header["compression"] == b"\3", "compression", header["compression"])
    names, place = [], 0
    while header["channels"][place]:
        name, place = text_at(header["channels"], place)
        check(struct.unpack_from("<i", header["channels"], place) == (2,), name, "is no float")
        names.append(name)
        place += 16
    x0, y0, x1, y1 = struct.unpack("<4i", header["dataWindow"])
    width, height = x1 - x0 + 1, y1 - y0 + 1
    channels = {name: [] for name in names}
    blocks = (height + 15) // 16
    for offset in struct.unpack_from("<%dQ" % blocks, data, at):
        y, size = struct.unpack_from("<2i", data, offset)
        rows = min(16, y1 + 1 - y)
        body = undo_zip(data[offset + 8:offset + 8 + size], rows * width * 4 * len(names))
        for row in range(rows):
            for k, name in enumerate(names):
                start = (row * len(names) + k) * width * 4
                channels[name] += struct.unpack_from("<%df" % width, body, start)
    return width, height, channels, header


def read_png(path):
    """(width, height, [row of (r, g, b)], {key: text}): 8-bit RGB, every chunk's sum checked."""
    with open(path, "rb") as file:
        data = file.read()
    check(data[:8] == b"\x89PNG\r\n\x1a\n", path, "is no PNG file")
    at, body, texts, size = 8, b"", {}, None
    while at < len(data):
        (length,) = struct.unpack_from(">I", data, at)
        kind, chunk = data[at + 4:at + 8], data[at + 8:at + 8 + length]
        (crc,) = struct.unpack_from(">I", data, at + 8 + length)
        check(crc == zlib.crc32(kind + chunk), path, kind, "has another sum")
        if kind == b"IHDR":
            size = struct.unpack(">2I5B", chunk)
        elif kind == b"IDAT":
            body += chunk
        elif kind == b"iTXt":
            key, rest = chunk.split(b"\0", 1)
            check(rest[:2] == b"\0\0", path, key, "is compressed")
            texts[key.decode()] = rest[2:].split(b"\0", 2)[2].decode("utf-8")
        at += 12 + length
    width, height = size[:2]
    check(size[2:] == (8, 2, 0, 0, 0), path, "is of the kind", size[2:])
    raw, rows, before = zlib.decompress(body), [], bytes(3 * width)
    for y in range(height):
        start = y * (3 * width + 1)
        row = unfilter(raw[start], bytearray(raw[start + 1:start + 1 + 3 * width]), before)
        rows.append(list(zip(row[0::3], row[1::3], row[2::3])))
        before = row
    return width, height, rows, texts


def unfilter(kind, row, above):
    """A row of 8-bit RGB without its filter (PNG 1.2, section 6), in place. Written without a
    function call per byte: pictures have millions of them."""
    if kind == 2:
        row[:] = bytes((value + up) & 255 for value, up in zip(row, above))
    elif kind:
        for channel in range(3):
            left = corner = 0
            for i in range(channel, len(row), 3):
                up = above[i]
                if kind == 4:
                    to_left, to_up = abs(up - corner), abs(left - corner)
                    to_corner = abs(left + up - 2 * corner)
                    guess = left if to_left <= to_up and to_left <= to_corner else up if to_up <= to_corner else corner
                else:
                    guess = left if kind == 1 else (left + up) // 2
                left, corner = (row[i] + guess) & 255, up
                row[i] = left
    return row


# ---- what must hold ----

def near(a, b, tolerance):
    return abs(a - b) <= tolerance


def check_directions(width, height, channels):
    """P is where the place of the pixel on the globe looks: north, +x, in the middle, and
    clockwise from there to the right."""
    for i, z in enumerate(channels["Z"]):
        longitude = 2 * math.pi * ((i % width + 0.5) / width - 0.5)
        latitude = math.pi * (0.5 - (i // width + 0.5) / height)
        direction = (math.cos(latitude) * math.cos(longitude),
                     -math.cos(latitude) * math.sin(longitude), math.sin(latitude))
        for k, axis in enumerate("XYZ"):
            want = FROM[k] + z * direction[k]
            check(near(channels["P." + axis][i], want, 2e-6), "P.%s of" % axis, i, "is",
                  channels["P." + axis][i], "not", want)


def check_mean(width, height, channels, facts):
    rows = [math.sin(math.pi * (0.5 - y / height)) - math.sin(math.pi * (0.5 - (y + 1) / height))
            for y in range(height)]
    for b, band in enumerate(("450nm", "550nm", "650nm")):
        value = channels["S0." + band]
        mean = sum(rows[i // width] * v for i, v in enumerate(value)) / (2 * width)
        stated = facts["mean_radiance"][b]
        check(near(mean, stated, 1e-6 * stated), "mean in", band, "is", mean, "not", stated)
        plain = sum(value) / len(value)
        check(not near(plain, stated, 1e-3 * stated), "the mean over pixels is the same")
    check(facts["mean_over"] == "solid angle", facts["mean_over"])


def shown(rgb, stops):
    """What the tone curve makes of linear colour."""
    c = [2 ** stops * max(0, v) for v in rgb]
    light = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]
    c = [v * (1 + light / 16) / (1 + light) for v in c]
    c = [12.92 * v if v <= 0.0031308 else 1.055 * v ** (1 / 2.4) - 0.055 for v in c]
    return [255 * min(1, v) for v in c]


def check_png(path, channels, stops, texts_want):
    width, _, rows, texts = read_png(path)
    for i, rgb in enumerate(zip(channels["R"], channels["G"], channels["B"])):
        for got, want in zip(rows[i // width][i % width], shown(rgb, stops)):
            check(near(got, want, 0.51), "pixel", i, "is", got, "not", want)
    for key, want in texts_want.items():
        check(texts.get(key) == want, key, "is", texts.get(key), "not", want)
    light = sorted(0.2126 * r + 0.7152 * g + 0.0722 * b
                   for r, g, b in zip(channels["R"], channels["G"], channels["B"]))
    return light


def check_false_colour(path, values, low, high, is_log):
    """Brighter is more, alike is alike, the ends are viridis', the legend lies below."""
    width, height, rows, texts = read_png(path)
    seen = {}
    for i, v in enumerate(values):
        t = math.log(v / low) / math.log(high / low) if is_log and v > 0 else (
            math.nan if is_log or v != v else (v - low) / (high - low))
        colour = rows[i // 48][i % 48]
        if t != t:
            check(colour == (128, 128, 128), i, "has no colour, and is", colour)
            continue
        if t <= 0 or t >= 1:
            want = (68, 1, 84) if t <= 0 else (253, 231, 37)
            check(colour == want, i, "at the end is", colour)
        seen.setdefault(t, set()).add(colour)
    check(all(len(colours) == 1 for colours in seen.values()), "equal values, two colours")
    light = [0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]
             for _, (c,) in sorted((t, tuple(c)) for t, c in seen.items())]
    check(all(b >= a - 1.5 for a, b in zip(light, light[1:])), "colours do not rise")
    check(width >= 48 and height > 24 + 30, "no legend in", width, "x", height)
    legend = [pixel for row in rows[24:] for pixel in row]
    check((0, 0, 0) in legend and (255, 255, 255) in legend, "the legend has no letters")
    for end in ((68, 1, 84), (253, 231, 37)):
        check(any(max(abs(a - b) for a, b in zip(p, end)) <= 8 for p in legend), "no bar's end", end)
    return texts


def normal_at(p):
    """Of the room's wall or the crate's face that a point lies on, into the room."""
    for k, top in enumerate((4, 4, 3)):
        for side, sign in ((0, 1), (top, -1)):
            if near(p[k], side, 1e-5):
                return [sign if i == k else 0 for i in range(3)]
    for k, (low, high) in enumerate(((2, 3), (2, 3), (0, 1))):
        for side, sign in ((low, -1), (high, 1)):
            if near(p[k], side, 1e-5):
                return [sign if i == k else 0 for i in range(3)]
    raise Failed("P is on no surface: %s" % (p,))


def check_coverage(murk, all_of_them, points):
    """Each sensor alone sees of the picture's points what murk sense says that it sees of them;
    all of them together: the sum, and the clearest."""
    with open(murk.path("points.csv"), "w", encoding="ascii") as file:
        file.write("x_m,y_m,z_m,normal_x,normal_y,normal_z\n")
        for p in points:
            held = [max(0, v) for v in p]  # rounding may take it out of the domain
            file.write(",".join("%.9g" % v for v in (*held, *normal_at(p))) + "\n")
    head, *sensors = SENSORS.splitlines()
    counts, clarities = [0] * len(points), [0] * len(points)
    for sensor, band in zip(sensors, (450, 450, 650)):
        with open(murk.path("one.csv"), "w", encoding="ascii") as file:
            file.write(head + "\n" + sensor + "\n")
        facts = json.loads(murk.run(
            "sense", "scene.yaml", "--sensors", "one.csv", "--format", "json", "--set",
            "placement.targets={points: points.csv, band_nm: %d}" % band))
        _, (_, _, one, _) = murk.render("--sensors", "one.csv", "--method", "path",
                                        "--samples", "1")
        count, clarity = one["coverage.count"], one["coverage.clarity"]
        for got, want in ((count, facts["seen_by_at_least"][0]),
                          (clarity, facts["coverage"]["in_sample"])):
            mean = sum(got) / len(points)
            check(0.01 < mean < 0.99 and near(mean, want, 1e-7), sensor, mean, "sense says", want)
        counts = [a + b for a, b in zip(counts, count)]
        clarities = [max(a, b) for a, b in zip(clarities, clarity)]
    check(counts == all_of_them["coverage.count"], "counts do not add up")
    check(clarities == all_of_them["coverage.clarity"], "the clearest is another")
    check(max(counts) >= 2 and min(counts) == 0, "counts", min(counts), max(counts))


class Murk:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def path(self, name):
        return os.path.join(self.folder, name)

    def process(self, *arguments):
        done = subprocess.run([self.program, *arguments], cwd=self.folder, text=True,
                              capture_output=True, check=False)
        check(done.returncode == 0, arguments, "ends with", done.returncode, done.stderr)
        return done

    def run(self, *arguments):
        return self.process(*arguments).stdout

    def render(self, *arguments):
        """Its JSON, and the image."""
        said = self.run("render", "scene.yaml", "--format", "json", "-o", "x.exr", *arguments)
        return json.loads(said), read_exr(self.path("x.exr"))


def main(program):
    with tempfile.TemporaryDirectory() as folder:
        murk = Murk(program, folder)

        for name, text in (("scene.yaml", SCENE), ("sensors.csv", SENSORS)):
            with open(murk.path(name), "w", encoding="ascii") as file:
                file.write(text)

        facts, (width, height, channels, header) = murk.render(
            "--sensors", "sensors.csv", "--png", "--false-colour", "radiance.550nm",
            "--threads", "1")
        check((width, height) == (48, 24), width, height)
        check(header["envmap"] == b"\0", "no latitude and longitude in", header.get("envmap"))
        check(header["murkHeading"] == b"0 degrees", header["murkHeading"])
        check_directions(width, height, channels)
        check_mean(width, height, channels, facts)
        stops = facts["png"]["exposure_stops"]
        light = check_png(murk.path("x.png"), channels, stops,
                          {"murkCamera": "round", "murkSeed": "3", "murkPhotons": "2000",
                           "murkProjection": "equirectangular",
                           "murkExposure": "%.2f stops, by the picture" % stops,
                           "murkSceneSha256": header["murkSceneSha256"].decode()})
        lit = [v for v in light if v > 0]
        log_mean = sum(math.log2(v) for v in lit) / len(lit)
        check(near(stops, math.log2(0.18) - log_mean, 0.02), "exposure", stops, "log mean", log_mean)
        colours = facts["false_colour"]
        check(colours["logarithmic"] and colours["channel"] == "S0.550nm", colours)
        texts = check_false_colour(murk.path("x-S0.550nm.png"), channels["S0.550nm"],
                                   colours["low"], colours["high"], True)
        check(texts["murkChannel"] == "S0.550nm" and "W/m2/sr" in texts["murkColours"], texts)

        # the same bytes for any threads
        first = {name: open(murk.path(name), "rb").read()
                 for name in ("x.exr", "x.png", "x-S0.550nm.png")}
        for threads in ("2", "5"):
            murk.render("--sensors", "sensors.csv", "--png", "--false-colour", "radiance.550nm",
                        "--threads", threads)
            for name, data in first.items():
                with open(murk.path(name), "rb") as file:
                    check(file.read() == data, name, "differs with", threads, "threads")

        check_coverage(murk, channels,
                       list(zip(channels["P.X"], channels["P.Y"], channels["P.Z"])))

        # a sensor's own view: its axis in the middle, its angles at the edges
        facts, (width, height, channels, header) = murk.render(
            "--sensors", "sensors.csv", "--from-sensor", "2", "--method", "path",
            "--samples", "1", "--false-colour", "coverage.count", "--camera", "gate")
        check((width, height) == (40, round(40 * math.tan(math.radians(25))
                                            / math.tan(math.radians(40)))), width, height)
        check(facts["camera"] == "sensor 2 (eye)" and facts["projection"] == "perspective", facts)
        check(near(facts["heading_deg"], 200, 1e-9) and near(facts["tilt_deg"], -20, 1e-9), facts)
        (aspect,) = struct.unpack("<f", header["pixelAspectRatio"])
        check(near(aspect, math.tan(math.radians(40)) / 40 * height / math.tan(math.radians(25)),
                   1e-6), "pixels' aspect", aspect)
        ranges = [z for z, c in zip(channels["Z"], channels["coverage.count"]) if c >= 1]
        check(len(ranges) > 400, "the sensor sees", len(ranges), "pixels of its own view")
        check(all(c >= 1 or z > 3.99 for z, c in
                  zip(channels["Z"], channels["coverage.count"])), "what it shows it does not see")
        check(all(math.isinf(e) for e in channels["error.550nm"]), "one sample has an error")

        # nothing to see: all dark, one sample; and of several sensors two see all round
        facts, (_, _, channels, _) = murk.render(
            "--set", "lights.0.power_w=0", "--png", "--false-colour", "error.R",
            "--method", "path", "--samples", "1")
        check(not any(channels["R"]) and facts["png"]["exposure_stops"] == 0, facts["png"])
        _, _, rows, _ = read_png(murk.path("x.png"))
        check(set(sum(rows, [])) == {(0, 0, 0)}, "the dark picture is not black")
        facts, (_, _, channels, _) = murk.render(
            "--set", "lights.0.power_w=0", "--false-colour", "radiance.450nm",
            "--method", "path", "--range", "1:2", "--scale", "log")
        _, _, rows, _ = read_png(murk.path("x-S0.450nm.png"))
        check({p for row in rows[:24] for p in row[:48]} == {(128, 128, 128)}, "dark has a colour")
        facts, (_, _, channels, _) = murk.render(
            "--false-colour", "Z", "--range=0.5:2", "--method", "path",
            "--samples", "1", "--png", "--exposure", "-1.5")
        check(facts["png"]["exposure_stops"] == -1.5, facts["png"])
        check_png(murk.path("x.png"), channels, -1.5,
                  {"murkExposure": "-1.50 stops", "murkPhotons": "0"})
        check_false_colour(murk.path("x-Z.png"), channels["Z"], 0.5, 2, False)

        # names beside the scene; a camera in the wall's far side is told of
        murk.run("render", "scene.yaml", "--sensors", "sensors.csv", "--from-sensor", "1",
                 "--pixels", "8x6", "--samples", "1", "--method", "path", "--quiet", "--png")
        check(os.path.exists(murk.path("scene-sensor1.png")), os.listdir(folder))
        done = murk.process("render", "scene.yaml", "--method", "path", "--samples", "1",
                            "--pixels", "4x2", "-o", "x.exr", "--set",
                            "cameras.0.from_m=[2.5, 2.5, 0.5]")
        check(re.search(r"round stands at .* no open way to any light", done.stderr), done.stderr)
        done = murk.process("render", "scene.yaml", "--method", "path", "--samples", "1",
                            "--pixels", "4x2", "-o", "x.exr")
        check(done.stderr == "", done.stderr)


if __name__ == "__main__":
    try:
        main(os.path.abspath(sys.argv[1]))
    except Failed as failed:
        print(failed)
        sys.exit(1)
