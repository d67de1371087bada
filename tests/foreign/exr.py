"""Uncompressed OpenEXR files of scan lines, by nothing but struct and numpy: what the OpenEXR file
layout says, so that neither OpenEXR nor OpenImageIO stands between a test and the samples.
https://openexr.com/en/latest/OpenEXRFileLayout.html
"""

import struct

import numpy

UINT, HALF, FLOAT = 0, 1, 2
TYPES = {UINT: "<u4", HALF: "<f2", FLOAT: "<f4"}
MAGIC = b"\x76\x2f\x31\x01"


class Part:
    """Channels of one part: {name: array of rows}; arrays may be subsampled: {name: (2, 2)}."""

    def __init__(self, channels, origin=(0, 0), display=None, attributes=(), sampling=None):
        self.channels = dict(sorted(channels.items()))
        self.sampling = sampling or {}
        self.origin = origin
        self.display = display
        self.attributes = list(attributes)  # (name, type, bytes)

    def size(self):
        name, array = next((n, a) for n, a in self.channels.items()
                           if self.sampling.get(n, (1, 1)) == (1, 1))
        return array.shape[1], array.shape[0]


def text(name, value):
    return name, "string", value.encode()


def texts(name, values):
    return name, "stringvector", b"".join(
        struct.pack("<i", len(v)) + v.encode() for v in values)


def integer(name, value):
    return name, "int", struct.pack("<i", value)


def _type_of(array):
    return {"uint32": UINT, "float16": HALF, "float32": FLOAT}[array.dtype.name]


def _attribute(name, kind, value):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value


def _header(part, several):
    width, height = part.size()
    x, y = part.origin
    data = struct.pack("<4i", x, y, x + width - 1, y + height - 1)
    display = struct.pack("<4i", *part.display) if part.display else data
    channels = b"".join(
        name.encode() + b"\0" + struct.pack("<iB3xii", _type_of(array), 0,
                                            *part.sampling.get(name, (1, 1)))
        for name, array in part.channels.items()) + b"\0"
    header = [("channels", "chlist", channels), ("compression", "compression", b"\0"),
              ("dataWindow", "box2i", data), ("displayWindow", "box2i", display),
              ("lineOrder", "lineOrder", b"\0"),
              ("pixelAspectRatio", "float", struct.pack("<f", 1)),
              ("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0)),
              ("screenWindowWidth", "float", struct.pack("<f", 1))]
    if several:
        header += [("type", "string", b"scanlineimage"), ("chunkCount", "int",
                                                          struct.pack("<i", height))]
    return b"".join(_attribute(*a) for a in header + part.attributes) + b"\0"


def _rows(part):
    """The samples of each row, channel by channel; a subsampled channel is in some rows only."""
    y0 = part.origin[1]
    for row in range(part.size()[1]):
        samples = b""
        for name, array in part.channels.items():
            step = part.sampling.get(name, (1, 1))[1]
            if (y0 + row) % step == 0:
                samples += array[row // step].astype(TYPES[_type_of(array)]).tobytes()
        yield y0 + row, samples


def write(path, *parts):
    """One part as a plain file, several as a multi-part file (their attributes name them)."""
    several = len(parts) > 1
    version = 2 | (0x1000 if several else 0)
    if any(len(n) > 31 for p in parts for n in [*p.channels, *(a[0] for a in p.attributes)]):
        version |= 0x400
    start = MAGIC + struct.pack("<i", version)
    start += b"".join(_header(part, several) for part in parts) + (b"\0" if several else b"")
    position = len(start) + 8 * sum(part.size()[1] for part in parts)
    offsets, chunks = b"", b""
    for number, part in enumerate(parts):
        for y, samples in _rows(part):
            offsets += struct.pack("<Q", position + len(chunks))
            if several:
                chunks += struct.pack("<i", number)
            chunks += struct.pack("<2i", y, len(samples)) + samples
    path.write_bytes(start + offsets + chunks)


def _read_string(content, at):
    end = content.index(b"\0", at)
    return content[at:end].decode(), end + 1


def _channels(value):
    at, channels = 0, []
    while value[at]:
        name, at = _read_string(value, at)
        channels.append((name, TYPES[struct.unpack_from("<i", value, at)[0]]))
        at += 16
    return channels


def _attributes(content):
    """[(name, type, bytes)] of the one header, and where it ends."""
    assert content[:4] == MAGIC and struct.unpack_from("<i", content, 4)[0] & 0x1a00 == 0
    at, attributes = 8, []
    while content[at]:
        name, at = _read_string(content, at)
        kind, at = _read_string(content, at)
        size = struct.unpack_from("<i", content, at)[0]
        attributes.append((name, kind, content[at + 4:at + 4 + size]))
        at += 4 + size
    return attributes, at + 1


def values(path):
    """{attribute: value} of those of one part that are a text or a number."""
    read_as = {"string": bytes.decode, "int": lambda b: struct.unpack("<i", b)[0],
               "float": lambda b: struct.unpack("<f", b)[0]}
    attributes, _ = _attributes(path.read_bytes())
    return {name: read_as[kind](value) for name, kind, value in attributes if kind in read_as}


def read(path):
    """({channel: array}, {attribute: bytes}) of a file with one part."""
    content = path.read_bytes()
    header, table = _attributes(content)
    attributes = {name: value for name, _, value in header}
    assert attributes["compression"] == b"\0", "compressed"
    x0, y0, x1, y1 = struct.unpack("<4i", attributes["dataWindow"])
    width, height = x1 - x0 + 1, y1 - y0 + 1
    channels = _channels(attributes["channels"])
    arrays = {name: numpy.empty((height, width), kind) for name, kind in channels}
    for offset in struct.unpack_from(f"<{height}Q", content, table):
        row = struct.unpack_from("<i", content, offset)[0] - y0
        position = offset + 8
        for name, kind in channels:
            arrays[name][row] = numpy.frombuffer(content, kind, width, position)
            position += width * numpy.dtype(kind).itemsize
    return arrays, attributes
