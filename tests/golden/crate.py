"""A hall with a crate and a pool of mist, in plain Python: which segments are open, and through how
much fog."""

import math

BANDS = (450, 650)
FOG, MIST = (0.2, 0.1), (0.5, 0.9)
CRATE = ((3, 2, 0), (4, 4, 2))
POOL = ((5, 0, 0), (8, 6, 1))
RANGE_M = 4
CLEAR = 65535
SCENE = """
murk: 1
seed: 7
bands_nm: [450, 650]
domain: {min_m: [0, 0, 0], max_m: [8, 6, 3]}
geometry:
  - {box: {min_m: [0, 0, 0], max_m: [8, 6, 3]}}
  - {box: {min_m: [3, 2, 0], max_m: [4, 4, 2]}}
materials: {default: {diffuse: [0.5, 0.7]}}
media:
  fog: {extinction_per_m: [0.2, 0.1], albedo: 0.9}
  mist: {extinction_per_m: [0.5, 0.9], albedo: 0.9}
regions: [{medium: fog}, {medium: mist, box: {min_m: [5, 0, 0], max_m: [8, 6, 1]}}]
lights: [{type: point, position_m: [1, 1, 2.5], power_w: 10}]
photons: {emit: 2000}
tallies: [{name: box, type: grid, min_m: [1, 1, 1], max_m: [7, 5, 2], size: [6, 4, 2]}]
sensors:
  types: [{name: node, range_m: 4}]
  candidates: {grid: {min_m: [1.1, 1.1, 1.1], max_m: [7.1, 5.1, 2.1], size: [4, 3, 2]}}
  count: 3
"""


def write_scene(murk, text=SCENE, name="scene.yaml"):
    with open(murk.path(name), "w") as file:
        file.write(text)
    return murk.path(name)


def shares(a, b, box):
    """Where the segment enters and leaves a box, as shares of it; None: it misses."""
    near, far = 0.0, 1.0
    for p, q, low, high in zip(a, b, *box):
        if q == p:
            if not low < p < high:
                return None
            continue
        one, two = sorted(((low - p) / (q - p), (high - p) / (q - p)))
        near, far = max(near, one), min(far, two)
    return (near, far) if near < far else None


def grown(box, by):
    return [x - by for x in box[0]], [x + by for x in box[1]]


def depth_between(a, b, band):
    inside = shares(a, b, POOL)
    length = math.dist(a, b)
    return FOG[band] * length + (MIST[band] * length * (inside[1] - inside[0]) if inside else 0)


def visible_from(place, sensors):
    """The sensors that see a place; None where a segment to one grazes the crate, or a range."""
    out = []
    for sensor in sensors:
        length = math.dist(place, sensor)
        if abs(length - RANGE_M) < 1e-4 or \
                bool(shares(place, sensor, grown(CRATE, 1e-4))) != \
                bool(shares(place, sensor, grown(CRATE, -1e-4))):
            return None
        if length < RANGE_M and not shares(place, sensor, CRATE):
            out.append(sensor)
    return out
