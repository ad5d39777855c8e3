#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# VTK's butterfly filter as a candidate of a race: a process that stays, and takes a turn for every line it reads.
#
# Reads a line POINTS TRIANGLES LEVELS, then a line of three coordinates a point and of three ids a triangle; prints
# "ready". Then for each line:
#   run    refines with a filter of its own and prints seconds on the wall and of the processor
#   sums   prints points, triangles, sums of the coordinates and of their squares, of the last result
#
# Needs Debian's python3-vtk9. Exit 3 if it is missing.
import sys
import time

try:
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    from vtkmodules.vtkFiltersModeling import vtkButterflySubdivisionFilter
except ImportError:
    sys.exit(3)


def numbers(kind):
    return [kind(word) for word in sys.stdin.readline().split()]


def read_surface(n_points, n_triangles):
    points, cells = vtkPoints(), vtkCellArray()
    points.SetDataTypeToFloat()
    cells.Use64BitStorage()  # with 32 bits VTK before 9.4 mixes up two reads of a cell, and finds any surface non-manifold
    for _ in range(n_points):
        points.InsertNextPoint(numbers(float))
    for _ in range(n_triangles):
        cells.InsertNextCell(3)
        for vertex in numbers(int):
            cells.InsertCellPoint(vertex)
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(cells)
    return surface


def sums(surface):
    rows = [surface.GetPoint(i) for i in range(surface.GetNumberOfPoints())]
    columns = list(zip(*rows))
    return [len(rows), surface.GetNumberOfCells(), *map(sum, columns), *(sum(x * x for x in c) for c in columns)]


count_points, count_triangles, n_levels = numbers(int)
control = read_surface(count_points, count_triangles)
refined = None
print("ready", flush=True)
for line in sys.stdin:
    if line.strip() == "sums":
        print(*sums(refined), flush=True)
        continue
    refined = None  # frees it before the clock starts
    butterfly = vtkButterflySubdivisionFilter()
    butterfly.SetNumberOfSubdivisions(n_levels)
    butterfly.SetInputData(control)
    on_wall, of_processor = time.perf_counter(), time.process_time()
    butterfly.Update()
    print(time.perf_counter() - on_wall, time.process_time() - of_processor, flush=True)
    refined = butterfly.GetOutput()
    del butterfly
