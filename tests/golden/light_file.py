"""light.murk read from its published layout, and a plan's coverage computed
again from it in plain Python: another programmer's reading of
src/photonmap/map_file.h, src/photonmap/photon.h and the meaning of coverage.
For convex places in homogeneous fog, where no wall is in the way."""

import math
import struct

MAGIC = b"\x8dmurk\r\n\x1a"


def sections(path):
    """Sections by name. A wrong layout raises."""
    with open(path, "rb") as file:
        data = file.read()
    magic, version, order, record, count, size = struct.unpack_from("<8s4IQ", data)
    assert (magic, version, order, record) == (MAGIC, 1, 0x01020304, 32)
    assert size == len(data)
    at = 64 + 48 * count
    found = {}
    for i in range(count):
        name, length, zero = struct.unpack_from("<16sQQ", data, 64 + 48 * i)
        assert zero == 0
        found[name.rstrip(b"\0").decode()] = data[at:at + length]
        at += length
    assert at == len(data), "nothing stands behind the last section"
    return found


def records(section):
    """(x, y, z), power in W, emitted index, band, packings of normal and of the
    direction it came along, kind."""
    for r in struct.iter_unpack("<3fIIfI4B", section):
        yield r[:3], r[5], r[6], r[7], r[4], r[3], r[10]


def unpack_direction(packed):
    """Octahedral, 16 bits a coordinate."""
    u, v = (((packed >> shift & 0xFFFF) - 32768) / 32767 for shift in (0, 16))
    z = 1 - abs(u) - abs(v)
    if z < 0:
        u, v = math.copysign(1 - abs(v), u), math.copysign(1 - abs(u), v)
    length = math.sqrt(u * u + v * v + z * z)
    return u / length, v / length, z / length


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def clarities(record, sensors, range_m, extinction_per_m, takes):
    """What each sensor sees of one record, 0..1."""
    place, _, _, band, normal, travel, kind = record
    facing = unpack_direction(normal) if kind < 4 else None
    for j, sensor in enumerate(sensors):
        offset = [s - p for s, p in zip(sensor, place)]
        distance_m = math.sqrt(dot(offset, offset))
        if distance_m > range_m:
            yield 0.0
        elif takes and not takes[j](band, unpack_direction(travel), [-w for w in offset]):
            yield 0.0
        elif facing and sum(f * w for f, w in zip(facing, offset)) <= 0:
            yield 0.0
        else:
            yield math.exp(-extinction_per_m[band] * distance_m)


def coverage(found, emitted, sensors, range_m, extinction_per_m, takes=None, counts=None):
    """Balanced coverage of sensors, with its error by emitted photon; `takes`
    says for each sensor whether it takes up light of a band that travels along
    a direction, from a way off; `counts`, what the power of a record at a place
    counts times."""
    n = len(sensors)
    out = {"covers": [0.0] * n, "only_it_covers": [0.0] * n,
           "seen_by_at_least": [0.0] * n}
    residual = {}
    maps = {}
    for name in ("surface", "volume"):
        stored = list(records(found[name]))
        if counts:
            stored = [(r[0], r[1] * counts(r[0]), *r[2:]) for r in stored]
        whole = sum(r[1] for r in stored)
        seen = 0.0
        per_photon = {}
        for r in stored:
            values = list(clarities(r, sensors, range_m, extinction_per_m, takes))
            weight = r[1] / whole
            best = max(values)
            seen += weight * best
            for j, view in enumerate(values):
                others = max(values[:j] + values[j + 1:], default=0.0)
                out["covers"][j] += weight * view / 2
                out["only_it_covers"][j] += weight * max(best - others, 0) / 2
            for k in range(sum(view * 65535 >= 0.5 for view in values)):
                out["seen_by_at_least"][k] += weight / 2
            x, y = per_photon.get(r[2], (0.0, 0.0))
            per_photon[r[2]] = (x + weight * best, y + weight)
        maps[name] = seen
        for photon, (x, y) in per_photon.items():
            residual[photon] = residual.get(photon, 0.0) + (x - seen * y) / 2
    out["surface"], out["volume"] = maps["surface"], maps["volume"]
    out["in_sample"] = (maps["surface"] + maps["volume"]) / 2
    squares = sum(r * r for r in residual.values())
    out["standard_error"] = math.sqrt(emitted / (emitted - 1) * squares)
    out["sum_of_views"] = sum(out["covers"])
    return out
