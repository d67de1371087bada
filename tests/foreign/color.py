"""From samples to colours and back, by closed forms and the tables of data/: the 81-term sum that
docs/method.md calls the colour of a spectrum, IEC 61966-2-1 for sRGB, CIE 142 for CIEDE2000.
"""

import pathlib

import numpy

DATA = pathlib.Path(__file__).resolve().parents[2] / "data"
REC709 = ((0.64, 0.33), (0.30, 0.60), (0.15, 0.06))


def _table(name):
    lines = [line for line in (DATA / name).read_text().splitlines() if not line.startswith("#")]
    names = lines[0].split(",")
    columns = numpy.array([[float(v or "nan") for v in line.split(",")] for line in lines[1:]]).T
    return dict(zip(names, columns))


def weights(illuminant):
    """81 x 3: what each band adds to X, Y and Z of a surface; white has Y = 1."""
    observer = _table("cie1931_2deg_5nm.csv")
    light = _table("illuminants_5nm.csv")[illuminant]
    w = numpy.stack([observer[c] * light for c in ("xbar", "ybar", "zbar")], axis=1)
    return w / w[:, 1].sum()


def power_every_nm(illuminant):
    """From 360 to 830 nm: Planck's law for A, for the others linear between the 5 nm of the tables,
    which go on as they end."""
    nm = numpy.arange(360, 831)
    if illuminant == "A":
        return nm**-5.0 / numpy.expm1(1.435e7 / (2848 * nm))
    middle, ends = _table("illuminants_5nm.csv"), _table("illuminants_ends.csv")
    at, power = middle["lambda_nm"], middle[illuminant]
    if illuminant in ends:
        known = ~numpy.isnan(ends[illuminant])
        at = numpy.concatenate([at, ends["lambda_nm"][known]])
        power = numpy.concatenate([power, ends[illuminant][known]])
    order = numpy.argsort(at)
    return numpy.interp(nm, at[order], power[order])


def fine_weights(illuminant, wavelengths):
    """N x 3: the same for who integrates every 1 nm from 360 to 830, linear between N bands."""
    observer = _table("cie1931_2deg_1nm.csv")
    lit = numpy.stack([observer[c] for c in ("xbar", "ybar", "zbar")], axis=1)
    lit = lit * power_every_nm(illuminant)[:, None]
    of_band = [numpy.interp(observer["lambda_nm"], wavelengths, one)
               for one in numpy.eye(len(wavelengths))]
    return numpy.array(of_band) @ lit / lit[:, 1].sum()


def rgb_to_xyz(white, primaries=REC709):
    """The matrix by which R = G = B = 1 is the white."""
    columns = numpy.array([[x / y, 1, (1 - x - y) / y] for x, y in primaries]).T
    return columns * numpy.linalg.solve(columns, white)


def bradford(white, other):
    """For row vectors: what looks beside the other white as a colour does beside the one (ICC.1,
    annex E)."""
    cones = numpy.array([[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367],
                         [0.0389, -0.0685, 1.0296]])
    gains = (cones @ other) / (cones @ white)
    return (numpy.linalg.inv(cones) @ (gains[:, None] * cones)).T


def linear_from_srgb(v):
    v = numpy.asarray(v, numpy.float64)
    return numpy.where(v <= 0.04045, v / 12.92, ((numpy.maximum(v, 0) + 0.055) / 1.055) ** 2.4)


def lab(xyz, white):
    t = xyz / white
    f = numpy.where(t > (6 / 29) ** 3, numpy.cbrt(t), t * (29 / 6) ** 2 / 3 + 4 / 29)
    return numpy.stack([116 * f[..., 1] - 16, 500 * (f[..., 0] - f[..., 1]),
                        200 * (f[..., 1] - f[..., 2])], axis=-1)


def ciede2000(one, other):
    """CIE 142-2001, with kL = kC = kH = 1."""
    l1, a1, b1 = numpy.moveaxis(one, -1, 0)
    l2, a2, b2 = numpy.moveaxis(other, -1, 0)
    c = (numpy.hypot(a1, b1) + numpy.hypot(a2, b2)) / 2
    g = 1.5 - 0.5 * numpy.sqrt(c**7 / (c**7 + 25.0**7))
    c1, c2 = numpy.hypot(g * a1, b1), numpy.hypot(g * a2, b2)
    h1, h2 = numpy.arctan2(b1, g * a1), numpy.arctan2(b2, g * a2)
    h1, h2 = h1 % (2 * numpy.pi), h2 % (2 * numpy.pi)
    dh = h2 - h1
    dh -= 2 * numpy.pi * (numpy.sign(dh) * (numpy.abs(dh) > numpy.pi))
    dh = numpy.where(c1 * c2 == 0, 0, dh)
    h = numpy.where(c1 * c2 == 0, h1 + h2, h1 + dh / 2)
    dl, dc, dhue = l2 - l1, c2 - c1, 2 * numpy.sqrt(c1 * c2) * numpy.sin(dh / 2)
    l, c = (l1 + l2) / 2, (c1 + c2) / 2
    t = (1 - 0.17 * numpy.cos(h - numpy.pi / 6) + 0.24 * numpy.cos(2 * h)
         + 0.32 * numpy.cos(3 * h + numpy.pi / 30) - 0.20 * numpy.cos(4 * h - 63 * numpy.pi / 180))
    sl = 1 + 0.015 * (l - 50) ** 2 / numpy.sqrt(20 + (l - 50) ** 2)
    sc, sh = 1 + 0.045 * c, 1 + 0.015 * c * t
    degrees = numpy.degrees(h) % 360
    rt = (-2 * numpy.sqrt(c**7 / (c**7 + 25.0**7))
          * numpy.sin(numpy.radians(60 * numpy.exp(-(((degrees - 275) / 25) ** 2)))))
    return numpy.sqrt((dl / sl) ** 2 + (dc / sc) ** 2 + (dhue / sh) ** 2
                      + rt * (dc / sc) * (dhue / sh))
