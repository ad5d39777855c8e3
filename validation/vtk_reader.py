#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# Reads VTU files with VTK's own reader and prints what it finds in each, as lines of words:
#
#   file PATH
#   points N
#   cells VTK_TYPE N          for each type
#   volume LEAST SUM N         of the tets and polyhedra, signed by the order of their vertices and faces; N are not > 0
#   array point|cell WIDTH SUM NAME
#
# Usage: vtk_reader.py FILE...; needs Debian's python3-vtk9. Exit 3 if it is missing, 1 if VTK can't read a file.
import math
import sys

try:
    from vtkmodules.vtkCommonCore import vtkIdList
    from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, VTK_TETRA, vtkTetra
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError as error:
    print(error)
    sys.exit(3)


def polyhedron_volume(grid, cell):
    """By the divergence theorem, from the faces as the file orders them (VTK: counterclockwise from outside)."""
    stream = vtkIdList()
    grid.GetFaceStream(cell, stream)
    ids = [stream.GetId(i) for i in range(stream.GetNumberOfIds())]
    origin = grid.GetPoint(ids[2])
    volume, at = 0.0, 1
    for _ in range(ids[0]):
        n = ids[at]
        corners = [grid.GetPoint(v) for v in ids[at + 1:at + 1 + n]]
        at += n + 1
        for k in range(1, n - 1):
            volume += vtkTetra.ComputeVolume(origin, corners[0], corners[k], corners[k + 1])
    return volume


def volumes(grid):
    points = vtkIdList()
    for cell in range(grid.GetNumberOfCells()):
        kind = grid.GetCellType(cell)
        if kind == VTK_TETRA:
            grid.GetCellPoints(cell, points)
            yield vtkTetra.ComputeVolume(*(grid.GetPoint(points.GetId(i)) for i in range(4)))
        elif kind == VTK_POLYHEDRON:
            yield polyhedron_volume(grid, cell)


def describe(path):
    failed = []
    reader = vtkXMLUnstructuredGridReader()
    reader.AddObserver("ErrorEvent", lambda *_: failed.append(path))
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    if failed or grid is None:
        sys.exit(f"VTK can't read {path}")
    print("file", path)
    print("points", grid.GetNumberOfPoints())
    kinds = [grid.GetCellType(c) for c in range(grid.GetNumberOfCells())]
    for kind in sorted(set(kinds)):
        print("cells", kind, kinds.count(kind))
    found = list(volumes(grid))
    if found:
        print("volume", repr(min(found)), repr(math.fsum(found)), sum(not v > 0 for v in found))
    for place, data in (("point", grid.GetPointData()), ("cell", grid.GetCellData())):
        for i in range(data.GetNumberOfArrays()):
            array = data.GetArray(i)
            width = array.GetNumberOfComponents()
            total = math.fsum(x for t in range(array.GetNumberOfTuples()) for x in array.GetTuple(t))
            print("array", place, width, repr(total), array.GetName())


for name in sys.argv[1:]:
    describe(name)
