#include "color/names.h"

#include <specbake/core/error.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace specbake {

using namespace internal;

namespace {

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

}  // namespace specbake
