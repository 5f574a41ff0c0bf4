"""A workshop hall of 24 x 12 x 6 m: a band of windows in the south wall, two
in the east, skylights in the roof, a mezzanine with a stair, machine tools,
benches and racks."""

from .mesh import Mesh, circle

LENGTH, WIDTH, HEIGHT = 24.0, 12.0, 6.0
# (from, to, sill, head): along x in the south wall, along y in the east wall
SOUTH = [(1.5 + 4.5 * k, 4.7 + 4.5 * k, 1.2, 4.2) for k in range(5)]
EAST = [(2.0, 4.6, 1.2, 3.4), (7.0, 9.6, 1.2, 3.4)]
# (x from, x to, y from, y to)
ROOF = [(3.5, 5.5, 5.0, 9.0), (11.0, 13.0, 5.0, 9.0), (18.5, 20.5, 5.0, 9.0)]


def _shell(m):
    m.part("floor", "screed")
    m.polygon((0, 0, 0), (LENGTH, 0, 0), (LENGTH, WIDTH, 0), (0, WIDTH, 0))
    m.part("south wall", "plaster")
    m.wall("y", 0, (0, LENGTH), (0, HEIGHT),
           [(a, b, low, high, "glass") for a, b, low, high in SOUTH])
    m.part("east wall", "plaster")
    m.wall("x", LENGTH, (0, WIDTH), (0, HEIGHT),
           [(a, b, low, high, "glass") for a, b, low, high in EAST])
    m.part("north wall", "plaster")
    m.wall("y", WIDTH, (0, LENGTH), (0, HEIGHT),
           [(10, 13, None, 3.5, "steel")])
    m.part("west wall", "plaster")
    m.wall("x", 0, (0, WIDTH), (0, HEIGHT))
    m.part("roof", "cladding")
    x = 0.0
    for a, b, low, high in ROOF:
        m.wall("z", HEIGHT, (x, a), (0, WIDTH))
        m.wall("z", HEIGHT, (a, b), (0, low))
        m.wall("z", HEIGHT, (a, b), (high, WIDTH))
        x = b
    m.wall("z", HEIGHT, (x, LENGTH), (0, WIDTH))
    m.part("skylights", "glass")
    for a, b, low, high in ROOF:
        m.wall("z", HEIGHT + .05, (a, b), (low, high))
    m.part("upstands", "cladding")
    for a, b, low, high in ROOF:
        m.wall("x", a, (low, high), (HEIGHT, HEIGHT + .05))
        m.wall("x", b, (low, high), (HEIGHT, HEIGHT + .05))
        m.wall("y", low, (a, b), (HEIGHT, HEIGHT + .05))
        m.wall("y", high, (a, b), (HEIGHT, HEIGHT + .05))


def _frame(m):
    m.part("columns", "steel")
    for x in (.1, 6.0, 12.0, 18.0, 23.6):
        for y in (.1, WIDTH - .4):
            m.standing((x, y, 0), (x + .3, y + .3, HEIGHT - .3))
    m.part("beams", "steel")
    for x in (6.05, 14.0, 18.05):
        m.box((x, .05, HEIGHT - .35), (x + .2, WIDTH - .05, HEIGHT - .05))


def _mezzanine(m):
    m.part("mezzanine", "wood")
    m.box((.02, 8.0, 3.0), (6.0, WIDTH - .02, 3.15))
    m.part("posts", "steel")
    for x in (1.0, 5.6):
        m.post((x, 8.1, 0), (x + .15, 8.25, 3.0))
    m.part("stair", "steel")
    for k in range(12):
        m.box((6.0 + .28 * k, 10.4, 2.75 - .25 * k),
              (6.3 + .28 * k, 11.4, 2.8 - .25 * k))
    m.part("rail", "steel")
    m.box((.1, 8.0, 4.1), (6.0, 8.04, 4.15))


def _machines(m):
    m.part("lathe", "machine_green")
    m.standing((8.2, 2.2, 0), (11.0, 3.3, 1.1))
    m.standing((8.2, 2.2, 1.099), (9.0, 3.3, 1.6))
    m.part("mill", "machine_green")
    m.standing((14.6, 2.0, 0), (16.2, 3.8, 1.0))
    m.standing((15.0, 3.0, .999), (15.8, 3.8, 2.4))
    m.part("press", "steel")
    m.standing((20.0, 2.4, 0), (21.6, 4.0, 2.8))
    m.part("tank", "steel")
    m.prism(circle((21.4, 9.4), 1.0, 24), -.001, 2.2)


def _furniture(m):
    m.part("benches", "wood")
    for x in (1.5, 4.2):
        m.box((x, .8, .86), (x + 2.2, 1.6, .92))
        for dx in (.05, 2.05):
            m.standing((x + dx, .9, 0), (x + dx + .08, 1.5, .87))
    m.part("racks", "steel")
    for x in (8.5, 15.0):
        for z in (.4, 1.3, 2.2):
            m.box((x, 10.6, z), (x + 4.5, 11.6, z + .04))
        for dx in (0, 4.42):
            m.standing((x + dx, 10.6, 0), (x + dx + .08, 11.6, 2.6))
    m.part("boxes", "card")
    for k in range(6):
        m.standing((8.7 + .7 * k, 10.8, .44), (9.2 + .7 * k, 11.4, .9))
        m.standing((15.3 + .65 * k, 10.8, 1.34), (15.8 + .65 * k, 11.4,
                                                  1.75))


def mesh():
    m = Mesh("A workshop hall with windows")
    for build in (_shell, _frame, _mezzanine, _machines, _furniture):
        build(m)
    return m
