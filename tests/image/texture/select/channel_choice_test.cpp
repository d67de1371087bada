#include "texture/select/channel_choice.h"

#include <specbake/core/error.h>
#include <specbake/image/texture_reader.h>

#include <doctest/doctest.h>

#include <functional>

using namespace specbake;
using namespace specbake::internal;

namespace {

using Names = std::vector<std::string>;

ImageDescription imageOf(const Names& channels, std::optional<int> alpha = {}) {
    ImageDescription image;
    image.channels = channels;
    image.alpha = alpha;
    image.associatedAlpha = true;
    return image;
}

/// The names of the channels that are chosen; what is refused is its line.
Names chosen(const Names& channels, const Names& wanted = {}, std::optional<int> alpha = {}) {
    const ImageDescription image = imageOf(channels, alpha);
    try {
        const ChannelChoice choice = wanted.empty() ? automaticChannels("file", image)
                                                    : namedChannels("file", image, wanted);
        Names names;
        for (const int c : choice.channels) names.push_back(channels.at(std::size_t(c)));
        return names;
    } catch (const FileError& error) {
        return {error.what()};
    }
}

bool refused(const Names& channels, const std::string& line, const Names& wanted = {}) {
    return chosen(channels, wanted).at(0).find(line) != std::string::npos;
}

}  // namespace

TEST_CASE("channels: the colours of the layer without a name") {
    CHECK(chosen({"R", "G", "B"}) == Names{"R", "G", "B"});
    CHECK(chosen({"A", "B", "G", "R", "Z"}) == Names{"R", "G", "B", "A"});
    CHECK(chosen({"red", "Green", "BLUE", "Alpha"}) == Names{"red", "Green", "BLUE", "Alpha"});
    CHECK(chosen({"X", "Y", "Z"}) == Names{"X", "Y", "Z"});
    CHECK(chosen({"Y", "A"}) == Names{"Y", "A"});
    CHECK(chosen({"Y", "Z"}) == Names{"Y"});
    CHECK(chosen({"R", "G", "B", "diffuse.R", "diffuse.G", "diffuse.B", "diffuse.A"}, {}, 6) ==
          Names{"R", "G", "B"});
}

TEST_CASE("channels: the only layer that has colours") {
    CHECK(chosen({"V.Combined.R", "V.Combined.G", "V.Combined.B", "V.Combined.A", "V.Depth.Z"}) ==
          Names{"V.Combined.R", "V.Combined.G", "V.Combined.B", "V.Combined.A"});
    CHECK(refused({"a.R", "a.G", "a.B", "b.R", "b.G", "b.B"}, "2 layers: a, b; --channels a"));
}

TEST_CASE("channels: what is no colour is refused with the option that reads it") {
    CHECK(refused({"Z"}, "--channels Z"));
    CHECK(refused({"A"}, "--channels A"));
    CHECK(refused({"U", "V", "W"}, "--channels U,V,W"));
    CHECK(refused({"normal.X", "normal.Y", "normal.Z"}, "--channels"));
    CHECK(refused({"R", "G", "B", "T.380,000000nm"}, "a spectral image already"));
    CHECK(refused({"R", "G"}, "cannot be told"));
}

TEST_CASE("channels: by name, by number, by layer") {
    const Names all = {"R", "G", "B", "A", "diffuse.R", "diffuse.G", "diffuse.B", "Z", "7"};
    CHECK(chosen(all, {"B", "G", "R"}) == Names{"B", "G", "R"});
    CHECK(chosen(all, {"r", "g", "b", "a"}) == Names{"R", "G", "B", "A"});
    CHECK(chosen(all, {"diffuse"}) == Names{"diffuse.R", "diffuse.G", "diffuse.B"});
    CHECK(chosen(all, {"Z"}) == Names{"Z"});
    CHECK(chosen(all, {"4", "5", "6"}) == Names{"diffuse.R", "diffuse.G", "diffuse.B"});
    CHECK(chosen(all, {"7"}) == Names{"7"});  // a name before a number
    CHECK(refused(all, "no channel '9'; it has R, G, B, A, diffuse.R, diffuse.G", {"9"}));
    CHECK(refused(all, "no channel '-1'", {"-1"}));
    CHECK(refused(all, "no channel 'specular'", {"specular"}));
}

TEST_CASE("channels: alpha is what its name says") {
    const ImageDescription image = imageOf({"R", "G", "B", "A", "mask"}, 3);
    CHECK(automaticChannels("file", image).associatedAlpha);
    CHECK(namedChannels("file", image, {"R", "G", "B", "A"}).associatedAlpha);
    const ChannelChoice masked = namedChannels("file", image, {"R", "G", "B", "mask"});
    CHECK(masked.alpha);
    CHECK_FALSE(masked.associatedAlpha);
    const ChannelChoice bare = namedChannels("file", image, {"R", "G", "B"});
    CHECK_FALSE(bare.alpha);
    CHECK(bare.notes.size() == 1);
}

TEST_CASE("read options: lists, and what is no list") {
    CHECK(channelList("R,G,B") == Names{"R", "G", "B"});
    CHECK(channelList("Y") == Names{"Y"});
    CHECK(channelList("R,,B") == Names{"R", "", "B"});
    const auto isValid = [](const Names& names) {
        return ReadOptions{.channels = names}.isValid();
    };
    CHECK(isValid({}));
    CHECK(isValid({"R", "G", "B", "A"}));
    CHECK_FALSE(isValid({"R", "", "B"}));
    CHECK_FALSE(isValid({"R", "G", "B", "A", "Z"}));
    CHECK_FALSE(ReadOptions{.part = ""}.isValid());
}
