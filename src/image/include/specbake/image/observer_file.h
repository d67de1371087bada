#pragma once

#include <specbake/core/api.h>

#include <string>

namespace specbake {

/// A table of colour-matching functions, in the form of observerText(): its label is the file's
/// name. Reads text of four columns, wavelength in nm, x̄, ȳ and z̄, divided by commas, semicolons,
/// tabs or spaces, as the CIE and the CVRL give them. Lines that begin with # and lines that are no
/// such row are passed over. Throws FileError.
SPECBAKE_API std::string readObserver(const std::string& path);

}  // namespace specbake
