"""Ten million records as NumPy arrays: stored fields are views that take no time and no memory, packed fields are
unpacked once, in under a second each, and a second call is a view of the same memory.

The limit of a view is a hundredth of the memory of a copy of the smallest field, 1 byte a record; the limit of a
packed field is its own size and a tenth.

    python_records.py MURK LIBRARY [RECORDS]
"""
import sys
import time

from python_module import ROOM, allocated_bytes, check, done, murk, resident_mb

RECORDS = int(sys.argv[3]) if len(sys.argv) > 3 else 10000000
SECONDS = 1.0  # what a user at a prompt takes for at once
STORED = {"position_m": 12, "power_w": 4, "emitted": 4, "band": 1, "light": 1, "material": 1}
PACKED = {"direction": 12, "normal": 12, "event_class": 1}


def measured(work):
    """(result, seconds, bytes that malloc() has given out, resident MB), the last three as differences."""
    bytes_before, resident, begun = allocated_bytes(), resident_mb(), time.monotonic()
    result = work()
    seconds = time.monotonic() - begun
    return result, seconds, allocated_bytes() - bytes_before, resident_mb() - resident


def main():
    begun = time.monotonic()
    light = murk.Scene({**ROOM, "photons": {"store": RECORDS, "max_stored": 2 * RECORDS, "maps": "volume"}, "tallies": []}).trace()
    n = len(light.volume)
    print(f"{n} records traced in {time.monotonic() - begun:.1f} s, {resident_mb():.0f} MB resident")
    check(n >= RECORDS, "the records")
    for field, size in {**STORED, **PACKED}.items():
        array, seconds, given, resident = measured(lambda f=field: light.array("volume", f))
        kind = "view" if field in STORED else "copy"
        print(f"{field:<12} {kind}: {1e3 * seconds:7.2f} ms, {given / 1e6:8.3f} MB given out, {resident:6.1f} MB resident")
        check(len(array) == n and not array.flags.owndata and not array.flags.writeable, f"{field} is a view")
        check(seconds < SECONDS, f"{field} takes {seconds:.2f} s")
        check(given < n / 100 if field in STORED else given < 1.1 * n * size, f"{field} takes {given} bytes")
        again, seconds, given, _ = measured(lambda f=field: light.array("volume", f))
        check(again.ctypes.data == array.ctypes.data and given < n / 100, f"{field} is made once")
    records, seconds, given, _ = measured(lambda: light.volume["power_w"])
    check(records.dtype.itemsize == 4 and given < n / 100, "a field of the structured array is a view")
    check((records == light.array("volume", "power_w")).all(), "the same numbers")
    done()


main()
