"""Rows on channels, layers, parts and windows of OpenEXR, and on metadata. The files are written by
exr.py; exrheader, a program of OpenEXR, must be able to read each.
"""

import numpy
from PIL.PngImagePlugin import PngInfo

import exr
from case import Case, Picture, run
from pictures import HEIGHT, WIDTH, by_pillow, rgb

SHAPE = (HEIGHT, WIDTH)


def plane(seed, least=0.0, most=1.0):
    """Colours that reflectances have, as long as R, G and B lie between 0 and 1."""
    random = numpy.random.default_rng(seed)
    values = random.random(SHAPE, numpy.float32)
    values[0, :2] = 0, 1
    return (least + (most - least) * values).astype(numpy.float32)


def planes(layer="", seed=1, alpha=False):
    """R, G and B of a layer, multiplied by its alpha if it has one."""
    prefix = layer + "." if layer else ""
    channels = {prefix + n: plane(seed + i) for i, n in enumerate("RGB")}
    if alpha:
        a = numpy.resize(numpy.float32([1, 0.5, 0.25]), SHAPE)
        channels = {n: v * a for n, v in channels.items()}
        channels[prefix + "A"] = a
    return channels


def picture(layer="", seed=1, alpha=False):
    channels = planes(layer, seed)
    a = numpy.resize(numpy.float32([1, 0.5, 0.25]), SHAPE) if alpha else None
    return Picture(numpy.stack(list(channels[(layer + "." if layer else "") + n]
                                    for n in "RGB"), axis=-1).astype(numpy.float64), a)


def grey(seed):
    return Picture(numpy.repeat(plane(seed)[..., None].astype(numpy.float64), 3, axis=-1))


def xyz(seed):
    """Under E, white is (1, 1, 1); near greys are inside the solid."""
    return {n: plane(seed + i, 0.3, 0.5) for i, n in enumerate("XYZ")}


def xyz_picture(seed):
    channels = xyz(seed)
    return Picture(numpy.stack([channels[n] for n in "XYZ"], axis=-1).astype(numpy.float64),
                   is_xyz=True)


def file(*parts):
    def make(path):
        exr.write(path, *parts)
        run("exrheader", path)
    return make


def part(channels, name=None, **options):
    attributes = [] if name is None else [exr.text("name", name),
                                          exr.text("type", "scanlineimage")]
    return exr.Part(channels, attributes=attributes + options.pop("attributes", []), **options)


def row(kind, name, parts, expected=None, options=(), says="", refused=False, read=""):
    return Case("EXR", kind, "exr.py", "exr.py", name + ".exr", file(*parts),
                None if expected is None else lambda path: expected, options=options, says=says,
                refused=refused, read=read)


Z = {"Z": plane(9, 1, 100)}
UNUSED = "is not used|are not used"


def channel_rows():
    yield row("R, G, B", "rgb", [part(planes())], picture())
    yield row("R, G, B, A", "rgba", [part(planes(alpha=True))], picture(alpha=True))
    yield row("r, g, b", "small", [part({n.lower(): v for n, v in planes().items()})], picture())
    yield row("R, G, B, Z", "rgbz", [part({**planes(), **Z})], picture(), says=UNUSED,
              read="R, G, B")
    yield row("R, G, B, A, Z", "rgbaz", [part({**planes(alpha=True), **Z})], picture(alpha=True),
              says=UNUSED, read="R, G, B, A")
    yield row("half R, G, B and float Z", "mixed",
              [part({**{n: v.astype(numpy.float16) for n, v in planes().items()}, **Z})],
              Picture(picture().color.astype(numpy.float16).astype(numpy.float64)), says=UNUSED,
              read="R, G, B")
    yield row("two layers besides", "layers", [part({**planes(), **planes("diffuse", 4)})],
              picture(), says=UNUSED, read="R, G, B")
    yield row("two layers besides", "layers", [part({**planes(), **planes("diffuse", 4)})],
              picture("diffuse", 4), options=("--channels", "diffuse"), read="diffuse.R, G, B")
    yield row("one layer", "layer", [part(planes("beauty", 4, alpha=True))],
              picture("beauty", 4, alpha=True), says="only layer", read="its R, G, B, A")
    yield row("two layers", "two", [part({**planes("diffuse"), **planes("specular", 4)})],
              refused=True, says="2 layers: diffuse, specular; --channels diffuse")
    yield row("two layers", "two", [part({**planes("diffuse"), **planes("specular", 4)})],
              picture("specular", 4), options=("--channels", "specular.R,specular.G,specular.B"))
    yield row("X, Y, Z", "xyz", [part(xyz(1))], xyz_picture(1))
    yield row("normal.X, Y, Z", "vectors", [part({"normal." + n: v for n, v in xyz(1).items()})],
              refused=True, says="--channels")
    yield row("U, V, W", "uvw", [part(dict(zip("UVW", planes().values())))], refused=True,
              says="cannot be told; --channels")
    yield row("Z alone", "z", [part({"Z": plane(3)})], refused=True, says="--channels Z")
    yield row("Z alone", "z", [part({"Z": plane(3)})], grey(3), options=("--channels", "Z"))
    yield row("A alone", "a", [part({"A": plane(3)})], refused=True, says="--channels A")
    yield row("Y", "y", [part({"Y": plane(3)})], grey(3))
    yield row("Y", "rgb", [part(planes())], grey(2), options=("--channels", "G"), read="G as grey")
    yield row("shade alone", "lone", [part({"shade": plane(3)})], grey(3), says="taken for grey")
    yield row("whole numbers", "uint", [part({"count": (plane(3) * 9).astype(numpy.uint32)})],
              refused=True, says="whole numbers")


def part_rows():
    far = part(planes(seed=4), "far", origin=(-5, 7), display=(0, 0, 63, 47))
    first = part(planes(), "near", display=(0, 0, 63, 47))
    small = part({n: v[:5, :7] for n, v in planes(seed=4).items()}, "small",
                 display=(0, 0, 63, 47))
    depth = part(Z, "depth", display=(0, 0, 63, 47))
    says = r"of its parts 0 \(near\), 1 \((far|small)\) only number 0"
    yield row("two parts with other windows", "parts", [first, far], picture(), says=says,
              read="the first part")
    yield row("two parts with other windows", "parts", [first, far], picture(seed=4),
              options=("--part", "far"), says="only number 1")
    yield row("two parts of other sizes", "sizes", [first, small], picture(), says=says,
              read="the first part")
    yield row("two parts of other sizes", "sizes", [first, small],
              Picture(picture(seed=4).color[:5, :7]), options=("--part", "1"),
              says="only number 1")
    yield row("two parts of other sizes", "sizes", [first, small], options=("--part", "x"),
              refused=True, says=r"no part 'x'; it has 0 \(near\), 1 \(small\)")
    yield row("depth, then colours", "later", [depth, first], refused=True,
              says=r"--part chooses among its parts 0 \(depth\), 1 \(near\)")
    yield row("depth, then colours", "later", [depth, first], picture(),
              options=("--part", "near"), says="only number 1")
    views = {**planes(), **planes("right", 4)}
    yield row("two views, the left by default", "views",
              [part(views, attributes=[exr.texts("multiView", ["left", "right"])])], picture(),
              says=UNUSED, read="the default view")
    yield row("two views", "views",
              [part(views, attributes=[exr.texts("multiView", ["left", "right"])])],
              picture("right", 4), options=("--channels", "right"))


def chroma(path):
    """Luminance and chroma (OpenEXR technical introduction): RY = (R - Y)/Y, BY = (B - Y)/Y, every
    second of them in x and y. Of one hue and saturation, which subsampling leaves as it is.
    """
    weights = [0.2126390, 0.7151687, 0.0721923]
    rgb_of_one = numpy.array([0.9, 0.5, 0.2])
    y_of_one = weights @ rgb_of_one
    y = (plane(3, 0.1, 0.5)).astype(numpy.float16)
    ry, by = (numpy.full((HEIGHT // 2, WIDTH // 2), (c - y_of_one) / y_of_one, numpy.float16)
              for c in (rgb_of_one[0], rgb_of_one[2]))
    exr.write(path, exr.Part({"Y": y, "RY": ry, "BY": by},
                             sampling={"RY": (2, 2), "BY": (2, 2)}))
    run("exrheader", path)


def chroma_picture(path):
    return Picture(plane(3, 0.1, 0.5)[..., None].astype(numpy.float16)
                   * numpy.array([0.9, 0.5, 0.2]) / (numpy.array(
                       [0.2126390, 0.7151687, 0.0721923]) @ numpy.array([0.9, 0.5, 0.2])))


def chroma_rows():
    yield Case("EXR", "Y, RY, BY (luminance and chroma)", "exr.py", "exr.py", "chroma.exr", chroma,
               chroma_picture, limit=0.2, says="luminance and chroma")


CAMERA_RAW = """<?xpacket begin="" id="W5M0MpCehiHzreSzNTczkc9d"?>
<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">
<rdf:Description rdf:about="" xmlns:crs="http://ns.adobe.com/camera-raw-settings/1.0/"
 crs:LuminanceAdjustmentAquamarine="12" crs:ParametricHighlightSplit="75"></rdf:Description>
</rdf:RDF></x:xmpmeta>
<?xpacket end="w"?>
"""


def metadata_rows():
    name = "a.name.of.more.than.thirty-one.characters"
    yield row("a long name of metadata", "long",
              [part(planes(), attributes=[exr.text(name, "value")])], picture(),
              says=f"left out: {name}")

    def png(path):
        info = PngInfo()
        for key in ("dataWindow", "displayWindow", "lineOrder", "tiles", "preview", "view", name):
            info.add_text(key, "value")
        rgb().save(path, pnginfo=info)
    yield Case("PNG", "text under names of EXR's own", "Pillow", "Pillow", "names.png", png,
               by_pillow, says="left out: .*dataWindow")

    def xmp(path):
        rgb().save(path, quality=95)
        packet = path.with_suffix(".xmp")
        packet.write_text(CAMERA_RAW)
        run("exiftool", "-q", "-overwrite_original", f"-xmp<={packet}", path)
    yield Case("JPEG", "XMP of Camera Raw", "exiftool", "Pillow", "xmp.jpg", xmp, by_pillow,
               says="left out: crs:LuminanceAdjustmentAquamarine")


def rows():
    for kind in (channel_rows, part_rows, chroma_rows, metadata_rows):
        yield from kind()
