#pragma once

#include <specbake/core/upsampler_options.h>

#include <filesystem>
#include <optional>
#include <string>

namespace specbake::python {

/// How colours become spectra, of the words that Python has for it. Throws ArgumentError.
/// `method`: none for the default.
/// `samples`: a file of measured reflectances (measured_file.h), whose FileError goes on.
UpsamplerOptions modelOptions(const std::optional<std::string>& light,
                              const std::optional<std::string>& method, const std::string& outside,
                              std::optional<int> grid, const std::optional<std::string>& material,
                              const std::optional<std::filesystem::path>& samples);

}  // namespace specbake::python
