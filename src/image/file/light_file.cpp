#include <specbake/core/error.h>
#include <specbake/core/observer.h>
#include <specbake/image/light_file.h>

#include <charconv>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <vector>

namespace specbake {
namespace {

constexpr std::uintmax_t kLargestFile = std::uintmax_t(1) << 24;  // bytes
constexpr std::size_t kMostSamples = 100'000;

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// The numbers of a line, wherever they stand in it.
std::vector<double> numbersIn(const std::string& line) {
    std::vector<double> numbers;
    const char* at = line.data();
    const char* const end = at + line.size();
    while (at != end) {
        const bool begins = isDigit(*at) || ((*at == '-' || *at == '.') && at + 1 != end &&
                                             (isDigit(at[1]) || at[1] == '.'));
        double value = 0;
        const auto [next, error] = std::from_chars(at, end, value);
        if (begins && error == std::errc()) {
            numbers.push_back(value);
            at = next;
        } else {
            ++at;
        }
    }
    return numbers;
}

std::vector<LightSample> pairs(std::istream& in) {
    std::vector<LightSample> samples;
    for (std::string line; std::getline(in, line) && samples.size() < kMostSamples;) {
        const std::size_t first = line.find_first_not_of(" \t\r");
        if (first == std::string::npos || line[first] == '#') continue;
        const std::vector<double> numbers = numbersIn(line);
        constexpr double shortest = 200;
        constexpr double longest = 3000;  // nm: no head of a table
        if (numbers.size() != 2 || numbers[0] < shortest || numbers[0] > longest) continue;
        samples.push_back({numbers[0], numbers[1]});
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
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) throw FileError(path, "no such file");
    if (std::filesystem::file_size(path, ignored) > kLargestFile) {
        throw FileError(path, "too long for a table of a light");
    }
    std::ifstream in(path);
    std::ostringstream all;
    all << in.rdbuf();
    const std::string text = all.str();
    std::istringstream lines(text);
    const auto samples = text.starts_with("SPECT") ? cgats(text) : pairs(lines);
    if (!in || samples.empty()) {
        throw FileError(path, "no table of wavelengths in nm and powers");
    }
    try {
        return lightText(std::filesystem::path(path).filename().string(), lightPower(samples));
    } catch (const ArgumentError& error) {
        throw FileError(path, error.what());
    }
}

}  // namespace specbake
