"""Small pictures with what is awkward, and how other programs store and decode them."""

import numpy
from PIL import Image, ImageOps

import color
from case import Picture, run

HEIGHT, WIDTH = 12, 16


def texels(seed=1):
    """height x width x 4 of 8 bits: black, white, primaries, noise; alpha of 0, 1, 64, … 255."""
    random = numpy.random.default_rng(seed)
    t = random.integers(0, 256, (HEIGHT, WIDTH, 4), dtype=numpy.uint8)
    t[0, :8, :3] = [[0, 0, 0], [255, 255, 255], [255, 0, 0], [0, 255, 0],
                    [0, 0, 255], [1, 1, 1], [254, 255, 255], [10, 0, 11]]
    t[..., 3] = numpy.resize([255, 200, 128, 64, 17, 1, 0, 255, 255], (HEIGHT, WIDTH))
    return t


def rgb():
    return Image.fromarray(texels()[..., :3], "RGB")


def rgba():
    return Image.fromarray(texels(), "RGBA")


def grey():
    return Image.fromarray(texels()[..., 0].copy(), "L")


def picture_of(samples, scale):
    """Of an array with 1 to 4 channels of encoded sRGB; the second or fourth is alpha."""
    s = numpy.asarray(samples, numpy.float64) / scale
    s = s[..., None] if s.ndim == 2 else s
    alpha = s[..., -1] if s.shape[-1] in (2, 4) else None
    colors = s[..., :3] if s.shape[-1] >= 3 else numpy.repeat(s[..., :1], 3, axis=-1)
    return Picture(color.linear_from_srgb(colors), alpha, encoded=colors)


def by_pillow(path, frame=0, turned=False):
    image = Image.open(path)
    image.seek(frame)
    if turned:
        image = ImageOps.exif_transpose(image)
    has_alpha = image.mode in ("RGBA", "LA", "PA") or "transparency" in image.info
    if image.mode in ("I", "I;16"):
        return picture_of(numpy.array(image), 65535)
    return picture_of(numpy.array(image.convert("RGBA" if has_alpha else "RGB")), 255)


def by_magick(path, *operations, frame=0, alpha=True):
    """ImageMagick: 16 bits a sample, as encoded."""
    size = run("identify", "-format", "%w %h\n", f"{path}[{frame}]").split()
    raw = run("convert", f"{path}[{frame}]", *operations, "-depth", "16", "-endian", "LSB",
              "rgba:-" if alpha else "rgb:-")
    samples = numpy.frombuffer(raw, "<u2").reshape(-1, 4 if alpha else 3)
    width, height = int(size[0]), int(size[1])
    if "-auto-orient" in operations:
        width, height = [int(n) for n in run("convert", f"{path}[{frame}]", "-auto-orient",
                                             "-format", "%w %h", "info:").split()]
    return picture_of(samples.reshape(height, width, -1), 65535)


def by_dwebp(path):
    pam = run("dwebp", "-quiet", "-pam", path, "-o", "-")
    header, samples = pam.split(b"ENDHDR\n", 1)
    depth = int(header.split(b"DEPTH ")[1].split()[0])
    return picture_of(numpy.frombuffer(samples, numpy.uint8).reshape(HEIGHT, WIDTH, depth), 255)


def by_gif2rgb(path):
    """gif2rgb knows no transparency: Pillow tells where there is none."""
    raw = path.with_suffix(".raw")
    run("gif2rgb", "-1", "-o", raw, path)
    samples = numpy.frombuffer(raw.read_bytes(), numpy.uint8).reshape(HEIGHT, WIDTH, 3)
    picture = picture_of(samples, 255)
    picture.alpha = by_pillow(path).alpha
    picture.compared = None if picture.alpha is None else picture.alpha > 0
    return picture


def save(image, **options):
    return lambda path: image().save(path, **options)


def magick(*operations, image=rgba, prefix=""):
    """A file that ImageMagick writes of an image that Pillow gives it as PNG."""
    def make(path):
        start = path.with_name(path.name + ".start.png")
        image().save(start)
        run("convert", start, *operations, f"{prefix}{path}")
    return make
