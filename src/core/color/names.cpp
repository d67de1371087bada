#include "color/names.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>

namespace specbake::internal {
namespace {

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
}

/// How many letters are put in, left out, replaced, or swapped with their neighbour (Damerau 1964),
/// no letter more than once; three rows of the table at a time.
std::size_t edits(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1);
    std::vector<std::size_t> above(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t(0));
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before.swap(above);
        above.swap(row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({replaced, row[j - 1] + 1, above[j] + 1});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
        }
    }
    return row.back();
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

std::optional<std::string> nearestName(std::string_view text, std::span<const std::string> names) {
    constexpr std::size_t longest = 64;  // whoever types more did not mean a name
    const std::string bare = bareName(text);
    if (bare.size() > longest) return {};
    std::optional<std::string> nearest;
    std::size_t fewest = bare.size() / 3 + 1;  // this many are too many
    for (const std::string& name : names) {
        const std::size_t distance = edits(bare, bareName(name));
        if (distance >= fewest) continue;
        fewest = distance;
        nearest = name;
    }
    return nearest;
}

std::string suggestion(std::string_view text, std::span<const std::string> names) {
    const auto name = nearestName(text, names);
    return name ? "; did you mean '" + *name + "'?" : "";
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
