#pragma once

#include <specbake/core/api.h>

#include <string>

namespace specbake {

/// A light that was measured, in the form of lightText(): its label is the file's name. Reads text
/// of two columns, wavelength in nm and power, divided by commas, semicolons, tabs or spaces: CSV,
/// the .spd files of pbrt and Mitsuba, and what spectrometers export, words around the numbers
/// included ("Spectral Data 380[nm],0.0012"). Lines that begin with # and lines that are no pair
/// are passed over. The .sp files of ArgyllCMS (CGATS) are known by their first word, SPECT. Throws
/// FileError, with the line where that helps.
SPECBAKE_API std::string readLight(const std::string& path);

}  // namespace specbake
