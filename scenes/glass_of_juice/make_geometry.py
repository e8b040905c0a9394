"""Writes the three boundaries of a glass of juice, glass.ply, inside.ply and surface.ply, into the folder given (default: beside this script).

Lengths are centimetres. Each boundary is a surface of revolution around y, given by its profile and the normals along it; the three meet in one ring, at the juice's level on the inner wall, and the two that
bound the juice close it together. Numbers are rounded to 1e-6, so that every machine writes the same bytes.
"""
import math
import sys
from pathlib import Path

AROUND = 96
OUTER, INNER = (2.8, 3.5), (2.5, 3.2)       # radii at the foot and at the rim
FOOT, FLOOR, LEVEL, RIM = 0.03125, 0.8, 8.6, 10.5   # heights: underside, inside of the base, juice, rim


def radius(wall, y):
    return wall[0] + (wall[1] - wall[0]) * (y - FOOT) / (RIM - FOOT)


def slanted(wall):
    """Outward normal of a wall that widens upwards, as (away from the axis, up)."""
    run, rise = RIM - FOOT, wall[1] - wall[0]
    length = math.hypot(run, rise)
    return run / length, -rise / length


def turned_over(normal):
    return -normal[0], -normal[1]


UP, DOWN = (0.0, 1.0), (0.0, -1.0)


def band(a, b, normal):
    """A profile's piece from a to b, both (radius, height), with one normal along it."""
    return a, b, normal


GLASS = (band((0.0, FOOT), (OUTER[0], FOOT), DOWN),
         band((OUTER[0], FOOT), (OUTER[1], RIM), slanted(OUTER)),
         band((OUTER[1], RIM), (INNER[1], RIM), UP),
         band((INNER[1], RIM), (radius(INNER, LEVEL), LEVEL), turned_over(slanted(INNER))))
INSIDE = (band((0.0, FLOOR), (radius(INNER, FLOOR), FLOOR), DOWN),
          band((radius(INNER, FLOOR), FLOOR), (radius(INNER, LEVEL), LEVEL), slanted(INNER)))
SURFACE = (band((radius(INNER, LEVEL), LEVEL), (0.0, LEVEL), UP),)


def number(value):
    return "%.6f" % (round(value * 1e6) / 1e6 + 0.0)


def ring(point, normal):
    for i in range(AROUND):
        c, s = math.cos(2 * math.pi * i / AROUND), math.sin(2 * math.pi * i / AROUND)
        yield " ".join(number(x) for x in (point[0] * c, point[1], point[0] * s, normal[0] * c, normal[1], normal[0] * s))


def ply(bands):
    vertices, triangles = [], []
    for a, b, normal in bands:
        first = len(vertices)
        vertices += list(ring(a, normal)) + list(ring(b, normal))
        for i in range(AROUND):
            j = (i + 1) % AROUND
            low, high, low_next, high_next = first + i, first + AROUND + i, first + j, first + AROUND + j
            if a[0] > 0:
                triangles.append((low, high, low_next))
            if b[0] > 0:
                triangles.append((low_next, high, high_next))
    header = ["ply", "format ascii 1.0", "comment written by make_geometry.py", f"element vertex {len(vertices)}"]
    header += [f"property float {name}" for name in ("x", "y", "z", "nx", "ny", "nz")]
    header += [f"element face {len(triangles)}", "property list uchar int vertex_indices", "end_header"]
    return "\n".join(header + vertices + ["3 %d %d %d" % t for t in triangles]) + "\n"


if __name__ == "__main__":
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    for name, bands in (("glass", GLASS), ("inside", INSIDE), ("surface", SURFACE)):
        (folder / f"{name}.ply").write_text(ply(bands), newline="\n")
