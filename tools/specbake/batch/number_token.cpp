#include "batch/number_token.h"

#include <algorithm>
#include <cctype>

namespace specbake::tool {
namespace {

constexpr int kMostDigits = 9;
const char* const kUdim = "[1-9][0-9][0-9][0-9]";

std::string digits(int count) {
    std::string glob;
    for (int i = 0; i < count; ++i) glob += "[0-9]";
    return glob;
}

std::vector<std::string> atLeast(int count) {
    std::vector<std::string> globs;
    for (int n = std::max(count, 1); n <= std::max(count, kMostDigits); ++n) {
        globs.push_back(n > std::max(count, 1) ? "[1-9]" + digits(n - 1) : digits(n));
    }
    return globs;
}

/// u1_v1 to u99_v99.
std::vector<std::string> uvTiles() {
    const std::string one = "[1-9]";
    const std::string two = "[1-9][0-9]";
    std::vector<std::string> globs;
    for (const std::string& u : {one, two}) {
        for (const std::string& v : {one, two}) {
            std::string glob = "u";
            globs.push_back(glob.append(u).append("_v").append(v));
        }
    }
    return globs;
}

std::optional<NumberToken> findTile(const std::string& name) {
    for (const char* word : {"<UDIM>", "%(UDIM)d", "_MAPID_"}) {
        const std::size_t at = name.find(word);
        if (at != std::string::npos) return NumberToken{at, std::string(word).size(), {kUdim}};
    }
    for (const char* word : {"<UVTILE>", "%(UVTILE)d"}) {
        const std::size_t at = name.find(word);
        if (at != std::string::npos) return NumberToken{at, std::string(word).size(), uvTiles()};
    }
    return {};
}

/// Of `####`: a digit for each; of a single # four, as oiiotool has it.
std::optional<NumberToken> findHashes(const std::string& name) {
    const std::size_t begin = name.find('#');
    if (begin == std::string::npos) return {};
    const std::size_t end = std::min(name.find_first_not_of('#', begin), name.size());
    const int count = end - begin == 1 ? 4 : int(end - begin);
    return NumberToken{begin, end - begin, atLeast(count)};
}

/// `%d` and `%04d`, as of printf().
std::optional<NumberToken> findConversion(const std::string& name) {
    for (std::size_t begin = name.find('%'); begin != std::string::npos;
         begin = name.find('%', begin + 1)) {
        std::size_t end = begin + 1;
        int width = 0;
        while (end < name.size() && std::isdigit(static_cast<unsigned char>(name[end])) != 0 &&
               width < kMostDigits) {
            width = 10 * width + (name[end++] - '0');
        }
        const bool padded = end == begin + 1 || name[begin + 1] == '0';
        if (end < name.size() && name[end] == 'd' && padded && width <= kMostDigits) {
            return NumberToken{begin, end + 1 - begin, atLeast(width)};
        }
    }
    return {};
}

}  // namespace

std::optional<NumberToken> findNumberToken(const std::string& name) {
    if (auto tile = findTile(name)) return tile;
    if (auto conversion = findConversion(name)) return conversion;
    return findHashes(name);
}

}  // namespace specbake::tool
