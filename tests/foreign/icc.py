"""ICC profiles with tables, byte by byte, as ICC.1:2004-10 lays them out: what a press or a scanner
would bring, without asking a press for its own. And what Little CMS's transicc makes of a profile.
"""

import pathlib
import struct
import subprocess

import numpy

SYSTEM = pathlib.Path("/usr/share/color/icc")
D50 = numpy.array([0.9642, 1.0, 0.8249])  # ICC.1, 7.2.16


def _text(value):
    return b"text\0\0\0\0" + value.encode() + b"\0"


def _description(value):
    ascii_text = value.encode() + b"\0"
    return (b"desc\0\0\0\0" + struct.pack(">I", len(ascii_text)) + ascii_text + bytes(8 + 3 + 67))


def _xyz(x, y, z):
    return b"XYZ \0\0\0\0" + struct.pack(">3i", *(round(v * 65536) for v in (x, y, z)))


def _lut16(inputs, grid, table):
    """lut16Type (10.10): identity matrix and curves; `table`: grid^inputs x 3 of 16 bits."""
    identity = struct.pack(">9i", 65536, 0, 0, 0, 65536, 0, 0, 0, 65536)
    line = struct.pack(">2H", 0, 65535)
    return (b"mft2\0\0\0\0" + struct.pack(">4B", inputs, 3, grid, 0) + identity
            + struct.pack(">2H", 2, 2) + inputs * line + table.astype(">u2").tobytes() + 3 * line)


def lab16(lab):
    """Lab as version 2 stores it in 16 bits (10.10, table 42)."""
    scaled = [lab[..., 0] * 65280 / 100, (lab[..., 1] + 128) * 256, (lab[..., 2] + 128) * 256]
    return numpy.clip(numpy.rint(numpy.stack(scaled, axis=-1)), 0, 65535)


def _profile(space, name, tags):
    at = 128 + 4 + 12 * len(tags)
    table, data = struct.pack(">I", len(tags)), b""
    for tag, value in tags:
        value += bytes(-len(value) % 4)
        table += tag + struct.pack(">2I", at + len(data), len(value))
        data += value
    header = struct.pack(">I4sI4s4s4s", at + len(data), b"test", 0x02400000, b"prtr", space, b"Lab ")
    header += struct.pack(">6H", 2024, 1, 1, 0, 0, 0) + b"acsp" + bytes(28)
    header += struct.pack(">3i", *(round(v * 65536) for v in D50)) + bytes(48)
    assert len(header) == 128, name
    return header + table + data


def table_profile(space, inputs, name, colors, grid=9):
    """`colors`: device values of the lattice, each 0 to 1, to Lab beside D50."""
    axes = numpy.meshgrid(*[numpy.linspace(0, 1, grid)] * inputs, indexing="ij")
    table = lab16(colors(numpy.stack(axes, axis=-1).reshape(-1, inputs)))
    return _profile(space, name, [(b"desc", _description(name)), (b"cprt", _text("none")),
                                  (b"wtpt", _xyz(*D50)), (b"A2B0", _lut16(inputs, grid, table))])


def press(cmyk):
    """A press that no one has: inks that darken, each with a hue of its own, on white paper."""
    c, m, y, k = numpy.moveaxis(cmyk, -1, 0)
    paper = (1 - 0.55 * c) * (1 - 0.5 * m) * (1 - 0.12 * y) * (1 - 0.9 * k)
    light = 1 - k
    return numpy.stack([100 * paper, light * (-35 * c + 60 * m - 5 * y),
                        light * (-45 * c - 4 * m + 75 * y)], axis=-1)


def scanner(rgb):
    r, g, b = numpy.moveaxis(rgb, -1, 0)
    return numpy.stack([100 * (0.25 * r + 0.6 * g + 0.15 * b) ** 0.9, 60 * (r - g), 70 * (g - b)],
                       axis=-1)


def by_transicc(profile, device):
    """Lab beside D50, relative colorimetric, of device values n x channels as transicc counts them
    (RGB and grey to 255, inks to 100)."""
    lines = "".join(" ".join(f"{v:.6f}" for v in row) + "\n" for row in device)
    done = subprocess.run(["transicc", "-i", profile, "-o", "*Lab", "-t1", "-n"], input=lines,
                          capture_output=True, check=True, text=True)
    return numpy.array([[float(v) for v in line.split()] for line in done.stdout.splitlines()
                        if line.strip()])
