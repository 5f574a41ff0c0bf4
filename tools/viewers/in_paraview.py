"""Opens the .vti, .vtp and .ply files of a folder in ParaView, run as
pvpython in_paraview.py DIR PICTURES

With NO_PICTURES set it only looks whether all is there: pictures need a display.
"""

import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import headers  # noqa: E402
from paraview.simple import (  # noqa: E402
    Clip, CreateView, ColorBy, Delete, GetColorTransferFunction, GetOpacityTransferFunction, Hide,
    OpenDataFile, ResetCamera, SaveScreenshot, Show)

SIZE = [480, 360]
WITHOUT_PICTURES = "NO_PICTURES" in os.environ
failures = []


def say(name, *words, failed=False):
    print("paraview  %-20s %s" % (name, " ".join(str(word) for word in words)), flush=True)
    if failed:
        failures.append(name)


def check(holds, *words):
    if not holds:
        raise ValueError(" ".join(str(word) for word in words))


def new_view():
    view = CreateView("RenderView")
    view.ViewSize = SIZE
    view.UseColorPaletteForBackground = 0
    view.Background = [0.06, 0.065, 0.09]
    view.OrientationAxesVisibility = 0
    return view


TO_EYE = -0.55, -0.85, 0.75  # from the middle to the eye


def middle_of(bounds):
    return [(a + b) / 2 for a, b in zip(bounds[::2], bounds[1::2])]


def aim_camera(view, bounds):
    middle = middle_of(bounds)
    radius = math.dist(bounds[::2], bounds[1::2]) / 2
    length = math.hypot(*TO_EYE)
    view.CameraFocalPoint = middle
    view.CameraPosition = [m + w / length * 3 * radius for m, w in zip(middle, TO_EYE)]
    view.CameraViewUp = [0, 0, 1]
    ResetCamera(view)


def shades(path):
    """Of a picture: more than a few, or nothing is to be seen."""
    from paraview.vtk.vtkIOImage import vtkPNGReader
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    scalars = image.GetPointData().GetScalars()
    return len({tuple(round(x / 4) for x in scalars.GetTuple3(i))
                for i in range(scalars.GetNumberOfTuples())})


def take(view, source, path):
    aim_camera(view, source.GetDataInformation().GetBounds())
    SaveScreenshot(path, view)
    Hide(source, view)
    n = shades(path)
    check(n > 20, "the picture is blank:", n, "shades")


def ranges(data, names):
    """Every array, with a number in it."""
    out = {}
    for name in names:
        array = data.GetArray(name)
        check(array is not None, "no array", name)
        low, high = array.GetRange(0)
        check(math.isfinite(low) and math.isfinite(high) and low <= high or name == "coverage",
              name, "is", low, high)
        out[name] = low, high
    return out


def open_image(folder, name, picture):
    path = os.path.join(folder, name)
    want = headers.vtk_arrays(path)["CellData"]
    low, high, _ = headers.domain(path)
    source = OpenDataFile(path)
    source.UpdatePipeline()
    facts = source.GetDataInformation()
    bounds = facts.GetBounds()
    check(math.dist(bounds[::2], low) < 1e-9 and math.dist(bounds[1::2], high) < 1e-9,
          "lies in", bounds, "not in", low, high)
    found = ranges(source.CellData, want)
    if not WITHOUT_PICTURES:
        view = new_view()
        display = Show(source, view)
        display.Representation = "Volume"
        ColorBy(display, ("CELLS", want[0]))
        low, high = found[want[0]]
        color, opacity = (get(want[0]) for get in (GetColorTransferFunction,
                                                   GetOpacityTransferFunction))
        color.RescaleTransferFunction(low, high)
        opacity.Points = [low, 0, 0.5, 0, high if high > low else low + 1, 0.5, 0.5, 0]
        take(view, source, picture)
        Delete(view)
    Delete(source)
    return "%s; %d voxels" % (", ".join(want), facts.GetNumberOfCells())


def without_near_half(source):
    """One looks into a room."""
    half = Clip(Input=source)
    half.ClipType = "Plane"
    half.ClipType.Origin = middle_of(source.GetDataInformation().GetBounds())
    half.ClipType.Normal = TO_EYE
    half.Invert = 1
    half.UpdatePipeline()
    return half


def open_mesh(folder, name, picture):
    path = os.path.join(folder, name)
    source = OpenDataFile(path)
    source.UpdatePipeline()
    facts = source.GetDataInformation()
    if name.endswith(".ply"):
        counts = headers.ply_counts(path)
        points, cells, shown = counts["vertex"][0], counts.get("face", (0,))[0], ["RGB"]
        found, data = ranges(source.PointData, shown), ("POINTS", "RGB")
    else:
        piece = headers.vtk_header(path)[0].find("Piece").attrib
        names = headers.vtk_arrays(path)
        points = int(piece["NumberOfPoints"])
        cells = int(piece.get("NumberOfPolys", piece.get("NumberOfVerts", 0)))
        found = ranges(source.CellData, names["CellData"])
        found.update(ranges(source.PointData, names["PointData"]))
        shown = [n for n in ("coverage", "irradiance", "color") if n in found][:1]
        data = ("CELLS" if names["CellData"] else "POINTS", shown[0])
    check(facts.GetNumberOfPoints() == points, facts.GetNumberOfPoints(), "points, not", points)
    check(facts.GetNumberOfCells() == cells, facts.GetNumberOfCells(), "cells, not", cells)
    if not WITHOUT_PICTURES:
        view = new_view()
        shown_of = without_near_half(source) if name.startswith("surfaces") else source
        display = Show(shown_of, view)
        ColorBy(display, data)
        if shown[0] in ("RGB", "color"):
            display.MapScalars = 0
            if points > 3 * cells or cells < 2:
                display.Representation = "Point Gaussian"
                display.GaussianRadius = 0.002 * math.dist(facts.GetBounds()[::2],
                                                           facts.GetBounds()[1::2])
        else:
            display.RescaleTransferFunctionToDataRange(False, True)
        take(view, shown_of, picture)
        Delete(view)
        if shown_of is not source:
            Delete(shown_of)
    Delete(source)
    return "%d points, %d cells; %s" % (points, cells, ", ".join(found))


def main():
    folder, pictures = sys.argv[1:]
    names = sorted(n for n in os.listdir(folder) if n.endswith((".vti", ".vtp", ".ply")))
    if not names:
        say("", "nothing to open: no .vti, .vtp and .ply; murk place -o DIR --export "
            "fields,photons,surfaces")
    for name in names:
        opens = open_image if name.endswith(".vti") else open_mesh
        picture = os.path.join(pictures, "paraview-%s.png" % name.replace(".", "-"))
        try:
            say(name, opens(folder, name, picture))
        except Exception as error:
            say(name, "FAILED:", error, failed=True)
    with open(os.path.join(pictures, ".paraview"), "w") as file:
        file.write("".join(name + "\n" for name in failures))


main()
