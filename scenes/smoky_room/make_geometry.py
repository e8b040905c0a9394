"""Writes the smoke, smoke.vol, and what stands in the room, furniture.ply, blinds.ply and frame.ply, into the folder given (default: beside this script).

Lengths are metres; the room is 5 wide (x), 2.8 high (y) and 4.5 deep (z). The smoke is value noise in layers, denser below the ceiling and above the table, where it rises from: Mitsuba's .vol, version
3, one channel of floats, x fastest. All arithmetic is on whole numbers and products of doubles, rounded to twelve bits, so that every machine writes the same bytes.
"""
import struct
import sys
from pathlib import Path

SIZE = (40, 24, 36)                      # voxels along x, y (upwards) and z
LOW, HIGH = (-2.4925, 0.008, -2.242), (2.3075, 2.792, 2.242)   # a finger's breadth from the walls, a hand's before the blinds
ROOM = (2.5, 2.8, 2.25)                  # half width, height, half depth
OCTAVES = ((1.1, 0.55), (2.3, 0.28), (4.7, 0.17))         # cells per metre, weight
SOURCE = (-0.35, 0.78, -0.45)            # where it rises from: the cup on the table

WINDOW = ((0.75, 2.45), (-1.60, 0.80))   # heights, and extent in z, of the opening in the wall x = 2.5
SLATS, TILT, DEPTH, THIN = 8, -0.25, 0.125, 0.008         # blinds: number, slope (outwards), width, thickness


def hashed(x, y, z):
    """A number in [0, 1) per lattice point."""
    n = (x * 73856093 ^ y * 19349663 ^ z * 83492791) & 0xFFFFFFFF
    for multiplier in (0x7FEB352D, 0x846CA68B):
        n = ((n ^ n >> 16) * multiplier) & 0xFFFFFFFF
    return (n ^ n >> 16) / 2**32


def smooth(t):
    return t * t * (3 - 2 * t)


def value_noise(p, frequency):
    cells = [int(c * frequency // 1) for c in p]
    f = [smooth(c * frequency - i) for c, i in zip(p, cells)]
    total = 0.0
    for corner in range(8):
        weight, at = 1.0, []
        for k in range(3):
            step = corner >> k & 1
            weight *= f[k] if step else 1 - f[k]
            at.append(cells[k] + step)
        total += weight * hashed(*at)
    return total


def density(p):
    """A haze that fills the room, sheets of smoke that drift through it, and the thread that rises from the cup and spreads."""
    x, y, z = p
    drift = sum(w * value_noise((x * 0.7 + 9, y * 1.9 + 4, z * 0.8 + 17), f) for f, w in OCTAVES)
    sheets = max(0.0, drift - 0.44) * 5.5
    height = max(0.0, y - SOURCE[1])
    sway = 0.32 * height * height
    radius = 0.05 + 0.16 * height
    off = ((x - SOURCE[0] + 0.5 * sway) ** 2 + (z - SOURCE[2] - 0.3 * sway) ** 2) / (radius * radius)
    thread = max(0.0, 1 - off) * 3.0 / (1 + 2 * height) if y > SOURCE[1] else 0.0
    return 0.2 + sheets * (0.45 + 0.3 * y) + thread


def smoke_vol():
    middles = [[low + (high - low) * (i + 0.5) / n for i in range(n)] for low, high, n in zip(LOW, HIGH, SIZE)]
    values = [round(density((x, y, z)) * 4096) / 4096 for z in middles[2] for y in middles[1] for x in middles[0]]
    header = b"VOL\x03" + struct.pack("<5i", 1, *SIZE, 1) + struct.pack("<6f", 0, 0, 0, 1, 1, 1)
    return header + struct.pack(f"<{len(values)}f", *values)


class Mesh:
    """Boxes, given by their corners or by an origin and three edges, as triangles that face outwards."""

    def __init__(self):
        self.vertices, self.triangles = [], []

    def block(self, origin, a, b, c):
        first = len(self.vertices)
        for corner in range(8):
            x, y, z = corner >> 2 & 1, corner >> 1 & 1, corner & 1
            self.vertices.append(tuple(o + x * i + y * j + z * k for o, i, j, k in zip(origin, a, b, c)))
        for q in ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)):
            self.triangles += [(first + q[0], first + q[i], first + q[i + 1]) for i in (1, 2)]

    def box(self, low, high):
        size = [h - l for l, h in zip(low, high)]
        self.block(low, (size[0], 0, 0), (0, size[1], 0), (0, 0, size[2]))

    def ply(self):
        header = ["ply", "format ascii 1.0", "comment written by make_geometry.py", f"element vertex {len(self.vertices)}"]
        header += [f"property float {axis}" for axis in "xyz"]
        header += [f"element face {len(self.triangles)}", "property list uchar int vertex_indices", "end_header"]
        return "\n".join(header + ["%.6f %.6f %.6f" % v for v in self.vertices] + ["3 %d %d %d" % t for t in self.triangles]) + "\n"


def legs(mesh, low, high, top, thick):
    for x in (low[0], high[0] - thick):
        for z in (low[1], high[1] - thick):
            mesh.box((x, 0.0, z), (x + thick, top, z + thick))


def furniture():
    """A table, two chairs, a bench below the window, a shelf at the back wall."""
    mesh = Mesh()
    mesh.box((-1.1, 0.70, -0.95), (0.5, 0.74, 0.0))
    legs(mesh, (-1.05, -0.90), (0.45, -0.05), 0.70, 0.06)
    for x, z, back in ((-1.75, -0.75, -1.75), (-0.55, 0.3, None)):
        mesh.box((x, 0.42, z), (x + 0.45, 0.46, z + 0.45))
        legs(mesh, (x, z), (x + 0.45, z + 0.45), 0.42, 0.04)
        if back is not None:
            mesh.box((x, 0.46, z), (x + 0.04, 0.95, z + 0.45))
        else:
            mesh.box((x, 0.46, z + 0.41), (x + 0.45, 0.95, z + 0.45))
    mesh.box((1.85, 0.40, -1.7), (2.30, 0.46, 0.6))
    mesh.box((1.89, 0.0, -1.65), (2.26, 0.40, -1.55))
    mesh.box((1.89, 0.0, 0.45), (2.26, 0.40, 0.55))
    for y in (0.05, 0.55, 1.05, 1.55, 2.0):
        mesh.box((-2.3, y, -2.22), (-1.0, y + 0.03, -1.92))
    for x in (-2.33, -1.0):
        mesh.box((x, 0.0, -2.22), (x + 0.03, 2.03, -1.92))
    # books
    x, n = -2.25, 0
    while x < -1.15:
        for shelf, y in enumerate((0.58, 1.08, 1.58)):
            tall = 0.22 + 0.16 * hashed(n, shelf, 5)
            if hashed(n, shelf, 9) > 0.25:
                mesh.box((x, y, -2.2), (x + 0.045, y + tall, -2.0 + 0.05 * hashed(n, shelf, 7)))
        x, n = x + 0.05, n + 1
    return mesh


def frame():
    """The wall x = 2.5 around the window, thick enough to be closed, and the bars of the window."""
    mesh = Mesh()
    (low, high), (near, far) = WINDOW
    for y0, y1, z0, z1 in ((0.0, low, -ROOM[2], ROOM[2]), (high, ROOM[1], -ROOM[2], ROOM[2]), (low, high, -ROOM[2], near), (low, high, far, ROOM[2])):
        mesh.box((2.5, y0, z0), (2.62, y1, z1))
    middle = 0.5 * (near + far)
    mesh.box((2.54, low, middle - 0.025), (2.6, high, middle + 0.025))
    return mesh


def blinds():
    """Wide slats whose inner edges are the higher ones: nearly half of the sun passes between them."""
    mesh = Mesh()
    (low, high), (near, far) = WINDOW
    for i in range(SLATS):
        y = low + (high - low) * (i + 0.5) / SLATS
        mesh.block((2.46 - DEPTH, y - 0.5 * DEPTH * TILT, near - 0.02), (DEPTH, DEPTH * TILT, 0.0), (-THIN * TILT, THIN, 0.0), (0.0, 0.0, far - near + 0.04))
    return mesh


if __name__ == "__main__":
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    (folder / "smoke.vol").write_bytes(smoke_vol())
    for name, mesh in (("furniture", furniture()), ("frame", frame()), ("blinds", blinds())):
        (folder / f"{name}.ply").write_text(mesh.ply(), newline="\n")
