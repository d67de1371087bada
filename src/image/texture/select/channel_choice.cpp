#include "texture/select/channel_choice.h"

#include "texture/select/channel_names.h"

#include <specbake/core/error.h>
#include <specbake/image/spectral_layout.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <numeric>
#include <string_view>
#include <utility>

namespace specbake::internal {
namespace {

/// A decision in the making: a file, and the channels that were taken from it.
class Choice {
  public:
    Choice(const std::string& path, const ImageDescription& image) : path_(path), image_(image) {}

    const std::string& name(int channel) const { return image_.channels[std::size_t(channel)]; }
    bool isTaken(int channel) const {
        const auto& taken = made_.channels;
        return std::find(taken.begin(), taken.end(), channel) != taken.end();
    }

    void take(const std::vector<int>& color, std::optional<int> alpha) {
        made_.channels = color;
        made_.alpha = alpha.has_value();
        if (!alpha) return;
        made_.channels.push_back(*alpha);
        const bool usual = alpha == image_.alpha || isAlphaName(name(*alpha));
        made_.associatedAlpha = image_.associatedAlpha && usual;
    }

    void note(std::string line) { made_.notes.push_back(std::move(line)); }

    ChannelChoice made() const { return made_; }

    [[noreturn]] void refuse(const std::string& reason) const {
        throw FileError(path_, reason + (image_.parts.empty()
                                             ? ""
                                             : "; --part chooses among its parts " + image_.parts));
    }

  private:
    const std::string& path_;
    const ImageDescription& image_;
    ChannelChoice made_;
};

std::vector<int> allOf(const ImageDescription& image) {
    std::vector<int> all(image.channels.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

void noteUnused(Choice& choice, const ImageDescription& image) {
    std::vector<int> unused = allOf(image);
    std::erase_if(unused, [&](int c) { return choice.isTaken(c); });
    if (unused.empty()) return;
    choice.note("of its channels, " + listOfChannels(image.channels, unused) +
                (unused.size() == 1 ? " is" : " are") + " not used (--channels chooses)");
}

void refuseSpectral(const Choice& choice, const ImageDescription& image) {
    const auto& names = image.channels;
    const auto band = std::find_if(names.begin(), names.end(),
                                   [](const auto& name) { return bandWavelength(name); });
    if (band == names.end()) return;
    choice.refuse("it is a spectral image already (" + *band +
                  "); --channels R,G,B reads its preview");
}

/// Names of data that a lone channel may hold, and that are no shades of grey.
bool isKnownData(const std::string& channel) {
    constexpr std::array<std::string_view, 12> names = {
        "Z", "depth", "A", "alpha", "U", "V", "W", "X", "N", "id", "ZBack", "crypto00"};
    const std::string component = componentOf(channel);
    return std::any_of(names.begin(), names.end(),
                       [&](auto name) { return sameName(component, name); });
}

/// A file whose only channel beside alpha is `grey`.
void takeLone(Choice& choice, int grey, std::optional<int> alpha) {
    const std::string& name = choice.name(grey);
    if (isKnownData(name)) {
        choice.refuse("its only channel, " + name + ", holds no colours; --channels " + name +
                      " reads it as grey");
    }
    choice.take({grey}, alpha);
    if (!sameName(name, "Y") && !sameName(name, "I") && !sameName(name, "L")) {
        choice.note("its only channel, " + name + ", is taken for grey");
    }
}

/// "diffuse, specular"
std::string namesOf(const std::vector<Layer>& layers) {
    std::string names;
    for (const Layer& layer : layers) names += (names.empty() ? "" : ", ") + layer.name;
    return names;
}

/// A layer with a name, where the layer without one has no colours.
bool takeOnlyLayer(Choice& choice, std::vector<Layer> layers) {
    std::erase_if(layers, [](const Layer& layer) { return layer.color.empty(); });
    if (layers.size() > 1) {
        choice.refuse("its colours are in " + std::to_string(layers.size()) + " layers: " +
                      namesOf(layers) + "; --channels " + layers[0].name + " reads the first");
    }
    if (layers.empty()) return false;
    choice.take(layers[0].color, layers[0].alpha);
    choice.note("its colours are those of its only layer of R, G and B, " + layers[0].name);
    return true;
}

[[noreturn]] void refuseData(const Choice& choice, const ImageDescription& image) {
    std::string three;
    for (std::size_t c = 0; c < 3; ++c) {
        const std::string& name = image.channels[std::min(c, image.channels.size() - 1)];
        three += (c == 0 ? "" : ",") + name;
    }
    choice.refuse("which of its channels (" + listOfChannels(image.channels, allOf(image)) +
                  ") are colours cannot be told; --channels NAME,NAME,NAME or NAME chooses" +
                  (image.channels.size() < 3 ? "" : ", as --channels " + three));
}

/// The layer without a name: R, G and B (or four inks), X, Y and Z, or a channel of grey.
bool takeMain(Choice& choice, const Layer& main, const ImageDescription& image) {
    const bool said = image.alpha && layerOf(choice.name(*image.alpha)).empty();
    const std::optional<int> alpha = said ? image.alpha : main.alpha;
    if (!main.color.empty()) {
        choice.take(main.color, alpha);
        return true;
    }
    if (!main.vectors.empty()) {
        choice.take(main.vectors, alpha);
        return true;
    }
    const auto grey = std::find_if(main.others.begin(), main.others.end(),
                                   [&](int c) { return sameName(choice.name(c), "Y"); });
    if (grey == main.others.end()) return false;
    choice.take({*grey}, alpha);
    return true;
}

int channelNamed(const Choice& choice, const ImageDescription& image, const std::string& wanted) {
    const auto& names = image.channels;
    const auto exact = std::find(names.begin(), names.end(), wanted);
    if (exact != names.end()) return int(exact - names.begin());
    const auto like = [&](const std::string& name) { return sameName(name, wanted); };
    if (std::count_if(names.begin(), names.end(), like) == 1) {
        return int(std::find_if(names.begin(), names.end(), like) - names.begin());
    }
    int number = -1;
    const char* end = wanted.data() + wanted.size();
    const auto parsed = std::from_chars(wanted.data(), end, number);
    if (parsed.ec == std::errc() && parsed.ptr == end && number >= 0 &&
        number < int(names.size())) {
        return number;
    }
    choice.refuse("no channel '" + wanted + "'; it has " + listOfChannels(names, allOf(image)));
}

const Layer* layerNamed(const std::vector<Layer>& layers, const std::string& wanted) {
    const auto found = std::find_if(layers.begin(), layers.end(), [&](const Layer& layer) {
        return sameName(layer.name, wanted) && !layer.color.empty();
    });
    return found == layers.end() ? nullptr : &*found;
}

}  // namespace

ChannelChoice automaticChannels(const std::string& path, const ImageDescription& image) {
    Choice choice(path, image);
    refuseSpectral(choice, image);
    const std::vector<Layer> layers = layersOf(image.channels);
    const auto main =
        std::find_if(layers.begin(), layers.end(), [](const Layer& l) { return l.name.empty(); });
    const bool taken = main != layers.end() && takeMain(choice, *main, image);
    if (!taken && !takeOnlyLayer(choice, layers)) {
        std::vector<int> others = allOf(image);
        std::erase_if(others, [&](int c) { return c == image.alpha; });
        if (others.size() > 1) refuseData(choice, image);
        takeLone(choice, others.empty() ? 0 : others[0],
                 others.empty() ? std::optional<int>() : image.alpha);
    }
    noteUnused(choice, image);
    return choice.made();
}

ChannelChoice namedChannels(const std::string& path, const ImageDescription& image,
                            const std::vector<std::string>& wanted) {
    Choice choice(path, image);
    if (wanted.size() == 1) {
        const std::vector<Layer> layers = layersOf(image.channels);
        const auto& names = image.channels;
        const bool isChannel = std::find(names.begin(), names.end(), wanted[0]) != names.end();
        if (const Layer* layer = layerNamed(layers, wanted[0]); layer != nullptr && !isChannel) {
            choice.take(layer->color, layer->alpha);
            return choice.made();
        }
    }
    std::vector<int> color;
    for (const std::string& name : wanted) color.push_back(channelNamed(choice, image, name));
    std::optional<int> alpha;
    if (wanted.size() == 2 || wanted.size() == 4) {
        alpha = color.back();
        color.pop_back();
    }
    choice.take(color, alpha);
    if (image.associatedAlpha && !alpha) {
        choice.note("its alpha is not read: colours stay multiplied by it");
    }
    return choice.made();
}

}  // namespace specbake::internal
