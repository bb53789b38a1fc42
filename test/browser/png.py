"""Reads PNG files of eight bits a channel, red, green, blue and alpha, not interlaced: the ones that Dioptre writes."""

import struct
import zlib


def pixels(data):
    """Width, height and the bytes of the pixels, four each, row after row."""
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise ValueError("this is no PNG file")
    header, compressed, at = None, b"", 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        body = data[at + 8 : at + 8 + length]
        (checksum,) = struct.unpack(">I", data[at + 8 + length : at + 12 + length])
        if zlib.crc32(kind + body) != checksum:
            raise ValueError(f"the checksum of {kind} is wrong")
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        if kind == b"IDAT":
            compressed += body
        at += 12 + length
    if header is None or header[2:] != (8, 6, 0, 0, 0):
        raise ValueError("this is not a PNG file of four channels of eight bits each")
    width, height = header[:2]
    return width, height, _unfiltered(zlib.decompress(compressed), width, height)


def _unfiltered(raw, width, height):
    """Undoes the filters, one a row: https://www.w3.org/TR/png-3/#9Filters"""
    size = 4 * width
    if len(raw) != height * (size + 1):
        raise ValueError("this PNG file has not as many bytes as its size says")
    rows, above = [], bytes(size)
    for start in range(0, len(raw), size + 1):
        kind, row = raw[start], bytearray(raw[start + 1 : start + 1 + size])
        if kind != 0:
            for k in range(size):
                left, corner = (row[k - 4], above[k - 4]) if k >= 4 else (0, 0)
                row[k] = (row[k] + (left, above[k], (left + above[k]) // 2, _paeth(left, above[k], corner))[kind - 1]) % 256
        above = bytes(row)
        rows.append(above)
    return b"".join(rows)


def _paeth(left, above, corner):
    guess = left + above - corner
    return min((left, above, corner), key=lambda one: abs(guess - one))
