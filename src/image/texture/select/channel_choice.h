#pragma once

#include "texture/image_file.h"

#include <optional>
#include <string>
#include <vector>

namespace specbake::internal {

/// Which channels of a file are its texture.
struct ChannelChoice {
    std::vector<int> channels;  ///< indices in the file: those of colour, then alpha if there is
    bool alpha = false;         ///< the last of them is alpha
    bool associatedAlpha = false;
    std::vector<std::string> notes;  ///< one line each on what of the file is not used
};

/// The colours of a file by the names of its channels: R, G and B of the layer without a name, or
/// of the only layer that has them; X, Y and Z of the layer without a name; else a single channel,
/// which is grey, unless its name says that it is something else. Throws FileError, with a line
/// that tells what to do, where that does not decide.
ChannelChoice automaticChannels(const std::string& path, const ImageDescription& image);

/// The channels that are named, as ReadOptions says. Throws FileError for names that are not there.
ChannelChoice namedChannels(const std::string& path, const ImageDescription& image,
                            const std::vector<std::string>& wanted);

}  // namespace specbake::internal
