#pragma once

#include <specbake/core/upsampler_options.h>

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace specbake::python {

/// "400:700:10", or the wavelengths themselves, nm.
using WavelengthWords = std::variant<std::string, std::vector<double>>;

/// How colours become spectra, in the words that Python has for it.
struct ModelWords {
    std::optional<std::string> light;
    std::string adapt;
    std::optional<std::string> method;  ///< none: the default
    std::string outside;
    std::optional<int> grid;
    std::optional<std::string> material;
    std::optional<std::filesystem::path> samples;  ///< measured reflectances (measured_file.h)
    std::optional<std::string> quadrature;         ///< none: fine with wavelengths, else bands
    std::optional<WavelengthWords> wavelengths;
    std::string observer = "2";  ///< as of observerNamed()
};

/// Throws ArgumentError; the FileError of the samples goes on.
UpsamplerOptions modelOptions(const ModelWords& words);

/// Throw ArgumentError for a name that there is not.
Adaptation adaptationNamed(const std::string& name);
Quadrature quadratureNamed(const std::string& name);

/// The name of a light as it is; what is none, as a file with its spectrum (light_file.h).
std::string lightNamed(const std::string& name);

/// "2", "10" or a name as it is; what is none, as a file with a table (observer_file.h).
std::string observerNamed(const std::string& name);

/// The wavelengths, evenly spaced. Throws ArgumentError for others.
Wavelengths wavelengthsOf(const WavelengthWords& words);

}  // namespace specbake::python
