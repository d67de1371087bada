"""Writes an EXR to standard output without its attributes specbake:identity and oiio:SHA-1, which is a
hash of that:  without_identity.py FILE

What is left are the bytes that the file would have if it had never had them: each is cut out of the
header (OpenEXR file layout: name, type, size, value), and the offsets of the chunks, which
count from the start of the file, are lowered by as much.
"""
import struct
import sys

MAGIC_AND_VERSION = 8


def text(data, at):
    end = data.index(b"\0", at)
    return data[at:end], end + 1


def header(data, wanted):
    """Where the attribute begins and ends, nothing if there is none; and where the header ends."""
    found, at = None, MAGIC_AND_VERSION
    while data[at]:
        begin = at
        name, at = text(data, at)
        _, at = text(data, at)
        (size,) = struct.unpack_from("<i", data, at)
        at += 4 + size
        if name == wanted:
            found = begin, at
    return found, at + 1


def offsets(data, begin):
    """The table's entries: it ends where the first chunk in the file begins."""
    entries, at, first = [], begin, len(data)
    while at < first:
        entries += struct.unpack_from("<Q", data, at)
        first = min(first, entries[-1])
        at += 8
    return entries, at


def without(data, name):
    found, end = header(data, name)
    if not found:
        return data
    begin, after = found
    entries, chunks = offsets(data, end)
    lowered = [entry - (after - begin) for entry in entries]
    table = struct.pack("<%dQ" % len(lowered), *lowered)
    return data[:begin] + data[after:end] + table + data[chunks:]


with open(sys.argv[1], "rb") as file:
    data = file.read()
for attribute in (b"specbake:identity", b"oiio:SHA-1"):
    data = without(data, attribute)
sys.stdout.buffer.write(data)
