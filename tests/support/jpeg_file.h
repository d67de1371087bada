#pragma once

#include <string>

namespace specbake::testing {

/// A marker segment: its length counts itself.
std::string jpegSegment(int marker, const std::string& data);

/// A JFIF header with a density; `unit`: 0 none, 1 inch, 2 cm.
std::string jfifSegment(char unit, int x, int y);

/// The same without its application segments but JFIF.
std::string withoutMetadata(const std::string& jpeg);

/// testimages/rgb8.jpg so.
std::string plainJpeg();

/// The same whose JFIF header is replaced by these segments.
std::string jpegWithSegments(const std::string& segments);

}  // namespace specbake::testing
