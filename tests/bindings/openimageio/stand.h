#pragma once

#include <specbake/bake/bake.h>

#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace specbake::testing {

/// The folder of images, with a slash.
extern const std::string kImages;

/// A folder of this test, and a reader of OpenImageIO that looks for plugins where ours is.
struct Stand {
    std::filesystem::path folder;
    Stand();
    ~Stand();

    std::string path(const std::string& name) const { return (folder / name).string(); }

    /// NAME.spectral with that text.
    std::string recipe(const std::string& name, const std::string& text) const;

    /// What a bake with these options writes.
    std::string baked(const std::string& texture, BakeOptions options) const;
};

std::unique_ptr<OIIO::ImageInput> opened(const std::string& path);

/// All samples of a level, as they are stored.
std::vector<std::byte> samplesOf(OIIO::ImageInput& input, int level, int first, int end);

/// Every level: dimensions, metadata, samples of all channels, and of some runs of them.
void checkSameImage(const std::string& computed, const std::string& baked);

}  // namespace specbake::testing
