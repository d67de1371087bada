#pragma once

#include <specbake/bake/baked_image.h>

#include <OpenImageIO/imageio.h>

#include <vector>

namespace specbake::openimageio {

/// The numbers of a file's channels (channelNames()) in the order in which OpenImageIO's EXR reader
/// has them: R, G, B, A, then the bands.
std::vector<int> readersOrder(bool alpha);

/// What OpenImageIO's EXR reader says of each level of such a file, apart from how it is
/// compressed.
/// `mipmap`: whether it was asked for, even where the image is its only level.
std::vector<OIIO::ImageSpec> levelSpecs(const BakedImage& image, bool mipmap);

}  // namespace specbake::openimageio
