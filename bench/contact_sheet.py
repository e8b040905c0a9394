#!/usr/bin/env python3
"""All frames of an animation on one sheet.

    python3 bench/contact_sheet.py FRAMES -o sheet.png [--columns 6] [--every 1] [--shrink 1] [--exposure 0]

FRAMES is a folder of `tyndall animate`. The images are read, not the pictures, whose brightness is chosen frame by frame: one exposure (in stops) for all, sRGB, clipped. --shrink N averages N x N pixels, --every N
takes every N-th frame. Nothing but Python's own library.
"""
import argparse
import os
import struct
import sys
import zlib

import exr_frames


def encoded(value):
    value = min(max(value, 0.0), 1.0)
    return round(255 * (12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055))


def thumbnail(file, shrink, scale):
    """(width, rows of bytes) of a frame."""
    width, height, planes = exr_frames.read(file, {"R", "G", "B"})
    small, rows = width // shrink, []
    for y in range(height // shrink):
        row = bytearray()
        for x in range(small):
            for channel in "RGB":
                values = [planes[channel][(y * shrink + j) * width + x * shrink + i] for j in range(shrink) for i in range(shrink)]
                row.append(encoded(scale * sum(values) / len(values)))
        rows.append(bytes(row))
    return small, rows


def png(width, rows):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    pixels = zlib.compress(b"".join(b"\0" + row for row in rows), 9)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, len(rows), 8, 2, 0, 0, 0)) + chunk(b"IDAT", pixels) + chunk(b"IEND", b"")


def sheet(files, columns, shrink, scale):
    frames = [thumbnail(file, shrink, scale) for file in files]
    width, height = frames[0][0], len(frames[0][1])
    gap, rows = b"\xff" * 6, []
    for start in range(0, len(frames), columns):
        group = [rows_of for _, rows_of in frames[start:start + columns]] + [[b"\xff" * (3 * width)] * height] * (columns - len(frames[start:start + columns]))
        rows += [gap.join(line) for line in zip(*group)] + [b"\xff" * (3 * (columns * width + 2 * (columns - 1)))] * 2
    return png(columns * width + 2 * (columns - 1), rows[:-2])


def main():
    parser = argparse.ArgumentParser(description="A sheet of an animation's frames.")
    parser.add_argument("frames")
    parser.add_argument("-o", "--output", required=True)
    for name, default in (("columns", 6), ("every", 1), ("shrink", 1)):
        parser.add_argument("--" + name, type=int, default=default)
    parser.add_argument("--exposure", type=float, default=0)
    options = parser.parse_args()
    files = sorted(f for f in os.listdir(options.frames) if f.startswith("frame_") and f.endswith(".exr"))[::options.every]
    if not files:
        sys.exit(f"{options.frames} holds no frame_*.exr")
    with open(options.output, "wb") as out:
        out.write(sheet([os.path.join(options.frames, f) for f in files], options.columns, options.shrink, 2 ** options.exposure))


if __name__ == "__main__":
    main()
