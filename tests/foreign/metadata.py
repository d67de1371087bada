#!/usr/bin/python3
"""Whether what a photograph says of itself arrives in the spectral image.

    metadata.py PROGRAM WORK

exiftool writes Exif into a JPEG and a PNG, in both byte orders, and reads it back; PROGRAM
(build/specbake) bakes them; the attributes of the EXR must say the same. Exit status 77 if
exiftool is missing, unless CI is set: then, and if a value differs, it is 1.
"""

import json
import math
import os
import pathlib
import shutil
import sys

import exr
from case import run
from pictures import rgb

SKIPPED = 77
# What exiftool calls a tag, what it is set to, and what it is called in the EXR.
TAGS = (
    ("Make", "A maker", "Make"),
    ("Model", "Model 5", "Model"),
    ("Artist", "Zoë", "Artist"),
    ("Copyright", "2026 of nobody", "Copyright"),
    ("ImageDescription", "A wall: wet", "ImageDescription"),
    ("DateTimeOriginal", "2024:05:06 07:08:09", "Exif:DateTimeOriginal"),
    ("LensModel", "50mm f/1.8", "Exif:LensModel"),
    ("OffsetTime", "+02:00", "Exif:OffsetTime"),
    ("ExposureTime", 0.008, "ExposureTime"),
    ("FNumber", 7.1, "FNumber"),
    ("ISO", 400, "Exif:PhotographicSensitivity"),
    ("ExposureCompensation", -0.7, "Exif:ExposureBiasValue"),
    ("FocalLength", 50, "Exif:FocalLength"),
    ("Flash", 16, "Exif:Flash"),
    ("MeteringMode", 5, "Exif:MeteringMode"),
    ("SensitivityType", 2, "Exif:SensitivityType"),
    ("RecommendedExposureIndex", 70000, "Exif:RecommendedExposureIndex"),
    ("AmbientTemperature", -3.5, "Exif:Temperature"),
    ("GPSAltitude", 512.25, "GPS:Altitude"),
    ("GPSMapDatum", "WGS-84", "GPS:MapDatum"),
    ("GPSImgDirection", 123.5, "GPS:ImgDirection"),
)
FORMATS = ("jpg", "png")
# exiftool prints, and rounds, to ten digits; a fraction of Exif is kept as a float.
LIMIT = 2**-24 + 1e-9


def make(path, order):
    rgb().save(path)
    values = [f"-EXIF:{name}={value}" for name, value, _ in TAGS]
    run("exiftool", "-q", "-n", "-overwrite_original", f"-ExifByteOrder={order}", *values, path)


def by_exiftool(path):
    """What exiftool reads: {name of the tag: value}."""
    return json.loads(run("exiftool", "-n", "-j", "-EXIF:all", path))[0]


def same(expected, found):
    if isinstance(expected, str) or found is None:
        return expected == found
    return math.isclose(float(expected), found, rel_tol=LIMIT)


def differences(program, work, extension, order):
    """Lines on what differs."""
    path = work / f"photograph.{extension}"
    baked = work / "o.exr"
    make(path, order)
    run(program, "bake", "-q", path, "-o", baked)
    stated = by_exiftool(path)
    kept = exr.values(baked)
    for name, value, attribute in TAGS:
        expected = stated.get(name)
        if expected is None:
            yield f"{path.name}: exiftool did not write {name} = {value}"
        elif not same(str(expected) if isinstance(value, str) else expected, kept.get(attribute)):
            yield f"{path.name} ({order}): {attribute} is {kept.get(attribute)}, not {expected}"


def main():
    program, work = sys.argv[1], pathlib.Path(sys.argv[2])
    if not shutil.which("exiftool"):
        print("exiftool is missing")
        return 1 if os.environ.get("CI") else SKIPPED
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    failures = [line for extension in FORMATS for order in ("II", "MM")
                for line in differences(program, work, extension, order)]
    print("\n".join(failures) or f"{len(TAGS)} tags of {len(FORMATS)} formats: the same")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
