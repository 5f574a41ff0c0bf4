"""VTK's XML files with raw appended data (.vti, .vtp), read as their headers say."""

import struct
import xml.etree.ElementTree

from exchange import check

KINDS = {"Float32": "f", "UInt8": "B", "UInt16": "H", "UInt32": "I", "Int64": "q"}


def read_vtk(path, kind):
    """The element of that kind, texts of its field data, and arrays by name: lists of numbers, or
    of tuples where they have several components."""
    with open(path, "rb") as file:
        data = file.read()
    at = data.index(b"_", data.index(b"<AppendedData")) + 1
    end = data.rindex(b"\n  </AppendedData>")
    root = xml.etree.ElementTree.fromstring(data[:at - 1].decode("ascii") +
                                            "</AppendedData></VTKFile>")
    check(root.attrib["type"] == kind and root.attrib["byte_order"] == "LittleEndian" and
          root.attrib["header_type"] == "UInt64", root.attrib)
    element = root.find(kind)
    texts = {array.attrib["Name"]: bytes(int(x) for x in array.text.split()[:-1]).decode()
             for array in element.find("FieldData")}
    arrays, used = {}, 0
    for array in element.find("Piece").iter("DataArray"):
        facts = array.attrib
        offset, each = at + int(facts["offset"]), KINDS[facts["type"]]
        check(offset == at + used, "a gap before", facts)
        (n,) = struct.unpack_from("<Q", data, offset)
        values = struct.unpack_from("<%d%s" % (n // struct.calcsize(each), each), data, offset + 8)
        many = int(facts.get("NumberOfComponents", 1))
        arrays[facts["Name"]] = values if many == 1 else list(zip(*[iter(values)] * many))
        used += 8 + n
    check(used == end - at, "bytes behind the arrays", end - at - used)
    return element, texts, arrays
