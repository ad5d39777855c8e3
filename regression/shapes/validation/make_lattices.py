#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# Writes lattice_28.vtu and lattice_20.vtu: small control lattices with the numbers of tets of the box-spline paper.
#
# Both are built by cones: a cube whose six faces are cut into two triangles each, joined to its centre, is 12 tets; a
# "roof" is an apex over one outer face of a cube, 2 tets. Two cubes in a row with a roof at each end: 12 + 12 + 2 + 2 =
# 28 tets on 12 + 2 + 2 = 16 points. One cube with roofs on four faces: 12 + 4 * 2 = 20 tets on 8 + 1 + 4 = 13 points.
# Needs nothing but Python. Usage: make_lattices.py [FOLDER]
import pathlib
import sys


class Lattice:
    def __init__(self):
        self.points, self.tets, self.number = [], [], {}

    def point(self, p):
        if p not in self.number:
            self.number[p] = len(self.points)
            self.points.append(p)
        return self.number[p]

    def add_tet(self, a, b, c, d):
        """Adds a tet, its vertices ordered so that it is positive."""
        pa, pb, pc, pd = (self.points[v] for v in (a, b, c, d))
        u, v, w = ([q[i] - pa[i] for i in range(3)] for q in (pb, pc, pd))
        det = (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0])
               + u[2] * (v[0] * w[1] - v[1] * w[0]))
        assert det != 0
        self.tets.append((a, b, c, d) if det > 0 else (a, b, d, c))

    def add_pyramid(self, square, apex):
        """Two tets between a square, cut along the diagonal from its least point, and an apex."""
        q = [self.point(p) for p in square]
        k = min(range(4), key=lambda i: square[i])
        q = q[k:] + q[:k]
        top = self.point(apex)
        self.add_tet(q[0], q[1], q[2], top)
        self.add_tet(q[0], q[2], q[3], top)

    def add_cube(self, x):
        """The cube with least corner (x, -1, -1) and edge length 2: six pyramids to its centre."""
        for square in squares(x):
            self.add_pyramid(square, (x + 1.0, 0.0, 0.0))

    def write(self, path):
        n, m = len(self.points), len(self.tets)
        lines = ['<?xml version="1.0"?>', '<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian">',
                 ' <UnstructuredGrid>', f'  <Piece NumberOfPoints="{n}" NumberOfCells="{m}">',
                 '   <Points>', '    <DataArray type="Float64" NumberOfComponents="3" format="ascii">']
        lines += ["     " + " ".join(repr(float(x)) for x in p) for p in self.points]
        lines += ['    </DataArray>', '   </Points>', '   <Cells>',
                  '    <DataArray type="Int64" Name="connectivity" format="ascii">']
        lines += ["     " + " ".join(map(str, t)) for t in self.tets]
        lines += ['    </DataArray>', '    <DataArray type="Int64" Name="offsets" format="ascii">',
                  "     " + " ".join(str(4 * (i + 1)) for i in range(m)), '    </DataArray>',
                  '    <DataArray type="UInt8" Name="types" format="ascii">', "     " + " ".join(["10"] * m),
                  '    </DataArray>', '   </Cells>', '  </Piece>', ' </UnstructuredGrid>', '</VTKFile>']
        path.write_text("\n".join(lines) + "\n")


def squares(x):
    """The six faces of the cube, each as its corners in order."""
    lo, hi = x, x + 2.0
    return [[(e, -1.0, -1.0), (e, 1.0, -1.0), (e, 1.0, 1.0), (e, -1.0, 1.0)] for e in (lo, hi)] + \
           [[(lo, e, -1.0), (hi, e, -1.0), (hi, e, 1.0), (lo, e, 1.0)] for e in (-1.0, 1.0)] + \
           [[(lo, -1.0, e), (hi, -1.0, e), (hi, 1.0, e), (lo, 1.0, e)] for e in (-1.0, 1.0)]


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__)
    folder = folder if folder.is_dir() else folder.parent

    spindle = Lattice()
    spindle.add_cube(0.0)
    spindle.add_cube(2.0)
    spindle.add_pyramid(squares(0.0)[0], (-1.0, 0.0, 0.0))
    spindle.add_pyramid(squares(2.0)[1], (5.0, 0.0, 0.0))
    assert (len(spindle.points), len(spindle.tets)) == (16, 28)
    spindle.write(folder / "lattice_28.vtu")

    star = Lattice()
    star.add_cube(0.0)
    for square, apex in zip(squares(0.0)[2:], [(1.0, -2.0, 0.0), (1.0, 2.0, 0.0), (1.0, 0.0, -2.0), (1.0, 0.0, 2.0)]):
        star.add_pyramid(square, apex)
    assert (len(star.points), len(star.tets)) == (13, 20)
    star.write(folder / "lattice_20.vtu")


main()
