# SPDX-License-Identifier: Apache-2.0
"""A scan as a target to project on, and a coarse, even mesh of it: steps 1 and 2 of make_bunny_lattice.py."""
import heapq

import numpy as np
from scipy.spatial import cKDTree

LONGEST_EDGE = 1.9  # the bunny is about 10 units across


# ---------------------------------------------------------------- the scan as a target

def closest_on_triangles(p, a, b, c):
    """Closest point to p on triangle (a, b, c), row by row."""
    ab, ac, ap = b - a, c - a, p - a
    dot = lambda u, v: np.einsum("ij,ij->i", u, v)
    d1, d2, d11, d12, d22 = dot(ab, ap), dot(ac, ap), dot(ab, ab), dot(ab, ac), dot(ac, ac)
    det = d11 * d22 - d12 * d12
    v, w = (d22 * d1 - d12 * d2) / det, (d11 * d2 - d12 * d1) / det
    best = a + v[:, None] * ab + w[:, None] * ac
    inside = (v >= 0) & (w >= 0) & (v + w <= 1)
    distance = np.where(inside, dot(p - best, p - best), np.inf)
    for s, e in ((a, b), (b, c), (c, a)):
        t = np.clip(dot(p - s, e - s) / dot(e - s, e - s), 0, 1)
        q = s + t[:, None] * (e - s)
        d = dot(p - q, p - q)
        best[d < distance] = q[d < distance]
        distance = np.minimum(distance, d)
    return best, distance


class Surface:
    """A triangle mesh that answers closest-point queries; normals choose between the two sides of thin parts (ears)."""

    def __init__(self, vertices, triangles):
        self.v, self.t = vertices, triangles
        n = np.cross(vertices[triangles[:, 1]] - vertices[triangles[:, 0]], vertices[triangles[:, 2]] - vertices[triangles[:, 0]])
        self.n = n / np.linalg.norm(n, axis=1)[:, None]
        self.tree = cKDTree(vertices[triangles].mean(1))

    def closest(self, points, normals=None, k=40):
        _, near = self.tree.query(points, k=k)
        best, best_d = np.zeros_like(points), np.full(len(points), np.inf)
        for j in range(k):
            t = self.t[near[:, j]]
            q, d = closest_on_triangles(points, self.v[t[:, 0]], self.v[t[:, 1]], self.v[t[:, 2]])
            if normals is not None:  # the far side of an ear is not a candidate
                d = np.where(np.einsum("ij,ij->i", self.n[near[:, j]], normals) < 0.2, d + 1e3, d)
            best[d < best_d] = q[d < best_d]
            best_d = np.minimum(best_d, d)
        return best


def vertex_normals(v, t):
    face = np.cross(v[t[:, 1]] - v[t[:, 0]], v[t[:, 2]] - v[t[:, 0]])
    n = np.zeros_like(v)
    for i in range(3):
        np.add.at(n, t[:, i], face)
    return n / np.linalg.norm(n, axis=1)[:, None]


# ---------------------------------------------------------------- 1: decimation

class Triangles:
    """Editable triangle mesh: faces by number, and the faces around each vertex."""

    def __init__(self, v, t):
        self.p = [np.array(x) for x in v]
        self.f = {i: tuple(map(int, x)) for i, x in enumerate(t)}
        self.around = [set() for _ in v]
        for i, face in self.f.items():
            for x in face:
                self.around[x].add(i)

    def ring(self, v):
        return {x for f in self.around[v] for x in self.f[f]} - {v}

    def normal(self, face, moved=None, to=None):
        a, b, c = (to if x in (moved or ()) else self.p[x] for x in face)
        return np.cross(b - a, c - a)

    def arrays(self):
        used = sorted({x for face in self.f.values() for x in face})
        new = {x: i for i, x in enumerate(used)}
        return np.array([self.p[x] for x in used]), np.array([[new[x] for x in self.f[i]] for i in sorted(self.f)])


def decimate(v, t, target):
    mesh = Triangles(v, t)
    quadric = [np.zeros((4, 4)) for _ in v]
    for face in mesh.f.values():
        n = mesh.normal(face)
        area = np.linalg.norm(n)
        plane = np.append(n / area, -np.dot(n / area, mesh.p[face[0]]))
        for x in face:
            quadric[x] += area * np.outer(plane, plane)
    for i, p in enumerate(mesh.p):  # a little pull to the old place keeps flat parts evenly sampled
        pull = np.eye(4)
        pull[:3, 3] = pull[3, :3] = -p
        pull[3, 3] = p @ p
        quadric[i] += 2e-3 * pull

    def plan(a, b):
        q = quadric[a] + quadric[b]
        x = np.linalg.solve(q[:3, :3], -q[:3, 3])
        h = np.append(x, 1)
        return max(0.0, h @ q @ h) + 2e-3 * np.sum((mesh.p[a] - mesh.p[b]) ** 2), x

    def allowed(a, b, x):
        ring_a, ring_b = mesh.ring(a), mesh.ring(b)
        if len(ring_a & ring_b) != 2 or len(ring_a | ring_b) - 2 > 8:
            return False  # not manifold afterwards, or a vertex of valence over 8
        if any(len(mesh.ring(c)) <= 4 for c in ring_a & ring_b):
            return False  # would leave a vertex of valence 3
        if max(np.linalg.norm(mesh.p[r] - x) for r in (ring_a | ring_b) - {a, b}) > LONGEST_EDGE:
            return False
        for f in mesh.around[a] ^ mesh.around[b]:
            old, new = mesh.normal(mesh.f[f]), mesh.normal(mesh.f[f], (a, b), x)
            if old @ new < 0.3 * np.linalg.norm(old) * np.linalg.norm(new):
                return False
        return True

    version = [0] * len(v)
    heap = []
    def push(a, b):
        heapq.heappush(heap, (plan(a, b)[0], a, b, version[a], version[b]))
    for a in range(len(v)):
        for b in mesh.ring(a):
            if a < b:
                push(a, b)
    count = len(v)
    while count > target and heap:
        _, a, b, va, vb = heapq.heappop(heap)
        if version[a] != va or version[b] != vb or not mesh.around[a] or not mesh.around[b]:
            continue
        x = plan(a, b)[1]
        if not allowed(a, b, x):
            continue
        for f in list(mesh.around[a] & mesh.around[b]):
            for w in mesh.f.pop(f):
                mesh.around[w].discard(f)
        for f in mesh.around[b]:
            mesh.f[f] = tuple(a if w == b else w for w in mesh.f[f])
            mesh.around[a].add(f)
        mesh.around[b] = set()
        mesh.p[a] = x
        quadric[a] = quadric[a] + quadric[b]
        version[a] += 1
        count -= 1
        for w in mesh.ring(a):
            push(min(a, w), max(a, w))
    return mesh.arrays()


# ---------------------------------------------------------------- 2: evening out

def flip_edges(v, t):
    """Flips edges where that brings valences nearer to 6 or makes flat pairs Delaunay, and hardly changes the shape."""
    mesh = Triangles(v, t)
    edges = sorted({tuple(sorted((f[i], f[(i + 1) % 3]))) for f in mesh.f.values() for i in range(3)})
    flips = 0
    for a, b in edges:
        both = mesh.around[a] & mesh.around[b]
        if len(both) != 2:
            continue
        f, g = sorted(both)
        while set(mesh.f[f][:2]) != {a, b}:
            mesh.f[f] = mesh.f[f][1:] + mesh.f[f][:1]
        a, b, c = mesh.f[f]
        d = next(x for x in mesh.f[g] if x not in (a, b))
        if d in mesh.ring(c):
            continue
        size = {x: len(mesh.ring(x)) for x in (a, b, c, d)}
        if size[a] <= 4 or size[b] <= 4:
            continue
        score = lambda s: sum((s[x] - 6) ** 2 for x in s)
        after = {a: size[a] - 1, b: size[b] - 1, c: size[c] + 1, d: size[d] + 1}
        n1, n2 = mesh.normal((c, a, d)), mesh.normal((c, d, b))
        o1, o2 = mesh.normal(mesh.f[f]), mesh.normal(mesh.f[g])
        unit = lambda n: n / (np.linalg.norm(n) + 1e-30)
        if unit(o1) @ unit(o2) < 0.8 or min(unit(n) @ unit(o1 + o2) for n in (n1, n2)) < 0.8:
            continue  # an edge that carries shape stays
        ratio = np.linalg.norm(mesh.p[c] - mesh.p[d]) / np.linalg.norm(mesh.p[a] - mesh.p[b])
        if score(after) + 4 * (ratio - 1) >= score(size):
            continue
        mesh.f[f], mesh.f[g] = (c, a, d), (c, d, b)
        mesh.around[a].discard(g), mesh.around[b].discard(f)
        mesh.around[c].add(g), mesh.around[d].add(f)
        flips += 1
    return mesh.arrays()[1], flips


def relax(v, t, surface, amount=0.5):
    edges = np.vstack([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]])
    mean, count = np.zeros_like(v), np.zeros(len(v))
    np.add.at(mean, edges[:, 0], v[edges[:, 1]])
    np.add.at(count, edges[:, 0], 1)
    n = vertex_normals(v, t)
    step = mean / count[:, None] - v
    step -= np.einsum("ij,ij->i", step, n)[:, None] * n
    return surface.closest(v + amount * step, n)
