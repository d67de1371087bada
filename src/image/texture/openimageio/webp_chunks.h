#pragma once

#include <string>

namespace specbake::internal {

/// The orientation, 1 to 8, in the Exif chunk of a WebP, of which OpenImageIO 2.4.7 leaves out the
/// first six bytes; 1 if the file says nothing of it.
int webpOrientation(const std::string& path);

/// The ICC profile of a WebP, which OpenImageIO 2.4.7 passes over; empty if it has none.
std::string webpProfile(const std::string& path);

}  // namespace specbake::internal
