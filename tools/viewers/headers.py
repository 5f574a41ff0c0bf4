"""What the headers of .ply, .vti and .vtp files promise, for those who check what a viewer made of
them."""

import xml.etree.ElementTree


def ply_counts(path):
    """Elements by name: how many, and which properties."""
    out, name = {}, None
    with open(path, "rb") as file:
        for line in file:
            words = line.decode("utf-8", "replace").split()
            if words == ["end_header"]:
                return out
            if words[0] == "element":
                name = words[1]
                out[name] = int(words[2]), []
            elif words[0] == "property":
                out[name][1].append(words[-1])
    raise ValueError("no end_header")


def vtk_header(path):
    """The root of a .vti or .vtp, without its raw bytes."""
    with open(path, "rb") as file:
        data = b""
        while b"<AppendedData" not in data:
            more = file.read(65536)
            if not more:
                raise ValueError("no appended data")
            data += more
    head = data[:data.index(b"<AppendedData")].decode("ascii")
    return xml.etree.ElementTree.fromstring(head + "</VTKFile>")


def vtk_arrays(path):
    """Names by CellData and PointData."""
    piece = vtk_header(path)[0].find("Piece")
    return {kind: [array.attrib["Name"] for array in piece.findall(kind + "/DataArray")]
            for kind in ("CellData", "PointData")}


def domain(path):
    """Lower and upper corner of a .vti, and its voxels' edges."""
    image = vtk_header(path)[0].attrib
    extent, origin, spacing = ([float(x) for x in image[key].split()]
                               for key in ("WholeExtent", "Origin", "Spacing"))
    return origin, [o + s * n for o, s, n in zip(origin, spacing, extent[1::2])], spacing
