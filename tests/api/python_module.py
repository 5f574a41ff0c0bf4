"""What the tests of the Python module share: the module of this source tree over a library that is given, one scene,
and checks that are counted. A test is skipped where Debian's cffi or NumPy is missing.

    TEST.py MURK LIBRARY
"""
import ctypes
import os
import sys

program, library = (os.path.abspath(path) for path in sys.argv[1:3])
top = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
os.environ["MURK_LIBRARY"], os.environ["MURK_HEADER"] = library, os.path.join(top, "src/murk.h")
os.environ["PYTHONPATH"] = os.path.join(top, "python")  # of processes that a test starts
sys.path.insert(0, os.environ["PYTHONPATH"])
try:
    import numpy  # noqa: F401

    import murk
except ModuleNotFoundError as missing:
    print(f"skipped: no {missing.name}")
    sys.exit(77)

ROOM = {
    "bands_nm": [532], "domain": {"min_m": [0, 0, 0], "max_m": [10, 10, 5]},
    "geometry": [{"rect": {"corner_m": [0, 0, 0], "edge1_m": [10, 0, 0], "edge2_m": [0, 10, 0]}}],
    "media": {"fog": {"extinction_per_m": 0.2, "albedo": 0.9, "phase": {"hg": 0.7}}},
    "regions": [{"medium": "fog"}],
    "lights": [{"type": "sphere", "center_m": [5, 5, 4], "radius_m": 0.1, "power_w": 10}],
    "photons": {"emit": 20000},
    "sensors": {"types": [{"name": "node", "range_m": 6}, {"name": "cam", "range_m": 9, "view": {"cone_deg": 90},
                                                           "headings": 4, "tilts_deg": [-30]}],
                "candidates": {"grid": {"min_m": [1, 1, 1], "max_m": [9, 9, 4], "size": [5, 5, 2]}}, "count": 2},
    "tallies": [{"name": "box", "type": "grid", "min_m": [0, 0, 0], "max_m": [10, 10, 5], "size": [4, 3, 2]},
                {"name": "floor", "type": "plane", "point_m": [0, 0, 0.1], "normal": [0, 0, -1], "bins": [3, 2]}],
}
_checks = 0


def check(condition, what):
    global _checks
    _checks += 1
    if not condition:
        print(f"not so: {what}")
        sys.exit(1)


def done():
    check(_checks > 0, "something was checked")
    print(f"{_checks - 1} checks")


def resident_mb():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGESIZE") / 1e6


class _Mallinfo(ctypes.Structure):
    _fields_ = [(name, ctypes.c_size_t) for name in ("arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks",
                                                     "fsmblks", "uordblks", "fordblks", "keepcost")]


def allocated_bytes():
    """The bytes that malloc() has given out, of all arenas and of mmap(); glibc 2.33 or later."""
    mallinfo2 = ctypes.CDLL(None).mallinfo2
    mallinfo2.restype = _Mallinfo
    info = mallinfo2()
    return info.uordblks + info.hblkhd
