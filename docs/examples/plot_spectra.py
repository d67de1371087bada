#!/usr/bin/env python3
"""Plots the spectra of some colours, as `smooth` and as `natural` make them, and what illuminant A
makes of both:  plot_spectra.py [PICTURE.png]
"""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import specbake

COLORS = np.array([[200, 40, 35], [225, 130, 30], [70, 140, 60], [40, 80, 180], [150, 110, 90]],
                  dtype=np.uint8)  # sRGB, as a texture stores it


def srgb_under(light, spectra):
    """What an eye adapted to the light sees, encoded: the sum over the bands, von Kries in XYZ."""
    observer, daylight = specbake.Observer(light), specbake.Observer("D65")
    xyz = spectra @ observer.weights / observer.white * daylight.white
    # The matrix of linear Rec.709 is what its own primaries come to.
    linear = xyz @ np.linalg.inv(specbake.Upsampler("lin_rec709").xyz(np.eye(3)))
    v = np.clip(linear, 0, 1)
    return np.where(v <= 0.0031308, 12.92 * v, 1.055 * v ** (1 / 2.4) - 0.055)


def main(picture="spectra.png"):
    figure, axes = plt.subplots(1, 2, figsize=(10, 4), sharey=True, layout="constrained")
    for axis, method in zip(axes, ("smooth", "natural")):
        spectra = specbake.Upsampler("srgb", method=method).spectra(COLORS)
        under_a = srgb_under("A", spectra)
        for color, lit, spectrum in zip(COLORS / 255, under_a, spectra):
            axis.plot(specbake.WAVELENGTHS, spectrum, color=color, label="under D65")
            axis.plot(specbake.WAVELENGTHS[-1] + 12, spectrum[-1], "s", color=lit, markersize=9)
        axis.set(title=f"{method}; squares: under A", xlabel="wavelength, nm")
    axes[0].set_ylabel("reflectance")
    figure.savefig(picture, dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
