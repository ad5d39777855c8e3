#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# Prints the scaled Jacobian of every cell of VTU files of tets and hexahedra, as VTK's Verdict library finds it:
#
#   file PATH
#   VALUE                      for each cell
#
# Usage: vtk_quality.py FILE...; needs Debian's python3-vtk9. Exit 3 if it is missing, 1 if VTK can't read a file.
import sys

try:
    from vtkmodules.vtkFiltersVerdict import vtkMeshQuality
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError as error:
    print(error)
    sys.exit(3)

for path in sys.argv[1:]:
    failed = []
    reader = vtkXMLUnstructuredGridReader()
    reader.AddObserver("ErrorEvent", lambda *_: failed.append(path))
    reader.SetFileName(path)
    quality = vtkMeshQuality()
    quality.SetInputConnection(reader.GetOutputPort())
    quality.SetTetQualityMeasureToScaledJacobian()
    quality.SetHexQualityMeasureToScaledJacobian()
    quality.Update()
    if failed:
        sys.exit(f"VTK can't read {path}")
    print("file", path)
    values = quality.GetOutput().GetCellData().GetArray("Quality")
    for cell in range(values.GetNumberOfTuples()):
        print(repr(values.GetTuple1(cell)))
