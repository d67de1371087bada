#pragma once

#include <specbake/bake/baked_image.h>

#include <OpenImageIO/imageio.h>

#include <vector>

namespace specbake::openimageio {

/// The numbers of a file's channels (channelNames()) in the order in which OpenImageIO's EXR reader
/// has them: R, G, B, A, then the bands, so many.
std::vector<int> readersOrder(bool alpha, int bands);

/// What OpenImageIO's EXR reader says of each level of such a file, apart from how it is
/// compressed.
std::vector<OIIO::ImageSpec> levelSpecs(const BakedImage& image);

}  // namespace specbake::openimageio
