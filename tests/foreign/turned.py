"""Rows on orientation: all eight of Exif and TIFF, for every reader, as Pillow and ImageMagick turn
them.
"""

from PIL import Image

from case import Case, run
from pictures import by_magick, by_pillow, rgb

NOTE = r"its orientation \(Exif \d\) is not used"


def with_exif(orientation, **options):
    def make(path):
        exif = Image.Exif()
        exif[0x0112] = orientation
        rgb().save(path, exif=exif, **options)
    return make


def by_exiftool(orientation):
    def make(path):
        rgb().save(path, quality=95)
        run("exiftool", "-q", "-n", "-overwrite_original", f"-Orientation={orientation}", path)
    return make


def by_tiff_tag(orientation):
    return lambda path: rgb().save(path, tiffinfo={274: orientation})


READERS = (("JPEG", "jpg", by_exiftool, "exiftool"), ("PNG", "png", with_exif, "Pillow"),
           ("TIFF", "tif", by_tiff_tag, "Pillow"),
           ("WebP", "webp", lambda o: with_exif(o, lossless=True), "Pillow"))


def turned_by_magick(path):
    return by_magick(path, "-auto-orient", alpha=False)


def turned_by_pillow(path):
    return by_pillow(path, turned=True)


def rows():
    for name, extension, make, maker in READERS:
        for orientation in range(1, 9):
            magick = name in ("JPEG", "TIFF")
            yield Case(name, f"orientation {orientation}", maker,
                       "ImageMagick" if magick else "Pillow",
                       f"turned{orientation}.{extension}", make(orientation),
                       turned_by_magick if magick else turned_by_pillow, options=("--orient",))
        yield Case(name, "orientation 6", maker, "ImageMagick", f"turned6.{extension}", make(6),
                   lambda path: by_magick(path, alpha=False), says=NOTE,
                   read="texels where they are stored")
