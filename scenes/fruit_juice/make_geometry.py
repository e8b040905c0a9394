"""Writes the juice body, glass.obj, and the studio backdrop, backdrop.ply, into the folder given (default: beside this script).

Lengths are centimetres. The juice is a tapered prism with 46 sides and two caps: closed and convex, 48 planes. The backdrop is a table top that
bends up into a back wall; nothing stands in front of it but the juice, so no straight line between two points of the scene is ever blocked.
"""
import math
import sys
from pathlib import Path

SIDES = 46
BOTTOM, TOP = 0.02, 9.5              # just above the table, so that the two surfaces do not coincide
BOTTOM_RADIUS, TOP_RADIUS = 2.7, 3.5

HALF_WIDTH, FRONT, WALL = 34.0, 26.0, -20.0
BEND_RADIUS, BEND_STEPS = 12.0, 20
WALL_TOP = 30.0


def number(x):
    """Six decimals: far coarser than any machine's sine differs, so the files are the same everywhere."""
    return f"{x + 0.0:.6f}".replace("-0.000000", "0.000000")


def ring(radius, height):
    angles = [2 * math.pi * i / SIDES for i in range(SIDES)]
    return [(radius * math.cos(a), height, radius * math.sin(a)) for a in angles]


def glass_obj():
    vertices = ring(BOTTOM_RADIUS, BOTTOM) + ring(TOP_RADIUS, TOP)
    triangles = []
    for i in range(SIDES):
        j = (i + 1) % SIDES
        triangles += [(i, SIDES + i, SIDES + j), (i, SIDES + j, j)]
    for i in range(1, SIDES - 1):
        triangles += [(0, i, i + 1), (SIDES, SIDES + i + 1, SIDES + i)]
    lines = ["# written by make_geometry.py"]
    lines += ["v " + " ".join(map(number, v)) for v in vertices]
    lines += ["f " + " ".join(str(i + 1) for i in t) for t in triangles]
    return "\n".join(lines) + "\n"


def backdrop_profile():
    """The backdrop in the plane x = 0, from the front edge of the table to the top of the wall, as (y, z)."""
    centre_y, centre_z = BEND_RADIUS, WALL + BEND_RADIUS
    profile = [(0.0, FRONT)]
    for i in range(BEND_STEPS + 1):
        angle = 0.5 * math.pi * i / BEND_STEPS
        profile.append((centre_y - BEND_RADIUS * math.cos(angle), centre_z - BEND_RADIUS * math.sin(angle)))
    return profile + [(WALL_TOP, WALL)]


def backdrop_ply():
    profile = backdrop_profile()
    vertices = [(x, y, z) for y, z in profile for x in (-HALF_WIDTH, HALF_WIDTH)]
    triangles = []
    for i in range(0, 2 * len(profile) - 2, 2):
        triangles += [(i, i + 1, i + 3), (i, i + 3, i + 2)]
    header = ["ply", "format ascii 1.0", "comment written by make_geometry.py", f"element vertex {len(vertices)}"]
    header += [f"property float {axis}" for axis in "xyz"]
    header += [f"element face {len(triangles)}", "property list uchar int vertex_indices", "end_header"]
    lines = [" ".join(map(number, v)) for v in vertices] + ["3 %d %d %d" % t for t in triangles]
    return "\n".join(header + lines) + "\n"


if __name__ == "__main__":
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    (folder / "glass.obj").write_text(glass_obj(), newline="\n")
    (folder / "backdrop.ply").write_text(backdrop_ply(), newline="\n")
