#pragma once

#include "texture/image_file.h"

#include <cstddef>
#include <string>
#include <vector>

namespace specbake::testing {

/// Rows as they are stored.
std::vector<std::byte> rowsOf(internal::ImageFile& file, int first, int count);
std::vector<std::byte> allOf(internal::ImageFile& file);

/// OpenImageIO is the oracle: every field of the description and every byte are the same.
void checkSameAsOpenImageIO(internal::ImageFile& file, const std::string& path);

}  // namespace specbake::testing
