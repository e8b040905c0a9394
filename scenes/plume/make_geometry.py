"""Writes the plume's density, plume.vol, into the folder given (default: beside this script).

A rising column of smoke that widens and is bent by the wind, stirred by value noise of four octaves: Mitsuba's .vol, version 3, one channel of floats, x fastest. All
arithmetic is on whole numbers and products of doubles, rounded to twelve bits, so that every machine writes the same bytes.
"""
import struct
import sys
from pathlib import Path

SIZE = (28, 44, 28)                      # voxels along x, y (upwards) and z
LOW, HIGH = (-0.7, 0.0, -0.7), (0.7, 2.2, 0.7)
OCTAVES = ((3, 0.5), (6, 0.28), (12, 0.15), (24, 0.07))   # cells per unit of length, weight


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
    x, y, z = p
    height = y / HIGH[1]
    centre_x, centre_z = 0.22 * height * height, 0.08 * height * (1 - height)
    radius = 0.14 + 0.34 * height
    swirl = sum(w * (value_noise((x + 7, y * 0.8 + 3, z + 11), f) - 0.5) for f, w in OCTAVES)
    off = ((x - centre_x) ** 2 + (z - centre_z) ** 2) / (radius * radius)
    edge = 1 - off + 2.6 * swirl
    ends = min(1.0, 8 * height) * min(1.0, 5 * (1 - height))
    return max(0.0, edge) * ends * (1.3 - 0.8 * height)


def plume_vol():
    middles = [[low + (high - low) * (i + 0.5) / n for i in range(n)] for low, high, n in zip(LOW, HIGH, SIZE)]
    values = [round(density((x, y, z)) * 4096) / 4096 for z in middles[2] for y in middles[1] for x in middles[0]]
    header = b"VOL\x03" + struct.pack("<5i", 1, *SIZE, 1) + struct.pack("<6f", 0, 0, 0, 1, 1, 1)
    return header + struct.pack(f"<{len(values)}f", *values)


if __name__ == "__main__":
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    (folder / "plume.vol").write_bytes(plume_vol())
