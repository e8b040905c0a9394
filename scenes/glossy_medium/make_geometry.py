"""Writes the body of the medium, dodecahedron.obj, into the folder given (default: beside this script).

Lengths are metres. A regular dodecahedron whose corners lie at the distance 1 from the origin, standing on a face. Each face is one polygon of five corners,
given to all digits of a double, so that the triangles of a face share one plane.
"""
import math
import sys
from pathlib import Path

GOLDEN = (1 + math.sqrt(5)) / 2


def corners():
    """The corners of a cube and of three rectangles, on the unit sphere."""
    signs = (-1, 1)
    points = [(x, y, z) for x in signs for y in signs for z in signs]
    for a in signs:
        for b in signs:
            u, v = a / GOLDEN, b * GOLDEN
            points += [(0, u, v), (u, v, 0), (v, 0, u)]
    return [tuple(c / math.sqrt(3) for c in p) for p in points]


def normals():
    """Of the twelve faces: the corners of an icosahedron."""
    length = math.sqrt(1 + GOLDEN * GOLDEN)
    signs = (-1, 1)
    return [n for a in signs for b in signs for n in ((a / length, 0, b * GOLDEN / length), (0, b * GOLDEN / length, a / length), (b * GOLDEN / length, a / length, 0))]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def face(normal, points):
    """Numbers of the five corners farthest along the normal, counter-clockwise seen from outside."""
    five = sorted(range(len(points)), key=lambda i: -dot(points[i], normal))[:5]
    x = points[five[0]]
    y = cross(normal, x)
    return sorted(five, key=lambda i: math.atan2(dot(points[i], y), dot(points[i], x)))


def dodecahedron():
    points = corners()
    faces = [face(n, points) for n in normals()]
    n = normals()[2]                                    # turned about the z axis so that this face points down
    turn = -math.pi / 2 - math.atan2(n[1], n[0])
    c, s = math.cos(turn), math.sin(turn)
    points = [(c * x - s * y, s * x + c * y, z) for x, y, z in points]
    lines = ["# written by make_geometry.py"] + ["v " + " ".join(repr(round(x, 16) + 0.0) for x in p) for p in points]
    return "\n".join(lines + ["f " + " ".join(str(i + 1) for i in f) for f in faces]) + "\n"


if __name__ == "__main__":
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    (folder / "dodecahedron.obj").write_text(dodecahedron(), newline="\n")
