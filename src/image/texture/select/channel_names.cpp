#include "texture/select/channel_names.h"

#include <algorithm>
#include <map>
#include <utility>

namespace specbake::internal {
namespace {

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
}

/// The channel of a layer that has one of the names, or -1.
int find(const std::vector<std::string>& channels, const std::vector<int>& layer,
         std::string_view name, std::string_view longName) {
    for (const int c : layer) {
        const std::string component = componentOf(channels[std::size_t(c)]);
        if (sameName(component, name) || sameName(component, longName)) return c;
    }
    return -1;
}

using Names = std::vector<std::pair<std::string_view, std::string_view>>;

/// The channels of all those names, or none.
std::vector<int> findAll(const std::vector<std::string>& channels, const std::vector<int>& layer,
                         const Names& names) {
    std::vector<int> found;
    for (const auto& [name, longName] : names) {
        found.push_back(find(channels, layer, name, longName));
    }
    if (std::count(found.begin(), found.end(), -1) > 0) found.clear();
    return found;
}

bool contains(const std::vector<int>& all, int one) {
    return std::find(all.begin(), all.end(), one) != all.end();
}

Layer layerFrom(const std::vector<std::string>& channels, std::string name,
                const std::vector<int>& members) {
    Layer layer;
    layer.name = std::move(name);
    layer.color = findAll(channels, members, {{"R", "red"}, {"G", "green"}, {"B", "blue"}});
    if (layer.color.empty()) {
        layer.color = findAll(channels, members,
                              {{"C", "cyan"}, {"M", "magenta"}, {"Y", "yellow"}, {"K", "black"}});
    }
    if (layer.color.empty()) {
        layer.color = findAll(channels, members, {{"L*", "L*"}, {"a*", "a*"}, {"b*", "b*"}});
    }
    layer.vectors = findAll(channels, members, {{"X", "X"}, {"Y", "Y"}, {"Z", "Z"}});
    const int alpha = find(channels, members, "A", "alpha");
    if (alpha >= 0) layer.alpha = alpha;
    for (const int c : members) {
        if (!contains(layer.color, c) && layer.alpha != c) layer.others.push_back(c);
    }
    return layer;
}

}  // namespace

std::string layerOf(std::string_view channel) {
    const auto dot = channel.rfind('.');
    return std::string(dot == std::string_view::npos ? std::string_view() : channel.substr(0, dot));
}

std::string componentOf(std::string_view channel) {
    return std::string(channel.substr(channel.rfind('.') + 1));
}

bool sameName(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char one, char other) { return lower(one) == lower(other); });
}

bool isAlphaName(std::string_view channel) {
    const std::string component = componentOf(channel);
    return sameName(component, "A") || sameName(component, "alpha");
}

std::vector<Layer> layersOf(const std::vector<std::string>& channels) {
    std::vector<std::string> order;
    std::map<std::string, std::vector<int>> members;
    for (std::size_t c = 0; c < channels.size(); ++c) {
        const std::string name = layerOf(channels[c]);
        if (!members.contains(name)) order.push_back(name);
        members[name].push_back(int(c));
    }
    std::vector<Layer> layers;
    layers.reserve(order.size());
    for (const std::string& name : order) {
        layers.push_back(layerFrom(channels, name, members[name]));
    }
    return layers;
}

std::string listOfChannels(const std::vector<std::string>& channels,
                           const std::vector<int>& indices) {
    constexpr std::size_t most = 8;
    std::string list;
    for (std::size_t i = 0; i < std::min(most, indices.size()); ++i) {
        list += (i == 0 ? "" : ", ") + channels[std::size_t(indices[i])];
    }
    if (indices.size() > most) list += " and " + std::to_string(indices.size() - most) + " more";
    return list;
}

}  // namespace specbake::internal
