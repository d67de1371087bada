#include "color/names.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace specbake::internal {
namespace {

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
}

}  // namespace

std::string lowerCase(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(), lower);
    return result;
}

std::string bareName(std::string_view name) {
    std::string bare = lowerCase(name);
    std::erase_if(bare, [](char c) { return !isDigit(c) && !(c >= 'a' && c <= 'z'); });
    return bare;
}

std::string decimal(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

std::string decimals(std::span<const double> values) {
    std::string text;
    for (const double value : values) {
        if (!text.empty()) text += ',';
        text += decimal(value);
    }
    return text;
}

std::optional<std::vector<double>> numbersOf(std::string_view text) {
    std::vector<double> numbers;
    const char* at = text.data();
    const char* end = at + text.size();
    while (true) {
        while (at != end && *at == ' ') ++at;
        double value = 0;
        const auto parsed = std::from_chars(at, end, value);
        if (parsed.ec != std::errc() || !std::isfinite(value)) return {};
        numbers.push_back(value);
        at = parsed.ptr;
        if (at == end) return numbers;
        if (*at++ != ',') return {};
    }
}

}  // namespace specbake::internal
