"""Reads the uncompressed scan lines that Blender writes, every channel by its name."""

import struct

import numpy

HALF, FLOAT = 1, 2


def read(path):
    data = open(path, "rb").read()
    header, at = {}, 8
    while data[at]:
        name, at = text(data, at)
        _, at = text(data, at)
        (size,) = struct.unpack_from("<i", data, at)
        header[name] = data[at + 4 : at + 4 + size]
        at += 4 + size
    x0, y0, x1, y1 = struct.unpack("<4i", header["dataWindow"])
    width, height = x1 - x0 + 1, y1 - y0 + 1
    channels, place = [], 0
    while header["channels"][place]:
        name, place = text(header["channels"], place)
        (kind,) = struct.unpack_from("<i", header["channels"], place)
        channels.append((name, {HALF: "<f2", FLOAT: "<f4"}.get(kind, "<u4")))
        place += 16
    row_type = numpy.dtype([(name, kind, width) for name, kind in channels])
    images = {name: numpy.zeros((height, width), numpy.float32) for name, _ in channels}
    for offset in struct.unpack_from(f"<{height}Q", data, at + 1):
        (y,) = struct.unpack_from("<i", data, offset)
        row = numpy.frombuffer(data, row_type, 1, offset + 8)[0]
        for name, _ in channels:
            images[name][y - y0] = row[name]
    return images


def text(data, at):
    end = data.index(0, at)
    return data[at:end].decode(), end + 1
