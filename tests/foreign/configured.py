#!/usr/bin/python3
"""Whether colours by a configuration of OpenColorIO are those that oiiotool converts by it.

    configured.py PROGRAM WORK

Makes a configuration with a curve from a table, a look, a space by formula and file rules, bakes
small textures by it with PROGRAM (build/specbake), and compares the colours of the spectra with
those that `oiiotool --colorconvert` makes of the same textures. Exit status 77 if oiiotool is
missing or PROGRAM was built without OpenColorIO, unless CI is set: then, and if a colour differs,
it is 1.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

import numpy

SKIPPED = 77
# Rec.709 to AP0, adapted by Bradford from D65 to the ACES white; the digits do not matter here.
TO_AP0 = ("0.4395857, 0.3839294, 0.1765327, 0, 0.0895396, 0.8147498, 0.0956845, 0, "
          "0.0173872, 0.1087394, 0.8738206, 0, 0, 0, 0, 1")
CONFIG = f"""ocio_profile_version: 2
search_path: tables
roles:
  aces_interchange: Reference
  scene_linear: Working
  default: Numbers
  texture_paint: Encoded
file_rules:
  - !<Rule> {{name: painted, colorspace: Painted, pattern: "*_painted*", extension: "*"}}
  - !<Rule> {{name: Default, colorspace: default}}
displays:
  screen:
    - !<View> {{name: Raw, colorspace: Numbers}}
looks:
  - !<Look>
    name: warm
    process_space: Working
    transform: !<CDLTransform> {{slope: [1.1, 1, 0.8], offset: [0.01, 0, 0]}}
colorspaces:
  - !<ColorSpace>
    name: Reference
    bitdepth: 32f
  - !<ColorSpace>
    name: Working
    aliases: [WORKING_ALIAS]
    bitdepth: 32f
    to_scene_reference: !<BuiltinTransform> {{style: ACEScg_to_ACES2065-1}}
  - !<ColorSpace>
    name: Encoded
    bitdepth: 8ui
    to_scene_reference: !<GroupTransform>
      children:
        - !<ExponentWithLinearTransform> {{gamma: [2.4, 2.4, 2.4, 1], offset: [0.055, 0.055, 0.055, 0]}}
        - !<MatrixTransform> {{matrix: [{TO_AP0}]}}
  - !<ColorSpace>
    name: Painted
    bitdepth: 8ui
    to_scene_reference: !<GroupTransform>
      children:
        - !<FileTransform> {{src: paint.spi1d, interpolation: linear}}
        - !<ColorSpaceTransform> {{src: Working, dst: Reference}}
  - !<ColorSpace>
    name: Graded
    bitdepth: 8ui
    to_scene_reference: !<LookTransform> {{src: Working, dst: Reference, looks: warm}}
  - !<ColorSpace>
    name: Numbers
    isdata: true
"""


def table(power):
    rows = "\n".join(f"  {(i / 63) ** power:.9f}" for i in range(64))
    return f"Version 1\nFrom 0.0 1.0\nLength 64\nComponents 1\n{{\n{rows}\n}}\n"


class Room:
    def __init__(self, program, work):
        self.program, self.work = program, work
        self.failures = 0
        self.config = work / "studio.ocio"
        (work / "tables").mkdir(parents=True, exist_ok=True)
        self.write("WORKING_ALIAS", 2.1)
        self.images = pathlib.Path(__file__).resolve().parents[2] / "testimages"

    def write(self, alias, power):
        self.config.write_text(CONFIG.replace("WORKING_ALIAS", alias))
        (self.work / "tables" / "paint.spi1d").write_text(table(power))

    def run(self, *words, config=None):
        environment = {k: v for k, v in os.environ.items() if k != "OCIO"}
        if config:
            environment["OCIO"] = str(config)
        return subprocess.run([str(w) for w in words], env=environment, capture_output=True,
                              text=True, check=False)

    def tool(self, *words, **options):
        return self.run(self.program, *words, **options)

    def check(self, right, what):
        if not right:
            self.failures += 1
            print("wrong:", what)

    def bake(self, texture, name, *words, **options):
        output = self.work / name
        done = self.tool("bake", "-q", "-d", "float", "--per-texel", texture, "-o", output, *words,
                         **options)
        self.check(done.returncode == 0, f"bake {' '.join(map(str, words))}: {done.stderr}")
        return output

    def has_colors(self, spectral, colors, what):
        """To CIEDE2000 0.01: both convert in single precision."""
        done = self.tool("verify", spectral, colors, "--space", "acescg", "--max-de", "0.01",
                         "--no-independent", "--adapt", "bradford")
        self.check(done.returncode == 0, f"{what}: {done.stdout}{done.stderr}")


def compared(room, texture, space, *words, **options):
    converted = room.work / "converted.exr"
    done = room.run("oiiotool", texture, "-d", "float", "--ch", "R,G,B", "--colorconfig",
                    room.config, "--colorconvert", space, "Working", "-o", converted)
    room.check(done.returncode == 0, f"oiiotool: {done.stderr}")
    given = room.bake(texture, "given.exr", *words, **options)
    room.has_colors(given, converted, f"{texture.name} in {space} by {words}")
    return given


def check_spaces(room):
    for name in ("rgb16.png", "rgb_float.exr"):
        for space in ("Encoded", "Painted", "Graded", "Working"):
            compared(room, room.images / name, space, "--colorconfig", room.config,
                     "--space", space)
    room.write("lin_ap1", 2.1)  # colours then go to acescg, and not by the role to aces2065-1
    compared(room, room.images / "rgb8.png", "Painted", "--colorconfig", room.config,
             "--space", "painted")
    room.write("WORKING_ALIAS", 2.1)
    compared(room, room.images / "rgb8.png", "Encoded", "--colorconfig", room.config,
             "--space", "texture_paint")
    compared(room, room.images / "rgb8.png", "Encoded", "--space", "Encoded", config=room.config)


def check_rules(room):
    painted = room.work / "wood_painted.png"
    shutil.copy(room.images / "rgb8.png", painted)
    baked = compared(room, painted, "Painted", "--colorconfig", room.config)
    done = room.tool("verify", baked, painted, "--colorconfig", room.config)
    room.check(done.returncode == 0, "verify by the configuration: " + done.stdout + done.stderr)
    done = room.tool("verify", baked, painted)
    room.check(done.returncode == 1 and "--colorconfig" in done.stderr, "verify without it")
    # No rule, and a name that only specbake has: as without a configuration.
    plain = room.images / "rgb8.png"
    for words in ((), ("--space", "adobergb")):
        a = room.bake(plain, "a.exr", "--colorconfig", room.config, *words).read_bytes()
        room.check(a == room.bake(plain, "b.exr", *words).read_bytes(), f"no rule, {words}")


def check_update(room):
    """What the table says is in the identity; what is about other spaces is not."""
    texture, output = room.images / "rgb8.png", room.work / "updated.exr"
    words = ("bake", "-u", "-v", texture, "-o", output, "--colorconfig", room.config, "--space",
             "Painted")
    room.tool(*words)
    room.check("up to date" in room.tool(*words).stdout, "made again though nothing changed")
    room.write("WORKING_ALIAS", 1.7)
    done = room.tool(*words)
    room.check(done.returncode == 0 and "up to date" not in done.stdout, "not made again")
    room.write("WORKING_ALIAS", 2.1)
    done = room.tool("verify", output, texture, "--colorconfig", room.config)
    room.check(done.returncode == 1 and "changed" in done.stderr, "verified by another table")


def check_numbers(room):
    """Colours that are typed, and tables: of the same spaces."""
    words = ("--colorconfig", room.config, "--space")
    typed = (0.8, 0.3, 0.1)
    room.write("lin_ap1", 2.1)  # so that colours go to acescg
    for space in ("Encoded", "Painted", "Graded", "Working"):
        converted = room.work / "typed.exr"
        done = room.run("oiiotool", "--create", "1x1", 3, "-d", "float", "--fill:color=" +
                        ",".join(map(str, typed)), "1x1", "--colorconfig", room.config,
                        "--colorconvert", space, "Working", "-o", converted)
        room.check(done.returncode == 0, f"oiiotool: {done.stderr}")
        done = room.run("oiiotool", "--info", "--dumpdata", converted)
        linear = re.search(r"\): +([-0-9.e]+) ([-0-9.e]+) ([-0-9.e]+)", done.stdout).groups()
        ours = room.tool("solve", "--json", "--rgb", *typed, *words, space)
        theirs = room.tool("solve", "--json", "--rgb", *linear, "--space", "acescg")
        room.check(ours.returncode == theirs.returncode == 0, f"solve: {ours.stderr}")
        # Nine digits of single precision are printed; XYZ of ACES are up to 1.1 of RGB.
        asked = [json.loads(done.stdout)["asked_xyz"] for done in (ours, theirs)]
        room.check(max(abs(a - b) for a, b in zip(*asked)) < 1e-6, f"solve in {space}: {asked}")
    room.write("WORKING_ALIAS", 2.1)


def chromaticities(matrix):
    """Of the primaries and the white, from a matrix to AP0 (SMPTE ST 2065-1 has its primaries)."""
    def tristimulus(x, y):
        return numpy.array([x / y, 1, (1 - x - y) / y])
    white = tristimulus(0.32168, 0.33767)
    ap0 = numpy.array([tristimulus(0.7347, 0.2653), tristimulus(0, 1), tristimulus(0.0001, -0.077)])
    ap0 = ap0 * numpy.linalg.solve(ap0.T, white)[:, None]
    colors = numpy.array(matrix).T @ ap0
    for color in (*colors, colors.sum(axis=0)):
        yield from color[:2] / color.sum()


def check_tables(room):
    def table(name, *words):
        output = room.work / name
        done = room.tool("table", "--grid", 2, "-o", output, *words)
        room.check(done.returncode == 0, f"table {words}: {done.stderr}")
        return output.read_bytes()

    config = ("--colorconfig", room.config)
    room.check(table("w.spectab", *config, "--space", "scene_linear") ==
               table("a.spectab", "--space", "acescg"), "a table of the role scene_linear")
    room.check(table("s.spectab", *config) == table("t.spectab"), "without --space it is sRGB")
    text = table("e.spectab", *config, "--space", "Encoded").decode("latin-1")
    said = re.search(r"identity=.*custom \(([-0-9.,]+)\)", text).group(1)
    ours = [float(number) for number in said.split(",")]
    numbers = [float(n) for n in TO_AP0.split(",")]
    expected = list(chromaticities([numbers[0:3], numbers[4:7], numbers[8:11]]))
    # Six decimals, of what single precision leaves of them.
    room.check(max(abs(a - b) for a, b in zip(ours, expected)) < 3e-6, f"{ours} for {expected}")
    done = room.tool("table", "-o", room.work / "g.spectab", *config, "--space", "Graded")
    room.check(done.returncode == 2 and "linear RGB" in done.stderr, f"a look: {done.stderr}")


def check_refusals(room):
    texture, output = room.images / "rgb8.png", room.work / "refused.exr"
    for words, reason in ((("--space", "Numbers"), "data"), (("--space", "Paintd"), "Painted"),
                          (("--space", "Painted", "--transfer", "srgb"), "--transfer")):
        done = room.tool("bake", texture, "-o", output, "--colorconfig", room.config, *words)
        room.check(done.returncode == 2 and reason in done.stderr, f"{words}: {done.stderr}")
    broken = room.work / "broken.ocio"
    broken.write_text("colorspaces: 1\n")
    done = room.tool("bake", texture, "-o", output, "--colorconfig", broken)
    room.check(done.returncode == 1 and "broken.ocio" in done.stderr, f"broken: {done.stderr}")
    room.check(not output.exists(), "refused, and written all the same")


def main():
    program, work = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    work.mkdir(parents=True, exist_ok=True)
    skipped = 1 if os.environ.get("CI") else SKIPPED
    if shutil.which("oiiotool") is None:
        print("not run: oiiotool is missing")
        return skipped
    room = Room(program, work)
    without = room.tool("bake", room.images / "1x1.png", "-o", work / "x.exr", "--colorconfig",
                        room.config, "--space", "Encoded")
    if "built without" in without.stderr:
        print("not run: built without OpenColorIO")
        return skipped
    for check in (check_spaces, check_rules, check_numbers, check_tables, check_update,
                  check_refusals):
        check(room)
    print(json.dumps({"failures": room.failures}))
    return 1 if room.failures else 0


sys.exit(main())
