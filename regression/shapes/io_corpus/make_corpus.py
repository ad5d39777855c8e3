#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Writes the machine-made files of this folder with VTK 9.1 and Gmsh 4.8 (Debian: python3-vtk9 python3-gmsh; run it with
# /usr/bin/python3). The tests need only the files, which are committed.
import itertools
import os
import struct

import gmsh
import vtk

FOLDER = os.path.dirname(os.path.abspath(__file__))
OCT_FACES = [(0, 2, 5), (0, 4, 2), (0, 5, 3), (0, 3, 4), (1, 2, 4), (1, 5, 2), (1, 4, 3), (1, 3, 5)]
CUBE_FACES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]


def array(kind, name, width, values):
    a = kind()
    a.SetName(name)
    a.SetNumberOfComponents(width)
    for value in values:
        a.InsertNextValue(value)
    return a


def add_data(data, n):
    """Attributes of several types; value i of row r is told by its place, so that tests can compute it."""
    data.AddArray(array(vtk.vtkDoubleArray, "a double", 1, [r / 4 for r in range(n)]))
    data.AddArray(array(vtk.vtkFloatArray, "flow", 3, [r + k / 8 for r in range(n) for k in range(3)]))
    data.AddArray(array(vtk.vtkLongLongArray, "number", 1, [10**10 + r for r in range(n)]))
    data.AddArray(array(vtk.vtkUnsignedCharArray, "byte", 1, [255 - r for r in range(n)]))
    data.AddArray(array(vtk.vtkShortArray, "short", 1, [-r for r in range(n)]))


def points():
    p = vtk.vtkPoints()
    p.SetDataTypeToDouble()
    for xyz in [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, -1), (0, 0, 1)]:
        p.InsertNextPoint(xyz)
    for z, y, x in itertools.product((0, 1), repeat=3):
        p.InsertNextPoint(x + 2 if y == 0 else 3 - x, y, z)  # around each square
    return p


def grid():
    g = vtk.vtkUnstructuredGrid()
    g.SetPoints(points())

    def cell(kind, ids):
        ids_list = vtk.vtkIdList()
        for i in ids:
            ids_list.InsertNextId(i)
        g.InsertNextCell(kind, ids_list)

    def faces(all_faces, first):
        return [len(all_faces)] + [n for f in all_faces for n in [len(f)] + [v + first for v in f]]

    cell(vtk.VTK_HEXAHEDRON, range(6, 14))
    cell(vtk.VTK_POLYHEDRON, faces(OCT_FACES, 0))
    cell(vtk.VTK_TETRA, [6, 7, 8, 10])
    cell(vtk.VTK_WEDGE, [6, 8, 7, 10, 12, 11])
    cell(vtk.VTK_PYRAMID, [6, 7, 8, 9, 10])
    cell(vtk.VTK_POLYHEDRON, faces(CUBE_FACES, 6))
    cell(vtk.VTK_VOXEL, [6, 7, 9, 8, 10, 11, 13, 12])
    cell(vtk.VTK_LINE, [0, 6])
    cell(vtk.VTK_TRIANGLE, [0, 2, 5])
    cell(vtk.VTK_QUAD, [6, 7, 8, 9])
    cell(vtk.VTK_PIXEL, [6, 7, 9, 8])
    cell(vtk.VTK_POLYGON, [0, 2, 5, 6, 7])
    cell(vtk.VTK_TRIANGLE_STRIP, [6, 7, 9, 8])
    cell(vtk.VTK_POLY_LINE, [1, 2, 3])
    cell(vtk.VTK_VERTEX, [4])
    cell(vtk.VTK_TETRA, [7, 8, 9, 10])
    add_data(g.GetPointData(), g.GetNumberOfPoints())
    add_data(g.GetCellData(), g.GetNumberOfCells())
    return g


def poly_data():
    p = vtk.vtkPolyData()
    p.SetPoints(points())

    def cells(lists):
        a = vtk.vtkCellArray()
        for ids in lists:
            a.InsertNextCell(len(ids))
            for i in ids:
                a.InsertCellPoint(i)
        return a

    p.SetVerts(cells([[3]]))
    p.SetLines(cells([[0, 1, 2]]))
    p.SetPolys(cells([[0, 2, 5], [6, 7, 8, 9], [0, 2, 5, 6, 7]]))
    p.SetStrips(cells([[6, 7, 9, 8]]))
    add_data(p.GetPointData(), p.GetNumberOfPoints())
    add_data(p.GetCellData(), p.GetNumberOfCells())
    return p


def write_vtu(name, mode, compressed, big_endian, header, encoded=False):
    w = vtk.vtkXMLUnstructuredGridWriter()
    w.SetFileName(os.path.join(FOLDER, name))
    w.SetInputData(grid())
    {"ascii": w.SetDataModeToAscii, "binary": w.SetDataModeToBinary, "appended": w.SetDataModeToAppended}[mode]()
    w.SetCompressor(vtk.vtkZLibDataCompressor() if compressed else None)
    w.SetBlockSize(128)
    w.SetByteOrder(0 if big_endian else 1)  # vtkXMLWriter: BigEndian = 0, LittleEndian = 1
    (w.SetHeaderTypeToUInt64 if header == 64 else w.SetHeaderTypeToUInt32)()
    w.SetEncodeAppendedData(encoded)
    w.Write()


def write_legacy(name, writer, data, binary, version):
    w = writer()
    w.SetFileName(os.path.join(FOLDER, name))
    w.SetInputData(data)
    (w.SetFileTypeToBinary if binary else w.SetFileTypeToASCII)()
    w.SetFileVersion(version)
    w.Write()


def write_gmsh():
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("PostProcessing.SaveMesh", 0)
    gmsh.option.setNumber("Mesh.MeshSizeMin", 2)
    gmsh.option.setNumber("Mesh.MeshSizeMax", 2)
    box = gmsh.model.occ.addBox(0, 0, 0, 1, 1, 1)
    gmsh.model.occ.synchronize()
    for dimension, tag, label in ((3, box, 7), (2, 1, 5), (1, 1, 4), (0, 1, 3)):
        gmsh.model.addPhysicalGroup(dimension, [tag], label)
    gmsh.model.setPhysicalName(3, 7, "the box")
    gmsh.model.mesh.generate(3)
    height = gmsh.view.add("height z")
    nodes, xyz, _ = gmsh.model.mesh.getNodes()
    gmsh.view.addModelData(height, 0, gmsh.model.getCurrent(), "NodeData", nodes, [[z] for z in xyz[2::3]])
    flow = gmsh.view.add("flow")
    tets = gmsh.model.mesh.getElements(3)[1][0]
    gmsh.view.addModelData(flow, 0, gmsh.model.getCurrent(), "ElementData", tets, [[float(t), 1, 2] for t in tets])
    for version, binary, parametric in ((1, 0, 0), (2.2, 0, 0), (2.2, 1, 0), (4.1, 0, 0), (4.1, 1, 0), (4.1, 1, 1)):
        gmsh.option.setNumber("Mesh.MshFileVersion", version)
        gmsh.option.setNumber("Mesh.Binary", binary)
        gmsh.option.setNumber("Mesh.SaveParametric", parametric)
        name = f"gmsh_{version}_{'binary' if binary else 'text'}{'_parametric' if parametric else ''}.msh"
        path = os.path.join(FOLDER, name)
        gmsh.write(path)
        if version > 1:
            gmsh.view.write(height, path, True)
            gmsh.view.write(flow, path, True)
    gmsh.option.setNumber("Mesh.Binary", 0)
    gmsh.write(os.path.join(FOLDER, "gmsh_box.mesh"))
    gmsh.write(os.path.join(FOLDER, "gmsh_box_text.stl"))
    gmsh.option.setNumber("Mesh.Binary", 1)
    gmsh.write(os.path.join(FOLDER, "gmsh_box_binary.stl"))


def write_ply(name, order):
    """The mesh of hand_crlf.ply."""
    header = f"""ply
format binary_{order}_endian 1.0
element vertex 5
property float x
property float y
property float z
property uchar red
property double w_0
property double w_1
element face 2
property list uchar int vertex_index
property int label
element edge 1
property int vertex1
property int vertex2
property double sharpness
end_header
"""
    mark = "<" if order == "little" else ">"
    with open(os.path.join(FOLDER, name), "wb") as file:
        file.write(header.encode())
        for i, xyz in enumerate([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0.5, 1)]):
            file.write(struct.pack(mark + "fffBdd", *xyz, 255 - i, i + 0.5, -1 - i))
        file.write(struct.pack(mark + "Biiii", 3, 0, 1, 4, 7))
        file.write(struct.pack(mark + "Biiiii", 4, 0, 3, 2, 1, 8))
        file.write(struct.pack(mark + "iid", 0, 1, 2.5))


write_vtu("vtk_text.vtu", "ascii", False, False, 32)
write_vtu("vtk_base64.vtu", "binary", False, False, 64)
write_vtu("vtk_base64_zlib_big.vtu", "binary", True, True, 32)
write_vtu("vtk_raw.vtu", "appended", False, False, 32)
write_vtu("vtk_raw_zlib_big.vtu", "appended", True, True, 64)
write_vtu("vtk_encoded_zlib.vtu", "appended", True, False, 64, True)
for form in ("text", "binary"):
    for file_version in (42, 51):
        write_legacy(f"vtk_{file_version}_{form}.vtk", vtk.vtkUnstructuredGridWriter, grid(), form == "binary", file_version)
        write_legacy(f"vtk_{file_version}_{form}_poly.vtk", vtk.vtkPolyDataWriter, poly_data(), form == "binary", file_version)
write_gmsh()
write_ply("ply_little.ply", "little")
write_ply("ply_big.ply", "big")
