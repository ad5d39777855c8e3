#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""cut_head.py BODY.obj HEAD.obj: the head of a standing body, as a scanner sees it: open at the neck, with three holes.

Triangles are kept whose middle is less than 15.7 % of the body's height below its top and near its axis; those around
three places of the skin are taken away again, in radii of 2.1, 1.5 and 1.8 % of that height.
"""
import math
import sys


def read(name):
    vertices, faces = [], []
    with open(name) as file:
        for line in file:
            words = line.split()
            if words[:1] == ["v"]:
                vertices.append(tuple(float(x) for x in words[1:4]))
            elif words[:1] == ["f"]:
                faces.append([int(w.split("/")[0]) - 1 for w in words[1:4]])
    return vertices, faces


def main(body, head):
    vertices, faces = read(body)
    middles = [[sum(vertices[v][k] for v in f) / 3 for k in range(3)] for f in faces]
    low, high = min(v[1] for v in vertices), max(v[1] for v in vertices)
    height = high - low
    kept = [i for i, m in enumerate(middles) if m[1] > high - 0.157 * height and abs(m[0]) < 0.063 * height]
    centre = [sum(middles[i][k] for i in kept) / len(kept) for k in range(3)]
    skin = list(kept)
    for way, radius in (((0, 0, -0.06), 0.021), ((0.048, -0.012, 0), 0.015), ((-0.03, 0.06, 0.03), 0.018)):
        place = [centre[k] + way[k] * height for k in range(3)]
        middle = middles[min(skin, key=lambda i: math.dist(middles[i], place))]
        kept = [i for i in kept if math.dist(middles[i], middle) > radius * height]
    used = sorted({v for i in kept for v in faces[i]})
    number = {v: i + 1 for i, v in enumerate(used)}
    with open(head, "w") as file:
        file.writelines("v %.9g %.9g %.9g\n" % vertices[v] for v in used)
        file.writelines("f %d %d %d\n" % tuple(number[v] for v in faces[i]) for i in kept)


if len(sys.argv) != 3:
    sys.exit(__doc__)
main(*sys.argv[1:])
