#pragma once

#include <specbake/image/image_types.h>

#include <OpenImageIO/imageio.h>

namespace specbake::internal {

/// The metadata that still holds for a spectral image made from this one: not what describes the
/// old file's storage (compression, layout, colour profile) or what the new file says itself.
Attributes metadataOf(const OIIO::ImageSpec& spec);

}  // namespace specbake::internal
