"""Writes the slitted wall, wall.ply, into the folder given (default: beside this script).

Lengths are metres. The wall is a slab at x = WALL from the floor to the ceiling with three level slits cut right through it. It is made of
closed boxes: one for each board between two slits, and a jamb at either end of the slits.
"""
import sys
from pathlib import Path

WALL, THICKNESS = -1.2, 0.05
BOTTOM, TOP = -0.05, 3.05            # a little beyond floor and ceiling, so that no surfaces coincide
BACK, FRONT = -1.65, 4.65
SLITS = ((0.95, 1.05), (1.40, 1.50), (1.85, 1.95))      # heights
SLITS_BACK, SLITS_FRONT = -0.5, 0.5


def boxes():
    """(low, high) corners of the pieces; neighbours share a plane, which no light can reach."""
    x0, x1 = WALL - 0.5 * THICKNESS, WALL + 0.5 * THICKNESS
    pieces = [((x0, BOTTOM, BACK), (x1, TOP, SLITS_BACK)), ((x0, BOTTOM, SLITS_FRONT), (x1, TOP, FRONT))]
    edges = [BOTTOM] + [y for slit in SLITS for y in slit] + [TOP]
    for low, high in zip(edges[0::2], edges[1::2]):
        pieces.append(((x0, low, SLITS_BACK), (x1, high, SLITS_FRONT)))
    return pieces


def box_triangles(first):
    """Twelve outward triangles over corners numbered first + 4 x + 2 y + z."""
    quads = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    return [(first + q[0], first + q[i], first + q[i + 1]) for q in quads for i in (1, 2)]


def wall_ply():
    vertices, triangles = [], []
    for low, high in boxes():
        triangles += box_triangles(len(vertices))
        vertices += [(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]
    header = ["ply", "format ascii 1.0", "comment written by make_geometry.py", f"element vertex {len(vertices)}"]
    header += [f"property float {axis}" for axis in "xyz"]
    header += [f"element face {len(triangles)}", "property list uchar int vertex_indices", "end_header"]
    lines = ["%.6f %.6f %.6f" % v for v in vertices] + ["3 %d %d %d" % t for t in triangles]
    return "\n".join(header + lines) + "\n"


if __name__ == "__main__":
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    (folder / "wall.ply").write_text(wall_ply(), newline="\n")
