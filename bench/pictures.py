"""Reading PNG files and raw pictures, and comparing them, with the standard library alone."""

import struct
import zlib
from concurrent.futures import ProcessPoolExecutor

LEVELS = 2  # a pixel differs if a channel does by more than this


def apart(of, *arguments):
    """What a function gives, from a process of its own, since it needs much memory. See measure.measured."""
    with ProcessPoolExecutor(1) as pool:
        return pool.submit(of, *arguments).result()


def png_rows(path):
    """Width, channels and rows of a PNG file of 8-bit RGB or RGBA, not interlaced."""
    data = path.read_bytes()
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise ValueError(f"{path}: not a PNG file")
    place, packed = 8, []
    width = height = channels = 0
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place : place + 8])
        body = data[place + 8 : place + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", body)
            if depth != 8 or colour not in (2, 6) or interlaced:
                raise ValueError(f"{path}: not a picture of 8-bit RGB or RGBA")
            channels = 3 if colour == 2 else 4
        elif kind == b"IDAT":
            packed.append(body)
        place += 12 + length
    raw = zlib.decompress(b"".join(packed))
    stride = width * channels
    above = bytes(stride)
    rows = []
    for y in range(height):
        start = y * (stride + 1)
        above = unfiltered(raw[start], raw[start + 1 : start + 1 + stride], above, channels)
        rows.append(above)
    return width, channels, rows


def unfiltered(kind, line, above, channels):
    """A row of a PNG file as it was before filtering (PNG specification, section 9)."""
    if kind == 0:
        return line
    if kind == 2 and not any(line):
        return above
    row = bytearray(line)
    for i, value in enumerate(line):
        left = row[i - channels] if i >= channels else 0
        if kind == 1:
            guess = left
        elif kind == 2:
            guess = above[i]
        elif kind == 3:
            guess = (left + above[i]) // 2
        else:
            guess = paeth(left, above[i], above[i - channels] if i >= channels else 0)
        row[i] = (value + guess) & 255
    return bytes(row)


def paeth(left, up, corner):
    guess = left + up - corner
    if abs(guess - left) <= abs(guess - up) and abs(guess - left) <= abs(guess - corner):
        return left
    return up if abs(guess - up) <= abs(guess - corner) else corner


def raw_rows(path, width):
    """The same of a file of nothing but 8-bit RGBA, so wide."""
    data, stride = path.read_bytes(), 4 * width
    if len(data) % stride:
        raise ValueError(f"{path}: not a picture of {width} columns")
    return width, 4, [data[place : place + stride] for place in range(0, len(data), stride)]


def differing(a, b):
    """How many pixels there are, and how many of them differ by more than LEVELS. Alpha is not compared.

    Both are PNG files, or the second is raw RGBA, of the first one's width.
    """
    width, channels_a, rows_a = png_rows(a)
    width_b, channels_b, rows_b = raw_rows(b, width) if b.suffix == ".rgba" else png_rows(b)
    if width != width_b or len(rows_a) != len(rows_b):
        raise ValueError(f"{a} and {b} are of different sizes")
    count = 0
    for row_a, row_b in zip(rows_a, rows_b):
        planes = [(row_a[c::channels_a], row_b[c::channels_b]) for c in range(3)]
        places = set()
        for plane_a, plane_b in planes:
            if plane_a != plane_b:
                places.update(x for x, (p, q) in enumerate(zip(plane_a, plane_b)) if abs(p - q) > LEVELS)
        count += len(places)
    return width * len(rows_a), count


def coloured(path):
    """How many pixels are not black. Alpha is not looked at."""
    _, channels, rows = png_rows(path)
    return sum(any(pixel) for row in rows for pixel in zip(*(row[c::channels] for c in range(3))))
