"""A flat of six rooms, 12 x 10 x 3 m, with exactly the 268 triangles of the
interior that the SPOQ paper placed its sensors in.

     y=10 +--------+-------+----------+
          | bed 1  | bath  |  bed 2   |
      y=6 +--   ---+-   --+---   ----+
          |         corridor          = door
    y=4.5 +----   ------+----   -----+
          | living      :  kitchen   |
      y=0 +-------------+------------+
         x=0         x=4.8  x=7     x=12
"""

from .mesh import Mesh

HEIGHT = 3.0
DOOR = 2.1  # height of the door openings


def shell(m):
    m.part("floor", "floor")
    m.polygon((-.001, -.001, 0), (12.001, -.001, 0), (12.001, 10.001, 0),
              (-.001, 10.001, 0))
    m.part("ceiling", "walls")
    m.polygon((-.001, -.001, HEIGHT), (-.001, 10.001, HEIGHT),
              (12.001, 10.001, HEIGHT), (12.001, -.001, HEIGHT))
    heights = (0, HEIGHT)
    m.part("south wall", "walls")
    m.wall("y", 0, (0, 12), heights, [(1.6, 4.6, .8, 2.3, "glass"),
                                      (8.4, 10.4, 1.1, 2.3, "glass")])
    m.part("north wall", "walls")
    m.wall("y", 10, (0, 12), heights, [(1.2, 3.2, .9, 2.3, "glass"),
                                       (8.4, 10.8, .9, 2.3, "glass")])
    m.part("west wall", "walls")
    m.wall("x", 0, (0, 10), heights, [(4.8, 5.7, 1, 2.2, "glass")])
    m.part("east wall", "walls")
    m.wall("x", 12, (0, 10), heights, [(4.8, 5.7, None, DOOR, "wood")])


def _partitions(m):
    heights = (0, HEIGHT)
    m.part("south side of the corridor", "walls")
    m.wall("y", 4.5, (0, 12), heights, [(3.9, 4.9, None, DOOR, None),
                                        (8.1, 9.1, None, DOOR, None)])
    m.part("north side of the corridor", "walls")
    m.wall("y", 6, (0, 12), heights, [(2.7, 3.6, None, DOOR, None),
                                      (5.4, 6.3, None, DOOR, None),
                                      (8.2, 9.1, None, DOOR, None)])
    m.part("living room to kitchen", "walls")
    m.wall("x", 7, (0, 4.5), heights, [(1.2, 3, None, DOOR, None)])
    m.part("bed 1 to bath", "walls")
    m.wall("x", 4.8, (6, 10), heights)
    m.part("bath to bed 2", "walls")
    m.wall("x", 7, (6, 10), heights)


def _furniture(m):
    m.part("table top", "wood")
    m.box((4.4, 1.1, .72), (6.2, 2.0, .76))
    m.part("table sides", "wood")
    for x in (4.5, 6.1):
        m.polygon((x, 1.2, -.001), (x, 1.9, -.001), (x, 1.9, .721),
                  (x, 1.2, .721))
    m.part("sofa", "fabric")
    m.standing((.9, 2.9, 0), (3.1, 3.75, .43))
    m.standing((.9, 3.752, 0), (3.1, 4.0, .85))
    m.part("sideboard", "wood")
    m.standing((.15, .5, 0), (.6, 2.3, .55))
    m.part("bookcase", "wood")
    m.standing((5.3, 4.05, 0), (6.8, 4.4, 2.05))
    m.part("screen", "metal")
    m.polygon((.12, .8, .8), (.12, 2, .8), (.12, 2, 1.5), (.12, .8, 1.5))
    m.part("kitchen counter", "wood")
    m.standing((7.8, .1, 0), (11.0, .7, .92))
    m.part("fridge", "metal")
    m.standing((11.2, .1, 0), (11.85, .75, 1.85))
    m.part("kitchen island", "wood")
    m.standing((9, 2.1, 0), (10.6, 2.9, .92))
    m.part("bed 1", "fabric")
    m.standing((1.3, 7.75, 0), (3.1, 9.8, .52))
    m.part("wardrobe 1", "wood")
    m.standing((.1, 6.2, 0), (.7, 7.6, 2.15))
    m.part("bed 2", "fabric")
    m.standing((9.7, 7.2, 0), (11.8, 8.8, .52))
    m.part("wardrobe 2", "wood")
    m.standing((7.1, 7.7, 0), (7.7, 9.9, 2.15))
    m.part("bath tub", "metal")
    m.standing((5.0, 9.1, 0), (6.8, 9.88, .57))
    m.part("mirror", "metal")
    m.polygon((4.82, 7, 1), (4.82, 8.2, 1), (4.82, 8.2, 2), (4.82, 7, 2))
    m.part("white board", "walls")
    m.polygon((11.97, 1.5, 1), (11.97, 3.2, 1), (11.97, 3.2, 2),
              (11.97, 1.5, 2))


def mesh():
    m = Mesh("Six furnished rooms")
    shell(m)
    _partitions(m)
    _furniture(m)
    return m
