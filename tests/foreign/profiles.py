"""Rows on files that say what their numbers mean: ICC profiles, inks, Lab, chromaticities."""

import struct
import zlib

import numpy
from PIL import Image

import color
import exr
import icc
from case import Case, Picture, run
from pictures import HEIGHT, WIDTH, texels

# What the issue of ICC asks for: matrix profiles of 16 bits. Tables have 16 bits of Lab themselves:
# their white is made good, by up to 2e-3 of each component (src/image/texture/color).
MATRIX, TABLE = 0.1, 0.1
# ICC's white D50 has four decimals, the table's sum all: two components may be off by 5e-5 each, and
# a* = 500 (f(X) - f(Y)) with f' = 1/3 at white by 500/3 * 1e-4.
LAB = 0.017
OUTSIDE = "^$|that no reflectance has"


def xyz_of_lab(lab):
    """Beside D50."""
    fy = (lab[..., 0] + 16) / 116
    f = numpy.stack([fy + lab[..., 1] / 500, fy, fy - lab[..., 2] / 200], axis=-1)
    t = numpy.where(f > 6 / 29, f**3, 3 * (6 / 29) ** 2 * (f - 4 / 29))
    return t * icc.D50


def picture(lab, alpha=None):
    """What sRGB holds of it is compared: wider colours are moved where no surface has them."""
    xyz = xyz_of_lab(lab.reshape(HEIGHT, WIDTH, 3))
    matrix = color.rgb_to_xyz(color.weights("D65").sum(axis=0)).T
    linear = xyz @ color.bradford(icc.D50, color.weights("D65").sum(axis=0)) @ numpy.linalg.inv(
        matrix)
    inside = numpy.all((linear > -1e-6) & (linear < 1 + 1e-6), axis=-1)
    assert inside.mean() > 0.2, "too few texels to compare"
    return Picture(xyz, alpha, is_xyz=True, white=icc.D50, compared=inside)


def samples16(channels, calm):
    """16 bits; the first row has black and white; `calm`: how near to grey the others are."""
    random = numpy.random.default_rng(11)
    grey = random.random((HEIGHT, WIDTH, 1))
    s = grey + (1 - calm) * (random.random((HEIGHT, WIDTH, channels)) - grey)
    s[0, 0], s[0, 1] = 0, 1
    return numpy.rint(s * 65535).astype("<u2")


def tiff16(samples, profile, photometric="rgb"):
    def make(path):
        raw = path.with_suffix(".raw")
        raw.write_bytes(samples.tobytes())
        run("raw2tiff", "-w", WIDTH, "-l", HEIGHT, "-b", samples.shape[-1], "-d", "short", "-p",
            photometric, raw, path)
        attach(path, profile)
    return make


def attach(path, profile):
    run("exiftool", "-q", "-overwrite_original", f"-icc_profile<={profile}", path)


def matrix_rows():
    found = sorted(icc.SYSTEM.glob("colord/*.icc")) + [
        icc.SYSTEM / "compatibleWithAdobeRGB1998.icc", icc.SYSTEM / "LStar-RGB.icc"]
    for profile in found:
        if profile.stem in ("Crayons", "x11-colors"):  # lists of names
            continue
        samples = samples16(3, calm=0.5)
        yield Case("TIFF", f"16-bit, ICC profile {profile.stem}", "raw2tiff, exiftool", "transicc",
                   f"icc-{profile.stem}.tif", tiff16(samples, profile),
                   lambda path, p=profile, s=samples: picture(
                       icc.by_transicc(p, s.reshape(-1, 3) / 257)), limit=MATRIX, says=OUTSIDE)
    for profile in (icc.SYSTEM / "Gray.icc", icc.SYSTEM / "Gray-CIE_L.icc"):
        samples = samples16(1, calm=0)
        yield Case("TIFF", f"16-bit grey, ICC profile {profile.stem}", "raw2tiff, exiftool",
                   "transicc", f"icc-{profile.stem}.tif", tiff16(samples, profile, "minisblack"),
                   lambda path, p=profile, s=samples: picture(
                       icc.by_transicc(p, s.reshape(-1, 1) / 257)), limit=MATRIX, says=OUTSIDE)


def made_profile(path, bytes_of):
    profile = path.with_name(path.name + ".icc")
    profile.write_bytes(bytes_of)
    return profile


PRESS = icc.table_profile(b"CMYK", 4, "a press", icc.press)
SCANNER = icc.table_profile(b"RGB ", 3, "a scanner", icc.scanner)


def inks(strength=0.6):
    t = texels().astype(float)
    t[0, :2] = [[0, 0, 0, 0], [0, 0, 0, 255]]
    return numpy.rint(t * strength).astype(numpy.uint8)


def by_press(path, samples, alpha=None):
    percent = samples.reshape(-1, 4).astype(float) * (100 / 255)
    return picture(icc.by_transicc(made_profile(path, PRESS), percent), alpha)


def cmyk_tiff(path):
    Image.frombytes("CMYK", (WIDTH, HEIGHT), inks().tobytes()).save(path, icc_profile=PRESS)


def cmyk_jpeg(path):
    Image.frombytes("CMYK", (WIDTH, HEIGHT), inks().tobytes()).save(
        path, icc_profile=PRESS, quality=98, subsampling=0)


def by_pillow_cmyk(path):
    return numpy.array(Image.open(path))


def guessed(path):
    """Of inks without a profile: what each leaves of sRGB's light."""
    left = 1 - inks().astype(float) / 255
    linear = color.linear_from_srgb(left[..., :3] * left[..., 3:])
    return Picture(linear)


def inks_and_alpha(path):
    """TIFF 6.0: five samples, the fifth straight alpha (ExtraSamples 2)."""
    samples = numpy.concatenate([inks(), texels()[..., 3:]], axis=-1)
    data = samples.tobytes()
    entries = [(256, 3, 1, WIDTH), (257, 3, 1, HEIGHT), (258, 3, 5, 200), (259, 3, 1, 1),
               (262, 3, 1, 5), (273, 4, 1, 600), (277, 3, 1, 5), (278, 3, 1, HEIGHT),
               (279, 4, 1, len(data)), (338, 3, 1, 2)]
    tiff_by_hand(path, entries, {200: struct.pack("<5H", *[8] * 5)}, data, 600)


def lab_tiff(bits, photometric, alpha=False):
    """CIE Lab (8) or ICC Lab (9), straight alpha behind it if asked for."""
    def make(path):
        lab, codes = lab_samples(bits, photometric)
        if alpha:
            codes = numpy.concatenate([codes, texels()[..., 3:].astype(codes.dtype)], axis=-1)
        data, count = codes.astype(f"<u{bits // 8}").tobytes(), codes.shape[-1]
        entries = [(256, 3, 1, WIDTH), (257, 3, 1, HEIGHT), (258, 3, count, 200), (259, 3, 1, 1),
                   (262, 3, 1, photometric), (273, 4, 1, 600), (277, 3, 1, count),
                   (278, 3, 1, HEIGHT), (279, 4, 1, len(data))]
        if alpha:
            entries.append((338, 3, 1, 2))
        tiff_by_hand(path, entries, {200: struct.pack(f"<{count}H", *[bits] * count)}, data, 600)
    return make


def lab_samples(bits, photometric):
    """Lab of sRGB's colours, and its codes (TIFF 6.0, section 23; Adobe's TIFF notes of 2002)."""
    white = color.weights("D65").sum(axis=0)
    linear = color.linear_from_srgb(texels()[..., :3] / 255 * 0.9 + 0.05)
    xyz = linear @ color.rgb_to_xyz(white).T @ color.bradford(white, icc.D50)
    lab = color.lab(xyz, icc.D50)
    step = 1 if bits == 8 else 256
    top = 255 if bits == 8 else (65535 if photometric == 8 else 65280)
    lightness = numpy.rint(lab[..., :1] * top / 100)
    ab = numpy.rint(lab[..., 1:] * step)
    decoded = numpy.concatenate([lightness * 100 / top, ab / step], axis=-1)
    ab = ab % 2**bits if photometric == 8 else ab + 128 * step
    return decoded, numpy.concatenate([lightness, ab], axis=-1).astype(int)


def tiff_by_hand(path, entries, values, data, data_at):
    directory = struct.pack("<H", len(entries))
    for tag, kind, count, value in sorted(entries):
        wide = kind == 4 or count * 2 > 4
        directory += struct.pack("<HHI", tag, kind, count) + (
            struct.pack("<I", value) if wide else struct.pack("<H2x", value))
    content = bytearray(b"II*\0" + struct.pack("<I", 8) + directory + bytes(4))
    content += bytes(data_at - len(content))
    for at, value in values.items():
        content[at:at + len(value)] = value
    path.write_bytes(bytes(content) + data)


def turned_cmyk_jpeg(path):
    cmyk_jpeg(path)
    run("exiftool", "-q", "-n", "-overwrite_original", "-XMP-dc:Title=inks", "-Orientation=6", path)


def ink_rows():
    yield Case("TIFF", "CMYK, ICC profile of a press", "Pillow", "transicc", "cmyk.tif", cmyk_tiff,
               lambda path: by_press(path, inks()), limit=TABLE, says=OUTSIDE)
    yield Case("JPEG", "CMYK (Adobe), ICC profile of a press", "Pillow", "Pillow, transicc",
               "cmyk.jpg", cmyk_jpeg, lambda path: by_press(path, by_pillow_cmyk(path)),
               limit=TABLE, says=OUTSIDE)
    yield Case("JPEG", "CMYK (Adobe), ICC profile, XMP, orientation 6", "Pillow, exiftool",
               "Pillow, transicc", "cmyk6.jpg", turned_cmyk_jpeg,
               lambda path: by_press(path, by_pillow_cmyk(path)), limit=TABLE,
               says=r"its orientation \(Exif 6\)", read="texels where they are stored")
    yield Case("TIFF", "CMYK without a profile", "Pillow", "the product of what inks leave",
               "cmyk-plain.tif",
               lambda path: Image.frombytes("CMYK", (WIDTH, HEIGHT), inks().tobytes()).save(path),
               guessed, says="CMYK without an ICC profile", limit=MATRIX)
    alpha = texels()[..., 3] / 255
    yield Case("TIFF", "CMYK and alpha, ICC profile of a press", "exiftool", "transicc",
               "cmyk-alpha.tif",
               lambda path: (inks_and_alpha(path), attach(path, made_profile(path, PRESS))),
               lambda path: by_press(path, inks(), alpha), limit=TABLE, says=OUTSIDE)
    scans = samples16(3, calm=0.5)
    yield Case("TIFF", "16-bit, ICC profile of a scanner (a table)", "raw2tiff, exiftool",
               "transicc", "scan.tif",
               lambda path: tiff16(scans, made_profile(path, SCANNER))(path),
               lambda path: picture(icc.by_transicc(made_profile(path, SCANNER),
                                                    scans.reshape(-1, 3) / 257)),
               limit=TABLE, says=OUTSIDE)


def lab_rows():
    for bits in (8, 16):
        for photometric, name in ((8, "CIE L\\*a\\*b\\*"), (9, "ICC L\\*a\\*b\\*")):
            yield Case("TIFF", f"{bits}-bit {name}", "by hand", "CIE 15's formula",
                       f"lab{bits}-{photometric}.tif", lab_tiff(bits, photometric),
                       lambda path, b=bits, p=photometric: picture(lab_samples(b, p)[0]),
                       limit=LAB, says=OUTSIDE)
    yield Case("TIFF", "8-bit CIE L\\*a\\*b\\* and alpha", "by hand", "CIE 15's formula",
               "lab-alpha.tif", lab_tiff(8, 8, alpha=True),
               lambda path: picture(lab_samples(8, 8)[0], texels()[..., 3] / 255),
               limit=LAB, says=OUTSIDE)


def rgb8(profile):
    """What transicc makes of the 8-bit colours, mixed with grey, that `save` stores."""
    return lambda path, samples: picture(icc.by_transicc(profile, samples.reshape(-1, 3)))


def container_rows():
    """The same profile in each format that carries one."""
    profile = icc.SYSTEM / "colord/ProPhotoRGB.icc"
    samples = (samples16(3, calm=0.6) >> 8).astype(numpy.uint8)
    image = Image.fromarray(samples, "RGB")
    read = rgb8(profile)

    def pillow(**options):
        return lambda path: image.save(path, icc_profile=profile.read_bytes(), **options)

    def magick(path):
        start = path.with_name(path.name + ".start.png")
        image.save(start)
        run("convert", start, "-profile", profile, "-compress", "RLE", path)

    def attached(path):
        image.save(path)
        attach(path, profile)
    for fmt, name, make, maker in (
            ("PNG", "pro.png", pillow(), "Pillow"),
            ("PNG", "pro-magick.png", attached, "Pillow, exiftool"),
            ("WebP", "pro.webp", pillow(lossless=True), "Pillow"),
            ("TIFF", "pro.tif", pillow(), "Pillow"),
            ("PSD", "pro.psd", magick, "ImageMagick"),
            ("JPEG 2000", "pro.jp2", attached, "Pillow, exiftool")):
        yield Case(fmt, "8-bit, ICC profile ProPhotoRGB", maker, "transicc", name, make,
                   lambda path: read(path, samples), limit=MATRIX,
                   says=OUTSIDE if fmt != "PSD" else "of its parts 0, 1")
    yield Case("JPEG", "4:4:4, ICC profile ProPhotoRGB", "Pillow", "Pillow, transicc", "pro.jpg",
               pillow(quality=98, subsampling=0),
               lambda path: read(path, numpy.array(Image.open(path))), limit=MATRIX, says=OUTSIDE)


P3 = ((0.680, 0.320), (0.265, 0.690), (0.150, 0.060))
D65 = (0.3127, 0.3290)


def seen(linear):
    """Linear Display P3."""
    white = color.weights("D65").sum(axis=0)
    return Picture(linear @ color.rgb_to_xyz(white, P3).T, is_xyz=True, white=white)


def png_with(image, *chunks):
    """A PNG of Pillow's, with these chunks behind its head."""
    def make(path):
        image.save(path, format="PNG")
        png = path.read_bytes()
        added = b"".join(struct.pack(">I", len(data)) + name + data
                         + struct.pack(">I", zlib.crc32(name + data)) for name, data in chunks)
        path.write_bytes(png[:33] + added + png[33:])
    return make


def png_rows():
    """The order of PNG's third edition, section 4.3: cICP, iCCP, sRGB, gAMA and cHRM."""
    samples = (samples16(3, calm=0.5) >> 8).astype(numpy.uint8)
    image, values = Image.fromarray(samples, "RGB"), samples / 255
    cicp = (b"cICP", bytes([12, 13, 0, 1]))
    srgb = (b"sRGB", bytes(1))
    gama = (b"gAMA", struct.pack(">I", 50000))
    chrm = (b"cHRM", struct.pack(">8I", *[round(1e5 * v) for xy in (D65, *P3) for v in xy]))
    for kind, name, chunks, read in (
            ("gAMA 0.5 and cHRM of Display P3", "gama-chrm.png", (gama, chrm),
             lambda path: seen(values**2)),
            ("gAMA 0.5", "gama.png", (gama,), lambda path: Picture(values**2)),
            ("sRGB, and gAMA and cHRM that differ", "srgb.png", (srgb, gama, chrm),
             lambda path: Picture(color.linear_from_srgb(values))),
            ("cICP of Display P3, and sRGB", "cicp.png", (cicp, srgb),
             lambda path: seen(color.linear_from_srgb(values)))):
        yield Case("PNG", kind, "Pillow, the chunks by hand", "the PNG specification's formulas",
                   name, png_with(image, *chunks), read, says="^$|not used")


def chromaticity_rows():
    numbers = [v for pair in (*P3, D65) for v in pair]
    samples = samples16(3, calm=0.5)
    linear = (samples / 65535).astype(numpy.float32)

    def half(path):
        part = exr.Part({c: linear[..., i] for i, c in enumerate("RGB")}, attributes=[
            ("chromaticities", "chromaticities", struct.pack("<8f", *numbers))])
        exr.write(path, part)
    yield Case("EXR", "chromaticities of Display P3", "exr.py", "the samples", "p3.exr", half,
               lambda path: seen(linear.astype(float)))

    def tiff(path):
        raw = path.with_suffix(".raw")
        raw.write_bytes(samples.tobytes())
        run("raw2tiff", "-w", WIDTH, "-l", HEIGHT, "-b", 3, "-d", "short", "-p", "rgb", raw, path)
        run("tiffset", "-s", 319, *numbers[:6], path)
        run("tiffset", "-s", 318, *D65, path)
    yield Case("TIFF", "16-bit, chromaticities of Display P3", "raw2tiff, tiffset", "the samples",
               "p3.tif", tiff, lambda path: seen(color.linear_from_srgb(samples / 65535)))


def rows():
    for kind in (matrix_rows, ink_rows, lab_rows, container_rows, png_rows,
                 chromaticity_rows):
        yield from kind()
