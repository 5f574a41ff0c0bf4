"""A workshop of 12 x 8 x 3.5 m as a program for buildings writes it: an IFC file of
walls, slab, window panes and furniture, each a solid with a named surface style. The
roof is not in it, as happens when one storey is exported, and the gate in the north
wall stands open.

     y=8 +----------+---------[ gate ]--+
         | shelf    |                   |
         |           door      bench    |
         | shelf    |                   |
     y=0 +-[window]-+------[window]-----+
        x=0         5                   12
"""

WALL = .3       # thickness
SINK = .01      # solids that meet run into each other, so that no ray finds a seam

# IFC class, name, surface style, lower and upper corner
SOLIDS = [
    ("SLAB", "Floor", "Concrete", (-.3, -.3, -.2), (12.3, 8.3, 0)),
    ("WALL", "South below windows", "Brick", (-.3, -.3, -.1), (12.3, 0, 1)),
    ("WALL", "South above windows", "Brick", (-.3, -.3, 2.4), (12.3, 0, 3.5)),
    ("WALL", "South 1", "Brick", (-.3, -.3, 1 - SINK), (1.5, 0, 2.4 + SINK)),
    ("WALL", "South 2", "Brick", (4, -.3, 1 - SINK), (7.5, 0, 2.4 + SINK)),
    ("WALL", "South 3", "Brick", (10, -.3, 1 - SINK), (12.3, 0, 2.4 + SINK)),
    ("WINDOW", "Window 1", "Glass", (1.5 - SINK, -.16, 1 - SINK), (4 + SINK, -.14, 2.4 + SINK)),
    ("WINDOW", "Window 2", "Glass", (7.5 - SINK, -.16, 1 - SINK), (10 + SINK, -.14, 2.4 + SINK)),
    ("WALL", "West", "Brick", (-.3, -.3, -.1), (0, 8.3, 3.5)),
    ("WALL", "East", "Brick", (12, -.3, -.1), (12.3, 8.3, 3.5)),
    ("WALL", "North 1", "Brick", (-.3, 8, -.1), (9, 8.3, 3.5)),
    ("WALL", "North 2", "Brick", (11, 8, -.1), (12.3, 8.3, 3.5)),
    ("WALL", "North above gate", "Brick", (9 - SINK, 8, 2.6), (11 + SINK, 8.3, 3.5)),
    ("WALL", "Inner 1", "Plaster", (5, -SINK, -.1), (5.15, 3, 3.5)),
    ("WALL", "Inner 2", "Plaster", (5, 4.2, -.1), (5.15, 8 + SINK, 3.5)),
    ("WALL", "Inner above door", "Plaster", (5, 3 - SINK, 2.1), (5.15, 4.2 + SINK, 3.5)),
    ("FURNISHINGELEMENT", "Shelf 1", "Wood", (.5, 1.5, -SINK), (1, 3.5, 2)),
    ("FURNISHINGELEMENT", "Shelf 2", "Wood", (.5, 5, -SINK), (1, 7, 2)),
    ("FURNISHINGELEMENT", "Bench", "Steel", (7, 4, -SINK), (10, 5, .9)),
]
COLOURS = {"Concrete": (.6, .6, .6), "Brick": (.7, .4, .3), "Plaster": (.9, .9, .9),
           "Glass": (.7, .9, .9), "Wood": (.6, .45, .3), "Steel": (.5, .5, .55)}
# Attributes of IFC 2x3 behind the representation.
TAIL = {"SLAB": "$,.FLOOR.", "WALL": "$", "WINDOW": "$,$,$", "FURNISHINGELEMENT": "$"}

HEAD = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION(('ViewDefinition [CoordinationView]'),'2;1');
FILE_NAME('workshop.ifc','2026-01-01T00:00:00',(''),(''),'tools/make_scenes','murk','');
FILE_SCHEMA(('IFC2X3'));
ENDSEC;
DATA;
"""


def _decimal(x):
    text = f"{x:.4f}".rstrip("0")
    return "0." if text in ("-0.", "0.") else text


class Ifc:
    """The solids as text of an IFC file."""

    def __init__(self):
        self.lines = []

    def add(self, entity):
        self.lines.append(f"#{len(self.lines) + 1}={entity};")
        return f"#{len(self.lines)}"

    def point(self, *x):
        return self.add("IFCCARTESIANPOINT((" + ",".join(map(_decimal, x)) + "))")

    def direction(self, *x):
        return self.add("IFCDIRECTION((" + ",".join(map(_decimal, x)) + "))")

    def guid(self):
        """22 characters of which each is used once, as IFC asks of each object."""
        return f"'{len(self.lines):022d}'"

    def place(self, corner, within="$"):
        axes = self.add(f"IFCAXIS2PLACEMENT3D({self.point(*corner)},$,$)")
        return self.add(f"IFCLOCALPLACEMENT({within},{axes})")

    def project(self):
        person = self.add("IFCPERSON($,$,'murk',$,$,$,$,$)")
        company = self.add("IFCORGANIZATION($,'murk',$,$,$)")
        owner = self.add(f"IFCPERSONANDORGANIZATION({person},{company},$)")
        program = self.add(f"IFCAPPLICATION({company},'1','make_scenes','make_scenes')")
        self.history = self.add(f"IFCOWNERHISTORY({owner},{program},$,.ADDED.,$,$,$,0)")
        units = ",".join(self.add(f"IFCSIUNIT(*,.{kind}.,$,.{name}.)") for kind, name in (
            ("LENGTHUNIT", "METRE"), ("AREAUNIT", "SQUARE_METRE"), ("VOLUMEUNIT", "CUBIC_METRE"),
            ("PLANEANGLEUNIT", "RADIAN")))
        units = self.add(f"IFCUNITASSIGNMENT(({units}))")
        axes = self.add(f"IFCAXIS2PLACEMENT3D({self.point(0, 0, 0)},$,$)")
        self.context = self.add(f"IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-5,{axes},$)")
        project = self.add(f"IFCPROJECT({self.guid()},{self.history},'Workshop',$,$,$,$,({self.context}),{units})")
        parent, within = project, "$"
        for kind, name, tail in (("SITE", "Site", ",$,$,$,$,$"), ("BUILDING", "Building", ",$,$,$"),
                                 ("BUILDINGSTOREY", "Ground floor", ",0.")):
            within = self.place((0, 0, 0), within)
            child = self.add(f"IFC{kind}({self.guid()},{self.history},'{name}',$,$,{within},$,$,.ELEMENT.{tail})")
            self.add(f"IFCRELAGGREGATES({self.guid()},{self.history},$,$,{parent},({child}))")
            parent = child
        return parent, within

    def style(self, name):
        colour = self.add("IFCCOLOURRGB($," + ",".join(map(_decimal, COLOURS[name])) + ")")
        shading = self.add(f"IFCSURFACESTYLERENDERING({colour},0.,$,$,$,$,$,$,.NOTDEFINED.)")
        surface = self.add(f"IFCSURFACESTYLE('{name}',.BOTH.,({shading}))")
        return self.add(f"IFCPRESENTATIONSTYLEASSIGNMENT(({surface}))")

    def solid(self, kind, name, style, low, high, within):
        size = [b - a for a, b in zip(low, high)]
        middle = self.add(f"IFCAXIS2PLACEMENT2D({self.point(size[0] / 2, size[1] / 2)},$)")
        profile = self.add(f"IFCRECTANGLEPROFILEDEF(.AREA.,$,{middle},{_decimal(size[0])},{_decimal(size[1])})")
        axes = self.add(f"IFCAXIS2PLACEMENT3D({self.point(0, 0, 0)},$,$)")
        up = self.direction(0, 0, 1)
        body = self.add(f"IFCEXTRUDEDAREASOLID({profile},{axes},{up},{_decimal(size[2])})")
        self.add(f"IFCSTYLEDITEM({body},({style}),$)")
        shape = self.add(f"IFCSHAPEREPRESENTATION({self.context},'Body','SweptSolid',({body}))")
        shape = self.add(f"IFCPRODUCTDEFINITIONSHAPE($,$,({shape}))")
        place = self.place(low, within)
        return self.add(f"IFC{kind}({self.guid()},{self.history},'{name}',$,$,{place},{shape},{TAIL[kind]})")

    def triangles(self):
        return 12 * len(SOLIDS)

    def text(self):
        self.lines = []
        storey, within = self.project()
        styles = {name: self.style(name) for name in COLOURS}
        solids = [self.solid(kind, name, styles[style], low, high, within)
                  for kind, name, style, low, high in SOLIDS]
        self.add(f"IFCRELCONTAINEDINSPATIALSTRUCTURE({self.guid()},{self.history},$,$,"
                 f"({','.join(solids)}),{storey})")
        return HEAD + "\n".join(self.lines) + "\nENDSEC;\nEND-ISO-10303-21;\n"
