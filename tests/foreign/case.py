"""One row of docs/inputs.md: a file that another program makes, what another program reads of it,
and what specbake bakes of it.
"""

import dataclasses
import pathlib
import re
import subprocess
import typing

import numpy

import color
import exr

# Bands are stored as floats and lie in [0, 1], so that each is off by at most 2^-25; their weighted
# sum, by as much of white. CIEDE2000 changes most at black: L* by 903.3 for a unit of Y, a* and b*
# by 500 and 200 times 7.787 for one of X, Y and Z, so at most 2^-25 (903 + 3894 sqrt 2) = 2e-4. The
# solver leaves 1e-7 of XYZ (docs/method.md): 1e-3 in all. White and samples of 8 to 32 bits are
# computed in double here and in float there (2^-24 of each): no more.
EXACT = 2e-3


@dataclasses.dataclass
class Picture:
    """What a program decoded: linear Rec.709, or XYZ, not multiplied by alpha."""

    color: numpy.ndarray  # height, width, 3
    alpha: typing.Optional[numpy.ndarray] = None  # height, width; 0 to 1
    is_xyz: bool = False
    white: typing.Optional[numpy.ndarray] = None  # of XYZ: adapted to the light of the bake
    compared: typing.Optional[numpy.ndarray] = None  # height, width; None: all texels
    encoded: typing.Optional[numpy.ndarray] = None  # sRGB from which color came


@dataclasses.dataclass
class Case:
    format: str
    kind: str
    maker: str  # the programs, for the table
    decoder: str
    name: str  # of the file
    make: typing.Callable[[pathlib.Path], None]
    decode: typing.Optional[typing.Callable[[pathlib.Path], Picture]] = None
    options: tuple = ()
    says: str = ""  # a pattern that a remark, or the refusal, must match
    refused: bool = False
    steps: float = 0  # of 8 bits by which a reader rounds what is multiplied by alpha
    limit: float = EXACT  # CIEDE2000
    read: str = ""  # what is read, for the table


@dataclasses.dataclass
class Outcome:
    mean: float = 0
    largest: float = 0
    texels: int = 0
    line: str = ""  # remark or refusal
    failure: str = ""


def run(*command, **kwargs):
    done = subprocess.run([str(c) for c in command], capture_output=True, check=False, **kwargs)
    if done.returncode != 0:
        raise RuntimeError(f"{command[0]}: {done.stderr.decode(errors='replace').strip()}")
    return done.stdout


def baked_colors(path, illuminant):
    """XYZ of each texel by the 81-term sum, and alpha."""
    channels, _ = exr.read(path)
    bands = sorted((n for n in channels if n.startswith("T.")),
                   key=lambda n: float(n[2:-2].replace(",", ".")))
    assert len(bands) == 81
    spectra = numpy.stack([channels[n] for n in bands], axis=-1).astype(numpy.float64)
    assert spectra.min() >= 0 and spectra.max() <= 1
    return spectra @ color.weights(illuminant), channels.get("A")


def light_of(path):
    return exr.read(path)[1]["specbake:illuminant"].decode()


def differences(picture, xyz, alpha, illuminant):
    """CIEDE2000 of each texel that is compared. Raises where sizes or alpha differ."""
    white = color.weights(illuminant).sum(axis=0)
    expected = picture.color
    if not picture.is_xyz:
        expected = expected @ color.rgb_to_xyz(white).T
    if expected.shape != xyz.shape:
        raise AssertionError(f"{expected.shape} texels expected, {xyz.shape} baked")
    opacity = numpy.ones(alpha.shape) if picture.alpha is None else picture.alpha
    if numpy.abs(opacity - alpha).max() > 1e-6:
        raise AssertionError(f"alpha off by {numpy.abs(opacity - alpha).max():.3g}")
    de = color.ciede2000(color.lab(expected, white), color.lab(xyz, white))
    return de if picture.compared is None else de[picture.compared]


def explained(picture, steps, illuminant):
    """The largest CIEDE2000 of each texel if a reader rounds colour times alpha by so many steps of 8
    bits: colour is off by steps / alpha in each channel.
    """
    white = color.weights(illuminant).sum(axis=0)
    matrix = color.rgb_to_xyz(white).T
    exact = color.lab(color.linear_from_srgb(picture.encoded) @ matrix, white)
    off = steps / 255 / numpy.maximum(picture.alpha, 1 / 255)[..., None]
    largest = numpy.zeros(picture.alpha.shape)
    for signs in numpy.ndindex(3, 3, 3):
        moved = numpy.clip(picture.encoded + off * (numpy.array(signs) - 1), 0, 1)
        lab = color.lab(color.linear_from_srgb(moved) @ matrix, white)
        largest = numpy.maximum(largest, color.ciede2000(exact, lab))
    return largest[picture.compared]


def judge(case, program, work):
    """Makes the file, bakes it, compares: an Outcome whose failure is empty if all is well."""
    source, baked = work / case.name, work / "baked" / (case.name + ".exr")
    baked.parent.mkdir(exist_ok=True)
    if not source.exists():
        case.make(source)
    done = subprocess.run([program, "bake", source, "-o", baked, "-d", "float", "--compression",
                           "none", *case.options], capture_output=True, check=False)
    said = done.stderr.decode(errors="replace").replace(str(source), case.name)
    lines = [line.removeprefix(f"specbake: {case.name}: ") for line in said.splitlines()]
    outcome = Outcome(line=" · ".join(lines))
    if done.returncode != (1 if case.refused else 0) or (case.refused and len(lines) != 1):
        outcome.failure = f"exit code {done.returncode}: {said}"
    elif not re.search(case.says or "^$", outcome.line):
        outcome.failure = f"said '{outcome.line}', not '{case.says}'"
    elif not case.refused:
        compare(case, program, source, baked, outcome)
    return outcome


def compare(case, program, source, baked, outcome):
    picture = case.decode(source)
    illuminant = light_of(baked)
    if picture.white is not None:
        light = color.weights(illuminant).sum(axis=0)
        picture.color = picture.color @ color.bradford(picture.white, light)
    xyz, alpha = baked_colors(baked, illuminant)
    try:
        de = differences(picture, xyz, numpy.float32(1) + 0 * xyz[..., 0] if alpha is None
                         else alpha, illuminant)
    except AssertionError as error:
        outcome.failure = str(error)
        return
    outcome.mean, outcome.largest, outcome.texels = de.mean(), de.max(), de.size
    limit = case.limit
    if case.steps:
        limit = limit + explained(picture, case.steps, illuminant)
    if not numpy.all(de <= limit):
        outcome.failure = f"CIEDE2000 mean {outcome.mean:.3g}, max {outcome.largest:.3g}"
    verified = subprocess.run([program, "verify", baked, source], capture_output=True, check=False)
    if verified.returncode != 0:
        outcome.failure += " verify: " + (verified.stdout + verified.stderr).decode().strip()
