"""Reads the two picture formats that thud-play writes, PNG and BMP, by their specifications."""

import struct
import zlib
from collections import Counter
from itertools import accumulate, chain


class Picture:
    """`rows[y][x]` is a pixel's (red, green, blue)."""

    def __init__(self, width, height, rows):
        self.width, self.height, self.rows = width, height, rows

    def pixels(self):
        return chain.from_iterable(self.rows)

    def count_near(self, color, distance):
        """How many pixels differ from `color` by at most `distance`, summed over the channels."""
        return sum(count for pixel, count in Counter(self.pixels()).items()
                   if sum(abs(a - b) for a, b in zip(pixel, color)) <= distance)


def pixel_rows(data, width, height, stride, order):
    rows = []
    for y in range(height):
        line = data[y * stride:y * stride + 3 * width]
        channels = [line[i::3] for i in order]
        rows.append(list(zip(*channels)))
    return rows


def read_png(path):
    """Reads an RGB image without alpha and interlace, and verifies every checksum."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "not a PNG"
    at, packed, kinds = 8, b"", []
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        checksum, = struct.unpack(">I", data[at + 8 + length:at + 12 + length])
        assert checksum == zlib.crc32(kind + body), f"checksum of {kind}"
        if kind == b"IHDR":
            width, height, *rest = struct.unpack(">IIBBBBB", body)
            assert rest == [8, 2, 0, 0, 0], rest
        elif kind == b"IDAT":
            packed += body
        kinds.append(kind)
        at += 12 + length
    assert kinds[0] == b"IHDR" and kinds[-1] == b"IEND", kinds
    raw = zlib.decompress(packed)
    stride = 3 * width + 1
    assert len(raw) == stride * height
    lines = b"".join(unfiltered(raw[y * stride:(y + 1) * stride]) for y in range(height))
    return Picture(width, height, pixel_rows(lines, width, height, 3 * width, (0, 1, 2)))


def unfiltered(line):
    """Undoes the filters none and sub."""
    kind, body = line[0], bytearray(line[1:])
    assert kind in (0, 1), f"filter {kind}"
    if kind == 1:
        for channel in range(3):
            body[channel::3] = bytes(map((0xFF).__and__, accumulate(body[channel::3])))
    return bytes(body)


def read_bmp(path):
    """Reads an image with 24 bits per pixel, uncompressed, with rows from the bottom up."""
    data = path.read_bytes()
    assert data[:2] == b"BM", "not a BMP"
    start, = struct.unpack("<I", data[10:14])
    width, height, _, bits, compression = struct.unpack("<iiHHI", data[18:34])
    assert bits == 24 and compression == 0 and height > 0
    stride = (3 * width + 3) // 4 * 4
    rows = pixel_rows(data[start:], width, height, stride, (2, 1, 0))
    return Picture(width, height, rows[::-1])
