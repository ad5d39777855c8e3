#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes bunny_lattice.vtu: a coarse tetrahedral control lattice whose Loop boundary surface is the Stanford bunny.

    /usr/bin/python3 make_bunny_lattice.py bunny.obj bunny_lattice.vtu

Needs numpy, scipy (Debian: python3-numpy python3-scipy) and the program tetgen on the PATH. Steps:
  1. decimate the scan by quadric edge collapse, with a bound on edge length and valence;
  2. even it out: edge flips towards valence 6, tangential smoothing, projection back to the scan;
  3. move the control points so that the Loop limit surface fits the scan (least squares, alternating with closest points),
     then by fixed point so that every control vertex's own limit position comes to lie on the scan;
  4. fill the fitted surface with tets (tetgen, the surface kept as it is), flip the tets around inner edges that have only
     three of them (the box-spline rules like those least), move interior vertices for better shape;
  5. move control points a little where the refined solid would fold: no child of any tet, whatever its diagonal, may have
     less than a small share of its parent's volume;
  6. add the point attribute `density` (1 in the skin, 3 deep inside) and write ASCII VTU.
"""
import os
import subprocess
import sys
import tempfile

import numpy as np
import scipy.optimize
import scipy.sparse as sp
import scipy.sparse.linalg as spla
from scipy.spatial import cKDTree

from coarse_surface import Surface, decimate, flip_edges, relax, vertex_normals

BOUNDARY_VERTICES = 520
INTERIOR_VOLUME = 1.1  # largest tet asked of tetgen


# ---------------------------------------------------------------- files

def read_obj(path):
    vertices, triangles = [], []
    for line in open(path):
        words = line.split()
        if words and words[0] == "v":
            vertices.append([float(w) for w in words[1:4]])
        elif words and words[0] == "f":
            triangles.append([int(w.split("/")[0]) - 1 for w in words[1:4]])
    return np.array(vertices), np.array(triangles)


def write_vtu(path, points, tets, attributes):
    def array(name, kind, values, width, text):
        rows = np.asarray(values).reshape(len(values), -1)
        lines = "\n".join(" ".join(text % x for x in row) for row in rows)
        components = f' NumberOfComponents="{width}"' if width > 1 else ""
        return f'<DataArray type="{kind}" Name="{name}"{components} format="ascii">\n{lines}\n</DataArray>\n'

    with open(path, "w") as out:
        out.write('<?xml version="1.0"?>\n<!-- The Stanford bunny (Stanford University Computer Graphics Laboratory) as a '
                  'control lattice; see README.md beside this file. -->\n'
                  '<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian">\n<UnstructuredGrid>\n'
                  f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(tets)}">\n<PointData>\n')
        for name, values in attributes.items():
            out.write(array(name, "Float64", values, 1, "%.4f"))
        out.write("</PointData>\n<Points>\n" + array("Points", "Float64", points, 3, "%.5f") + "</Points>\n<Cells>\n")
        out.write(array("connectivity", "Int64", tets, 1, "%d"))
        per_line = [" ".join(str(4 * (i + 1)) for i in range(s, min(s + 12, len(tets)))) for s in range(0, len(tets), 12)]
        out.write('<DataArray type="Int64" Name="offsets" format="ascii">\n' + "\n".join(per_line) + "\n</DataArray>\n")
        per_line = [" ".join(["10"] * (min(s + 40, len(tets)) - s)) for s in range(0, len(tets), 40)]
        out.write('<DataArray type="UInt8" Name="types" format="ascii">\n' + "\n".join(per_line) + "\n</DataArray>\n")
        out.write("</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n")


# ---------------------------------------------------------------- 3: Loop surface and its fit

def loop_matrix(n, t):
    """One step of Loop subdivision of a closed mesh as a sparse matrix, and the new triangles."""
    edge = {}
    opposite = {}
    for f in t:
        for i in range(3):
            key = tuple(sorted((f[i], f[(i + 1) % 3])))
            edge.setdefault(key, n + len(edge))
            opposite.setdefault(key, []).append(f[(i + 2) % 3])
    ring = [[] for _ in range(n)]
    for a, b in edge:
        ring[a].append(b)
        ring[b].append(a)
    rows = []
    for i in range(n):
        k = len(ring[i])
        beta = (5 / 8 - (3 / 8 + np.cos(2 * np.pi / k) / 4) ** 2) / k
        rows += [(i, i, 1 - k * beta)] + [(i, j, beta) for j in ring[i]]
    for (a, b), e in edge.items():
        rows += [(e, a, 3 / 8), (e, b, 3 / 8)] + [(e, c, 1 / 8) for c in opposite[(a, b)]]
    i, j, w = zip(*rows)
    new = []
    for f in t:
        m = [edge[tuple(sorted((f[i], f[(i + 1) % 3])))] for i in range(3)]
        new += [(f[0], m[0], m[2]), (m[0], f[1], m[1]), (m[2], m[1], f[2]), (m[0], m[1], m[2])]
    return sp.csr_matrix((w, (i, j)), (n + len(edge), n)), np.array(new)


def limit_matrix(n, t):
    edges = np.unique(np.sort(np.vstack([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]]), axis=1), axis=0)
    a = sp.coo_matrix((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), (n, n))
    a = (a + a.T).tocsr()
    k = np.asarray(a.sum(1)).ravel()
    beta = (5 / 8 - (3 / 8 + np.cos(2 * np.pi / k) / 4) ** 2) / k
    chi = 1 / (3 / (8 * beta) + k)
    return (sp.diags(1 - k * chi) + sp.diags(chi) @ a).tocsr(), edges


def fit(v, t, surface, smoothness):
    """Control points whose limit surface, sampled at level 2, is nearest to the scan, and the scan's vertices to it: the
    second keeps the ears from drawing back."""
    limit, edges = limit_matrix(len(v), t)
    sample, fine = sp.identity(len(v), format="csr"), t
    for _ in range(2):
        step, fine = loop_matrix(sample.shape[0], fine)
        sample = step @ sample
    sample = limit_matrix(sample.shape[0], fine)[0] @ sample
    adjacency = sp.coo_matrix((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), (len(v), len(v)))
    adjacency = (adjacency + adjacency.T).tocsr()
    laplacian = sp.diags(1 / np.asarray(adjacency.sum(1)).ravel()) @ adjacency - sp.identity(len(v))
    thin_plate = laplacian.T @ laplacian
    control = v.copy()
    for _ in range(12):
        points = sample @ control
        target = surface.closest(points, vertex_normals(points, fine))
        nearest = sample[cKDTree(points).query(surface.v)[1]]
        a = sample.T @ sample + nearest.T @ nearest + smoothness * thin_plate
        control = spla.splu(a.tocsc()).solve(sample.T @ target + nearest.T @ surface.v)
    return control, limit, sample, fine


# ---------------------------------------------------------------- 4: tets

def fill(points, triangles, interior_volume):
    with tempfile.TemporaryDirectory() as folder:
        base = os.path.join(folder, "bunny")
        with open(base + ".poly", "w") as out:
            out.write(f"{len(points)} 3 0 0\n" + "".join(f"{i} {p[0]:.17g} {p[1]:.17g} {p[2]:.17g}\n" for i, p in enumerate(points)))
            out.write(f"{len(triangles)} 0\n" + "".join(f"1\n3 {f[0]} {f[1]} {f[2]}\n" for f in triangles) + "0\n0\n")
        subprocess.run(["tetgen", f"-pYq1.3/12a{interior_volume}Q", base + ".poly"], check=True)
        node = [line.split() for line in open(base + ".1.node") if not line.startswith("#")]
        ele = [line.split() for line in open(base + ".1.ele") if not line.startswith("#")]
    new_points = np.array([[float(w) for w in row[1:4]] for row in node[1:] if row])
    tets = np.array([[int(w) for w in row[1:5]] for row in ele[1:] if row])
    return new_points, tets


def volumes(p, t):
    return np.linalg.det(p[t[:, 1:]] - p[t[:, :1]]) / 6


def shape(p, t):
    """Mean-ratio quality of tets: 1 for the regular one, 0 for a flat one, negative if inverted."""
    squares = sum(np.sum((p[t[:, i]] - p[t[:, j]]) ** 2, axis=1) for i in range(4) for j in range(i))
    volume = volumes(p, t)
    return np.sign(volume) * 12 * (3 * np.abs(volume)) ** (2 / 3) / squares


def improve_interior(p, t, n_fixed):
    """Moves each interior vertex to the best of a few places, by the worst shape of its tets. Fixed pseudo-random steps."""
    rng = np.random.default_rng(1)
    around = [np.nonzero((t == v).any(1))[0] for v in range(len(p))]
    neighbours = [np.setdiff1d(np.unique(t[a]), [v]) for v, a in enumerate(around)]
    for round_ in range(60):
        radius = 0.3 * 0.93 ** round_
        for v in range(n_fixed, len(p)):
            worst = np.sort(shape(p, t[around[v]]))[:3].mean()
            old = p[v].copy()
            centre = p[neighbours[v]].mean(0)
            for candidate in [old + 0.3 * (centre - old)] + list(old + radius * rng.standard_normal((4, 3))):
                before = p[v].copy()
                p[v] = candidate
                new = np.sort(shape(p, t[around[v]]))[:3].mean()
                if new > worst:
                    worst = new
                else:
                    p[v] = before
    return p


def edge_rings(t):
    """The tets around every edge."""
    around = {}
    for i, tet in enumerate(t.tolist()):
        for a in range(4):
            for b in range(a):
                around.setdefault((min(tet[a], tet[b]), max(tet[a], tet[b])), []).append(i)
    return around


def boundary_of(t):
    """Triangles in one tet, counterclockwise from outside."""
    faces = {}
    for tet in t:
        for local in ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)):
            face = tuple(int(x) for x in tet[list(local)])
            faces.setdefault(tuple(sorted(face)), []).append(face)
    return np.array([f[0] for f in faces.values() if len(f) == 1])


def remove_thin_edges(p, t, worst=0.12):
    """Flips the three tets around an inner edge into two where that keeps a decent shape."""
    on_boundary = {tuple(sorted((f[i], f[i - 1]))) for f in boundary_of(t).tolist() for i in range(3)}
    flips = 0
    while True:
        for (a, b), ring in sorted(edge_rings(t).items()):
            if len(ring) != 3 or (a, b) in on_boundary:
                continue
            link = sorted({x for i in ring for x in t[i].tolist()} - {a, b})
            if len(link) != 3:
                continue
            new = np.array([link + [a], link + [b]])
            for tet in new:
                if volumes(p, tet[None])[0] < 0:
                    tet[[2, 3]] = tet[[3, 2]]
            old = volumes(p, t[ring]).sum()
            if shape(p, new).min() < worst or abs(volumes(p, new).sum() - old) > 1e-9 * old:
                continue
            t = np.vstack([np.delete(t, ring, axis=0), new])
            flips += 1
            break
        else:
            return t, flips


# ---------------------------------------------------------------- 5: no folds after refinement

def box_spline_level_1(n, n_boundary, t, surface):
    """The box-spline points of level 1 as a sparse matrix (the first n_boundary vertices are the boundary's), and the number
    of each edge's point. They do not depend on the diagonals, which only join them."""
    rings = edge_rings(t)
    edge = {e: n + i for i, e in enumerate(rings)}
    loop = loop_matrix(n_boundary, surface)[0]
    loop_edge = {}
    for f in surface.tolist():
        for i in range(3):
            loop_edge.setdefault(tuple(sorted((f[i], f[(i + 1) % 3]))), n_boundary + len(loop_edge))
    rows = []

    def copy(row, loop_row):
        span = slice(loop.indptr[loop_row], loop.indptr[loop_row + 1])
        rows.extend((row, j, w) for j, w in zip(loop.indices[span], loop.data[span]))

    neighbours = [[] for _ in range(n)]
    for a, b in edge:
        neighbours[a].append(b)
        neighbours[b].append(a)
    for v in range(n):
        if v < n_boundary:
            copy(v, v)
        else:
            rows += [(v, v, 18 / 32)] + [(v, x, 14 / 32 / len(neighbours[v])) for x in neighbours[v]]
    for (a, b), e in edge.items():
        if (a, b) in loop_edge:
            copy(e, loop_edge[(a, b)])
            continue
        link = sorted({x for i in rings[(a, b)] for x in t[i].tolist()} - {a, b})
        ends, rest = (8 / 32, 16 / 32) if len(link) == 4 else (10 / 32, 12 / 32)
        rows += [(e, a, ends), (e, b, ends)] + [(e, x, rest / len(link)) for x in link]
    i, j, w = zip(*rows)
    return sp.csr_matrix((w, (i, j)), (n + len(edge), n)), edge


def children(t, edge):
    """Tets of level 1, all parents' first children first, then their second..: the four corners, and the inner octahedron
    in quarters around each of its three diagonals."""
    def middle(a, b):
        return np.array([edge[(min(x, y), max(x, y))] for x, y in zip(t[:, a].tolist(), t[:, b].tolist())])

    m01, m02, m03, m12, m13, m23 = [middle(a, b) for a, b in ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3))]
    v = t.T
    kinds = [(v[0], m01, m02, m03), (m01, v[1], m12, m13), (m02, m12, v[2], m23), (m03, m13, m23, v[3])]
    for o in ((m01, m23, m02, m13, m03, m12), (m02, m13, m03, m12, m01, m23), (m03, m12, m01, m23, m02, m13)):
        kinds += [(o[0], o[1], o[2], o[4]), (o[0], o[1], o[4], o[3]), (o[0], o[1], o[3], o[5]), (o[0], o[1], o[5], o[2])]
    return np.concatenate([np.stack(kind, axis=1) for kind in kinds])


def unfold(p, t, n_boundary, surface, least=0.35, stay=0.3):
    """Moves points until every child has about the share `least` of its even part of the parent, staying near `p`."""
    matrix, edge = box_spline_level_1(len(p), n_boundary, t, surface)
    kids = children(t, edge)
    even = np.tile(volumes(p, t) / 8, len(kids) // len(t))

    def cost(x):
        q, moved = matrix @ x.reshape(-1, 3), x.reshape(-1, 3) - p
        a = q[kids[:, 0]]
        b, c, d = (q[kids[:, i]] - a for i in (1, 2, 3))
        normals = np.cross(c, d), np.cross(d, b), np.cross(b, c)
        gap = np.maximum(0, least - np.einsum("ij,ij->i", b, normals[0]) / 6 / even)
        slope = (-2 * gap / even / 6)[:, None]
        gradient = np.zeros_like(q)
        for i in (1, 2, 3):
            np.add.at(gradient, kids[:, i], slope * normals[i - 1])
        np.add.at(gradient, kids[:, 0], -slope * sum(normals))
        return gap @ gap + stay * np.sum(moved ** 2), (matrix.T @ gradient + 2 * stay * moved).ravel()

    before = volumes(matrix @ p, kids) / even
    p = scipy.optimize.minimize(cost, p.ravel(), jac=True, method="L-BFGS-B", options={"maxiter": 400}).x.reshape(-1, 3)
    after = volumes(matrix @ p, kids) / even
    print(f"smallest share of a child: {before.min():.3f} before, {after.min():.3f} after unfolding")
    assert after.min() > 0
    return p


# ---------------------------------------------------------------- all of it

def check(points, tets, n_boundary):
    assert (volumes(points, tets) > 0).all()
    faces = {}
    for tet in tets:
        for i in range(4):
            key = tuple(sorted(np.delete(tet, i)))
            faces[key] = faces.get(key, 0) + 1
    boundary = [f for f, n in faces.items() if n == 1]
    edges = {}
    for f in boundary:
        for i in range(3):
            key = (f[i - 1], f[i]) if f[i - 1] < f[i] else (f[i], f[i - 1])
            edges[key] = edges.get(key, 0) + 1
    assert set(edges.values()) == {2}, "the boundary is not a manifold"
    on_boundary = {x for f in boundary for x in f}
    assert on_boundary == set(range(n_boundary))
    assert len(on_boundary) - len(edges) + len(boundary) == 2, "the boundary is not one sphere"
    return len(boundary)


def report(control, limit, sample, fine, scan):
    for name, matrix in (("limit surface", sample), ("limits of the control vertices", limit)):
        points = matrix @ control
        distance = np.linalg.norm(scan.closest(points) - points, axis=1)
        print(f"{name} to scan: mean {distance.mean():.4f}, largest {distance.max():.4f}")
    points = sample @ control
    distance = np.linalg.norm(Surface(points, fine).closest(scan.v, k=60) - scan.v, axis=1)
    print(f"scan to limit surface: mean {distance.mean():.4f}, largest {distance.max():.4f}")


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: make_bunny_lattice.py bunny.obj bunny_lattice.vtu")
    source, target = sys.argv[1], sys.argv[2]
    v0, t0 = read_obj(source)
    scan = Surface(v0, t0)
    v, t = decimate(v0, t0, BOUNDARY_VERTICES)
    for _ in range(10):
        t, flips = flip_edges(v, t)
        v = relax(v, t, scan)
    print(f"control surface: {len(v)} vertices, {len(t)} triangles, valences",
          np.bincount(np.bincount(t.ravel(), minlength=len(v))).tolist())

    control, limit, sample, fine = fit(v, t, scan, 0.3)
    for _ in range(4):  # the control vertices' own limit positions onto the scan
        points = limit @ control
        control += scan.closest(points, vertex_normals(points, t)) - points
    report(control, limit, sample, fine, scan)
    control = np.round(control, 5)

    points, tets = fill(control, t, INTERIOR_VOLUME)
    if volumes(points, tets).mean() < 0:
        tets = tets[:, [0, 1, 3, 2]]
    assert np.array_equal(points[: len(control)], control), "tetgen moved the boundary"
    tets, flips = remove_thin_edges(points, tets)
    points = improve_interior(points, tets, len(control))
    around = np.bincount([len(ring) for ring in edge_rings(tets).values()])
    print(f"{flips} flips; edges by number of tets around them: {around.tolist()}")
    points = np.round(unfold(points, tets, len(control), t), 5)
    control = points[: len(control)]
    n_faces = check(points, tets, len(control))
    report(control, limit, sample, fine, scan)

    depth = np.linalg.norm(Surface(control, t).closest(points, k=60) - points, axis=1)
    density = 1 + 2 * np.clip(depth / depth.max(), 0, 1) ** 0.75
    quality = shape(points, tets)
    print(f"lattice: {len(points)} control points ({len(control)} on the boundary), {len(tets)} tets, {n_faces} boundary faces, "
          f"volume {volumes(points, tets).sum():.2f}, shape min {quality.min():.3f} mean {quality.mean():.3f}")
    write_vtu(target, points, tets, {"density": density})


if __name__ == "__main__":
    main()
