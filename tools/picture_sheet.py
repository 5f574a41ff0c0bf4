"""The sheet that tools/picture draws on: lines, rings, text, and the PNG file."""

import math
import struct
import zlib

SHADE_STEP = 8            # between colours of the file: keeps it small

# A glyph is 5 wide, 7 high above the base line and 2 below it; capitals are
# drawn as small letters. Rows as they look, named by the line above them.
GLYPH_WIDTH, GLYPH_HEIGHT = 5, 9
ART = """
a     b     c     d     e     f     g     h     i     j     k     l     m
..... #.... ..... ....# ..... ..##. ..... #.... ..#.. ...#. #.... .##.. .....
..... #.... ..... ....# ..... .#... ..... #.... ..... ..... #.... ..#.. .....
.###. ####. .#### .#### .###. ####. .#### ####. .##.. ..##. #..#. ..#.. ####.
....# #...# #.... #...# #...# .#... #...# #...# ..#.. ...#. #.#.. ..#.. #.#.#
.#### #...# #.... #...# ##### .#... #...# #...# ..#.. ...#. ##... ..#.. #.#.#
#...# #...# #.... #...# #.... .#... #...# #...# ..#.. ...#. #.#.. ..#.. #.#.#
.#### ####. .#### .#### .#### .#... .#### #...# .###. ...#. #..#. .###. #.#.#
..... ..... ..... ..... ..... ..... ....# ..... ..... #..#. ..... ..... .....
..... ..... ..... ..... ..... ..... .###. ..... ..... .##.. ..... ..... .....
n     o     p     q     r     s     t     u     v     w     x     y     z
..... ..... ..... ..... ..... ..... .#... ..... ..... ..... ..... ..... .....
..... ..... ..... ..... ..... ..... .#... ..... ..... ..... ..... ..... .....
####. .###. ####. .#### #.##. .#### ####. #...# #...# #...# #...# #...# #####
#...# #...# #...# #...# ##..# #.... .#... #...# #...# #.#.# .#.#. #...# ...#.
#...# #...# #...# #...# #.... .###. .#... #...# #...# #.#.# ..#.. #...# ..#..
#...# #...# #...# #...# #.... ....# .#... #...# .#.#. #.#.# .#.#. #...# .#...
#...# .###. ####. .#### #.... ####. ..##. .#### ..#.. .#.#. #...# .#### #####
..... ..... #.... ....# ..... ..... ..... ..... ..... ..... ..... ....# .....
..... ..... #.... ....# ..... ..... ..... ..... ..... ..... ..... .###. .....
0     1     2     3     4     5     6     7     8     9     .     ,     :
.###. ..#.. .###. ##### ...#. ##### ..##. ##### .###. .###. ..... ..... .....
#...# .##.. #...# ...#. ..##. #.... .#... ....# #...# #...# ..... ..... .##..
#..## ..#.. ....# ..#.. .#.#. ####. #.... ...#. #...# #...# ..... ..... .##..
#.#.# ..#.. ...#. ...#. #..#. ....# ####. ..#.. .###. .#### ..... ..... .....
##..# ..#.. ..#.. ....# ##### ....# #...# .#... #...# ....# ..... ..... .....
#...# ..#.. .#... #...# ...#. #...# #...# .#... #...# ...#. .##.. .##.. .##..
.###. .###. ##### .###. ...#. .###. .###. .#... .###. .##.. .##.. .##.. .##..
..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..#.. .....
..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .#... .....
+     -     %     /     (     )     _     ?
..... ..... ##..# ....# ...#. .#... ..... .###.
..#.. ..... ##..# ....# ..#.. ..#.. ..... #...#
..#.. ..... ...#. ...#. .#... ...#. ..... ....#
##### ##### ..#.. ..#.. .#... ...#. ..... ...#.
..#.. ..... .#... .#... .#... ...#. ..... ..#..
..#.. ..... #..## #.... ..#.. ..#.. ..... .....
..... ..... #..## #.... ...#. .#... ##### ..#..
..... ..... ..... ..... ..... ..... ..... .....
..... ..... ..... ..... ..... ..... ..... .....
"""


def _read(art):
    lines, glyphs = art.split("\n")[1:-1], {" ": ["." * GLYPH_WIDTH] * GLYPH_HEIGHT}
    for k in range(0, len(lines), GLYPH_HEIGHT + 1):
        rows = [line.split() for line in lines[k + 1:k + 1 + GLYPH_HEIGHT]]
        for name, *glyph in zip(lines[k].split(), *rows):
            glyphs[name] = glyph
    return glyphs


_GLYPHS = _read(ART)


def text_width(text, size):
    """In pixels, where a dot of the font is size pixels wide."""
    return max(0, len(text) * (GLYPH_WIDTH + 1) - 1) * size


def _dots(text, size):
    """The pixels (x, y) of the text, from the top left of the first glyph."""
    for k, letter in enumerate(text.lower()):
        for y, row in enumerate(_GLYPHS.get(letter, _GLYPHS["?"])):
            for x, dot in enumerate(row):
                if dot == "#":
                    for i in range(size * size):
                        yield ((k * (GLYPH_WIDTH + 1) + x) * size + i % size,
                               y * size + i // size)


class Sheet:
    """Pixels, x to the right and y down; what lies outside is not drawn."""

    def __init__(self, width, height, background):
        self.width, self.height = width, height
        self.pixel = [list(background) for _ in range(width * height)]

    def mix(self, x, y, colour, cover):
        if 0 <= x < self.width and 0 <= y < self.height and cover > 0:
            p = self.pixel[y * self.width + x]
            for k in range(3):
                p[k] += min(1, cover) * (colour[k] - p[k])

    def text(self, x, y, text, size, colour):
        for i, j in _dots(text, size):
            self.mix(x + i, y + j, colour, 1)

    def ring(self, centre, radius, half, colour, cover, clip, dash=0):
        """A circle line of width 2 half; a disc when half is radius. clip is
        left, top, right, bottom."""
        cx, cy = centre
        for y in range(max(clip[1], math.floor(cy - radius - half - 1)),
                       min(clip[3], math.ceil(cy + radius + half + 1))):
            for x in range(max(clip[0], math.floor(cx - radius - half - 1)),
                           min(clip[2], math.ceil(cx + radius + half + 1))):
                dx, dy = x + .5 - cx, y + .5 - cy
                inside = half + .5 - abs(math.hypot(dx, dy) - radius)
                if inside <= 0:
                    continue
                if dash and math.atan2(dy, dx) * radius // dash % 2:
                    continue
                self.mix(x, y, colour, cover * min(1, inside))

    def line(self, start, end, colour):
        n = 2 * math.ceil(math.dist(start, end))
        for k in range(n):
            x, y = (a + (b - a) * k / n for a, b in zip(start, end))
            self.mix(int(x), int(y), colour, .8)

    def png(self):
        def chunk(kind, body):
            return (struct.pack(">I", len(body)) + kind + body +
                    struct.pack(">I", zlib.crc32(kind + body)))

        def shade(v):
            return min(255, int(v / SHADE_STEP + .5) * SHADE_STEP)
        raw, above = bytearray(), bytes(3 * self.width)
        for y in range(self.height):
            row = bytes(shade(v) for p in self.pixel[y * self.width:(y + 1) * self.width]
                        for v in p)
            raw.append(2)  # filter: difference to the pixel above
            raw += bytes((a - b) & 255 for a, b in zip(row, above))
            above = row
        head = struct.pack(">2I5B", self.width, self.height, 8, 2, 0, 0, 0)
        return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) +
                chunk(b"IDAT", zlib.compress(bytes(raw), 9)) + chunk(b"IEND", b""))
