"""A small builder of triangle meshes, written as OBJ.

Lengths are metres. Corners are rounded to a tenth of a millimetre, so that the
last digits of a machine's cosine cannot reach the file and what meets shares
its corners exactly.

Surfaces that meet without sharing corners run through each other by SINK: no
ray finds a seam, and no two faces lie in one plane.
"""

import math

SINK = 0.001
_PER_M = 10000  # corners are whole tenths of a millimetre


class Mesh:
    def __init__(self, title):
        self.title = title
        self._index = {}
        self._corners = []
        self._parts = []  # (name, material, [(i, j, k), ...])

    def part(self, name, material):
        """What is added from here on belongs to this object and material."""
        self._parts.append((name, material, []))

    def triangles(self):
        return sum(len(faces) for _, _, faces in self._parts)

    def polygon(self, *corners):
        """A flat polygon, as a fan about its first corner."""
        indices = [self._corner(c) for c in corners]
        faces = self._parts[-1][2]
        for second, third in zip(indices[1:], indices[2:]):
            faces.append((indices[0], second, third))

    def box(self, low, high, without=""):
        """A box; `without` names faces left out: any of -x +x -y +y -z +z."""
        x, y, z = zip(low, high)
        sides = {
            "-x": [(0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0)],
            "+x": [(1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1)],
            "-y": [(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)],
            "+y": [(0, 1, 0), (0, 1, 1), (1, 1, 1), (1, 1, 0)],
            "-z": [(0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0)],
            "+z": [(0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)],
        }
        for name, corners in sides.items():
            if name not in without.split():
                self.polygon(*((x[i], y[j], z[k]) for i, j, k in corners))

    def standing(self, low, high):
        """A box that stands on what is at its lower z: no bottom, sunk."""
        self.box((low[0], low[1], low[2] - SINK), high, without="-z")

    def post(self, low, high):
        """An upright between two surfaces: four sides, sunk into both."""
        self.box((low[0], low[1], low[2] - SINK),
                 (high[0], high[1], high[2] + SINK), without="-z +z")

    def prism(self, outline, start, end, axis="z", caps=True):
        """A convex or not outline [(u, v)] pushed along an axis from start to
        end; (u, v) are the two other coordinates in the order x, y, z. Caps
        need a convex outline."""
        place = {"x": lambda u, v, w: (w, u, v),
                 "y": lambda u, v, w: (u, w, v),
                 "z": lambda u, v, w: (u, v, w)}[axis]
        closed = outline + outline[:1]
        for (u0, v0), (u1, v1) in zip(closed, closed[1:]):
            self.polygon(place(u0, v0, start), place(u1, v1, start),
                         place(u1, v1, end), place(u0, v0, end))
        if caps:
            for w in (start, end):
                self.polygon(*(place(u, v, w) for u, v in outline))

    def wall(self, axis, at, span, heights, openings=()):
        """An upright sheet in the plane x = at or y = at, from span[0] to
        span[1] along the other axis, with openings (from, to, bottom, top,
        pane), left to right, pane None or a material that fills it. A bottom
        of None goes down to the floor. With axis "z" the sheet is level, span
        runs along x and heights along y. Corners are shared all over, so the
        sheet has no seams; it is sunk into whatever surrounds it."""
        point = {"x": lambda u, v: (at, u, v),
                 "y": lambda u, v: (u, at, v),
                 "z": lambda u, v: (u, v, at)}[axis]
        name, material, _ = self._parts[-1]
        bottom, top = heights[0] - SINK, heights[1] + SINK
        left_edge = [bottom, top]
        left = span[0] - SINK
        panes = []
        for u0, u1, low, high, pane in openings:
            edge = [bottom] + ([low] if low is not None else []) + [high, top]
            self._strip(point, left, left_edge, u0, edge)
            if low is not None:
                self._strip(point, u0, [bottom, low], u1, [bottom, low])
            self._strip(point, u0, [high, top], u1, [high, top])
            if pane:
                panes.append((pane, u0, u1, edge[-3], high))
            left, left_edge = u1, edge
        self._strip(point, left, left_edge, span[1] + SINK, [bottom, top])
        for pane, u0, u1, low, high in panes:
            self.part(name + " pane", pane)
            self._strip(point, u0, [low, high], u1, [low, high])
        if panes:
            self.part(name, material)

    def _strip(self, point, left, left_edge, right, right_edge):
        """Triangles between two upright edges with corners at those heights."""
        i = j = 0
        while i + 1 < len(left_edge) or j + 1 < len(right_edge):
            a, b = point(left, left_edge[i]), point(right, right_edge[j])
            climb_right = i + 1 == len(left_edge) or (
                j + 1 < len(right_edge)
                and right_edge[j + 1] <= left_edge[i + 1])
            if climb_right:
                j += 1
                self.polygon(a, b, point(right, right_edge[j]))
            else:
                i += 1
                self.polygon(a, b, point(left, left_edge[i]))

    def _corner(self, corner):
        key = tuple(round(c * _PER_M) for c in corner)
        if key not in self._index:
            self._index[key] = len(self._corners) + 1
            self._corners.append(key)
        return self._index[key]

    def text(self):
        lines = [f"# {self.title}",
                 f"# {self.triangles()} triangles, metres, z up; made by "
                 "tools/make_scenes"]
        for key in self._corners:
            lines.append("v " + " ".join(_decimal(c) for c in key))
        for name, material, faces in self._parts:
            if faces:
                lines.append("g " + name.replace(" ", "_"))
                lines.append("usemtl " + material)
                lines += ["f %d %d %d" % face for face in faces]
        return "\n".join(lines) + "\n"


def _decimal(tenths_of_mm):
    sign = "-" if tenths_of_mm < 0 else ""
    whole, rest = divmod(abs(tenths_of_mm), _PER_M)
    return sign + (f"{whole}.{rest:04d}".rstrip("0").rstrip("."))


def circle(center, radius, sides):
    """Outline of a regular polygon, corners on the circle."""
    return [(center[0] + radius * math.cos(2 * math.pi * (k + 0.5) / sides),
             center[1] + radius * math.sin(2 * math.pi * (k + 0.5) / sides))
            for k in range(sides)]


def girder(center, width, height, flange=0.02, web=0.014):
    """Outline of an I section, its web along the second coordinate."""
    u, v = center
    w, h, t = width / 2, height / 2, web / 2
    return [(u - w, v - h), (u + w, v - h), (u + w, v - h + flange),
            (u + t, v - h + flange), (u + t, v + h - flange),
            (u + w, v + h - flange), (u + w, v + h), (u - w, v + h),
            (u - w, v + h - flange), (u - t, v + h - flange),
            (u - t, v - h + flange), (u - w, v - h + flange)]
