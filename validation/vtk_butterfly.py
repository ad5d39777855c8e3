#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# Refines triangle surfaces by VTK's butterfly filter and prints the levels, as lines of numbers.
#
# VTK rounds points to floats. It blends point data by the same weights in double precision, so the coordinates come
# along as point data, and it is those that are printed.
#
#   surface I                  for each surface of the file, from 0
#   level L POINTS TRIANGLES   for each level from 1; then a line of three coordinates a point, of three ids a triangle
#   refused WORDS              instead of the next level, if VTK reports an error
#
# Usage: vtk_butterfly.py FILE LEVELS; FILE has surfaces one after another: a line POINTS TRIANGLES, then lines as above.
# Needs Debian's python3-vtk9. Exit 3 if it is missing.
import sys

try:
    from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIdList, vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    from vtkmodules.vtkFiltersModeling import vtkButterflySubdivisionFilter
except ImportError as error:
    print(error)
    sys.exit(3)


def make_surface(points, triangles):
    places, coordinates, cells = vtkPoints(), vtkDoubleArray(), vtkCellArray()
    cells.Use64BitStorage()  # with 32 bits VTK before 9.4 mixes up two reads of a cell, and finds any surface non-manifold
    coordinates.SetName("coordinates")
    coordinates.SetNumberOfComponents(3)
    for point in points:
        places.InsertNextPoint(point)
        coordinates.InsertNextTuple(point)
    for triangle in triangles:
        cells.InsertNextCell(3)
        for vertex in triangle:
            cells.InsertCellPoint(vertex)
    surface = vtkPolyData()
    surface.SetPoints(places)
    surface.SetPolys(cells)
    surface.GetPointData().AddArray(coordinates)
    return surface


def subdivide(points, triangles):
    """One level: points, triangles and what VTK complained of."""
    complaints = []

    def note(caller, event, text):
        complaints.append(" ".join(text.split()))

    note.CallDataType = "string0"
    butterfly = vtkButterflySubdivisionFilter()
    butterfly.AddObserver("ErrorEvent", note)
    butterfly.AddObserver("WarningEvent", note)
    butterfly.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)  # it only repeats that the filter failed
    butterfly.SetNumberOfSubdivisions(1)
    butterfly.SetInputData(make_surface(points, triangles))
    butterfly.Update()
    result = butterfly.GetOutput()
    coordinates = result.GetPointData().GetArray("coordinates")
    if complaints or coordinates is None or coordinates.GetNumberOfTuples() != result.GetNumberOfPoints():
        return [], [], complaints or ["no result"]
    corners, finer = vtkIdList(), []
    for cell in range(result.GetNumberOfCells()):
        result.GetCellPoints(cell, corners)
        finer.append([corners.GetId(i) for i in range(corners.GetNumberOfIds())])
    return [coordinates.GetTuple(v) for v in range(coordinates.GetNumberOfTuples())], finer, []


def refine(points, triangles, n_levels):
    for level in range(1, n_levels + 1):
        points, triangles, complaints = subdivide(points, triangles)
        if complaints:
            print("refused", "; ".join(complaints))
            return
        print("level", level, len(points), len(triangles))
        print("\n".join(" ".join(map(repr, row)) for row in points + triangles))


with open(sys.argv[1], encoding="ascii") as file:
    words = iter(file.read().split())
for index, count in enumerate(words):
    n_points, n_triangles = int(count), int(next(words))
    given_points = [[float(next(words)) for _ in range(3)] for _ in range(n_points)]
    given_triangles = [[int(next(words)) for _ in range(3)] for _ in range(n_triangles)]
    print("surface", index)
    refine(given_points, given_triangles, int(sys.argv[2]))
