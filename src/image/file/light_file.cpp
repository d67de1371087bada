#include "file/text_table.h"

#include <specbake/core/error.h>
#include <specbake/core/observer.h>
#include <specbake/image/light_file.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace specbake {

using namespace internal;

namespace {

constexpr std::size_t kMostSamples = 100'000;

std::vector<LightSample> pairs(const std::string& text) {
    std::vector<LightSample> samples;
    for (const std::vector<double>& row : rowsOfTable(text, 2, kMostSamples)) {
        samples.push_back({row[0], row[1]});
    }
    return samples;
}

/// Of a line such as SPECTRAL_START_NM "380.0".
std::optional<double> field(const std::string& text, const std::string& name) {
    const std::size_t at = text.find(name + " ");
    if (at == std::string::npos) return {};
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const auto numbers = numbersIn(text.substr(at + name.size(), end - at - name.size()));
    return numbers.empty() ? std::nullopt : std::optional(numbers.front());
}

std::vector<LightSample> cgats(const std::string& text) {
    const auto first = field(text, "SPECTRAL_START_NM");
    const auto last = field(text, "SPECTRAL_END_NM");
    const std::size_t begin = text.find("\nBEGIN_DATA\n");
    const std::size_t end = text.find("\nEND_DATA");
    if (!first || !last || begin == std::string::npos || end == std::string::npos || end < begin) {
        return {};
    }
    const auto powers = numbersIn(text.substr(begin + 12, end - begin - 12));
    std::vector<LightSample> samples;
    for (std::size_t i = 0; i < powers.size() && powers.size() > 1; ++i) {
        const double share = double(i) / double(powers.size() - 1);
        samples.push_back({*first + share * (*last - *first), powers[i]});
    }
    return samples;
}

}  // namespace

std::string readLight(const std::string& path) {
    const std::string text = textOfTable(path);
    const auto samples = text.starts_with("SPECT") ? cgats(text) : pairs(text);
    if (samples.empty()) {
        throw FileError(path, "no table of wavelengths in nm and powers");
    }
    try {
        return lightText(std::filesystem::path(path).filename().string(), lightPower(samples));
    } catch (const ArgumentError& error) {
        throw FileError(path, error.what());
    }
}

}  // namespace specbake
