#include "texture/select/recorded_options.h"

#include <specbake/image/spectral_reader.h>
#include <specbake/image/texture_reader.h>

#include <algorithm>

namespace specbake {

using namespace internal;

namespace {

constexpr const char* kChannels = "specbake:channels";
constexpr const char* kPart = "specbake:part";
constexpr const char* kOrient = "specbake:orient";

/// What is wrong; empty if nothing is.
std::string problemOf(const ReadOptions& options) {
    constexpr std::size_t most = 4;
    const auto& names = options.channels;
    if (names.size() > most) return "more than four channels are named";
    if (std::any_of(names.begin(), names.end(), [](const auto& name) { return name.empty(); })) {
        return "a channel without a name";
    }
    if (options.part && options.part->empty()) return "a part without a name";
    return {};
}

}  // namespace

bool ReadOptions::isValid(std::string* reason) const {
    std::string problem = problemOf(*this);
    const bool valid = problem.empty();
    if (reason != nullptr) *reason = std::move(problem);
    return valid;
}

ReadOptions ReadOptions::orAsIn(const SpectralReader& spectral) const {
    ReadOptions all = *this;
    const auto names = spectral.text(kChannels);
    if (all.channels.empty() && names) all.channels = channelList(*names);
    if (!all.part) all.part = spectral.text(kPart);
    if (spectral.text(kOrient)) all.orient = true;
    return all;
}

std::vector<std::string> channelList(const std::string& text) {
    std::vector<std::string> names;
    std::size_t begin = 0;
    while (begin <= text.size()) {
        const std::size_t comma = std::min(text.find(',', begin), text.size());
        names.push_back(text.substr(begin, comma - begin));
        begin = comma + 1;
    }
    return names;
}

namespace internal {

Attributes recorded(const ReadOptions& options) {
    Attributes attributes;
    std::string names;
    for (const std::string& name : options.channels) names += (names.empty() ? "" : ",") + name;
    if (!names.empty()) attributes[kChannels] = names;
    if (options.part) attributes[kPart] = *options.part;
    if (options.orient) attributes[kOrient] = std::string("yes");
    return attributes;
}

}  // namespace internal
}  // namespace specbake
