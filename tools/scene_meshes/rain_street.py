"""What stands along a street of 80 x 30 m between two rows of houses: kerbs,
house fronts with windows and doors, lamps on masts that reach over the road,
a gantry with signs, a bus stop and parked cars. The ground is in the scene
file."""

from .mesh import Mesh, circle

LENGTH, WIDTH = 80.0, 30.0
KERBS = (8.0, 22.0)          # the road lies between them
FRONTS = (3.0, 27.0)         # of the houses, south and north of the street
# (length of front, height, storeys): from west to east
SOUTH = ((14, 9.5, 3), (12, 12.5, 4), (18, 9.5, 3), (10, 6.5, 2),
         (14, 12.5, 4), (12, 9.5, 3))
NORTH = ((16, 12.5, 4), (12, 9.5, 3), (10, 9.5, 3), (20, 12.5, 4),
         (12, 6.5, 2), (10, 9.5, 3))
COLOURS = ("render_light", "brick", "render_dark")
MASTS = [(10 + 20 * k, KERBS[k % 2], 1 - 2 * (k % 2)) for k in range(4)]
CARS = ((6, 9.1), (18.5, 9.1), (33, 9.1), (47, 9.1), (12, 19.2), (41, 19.2),
        (64, 19.2), (71, 19.2))


def _front(m, x, length, y, storeys, height):
    """A house's front with two windows a storey for each six metres of it."""
    count = max(2, 2 * round(length / 6))
    step = length / count
    z = 0.0
    for storey in range(storeys):
        top = height if storey + 1 == storeys else z + 3.1
        openings = []
        for k in range(count):
            left = x + step * k + step / 2 - .6
            is_door = storey == 0 and k == count // 2
            openings.append((left, left + 1.2, None if is_door else z + 1.0,
                             z + 2.4, "wood" if is_door else "glass"))
        m.wall("y", y, (x, x + length), (z, top), openings)
        z = top


def _houses(m):
    for side, row, y, back in (("south", SOUTH, FRONTS[0], .2),
                               ("north", NORTH, FRONTS[1], WIDTH - .2)):
        x = 0.0
        for number, (length, height, storeys) in enumerate(row):
            m.part(f"{side} house {number}", COLOURS[number % 3])
            _front(m, x, length, y, storeys, height)
            m.wall("y", back, (x, x + length), (0, height))
            for end in (x, x + length):
                m.wall("x", end, (min(y, back), max(y, back)), (0, height))
            m.part(f"{side} roof {number}", "tiles")
            m.box((x, min(y, back) - .3, height - .001),
                  (x + length, max(y, back) + .3, height + .25))
            x += length


def _pavements(m):
    m.part("pavements", "paving")
    m.standing((0, FRONTS[0], 0), (LENGTH, KERBS[0], .14))
    m.standing((0, KERBS[1], 0), (LENGTH, FRONTS[1], .14))


def _masts(m):
    for x, y, inward in MASTS:
        m.part(f"lamp mast {x}", "steel")
        m.prism(circle((x, y - .8 * inward), .09, 10), .1, 7.9, caps=False)
        low, high = sorted((y - .8 * inward, y + 2.2 * inward))
        m.box((x - .06, low, 7.8), (x + .06, high, 7.95))
        m.part(f"lamp {x}", "steel")
        low, high = sorted((y + 1.5 * inward, y + 2.3 * inward))
        m.box((x - .2, low, 7.951), (x + .2, high, 8.02))


def _gantry(m):
    m.part("gantry", "steel")
    for y in (KERBS[0] - .9, KERBS[1] + .6):
        m.standing((57, y, .1), (57.3, y + .3, 6.4))
    m.box((57.02, KERBS[0] - 1, 6.0), (57.28, KERBS[1] + 1, 6.3))
    m.part("signs", "sign_blue")
    for y in (10.5, 16.5):
        m.box((56.9, y, 5.0), (57.0, y + 3, 6.5))


def _bus_stop(m):
    m.part("bus stop", "steel")
    for x in (26, 29.4):
        m.standing((x, 5.2, .14), (x + .08, 5.28, 2.5))
    m.part("bus stop roof", "glass")
    m.wall("z", 2.52, (25.8, 29.7), (5.0, 6.8))
    m.part("bus stop back", "glass")
    m.wall("y", 5.24, (26.1, 29.4), (.5, 2.4))
    m.part("bench", "wood")
    m.box((26.4, 5.4, .55), (29.1, 5.8, .62))


def _cars(m):
    for number, (x, y) in enumerate(CARS):
        m.part(f"car {number}", ("car_red", "car_grey", "car_white")[number % 3])
        m.box((x, y, .35), (x + 4.3, y + 1.75, .85))
        m.part(f"car {number} cabin", "car_glass")
        m.box((x + 1.1, y + .12, .849), (x + 3.5, y + 1.63, 1.45))
        m.part(f"car {number} wheels", "rubber")
        for dx in (.8, 3.5):
            for dy in (-.02, 1.55):
                m.prism(circle((x + dx, .319), .32, 12), y + dy, y + dy + .22,
                        "y")


def mesh():
    m = Mesh("A street")
    for build in (_pavements, _houses, _masts, _gantry, _bus_stop, _cars):
        build(m)
    return m
