"""What stands in a container yard of 60 x 40 m: rows of containers, a gantry
crane over them, a fence with a gate in the east, lamp masts, a hut and a
lorry. The ground and the fuel tank are in the scene file."""

from .mesh import Mesh, circle

LENGTH, WIDTH, HEIGHT = 6.06, 2.44, 2.59  # of a 20-foot container
COLOURS = ("container_red", "container_blue", "container_grey")
# row: (y, [containers on each other, from x = 8 on])
ROWS = ((6, (2, 3, 1, 2, 0, 1)), (9, (3, 2, 2, 0, 1, 1)),
        (18, (1, 2, 3, 3, 2, 1)), (21, (2, 1, 3, 2, 2, 0)),
        (30, (1, 0, 2, 1)))
MASTS = ((5, 14.5), (28, 14.5), (52, 14.5), (5, 27), (28, 27), (52, 27))


def _containers(m):
    for row, (y, stacks) in enumerate(ROWS):
        for column, count in enumerate(stacks):
            x = 8 + 6.6 * column
            for level in range(count):
                m.part(f"container {row} {column} {level}",
                       COLOURS[(2 * row + column + level) % 3])
                east = x + .04 * ((row + 2 * column + 3 * level) % 4)
                north = y + .03 * ((row + column + 2 * level) % 3)
                z = HEIGHT * level
                m.standing((east, north, z),
                           (east + LENGTH, north + WIDTH, z + HEIGHT))


def _crane(m):
    m.part("gantry crane", "yellow_steel")
    for y in (16.4, 25.2):
        for x in (20, 25.6):
            m.standing((x, y, 0), (x + .5, y + .5, 11))
        m.box((19.6, y - .1, .35), (26.5, y + .6, .85))
        m.box((20.1, y + .1, 6), (26, y + .4, 6.4))
    for x in (20, 25.5):
        m.box((x - .1, 13, 10.99), (x + .7, 29, 11.9))
    m.part("trolley", "steel")
    m.box((19.95, 19.6, 11.899), (26.1, 21.6, 12.9))
    m.part("spreader", "yellow_steel")
    m.box((20.3, 19.4, 9), (25.9, 21.8, 9.35))
    m.part("ropes", "steel")
    for x in (21, 25):
        for y in (19.9, 21.2):
            m.prism(circle((x, y), .03, 6), 9.3, 11.95, caps=False)


def _fence(m):
    x0, x1, y0, y1, top = 2.0, 58.0, 2.0, 38.0, 2.4
    m.part("fence posts", "steel")
    spots = [(x0 + 4 * k, y) for k in range(15) for y in (y0, y1)]
    spots += [(x, y0 + 4 * k) for k in range(1, 9) for x in (x0, x1)
              if (x, k) != (x1, 4)]  # the gate
    for x, y in spots:
        m.standing((x - .05, y - .05, 0), (x + .05, y + .05, top + .1))
    m.part("fence", "wire_mesh")
    for y in (y0, y1):
        m.wall("y", y, (x0, x1), (.05, top))
    m.wall("x", x0, (y0, y1), (.05, top))
    m.wall("x", x1, (y0, 14), (.05, top))
    m.wall("x", x1, (22, y1), (.05, top))
    m.part("open gate", "wire_mesh")
    m.wall("y", 22.1, (54, 57.9), (.1, 2.2))


def _masts(m):
    for x, y in MASTS:
        m.part(f"mast {x} {y}", "steel")
        m.standing((x - .3, y - .3, 0), (x + .3, y + .3, .5))
        m.prism(circle((x, y), .1, 8), .499, 9.6, caps=False)
        m.box((x - .5, y - .15, 9.599), (x + .5, y + .15, 9.75))


def _hut(m):
    m.part("hut", "plaster")
    x, y, height = (46, 53), (29.5, 33.5), 2.9
    m.wall("y", y[0], x, (0, height), [(46.8, 47.7, None, 2.1, "wood"),
                                       (48.6, 52, .9, 2.1, "glass")])
    m.wall("y", y[1], x, (0, height), [(47.5, 50, .9, 2.1, "glass")])
    m.wall("x", x[0], y, (0, height), [(30.8, 32.4, .9, 2.1, "glass")])
    m.wall("x", x[1], y, (0, height))
    m.part("hut roof", "steel")
    m.box((x[0] - .4, y[0] - .4, height), (x[1] + .4, y[1] + .4, height + .2))
    m.part("desk", "wood")
    m.standing((48.8, 30, 0), (51.5, 30.7, .74))


def _lorry(m):
    m.part("lorry", "container_blue")
    m.box((50.4, 15.2, .9), (52.4, 17.5, 3.3))
    m.part("lorry bed", "steel")
    m.box((43.6, 15.2, .95), (50.3, 17.5, 1.15))
    m.part("load", "container_red")
    m.standing((43.8, 15.15, 1.15), (43.8 + LENGTH, 15.15 + WIDTH,
                                     1.15 + HEIGHT))
    m.part("wheels", "rubber")
    for x in (44.6, 45.8, 48.8, 51.6):
        for y in (15.18, 17.22):
            m.prism(circle((x, .499), .5, 16), y, y + .3, "y")


def mesh():
    m = Mesh("A container yard")
    for build in (_containers, _crane, _fence, _masts, _hut, _lorry):
        build(m)
    return m
