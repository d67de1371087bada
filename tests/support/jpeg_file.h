#pragma once

#include <string>

namespace specbake::testing {

/// A marker segment: its length counts itself.
std::string jpegSegment(int marker, const std::string& data);

/// The same without its application segments but JFIF.
std::string withoutMetadata(const std::string& jpeg);

/// testimages/rgb8.jpg so.
std::string plainJpeg();

/// The same whose JFIF header is replaced by these segments.
std::string jpegWithSegments(const std::string& segments);

std::string bytesOfFile(const std::string& path);

}  // namespace specbake::testing
