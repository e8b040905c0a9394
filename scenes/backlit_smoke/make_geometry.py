"""Writes the body of smoke, smoke.obj, and the slatted screen behind it, slats.ply, into the folder given (default: beside this script).

Lengths are metres. The smoke fills a cone cut off at both ends, narrow below and wide above; its corners are given to all digits of a double, so that the
triangles of a side share one plane. The screen is a row of upright boards, closed boxes with gaps between them.
"""
import math
import sys
from pathlib import Path

SIDES = 16
BOTTOM, TOP = 0.05, 2.55             # heights
NARROW, WIDE = 0.45, 1.15            # radii
SCREEN, THICKNESS = -1.9, 0.04       # z of the screen's middle, thickness of a board
BOARD, GAP, BOARDS = 0.16, 0.14, 11  # widths, number
HEIGHT = 2.9


def smoke_obj():
    points = []
    for height, radius in ((BOTTOM, NARROW), (TOP, WIDE)):
        points += [(radius * math.cos(2 * math.pi * i / SIDES), height, radius * math.sin(2 * math.pi * i / SIDES)) for i in range(SIDES)]
    faces = [list(range(SIDES)), list(range(2 * SIDES - 1, SIDES - 1, -1))]
    for i in range(SIDES):
        j = (i + 1) % SIDES
        faces.append([i, i + SIDES, j + SIDES, j])
    lines = ["# written by make_geometry.py"] + ["v " + " ".join(repr(round(x, 16) + 0.0) for x in p) for p in points]
    return "\n".join(lines + ["f " + " ".join(str(i + 1) for i in f) for f in faces]) + "\n"


def boards():
    """(low, high) corners; the row is centred on x = 0."""
    width = BOARDS * BOARD + (BOARDS - 1) * GAP
    for i in range(BOARDS):
        x = -0.5 * width + i * (BOARD + GAP)
        yield (x, 0.01, SCREEN - 0.5 * THICKNESS), (x + BOARD, HEIGHT, SCREEN + 0.5 * THICKNESS)


def box_triangles(first):
    """Twelve outward triangles over corners numbered first + 4 x + 2 y + z."""
    quads = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    return [(first + q[0], first + q[i], first + q[i + 1]) for q in quads for i in (1, 2)]


def slats_ply():
    vertices, triangles = [], []
    for low, high in boards():
        triangles += box_triangles(len(vertices))
        vertices += [(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]
    header = ["ply", "format ascii 1.0", "comment written by make_geometry.py", f"element vertex {len(vertices)}"]
    header += [f"property float {axis}" for axis in "xyz"]
    header += [f"element face {len(triangles)}", "property list uchar int vertex_indices", "end_header"]
    lines = ["%.6f %.6f %.6f" % v for v in vertices] + ["3 %d %d %d" % t for t in triangles]
    return "\n".join(header + lines) + "\n"


if __name__ == "__main__":
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    (folder / "smoke.obj").write_text(smoke_obj(), newline="\n")
    (folder / "slats.ply").write_text(slats_ply(), newline="\n")
