"""Writes NetCDF files in the classic format (NetCDF Users Guide, appendix B). Standard library only."""

import math
import struct

TYPES = {"b": (1, 1), "f": (5, 4), "d": (6, 8), "h": (3, 2)}


def text(value):
    data = value.encode()
    return struct.pack(">i", len(data)) + data + b"\0" * (-len(data) % 4)


def attributes(given):
    if not given:
        return struct.pack(">ii", 0, 0)
    out = struct.pack(">ii", 12, len(given))
    for name, value in given.items():
        if isinstance(value, str):
            data = value.encode()
            out += text(name) + struct.pack(">ii", 2, len(data)) + data + b"\0" * (-len(data) % 4)
        else:
            kind, *numbers = value
            data = struct.pack(f">{len(numbers)}{kind}", *numbers)
            out += text(name) + struct.pack(">ii", TYPES[kind][0], len(numbers)) + data + b"\0" * (-len(data) % 4)
    return out


def write_classic(path, dimensions, variables):
    """A NetCDF file in the classic format. dimensions: name -> length, 0: the
    records of all variables with it; variables: name -> (dimensions, type,
    attributes, values)."""
    names = list(dimensions)
    head = b"CDF\1" + struct.pack(">i", 3 if 0 in dimensions.values() else 0)
    records = 0
    for _, (axes, _, _, values) in variables.items():
        if axes and dimensions[axes[0]] == 0:
            records = len(values) // math.prod(dimensions[axis] for axis in axes[1:])
    head = b"CDF\1" + struct.pack(">i", records)
    head += struct.pack(">ii", 10, len(names)) + b"".join(text(n) + struct.pack(">i", dimensions[n]) for n in names)
    head += attributes({})

    def listed(begins):
        out = struct.pack(">ii", 11, len(variables))
        for (name, (axes, kind, given, _)), begin in zip(variables.items(), begins):
            size = math.prod(dimensions[a] or 1 for a in axes) * TYPES[kind][1]
            out += text(name) + struct.pack(">i", len(axes)) + struct.pack(f">{len(axes)}i", *map(names.index, axes))
            out += attributes(given) + struct.pack(">iii", TYPES[kind][0], size + -size % 4, begin)
        return out

    at = len(head) + len(listed([0] * len(variables)))
    begins, fixed, per_record = [], b"", []
    for axes, kind, _, values in variables.values():
        data = struct.pack(f">{len(values)}{kind}", *values)
        if axes and dimensions[axes[0]] == 0:
            step = len(data) // records
            per_record.append([data[i * step:(i + 1) * step] + b"\0" * (-step % 4) for i in range(records)])
            begins.append(None)
        else:
            begins.append(at + len(fixed))
            fixed += data + b"\0" * (-len(data) % 4)
    place = at + len(fixed)
    record_at = iter(range(len(per_record)))
    for i, begin in enumerate(begins):
        if begin is None:
            begins[i] = place
            place += len(per_record[next(record_at)][0])
    with open(path, "wb") as out:
        out.write(head + listed(begins) + fixed)
        for record in range(records):
            for data in per_record:
                out.write(data[record])
