#!/usr/bin/env python3
"""Draws docs/images/overview.png, the README's picture, from testimages/demo.png.

    docs/images/make_overview.py [SPECBAKE]      (default: build/specbake)

Needs python3-matplotlib. Run it again where the test image or the spectra change.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

ROOT = pathlib.Path(__file__).resolve().parents[2]
TEXTURE = ROOT / "testimages/demo.png"
TEXELS = [(45, 78), (72, 42), (131, 46), (183, 70), (241, 168), (142, 185), (44, 208), (122, 132)]
LIGHTS = [("A", "in lamplight (A)"), ("F11", "in fluorescent light (F11)")]
INK = "#24292f"


def specbake(*arguments):
    program = sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/specbake"
    return subprocess.run([program, *arguments], check=True, capture_output=True, text=True).stdout


def show(axes, image, title):
    axes.imshow(image, interpolation="lanczos")
    axes.set_title(title, fontsize=10, color=INK, pad=5)
    axes.set_xticks([])
    axes.set_yticks([])
    for side in axes.spines.values():
        side.set_visible(False)


def draw_texture(axes, texture):
    show(axes, texture, "texture")
    for x, y in TEXELS:
        axes.plot(x, y, "o", markersize=9, color=texture[y, x], markeredgecolor="white",
                  markeredgewidth=2)
        axes.plot(x, y, "o", markersize=11.5, color="none", markeredgecolor="#000a")


def draw_spectra(axes, texture, texels):
    wavelengths = range(380, 785, 5)
    for texel in texels:
        color = texture[texel["y"], texel["x"]]
        axes.plot(wavelengths, texel["reflectance"], color="#0006", linewidth=3.4)
        axes.plot(wavelengths, texel["reflectance"], color=color, linewidth=2.4)
    axes.set_xlim(380, 780)
    axes.set_ylim(0, 1)
    axes.set_xlabel("wavelength (nm)", fontsize=9, color=INK)
    axes.set_ylabel("reflectance", fontsize=9, color=INK)
    axes.set_title("spectra of eight of its texels", fontsize=10, color=INK, pad=5)
    axes.tick_params(labelsize=8, colors=INK)
    axes.grid(color="#d0d7de", linewidth=0.6)
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def main():
    texture = plt.imread(TEXTURE)
    figure = plt.figure(figsize=(12.2, 2.95), dpi=130, facecolor="white")
    side = 0.76 * 2.95 / 12.2  # of a square picture
    at = lambda left, width: figure.add_axes([left, 0.155, width, 0.76])
    with tempfile.TemporaryDirectory() as folder:
        spectral = folder + "/demo.exr"
        specbake("bake", TEXTURE, "-o", spectral, "-d", "float")
        places = [str(n) for texel in TEXELS for n in ("--at", *texel)]
        texels = json.loads(specbake("inspect", spectral, "--json", *places))["texels"]
        draw_texture(at(0.006, side), texture)
        draw_spectra(at(0.243, 0.365), texture, texels)
        for left, (illuminant, name) in zip((0.62, 0.811), LIGHTS):
            picture = f"{folder}/{illuminant}.png"
            specbake("relight", spectral, "-o", picture, "--illuminant", illuminant, "--no-adapt")
            show(at(left, side), plt.imread(picture), name)
    # Without the versions of the programs, so that the file changes where the picture does.
    figure.savefig(ROOT / "docs/images/overview.png", metadata={"Software": None})


main()
