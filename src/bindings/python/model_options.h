#pragma once

#include <specbake/core/color.h>
#include <specbake/core/upsampler_options.h>

#include <optional>
#include <string>

namespace specbake::python {

/// The space of that name. Throws ArgumentError.
const ColorSpace& spaceNamed(const std::string& name);

/// How colours become spectra, of the words that Python has for it. Throws ArgumentError.
UpsamplerOptions modelOptions(const std::optional<std::string>& light, const std::string& method,
                              const std::string& outside, std::optional<int> grid);

}  // namespace specbake::python
