#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace specbake::internal {

/// "diffuse.R" is channel R of layer "diffuse"; "R" is of the layer without a name.
std::string layerOf(std::string_view channel);
std::string componentOf(std::string_view channel);

/// Letters of ASCII without their case: programs write R, r, red and Red.
bool sameName(std::string_view a, std::string_view b);

/// "A" or "alpha", whatever its layer.
bool isAlphaName(std::string_view channel);

/// The channels of one layer by what they are.
struct Layer {
    std::string name;
    std::vector<int> color;    ///< R, G, B, four inks, or Lab; empty if it has no such set
    std::vector<int> vectors;  ///< X, Y, Z
    std::optional<int> alpha;
    std::vector<int> others;  ///< that are neither in `color` nor alpha
};

/// The layers of an image in the order in which their channels come.
std::vector<Layer> layersOf(const std::vector<std::string>& channels);

/// "R, G, B", at most eight of them and how many more there are.
std::string listOfChannels(const std::vector<std::string>& channels,
                           const std::vector<int>& indices);

}  // namespace specbake::internal
