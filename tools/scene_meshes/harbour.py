"""A harbour basin of 60 x 40 m: a quay wall in the west, a pier on piles, a
moored boat's hull, mooring blocks and a sunken wreck's ribs on a seabed that
falls from 5 to 9 m with ripples and a dredged channel. The water's surface is
z = 0 (in the scene file)."""

import math

from .mesh import Mesh, circle

LENGTH, WIDTH = 60.0, 40.0
CELLS = (60, 40)  # of the seabed
PILES = [(12 + 6 * k, y) for k in range(5) for y in (24.0, 28.0)]


def depth_at(x, y):
    """Height of the seabed: falls eastward, a channel along y = 11, ripples
    and a mound of dumped mud."""
    slope = -5.0 - 4.0 * x / LENGTH
    channel = -1.2 * math.exp(-((y - 11) / 4) ** 2)
    ripples = .12 * math.sin(1.1 * x + .5 * math.sin(.4 * y)) \
        + .08 * math.sin(.7 * y + 1.3)
    mound = 1.6 * math.exp(-((x - 42) ** 2 + (y - 30) ** 2) / 18)
    return slope + channel + ripples + mound


def _seabed(m):
    m.part("seabed", "mud")
    nx, ny = CELLS
    points = [[(LENGTH * i / nx, WIDTH * j / ny,
                depth_at(LENGTH * i / nx, WIDTH * j / ny))
               for j in range(ny + 1)] for i in range(nx + 1)]
    for i in range(nx):
        for j in range(ny):
            m.polygon(points[i][j], points[i + 1][j], points[i + 1][j + 1])
            m.polygon(points[i][j], points[i + 1][j + 1], points[i][j + 1])


def _quay(m):
    m.part("quay", "concrete")
    m.box((-.5, -.5, -7.5), (1.2, WIDTH + .5, 1.6), without="-z")
    m.part("fenders", "rubber")
    for k in range(6):
        m.box((1.15, 4 + 6.4 * k, -.6), (1.45, 4.4 + 6.4 * k, 1.2))


def _pier(m):
    m.part("pier deck", "wood")
    m.box((1.1, 23.4, 1.2), (38.5, 28.6, 1.45))
    m.part("piles", "old_wood")
    for x, y in PILES:
        m.prism(circle((x, y), .22, 12), depth_at(x, y) - .5, 1.25, caps=False)
    m.part("braces", "old_wood")
    for x, _ in PILES[::2]:
        m.box((x - .1, 24, -1.1), (x + .1, 28, -.9))


def _boat(m):
    """A hull of 14 m: sections of a barge with a pointed bow."""
    m.part("hull", "red_paint")
    x0, x1, bow = 16.0, 27.0, 31.0
    y0, y1, keel, deck = 17.0, 20.6, -1.5, 1.1
    m.box((x0, y0, keel), (x1, y1, deck), without="+x")
    for y in (y0, y1):
        m.polygon((x1, y, keel), (bow, (y0 + y1) / 2, keel + .6),
                  (bow, (y0 + y1) / 2, deck + .3), (x1, y, deck))
    m.polygon((x1, y0, deck), (bow, (y0 + y1) / 2, deck + .3), (x1, y1, deck))
    m.polygon((x1, y0, keel), (bow, (y0 + y1) / 2, keel + .6), (x1, y1, keel))


def _blocks(m):
    m.part("mooring blocks", "concrete")
    for x, y in ((22, 7), (34, 12.5), (48, 20), (52, 33), (30, 35)):
        z = depth_at(x, y) - .4
        m.box((x - .6, y - .6, z), (x + .6, y + .6, z + 1.2), without="-z")


def _wreck(m):
    m.part("wreck", "rust")
    for k in range(7):
        x = 44 + 1.2 * k
        half = 1.7 - .08 * (k - 3) ** 2
        z = depth_at(x, 8) - .3
        m.box((x - .06, 8 - half, z), (x + .06, 8 - half + .15, z + 1.5))
        m.box((x - .06, 8 + half - .15, z), (x + .06, 8 + half, z + 1.5))
    m.box((43.6, 7.9, depth_at(47.6, 8) - .3), (51.6, 8.1, depth_at(47.6, 8) + .2))


def mesh():
    m = Mesh("A harbour basin")
    for build in (_seabed, _quay, _pier, _boat, _blocks, _wreck):
        build(m)
    return m
