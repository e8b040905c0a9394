"""Writes the juice, glass.obj, into the folder given (default: beside this script).

A tapered prism with 46 sides and two caps, closed and convex; lengths are centimetres. Its corners lie on a lattice that binary floating point holds
exactly and its two rings are multiples of one polygon, so the two triangles of each side lie in one plane to the last bit: 48 planes in all.
"""
import math
import sys
from pathlib import Path

SIDES = 46
LATTICE = 4096                          # steps per unit of the polygon that both rings are multiples of
BOTTOM, TOP = 0.03125, 9.5              # just above the table, so that the two surfaces do not coincide
BOTTOM_RADIUS, TOP_RADIUS = 2.75, 3.5


def ring(radius, height):
    angles = [2 * math.pi * i / SIDES for i in range(SIDES)]
    unit = [(round(LATTICE * math.cos(a)) / LATTICE, round(LATTICE * math.sin(a)) / LATTICE) for a in angles]
    return [(radius * x, height, radius * z) for x, z in unit]


def sides_and_caps():
    triangles = []
    for i in range(SIDES):
        j = (i + 1) % SIDES
        triangles += [(i, SIDES + i, SIDES + j), (i, SIDES + j, j)]
    for i in range(1, SIDES - 1):
        triangles += [(0, i, i + 1), (SIDES, SIDES + i + 1, SIDES + i)]
    return triangles


def glass_obj():
    lines = ["# written by make_geometry.py"]
    lines += ["v %.17g %.17g %.17g" % tuple(x + 0.0 for x in v) for v in ring(BOTTOM_RADIUS, BOTTOM) + ring(TOP_RADIUS, TOP)]
    lines += ["f %d %d %d" % tuple(i + 1 for i in t) for t in sides_and_caps()]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    (folder / "glass.obj").write_text(glass_obj(), newline="\n")
