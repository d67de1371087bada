#include "identity/identity.h"

#include <specbake/image/file_fingerprint.h>

#include <fmt/format.h>

#include <array>
#include <charconv>

namespace specbake::internal {
namespace {

/// The shortest decimal that reads back as the same number.
std::string decimal(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

std::string joined(const std::vector<std::string>& words, std::string_view between) {
    return fmt::format("{}", fmt::join(words, between));
}

std::string described(const ReadOptions& read) {
    std::vector<std::string> words;
    if (!read.channels.empty()) words.push_back("channels " + joined(read.channels, ","));
    if (read.part) words.push_back("part " + *read.part);
    if (read.orient) words.emplace_back("turned");
    return words.empty() ? "read as it is" : joined(words, ", ");
}

/// What the texture does not say itself, since its bytes stand for that.
std::string described(const ColorWishes& color) {
    std::vector<std::string> words;
    if (color.space) words.push_back("space " + *color.space);
    if (color.transfer) words.push_back("transfer " + *color.transfer);
    if (color.primaries) words.push_back("primaries " + *color.primaries);
    return joined(words, ", ");
}

std::string bytesOf(const std::filesystem::path& image) {
    return fileFingerprint(image.string()).value_or("no file that could be compared");
}

/// The map's bytes, and what its channels are.
std::string describedMap(const BakeOptions& options) {
    return joined(options.mappedMaterials, ",") + " by a map of " + bytesOf(*options.materialMap);
}

std::string describedSecond(const BakeOptions& options) {
    return "under " + Observer(options.secondLight).illuminant() + " " + bytesOf(*options.second);
}

std::string precision(const BakeOptions& options) {
    std::string text(sampleTypeName(options.storage.sampleType));
    if (options.storage.sampleType == SampleType::half) {
        text += options.maxDE ? " within CIEDE2000 " + decimal(*options.maxDE)
                              : " of " + std::to_string(options.bits) + " bits";
    }
    if (options.maxDeviation) text += ", grid within " + decimal(*options.maxDeviation);
    return text;
}

std::string described(const StorageOptions& storage) {
    std::vector<std::string> words = {std::string(compressionName(storage.compression))};
    if (words.front().starts_with("zip")) {
        words.front() += ':';
        words.front() += std::to_string(storage.level);
    }
    if (storage.isTiled()) {
        const TileSize tile = storage.tile.value_or(TileSize());
        words.push_back("tiles " + std::to_string(tile.width) + " x " +
                        std::to_string(tile.height));
    }
    if (storage.mipmap) words.emplace_back("mip levels");
    return joined(words, ", ");
}

struct AsText {
    std::string operator()(const std::string& text) const { return text; }
    std::string operator()(int number) const { return std::to_string(number); }
    std::string operator()(float number) const { return decimal(double(number)); }
    std::string operator()(const std::vector<float>& numbers) const {
        std::vector<std::string> words;
        for (const float number : numbers) words.push_back((*this)(number));
        return joined(words, " ");
    }
};

std::string described(const Attributes& attributes) {
    std::vector<std::string> words;
    for (const auto& [name, value] : attributes) {
        words.push_back(name + "=" + std::visit(AsText(), value));
    }
    return joined(words, ", ");
}

}  // namespace

std::string bakeIdentity(const std::string& source, const Upsampler& model,
                         const ColorMeaning& meaning, const BakeOptions& options) {
    std::vector<std::string> parts = {source, described(options.read), model.identity(),
                                      precision(options), described(options.storage)};
    if (meaning.source == ColorSource::config) {
        parts.push_back("'" + meaning.configSpace + "' of a configuration, " + meaning.configHash);
    } else if (options.color.any()) {
        parts.push_back(described(options.color));
    }
    if (options.materialMap) parts.push_back(describedMap(options));
    if (options.second) parts.push_back(describedSecond(options));
    if (!options.attributes.empty()) parts.push_back(described(options.attributes));
    return joined(parts, kIdentitySeparator);
}

}  // namespace specbake::internal
