"""Rows on formats of whole images: bits, palettes, alpha, frames."""

import numpy
from PIL import Image

from case import Case, run
from pictures import (HEIGHT, WIDTH, by_dwebp, by_gif2rgb, by_magick, by_pillow, grey, magick,
                      picture_of, rgb, rgba, save, texels)

PARTS = "of its parts .* only number 0 is used"


def palette(transparent=False, interlace=0):
    def make(path):
        image = rgb().quantize(16)
        options = {"transparency": 3} if transparent else {}
        image.save(path, interlace=interlace, **options)
    return make


def animation(path):
    frames = [Image.fromarray(texels(seed)[..., :3], "RGB").quantize(32) for seed in (1, 2, 3)]
    frames[0].save(path, save_all=True, append_images=frames[1:], duration=100)


def pillow_rows():
    yield Case("PNG", "8-bit RGB", "Pillow", "Pillow", "rgb.png", save(rgb), by_pillow)
    yield Case("PNG", "8-bit RGBA", "Pillow", "Pillow", "rgba.png", save(rgba), by_pillow)
    yield Case("PNG", "8-bit grey", "Pillow", "Pillow", "grey.png", save(grey), by_pillow)
    yield Case("PNG", "palette, a transparent entry", "Pillow", "Pillow", "palette.png",
               palette(transparent=True), by_pillow)
    yield Case("PNG", "16-bit RGBA, interlaced", "ImageMagick", "ImageMagick", "rgba16.png",
               magick("-depth", "16", "-resize", "16x12!", "-interlace", "PNG",
                      prefix="PNG64:"), by_magick)
    yield Case("PNG", "1-bit grey", "Pillow", "Pillow", "bilevel.png",
               lambda path: grey().convert("1").save(path), by_pillow)
    yield Case("PNG", "16-bit grey", "Pillow", "Pillow", "grey16.png",
               lambda path: Image.fromarray(
                   numpy.random.default_rng(2).integers(0, 65536, (HEIGHT, WIDTH),
                                                        dtype=numpy.uint16)).save(path), by_pillow)
    yield Case("JPEG", "grey", "Pillow", "Pillow", "grey.jpg", save(grey), by_pillow)
    yield Case("JPEG", "4:4:4, progressive", "Pillow", "Pillow", "rgb.jpg",
               save(rgb, quality=95, subsampling=0, progressive=True), by_pillow)
    yield Case("JPEG", "4:2:0", "ImageMagick", "ImageMagick", "rgb420.jpg",
               magick("-sampling-factor", "4:2:0", image=rgb), by_magick)
    yield Case("BMP", "24-bit", "Pillow", "Pillow", "rgb.bmp", save(rgb), by_pillow)
    yield Case("BMP", "8-bit palette", "Pillow", "Pillow", "palette.bmp",
               lambda path: rgb().quantize(16).save(path), by_pillow)
    yield Case("BMP", "32-bit with alpha (V4)", "ImageMagick", "ImageMagick", "rgba.bmp",
               magick(), by_magick)
    yield Case("BMP", "16-bit (5-6-5)", "ImageMagick", "ImageMagick", "565.bmp",
               magick("-define", "bmp:subtype=RGB565", image=rgb), by_magick)
    yield Case("TGA", "24-bit", "Pillow", "Pillow", "rgb.tga", save(rgb), by_pillow)
    yield Case("TGA", "32-bit RLE", "Pillow", "Pillow", "rle.tga",
               save(rgba, compression="tga_rle"), by_pillow)
    yield Case("TGA", "32-bit, lower left first", "Pillow", "Pillow", "bottom.tga",
               save(rgba, orientation=1), by_pillow)
    yield Case("TGA", "32-bit, upper left first", "Pillow", "Pillow", "top.tga",
               save(rgba, orientation=-1), by_pillow)
    yield Case("TGA", "grey", "Pillow", "Pillow", "grey.tga", save(grey), by_pillow)
    yield Case("SGI", "RGBA", "Pillow", "Pillow", "rgba.sgi", save(rgba), by_pillow)
    yield Case("ICO", "32-bit", "Pillow", "Pillow", "rgba.ico",
               save(rgba, sizes=[(WIDTH, HEIGHT)]), by_pillow)
    yield Case("DDS", "32-bit", "Pillow", "Pillow", "rgba.dds", save(rgba), by_pillow)
    yield Case("DDS", "DXT5", "ImageMagick", "ImageMagick", "dxt5.dds",
               magick("-define", "dds:compression=dxt5", "-define", "dds:mipmaps=0"), by_magick,
               limit=1)  # between the two colours of a block, each decoder rounds in its own way
    yield Case("JPEG 2000", "lossless RGBA", "Pillow", "Pillow", "rgba.jp2", save(rgba),
               by_pillow)
    yield Case("PPM", "8-bit RGB", "Pillow", "Pillow", "rgb.ppm", save(rgb), by_pillow)


def magick_rows():
    yield Case("PSD", "RGB", "ImageMagick", "ImageMagick", "rgb.psd", magick("-compress", "RLE",
                                                                          image=rgb),
               by_magick, says=PARTS)
    yield Case("PSD", "RGBA", "ImageMagick", "ImageMagick", "rgba.psd",
               magick("-compress", "RLE"), where_opaque(by_magick),
               says="mixed with white in 8 bits.*" + PARTS, steps=2, read="where alpha is not 0")
    yield Case("PSD", "layers compressed by ZIP", "ImageMagick", "", "zip.psd",
               magick("-compress", "Zip"), refused=True, says="unsupported compression")


def gif_rows():
    yield Case("GIF", "opaque", "Pillow", "gif2rgb", "opaque.gif", palette(), by_gif2rgb)
    yield Case("GIF", "interlaced", "Pillow", "gif2rgb", "interlaced.gif", palette(interlace=1),
               by_gif2rgb)
    yield Case("GIF", "a transparent entry", "Pillow", "gif2rgb, Pillow", "transparent.gif",
               palette(transparent=True), by_gif2rgb)
    yield Case("GIF", "animated", "Pillow", "Pillow", "animated.gif", animation, by_pillow,
               says=PARTS, read="the first frame")
    yield Case("GIF", "animated, `--part 2`", "Pillow", "Pillow", "animated.gif", animation,
               lambda path: by_pillow(path, frame=2), options=("--part", "2"), says="only number 2")


def where_opaque(decode):
    """Where alpha is 0, a reader that has multiplied by it has no colour left."""
    def decoded(path):
        picture = decode(path)
        picture.compared = picture.alpha > 0
        return picture
    return decoded


def webp_rows():
    def cwebp(*options, image=rgb):
        def make(path):
            start = path.with_name(path.name + ".start.png")
            image().save(start)
            run("cwebp", "-quiet", *options, start, "-o", path)
        return make
    yield Case("WebP", "lossless", "cwebp", "dwebp", "lossless.webp", cwebp("-lossless"), by_dwebp)
    yield Case("WebP", "lossy", "cwebp", "dwebp", "lossy.webp", cwebp("-q", "90"), by_dwebp)
    yield Case("WebP", "lossless with alpha", "cwebp", "dwebp", "alpha.webp",
               cwebp("-lossless", "-exact", image=rgba), where_opaque(by_dwebp),
               says="multiplies it by alpha in 8 bits", steps=1, read="where alpha is not 0")


RAW = {"byte": ("<u1", 255), "short": ("<u2", 65535), "long": ("<u4", 2**32 - 1),
       "sshort": ("<i2", 32767), "slong": ("<i4", 2**31 - 1), "float": ("<f4", 1)}


def tiffcp(options):
    def make(path):
        start = path.with_name(path.name + ".start.tif")
        rgb().save(start)
        run("tiffcp", *options, start, path)
    return make


def raw_samples(kind):
    dtype, scale = RAW[kind]
    shares = numpy.random.default_rng(7).random((HEIGHT, WIDTH, 3))
    shares[0, :2] = [[0, 0, 0], [1, 1, 1]]
    return (shares * scale).astype(dtype), scale


def raw_tiff(kind):
    def make(path):
        raw = path.with_suffix(".raw")
        raw.write_bytes(raw_samples(kind)[0].tobytes())
        run("raw2tiff", "-w", WIDTH, "-l", HEIGHT, "-b", 3, "-d", kind, "-p", "rgb", raw, path)
    return make


def raw_picture(kind):
    samples, scale = raw_samples(kind)
    picture = picture_of(samples, scale)
    if kind == "float":
        picture.color = samples.astype(numpy.float64)
    return picture


def tiff_rows():
    yield Case("TIFF", "8-bit RGBA, straight", "Pillow", "Pillow", "rgba.tif", save(rgba),
               by_pillow)
    yield Case("TIFF", "16-bit RGBA, colour multiplied by alpha", "ImageMagick", "ImageMagick",
               "associated.tif", magick("-depth", "16", "-define", "tiff:alpha=associated"),
               where_opaque(by_magick))
    yield Case("TIFF", "white is 0", "ImageMagick", "ImageMagick", "white0.tif",
               magick("-define", "quantum:polarity=min-is-white", image=grey), by_magick)
    for name, options in (("LZW, big-endian", ["-c", "lzw", "-B"]), ("planes apart", ["-p", "separate"]),
                          ("tiles of 16 x 16", ["-t", "-w", "16", "-l", "16"])):
        yield Case("TIFF", name, "Pillow, tiffcp", "Pillow", f"{name.split()[0].strip(',')}.tif",
                   tiffcp(options), by_pillow)
    yield Case("TIFF", "8-bit palette", "ImageMagick", "ImageMagick", "palette.tif",
               magick("-colors", "16", "-depth", "8", "-type", "Palette", image=rgb), by_magick)
    yield Case("TIFF", "1 bit", "ImageMagick", "ImageMagick", "bilevel.tif",
               magick("-monochrome", "-type", "bilevel", image=grey), by_magick)
    for kind, name in (("byte", "8-bit"), ("short", "16-bit"), ("long", "32-bit integers"),
                       ("float", "float")):
        yield Case("TIFF", name, "raw2tiff", "the raw samples", f"{kind}.tif", raw_tiff(kind),
                   lambda path, kind=kind: raw_picture(kind))
    for kind, name in (("sshort", "16-bit signed"), ("slong", "32-bit signed")):
        yield Case("TIFF", name, "raw2tiff", "the raw samples", f"{kind}.tif", raw_tiff(kind),
                   lambda path, kind=kind: raw_picture(kind), says="signed integers")
    yield Case("TIFF", "two pages, `--part 1`", "Pillow", "Pillow", "pages.tif", pages,
               lambda path: by_pillow(path, frame=1), options=("--part", "1"),
               says="only number 1")


def pages(path):
    first, second = (Image.fromarray(texels(seed)[..., :3], "RGB") for seed in (1, 2))
    first.save(path, save_all=True, append_images=[second])


def rows():
    for kind in (pillow_rows, magick_rows, gif_rows, webp_rows, tiff_rows):
        yield from kind()
