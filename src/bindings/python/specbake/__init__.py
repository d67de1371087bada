"""Reflectance spectra of colours and textures.

    import numpy, specbake

    model = specbake.Upsampler(space="srgb")                # what the numbers are
    spectra = model.spectra(image)                          # (h, w, 3) -> (h, w, 81) float32
    specbake.bake("wood.png", "wood.exr")                   # a texture to a spectral image

Spectra are reflectances from 0 to 1 at WAVELENGTHS, 380 to 780 nm every 5 nm. docs/python.md has
examples.
"""

from ._specbake import (
    LIGHTS,
    MATERIALS,
    METHODS,
    SPACES,
    WAVELENGTHS,
    ArgumentError,
    BakeStatistics,
    Cancelled,
    Error,
    FileError,
    Observer,
    Solution,
    SpectralImage,
    Table,
    Upsampler,
    Verification,
    __version__,
    bake,
    read_spectral,
    relight,
    verify,
)

__all__ = [name for name in dir() if not name.startswith("_")]
