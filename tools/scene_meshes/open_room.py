"""One furnished room, 12 x 10 x 3 m, with exactly the 268 triangles of the
interior that the SPOQ paper placed its sensors in: an open-plan office, whose
desks, shelves and pillars hide what lies behind them, but no doors.

     y=10 +--------------------------+
          | shelf   shelf   shelf    |
          |   desk    desk    desk   |
          |       o           o      |   o pillar
          |   desk    desk    desk   |
          | sofa    table   counter  |
      y=0 +--------------------------+
         x=0                        x=12
"""

from .mesh import Mesh
from .paper_room import shell


def _desk(m, x, y):
    """A top on two sides, and a screen on it."""
    m.box((x, y, .70), (x + 1.8, y + .8, .74))
    for side in (x + .1, x + 1.7):
        m.polygon((side, y + .05, -.001), (side, y + .75, -.001),
                  (side, y + .75, .701), (side, y + .05, .701))
    m.polygon((x + .6, y + .4, .8), (x + 1.2, y + .4, .8),
              (x + 1.2, y + .4, 1.2), (x + .6, y + .4, 1.2))


def mesh():
    m = Mesh("One furnished room")
    shell(m)
    m.part("desks", "wood")
    for y in (3.0, 6.2):
        for x in (1.6, 5.1, 8.6):
            _desk(m, x, y)
    m.part("shelves", "wood")
    for x in (1.0, 5.0, 9.0):
        m.standing((x, 8.9, 0), (x + 2.2, 9.3, 1.9))
    m.part("sofa", "fabric")
    m.standing((.9, .6, 0), (3.1, 1.4, .45))
    m.part("counter", "wood")
    m.standing((8.2, .5, 0), (10.9, 1.2, 1.05))
    m.part("table", "wood")
    m.standing((5.2, .7, 0), (6.6, 1.5, .75))
    m.part("pillars", "walls")
    for x in (4.1, 7.7):
        m.post((x, 5.1, 0), (x + .4, 5.5, 3.0))
    m.part("screen", "metal")
    m.polygon((.03, 4, .8), (.03, 5.4, .8), (.03, 5.4, 1.6), (.03, 4, 1.6))
    m.part("white board", "walls")
    m.polygon((11.97, 1.5, 1), (11.97, 3.2, 1), (11.97, 3.2, 2),
              (11.97, 1.5, 2))
    return m
