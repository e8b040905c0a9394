"""Reads the images that Tyndall writes: OpenEXR, scan lines, ZIP or no compression, 32-bit or 16-bit floats. Nothing but Python's own library."""
import array
import struct
import sys
import zlib

ZIP_ROWS = {0: 1, 2: 1, 3: 16}  # rows in a block by compression: none, ZIPS, ZIP


def text(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode("latin-1"), end + 1


def header_of(data, name):
    if data[:4] != b"\x76\x2f\x31\x01":
        raise ValueError(f"{name} is not an OpenEXR file")
    at, attributes = 8, {}
    while data[at]:
        key, at = text(data, at)
        _, at = text(data, at)
        size, = struct.unpack_from("<i", data, at)
        attributes[key] = data[at + 4:at + 4 + size]
        at += 4 + size
    return attributes, at + 1


def channels_of(packed):
    """Names and kinds (1: half, 2: float), in the order in which a row holds them."""
    at, channels = 0, []
    while packed[at]:
        name, at = text(packed, at)
        channels.append((name, struct.unpack_from("<i", packed, at)[0]))
        at += 16
    return channels


def unpacked(block, size, compression):
    """Undoes zlib, the differences of neighbouring bytes, and the split into odd and even bytes."""
    if compression == 0 or len(block) == size:
        return block
    coded = bytearray(zlib.decompress(block))
    last = coded[0]
    for i in range(1, len(coded)):
        last = (last + coded[i] - 128) & 255
        coded[i] = last
    half = (len(coded) + 1) // 2
    plain = bytearray(len(coded))
    plain[0::2], plain[1::2] = coded[:half], coded[half:]
    return bytes(plain)


def floats(data, kind):
    if kind == 2:
        values = array.array("f")
        values.frombytes(data)
        if sys.byteorder == "big":
            values.byteswap()
        return values
    return array.array("f", (v[0] for v in struct.iter_unpack("<e", data)))


def read(file, wanted):
    """(width, height, {channel: floats, top row first}) of the channels of `wanted` that the image has."""
    with open(file, "rb") as stream:
        data = stream.read()
    attributes, at = header_of(data, file)
    x0, y0, x1, y1 = struct.unpack("<4i", attributes["dataWindow"])
    width, height, compression = x1 - x0 + 1, y1 - y0 + 1, attributes["compression"][0]
    if compression not in ZIP_ROWS:
        raise ValueError(f"{file} is compressed by method {compression}; ZIP or none is read")
    channels, rows = channels_of(attributes["channels"]), ZIP_ROWS[compression]
    row_bytes = sum(width * (4 if kind == 2 else 2) for _, kind in channels)
    planes = {name: array.array("f") for name, _ in channels if name in wanted}
    for offset in struct.unpack_from(f"<{-(-height // rows)}Q", data, at):
        y, size = struct.unpack_from("<2i", data, offset)
        count = min(rows, y1 + 1 - y)
        block, place = unpacked(data[offset + 8:offset + 8 + size], row_bytes * count, compression), 0
        for _ in range(count):
            for name, kind in channels:
                end = place + width * (4 if kind == 2 else 2)
                if name in planes:
                    planes[name].extend(floats(block[place:end], kind))
                place = end
    return width, height, planes
