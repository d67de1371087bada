#include "texture/openimageio/subimages.h"

#include "texture/openimageio/one_line.h"

#include <specbake/core/error.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <vector>

namespace specbake::internal {
namespace {

/// A list of names need not go on for ever, as a film does.
constexpr int kMostListed = 100;

std::string nameOf(const OIIO::ImageSpec& spec) {
    return spec.get_string_attribute("oiio:subimagename", spec.get_string_attribute("name"));
}

/// Null, and OIIO::geterror() says why, for what cannot be opened.
std::unique_ptr<OIIO::ImageInput> open(const std::string& path, bool raw) {
    OIIO::ImageSpec wishes;
    wishes["oiio:UnassociatedAlpha"] = 1;
    if (raw) wishes["oiio:RawColor"] = 1;
    return OIIO::ImageInput::open(path, &wishes);
}

bool holdsLab(const OIIO::ImageSpec& spec) {
    constexpr int cieLab = 8;
    constexpr int iccLab = 9;
    const int photometric = spec.get_int_attribute("tiff:PhotometricInterpretation");
    return photometric == cieLab || photometric == iccLab;
}

/// The names of the first subimages; those without one are empty.
std::vector<std::string> namesIn(const std::string& path) {
    const auto input = openSubimage(path, 0);
    std::vector<std::string> names;
    while (int(names.size()) < kMostListed && input->seek_subimage(int(names.size()), 0)) {
        names.push_back(nameOf(input->spec()));
    }
    static_cast<void>(input->geterror());
    return names;
}

bool exists(const std::string& path, int subimage, int level) {
    const auto input = openSubimage(path, 0);
    const bool found = input->seek_subimage(subimage, level);
    static_cast<void>(input->geterror());
    return found;
}

std::string listed(const std::vector<std::string>& names) {
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i) {
        list += (i == 0 ? "" : ", ") + std::to_string(i);
        if (!names[i].empty()) list += " (" + names[i] + ")";
    }
    return names.size() == std::size_t(kMostListed) ? list + ", …" : list;
}

}  // namespace

std::unique_ptr<OIIO::ImageInput> openSubimage(const std::string& path, int subimage, bool raw) {
    auto input = open(path, raw);
    if (!input) {
        const std::string reason = oneLine(OIIO::geterror());
        // Lab with alpha is refused, but for its numbers as they are (OpenImageIO 2.4.7).
        if (!raw) input = open(path, true);
        static_cast<void>(OIIO::geterror());
        std::error_code ignored;
        const bool there = input || std::filesystem::exists(path, ignored);
        if (!there) throw FileError(path, "no such file");
        if (!input || !holdsLab(input->spec())) throw FileError(path, reason);
    }
    input->threads(1);
    if (subimage != 0 && !input->seek_subimage(subimage, 0)) {
        throw FileError(path, "no part " + std::to_string(subimage));
    }
    return input;
}

int subimageNumber(const std::string& path, const std::string& part) {
    const std::vector<std::string> names = namesIn(path);
    const auto named = std::find(names.begin(), names.end(), part);
    if (named != names.end() && !part.empty()) return int(named - names.begin());
    int number = -1;
    const char* end = part.data() + part.size();
    const auto parsed = std::from_chars(part.data(), end, number);
    const bool isNumber = parsed.ec == std::errc() && parsed.ptr == end && number >= 0;
    if (isNumber && (number < int(names.size()) || exists(path, number, 0))) return number;
    throw FileError(path, "no part '" + part + "'; it has " + listed(names));
}

std::string subimageNames(const std::string& path) {
    const auto input = openSubimage(path, 0);
    const std::string_view format = input->format_name();
    if (!exists(path, 1, 0)) return {};
    // Frames would have to be decoded to be counted.
    return format == "openexr" || format == "psd" ? listed(namesIn(path)) : "0, 1, …";
}

bool hasMipLevels(const std::string& path, int subimage) {
    return exists(path, subimage, 1);
}

}  // namespace specbake::internal
