"""An industrial hall of 30 x 18 x 9 m: six bays of 5 m along x, the gate half
open in the east, offices under a mezzanine in the north-west, racks along the
north wall, machines along the south wall, and the burning crate under the
crane at (18.9, 8.9)."""

from .mesh import Mesh, circle, girder

LENGTH, WIDTH, HEIGHT = 30.0, 18.0, 9.0
BAYS = [5.0 * k for k in range(6)]  # where each begins
FRAMES = BAYS[1:]                   # columns and beams between the bays


def _shell(m):
    m.part("floor", "concrete")
    m.polygon((-.001, -.001, 0), (LENGTH + .001, -.001, 0),
              (LENGTH + .001, WIDTH + .001, 0), (-.001, WIDTH + .001, 0))
    windows = [(x + .8, x + 4.2, 5, 6.6, "glass") for x in BAYS]
    m.part("south wall", "cladding")
    m.wall("y", 0, (0, LENGTH), (0, HEIGHT), windows)
    m.part("north wall", "cladding")
    m.wall("y", WIDTH, (0, LENGTH), (0, HEIGHT), windows)
    m.part("west wall", "cladding")
    m.wall("x", 0, (0, WIDTH), (0, HEIGHT), [(4.5, 5.5, None, 2.1, "wood"),
                                             (12, 16.5, 5, 6.6, "glass")])
    m.part("east wall and gate", "cladding")
    m.wall("x", LENGTH, (0, WIDTH), (0, HEIGHT), [(6.5, 11.5, None, 4.8, None)])
    m.part("roof", "cladding")
    m.wall("z", HEIGHT, (0, LENGTH), (0, WIDTH),
           [(x + 1.5, x + 3.5, 6, 12, "glass") for x in BAYS])
    m.part("roller shutter, half down", "metal")
    x = LENGTH - .05
    m.polygon((x, 6.4, 2.8), (x, 11.6, 2.8), (x, 11.6, 4.9), (x, 6.4, 4.9))


def _frames(m):
    for x in FRAMES:
        m.part(f"frame at x {x:g}", "steel")
        for y in (.3, WIDTH - .3):
            m.prism(girder((x, y), .3, .3), -.001, 8.5, caps=False)
        m.prism(girder((x, 8.7), .25, .5, web=.012), -.001, WIDTH + .001, "y",
                caps=False)


def _crane(m):
    m.part("crane", "yellow_steel")
    for y, inward in ((.75, .45), (WIDTH - .75, -.45)):
        m.prism(girder((y, 7.4), .25, .4), -.001, LENGTH + .001, "x",
                caps=False)
        for x in FRAMES:
            low, high = sorted((y - inward, y + inward / 2))
            m.box((x - .1, low, 6.95), (x + .1, high, 7.201), without="+z")
    for x in (18.5, 19.5):
        m.prism(girder((x, 7.85), .25, .5), .6, WIDTH - .6, "y", caps=False)
    m.box((18.3, 8.5, 8.099), (19.7, 9.5, 8.38))
    m.part("hoist rope", "steel")
    m.prism(circle((19, 9), .03, 6), 5.5, 8.2, caps=False)


def _mezzanine(m):
    m.part("mezzanine", "concrete")
    m.box((-.001, 10, 3.8), (7, WIDTH + .001, 4))
    m.part("mezzanine posts", "steel")
    for x, y in ((6.8, 10.2), (6.8, 17.6), (3.2, 10.2), (.3, 10.2)):
        m.post((x - .1, y - .1, 0), (x + .1, y + .1, 3.8))
    m.part("railing", "yellow_steel")
    for k in range(8):
        m.post((6.93, 11.25 + .95 * k, 4), (6.97, 11.29 + .95 * k, 5.05))
        m.post((.1 + .95 * k, 10.03, 4), (.14 + .95 * k, 10.07, 5.05))
    m.box((6.92, 11.2, 5.05), (6.98, 17.98, 5.1))
    m.box((.02, 10.02, 5.05), (6.9, 10.08, 5.1))
    m.part("offices", "plaster")
    m.wall("y", 11, (0, 6), (0, 3.8), [(.6, 1.5, None, 2.1, None),
                                       (2.2, 5.2, .9, 2.3, "glass")])
    m.wall("x", 6, (11, WIDTH), (0, 3.8), [(11.8, 13.8, .9, 2.3, "glass"),
                                           (14.9, 15.8, None, 2.1, None)])
    m.part("office desks", "wood")
    for y in (12.4, 15):
        m.standing((1.2, y, 0), (2.8, y + .8, .74))
    m.part("stairs", "steel")
    for k in range(19):
        x = 11.75 - .25 * k
        m.box((x, 10.1, .2 * k + .16), (x + .28, 11.1, .2 * k + .2))
    for y in (10.03, 11.12):
        m.polygon((12.1, y, 0), (12.1, y, .25), (7, y, 4.05), (7, y, 3.7))


def _racks(m):
    x0, bay, depth, south = 12.5, 2.7, 1.1, 16.2
    levels = (.12, 2.0, 3.9)
    m.part("rack uprights", "steel")
    for k in range(6):
        for y in (south, south + depth - .08):
            x = x0 + bay * k
            m.standing((x - .04, y, 0), (x + .04, y + .08, 5.4))
    m.part("rack boards", "wood")
    for k in range(5):
        x = x0 + bay * k
        for z in levels:
            m.box((x + .05, south + .01, z), (x + bay - .05,
                                              south + depth - .01, z + .1))
    for k in range(5):
        for j, z in enumerate(levels):
            for i in range(2):
                turn = 7 * k + 3 * j + 5 * i
                if turn % 6 == 0:
                    continue  # an empty place here and there
                m.part(f"goods {k} {j} {i}", ("card", "wood", "fabric")[turn % 3])
                x = x0 + bay * k + .15 + 1.25 * i
                width, height = .9 + .05 * (turn % 4), .7 + .15 * (turn % 5)
                m.standing((x, south + .1, z + .1),
                           (x + width, south + .95, z + .1 + height))


def _lathe(m, x):
    m.part("lathe", "machine_green")
    m.standing((x, 1.2, 0), (x + 2.8, 2.1, .7))
    m.standing((x + .01, 1.21, .7), (x + .8, 2.09, 1.45))
    m.standing((x + 2.3, 1.4, .7), (x + 2.7, 1.9, 1.3))
    m.part("chuck", "metal")
    m.prism(circle((1.65, 1.08), .26, 16), x + .799, x + 1.05, "x")
    m.prism(circle((1.65, 1.08), .06, 8), x + 1.049, x + 2.301, "x",
            caps=False)


def _press(m):
    m.part("press", "machine_green")
    m.standing((8.6, .9, 0), (10.2, 2.5, .9))
    m.standing((8.65, .95, .9), (10.15, 1.5, 3.2))
    m.box((8.6, .9, 3.199), (10.2, 2.5, 3.9))
    m.part("ram", "metal")
    m.prism(circle((9.4, 2.05), .22, 16), 1.7, 3.2)


def _machines(m):
    for x in (12.2, 21.2):
        _lathe(m, x)
    _press(m)
    for x, y in ((1.6, 1.6), (4, 1.6)):
        m.part("tank", "metal")
        m.prism(circle((x, y), .95, 24), -.001, 3.4)
        m.part("tank outlet", "steel")
        m.prism(circle((x, 1.0), .08, 8), y + .9, y + 1.6, "y")
    m.part("compressor", "machine_green")
    m.standing((26, .8, 0), (28.2, 2, 1.2))
    m.prism(circle((1.4, 1.6), .42, 16), 26.1, 28.1, "x")
    m.part("workbench", "wood")
    m.box((16.4, 1, .85), (19.4, 1.8, .92))
    for x in (16.5, 19.2):
        for y in (1.05, 1.65):
            m.post((x, y, 0), (x + .1, y + .1, .85))
    m.part("vice", "steel")
    m.standing((17.5, 1.1, .92), (17.8, 1.5, 1.15))


def _conveyor(m):
    m.part("conveyor", "steel")
    m.box((8.5, 5.4, .75), (15, 6.4, .85))
    for x in (8.8, 10.8, 12.6, 14.6):
        for y in (5.45, 6.25):
            m.post((x, y, 0), (x + .1, y + .1, .75))
    for k in range(13):
        m.prism(circle((8.75 + .5 * k, .9), .06, 8), 5.45, 6.35, "y")
    m.part("parcels", "card")
    for x, size in ((9.3, .55), (11.4, .8), (13.3, .45)):
        m.standing((x, 5.9 - size / 2, .955), (x + size, 5.9 + size / 2,
                                               .955 + size))


def _crates(m):
    m.part("burning crate", "char")
    m.standing((18.2, 8.2, 0), (19.6, 9.6, .85))
    m.part("crates", "wood")
    for x, y, z, size in (
            (16.2, 9.7, 0, 1.2), (16.3, 9.8, 1.2, 1.0), (16.1, 7.4, 0, 1.0),
            (20.6, 10.8, 0, 1.3), (22.1, 10.9, 0, 1.1), (20.7, 10.9, 1.3, 1.1),
            (22.5, 5.2, 0, 1.2), (23.9, 5.3, 0, 1.0), (22.7, 5.3, 1.2, .9),
            (27.3, 13.1, 0, 1.2), (27.2, 14.5, 0, 1.1)):
        m.standing((x, y, z), (x + size, y + size, z + size))
    m.part("drums", "metal")
    for x, y in ((10.3, 13.2), (11, 13.3), (10.6, 13.95), (28.8, 4.4),
                 (28.7, 5.1)):
        m.prism(circle((x, y), .29, 16), -.001, .88)


def _fork_lift(m):
    m.part("fork lift", "yellow_steel")
    m.box((25.2, 8.4, .25), (27, 9.5, 1.05))
    m.standing((26.3, 8.5, 1.05), (26.95, 9.4, 1.35))
    m.box((25.3, 8.45, 2.1), (26.9, 9.45, 2.16))
    m.part("fork lift frame", "steel")
    for x in (25.32, 26.82):
        for y in (8.47, 9.37):
            m.post((x, y, 1.05), (x + .06, y + .06, 2.1))
    for y in (8.6, 9.2):
        m.box((25.02, y, .15), (25.12, y + .1, 2.6))
        m.box((23.9, y, .1), (25.021, y + .1, .14))
    m.part("wheels", "rubber")
    for x in (25.55, 26.65):
        for y in (8.36, 9.34):
            m.prism(circle((x, .279), .28, 12), y, y + .2, "y")


def _services(m):
    m.part("pipes", "metal")
    for z, radius in ((4.4, .16), (4.0, .1), (3.7, .06)):
        m.prism(circle((.62, z), radius, 10), -.001, LENGTH + .001, "x",
                caps=False)
    m.part("air duct", "metal")
    m.box((7.5, 16.35, 6.1), (LENGTH + .001, 16.95, 6.7), without="+x")
    for x in (10, 15, 20, 25):
        m.part("duct outlet", "metal")
        m.prism(circle((x + 1.5, 16.65), .22, 12), 5.75, 6.101, caps=False)


def mesh():
    m = Mesh("An industrial hall")
    for build in (_shell, _frames, _crane, _mezzanine, _racks, _machines,
                  _conveyor, _crates, _fork_lift, _services):
        build(m)
    return m
