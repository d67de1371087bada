#include "attribute_choices.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace specbake::tool {
namespace {

template <class Number>
std::optional<Number> numberIn(const std::string& text) {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, number);
    if (parsed.ec != std::errc() || parsed.ptr != end) return {};
    return number;
}

bool isWrapMode(std::string_view word) {
    constexpr std::array<std::string_view, 4> modes = {"black", "clamp", "periodic", "mirror"};
    return std::find(modes.begin(), modes.end(), word) != modes.end();
}

}  // namespace

AttributeValue attributeValue(const std::string& text) {
    if (const auto number = numberIn<int>(text)) return *number;
    const auto number = numberIn<float>(text);
    if (number && std::isfinite(*number)) return *number;
    return text;
}

std::string wrapModes(const std::string& text) {
    return text.find(',') == std::string::npos ? text + "," + text : text;
}

CLI::Validator wrapCheck() {
    const auto check = [](const std::string& text) {
        const std::string both = wrapModes(text);
        const std::size_t comma = both.find(',');
        const bool known = isWrapMode(std::string_view(both).substr(0, comma)) &&
                           isWrapMode(std::string_view(both).substr(comma + 1));
        return known ? std::string() : text + " is no wrap mode: black, clamp, periodic or mirror";
    };
    return {check, "", ""};
}

}  // namespace specbake::tool
